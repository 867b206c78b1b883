//! Values of a binary PLY file, in either byte order.

use super::header::{Element, Kind, Layout, Property, Scalar};
use super::source::{Source, exact_index};
use crate::mesh::error::{MeshError, Place};
use crate::mesh::faces::{Faces, MAX_CORNERS};
use crate::mesh::tokens;

/// The values of a binary file.
pub(super) struct Binary<'a, const BIG_ENDIAN: bool> {
    bytes: &'a [u8],
    position: usize,
}

impl<'a, const BIG_ENDIAN: bool> Binary<'a, BIG_ENDIAN> {
    /// Begins at byte `position`, where the header ends.
    pub(super) fn new(bytes: &'a [u8], position: usize) -> Self {
        Self { bytes, position }
    }

    /// Takes the next `N` bytes and returns them with the least significant first.
    #[inline]
    fn take<const N: usize>(&mut self) -> Result<[u8; N], MeshError> {
        let rest = &self.bytes[self.position..];
        let value = *rest.first_chunk().ok_or_else(|| tokens::truncated("a value"))?;
        self.position += N;
        Ok(Self::least_first(value))
    }

    #[inline]
    fn least_first<const N: usize>(mut value: [u8; N]) -> [u8; N] {
        if BIG_ENDIAN {
            value.reverse();
        }
        value
    }

    /// Reads the next value. 64-bit floating point numbers hold all of them exactly.
    #[inline]
    fn value(&mut self, kind: Scalar) -> Result<f64, MeshError> {
        Ok(match kind {
            Scalar::I8 => i8::from_le_bytes(self.take()?).into(),
            Scalar::U8 => u8::from_le_bytes(self.take()?).into(),
            Scalar::I16 => i16::from_le_bytes(self.take()?).into(),
            Scalar::U16 => u16::from_le_bytes(self.take()?).into(),
            Scalar::I32 => i32::from_le_bytes(self.take()?).into(),
            Scalar::U32 => u32::from_le_bytes(self.take()?).into(),
            Scalar::F32 => f32::from_le_bytes(self.take()?).into(),
            Scalar::F64 => f64::from_le_bytes(self.take()?),
        })
    }

    /// Reads up to `count` records of `layout`, with coordinates decoded by `decode`.
    fn positions<const N: usize>(
        &mut self,
        count: usize,
        layout: &Layout,
        positions: &mut Vec<[f64; 3]>,
        decode: impl Fn([u8; N]) -> f64,
    ) -> usize {
        let records = self.bytes[self.position..].chunks_exact(layout.size).take(count);
        let whole = records.len();
        positions.extend(records.map(|record| {
            layout.coordinates.map(|at| {
                let value = *record[at..].first_chunk().expect("the coordinate is in the record");
                decode(Self::least_first(value))
            })
        }));
        self.position += whole * layout.size;
        whole
    }

    /// Returns the corners of the next face: a count of one byte, then 4 bytes each. None if the
    /// face is not whole.
    #[inline]
    fn next_corners(&self) -> Option<&'a [[u8; 4]]> {
        let (&arity, rest) = self.bytes[self.position..].split_first()?;
        rest.as_chunks::<4>().0.get(..arity.into())
    }
}

impl<const BIG_ENDIAN: bool> Source for Binary<'_, BIG_ENDIAN> {
    #[inline]
    fn coordinate(&mut self, kind: Scalar) -> Result<f64, MeshError> {
        self.value(kind)
    }

    #[inline]
    fn index(&mut self, kind: Scalar, expected: &str) -> Result<u32, MeshError> {
        let place = Place::Byte(self.position);
        let value = self.value(kind)?;
        exact_index(value)
            .ok_or_else(|| MeshError::malformed(place, format!("{value} is not {expected}")))
    }

    fn index_or_restart(&mut self, kind: Scalar) -> Result<Option<u32>, MeshError> {
        let position = self.position;
        if self.value(kind)? == -1.0 {
            return Ok(None);
        }
        self.position = position;
        self.index(kind, "a vertex index").map(Some)
    }

    fn skip(&mut self, kind: Scalar, times: usize) -> Result<(), MeshError> {
        let end = times.checked_mul(kind.size()).and_then(|size| self.position.checked_add(size));
        let end = end.filter(|&end| end <= self.bytes.len());
        self.position = end.ok_or_else(|| tokens::truncated("a value"))?;
        Ok(())
    }

    fn least_size(&self, kind: Scalar) -> usize {
        kind.size()
    }

    fn rest(&self) -> &[u8] {
        &self.bytes[self.position..]
    }

    fn whole_vertices(&mut self, element: &Element, positions: &mut Vec<[f64; 3]>) -> usize {
        match element.layout() {
            Some((Scalar::F32, layout)) => {
                self.positions(element.count, &layout, positions, |x| f32::from_le_bytes(x).into())
            }
            Some((Scalar::F64, layout)) => {
                self.positions(element.count, &layout, positions, f64::from_le_bytes)
            }
            _ => 0,
        }
    }

    fn whole_faces(&mut self, element: &Element, faces: &mut Faces) -> usize {
        let [Property { kind: Kind::List { count: Scalar::U8, item }, .. }] =
            element.properties[..]
        else {
            return 0;
        };
        let largest = match item {
            Scalar::I32 => i32::MAX as u32,
            Scalar::U32 => u32::MAX,
            _ => return 0,
        };
        for done in 0..element.count {
            let Some(corners) = self.next_corners() else { return done };
            let indices = corners.iter().map(|&v| u32::from_le_bytes(Self::least_first(v)));
            let fits = faces.corners().len() + corners.len() <= MAX_CORNERS;
            if !fits || indices.clone().any(|v| v > largest) {
                return done;
            }
            indices.for_each(|v| faces.push_corner(v));
            faces.close_face(corners.len());
            self.position += 1 + 4 * corners.len();
        }
        element.count
    }
}
