//! What the two papers print: their tables row by row, what is known to be wrong with them, and
//! what stands in their sentences only.
//!
//! The files are part of the library; `experiments/paper/README.md` explains every column.
//! `tests/paper_tables/` recomputes them and finds exactly the rows whose errata are not empty.

mod rows;

pub use rows::{LinkTestRow, MeshRow, PairingRow, RatioRow, TextErratum, TextRow};

use serde::de::DeserializeOwned;

/// One of the two papers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paper {
    /// Lemos, Ramaswami and Siqueira, on the conversion of triangulations.
    Comparison,
    /// Ramaswami and Siqueira, on irreducible triangulations.
    Irreducible,
}

/// What the rows of a table are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
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
    paper: Paper,
    number: &'static str,
    title: &'static str,
    kind: Kind,
    file: &'static str,
    text: &'static str,
}

/// A table, with its file in `experiments/paper/`.
macro_rules! table {
    ($paper:ident, $number:literal, $kind:ident, $title:literal, $file:literal) => {
        Table {
            paper: Paper::$paper,
            number: $number,
            title: $title,
            kind: Kind::$kind,
            file: $file,
            text: include_str!(concat!("../../experiments/paper/", $file)),
        }
    };
}

impl Table {
    /// Every table, in the order of the papers.
    pub const ALL: [Self; 16] = [
        table!(Comparison, "4.1", Meshes, "Scans", "table_4_1.csv"),
        table!(Comparison, "4.2(a)", Meshes, "Boxes of genus 0", "table_4_2_a.csv"),
        table!(Comparison, "4.2(b)", Meshes, "Boxes of genus 3,500", "table_4_2_b.csv"),
        table!(Comparison, "4.3", Pairings, "SG, PS, DS, LRS on scans", "table_4_3.csv"),
        table!(Comparison, "4.4(i)", Pairings, "PS and LRS on A1 to A5", "table_4_4_i.csv"),
        table!(Comparison, "4.4(ii)", Pairings, "PS and LRS on B1 to B5", "table_4_4_ii.csv"),
        table!(Irreducible, "2", Meshes, "Scans", "table_2.csv"),
        table!(Irreducible, "3", Meshes, "Boxes of genus 0", "table_3.csv"),
        table!(Irreducible, "4", Meshes, "Boxes of genus 3,500", "table_4.csv"),
        table!(Irreducible, "5", Meshes, "Boxes of genus 10 to 3,500", "table_5.csv"),
        table!(Irreducible, "6", LinkTests, "Link condition tests, second group", "table_6.csv"),
        table!(Irreducible, "7", Ratios, "Ratios, second group", "table_7.csv"),
        table!(Irreducible, "8", LinkTests, "Link condition tests, third group", "table_8.csv"),
        table!(Irreducible, "9", Ratios, "Ratios, third group", "table_9.csv"),
        table!(Irreducible, "10", LinkTests, "Link condition tests, fourth group", "table_10.csv"),
        table!(Irreducible, "11", Ratios, "Ratios, fourth group", "table_11.csv"),
    ];

    /// The table of that number, such as `4.3`, `4.4(ii)` or `11`.
    pub fn numbered(number: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|table| table.number == number)
    }

    /// Where it is printed; the two papers number differently, so a number says it too.
    pub fn paper(&self) -> Paper {
        self.paper
    }

    /// Its number in the paper.
    pub fn number(&self) -> &'static str {
        self.number
    }

    /// What is in it, in a few words.
    pub fn title(&self) -> &'static str {
        self.title
    }

    /// What its columns mean.
    pub fn caption(&self) -> &'static str {
        match self.kind {
            Kind::Meshes => "Numbers of vertices, edges and triangles, and genus.",
            Kind::Pairings => {
                "(a) Seconds for the initial pairing. (b) Percentage of triangles paired. (c) \
                 Triangles left unpaired. (d) Seconds to make the pairing perfect. (e) Seconds in \
                 all. SG and PS: means of ten runs; DS and LRS: single runs."
            }
            Kind::LinkTests => {
                "ℓ: tests of the link condition. ε: edges tested more than once. BF: means of ten \
                 runs; RS and S: single runs."
            }
            Kind::Ratios => "Ratios of tests of the link condition, ℓ, and of times, t.",
        }
    }

    /// What its rows are.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// Its file in `experiments/paper/`.
    pub fn file(&self) -> &'static str {
        self.file
    }

    /// The file: comma-separated values, their names in the first line.
    pub fn text(&self) -> &'static str {
        self.text
    }

    /// Names of the columns; the last is `errata`.
    pub fn header(&self) -> Vec<String> {
        let mut reader = csv::Reader::from_reader(self.text.as_bytes());
        let names = reader.headers().expect("a line of names");
        names.iter().map(str::to_owned).collect()
    }

    /// The rows, digit by digit as printed, in the order of [`Table::header`].
    pub fn rows(&self) -> Vec<Vec<String>> {
        parse(self.text)
    }

    /// The rows of a table of meshes; of another, none.
    pub fn mesh_rows(&self) -> Vec<MeshRow> {
        self.rows_if(Kind::Meshes)
    }

    /// The rows of a table of pairings; of another, none.
    pub fn pairing_rows(&self) -> Vec<PairingRow> {
        self.rows_if(Kind::Pairings)
    }

    /// The rows of a table of link condition tests; of another, none.
    pub fn link_test_rows(&self) -> Vec<LinkTestRow> {
        self.rows_if(Kind::LinkTests)
    }

    /// The rows of a table of ratios; of another, none.
    pub fn ratio_rows(&self) -> Vec<RatioRow> {
        self.rows_if(Kind::Ratios)
    }

    fn rows_if<Row: DeserializeOwned>(&self, kind: Kind) -> Vec<Row> {
        if self.kind == kind { parse(self.text) } else { Vec::new() }
    }
}

impl Paper {
    /// Authors, title and place.
    pub fn citation(self) -> &'static str {
        match self {
            Self::Comparison => {
                "T. Lemos, S. Ramaswami and M. Siqueira, An Experimental Comparison of Algorithms \
                 for Converting Triangulations of Closed Surfaces into Quadrangulations"
            }
            Self::Irreducible => {
                "S. Ramaswami and M. Siqueira, A fast algorithm for computing irreducible \
                 triangulations of closed surfaces in E^d, CoRR arXiv:1409.6015, 2014"
            }
        }
    }
}

/// The measurements that stand in sentences only.
pub fn printed_in_text() -> Vec<TextRow> {
    parse(include_str!("../../experiments/paper/printed_in_text.csv"))
}

/// The sentences that the tables or other sentences contradict.
pub fn text_errata() -> Vec<TextErratum> {
    parse(include_str!("../../experiments/paper/errata_text.csv"))
}

/// The rows of a file, which is known to have these columns.
fn parse<Row: DeserializeOwned>(text: &str) -> Vec<Row> {
    let rows = csv::Reader::from_reader(text.as_bytes()).into_deserialize();
    rows.collect::<Result<_, _>>().expect("a file of experiments/paper has these columns")
}
