//! How far a product of means may be from the truth, by the bootstrap.

use crate::report::claims::Factor;
use triquad::random::Random;

/// Resamples drawn.
const RESAMPLES: usize = 1000;

/// The runs of one factor: repetition and value.
pub type Sample = Vec<(u32, f64)>;

/// Returns the product of the means.
pub fn product(factors: &[(&Factor, Sample)]) -> f64 {
    let mean = |sample: &Sample| sample.iter().map(|run| run.1).sum::<f64>() / sample.len() as f64;
    factors.iter().fold(1.0, |product, (factor, sample)| factor.apply(product, mean(sample)))
}

/// Returns 95 % of 1000 resamples of the product of means (percentile bootstrap); `None` where
/// nothing was repeated. Factors with the same repetitions are drawn together, so that what
/// disturbed a repetition disturbs both. O(1000 · runs).
pub fn interval(factors: &[(&Factor, Sample)], mut random: Random) -> Option<(f64, f64)> {
    if factors.iter().all(|(_, sample)| sample.len() < 2) {
        return None;
    }
    let mut products: Vec<f64> = (0..RESAMPLES)
        .map(|_| {
            let drawn = resample(factors, &mut random);
            factors
                .iter()
                .zip(drawn)
                .fold(1.0, |product, ((factor, _), mean)| factor.apply(product, mean))
        })
        .collect();
    products.sort_by(f64::total_cmp);
    Some((products[RESAMPLES / 40], products[RESAMPLES - 1 - RESAMPLES / 40]))
}

/// Returns the mean of each factor over runs drawn with replacement.
fn resample(factors: &[(&Factor, Sample)], random: &mut Random) -> Vec<f64> {
    let mut means = vec![None; factors.len()];
    for first in 0..factors.len() {
        if means[first].is_some() {
            continue;
        }
        let sample = &factors[first].1;
        let runs = sample.len() as u32;
        let draws: Vec<usize> = (0..runs).map(|_| random.below(runs) as usize).collect();
        for (mean, (_, other)) in means.iter_mut().zip(factors).skip(first) {
            if other.iter().map(|run| run.0).eq(sample.iter().map(|run| run.0)) {
                let sum: f64 = draws.iter().map(|&run| other[run].1).sum();
                *mean = Some(sum / f64::from(runs));
            }
        }
    }
    means
        .into_iter()
        .map(|mean| mean.expect("every factor has the repetitions of itself"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::claims::Expression;

    fn stream() -> Random {
        Random::stream(0, &["bootstrap", "test"])
    }

    fn sample(values: &[f64]) -> Sample {
        values.iter().enumerate().map(|(i, &value)| (i as u32, value)).collect()
    }

    #[test]
    fn repetitions_that_were_disturbed_together_are_drawn_together() {
        let ratio =
            Expression::try_from("ps.total_seconds / lrs.total_seconds".to_owned()).unwrap();
        let [top, bottom] = &ratio.factors[..] else { unreachable!() };
        let values = [1.0, 2.0, 5.0, 9.0];
        let paired = [(top, sample(&values.map(|v| 3.0 * v))), (bottom, sample(&values))];
        let (low, high) = interval(&paired, stream()).unwrap();
        assert!((low - 3.0).abs() < 1e-12 && (high - 3.0).abs() < 1e-12, "{low} {high}");
        // Of other repetitions they are independent.
        let shifted = sample(&values).into_iter().map(|(i, v)| (i + 1, v)).collect();
        let apart = [(top, sample(&values.map(|v| 3.0 * v))), (bottom, shifted)];
        let (low, high) = interval(&apart, stream()).unwrap();
        assert!(low < 1.5 && high > 6.0, "{low} {high}");
        assert!((product(&apart) - 3.0).abs() < 1e-12);
    }

    #[test]
    fn the_interval_of_a_mean_is_that_of_the_textbook() {
        let mean = Expression::try_from("ps.total_seconds".to_owned()).unwrap();
        let values: Vec<f64> = (0..400).map(f64::from).collect();
        let (low, high) = interval(&[(&mean.factors[0], sample(&values))], stream()).unwrap();
        // Standard error 115.5 / 20; 1.96 of it either way.
        assert!(
            (low - (199.5 - 11.3)).abs() < 1.5 && (high - (199.5 + 11.3)).abs() < 1.5,
            "{low} {high}"
        );
    }

    #[test]
    fn what_was_not_repeated_has_no_interval() {
        let mean = Expression::try_from("ps.total_seconds".to_owned()).unwrap();
        assert_eq!(interval(&[(&mean.factors[0], sample(&[1.0]))], stream()), None);
    }
}
