//! Smooth random functions of two variables.

/// Steps of a random number between 0 and 1.
const STEPS: u32 = 1 << 20;

/// A sum of octaves, each with half the wavelength and half the amplitude of the one before.
pub(super) struct Noise(Vec<Octave>);

/// A uniform quadratic B-spline with random coefficients: its slopes are continuous, and it is
/// nowhere larger than its largest coefficient.
struct Octave {
    /// Knots for each unit of length.
    frequency: f64,
    /// The coefficients repeat after so many in both directions, a power of two.
    period: usize,
    coefficients: Vec<f64>,
}

impl Noise {
    /// For arguments up to three times `radius` from 0: wavelengths from `radius` down to `finest`,
    /// values below twice `amplitude`. O((radius / finest)²).
    pub(super) fn new(
        radius: f64,
        finest: f64,
        amplitude: f64,
        below: &mut dyn FnMut(u32) -> u32,
    ) -> Self {
        let octave = |k| {
            let waves = f64::from(1 << k);
            Octave::new(waves / radius, amplitude / waves, 8_usize << k, below)
        };
        Self((0..octaves(radius, finest)).map(octave).collect())
    }

    pub(super) fn at(&self, x: f64, y: f64) -> f64 {
        self.0.iter().map(|octave| octave.at(x, y)).sum()
    }
}

/// Number of times that `radius` can be halved before it is below `finest`.
pub(super) fn octaves(radius: f64, finest: f64) -> u32 {
    (0..31).take_while(|&k| radius >= finest * f64::from(1 << k)).count() as u32
}

impl Octave {
    fn new(
        frequency: f64,
        amplitude: f64,
        period: usize,
        below: &mut dyn FnMut(u32) -> u32,
    ) -> Self {
        let mut draw = || f64::from(below(2 * STEPS)) / f64::from(STEPS) - 1.0;
        let coefficients = (0..period * period).map(|_| amplitude * draw()).collect();
        Self { frequency, period, coefficients }
    }

    fn at(&self, x: f64, y: f64) -> f64 {
        let ((columns, across), (rows, along)) = (self.knots(x), self.knots(y));
        let mut sum = 0.0;
        for (row, weight) in rows.into_iter().zip(along) {
            let row = &self.coefficients[row * self.period..][..self.period];
            let value = across[0] * row[columns[0]] + across[1] * row[columns[1]];
            sum += weight * (value + across[2] * row[columns[2]]);
        }
        sum
    }

    /// The three coefficients that matter at `x` along one direction, and their weights.
    fn knots(&self, x: f64) -> ([usize; 3], [f64; 3]) {
        // One period on, to round down by cutting off the fraction.
        let knots = x * self.frequency + self.period as f64;
        debug_assert!(knots >= 0.0);
        let first = knots as usize;
        let t = knots - first as f64;
        let weights = [(1.0 - t) * (1.0 - t) / 2.0, 0.5 + t - t * t, t * t / 2.0];
        ([first, first + 1, first + 2].map(|knot| knot & (self.period - 1)), weights)
    }
}
