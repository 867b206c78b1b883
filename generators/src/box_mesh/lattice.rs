//! Cells of each part of a box: arithmetic on counts, no geometry.

use super::shape::BoxShape;

/// Height of the box.
pub(crate) const HEIGHT: f64 = 1.0;
/// Side of the square cross-section of a shaft.
pub(crate) const SHAFT: f64 = 1.0;
/// Depth of a cavity.
pub(crate) const DEPTH: f64 = 0.75;
/// Depth of a cavity as it counts when cells are dealt out: cells of its walls are about half again
/// as high as wide. Module `diagonals` gives the reason.
const COUNTED_DEPTH: f64 = DEPTH / 1.5;

/// Distance between neighbouring shafts, and from the outer ones to the sides; without shafts,
/// from one side of the box to the other.
pub(crate) fn gap(columns: u32) -> f64 {
    if columns == 0 { 2.0 } else { 0.5 }
}

/// The least number whose square is at least `shafts`.
pub(crate) fn columns(shafts: u64) -> u32 {
    if shafts == 0 { 0 } else { (shafts - 1).isqrt() as u32 + 1 }
}

/// The `index`th share when `total` things are spread evenly over `count` places.
pub(super) fn share(index: u32, total: u32, count: u32) -> u32 {
    let up_to = |index: u64| index * u64::from(total) / u64::from(count);
    (up_to(u64::from(index) + 1) - up_to(index.into())) as u32
}

/// Part that is cut into cells of its own.
#[derive(Clone, Copy)]
pub(super) enum Part {
    /// The side of a shaft.
    Shaft,
    /// The gap between two shafts.
    Gap,
    /// A cavity, from top to floor.
    Cavity,
    /// A hole, from top to bottom.
    Hole,
    /// The outer sides, from top to bottom.
    Side,
}

/// The grid lines of a box.
#[derive(Clone, Copy)]
pub(super) struct Lattice {
    /// Shafts in a row of the array, and rows.
    pub(super) columns: u32,
    pub(super) cavities: u32,
    pub(super) holes: u32,
    /// Cells along each [`Part`].
    cells: [u32; 5],
    /// Further lines across x and across y, spread over the gaps.
    pub(super) extra_lines: [u32; 2],
    /// Further rings around the walls, spread over the shafts.
    pub(super) extra_rings: u32,
}

impl Lattice {
    /// One cell for each part.
    pub(super) fn coarsest(cavities: u32, holes: u32) -> Self {
        let columns = columns(u64::from(cavities) + u64::from(holes));
        let (cells, extra_lines) = ([1; 5], [0; 2]);
        Self { columns, cavities, holes, cells, extra_lines, extra_rings: 0 }
    }

    /// The lattice of a box, which has to be possible; at most `shape.vertices` vertices. The
    /// difference is less than the number of its cells. O(√vertices).
    pub(super) fn of(shape: &BoxShape) -> Self {
        let mut lattice = Self::coarsest(shape.cavities, shape.holes);
        let fits = |lattice: &Self| lattice.vertices() <= shape.vertices.into();
        while let Some(finer) = Some(lattice.refined()).filter(fits) {
            lattice = finer;
        }
        for line in 0..2 * (lattice.columns + 1) {
            let mut finer = lattice;
            finer.extra_lines[(line % 2) as usize] += 1;
            if !fits(&finer) {
                break;
            }
            lattice = finer;
        }
        if lattice.columns > 0 {
            let left = u64::from(shape.vertices) - lattice.vertices();
            lattice.extra_rings = (left / lattice.ring()) as u32;
        }
        lattice
    }

    /// With one more cell for the part whose cells are longest.
    fn refined(mut self) -> Self {
        let exists = [self.columns, 1, self.cavities, self.holes, 1].map(|count| count > 0);
        let lengths = [SHAFT, gap(self.columns), COUNTED_DEPTH, HEIGHT, HEIGHT];
        let cell = |part: usize| lengths[part] / f64::from(self.cells[part]);
        let parts = (0..5).filter(|&part| exists[part]);
        let longest = parts.reduce(|a, b| if cell(b) > cell(a) { b } else { a });
        self.cells[longest.expect("every box has sides")] += 1;
        self
    }

    /// Cells along one `part`, without the extra ones.
    pub(super) fn cells(&self, part: Part) -> u32 {
        self.cells[part as usize]
    }

    /// Cells along the whole box in x (axis 0) or y (axis 1).
    pub(super) fn cells_along(&self, axis: usize) -> u64 {
        let columns = u64::from(self.columns);
        let [shaft, gap] = [Part::Shaft, Part::Gap].map(|part| u64::from(self.cells(part)));
        columns * shaft + (columns + 1) * gap + u64::from(self.extra_lines[axis])
    }

    /// Vertices of one ring around the walls of a shaft.
    fn ring(&self) -> u64 {
        4 * u64::from(self.cells(Part::Shaft))
    }

    /// Vertices of all grids together.
    pub(super) fn vertices(&self) -> u64 {
        let [x, y] = [self.cells_along(0), self.cells_along(1)];
        let [shaft, cavity, hole, side] =
            [Part::Shaft, Part::Cavity, Part::Hole, Part::Side].map(|p| u64::from(self.cells(p)));
        let (cavities, holes) = (u64::from(self.cavities), u64::from(self.holes));
        // What a cavity takes from the top it has again as its floor.
        let rings = cavities * cavity + holes * (hole - 1) + u64::from(self.extra_rings);
        2 * (x + 1) * (y + 1) + 2 * (x + y) * (side - 1) + rings * self.ring()
            - 2 * holes * (shaft - 1).pow(2)
    }

    /// Cells of all grids together: half the triangles of a surface with these vertices alone.
    pub(super) fn cell_count(&self) -> u64 {
        self.vertices() - 2 + 2 * u64::from(self.holes)
    }
}
