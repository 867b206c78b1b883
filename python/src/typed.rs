//! Arrays with the types that stand for them in the stub, which is made of the signatures here.

use std::convert::Infallible;
use std::marker::PhantomData;

use numpy::PyArray;
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::{type_hint_identifier, type_hint_subscript};

/// Makes the type of an array from that of its elements.
macro_rules! array_of {
    ($module:expr, $name:expr) => {
        type_hint_subscript!(
            type_hint_identifier!("numpy.typing", "NDArray"),
            type_hint_identifier!($module, $name)
        )
    };
}

/// An argument: an array of any dtype and shape.
pub struct AnyArray<'py>(pub Bound<'py, PyAny>);

impl<'py> FromPyObject<'_, 'py> for AnyArray<'py> {
    type Error = Infallible;

    const INPUT_TYPE: PyStaticExpr = array_of!("typing", "Any");

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> Result<Self, Infallible> {
        Ok(Self(object.to_owned()))
    }
}

/// A result: an array of `T` of any shape.
pub struct NewArray<'py, T>(Bound<'py, PyAny>, PhantomData<T>);

impl<'py, T> NewArray<'py, T> {
    /// Takes an array of any number of dimensions.
    pub fn new<D>(array: Bound<'py, PyArray<T, D>>) -> Self {
        Self(array.into_any(), PhantomData)
    }
}

/// An element of arrays, with its name in numpy.
pub trait Dtype {
    const NAME: &str;
}

impl Dtype for u32 {
    const NAME: &str = "uint32";
}

impl Dtype for i64 {
    const NAME: &str = "int64";
}

impl Dtype for f64 {
    const NAME: &str = "float64";
}

impl<'py, T: Dtype> IntoPyObject<'py> for NewArray<'py, T> {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = Infallible;

    const OUTPUT_TYPE: PyStaticExpr = array_of!("numpy", T::NAME);

    fn into_pyobject(self, _: Python<'py>) -> Result<Self::Output, Infallible> {
        Ok(self.0)
    }
}
