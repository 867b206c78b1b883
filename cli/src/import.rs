//! `triquad import`.

use std::collections::HashSet;
use std::fmt;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use triquad::counted::{counted, listed};
use triquad::mesh::refuse_endless;
use triquad_lab::experiment::import::{self, ImportSettings, Imported, MissingPart};
use triquad_lab::experiment::journal::Journal;
use triquad_lab::experiment::machine;
use triquad_lab::experiment::{Results, RunRecord, Task};
use triquad_lab::meshes::paper::Scale;

use crate::failure::Failure;
use crate::names::one_of;
use crate::{report, results_folder, stdio};

/// Import results measured elsewhere into a results folder
///
/// The file needs a column for the mesh and one with a number, named as in runs.csv or mapped to
/// it; the rest has defaults. Tables, plots and page of the folder are rebuilt.
#[derive(clap::Args)]
#[command(after_help = "Example: triquad import mine.csv --map \"graph=mesh,time=total_seconds\" \
                        --algorithm mine --out results/mine")]
pub struct Arguments {
    /// Comma-separated values, names in the first line; '-' for standard input
    #[arg(value_name = "FILE.csv")]
    file: PathBuf,
    /// Names in the file, and in runs.csv; '-' leaves a column out. May be given more than once
    #[arg(long, value_name = "THEIRS=OURS,…", value_delimiter = ',', value_parser = parse_mapping)]
    map: Vec<(String, String)>,
    /// Algorithm of all rows: one of ours, or a name of your own
    #[arg(long, value_name = "NAME")]
    algorithm: String,
    /// Task of the algorithm: convert (quads) or irreducible [default: by the columns]
    #[arg(long, value_name = "TASK", value_parser = one_of(Task::ALL, Task::id))]
    task: Option<Task>,
    /// Size of the papers' meshes in the file
    #[arg(long, default_value = "full", value_name = "SCALE")]
    #[arg(value_parser = one_of(Scale::ALL, Scale::id))]
    scale: Scale,
    /// Accept meshes that the papers do not have
    #[arg(long)]
    other_meshes: bool,
    /// The results folder
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Reads `THEIRS=OURS`.
fn parse_mapping(text: &str) -> Result<(String, String), String> {
    let parts = text.split_once('=').map(|(from, to)| (from.trim(), to.trim()));
    match parts {
        Some((from, to)) if !from.is_empty() && !to.is_empty() => Ok((from.into(), to.into())),
        _ => Err("a mapping is THEIRS=OURS, time=total_seconds for example".into()),
    }
}

/// Reads the file, adds its rows to the folder and writes the report.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut imported = read(arguments)?;
    let out = &arguments.out;
    let failure = |error: std::io::Error| results_folder::unwritable(out, &error);
    let mut journal = Journal::open(out).map_err(|error| results_folder::closed(&error))?;
    if let Some(there) = imported.other_scale_in(journal.results()) {
        return Err(Failure::bad(of_other_scale(arguments, there)));
    }
    let facts = [
        ("imported from", arguments.file.display().to_string()),
        ("imported by", machine::program()),
    ];
    let facts = facts.map(|(name, fact)| (name.to_owned(), fact)).into();
    let machine = import::machine_name(&imported.algorithm);
    journal.note_machine(&machine, facts).map_err(failure)?;
    journal.note_plan(imported.planned()).map_err(failure)?;
    let counts = Counts::new(&imported, journal.results(), &machine);
    for record in std::mem::take(&mut imported.records) {
        journal.append(record).map_err(failure)?;
    }
    print_notes(arguments, &imported);
    let written = report::write(out, journal.results())?;
    let page = written.page.as_deref().unwrap_or(out).display();
    stdio::say(&format!("{page}: {counts}"))
}

/// How many rows were taken, and what became of earlier ones.
struct Counts {
    algorithm: String,
    task: &'static str,
    runs: usize,
    meshes: usize,
    replaced: usize,
    /// Earlier rows of the same algorithm.
    staying: usize,
    /// A column taken as another.
    renamed: Option<(&'static str, &'static str)>,
}

impl Counts {
    /// Counts the rows of `imported` beside those that there are, of `machine` and others.
    fn new(imported: &Imported, there: &Results, machine: &str) -> Self {
        let mut keys: HashSet<&String> = there.records.iter().map(|run| &run.key).collect();
        let replaced = imported.records.iter().filter(|run| !keys.insert(&run.key)).count();
        let new: HashSet<&String> = imported.records.iter().map(|run| &run.key).collect();
        let is_staying = |run: &&RunRecord| run.machine == machine && !new.contains(&run.key);
        Self {
            algorithm: imported.algorithm.clone(),
            task: imported.records.first().map_or("", |run| run.id.job.task().id()),
            runs: imported.records.len(),
            meshes: imported.planned().len(),
            replaced,
            staying: there.records.iter().filter(is_staying).count(),
            renamed: imported.renamed,
        }
    }
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { algorithm, task, replaced, staying, .. } = self;
        let runs = counted(self.runs, "run", "runs");
        let meshes = counted(self.meshes, "mesh", "meshes");
        write!(f, "{runs} of {algorithm} ({task}) on {meshes} taken in")?;
        if let Some((from, to)) = &self.renamed {
            write!(f, "; {from} taken as {to}")?;
        }
        if *replaced > 0 {
            let rows =
                counted(*replaced, "row replaces an earlier one", "rows replace earlier ones");
            write!(f, "; {rows}")?;
        }
        if *staying > 0 {
            let one = format!("earlier row of {algorithm} stays");
            let more = format!("earlier rows of {algorithm} stay");
            write!(f, "; {}", counted(*staying, one, more))?;
        }
        Ok(())
    }
}

/// Prints what may have been meant otherwise, and what is missing.
fn print_notes(arguments: &Arguments, imported: &Imported) {
    let file = arguments.file.display();
    let taken = |given: &str, taken: &str, why: &str| {
        stdio::note(&format!("{file}: note: {given} is taken as {taken}: {why}"));
    };
    if imported.algorithm != arguments.algorithm {
        let why = "algorithms of triquad are called so in letters of either case";
        taken(&arguments.algorithm, &imported.algorithm, why);
    }
    if let Some(note) = of_rounded(&imported.rounded) {
        stdio::complain(&format!("{file}: {note}"));
    }
    for (given, ours) in &imported.renamed_meshes {
        taken(given, ours, "the boxes of the paper on irreducible triangulations are called so");
    }
    for (given, near) in &imported.near_meshes {
        let note = format!("{given:?} is taken as a mesh of your own; {near:?} is near");
        stdio::note(&format!("{file}: note: {note}"));
    }
    for part in &imported.missing_parts {
        stdio::complain(&format!("{file}: {}", without_total(part)));
    }
}

/// Words why rows are not put beside runs on meshes of scale `there`.
fn of_other_scale(arguments: &Arguments, there: Scale) -> String {
    let (file, out) = (arguments.file.display(), arguments.out.display());
    let (ours, there) = (arguments.scale.id(), there.id());
    format!(
        "{file}: its meshes are of scale {ours}, those in {out} of scale {there}: one table would \
         have meshes of one name in two sizes; give --scale {there} if that is their size, or \
         another folder with --out"
    )
}

/// Words which counts were rounded, one for each of these lines; nothing if there are none.
fn of_rounded(lines: &[u64]) -> Option<String> {
    /// Of more lines only the number is told.
    const SHOWN: usize = 8;
    let mut distinct = lines.to_vec();
    distinct.dedup();
    let mut names: Vec<String> = distinct.iter().take(SHOWN).map(u64::to_string).collect();
    if distinct.len() > SHOWN {
        names.push(format!("{} more", distinct.len() - SHOWN));
    }
    let place = if distinct.len() == 1 { "line" } else { "lines" };
    let counts = counted(
        lines.len(),
        "count is no whole number and was rounded",
        "counts are no whole numbers and were rounded",
    );
    let remedy = "give each run a row of its own, not their mean";
    (!lines.is_empty()).then(|| format!("{place} {}: {counts}; {remedy}", listed(&names)))
}

/// Words why runs have no total, and what gives them one.
fn without_total(part: &MissingPart) -> String {
    let MissingPart { column, known, has_column, runs } = *part;
    let runs = counted(runs, "run has", "runs have");
    let (fault, remedy) = match has_column {
        true => ("empty", "fill it in"),
        false => ("missing", "add it"),
    };
    format!(
        "{runs} no total, which is {known} + {column}: {column} is {fault}; {remedy}, with 0 for \
         a stage that does not exist, or give total_seconds"
    )
}

fn read(arguments: &Arguments) -> Result<Imported, Failure> {
    let file = &arguments.file;
    let failure =
        |error: &dyn std::fmt::Display| Failure::bad(format!("{}: {error}", file.display()));
    let text = read_text(file).map_err(|error| failure(&error))?;
    let settings = ImportSettings {
        algorithm: arguments.algorithm.clone(),
        task: arguments.task,
        scale: arguments.scale,
        mapping: arguments.map.clone(),
        allows_other_meshes: arguments.other_meshes,
    };
    import::read(&text, &settings).map_err(|error| failure(&error))
}

fn read_text(file: &Path) -> std::io::Result<String> {
    if file.as_os_str() == "-" {
        let mut text = String::new();
        return std::io::stdin().read_to_string(&mut text).map(|_| text);
    }
    refuse_endless(file).and_then(|()| std::fs::read_to_string(file))
}
