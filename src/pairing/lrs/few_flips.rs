//! Fewer flips than published, what the authors of the paper leave to be done (section 5): most
//! edges that the expansion flips can be flipped back afterwards, and a little re-pairing around
//! each makes up for it.

use super::Expanded;
use super::printed::{Mark, Run};
use crate::augmentation::Rescue;
use crate::dual::{DualGraph, Matching};
use crate::triangulation::{HalfEdgeId, IdVec, TriangleId, Triangulation};

/// How many triangles are searched for a re-pairing that lets an edge be flipped back.
const SEARCH_LIMIT: usize = 16;

/// 𝒦 with its flipped edges, which can be flipped back.
struct Reverter<'t> {
    input: &'t Triangulation,
    /// The flipped edges by half-edges of the input, in the order of time.
    flips: Vec<HalfEdgeId>,
    k: Triangulation,
    /// Where those half-edges are now.
    place: Vec<HalfEdgeId>,
    /// For each place what is there.
    label: IdVec<HalfEdgeId, u32>,
}

/// Nothing special. Other labels are numbers of flips, plus one.
const PLAIN: u32 = 0;
/// A side of an edge in M.
const MATCHED: u32 = u32::MAX;

/// 𝒦 and the matching of its triangles, when all vertices are back, with as many flips undone as
/// short searches can. O(n).
pub(super) fn finish(run: Run, input: &Triangulation) -> Expanded {
    let mut reverter = Reverter::of(run, input);
    let matching = reverter.matching();
    let dual = DualGraph::of(&reverter.k);
    let rescue = Rescue::new(dual.len());
    let mut pairing = Pairing { dual, matching, rescue };
    // The newest first: it may be in the way of older ones, and they are not in its way.
    let count = reverter.flips.len();
    let undone = (0..count).rev().filter(|&flip| reverter.undo(flip, &mut pairing)).count();
    let Pairing { dual, matching, .. } = pairing;
    Expanded { triangulation: reverter.k, dual, matching, edge_flips: count - undone }
}

/// A pairing while edges are being flipped back.
struct Pairing {
    dual: DualGraph,
    matching: Matching,
    rescue: Rescue,
}

impl<'t> Reverter<'t> {
    /// Makes the flips that `run` has marked.
    fn of(run: Run, input: &'t Triangulation) -> Self {
        let flips: Vec<HalfEdgeId> = run.lasting_flips().collect();
        let Run { t, marks, .. } = run;
        let mut label = IdVec::filled(PLAIN, marks.len());
        for h in marks.ids().filter(|&h| marks[h] == Mark::Matched) {
            label[h] = MATCHED;
        }
        for (number, &h) in (1..).zip(&flips) {
            label[h] = number;
        }
        let (k, place) = (t.into_triangulation(), flips.clone());
        let mut reverter = Self { input, flips, k, place, label };
        (0..reverter.flips.len()).for_each(|flip| reverter.turn(flip));
        reverter
    }

    /// Flips the edge of a flip, which turns it by a quarter, and follows what moves.
    fn turn(&mut self, flip: usize) {
        let moves = self.k.flip(self.place[flip]);
        for (label, to) in moves.map(|(from, to)| (self.label[from], to)) {
            self.label[to] = label;
            if label != PLAIN && label != MATCHED {
                self.place[label as usize - 1] = to;
            }
        }
    }

    fn matching(&self) -> Matching {
        let mut matching = Matching::empty(self.k.triangle_count());
        for side in self.label.ids().filter(|&h| self.label[h] == MATCHED) {
            let across = self.k.twin(side);
            if side < across {
                matching.pair_unpaired(side.triangle(), across.triangle());
            }
        }
        matching
    }

    /// Flips an edge back, if the edge of the input comes of it and the pairing can be mended.
    fn undo(&mut self, flip: usize, pairing: &mut Pairing) -> bool {
        let s = self.place[flip];
        let t = self.k.twin(s);
        if !self.leads_back(flip, s, t) {
            return false;
        }
        let (f, g) = (s.triangle(), t.triangle());
        let mates = [f, g].map(|triangle| pairing.matching.mate(triangle));
        if mates[0] == Some(g) {
            self.turn_in(flip, [f, g], &mut pairing.dual);
            return true;
        }
        // Each mate stays with the triangle at whose side it lies; two sides change triangles.
        let beyond = |side: HalfEdgeId| Some(self.k.twin(side).triangle());
        let hosts = [
            if mates[0] == beyond(s.next()) { g } else { f },
            if mates[1] == beyond(t.next()) { f } else { g },
        ];
        self.turn_in(flip, [f, g], &mut pairing.dual);
        if pairing.mend([f, g], mates, hosts) {
            return true;
        }
        // Three more quarters of a turn, and there are the same triangles as before.
        (0..3).for_each(|_| self.turn_in(flip, [f, g], &mut pairing.dual));
        false
    }

    /// Whether flipping the edge of `s` and `t` makes the edge that `flip` flipped: what lies round
    /// it may have changed since. That edge is not in 𝒦 now, as no flip is an edge of the input.
    fn leads_back(&self, flip: usize, s: HalfEdgeId, t: HalfEdgeId) -> bool {
        let ends = [s, t].map(|side| self.k.origin(side.prev()));
        let h = self.flips[flip];
        let given = [h, h.next()].map(|side| self.input.origin(side));
        ends == given || ends == [given[1], given[0]]
    }

    /// Like [`Reverter::turn`], in the dual graph as well; the edge is between `triangles`.
    fn turn_in(&mut self, flip: usize, triangles: [TriangleId; 2], dual: &mut DualGraph) {
        self.turn(flip);
        for side in triangles.into_iter().flat_map(TriangleId::half_edges) {
            dual.read_sides(&self.k, side.triangle());
            dual.read_sides(&self.k, self.k.twin(side).triangle());
        }
    }
}

impl Pairing {
    /// Pairs two triangles anew, between which an edge has been flipped, and their mates: each lies
    /// beside its host now. False, and nothing has changed, if a search finds no way.
    fn mend(
        &mut self,
        triangles: [TriangleId; 2],
        mates: [Option<TriangleId>; 2],
        hosts: [TriangleId; 2],
    ) -> bool {
        let couples = |with: [TriangleId; 2]| {
            mates.into_iter().zip(with).filter_map(|(mate, host)| Some((mate?, host)))
        };
        couples(triangles).for_each(|(mate, triangle)| self.matching.separate(mate, triangle));
        let [Some(one), Some(_)] = mates else {
            couples(hosts).for_each(|(mate, host)| self.matching.pair(mate, host));
            return true;
        };
        if hosts[0] != hosts[1] {
            couples(hosts).for_each(|(mate, host)| self.matching.pair(mate, host));
            return true;
        }
        self.matching.pair(triangles[0], triangles[1]);
        if self.rescue.pair(&self.dual, &mut self.matching, one, SEARCH_LIMIT).is_some() {
            return true;
        }
        self.matching.separate(triangles[0], triangles[1]);
        couples(triangles).for_each(|(mate, triangle)| self.matching.pair(mate, triangle));
        false
    }
}
