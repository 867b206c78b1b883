//! Executes a plan: every run a process, every process a row, nothing done twice.

use std::collections::HashMap;
use std::io;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use super::command_line::command;
use super::estimate::run_seconds;
use super::external::{Installed, NotInstalledError, ProgramRun};
use super::journal::Journal;
use super::machine::{self, hash_of_words};
use super::measured::Measured;
use super::own_run::OwnRun;
use super::plan::{Block, Plan, PlannedRun};
use super::planned_mesh::{PlannedMesh, Source};
use super::program_spec::ProgramFormat;
use super::record::{Outcome, RunRecord, SCHEMA};
use super::workshop::{AtHand, MeshFile, Workshop};
use crate::whole_file;
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

/// The runs that are to be done.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OpenRuns {
    /// Number of all.
    pub runs: usize,
    /// Number of those of external programs.
    pub external: usize,
    /// Seconds that the others may take.
    pub seconds: f64,
}

/// Receives progress events.
pub trait RunObserver: Sync {
    /// Called once before anything runs.
    fn begin(&self, _open: OpenRuns) {}
    /// Called before a mesh is made or read.
    fn preparing(&self, _mesh: &PlannedMesh) {}
    /// Called before a run.
    fn running(&self, _block: &Block, _run: &PlannedRun) {}
    /// Called after a run; `estimate` was its part of the seconds of `begin`, `None` for an
    /// external program.
    fn finished(&self, _record: &RunRecord, _estimate: Option<f64>) {}
    /// Called when all runs of a block have their rows.
    ///
    /// # Errors
    /// What was to be written could not be written; nothing more is run.
    fn block_done(&self, _journal: &Journal) -> io::Result<()> {
        Ok(())
    }
    /// Called when all runs on a mesh, of which `block` is the last, have their rows.
    fn mesh_done(&self, _block: &Block) {}
}

/// Age at which a temporary file in the cache, which others may be writing, is a leftover.
const LEFT_IN_CACHE: Duration = Duration::from_secs(24 * 60 * 60);

/// Shared state while a plan is executed.
struct Execution<'a, C> {
    runner: &'a Runner,
    programs: Programs,
    journal: Mutex<&'a mut Journal>,
    clock: &'a C,
    observer: &'a dyn RunObserver,
}

/// The programs that are not ours, by experiment and name.
type Programs = HashMap<(String, String), Result<Installed, NotInstalledError>>;

impl Runner {
    /// Executes what of `plan` is not done according to `journal`.
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
        let workshop = Workshop::new(self);
        workshop.clear(plan.blocks.iter().map(|block| &block.mesh));
        if let Some(cache) = &self.cache {
            whole_file::remove_leftovers(cache, LEFT_IN_CACHE);
        }
        let programs = self.find_programs(plan);
        let journal = Mutex::new(journal);
        Execution { runner: self, programs, journal, clock, observer }.all(plan, &workshop)
    }

    fn find_programs(&self, plan: &Plan) -> Programs {
        let mut programs = Programs::new();
        for block in &plan.blocks {
            for program in block.programs.iter() {
                let place = (block.id.experiment.clone(), program.name.clone());
                programs.entry(place).or_insert_with(|| Installed::find(program, &self.program));
            }
        }
        programs
    }
}

impl<C: Clock + Sync> Execution<'_, C> {
    fn all(&self, plan: &Plan, workshop: &Workshop) -> io::Result<()> {
        self.observer.begin(self.left(plan));
        let mut at_hand: Option<AtHand> = None;
        let mut last: Option<&Block> = None;
        for block in &plan.blocks {
            let open = self.open_runs(block);
            if open.is_empty() {
                continue;
            }
            if at_hand.as_ref().is_none_or(|at_hand| at_hand.mesh != block.mesh) {
                self.leave(at_hand.take(), last, workshop);
                self.observer.preparing(&block.mesh);
                at_hand = Some(workshop.prepare(&block.mesh, block.limits));
            }
            match &at_hand.as_ref().expect("it has just been put there").file {
                Err(error) => {
                    for run in open {
                        let (outcome, reason) = (Outcome::Crash, error.to_string());
                        let planned = self.planned_record(block, run);
                        self.finish(block, run, RunRecord { outcome, reason, ..planned })?;
                    }
                }
                Ok(file) => self.run_block(block, file, workshop, &open)?,
            }
            self.observer.block_done(&lock(&self.journal))?;
            last = Some(block);
        }
        self.leave(at_hand, last, workshop);
        Ok(())
    }

    fn left(&self, plan: &Plan) -> OpenRuns {
        let mut open = OpenRuns::default();
        for block in &plan.blocks {
            for run in self.open_runs(block) {
                open.runs += 1;
                match run_seconds(&block.mesh, run) {
                    Some(seconds) => open.seconds += seconds,
                    None => open.external += 1,
                }
            }
        }
        open
    }

    fn open_runs<'b>(&self, block: &'b Block) -> Vec<&'b PlannedRun> {
        let journal = lock(&self.journal);
        let is_open = |run: &&PlannedRun| {
            let (key, id) = (self.key(block, run), block.run_id(run));
            !journal.is_done(&key, &id, block.mesh.triangles.into())
        };
        block.runs.iter().filter(is_open).collect()
    }

    /// Runs what is open in a block, `jobs` at a time.
    fn run_block(
        &self,
        block: &Block,
        file: &MeshFile,
        workshop: &Workshop,
        open: &[&PlannedRun],
    ) -> io::Result<()> {
        let queue = Mutex::new(open.iter());
        let work = || -> io::Result<()> {
            loop {
                let Some(run) = lock(&queue).next() else { return Ok(()) };
                let planned = self.planned_record(block, run);
                let planned = RunRecord { mesh_sha256: file.sha256.clone(), ..planned };
                let record = match self.why_skipped(&planned, block, run) {
                    Some(reason) => RunRecord { outcome: Outcome::Skipped, reason, ..planned },
                    None => {
                        self.observer.running(block, run);
                        self.run_process(planned, block, run, file, workshop)?
                    }
                };
                self.finish(block, run, record)?;
            }
        };
        std::thread::scope(|scope| {
            // Those that the system does not grant are done without.
            let start = |_| std::thread::Builder::new().spawn_scoped(scope, work).ok();
            let helpers: Vec<_> = (1..self.runner.jobs).filter_map(start).collect();
            let here = work();
            let others = helpers.into_iter().map(|helper| helper.join().expect("it panicked"));
            others.fold(here, io::Result::and)
        })
    }

    /// Notes how a run ended.
    fn finish(&self, block: &Block, run: &PlannedRun, record: RunRecord) -> io::Result<()> {
        self.observer.finished(&record, run_seconds(&block.mesh, run));
        lock(&self.journal).append(record)
    }

    fn run_process(
        &self,
        record: RunRecord,
        block: &Block,
        run: &PlannedRun,
        file: &MeshFile,
        workshop: &Workshop,
    ) -> io::Result<RunRecord> {
        let program = block.program(run.job);
        let format = match program {
            Some(program) => Some(program.format),
            None => block.leaves_file(run).then(ProgramFormat::default),
        };
        let mesh = match format.map(|format| workshop.in_format(&file.path, format)) {
            None => file.path.clone(),
            Some(Ok(mesh)) => mesh,
            Some(Err(error)) => {
                let (outcome, reason) = (Outcome::Crash, error.to_string());
                return Ok(RunRecord { outcome, reason, ..record });
            }
        };
        let (ours, mesh, workshop) = (self.runner.program.as_path(), &*mesh, workshop.folder());
        let limits = block.limits;
        match program {
            Some(spec) => {
                ProgramRun { spec, ours, mesh, workshop, limits }.execute(record, self.clock)
            }
            None => OwnRun { ours, block, run, mesh, workshop }.execute(record, self.clock),
        }
    }

    /// Returns why a run is skipped: its program is not installed, or its job timed out on a
    /// smaller mesh.
    fn why_skipped(&self, run: &RunRecord, block: &Block, planned: &PlannedRun) -> Option<String> {
        if let Some(Err(error)) = self.installed(block, planned) {
            return Some(error.to_string());
        }
        let journal = lock(&self.journal);
        let smaller = journal.timed_out_below(&run.id, run.measured.triangles?)?;
        Some(format!("it timed out on {}, which is smaller", smaller.id.mesh.name))
    }

    fn installed(
        &self,
        block: &Block,
        run: &PlannedRun,
    ) -> Option<&Result<Installed, NotInstalledError>> {
        let program = block.program(run.job)?;
        self.programs.get(&(block.id.experiment.clone(), program.name.clone()))
    }

    /// Returns the record of a run before it begins.
    fn planned_record(&self, block: &Block, run: &PlannedRun) -> RunRecord {
        let program = match self.installed(block, run) {
            None => machine::program(),
            Some(Ok(installed)) => installed.version.clone(),
            Some(Err(_)) => String::new(),
        };
        RunRecord {
            key: self.key(block, run),
            id: block.run_id(run),
            mesh_kind: block.mesh.kind(),
            repetition: block.repetition,
            seed: run.seed,
            parallel_jobs: self.runner.jobs,
            program,
            machine: self.runner.machine.clone(),
            command: command(block, run),
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
        let how = match run.stop_after_paths {
            Some(paths) => paths.to_string(),
            None if block.leaves_file(run) => "measured from its file".into(),
            None => String::new(),
        };
        let program = match self.installed(block, run) {
            None => &self.runner.program_hash,
            Some(Ok(installed)) => &installed.hash,
            Some(Err(_)) => "not installed",
        };
        hash_of_words(&[
            SCHEMA,
            program,
            &block.id.experiment,
            block.id.scale.id(),
            &block.id.group,
            &block.id.name,
            &mesh,
            &run.job.name(),
            &block.repetition.to_string(),
            &run.seed.to_string(),
            &how,
            &block.limits.timeout_seconds.to_string(),
            &block.limits.memory_gigabytes.to_string(),
        ])
    }

    /// Removes a mesh that is no longer needed; `last` is its last block.
    fn leave(&self, at_hand: Option<AtHand>, last: Option<&Block>, workshop: &Workshop) {
        if let Some((AtHand { mesh, .. }, last)) = at_hand.zip(last) {
            workshop.clear([&mesh]);
            self.observer.mesh_done(last);
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::experiment::spec::Experiment;
    use crate::meshes::paper::Scale;
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
