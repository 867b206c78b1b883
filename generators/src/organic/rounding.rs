//! From the surface of a box to one without edges.

use crate::box_mesh::array::{Place, places};
use crate::box_mesh::lattice::{HEIGHT, SHAFT, columns, gap};
use crate::circle::quarter;

/// Semi-axes of the shape without holes.
const ELLIPSOID: [f64; 3] = [1.0, 0.8, 0.6];
/// Half the thickness of the plate.
const THICKNESS: f64 = 0.42;
/// Radius of a hole where it is narrowest.
const HOLE: f64 = 0.38;
/// Reach of the rim of the plate beyond the array of holes.
const RIM: f64 = 0.4;
/// How much of the square is used that [`to_disc`] makes round: all of it would flatten the
/// triangles in its corners.
const ROUND: f64 = 0.85;

/// A map from the surface of a box with holes to a smooth one, about the origin.
pub(super) struct Rounding {
    columns: u32,
    places: Vec<Place>,
}

/// Half the distance of neighbouring holes: the holes sit in square tiles.
fn half_tile() -> f64 {
    (SHAFT + gap(1)) / 2.0
}

impl Rounding {
    /// For the box with these holes and without cavities.
    pub(super) fn new(holes: u32) -> Self {
        let columns = columns(holes.into());
        Self { columns, places: places(columns, 0, holes) }
    }

    /// About the distance of the farthest point from the z axis.
    pub(super) fn radius(&self) -> f64 {
        if self.columns == 0 { ELLIPSOID[0] } else { self.array() + RIM }
    }

    /// The size of the smallest details that fit between two holes, or that make a shape without
    /// holes interesting.
    pub(super) fn detail(&self) -> f64 {
        if self.columns == 0 { 0.1 } else { 0.35 }
    }

    /// Half the side of the array of tiles.
    fn array(&self) -> f64 {
        f64::from(self.columns) * half_tile()
    }

    pub(super) fn apply(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let z = z - HEIGHT / 2.0;
        if self.columns == 0 {
            let half = gap(0) / 2.0;
            let ball = to_ball([x / half - 1.0, y / half - 1.0, z / (HEIGHT / 2.0)]);
            return [0, 1, 2].map(|axis| ball[axis] * ELLIPSOID[axis]);
        }
        let half = self.array() + gap(self.columns) / 2.0;
        let ([x, y], part) = self.flatten([x - half, y - half], HEIGHT / 2.0 - z.abs());
        let [height, _] = quarter(part);
        let height = THICKNESS * height;
        let [x, y] = to_disc([x, y], self.radius());
        [x, y, if z < 0.0 { -height } else { height }]
    }

    /// Where a point goes in x and y if it is `down` below the top or above the bottom, and how far
    /// it is, from 0 to 1, on the way from the tile's border over the edge to half the height.
    fn flatten(&self, point: [f64; 2], down: f64) -> ([f64; 2], f64) {
        let (from_centre, array) = (largest(point), self.array());
        // The way across half a gap and down half a wall.
        let way = gap(self.columns) / 2.0 + HEIGHT / 2.0;
        if from_centre > array {
            let part = (from_centre - array + down) / way;
            let outward = quarter(part)[1];
            // Small enough that a corner moves outward nearly as fast as the sides do.
            let softness = outward * RIM / (2.0 * array);
            let scale = (array + RIM * outward) / softened(point, softness);
            return (point.map(|x| x * scale), part);
        }
        let tile = point.map(|x| self.tile(x));
        let place = tile[1] as usize * self.columns as usize + tile[0] as usize;
        if self.places[place] != Place::Hole {
            return (point, 0.0);
        }
        let centre = tile.map(|tile| f64::from(2 * tile + 1) * half_tile() - array);
        let local = [point[0] - centre[0], point[1] - centre[1]];
        let part = (half_tile() - largest(local) + down) / way;
        let rounded = into_hole(local, quarter(part)[1]);
        ([centre[0] + rounded[0], centre[1] + rounded[1]], part)
    }

    /// The column of tiles in which a coordinate inside the array is.
    fn tile(&self, x: f64) -> u32 {
        let tiles = (x + self.array()) / (2.0 * half_tile());
        (tiles as u32).min(self.columns - 1)
    }
}

/// The point `part` of the way, 0 to 1, from the border of a tile to the circle around its centre,
/// on the ray through `local`.
fn into_hole(local: [f64; 2], part: f64) -> [f64; 2] {
    let [x, y] = local;
    let (border, circle) = (half_tile() / softened(local, part), HOLE / (x * x + y * y).sqrt());
    local.map(|x| x * (border + (circle - border) * part))
}

/// Distance from the origin in the norm whose balls are squares.
fn largest([x, y]: [f64; 2]) -> f64 {
    x.abs().max(y.abs())
}

/// A norm whose balls are squares with corners rounded by `softness` between 0 and 1: [`largest`]
/// if that is 0, up to √2 times as much otherwise.
fn softened([x, y]: [f64; 2], softness: f64) -> f64 {
    let (sum, difference) = (x * x + y * y, x * x - y * y);
    let soft = softness * sum;
    ((sum + (difference * difference + soft * soft).sqrt()) / 2.0).sqrt()
}

/// Makes a square of this half side nearly round: a part of the map
/// `x √(1 - y²/2)`, `y √(1 - x²/2)` from the square of half side 1 to the disc.
fn to_disc(point: [f64; 2], half_side: f64) -> [f64; 2] {
    let [x, y] = point.map(|x| x * ROUND / half_side);
    let [across, along] = [y, x].map(|other| (1.0 - other * other / 2.0).sqrt());
    [point[0] * across, point[1] * along]
}

/// From the cube of half side 1 to the ball, the analogue of [`to_disc`]: its triangles are of
/// nearly equal size.
fn to_ball([x, y, z]: [f64; 3]) -> [f64; 3] {
    let [xx, yy, zz] = [x * x, y * y, z * z];
    let shrink = |a: f64, b: f64| (1.0 - a / 2.0 - b / 2.0 + a * b / 3.0).sqrt();
    [x * shrink(yy, zz), y * shrink(zz, xx), z * shrink(xx, yy)]
}
