//! Seeded randomness that never changes: ChaCha8 words, and our own bounded draw and shuffle.
//!
//! The `rand` crate may change which values its shuffles give between releases; the raw words
//! of ChaCha may not.
//!
//! ```
//! use triquad::random::Random;
//!
//! let mut random = Random::stream(7, &["sg", "bunny"]);
//! assert!(random.below(6) < 6);
//! let mut cards = [1, 2, 3];
//! random.shuffle(&mut cards);
//! cards.sort_unstable();
//! assert_eq!(cards, [1, 2, 3]);
//! ```

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// A reproducible stream of random numbers: the same on every machine and in every release.
#[derive(Clone, Debug)]
pub struct Random(ChaCha8Rng);

impl Random {
    /// Makes the stream that belongs to `names` (algorithm, mesh, repetition …) under a master
    /// seed.
    ///
    /// Streams of different names are independent: adding or dropping one moves no other.
    pub fn stream(seed: u64, names: &[&str]) -> Self {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        let mut rng = ChaCha8Rng::from_seed(key);
        rng.set_stream(fnv1a(names));
        Self(rng)
    }

    /// Draws uniformly from `0..bound` (Lemire's multiplication with rejection).
    ///
    /// # Panics
    /// If `bound` is 0.
    pub fn below(&mut self, bound: u32) -> u32 {
        assert!(bound > 0, "nothing lies below 0");
        loop {
            let wide = u64::from(self.0.next_u32()) * u64::from(bound);
            // The threshold is below the bound, and a division: rarely worth computing.
            if wide as u32 >= bound || wide as u32 >= bound.wrapping_neg() % bound {
                return (wide >> 32) as u32;
            }
        }
    }

    /// Shuffles `items`, which must be fewer than 2^32, uniformly (Fisher-Yates). O(n).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            let other = self.below(last as u32 + 1) as usize;
            items.swap(last, other);
        }
    }
}

/// Returns the 64-bit FNV-1a hash of `names`, each ended by a byte that UTF-8 never uses.
fn fnv1a(names: &[&str]) -> u64 {
    let bytes = names.iter().flat_map(|name| name.bytes().chain([0xff]));
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stream_is_what_it_was_when_it_was_published() {
        let mut random = Random::stream(7, &["ps", "0"]);
        let draws: Vec<u32> = (0..6).map(|_| random.below(1000)).collect();
        assert_eq!(draws, [622, 727, 962, 356, 127, 349]);
    }

    #[test]
    fn names_and_seeds_make_different_streams() {
        let first = |seed, names: &[&str]| Random::stream(seed, names).below(u32::MAX);
        assert_ne!(first(0, &["sg"]), first(1, &["sg"]));
        assert_ne!(first(0, &["sg"]), first(0, &["ps"]));
        assert_ne!(first(0, &["a", "b"]), first(0, &["ab"]));
    }

    #[test]
    fn draws_are_uniform_and_shuffles_are_permutations() {
        let mut random = Random::stream(0, &["test"]);
        let mut counts = [0; 7];
        (0..70_000).for_each(|_| counts[random.below(7) as usize] += 1);
        assert!(counts.iter().all(|&count: &i32| (count - 10_000).abs() < 500), "{counts:?}");
        let mut items: Vec<u32> = (0..1000).collect();
        random.shuffle(&mut items);
        assert!(!items.is_sorted());
        items.sort_unstable();
        assert!(items.into_iter().eq(0..1000));
    }
}
