//! The table of algorithms: id and function of each.

use super::best::best;
use super::cubic::{diks_stanczyk, gawrychowski_wasylkiewicz};
use std::ops::ControlFlow;
use std::str::FromStr;

use super::eager_rescue::{eager_rescue, pair_with_rescues};
use super::initial::InitialPairing;
use super::lrs::{Expansion, LRS_ORDER, lrs};
use super::objective::Objective;
use super::pulli_segal::{pair_by_priority, pulli_segal};
use super::ranked_graph::RankedGraph;
use super::shuffler::Shuffler;
use super::simple_greedy::{pair_edges, simple_greedy};
use super::velho::{squared_length, velho};
use crate::clock::Clock;
use crate::dual::{DualGraph, Matching};
use crate::irreducible::Discipline;
use crate::mesh::Mesh;
use crate::names::{UnknownNameError, find, serde_as_string};
use crate::random::Random;
use crate::triangulation::{Surface, Triangulation};

/// An algorithm that pairs up triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Algorithm {
    /// `best`: ours, the perfect pairing of least total cost, exact, with a proof. Remacle et al.
    /// (2012, Blossom-Quad) solve the same problem with another cost.
    Best,
    /// `tq`: ours, the Pulli-Segal heuristic that rescues every stranded triangle at once.
    EagerRescue,
    /// `sg`: simple greedy, edges in random order (Lemos et al., section 3.1).
    SimpleGreedy,
    /// `velho`: simple greedy, the longest edge first, after Velho (section 3.1). The seed is
    /// ignored.
    Velho,
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
    /// All algorithms, those with variants as published.
    pub const ALL: [Self; 8] = [
        Self::Best,
        Self::EagerRescue,
        Self::SimpleGreedy,
        Self::Velho,
        Self::PulliSegal,
        Self::DiksStanczyk,
        Self::GawrychowskiWasylkiewicz,
        Self::Lrs(Expansion::Printed),
    ];

    /// Returns the name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Best => "best",
            Self::EagerRescue => "tq",
            Self::SimpleGreedy => "sg",
            Self::Velho => "velho",
            Self::PulliSegal => "ps",
            Self::DiksStanczyk => "ds",
            Self::GawrychowskiWasylkiewicz => "gw",
            Self::Lrs(_) => "lrs",
        }
    }

    /// Returns what is special about it, in a few words for `--help`.
    pub fn description(self) -> &'static str {
        match self {
            Self::Best => "best-shaped quads, provably",
            Self::EagerRescue => "for speed, without regard to shape",
            Self::SimpleGreedy => "simple greedy",
            Self::Velho => "simple greedy, the longest edge first",
            Self::PulliSegal => "Pulli-Segal",
            Self::DiksStanczyk => "Diks-Stanczyk",
            Self::GawrychowskiWasylkiewicz => "Gawrychowski-Wasylkiewicz",
            Self::Lrs(_) => "contraction and expansion; flips edges",
        }
    }

    /// Returns whether surfaces may have a boundary or be one-sided; see
    /// [`Converter::open`](crate::Converter::open).
    pub fn works_on_open(self) -> bool {
        match self {
            Self::Best
            | Self::EagerRescue
            | Self::SimpleGreedy
            | Self::Velho
            | Self::PulliSegal => true,
            Self::DiksStanczyk | Self::GawrychowskiWasylkiewicz | Self::Lrs(_) => false,
        }
    }

    /// Pairs up triangles of `triangulation`, without coordinates.
    ///
    /// Equal input and equal `random` give equal output. `best` has no costs here: to it all
    /// pairings are equally good, see [`best`] for costs. To `velho` all edges are equally long,
    /// see [`velho`] for lengths. `lrs` contracts in [`LRS_ORDER`], see [`lrs`] for others.
    ///
    /// `sg` and `ps` take O(n), `tq` in practice; `velho` and `gw` O(n log n), `ds` O(n log² n),
    /// `lrs` O(n) at genus 0 and else O(g² + g n). No bound near linear is proved for `best`.
    pub fn pair<'t>(
        self,
        triangulation: &'t Triangulation,
        random: &mut Random,
    ) -> InitialPairing<'t> {
        self.pair_closed(triangulation, None, LRS_ORDER, Shuffler::new(random, None)).0
    }

    /// Does the same with the coordinates of `mesh`, if there are any, and with another order for
    /// `lrs`. Returns the seconds, too, that shuffles have taken by `clock`.
    pub(crate) fn pair_by_clock<'t>(
        self,
        triangulation: &'t Triangulation,
        mesh: Option<&Mesh>,
        lrs_order: Discipline,
        random: &mut Random,
        clock: &dyn Clock,
    ) -> (InitialPairing<'t>, f64) {
        self.pair_closed(triangulation, mesh, lrs_order, Shuffler::new(random, Some(clock)))
    }

    /// The call of each algorithm for closed surfaces; [`Algorithm::pair_open`] has the others.
    fn pair_closed<'t>(
        self,
        triangulation: &'t Triangulation,
        mesh: Option<&Mesh>,
        lrs_order: Discipline,
        mut random: Shuffler,
    ) -> (InitialPairing<'t>, f64) {
        let mut shuffle_seconds = 0.0;
        let pairing = match self {
            Self::Best => {
                let costs = vec![[0; 3]; triangulation.triangle_count()];
                let objective = Objective::perfect(costs);
                best(triangulation, objective, &mut |_| ControlFlow::Continue(())).expect(LEGAL)
            }
            Self::EagerRescue => {
                let (dual, matching) = pair_with_rescues(RankedGraph::new(triangulation));
                InitialPairing::new(triangulation, dual, matching)
            }
            Self::SimpleGreedy => InitialPairing::from_input(triangulation, |dual| {
                let matching = pair_edges(dual, &mut random);
                shuffle_seconds = random.seconds();
                matching
            }),
            Self::Velho => InitialPairing::from_input(triangulation, |dual| match mesh {
                Some(mesh) => velho(dual, |h| squared_length(triangulation, mesh, h)),
                None => velho(dual, |_| 0.0),
            }),
            Self::PulliSegal => {
                let ranked = RankedGraph::new(triangulation);
                let (dual, matching, seconds) = pair_by_priority(ranked, Some(random));
                shuffle_seconds = seconds;
                InitialPairing::new(triangulation, dual, matching)
            }
            // A triangulation is closed, so its dual graph is cubic. It is bridgeless: the edge
            // across side ab lies on the ring of triangles round a, exactly once, as a and b
            // differ.
            Self::DiksStanczyk => {
                InitialPairing::from_input(triangulation, |dual| diks_stanczyk(dual).expect(LEGAL))
            }
            Self::GawrychowskiWasylkiewicz => InitialPairing::from_input(triangulation, |dual| {
                gawrychowski_wasylkiewicz(dual).expect(LEGAL)
            }),
            Self::Lrs(expansion) => lrs(triangulation, expansion, lrs_order),
        };
        (pairing, shuffle_seconds)
    }

    /// Pairs triangles of any surface: `dual` is its dual graph, `mesh` has its coordinates.
    ///
    /// Returns none for those that need a closed surface, and for `best`, which needs costs.
    pub(crate) fn pair_open(
        self,
        surface: &impl Surface,
        dual: &DualGraph,
        mesh: &Mesh,
        random: &mut Random,
    ) -> Option<Matching> {
        match self {
            Self::EagerRescue => Some(eager_rescue(dual)),
            Self::SimpleGreedy => Some(simple_greedy(dual, random)),
            Self::Velho => Some(velho(dual, |h| squared_length(surface, mesh, h))),
            Self::PulliSegal => Some(pulli_segal(dual, Some(random))),
            Self::Best | Self::DiksStanczyk | Self::GawrychowskiWasylkiewicz | Self::Lrs(_) => None,
        }
    }
}

const LEGAL: &str = "the dual graph of a closed surface is cubic and bridgeless";

impl std::fmt::Display for Algorithm {
    /// Writes the id, and behind it the variant if that is not the published one.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Lrs(variant) if *variant != Expansion::default() => {
                f.pad(&format!("{} {variant}", self.id()))
            }
            _ => f.pad(self.id()),
        }
    }
}

impl FromStr for Algorithm {
    type Err = UnknownNameError;

    /// Reads an id, or an id and a variant separated by a space, as in `lrs few-flips`.
    fn from_str(name: &str) -> Result<Self, UnknownNameError> {
        match name.split_once(' ') {
            Some(("lrs", variant)) => variant.parse().map(Self::Lrs),
            _ => find("pairing algorithm", &Self::ALL, Self::id, name),
        }
    }
}

serde_as_string!(Algorithm);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn algorithms_are_read_back_as_they_are_written() {
        let variants = Expansion::ALL.map(Algorithm::Lrs);
        for algorithm in Algorithm::ALL.into_iter().chain(variants) {
            assert_eq!(algorithm.to_string().parse(), Ok(algorithm));
        }
        assert_eq!("lrs printed".parse(), Ok(Algorithm::Lrs(Expansion::Printed)));
    }

    #[test]
    fn unknown_algorithms_are_refused_with_the_names_there_are() {
        let refusal = |name: &str| name.parse::<Algorithm>().unwrap_err().to_string();
        let all = Algorithm::ALL.map(Algorithm::id).join(", ");
        let expected = format!("\"mst\" is no pairing algorithm; use one of: {all}");
        assert_eq!(refusal("mst"), expected);
        assert_eq!(
            refusal("lrs no-flips"),
            "\"no-flips\" is no expansion of lrs; use one of: printed, few-flips"
        );
    }

    #[cfg(feature = "serde")]
    #[test]
    fn algorithms_are_strings_in_json() {
        let json = serde_json::to_string(&Algorithm::Lrs(Expansion::FewFlips)).unwrap();
        assert_eq!(json, "\"lrs few-flips\"");
        let back: Algorithm = serde_json::from_str(&json).unwrap();
        assert_eq!(back, Algorithm::Lrs(Expansion::FewFlips));
        assert!(serde_json::from_str::<Algorithm>("\"mst\"").is_err());
    }
}
