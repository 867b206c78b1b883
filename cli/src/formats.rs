//! The file formats in help texts.

/// Formats that are read and written; .stl is read only.
pub const FORMATS: &str = ".obj .ply .off";

/// Returns the help of an argument that names a mesh to read.
pub fn reads(what: &str) -> String {
    format!("{what}: {FORMATS} .stl, each also with .gz; '-' reads any of them from standard input")
}

/// Returns the help of an option that names a mesh to write.
pub fn writes(what: &str) -> String {
    format!("{what}: {FORMATS}, each also with .gz; '-' writes OBJ to standard output")
}

/// Returns the help of `-o` where it may be left out.
pub fn may_write(what: &str) -> String {
    let tail = "Without it nothing is written but the summary";
    format!("{}. {tail}", writes(what))
}
