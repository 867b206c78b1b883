//! From counts to a surface: two plates, the sides between them, and the shafts.

use super::array::{Place, places};
use super::cell_surface::{CellSurface, between};
use super::diagonals::{is_turned, is_turned_around};
use super::lattice::{DEPTH, HEIGHT, Lattice, Part, SHAFT, gap, share};
use super::shape::BoxShape;
use crate::surface::Surface;

/// No vertex, or no shaft.
const NONE: u32 = u32::MAX;

/// The box, which has to be possible. O(vertices).
pub(super) fn surface(shape: &BoxShape) -> Surface {
    let lattice = Lattice::of(shape);
    let centres = u64::from(shape.vertices) - lattice.vertices();
    let mut builder = Builder {
        axes: [0, 1].map(|axis| Axis::new(&lattice, axis)),
        places: places(lattice.columns, lattice.cavities, lattice.holes),
        cells: CellSurface::new(shape.vertices as usize, lattice.cell_count(), centres),
        plates: Default::default(),
        floor: Grid::default(),
        loops: Default::default(),
        shafts: 0,
        lattice,
    };
    builder.plate(Plate::Bottom);
    builder.plate(Plate::Top);
    builder.sides();
    let surface = builder.cells.into_surface();
    debug_assert_eq!(surface.positions.len(), shape.vertices as usize);
    surface
}

/// The grid lines across one horizontal axis.
struct Axis {
    /// Positions.
    lines: Vec<f64>,
    /// For each cell between two lines the column of the array it is in, or [`NONE`].
    columns: Vec<u32>,
    /// The first line of each column.
    starts: Vec<usize>,
}

impl Axis {
    fn new(lattice: &Lattice, axis: usize) -> Self {
        let mut new = Self { lines: Vec::new(), columns: Vec::new(), starts: Vec::new() };
        let mut end = 0.0;
        for column in 0..=lattice.columns {
            let extra = share(column, lattice.extra_lines[axis], lattice.columns + 1);
            end = new.extend(end, gap(lattice.columns), lattice.cells(Part::Gap) + extra, NONE);
            if column < lattice.columns {
                new.starts.push(new.lines.len());
                end = new.extend(end, SHAFT, lattice.cells(Part::Shaft), column);
            }
        }
        new.lines.push(end);
        new
    }

    /// Appends a stretch of cells without its last line, and returns where that one is.
    fn extend(&mut self, start: f64, length: f64, cells: u32, column: u32) -> f64 {
        let end = start + length;
        self.lines.extend((0..cells).map(|step| between([start, end], step, cells)));
        self.columns.extend((0..cells).map(|_| column));
        end
    }

    /// Returns whether cells have the other diagonal because of their place in a column, or
    /// [`None`] between two columns.
    fn is_turned(&self, cell: usize) -> Option<bool> {
        let start = self.starts.get(self.columns[cell] as usize)?;
        Some(is_turned(cell - start))
    }

    /// The column that the given line is strictly inside of, or [`NONE`].
    fn column_around(&self, line: usize) -> u32 {
        match line.checked_sub(1) {
            Some(before) if self.columns.get(line) == Some(&self.columns[before]) => {
                self.columns[before]
            }
            _ => NONE,
        }
    }
}

/// The vertices of a horizontal grid, row by row.
#[derive(Default)]
struct Grid {
    width: usize,
    /// A vertex, or [`NONE`] over a shaft.
    vertices: Vec<u32>,
}

impl Grid {
    fn at(&self, [x, y]: [usize; 2]) -> u32 {
        self.vertices[y * self.width + x]
    }

    /// The corners of a cell, counter-clockwise from above.
    fn cell(&self, [x, y]: [usize; 2]) -> [u32; 4] {
        [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]].map(|corner| self.at(corner))
    }

    /// The vertices around a rectangle of cells, counter-clockwise from above.
    fn rim(&self, [x, y]: [usize; 2], [width, depth]: [usize; 2], rim: &mut Vec<u32>) {
        let (right, back) = (x + width, y + depth);
        rim.clear();
        rim.extend((x..right).map(|x| self.at([x, y])));
        rim.extend((y..back).map(|y| self.at([right, y])));
        rim.extend((x..right).rev().map(|x| self.at([x + 1, back])));
        rim.extend((y..back).rev().map(|y| self.at([x, y + 1])));
    }
}

/// One of the two plates, and its index in [`Builder::plates`].
#[derive(Clone, Copy, PartialEq)]
enum Plate {
    Bottom,
    Top,
}

impl Plate {
    /// Returns whether it is open where the array has `place`.
    fn is_open(self, place: Place) -> bool {
        match self {
            Self::Bottom => place == Place::Hole,
            Self::Top => place != Place::Empty,
        }
    }
}

struct Builder {
    lattice: Lattice,
    axes: [Axis; 2],
    places: Vec<Place>,
    cells: CellSurface,
    plates: [Grid; 2],
    /// The floor of a cavity, and the loops at the ends of its walls: scratch.
    floor: Grid,
    loops: [Vec<u32>; 2],
    /// Shafts dug so far.
    shafts: u32,
}

impl Builder {
    /// Appends a plate, and after each row of the array its shafts.
    fn plate(&mut self, plate: Plate) {
        let [across, rows] = [0, 1].map(|axis| self.axes[axis].lines.len());
        self.plates[plate as usize] =
            Grid { width: across, vertices: Vec::with_capacity(across * rows) };
        let shaft = self.lattice.cells(Part::Shaft) as usize;
        let mut row = 0;
        for y in 0..rows {
            self.line(plate, y);
            if y > 0 {
                self.strip(plate, y - 1);
            }
            if plate == Plate::Top && self.axes[1].starts.get(row).is_some_and(|s| s + shaft == y) {
                (0..self.lattice.columns).for_each(|column| self.shaft(column, row as u32));
                row += 1;
            }
        }
    }

    /// Returns whether `plate` is open at a column and a row of the array, which may be [`NONE`].
    fn is_open(&self, plate: Plate, column: u32, row: u32) -> bool {
        let place = || self.places[(row * self.lattice.columns + column) as usize];
        column != NONE && row != NONE && plate.is_open(place())
    }

    /// Appends the vertices along one line of a plate.
    fn line(&mut self, plate: Plate, y: usize) {
        let row = self.axes[1].column_around(y);
        let height = [0.0, HEIGHT][plate as usize];
        for x in 0..self.axes[0].lines.len() {
            let open = self.is_open(plate, self.axes[0].column_around(x), row);
            let position = [self.axes[0].lines[x], self.axes[1].lines[y], height];
            let vertex = if open { NONE } else { self.cells.vertex(position) };
            self.plates[plate as usize].vertices.push(vertex);
        }
    }

    /// Appends the cells between two lines of a plate.
    fn strip(&mut self, plate: Plate, y: usize) {
        let row = self.axes[1].columns[y];
        for x in 0..self.axes[0].columns.len() {
            if !self.is_open(plate, self.axes[0].columns[x], row) {
                let [a, b, c, d] = self.plates[plate as usize].cell([x, y]);
                let corners = if plate == Plate::Top { [a, b, c, d] } else { [d, c, b, a] };
                let turned = self.axes[0].is_turned(x).or(self.axes[1].is_turned(y));
                self.cells.cell(corners, turned == Some(true));
            }
        }
    }

    /// Appends the walls of the shaft at a place of the array, and its floor, if there are any.
    fn shaft(&mut self, column: u32, row: u32) {
        let place = self.places[(row * self.lattice.columns + column) as usize];
        if place == Place::Empty {
            return;
        }
        let corner = [self.axes[0].starts[column as usize], self.axes[1].starts[row as usize]];
        let size = [self.lattice.cells(Part::Shaft) as usize; 2];
        let [upper, lower] = &mut self.loops;
        self.plates[Plate::Top as usize].rim(corner, size, upper);
        let part = match place {
            Place::Hole => {
                self.plates[Plate::Bottom as usize].rim(corner, size, lower);
                Part::Hole
            }
            _ => {
                lay_floor(&mut self.floor, &self.axes, &mut self.cells, corner, size);
                self.floor.rim([0, 0], size, lower);
                Part::Cavity
            }
        };
        // The outside of the surface is the inside of the shaft: the other way round from the same
        // corner.
        upper[1..].reverse();
        lower[1..].reverse();
        let shafts = self.lattice.cavities + self.lattice.holes;
        let extra = share(self.shafts, self.lattice.extra_rings, shafts);
        self.shafts += 1;
        let turned = |step| is_turned_around(size[0], step);
        self.cells.walls(upper, lower, self.lattice.cells(part) + extra, turned);
        if place == Place::Cavity {
            for [x, y] in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y])) {
                self.cells.cell(self.floor.cell([x, y]), is_turned(x));
            }
        }
    }

    /// Appends the outer sides.
    fn sides(&mut self) {
        let size = [0, 1].map(|axis| self.axes[axis].columns.len());
        let [upper, lower] = &mut self.loops;
        self.plates[Plate::Top as usize].rim([0, 0], size, upper);
        self.plates[Plate::Bottom as usize].rim([0, 0], size, lower);
        self.cells.walls(upper, lower, self.lattice.cells(Part::Side), |_| false);
    }
}

/// Appends the vertices of a floor under the given cells.
fn lay_floor(
    floor: &mut Grid,
    axes: &[Axis; 2],
    cells: &mut CellSurface,
    corner: [usize; 2],
    size: [usize; 2],
) {
    floor.width = size[0] + 1;
    floor.vertices.clear();
    for y in &axes[1].lines[corner[1]..=corner[1] + size[1]] {
        for x in &axes[0].lines[corner[0]..=corner[0] + size[0]] {
            floor.vertices.push(cells.vertex([*x, *y, HEIGHT - DEPTH]));
        }
    }
}
