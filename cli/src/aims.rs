//! The options of `convert` that say what `best` aims at, and the files that they name.

use std::path::{Path, PathBuf};

use triquad::convert::Aims;
use triquad::counted::listed;
use triquad::quadrangulation::Keep;
use triquad::{ConvertError, DefaultCost, ShapeCost};

use crate::failure::Failure;
use crate::input;

/// The criteria of the best pairing.
#[derive(clap::Args, Clone)]
#[command(next_help_heading = "What best aims at")]
pub struct AimOptions {
    /// Cost of a quad, of which best minimises the sum: default (shape, folds and sharp edges),
    /// shape (10000 times 1 less the scaled Jacobian, rounded), or FILE: one integer an edge, in
    /// the order in which the faces first pass the edges
    #[arg(long, default_value = "default", value_name = "default|shape|FILE")]
    cost: String,
    /// Keep edges at which the surface bends by more than DEG degrees: no quad lies across them. If
    /// not all can be kept, the fewest possible are given up, provably
    #[arg(long, value_name = "DEG", value_parser = degrees)]
    keep_sharp: Option<f64>,
    /// Keep the edges listed in FILE: two vertex numbers a line, counted from 1
    #[arg(long, value_name = "FILE")]
    keep_edges: Option<PathBuf>,
    /// Keep edges at which texture coordinates, objects, groups or materials change
    #[arg(long)]
    keep_seams: bool,
    /// Give up none of the edges to keep; leave the fewest triangles instead, provably
    #[arg(long)]
    strict: bool,
    /// Leave a triangle wherever every pair would cost more than twice PRICE (0.35 if no PRICE is
    /// given). PRICE 1 stands for a loss of 1 in scaled Jacobian, from a rectangle to a corner of
    /// 180 degrees. With --cost FILE the unit is that of FILE
    #[arg(long, value_name = "PRICE", num_args = 0..=1, default_missing_value = "0.35")]
    #[arg(value_parser = price, allow_negative_numbers = true)]
    quad_dominant: Option<f64>,
}

fn degrees(text: &str) -> Result<f64, String> {
    let degrees = text.parse().ok().filter(|degrees| (0.0..=180.0).contains(degrees));
    degrees.ok_or_else(|| "an angle is a number from 0 to 180".into())
}

fn price(text: &str) -> Result<f64, String> {
    let price = text.parse().ok().filter(|price: &f64| price.is_finite());
    price.ok_or_else(|| "a price is a number; put IN before --quad-dominant".into())
}

/// A kind of cost.
#[derive(Clone, Debug, PartialEq)]
pub enum CostKind {
    Default,
    Shape,
    /// One for each edge, in a file.
    Listed(PathBuf),
}

impl CostKind {
    fn of(name: &str) -> Self {
        match name {
            "default" => Self::Default,
            "shape" => Self::Shape,
            path => Self::Listed(path.into()),
        }
    }

    /// Returns the name in certificates.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Default => "default",
            Self::Shape => "shape",
            Self::Listed(_) => "listed",
        }
    }

    /// Sets the cost of `aims`; reads it if it is in a file.
    pub fn enter(&self, aims: &mut Aims<'static>) -> Result<(), Failure> {
        match self {
            Self::Default => aims.cost = None,
            Self::Shape => aims.cost = Some(&ShapeCost),
            Self::Listed(path) => aims.listed_costs = Some(read_costs(path)?),
        }
        Ok(())
    }

    /// Returns the integer that stands for 1.
    fn unit(&self) -> f64 {
        match self {
            Self::Default => DefaultCost::UNIT,
            Self::Shape => ShapeCost::UNIT,
            Self::Listed(_) => 1.0,
        }
    }
}

/// Aims with the files that parts of them come from.
pub struct ReadAims {
    pub aims: Aims<'static>,
    pub cost: CostKind,
    /// The file of edges to keep, and the line of each edge.
    edges: Option<(PathBuf, Vec<usize>)>,
}

impl AimOptions {
    /// Reads the files that the options name.
    pub fn read(&self) -> Result<ReadAims, Failure> {
        let cost = CostKind::of(&self.cost);
        let mut aims = Aims::default();
        cost.enter(&mut aims)?;
        aims.keep = Keep::default();
        aims.keep.sharp = self.keep_sharp;
        aims.keep.seams = self.keep_seams;
        let mut edges = None;
        if let Some(path) = &self.keep_edges {
            let (lines, pairs) = read_edges(path)?.into_iter().unzip();
            aims.keep.edges = pairs;
            edges = Some((path.clone(), lines));
        }
        aims.strict = self.strict;
        // A cast saturates: a price beyond 32 bits means that nothing is left that need not be.
        aims.price = self.quad_dominant.map(|price| (price * cost.unit()).round() as i32);
        Ok(ReadAims { aims, cost, edges })
    }

    /// Returns what the options make of `best` alone, in words, and these options; none if all
    /// algorithms are judged by the same.
    pub fn for_best_alone(&self) -> Option<(String, String)> {
        let deeds = [
            (self.keeps_edges(), "keeps edges"),
            (self.quad_dominant.is_some(), "leaves triangles at a price"),
        ];
        let options = [
            (self.keep_sharp.is_some(), "--keep-sharp"),
            (self.keep_edges.is_some(), "--keep-edges"),
            (self.keep_seams, "--keep-seams"),
            (self.strict, "--strict"),
            (self.quad_dominant.is_some(), "--quad-dominant"),
        ];
        let given = |all: &[(bool, &str)]| {
            let given = all.iter().filter(|(is_given, _)| *is_given);
            given.map(|(_, words)| String::from(*words)).collect::<Vec<_>>()
        };
        let deeds = given(&deeds);
        (!deeds.is_empty()).then(|| (listed(&deeds), listed(&given(&options))))
    }

    /// Returns whether edges are to be kept.
    fn keeps_edges(&self) -> bool {
        self.keep_sharp.is_some() || self.keep_edges.is_some() || self.keep_seams
    }

    /// Refuses options that mean nothing together.
    pub fn check(&self) -> Result<(), Failure> {
        if self.strict && !self.keeps_edges() {
            let remedy = "add --keep-sharp, --keep-edges or --keep-seams";
            return Err(Failure::bad(format!("--strict is about edges to keep; {remedy}")));
        }
        Ok(())
    }
}

impl ReadAims {
    /// Returns the aims that all algorithms are judged by: the cost alone.
    pub fn cost_alone(&self) -> Aims<'static> {
        let mut aims = Aims::default();
        (aims.cost, aims.listed_costs) = (self.aims.cost, self.aims.listed_costs.clone());
        aims
    }

    /// Words a failure that a file of these aims caused, if one did.
    pub fn failure(&self, input: &Path, error: &ConvertError) -> Option<Failure> {
        let input = input.display();
        match error {
            ConvertError::CostCount(counts) => {
                let CostKind::Listed(path) = &self.cost else { return None };
                let remedy = "give one integer an edge, in the order in which the faces first pass";
                let path = path.display();
                Some(Failure::bad(format!("{path}: {counts} of {input}; {remedy} the edges")))
            }
            ConvertError::NoSuchEdge(edge) => {
                let (path, lines) = self.edges.as_ref()?;
                let (path, line) = (path.display(), lines[edge.position]);
                let remedy = "name two corners of one face of the mesh, counted from 1";
                Some(Failure::bad(format!("{path}:{line}: {edge} {input}; {remedy}")))
            }
            _ => None,
        }
    }
}

/// Reads integers separated by blanks and line ends.
pub fn read_costs(path: &Path) -> Result<Vec<i32>, Failure> {
    let text = input::read_text(path)?;
    let words = (1..).zip(text.lines());
    let words =
        words.flat_map(|(line, text)| text.split_whitespace().map(move |word| (line, word)));
    let cost = |(line, word): (usize, &str)| {
        word.parse().map_err(|_| {
            let problem = "is no integer of 32 bits; costs are integers, one an edge";
            Failure::bad(format!("{}:{line}: {word:?} {problem}", path.display()))
        })
    };
    words.map(cost).collect()
}

/// Reads pairs of vertices counted from 1, each with its line; returns them counted from 0.
fn read_edges(path: &Path) -> Result<Vec<(usize, [u32; 2])>, Failure> {
    let text = input::read_text(path)?;
    let lines = (1..).zip(text.lines()).filter(|(_, text)| !text.trim().is_empty());
    let edge = |(line, text): (usize, &str)| {
        let ends = ends(text).ok_or_else(|| {
            let remedy = "a line has two different vertex numbers, counted from 1";
            Failure::bad(format!("{}:{line}: {text:?} is no edge; {remedy}", path.display()))
        })?;
        Ok((line, ends))
    };
    lines.map(edge).collect()
}

fn ends(line: &str) -> Option<[u32; 2]> {
    let mut words = line.split_whitespace();
    let mut end = || words.next()?.parse::<u32>().ok()?.checked_sub(1);
    let ends = [end()?, end()?];
    (words.next().is_none() && ends[0] != ends[1]).then_some(ends)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_two_different_vertices_is_an_edge() {
        assert_eq!(ends(" 3\t17 "), Some([2, 16]));
        for line in ["3", "3 17 4", "3 x", "0 4", "-1 4", "5 5", "3,17", "3 4294967296"] {
            assert_eq!(ends(line), None, "{line}");
        }
    }
}
