//! Irreducible triangulations: edges are contracted until none can be (Ramaswami and Siqueira, *A
//! fast algorithm for computing irreducible triangulations of closed surfaces in E^d*).
//!
//! Three algorithms share one contraction, [`ShrinkingTriangulation::contract`], and differ only in
//! how they find contractible edges: [`ramaswami_siqueira()`], [`schipper()`] and
//! [`brute_force()`].
//!
//! # Examples
//!
//! ```
//! use triquad::irreducible::{Contractor, Order, check_irreducible};
//! use triquad::{Mesh, Triangulation};
//!
//! let upper = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
//! let lower = [[5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];
//! let octahedron = Mesh::from_triangles(vec![[0.0; 3]; 6], [upper, lower].concat());
//! for contractor in Contractor::ALL {
//!     let triangulation = Triangulation::build(&octahedron)?;
//!     let least = contractor.reduce(triangulation, Order::File, 7);
//!     assert_eq!((least.vertices.len(), least.contractions), (4, 2));
//!     check_irreducible(&least.mesh(&octahedron), 1, 0).expect("a tetrahedron");
//! }
//! # Ok::<(), Box<triquad::Survey>>(())
//! ```
//!
//! The three functions take what [`Contractor::reduce`] gives them, and have no examples of their
//! own.

mod brute_force;
mod check;
mod contracted;
mod degree_queue;
mod edge_lists;
mod far_spoke;
#[cfg(test)]
mod invariants;
mod neighbour_sets;
mod ramaswami_siqueira;
mod schipper;
mod waiting_edges;

use crate::mesh::Mesh;
use crate::names::named;
use crate::random::Random;
use crate::triangulation::{ShrinkingTriangulation, Triangulation, VertexId};

pub use brute_force::brute_force;
pub use check::{IrreducibleError, check_irreducible};
pub use contracted::{Contracted, Counts};
pub use edge_lists::Discipline;
pub use ramaswami_siqueira::ramaswami_siqueira;
pub use schipper::schipper;

/// An algorithm that makes a triangulation irreducible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Contractor {
    /// `rs`: Ramaswami and Siqueira's (section 4).
    RamaswamiSiqueira,
    /// `schipper`: Schipper's, called S (section 3).
    Schipper,
    /// `brute-force`: BF, tests all edges in random order, again and again (section 5).
    BruteForce,
}

/// The order in which RS processes vertices. The other algorithms ignore it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Order {
    /// As in the file.
    #[default]
    File,
    /// Random.
    Random,
}

impl Order {
    /// All orders.
    pub const ALL: [Self; 2] = [Self::File, Self::Random];

    /// Returns the name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::File => "file",
            Self::Random => "random",
        }
    }

    /// Returns the ids of `vertices` vertices in this order. O(n).
    pub fn vertex_ids(self, vertices: usize, random: &mut Random) -> Vec<VertexId> {
        let mut ids: Vec<_> = (0..vertices).map(VertexId::new).collect();
        if self == Self::Random {
            random.shuffle(&mut ids);
        }
        ids
    }
}

/// An irreducible triangulation.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Irreducible {
    /// The vertices of the input that are left, in order. Vertex i of `triangulation` was
    /// `vertices[i]`.
    pub vertices: Vec<VertexId>,
    /// Their triangulation.
    pub triangulation: Triangulation,
    /// The number of contractions.
    pub contractions: usize,
    /// Tests of edges.
    pub counts: Counts,
}

impl Irreducible {
    /// Returns the irreducible triangulation with the coordinates of `input`, the mesh it was made
    /// from. O(n).
    ///
    /// # Panics
    /// If a vertex that is left does not exist in `input`.
    pub fn mesh(&self, input: &Mesh) -> Mesh {
        let position = |v: &VertexId| input.positions()[v.index()];
        let positions = self.vertices.iter().map(position).collect();
        Mesh::new(positions, self.triangulation.to_faces())
    }
}

impl Contractor {
    /// All algorithms.
    pub const ALL: [Self; 3] = [Self::RamaswamiSiqueira, Self::Schipper, Self::BruteForce];

    /// Returns the name on the command line and in records.
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
        let k = ShrinkingTriangulation::from(triangulation);
        let reduction = match self {
            Self::RamaswamiSiqueira => {
                let (vertices, discipline) = (k.vertex_id_count(), Discipline::default());
                match order {
                    // Needs no list of them.
                    Order::File => {
                        ramaswami_siqueira(k, (0..vertices).map(VertexId::new), discipline)
                    }
                    Order::Random => {
                        let order = order.vertex_ids(vertices, &mut random);
                        ramaswami_siqueira(k, order, discipline)
                    }
                }
            }
            Self::Schipper => schipper(k, &mut random),
            Self::BruteForce => brute_force(k, &mut random),
        };
        let (vertices, triangulation) = reduction.triangulation.survivors();
        let Contracted { splits, counts, .. } = reduction;
        Irreducible { vertices, triangulation, contractions: splits.len(), counts }
    }
}

named!(Contractor, "algorithm for irreducible triangulations", id);
named!(Order, "order of vertices", id);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contractors_and_orders_are_read_back_as_they_are_written() {
        for contractor in Contractor::ALL {
            assert_eq!(contractor.to_string().parse(), Ok(contractor));
        }
        for order in Order::ALL {
            assert_eq!(order.to_string().parse(), Ok(order));
        }
        assert_eq!("rs ".parse::<Contractor>().unwrap_err().known.len(), 3);
        assert_eq!("File".parse::<Order>().unwrap_err().known, ["file", "random"]);
    }
}
