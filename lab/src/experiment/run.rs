//! Executes a plan: every run a process, every process a row, nothing done twice.

use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::command_line::{arguments, command};
use super::completion::complete;
use super::estimate::run_seconds;
use super::journal::Journal;
use super::machine::{self, hash_of_words};
use super::measured::Measured;
use super::plan::{Block, Plan, PlannedRun};
use super::planned_mesh::{PlannedMesh, Source};
use super::process::{self, Ending};
use super::record::{Outcome, RunRecord, SCHEMA};
use super::spec::Limits;
use crate::meshes::paper::{PaperMesh, Scale};
use triquad::clock::Clock;

/// Settings of runs.
#[derive(Clone, Debug)]
pub struct Runner {
    /// The `triquad` that is run.
    pub program: PathBuf,
    /// Hash of it; other builds have others.
    pub program_hash: String,
    /// Name of this machine in records.
    pub machine: String,
    /// Folder for made meshes while they are used.
    pub workshop: PathBuf,
    /// Folder for meshes that take long to make.
    pub cache: Option<PathBuf>,
    /// Runs at the same time.
    pub jobs: u32,
}

/// Receives progress events.
pub trait RunObserver: Sync {
    /// Called once before anything runs, with the seconds that all open runs may take.
    fn begin(&self, _runs: usize, _seconds: f64) {}
    /// Called before a mesh is made or read.
    fn preparing(&self, _mesh: &PlannedMesh) {}
    /// Called before a run.
    fn running(&self, _block: &Block, _run: &PlannedRun) {}
    /// Called after a run; `estimate` was its part of the seconds of `begin`.
    fn finished(&self, _record: &RunRecord, _estimate: f64) {}
    /// Called when all runs of a block have their rows.
    ///
    /// # Errors
    /// What was to be written could not be written; nothing more is run.
    fn block_done(&self, _journal: &Journal) -> io::Result<()> {
        Ok(())
    }
    /// Called when all runs on a mesh have their rows.
    fn mesh_done(&self, _mesh: &PlannedMesh, _journal: &Journal) {}
}

/// Why a run has no mesh.
#[derive(Clone, Debug, thiserror::Error)]
enum MeshFileError {
    #[error("the mesh could not be made: {0}")]
    Make(String),
    #[error("{} cannot be read: {problem}", path.display())]
    Read { path: PathBuf, problem: String },
}

/// A mesh file and its hash.
struct MeshFile {
    path: PathBuf,
    sha256: String,
}

/// The mesh of the current block.
struct AtHand {
    mesh: PlannedMesh,
    file: Result<MeshFile, MeshFileError>,
}

impl Runner {
    /// Executes what of `plan` has no row in `journal` yet.
    ///
    /// # Errors
    /// A row cannot be written. What goes wrong in a run is in its row.
    pub fn execute(
        &self,
        plan: &Plan,
        journal: &mut Journal,
        clock: &(impl Clock + Sync),
        observer: &dyn RunObserver,
    ) -> io::Result<()> {
        journal.note_plan(plan.rows())?;
        let (runs, seconds) = self.left(plan, journal);
        observer.begin(runs, seconds);
        let journal = Mutex::new(journal);
        let mut at_hand: Option<AtHand> = None;
        for block in &plan.blocks {
            let open = self.open_runs(block, &lock(&journal));
            if open.is_empty() {
                continue;
            }
            if at_hand.as_ref().is_none_or(|at_hand| at_hand.mesh != block.mesh) {
                self.leave(at_hand.take(), &lock(&journal), observer);
                observer.preparing(&block.mesh);
                let file = self.prepare(&block.mesh, block.limits);
                at_hand = Some(AtHand { mesh: block.mesh.clone(), file });
            }
            match &at_hand.as_ref().expect("it has just been put there").file {
                Err(error) => {
                    for run in open {
                        let mut record = self.planned_record(block, run);
                        (record.outcome, record.reason) = (Outcome::Crash, error.to_string());
                        lock(&journal).append(record)?;
                    }
                }
                Ok(file) => self.run_block(block, file, &open, &journal, clock, observer)?,
            }
            observer.block_done(&lock(&journal))?;
        }
        self.leave(at_hand, &lock(&journal), observer);
        Ok(())
    }

    /// Returns how many runs have no row, and the seconds that they may take.
    fn left(&self, plan: &Plan, journal: &Journal) -> (usize, f64) {
        let (mut runs, mut seconds) = (0, 0.0);
        for block in &plan.blocks {
            for run in self.open_runs(block, journal) {
                runs += 1;
                seconds += run_seconds(&block.mesh, run);
            }
        }
        (runs, seconds)
    }

    fn open_runs<'b>(&self, block: &'b Block, journal: &Journal) -> Vec<&'b PlannedRun> {
        block.runs.iter().filter(|run| !journal.has(&self.key(block, run))).collect()
    }

    /// Runs what is open in a block, `jobs` at a time.
    fn run_block(
        &self,
        block: &Block,
        file: &MeshFile,
        open: &[&PlannedRun],
        journal: &Mutex<&mut Journal>,
        clock: &(impl Clock + Sync),
        observer: &dyn RunObserver,
    ) -> io::Result<()> {
        let queue = Mutex::new(open.iter());
        let work = || -> io::Result<()> {
            loop {
                let Some(run) = lock(&queue).next() else { return Ok(()) };
                let mut record = self.planned_record(block, run);
                record.mesh_sha256.clone_from(&file.sha256);
                let record = match too_slow(&record, &lock(journal)) {
                    Some(reason) => RunRecord { outcome: Outcome::Skipped, reason, ..record },
                    None => {
                        observer.running(block, run);
                        self.run_process(record, block, run, &file.path, clock)?
                    }
                };
                observer.finished(&record, run_seconds(&block.mesh, run));
                lock(journal).append(record)?;
            }
        };
        std::thread::scope(|scope| {
            let workers: Vec<_> = (0..self.jobs).map(|_| scope.spawn(work)).collect();
            workers.into_iter().try_for_each(|worker| worker.join().expect("a worker panicked"))
        })
    }

    fn run_process(
        &self,
        record: RunRecord,
        block: &Block,
        run: &PlannedRun,
        mesh_file: &Path,
        clock: &(impl Clock + Sync),
    ) -> io::Result<RunRecord> {
        let arguments = arguments(mesh_file, run);
        let (ending, process_seconds) =
            clock.time(|| process::run(&self.program, &arguments, block.limits));
        Ok(complete(RunRecord { process_seconds, ..record }, ending?, &block.mesh))
    }

    /// Returns the record of a run before it begins.
    fn planned_record(&self, block: &Block, run: &PlannedRun) -> RunRecord {
        RunRecord {
            key: self.key(block, run),
            id: block.run_id(run),
            mesh_kind: block.mesh.kind(),
            repetition: block.repetition,
            seed: run.seed,
            parallel_jobs: self.jobs,
            program: machine::program(),
            machine: self.machine.clone(),
            command: command(&block.mesh, run),
            measured: Measured {
                vertices: Some(block.mesh.vertices.into()),
                triangles: Some(block.mesh.triangles.into()),
                genus: Some(block.mesh.genus.into()),
                ..Measured::default()
            },
            ..RunRecord::default()
        }
    }

    /// Returns the key of a run; runs with equal keys are interchangeable.
    fn key(&self, block: &Block, run: &PlannedRun) -> String {
        let mesh = match &block.mesh.source {
            Source::File(_, sha256) => sha256.clone(),
            // The program fixes its bytes.
            Source::Made(made, _) => made.recipe.key(),
        };
        let stop = run.stop_after_paths.map_or(String::new(), |paths| paths.to_string());
        hash_of_words(&[
            SCHEMA,
            &self.program_hash,
            &block.id.experiment,
            block.id.scale.id(),
            &block.id.group,
            &block.id.name,
            &mesh,
            &run.job.name(),
            &block.repetition.to_string(),
            &run.seed.to_string(),
            &stop,
            &block.limits.timeout_seconds.to_string(),
            &block.limits.memory_gigabytes.to_string(),
        ])
    }

    /// Makes the mesh if it has no file yet, and hashes the file.
    fn prepare(&self, mesh: &PlannedMesh, limits: Limits) -> Result<MeshFile, MeshFileError> {
        let path = match &mesh.source {
            Source::File(path, _) => path.clone(),
            Source::Made(made, scale) => self.make(made, *scale, limits)?,
        };
        match machine::hash_of_file(&path) {
            Ok(sha256) => Ok(MeshFile { path, sha256 }),
            Err(error) => Err(MeshFileError::Read { path, problem: error.to_string() }),
        }
    }

    /// Makes a mesh in a process of its own.
    fn make(
        &self,
        made: &PaperMesh,
        scale: Scale,
        limits: Limits,
    ) -> Result<PathBuf, MeshFileError> {
        let failure = |error: io::Error| MeshFileError::Make(error.to_string());
        std::fs::create_dir_all(&self.workshop).map_err(failure)?;
        let path = self.workshop.join(format!("{}-{}.ply", made.name, scale.id()));
        let words = ["generate", "paper", made.name, "--scale", scale.id(), "-o"];
        let mut arguments: Vec<OsString> = words.map(Into::into).into();
        arguments.push(path.clone().into());
        if let Some(cache) = &self.cache {
            arguments.extend(["--cache".into(), cache.into()]);
        }
        match process::run(&self.program, &arguments, limits).map_err(failure)? {
            Ending { outcome: Outcome::Ok, .. } => Ok(path),
            Ending { reason, .. } => Err(MeshFileError::Make(reason)),
        }
    }

    /// Removes a mesh that was made and is no longer needed.
    fn leave(&self, at_hand: Option<AtHand>, journal: &Journal, observer: &dyn RunObserver) {
        let Some(AtHand { mesh, file }) = at_hand else { return };
        if let (Source::Made(..), Ok(MeshFile { path, .. })) = (&mesh.source, file) {
            // What stays behind is replaced the next time.
            let _ = std::fs::remove_file(path);
            let _ = std::fs::remove_dir(&self.workshop);
        }
        observer.mesh_done(&mesh, journal);
    }
}

/// Returns why a run is skipped: its job timed out on a smaller mesh.
fn too_slow(run: &RunRecord, journal: &Journal) -> Option<String> {
    let smaller = journal.timed_out_below(&run.id, run.measured.triangles?)?;
    Some(format!("it timed out on {}, which is smaller", smaller.id.mesh.name))
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::spec::Experiment;
    use triquad::clock::SteppingClock;

    const EXPERIMENT: &str = r#"
        name = "tiny"
        title = ""
        task = "convert"
        seed = 3
        [limits]
        timeout_seconds = 9
        memory_gigabytes = 1
        [[group]]
        name = "scans"
        meshes = ["botijo"]
        [[group.run]]
        algorithms = ["sg", "ps", "lrs", "ds"]
        augmentations = ["tarjan"]
        repetitions = { full = 2, small = 2, demo = 2 }
    "#;

    /// A `triquad` with an answer for everything; DS fails its check.
    const PROGRAM: &str = r#"#!/bin/sh
        if [ "$1" = generate ]; then
            while [ "$1" != -o ]; do shift; done
            echo mesh > "$2"
            exit
        fi
        case "$4" in
            ds) echo "the result failed its check" >&2; exit 1 ;;
            lrs) unpaired=4 ;;
            *) unpaired=12 ;;
        esac
        echo '{"vertices": 200, "edges": 600, "triangles": 400, "genus": 1, "components": 1,'
        echo '"unpaired_triangles": '$unpaired', "pairing_seconds": 0.5,'
        echo '"augmentation_seconds": 0.25}'
    "#;

    /// What is written down is what was answered, byte for byte, under a scripted clock.
    #[cfg(unix)]
    #[test]
    fn the_records_of_scripted_runs_are_what_they_were() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let program = folder.path().join("scripted");
        std::fs::write(&program, PROGRAM).unwrap();
        std::fs::set_permissions(&program, std::fs::Permissions::from_mode(0o755)).unwrap();
        let runner = Runner {
            program,
            program_hash: "fixed".into(),
            machine: "here".into(),
            workshop: folder.path().join("meshes"),
            cache: None,
            jobs: 1,
        };
        let experiment: Experiment = toml::from_str(EXPERIMENT).unwrap();
        let plan = Plan::new(&[experiment], Scale::Demo, &[]).unwrap();
        let mut journal = Journal::open(&folder.path().join("out")).unwrap();
        struct Silent;
        impl RunObserver for Silent {}
        runner.execute(&plan, &mut journal, &SteppingClock::new(0.25), &Silent).unwrap();
        let rows = std::fs::read_to_string(folder.path().join("out/runs.csv")).unwrap();
        let rows = rows.replace(&machine::program(), "this program");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/scripted_runs.csv");
        let golden = std::fs::read_to_string(path).unwrap_or_default();
        assert!(rows == golden, "the rows are now:\n{rows}");
    }
}
