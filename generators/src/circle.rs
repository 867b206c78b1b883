//! Points on the unit circle, the same to the last bit on every platform.
//!
//! The sine and cosine of the standard library come from the platform's own and may differ in the
//! last bit. IEEE 754 fixes the result of every `+ - * /`, and Rust never fuses two of them, so a
//! polynomial evaluated in a fixed order is reproducible.

use std::f64::consts::FRAC_PI_2;

/// Point `k` (modulo `n`) of `n` points spread evenly on the unit circle, counter-clockwise from
/// (1, 0). Accurate to a few units in the last place.
///
/// # Panics
/// If `n` is 0.
pub(crate) fn circle(k: u32, n: u32) -> [f64; 2] {
    let quarters = 4 * u64::from(k % n);
    let n = u64::from(n);
    let rest = quarters % n;
    let [cosine, sine] = [n - rest, rest].map(|part| quarter_sine(part as f64 / n as f64));
    // Subtracted, not negated: no coordinate becomes -0.
    match quarters / n {
        0 => [cosine, sine],
        1 => [0.0 - sine, cosine],
        2 => [0.0 - cosine, 0.0 - sine],
        _ => [sine, 0.0 - cosine],
    }
}

/// The point at `part` of a right angle, 0 to 1.
pub(crate) fn quarter(part: f64) -> [f64; 2] {
    [quarter_sine(1.0 - part), quarter_sine(part)]
}

/// Sine of `part` of a right angle, 0 to 1, by its Taylor polynomial of degree 23: the first term
/// left out is below 1e-20 in this range.
fn quarter_sine(part: f64) -> f64 {
    let x = FRAC_PI_2 * part;
    let factor = (1..12u32).rev().fold(1.0, |inner, k| {
        let divisor = f64::from(2 * k * (2 * k + 1));
        1.0 - inner * (x * x) / divisor
    });
    x * factor
}

#[cfg(test)]
mod tests {
    use super::circle;

    #[test]
    fn agrees_with_the_standard_library() {
        for n in [1, 2, 3, 4, 5, 7, 12, 100, 1001] {
            for k in 0..2 * n {
                let angle = f64::from(k) / f64::from(n) * std::f64::consts::TAU;
                let [x, y] = circle(k, n);
                assert!((x - angle.cos()).abs() < 4e-15 && (y - angle.sin()).abs() < 4e-15);
            }
        }
    }

    /// The bits come from the same formula evaluated by another language's IEEE arithmetic.
    #[test]
    fn is_the_same_on_every_platform() {
        assert_eq!(circle(1, 7).map(f64::to_bits), [0x3fe3_f3a0_e28b_edd1, 0x3fe9_04c3_7505_de4b]);
    }
}
