//! Random closed surfaces of any genus, tori of random degrees, irregular versions of regular ones.
//!
//! `below(n)` is always a uniform draw from `0..n`; equal draws give equal surfaces.

use crate::classic::{octahedron, seven_vertex_torus, tetrahedron};
use crate::grids;
use crate::sculptor::{Operation, Sculptor};
use crate::surface::Surface;

/// The mix of operations that makes a random surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mix {
    /// Face splits only: many vertices of degree 3 and a few of very high degree.
    Splits,
    /// Edge splits only: many vertices of degree 4, no vertex of degree 3 but those of the start.
    Subdivisions,
    /// Seven tried flips for each edge split: degrees spread widely.
    Flips,
    /// One face split and one edge split for two tried flips.
    Balanced,
}

impl Mix {
    /// Every mix there is.
    pub const ALL: [Self; 4] = [Self::Splits, Self::Subdivisions, Self::Flips, Self::Balanced];

    /// Shares, out of eight, of face splits and of edge splits; the rest are flips.
    fn shares(self) -> (u32, u32) {
        match self {
            Self::Splits => (8, 0),
            Self::Subdivisions => (0, 8),
            Self::Flips => (0, 1),
            Self::Balanced => (2, 2),
        }
    }

    fn draw(self, sculptor: &Sculptor, below: &mut dyn FnMut(u32) -> u32) -> Operation {
        let (face_splits, edge_splits) = self.shares();
        let kind = below(8);
        if kind < face_splits {
            Operation::SplitFace(below(sculptor.face_count()))
        } else if kind < face_splits + edge_splits {
            Operation::SplitEdge(below(sculptor.half_edge_count()))
        } else {
            Operation::Flip(below(sculptor.half_edge_count()))
        }
    }
}

/// A random connected closed surface, numbered at random: `operations` edits drawn from `mix`,
/// starting from a tetrahedron or an octahedron, or from a connected sum of `genus` tori of seven
/// vertices.
///
/// Simple, oriented, of exactly this genus, with at most `operations` vertices more than the start
/// has. The coordinates are finite and, short of a conspiracy of draws, distinct, but the surface
/// may pass through itself. O((genus + operations) · degree).
///
/// # Panics
/// If the surface gets too large to number its half-edges with a `u32`.
pub fn random_surface(
    genus: usize,
    operations: usize,
    mix: Mix,
    below: &mut dyn FnMut(u32) -> u32,
) -> Surface {
    let mut sculptor = start(genus, below);
    for _ in 0..operations {
        let operation = mix.draw(&sculptor, below);
        sculptor.apply(operation);
    }
    sculptor.relabel(below);
    let mut surface = sculptor.into_surface();
    shake(&mut surface.positions, below);
    surface
}

/// Moves every coordinate by a random amount below 2⁻¹⁰. Midpoints of symmetric starts coincide
/// often, and a file format without vertex numbers would weld them.
fn shake(positions: &mut [[f64; 3]], below: &mut dyn FnMut(u32) -> u32) {
    for coordinate in positions.as_flattened_mut() {
        *coordinate += f64::from(below(1 << 20)) / f64::from(1 << 30);
    }
}

/// A small surface of the given genus.
fn start(genus: usize, below: &mut dyn FnMut(u32) -> u32) -> Sculptor {
    if genus == 0 {
        let spheres = [tetrahedron(), octahedron()];
        return Sculptor::from(&spheres[below(2) as usize]);
    }
    let torus = seven_vertex_torus();
    let mut sculptor = Sculptor::from(&torus);
    for _ in 1..genus {
        sculptor.join(&torus, below(sculptor.face_count()));
    }
    sculptor
}

/// `surface` with its connectivity stirred: `rounds` random flips tried for each edge.
///
/// The vertices stay as they are, the degrees of a regular grid spread out after one or two
/// rounds. Flips are legal by connectivity alone, so triangles get long and cross each other.
/// O(rounds · n · degree) and the sorting of the edges; a million triangles take about a second a
/// round.
///
/// # Panics
/// If `surface` is not simple, closed and consistently oriented, as for [`Sculptor::from`].
pub fn irregular(surface: &Surface, rounds: usize, below: &mut dyn FnMut(u32) -> u32) -> Surface {
    let mut sculptor = Sculptor::from(surface);
    let half_edges = sculptor.half_edge_count();
    for _ in 0..rounds * (half_edges / 2) as usize {
        sculptor.flip(below(half_edges));
    }
    sculptor.into_surface()
}

/// [`grids::torus`] with the diagonal of each square cell drawn: degrees from 4 to 8. O(nu · nv).
///
/// # Panics
/// As [`grids::torus`].
pub fn torus(nu: u32, nv: u32, below: &mut dyn FnMut(u32) -> u32) -> Surface {
    let mut surface = grids::torus(nu, nv);
    let (cells, _) = surface.triangles.as_chunks_mut();
    for [one, other] in cells {
        if below(2) == 1 {
            // The torus cuts each cell a, b, c, d from a to c.
            let ([a, b, c], d) = (*one, other[2]);
            [*one, *other] = [[a, b, d], [b, c, d]];
        }
    }
    surface
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{assert_distinct_positions, assert_oriented, degrees};
    use crate::testing::draws;

    #[test]
    fn random_surfaces_have_their_genus() {
        for mix in Mix::ALL {
            for genus in [0, 1, 2, 5] {
                for (seed, operations) in [(1, 0), (2, 1), (3, 10), (4, 100), (5, 1000)] {
                    let surface = random_surface(genus, operations, mix, &mut draws(seed));
                    assert_oriented(&surface, genus);
                    assert_distinct_positions(&surface);
                }
            }
        }
    }

    #[test]
    fn equal_draws_give_equal_surfaces() {
        let [a, b, c] =
            [1, 1, 2].map(|seed| random_surface(2, 100, Mix::Balanced, &mut draws(seed)));
        assert_eq!(a, b);
        assert_ne!(a, c);
    }

    #[test]
    fn every_mix_has_its_own_degrees() {
        let lowest = |mix| {
            let surface = random_surface(1, 1000, mix, &mut draws(9));
            degrees(&surface).into_iter().min()
        };
        let lowest = Mix::ALL.map(lowest);
        assert_eq!(lowest, [Some(3), Some(4), Some(3), Some(3)]);
    }

    #[test]
    fn irregular_surfaces_keep_vertices_and_genus() {
        for (regular, genus) in [(grids::sphere(12), 0), (grids::torus(20, 15), 1)] {
            let stirred = irregular(&regular, 2, &mut draws(5));
            assert_oriented(&stirred, genus);
            assert_eq!(stirred.positions, regular.positions);
            let degrees = degrees(&stirred);
            assert!(degrees.contains(&4) && degrees.iter().any(|&degree| degree > 8));
        }
    }

    #[test]
    fn tori_have_every_degree_from_4_to_8() {
        for (nu, nv) in [(3, 3), (3, 40), (40, 30)] {
            let surface = torus(nu, nv, &mut draws(3));
            assert_oriented(&surface, 1);
            assert_eq!(surface.positions, grids::torus(nu, nv).positions);
            let degrees = degrees(&surface);
            assert!(degrees.iter().all(|degree| (4..=8).contains(degree)));
            assert!(nu < 40 || (4..=8).all(|degree| degrees.contains(&degree)));
        }
    }

    #[test]
    fn no_rounds_change_nothing() {
        assert_eq!(irregular(&grids::sphere(4), 0, &mut draws(5)), grids::sphere(4));
    }
}
