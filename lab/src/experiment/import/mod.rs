//! Results that others have measured, read from a file of comma-separated values.
//!
//! Two columns are needed: the mesh, and one number of [`Measured`]. What else `runs.csv` has is
//! taken where it is there and has a default where it is not.

mod error;
mod plausible;

use std::collections::{BTreeSet, HashMap};
use std::path::Path;

use csv::StringRecord;
use serde::Deserialize;
use triquad::clock::to_nanoseconds;
use triquad::counted::counted;
use triquad::mesh::Format;

pub use error::ImportError;

use super::job::{self, Job};
use super::machine::hash_of_words;
use super::measured::Measured;
use super::record::{IMPORTED, Outcome, RunRecord};
use super::results::{Planned, Results, column_names};
use super::run_id::{MeshId, RunId};
use super::task::Task;
use crate::meshes::paper::{self, PaperMesh, Scale};
use crate::meshes::{MeshKind, Recipe};
use crate::nearest::{likely, slip_of};
use crate::paper::Paper;

/// Options for reading a file.
#[derive(Clone, Debug)]
pub struct ImportSettings {
    /// Algorithm of all rows; one of ours, or any other name.
    pub algorithm: String,
    /// Task of the algorithm, if that does not follow from its name or the columns.
    pub task: Option<Task>,
    /// Size of the papers' meshes.
    pub scale: Scale,
    /// Names of columns in the file and in `runs.csv`; `-` for a column that is to be left out.
    pub mapping: Vec<(String, String)>,
    /// True if there may be meshes that the papers do not have.
    pub allows_other_meshes: bool,
}

impl ImportSettings {
    /// Returns the settings with an algorithm of ours under the name that we give it: case does not
    /// matter.
    fn with_our_name(&self) -> Self {
        let is_of_task = |task| self.task.is_none_or(|wanted| wanted == task);
        let ours = job::our_name(&self.algorithm).filter(|(_, task)| is_of_task(*task));
        let algorithm = ours.map_or_else(|| self.algorithm.clone(), |(name, _)| name);
        Self { algorithm, ..self.clone() }
    }
}

/// Rows that were read.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Name of the algorithm in the rows.
    pub algorithm: String,
    /// One row a run.
    pub records: Vec<RunRecord>,
    /// Lines of counts that were no whole numbers, as means are not, and were rounded: one a count,
    /// from 1.
    pub rounded: Vec<u64>,
    /// A column of times, and the one that the task has for it, where they differ.
    pub renamed: Option<(&'static str, &'static str)>,
    /// Meshes in the words of the file, and those of the second paper that they are taken for.
    pub renamed_meshes: Vec<(String, String)>,
    /// Meshes that the papers do not have, and those of theirs whose names are but a slip away.
    pub near_meshes: Vec<(String, String)>,
    /// Parts of the total that runs lack.
    pub missing_parts: Vec<MissingPart>,
}

/// A time without which a total cannot be computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MissingPart {
    /// Its column.
    pub column: &'static str,
    /// The column of the other part, which is there.
    pub known: &'static str,
    /// True if the file has the column, empty in these runs.
    pub has_column: bool,
    /// Runs that ended well and have neither this time nor a total.
    pub runs: usize,
}

/// The columns that are no numbers of a run.
#[derive(Deserialize)]
struct PlaceColumns {
    mesh: String,
    mesh_kind: Option<MeshKind>,
    repetition: Option<u32>,
    seed: Option<u64>,
    outcome: Option<Outcome>,
    reason: Option<String>,
    parallel_jobs: Option<u32>,
    stopped_after_paths: Option<u64>,
    program: Option<String>,
    command: Option<String>,
    process_seconds: Option<f64>,
}

/// Their names.
const PLACE_COLUMNS: [&str; 11] = [
    MESH,
    "mesh_kind",
    "repetition",
    "seed",
    "outcome",
    "reason",
    "parallel_jobs",
    "stopped_after_paths",
    "program",
    "command",
    "process_seconds",
];

/// Those of them that are whole numbers.
const COUNTS_OF_PLACE: [&str; 4] = ["repetition", "seed", "parallel_jobs", "stopped_after_paths"];

/// The column of the mesh.
const MESH: &str = "mesh";

/// Columns whose sum is the total of a conversion.
const PAIRING: &str = "pairing_seconds";
const AUGMENTATION: &str = "augmentation_seconds";

/// Columns that belong to the mesh: they alone are no result.
const SIZES: [&str; 5] = ["vertices", "edges", "triangles", "genus", "components"];

/// Columns that only irreducible triangulations have.
const OF_REDUCTIONS: [&str; 6] = [
    "result_vertices",
    "result_edges",
    "result_triangles",
    "contractions",
    "link_condition_tests",
    "edges_tested_more_than_once",
];

/// Reads the text of a file.
///
/// # Errors
/// It lacks the mesh or any number, or a name in it is not known: the nearest known one is named.
pub fn read(text: &str, settings: &ImportSettings) -> Result<Imported, ImportError> {
    if !is_name(&settings.algorithm) {
        return Err(ImportError::Name(settings.algorithm.clone()));
    }
    let settings = &settings.with_our_name();
    let text = text.trim_start_matches('\u{feff}');
    if let Some(separator) = foreign_separator(text) {
        return Err(ImportError::Separator(separator));
    }
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers()?.clone();
    let rows = reader.records().collect::<Result<Vec<StringRecord>, _>>().map_err(fault_of_row);
    let columns = columns(&header, rows.as_deref().unwrap_or_default(), settings)?;
    let rows = rows?;
    let first = rows.first().ok_or(ImportError::NoRows)?;
    let mesh_of_first = columns.iter().position(|column| column == MESH).map(|at| &first[at]);
    let job = job(settings, &columns, mesh_of_first.unwrap_or_default());
    // Of the two tasks' times, the one that the other calls so too.
    let (columns, renamed) = with_times_of(job.task(), columns);
    let names = StringRecord::from(columns.clone());
    let mut imported = Imported {
        algorithm: settings.algorithm.clone(),
        records: Vec::new(),
        rounded: Vec::new(),
        renamed,
        renamed_meshes: Vec::new(),
        near_meshes: Vec::new(),
        missing_parts: Vec::new(),
    };
    for row in rows {
        let row = checked(&row, &columns, &header, &mut imported.rounded)?;
        refuse_empty(&row, &columns, &header)?;
        let mut record = record(&row, &names, job, settings, &imported.records)?;
        plausible::check(&row, &columns, &header, &record)?;
        imported.note_mesh(&row, &columns, &record);
        imported.complete_total(&mut record, &columns);
        imported.records.push(record);
    }
    Ok(imported)
}

impl Imported {
    /// Notes a mesh of the second paper that the file calls as the first paper calls another, and
    /// one of somebody's own that is called nearly as a mesh of the papers.
    fn note_mesh(&mut self, row: &StringRecord, columns: &[String], record: &RunRecord) {
        let (Some(given), taken) = (cell(row, columns, MESH), &record.id.mesh.name) else {
            return;
        };
        let is_new = || self.renamed_meshes.iter().all(|(_, mesh)| mesh != taken);
        if taken.starts_with(SECOND_PAPER) && !starts_second_paper(given) && is_new() {
            self.renamed_meshes.push((given.to_owned(), taken.clone()));
        }
        let is_of_papers = paper::ALL.iter().any(|mesh| mesh.name == taken);
        let is_known = is_of_papers || self.near_meshes.iter().any(|(name, _)| name == taken);
        if let Some(near) = near_mesh(taken).filter(|_| !is_known) {
            self.near_meshes.push((taken.clone(), near.to_owned()));
        }
    }

    /// Fills in the total of a conversion where both its parts are known, and notes the part that
    /// is missing where only one is.
    fn complete_total(&mut self, record: &mut RunRecord, columns: &[String]) {
        let measured = &mut record.measured;
        if record.id.job.task() != Task::Convert || measured.total_seconds.is_some() {
            return;
        }
        let (column, known) = match (measured.pairing_seconds, measured.augmentation_seconds) {
            (Some(pairing), Some(augmentation)) => {
                measured.total_seconds = Some(to_nanoseconds(pairing + augmentation));
                return;
            }
            (Some(_), None) => (AUGMENTATION, PAIRING),
            (None, Some(_)) => (PAIRING, AUGMENTATION),
            (None, None) => return,
        };
        if !record.is_ok() {
            return;
        }
        match self.missing_parts.iter_mut().find(|part| part.column == column) {
            Some(part) => part.runs += 1,
            None => {
                let has_column = columns.iter().any(|name| name == column);
                self.missing_parts.push(MissingPart { column, known, has_column, runs: 1 });
            }
        }
    }

    /// Returns the scale of the papers' meshes in a folder, if these rows are of another one that
    /// the folder does not have. Meshes of the same name then differ in size.
    pub fn other_scale_in(&self, folder: &Results) -> Option<Scale> {
        let is_of_paper =
            |record: &&RunRecord| paper::ALL.iter().any(|mesh| mesh.name == record.id.mesh.name);
        let scale = self.records.iter().find(is_of_paper)?.id.mesh.scale;
        let there = folder.records.iter().filter(is_of_paper).map(|record| record.id.mesh.scale);
        let there: Vec<Scale> = there.collect();
        there.first().copied().filter(|_| !there.contains(&scale))
    }

    /// Returns the plan that these rows fulfil: nothing else was planned, whatever numbers the
    /// repetitions have.
    pub fn planned(&self) -> Vec<Planned> {
        let mut runs: HashMap<&RunId, BTreeSet<u32>> = HashMap::new();
        let mut planned: Vec<Planned> = Vec::new();
        for record in &self.records {
            let numbers = runs.entry(&record.id).or_insert_with(|| {
                planned.push(Planned { id: record.id.clone(), repetitions: 0 });
                BTreeSet::new()
            });
            numbers.insert(record.repetition);
        }
        for row in &mut planned {
            row.repetitions = runs[&row.id].len() as u32;
        }
        planned
    }
}

/// Returns what stands between values in place of commas, if the first line has more of it.
fn foreign_separator(text: &str) -> Option<&'static str> {
    let first = text.lines().next().unwrap_or_default();
    let count = |separator: char| first.matches(separator).count();
    let others = [(';', "semicolons"), ('\t', "tabs"), ('|', "vertical bars")];
    others.into_iter().find(|(other, _)| count(*other) > count(',')).map(|other| other.1)
}

fn fault_of_row(error: csv::Error) -> ImportError {
    match *error.kind() {
        csv::ErrorKind::UnequalLengths { ref pos, expected_len, len } => ImportError::Fields {
            line: pos.as_ref().map_or(0, csv::Position::line),
            fields: counted(len as usize, "field", "fields"),
            names: expected_len,
        },
        _ => error.into(),
    }
}

/// Refuses a row without a mesh, and one that ended well without any number.
fn refuse_empty(
    row: &StringRecord,
    columns: &[String],
    header: &StringRecord,
) -> Result<(), ImportError> {
    let line = row.position().map_or(0, csv::Position::line);
    let place = |name: &str| columns.iter().position(|column| column == name);
    let mesh = place(MESH).filter(|&at| row[at].is_empty());
    if let Some(column) = mesh.map(|at| header[at].to_owned()) {
        return Err(ImportError::EmptyMesh { line, column });
    }
    let mut results = (0..columns.len()).filter(|&at| is_result(&columns[at]));
    let outcome = place("outcome").map_or("", |at| &row[at]);
    let is_ok = ["", Outcome::Ok.id()].contains(&outcome);
    if is_ok && results.clone().all(|at| row[at].is_empty()) {
        let column = results.next().map_or(String::new(), |at| header[at].to_owned());
        return Err(ImportError::EmptyRow { line, column });
    }
    Ok(())
}

/// Returns whether a column has a number of a run.
fn is_result(column: &str) -> bool {
    let mut others = PLACE_COLUMNS.iter().chain(&SIZES).chain(&["-"]);
    !others.any(|other| *other == column)
}

/// Returns the names in `runs.csv` of the columns of the file; `-` for those that are left out.
fn columns(
    header: &StringRecord,
    rows: &[StringRecord],
    settings: &ImportSettings,
) -> Result<Vec<String>, ImportError> {
    let known = known_columns();
    let header: Vec<String> = header.iter().map(str::to_owned).collect();
    let is_same = |one: &str, other: &str| one.to_lowercase() == other.to_lowercase();
    // Names are those of `runs.csv` in letters of either case.
    let plain = |name: &str| {
        let same = known.iter().find(|known| is_same(known, name));
        same.map_or(name, |known| known).to_owned()
    };
    // Columns of the file that differ in case alone are told apart.
    let mapping_of = |name: &str| {
        let exact = settings.mapping.iter().find(|(from, _)| from == name);
        let others = || settings.mapping.iter().find(|(from, _)| is_same(from, name));
        let is_other = |from: &str| from != name && header.iter().any(|other| other == from);
        exact.or_else(|| others().filter(|(from, _)| !is_other(from)))
    };
    for (from, to) in &settings.mapping {
        if !header.iter().any(|name| is_same(name, from)) {
            let (name, has) = (from.clone(), header.join(", "));
            return Err(ImportError::UnknownSource { name, has });
        }
        if to != "-" && !known.contains(&plain(to)) {
            let nearest = nearest_of(to, &known);
            return Err(ImportError::UnknownTarget { name: to.clone(), nearest });
        }
    }
    let mapped = |name: &String| plain(mapping_of(name).map_or(name, |(_, to)| to));
    let columns: Vec<String> = header.iter().map(mapped).collect();
    check_columns(&columns, &header, rows, &known)?;
    Ok(columns)
}

/// Checks that every column is known and there once, with a mesh and a number among them. `header`
/// has the names in the file.
fn check_columns(
    columns: &[String],
    header: &[String],
    rows: &[StringRecord],
    known: &[String],
) -> Result<(), ImportError> {
    let lacks_mesh = !columns.iter().any(|column| column == MESH);
    for (i, column) in columns.iter().enumerate().filter(|(_, column)| *column != "-") {
        if !known.contains(column) {
            let name = column.clone();
            return Err(match lacks_mesh && has_meshes(rows, i) {
                true => ImportError::UnknownMeshColumn(name),
                false => ImportError::UnknownColumn { nearest: nearest_of(column, known), name },
            });
        }
        if columns[..i].contains(column) {
            return Err(ImportError::Twice(column.clone()));
        }
    }
    if lacks_mesh {
        let column = (0..header.len()).find(|&at| has_meshes(rows, at));
        let column = column.map(|at| header[at].clone());
        return Err(ImportError::NoMesh { column, has: header.join(", ") });
    }
    columns.iter().find(|column| is_result(column)).ok_or(ImportError::NoNumber)?;
    Ok(())
}

/// Returns the known column whose name is near.
fn nearest_of(name: &str, known: &[String]) -> Option<String> {
    likely(name, known.iter().map(String::as_str)).map(str::to_owned)
}

/// Returns whether a column has names of meshes alone: meshes of the papers, or files.
fn has_meshes(rows: &[StringRecord], at: usize) -> bool {
    let of_second_paper = |name: &str| paper::called(&format!("{SECOND_PAPER}{name}")).is_some();
    let is_mesh = |name: &str| {
        let is_file = || Format::from_path(Path::new(name)).is_ok();
        paper::called(name).is_some() || of_second_paper(name) || is_file()
    };
    let names = rows.iter().filter_map(|row| row.get(at)).filter(|name| !name.is_empty());
    let mut names = names.peekable();
    names.peek().is_some() && names.all(is_mesh)
}

/// Returns whether rows can have this name: it stands in tables and on the page.
fn is_name(name: &str) -> bool {
    name.starts_with(char::is_alphanumeric)
        && !name.contains(char::is_control)
        && name.chars().count() <= error::LONGEST_NAME
}

fn known_columns() -> Vec<String> {
    let all = column_names().unwrap_or_default();
    let names: Vec<&str> = all.split(',').collect();
    let first = names.iter().position(|name| *name == "vertices").unwrap_or(names.len());
    let known = PLACE_COLUMNS.iter().chain(&names[first..]);
    known.map(|name| (*name).to_owned()).collect()
}

/// Program of rows that name none.
pub const UNNAMED_PROGRAM: &str = "external";

/// Begins the names of the second paper's boxes.
const SECOND_PAPER: &str = "ir-";

/// Returns whether a mesh in the words of a file has that prefix. A mesh that is not the paper's
/// needs its hyphen: other words begin with these letters.
fn starts_second_paper(mesh: &str) -> bool {
    paper::called(mesh).is_some_and(|mesh| mesh.name.starts_with(SECOND_PAPER))
        || mesh.to_lowercase().replace(['_', ' '], "-").starts_with(SECOND_PAPER)
}

/// Returns the field of a row in a column, if it is there and not empty.
fn cell<'r>(row: &'r StringRecord, columns: &[String], column: &str) -> Option<&'r str> {
    let place = columns.iter().position(|name| name == column)?;
    row.get(place).filter(|field| !field.is_empty())
}

/// Returns the job of all rows.
fn job(settings: &ImportSettings, columns: &[String], mesh: &str) -> Job {
    let name = settings.algorithm.as_str();
    let is_reduction = columns.iter().any(|column| OF_REDUCTIONS.contains(&column.as_str()));
    let of_second_paper = starts_second_paper(mesh);
    let task = match settings.task {
        Some(task) => task,
        None if is_reduction || of_second_paper => Task::Irreducible,
        None => Task::Convert,
    };
    match Job::named(name) {
        Ok(job) if settings.task.is_none_or(|task| task == job.task()) => job,
        _ => Job::program(task, name),
    }
}

/// Returns the columns with the name that a task has for its time, and the change if there is one:
/// a lone `seconds` of a conversion is its total, a lone total of a reduction its `seconds`.
fn with_times_of(
    task: Task,
    mut columns: Vec<String>,
) -> (Vec<String>, Option<(&'static str, &'static str)>) {
    let (from, to) = match task {
        Task::Convert => ("seconds", "total_seconds"),
        Task::Irreducible => ("total_seconds", "seconds"),
    };
    if columns.iter().any(|column| column == to) {
        return (columns, None);
    }
    let renamed = columns.iter_mut().find(|column| *column == from).map(|column| {
        to.clone_into(column);
        (from, to)
    });
    (columns, renamed)
}

/// Returns the row with whole counts, if every number is one.
fn checked(
    row: &StringRecord,
    columns: &[String],
    header: &StringRecord,
    rounded: &mut Vec<u64>,
) -> Result<StringRecord, ImportError> {
    let line = row.position().map_or(0, csv::Position::line);
    let mut fields = Vec::new();
    for ((field, column), name) in row.iter().zip(columns).zip(header) {
        let bad = |expected| ImportError::BadField {
            line,
            column: name.into(),
            value: field.into(),
            expected,
        };
        let range = |bounds| ImportError::OutOfRange {
            line,
            column: name.into(),
            value: field.into(),
            bounds,
        };
        if COUNTS_OF_PLACE.contains(&column.as_str()) && !field.is_empty() {
            if field.parse::<f64>().is_ok_and(|value| value < 0.0) {
                return Err(range("0 or more"));
            }
            field.parse::<u64>().map_err(|_| bad("whole number"))?;
        }
        let is_text = PLACE_COLUMNS.contains(&column.as_str()) || column == "-";
        if is_text || field.is_empty() {
            fields.push(field.to_owned());
            continue;
        }
        let is_fraction =
            ["seconds", "percent", "mean", "minimum"].iter().any(|ending| column.ends_with(ending));
        let value: f64 = field.parse().map_err(|_| bad("number"))?;
        if !value.is_finite() {
            return Err(bad("number"));
        }
        let (least, most, bounds) = match column.as_str() {
            name if name.ends_with("percent") => (0.0, 100.0, "from 0 to 100"),
            // Those of scaled Jacobians.
            name if name.starts_with("quality") => (-1.0, 1.0, "from -1 to 1"),
            _ => (0.0, f64::INFINITY, "0 or more"),
        };
        if value < least || value > most {
            return Err(range(bounds));
        }
        if is_fraction || field.parse::<u64>().is_ok() {
            fields.push(field.to_owned());
        } else {
            rounded.extend((value.fract() != 0.0).then_some(line));
            fields.push(format!("{value:.0}"));
        }
    }
    let mut checked = StringRecord::from(fields);
    checked.set_position(row.position().cloned());
    Ok(checked)
}

fn record(
    row: &StringRecord,
    names: &StringRecord,
    job: Job,
    settings: &ImportSettings,
    before: &[RunRecord],
) -> Result<RunRecord, ImportError> {
    let place: PlaceColumns = row.deserialize(Some(names))?;
    let measured: Measured = row.deserialize(Some(names))?;
    let line = row.position().map_or(0, csv::Position::line);
    let mesh = find_mesh(&place.mesh, job.task(), settings);
    let mesh = match mesh {
        None if !settings.allows_other_meshes => {
            let nearest = near_mesh(&place.mesh).map(String::from);
            return Err(ImportError::UnknownMesh { line, name: place.mesh, nearest });
        }
        found => found,
    };
    let name = mesh.map_or(place.mesh.as_str(), |mesh| mesh.name);
    let paper = Paper::on(job.task());
    let id = RunId {
        mesh: MeshId {
            experiment: paper.experiment().into(),
            scale: settings.scale,
            group: paper.group_of(name).into(),
            name: name.replace(char::is_control, " "),
        },
        job,
    };
    let earlier = before.iter().filter(|record| record.id == id).count() as u32;
    let repetition = place.repetition.unwrap_or(earlier);
    let key = ["import", &settings.algorithm, name, settings.scale.id(), &repetition.to_string()];
    let plain = |text: Option<String>| text.unwrap_or_default().replace(char::is_control, " ");
    Ok(RunRecord {
        key: hash_of_words(&key),
        id,
        mesh_kind: place
            .mesh_kind
            .or(mesh.map(|mesh| kind_of(mesh, settings.scale)))
            .unwrap_or(MeshKind::Real),
        mesh_sha256: String::new(),
        repetition,
        seed: place.seed.unwrap_or(0),
        outcome: place.outcome.unwrap_or_default(),
        reason: plain(place.reason),
        parallel_jobs: place.parallel_jobs.unwrap_or(1),
        stopped_after_paths: place.stopped_after_paths,
        program: place.program.map_or(UNNAMED_PROGRAM.into(), |program| plain(Some(program))),
        machine: machine_name(&settings.algorithm),
        command: plain(place.command),
        process_seconds: place.process_seconds,
        measured: with_sizes(measured, mesh),
    })
}

/// Returns the name under which the source of imported rows stands in `machines.json`.
pub fn machine_name(algorithm: &str) -> String {
    format!("{IMPORTED}{algorithm}")
}

/// Returns the mesh of the papers that is called so; the second paper's boxes need no `ir-`.
fn find_mesh(name: &str, task: Task, settings: &ImportSettings) -> Option<PaperMesh> {
    let find = |name: &str| paper::called(name).map(|mesh| mesh.at(settings.scale));
    let of_second_paper = || find(&format!("{SECOND_PAPER}{name}"));
    match task {
        Task::Convert => find(name),
        Task::Irreducible => of_second_paper().or_else(|| find(name)),
    }
}

/// Returns the mesh of the papers whose name is but a slip away. O(meshes).
fn near_mesh(name: &str) -> Option<&'static str> {
    slip_of(name, paper::ALL.iter().map(|mesh| mesh.name))
}

/// Returns the kind of a mesh that others have: the scans themselves, and of smaller sizes the
/// stand-ins, as there are no such scans.
fn kind_of(mesh: PaperMesh, scale: Scale) -> MeshKind {
    match mesh.recipe {
        Recipe::StandIn { .. } if scale == Scale::Full => MeshKind::Real,
        _ => mesh.kind(),
    }
}

/// Fills in the sizes of a mesh of the papers.
fn with_sizes(measured: Measured, mesh: Option<PaperMesh>) -> Measured {
    let Some(mesh) = mesh else { return measured };
    Measured {
        vertices: measured.vertices.or(Some(mesh.vertices.into())),
        edges: measured.edges.or(Some(mesh.edges().into())),
        triangles: measured.triangles.or(Some(mesh.triangles().into())),
        genus: measured.genus.or(Some(mesh.genus.into())),
        ..measured
    }
}
