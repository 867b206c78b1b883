//! A check that a quad mesh is what it should be, from the two meshes alone.
//!
//! It uses nothing of what built the quads: neither the half-edge structure nor the matching.
//! Around every vertex, the quads and the triangles that start there are found in one array over
//! all vertices. So the check is linear and needs no hashing.

use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

use super::check_error::{CheckError, FaceFault};
use crate::mesh::{Faces, Mesh};
use crate::parallel::{collect, join, map, ranges};

/// Counts of a quad mesh that passed the check.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct CheckReport {
    /// Number of quads.
    pub quads: usize,
    /// Number of triangles left over, each one of the triangle mesh.
    pub triangles: usize,
    /// Vertices that faces use.
    pub vertices: usize,
    /// Vertices of degree 2 inside the surface, where two faces share two edges: legal and common.
    pub degree_two_vertices: usize,
    /// Vertices - edges + faces, the same as that of the triangles.
    pub euler_characteristic: i64,
}

/// Checks that `quads` is a quadrangulation of the surface that `triangles` triangulates.
///
/// Both must have the same vertices, and every quad must be the union of two triangles.
///
/// ```
/// use triquad::{Mesh, check, mesh::Faces};
///
/// let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let mesh = Mesh::from_triangles(positions, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
/// let quads = mesh.clone().with_faces(Faces::uniform(4, vec![0, 2, 1, 3, 1, 2, 0, 3]));
/// assert_eq!(check(&quads, &mesh)?.degree_two_vertices, 4);
///
/// let twice = mesh.clone().with_faces(Faces::uniform(4, vec![0, 2, 1, 3, 0, 2, 1, 3]));
/// let mismatch = check(&twice, &mesh).unwrap_err();
/// assert_eq!(mismatch.to_string(), "edge 1-3 is passed twice in the same direction");
/// # Ok::<(), triquad::CheckError>(())
/// ```
///
/// # Errors
/// The first defect found.
///
/// # Cost
/// O(n) time; about 40 bytes a triangle while it runs.
pub fn check(quads: &Mesh, triangles: &Mesh) -> Result<CheckReport, CheckError> {
    let counts = [quads, triangles].map(|mesh| mesh.positions().len());
    if counts[0] != counts[1] {
        return Err(CheckError::VertexCount { quads: counts[0], triangles: counts[1] });
    }
    check_positions(quads.positions(), triangles.positions())?;
    check_faces(quads.faces(), triangles.faces(), triangles.positions().len())
}

/// Checks that two meshes of as many vertices have them in the same places.
pub(super) fn check_positions(ours: &[[f64; 3]], given: &[[f64; 3]]) -> Result<(), CheckError> {
    // -0 is where 0 is, which adding 0 makes of it; NaN is at the place of an equal NaN.
    let bits = |position: &[f64; 3]| position.map(|coordinate| (coordinate + 0.0).to_bits());
    let moved = (0..ours.len()).find(|&v| bits(&ours[v]) != bits(&given[v]));
    moved.map_or(Ok(()), |v| Err(CheckError::Moved(v)))
}

/// Checks like [`check`], for meshes over the same `vertices` positions.
///
/// # Errors
/// The first defect found.
pub(crate) fn check_faces(
    quads: &Faces,
    triangles: &Faces,
    vertices: usize,
) -> Result<CheckReport, CheckError> {
    compare_faces(quads, triangles, vertices)
        .map_err(|mismatch| explain(mismatch, quads, triangles))
}

/// Returns what is wrong with a quad that is no pair of triangles, if it is that it is turned.
fn explain(mismatch: CheckError, quads: &Faces, triangles: &Faces) -> CheckError {
    let CheckError::NotAPair(index) = mismatch else { return mismatch };
    let [a, b, c, d] = [0, 1, 2, 3].map(|corner| quads[index][corner]);
    let is_there = |mut wanted: [u32; 3]| {
        put_least_first(&mut wanted);
        triangles.corners().as_chunks::<3>().0.iter().any(|&(mut triangle)| {
            put_least_first(&mut triangle);
            triangle == wanted
        })
    };
    let turned_pairs = [[[a, d, c], [a, c, b]], [[b, a, d], [b, d, c]]];
    let is_turned = turned_pairs.into_iter().any(|pair| pair.into_iter().all(is_there));
    if is_turned { CheckError::Reversed(index) } else { mismatch }
}

/// Rotates a triangle so that its least corner comes first.
fn put_least_first(triangle: &mut [u32; 3]) {
    let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
    triangle.rotate_left(least);
}

fn compare_faces(
    quads: &Faces,
    triangles: &Faces,
    vertices: usize,
) -> Result<CheckReport, CheckError> {
    require_arity(quads, 4, vertices).map_err(|(face, fault)| CheckError::NotAQuad(face, fault))?;
    require_triangles(triangles, vertices)?;
    let (of_quads, of_triangles) = join(
        || Corners::gather(quads.corners(), vertices),
        || Corners::gather(triangles.corners(), vertices),
    );
    let inside = collect(quads.corners().len(), |_| AtomicU32::new(NONE));
    let visit = |range| Visit::new(&of_quads, &of_triangles, &inside).visit_stars(range);
    let mut found = Found::default();
    for part in map(ranges(vertices), visit) {
        found.add(part?);
    }
    cover_triangles(inside, triangles.len())?;
    let euler = |corners: usize, faces: usize| {
        found.used_vertices as i64 - (corners / 2) as i64 + faces as i64
    };
    let of_quads = euler(quads.corners().len(), quads.len());
    let of_triangles = euler(triangles.corners().len(), triangles.len());
    if of_quads != of_triangles {
        return Err(CheckError::EulerCharacteristic { quads: of_quads, triangles: of_triangles });
    }
    Ok(CheckReport {
        quads: quads.len(),
        triangles: 0,
        vertices: found.used_vertices,
        degree_two_vertices: found.degree_two_vertices,
        euler_characteristic: of_quads,
    })
}

const NONE: u32 = u32::MAX;

/// Checks that all faces are triangles of existing vertices.
pub(super) fn require_triangles(triangles: &Faces, vertices: usize) -> Result<(), CheckError> {
    require_arity(triangles, 3, vertices)
        .map_err(|(face, fault)| CheckError::BadTriangle(face, fault))
}

/// Checks that all faces have `arity` corners below `vertices`; the error is the first that has
/// not.
fn require_arity(faces: &Faces, arity: usize, vertices: usize) -> Result<(), (usize, FaceFault)> {
    let in_range = |face: &[u32]| face.iter().all(|&v| (v as usize) < vertices);
    if faces.arity() == Some(arity) && in_range(faces.corners()) {
        return Ok(());
    }
    let fault = |face: &[u32]| {
        let other = (face.len() != arity).then_some(FaceFault::Corners(face.len()));
        other.or_else(|| absent_vertex(face, vertices))
    };
    let first = faces.iter().enumerate().find_map(|(index, face)| Some((index, fault(face)?)));
    first.map_or(Ok(()), Err)
}

/// Returns the first corner of a face that is none of so many vertices.
pub(super) fn absent_vertex(face: &[u32], vertices: usize) -> Option<FaceFault> {
    let absent = face.iter().find(|&&v| v as usize >= vertices);
    absent.map(|&vertex| FaceFault::AbsentVertex { vertex, all: vertices })
}

/// The corners of faces of equal size, and where each vertex's corners are.
struct Corners<'m, const ARITY: u32> {
    vertex: &'m [u32],
    starts: Vec<u32>,
    at_vertex: Vec<u32>,
}

impl<'m, const ARITY: u32> Corners<'m, ARITY> {
    fn gather(vertex: &'m [u32], vertices: usize) -> Self {
        let mut starts = vec![0u32; vertices + 2];
        vertex.iter().for_each(|&v| starts[v as usize + 2] += 1);
        (2..starts.len()).for_each(|v| starts[v] += starts[v - 1]);
        let mut at_vertex = vec![0; vertex.len()];
        for (corner, &v) in vertex.iter().enumerate() {
            at_vertex[starts[v as usize + 1] as usize] = corner as u32;
            starts[v as usize + 1] += 1;
        }
        Self { vertex, starts, at_vertex }
    }

    fn star(&self, v: u32) -> std::ops::Range<usize> {
        self.starts[v as usize] as usize..self.starts[v as usize + 1] as usize
    }

    /// Returns the corner `steps` further round the same face.
    fn turn(&self, corner: u32, steps: u32) -> u32 {
        let first = corner - corner % ARITY;
        first + (corner - first + steps) % ARITY
    }

    /// Returns the vertex that the side starting at `corner` leads to.
    fn head(&self, corner: u32) -> u32 {
        self.vertex[self.turn(corner, 1) as usize]
    }

    /// Returns the vertex from which the side before `corner` comes.
    fn tail(&self, corner: u32) -> u32 {
        self.vertex[self.turn(corner, ARITY - 1) as usize]
    }
}

/// The sides that start at one vertex after the other, by where they lead.
struct Star<'c, 'm, const ARITY: u32> {
    corners: &'c Corners<'m, ARITY>,
    /// For each vertex w the last corner seen whose side leads to w.
    leading_to: Vec<u32>,
}

impl<'c, 'm, const ARITY: u32> Star<'c, 'm, ARITY> {
    fn new(corners: &'c Corners<'m, ARITY>) -> Self {
        Self { corners, leading_to: vec![NONE; corners.starts.len() - 2] }
    }

    /// Enters the sides that start at `v`; the end of one entered twice is the error.
    fn enter(&mut self, v: u32) -> Result<(), u32> {
        for i in self.corners.star(v) {
            let corner = self.corners.at_vertex[i];
            let head = self.corners.head(corner);
            if self.side(v, head).is_some() {
                return Err(head);
            }
            self.leading_to[head as usize] = corner;
        }
        Ok(())
    }

    /// Returns the corner at `v` whose side leads to `head`; `v` was the last vertex entered.
    fn side(&self, v: u32, head: u32) -> Option<u32> {
        let corner = self.leading_to[head as usize];
        (corner != NONE && self.corners.vertex[corner as usize] == v).then_some(corner)
    }
}

/// Counts at the vertices of a range.
#[derive(Default)]
struct Found {
    degree_two_vertices: usize,
    used_vertices: usize,
}

impl Found {
    fn add(&mut self, other: Self) {
        self.degree_two_vertices += other.degree_two_vertices;
        self.used_vertices += other.used_vertices;
    }
}

/// The visit of some vertices, one thread's.
struct Visit<'c, 'm> {
    quads: Star<'c, 'm, 4>,
    triangles: Star<'c, 'm, 3>,
    /// For each side of a quad, the triangle that lies inside it. The thread that visits the side's
    /// vertex sets it.
    inside: &'c [AtomicU32],
}

impl<'c, 'm> Visit<'c, 'm> {
    fn new(
        quads: &'c Corners<'m, 4>,
        triangles: &'c Corners<'m, 3>,
        inside: &'c [AtomicU32],
    ) -> Self {
        Self { quads: Star::new(quads), triangles: Star::new(triangles), inside }
    }

    fn visit_stars(mut self, vertices: Range<usize>) -> Result<Found, CheckError> {
        let mut found = Found::default();
        for v in vertices {
            let degree = self.quads.corners.star(v as u32).len();
            if (degree == 0) != self.triangles.corners.star(v as u32).is_empty() {
                return Err(CheckError::VertexUse(v));
            }
            found.used_vertices += usize::from(degree > 0);
            found.degree_two_vertices += usize::from(degree == 2);
            self.visit_star(v as u32)?;
        }
        Ok(found)
    }

    fn visit_star(&mut self, v: u32) -> Result<(), CheckError> {
        self.triangles.enter(v).map_err(|head| CheckError::EdgeTwice(v, head))?;
        self.quads.enter(v).map_err(|head| CheckError::EdgeTwice(v, head))?;
        let quads = self.quads.corners;
        for i in quads.star(v) {
            let corner = quads.at_vertex[i];
            let (head, tail) = (quads.head(corner), quads.tail(corner));
            if head == v || quads.vertex[quads.turn(corner, 2) as usize] == v {
                return Err(CheckError::RepeatedCorner(corner as usize / 4));
            }
            if self.quads.side(v, tail).is_none() {
                return Err(CheckError::EdgeOpen(tail, v));
            }
            let triangle = self.triangles.side(v, head).map(|inner| inner / 3);
            let triangle = triangle.ok_or(CheckError::NotAPair(corner as usize / 4))?;
            self.inside[corner as usize].store(triangle, Ordering::Relaxed);
        }
        self.check_one_fan(v)
    }

    /// Turns about `v` from its first quad; checks that all its quads come before that again.
    fn check_one_fan(&self, v: u32) -> Result<(), CheckError> {
        let quads = self.quads.corners;
        let star = quads.star(v);
        let Some(&first) = quads.at_vertex[star.clone()].first() else { return Ok(()) };
        let mut corner = first;
        for turned in 1..=star.len() {
            corner = self.quads.side(v, quads.tail(corner)).expect("seen to exist");
            if corner == first {
                let whole = turned == star.len();
                return if whole { Ok(()) } else { Err(CheckError::Fans(v as usize)) };
            }
        }
        Err(CheckError::Fans(v as usize))
    }
}

/// Checks that each quad covers two triangles, and each triangle is covered once.
///
/// A quad must have one triangle inside two sides in a row and another inside the other two.
/// Both then lie on the diagonal between, in opposite directions.
fn cover_triangles(inside: Vec<AtomicU32>, triangles: usize) -> Result<(), CheckError> {
    let inside: Vec<u32> = inside.into_iter().map(AtomicU32::into_inner).collect();
    let mut covered = vec![false; triangles];
    for (quad, inside) in inside.as_chunks::<4>().0.iter().enumerate() {
        let &[a, b, c, d] = inside;
        let pair = a == b && c == d || b == c && d == a;
        if !pair || a == c {
            return Err(CheckError::NotAPair(quad));
        }
        for triangle in [a, c] {
            if std::mem::replace(&mut covered[triangle as usize], true) {
                return Err(CheckError::TriangleTwice(triangle as usize));
            }
        }
    }
    let unused = covered.iter().position(|covered| !covered);
    unused.map_or(Ok(()), |triangle| Err(CheckError::TriangleUnused(triangle)))
}
