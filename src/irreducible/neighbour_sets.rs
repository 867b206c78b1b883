//! The neighbour dictionaries of Schipper's algorithm.

use crate::triangulation::{HalfEdgeId, ShrinkingTriangulation, VertexId};

/// For each vertex v the ordered set D_v of its neighbours: a treap (Seidel and Aragon, *Randomized
/// search trees*), whose nodes lie in one array for all vertices. O(log deg v) an operation,
/// expected; 12 bytes a half-edge and as many a vertex.
///
/// A vertex begins with as many nodes as it has half-edges, and the nodes of neighbours that move
/// from one vertex to another move along, so that none is ever made.
#[derive(Debug)]
pub(super) struct NeighbourSets {
    /// The nodes, and behind them one for each vertex whose left child is the root of its set.
    nodes: Vec<TreapNode>,
    /// First of the nodes that hold roots.
    roots: u32,
}

#[derive(Clone, Copy, Debug)]
struct TreapNode {
    neighbour: VertexId,
    /// Roots of the lesser and the greater neighbours, or [`NIL`].
    children: [u32; 2],
}

const NIL: u32 = u32::MAX;

/// A place that holds a reference to a node: the holding node, and the number of the child.
type Link = (u32, usize);

/// A node that is in no set.
#[derive(Debug)]
pub(super) struct FreeNode(u32);

impl NeighbourSets {
    /// Gathers the neighbours of all vertices of `k`. O(n log d) expected, for the mean degree d.
    pub(super) fn new(k: &ShrinkingTriangulation) -> Self {
        let empty = TreapNode { neighbour: VertexId::NONE, children: [NIL; 2] };
        let roots = k.half_edge_id_count();
        let nodes = vec![empty; roots + k.vertex_id_count()];
        let mut sets = Self { nodes, roots: roots as u32 };
        for h in (0..roots).map(HalfEdgeId::new) {
            sets.insert(k.origin(h), FreeNode(h.index() as u32), k.destination(h));
        }
        sets
    }

    /// Returns whether `w` is a neighbour of `v`.
    pub(super) fn contains(&self, v: VertexId, w: VertexId) -> bool {
        let (holder, side) = self.root(v);
        let mut at = self.nodes[holder as usize].children[side];
        while at != NIL {
            let node = &self.nodes[at as usize];
            if node.neighbour == w {
                return true;
            }
            at = node.children[usize::from(node.neighbour < w)];
        }
        false
    }

    /// Adds `w`, which must not be in, to the neighbours of `v`.
    pub(super) fn insert(&mut self, v: VertexId, FreeNode(node): FreeNode, w: VertexId) {
        let mut place = self.root(v);
        let mut below = self.at(place);
        while below != NIL && priority(below) > priority(node) {
            place = (below, usize::from(self.nodes[below as usize].neighbour < w));
            below = self.at(place);
        }
        self.put(place, node);
        self.nodes[node as usize].neighbour = w;
        // The subtree that was there is cut in two along the search path of w.
        let mut ends = [(node, 0), (node, 1)];
        while below != NIL {
            let lesser = self.nodes[below as usize].neighbour < w;
            let (this, onward) = (usize::from(!lesser), usize::from(lesser));
            self.put(ends[this], below);
            ends[this] = (below, onward);
            below = self.at(ends[this]);
        }
        ends.into_iter().for_each(|end| self.put(end, NIL));
    }

    /// Removes `w`, which must be present, from the neighbours of `v`.
    pub(super) fn remove(&mut self, v: VertexId, w: VertexId) -> FreeNode {
        let mut place = self.root(v);
        let mut node = self.at(place);
        while self.nodes[node as usize].neighbour != w {
            place = (node, usize::from(self.nodes[node as usize].neighbour < w));
            node = self.at(place);
        }
        // The two subtrees become one, along the right edge of the left and the left of the right.
        let mut halves = self.nodes[node as usize].children;
        while halves[0] != NIL && halves[1] != NIL {
            let upper = usize::from(priority(halves[1]) > priority(halves[0]));
            self.put(place, halves[upper]);
            place = (halves[upper], 1 - upper);
            halves[upper] = self.at(place);
        }
        self.put(place, if halves[0] == NIL { halves[1] } else { halves[0] });
        FreeNode(node)
    }

    fn root(&self, v: VertexId) -> Link {
        (self.roots + v.index() as u32, 0)
    }

    fn at(&self, (holder, side): Link) -> u32 {
        self.nodes[holder as usize].children[side]
    }

    fn put(&mut self, (holder, side): Link, node: u32) {
        self.nodes[holder as usize].children[side] = node;
    }
}

/// Returns the rank of a node, as good as random and different for each (the finaliser of
/// MurmurHash3).
fn priority(node: u32) -> u32 {
    let node = (node ^ (node >> 16)).wrapping_mul(0x85eb_ca6b);
    let node = (node ^ (node >> 13)).wrapping_mul(0xc2b2_ae35);
    node ^ (node >> 16)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::mesh::Mesh;
    use crate::random::Random;
    use crate::triangulation::Triangulation;

    /// Neighbours in order, and that no node ranks above its parent.
    fn content(sets: &NeighbourSets, v: VertexId) -> Vec<VertexId> {
        let mut found = Vec::new();
        let mut pending = vec![sets.at(sets.root(v))];
        while let Some(node) = pending.pop().filter(|&node| node != NIL) {
            let TreapNode { neighbour, children } = sets.nodes[node as usize];
            found.push(neighbour);
            for child in children.into_iter().filter(|&child| child != NIL) {
                assert!(priority(child) < priority(node));
                pending.push(child);
            }
        }
        found.sort_unstable();
        found
    }

    /// A ring of 40 vertices between two, one of which is joined to all.
    #[test]
    fn sets_agree_with_ordered_sets_while_neighbours_move() {
        let pair = |i: u32| [[i, (i + 1) % 40, 40], [(i + 1) % 40, i, 41]];
        let triangles = (0..40).flat_map(pair).collect();
        let list = Mesh::from_triangles(vec![[0.0; 3]; 42], triangles);
        let k = ShrinkingTriangulation::from(Triangulation::build(&list).unwrap());
        let mut sets = NeighbourSets::new(&k);
        let id = |v: u32| VertexId::new(v as usize);
        let neighbours = |v| k.spokes(id(v)).map(|h| k.destination(h)).collect();
        let mut expected: Vec<BTreeSet<VertexId>> = (0..42).map(neighbours).collect();
        let mut random = Random::stream(2, &["neighbour-sets"]);
        for _ in 0..2000 {
            let [from, to] = [0, 0].map(|_| random.below(42));
            let size = expected[from as usize].len();
            if size > 0 {
                let moving = random.below(size as u32) as usize;
                let w = *expected[from as usize].iter().nth(moving).unwrap();
                if expected[to as usize].insert(w) {
                    expected[from as usize].remove(&w);
                    let node = sets.remove(id(from), w);
                    sets.insert(id(to), node, w);
                }
            }
            let [v, w] = [0, 0].map(|_| random.below(42));
            assert_eq!(sets.contains(id(v), id(w)), expected[v as usize].contains(&id(w)));
        }
        for v in 0..42 {
            assert!(content(&sets, id(v)).into_iter().eq(expected[v as usize].iter().copied()));
        }
    }
}
