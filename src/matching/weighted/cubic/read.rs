//! A problem is read into rows.

use std::sync::atomic::{AtomicBool, Ordering};

use super::super::nodes::NONE;
use super::super::number::{Number, doubled};
use super::super::places::Places;
use super::super::problem::{CubicProblem, NONE as NO_NODE};
use super::super::refusal::Refusal;
use super::row::{EMPTY, Row};
use crate::parallel::collect;

/// Reads all nodes, each in its place; the places of neighbours stand for twins. O(n).
pub(super) fn open_rows<N: Number>(
    problem: &impl CubicProblem,
    places: &Places,
) -> Result<Vec<Row<N>>, Refusal> {
    read(problem, places, |_, _, neighbour, _| Some(places.place_of(neighbour)))
        .map(|rows| rows.expect("every neighbour has a place"))
}

/// Reads all nodes with their twins, if the problem has these at hand. There are no rows where they
/// disagree in a cost, or lead nowhere. O(n).
pub(super) fn joined_rows<N: Number>(
    problem: &impl CubicProblem,
    places: &Places,
) -> Result<Option<Vec<Row<N>>>, Refusal> {
    let count = problem.node_count() as u32;
    if count == 0 || problem.backs(0).is_none() {
        return Ok(None);
    }
    read(problem, places, |node, side, neighbour, cost| {
        let back = problem.backs(node)?[side];
        if neighbour >= count || back > 2 {
            return None;
        }
        let agrees = problem.costs(neighbour)[usize::from(back)] == cost;
        agrees.then(|| 4 * places.place_of(neighbour) + u32::from(back))
    })
}

/// Reads all nodes. `twin` returns what stands for a twin, of a node, its side, the neighbour and
/// the cost; if it has nothing once, there are no rows.
fn read<N: Number>(
    problem: &impl CubicProblem,
    places: &Places,
    twin: impl Fn(u32, usize, u32, i128) -> Option<u32> + Sync + Send,
) -> Result<Option<Vec<Row<N>>>, Refusal> {
    let [is_too_narrow, lacks_twin] = [const { AtomicBool::new(false) }; 2];
    let double = |cost| {
        doubled(cost).unwrap_or_else(|_| {
            is_too_narrow.store(true, Ordering::Relaxed);
            N::ZERO
        })
    };
    let row = |place: usize| {
        let node = places.node_at(place as u32);
        let neighbours = problem.neighbours(node);
        let costs = problem.costs(node);
        let mut row = Row {
            twins: [NONE; 3],
            costs: [N::ZERO; 3],
            potential: N::ZERO,
            state: N::state(EMPTY),
        };
        let mut least = problem.price(node).map(&double);
        for (side, neighbour) in neighbours.into_iter().enumerate() {
            if neighbour != NO_NODE && neighbour != node {
                row.twins[side] = twin(node, side, neighbour, costs[side]).unwrap_or_else(|| {
                    lacks_twin.store(true, Ordering::Relaxed);
                    NONE
                });
                row.costs[side] = double(costs[side]);
                let half = row.costs[side].half();
                least = Some(least.map_or(half, |least| least.min(half)));
            }
        }
        row.potential = least.unwrap_or(N::ZERO);
        row
    };
    let rows = collect(problem.node_count(), row);
    if is_too_narrow.into_inner() {
        return Err(Refusal::TooNarrow);
    }
    Ok((!lacks_twin.into_inner()).then_some(rows))
}
