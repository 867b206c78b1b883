//! Straight lines through points on log-log axes: exponents of growth.

/// A power law y = e^`intercept` x^`exponent`, by least squares on the logarithms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// Slope on log-log axes.
    pub exponent: f64,
    /// Logarithm of the value at x = 1.
    pub intercept: f64,
    /// 95 % confidence interval of the exponent (Student's t with n - 2 degrees of freedom); none
    /// for two points.
    pub interval: Option<(f64, f64)>,
    /// Number of points.
    pub n: usize,
}

impl PowerLaw {
    /// Fits `points`, (x, y), leaving out those without logarithms. `None` if fewer than two points
    /// or only one x remain. O(n).
    pub fn through(points: &[(f64, f64)]) -> Option<Self> {
        // The logarithm is not the platform's, whose last digit varies.
        let logs: Vec<(f64, f64)> = points
            .iter()
            .filter(|(x, y)| *x > 0.0 && *y > 0.0)
            .map(|&(x, y)| (libm::log(x), libm::log(y)))
            .collect();
        let n = logs.len() as f64;
        let mean = |number: fn(&(f64, f64)) -> f64| logs.iter().map(number).sum::<f64>() / n;
        let (x, y) = (mean(|point| point.0), mean(|point| point.1));
        let spread: f64 = logs.iter().map(|point| (point.0 - x) * (point.0 - x)).sum();
        if logs.len() < 2 || spread <= 1e-12 {
            return None;
        }
        let common: f64 = logs.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
        let exponent = common / spread;
        let intercept = y - exponent * x;
        let residual = |point: &(f64, f64)| point.1 - intercept - exponent * point.0;
        let squares: f64 = logs.iter().map(|point| residual(point) * residual(point)).sum();
        let interval = (logs.len() > 2).then(|| {
            let half = student_t(logs.len() - 2) * (squares / (n - 2.0) / spread).sqrt();
            (exponent - half, exponent + half)
        });
        Some(Self { exponent, intercept, interval, n: logs.len() })
    }
}

/// Returns the 97.5 % quantile of Student's t; beyond the table that of its last entry, which is
/// larger.
fn student_t(degrees: usize) -> f64 {
    // Not `statrs::StudentsT`: with it one interval of the committed compare.csv and the bounds of
    // four plots print another last digit, and its logarithms are the platform's.
    const QUANTILES: [f64; 20] = [
        12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160,
        2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
    ];
    QUANTILES[degrees.clamp(1, QUANTILES.len()) - 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_is_found_again() {
        let points: Vec<(f64, f64)> = [1.0, 2.0, 4.0, 8.0].map(|x| (x, 3.0 * x * x)).into();
        let fit = PowerLaw::through(&points).unwrap();
        let (low, high) = fit.interval.unwrap();
        assert!((fit.exponent - 2.0).abs() < 1e-12 && high - low < 1e-6, "{fit:?}");
        assert!((fit.intercept - 3.0_f64.ln()).abs() < 1e-12, "{fit:?}");
    }

    /// y = 1, 1, 2 at x = 1, e, e²: by hand, slope ln 2 / 2, and residuals ln 2 (1, -2, 1) / 6.
    #[test]
    fn the_interval_is_that_of_the_textbook() {
        let e = std::f64::consts::E;
        let fit = PowerLaw::through(&[(1.0, 1.0), (e, 1.0), (e * e, 2.0)]).unwrap();
        let ln2 = std::f64::consts::LN_2;
        let half = 12.706 * ln2 / 6.0 * (6.0_f64 / 2.0).sqrt();
        let (low, high) = fit.interval.unwrap();
        assert!((fit.exponent - ln2 / 2.0).abs() < 1e-9, "{fit:?}");
        assert!((high - low - 2.0 * half).abs() < 1e-9, "{fit:?} {half}");
    }

    #[test]
    fn what_has_no_slope_is_not_fitted() {
        for points in [&[(1.0, 1.0)][..], &[(2.0, 1.0), (2.0, 3.0)], &[(0.0, 1.0), (1.0, 1.0)]] {
            assert_eq!(PowerLaw::through(points), None);
        }
        assert_eq!(PowerLaw::through(&[(1.0, 1.0), (2.0, 2.0)]).unwrap().interval, None);
    }
}
