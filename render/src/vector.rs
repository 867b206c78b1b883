//! The few operations on vectors that drawing needs, in one fixed order of evaluation.

pub type Vector = [f64; 3];

pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Returns the vector of length 1 in the direction of `a`, unless that has none.
pub fn unit(a: Vector) -> Option<Vector> {
    let most = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    // Scaled first, so that no square is too large or too small for an f64.
    let small = a.map(|x| x / most);
    let length = dot(small, small).sqrt();
    (most > 0.0 && length.is_finite()).then(|| small.map(|x| x / length))
}

/// Returns the point between `a` and `b` at `share` of the way.
pub fn between(a: Vector, b: Vector, share: f64) -> Vector {
    [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]))
}
