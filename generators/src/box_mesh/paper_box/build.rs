//! From a box of the papers' kind to its surface: two plates with the floors, then the walls.
//!
//! Walls come in slabs along x, those of one shaft in two. So simplification in the order of the
//! file takes them row by row, as `docs/meshes.md` explains.

use super::super::cell_surface::{CellSurface, Tube};
use super::shape::{ImpossiblePaperBoxError, PaperBox, THICKNESS, Walls};
use crate::surface::Surface;

impl PaperBox {
    /// Returns the box: connected, closed, simple, of genus [`PaperBox::holes`], outward, in cells
    /// of side 1.
    ///
    /// The first shafts are one cell from the sides; the two cells that are left along y are behind
    /// the last. Holes are drawn from the shafts by a fixed hash, those of a box with fewer among
    /// those of one with more. Plates and floors come first, then the walls in slabs along x.
    /// `below` draws for [`Walls::Drawn`]: `below(2)` once for each wall.
    ///
    /// O(n) time for n vertices; in addition to the surface, 4 bytes for each vertex of a plate.
    ///
    /// # Errors
    /// There is no such box.
    pub fn surface(
        &self,
        walls: Walls,
        below: &mut dyn FnMut(u32) -> u32,
    ) -> Result<Surface, ImpossiblePaperBoxError> {
        if self.depth == 0 {
            return Err(ImpossiblePaperBoxError::NoDepth);
        }
        let (holes, shafts) = (self.holes, u64::from(self.shafts).pow(2));
        if u64::from(holes) > shafts {
            return Err(ImpossiblePaperBoxError::TooManyHoles { holes, shafts });
        }
        if self.triangles() > (1 << 31) / 3 {
            return Err(ImpossiblePaperBoxError::TooManyHalfEdges);
        }
        Ok(build(self, walls, below))
    }
}

/// Builds the surface of a possible box. O(vertices).
fn build(shape: &PaperBox, pattern: Walls, below: &mut dyn FnMut(u32) -> u32) -> Surface {
    let mut builder = Builder {
        shape: *shape,
        cells: shape.cells().map(|cells| cells as u32),
        holes: holes(shape),
        surface: CellSurface::halved(shape.vertices() as usize, shape.triangles() as usize),
        plates: Default::default(),
    };
    builder.plate(Plate::Bottom);
    builder.plate(Plate::Top);
    let mut walls = WallsToBuild::default();
    for shaft in 0..shape.shafts.pow(2) {
        let tube = builder.shaft(shaft);
        walls.add_shaft(2 * (shaft % shape.shafts) + 1, tube, pattern.turned(below));
    }
    let sides = builder.sides();
    walls.add_sides(builder.cells, sides, pattern.turned(below));
    walls.build(&mut builder.surface);
    let surface = builder.surface.into_surface();
    debug_assert_eq!(surface.positions.len() as u64, shape.vertices());
    surface
}

/// Returns whether each shaft is a hole: those whose numbers have the least hashes.
fn holes(shape: &PaperBox) -> Vec<bool> {
    let mut order: Vec<u32> = (0..shape.shafts.pow(2)).collect();
    order.sort_unstable_by_key(|&shaft| hash(shaft));
    let mut holes = vec![false; order.len()];
    order[..shape.holes as usize].iter().for_each(|&shaft| holes[shaft as usize] = true);
    holes
}

/// Returns a number as good as random for each of them, different for different ones.
fn hash(shaft: u32) -> u32 {
    let x = shaft.wrapping_mul(0x9e37_79b1).wrapping_add(0x91c3_5f65);
    let x = (x ^ (x >> 15)).wrapping_mul(0x2c1b_3c6d);
    let x = (x ^ (x >> 12)).wrapping_mul(0x297a_2d39);
    x ^ (x >> 15)
}

/// One of the two plates, and its index in [`Builder::plates`].
#[derive(Clone, Copy, PartialEq)]
enum Plate {
    Bottom,
    Top,
}

struct Builder {
    shape: PaperBox,
    /// Along x, y and z.
    cells: [u32; 3],
    /// True if each shaft is a hole, row by row.
    holes: Vec<bool>,
    surface: CellSurface,
    /// The lattice vertices of bottom and top, row by row.
    plates: [Vec<u32>; 2],
}

impl Builder {
    /// Appends a plate row by row, the top with the floors of the cavities in each row.
    fn plate(&mut self, plate: Plate) {
        let z = if plate == Plate::Top { f64::from(self.cells[2]) } else { 0.0 };
        for y in 0..=self.cells[1] {
            for x in 0..=self.cells[0] {
                let vertex = self.surface.vertex([f64::from(x), f64::from(y), z]);
                self.plates[plate as usize].push(vertex);
            }
            if y > 0 {
                (0..self.cells[0]).for_each(|x| self.plate_cell(plate, [x, y - 1]));
            }
        }
    }

    /// Appends a cell of a plate, if it is closed there.
    fn plate_cell(&mut self, plate: Plate, cell: [u32; 2]) {
        let corners = self.corners(plate, cell);
        let is_hole = self.shaft_at(cell).map(|shaft| self.holes[shaft as usize]);
        match (plate, is_hole) {
            (Plate::Bottom, Some(true)) | (Plate::Top, Some(_)) => {}
            (Plate::Bottom, _) => {
                let [a, b, c, d] = corners;
                self.surface.quarters([d, c, b, a]);
            }
            (Plate::Top, None) => self.surface.quarters(corners),
        }
    }

    /// Returns the shaft at a cell of the plates, if there is one.
    fn shaft_at(&self, [x, y]: [u32; 2]) -> Option<u32> {
        let shafts = self.shape.shafts;
        let is_in = |at: u32| at % 2 == 1 && at / 2 < shafts;
        (is_in(x) && is_in(y)).then(|| y / 2 * shafts + x / 2)
    }

    /// Returns the corners of a cell of a plate, counter-clockwise from above.
    fn corners(&self, plate: Plate, [x, y]: [u32; 2]) -> [u32; 4] {
        let width = self.cells[0] + 1;
        let at = |x: u32, y: u32| self.plates[plate as usize][(y * width + x) as usize];
        [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]
    }

    /// Appends the vertices of a shaft and its floor, if it is a cavity.
    fn shaft(&mut self, shaft: u32) -> Tube {
        let cell = [shaft % self.shape.shafts, shaft / self.shape.shafts].map(|i| 2 * i + 1);
        let upper = self.corners(Plate::Top, cell);
        let is_hole = self.holes[shaft as usize];
        let lower = if is_hole { self.corners(Plate::Bottom, cell) } else { self.floor(upper) };
        let levels = self.shape.depth + if is_hole { THICKNESS } else { 0 };
        // The outside of the surface is the inside of the shaft.
        let inwards = |[a, b, c, d]: [u32; 4]| [d, c, b, a];
        self.surface.tube(inwards(upper).into(), inwards(lower).into(), levels)
    }

    /// Appends a floor below the given corners of a cell.
    fn floor(&mut self, upper: [u32; 4]) -> [u32; 4] {
        let depth = f64::from(self.shape.depth);
        let corners = upper.map(|v| {
            let [x, y, z] = self.surface.position(v);
            self.surface.vertex([x, y, z - depth])
        });
        self.surface.quarters(corners);
        corners
    }

    /// Appends the vertices of the outer sides.
    fn sides(&mut self) -> Tube {
        let [upper, lower] = [Plate::Top, Plate::Bottom].map(|plate| self.rim(plate));
        self.surface.tube(upper, lower, self.cells[2])
    }

    /// Returns the vertices round a plate, counter-clockwise from above.
    fn rim(&self, plate: Plate) -> Vec<u32> {
        let [right, back, _] = self.cells;
        let front = (0..right).map(|x| [x, 0]).chain((0..back).map(|y| [right, y]));
        let behind = (1..=right).rev().map(|x| [x, back]).chain((1..=back).rev().map(|y| [0, y]));
        let at = |[x, y]: [u32; 2]| self.plates[plate as usize][(y * (right + 1) + x) as usize];
        front.chain(behind).map(at).collect()
    }
}

/// All walls, as strips of cells below each other.
#[derive(Default)]
struct WallsToBuild {
    tubes: Vec<Tube>,
    strips: Vec<Strip>,
}

/// One step round a tube, from top to bottom.
struct Strip {
    /// The cell along x that it is in; the one behind it, if it lies across x.
    slab: u32,
    tube: usize,
    step: usize,
    turned: bool,
}

impl WallsToBuild {
    /// Adds the walls of a shaft in the cells `x`, those at the back, right, front and left.
    fn add_shaft(&mut self, x: u32, tube: Tube, turned: [bool; 4]) {
        let slabs = [x, x + 1, x, x];
        let strip =
            |step| Strip { slab: slabs[step], tube: self.tubes.len(), step, turned: turned[step] };
        self.strips.extend((0..4).map(strip));
        self.tubes.push(tube);
    }

    /// Adds the outer sides: front, right, back and left.
    fn add_sides(&mut self, [across, back, _]: [u32; 3], tube: Tube, turned: [bool; 4]) {
        let front = (0..across).map(|x| (x, 0));
        let right = (0..back).map(|_| (across, 1));
        let behind = (0..across).rev().map(|x| (x, 2));
        let left = (0..back).map(|_| (0, 3));
        for (step, (slab, side)) in front.chain(right).chain(behind).chain(left).enumerate() {
            self.strips.push(Strip { slab, tube: self.tubes.len(), step, turned: turned[side] });
        }
        self.tubes.push(tube);
    }

    /// Appends the cells of all walls, slab by slab.
    fn build(mut self, surface: &mut CellSurface) {
        self.strips.sort_by_key(|strip| strip.slab);
        for Strip { tube, step, turned, .. } in self.strips {
            let tube = &self.tubes[tube];
            (0..tube.levels()).for_each(|level| surface.cell(tube.corners(level, step), turned));
        }
    }
}
