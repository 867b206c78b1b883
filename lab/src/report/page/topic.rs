//! Topic of the page: the papers' experiments, or somebody's own.

use crate::report::summary::Summary;

/// Topic of the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Topic {
    /// Our algorithms in the papers' experiments.
    Papers,
    /// Anything else: names of experiments, and of algorithms whose results were imported.
    Own(Vec<String>),
}

impl Topic {
    /// Returns the topic of these records; without any, it is the papers. O(cells · names).
    pub fn of(summary: &Summary) -> Self {
        if !summary.is_own() {
            return Self::Papers;
        }
        let mut names: Vec<String> = Vec::new();
        for cell in summary.cells() {
            let name = match cell.was_imported() {
                true => cell.id.job.facts().label,
                false => &cell.id.mesh.experiment,
            };
            if names.iter().all(|other| other != name) {
                names.push(name.into());
            }
        }
        Self::Own(names)
    }

    /// Returns the title of the page.
    pub fn title(&self) -> String {
        match self {
            Self::Papers => "Two papers on triangulations, run again".into(),
            Self::Own(names) => format!("Results: {}", names.join(", ")),
        }
    }

    /// Returns whether the papers' numbers are but a supplement.
    pub fn is_own(&self) -> bool {
        matches!(self, Self::Own(_))
    }
}
