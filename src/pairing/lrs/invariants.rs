//! The expansion as published, under observation: after every vertex that comes back, 𝒦 and M are
//! made from scratch and counted (Claim 3.1).

use std::collections::{BTreeMap, BTreeSet};

use proptest::prelude::*;
use triquad_generators::Surface;
use triquad_generators::classic::{octahedron, seven_vertex_torus, tetrahedron};
use triquad_generators::random::{Mix, random_surface};
use triquad_generators::sculptor::{Operation, Sculptor};

use super::printed::{Mark, Observer, Run, expand_all};
use super::{Expanded, contract};
use crate::dual::DualGraph;
use crate::irreducible::Discipline;
use crate::mesh::FaceList;
use crate::random::Random;
use crate::triangulation::{HalfEdgeId, Id, ShrinkingTriangulation, TriangleId, Triangulation};

/// Triangles with named sides: for each side the vertex it leaves and the half-edge it is.
#[derive(Clone)]
struct Sides(Vec<[(u32, HalfEdgeId); 3]>);

impl Sides {
    /// The triangles of `t` that are not contracted.
    fn of(t: &ShrinkingTriangulation) -> Self {
        let all = (0..t.half_edge_id_count() / 3).map(TriangleId::new);
        let sides = |f: TriangleId| f.half_edges().map(|h| (t.origin(h).index() as u32, h));
        Self(all.filter(|&f| t.is_alive(f)).map(sides).collect())
    }

    /// The triangle that has side `h`, turned so that it comes first.
    fn find(&self, h: HalfEdgeId) -> (usize, [(u32, HalfEdgeId); 3]) {
        for (at, sides) in self.0.iter().enumerate() {
            if let Some(i) = sides.iter().position(|side| side.1 == h) {
                return (at, [sides[i], sides[(i + 1) % 3], sides[(i + 2) % 3]]);
            }
        }
        panic!("{h:?} is in no triangle");
    }

    /// Replaces the diagonal of the quadrilateral round the edge of `h` and `t`.
    fn flip(&mut self, h: HalfEdgeId, t: HalfEdgeId) {
        let (f, [_, bc, ca]) = self.find(h);
        let (g, [_, ad, db]) = self.find(t);
        let (c, d) = (ca.0, db.0);
        self.0[f] = [ad, (d, h), ca];
        self.0[g] = [bc, (c, t), db];
    }

    /// The triangulation they are, with `vertices` vertex ids.
    fn build(&self, vertices: usize) -> Triangulation {
        let triangles = self.0.iter().map(|sides| sides.map(|side| side.0)).collect();
        let list = FaceList::from_triangles(vec![[0.0; 3]; vertices], triangles);
        Triangulation::build(&list).expect("still a triangulation")
    }
}

/// Checks Claim 3.1 and Proposition 3.3 after every expansion.
struct Checker {
    euler_characteristic: i64,
    expansions: usize,
}

impl Observer for Checker {
    fn expanded(&mut self, run: &Run) {
        self.expansions += 1;
        let mut sides = Sides::of(&run.t);
        for h in run.lasting_flips() {
            sides.flip(h, run.t.twin(h));
        }
        let k = sides.build(run.t.vertex_id_count());
        assert_eq!(k.euler_characteristic(), self.euler_characteristic);
        assert_eq!(k.vertex_count(), run.t.vertex_count());
        self.check_matching(run, &sides);
    }
}

impl Checker {
    /// The marks of both sides of an edge agree, M joins neighbours in 𝒦, no triangle is joined twice,
    /// and two are for every expansion.
    fn check_matching(&self, run: &Run, sides: &Sides) {
        let mut joined = BTreeSet::new();
        for &(_, h) in sides.0.iter().flatten() {
            assert_eq!(run.marks[h], run.marks[run.t.twin(h)]);
            if run.marks[h] == Mark::Matched {
                assert!(joined.insert(sides.find(h).0), "{h:?}: its triangle is joined twice");
            }
        }
        assert_eq!(joined.len(), 2 * self.expansions, "the expanded triangles");
    }
}

fn triangulation(surface: &Surface) -> Triangulation {
    let list = FaceList::from_triangles(surface.positions.clone(), surface.triangles.clone());
    Triangulation::build(&list).unwrap()
}

/// Directed edges with the triangle of each.
fn edges(t: &Triangulation) -> BTreeMap<[u32; 2], TriangleId> {
    let sides = t.triangles().flat_map(|f| f.half_edges());
    let ends = |h: HalfEdgeId| [h, h.next()].map(|h| t.origin(h).index() as u32);
    sides.map(|h| (ends(h), h.triangle())).collect()
}

/// Expands `surface` under observation and checks the outcome; the number of flips.
fn observe(surface: &Surface, discipline: Discipline) -> usize {
    let input = triangulation(surface);
    let reduction = contract(&input, discipline);
    let left = reduction.triangulation.vertex_count() as i64;
    let mut checker = Checker { euler_characteristic: input.euler_characteristic(), expansions: 0 };
    let run = expand_all(reduction, &mut checker);
    let mut sides = Sides::of(&run.t);
    run.lasting_flips().for_each(|h| sides.flip(h, run.t.twin(h)));
    let replayed = sides.build(input.vertex_id_count());
    let Expanded { triangulation: k, dual, matching, edge_flips } = run.finish();

    assert_eq!(matching.unpaired_count() as i64, 2 * left - 2 * input.euler_characteristic());
    assert!(matching.is_matching_of(&dual) && dual == DualGraph::of(&k));
    // The half-edge structure is what its triangles say, and they are those of the replay.
    let list = FaceList {
        faces: k.faces(),
        positions: vec![[0.0; 3]; k.vertex_id_count()],
        ..FaceList::default()
    };
    assert_eq!(Triangulation::build(&list).unwrap(), k);
    let [ours, replayed, given] = [&k, &replayed, &input].map(edges);
    assert!(ours.keys().eq(replayed.keys()));
    let new = ours.keys().filter(|&[a, b]| a < b && !given.contains_key(&[*a, *b])).count();
    assert_eq!(new, edge_flips, "every flip is an edge that the input does not have");
    edge_flips
}

/// Connected sums of tori, edited at random.
fn surfaces(each: u64) -> impl Iterator<Item = Surface> {
    let kinds = [0, 1, 2, 3, 5].into_iter().flat_map(|genus| Mix::ALL.map(|mix| (genus, mix)));
    kinds.flat_map(move |(genus, mix)| {
        (0..each).map(move |seed| {
            let mut random = Random::stream(seed, &["expanded"]);
            let operations = (seed * 7 % 61) as usize;
            random_surface(genus, operations, mix, &mut |bound| random.below(bound))
        })
    })
}

#[test]
fn every_expansion_keeps_the_claim() {
    let flips: usize =
        surfaces(60).map(|surface| observe(&surface, Discipline::FirstInFirstOut)).sum();
    assert!(flips > 100, "there is something to see");
}

#[test]
fn any_order_of_contraction_can_be_expanded() {
    for surface in surfaces(20) {
        observe(&surface, Discipline::LastInFirstOut);
    }
}

#[test]
fn nothing_to_contract_is_nothing_to_expand() {
    for (surface, unpaired) in [(tetrahedron(), 4), (seven_vertex_torus(), 14)] {
        let run =
            expand_all(contract(&triangulation(&surface), Discipline::FirstInFirstOut), &mut ());
        let Expanded { matching, edge_flips, .. } = run.finish();
        assert_eq!((matching.unpaired_count(), edge_flips), (unpaired, 0));
    }
    observe(&octahedron(), Discipline::FirstInFirstOut);
}

/// Two flipped edges share a triangle of the input: only in the order in which they were flipped do
/// they lead to a triangulation that has the matching.
#[test]
fn flips_are_made_in_the_order_of_time() {
    let triangles = "017 021 072 123 134 146 157 165 243 274 456 475";
    let corners = |t: &str| -> Vec<u32> { t.chars().map(|v| v.to_digit(10).unwrap()).collect() };
    let triangles: Vec<[u32; 3]> =
        triangles.split(' ').map(|t| corners(t).try_into().unwrap()).collect();
    let surface = Surface { positions: vec![[0.0; 3]; 8], triangles };
    assert_eq!(observe(&surface, Discipline::FirstInFirstOut), 2);

    let input = triangulation(&surface);
    let run = expand_all(contract(&input, Discipline::FirstInFirstOut), &mut ());
    let flips: Vec<_> = run.lasting_flips().collect();
    let made = |flips: &mut dyn Iterator<Item = &HalfEdgeId>| {
        let mut sides = Sides::of(&run.t);
        flips.for_each(|&h| sides.flip(h, run.t.twin(h)));
        edges(&sides.build(8)).into_keys().collect::<BTreeSet<_>>()
    };
    assert_ne!(made(&mut flips.iter()), made(&mut flips.iter().rev()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn sculpted_surfaces_keep_the_claim(
        genus in 0..4usize,
        edits in prop::collection::vec((0..3u8, any::<u32>()), 0..30),
    ) {
        let torus = seven_vertex_torus();
        let mut sculptor = Sculptor::from(&if genus == 0 { tetrahedron() } else { torus.clone() });
        (1..genus).for_each(|_| sculptor.join(&torus, 0));
        for (kind, place) in edits {
            sculptor.apply(match kind {
                0 => Operation::SplitFace(place),
                1 => Operation::SplitEdge(place),
                _ => Operation::Flip(place),
            });
        }
        observe(&sculptor.into_surface(), Discipline::FirstInFirstOut);
    }
}
