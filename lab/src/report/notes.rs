//! Notes for reading a table or plot, worded once.

use super::summary::Cell;
use crate::meshes::paper::Scale;

/// A remark on numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Note {
    /// The meshes are not of the papers' sizes.
    Scale(Scale),
    /// Some meshes are stand-ins.
    StandIn,
    /// Some times are extrapolated.
    Extrapolated,
    /// Some runs were beside others.
    Parallel,
    /// Some times are those of whole processes.
    WallClock,
    /// Some runs have no row, or one without numbers.
    Incomplete,
    /// The paper prints PS and LRS only.
    TwoOfFour,
    /// The paper's tables have no runs with another augmentation than its own.
    TarjanOnly,
    /// Ratios are between two machines.
    OtherMachine,
}

impl Note {
    /// Returns the notes that a reader of these cells needs. O(runs).
    pub fn on<'a>(cells: impl Iterator<Item = &'a Cell> + Clone) -> Vec<Self> {
        let any = |test: fn(&Cell) -> bool| cells.clone().any(test);
        let mut notes = Vec::new();
        for scale in [Scale::Small, Scale::Demo] {
            if cells.clone().any(|cell| cell.smaller_scale() == Some(scale)) {
                notes.push(Self::Scale(scale));
            }
        }
        let incomplete =
            |cell: &Cell| cell.missing() > 0 || cell.runs.iter().any(|run| !run.is_ok());
        let found = [
            (any(Cell::is_stand_in), Self::StandIn),
            (any(Cell::is_extrapolated), Self::Extrapolated),
            (any(Cell::is_parallel), Self::Parallel),
            (any(Cell::has_wall_clock_times), Self::WallClock),
            (any(incomplete), Self::Incomplete),
        ];
        notes.extend(found.into_iter().filter(|found| found.0).map(|found| found.1));
        notes
    }

    /// Returns the note in a sentence.
    pub fn sentence(&self) -> String {
        match self {
            Self::Scale(scale) => {
                return format!(
                    "Scale {}: the meshes are smaller than the papers' of the same names. Their \
                     times, and counts that depend on size, cannot be compared with the printed \
                     ones.",
                    scale.id()
                );
            }
            Self::StandIn => {
                "† At full scale a stand-in has the vertex count and genus of the paper's scan; \
                 its shape and connectivity are other ones. Compare orders of magnitude, not \
                 digits."
            }
            Self::Extrapolated => {
                "* Extrapolated: the augmentation was stopped after some of its paths. Its time is \
                 that of these paths, by rule of three for all of them."
            }
            Self::Parallel => {
                "Some runs went on beside others on the same machine: their times are neither \
                 ranked nor divided by each other."
            }
            Self::WallClock => {
                "A program that reports no time of its own has the wall-clock time of its whole \
                 process: reading, starting and writing are included."
            }
            Self::Incomplete => "Runs that are missing or did not end well: see the outcomes.",
            Self::TwoOfFour => "The paper measured SG and DS too, but does not print their rows.",
            Self::TarjanOnly => {
                "This table has runs with tarjan, the augmentation as published; \
                 table_augmentation.csv has those with local, too."
            }
            Self::OtherMachine => {
                "Seconds of the paper are of another machine and are not compared. Under a mean \
                 stand the quartiles of its runs."
            }
        }
        .into()
    }

    /// Returns the note in a few words, for plots; `None` for notes on tables only.
    pub fn legend(&self) -> Option<String> {
        Some(match self {
            Self::Scale(scale) => {
                format!("scale {}: meshes smaller than the paper's of these names", scale.id())
            }
            Self::StandIn => {
                "hollow or hatched, † : a stand-in for the paper's scan, of other shape".into()
            }
            Self::Extrapolated => "* : extrapolated from a part of the augmenting paths".into(),
            Self::Parallel => "runs went on side by side: times are not ranked".into(),
            Self::WallClock => "programs without times of their own: whole processes".into(),
            _ => return None,
        })
    }
}
