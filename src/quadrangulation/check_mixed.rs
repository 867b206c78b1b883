//! A check that a mesh of quads and triangles is what it should be, from the two meshes alone.
//!
//! Triangles are found by their three vertices, in a sorted list. So the surfaces may have a
//! boundary and may be one-sided.

use super::check::{CheckReport, absent_vertex, check_positions, require_triangles};
use super::check_error::{CheckError, FaceFault};
use crate::dual::Matching;
use crate::mesh::{Faces, Mesh};
use crate::triangulation::TriangleId;

/// Counts of a mesh that passed the check, and which triangles its quads consist of.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct MixedCheck {
    /// The counts.
    pub report: CheckReport,
    /// The two triangles of each quad as a pair.
    pub matching: Matching,
}

/// Checks that the quads and triangles of `mixed` cover each triangle of `triangles` once.
///
/// Both must have the same vertices. Every quad must be the union of two triangles across their
/// common edge, oriented like one of them. Every face of three corners must be one of the
/// triangles. The triangles must be those of a surface, see
/// [`OpenTriangulation::build`](crate::triangulation::OpenTriangulation::build).
///
/// ```
/// use triquad::quadrangulation::check_mixed;
/// use triquad::{Mesh, mesh::Faces};
///
/// let plane = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 1.0]];
/// let positions = plane.map(|[x, y]| [x, y, 0.0]).to_vec();
/// let strip = Mesh::from_triangles(positions, vec![[0, 1, 2], [2, 3, 0], [1, 4, 2]]);
/// let mixed = strip.clone().with_faces(Faces::from_iter([&[0, 1, 2, 3][..], &[1, 4, 2]]));
/// let report = check_mixed(&mixed, &strip)?.report;
/// assert_eq!((report.quads, report.triangles, report.euler_characteristic), (1, 1, 1));
/// # Ok::<(), triquad::CheckError>(())
/// ```
///
/// # Errors
/// The first defect found.
///
/// # Cost
/// O(n log n) time; about 70 bytes a triangle while it runs.
pub fn check_mixed(mixed: &Mesh, triangles: &Mesh) -> Result<MixedCheck, CheckError> {
    let counts = [mixed, triangles].map(|mesh| mesh.positions().len());
    if counts[0] != counts[1] {
        return Err(CheckError::VertexCount { quads: counts[0], triangles: counts[1] });
    }
    check_positions(mixed.positions(), triangles.positions())?;
    check_mixed_faces(mixed.faces(), triangles.faces(), counts[0])
}

/// Checks like [`check_mixed`], for meshes over the same `vertices` positions.
///
/// # Errors
/// The first defect found.
pub(crate) fn check_mixed_faces(
    mixed: &Faces,
    triangles: &Faces,
    vertices: usize,
) -> Result<MixedCheck, CheckError> {
    require_triangles(triangles, vertices)?;
    for (face, corners) in mixed.iter().enumerate() {
        require_distinct(face, corners, vertices)?;
    }
    let mut cover = Cover::new(triangles);
    let mut quads = 0;
    for (face, corners) in mixed.iter().enumerate() {
        match *corners {
            [a, b, c] => cover.triangle(face, [a, b, c])?,
            [a, b, c, d] => cover.quad(face, [a, b, c, d])?,
            _ => {
                let fault = FaceFault::Corners(corners.len());
                return Err(CheckError::NotATriangleOrQuad(face, fault));
            }
        }
        quads += usize::from(corners.len() == 4);
    }
    if let Some(unused) = cover.is_covered.iter().position(|covered| !covered) {
        return Err(CheckError::TriangleUnused(unused));
    }
    let Degrees { edges, used, two } = Degrees::new(mixed, triangles, vertices);
    let report = CheckReport {
        quads,
        triangles: mixed.len() - quads,
        vertices: used,
        degree_two_vertices: two,
        euler_characteristic: used as i64 - edges as i64 + triangles.len() as i64,
    };
    Ok(MixedCheck { report, matching: cover.matching })
}

/// Checks that corners exist and none is repeated.
fn require_distinct(face: usize, corners: &[u32], vertices: usize) -> Result<(), CheckError> {
    if let Some(fault) = absent_vertex(corners, vertices) {
        return Err(CheckError::NotATriangleOrQuad(face, fault));
    }
    let is_repeated = |k: usize| corners[..k].contains(&corners[k]);
    if corners.len() <= 4 && (1..corners.len()).any(is_repeated) {
        return Err(CheckError::RepeatedCorner(face));
    }
    Ok(())
}

/// The triangles of a mesh, which of them are covered, and in what pairs.
struct Cover<'m> {
    corners: &'m [[u32; 3]],
    /// The corners of each triangle in order of their numbers, and the triangle; sorted.
    by_corners: Vec<([u32; 3], u32)>,
    is_covered: Vec<bool>,
    matching: Matching,
}

impl<'m> Cover<'m> {
    fn new(triangles: &'m Faces) -> Self {
        let corners = triangles.corners().as_chunks::<3>().0;
        let mut by_corners: Vec<_> =
            corners.iter().map(|&corners| sorted(corners)).zip(0..).collect();
        by_corners.sort_unstable();
        let count = corners.len();
        Self {
            corners,
            by_corners,
            is_covered: vec![false; count],
            matching: Matching::empty(count),
        }
    }

    /// Returns the triangle with these corners in any order.
    fn find(&self, corners: [u32; 3]) -> Option<usize> {
        let key = sorted(corners);
        let found = self.by_corners.binary_search_by_key(&key, |entry| entry.0).ok()?;
        Some(self.by_corners[found].1 as usize)
    }

    /// Returns whether a triangle passes its three corners in this direction.
    fn runs(&self, triangle: usize, [a, b, _]: [u32; 3]) -> bool {
        let [p, q, r] = self.corners[triangle];
        [(p, q), (q, r), (r, p)].contains(&(a, b))
    }

    /// Covers the triangle that a face of three corners is.
    fn triangle(&mut self, face: usize, corners: [u32; 3]) -> Result<(), CheckError> {
        let triangle = self.find(corners).ok_or(CheckError::NotATriangle(face))?;
        if !self.runs(triangle, corners) {
            return Err(CheckError::Turned(face));
        }
        self.cover(triangle)
    }

    /// Covers the two triangles that a quad consists of.
    ///
    /// Only four vertices whose four triangles all exist, a whole tetrahedron, can be cut in both
    /// ways; then the direction decides.
    fn quad(&mut self, face: usize, [a, b, c, d]: [u32; 4]) -> Result<(), CheckError> {
        let cuts = [[[a, b, c], [c, d, a]], [[b, c, d], [d, a, b]]];
        let mut exists = false;
        for halves in cuts {
            let [Some(one), Some(other)] = halves.map(|half| self.find(half)) else { continue };
            exists = true;
            if self.runs(one, halves[0]) || self.runs(other, halves[1]) {
                [one, other].into_iter().try_for_each(|triangle| self.cover(triangle))?;
                self.matching.pair(TriangleId::new(one), TriangleId::new(other));
                return Ok(());
            }
        }
        Err(if exists { CheckError::Turned(face) } else { CheckError::NotAPair(face) })
    }

    fn cover(&mut self, triangle: usize) -> Result<(), CheckError> {
        match std::mem::replace(&mut self.is_covered[triangle], true) {
            true => Err(CheckError::TriangleTwice(triangle)),
            false => Ok(()),
        }
    }
}

fn sorted(mut corners: [u32; 3]) -> [u32; 3] {
    corners.sort_unstable();
    corners
}

/// Counts of edges round vertices.
struct Degrees {
    /// Edges of the triangles.
    edges: usize,
    /// Vertices of the triangles.
    used: usize,
    /// Vertices inside the surface at which two edges are left.
    two: usize,
}

impl Degrees {
    fn new(mixed: &Faces, triangles: &Faces, vertices: usize) -> Self {
        let mut edges_of_triangles = edges(triangles);
        edges_of_triangles.dedup();
        let count = edges_of_triangles.len();
        let mut used = vec![false; vertices];
        triangles.corners().iter().for_each(|&v| used[v as usize] = true);
        // Every edge left has one or two sides; at a vertex inside the surface each has two.
        let mut degree = vec![0_u32; vertices];
        let mut on_boundary = vec![false; vertices];
        for edge in edges(mixed).chunk_by(|one, other| one == other) {
            for v in edge[0].map(|v| v as usize) {
                degree[v] += 1;
                on_boundary[v] |= edge.len() == 1;
            }
        }
        // Two faces that share two edges share the vertex between them and nothing else there.
        let two = (0..vertices).filter(|&v| degree[v] == 2 && !on_boundary[v]).count();
        Self { edges: count, used: used.iter().filter(|used| **used).count(), two }
    }
}

/// Returns the sides of all faces as pairs of vertices, sorted.
fn edges(faces: &Faces) -> Vec<[u32; 2]> {
    let mut edges = Vec::with_capacity(faces.corners().len());
    for face in faces {
        let next = face.iter().cycle().skip(1);
        edges.extend(face.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]));
    }
    edges.sort_unstable();
    edges
}
