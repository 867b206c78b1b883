//! Axes: where values lie on them, and which are labelled.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Spread of values along an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Spread {
    /// Equal steps, equal differences.
    Linear,
    /// Equal steps, equal ratios.
    #[default]
    Logarithmic,
    /// One row for each of so many names, the first on top.
    Rows,
}

/// An axis in the coordinates of the plot: logarithms to base 10 where it is logarithmic.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    spread: Spread,
    low: f64,
    high: f64,
    ticks: Vec<(f64, String)>,
}

impl Axis {
    /// Makes an axis that shows `values`, and 0 if it is linear. A logarithmic one leaves out
    /// values without a logarithm.
    pub fn new(spread: Spread, values: impl Iterator<Item = f64>) -> Self {
        match spread {
            Spread::Linear => Self::linear(values),
            _ => Self::logarithmic(values),
        }
    }

    /// Makes an axis of one row a name.
    pub fn rows(names: &[String]) -> Self {
        let tick = |(i, name): (usize, &String)| (-(i as f64), name.clone());
        let ticks = names.iter().enumerate().map(tick).collect();
        Self { spread: Spread::Rows, low: 0.5 - names.len() as f64, high: 0.5, ticks }
    }

    fn linear(values: impl Iterator<Item = f64>) -> Self {
        let (least, most) = values
            .fold((0.0_f64, 0.0_f64), |(least, most), value| (least.min(value), most.max(value)));
        let step = step_of(if most > least { most - least } else { 1.0 });
        let first = (least / step).floor() as i32;
        let last = ((most / step).ceil() as i32).max(first + 1);
        let at = |i: i32| f64::from(i) * step;
        let ticks = (first..=last).map(|i| (at(i), short(at(i)))).collect();
        Self { spread: Spread::Linear, low: at(first), high: at(last), ticks }
    }

    fn logarithmic(values: impl Iterator<Item = f64>) -> Self {
        let logs = values.filter(|&value| value > 0.0).map(libm::log10);
        let (low, high) = logs
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let (low, high) = if low <= high { (low - 0.08, high + 0.08) } else { (0.0, 1.0) };
        let steps: &[f64] = if high - low < 2.6 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let every = if high - low > 9.0 { 2 } else { 1 };
        let decades = (low.floor() as i32)..=(high.ceil() as i32);
        let ticks = decades.filter(|decade| decade % every == 0).flat_map(|decade| {
            steps.iter().map(move |step| {
                (f64::from(decade) + libm::log10(*step), power(*step as u32, decade))
            })
        });
        let ticks = ticks.filter(|(at, _)| (low..=high).contains(at)).collect();
        Self { spread: Spread::Logarithmic, low, high, ticks }
    }

    /// Returns the place of a value; `None` if it has no logarithm and needs one.
    pub fn place(&self, value: f64) -> Option<f64> {
        match self.spread {
            Spread::Linear => Some(value),
            Spread::Rows => Some(-value),
            Spread::Logarithmic => (value > 0.0).then(|| libm::log10(value)),
        }
    }

    /// Returns the least and greatest place.
    pub fn bounds(&self) -> (f64, f64) {
        (self.low, self.high)
    }
}

/// Returns 1, 2 or 5 times a power of 10, about a fifth of `most`.
fn step_of(most: f64) -> f64 {
    let mut step = 1.0;
    while step * 10.0 > most {
        step /= 10.0;
    }
    while step * 100.0 <= most {
        step *= 10.0;
    }
    // Now `most` is 10 to 100 steps.
    [2.0, 5.0, 10.0, 20.0].into_iter().find(|n| most / (step * n) <= 6.0).unwrap_or(20.0) * step
}

/// Writes a number on an axis in few characters: 0.2, 15, 20 k, 3.5 M.
pub fn short(value: f64) -> String {
    let (scaled, unit) = match value.abs() {
        v if v >= 1e6 => (value / 1e6, " M"),
        v if v >= 1e4 => (value / 1e3, " k"),
        _ => (value, ""),
    };
    let digits = format!("{scaled:.6}");
    format!("{}{unit}", digits.trim_end_matches('0').trim_end_matches('.'))
}

/// Writes `digit` times 10 to the power of `decade`.
fn power(digit: u32, decade: i32) -> String {
    if decade < 0 {
        format!("0.{}{digit}", "0".repeat(decade.unsigned_abs() as usize - 1))
    } else {
        short(f64::from(digit) * libm::exp10(f64::from(decade)).round())
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, place: &f64, (from, to): (i32, i32)) -> i32 {
        let share = (place - self.low) / (self.high - self.low);
        from + (share * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        // Light lines between the labelled ones would only be noise.
        if hint.weight().allow_light_points() && self.spread != Spread::Rows {
            return Vec::new();
        }
        self.ticks.iter().map(|tick| tick.0).collect()
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, place: &f64) -> String {
        let tick = self.ticks.iter().find(|tick| tick.0 == *place);
        tick.map(|tick| tick.1.clone()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|tick| tick.1.as_str()).collect()
    }

    #[test]
    fn ticks_are_round_numbers_inside_the_axis() {
        let axis = Axis::new(Spread::Logarithmic, [1_696.0, 4_222_296.0].into_iter());
        assert_eq!(labels(&axis), ["10 k", "100 k", "1 M"]);
        let axis = Axis::new(Spread::Logarithmic, [0.004, 0.03].into_iter());
        assert_eq!(labels(&axis), ["0.005", "0.01", "0.02"]);
        let axis = Axis::new(Spread::Linear, [10.0, 3500.0].into_iter());
        assert_eq!(labels(&axis), ["0", "1000", "2000", "3000", "4000"]);
        let axis = Axis::new(Spread::Linear, [0.31].into_iter());
        assert_eq!(labels(&axis), ["0", "0.1", "0.2", "0.3", "0.4"]);
    }

    #[test]
    fn linear_axes_begin_at_the_step_below_negative_values() {
        for (values, expected) in [
            (&[-0.3, 0.55][..], &["-0.4", "-0.2", "0", "0.2", "0.4", "0.6"][..]),
            (&[-0.31], &["-0.4", "-0.3", "-0.2", "-0.1", "0"]),
            (&[-20_000.0], &["-20 k", "-15 k", "-10 k", "-5000", "0"]),
        ] {
            let axis = Axis::new(Spread::Linear, values.iter().copied());
            assert_eq!(labels(&axis), expected);
            let (low, high) = axis.bounds();
            assert!(values.iter().all(|value| (low..=high).contains(value)), "{axis:?}");
        }
    }

    #[test]
    fn axes_of_nothing_are_axes() {
        for spread in [Spread::Linear, Spread::Logarithmic] {
            let axis = Axis::new(spread, [0.0].into_iter());
            let (low, high) = axis.bounds();
            assert!(low < high && !axis.ticks.is_empty(), "{axis:?}");
        }
    }

    #[test]
    fn places_keep_the_order_and_rows_go_down() {
        let axis = Axis::new(Spread::Logarithmic, [1.0, 1000.0].into_iter());
        assert_eq!((axis.place(100.0), axis.place(0.0)), (Some(2.0), None));
        let rows = Axis::rows(&["a".into(), "b".into()]);
        assert!(rows.map(&rows.place(0.0).unwrap(), (0, 100)) > rows.map(&-1.0, (0, 100)));
        assert_eq!(rows.format_ext(&-1.0), "b");
    }
}
