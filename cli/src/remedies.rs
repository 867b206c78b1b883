//! Remedies of a mesh that is refused: what helps, with the options that are on.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::fmt;
use std::path::Path;

use triquad::counted::{counted, listed};
use triquad::mesh::Format;
use triquad::{Element, Law, Mesh, Violation};

use crate::attempt::Attempt;
use crate::fins::Fins;
use crate::input::Repairs;
use crate::rim::Junction;
use crate::welding::Welding;

/// A mesh that was read and repaired, and is refused.
pub struct Refused<'a> {
    mesh: &'a Mesh,
    /// The format of the file, if its name tells.
    format: Option<Format>,
    repairs: Repairs,
    without_welding: OnceCell<Attempt>,
    welding: OnceCell<Option<Welding>>,
    fins: OnceCell<Fins>,
}

/// What helps against a broken law.
pub struct Remedy {
    words: Cow<'static, str>,
    /// True if it is an option of the command.
    is_option: bool,
}

impl Remedy {
    fn option(words: impl Into<Cow<'static, str>>) -> Self {
        Self { words: words.into(), is_option: true }
    }

    /// A remedy outside of the command.
    fn other(words: impl Into<Cow<'static, str>>) -> Self {
        Self { words: words.into(), is_option: false }
    }
}

impl fmt::Display for Remedy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words)
    }
}

/// Options with which `convert` takes a mesh.
pub struct Way {
    pub repairs: Repairs,
    /// True if the mesh stays open, which is no repair.
    pub is_open: bool,
}

impl Way {
    /// Returns the options as they are typed, without those that are on.
    pub fn beyond(&self, on: Repairs) -> Vec<String> {
        let on = on.words();
        let mut words = self.words();
        words.retain(|word| !on.contains(word));
        words
    }

    fn words(&self) -> Vec<String> {
        let mut words = self.repairs.words();
        words.extend(self.is_open.then(|| "--open".into()));
        words
    }
}

impl fmt::Display for Way {
    /// Writes the options as they are typed.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words().join(" "))
    }
}

const CUT_OFF: &str = "if the file was cut off, copy or export it again";

const FILTERS: &str = "docs/formats.md (\"Other repairs\") names filters of MeshLab that do";

const NOT_IN_STL: &str =
    "do it in another format: corners of STL at equal coordinates are one vertex";

const CLEAN: &str = "--clean drops degenerate faces";

/// Returns what helps against a broken law of a mesh that is not at hand any more: an option of the
/// command where the library has a function.
pub fn general(law: Law, repairs: Repairs) -> Remedy {
    match law {
        Law::Triangle if repairs.triangulate => Remedy::option(CLEAN),
        Law::Triangle => {
            Remedy::option("--triangulate cuts larger faces into triangles; remove smaller ones")
        }
        Law::DistinctCorners => Remedy::option(CLEAN),
        Law::DistinctFaces => Remedy::option("--clean drops faces that are there twice"),
        Law::NoBoundary if repairs.reading.weld.is_some() => Remedy::other("close the holes"),
        Law::NoBoundary => Remedy::option("close the holes, or use --weld if the gaps are seams"),
        Law::AtMostTwoFaces | Law::OneFan => Remedy::other(format!("{}; {FILTERS}", law.remedy())),
        Law::ConsistentOrientation => Remedy::option("--orient flips faces until they agree"),
        law => Remedy::other(law.remedy()),
    }
}

impl<'a> Refused<'a> {
    /// Takes a mesh that was read from `path` with `repairs`.
    pub fn new(mesh: &'a Mesh, path: &Path, repairs: Repairs) -> Self {
        let format = Format::from_path(path).ok();
        let (without_welding, welding) = (OnceCell::new(), OnceCell::new());
        Self { mesh, format, repairs, without_welding, welding, fins: OnceCell::new() }
    }

    /// Returns true if the file does not announce how much is in it: its end may be missing.
    fn may_be_cut_off(&self) -> bool {
        self.format == Some(Format::Obj)
    }

    /// Returns what helps against a broken law.
    pub fn remedy(&self, violation: &Violation) -> Remedy {
        if let Some(remedy) = self.without_fins(violation) {
            return remedy;
        }
        if let Law::AtMostTwoFaces | Law::OneFan = violation.law
            && self.has_duplicate_at(violation.element)
        {
            return general(Law::DistinctFaces, self.repairs);
        }
        if let Law::AtMostTwoFaces | Law::OneFan = violation.law
            && let Some(welding) = self.welding()
            && !welding.attempt.breaks(violation.law)
        {
            let (option, joins) = (welding.option(), welding.joins());
            return Remedy::option(format!("{option} mends it: {joins}"));
        }
        match violation.law {
            law @ Law::NotEmpty if self.may_be_cut_off() => {
                Remedy::other(format!("{}; {CUT_OFF}", general(law, self.repairs)))
            }
            Law::Triangle => self.for_corners(),
            Law::NoBoundary => match self.welding() {
                Some(welding) if welding.leaves_holes() => {
                    Remedy::option(format!("{welding}; then {}", self.close_holes()))
                }
                Some(welding) => Remedy::option(welding.to_string()),
                None => self.for_holes(violation.element),
            },
            law @ Law::OneFan if self.format == Some(Format::Stl) => {
                Remedy::other(format!("{}; {NOT_IN_STL}", general(law, self.repairs)))
            }
            Law::DistinctFaces if !self.has_duplicate_at(Element::Mesh) => {
                Remedy::other("remove one of them")
            }
            law => general(law, self.repairs),
        }
    }

    /// Returns what helps against the first broken law, and whether an option that it names does
    /// not suffice.
    pub fn full_remedy(&self, first: &Violation) -> String {
        let remedy = self.remedy(first);
        if !remedy.is_option {
            return remedy.to_string();
        }
        match self.options() {
            None => format!("{remedy}, but no options suffice for this mesh"),
            Some(way) if way.repairs.number() > self.repairs.number() + 1 => {
                format!("{remedy}, but more options are needed")
            }
            Some(_) => remedy.to_string(),
        }
    }

    /// Returns the advice to remove the fins at the element, if there are any.
    fn without_fins(&self, violation: &Violation) -> Option<Remedy> {
        /// Of more faces only the number is told.
        const SHOWN: usize = 8;
        if !matches!(violation.law, Law::AtMostTwoFaces | Law::NoBoundary | Law::OneFan) {
            return None;
        }
        let in_file = |face: usize| self.mesh.face_in_file(face);
        let there =
            (0..self.mesh.faces().len()).filter(|&face| violation.faces.contains(&in_file(face)));
        let mut fins = self.fins.get_or_init(|| Fins::of(self.mesh)).at(there);
        fins.iter_mut().for_each(|face| *face = in_file(*face) + 1);
        fins.dedup();
        let mut names: Vec<String> = fins.iter().take(SHOWN).map(usize::to_string).collect();
        match &names[..] {
            [] => return None,
            [face] => {
                let words = format!("remove face {face}: it hangs on the mesh by one edge alone");
                return Some(Remedy::other(words));
            }
            _ if fins.len() > SHOWN => names.push(format!("{} more", fins.len() - SHOWN)),
            _ => {}
        }
        let faces = listed(&names);
        let words = format!("remove faces {faces}: they hang on the mesh by one edge alone");
        Some(Remedy::other(words))
    }

    /// Returns true if `--clean` drops a face at the element because it is there twice.
    fn has_duplicate_at(&self, element: Element) -> bool {
        let is_there = |corners: &[u32]| match element {
            Element::Edge(a, b) => corners.contains(&a) && corners.contains(&b),
            Element::Vertex(v) => corners.contains(&v),
            _ => true,
        };
        let faces = self.mesh.faces().iter().filter(|corners| is_there(corners));
        let mut there = Mesh::new(Vec::new(), faces.collect());
        there.clean().duplicate_faces > 0
    }

    /// Returns what helps against holes that welding does not make fewer.
    fn for_holes(&self, first: Element) -> Remedy {
        if let Element::Edge(a, b) = first
            && let Some(Junction { vertex, edge: [from, to] }) = Junction::near(self.mesh, [a, b])
        {
            return Remedy::other(format!(
                "{} lies on {}, a T-junction: cut the face of that edge there; or close the holes",
                Element::Vertex(vertex),
                Element::Edge(from, to)
            ));
        }
        Remedy::other(self.close_holes())
    }

    /// Returns the advice to close holes. Vertices without faces are the only sign that the file
    /// had more of them.
    fn close_holes(&self) -> String {
        let mut has_face = vec![false; self.mesh.positions().len()];
        for &v in self.mesh.faces().corners() {
            if let Some(has_face) = has_face.get_mut(v as usize) {
                *has_face = true;
            }
        }
        let idle = has_face.iter().filter(|&&has_face| !has_face).count();
        if idle == 0 || !self.may_be_cut_off() {
            return "close the holes".into();
        }
        let idle = counted(idle, "vertex is", "vertices are");
        format!("close the holes; {idle} in no face: {CUT_OFF}")
    }

    /// Returns what helps against the first face that is no triangle.
    fn for_corners(&self) -> Remedy {
        let faces = self.mesh.faces();
        let first = (0..faces.len()).find(|&face| faces[face].len() != 3).unwrap_or_default();
        match faces.get(first).unwrap_or_default().len() {
            corners @ 0..3 => {
                let corners = counted(corners, "corner", "corners");
                let end = match first + 1 == faces.len() {
                    true => format!(" and is the last: {CUT_OFF}"),
                    false => String::new(),
                };
                Remedy::option(format!("it has {corners}{end}; {CLEAN}"))
            }
            // What is left of larger faces after cutting repeats a corner.
            _ if self.repairs.triangulate => Remedy::option(CLEAN),
            _ => Remedy::option("--triangulate cuts larger faces into triangles"),
        }
    }

    /// Returns the least distance for `--weld` that closes the mesh, if there is one.
    pub fn closing_distance(&self) -> Option<f64> {
        self.welding().filter(|welding| welding.attempt.closes).map(|welding| welding.distance)
    }

    /// Returns the welding that leaves the fewest boundary edges, see [`Welding::find`].
    pub fn welding(&self) -> Option<&Welding> {
        let find = || Welding::find(self.mesh, self.repairs, self.without_welding());
        self.welding.get_or_init(find).as_ref()
    }

    /// Returns the welding if `convert` takes the mesh after it.
    pub fn welding_to_a_surface(&self) -> Option<&Welding> {
        self.welding().filter(|welding| welding.attempt.is_surface())
    }

    /// Returns the mesh after all repairs but another welding.
    fn without_welding(&self) -> &Attempt {
        self.without_welding.get_or_init(|| Attempt::new(self.mesh, self.repairs, None))
    }

    /// Returns the options with which `convert` takes the mesh, those that are on included; none if
    /// there are none. They have been tried.
    pub fn options(&self) -> Option<Way> {
        let welded = self.welding().map(|welding| &welding.attempt);
        let without = self.without_welding();
        // With nothing to pair it is no way, if welding is one to go on from.
        let without = Some(without).filter(|without| welded.is_none() || !without.is_apart());
        let mut attempts = [welded, without].into_iter().flatten();
        let attempt = attempts.find(|attempt| attempt.is_surface())?;
        Some(Way { repairs: attempt.repairs, is_open: attempt.is_open() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What `full_remedy` decides by is what the words say, for every law and repair.
    #[test]
    fn remedies_are_options_exactly_where_they_name_one() {
        let names = ["--clean", "--orient", "--triangulate", "--weld"];
        for triangulate in [false, true] {
            let repairs = Repairs { triangulate, ..Repairs::default() };
            for law in Law::ALL {
                let Remedy { words, is_option } = general(law, repairs);
                assert_eq!(names.iter().any(|name| words.contains(name)), is_option, "{words}");
            }
        }
    }

    #[test]
    fn a_way_is_counted_by_its_repairs_and_written_as_typed() {
        let mut way = Way { repairs: Repairs::default(), is_open: true };
        assert_eq!((way.to_string().as_str(), way.repairs.number()), ("--open", 0));
        way.repairs.clean = true;
        way.repairs.reading.weld = Some(1e-5);
        way.repairs.reading.max_expanded = Some(5_000_000);
        let words = "--max-expanded 5000000 --weld 1e-5 --clean --open";
        assert_eq!((way.to_string().as_str(), way.repairs.number()), (words, 2));
    }
}
