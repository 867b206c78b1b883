//! Carries out a plan: every run a process, every process a row, nothing done twice.

use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::estimate::run_seconds;
use super::journal::Journal;
use super::judge::judge;
use super::machine::{self, hash_of_words};
use super::plan::{Block, Plan, PlannedMesh, PlannedRun, Source};
use super::process::{self, Ending};
use super::record::{Outcome, RunRecord, SCHEMA};
use super::spec::Limits;
use crate::meshes::paper::Scale;
use triquad::clock::Clock;

/// How runs are carried out.
#[derive(Clone, Debug)]
pub struct Runner {
    /// The `triquad` that is run.
    pub program: PathBuf,
    /// What tells it from other builds.
    pub program_hash: String,
    /// The name of this machine in records.
    pub machine: String,
    /// Where made meshes are put while they are used.
    pub workshop: PathBuf,
    /// Where meshes are kept that take long to make.
    pub cache: Option<PathBuf>,
    /// Runs at the same time.
    pub jobs: u32,
}

/// Is told what happens.
pub trait Observer: Sync {
    /// Before anything runs: seconds that all that is left may take.
    fn begin(&self, _runs: usize, _seconds: f64) {}
    /// A mesh is made or read.
    fn preparing(&self, _mesh: &PlannedMesh) {}
    /// A run begins.
    fn running(&self, _block: &Block, _run: &PlannedRun) {}
    /// A run has its row; `estimate` was its part of the seconds told at first.
    fn finished(&self, _record: &RunRecord, _estimate: f64) {}
    /// All runs of a block have their rows.
    fn block_done(&self) -> io::Result<()> {
        Ok(())
    }
    /// All that was to be run on a mesh has its rows.
    fn mesh_done(&self, _mesh: &PlannedMesh, _journal: &Journal) {}
}

/// A mesh, and its file with that one's hash, or why there is none.
type AtHand = (PlannedMesh, Result<(PathBuf, String), String>);

/// A block whose mesh is at hand.
struct Ready<'a> {
    block: &'a Block,
    scale: Scale,
    mesh_file: PathBuf,
    mesh_hash: String,
}

impl Runner {
    /// Carries out what of `plan` has no row in `journal` yet.
    ///
    /// # Errors
    /// A row cannot be written. What goes wrong in a run is in its row.
    pub fn execute(
        &self,
        plan: &Plan,
        journal: &mut Journal,
        clock: &(impl Clock + Sync),
        observer: &dyn Observer,
    ) -> io::Result<()> {
        journal.note_plan(plan.rows())?;
        let (runs, seconds) = self.left(plan, journal);
        observer.begin(runs, seconds);
        let journal = Mutex::new(journal);
        let mut at_hand: Option<AtHand> = None;
        for block in &plan.blocks {
            let open = self.open_runs(plan.scale, block, &lock(&journal));
            if open.is_empty() {
                continue;
            }
            if at_hand.as_ref().is_none_or(|(mesh, _)| *mesh != block.mesh) {
                self.leave(at_hand.take(), &lock(&journal), observer);
                observer.preparing(&block.mesh);
                at_hand = Some((block.mesh.clone(), self.prepare(&block.mesh, block.limits)));
            }
            match &at_hand.as_ref().expect("it has just been put there").1 {
                Err(problem) => {
                    for run in open {
                        let mut record = self.identity(plan.scale, block, run);
                        record.outcome = Outcome::Crash;
                        record.reason = problem.clone();
                        lock(&journal).append(record)?;
                    }
                }
                Ok((mesh_file, mesh_hash)) => {
                    let ready = Ready {
                        block,
                        scale: plan.scale,
                        mesh_file: mesh_file.clone(),
                        mesh_hash: mesh_hash.clone(),
                    };
                    self.run_block(&ready, &open, &journal, clock, observer)?;
                }
            }
            observer.block_done()?;
        }
        self.leave(at_hand, &lock(&journal), observer);
        Ok(())
    }

    /// How many runs have no row, and how long they may take.
    fn left(&self, plan: &Plan, journal: &Journal) -> (usize, f64) {
        let (mut runs, mut seconds) = (0, 0.0);
        for block in &plan.blocks {
            for run in self.open_runs(plan.scale, block, journal) {
                runs += 1;
                seconds += run_seconds(&block.mesh, run);
            }
        }
        (runs, seconds)
    }

    fn open_runs<'b>(
        &self,
        scale: Scale,
        block: &'b Block,
        journal: &Journal,
    ) -> Vec<&'b PlannedRun> {
        let open = |run: &&PlannedRun| !journal.has(&self.identity(scale, block, run).key);
        block.runs.iter().filter(open).collect()
    }

    /// Runs what is open in a block, `jobs` at a time.
    fn run_block(
        &self,
        ready: &Ready<'_>,
        open: &[&PlannedRun],
        journal: &Mutex<&mut Journal>,
        clock: &(impl Clock + Sync),
        observer: &dyn Observer,
    ) -> io::Result<()> {
        let queue = Mutex::new(open.iter());
        let work = || -> io::Result<()> {
            loop {
                let Some(run) = lock(&queue).next() else { return Ok(()) };
                let record = self.run_one(ready, run, journal, clock, observer)?;
                observer.finished(&record, run_seconds(&ready.block.mesh, run));
                lock(journal).append(record)?;
            }
        };
        std::thread::scope(|scope| {
            let workers: Vec<_> = (0..self.jobs).map(|_| scope.spawn(work)).collect();
            workers.into_iter().try_for_each(|worker| worker.join().expect("a worker panicked"))
        })
    }

    fn run_one(
        &self,
        ready: &Ready<'_>,
        run: &PlannedRun,
        journal: &Mutex<&mut Journal>,
        clock: &(impl Clock + Sync),
        observer: &dyn Observer,
    ) -> io::Result<RunRecord> {
        let Ready { block, .. } = ready;
        let mut record = self.identity(ready.scale, block, run);
        record.mesh_sha256.clone_from(&ready.mesh_hash);
        let too_slow = lock(journal)
            .timed_out_below(&record, u64::from(block.mesh.triangles))
            .map(|smaller| smaller.mesh.clone());
        if let Some(smaller) = too_slow {
            record.outcome = Outcome::Skipped;
            record.reason = format!("it timed out on {smaller}, which is smaller");
            return Ok(record);
        }
        observer.running(block, run);
        let arguments = arguments(&ready.mesh_file, run);
        let (ending, seconds) =
            clock.time(|| process::run(&self.program, &arguments, block.limits));
        record.process_seconds = seconds;
        Ok(judge(record, ending?, &block.mesh))
    }

    /// What is known of a run before it begins.
    fn identity(&self, scale: Scale, block: &Block, run: &PlannedRun) -> RunRecord {
        let text = |name: Option<&str>| name.map(str::to_owned);
        RunRecord {
            schema: SCHEMA.into(),
            key: self.key(scale, block, run),
            experiment: block.experiment.clone(),
            scale: scale.id().into(),
            group: block.group.clone(),
            mesh: block.mesh.name.clone(),
            mesh_kind: block.mesh.kind().into(),
            algorithm: run.job.algorithm().into(),
            lrs_variant: text(run.job.lrs_variant()),
            augmentation: text(run.job.augmentation()),
            order: text(run.job.order()),
            repetition: block.repetition,
            seed: run.seed,
            parallel_jobs: self.jobs,
            program: machine::program(),
            machine: self.machine.clone(),
            command: command(&block.mesh, run),
            vertices: Some(block.mesh.vertices.into()),
            triangles: Some(block.mesh.triangles.into()),
            genus: Some(block.mesh.genus.into()),
            ..RunRecord::default()
        }
    }

    /// Equal for equal work: mesh, algorithm, parameters, seed, program.
    fn key(&self, scale: Scale, block: &Block, run: &PlannedRun) -> String {
        let mesh = match &block.mesh.source {
            Source::File(_, sha256) => sha256.clone(),
            // The program fixes its bytes.
            Source::Made(made, _) => made.recipe.key(),
        };
        let stop = run.stop_after_paths.map_or(String::new(), |paths| paths.to_string());
        hash_of_words(&[
            SCHEMA,
            &self.program_hash,
            &block.experiment,
            scale.id(),
            &block.group,
            &block.mesh.name,
            &mesh,
            &run.job.label(),
            &block.repetition.to_string(),
            &run.seed.to_string(),
            &stop,
            &block.limits.timeout_seconds.to_string(),
            &block.limits.memory_gigabytes.to_string(),
        ])
    }

    /// Makes sure that the mesh is in a file, and tells which and its hash.
    fn prepare(&self, mesh: &PlannedMesh, limits: Limits) -> Result<(PathBuf, String), String> {
        let path = match &mesh.source {
            Source::File(path, _) => path.clone(),
            Source::Made(made, scale) => self.make(mesh, made.name, *scale, limits)?,
        };
        let hash = machine::hash_of_file(&path);
        let hash = hash.map_err(|error| format!("{} cannot be read: {error}", path.display()))?;
        Ok((path, hash))
    }

    fn make(
        &self,
        mesh: &PlannedMesh,
        name: &str,
        scale: Scale,
        limits: Limits,
    ) -> Result<PathBuf, String> {
        let failure = |problem: String| format!("the mesh could not be made: {problem}");
        std::fs::create_dir_all(&self.workshop).map_err(|error| failure(error.to_string()))?;
        let path = self.workshop.join(format!("{}-{}.ply", mesh.name, scale.id()));
        let mut arguments: Vec<OsString> =
            ["generate", "paper", name, "--scale", scale.id(), "-o"].map(Into::into).into();
        arguments.push(path.clone().into());
        if let Some(cache) = &self.cache {
            arguments.extend(["--cache".into(), cache.into()]);
        }
        let ending = process::run(&self.program, &arguments, limits);
        match ending.map_err(|error| failure(error.to_string()))? {
            Ending { outcome: Outcome::Ok, .. } => Ok(path),
            Ending { reason, .. } => Err(failure(reason)),
        }
    }

    /// Removes a mesh that was made and is no longer needed.
    fn leave(&self, at_hand: Option<AtHand>, journal: &Journal, observer: &dyn Observer) {
        let Some((mesh, file)) = at_hand else { return };
        if let (Source::Made(..), Ok((path, _))) = (&mesh.source, file) {
            // What stays behind is replaced the next time.
            let _ = std::fs::remove_file(path);
            let _ = std::fs::remove_dir(&self.workshop);
        }
        observer.mesh_done(&mesh, journal);
    }
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn arguments(mesh_file: &Path, run: &PlannedRun) -> Vec<OsString> {
    let mut arguments = vec![run.job.verb().into(), mesh_file.into()];
    arguments.extend(options(run).into_iter().map(OsString::from));
    arguments
}

fn options(run: &PlannedRun) -> Vec<String> {
    let mut options: Vec<String> = run.job.options().into_iter().map(str::to_owned).collect();
    options.extend(["--seed".into(), run.seed.to_string()]);
    if let Some(paths) = run.stop_after_paths {
        options.extend(["--stop-after-paths".into(), paths.to_string()]);
    }
    options.extend(["--stats".into(), "-".into()]);
    options
}

/// What a reader types to see the same.
fn command(mesh: &PlannedMesh, run: &PlannedRun) -> String {
    let (make, file) = match &mesh.source {
        Source::File(path, _) => {
            (String::new(), path.file_name().unwrap_or_default().to_string_lossy().into_owned())
        }
        Source::Made(made, scale) => {
            let file = format!("{}.ply", made.name);
            let scale = match scale {
                Scale::Full => String::new(),
                other => format!(" --scale {}", other.id()),
            };
            (format!("triquad generate paper {}{scale} -o {file} && ", made.name), file)
        }
    };
    format!("{make}triquad {} {file} {}", run.job.verb(), options(run).join(" "))
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
        echo '"unpaired_triangles": '$unpaired', "pairing_seconds": 0.5, "augmentation_seconds": 0.25}'
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
        let plan = Plan::of(&[experiment], Scale::Demo, &[]).unwrap();
        let mut journal = Journal::open(&folder.path().join("out")).unwrap();
        struct Silent;
        impl Observer for Silent {}
        runner.execute(&plan, &mut journal, &SteppingClock::new(0.25), &Silent).unwrap();
        let rows = std::fs::read_to_string(folder.path().join("out/runs.csv")).unwrap();
        let rows = rows.replace(&machine::program(), "this program");
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/scripted_runs.csv");
        let golden = std::fs::read_to_string(path).unwrap_or_default();
        assert!(rows == golden, "the rows are now:\n{rows}");
    }
}
