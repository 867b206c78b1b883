//! First stage of every conversion: an initial pairing of edge-adjacent triangles, perfect or not.
//!
//! Adding an algorithm: one file with its function, one variant of [`Algorithm`] and the lines
//! that the compiler then asks for. Tests, `demo` and the command line iterate over
//! [`Algorithm::ALL`].

pub mod cubic;
mod lrs;
mod pulli_segal;
mod ranked_graph;
mod simple_greedy;
mod triquad;

use std::borrow::Cow;

use crate::dual::{DualGraph, Matching};
use crate::random::Random;
use crate::triangulation::Triangulation;

pub use cubic::{diks_stanczyk, gawrychowski_wasylkiewicz};
pub use lrs::{Expansion, lrs};
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

impl<'t> InitialPairing<'t> {
    /// What `pair` makes of the triangles of `triangulation` itself.
    fn of_input(
        triangulation: &'t Triangulation,
        pair: impl FnOnce(&DualGraph) -> Matching,
    ) -> Self {
        let dual = DualGraph::new(triangulation);
        let matching = pair(&dual);
        debug_assert!(matching.is_matching_of(&dual));
        let triangulation = Cow::Borrowed(triangulation);
        Self { triangulation, dual, matching, edge_flips: 0 }
    }
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
    /// `ds`: Frink's reductions with dynamic connectivity, in the spirit of Diks and Stanczyk
    /// (section 3.2). Perfect straight away; the seed is ignored.
    DiksStanczyk,
    /// `gw`: Frink's reductions with a link-cut tree alone, in the spirit of Gawrychowski and
    /// Wasylkiewicz (2024). Perfect straight away; the seed is ignored.
    GawrychowskiWasylkiewicz,
    /// `lrs`: contraction, and expansion with edge flips (section 3.3).
    Lrs(Expansion),
}

impl Algorithm {
    /// All algorithms there are, those with variants as published.
    pub const ALL: [Self; 6] = [
        Self::Triquad,
        Self::SimpleGreedy,
        Self::PulliSegal,
        Self::DiksStanczyk,
        Self::GawrychowskiWasylkiewicz,
        Self::Lrs(Expansion::Printed),
    ];

    /// The name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Triquad => "tq",
            Self::SimpleGreedy => "sg",
            Self::PulliSegal => "ps",
            Self::DiksStanczyk => "ds",
            Self::GawrychowskiWasylkiewicz => "gw",
            Self::Lrs(_) => "lrs",
        }
    }

    /// Pairs up triangles of `triangulation`.
    ///
    /// Equal input and equal `random` give equal output. O(n); `ds` O(n log² n), `gw` O(n log n).
    pub fn pair<'t>(
        self,
        triangulation: &'t Triangulation,
        random: &mut Random,
    ) -> InitialPairing<'t> {
        match self {
            Self::Triquad => InitialPairing::of_input(triangulation, triquad),
            Self::SimpleGreedy => {
                InitialPairing::of_input(triangulation, |dual| simple_greedy(dual, random))
            }
            Self::PulliSegal => {
                InitialPairing::of_input(triangulation, |dual| pulli_segal(dual, Some(random)))
            }
            // A triangulation is closed, so its dual graph is cubic. It is bridgeless: the edge across
            // side ab is on the ring of triangles round a, and once only, as a and b differ.
            Self::DiksStanczyk => {
                InitialPairing::of_input(triangulation, |dual| diks_stanczyk(dual).expect(LEGAL))
            }
            Self::GawrychowskiWasylkiewicz => InitialPairing::of_input(triangulation, |dual| {
                gawrychowski_wasylkiewicz(dual).expect(LEGAL)
            }),
            Self::Lrs(expansion) => lrs(triangulation, expansion),
        }
    }
}

const LEGAL: &str = "the dual graph of a closed surface is cubic and bridgeless";

impl std::fmt::Display for Algorithm {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id())
    }
}
