//! The laws that a mesh must obey to be a triangulation (Definition 2.2), by name.

use std::fmt;

use crate::counted::listed;
use crate::mesh::MAX_CORNERS;
use crate::names::named;

/// Returns whether there are more vertices or corners than 32-bit ids can name.
pub(super) fn is_too_large(vertices: usize, corners: usize) -> bool {
    corners > MAX_CORNERS || vertices >= u32::MAX as usize
}

/// A law, in the order in which a mesh's first broken one is reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Law {
    /// There is at least one face.
    NotEmpty,
    /// There are at most 2^31 half-edges, and fewer than 2^32 - 1 vertices.
    NotTooLarge,
    /// Every face index names a vertex.
    IndexInRange,
    /// Every coordinate is a finite number.
    FiniteCoordinate,
    /// Every face has three corners.
    Triangle,
    /// The corners of a face are distinct.
    DistinctCorners,
    /// No two faces have the same corners.
    DistinctFaces,
    /// No edge belongs to more than two faces (Lemma 2.2).
    AtMostTwoFaces,
    /// No edge belongs to only one face: the surface has no boundary (Lemma 2.2).
    NoBoundary,
    /// The surface has two sides.
    Orientable,
    /// Neighbouring faces are oriented alike.
    ConsistentOrientation,
    /// The faces round a vertex form one fan.
    OneFan,
}

impl Law {
    /// All laws, in the order in which they are reported.
    pub const ALL: [Self; 12] = [
        Self::NotEmpty,
        Self::NotTooLarge,
        Self::IndexInRange,
        Self::FiniteCoordinate,
        Self::Triangle,
        Self::DistinctCorners,
        Self::DistinctFaces,
        Self::AtMostTwoFaces,
        Self::NoBoundary,
        Self::Orientable,
        Self::ConsistentOrientation,
        Self::OneFan,
    ];

    /// Returns the name used in JSON and messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::NotEmpty => "empty-mesh",
            Self::NotTooLarge => "too-large",
            Self::IndexInRange => "index-out-of-range",
            Self::FiniteCoordinate => "non-finite-coordinate",
            Self::Triangle => "not-a-triangle",
            Self::DistinctCorners => "repeated-corner",
            Self::DistinctFaces => "duplicate-face",
            Self::AtMostTwoFaces => "overfull-edge",
            Self::NoBoundary => "boundary-edge",
            Self::Orientable => "non-orientable",
            Self::ConsistentOrientation => "inconsistent-orientation",
            Self::OneFan => "several-fans",
        }
    }

    /// Returns the complaint about an element that breaks the law, a sentence without its subject.
    pub fn complaint(self) -> &'static str {
        match self {
            Self::NotEmpty => "has no faces",
            Self::NotTooLarge => "has more than 2^31 half-edges or 2^32 - 2 vertices",
            Self::IndexInRange => "names a vertex that does not exist",
            Self::FiniteCoordinate => "has a coordinate that is NaN or infinite",
            Self::Triangle => "is not a triangle",
            Self::DistinctCorners => "repeats a corner",
            Self::DistinctFaces => "has the same corners as an earlier face",
            Self::AtMostTwoFaces => "belongs to more than two faces",
            Self::NoBoundary => "is a boundary edge: it belongs to one face only",
            Self::Orientable => "closes a one-sided (non-orientable) strip",
            Self::ConsistentOrientation => "is passed in the same direction by both its faces",
            Self::OneFan => "is a bow-tie: it joins several fans of faces",
        }
    }

    /// Returns the remedy, as an instruction to a program: it names functions of the library.
    pub fn remedy(self) -> &'static str {
        match self {
            Self::NotEmpty => "check that the file is a mesh and was exported with faces",
            Self::NotTooLarge => "split the mesh into components and convert them one by one",
            Self::IndexInRange => "correct the face or export the mesh again",
            Self::FiniteCoordinate => "correct the vertex or export the mesh again",
            Self::Triangle => {
                "cut larger faces (Mesh::triangulate), drop smaller ones (Mesh::clean)"
            }
            Self::DistinctCorners => "drop degenerate faces (Mesh::clean)",
            Self::DistinctFaces => "drop faces that are there twice (Mesh::clean)",
            Self::AtMostTwoFaces => {
                "separate the sheets that meet there, or remove the inner faces"
            }
            Self::NoBoundary => {
                "close the holes, join the vertices of seams (Mesh::weld), or leave triangles over \
                 (Converter::open)"
            }
            Self::Orientable => "cut the strip or take the double cover of the surface",
            Self::ConsistentOrientation => "flip faces until they agree (Converter::orient)",
            Self::OneFan => "give each fan a vertex of its own",
        }
    }
}

named!(Law, "law", name);

/// An element of a mesh. Displayed numbers count from 1, as in OBJ files; stored ones from 0.
///
/// ```
/// assert_eq!(triquad::Element::Edge(0, 2).to_string(), "edge 1-3");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Element {
    /// The mesh as a whole.
    Mesh,
    /// A vertex, by its index from 0.
    Vertex(u32),
    /// An edge, by the indices of its ends from 0.
    Edge(u32, u32),
    /// A face, by its index in the file from 0.
    Face(usize),
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mesh => write!(f, "the mesh"),
            Self::Vertex(v) => write!(f, "vertex {}", u64::from(*v) + 1),
            Self::Edge(a, b) => write!(f, "edge {}-{}", u64::from(*a) + 1, u64::from(*b) + 1),
            Self::Face(face) => write!(f, "face {}", face + 1),
        }
    }
}

/// A broken law: the first element that breaks it, and how many do. Displayed numbers count from 1,
/// stored ones from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Violation {
    /// The law.
    pub law: Law,
    /// The first element, in file order, that breaks it.
    pub element: Element,
    /// Number of elements that break it.
    pub count: usize,
    /// Faces at the first element, by their index in the file, if that does not name them: those of
    /// the edge, one face of each fan of the vertex, the earlier face with the same corners.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub faces: Vec<usize>,
    /// The vertex that the first face names and that does not exist, and the number of vertices
    /// that do.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub absent_vertex: Option<(u32, usize)>,
}

impl Violation {
    /// Returns the faces in words, the first of them if there are many; nothing if there are none.
    /// `start` is the number of the first face of the file.
    ///
    /// ```
    /// let overfull = vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]];
    /// let mesh = triquad::Mesh::from_triangles(vec![[0.0; 3]; 5], overfull);
    /// let violations = triquad::Survey::new(&mesh).violations;
    /// assert_eq!(violations[0].faces_in_words(1).as_deref(), Some("faces 1, 2 and 3"));
    /// ```
    pub fn faces_in_words(&self, start: usize) -> Option<String> {
        /// Of more faces only the number is displayed.
        const SHOWN: usize = 8;
        let shown = self.faces.iter().take(SHOWN);
        let mut names: Vec<String> = shown.map(|face| (face + start).to_string()).collect();
        if self.faces.len() > SHOWN {
            names.push(format!("{} more", self.faces.len() - SHOWN));
        }
        match (self.law, names.len()) {
            (_, 0) => None,
            (Law::OneFan, _) => Some(format!("one face of each: {}", listed(&names))),
            (_, 1) => Some(format!("face {}", names[0])),
            _ => Some(format!("faces {}", listed(&names))),
        }
    }

    /// Returns the words in brackets behind the complaint: the faces, the vertex that does not
    /// exist, and the number of elements if it is not one. `start` is the number of the first face
    /// and of the first vertex.
    ///
    /// ```
    /// let absent = triquad::Mesh::from_triangles(vec![[0.0; 3]; 3], vec![[0, 1, 7], [0, 1, 8]]);
    /// let violations = triquad::Survey::new(&absent).violations;
    /// assert_eq!(violations[0].notes(1), " (vertex 8 of 3; first of 2)");
    /// assert_eq!(violations[0].notes(0), " (vertex 7 of 3; first of 2)");
    /// ```
    pub fn notes(&self, start: usize) -> String {
        let faces = self.faces_in_words(start);
        let absent = self.absent_vertex;
        let absent = absent.map(|(v, all)| format!("vertex {} of {all}", v as usize + start));
        let first_of = (self.count > 1).then(|| format!("first of {}", self.count));
        let notes: Vec<String> = faces.into_iter().chain(absent).chain(first_of).collect();
        if notes.is_empty() { String::new() } else { format!(" ({})", notes.join("; ")) }
    }
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}{}", self.element, self.law.complaint(), self.notes(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_are_read_back_as_they_are_written() {
        assert!(Law::ALL.is_sorted());
        for law in Law::ALL {
            assert_eq!(law.to_string().parse(), Ok(law));
        }
        let refusal = "planar".parse::<Law>().unwrap_err();
        assert_eq!(refusal.known, Law::ALL.map(Law::name));
    }

    #[cfg(feature = "serde")]
    #[test]
    fn violations_are_plain_json() {
        let element = Element::Edge(3, 4);
        let mut violation = Violation {
            law: Law::NoBoundary,
            element,
            count: 2,
            faces: Vec::new(),
            absent_vertex: None,
        };
        let json = r#"{"law":"boundary-edge","element":{"edge":[3,4]},"count":2}"#;
        assert_eq!(serde_json::to_string(&violation).unwrap(), json);
        assert_eq!(serde_json::from_str::<Violation>(json).unwrap(), violation);
        violation.faces.push(7);
        let json = serde_json::to_string(&violation).unwrap();
        assert!(json.ends_with(r#""count":2,"faces":[7]}"#), "{json}");
    }

    #[test]
    fn ids_bound_the_size_of_a_mesh() {
        assert!(!is_too_large(u32::MAX as usize - 1, 1 << 31));
        assert!(is_too_large(4, (1 << 31) + 1));
        assert!(is_too_large(u32::MAX as usize, 12));
    }
}
