//! The native half of the Python package `triquad`: arrays in, arrays and JSON out.
//!
//! `arrays` copies numpy arrays, `typed` has their types, `failure` makes exceptions, `worker` runs
//! a call so that it can be interrupted; each other file has the functions of one subject. Names,
//! defaults, types and documentation are in the Python half, `triquad/`.

mod arrays;
mod convert;
mod failure;
mod files;
mod inspect;
mod matching;
mod reduce;
mod repair;
mod typed;
mod worker;

/// Functions behind the package `triquad`; not to be called directly.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use super::convert::{convert, pair};
    #[pymodule_export]
    use super::files::{read, write};
    #[pymodule_export]
    use super::inspect::{check, survey};
    #[pymodule_export]
    use super::matching::solve;
    #[pymodule_export]
    use super::reduce::{irreducible, simplify};
    #[pymodule_export]
    use super::repair::{clean, weld};
}
