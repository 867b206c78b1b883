//! Perfect matchings of least cost in any graph.

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use triquad::matching::weighted::{
    Certificate, EdgeList, Integers, NONE, Prices, SolveError, solve_sparse, verify,
};

use crate::arrays::{indices, node_count};
use crate::failure::Failure;
use crate::typed::{AnyArray, NewArray};
use crate::worker;

/// Mates, cost, and the certificate: potentials, innermost sets, parents and values.
type Solved<'py> =
    (NewArray<'py, i64>, i128, Wide<'py>, NewArray<'py, i64>, NewArray<'py, i64>, Wide<'py>);

/// Integers, in a list if 64 bits do not hold them.
#[derive(IntoPyObject)]
pub enum Wide<'py> {
    Array(NewArray<'py, i64>),
    List(Vec<i128>),
}

/// Finds a perfect matching of least cost and verifies its certificate.
#[pyfunction]
pub fn solve<'py>(
    py: Python<'py>,
    edges: AnyArray<'py>,
    costs: AnyArray<'py>,
    nodes: Option<usize>,
    price: Option<i64>,
) -> PyResult<Solved<'py>> {
    let edges = indices::<2>("edges", &edges)?;
    let costs = costs.0.extract::<PyReadonlyArray1<'_, i64>>()?.as_array().to_vec();
    let named = node_count("edges", edges.as_flattened())?;
    let nodes = nodes.unwrap_or(named);
    let solution = worker::run(py, 0, move |cancel| {
        let edges: Vec<(u32, u32)> = edges.into_iter().map(Into::into).collect();
        let prices = price.map_or(Prices::None, Prices::Equal);
        let problem = EdgeList::new(nodes, &edges, &costs).with_prices(prices);
        let solution = solve_sparse(&problem, &mut |_| cancel.flow()).map_err(failure)?;
        let proved = verify(&problem, &solution, &solution.certificate);
        proved.map_err(|error| Failure::Value(format!("please report this: {error}")))?;
        Ok(solution)
    })?;
    let Certificate { potentials, innermost, parents, values } = solution.certificate;
    Ok((
        numbers(py, &solution.mates),
        solution.cost,
        wide(py, &potentials),
        numbers(py, &innermost),
        numbers(py, &parents),
        wide(py, &values),
    ))
}

fn failure(error: SolveError) -> Failure {
    match error {
        SolveError::Infeasible(barrier) => Failure::Infeasible(barrier.nodes),
        SolveError::Stopped { .. } => Failure::Stopped,
        SolveError::NoSuchNode(node) => {
            Failure::Value(format!("edges: node {node} is not below the number of nodes"))
        }
        error => Failure::Value(format!("edges: {error}")),
    }
}

/// Makes an array of numbers of nodes or sets, with -1 for none.
fn numbers<'py>(py: Python<'py>, values: &[u32]) -> NewArray<'py, i64> {
    let number = |&value: &u32| if value == NONE { -1 } else { i64::from(value) };
    NewArray::new(PyArray1::from_iter(py, values.iter().map(number)))
}

fn wide<'py>(py: Python<'py>, values: &Integers) -> Wide<'py> {
    let all = (0..values.len()).map(|i| values.at(i));
    match all.clone().map(i64::try_from).collect::<Result<Vec<_>, _>>() {
        Ok(values) => Wide::Array(NewArray::new(PyArray1::from_vec(py, values))),
        Err(_) => Wide::List(all.collect()),
    }
}
