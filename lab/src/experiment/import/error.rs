//! Faults of a file of results.

/// Characters that the name of an algorithm may have.
pub(super) const LONGEST_NAME: usize = 60;

/// Reason why a file cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// It is no table of comma-separated values.
    #[error("it cannot be read: {0}")]
    Csv(#[from] csv::Error),
    /// The name of the algorithm would break tables, or be a formula in them.
    #[error(
        "no algorithm can be called {0:?}: give it a name of up to {longest} characters, the first \
         of them a letter or digit, none a line break",
        longest = LONGEST_NAME
    )]
    Name(String),
    /// There is no column for the mesh.
    #[error("no column says which mesh; map one to it: --map \"NAME=mesh\"")]
    NoMesh,
    /// There is no column with a number.
    #[error("no column has a number; map one to it: --map \"NAME=total_seconds\"")]
    NoNumber,
    /// There are no rows.
    #[error("it has no rows")]
    NoRows,
    /// A column is not known.
    #[error(
        "the column {name:?} is not known; the nearest name is {nearest:?}: --map \
         \"{name}={nearest}\", or --map \"{name}=-\" to leave it out"
    )]
    UnknownColumn {
        /// The column.
        name: String,
        /// The known name that is most like it.
        nearest: String,
    },
    /// A mapping leads to no known name.
    #[error("--map: {name:?} is no column of runs.csv; the nearest is {nearest:?}")]
    UnknownTarget {
        /// The name.
        name: String,
        /// The known name that is most like it.
        nearest: String,
    },
    /// A mapping is of a column that the file does not have.
    #[error("--map: the file has no column {name:?}; the nearest is {nearest:?}")]
    UnknownSource {
        /// The name.
        name: String,
        /// The column that is most like it.
        nearest: String,
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
    /// A field is not what its column is.
    #[error("line {line}, column {column:?}: {value:?} is no {expected}")]
    BadField {
        /// Line, from 1.
        line: u64,
        /// The column, as in `runs.csv`.
        column: String,
        /// The text there.
        value: String,
        /// The expected text.
        expected: &'static str,
    },
}
