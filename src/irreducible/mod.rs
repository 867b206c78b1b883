//! Irreducible triangulations: edges are contracted until none can be (Ramaswami and Siqueira, *A
//! fast algorithm for computing irreducible triangulations of closed surfaces in E^d*).
//!
//! Three algorithms on one contraction, [`ShrinkingTriangulation::contract`], so that they differ in
//! nothing but how they find contractible edges: [`ramaswami_siqueira()`], [`schipper()`] and
//! [`brute_force()`].

mod brute_force;
mod check;
mod degree_queue;
mod edge_lists;
#[cfg(test)]
mod invariants;
mod neighbour_sets;
mod ramaswami_siqueira;
mod schipper;

use crate::random::Random;
use crate::triangulation::{Id, ShrinkingTriangulation, Triangulation, VertexId, VertexSplit};

pub use brute_force::brute_force;
pub use check::{NotIrreducible, check_irreducible};
pub use ramaswami_siqueira::{Discipline, ramaswami_siqueira};
pub use schipper::schipper;

/// An algorithm that makes a triangulation irreducible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Method {
    /// `rs`: Ramaswami and Siqueira's (section 4).
    RamaswamiSiqueira,
    /// `schipper`: Schipper's, called S (section 3).
    Schipper,
    /// `brute-force`: BF, tests all edges in random order, again and again (section 5).
    BruteForce,
}

/// The order in which RS processes vertices; the others ignore it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Order {
    /// As in the file.
    #[default]
    File,
    /// Random.
    Random,
}

impl Order {
    /// All orders there are.
    pub const ALL: [Self; 2] = [Self::File, Self::Random];

    /// The name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::File => "file",
            Self::Random => "random",
        }
    }

    /// The ids of `vertices` vertices in this order. O(n).
    pub fn of(self, vertices: usize, random: &mut Random) -> Vec<VertexId> {
        let mut ids: Vec<_> = (0..vertices).map(VertexId::new).collect();
        if self == Self::Random {
            random.shuffle(&mut ids);
        }
        ids
    }
}

/// What an algorithm did, beside the contractions: Tables 6 to 11.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Tests of an edge against the link condition (ℓ). RS contracts edges at vertices of degree 3
    /// without a test.
    pub link_condition_tests: usize,
    /// Edges that were tested more than once (ε). An edge whose end moves stays the same edge; of
    /// two that become one, the one at the end that stays remains.
    pub edges_tested_more_than_once: usize,
}

/// What is left of a triangulation, and how to go back.
#[derive(Debug)]
pub struct Reduction {
    /// What is left.
    pub triangulation: ShrinkingTriangulation,
    /// The receipts of all contractions, the first contraction first.
    pub splits: Vec<VertexSplit>,
    /// What it took.
    pub counts: Counts,
}

/// An irreducible triangulation.
#[derive(Clone, Debug)]
pub struct Irreducible {
    /// The vertices of the input that are left, in order: vertex i of `triangulation` was `vertices[i]`.
    pub vertices: Vec<VertexId>,
    /// Their triangulation.
    pub triangulation: Triangulation,
    /// The number of contractions.
    pub contractions: usize,
    /// What it took.
    pub counts: Counts,
}

impl Method {
    /// All methods there are.
    pub const ALL: [Self; 3] = [Self::RamaswamiSiqueira, Self::Schipper, Self::BruteForce];

    /// The name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::RamaswamiSiqueira => "rs",
            Self::Schipper => "schipper",
            Self::BruteForce => "brute-force",
        }
    }

    /// Contracts edges of `triangulation` until none can be: every component becomes a tetrahedron
    /// or, of genus g > 0, has at most 26 g - 4 vertices (Theorem 4).
    ///
    /// Equal input, `order` and `seed` give equal output. For the cost see each algorithm.
    pub fn reduce(self, triangulation: Triangulation, order: Order, seed: u64) -> Irreducible {
        let mut random = Random::stream(seed, &[self.id()]);
        let k = ShrinkingTriangulation::of(triangulation);
        let reduction = match self {
            Self::RamaswamiSiqueira => {
                let order = order.of(k.vertex_id_count(), &mut random);
                ramaswami_siqueira(k, order, Discipline::default())
            }
            Self::Schipper => schipper(k),
            Self::BruteForce => brute_force(k, &mut random),
        };
        let (vertices, triangulation) = reduction.triangulation.survivors();
        let Reduction { splits, counts, .. } = reduction;
        Irreducible { vertices, triangulation, contractions: splits.len(), counts }
    }
}

impl std::fmt::Display for Method {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id())
    }
}
