//! `triquad run`.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use triquad::clock::SystemClock;
use triquad_lab::experiment::journal::Journal;
use triquad_lab::experiment::machine;
use triquad_lab::experiment::plan::{Block, PlannedMesh, PlannedRun};
use triquad_lab::experiment::record::{Outcome, RunRecord};
use triquad_lab::experiment::run::{Observer, Runner};
use triquad_lab::report::write;

use crate::experiments::{Selection, duration};
use crate::failure::Failure;
use crate::{generate, pictures, stdio};

/// Carry out experiments, each run in a process of its own, each a row of runs.csv
///
/// A row is on the disk before the next run begins. Started again, only what has no row is run, so it
/// may be interrupted at any time. Tables are written after every block, at most every five seconds,
/// the page every minute and at the end.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  triquad run experiments/comparison.toml --scale demo --out results/demo\n  \
                        triquad run experiments/comparison.toml --data ~/scans --out results/mine"
)]
pub struct Arguments {
    #[command(flatten)]
    selection: Selection,
    /// Where the results go
    #[arg(long, value_name = "DIR", default_value = "results/local")]
    out: PathBuf,
    /// Runs at the same time. Above 1 they slow each other down: times are then not compared
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=256))]
    jobs: u32,
    #[command(flatten)]
    cache: generate::CacheOption,
}

/// Runs what is left to run.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let plan = arguments.selection.plan()?;
    for remark in &plan.remarks {
        stdio::complain(remark);
    }
    let out = &arguments.out;
    let failure = |error: io::Error| folder_failure(out, &error);
    let mut journal = Journal::open(out).map_err(failure)?;
    for row in &journal.results().damaged {
        stdio::complain(&format!(
            "{}, line {}: {}; moved to damaged.csv, it will run again",
            out.join("runs.csv").display(),
            row.line,
            row.problem
        ));
    }
    let facts = machine::facts();
    let name = machine::name_of(&facts);
    journal.note_machine(&name, facts).map_err(failure)?;
    let program = std::env::current_exe().map_err(failure)?;
    let runner = Runner {
        program_hash: machine::hash_of_file(&program).map_err(failure)?,
        program,
        machine: name,
        workshop: out.join("meshes"),
        cache: arguments.cache.folder(),
        jobs: arguments.jobs,
    };
    let view = View::new(out);
    let clock = SystemClock::default();
    for mesh in &plan.pictured {
        let say = |line: &str| view.say(line);
        pictures::draw(out, mesh, runner.cache.as_deref(), &runner.program_hash, say)?;
    }
    runner.execute(&plan, &mut journal, &clock, &view).map_err(failure)?;
    view.finish(&journal)
}

fn folder_failure(folder: &Path, error: &io::Error) -> Failure {
    Failure::bad(format!(
        "{}: {error}; finished runs are kept, and 'triquad run' goes on from there",
        folder.display()
    ))
}

/// Shows how far it is: a bar on a terminal, a line a block elsewhere.
struct View<'a> {
    out: &'a Path,
    bar: ProgressBar,
    pace: Mutex<Pace>,
    written: Mutex<Written>,
}

/// When tables and page were last written.
struct Written {
    tables: Instant,
    page: Instant,
}

/// How long tables may lag behind where blocks take less than that.
const TABLES_EVERY: Duration = Duration::from_secs(5);
/// How long the page may lag behind: drawing its plots takes a moment.
const PAGE_EVERY: Duration = Duration::from_secs(60);

/// How estimates compare with what runs took.
#[derive(Default)]
struct Pace {
    left: f64,
    estimated: f64,
    taken: f64,
    bad: usize,
}

impl Pace {
    /// What is left, in the time of those that were run.
    fn seconds_left(&self) -> f64 {
        let factor = if self.estimated > 1.0 { self.taken / self.estimated } else { 1.0 };
        (self.left * factor).max(0.0)
    }
}

impl<'a> View<'a> {
    fn new(out: &'a Path) -> Self {
        let now = Instant::now();
        let written = Mutex::new(Written { tables: now, page: now });
        Self { out, bar: ProgressBar::no_length(), pace: Mutex::default(), written }
    }

    fn say(&self, line: &str) {
        if self.bar.is_hidden() {
            stdio::complain(line);
        } else {
            self.bar.println(line);
        }
    }

    fn pace(&self) -> std::sync::MutexGuard<'_, Pace> {
        self.pace.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn finish(self, journal: &Journal) -> Result<(), Failure> {
        self.bar.finish_and_clear();
        let report = write::write(self.out).map_err(|error| Failure::bad(error.to_string()))?;
        report.defects.iter().for_each(|defect| stdio::complain(defect));
        let records = &journal.results().records;
        let bad = self.pace().bad;
        let page = report.files.iter().find(|path| path.extension().is_some_and(|e| e == "html"));
        let line = format!(
            "{}: {} runs, all done",
            page.map_or(self.out, PathBuf::as_path).display(),
            records.len()
        );
        if bad == 0 {
            return stdio::say(&line);
        }
        stdio::say(&format!("{line}; {bad} of those just run did not end well, see runs.csv"))
    }
}

impl Observer for View<'_> {
    fn begin(&self, runs: usize, seconds: f64) {
        self.pace().left = seconds;
        self.bar.set_length(runs as u64);
        let template = "{spinner} {pos} of {len} runs, {msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            self.bar.set_style(style);
        }
        self.say(&format!("{runs} runs to do, about {}", duration(seconds)));
    }

    fn preparing(&self, mesh: &PlannedMesh) {
        self.bar.set_message(format!("making {}", mesh.name));
        self.bar.tick();
    }

    fn running(&self, block: &Block, run: &PlannedRun) {
        let left = duration(self.pace().seconds_left());
        let (mesh, job) = (&block.mesh.name, run.job.label());
        self.bar.set_message(format!("about {left} left: {mesh}, {job}"));
        self.bar.tick();
    }

    fn finished(&self, record: &RunRecord, estimate: f64) {
        let mut pace = self.pace();
        pace.left -= estimate;
        if record.outcome != Outcome::Skipped {
            pace.estimated += estimate;
            pace.taken += record.process_seconds;
        }
        drop(pace);
        self.bar.inc(1);
        if !record.is_ok() {
            self.pace().bad += 1;
            let RunRecord { mesh, algorithm, reason, .. } = record;
            self.say(&format!("{mesh}, {algorithm}: {:?}: {reason}", record.outcome));
        }
    }

    fn block_done(&self) -> io::Result<()> {
        let mut written = self.written.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        let report = if now - written.page >= PAGE_EVERY {
            *written = Written { page: now, tables: now };
            write::write(self.out)
        } else if now - written.tables >= TABLES_EVERY {
            written.tables = now;
            write::write_tables(self.out)
        } else {
            return Ok(());
        };
        report.map(|_| ()).map_err(io::Error::other)
    }

    fn mesh_done(&self, mesh: &PlannedMesh, journal: &Journal) {
        let left = duration(self.pace().seconds_left());
        let rows = journal.results().records.len();
        self.say(&format!("{} done: {rows} rows, about {left} left", mesh.name));
    }
}
