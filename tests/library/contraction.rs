//! Contractions and splits against brute force: the link condition by sets, every step rebuilt.

use std::collections::BTreeSet;

use proptest::prelude::*;
use triquad::Mesh;
use triquad::Triangulation;
use triquad::random::Random;
use triquad::triangulation::{HalfEdgeId, LinkMarks, ShrinkingTriangulation, VertexId};
use triquad_generators::Surface;

fn shrinking(surface: &Surface) -> ShrinkingTriangulation {
    ShrinkingTriangulation::from(Triangulation::build(&crate::common::face_list(surface)).unwrap())
}

fn half_edges(k: &ShrinkingTriangulation) -> impl Iterator<Item = HalfEdgeId> {
    (0..k.half_edge_id_count()).map(HalfEdgeId::new).filter(|h| k.is_alive(h.triangle()))
}

/// Triangles left, from origins alone.
fn triangles(k: &ShrinkingTriangulation) -> Vec<[u32; 3]> {
    let firsts = half_edges(k).filter(|h| h.index() % 3 == 0);
    firsts.map(|h| h.triangle().half_edges().map(|g| k.origin(g).index() as u32)).collect()
}

/// Whether contracting the edge of `h` leaves a triangulation of the same surface: tried on the
/// list.
fn contraction_is_valid(k: &ShrinkingTriangulation, h: HalfEdgeId) -> bool {
    let [u, v] = [k.origin(h), k.destination(h)].map(|end| end.index() as u32);
    let moved = triangles(k).into_iter().map(|t| t.map(|w| if w == v { u } else { w }));
    let left: Vec<_> = moved.filter(|[a, b, c]| a != b && b != c && c != a).collect();
    Triangulation::build(&Mesh::from_triangles(vec![[0.0; 3]; k.vertex_id_count()], left)).is_ok()
}

/// Twins, stars, degrees and counts as brute force finds them.
fn assert_right(k: &ShrinkingTriangulation) {
    let list = Mesh::from_triangles(vec![[0.0; 3]; k.vertex_id_count()], triangles(k));
    let rebuilt = Triangulation::build(&list).expect("still a triangulation");
    assert_eq!(rebuilt.vertex_count(), k.vertex_count());
    let mut stars = vec![BTreeSet::new(); k.vertex_id_count()];
    for h in half_edges(k) {
        assert_eq!(k.twin(k.twin(h)), h);
        assert_eq!(k.destination(k.twin(h)), k.origin(h));
        stars[k.origin(h).index()].insert(h);
    }
    for (v, star) in stars.iter().enumerate() {
        let v = VertexId::new(v);
        assert_eq!(k.outgoing(v).is_some(), !star.is_empty());
        if k.outgoing(v).is_some() {
            assert_eq!(k.degree(v) as usize, star.len());
            let walked: Vec<_> = k.spokes(v).collect();
            assert_eq!((walked.len(), &BTreeSet::from_iter(walked)), (star.len(), star));
        }
    }
    let (survivors, compact) = k.survivors();
    assert_eq!(survivors.len(), rebuilt.vertex_count());
    let names = |f| compact.corners(f).map(|v| survivors[v.index()].index() as u32);
    assert_eq!(compact.triangles().map(names).collect::<Vec<_>>(), triangles(k));
    assert_eq!(compact.euler_characteristic(), rebuilt.euler_characteristic());
    assert_eq!(compact.component_count(), rebuilt.component_count());
    for f in compact.triangles() {
        for h in f.half_edges() {
            assert_eq!(compact.origin(compact.twin(h)), compact.origin(h.next()));
            assert_eq!(compact.twin(compact.twin(h)), h);
        }
    }
}

/// Everything that a split has to restore.
fn state(k: &ShrinkingTriangulation) -> Vec<(VertexId, HalfEdgeId, u32)> {
    half_edges(k).map(|h| (k.origin(h), k.twin(h), k.degree(k.origin(h)))).collect()
}

/// Contracts random edges until none can be, then splits all the way back; all compared.
fn shrink_and_grow(surface: &Surface, seed: u64) {
    let mut random = Random::stream(seed, &["contraction"]);
    let mut k = shrinking(surface);
    let mut marks = LinkMarks::new(k.vertex_id_count());
    let mut undo = Vec::new();
    loop {
        let all: Vec<_> = half_edges(&k).collect();
        let contractible: Vec<_> =
            all.iter().copied().filter(|&h| k.is_contractible(h, &mut marks)).collect();
        for &h in &all {
            assert_eq!(contractible.contains(&h), contraction_is_valid(&k, h));
        }
        if contractible.is_empty() {
            break;
        }
        let before = state(&k);
        let h = contractible[random.below(contractible.len() as u32) as usize];
        let (u, v) = (k.origin(h), k.destination(h));
        let apexes = [k.origin(h.prev()), k.origin(k.twin(h).prev())];
        let expected: BTreeSet<_> = k
            .spokes(v)
            .map(|g| k.destination(g))
            .filter(|w| *w != u && !apexes.contains(w))
            .collect();
        let receipt = k.contract(h);
        let moved: Vec<_> = k.moved_spokes(&receipt).collect();
        assert!(moved.iter().all(|&g| k.origin(g) == u));
        assert_eq!(moved.iter().map(|&g| k.destination(g)).collect::<BTreeSet<_>>(), expected);
        assert_eq!(moved.len(), expected.len());
        assert_right(&k);
        undo.push((receipt, before));
    }
    for (receipt, before) in undo.into_iter().rev() {
        k.split(receipt);
        assert_eq!(state(&k), before);
    }
    assert_right(&k);
}

#[test]
fn random_surfaces_shrink_and_grow() {
    for (i, (_, surface)) in crate::common::many_surfaces(4).enumerate() {
        shrink_and_grow(&surface, i as u64);
    }
}

#[test]
fn special_surfaces_shrink_and_grow() {
    for (_, surface) in crate::common::special_surfaces() {
        if surface.positions.len() < 60 {
            shrink_and_grow(&surface, 1);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn sculpted_surfaces_shrink_and_grow(surface in crate::common::sculpted_surface(), seed: u64) {
        shrink_and_grow(&surface, seed);
    }
}
