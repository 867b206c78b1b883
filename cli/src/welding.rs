//! The distance for `--weld` that leaves the fewest boundary edges.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;

use triquad::counted::counted;
use triquad::mesh::Faces;
use triquad::{Law, Mesh};

use crate::attempt::Attempt;
use crate::input::Repairs;
use crate::rim::rim_edges;

/// A welding that leaves fewer boundary edges.
pub struct Welding {
    /// The distance for `--weld`; 0 without a number.
    pub distance: f64,
    /// The mesh after it.
    pub attempt: Attempt,
    /// Boundary edges before.
    before: usize,
    /// Laws that the mesh breaks only after it, and no option mends.
    breaks: Vec<&'static str>,
}

impl Welding {
    /// Finds the distance that leaves the fewest boundary edges: 0, or a power of ten up to a
    /// thousandth of the size of the mesh. It loses slivers at most. Distances come first after
    /// which no more elements break other laws than in `without`, the mesh without another welding;
    /// then one that closes the mesh; then 0, since vertices at equal coordinates are one. None if
    /// no distance beyond that of a `--weld` that is on leaves fewer boundary edges. Where vertices
    /// of the boundary meet, a few times the cost of a survey.
    pub fn find(mesh: &Mesh, on: Repairs, without: &Attempt) -> Option<Self> {
        let rim = rim(mesh, without.repairs.clean);
        let (mut harmless, mut harmful) = (Vec::new(), Vec::new());
        let mut met = 0;
        for distance in distances(mesh, &rim, on) {
            // Vertices of the rim must meet, all but the two ends of a slit. If no more of them do,
            // that is soon known.
            let meet = Mesh::new(rim.clone(), Faces::default()).weld(distance).merged_vertices;
            if meet == met {
                continue;
            }
            met = meet;
            let attempt = Attempt::new(mesh, on, Some(distance));
            if attempt.dropped > 0 && !only_slivers_collapse(distance, mesh) {
                break;
            }
            let (others, left) = attempt.faults();
            let is_harmless = others <= without.faults().0;
            if attempt.closes || attempt.boundary_edges < without.boundary_edges {
                let found = if is_harmless { &mut harmless } else { &mut harmful };
                found.push(Self::new(distance, attempt, without));
            }
            if is_harmless && left == 0 {
                break;
            }
        }
        let best = harmless.into_iter().min_by_key(|welding| welding.attempt.faults());
        best.or_else(|| {
            let of_harm = |welding: &Self| (!welding.attempt.closes, welding.distance > 0.0);
            let least = harmful.into_iter().min_by_key(of_harm)?;
            (of_harm(&least) != (true, true)).then_some(least)
        })
    }

    fn new(distance: f64, attempt: Attempt, without: &Attempt) -> Self {
        let harms = [Law::DistinctFaces, Law::AtMostTwoFaces, Law::OneFan].into_iter();
        let harms = harms.filter(|&law| attempt.breaks(law) && !without.breaks(law));
        let breaks = harms.map(Law::name).collect();
        Self { distance, attempt, before: without.boundary_edges, breaks }
    }

    /// Returns true if boundary edges are left.
    pub fn leaves_holes(&self) -> bool {
        !self.attempt.closes && self.attempt.boundary_edges > 0
    }

    /// Returns the option as it is typed.
    pub fn option(&self) -> String {
        match self.distance {
            0.0 => "--weld".into(),
            distance => format!("--weld {distance:e}"),
        }
    }

    /// Returns which vertices it joins.
    pub fn joins(&self) -> &'static str {
        match self.distance {
            0.0 => "it joins vertices at equal coordinates",
            _ => "it joins vertices that near",
        }
    }
}

impl fmt::Display for Welding {
    /// Writes what the option does.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Attempt { joined, boundary_edges: left, closes, .. } = self.attempt;
        let option = self.option();
        if closes {
            write!(f, "{option} closes it: {}", self.joins())?;
        } else {
            let joined = counted(joined, "vertex", "vertices");
            let left = if left == 0 { "none".into() } else { left.to_string() };
            let all = counted(self.before, "boundary edge", "boundary edges");
            write!(f, "{option} joins {joined} and leaves {left} of {all}")?;
        }
        match &self.breaks[..] {
            [] => Ok(()),
            laws => write!(f, "; it then breaks {}", laws.join(" and ")),
        }
    }
}

/// Returns true if vertices on the boundary of a surface are so near to others that it may be a
/// seam. Takes as long as sorting the edges.
pub fn may_have_seams(surface: &Mesh) -> bool {
    /// Distance of vertices in a seam, as a share of the size of the mesh.
    const NEAR: f64 = 1e-6;
    let distance = NEAR * size(surface);
    let mut points = Mesh::new(rim(surface, false), Faces::default());
    distance.is_finite() && points.weld(distance.max(0.0)).merged_vertices > 0
}

/// Returns the distances to try, beyond that of a `--weld` that is on.
fn distances(mesh: &Mesh, rim: &[[f64; 3]], on: Repairs) -> impl Iterator<Item = f64> {
    let exponent = if rim.is_empty() { f64::NAN } else { size(mesh).log10().floor() };
    let steps = if exponent.is_finite() { exponent as i32 - 9..exponent as i32 - 2 } else { 0..0 };
    let power = |exponent: i32| format!("1e{exponent}").parse().unwrap_or(f64::INFINITY);
    let is_beyond = move |distance: &f64| on.reading.weld.is_none_or(|on| *distance > on);
    std::iter::once(0.0).chain(steps.map(power)).filter(is_beyond)
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

/// Returns the vertices of edges that belong to one face only, with `clean` once faces are dropped.
fn rim(mesh: &Mesh, clean: bool) -> Vec<[f64; 3]> {
    let mut mesh = Cow::Borrowed(mesh);
    if clean {
        mesh.to_mut().clean();
    }
    let vertices: BTreeSet<u32> = rim_edges(&mesh).into_iter().flatten().collect();
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
