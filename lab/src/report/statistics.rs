//! Statistics of a handful of repeated measurements.

use statrs::statistics::{Data, Distribution, Max, Min, OrderStatistics};

/// A sample, described.
///
/// Quartiles are the approximately median-unbiased estimates of Hyndman and Fan (*Sample quantiles
/// in statistical packages*, 1996, type 8): between the order statistics around (n + 1/3) p + 1/3.
/// A single value is all of its own quantiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// Number of values.
    pub n: usize,
    /// Arithmetic mean, what the papers print.
    pub mean: f64,
    /// Middle value, or the mean of the two in the middle.
    pub median: f64,
    /// A quarter of the sample lies below.
    pub lower_quartile: f64,
    /// A quarter of the sample lies above.
    pub upper_quartile: f64,
    /// Least value.
    pub minimum: f64,
    /// Greatest value.
    pub maximum: f64,
}

impl Statistics {
    /// Describes `values`; `None` if there are none. O(n) on average.
    ///
    /// The mean of equal values is that value, to the last bit.
    pub fn from_values(values: &[f64]) -> Option<Self> {
        if values.is_empty() {
            return None;
        }
        let mut data = Data::new(values.to_vec());
        let (minimum, maximum) = (data.min(), data.max());
        // A running mean of equal values may differ from them by rounding.
        let mean = if minimum == maximum { minimum } else { data.mean()? };
        Some(Self {
            n: values.len(),
            mean,
            median: data.median(),
            lower_quartile: data.lower_quartile(),
            upper_quartile: data.upper_quartile(),
            minimum,
            maximum,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_has_no_statistics_and_one_value_is_all_of_them() {
        assert_eq!(Statistics::from_values(&[]), None);
        let one = Statistics::from_values(&[0.1]).unwrap();
        let Statistics { n, mean, median, lower_quartile, upper_quartile, minimum, maximum } = one;
        assert_eq!(n, 1);
        for value in [mean, median, lower_quartile, upper_quartile, minimum, maximum] {
            assert_eq!(value, 0.1);
        }
    }

    /// By hand: with n = 10 the lower quartile lies at (10 + 1/3)/4 + 1/3 = 2.91666…
    #[test]
    fn quartiles_are_those_of_type_8() {
        let values = [10.0, 2.0, 9.0, 4.0, 5.0, 6.0, 7.0, 8.0, 3.0, 1.0];
        let found = Statistics::from_values(&values).unwrap();
        assert!((found.lower_quartile - (2.0 + 0.75 + 1.0 / 6.0)).abs() < 1e-12, "{found:?}");
        assert!((found.upper_quartile - (8.0 + 0.25 - 1.0 / 6.0)).abs() < 1e-12, "{found:?}");
        assert_eq!((found.n, found.minimum, found.maximum), (10, 1.0, 10.0));
        assert!((found.mean - 5.5).abs() < 1e-12 && (found.median - 5.5).abs() < 1e-12);
    }

    #[test]
    fn the_mean_of_equal_values_is_that_value() {
        assert_eq!(Statistics::from_values(&[0.1; 10]).unwrap().mean, 0.1);
    }
}
