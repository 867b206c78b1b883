//! Both expansions under observation: after every vertex that comes back, 𝒦 and M are made from
//! scratch and counted (Claim 3.1).

use std::collections::{BTreeMap, BTreeSet};

use proptest::prelude::*;
use triquad_generators::Surface;
use triquad_generators::classic::{octahedron, seven_vertex_torus, tetrahedron};

use super::expanded::{Expanded, ExpansionObserver};
use super::few_flips::{self, FewFlipsExpansion};
use super::marks::{EdgeMark, EdgeMarks};
use super::printed::{PrintedExpansion, expand_all};
use super::{LRS_ORDER, contract};
use crate::dual::DualGraph;
use crate::irreducible::Discipline;
use crate::mesh::Mesh;
use crate::samples::{sculpted, surfaces, triangulation};
use crate::triangulation::{
    Connectivity, ExpandingTriangulation, HalfEdgeId, TriangleId, Triangulation, VertexSplit,
};

/// Triangles with named sides: for each side the vertex it leaves and the half-edge it is.
#[derive(Clone)]
struct NamedTriangles(Vec<[(u32, HalfEdgeId); 3]>);

impl NamedTriangles {
    /// Returns the triangles that are there while some splits are `pending`.
    fn new(t: &ExpandingTriangulation, pending: &[VertexSplit]) -> Self {
        let edges = pending.iter().map(VertexSplit::half_edge);
        let removed: BTreeSet<_> =
            edges.flat_map(|h| [h, t.twin(h)]).map(HalfEdgeId::triangle).collect();
        let all = (0..t.half_edge_id_count() / 3).map(TriangleId::new);
        let sides = |f: TriangleId| f.half_edges().map(|h| (t.origin(h).index() as u32, h));
        Self(all.filter(|f| !removed.contains(f)).map(sides).collect())
    }

    /// Returns the triangle that has side `h`, turned so that it comes first.
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

    /// Returns the triangulation they are, with `vertices` vertex ids.
    fn build(&self, vertices: usize) -> Triangulation {
        let triangles = self.0.iter().map(|sides| sides.map(|side| side.0)).collect();
        let list = Mesh::from_triangles(vec![[0.0; 3]; vertices], triangles);
        Triangulation::build(&list).expect("still a triangulation")
    }
}

/// Checks Claim 3.1 and Proposition 3.3 after every expansion of what `input` has been contracted
/// to.
struct Checker<'a> {
    input: &'a Triangulation,
    expansions: usize,
}

impl ExpansionObserver<PrintedExpansion> for Checker<'_> {
    fn expanded(&mut self, run: &PrintedExpansion, pending: &[VertexSplit]) {
        let mut sides = NamedTriangles::new(&run.t, pending);
        for h in run.lasting_flips() {
            sides.flip(h, run.t.twin(h));
        }
        self.check(&sides, &run.t, &run.marks, pending);
    }
}

impl ExpansionObserver<FewFlipsExpansion> for Checker<'_> {
    fn expanded(&mut self, run: &FewFlipsExpansion, pending: &[VertexSplit]) {
        self.check(&NamedTriangles::new(&run.k, pending), &run.k, &run.marks, pending);
    }
}

impl Checker<'_> {
    /// 𝒦, which has these `sides`, is a triangulation of the surface with the vertices of `t`, all
    /// but the `pending` ones; the marks of both sides of an edge of `t` agree; M joins neighbours
    /// in 𝒦, no triangle twice, and two triangles for every expansion.
    fn check(
        &mut self,
        sides: &NamedTriangles,
        t: &ExpandingTriangulation,
        marks: &EdgeMarks,
        pending: &[VertexSplit],
    ) {
        self.expansions += 1;
        let k = sides.build(self.input.vertex_id_count());
        assert_eq!(k.euler_characteristic(), self.input.euler_characteristic());
        assert_eq!(k.vertex_count(), self.input.vertex_count() - pending.len());
        let mut joined = BTreeSet::new();
        for &(_, h) in sides.0.iter().flatten() {
            assert!(marks.agree(h, t.twin(h)));
            assert!(!marks.has(h, EdgeMark::Inner), "a search has left traces");
            if marks.has(h, EdgeMark::Matched) {
                assert!(joined.insert(sides.find(h).0), "{h:?}: its triangle is joined twice");
            }
        }
        assert_eq!(joined.len(), 2 * self.expansions, "the expanded triangles");
    }
}

/// Directed edges with the triangle of each.
fn edges(t: &Triangulation) -> BTreeMap<[u32; 2], TriangleId> {
    let sides = t.triangles().flat_map(|f| f.half_edges());
    let ends = |h: HalfEdgeId| [h, h.next()].map(|h| t.origin(h).index() as u32);
    sides.map(|h| (ends(h), h.triangle())).collect()
}

/// Expands `surface` under observation in both ways and checks the outcomes; the numbers of flips.
fn observe(surface: &Surface, discipline: Discipline) -> [usize; 2] {
    let input = triangulation(surface);
    let reductions = [(); 2].map(|()| contract(&input, discipline));
    let left = reductions[0].triangulation.vertex_count() as i64;
    let unpaired = (2 * left - 2 * input.euler_characteristic()) as usize;
    let mut checkers = [(); 2].map(|()| Checker { input: &input, expansions: 0 });
    let [one, other] = reductions;
    let run = expand_all(one, &mut checkers[0]);
    let mut sides = NamedTriangles::new(&run.t, &[]);
    run.lasting_flips().for_each(|h| sides.flip(h, run.t.twin(h)));
    let replayed = sides.build(input.vertex_id_count());
    let as_printed = run.finish();
    assert!(edges(&as_printed.triangulation).keys().eq(edges(&replayed).keys()));
    let few = few_flips::expand_all(other, &mut checkers[1]).finish(&input);
    [as_printed, few].map(|expanded| check_outcome(expanded, &input, unpaired))
}

/// Checks 𝒦 and its matching against the input; the number of flips.
fn check_outcome(expanded: Expanded, input: &Triangulation, unpaired: usize) -> usize {
    let Expanded { triangulation: k, dual, matching, edge_flips } = expanded;
    assert_eq!(matching.unpaired_count(), unpaired);
    assert!(matching.is_matching_of(&dual) && dual == DualGraph::new(&k));
    // The half-edge structure agrees with its triangles.
    let list = Mesh::new(vec![[0.0; 3]; k.vertex_id_count()], k.to_faces());
    assert_eq!(Triangulation::build(&list).unwrap(), k);
    let [ours, given] = [&k, input].map(edges);
    let new = ours.keys().filter(|&[a, b]| a < b && !given.contains_key(&[*a, *b])).count();
    assert_eq!(new, edge_flips, "every flip is an edge that the input does not have");
    edge_flips
}

#[test]
fn every_expansion_keeps_the_claim() {
    let mut flips = [0; 2];
    for surface in surfaces(60, 61) {
        let of_surface = observe(&surface, LRS_ORDER);
        flips.iter_mut().zip(of_surface).for_each(|(sum, flips)| *sum += flips);
    }
    assert!(flips.iter().all(|&flips| flips > 20), "{flips:?}: there is something to see");
    assert!(3 * flips[1] < flips[0], "{flips:?}");
}

#[test]
fn any_order_of_contraction_can_be_expanded() {
    for surface in surfaces(20, 61) {
        observe(&surface, Discipline::FirstInFirstOut);
    }
}

#[test]
fn nothing_to_contract_is_nothing_to_expand() {
    for (surface, unpaired) in [(tetrahedron(), 4), (seven_vertex_torus(), 14)] {
        let run = expand_all(contract(&triangulation(&surface), LRS_ORDER), &mut ());
        let Expanded { matching, edge_flips, .. } = run.finish();
        assert_eq!((matching.unpaired_count(), edge_flips), (unpaired, 0));
        observe(&surface, LRS_ORDER);
    }
    observe(&octahedron(), LRS_ORDER);
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
    assert_eq!(observe(&surface, Discipline::FirstInFirstOut)[0], 2);

    let input = triangulation(&surface);
    let run = expand_all(contract(&input, Discipline::FirstInFirstOut), &mut ());
    let flips: Vec<_> = run.lasting_flips().collect();
    let made = |flips: &mut dyn Iterator<Item = &HalfEdgeId>| {
        let mut sides = NamedTriangles::new(&run.t, &[]);
        flips.for_each(|&h| sides.flip(h, run.t.twin(h)));
        edges(&sides.build(8)).into_keys().collect::<BTreeSet<_>>()
    };
    assert_ne!(made(&mut flips.iter()), made(&mut flips.iter().rev()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn sculpted_surfaces_keep_the_claim(surface in sculpted()) {
        observe(&surface, LRS_ORDER);
    }
}
