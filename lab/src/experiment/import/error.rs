//! Faults of a file of results.

/// Characters that the name of an algorithm may have.
pub(super) const LONGEST_NAME: usize = 60;

/// Reason why a file cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// It is no table of comma-separated values.
    #[error("it cannot be read: {0}")]
    Csv(#[from] csv::Error),
    /// Its values are separated otherwise.
    #[error(
        "its values are separated by {0}; save it with commas between values, and points in numbers"
    )]
    Separator(&'static str),
    /// A row has more or fewer fields than the first line.
    #[error(
        "line {line}: {fields} where the first line has {names}; a comma within a field needs \
         quotes round the field, and numbers have a point"
    )]
    Fields {
        /// Line, from 1.
        line: u64,
        /// Number of its fields, in words.
        fields: String,
        /// Number of fields of the first line.
        names: u64,
    },
    /// The name of the algorithm would break tables, or be a formula in them.
    #[error(
        "no algorithm can be called {0:?}: give it a name of up to {longest} characters, the first \
         of them a letter or digit, none a line break",
        longest = LONGEST_NAME
    )]
    Name(String),
    /// There is no column for the mesh.
    #[error("no column says which mesh; {}", mesh_of(.column.as_deref(), .has))]
    NoMesh {
        /// A column with names of meshes, which was mapped otherwise.
        column: Option<String>,
        /// The columns of the file.
        has: String,
    },
    /// A column is not known; it has names of meshes, and no other column is that of the mesh.
    #[error("the column {0:?} is not known; its values are names of meshes: --map \"{0}=mesh\"")]
    UnknownMeshColumn(String),
    /// There is no column with a number.
    #[error("no column has a number; map one to it: --map \"NAME=total_seconds\"")]
    NoNumber,
    /// There are no rows.
    #[error("it has no rows")]
    NoRows,
    /// A column is not known.
    #[error("the column {name:?} is not known; {}", remedy_of(.name, .nearest.as_deref()))]
    UnknownColumn {
        /// The column.
        name: String,
        /// The known name that is probably meant.
        nearest: Option<String>,
    },
    /// A mapping leads to no known name.
    #[error(
        "--map: {name:?} is no column of runs.csv{}",
        .nearest.as_ref().map_or(EXAMPLES.into(), |one| format!("; the nearest is {one:?}"))
    )]
    UnknownTarget {
        /// The name.
        name: String,
        /// The known name that is probably meant.
        nearest: Option<String>,
    },
    /// A mapping is of a column that the file does not have.
    #[error("--map: the file has no column {name:?}; it has {has}")]
    UnknownSource {
        /// The name.
        name: String,
        /// The columns of the file.
        has: String,
    },
    /// Two columns would be the same.
    #[error("two columns are {0:?}; leave one out: --map \"NAME=-\"")]
    Twice(String),
    /// A mesh is not known.
    #[error(
        "line {line}: {name:?} is no mesh of the papers; --other-meshes takes it in as a mesh of \
         your own{}",
        .nearest.as_ref().map_or(String::new(), |one| format!(", or {one:?} is meant"))
    )]
    UnknownMesh {
        /// Line, from 1.
        line: u64,
        /// The mesh.
        name: String,
        /// The known mesh that is most like it, if it is but a slip away.
        nearest: Option<String>,
    },
    /// A row does not say of which mesh it is.
    #[error("line {line}, column {column:?}: it is empty; every row needs a mesh")]
    EmptyMesh {
        /// Line, from 1.
        line: u64,
        /// The column, as in the file.
        column: String,
    },
    /// A row that ended well has no number.
    #[error(
        "line {line}, column {column:?}: it is empty, and the row has no other number; leave the \
         row out, or name how the run ended in a column \"outcome\""
    )]
    EmptyRow {
        /// Line, from 1.
        line: u64,
        /// The first column with a number, as in the file.
        column: String,
    },
    /// A field is not what its column is.
    #[error("line {line}, column {column:?}: {value:?} is no {expected}")]
    BadField {
        /// Line, from 1.
        line: u64,
        /// The column, as in the file.
        column: String,
        /// The text there.
        value: String,
        /// The expected text.
        expected: &'static str,
    },
    /// A number is outside of what its column may be.
    #[error("line {line}, column {column:?}: {value} must be {bounds}")]
    OutOfRange {
        /// Line, from 1.
        line: u64,
        /// The column, as in the file.
        column: String,
        /// The number.
        value: String,
        /// What it may be.
        bounds: &'static str,
    },
    /// A count is greater than the mesh allows.
    #[error("line {line}, column {column:?}: {value} is too many: {mesh} has {all} {what}")]
    TooMany {
        /// Line, from 1.
        line: u64,
        /// The column, as in the file.
        column: String,
        /// The count.
        value: u64,
        /// The mesh.
        mesh: String,
        /// Number of what is counted in the mesh.
        all: u64,
        /// What that is.
        what: &'static str,
    },
    /// A total is not the sum of its parts.
    #[error(
        "line {line}, column {column:?}: {total} is not pairing_seconds + augmentation_seconds, \
         which is {sum}; correct it, or leave the column out: --map \"{column}=-\""
    )]
    Total {
        /// Line, from 1.
        line: u64,
        /// The column, as in the file.
        column: String,
        /// The given total.
        total: String,
        /// The sum.
        sum: String,
    },
    /// A total is less than the one of its parts that is known.
    #[error(
        "line {line}, column {column:?}: {total} is less than {part}, which is {seconds}; correct \
         it, or leave the column out: --map \"{column}=-\""
    )]
    TotalOfPart {
        /// Line, from 1.
        line: u64,
        /// The column, as in the file.
        column: String,
        /// The given total.
        total: String,
        /// The part.
        part: &'static str,
        /// Its time.
        seconds: String,
    },
}

/// Examples of columns.
const EXAMPLES: &str = ", as \"total_seconds\" and \"unpaired_triangles\" are";

/// Returns which column to map to the mesh.
fn mesh_of(column: Option<&str>, has: &str) -> String {
    match column {
        Some(column) => {
            format!("the values of {column:?} are names of meshes: --map \"{column}=mesh\"")
        }
        None => format!("map one to it: --map \"NAME=mesh\" with a column of the file: {has}"),
    }
}

/// Returns what to do about a column that is not known.
fn remedy_of(name: &str, nearest: Option<&str>) -> String {
    let leave_out = format!("--map \"{name}=-\" to leave it out");
    match nearest {
        Some(nearest) => {
            format!("the nearest name is {nearest:?}: --map \"{name}={nearest}\", or {leave_out}")
        }
        None => {
            format!("--map \"{name}=NAME\" with a column of runs.csv{EXAMPLES}, or {leave_out}")
        }
    }
}
