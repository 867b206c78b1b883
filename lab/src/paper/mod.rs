//! Printed content of the two papers: their tables row by row, and what is known to be wrong with
//! them.
//!
//! The files are part of the program; `experiments/paper/README.md` explains every column.
//! `tests/lab/paper_tables/` recomputes them and finds exactly the rows whose errata are not empty.

mod rows;

pub use rows::{LinkTestRow, MeshRow, PairingRow, RatioRow};

use serde::Deserialize;
use serde::de::DeserializeOwned;
use triquad::irreducible::Contractor;
use triquad::pairing::{Algorithm, Expansion};

use crate::experiment::job::UnknownNameError;
use crate::experiment::{Job, Task};

/// One of the two papers, and the experiment that repeats it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Paper {
    /// Lemos, Ramaswami and Siqueira, on the conversion of triangulations.
    Comparison,
    /// Ramaswami and Siqueira, on irreducible triangulations.
    Irreducible,
}

/// Content of the rows of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableKind {
    /// [`MeshRow`]s.
    Meshes,
    /// [`PairingRow`]s.
    Pairings,
    /// [`LinkTestRow`]s.
    LinkTests,
    /// [`RatioRow`]s.
    Ratios,
}

/// A printed table; a part of it where its parts are tables of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Table {
    /// The paper; the two number differently, so that a number gives it too.
    pub paper: Paper,
    /// Its number in the paper.
    pub number: &'static str,
    /// Group of its meshes in the experiment.
    pub group: &'static str,
    /// Its content in a few words.
    pub title: &'static str,
    /// Its rows.
    pub kind: TableKind,
    /// Its file in `experiments/paper/`.
    pub file: &'static str,
    /// The file: comma-separated values, their names in the first line.
    pub text: &'static str,
}

/// A table, with its file in `experiments/paper/`.
macro_rules! table {
    ($paper:ident, $number:literal, $kind:ident, $group:literal, $title:literal, $file:literal) => {
        Table {
            paper: Paper::$paper,
            number: $number,
            group: $group,
            title: $title,
            kind: TableKind::$kind,
            file: $file,
            text: include_str!(concat!("../../experiments/paper/", $file)),
        }
    };
}

impl Table {
    /// Every table, in the order of the papers.
    pub const ALL: [Self; 16] = [
        table!(Comparison, "4.1", Meshes, "scans", "Scans", "table_4_1.csv"),
        table!(Comparison, "4.2(a)", Meshes, "A", "Boxes of genus 0", "table_4_2_a.csv"),
        table!(Comparison, "4.2(b)", Meshes, "B", "Boxes of genus 3,500", "table_4_2_b.csv"),
        table!(Comparison, "4.3", Pairings, "scans", "SG, PS, DS, LRS on scans", "table_4_3.csv"),
        table!(Comparison, "4.4(i)", Pairings, "A", "PS and LRS on A1 to A5", "table_4_4_i.csv"),
        table!(Comparison, "4.4(ii)", Pairings, "B", "PS and LRS on B1 to B5", "table_4_4_ii.csv"),
        table!(Irreducible, "2", Meshes, "scans", "Scans", "table_2.csv"),
        table!(Irreducible, "3", Meshes, "B", "Boxes of genus 0", "table_3.csv"),
        table!(Irreducible, "4", Meshes, "C", "Boxes of genus 3,500", "table_4.csv"),
        table!(Irreducible, "5", Meshes, "D", "Boxes of genus 10 to 3,500", "table_5.csv"),
        table!(
            Irreducible,
            "6",
            LinkTests,
            "B",
            "Link condition tests, second group",
            "table_6.csv"
        ),
        table!(Irreducible, "7", Ratios, "B", "Ratios, second group", "table_7.csv"),
        table!(
            Irreducible,
            "8",
            LinkTests,
            "C",
            "Link condition tests, third group",
            "table_8.csv"
        ),
        table!(Irreducible, "9", Ratios, "C", "Ratios, third group", "table_9.csv"),
        table!(
            Irreducible,
            "10",
            LinkTests,
            "D",
            "Link condition tests, fourth group",
            "table_10.csv"
        ),
        table!(Irreducible, "11", Ratios, "D", "Ratios, fourth group", "table_11.csv"),
    ];

    /// Returns the tables of a paper with rows of a kind.
    pub fn of_kind(paper: Paper, kind: TableKind) -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(move |table| (table.paper, table.kind) == (paper, kind))
    }

    /// Returns every mesh of a table of pairings with each of the four algorithms, and the printed
    /// row.
    pub fn pairing_jobs(&self) -> Vec<(String, Job, Option<PairingRow>)> {
        let rows = self.pairing_rows();
        let mut meshes: Vec<&str> = rows.iter().map(|row| row.mesh.as_str()).collect();
        meshes.dedup();
        let with_row = |mesh: &str, job: Job| {
            (mesh.to_owned(), job, PairingRow::find(&rows, mesh, job).cloned())
        };
        let jobs = |mesh| Paper::Comparison.jobs().iter().map(move |&job| with_row(mesh, job));
        meshes.into_iter().flat_map(jobs).collect()
    }

    /// Returns the table of that number, such as `4.3`, `4.4(ii)` or `11`.
    pub fn numbered(number: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|table| table.number == number)
    }

    /// Returns the table of that number, or of the file called so, with or without its ending.
    ///
    /// # Errors
    /// There is no such table.
    pub fn named(name: &str) -> Result<Self, UnknownNameError> {
        let stem = name.trim_end_matches(".csv");
        let is_file = |table: &Self| table.file.trim_end_matches(".csv") == stem;
        let found = Self::numbered(name).or_else(|| Self::ALL.into_iter().find(is_file));
        found.ok_or_else(|| UnknownNameError::new(name, &Self::ALL.map(|table| table.number)))
    }

    /// Returns the rows of a table of meshes; of another, none.
    pub fn mesh_rows(&self) -> Vec<MeshRow> {
        self.rows_if(TableKind::Meshes)
    }

    /// Returns the rows of a table of pairings; of another, none.
    pub fn pairing_rows(&self) -> Vec<PairingRow> {
        self.rows_if(TableKind::Pairings)
    }

    /// Returns the rows of a table of link condition tests; of another, none.
    pub fn link_test_rows(&self) -> Vec<LinkTestRow> {
        self.rows_if(TableKind::LinkTests)
    }

    /// Returns the rows of a table of ratios; of another, none.
    pub fn ratio_rows(&self) -> Vec<RatioRow> {
        self.rows_if(TableKind::Ratios)
    }

    /// Returns the number of its rows that contradict the paper itself.
    pub fn errata(&self) -> usize {
        let mut reader = csv::Reader::from_reader(self.text.as_bytes());
        let names = reader.headers().cloned().unwrap_or_default();
        let place = names.iter().position(|name| name == "errata");
        let has = |row: &csv::StringRecord| place.is_some_and(|place| !row[place].is_empty());
        reader.records().flatten().filter(has).count()
    }

    fn rows_if<Row: DeserializeOwned>(&self, kind: TableKind) -> Vec<Row> {
        if self.kind == kind { parse(self.text) } else { Vec::new() }
    }
}

/// SG, PS, DS and LRS, with the augmentation as published.
static COMPARED: [Job; 4] = [
    Job::published(Algorithm::SimpleGreedy),
    Job::published(Algorithm::PulliSegal),
    Job::published(Algorithm::DiksStanczyk),
    Job::published(Algorithm::Lrs(Expansion::Printed)),
];

/// RS, S and BF, vertices in the order of the file.
static REDUCTIONS: [Job; 3] = [
    Job::in_file_order(Contractor::RamaswamiSiqueira),
    Job::in_file_order(Contractor::Schipper),
    Job::in_file_order(Contractor::BruteForce),
];

impl Paper {
    /// Returns the jobs that it compares, in the order of its tables.
    pub fn jobs(self) -> &'static [Job] {
        match self {
            Self::Comparison => &COMPARED,
            Self::Irreducible => &REDUCTIONS,
        }
    }

    /// Returns what its algorithms make. Records belong to the paper of their task, whatever their
    /// experiment is called.
    pub fn task(self) -> Task {
        match self {
            Self::Comparison => Task::Convert,
            Self::Irreducible => Task::Irreducible,
        }
    }

    /// Returns the paper on a task.
    pub fn on(task: Task) -> Self {
        match task {
            Task::Convert => Self::Comparison,
            Task::Irreducible => Self::Irreducible,
        }
    }

    /// Returns the group of a mesh in its tables; `data` for a mesh that it does not have.
    pub fn group_of(self, mesh: &str) -> &'static str {
        let has = |table: &Table| table.mesh_rows().iter().any(|row| row.mesh == mesh);
        Table::of_kind(self, TableKind::Meshes).find(has).map_or("data", |table| table.group)
    }

    /// Returns the name of its experiment in records.
    pub fn experiment(self) -> &'static str {
        match self {
            Self::Comparison => "comparison",
            Self::Irreducible => "irreducible",
        }
    }

    /// Returns authors, title, year, venue and identifiers of each version, as printed or as arXiv
    /// has them.
    pub fn citations(self) -> &'static [&'static str] {
        match self {
            Self::Comparison => &[
                "Thiago Lemos, Suneeta Ramaswami and Marcelo Siqueira: An Experimental Comparison \
                 of Algorithms for Converting Triangulations of Closed Surfaces into \
                 Quadrangulations. Research note, 24th International Meshing Roundtable (IMR24), \
                 Elsevier, 2015, ISSN 1877-7058; no DOI is printed. Its Table 1 is Table 4.3",
                "The same authors and title: long version, 2015, \
                 http://clam.rutgers.edu/~rsuneeta/hpc/research/imr15_long.pdf. Sections and \
                 tables here are numbered as there",
            ],
            Self::Irreducible => {
                &["Suneeta Ramaswami and Marcelo Siqueira: A fast algorithm for computing \
                 irreducible triangulations of closed surfaces in E^d. CoRR arXiv:1409.6015, 2014, \
                 DOI 10.48550/arXiv.1409.6015"]
            }
        }
    }
}

/// Parses the rows of a file, which is known to have these columns.
fn parse<Row: DeserializeOwned>(text: &str) -> Vec<Row> {
    let rows = csv::Reader::from_reader(text.as_bytes()).into_deserialize();
    rows.collect::<Result<_, _>>().expect("a file of experiments/paper has these columns")
}
