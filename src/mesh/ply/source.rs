//! The values of a PLY file: from text here, from bytes in `binary.rs`.

use super::header::{Element, Kind, Scalar};
use crate::mesh::error::MeshError;
use crate::mesh::faces::Faces;
use crate::mesh::tokens::{self, Tokens};

/// A source of values, one after the other.
pub(super) trait Source {
    /// Reads the next value, a coordinate.
    fn coordinate(&mut self, kind: Scalar) -> Result<f64, MeshError>;

    /// Reads the next value, an integer from 0; `expected` names it for the error.
    fn index(&mut self, kind: Scalar, expected: &str) -> Result<u32, MeshError>;

    /// Reads the next value of a strip, a vertex index; none where another strip begins.
    fn index_or_restart(&mut self, kind: Scalar) -> Result<Option<u32>, MeshError>;

    /// Passes over `times` values.
    fn skip(&mut self, kind: Scalar, times: usize) -> Result<(), MeshError>;

    /// Returns the bytes that a value takes at least.
    fn least_size(&self, kind: Scalar) -> usize;

    /// Returns everything that was not read yet.
    fn rest(&self) -> &[u8];

    /// Reads vertices by the record instead of by the value, where their layout allows that.
    ///
    /// Returns their number: up to the first that is wrong.
    fn whole_vertices(&mut self, _: &Element, _: &mut Vec<[f64; 3]>) -> usize {
        0
    }

    /// Reads faces as [`Source::whole_vertices`] reads vertices.
    fn whole_faces(&mut self, _: &Element, _: &mut Faces) -> usize {
        0
    }

    /// Passes over one value of a record.
    fn skip_property(&mut self, kind: Kind) -> Result<(), MeshError> {
        match kind {
            Kind::Scalar(kind) => self.skip(kind, 1),
            Kind::List { count, item } => {
                let count = self.index(count, "the length of a list")?;
                self.skip(item, count as usize)
            }
        }
    }
}

impl Source for Tokens<'_> {
    fn coordinate(&mut self, _: Scalar) -> Result<f64, MeshError> {
        self.read("a coordinate", tokens::float)
    }

    fn index(&mut self, _: Scalar, expected: &str) -> Result<u32, MeshError> {
        // Where the header announces floating point numbers, `3.0` is an index too.
        self.read(expected, |word| {
            tokens::index(word).or_else(|| tokens::float(word).and_then(exact_index))
        })
    }

    fn index_or_restart(&mut self, kind: Scalar) -> Result<Option<u32>, MeshError> {
        let before = *self;
        if self.next_word() == Some(b"-1") {
            return Ok(None);
        }
        *self = before;
        self.index(kind, "a vertex index").map(Some)
    }

    fn skip(&mut self, _: Scalar, times: usize) -> Result<(), MeshError> {
        (0..times).try_for_each(|_| self.read("a value", |_| Some(())))
    }

    fn least_size(&self, _: Scalar) -> usize {
        // A digit and a blank.
        2
    }

    fn rest(&self) -> &[u8] {
        Tokens::rest(self)
    }
}

/// Returns the integer that `value` is, if it is one and fits.
#[inline]
pub(super) fn exact_index(value: f64) -> Option<u32> {
    let index = value as u32; // Saturates, and makes 0 of NaN.
    (f64::from(index) == value).then_some(index)
}
