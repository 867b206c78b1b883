//! Numpy arrays to vectors, copied once, and vectors to numpy arrays, not copied.
//!
//! The Python half has seen to it that arrays have two dimensions, the right width and a dtype of
//! the right kind, native and aligned. Strides may be any.

use std::fmt::Display;

use numpy::ndarray::ArrayView1;
use numpy::{Element, PyArray1, PyArrayMethods, PyReadonlyArray2};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use triquad::Mesh;

use crate::failure::Failure;
use crate::typed::{AnyArray, NewArray};

/// Vertices that arrays without coordinates may name in any case.
const VERTICES_ALLOWED: usize = 1 << 24;

/// Positions and faces.
pub type MeshArrays<'py> = (NewArray<'py, f64>, NewArray<'py, u32>);

/// Copies rows of three `float64` or `float32`.
pub fn positions(array: &AnyArray<'_>) -> PyResult<Vec<[f64; 3]>> {
    if let Ok(doubles) = array.0.extract::<PyReadonlyArray2<'_, f64>>() {
        return Ok(rows(&doubles, |x| x));
    }
    let singles = array.0.extract::<PyReadonlyArray2<'_, f32>>()?;
    Ok(rows(&singles, f64::from))
}

/// Copies rows of `N` indices of any integer dtype. `name` is that of the argument.
pub fn indices<const N: usize>(name: &str, array: &AnyArray<'_>) -> PyResult<Vec<[u32; N]>> {
    macro_rules! try_each {
        ($($dtype:ty)*) => {$(
            if let Ok(array) = array.0.extract::<PyReadonlyArray2<'_, $dtype>>() {
                return Ok(index_rows(name, &array)?);
            }
        )*};
    }
    try_each!(i64 i32 u32 u64 i16 u16 i8 u8);
    Err(PyTypeError::new_err(format!("{name}: expected integers of at most 64 bits")))
}

/// Makes an array of rows of `width`, not copied.
pub fn table<T: Element>(
    py: Python<'_>,
    values: Vec<T>,
    width: usize,
) -> PyResult<NewArray<'_, T>> {
    let shape = [values.len() / width, width];
    Ok(NewArray::new(PyArray1::from_vec(py, values).reshape(shape)?))
}

/// Makes a mesh of faces of `N` corners on vertices without places.
///
/// # Errors
/// The faces name a vertex so large that the places would not fit in memory.
pub fn faces_alone<const N: usize>(name: &str, faces: Vec<[u32; N]>) -> Result<Mesh, Failure> {
    let count = node_count(name, faces.as_flattened())?;
    let faces = triquad::mesh::Faces::uniform(N, faces.into_flattened());
    Ok(Mesh::new(vec![[0.0; 3]; count], faces))
}

/// Returns the number after the greatest of `nodes`, the nodes of rows of an argument.
///
/// # Errors
/// It is beyond any use.
pub fn node_count(name: &str, nodes: &[u32]) -> Result<usize, Failure> {
    let count = nodes.iter().max().map_or(0, |&greatest| greatest as usize + 1);
    if count > nodes.len().max(VERTICES_ALLOWED) {
        let message = format!(
            "{name}: index {} is too large for {} indices; renumber with numpy.unique(..., \
             return_inverse=True)",
            count - 1,
            nodes.len(),
        );
        return Err(Failure::Value(message));
    }
    Ok(count)
}

/// Copies an array row by row.
fn rows<T: Element + Copy, U, const N: usize>(
    array: &PyReadonlyArray2<'_, T>,
    convert: impl Fn(T) -> U,
) -> Vec<[U; N]> {
    let view = array.as_array();
    match view.as_slice() {
        Some(values) => values.as_chunks().0.iter().map(|row: &[T; N]| row.map(&convert)).collect(),
        None => {
            let row = |row: ArrayView1<'_, T>| std::array::from_fn(|i| convert(row[i]));
            view.rows().into_iter().map(row).collect()
        }
    }
}

/// Copies an array of indices and looks for one that no vertex can have.
fn index_rows<T, const N: usize>(
    name: &str,
    array: &PyReadonlyArray2<'_, T>,
) -> Result<Vec<[u32; N]>, Failure>
where
    T: Element + Copy + Display,
    u32: TryFrom<T>,
{
    let converted = rows(array, |value| u32::try_from(value).unwrap_or(u32::MAX));
    if !converted.as_flattened().contains(&u32::MAX) {
        return Ok(converted);
    }
    let view = array.as_array();
    let mut misfits = view.iter().enumerate().filter(|&(_, &value)| u32::try_from(value).is_err());
    // 2^32 - 1 itself is left to the laws.
    let Some((first, value)) = misfits.next() else { return Ok(converted) };
    let message = format!("{name}: row {} has index {value}", first / N);
    Err(Failure::index(message, first / N, 1 + misfits.count()))
}
