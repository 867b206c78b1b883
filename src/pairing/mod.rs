//! First stage of every conversion: an initial pairing of edge-adjacent triangles, perfect or not.
//!
//! Adding an algorithm: one file with its function, one variant of [`Algorithm`] and the lines
//! that the compiler then asks for. Tests, `demo` and the command line iterate over
//! [`Algorithm::ALL`].

mod pulli_segal;
mod simple_greedy;
mod triquad;

use std::borrow::Cow;

use crate::dual::{DualGraph, Matching};
use crate::random::Random;
use crate::triangulation::Triangulation;

pub use pulli_segal::pulli_segal;
pub use simple_greedy::simple_greedy;
pub use triquad::triquad;

/// An initial pairing, and the triangulation whose triangles it pairs.
#[derive(Clone, Debug)]
pub struct InitialPairing<'t> {
    /// The input, or another triangulation of the same surface with the same vertices.
    pub triangulation: Cow<'t, Triangulation>,
    /// The dual graph of `triangulation`.
    pub dual: DualGraph,
    /// A matching in `dual`.
    pub matching: Matching,
    /// Number of edges of `triangulation` that the input does not have.
    pub edge_flips: usize,
}

/// An algorithm that pairs up triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Algorithm {
    /// `tq`: ours, the Pulli-Segal heuristic that rescues every stranded triangle at once.
    Triquad,
    /// `sg`: simple greedy, edges in random order (Lemos et al., section 3.1).
    SimpleGreedy,
    /// `ps`: the greedy algorithm of Pulli and Segal, triangles in random order (section 3.1).
    PulliSegal,
}

impl Algorithm {
    /// All algorithms there are.
    pub const ALL: [Self; 3] = [Self::Triquad, Self::SimpleGreedy, Self::PulliSegal];

    /// The name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Triquad => "tq",
            Self::SimpleGreedy => "sg",
            Self::PulliSegal => "ps",
        }
    }

    /// Pairs up triangles of `triangulation`.
    ///
    /// Equal input and equal `random` give equal output. O(n).
    pub fn pair<'t>(
        self,
        triangulation: &'t Triangulation,
        random: &mut Random,
    ) -> InitialPairing<'t> {
        let mut dual = DualGraph::of(triangulation);
        let matching = match self {
            Self::Triquad => triquad(&mut dual),
            Self::SimpleGreedy => simple_greedy(&dual, random),
            Self::PulliSegal => pulli_segal(&mut dual, Some(random)),
        };
        debug_assert!(matching.is_matching_of(&dual));
        InitialPairing {
            triangulation: Cow::Borrowed(triangulation),
            dual,
            matching,
            edge_flips: 0,
        }
    }
}

impl std::fmt::Display for Algorithm {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id())
    }
}
