//! The surgery that the operations are made of; half-edges are indices here.

use super::half_edges::{HalfEdge, Sculptor, next, previous};

impl Sculptor {
    /// The half-edge meant by an arbitrary number.
    pub(super) fn half_edge(&self, choice: u32) -> usize {
        (choice % self.half_edge_count()) as usize
    }

    /// The first half-edge of the face meant by an arbitrary number.
    pub(super) fn first_half_edge(&self, face: u32) -> usize {
        3 * (face % self.face_count()) as usize
    }

    /// The vertex that `h` leaves.
    pub(super) fn origin(&self, h: usize) -> u32 {
        self.half_edges[h].origin
    }

    /// The other half-edge of the edge of `h`.
    pub(super) fn twin(&self, h: usize) -> usize {
        self.half_edges[h].twin as usize
    }

    /// Makes two half-edges each other's twins.
    pub(super) fn link(&mut self, g: usize, h: usize) {
        self.half_edges[g].twin = h as u32;
        self.half_edges[h].twin = g as u32;
    }

    /// Origin of `h`.
    pub(super) fn position(&self, h: usize) -> [f64; 3] {
        self.positions[self.origin(h) as usize]
    }

    /// The middle of the edge of `h`.
    pub(super) fn middle(&self, h: usize) -> [f64; 3] {
        let [a, b] = [h, next(h)].map(|h| self.position(h));
        [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]))
    }

    /// The centroid of the face of `h`.
    pub(super) fn centroid(&self, h: usize) -> [f64; 3] {
        let [a, b, c] = [h, next(h), previous(h)].map(|h| self.position(h));
        [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0)
    }

    /// The number of the next half-edge, after making sure that `more` of them can be numbered.
    pub(super) fn reserve(&self, more: usize) -> u32 {
        let total = u32::try_from(self.half_edges.len() + more);
        total.expect("the half-edges of a surface fit a u32") - more as u32
    }

    /// Returns whether an edge joins the vertices that `g` and `h` leave. Walks around both in
    /// step, so the smaller degree counts, and the two chains of memory accesses overlap.
    pub(super) fn are_joined(&self, g: usize, h: usize) -> bool {
        let (from_g, from_h) = (self.origin(g), self.origin(h));
        let (mut around_g, mut around_h) = (g, h);
        loop {
            if self.origin(next(around_g)) == from_h || self.origin(next(around_h)) == from_g {
                return true;
            }
            around_g = self.twin(previous(around_g));
            around_h = self.twin(previous(around_h));
            if around_g == g || around_h == h {
                return false;
            }
        }
    }

    /// Splits the face of `h`, from `a` to `b`, at a new vertex `v`. Half-edge `h` keeps its
    /// place, in the face `a b v`.
    ///
    /// ```text
    ///         c                    c
    ///        / \                  /|\
    ///       /   \                / | \        a b v  (the old face)
    ///      /     \       →      /  v  \       b c v  (from half-edge k)
    ///     /       \            / /   \ \      c a v  (from half-edge k + 3)
    ///    /   h →   \          //  h →  \\
    ///   a-----------b        a-----------b
    /// ```
    pub(super) fn insert_vertex(&mut self, h: usize, position: [f64; 3]) {
        let k = self.reserve(6) as usize;
        let v = self.positions.len() as u32;
        self.positions.push(position);
        let [a, b, c] = [h, next(h), previous(h)].map(|h| self.origin(h));
        let [beyond_bc, beyond_ca] = [next(h), previous(h)].map(|h| self.twin(h));

        self.half_edges[previous(h)].origin = v;
        // The twins follow.
        self.half_edges.extend([b, c, v, c, a, v].map(|origin| HalfEdge { origin, twin: 0 }));
        self.link(k, beyond_bc);
        self.link(k + 3, beyond_ca);
        self.link(k + 1, k + 5);
        self.link(k + 2, next(h));
        self.link(k + 4, previous(h));
    }

    /// Replaces the edge of `h`, from `a` to `b`, by the edge between `c` and `d`, which must not
    /// exist yet. The half-edges from `c` to `a` and from `d` to `b` keep their places.
    ///
    /// ```text
    ///         c                     c
    ///       /   \                 / | \
    ///      / h →  \              /  |  \
    ///     a-------b      →      a   |   b
    ///      \ ← t  /              \  |  /
    ///       \   /                 \ | /
    ///         d                     d
    /// ```
    pub(super) fn turn_edge(&mut self, h: usize) {
        let t = self.twin(h);
        let (c, d) = (self.origin(previous(h)), self.origin(previous(t)));
        let [beyond_bc, beyond_ad] = [next(h), next(t)].map(|h| self.twin(h));
        // Face of h: a d, d c, c a.  Face of t: b c, c d, d b.
        self.half_edges[next(h)].origin = d;
        self.half_edges[next(t)].origin = c;
        self.link(h, beyond_ad);
        self.link(t, beyond_bc);
        self.link(next(h), next(t));
    }

    /// Takes over the vertices of `other` except those of its first face, which are identified
    /// with the corners of the face of `h`; returns the new number of each.
    pub(super) fn adopt_vertices(&mut self, other: &Self, h: usize) -> Vec<u32> {
        let (here, there) = (self.centroid(h), other.centroid(0));
        let mut names = vec![u32::MAX; other.positions.len()];
        // Reversed, so that both surfaces lie on the left of their own half-edges.
        for (theirs, mine) in [next(h), h, previous(h)].into_iter().enumerate() {
            names[other.origin(theirs) as usize] = self.origin(mine);
        }
        for (name, p) in names.iter_mut().zip(&other.positions) {
            if *name == u32::MAX {
                *name = self.positions.len() as u32;
                self.positions.push([0, 1, 2].map(|i| p[i] - there[i] + here[i]));
            }
        }
        names
    }

    /// Drops the face that starts with `h` and to which no twin points; the last face takes its
    /// number.
    pub(super) fn remove_face(&mut self, h: usize) {
        let last = self.half_edges.len() - 3;
        if h != last {
            for corner in 0..3 {
                self.half_edges[h + corner].origin = self.origin(last + corner);
                self.link(h + corner, self.twin(last + corner));
            }
        }
        self.half_edges.truncate(last);
    }
}
