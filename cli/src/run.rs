//! `triquad run`.

use std::collections::{BTreeSet, HashSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use triquad::clock::SystemClock;
use triquad::counted::{counted, listed};
use triquad_lab::experiment::journal::Journal;
use triquad_lab::experiment::machine::{self, Build};
use triquad_lab::experiment::plan::{Block, Plan, PlannedRun};
use triquad_lab::experiment::planned_mesh::PlannedMesh;
use triquad_lab::experiment::record::{Outcome, RunRecord};
use triquad_lab::experiment::run::{OpenRuns, RunObserver, Runner};
use triquad_lab::pictures::{self, DrawError};
use triquad_lab::report::{self as lab_report, Extent};

use crate::bad_runs::Alike;
use crate::experiments::{Selection, duration, no_estimate};
use crate::failure::Failure;
use crate::{bad_runs, generate, input, interrupt, own_program, report, results_folder, stdio};

/// Run experiments: each run is a process, and a row of runs.csv
///
/// A row is on the disk before the next run begins. Interrupt it at any time: started again,
/// it does the runs without a row, and those that failed before they began. Tables are written
/// after every block, at most every five seconds, the page every minute and at the end.
///
/// Exit code 1 if a run did not end well (timeout, out of memory, crash, invalid result); each is
/// named. A folder has one run at a time; a second one is refused, and so is an experiment of
/// another name than those that it has.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
                        triquad run experiments/comparison.toml --scale demo --out results/demo\n  \
                        triquad run experiments/comparison.toml --data ~/scans --out results/mine")]
pub struct Arguments {
    #[command(flatten)]
    selection: Selection,
    /// The results folder
    #[arg(long, value_name = "DIR", default_value = "results/local")]
    out: PathBuf,
    /// Number of runs at the same time. Above 1 they slow each other down, and times are not
    /// compared
    #[arg(long, value_name = "N", default_value_t = 1)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=256))]
    jobs: u32,
    #[command(flatten)]
    cache: generate::CacheOption,
}

/// Does the runs that have no row yet, and draws the pictures.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let plan = arguments.selection.plan()?;
    let out = &arguments.out;
    let failure = |error: io::Error| results_folder::unwritable(out, &error);
    let mut journal = Journal::open(out).map_err(|error| results_folder::closed(&error))?;
    refuse_other_experiments(out, &plan, &journal)?;
    complain_of_damage(out, &journal);
    let runner = runner(arguments, &mut journal).map_err(failure)?;
    let view = RunView::new(out);
    let drawn = draw_pictures(out, &plan, &runner, &view);
    let executed = runner.execute(&plan, &mut journal, &SystemClock::default(), &view);
    executed.map_err(|error| interrupted(out, &error))?;
    view.finish(&journal)?;
    drawn
}

/// Refuses a folder that has other experiments alone: one page would mix them. What was run
/// together, or shares an experiment with the folder, belongs together.
fn refuse_other_experiments(out: &Path, plan: &Plan, journal: &Journal) -> Result<(), Failure> {
    let (there, new) = (journal.results().experiments(), plan.experiments());
    if there.is_empty() || new.is_empty() || !there.is_disjoint(&new) {
        return Ok(());
    }
    let names = |experiments: &BTreeSet<&str>| {
        listed(&experiments.iter().map(|name| format!("{name:?}")).collect::<Vec<_>>())
    };
    Err(Failure::bad(format!(
        "{}: it has results of {}, not of {}; name another folder with --out, or run the \
         experiment files together to have them on one page",
        out.display(),
        names(&there),
        names(&new)
    )))
}

/// Draws what is not drawn yet. Says what cannot be drawn; the runs go on all the same.
fn draw_pictures(out: &Path, plan: &Plan, runner: &Runner, view: &RunView) -> Result<(), Failure> {
    let mut failed = Ok(());
    for pictured in &plan.pictured {
        let mesh = &pictured.mesh;
        let begin = || view.say(&format!("drawing the pictures of {}", mesh.name));
        let drawn =
            pictures::draw(out, pictured, runner.cache.as_deref(), &runner.program_hash, begin);
        if let Err(error) = drawn {
            view.say(&picture_failure(&mesh.name, &error).message);
            failed = Err(Failure::no(format!("the pictures of {} are missing", mesh.name)));
        }
    }
    failed
}

/// Prints what was wrong with the folder: damaged rows, lost names, no locks.
fn complain_of_damage(out: &Path, journal: &Journal) {
    if !journal.is_locked() {
        let folder = out.display();
        stdio::complain(&format!(
            "{folder}: its file system has no locks; start no second run in this folder"
        ));
    }
    if journal.has_lost_names() {
        let path = out.join("runs.csv");
        stdio::complain(&format!("{}: its first line was lost and is there again", path.display()));
    }
    for row in journal.set_aside() {
        stdio::complain(&format!(
            "{}, line {}: {}; moved to damaged.csv, it will run again",
            out.join("runs.csv").display(),
            row.line,
            row.problem
        ));
    }
}

/// Returns the runner for this machine and notes the machine in the journal.
fn runner(arguments: &Arguments, journal: &mut Journal) -> io::Result<Runner> {
    // Named when the program was built: the sources may have moved on since.
    let build = Build { profile: env!("TRIQUAD_PROFILE"), commit: env!("TRIQUAD_COMMIT") };
    let facts = machine::facts(build);
    let name = machine::name_of(&facts);
    journal.note_machine(&name, facts)?;
    Ok(Runner {
        program_hash: own_program::hash()?,
        program: own_program::path()?,
        machine: name,
        workshop: arguments.out.join("meshes"),
        cache: arguments.cache.folder(),
        jobs: arguments.jobs,
    })
}

fn picture_failure(mesh: &str, error: &DrawError) -> Failure {
    match error {
        DrawError::Read { path, error } => input::mesh_failure(path, error),
        other => Failure::bad(format!("{mesh} cannot be drawn: {other}")),
    }
}

fn interrupted(folder: &Path, error: &io::Error) -> Failure {
    Failure::bad(format!(
        "{}: {error}; finished runs are kept, and 'triquad run' goes on from there",
        folder.display()
    ))
}

/// Shows progress (a bar on a terminal, a line a mesh elsewhere) and keeps the report up to date.
struct RunView<'a> {
    out: &'a Path,
    bar: ProgressBar,
    pace: Mutex<Pace>,
    written: Mutex<Written>,
    /// Reasons for which runs were skipped.
    said: Mutex<HashSet<String>>,
    /// Keys of runs that did not end well and were named at once, or counted with one that was.
    named: Mutex<HashSet<String>>,
    /// Runs that did not end well, those alike together.
    bad: Mutex<Alike>,
}

/// Times of the last writing of tables and page.
struct Written {
    tables: Instant,
    page: Instant,
}

/// Least time between two writings of the tables.
const TABLES_EVERY: Duration = Duration::from_secs(5);
/// Least time between two writings of the page, whose plots take a moment to draw.
const PAGE_EVERY: Duration = Duration::from_secs(60);

/// Estimated seconds beside measured ones.
#[derive(Default)]
struct Pace {
    /// Runs that were to be done.
    runs: usize,
    /// Those of them that are done.
    done: usize,
    /// Estimate of the runs that are left, without external programs.
    left: f64,
    /// Runs of external programs that are left.
    external: usize,
    /// Estimate of the runs that are done.
    estimated: f64,
    /// Seconds that they took.
    taken: f64,
}

impl Pace {
    /// Counts a finished run.
    fn count(&mut self, record: &RunRecord, estimate: Option<f64>) {
        self.done += 1;
        let Some(estimate) = estimate else {
            self.external -= 1;
            return;
        };
        self.left -= estimate;
        if record.outcome != Outcome::Skipped {
            self.estimated += estimate;
            self.taken += record.process_seconds.unwrap_or(0.0);
        }
    }

    /// Returns the time that is left, corrected by the times of finished runs, in words.
    fn left_in_words(&self) -> String {
        let factor = if self.estimated > 1.0 { self.taken / self.estimated } else { 1.0 };
        let time = duration((self.left * factor).max(0.0));
        match self.external {
            0 => format!("about {time} left"),
            runs => {
                let runs = counted(runs, "run of an external program", "runs of external programs");
                format!("about {time} and {runs} left")
            }
        }
    }
}

impl<'a> RunView<'a> {
    fn new(out: &'a Path) -> Self {
        let now = Instant::now();
        let written = Mutex::new(Written { tables: now, page: now });
        let bar = ProgressBar::no_length();
        interrupt::clear_on_interrupt(&bar);
        interrupt::advise("finished runs are kept, and the same command goes on from here");
        let (said, named, bad) = (Mutex::default(), Mutex::default(), Mutex::default());
        Self { out, bar, pace: Mutex::default(), written, said, named, bad }
    }

    /// Prints a line on standard error, above the bar if there is one.
    fn say(&self, line: &str) {
        if self.bar.is_hidden() {
            stdio::complain(line);
        } else {
            self.bar.println(line);
        }
    }

    fn pace(&self) -> MutexGuard<'_, Pace> {
        lock(&self.pace)
    }

    /// Writes the report and prints where it is.
    fn finish(self, journal: &Journal) -> Result<(), Failure> {
        self.bar.finish_and_clear();
        let (out, results) = (self.out, journal.results());
        lock(&self.bad).repeated().for_each(|line| stdio::complain(&line));
        if results.records.is_empty() {
            return stdio::say(&format!("{}: nothing was planned, nothing was run", out.display()));
        }
        let report = report::write(out, results)?;
        let place = report.page.as_deref().unwrap_or(out).display();
        let bad = results.records.iter().filter(|record| record.is_bad()).count();
        let skipped =
            results.records.iter().filter(|record| record.outcome == Outcome::Skipped).count();
        let mut line = format!("{place}: {}", counted(results.records.len(), "run", "runs"));
        for (count, what) in [(bad, "did not end well"), (skipped, "skipped")] {
            if count > 0 {
                line += &format!(", {count} {what}");
            }
        }
        stdio::say(&if bad + skipped == 0 { line + ", all done" } else { line })?;
        let named = lock(&self.named);
        bad_runs::refuse(out, results, |record| named.contains(&record.key))
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl RunObserver for RunView<'_> {
    fn begin(&self, open: OpenRuns) {
        let OpenRuns { runs, external, seconds } = open;
        *self.pace() = Pace { runs, left: seconds, external, ..Pace::default() };
        self.bar.set_length(runs as u64);
        let template = "{spinner} {pos} of {len} runs, {msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            self.bar.set_style(style);
        }
        let runs = counted(runs, "run", "runs");
        let note = no_estimate(external);
        self.say(&format!("{runs} to do, about {}{note}", duration(seconds)));
    }

    fn preparing(&self, mesh: &PlannedMesh) {
        self.bar.set_message(format!("making {}", mesh.name));
        self.bar.tick();
    }

    fn running(&self, block: &Block, run: &PlannedRun) {
        let left = self.pace().left_in_words();
        let (mesh, job) = (&block.mesh.name, run.job.name());
        self.bar.set_message(format!("{left}: {mesh}, {job}"));
        self.bar.tick();
    }

    fn finished(&self, record: &RunRecord, estimate: Option<f64>) {
        self.pace().count(record, estimate);
        self.bar.inc(1);
        // The reason why a program is not installed, or fails alike in every run, is printed once.
        let is_new = match record.outcome {
            Outcome::Skipped => lock(&self.said).insert(record.reason.clone()),
            _ => record.is_bad() && lock(&self.bad).add(record),
        };
        if is_new {
            self.say(&bad_runs::described(record));
        }
        if record.is_bad() {
            lock(&self.named).insert(record.key.clone());
        }
    }

    fn block_done(&self, journal: &Journal) -> io::Result<()> {
        let mut written = lock(&self.written);
        let now = Instant::now();
        let extent = if now - written.page >= PAGE_EVERY {
            *written = Written { page: now, tables: now };
            Extent::Everything
        } else if now - written.tables >= TABLES_EVERY {
            written.tables = now;
            Extent::Tables
        } else {
            return Ok(());
        };
        let report = lab_report::write(self.out, journal.results(), extent);
        report.map(|_| ()).map_err(io::Error::other)
    }

    fn mesh_done(&self, block: &Block) {
        let pace = self.pace();
        let (done, left) = (pace.done, pace.left_in_words());
        let runs = counted(pace.runs, "run", "runs");
        drop(pace);
        // Several experiments may have the mesh.
        let (experiment, mesh) = (&block.id.experiment, &block.mesh.name);
        self.say(&format!("{experiment}: {mesh} done: {done} of {runs}, {left}"));
    }
}
