//! Numbers in tables: the same digits on every machine.

/// Writes a number of unknown size in four significant digits, with an exponent where it is below
/// 10^-4 or 10^7 and more.
pub fn significant(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return format!("{value}");
    }
    let scientific = format!("{value:.3e}");
    let (_, exponent) = scientific.split_once('e').expect("scientific notation has an exponent");
    match exponent.parse() {
        Ok(exponent @ -4..=6) => format!("{value:.*}", usize::try_from(3 - exponent).unwrap_or(0)),
        _ => scientific,
    }
}

/// Writes seconds in four significant digits, down to a millionth, never with an exponent.
pub fn seconds(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        short if short < 1e-4 => format!("{value:.6}"),
        long if long >= 1e7 => format!("{value:.0}"),
        _ => significant(value),
    }
}

/// Puts commas between thousands.
pub fn grouped(number: &str) -> String {
    let (whole, rest) = number.split_at(number.find(['.', 'e']).unwrap_or(number.len()));
    let digits = whole.trim_start_matches('-');
    let mut grouped = String::from(&whole[..whole.len() - digits.len()]);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped + rest
}

/// Returns the quotient, where both numbers are known and the second is not 0.
pub fn quotient(top: Option<f64>, bottom: Option<f64>) -> Option<f64> {
    match (top, bottom) {
        (Some(top), Some(bottom)) if bottom != 0.0 => Some(top / bottom),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_significant_digits_of_any_size() {
        let written = [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1.000"),
            (0.123_456, "0.1235"),
            (0.999_96, "1.000"),
            (12.345, "12.35"),
            (-1234.5, "-1234"),
            (1_234_567.0, "1234567"),
            (12_345_678.0, "1.235e7"),
            (0.000_123_44, "0.0001234"),
            (0.000_012_344, "1.234e-5"),
            (f64::NAN, "NaN"),
        ];
        for (value, expected) in written {
            assert_eq!(significant(value), expected);
        }
    }

    #[test]
    fn seconds_have_no_exponent() {
        let written = [
            (0.0, "0"),
            (1.798e-5, "0.000018"),
            (-1.798e-5, "-0.000018"),
            (0.000_123_44, "0.0001234"),
            (4.987_000_9, "4.987"),
            (12_345_678.0, "12345678"),
        ];
        for (value, expected) in written {
            assert_eq!(seconds(value), expected);
        }
    }

    #[test]
    fn quotients_need_both_and_no_zero() {
        assert_eq!(quotient(Some(3.0), Some(2.0)), Some(1.5));
        for (top, bottom) in [(None, Some(1.0)), (Some(1.0), None), (Some(1.0), Some(0.0))] {
            assert_eq!(quotient(top, bottom), None);
        }
    }
}
