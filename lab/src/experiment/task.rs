//! The two tasks: what every run of an experiment makes of its meshes.

use serde::Deserialize;

/// Task of the runs of an experiment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Task {
    /// Quadrangulations.
    Convert,
    /// Irreducible triangulations.
    Irreducible,
}

impl Task {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Convert, Self::Irreducible];

    /// Returns the name in experiment files, which is the verb on the command line.
    pub fn id(self) -> &'static str {
        match self {
            Self::Convert => "convert",
            Self::Irreducible => "irreducible",
        }
    }
}
