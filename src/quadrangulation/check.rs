//! A check that a quad mesh is what it should be, from the two meshes alone.
//!
//! It uses nothing of what built the quads: neither the half-edge structure nor the matching.
//! Around every vertex, the quads and the triangles that start there are found in one array over
//! all vertices. So the check is linear and needs no hashing.

use crate::mesh::{Faces, Mesh};

/// Counts of a quad mesh that passed the check.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct CheckReport {
    /// Number of quads.
    pub quads: usize,
    /// Vertices that quads use.
    pub vertices: usize,
    /// Vertices of degree 2, where two quads share two edges: legal and common.
    pub degree_two_vertices: usize,
    /// Vertices - edges + quads, the same as that of the triangles.
    pub euler_characteristic: i64,
}

/// The first defect found of a quad mesh. Displayed numbers count from 1, stored ones from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Mismatch {
    /// The triangle mesh has a face that is not a triangle, or names a missing vertex.
    #[error("face {} of the triangle mesh is no triangle of existing vertices", .0 + 1)]
    BadTriangle(usize),
    /// The numbers of vertices differ.
    #[error("the quad mesh has {quads} vertices, the triangle mesh {triangles}")]
    VertexCount {
        /// Vertices of the quad mesh.
        quads: usize,
        /// Vertices of the triangle mesh.
        triangles: usize,
    },
    /// The triangulation has not as many vertices as the mesh whose surface it should triangulate.
    #[error("the triangulation has {paired} vertices, the triangle mesh {given}")]
    TriangulationVertexCount {
        /// Vertices of the triangulation whose triangles were paired.
        paired: usize,
        /// Vertices of the triangle mesh given.
        given: usize,
    },
    /// A vertex has moved.
    #[error("vertex {} has other coordinates than in the triangle mesh", .0 + 1)]
    Moved(usize),
    /// A face does not have four corners that exist.
    #[error("face {} is no quadrilateral of existing vertices", .0 + 1)]
    NotAQuad(usize),
    /// A quad has a corner twice.
    #[error("quad {} repeats a corner", .0 + 1)]
    RepeatedCorner(usize),
    /// Two faces of one of the meshes pass an edge in the same direction.
    #[error("edge {}-{} is passed twice in the same direction", .0 + 1, .1 + 1)]
    EdgeTwice(u32, u32),
    /// An edge is passed in one direction only.
    #[error("edge {}-{} belongs to one quad only", .0 + 1, .1 + 1)]
    EdgeOpen(u32, u32),
    /// A quad is passed in the other direction than the triangles inside it.
    #[error("quad {} has the opposite orientation of its two triangles", .0 + 1)]
    Reversed(usize),
    /// A quad is not the union of two triangles across their common edge.
    #[error("quad {} is not two triangles of the triangle mesh joined across an edge", .0 + 1)]
    NotAPair(usize),
    /// A triangle lies in two quads.
    #[error("triangle {} lies in two quads", .0 + 1)]
    TriangleTwice(usize),
    /// A triangle lies in no quad.
    #[error("triangle {} lies in no quad", .0 + 1)]
    TriangleUnused(usize),
    /// A vertex is used in one mesh only.
    #[error("vertex {} is used in one of the meshes only", .0 + 1)]
    VertexUse(usize),
    /// The quads round a vertex form more than one fan.
    #[error("the quads round vertex {} form several fans", .0 + 1)]
    Fans(usize),
    /// A component has other vertices or another number of triangles.
    #[error("the component of vertex {} has other vertices or another genus", .0 + 1)]
    Component(usize),
    /// The Euler characteristics differ.
    #[error("the Euler characteristic is {quads}, that of the triangle mesh {triangles}")]
    EulerCharacteristic {
        /// That of the quad mesh.
        quads: i64,
        /// That of the triangle mesh.
        triangles: i64,
    },
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
/// # Ok::<(), triquad::Mismatch>(())
/// ```
///
/// # Errors
/// The first defect found.
///
/// # Cost
/// O(n) time; about 40 bytes a triangle while it runs.
pub fn check(quads: &Mesh, triangles: &Mesh) -> Result<CheckReport, Mismatch> {
    let counts = [quads, triangles].map(|mesh| mesh.positions().len());
    if counts[0] != counts[1] {
        return Err(Mismatch::VertexCount { quads: counts[0], triangles: counts[1] });
    }
    check_positions(quads.positions(), triangles.positions())?;
    check_faces(quads.faces(), triangles.faces(), triangles.positions().len())
}

/// Checks that two meshes of as many vertices have them in the same places.
pub(super) fn check_positions(ours: &[[f64; 3]], given: &[[f64; 3]]) -> Result<(), Mismatch> {
    // -0 is where 0 is, which adding 0 makes of it; NaN is at the place of an equal NaN.
    let place = |position: &[f64; 3]| position.map(|coordinate| (coordinate + 0.0).to_bits());
    let moved = (0..ours.len()).find(|&v| place(&ours[v]) != place(&given[v]));
    moved.map_or(Ok(()), |v| Err(Mismatch::Moved(v)))
}

/// Checks like [`check`], for meshes over the same `vertices` positions.
///
/// # Errors
/// The first defect found.
pub(crate) fn check_faces(
    quads: &Faces,
    triangles: &Faces,
    vertices: usize,
) -> Result<CheckReport, Mismatch> {
    require_arity(quads, 4, vertices).map_err(Mismatch::NotAQuad)?;
    require_arity(triangles, 3, vertices).map_err(Mismatch::BadTriangle)?;
    let mut check = Check {
        quads: Corners::gather(quads.corners(), vertices),
        triangles: Corners::gather(triangles.corners(), vertices),
        inside: vec![NONE; quads.corners().len()],
        degree_two_vertices: 0,
        used_vertices: 0,
    };
    let covered = check.visit_stars(vertices).and_then(|()| check.cover_triangles());
    covered.map_err(|mismatch| explain(mismatch, quads, triangles))?;
    let euler = |corners: usize, faces: usize| {
        check.used_vertices as i64 - (corners / 2) as i64 + faces as i64
    };
    let of_quads = euler(quads.corners().len(), quads.len());
    let of_triangles = euler(triangles.corners().len(), triangles.len());
    if of_quads != of_triangles {
        return Err(Mismatch::EulerCharacteristic { quads: of_quads, triangles: of_triangles });
    }
    Ok(CheckReport {
        quads: quads.len(),
        vertices: check.used_vertices,
        degree_two_vertices: check.degree_two_vertices,
        euler_characteristic: of_quads,
    })
}

/// Returns what is wrong with a quad that is no pair of triangles, if it is that it is turned.
fn explain(mismatch: Mismatch, quads: &Faces, triangles: &Faces) -> Mismatch {
    let Mismatch::NotAPair(index) = mismatch else { return mismatch };
    let [a, b, c, d] = [0, 1, 2, 3].map(|corner| quads[index][corner]);
    let is_there = |mut wanted: [u32; 3]| {
        least_first(&mut wanted);
        triangles.corners().as_chunks::<3>().0.iter().any(|&(mut triangle)| {
            least_first(&mut triangle);
            triangle == wanted
        })
    };
    let turned_pairs = [[[a, d, c], [a, c, b]], [[b, a, d], [b, d, c]]];
    let is_turned = turned_pairs.into_iter().any(|pair| pair.into_iter().all(is_there));
    if is_turned { Mismatch::Reversed(index) } else { mismatch }
}

/// Rotates a triangle so that its least corner comes first.
fn least_first(triangle: &mut [u32; 3]) {
    let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
    triangle.rotate_left(least);
}

const NONE: u32 = u32::MAX;

/// Checks that all faces have `arity` corners below `vertices`; the error is the first that has
/// not.
pub(super) fn require_arity(faces: &Faces, arity: usize, vertices: usize) -> Result<(), usize> {
    let in_range = |face: &[u32]| face.iter().all(|&v| (v as usize) < vertices);
    if faces.arity() == Some(arity) && in_range(faces.corners()) {
        return Ok(());
    }
    let sound = |face: &[u32]| face.len() == arity && in_range(face);
    match faces.iter().position(|face| !sound(face)) {
        Some(face) => Err(face),
        None => Ok(()),
    }
}

/// The corners of faces of equal size, and where each vertex's corners are.
struct Corners<'m, const ARITY: u32> {
    vertex: &'m [u32],
    starts: Vec<u32>,
    at_vertex: Vec<u32>,
    /// For each vertex w the last corner seen whose side leads to w.
    leading_to: Vec<u32>,
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
        Self { vertex, starts, at_vertex, leading_to: vec![NONE; vertices] }
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

    /// Enters the sides that start at `v`; the end of one entered twice is the error.
    fn enter_star(&mut self, v: u32) -> Result<(), u32> {
        for i in self.star(v) {
            let corner = self.at_vertex[i];
            let head = self.head(corner);
            if self.side(v, head).is_some() {
                return Err(head);
            }
            self.leading_to[head as usize] = corner;
        }
        Ok(())
    }

    /// Returns the corner at `v` whose side leads to `head`; the star of `v` was the last entered.
    fn side(&self, v: u32, head: u32) -> Option<u32> {
        let corner = self.leading_to[head as usize];
        (corner != NONE && self.vertex[corner as usize] == v).then_some(corner)
    }
}

struct Check<'m> {
    quads: Corners<'m, 4>,
    triangles: Corners<'m, 3>,
    /// For each side of a quad, the triangle that lies inside it.
    inside: Vec<u32>,
    degree_two_vertices: usize,
    used_vertices: usize,
}

impl Check<'_> {
    fn visit_stars(&mut self, vertices: usize) -> Result<(), Mismatch> {
        for v in 0..vertices as u32 {
            let degree = self.quads.star(v).len();
            if (degree == 0) != self.triangles.star(v).is_empty() {
                return Err(Mismatch::VertexUse(v as usize));
            }
            self.used_vertices += usize::from(degree > 0);
            self.degree_two_vertices += usize::from(degree == 2);
            self.visit_star(v)?;
        }
        Ok(())
    }

    fn visit_star(&mut self, v: u32) -> Result<(), Mismatch> {
        self.triangles.enter_star(v).map_err(|head| Mismatch::EdgeTwice(v, head))?;
        self.quads.enter_star(v).map_err(|head| Mismatch::EdgeTwice(v, head))?;
        for i in self.quads.star(v) {
            let corner = self.quads.at_vertex[i];
            let (head, tail) = (self.quads.head(corner), self.quads.tail(corner));
            if head == v || self.quads.vertex[self.quads.turn(corner, 2) as usize] == v {
                return Err(Mismatch::RepeatedCorner(corner as usize / 4));
            }
            if self.quads.side(v, tail).is_none() {
                return Err(Mismatch::EdgeOpen(tail, v));
            }
            let triangle = self.triangles.side(v, head).map(|inner| inner / 3);
            self.inside[corner as usize] =
                triangle.ok_or(Mismatch::NotAPair(corner as usize / 4))?;
        }
        self.check_one_fan(v)
    }

    /// Turns about `v` from its first quad; checks that all its quads come before that again.
    fn check_one_fan(&self, v: u32) -> Result<(), Mismatch> {
        let star = self.quads.star(v);
        let Some(&first) = self.quads.at_vertex[star.clone()].first() else { return Ok(()) };
        let mut corner = first;
        for turned in 1..=star.len() {
            corner = self.quads.side(v, self.quads.tail(corner)).expect("seen to exist");
            if corner == first {
                let whole = turned == star.len();
                return if whole { Ok(()) } else { Err(Mismatch::Fans(v as usize)) };
            }
        }
        Err(Mismatch::Fans(v as usize))
    }

    /// Checks that each quad covers two triangles, and each triangle is covered once.
    ///
    /// A quad must have one triangle inside two sides in a row and another inside the other two.
    /// Both then lie on the diagonal between, in opposite directions.
    fn cover_triangles(&self) -> Result<(), Mismatch> {
        let mut covered = vec![false; self.triangles.vertex.len() / 3];
        for (quad, inside) in self.inside.as_chunks::<4>().0.iter().enumerate() {
            let &[a, b, c, d] = inside;
            let pair = a == b && c == d || b == c && d == a;
            if !pair || a == c {
                return Err(Mismatch::NotAPair(quad));
            }
            for triangle in [a, c] {
                if std::mem::replace(&mut covered[triangle as usize], true) {
                    return Err(Mismatch::TriangleTwice(triangle as usize));
                }
            }
        }
        let unused = covered.iter().position(|covered| !covered);
        unused.map_or(Ok(()), |triangle| Err(Mismatch::TriangleUnused(triangle)))
    }
}
