//! From the end of a run's process to its record.

use super::measured::RunStats;
use super::planned_mesh::PlannedMesh;
use super::process::Ending;
use super::record::{Outcome, RunRecord};

/// Completes the record of a run by how it ended and what it measured.
pub(super) fn complete(record: RunRecord, ending: Ending, mesh: &PlannedMesh) -> RunRecord {
    let Ending { outcome, reason, output, .. } = ending;
    if outcome != Outcome::Ok {
        return RunRecord { outcome, reason, ..record };
    }
    let RunStats { stopped_after_paths, measured } = match serde_json::from_slice(&output) {
        Ok(stats) => stats,
        Err(error) => {
            let reason = format!("its statistics cannot be read: {error}");
            return RunRecord { outcome: Outcome::Crash, reason, ..record };
        }
    };
    let counts = [measured.vertices, measured.triangles, measured.genus];
    let record = RunRecord { stopped_after_paths, measured, ..record };
    if counts == [mesh.vertices, mesh.triangles, mesh.genus].map(|count| Some(count.into())) {
        return RunRecord { outcome, reason, ..record };
    }
    let reason = "its mesh has other counts than were planned".into();
    RunRecord { outcome: Outcome::Invalid, reason, ..record }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::planned_mesh::Source;
    use crate::meshes::paper::{self, Scale};

    fn completed(output: &str) -> RunRecord {
        let made = paper::named("A5").unwrap();
        let (vertices, triangles) = (made.vertices, made.triangles());
        let source = Source::Made(made, Scale::Full);
        let mesh = PlannedMesh { name: "A5".into(), vertices, triangles, genus: 0, source };
        let ending = Ending {
            outcome: Outcome::Ok,
            reason: String::new(),
            output: output.into(),
            peak_memory_bytes: None,
        };
        complete(RunRecord { seed: 7, ..RunRecord::default() }, ending, &mesh)
    }

    #[test]
    fn a_record_takes_the_numbers_of_the_run_and_keeps_what_it_was_asked() {
        let record = completed(
            r#"{"vertices": 172354, "triangles": 344704, "genus": 0, "pairing_seconds": 0.25,
                "unpaired_triangles": 8, "seed": 9, "algorithm": "xx", "input": "A5.ply",
                "stopped_after_paths": 3}"#,
        );
        assert!(record.is_ok(), "{}", record.reason);
        let measured = &record.measured;
        assert_eq!((measured.pairing_seconds, measured.unpaired_triangles), (Some(0.25), Some(8)));
        assert_eq!((record.id.job, record.seed), (RunRecord::default().id.job, 7));
        assert_eq!(record.stopped_after_paths, Some(3));
    }

    #[test]
    fn another_mesh_or_no_record_is_no_result() {
        let other = completed(r#"{"vertices": 172354, "triangles": 344704, "genus": 1}"#);
        assert_eq!(other.outcome, Outcome::Invalid);
        assert_eq!(completed("half").outcome, Outcome::Crash);
        assert_eq!(completed(r#"{"vertices": "many"}"#).outcome, Outcome::Crash);
    }
}
