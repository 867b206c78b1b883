//! Confidence intervals of products of means, by the bootstrap.

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

/// A number on a mesh, resampled: the value, and what it is drawn against.
pub type Draw = [f64; 2];

/// Draws 1000 resamples of two products of means: the number on a mesh, and what it is drawn
/// against. Empty where nothing was repeated, or all repetitions are equal.
///
/// Factors with the same repetitions are drawn together, so that what disturbed a repetition
/// disturbs all of them. O(1000 · runs).
pub fn draws(
    value: &[(&Factor, Sample)],
    along: &[(&Factor, Sample)],
    mut random: Random,
) -> Vec<Draw> {
    let all: Vec<(&Factor, &Sample)> =
        value.iter().chain(along).map(|(factor, sample)| (*factor, sample)).collect();
    let varies = |sample: &Sample| sample.iter().any(|run| run.1 != sample[0].1);
    if !all.iter().any(|(_, sample)| varies(sample)) {
        return Vec::new();
    }
    let product = |factors: &[(&Factor, &Sample)], means: &[f64]| {
        let both = factors.iter().zip(means);
        both.fold(1.0, |product, ((factor, _), &mean)| factor.apply(product, mean))
    };
    let (values, alongs) = all.split_at(value.len());
    (0..RESAMPLES)
        .map(|_| {
            let means = resample(&all, &mut random);
            let (of_value, of_along) = means.split_at(value.len());
            [product(values, of_value), product(alongs, of_along)]
        })
        .collect()
}

/// Returns 95 % of the drawn values (percentile bootstrap); `None` if there are none.
pub fn interval(draws: &[Draw]) -> Option<(f64, f64)> {
    let mut values: Vec<f64> = draws.iter().map(|draw| draw[0]).collect();
    values.sort_by(f64::total_cmp);
    let tail = values.len() / 40;
    (!values.is_empty()).then(|| (values[tail], values[values.len() - 1 - tail]))
}

/// Returns the mean of each factor over runs drawn with replacement.
fn resample(factors: &[(&Factor, &Sample)], random: &mut Random) -> Vec<f64> {
    let mut means = vec![None; factors.len()];
    for first in 0..factors.len() {
        if means[first].is_some() {
            continue;
        }
        let sample = factors[first].1;
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
        let (low, high) = interval(&draws(&paired, &[], stream())).unwrap();
        assert!((low - 3.0).abs() < 1e-12 && (high - 3.0).abs() < 1e-12, "{low} {high}");
        // Of other repetitions they are independent.
        let shifted = sample(&values).into_iter().map(|(i, v)| (i + 1, v)).collect();
        let apart = [(top, sample(&values.map(|v| 3.0 * v))), (bottom, shifted)];
        let (low, high) = interval(&draws(&apart, &[], stream())).unwrap();
        assert!(low < 1.5 && high > 6.0, "{low} {high}");
        assert!((product(&apart) - 3.0).abs() < 1e-12);
    }

    #[test]
    fn the_interval_of_a_mean_is_that_of_the_textbook() {
        let mean = Expression::try_from("ps.total_seconds".to_owned()).unwrap();
        let values: Vec<f64> = (0..400).map(f64::from).collect();
        let found = draws(&[(&mean.factors[0], sample(&values))], &[], stream());
        let (low, high) = interval(&found).unwrap();
        // Standard error 115.5 / 20; 1.96 of it either way.
        assert!(
            (low - (199.5 - 11.3)).abs() < 1.5 && (high - (199.5 + 11.3)).abs() < 1.5,
            "{low} {high}"
        );
    }

    #[test]
    fn what_was_not_repeated_has_no_interval() {
        let mean = Expression::try_from("ps.total_seconds".to_owned()).unwrap();
        let found = draws(&[(&mean.factors[0], sample(&[1.0]))], &[], stream());
        assert_eq!(interval(&found), None);
    }
}
