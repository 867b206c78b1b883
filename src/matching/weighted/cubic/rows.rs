//! All nodes, and how they are read.

use std::ops::Range;

use super::super::nodes::NONE;
use super::super::number::{Number, doubled};
use super::super::places::Places;
use super::super::problem::CubicProblem;
use super::super::refusal::Refusal;
use super::read::{joined_rows, open_rows};
use super::row::{EMPTY, Row};
use super::view::Cubic;
use crate::parallel::map;

/// A graph in which no node has more than three sides.
pub(crate) struct Rows<N: Number> {
    rows: Vec<Row<N>>,
    /// Empty if no node has one.
    prices: Vec<Option<N>>,
}

impl<N: Number> Rows<N> {
    /// Greatest number of nodes: half-edges and blossoms beyond them are numbered with 32 bits.
    pub(crate) const MOST_NODES: usize = (u32::MAX / 5) as usize;

    /// Reads a problem, its nodes in their places. O(n).
    ///
    /// Edges inside each of the `ranges`, which divide all places, are joined at once.
    pub(crate) fn new(
        problem: &impl CubicProblem,
        places: &Places,
        ranges: impl Iterator<Item = Range<u32>>,
    ) -> Result<Self, Refusal> {
        let count = problem.node_count();
        let rows = match joined_rows(problem, places)? {
            Some(rows) => rows,
            None => {
                let mut rows = open_rows(problem, places)?;
                join_all(&mut rows, ranges)?;
                rows
            }
        };
        let all = 0..count as u32;
        let price = |place| problem.price(places.node_at(place));
        let prices = if all.clone().any(|place| price(place).is_some()) {
            all.map(|place| price(place).map(doubled).transpose()).collect::<Result<_, _>>()?
        } else {
            Vec::new()
        };
        Ok(Self { rows, prices })
    }

    /// Returns the number of nodes.
    pub(crate) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns a view of all nodes.
    pub(crate) fn whole(&mut self) -> Cubic<'_, N, false> {
        let count = self.rows.len() as u32;
        Cubic { rows: &mut self.rows, prices: &self.prices, first: 0, count }
    }

    /// Returns views of ranges of nodes, which divide them all in order.
    pub(crate) fn parts(
        &mut self,
        ranges: impl Iterator<Item = Range<u32>>,
    ) -> Vec<Cubic<'_, N, true>> {
        let Self { rows, prices } = self;
        let count = rows.len() as u32;
        let view =
            |(range, rows): (Range<u32>, _)| Cubic { rows, prices, first: range.start, count };
        divide(rows, ranges).map(view).collect()
    }
}

/// Divides rows into those of each range.
fn divide<N: Number>(
    mut rows: &mut [Row<N>],
    ranges: impl Iterator<Item = Range<u32>>,
) -> impl Iterator<Item = (Range<u32>, &mut [Row<N>])> {
    ranges.map(move |range| {
        let (own, rest) = std::mem::take(&mut rows).split_at_mut(range.len());
        rows = rest;
        (range, own)
    })
}

/// Makes twins of all sides: first in each of the ranges, then between them.
///
/// Several edges between two nodes correspond by cost, equal ones in the order of the sides.
fn join_all<N: Number>(
    rows: &mut [Row<N>],
    ranges: impl Iterator<Item = Range<u32>>,
) -> Result<(), Refusal> {
    let count = rows.len() as u32;
    let join_part = |(range, rows): (Range<u32>, &mut [Row<N>])| {
        let mut open = Vec::new();
        for node in range.clone() {
            if !join(rows, range.start, count, node)? {
                open.push(node);
            }
        }
        Ok(open)
    };
    let open = map(divide(rows, ranges).collect(), join_part);
    let open = open.into_iter().collect::<Result<Vec<_>, _>>()?;
    open.into_iter().flatten().try_for_each(|node| join(rows, 0, count, node).map(|_| ()))
}

/// Makes twins of a node's sides to later nodes in these rows, which begin with that of `first`;
/// those to earlier ones have been made. Returns whether all its sides have their twins then.
///
/// Bit i of a state is set if side i has its twin.
#[inline]
fn join<N: Number>(
    rows: &mut [Row<N>],
    first: u32,
    count: u32,
    node: u32,
) -> Result<bool, Refusal> {
    let range = first..first + rows.len() as u32;
    let row = rows[(node - first) as usize];
    let mut joined: u64 = row.state.into();
    let mut is_whole = true;
    for side in 0..3 {
        let neighbour = row.twins[side];
        if joined >> side & 1 != 0 || neighbour == NONE {
            continue;
        }
        if neighbour >= count {
            return Err(Refusal::NoSuchNode(neighbour));
        }
        if !range.contains(&neighbour) {
            is_whole = false;
            continue;
        }
        let asymmetric = Refusal::Asymmetric(node, neighbour);
        if neighbour < node {
            return Err(asymmetric);
        }
        let other = &mut rows[(neighbour - first) as usize];
        let theirs: u64 = other.state.into();
        // Bit i stands for side i. Which one leads back is hard to predict: nothing branches.
        let is_back = |i: usize| other.twins[i] == node && other.costs[i] == row.costs[side];
        let leads_back = |i: usize| u64::from(is_back(i)) << i;
        let open = (leads_back(0) | leads_back(1) | leads_back(2)) & !theirs;
        if open == 0 {
            return Err(asymmetric);
        }
        let back = open.trailing_zeros() as usize;
        other.twins[back] = 4 * node + side as u32;
        other.state = N::state(theirs | 1 << back);
        rows[(node - first) as usize].twins[side] = 4 * neighbour + back as u32;
        joined |= 1 << side;
    }
    rows[(node - first) as usize].state = N::state(if is_whole { EMPTY } else { joined });
    Ok(is_whole)
}
