//! The header of an OFF file: the letters before `OFF`, and the counts.

use super::super::error::MeshError;
use super::super::tokens::{self, Tokens};

/// Content of a header.
pub(super) struct Header {
    pub(super) vertices: usize,
    pub(super) faces: usize,
    /// Data of every vertex besides coordinates.
    extra: Vec<Extra>,
}

/// Numbers behind the coordinates of a vertex.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Extra {
    Texture,
    Colours,
    Normals,
}

impl Header {
    /// Reads up to the number of faces. That of edges may be missing.
    pub(super) fn read(tokens: &mut Tokens) -> Result<Self, MeshError> {
        let extra = read_header_word(tokens)?;
        let vertices = tokens.read("the number of vertices", tokens::count)?;
        let faces = tokens.read("the number of faces", tokens::count)?;
        Ok(Self { vertices, faces, extra })
    }

    /// Returns the names of the numbers behind coordinates.
    pub(super) fn extra_names(&self) -> Vec<String> {
        if self.extra.is_empty() {
            return vec!["numbers behind vertex coordinates".into()];
        }
        let name = |extra: &Extra| match extra {
            Extra::Texture => "vertex texture coordinates",
            Extra::Colours => "vertex colours",
            Extra::Normals => "vertex normals",
        };
        self.extra.iter().map(|extra| name(extra).into()).collect()
    }

    /// Returns how many numbers may follow the coordinates of every vertex.
    pub(super) fn extra_counts(&self) -> Vec<usize> {
        let count = |colours: usize| {
            let numbers = |extra: &Extra| match extra {
                Extra::Texture => 2,
                Extra::Colours => colours,
                Extra::Normals => 3,
            };
            self.extra.iter().map(numbers).sum()
        };
        if self.extra.contains(&Extra::Colours) { vec![count(4), count(3)] } else { vec![count(0)] }
    }
}

/// First words of files that are read.
const WORDS: [&str; 8] = ["OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"];

/// Reads `OFF` and the letters before it; returns what they announce.
fn read_header_word(tokens: &mut Tokens) -> Result<Vec<Extra>, MeshError> {
    let word = tokens.next_word().ok_or_else(|| tokens::truncated("the header"))?;
    let off = memchr::memmem::find(word, b"OFF");
    let Some(letters) = off.or_else(|| word.eq_ignore_ascii_case(b"off").then_some(0)) else {
        // The header word may be missing; then this is the number of vertices already.
        tokens::count(word).ok_or_else(|| {
            let cut_off = WORDS.iter().find_map(|whole| tokens.cut_off_within(whole));
            cut_off.unwrap_or_else(|| tokens.unexpected("an OFF header"))
        })?;
        tokens.split_word(0);
        return Ok(Vec::new());
    };
    let extra = vertex_extra(&word[..letters]).map_err(|problem| tokens.malformed(problem))?;
    // Some files continue with the number of vertices without a space.
    tokens.split_word(letters + b"OFF".len());
    refuse_binary(tokens)?;
    Ok(extra)
}

fn refuse_binary(tokens: &mut Tokens) -> Result<(), MeshError> {
    match tokens.next_in_line() {
        Some(b"BINARY") => Err(tokens.malformed("binary OFF files are not read, only text")),
        _ => {
            tokens.split_word(0);
            Ok(())
        }
    }
}

/// Returns what every vertex has besides coordinates, by the letters before `OFF`.
fn vertex_extra(mut letters: &[u8]) -> Result<Vec<Extra>, String> {
    let mut extra = Vec::new();
    while !letters.is_empty() {
        let (one, rest) = match letters {
            [b'S', b'T', rest @ ..] => (Extra::Texture, rest),
            [b'C', rest @ ..] => (Extra::Colours, rest),
            [b'N', rest @ ..] => (Extra::Normals, rest),
            [b'4', ..] => return Err("4OFF files are not read: vertices have 4 coordinates".into()),
            [b'n', ..] => return Err("nOFF files are not read: vertices need 3 coordinates".into()),
            _ => return Err(format!("'{}OFF' is not an OFF header", letters.escape_ascii())),
        };
        extra.push(one);
        letters = rest;
    }
    Ok(extra)
}
