//! Keys by which edges wait in the tournament: the stage first, then the cost. Edges of equal key
//! come in the order of the file.

use super::shape::STAGES;
use super::tournament::Tournament;

/// Lowest bit of the stage; below are the bits of the cost.
const STAGE_BIT: u32 = 29;

/// Bits below those of the cost, which keep its exponent and 3 bits of its fraction.
const TIE_BITS: u32 = 18;

/// Returns the key of edge `edge` at this cost before it has been refused.
///
/// Costs that agree to an eighth count as equal, and such edges are shuffled (by a multiplicative
/// hash): in the order of the file, a regular grid would be thinned out row by row and stay
/// regular.
#[inline]
pub fn shuffled(cost: f64, edge: usize) -> u32 {
    let hash = (edge as u32 + 1).wrapping_mul(0x9e37_79b1);
    let hash = (hash ^ (hash >> 15)).wrapping_mul(0x85eb_ca77);
    plain(cost) >> TIE_BITS << TIE_BITS | hash >> (u32::BITS - TIE_BITS)
}

/// Returns the key of any edge at this cost, which it keeps to 21 bits of its fraction.
#[inline]
pub fn plain(cost: f64) -> u32 {
    // Written so that NaN is the highest cost.
    let cost = if cost < f64::from(f32::MAX) { cost as f32 } else { f32::MAX };
    // A positive number compares like its bits; the sign bit is not needed.
    cost.to_bits() >> (31 - STAGE_BIT)
}

/// Returns the key of an edge that has been refused at the stage of `key`.
#[inline]
pub fn later(key: u32) -> u32 {
    if stage(key) + 1 < STAGES.len() { key + (1 << STAGE_BIT) } else { Tournament::ABSENT }
}

/// Returns the stage at which an edge waits, that of absent ones behind all others.
#[inline]
pub fn stage(key: u32) -> usize {
    (key >> STAGE_BIT) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_come_before_costs_and_costs_before_the_shuffle() {
        let costs = [0.0, 1e-30, 1e-12, 1.0, 1.2, 7e9, f64::MAX];
        for edges in [[5, 100_000_000], [100_000_000, 5]] {
            for pair in costs.windows(2) {
                let [low, high] = [shuffled(pair[0], edges[0]), shuffled(pair[1], edges[1])];
                assert!(low < high && high < later(low), "{pair:?}");
                assert_eq!((stage(high), stage(later(high))), (0, 1));
            }
        }
        assert_eq!(shuffled(f64::NAN, 3), shuffled(f64::INFINITY, 3));
        assert_eq!(plain(f64::NAN), plain(f64::MAX));
        assert!(plain(1.0) < plain(1.000_001) && plain(0.0) == 0);
        assert_eq!(stage(plain(f64::MAX)), 0);
        assert_eq!(shuffled(1.0, 5) >> TIE_BITS, shuffled(1.1, 6) >> TIE_BITS);
        assert!((0..1000).any(|edge| shuffled(1.0, edge) > shuffled(1.0, edge + 1)));
        let last = (1..STAGES.len()).fold(shuffled(f64::NAN, 3), |key, _| later(key));
        assert_eq!((stage(last), later(last)), (STAGES.len() - 1, Tournament::ABSENT));
    }
}
