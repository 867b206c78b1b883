//! Repairs tried on a copy of a mesh, and what is then left to mend.

use std::path::Path;

use triquad::{Law, Mesh, Survey};

use crate::input::{self, Repairs};

/// A copy of a mesh after the repairs that it needs.
pub struct Attempt {
    /// The repairs, those that were on included.
    pub repairs: Repairs,
    /// Vertices that welding joined with others.
    pub joined: usize,
    /// Faces that welding dropped.
    pub dropped: usize,
    /// Boundary edges after the welding alone.
    pub boundary_edges: usize,
    /// True if the welding alone closes the mesh.
    pub closes: bool,
    /// The copy after all of the repairs; none if a face cannot be cut.
    survey: Option<Survey>,
}

impl Attempt {
    /// Welds a copy of `mesh`, if at all, and then mends what options can mend. A few surveys.
    pub fn new(mesh: &Mesh, on: Repairs, distance: Option<f64>) -> Self {
        let mut mended = Mesh::new(mesh.positions().to_vec(), mesh.faces().clone());
        let mut repairs = on;
        repairs.reading.weld = distance.or(on.reading.weld);
        let welded = distance.map(|distance| mended.weld(distance)).unwrap_or_default();
        let survey = Survey::new(&mended);
        let faces = mended.faces();
        repairs.clean |= breaks(&survey, Law::DistinctCorners);
        repairs.clean |= breaks(&survey, Law::DistinctFaces);
        repairs.clean |= faces.iter().any(|face| face.len() < 3);
        repairs.triangulate |= faces.iter().any(|face| face.len() > 3);
        let (boundary_edges, closes) = (boundary_edges(&survey), survey.closed);
        let survey = match (repairs.clean, repairs.triangulate) {
            (false, false) => Some(survey),
            _ => {
                let done = input::repair(Path::new(""), &mut mended, repairs);
                done.is_ok().then(|| Survey::new(&mended))
            }
        };
        // Where edges have too many faces, only now is known which faces disagree.
        let disagree = |survey| breaks(survey, Law::ConsistentOrientation);
        repairs.orient |= survey.as_ref().is_some_and(disagree);
        let (joined, dropped) = (welded.merged_vertices, welded.dropped_faces);
        Self { repairs, joined, dropped, boundary_edges, closes, survey }
    }

    /// Returns how many elements break laws that no option mends nor allows, then how many edges
    /// are on a boundary.
    pub fn faults(&self) -> (usize, usize) {
        let Some(survey) = &self.survey else { return (usize::MAX, self.boundary_edges) };
        let is_mended =
            |law| matches!(law, Law::NoBoundary | Law::Orientable | Law::ConsistentOrientation);
        let others = survey.violations.iter().filter(|broken| !is_mended(broken.law));
        (others.map(|broken| broken.count).sum(), boundary_edges(survey))
    }

    /// Returns true if `convert` takes the copy, with `--open` perhaps.
    pub fn is_surface(&self) -> bool {
        self.faults().0 == 0
    }

    /// Returns true if `convert` takes the copy only with `--open`.
    pub fn is_open(&self) -> bool {
        self.breaks(Law::NoBoundary) || self.breaks(Law::Orientable)
    }

    /// Returns true if no edge has two faces, so that there is nothing to pair.
    pub fn is_apart(&self) -> bool {
        self.survey.as_ref().is_some_and(|survey| survey.edges == boundary_edges(survey))
    }

    /// Returns true if the copy breaks the law.
    pub fn breaks(&self, law: Law) -> bool {
        self.survey.as_ref().is_none_or(|survey| breaks(survey, law))
    }
}

fn breaks(survey: &Survey, law: Law) -> bool {
    survey.violations.iter().any(|violation| violation.law == law)
}

fn boundary_edges(survey: &Survey) -> usize {
    let boundary = survey.violations.iter().find(|violation| violation.law == Law::NoBoundary);
    boundary.map_or(0, |violation| violation.count)
}
