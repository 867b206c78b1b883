//! Welding: vertices at equal or nearly equal coordinates become one.

use std::collections::HashMap;

use super::derived::Derived;
use super::polygon_mesh::Mesh;

/// Outcome of welding a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Welded {
    /// Vertices that became one with an earlier one.
    pub merged_vertices: usize,
    /// Faces dropped because fewer than three corners are left of them.
    pub dropped_faces: usize,
}

impl Mesh {
    /// Makes vertices one whose distance is at most `tolerance`; at 0, those of equal coordinates.
    ///
    /// In file order, every vertex becomes one with the nearest kept vertex within the distance,
    /// the first of equally near ones; if there is none it is kept. So vertices keep their order,
    /// each with the coordinates of its first occurrence, and unreferenced ones are treated alike.
    /// Neighbouring corners of a face that become one are one corner. A face of fewer than three
    /// is dropped.
    ///
    /// ```
    /// use triquad::mesh::Mesh;
    ///
    /// let corners = [0.0, 1.0, 2.0, 1.0, 2.0, 3.0].map(|x| [x, x * x, 0.0]);
    /// let mut mesh = Mesh::from_triangles(corners.to_vec(), vec![[0, 1, 2], [4, 3, 5]]);
    /// assert_eq!(mesh.weld(0.0).merged_vertices, 2);
    /// assert_eq!(mesh.faces()[1], [2, 1, 3]);
    /// ```
    ///
    /// # Cost
    /// O(n) expected; 27 look-ups a vertex if `tolerance` is greater than 0.
    ///
    /// # Panics
    /// If `tolerance` is negative or not a number.
    pub fn weld(&mut self, tolerance: f64) -> Welded {
        assert!(tolerance >= 0.0, "a distance is not negative");
        let given = std::mem::take(&mut self.positions);
        let before = given.len();
        let (positions, targets) =
            if tolerance == 0.0 { weld_exactly(given) } else { weld_nearby(given, tolerance) };
        self.positions = positions;
        let merged_vertices = before - self.positions.len();
        let dropped_faces = if merged_vertices == 0 { 0 } else { self.follow_weld(&targets) };
        let faces = ["face of less than three corners", "faces of less than three corners"];
        self.note_repairs([
            ("weld joined", merged_vertices, ["vertex with another", "vertices with others"]),
            ("weld dropped", dropped_faces, faces),
        ]);
        Welded { merged_vertices, dropped_faces }
    }

    /// Gives the faces the vertices in `targets`; returns the number of faces dropped.
    fn follow_weld(&mut self, targets: &[u32]) -> usize {
        let target = |v: u32| targets.get(v as usize).copied().unwrap_or(v);
        // A corner goes if the next corner is another vertex that becomes the same.
        let goes = |face: &[u32], corner: usize| {
            let [one, next] = [face[corner], face[(corner + 1) % face.len()]];
            one != next && target(one) == target(next)
        };
        let is_whole = |face: &[u32]| !(0..face.len()).any(|corner| goes(face, corner));
        if self.faces.iter().all(is_whole) {
            self.faces.corners.iter_mut().for_each(|v| *v = target(*v));
            return 0;
        }
        let mut derived = Derived::default();
        for (index, face) in self.faces.iter().enumerate() {
            let left: Vec<usize> = (0..face.len()).filter(|&c| !goes(face, c)).collect();
            derived.begin_face();
            if left.len() >= 3 || left.len() == face.len() {
                derived.keep(self, index, left, target);
            }
        }
        derived.replace_faces_of(self)
    }
}

/// Makes positions with equal coordinates one vertex, in order of first occurrence.
pub(super) struct ExactWelder {
    pub(super) positions: Vec<[f64; 3]>,
    /// With the random keys of the standard library, so that no file can choose collisions.
    vertices: HashMap<[u64; 3], u32>,
}

impl ExactWelder {
    /// Begins without vertices, with room for so many.
    pub(super) fn with_capacity(vertices: usize) -> Self {
        let positions = Vec::with_capacity(vertices);
        Self { positions, vertices: HashMap::with_capacity(vertices) }
    }

    /// Returns the vertex at `position`.
    pub(super) fn vertex(&mut self, position: [f64; 3]) -> u32 {
        *self.vertices.entry(key(position)).or_insert_with(|| {
            self.positions.push(position);
            (self.positions.len() - 1) as u32
        })
    }
}

/// Returns a key that is equal for equal coordinates.
///
/// Equal bits are equal numbers once -0 + 0 = 0 has removed the one exception. NaN, which is not
/// equal to itself, is one number for each of its bit patterns.
fn key(position: [f64; 3]) -> [u64; 3] {
    position.map(|coordinate| (coordinate + 0.0).to_bits())
}

/// Returns the kept positions, and for each of `given` the index of the one that it becomes.
fn weld_exactly(given: Vec<[f64; 3]>) -> (Vec<[f64; 3]>, Vec<u32>) {
    let mut welder = ExactWelder::with_capacity(given.len());
    let targets = given.into_iter().map(|position| welder.vertex(position)).collect();
    (welder.positions, targets)
}

/// Returns what [`weld_exactly`] returns, for positions at most `tolerance` apart.
fn weld_nearby(given: Vec<[f64; 3]>, tolerance: f64) -> (Vec<[f64; 3]>, Vec<u32>) {
    let mut grid = Grid::new(tolerance);
    let targets = given.into_iter().map(|position| grid.vertex(position)).collect();
    (grid.positions, targets)
}

/// No vertex.
const NONE: u32 = u32::MAX;

/// Kept vertices in cubes whose side is the tolerance. A cube holds few, as they are apart.
struct Grid {
    tolerance: f64,
    positions: Vec<[f64; 3]>,
    /// The last vertex of each cube.
    first: HashMap<[u64; 3], u32>,
    /// For each vertex the one before it in its cube.
    next: Vec<u32>,
}

impl Grid {
    fn new(tolerance: f64) -> Self {
        let (positions, next, first) = (Vec::new(), Vec::new(), HashMap::new());
        Self { tolerance, positions, first, next }
    }

    fn vertex(&mut self, position: [f64; 3]) -> u32 {
        // What is not finite is near nothing.
        let is_finite = position.iter().all(|x| x.is_finite());
        if is_finite && let Some(vertex) = self.nearest(position) {
            return vertex;
        }
        let vertex = self.positions.len() as u32;
        let before = is_finite.then(|| {
            let cube = key(position.map(|x| self.cell(x)));
            self.first.insert(cube, vertex)
        });
        self.next.push(before.flatten().unwrap_or(NONE));
        self.positions.push(position);
        vertex
    }

    /// Returns the number of the cube along one axis; `x` itself where cubes are finer than f64.
    fn cell(&self, x: f64) -> f64 {
        const WHOLE: f64 = (1_u64 << 52) as f64;
        let cell = (x / self.tolerance).floor();
        if cell.abs() < WHOLE { cell } else { x }
    }

    /// Returns the nearest kept vertex within the tolerance, the first of equally near ones.
    fn nearest(&self, position: [f64; 3]) -> Option<u32> {
        let cells = position.map(|x| self.cell(x));
        let mut best: Option<(f64, u32)> = None;
        for step in 0..27 {
            let steps = [step % 3, step / 3 % 3, step / 9].map(|k| f64::from(k) - 1.0);
            let cube = std::array::from_fn(|axis| cells[axis] + steps[axis]);
            let mut vertex = self.first.get(&key(cube)).copied().unwrap_or(NONE);
            while vertex != NONE {
                let found = (self.distance(position, self.positions[vertex as usize]), vertex);
                if found.0 <= 1.0 && best.is_none_or(|best| found < best) {
                    best = Some(found);
                }
                vertex = self.next[vertex as usize];
            }
        }
        best.map(|(_, vertex)| vertex)
    }

    /// Returns the distance in units of the tolerance, so that nothing overflows near 1.
    fn distance(&self, p: [f64; 3], q: [f64; 3]) -> f64 {
        let squares = [0, 1, 2].map(|axis| {
            let step = if p[axis] == q[axis] { 0.0 } else { (p[axis] - q[axis]) / self.tolerance };
            step * step
        });
        (squares[0] + squares[1] + squares[2]).sqrt()
    }
}
