//! Vectors of three coordinates: sums, products and square roots only, the same on every machine.

/// A point or a vector.
pub(crate) type Vector = [f64; 3];

/// Returns `a` + `b`.
#[inline]
pub(crate) fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Returns `a` - `b`.
#[inline]
pub(crate) fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Returns `a` times `factor`.
#[inline]
pub(crate) fn scaled(a: Vector, factor: f64) -> Vector {
    [a[0] * factor, a[1] * factor, a[2] * factor]
}

/// Returns the dot product of `a` and `b`.
#[inline]
pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns the cross product of `a` and `b`.
#[inline]
pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Squares of lengths, and their products, neither overflow nor lose digits in this range.
pub(crate) const ORDINARY: std::ops::Range<f64> = 1e-100..1e100;

/// Returns vectors divided by their largest coordinate, for products that would leave the range of
/// numbers; the same ones if that is 0 or not finite.
#[cold]
pub(crate) fn to_unit_size<const N: usize>(vectors: [Vector; N]) -> [Vector; N] {
    let largest = vectors.as_flattened().iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    match largest > 0.0 && largest.is_finite() {
        true => vectors.map(|vector| vector.map(|x| x / largest)),
        false => vectors,
    }
}

/// Returns the squared length of `a`.
#[inline]
pub(crate) fn square(a: Vector) -> f64 {
    dot(a, a)
}
