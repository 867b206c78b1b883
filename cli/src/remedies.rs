//! Remedies of a mesh that is refused: what helps, with the options that are on.

use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::BTreeSet;
use std::fmt;
use std::path::Path;

use triquad::counted::{counted, listed};
use triquad::mesh::{Cleaned, Faces, Format};
use triquad::{Element, Law, Mesh, Survey, Violation};

use crate::fins::Fins;
use crate::input::{self, Repairs};
use crate::rim::{Junction, rim_edges};

/// A mesh that was read and repaired, and is refused.
pub struct Refused<'a> {
    mesh: &'a Mesh,
    /// The format of the file, if its name tells.
    format: Option<Format>,
    repairs: Repairs,
    welding_distance: OnceCell<Option<f64>>,
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
    repairs: Repairs,
    /// True if the mesh stays open, which is no repair.
    pub is_open: bool,
}

impl fmt::Display for Way {
    /// Writes the options as they are typed.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut words = self.repairs.words();
        words.extend(self.is_open.then(|| "--open".into()));
        f.write_str(&words.join(" "))
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
        let (welding_distance, fins) = (OnceCell::new(), OnceCell::new());
        Self { mesh, format, repairs, welding_distance, fins }
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
        match violation.law {
            law @ Law::NotEmpty if self.may_be_cut_off() => {
                Remedy::other(format!("{}; {CUT_OFF}", general(law, self.repairs)))
            }
            Law::Triangle => self.for_corners(),
            Law::NoBoundary => match self.welding_distance() {
                Some(0.0) => {
                    Remedy::option("--weld closes it: it joins vertices at equal coordinates")
                }
                Some(distance) => Remedy::option(format!(
                    "--weld {distance:e} closes it: it joins vertices that near"
                )),
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

    /// Returns what helps against the first of the laws of `survey`, and whether an option that it
    /// names does not suffice.
    pub fn full_remedy(&self, survey: &Survey) -> String {
        let remedy = self.remedy(&survey.violations[0]);
        if !remedy.is_option {
            return remedy.to_string();
        }
        match self.options(survey) {
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

    /// Returns what helps against holes that welding does not close. Vertices without faces are
    /// the only sign that the file had more of them.
    fn for_holes(&self, first: Element) -> Remedy {
        if self.repairs.reading.weld.is_none() && welding_closes_seams(self.mesh) {
            let words = "--weld closes the seams; close the holes that are left";
            return Remedy::option(words);
        }
        if let Element::Edge(a, b) = first
            && let Some(Junction { vertex, edge: [from, to] }) = Junction::near(self.mesh, [a, b])
        {
            return Remedy::other(format!(
                "{} lies on {}, a T-junction: cut the face of that edge there; or close the holes",
                Element::Vertex(vertex),
                Element::Edge(from, to)
            ));
        }
        let mut has_face = vec![false; self.mesh.positions().len()];
        for &v in self.mesh.faces().corners() {
            if let Some(has_face) = has_face.get_mut(v as usize) {
                *has_face = true;
            }
        }
        let idle = has_face.iter().filter(|&&has_face| !has_face).count();
        if idle == 0 || !self.may_be_cut_off() {
            return Remedy::other("close the holes");
        }
        let idle = counted(idle, "vertex is", "vertices are");
        Remedy::other(format!("close the holes; {idle} in no face: {CUT_OFF}"))
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

    /// Returns the least distance for `--weld` that closes the mesh and loses slivers at most: 0,
    /// or a power of ten up to a thousandth of the size of the mesh. None if there is none beyond
    /// that of a `--weld` that is on, or there are no holes. A few times the cost of a survey.
    pub fn welding_distance(&self) -> Option<f64> {
        *self.welding_distance.get_or_init(|| self.distance_that_closes(self.mesh))
    }

    fn distance_that_closes(&self, mesh: &Mesh) -> Option<f64> {
        let rim = rim(mesh);
        if rim.is_empty() {
            return None;
        }
        let exponent = size(mesh).log10().floor();
        let steps =
            if exponent.is_finite() { exponent as i32 - 9..exponent as i32 - 2 } else { 0..0 };
        let power = |exponent: i32| format!("1e{exponent}").parse().unwrap_or(f64::INFINITY);
        let on = self.repairs.reading.weld;
        let mut distances = std::iter::once(0.0).chain(steps.map(power));
        distances.find(|&distance| {
            on.is_none_or(|on| distance > on) && is_closed_by(distance, mesh, &rim)
        })
    }

    /// Returns the options with which `convert` takes the mesh, those that are on included; none if
    /// there are none. The mesh breaks the laws of `survey`.
    pub fn options(&self, survey: &Survey) -> Option<Way> {
        let breaks = |law| survey.violations.iter().any(|violation| violation.law == law);
        let mut way = self.repairs;
        let faces = self.mesh.faces();
        way.clean |= breaks(Law::DistinctCorners) || breaks(Law::DistinctFaces);
        way.clean |= faces.iter().any(|face| face.len() < 3);
        way.triangulate |= faces.iter().any(|face| face.len() > 3);
        let mut mended = Mesh::new(self.mesh.positions().to_vec(), faces.clone());
        if breaks(Law::NoBoundary) {
            let distance = match way.clean && mended.clean() != Cleaned::default() {
                true => self.distance_that_closes(&mended),
                false => self.welding_distance(),
            };
            let seams = || welding_closes_seams(&mended).then_some(0.0);
            way.reading.weld = distance.or(way.reading.weld).or_else(seams);
        }
        if let Some(distance) = way.reading.weld {
            mended.weld(distance);
        }
        input::repair(Path::new(""), &mut mended, way).ok()?;
        // Where edges have too many faces, only now is known which faces disagree.
        let violations = Survey::new(&mended).violations;
        way.orient |= violations.iter().any(|broken| broken.law == Law::ConsistentOrientation);
        let is_open = match input::build_oriented(&mut mended, way) {
            Ok(_) => false,
            Err(survey) if survey.is_open_surface(way.orient) => true,
            Err(_) => return None,
        };
        Some(Way { repairs: way, is_open })
    }
}

/// Returns true if welding closes the mesh. `rim` are the vertices of its boundary.
fn is_closed_by(distance: f64, mesh: &Mesh, rim: &[[f64; 3]]) -> bool {
    // Vertices of the rim must meet, all but the two ends of a slit. If none do, that is soon
    // known.
    let mut points = Mesh::new(rim.to_vec(), Faces::default());
    if points.weld(distance).merged_vertices == 0 {
        return false;
    }
    let mut welded = Mesh::new(mesh.positions().to_vec(), mesh.faces().clone());
    let dropped = welded.weld(distance).dropped_faces;
    (dropped == 0 || only_slivers_collapse(distance, mesh)) && Survey::new(&welded).closed
}

/// Returns true if vertices at equal coordinates are those of seams: joined, they leave fewer
/// boundary edges, and of an open surface. About the cost of a survey.
fn welding_closes_seams(mesh: &Mesh) -> bool {
    let mut welded = Mesh::new(mesh.positions().to_vec(), mesh.faces().clone());
    let outcome = welded.weld(0.0);
    outcome.merged_vertices > 0
        && outcome.dropped_faces == 0
        && rim_edges(&welded).len() < rim_edges(mesh).len()
        && Survey::new(&welded).is_open_surface(true)
}

/// Returns true if every face with a side that welding shortens to nothing has sides that are
/// longer by far.
fn only_slivers_collapse(distance: f64, mesh: &Mesh) -> bool {
    /// The least length of the longest side of a sliver, by its shortest.
    const SLIVER: f64 = 100.0;
    mesh.faces().iter().all(|face| {
        let next = face.iter().cycle().skip(1);
        let sides = face.iter().zip(next).filter(|(a, b)| a != b);
        let (shortest, longest) = sides
            .filter_map(|(&a, &b)| side_length(mesh, [a, b]))
            .fold((f64::INFINITY, 0.0_f64), |(least, most), x| (least.min(x), most.max(x)));
        shortest > distance || longest >= SLIVER * distance
    })
}

fn side_length(mesh: &Mesh, ends: [u32; 2]) -> Option<f64> {
    let [a, b] = ends.map(|v| mesh.positions().get(v as usize));
    let squares = a?.iter().zip(b?).map(|(a, b)| (a - b) * (a - b));
    Some(squares.sum::<f64>().sqrt())
}

/// Returns the vertices of edges that belong to one face only.
fn rim(mesh: &Mesh) -> Vec<[f64; 3]> {
    let vertices: BTreeSet<u32> = rim_edges(mesh).into_iter().flatten().collect();
    let positions = mesh.positions();
    vertices.iter().filter_map(|&v| positions.get(v as usize).copied()).collect()
}

/// Returns the longest side of the box round the mesh.
fn size(mesh: &Mesh) -> f64 {
    let side = |axis: usize| {
        let all = || mesh.positions().iter().map(|at| at[axis]).filter(|x| x.is_finite());
        all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min)
    };
    (0..3).map(side).fold(0.0, f64::max)
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
