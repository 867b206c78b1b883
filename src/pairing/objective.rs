//! Criteria of a best pairing: costs, edges to keep, triangles that may be left over.
//!
//! Criteria that rank above others are prices that no sum of the others reaches. One minimum-cost
//! matching then answers all of them, and one certificate proves it.

use crate::dual::{DualGraph, Matching};
use crate::matching::weighted::{CubicProblem, Edge, NONE, Problem, cubic_edges};
use crate::triangulation::{EdgeSet, HalfEdgeId, TriangleId};

/// Triangles that a pairing may leave unpaired.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Leftover {
    /// None: the pairing must be perfect.
    #[default]
    None,
    /// As few as can be; that ranks above all costs.
    Fewest,
    /// Any, each at this price, in the unit of the costs.
    Priced(i32),
}

/// Sacrifice for edges to keep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Keeping {
    /// As few of them as can be, that all triangles may be paired that can be.
    #[default]
    AsManyAsCan,
    /// Not one of them; triangles are left over instead.
    All,
}

/// Criteria by which [`best`](super::best) chooses among all pairings.
///
/// The first of these criteria by which two pairings differ decides: with [`Leftover::Fewest`], the
/// triangles left; with [`Keeping::AsManyAsCan`], the edges given up; the total cost, in which
/// [`Leftover::Priced`] includes the prices of the triangles left.
#[derive(Clone, Debug, PartialEq)]
pub struct Objective {
    costs: Vec<[i32; 3]>,
    kept: EdgeSet,
    keeping: Keeping,
    leftover: Leftover,
    /// Price of an edge given up.
    edge_price: i128,
    /// Price of a triangle left, if there may be any.
    price: Option<i128>,
}

impl Objective {
    /// Makes the objective of the perfect pairing of least cost.
    ///
    /// Row `f`, column `i` of `costs` belongs to side `i` of triangle `f`; both sides of an edge
    /// cost the same.
    pub fn perfect(costs: Vec<[i32; 3]>) -> Self {
        Self::new(costs, EdgeSet::default(), Keeping::AsManyAsCan, Leftover::None)
    }

    /// Makes the objective of the best pairing under these rules for edges and triangles.
    ///
    /// The empty set of edges may be that of any surface. O(n).
    ///
    /// # Panics
    /// If there are edges to keep and no costs.
    pub fn new(costs: Vec<[i32; 3]>, kept: EdgeSet, keeping: Keeping, leftover: Leftover) -> Self {
        let prices = Prices::new(&costs, !kept.is_empty());
        let price = match leftover {
            Leftover::None => None,
            Leftover::Fewest => Some(prices.triangle),
            Leftover::Priced(price) => Some(price.into()),
        };
        Self { costs, kept, keeping, leftover, edge_price: prices.edge, price }
    }

    /// Returns the problem of the minimum-cost matching that answers the question in `dual`.
    ///
    /// # Panics
    /// If `dual` does not have as many triangles as there are rows of costs.
    pub fn problem<'a>(&'a self, dual: &'a DualGraph) -> ObjectiveProblem<'a> {
        assert_eq!(dual.len(), self.costs.len(), "one row of costs a triangle");
        ObjectiveProblem { objective: self, dual, is_locked: self.locks() }
    }

    /// Returns the sum of the costs of the pairs of `matching`, and of the prices of the triangles
    /// that it leaves at a price of their own. O(n).
    ///
    /// # Panics
    /// If `dual`, `matching` and the costs differ in the number of triangles.
    pub fn cost(&self, dual: &DualGraph, matching: &Matching) -> i128 {
        let cost = |side: HalfEdgeId| self.costs[side.triangle().index()][side.index() % 3];
        let pairs: i128 = matching.sides(dual).map(|side| i128::from(cost(side))).sum();
        match self.leftover {
            Leftover::Priced(price) => {
                pairs + i128::from(price) * matching.unpaired_count() as i128
            }
            Leftover::None | Leftover::Fewest => pairs,
        }
    }

    /// Returns what [`Objective::cost`] would return for a matching that answers the question, from
    /// the cost of the matching problem. O(1).
    pub(super) fn cost_of_solution(&self, cost: i128, given_up: usize, left: usize) -> i128 {
        let fewest = self.price.filter(|_| self.leftover == Leftover::Fewest).unwrap_or(0);
        cost - fewest * left as i128 - self.edge_price * given_up as i128
    }

    /// Returns the cost of the edge across each side of each triangle.
    pub fn costs(&self) -> &[[i32; 3]] {
        &self.costs
    }

    /// Returns the edges to keep.
    pub fn kept(&self) -> &EdgeSet {
        &self.kept
    }

    /// Returns which triangles may be left.
    pub fn leftover(&self) -> Leftover {
        self.leftover
    }

    /// Returns the price of each triangle left, if there may be any.
    ///
    /// With [`Leftover::Fewest`] it exceeds what all pairs together can cost.
    pub fn price(&self) -> Option<i128> {
        self.price
    }

    /// Returns whether no pair may lie across an edge to keep. At a price for triangles, leaving
    /// two of them is always cheaper than giving up an edge.
    fn locks(&self) -> bool {
        let priced = matches!(self.leftover, Leftover::Priced(_));
        !self.kept.is_empty() && (self.keeping == Keeping::All || priced)
    }
}

/// Prices that no sum of costs reaches.
struct Prices {
    /// Of an edge given up; 0 if none is to be kept.
    edge: i128,
    /// Of a triangle left.
    triangle: i128,
}

impl Prices {
    fn new(costs: &[[i32; 3]], keeps_edges: bool) -> Self {
        let cells = || costs.as_flattened().iter().copied();
        let [least, most] = [cells().min(), cells().max()].map(|cost| cost.unwrap_or(0).into());
        let pairs = costs.len() as i128 / 2;
        // Two pairings of as many pairs differ by less than this in cost.
        let edge = if keeps_edges { pairs * (most - least) + 1 } else { 0 };
        // One pair more, two triangles less: that costs less than a quarter of this, edges given up
        // included. The rest keeps potentials apart, of which the barrier is read.
        let triangle = 4 * ((pairs + 1) * (i128::abs(least) + i128::abs(most) + edge) + 1);
        Self { edge, triangle }
    }
}

/// The minimum-cost matching that answers an [`Objective`].
#[derive(Clone, Copy, Debug)]
pub struct ObjectiveProblem<'a> {
    objective: &'a Objective,
    dual: &'a DualGraph,
    is_locked: bool,
}

impl ObjectiveProblem<'_> {
    /// Returns which sides of a triangle are those of edges to keep.
    #[inline]
    fn kept(&self, node: u32) -> u8 {
        let kept = &self.objective.kept;
        if kept.is_empty() { 0 } else { kept.sides(node as usize) }
    }
}

impl Problem for ObjectiveProblem<'_> {
    fn node_count(&self) -> usize {
        self.dual.len()
    }

    fn edges(&self) -> impl Iterator<Item = Edge> {
        cubic_edges(self, 0, 1)
    }

    fn edges_in(&self, part: usize, parts: usize) -> impl Iterator<Item = Edge> {
        cubic_edges(self, part, parts)
    }

    fn price(&self, _node: u32) -> Option<i128> {
        self.objective.price
    }
}

impl CubicProblem for ObjectiveProblem<'_> {
    #[inline]
    fn neighbours(&self, node: u32) -> [u32; 3] {
        let across = self.dual.sides_or_none(TriangleId(node)).map(u32::from);
        if !self.is_locked {
            return across;
        }
        let kept = self.kept(node);
        [0, 1, 2].map(|side| if kept >> side & 1 == 0 { across[side] } else { NONE })
    }

    #[inline]
    fn costs(&self, node: u32) -> [i128; 3] {
        let costs = self.objective.costs[node as usize];
        let kept = self.kept(node);
        [0, 1, 2].map(|side| {
            let price = if kept >> side & 1 == 0 { 0 } else { self.objective.edge_price };
            i128::from(costs[side]) + price
        })
    }

    #[inline]
    fn backs(&self, node: u32) -> Option<[u8; 3]> {
        self.dual.backs(TriangleId(node))
    }
}
