//! Notes before reading, and limits of what can be concluded.

use triquad::counted::counted;

use super::parts::Parts;
use super::topic::Topic;
use crate::report::notes::Note;
use crate::report::summary::{Cell, Summary};

/// Returns what must be known before anything is read.
pub fn warnings(parts: &Parts, defects: &[String]) -> Vec<String> {
    if parts.results.records.is_empty() {
        return vec!["there is no record of any run; everything below is empty.".into()];
    }
    let notes = Note::on(parts.summary.cells().iter());
    let scales = notes.iter().filter(|note| matches!(note, Note::Scale(_)));
    let mut warnings: Vec<String> = scales.map(Note::sentence).collect();
    if !defects.is_empty() {
        let things = counted(defects.len(), "thing is", "things are");
        warnings.push(format!("{things} missing or damaged: see the list below."));
    }
    warnings
}

/// Returns what cannot be concluded. Of what concerns the papers alone, own results have nothing.
pub fn limits(summary: &Summary, topic: &Topic) -> Vec<String> {
    let is_ds = |cell: &Cell| cell.id.job.algorithm() == "ds";
    let is_paper = !topic.is_own();
    let sentences = [
        (
            true,
            "Seconds of different machines are shown beside each other and not compared: counts \
             are, and ratios of times within one machine.",
        ),
        (
            is_paper || summary.cells().iter().any(is_ds),
            "DS follows the idea of Diks and Stanczyk; their full text was not at hand.",
        ),
        (
            is_paper,
            "The papers print counts of their box, and no proportions. docs/meshes.md derives \
             from these counts the box that triquad generate paper makes, and separates proof \
             from inference. How the papers simplified it is not known: counts hinge on both. \
             The edition of the meshes of older records may be another.",
        ),
        (
            true,
            "A difference between two means is as certain as the spread of their runs is small: \
             the tables have quartiles, the verdicts a bootstrap.",
        ),
    ];
    let said = sentences.into_iter().filter(|(applies, _)| *applies);
    let notes = Note::on(summary.cells().iter());
    let shared = notes.iter().filter(|note| !matches!(note, Note::Scale(_) | Note::Incomplete));
    said.map(|(_, sentence)| sentence.to_owned()).chain(shared.map(Note::sentence)).collect()
}
