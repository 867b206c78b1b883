//! Claims of the two papers, as data: `experiments/claims.toml`.

mod expression;
mod number;
mod predicate;

use serde::Deserialize;

pub use expression::{Expression, ExpressionError, Factor};
pub use number::{AtPrice, Number};
pub use predicate::{Direction, Finding, MeshNumber, Predicate};

use crate::paper::{Paper, Table, TableKind};

/// The text of `experiments/claims.toml`.
const TEXT: &str = include_str!("../../../experiments/claims.toml");

/// Kind of number that a claim is about; each is comparable under other conditions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ClaimKind {
    /// Counts, which do not depend on the machine.
    MachineFree,
    /// Times divided by times of the same folder of results.
    Ratio,
    /// Growth with size.
    Exponent,
    /// Seconds of the papers' machines: never judged.
    Seconds,
}

impl ClaimKind {
    /// Returns the name in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::MachineFree => "machine-free",
            Self::Ratio => "ratio",
            Self::Exponent => "exponent",
            Self::Seconds => "seconds",
        }
    }
}

/// Part that must be the paper's own for a claim to be judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Need {
    /// Sizes: the scale must be `full`.
    PaperSize,
}

/// Origin of the limits of a test.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LimitOrigin {
    /// Printed as a limit, in the text or in a definition.
    Paper,
    /// Printed, with half a unit of its last digit.
    Rounding,
    /// The words of the claim: faster, more, grows.
    Definition,
    /// A round factor of ours, the same for all claims of its sort.
    Convention,
    /// The strictest round limit that the paper's own numbers pass.
    Fitted,
}

impl LimitOrigin {
    /// Returns the name in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Rounding => "rounding",
            Self::Definition => "definition",
            Self::Convention => "convention",
            Self::Fitted => "fitted",
        }
    }
}

/// Cause of a difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cause {
    /// The mesh is not the paper's of that name.
    Mesh,
    /// The meshes were simplified by another program.
    Simplifier,
    /// The mesh has the counts of the paper's scan, not its shape.
    StandIn,
    /// The claim is about an implementation, and ours is another.
    Implementation,
    /// The claim is about a machine.
    Machine,
    /// The meshes were made smaller than the papers'. No claim names it: records have it.
    #[serde(skip)]
    Scale,
    /// Unknown.
    Unknown,
}

impl Cause {
    /// All of them, in the order of the page.
    pub const ALL: [Self; 7] = [
        Self::Mesh,
        Self::Simplifier,
        Self::StandIn,
        Self::Implementation,
        Self::Machine,
        Self::Scale,
        Self::Unknown,
    ];

    /// Returns the name in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mesh => "mesh",
            Self::Simplifier => "simplifier",
            Self::StandIn => "stand-in",
            Self::Implementation => "implementation",
            Self::Machine => "machine",
            Self::Scale => "scale",
            Self::Unknown => "unknown",
        }
    }
}

/// A claim that a paper makes, with the test of it.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Claim {
    /// Short name, unique.
    pub id: String,
    /// The claim, in other words than the paper's.
    pub statement: String,
    /// Section, table or figure.
    pub source: String,
    /// Kind of number that it is about.
    pub kind: ClaimKind,
    /// The paper, whose experiment has the records.
    pub experiment: Paper,
    /// Groups of the paper, or names of meshes.
    pub meshes: Vec<String>,
    /// True if it stands for a claim about every mesh; `{mesh}` is its name then.
    #[serde(default)]
    pub each: bool,
    /// The number that is tested on each mesh.
    pub value: Expression,
    /// The test.
    pub predicate: Predicate,
    /// Origin of the limits of the test.
    pub limit: LimitOrigin,
    /// The paper's numbers as it prints them, where they are not in its tables.
    #[serde(default)]
    pub paper: String,
    /// Parts that must be the paper's own.
    #[serde(default)]
    pub needs: Vec<Need>,
    /// The theorem or definition from which it follows.
    #[serde(default)]
    pub by_construction: Option<String>,
    /// Cause of a difference.
    #[serde(default)]
    pub cause: Option<Cause>,
    /// Evidence for this cause.
    #[serde(default)]
    pub evidence: String,
    /// The contradiction in the paper itself.
    #[serde(default)]
    pub inconsistent: Option<String>,
}

/// Content of the file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ClaimsFile {
    claim: Vec<Claim>,
}

/// Returns every claim, in the order of the papers.
///
/// # Panics
/// If the file, which is a part of the program, is not what it should be.
pub fn all() -> Vec<Claim> {
    parse(TEXT).unwrap_or_else(|error| panic!("experiments/claims.toml: {error}"))
}

/// Reads a file of claims.
///
/// # Errors
/// It is not TOML, or has a field that no claim has.
pub fn parse(text: &str) -> Result<Vec<Claim>, toml::de::Error> {
    let claims = toml::from_str::<ClaimsFile>(text)?.claim;
    Ok(claims.into_iter().flat_map(Claim::one_by_one).collect())
}

impl Claim {
    /// Returns a claim for each mesh if that is meant, else the claim as it is.
    fn one_by_one(self) -> Vec<Self> {
        if !self.each {
            return vec![self];
        }
        let one = |mesh: String| Self {
            id: format!("{}-{mesh}", self.id),
            statement: self.statement.replace("{mesh}", mesh.trim_start_matches("ir-")),
            meshes: vec![mesh],
            ..self.clone()
        };
        self.mesh_names().into_iter().map(one).collect()
    }

    /// Returns whether it is about times, so that runs must not have disturbed each other.
    pub fn is_about_times(&self) -> bool {
        let along = self.predicate.along();
        self.value.is_about_times() || along.is_some_and(Expression::is_about_times)
    }

    /// Returns the names of its meshes, groups replaced by the meshes of their printed table.
    pub fn mesh_names(&self) -> Vec<String> {
        let names_of = |name: &String| {
            let mut tables = Table::of_kind(self.experiment, TableKind::Meshes);
            match tables.find(|table| table.group == name) {
                Some(table) => table.mesh_rows().into_iter().map(|row| row.mesh).collect(),
                None => vec![name.clone()],
            }
        };
        self.meshes.iter().flat_map(names_of).collect()
    }
}
