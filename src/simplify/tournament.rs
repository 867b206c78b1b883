//! A priority queue over numbered items that is a tree of minima.
//!
//! Sixteen keys fill a cache line and are compared at once; above each sixteen stands their least.
//! A new key climbs only as far as it changes a minimum, mostly not at all, and no array of places
//! is needed, as in a heap.

const WIDTH: usize = 16;

/// The key of every item, and the item with the least key. 4.3 bytes an item.
#[derive(Clone, Debug)]
pub struct Tournament {
    /// Keys in sixteens, then their minima in sixteens, and so on up to a single sixteen.
    levels: Vec<Vec<[u32; WIDTH]>>,
}

impl Tournament {
    /// The key of an item that does not take part.
    pub const ABSENT: u32 = u32::MAX;

    /// Makes a tournament of items with these keys. O(n).
    pub fn new(keys: impl ExactSizeIterator<Item = u32>) -> Self {
        let mut levels = vec![in_sixteens(keys)];
        while let Some(below) = levels.last().filter(|level| level.len() > 1) {
            levels.push(in_sixteens(below.iter().map(least)));
        }
        Self { levels }
    }

    /// Returns the key of an item.
    #[inline]
    pub fn key(&self, item: usize) -> u32 {
        self.levels[0][item / WIDTH][item % WIDTH]
    }

    /// Changes the key of an item. O(log n), mostly O(1).
    #[inline]
    pub fn set(&mut self, item: usize, key: u32) {
        let (mut at, mut key) = (item, key);
        for level in &mut self.levels {
            let sixteen = &mut level[at / WIDTH];
            let old = std::mem::replace(&mut sixteen[at % WIDTH], key);
            if old == key {
                return;
            }
            key = least(sixteen);
            at /= WIDTH;
        }
    }

    /// Returns the item with the least key, the first of several, and its key. O(log n).
    #[inline]
    pub fn first(&self) -> Option<(usize, u32)> {
        let mut at = 0;
        let mut key = Self::ABSENT;
        for level in self.levels.iter().rev() {
            let sixteen = &level[at];
            key = least(sixteen);
            at = WIDTH * at + sixteen.iter().position(|&other| other == key)?;
        }
        (key != Self::ABSENT).then_some((at, key))
    }
}

#[inline]
fn least(sixteen: &[u32; WIDTH]) -> u32 {
    sixteen.iter().fold(Tournament::ABSENT, |least, &key| least.min(key))
}

fn in_sixteens(mut keys: impl ExactSizeIterator<Item = u32>) -> Vec<[u32; WIDTH]> {
    let sixteens = keys.len().div_ceil(WIDTH).max(1);
    let mut next = || keys.next().unwrap_or(Tournament::ABSENT);
    (0..sixteens).map(|_| std::array::from_fn(|_| next())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Compared with a plain search through all keys, at sizes round the powers of sixteen.
    #[test]
    fn the_least_key_is_first() {
        let mut random = Random::stream(0, &["tournament"]);
        for size in [0, 1, 15, 16, 17, 255, 256, 257, 5000] {
            let mut keys: Vec<u32> = (0..size).map(|_| random.below(50)).collect();
            let mut tournament = Tournament::new(keys.iter().copied());
            for _ in 0..3000 {
                let least = (0..keys.len()).min_by_key(|&item| keys[item]);
                let first = least.map(|item| (item, keys[item]));
                assert_eq!(tournament.first(), first.filter(|first| first.1 != u32::MAX));
                let Some(item) = least
                    .filter(|_| random.below(2) == 0)
                    .or_else(|| (size > 0).then(|| random.below(size) as usize))
                else {
                    break;
                };
                keys[item] = if random.below(3) == 0 { u32::MAX } else { random.below(90) };
                tournament.set(item, keys[item]);
                assert_eq!(tournament.key(item), keys[item]);
            }
        }
    }
}
