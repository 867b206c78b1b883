//! From how a run ended to its record.

use serde_json::{Map, Value};

use super::plan::PlannedMesh;
use super::process::Ending;
use super::record::{Outcome, RunRecord};

/// Puts together what was known before the run and how it ended.
pub(super) fn judge(mut record: RunRecord, ending: Ending, mesh: &PlannedMesh) -> RunRecord {
    record.outcome = ending.outcome;
    record.reason = ending.reason;
    if record.outcome != Outcome::Ok {
        return record;
    }
    let mut measured = match fill(&record, &ending.output) {
        Ok(measured) => measured,
        Err(problem) => {
            return RunRecord { outcome: Outcome::Crash, reason: problem, ..record };
        }
    };
    let counts = [measured.vertices, measured.triangles, measured.genus];
    let expected = [mesh.vertices, mesh.triangles, mesh.genus].map(|count| Some(count.into()));
    if counts != expected {
        measured.outcome = Outcome::Invalid;
        measured.reason = "its mesh has other counts than were planned".into();
    }
    measured
}

/// What of the statistics in `output` records have too.
fn fill(record: &RunRecord, output: &[u8]) -> Result<RunRecord, String> {
    let stats: Map<String, Value> =
        serde_json::from_slice(output).map_err(|error| format!("it left no record: {error}"))?;
    let about_run = ["schema", "algorithm", "lrs_variant", "augmentation", "order", "seed"];
    let mut row = serde_json::to_value(record).map_err(|error| error.to_string())?;
    let fields = row.as_object_mut().ok_or("a record is an object")?;
    for (name, field) in fields.iter_mut() {
        match stats.get(name) {
            Some(value) if !about_run.contains(&&name[..]) => *field = value.clone(),
            _ => {}
        }
    }
    serde_json::from_value(row).map_err(|error| format!("its record cannot be used: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::plan::Source;
    use crate::meshes::paper::{self, Scale};

    fn mesh() -> PlannedMesh {
        let made = paper::named("A5").unwrap();
        let (vertices, triangles) = (made.vertices, made.triangles());
        let source = Source::Made(made, Scale::Full);
        PlannedMesh { name: "A5".into(), vertices, triangles, genus: 0, source }
    }

    fn judged(output: &str) -> RunRecord {
        let ending = Ending { outcome: Outcome::Ok, reason: String::new(), output: output.into() };
        judge(RunRecord { algorithm: "ps".into(), seed: 7, ..Default::default() }, ending, &mesh())
    }

    #[test]
    fn a_record_takes_the_numbers_of_the_run_and_keeps_what_it_was_asked() {
        let record = judged(
            r#"{"vertices": 172354, "triangles": 344704, "genus": 0, "pairing_seconds": 0.25,
                "unpaired_triangles": 8, "seed": 9, "algorithm": "xx", "input": "A5.ply"}"#,
        );
        assert!(record.is_ok(), "{}", record.reason);
        assert_eq!((record.pairing_seconds, record.unpaired_triangles), (Some(0.25), Some(8)));
        assert_eq!((&record.algorithm[..], record.seed), ("ps", 7));
    }

    #[test]
    fn another_mesh_or_no_record_is_no_result() {
        let other = judged(r#"{"vertices": 172354, "triangles": 344704, "genus": 1}"#);
        assert_eq!(other.outcome, Outcome::Invalid);
        assert_eq!(judged("half").outcome, Outcome::Crash);
        assert_eq!(judged(r#"{"vertices": "many"}"#).outcome, Outcome::Crash);
    }
}
