//! Randomness for tests.

/// Returns a generator of uniform draws: `below(n)` is one of `0..n`.
///
/// Equal seeds give equal draws on every machine. A linear congruential generator with the
/// constants of Knuth's MMIX, of which the upper 32 bits are used: good enough for tests, and for
/// nothing else.
///
/// ```
/// let mut below = triquad_generators::testing::draws(7);
/// assert!((0..1000).all(|_| below(6) < 6));
/// ```
pub fn draws(seed: u64) -> impl FnMut(u32) -> u32 {
    let mut state = seed;
    move |n| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (((state >> 32) * u64::from(n)) >> 32) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::draws;

    #[test]
    fn draws_are_below_their_bound_and_about_equally_frequent() {
        for seed in 0..100 {
            let mut below = draws(seed);
            let mut counts = [0; 6];
            (0..6000).for_each(|_| counts[below(6) as usize] += 1);
            assert!(counts.iter().all(|count| (800..1200).contains(count)), "{counts:?}");
        }
    }
}
