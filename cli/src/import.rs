//! `triquad import`.

use std::collections::HashSet;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use triquad::counted::{counted, listed};
use triquad::mesh::refuse_endless;
use triquad_lab::experiment::import::{self, ImportSettings, Imported, MissingPart};
use triquad_lab::experiment::journal::Journal;
use triquad_lab::experiment::machine;
use triquad_lab::experiment::{RunRecord, Task};
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
    let imported = read(arguments)?;
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
    let algorithm = imported.algorithm.clone();
    if algorithm != arguments.algorithm {
        let (file, given) = (arguments.file.display(), &arguments.algorithm);
        let why = "algorithms of triquad are called so in letters of either case";
        stdio::note(&format!("{file}: note: {given} is taken as {algorithm}: {why}"));
    }
    let name = import::machine_name(&algorithm);
    journal.note_machine(&name, facts).map_err(failure)?;
    journal.note_plan(imported.planned()).map_err(failure)?;
    let cells = imported.planned().len();
    let rows = imported.records.len();
    let renamed = imported.renamed.map(|(from, to)| format!("; {from} taken as {to}"));
    let (meshes, near_meshes) = (imported.renamed_meshes, imported.near_meshes);
    let task = imported.records.first().map_or("", |record| record.id.job.task().id());
    let earlier = journal.results().records.iter().map(|record| record.key.clone());
    let mut keys: HashSet<String> = earlier.collect();
    let new: HashSet<&String> = imported.records.iter().map(|record| &record.key).collect();
    let is_staying = |record: &&RunRecord| record.machine == name && !new.contains(&record.key);
    let staying = journal.results().records.iter().filter(is_staying).count();
    let mut replaced = 0;
    for record in imported.records {
        replaced += usize::from(!keys.insert(record.key.clone()));
        journal.append(record).map_err(failure)?;
    }
    if let Some(note) = of_rounded(&imported.rounded) {
        stdio::complain(&format!("{}: {note}", arguments.file.display()));
    }
    for (given, taken) in meshes {
        let file = arguments.file.display();
        let why = "the boxes of the paper on irreducible triangulations are called so";
        stdio::note(&format!("{file}: note: {given} is taken as {taken}: {why}"));
    }
    for (given, near) in near_meshes {
        let file = arguments.file.display();
        stdio::note(&format!(
            "{file}: note: {given:?} is taken as a mesh of your own; {near:?} is near"
        ));
    }
    let staying = match staying {
        0 => String::new(),
        rows => format!(
            "; {}",
            counted(
                rows,
                format!("earlier row of {algorithm} stays"),
                format!("earlier rows of {algorithm} stay")
            )
        ),
    };
    let replaced = match replaced {
        0 => String::new(),
        rows => format!(
            "; {}",
            counted(rows, "row replaces an earlier one", "rows replace earlier ones")
        ),
    };
    for part in &imported.missing_parts {
        let note = without_total(part);
        stdio::complain(&format!("{}: {note}", arguments.file.display()));
    }
    let written = report::write(out, journal.results())?;
    stdio::say(&format!(
        "{}: {} of {} ({task}) on {} taken in{}{replaced}{staying}",
        written.page.as_deref().unwrap_or(out).display(),
        counted(rows, "run", "runs"),
        algorithm,
        counted(cells, "mesh", "meshes"),
        renamed.unwrap_or_default(),
    ))
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
