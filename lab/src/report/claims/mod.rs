//! What the two papers claim, as data: `experiments/claims.toml`.

mod expression;
mod number;
mod predicate;

use serde::Deserialize;

pub use expression::{Expression, Factor, ParseError};
pub use number::Number;
pub use predicate::{Direction, Point, Predicate, Test};

use super::paper::Table;

/// The text of `experiments/claims.toml`.
const TEXT: &str = include_str!("../../../experiments/claims.toml");

/// What kind of number a claim is about; each is comparable under other conditions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Counts, which do not depend on the machine.
    MachineFree,
    /// Times divided by times of the same folder of results.
    Ratio,
    /// Growth with size.
    Exponent,
    /// Seconds of the papers' machines: never judged.
    Seconds,
}

impl Kind {
    /// As in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::MachineFree => "machine-free",
            Self::Ratio => "ratio",
            Self::Exponent => "exponent",
            Self::Seconds => "seconds",
        }
    }
}

/// What must be the paper's own for a claim to be judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Need {
    /// Sizes: the scale must be `full`.
    PaperSize,
    /// The mesh itself: no stand-ins.
    PaperMesh,
}

/// A claim that a paper makes, with the test that says whether it holds.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Claim {
    /// Short name, unique.
    pub id: String,
    /// The claim, in other words than the paper's.
    pub statement: String,
    /// Section, table or figure.
    pub source: String,
    /// What kind of number it is about.
    pub kind: Kind,
    /// `comparison` or `irreducible`.
    pub experiment: String,
    /// Groups of the experiment, or names of meshes.
    pub meshes: Vec<String>,
    /// The number that is tested on each mesh.
    pub value: Expression,
    /// The test.
    pub predicate: Predicate,
    /// The paper's numbers as it prints them, where they are not in its tables.
    #[serde(default)]
    pub paper: String,
    /// What must be the paper's own.
    #[serde(default)]
    pub needs: Vec<Need>,
    /// How the paper contradicts the claim itself.
    #[serde(default)]
    pub inconsistent: Option<String>,
}

/// The file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    claim: Vec<Claim>,
}

/// Every claim, in the order of the papers.
///
/// # Panics
/// If the file, which is a part of the program, is not what it should be.
pub fn all() -> Vec<Claim> {
    parse(TEXT).unwrap_or_else(|error| panic!("experiments/claims.toml: {error}"))
}

/// Reads a file of claims.
///
/// # Errors
/// It is not TOML, or says what no claim says.
pub fn parse(text: &str) -> Result<Vec<Claim>, toml::de::Error> {
    toml::from_str::<File>(text).map(|file| file.claim)
}

impl Claim {
    /// Whether it is about times, so that runs must not have disturbed each other.
    pub fn is_about_times(&self) -> bool {
        let along = self.predicate.along();
        self.value.is_about_times() || along.is_some_and(Expression::is_about_times)
    }

    /// The meshes it is about by name, groups replaced by the meshes of their printed table.
    pub fn mesh_names(&self) -> Vec<String> {
        let names_of = |name: &String| match printed_group(&self.experiment, name) {
            Some(table) => table.mesh_rows().into_iter().map(|row| row.mesh).collect(),
            None => vec![name.clone()],
        };
        self.meshes.iter().flat_map(names_of).collect()
    }
}

/// The table that lists the meshes of a group.
fn printed_group(experiment: &str, group: &str) -> Option<Table> {
    let number = match (experiment, group) {
        ("comparison", "scans") => "4.1",
        ("comparison", "A") => "4.2(a)",
        ("comparison", "B") => "4.2(b)",
        ("irreducible", "scans") => "2",
        ("irreducible", "B") => "3",
        ("irreducible", "C") => "4",
        ("irreducible", "D") => "5",
        _ => return None,
    };
    Table::numbered(number)
}
