//! All laws that a mesh breaks, and its counts, whatever state the mesh is in.
//!
//! Works on polygons of any size and assumes nothing: edges are found by sorting, orientation and
//! fans by disjoint sets. O(n log n); not used for valid meshes.

use super::face_sides::SidesByEdge;
use super::genera::Genera;
use super::laws::{Element, Law, Violation, is_too_large};
use super::orientation::Orientation;
use super::violations::Violations;
use crate::disjoint_sets::DisjointSets;
use crate::mesh::Mesh;

/// Counts and broken laws of an arbitrary, possibly invalid mesh.
///
/// As the error of [`Triangulation::build`](super::Triangulation::build) it has at least one
/// violation and displays the first one.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Survey {
    /// Vertices that some face uses.
    pub vertices: usize,
    /// Vertices that no face uses.
    pub unreferenced_vertices: usize,
    /// SidesByEdge of all faces with distinct, existing corners.
    pub edges: usize,
    /// Faces of any number of corners.
    pub faces: usize,
    /// Faces with three corners.
    pub triangles: usize,
    /// Vertices - edges + faces.
    pub euler_characteristic: i64,
    /// Connected components (through shared vertices).
    pub components: usize,
    /// Connected components of the set of boundary edges.
    pub boundary_loops: usize,
    /// True if the faces can be oriented alike.
    pub orientable: bool,
    /// Handles of the two-sided components, if the mesh is one of surfaces, closed or not.
    pub handles: Option<usize>,
    /// Cross-caps of the one-sided components, if the mesh is one of surfaces, closed or not.
    pub cross_caps: Option<usize>,
    /// True if every edge belongs to exactly two faces.
    pub closed: bool,
    /// Every broken law once, the most basic one first.
    pub violations: Vec<Violation>,
    /// Faces (from 0) to flip so that neighbours agree, the fewest in each component.
    pub faces_to_flip: Vec<usize>,
}

impl std::error::Error for Survey {}

impl std::fmt::Display for Survey {
    /// Writes the first broken law.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.violations.first() {
            Some(violation) => violation.fmt(f),
            None => write!(f, "no law is broken"),
        }
    }
}

impl Survey {
    /// Examines every face, edge and vertex of `list`. O(n log n) time, about 100 bytes a triangle.
    pub fn new(list: &Mesh) -> Self {
        let mut violations = Violations::default();
        if is_too_large(list.positions().len(), list.faces().corners().len()) {
            // 32-bit counters are too small for such a mesh, so the counts are those of an empty
            // one.
            let mut survey = Self::new(&Mesh::default());
            survey.violations = vec![Violation {
                law: Law::NotTooLarge,
                element: Element::Mesh,
                count: 1,
                faces: Vec::new(),
                absent_vertex: None,
            }];
            return survey;
        }
        let sound = sound_faces(list, &mut violations);
        find_duplicates(list, &sound, &mut violations);
        let edges = SidesByEdge::gather(list, &sound);
        edges.check_degrees(list, &mut violations);
        let sides = Orientation::new(list, &edges, &mut violations);
        check_fans(list, &edges, &mut violations);

        let connected = Connected::new(list, &sound, &edges);
        let genera = violations
            .is_surface()
            .then(|| Genera::new(list.faces(), &edges, &sides.one_sided, list.positions().len()));
        let degenerate = sound.iter().filter(|sound| !**sound).count();
        let counted_faces = list.faces().len() - degenerate;
        let edge_count = edges.groups().count();
        Self {
            vertices: connected.vertices,
            unreferenced_vertices: list.positions().len() - connected.vertices,
            edges: edge_count,
            faces: list.faces().len(),
            triangles: list.faces().iter().filter(|face| face.len() == 3).count(),
            euler_characteristic: connected.vertices as i64 - edge_count as i64
                + counted_faces as i64,
            components: connected.components,
            boundary_loops: connected.boundary_loops,
            orientable: violations.none(Law::Orientable),
            handles: genera.map(|genera| genera.handles),
            cross_caps: genera.map(|genera| genera.cross_caps),
            closed: edge_count > 0 && edges.groups().all(|group| group.len() == 2),
            violations: with_absent_vertex(violations.into_sorted(), list),
            faces_to_flip: sides.faces_to_flip,
        }
    }

    /// Genus summed over the components, if the mesh is one of closed, two-sided surfaces.
    pub fn genus(&self) -> Option<usize> {
        self.handles.filter(|_| self.closed && self.orientable)
    }

    /// Genus with holes filled, summed over the two-sided components, if the mesh is one of
    /// surfaces. None if some are one-sided and no other has handles.
    pub fn filled_genus(&self) -> Option<usize> {
        self.handles.filter(|&handles| self.orientable || handles > 0)
    }

    /// Non-orientable genus: the number of cross-caps, if the mesh is one of surfaces of which some
    /// are one-sided. 1 for the projective plane, 2 for the Klein bottle.
    pub fn non_orientable_genus(&self) -> Option<usize> {
        self.cross_caps.filter(|_| !self.orientable)
    }

    /// Returns whether the only broken laws are those that an
    /// [`OpenTriangulation`](super::OpenTriangulation) may break; with `oriented`, after
    /// [`Survey::orient`].
    pub fn is_open_surface(&self, oriented: bool) -> bool {
        let may_break = |law| match law {
            Law::NoBoundary | Law::Orientable => true,
            Law::ConsistentOrientation => oriented,
            _ => false,
        };
        self.violations.iter().all(|violation| may_break(violation.law))
    }

    /// Flips the faces of `list`, the mesh surveyed, that disagree with most of their component.
    ///
    /// Faces keep their first corner. O(n).
    pub fn orient(&self, list: &mut Mesh) {
        for &face in &self.faces_to_flip {
            list.reverse_face(face);
        }
        list.note_repairs([("orient turned", self.faces_to_flip.len(), ["face", "faces"])]);
    }

    /// Returns whether flipping faces would mend everything that is wrong.
    pub fn only_orientation_is_wrong(&self) -> bool {
        self.violations.iter().all(|violation| violation.law == Law::ConsistentOrientation)
    }
}

/// Checks vertices and faces one by one. Returns for each face whether it has at least three
/// distinct, existing corners; only such faces are studied further.
fn sound_faces(list: &Mesh, violations: &mut Violations) -> Vec<bool> {
    if list.faces().is_empty() {
        violations.add(Law::NotEmpty, Element::Mesh);
    }
    for (v, position) in list.positions().iter().enumerate() {
        if !position.iter().all(|coordinate| coordinate.is_finite()) {
            violations.add(Law::FiniteCoordinate, Element::Vertex(v as u32));
        }
    }
    let check_face = |(face, corners): (usize, &[u32])| {
        let in_range = corners.iter().all(|&v| (v as usize) < list.positions().len());
        let distinct = all_distinct(corners);
        let laws = [
            (in_range, Law::IndexInRange),
            (corners.len() == 3, Law::Triangle),
            (distinct, Law::DistinctCorners),
        ];
        for (_, law) in laws.iter().filter(|(holds, _)| !holds) {
            violations.add(*law, Element::Face(list.face_in_file(face)));
        }
        in_range && distinct && corners.len() >= 3
    };
    list.faces().iter().enumerate().map(check_face).collect()
}

/// Adds the vertex that the first face out of range names.
fn with_absent_vertex(mut violations: Vec<Violation>, list: &Mesh) -> Vec<Violation> {
    let all = list.positions().len();
    if let Some(broken) = violations.iter_mut().find(|broken| broken.law == Law::IndexInRange) {
        let absent = list.faces().corners().iter().find(|&&v| v as usize >= all);
        broken.absent_vertex = absent.map(|&v| (v, all));
    }
    violations
}

fn all_distinct(corners: &[u32]) -> bool {
    match corners {
        [a, b, c] => a != b && b != c && c != a,
        _ => {
            let mut sorted = corners.to_vec();
            sorted.sort_unstable();
            sorted.windows(2).all(|pair| pair[0] != pair[1])
        }
    }
}

fn find_duplicates(list: &Mesh, sound: &[bool], violations: &mut Violations) {
    let sorted_corners = |face: usize| {
        let mut corners = list.faces()[face].to_vec();
        corners.sort_unstable();
        corners
    };
    // A sum does not depend on the order of the corners; equal sums are compared corner by corner.
    let scramble =
        |&v: &u32| (u64::from(v) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29);
    let key = |face: usize| list.faces()[face].iter().map(scramble).fold(0, u64::wrapping_add);
    let mut keyed: Vec<(u64, usize)> =
        (0..sound.len()).filter(|&face| sound[face]).map(|face| (key(face), face)).collect();
    keyed.sort_unstable();
    let mut repeated = Vec::new();
    for group in keyed.chunk_by(|a, b| a.0 == b.0).filter(|group| group.len() > 1) {
        let mut members: Vec<(Vec<u32>, usize)> =
            group.iter().map(|&(_, face)| (sorted_corners(face), face)).collect();
        members.sort_unstable();
        for equal in members.chunk_by(|a, b| a.0 == b.0) {
            repeated.extend(equal[1..].iter().map(|&(_, face)| (face, equal[0].1)));
        }
    }
    repeated.sort_unstable();
    for (face, earlier) in repeated {
        let element = Element::Face(list.face_in_file(face));
        violations.add_at(Law::DistinctFaces, element, || vec![list.face_in_file(earlier)]);
    }
}

/// Reports vertices whose faces, joined across edges of two faces, form more than one fan.
fn check_fans(list: &Mesh, edges: &SidesByEdge, violations: &mut Violations) {
    let corners = list.faces().corners();
    let vertex = |corner: u32| corners[corner as usize];
    let mut fans = DisjointSets::new(corners.len());
    for (one, other) in edges.pairs() {
        let (first, second) = if vertex(one.from) == vertex(other.from) {
            (other.from, other.to)
        } else {
            (other.to, other.from)
        };
        fans.join(one.from, first);
        fans.join(one.to, second);
    }
    let mut fan_count = vec![0u32; list.positions().len()];
    for side in edges.all() {
        if fans.find(side.from) == side.from {
            fan_count[vertex(side.from) as usize] += 1;
        }
    }
    for (v, _) in fan_count.iter().enumerate().filter(|(_, count)| **count > 1) {
        let v = v as u32;
        violations.add_at(Law::OneFan, Element::Vertex(v), || {
            let at_vertex = edges.all().iter().filter(|side| vertex(side.from) == v);
            let mut by_fan: Vec<(u32, usize)> = at_vertex
                .map(|side| (fans.find(side.from), list.face_in_file(side.face as usize)))
                .collect();
            by_fan.sort_unstable();
            by_fan.dedup_by_key(|(fan, _)| *fan);
            let mut faces: Vec<usize> = by_fan.into_iter().map(|(_, face)| face).collect();
            faces.sort_unstable();
            faces
        });
    }
}

/// Connected components of faces and of boundaries.
struct Connected {
    vertices: usize,
    components: usize,
    boundary_loops: usize,
}

impl Connected {
    fn new(list: &Mesh, sound: &[bool], edges: &SidesByEdge) -> Self {
        let count = list.positions().len();
        let mut used = vec![false; count];
        let mut sets = DisjointSets::new(count);
        for face in (0..sound.len()).filter(|&face| sound[face]) {
            let corners = &list.faces()[face];
            for &v in corners {
                used[v as usize] = true;
                sets.join(corners[0], v);
            }
        }
        let mut boundary = DisjointSets::new(count);
        let mut on_boundary = vec![false; count];
        for side in edges.groups().filter(|group| group.len() == 1).map(|group| &group[0]) {
            boundary.join(side.low, side.high);
            on_boundary[side.low as usize] = true;
            on_boundary[side.high as usize] = true;
        }
        let roots = |sets: &mut DisjointSets, member: &[bool]| {
            (0..count as u32).filter(|&v| member[v as usize] && sets.find(v) == v).count()
        };
        Self {
            vertices: used.iter().filter(|used| **used).count(),
            components: roots(&mut sets, &used),
            boundary_loops: roots(&mut boundary, &on_boundary),
        }
    }
}
