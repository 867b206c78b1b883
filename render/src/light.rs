//! The light that a face sends to the eye.

use super::vector::{Vector, dot, unit};

/// Lamps in view coordinates, with the share that each adds to a face turned to it: the key light
/// from above on the left, a fill light from the right, one at the eye, one from below.
const LAMPS: [(Vector, f64); 4] = [
    ([-0.45, 0.70, 0.55], 0.78),
    ([0.80, 0.15, 0.45], 0.24),
    ([0.00, 0.00, 1.00], 0.24),
    ([0.10, -0.90, 0.20], 0.09),
];

/// Light that comes from everywhere.
const AMBIENT: f64 = 0.16;

/// Returns the colour of a face of the given colour and unit normal, turned to the eye, in view
/// coordinates.
pub fn lit(colour: [u8; 3], normal: Vector) -> [u8; 3] {
    let from = |(lamp, share): (Vector, f64)| {
        let towards = unit(lamp).expect("lamp directions are non-zero");
        share * dot(towards, normal).max(0.0)
    };
    let light = LAMPS.into_iter().map(from).fold(AMBIENT, |sum, part| sum + part);
    colour.map(|part| encode(decode(part) * light))
}

/// Returns the colour between two, `share` of the way in amounts of light.
pub fn mixed(one: [u8; 3], other: [u8; 3], share: f64) -> [u8; 3] {
    [0, 1, 2].map(|i| encode(decode(one[i]) + share * (decode(other[i]) - decode(one[i]))))
}

/// Returns the amount of light, 0 to 1, that a stored value stands for: its square, close to what
/// screens show, and unlike a power of 2.2 the same on every machine.
pub fn decode(value: u8) -> f64 {
    let share = f64::from(value) / 255.0;
    share * share
}

/// Returns the value that stands for an amount of light; too much is white.
pub fn encode(light: f64) -> u8 {
    (255.0 * light.clamp(0.0, 1.0).sqrt()).round() as u8
}
