//! The table of `convert --compare`: a row an algorithm.

use std::fmt;

use triquad::convert::Aims;
use triquad::counted::listed;
use triquad::quadrangulation::check_mixed;
use triquad::triangulation::{OpenTriangulation, Surface};
use triquad::{Algorithm, Converted, DualGraph, Mesh, Triangulation};

/// Rows of text under a line of names.
pub struct Table<'a> {
    aims: &'a Aims<'a>,
    rows: Vec<[String; COLUMNS]>,
    /// Algorithms that do not take the mesh.
    skipped: Vec<String>,
    /// What the columns do not say.
    note: Option<String>,
}

const COLUMNS: usize = 10;

const NAMES: [&str; COLUMNS] = [
    "algorithm",
    "quads",
    "left over",
    "worst",
    "mean",
    "folded",
    "sharp kept",
    "degree 2",
    "cost",
    "seconds",
];

impl<'a> Table<'a> {
    /// Makes a table in which costs are those of `aims`.
    pub fn new(aims: &'a Aims<'a>) -> Self {
        Self { aims, rows: vec![NAMES.map(String::from)], skipped: Vec::new(), note: None }
    }

    /// Adds the row of a conversion.
    pub fn add(&mut self, converted: Converted) {
        let report = converted.report().clone();
        let cost = self.cost(converted);
        let quality = report.quality.as_ref().filter(|_| report.quads > 0);
        let shape = |value: Option<f64>| value.map_or("-".into(), three_digits);
        let sharp = report.sharp_edges.map(|sharp| format!("{} of {}", sharp.kept, sharp.all));
        self.rows.push([
            report.algorithm.to_string(),
            report.quads.to_string(),
            report.leftover_triangles.unwrap_or(0).to_string(),
            shape(quality.map(|quality| quality.minimum)),
            shape(quality.map(|quality| quality.mean)),
            quality.map_or("-".into(), |quality| quality.folded.to_string()),
            sharp.unwrap_or("-".into()),
            report.degree_two_vertices.to_string(),
            cost.map_or("-".into(), |cost| cost.to_string()),
            seconds(report.total_seconds()),
        ]);
    }

    /// Adds the row of an algorithm that does not take the mesh.
    pub fn skip(&mut self, algorithm: Algorithm) {
        let mut row: [String; COLUMNS] = std::array::from_fn(|_| "-".into());
        row[0] = algorithm.to_string();
        self.skipped.push(row[0].clone());
        self.rows.push(row);
    }

    /// Adds a line on options that mean something to `best` alone, given what they make it do,
    /// their names, and its conversion without them.
    pub fn explain_best(&mut self, deeds: &str, options: &str, without: Converted) {
        let cost = self.cost(without).map(|cost| format!("; without {options} its cost is {cost}"));
        self.note = Some(format!("only best {deeds}{}", cost.unwrap_or_default()));
    }

    /// Returns the total cost of the pairs, from the meshes alone. Listed costs are those of edges
    /// of the input, which lrs flips.
    fn cost(&self, converted: Converted) -> Option<i128> {
        if self.aims.listed_costs.is_some() && converted.report().edge_flips > 0 {
            return None;
        }
        let quads = converted.mesh().clone();
        let triangles = converted.into_triangle_mesh();
        match Triangulation::build(&triangles) {
            Ok(surface) => self.cost_on(&surface, &quads, &triangles),
            Err(_) => self.cost_on(&OpenTriangulation::build(&triangles).ok()?, &quads, &triangles),
        }
    }

    fn cost_on(&self, surface: &impl Surface, quads: &Mesh, triangles: &Mesh) -> Option<i128> {
        let objective = self.aims.objective(surface, triangles).ok()?;
        let matching = check_mixed(quads, triangles).ok()?.matching;
        Some(objective.cost(&DualGraph::new(surface), &matching))
    }
}

/// Writes a number with three digits behind the point, zero without a sign.
fn three_digits(value: f64) -> String {
    let text = format!("{value:.3}");
    if text == "-0.000" { "0.000".into() } else { text }
}

/// Writes seconds; short ones with more digits, so that they are not 0.
fn seconds(seconds: f64) -> String {
    if seconds < 0.01 { format!("{seconds:.6}") } else { format!("{seconds:.3}") }
}

impl fmt::Display for Table<'_> {
    /// Writes the columns right-aligned, names of algorithms left-aligned, a line on those that
    /// were skipped, and one on options for `best` alone.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = |k: usize| self.rows.iter().map(|row| row[k].len()).max().unwrap_or(0);
        let widths: [usize; COLUMNS] = std::array::from_fn(width);
        for (number, row) in self.rows.iter().enumerate() {
            if number > 0 {
                writeln!(f)?;
            }
            write!(f, "{:<1$}", row[0], widths[0])?;
            for (cell, width) in row.iter().zip(widths).skip(1) {
                write!(f, "  {cell:>width$}")?;
            }
        }
        match &self.skipped[..] {
            [] => {}
            [one] => write!(f, "\n{one} takes closed, two-sided surfaces only")?,
            more => write!(f, "\n{} take closed, two-sided surfaces only", listed(more))?,
        }
        self.note.iter().try_for_each(|note| write!(f, "\n{note}"))
    }
}
