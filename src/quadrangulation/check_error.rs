//! What may be wrong with a quad mesh.

use crate::counted::counted;

/// What is wrong with a face by itself. Displayed numbers count from 1, stored ones from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum FaceFault {
    /// It has another number of corners than it should have.
    #[error("{}", kind_of_face(*.0))]
    Corners(usize),
    /// It names a vertex that does not exist.
    #[error("names a vertex that does not exist (vertex {} of {all})", u64::from(*.vertex) + 1)]
    AbsentVertex {
        /// The vertex.
        vertex: u32,
        /// Number of vertices.
        all: usize,
    },
}

fn kind_of_face(corners: usize) -> String {
    match corners {
        3 => "is a triangle".into(),
        4 => "is a quadrilateral".into(),
        other => format!("has {}", counted(other, "corner", "corners")),
    }
}

/// The first defect found of a quad mesh. Displayed numbers count from 1, stored ones from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum CheckError {
    /// The triangle mesh has a face that is not a triangle, or names a missing vertex.
    #[error("face {} of the triangle mesh {}", .0 + 1, .1)]
    BadTriangle(usize, FaceFault),
    /// The numbers of vertices differ.
    #[error("the quad mesh has {}, the triangle mesh {triangles}", vertices(*.quads))]
    VertexCount {
        /// Vertices of the quad mesh.
        quads: usize,
        /// Vertices of the triangle mesh.
        triangles: usize,
    },
    /// The triangulation has not as many vertices as the mesh whose surface it should triangulate.
    #[error("the triangulation has {}, the triangle mesh {given}", vertices(*.paired))]
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
    #[error("face {} {}", .0 + 1, .1)]
    NotAQuad(usize, FaceFault),
    /// A face has neither three nor four corners that exist.
    #[error("face {} {}", .0 + 1, .1)]
    NotATriangleOrQuad(usize, FaceFault),
    /// A face of three corners is no triangle of the triangle mesh.
    #[error("face {} is no triangle of the triangle mesh", .0 + 1)]
    NotATriangle(usize),
    /// A face is turned against the triangles that it consists of.
    #[error("face {} is turned against the triangles that it covers", .0 + 1)]
    Turned(usize),
    /// A face has a corner twice.
    #[error("face {} repeats a corner", .0 + 1)]
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
    /// A triangle lies in two faces.
    #[error("triangle {} lies in two faces", .0 + 1)]
    TriangleTwice(usize),
    /// A triangle lies in no face.
    #[error("triangle {} lies in no face", .0 + 1)]
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

fn vertices(count: usize) -> String {
    counted(count, "vertex", "vertices")
}
