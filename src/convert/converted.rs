//! The result of a conversion.

use std::borrow::Cow;

use super::report::Report;
use crate::mesh::{Faces, Mesh};
use crate::pairing::Proof;
use crate::quadrangulation::{AttributeLosses, Quadrangulation};
use crate::triangulation::Triangulation;

/// A mesh of quads, and of triangles where some may be left, that passed its check; its report.
#[derive(Clone, Debug)]
pub struct Converted {
    pub(super) mesh: Mesh,
    /// The triangles that were paired.
    pub(super) triangles: Faces,
    pub(super) report: Report,
    pub(super) losses: AttributeLosses,
    pub(super) proof: Option<Proof>,
    /// The ends of each edge given up.
    pub(super) given_up: Vec<[u32; 2]>,
}

impl Converted {
    /// Returns the quads, and triangles left, on the vertices of the input, with the attributes
    /// carried over.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Returns the counts and times.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Returns what the quads cannot keep of the attributes of the input.
    pub fn losses(&self) -> &AttributeLosses {
        &self.losses
    }

    /// Returns the triangles that were paired: those of the input but for `lrs`, which flips edges.
    pub fn triangles(&self) -> &Faces {
        &self.triangles
    }

    /// Returns the edges that were to be kept and lie inside a quad, by their vertices.
    pub fn given_up(&self) -> &[[u32; 2]] {
        &self.given_up
    }

    /// Returns the proof that the pairing is the best, if it was to be kept, see
    /// [`Converter::keep_proof`](super::Converter::keep_proof).
    pub fn proof(&self) -> Option<&Proof> {
        self.proof.as_ref()
    }

    /// Returns the quads and drops the rest.
    pub fn into_mesh(self) -> Mesh {
        self.mesh
    }

    /// Returns the triangles that were paired as a mesh and drops the quads.
    pub fn into_triangle_mesh(self) -> Mesh {
        self.mesh.with_faces(self.triangles)
    }
}

/// A quadrangulation without coordinates, unchecked, with its report.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Quadrangulated<'t> {
    /// The quads.
    pub quadrangulation: Quadrangulation,
    /// The triangulation whose triangles were paired: the input, or another one for `lrs`.
    pub triangulation: Cow<'t, Triangulation>,
    /// Counts and times; nothing that the check finds.
    pub report: Report,
}
