//! LRS (Lemos et al., section 3.3): contraction to an irreducible triangulation, expansion back
//! with a matching and edge flips.
//!
//! The contraction is RS of [`irreducible`](crate::irreducible). The expansion undoes it vertex by
//! vertex, the last contraction first, and pairs the triangles that come back; where that is
//! impossible, it flips an edge. The outcome is a triangulation 𝒦 of the same surface on the same
//! vertices, and a matching of its triangles that misses only as many as the irreducible
//! triangulation has: 4 on a sphere, at most 56 g - 12 on a surface of genus g > 0.
//!
//! Departs from the printed RS in one order, by default: edges that are new at u are tested before
//! older ones, as from a stack. Printed is a queue. `docs/algorithms.md` has the argument and the
//! numbers: with the stack fewer edges are flipped.

mod expanded;
mod few_flips;
mod flip_undo;
#[cfg(test)]
mod invariants;
mod marks;
mod path_search;
mod printed;

use std::borrow::Cow;

use super::initial::InitialPairing;
use crate::irreducible::{Contracted, Discipline, ramaswami_siqueira};
use crate::names::named;
use crate::triangulation::{ShrinkingTriangulation, Triangulation, VertexId};
use expanded::Expanded;

/// The end of the list at which edges that are new at a vertex enter, unless another is chosen.
pub const LRS_ORDER: Discipline = Discipline::LastInFirstOut;

/// A variant of the expansion of LRS.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Expansion {
    /// `printed`: Algorithms 3.1 to 3.4, with corrections L1 and L2 of `docs/errata.md`.
    #[default]
    Printed,
    /// `few-flips`: ours. Flips only where no short alternating path is found, and undoes flips
    /// where there is one in the end.
    FewFlips,
}

impl Expansion {
    /// All variants.
    pub const ALL: [Self; 2] = [Self::Printed, Self::FewFlips];

    /// Returns the name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::FewFlips => "few-flips",
        }
    }
}

named!(Expansion, "expansion of lrs", id);

/// Pairs the triangles of 𝒦, a triangulation with the same vertices as `triangulation`, of the same
/// surface, made from it by edge flips.
///
/// Vertices are contracted in the order of the file, edges at a vertex in `order`, [`LRS_ORDER`]
/// if nothing speaks for another. O(n) for surfaces of genus 0 and O(g² + g n)
/// for genus g > 0; about 90 bytes a triangle while it runs, `triangulation` not counted.
pub fn lrs(
    triangulation: &Triangulation,
    expansion: Expansion,
    order: Discipline,
) -> InitialPairing<'_> {
    let reduction = contract(triangulation, order);
    let Expanded { triangulation, dual, matching, edge_flips } = match expansion {
        Expansion::Printed => printed::expand_all(reduction, &mut ()).finish(),
        Expansion::FewFlips => few_flips::expand_all(reduction, &mut ()).finish(triangulation),
    };
    debug_assert!(matching.is_matching_of(&dual));
    let triangulation = Cow::Owned(triangulation);
    InitialPairing { triangulation, dual, matching, edge_flips, proof: None }
}

/// Returns the contraction step: RS, vertices in the order of the file.
fn contract(triangulation: &Triangulation, discipline: Discipline) -> Contracted {
    let k = ShrinkingTriangulation::from(triangulation);
    let order = (0..k.vertex_id_count()).map(VertexId::new);
    ramaswami_siqueira(k, order, discipline)
}
