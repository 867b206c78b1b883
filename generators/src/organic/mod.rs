//! Smooth, irregular shapes of any genus: what to simplify when a scanned model of that genus is
//! not at hand.
//!
//! The surface of a [box with holes](crate::box_mesh) is mapped into space by functions that are
//! all one-to-one, so that it stays closed, of the same genus and without self-intersections:
//!
//! 1. The box is rounded: without holes to an ellipsoid, otherwise to a plate between two smooth
//!    sheets with round holes, its cross-section between two holes an oval.
//! 2. The plate is scaled in z by a positive factor that depends on x and y.
//! 3. It is displaced in z by a function of x and y, then in x by one of y and z, then in y by one
//!    of x and z. Whatever these functions are, each step can be undone.
//!
//! The functions of the last two steps are smooth noise of a few octaves: random in the large and
//! in the small, down to about the width of what is between two holes. The argument holds for the
//! smooth maps; the triangles follow them as closely as they are small, which is why there is a
//! least number of vertices.

mod noise;
mod rounding;

#[cfg(test)]
mod tests;

use crate::box_mesh::{BoxShape, lattice::columns};
use crate::surface::Surface;
use noise::{Noise, octaves};
use rounding::Rounding;

/// Largest relative change of the thickness by the first octave; all of them reach less than twice
/// as much.
const THICKENING: f64 = 0.35;
/// Largest coefficient of a displacement over its wavelength, in the root mean square of octaves.
const BEND: f64 = 0.45;

/// A smooth random surface of the given genus with exactly `at_least` vertices, or the fewest that
/// resolve its shape if that is more: [`minimum_vertices`]. Connected, closed, simple, outward.
///
/// Connectivity and numbering are those of the box, almost all degrees are 6; simplified to a third
/// of its vertices it has the irregular connectivity of a simplified scan. Neighbouring holes are
/// 3/2 apart; a surface of genus 0 is about 2 wide.
///
/// Equal draws from `below` (uniform in `0..n`) give equal surfaces, to the last bit on every
/// platform. O(vertices · log genus).
///
/// # Panics
/// If the surface would have more than 2³¹ half-edges.
pub fn surface(genus: u32, at_least: u32, below: &mut dyn FnMut(u32) -> u32) -> Surface {
    let vertices = minimum_vertices(genus).max(at_least.into());
    let vertices = u32::try_from(vertices).expect("a u32 numbers the half-edges");
    let shape = BoxShape { cavities: 0, holes: genus, vertices };
    let mut surface = shape.surface().unwrap_or_else(|why| panic!("{why}"));
    let rounding = Rounding::new(genus);
    let warp = Warp::new(rounding.radius(), rounding.detail(), below);
    for position in &mut surface.positions {
        *position = warp.apply(rounding.apply(*position));
    }
    surface
}

/// The vertices that [`surface`] spends at least: about three edges across and twelve around each
/// hole. O(1).
pub fn minimum_vertices(genus: u32) -> u64 {
    let columns = u64::from(columns(genus.into()));
    150 + 100 * columns + 70 * columns.pow(2)
}

/// The displacements of all three axes, and the scaling of z.
struct Warp {
    /// Smaller than 1, so that the scaling is by a positive factor.
    thickness: Noise,
    along: [Noise; 3],
}

impl Warp {
    /// For a shape within `radius` of the z axis that has details of the size `finest`.
    fn new(radius: f64, finest: f64, below: &mut dyn FnMut(u32) -> u32) -> Self {
        // Each octave bends the surface by about the same angle, in random directions.
        let slope = BEND / f64::from(octaves(radius, finest)).sqrt();
        Self {
            thickness: Noise::new(radius, finest, THICKENING, below),
            along: [(); 3].map(|()| Noise::new(radius, finest, slope * radius, below)),
        }
    }

    fn apply(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let z = z * (1.0 + self.thickness.at(x, y)) + self.along[2].at(x, y);
        let x = x + self.along[0].at(y, z);
        let y = y + self.along[1].at(x, z);
        [x, y, z]
    }
}
