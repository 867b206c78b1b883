//! Surfaces put together from quadrilateral cells.

use crate::surface::Surface;

/// A surface under construction. Of a known number of cells, some get a vertex in their centre,
/// spread evenly in the order of the cells.
pub(super) struct CellSurface {
    surface: Surface,
    cells: u64,
    centres: u64,
    /// `centres` times the cells so far, plus half of `cells`, modulo `cells`.
    phase: u64,
}

impl CellSurface {
    /// An empty surface that will have `vertices` vertices, `centres` of them in the centres of its
    /// `cells` cells.
    pub(super) fn new(vertices: usize, cells: u64, centres: u64) -> Self {
        debug_assert!(centres <= cells);
        let surface = Surface {
            positions: Vec::with_capacity(vertices),
            triangles: Vec::with_capacity(2 * (cells + centres) as usize),
        };
        Self { surface, cells, centres, phase: cells / 2 }
    }

    /// An empty surface that will have so many vertices and triangles, and centres only in cells
    /// added by [`CellSurface::quarters`].
    pub(super) fn halved(vertices: usize, triangles: usize) -> Self {
        let surface = Surface {
            positions: Vec::with_capacity(vertices),
            triangles: Vec::with_capacity(triangles),
        };
        Self { surface, cells: 1, centres: 0, phase: 0 }
    }

    pub(super) fn into_surface(self) -> Surface {
        debug_assert_eq!(self.phase, self.cells / 2, "there were as many cells as announced");
        self.surface
    }

    pub(super) fn vertex(&mut self, position: [f64; 3]) -> u32 {
        self.surface.positions.push(position);
        self.surface.positions.len() as u32 - 1
    }

    pub(super) fn position(&self, vertex: u32) -> [f64; 3] {
        self.surface.positions[vertex as usize]
    }

    /// A rectangle, its corners counter-clockwise from outside. Two triangles, `turned` or not, or
    /// four around the centre; left to right, so that cells that follow each other share an edge.
    ///
    /// ```text
    ///   d---c      d---c      d---c
    ///   | / |  or  | \ |  or  | x |
    ///   a---b      a---b      a---b
    /// ```
    pub(super) fn cell(&mut self, [a, b, c, d]: [u32; 4], turned: bool) {
        self.phase += self.centres;
        if self.phase >= self.cells {
            self.phase -= self.cells;
            return self.quarters([a, b, c, d]);
        }
        let halves = if turned { [[a, b, d], [b, c, d]] } else { [[a, c, d], [a, b, c]] };
        self.surface.triangles.extend(halves);
    }

    /// A rectangle cut in four round a centre, its corners counter-clockwise from outside.
    pub(super) fn quarters(&mut self, [a, b, c, d]: [u32; 4]) {
        let [p, q] = [a, c].map(|v| self.surface.positions[v as usize]);
        let centre = self.vertex([0, 1, 2].map(|axis| (p[axis] + q[axis]) / 2.0));
        self.surface
            .triangles
            .extend([[a, b], [b, c], [c, d], [d, a]].map(|[u, v]| [u, v, centre]));
    }

    /// Vertical walls between two closed loops of vertices one above the other, `levels` cells
    /// high. The outside is to the right of the loops seen from above. `turned` states for each
    /// step of the loops which diagonal the cells there have.
    pub(super) fn walls(
        &mut self,
        upper: &[u32],
        lower: &[u32],
        levels: u32,
        turned: impl Fn(usize) -> bool,
    ) {
        let tube = self.tube(upper.to_vec(), lower.to_vec(), levels);
        for level in 0..levels {
            for i in 0..upper.len() {
                self.cell(tube.corners(level, i), turned(i));
            }
        }
    }

    /// Appends the vertices of walls as above, without their cells.
    pub(super) fn tube(&mut self, upper: Vec<u32>, lower: Vec<u32>, levels: u32) -> Tube {
        let first = self.surface.positions.len() as u32;
        let heights = [upper[0], lower[0]].map(|v| self.surface.positions[v as usize][2]);
        for level in 1..levels {
            let z = between(heights, level, levels);
            for &v in &upper {
                let [x, y, _] = self.surface.positions[v as usize];
                self.vertex([x, y, z]);
            }
        }
        Tube { upper, lower, levels, first }
    }
}

/// The vertices of vertical walls between two loops.
pub(super) struct Tube {
    upper: Vec<u32>,
    lower: Vec<u32>,
    levels: u32,
    /// The first vertex between the loops.
    first: u32,
}

impl Tube {
    pub(super) fn levels(&self) -> u32 {
        self.levels
    }

    /// The corners of the cell at a level from above and a step of the loops, counter-clockwise
    /// from outside, the lower ones first.
    pub(super) fn corners(&self, level: u32, step: usize) -> [u32; 4] {
        let next = if step + 1 == self.upper.len() { 0 } else { step + 1 };
        let below = [self.vertex(level + 1, step), self.vertex(level + 1, next)];
        [below[0], below[1], self.vertex(level, next), self.vertex(level, step)]
    }

    fn vertex(&self, level: u32, step: usize) -> u32 {
        match level {
            0 => self.upper[step],
            _ if level == self.levels => self.lower[step],
            _ => self.first + (level - 1) * self.upper.len() as u32 + step as u32,
        }
    }
}

/// Point `step` of `steps` equal steps from the first to the second number.
pub(super) fn between([from, to]: [f64; 2], step: u32, steps: u32) -> f64 {
    from + (to - from) * f64::from(step) / f64::from(steps)
}
