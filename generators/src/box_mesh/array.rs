//! Places of the array with a shaft, and those with one that goes through.

/// One place of the array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// No shaft: its place is for a larger array than there are shafts.
    Empty,
    /// A shaft that ends inside.
    Cavity,
    /// A shaft that goes through.
    Hole,
}

/// The places row by row. Holes are spread evenly, holes and cavities together too. O(columns²).
///
/// # Panics
/// If there are fewer places than shafts.
pub(crate) fn places(columns: u32, cavities: u32, holes: u32) -> Vec<Place> {
    let mut order: Vec<_> = (0..columns * columns).collect();
    let key = |&place: &u32| (scatter(place % columns, place / columns), place);
    let (holes, shafts) = (holes as usize, holes as usize + cavities as usize);
    let mut places = vec![Place::Empty; order.len()];
    for (count, what) in [(shafts, Place::Cavity), (holes, Place::Hole)] {
        if (1..order.len()).contains(&count) {
            order.select_nth_unstable_by_key(count, key);
        }
        order[..count].iter().for_each(|&place| places[place as usize] = what);
    }
    places
}

/// A number for each place such that those below any bound are spread evenly: the fractional part
/// of `column / ρ + row / ρ²`, in units of 2⁻³², where ρ³ = ρ + 1. The pair (1/ρ, 1/ρ²) is badly
/// approximable, so that no short step of the array changes the number by little.
fn scatter(column: u32, row: u32) -> u32 {
    column.wrapping_mul(0xC13F_A9A9).wrapping_add(row.wrapping_mul(0x91E1_0DA5))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(places: &[Place], what: Place) -> usize {
        places.iter().filter(|&&place| place == what).count()
    }

    #[test]
    fn counts_are_exact() {
        for columns in 1..9 {
            for shafts in 0..=columns * columns {
                for holes in 0..=shafts {
                    let places = places(columns, shafts - holes, holes);
                    assert_eq!(places.len() as u32, columns * columns);
                    assert_eq!(count(&places, Place::Hole) as u32, holes);
                    assert_eq!(count(&places, Place::Cavity) as u32, shafts - holes);
                }
            }
        }
    }

    /// Every square window has its share up to 4, for the papers' numbers of holes.
    #[test]
    fn holes_are_spread() {
        let (columns, window) = (62, 10);
        for holes in [3500, 3000, 2500, 2000, 1500, 1000, 500, 100, 50, 10] {
            let places = places(columns, columns * columns - holes, holes);
            let expected = f64::from(holes * window * window) / f64::from(columns * columns);
            for corner in 0..(columns - window).pow(2) {
                let (x, y) = (corner % (columns - window), corner / (columns - window));
                let rows = (y..y + window).map(|y| (y * columns + x) as usize);
                let found: usize =
                    rows.map(|at| count(&places[at..at + window as usize], Place::Hole)).sum();
                let off = (found as f64 - expected).abs();
                assert!(off <= 4.0, "{found} of {holes} at {x}, {y} instead of {expected}");
            }
        }
    }
}
