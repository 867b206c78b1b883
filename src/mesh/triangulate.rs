//! Polygons cut into triangles, so that no edge and no triangle comes twice.
//!
//! A diagonal must not be an edge of the mesh, nor a diagonal of another polygon: where vertices
//! have degree 2, two polygons have the same two corners more than once. Polygons of five and more
//! corners are cut first and avoid diagonals that others could need. Quads then have two cuts each,
//! so what is left is 2-satisfiability, decided by limited backtracking.

use std::collections::{BTreeMap, BTreeSet};

use super::faces::Faces;
use super::polygon_cut::{Polygon, Triangle};
use super::polygon_mesh::Mesh;

/// A polygon of which every cut makes an edge or a triangle that is there already.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[error(
    "face {} cannot be cut into triangles: each cut makes an edge or a triangle twice",
    .face + 1
)]
pub struct CutError {
    /// The face, as the file counts, from 0.
    pub face: usize,
}

/// The two cuts of a quad, at its first and at its second corner.
const QUAD_CUTS: [[Triangle; 2]; 2] = [[[0, 1, 2], [0, 2, 3]], [[0, 1, 3], [1, 2, 3]]];

/// The diagonals that they use.
const QUAD_DIAGONALS: [[usize; 2]; 2] = [[0, 2], [1, 3]];

/// Polygons with more corners claim no diagonal; those that they use are taken.
const CLAIMING: usize = 16;

impl Mesh {
    /// Cuts every face of more than three corners into triangles.
    ///
    /// No cut makes an edge or a triangle that the mesh has already, and of the cuts that are left
    /// the best-shaped is made, polygon by polygon. Faces of fewer corners stay what they are. So
    /// do those that are refused in any case: with a corner twice, or none that exists.
    ///
    /// # Errors
    /// A polygon has no such cut. Then the mesh is unchanged. For quads this is exact, for larger
    /// polygons a cut may exist that was not found.
    ///
    /// # Cost
    /// O(n log n), cubic in the corners of a polygon up to 16 corners.
    pub fn triangulate(&mut self) -> Result<(), CutError> {
        if self.faces.arity() == Some(3) {
            return Ok(());
        }
        let cuts = Cutter::new(self).cut();
        let cuts = cuts.map_err(|face| CutError { face: self.face_in_file(face) })?;
        let mut faces = Faces::default();
        let (mut sources, mut origins, mut cut) = (Vec::new(), Vec::new(), 0);
        let mut first_new = Vec::with_capacity(self.faces.len() + 1);
        for (index, face) in self.faces.iter().enumerate() {
            first_new.push(faces.len());
            let start = self.faces.range(index).start;
            let mut push = |corners: &[u32]| {
                sources.extend(corners.iter().map(|&corner| start + corner as usize));
                faces
                    .push(&corners.iter().map(|&corner| face[corner as usize]).collect::<Vec<_>>());
                origins.push(self.face_in_file(index) as u32);
            };
            match cuts.of(index, face.len()) {
                Some(triangles) => {
                    cut += 1;
                    triangles.iter().for_each(|triangle| push(triangle));
                }
                None => push(&(0..face.len() as u32).collect::<Vec<_>>()),
            }
        }
        first_new.push(faces.len());
        self.set_derived_faces(faces, &sources, &first_new, origins);
        self.note_repairs([(
            "triangulate cut",
            cut,
            ["face into triangles", "faces into triangles"],
        )]);
        Ok(())
    }
}

/// The cut of every polygon.
#[derive(Default)]
struct Cuts {
    /// For each face which of its two cuts a quad has.
    quads: Vec<u8>,
    /// Cuts of larger polygons.
    larger: BTreeMap<usize, Vec<Triangle>>,
}

impl Cuts {
    /// Returns the triangles of a face; none if it is not cut.
    fn of(&self, face: usize, corners: usize) -> Option<&[Triangle]> {
        match corners {
            0..=3 => None,
            4 => Some(&QUAD_CUTS[self.quads[face] as usize]),
            _ => self.larger.get(&face).map(Vec::as_slice),
        }
    }
}

/// A quad whose cut is open.
const OPEN: u8 = 2;

/// Finds the cuts.
struct Cutter<'m> {
    mesh: &'m Mesh,
    /// Keys of all edges, in ascending order.
    edges: Vec<u64>,
    /// Diagonals that more than one polygon could use, with the quads that could, in ascending
    /// order.
    contested: Vec<(u64, u32)>,
    /// Diagonals that larger polygons use.
    taken: BTreeSet<u64>,
    cuts: Cuts,
}

impl<'m> Cutter<'m> {
    fn new(mesh: &'m Mesh) -> Self {
        let mut edges = Vec::with_capacity(mesh.faces.corners().len());
        let mut claims = Vec::new();
        for (index, face) in mesh.faces.iter().enumerate() {
            let next = face.iter().cycle().skip(1);
            edges.extend(face.iter().zip(next).map(|(&a, &b)| key(a, b)));
            for i in (0..face.len()).filter(|_| (4..=CLAIMING).contains(&face.len())) {
                let end = if i == 0 { face.len() - 1 } else { face.len() };
                claims.extend((i + 2..end).map(|j| (key(face[i], face[j]), index as u32)));
            }
        }
        edges.sort_unstable();
        edges.dedup();
        claims.sort_unstable();
        let contested = claims.chunk_by(|a, b| a.0 == b.0).filter(|group| group.len() > 1);
        let contested = contested.flatten().copied().collect();
        let cuts = Cuts { quads: vec![0; mesh.faces.len()], larger: BTreeMap::new() };
        Self { mesh, edges, contested, taken: BTreeSet::new(), cuts }
    }

    /// Cuts all polygons; the error is the first that cannot be cut.
    fn cut(mut self) -> Result<Cuts, usize> {
        for (index, face) in self.mesh.faces.iter().enumerate() {
            if face.len() == 4 {
                self.cuts.quads[index] = self.first_choice(face);
            } else if face.len() > 4 {
                self.cut_larger(index, face).ok_or(index)?;
            }
        }
        let open: Vec<usize> =
            (0..self.mesh.faces.len()).filter(|&face| self.cuts.quads[face] == OPEN).collect();
        // Those without a choice first: what follows from them is no choice of others either.
        let has_no_choice =
            |quad: &usize| [0, 1].iter().any(|&cut| self.is_gone(self.diagonal(*quad, cut)));
        let (forced, free): (Vec<_>, Vec<_>) = open.into_iter().partition(has_no_choice);
        for quad in forced.into_iter().chain(free) {
            if self.cuts.quads[quad] == OPEN {
                self.cut_quad(quad)?;
            }
        }
        Ok(self.cuts)
    }

    /// Returns the better-shaped cut of a quad, or `OPEN` if it has to be looked at again.
    fn first_choice(&self, quad: &[u32]) -> u8 {
        if !self.is_sound(quad) {
            return 0;
        }
        let is_open = |[i, j]: [usize; 2]| {
            let diagonal = key(quad[i], quad[j]);
            self.is_edge(diagonal) || self.is_contested(diagonal)
        };
        match QUAD_DIAGONALS.into_iter().any(is_open) {
            true => OPEN,
            false => self.better_cut(quad),
        }
    }

    fn better_cut(&self, quad: &[u32]) -> u8 {
        let polygon = self.polygon(quad);
        let worst = QUAD_CUTS.map(|[a, b]| polygon.shape(a).min(polygon.shape(b)));
        u8::from(worst[1] > worst[0])
    }

    /// Cuts a polygon of more than four corners; a fan if it is not sound.
    fn cut_larger(&mut self, index: usize, face: &[u32]) -> Option<()> {
        let triangles = if self.is_sound(face) {
            let price = |i: u32, j: u32| {
                let diagonal = key(face[i as usize], face[j as usize]);
                (!self.is_gone(diagonal)).then(|| u32::from(self.is_contested(diagonal)))
            };
            self.polygon(face).cut(&price)?
        } else {
            (1..face.len() as u32 - 1).map(|at| [0, at, at + 1]).collect()
        };
        // A side of the polygon may be among these; it is an edge in any case.
        let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        self.taken.extend(sides.map(|[a, b]| key(face[a as usize], face[b as usize])));
        self.cuts.larger.insert(index, triangles);
        Some(())
    }

    /// Decides the cut of a quad, and of the quads that have no choice then.
    fn cut_quad(&mut self, index: usize) -> Result<(), usize> {
        let better = self.better_cut(&self.mesh.faces[index]);
        for cut in [better, 1 - better] {
            let mut decided = Vec::new();
            if self.decide(index, cut, &mut decided) {
                return Ok(());
            }
            decided.into_iter().for_each(|quad: usize| self.cuts.quads[quad] = OPEN);
        }
        Err(index)
    }

    /// Gives a quad a cut, and others what follows from it; returns whether that is possible.
    fn decide(&mut self, quad: usize, cut: u8, decided: &mut Vec<usize>) -> bool {
        let mut forced = vec![(quad, cut)];
        while let Some((quad, cut)) = forced.pop() {
            match self.cuts.quads[quad] {
                OPEN => {}
                given if given == cut => continue,
                _ => return false,
            }
            self.cuts.quads[quad] = cut;
            decided.push(quad);
            let diagonal = self.diagonal(quad, cut);
            if self.is_gone(diagonal) {
                return false;
            }
            for &(_, other) in self.claimants(diagonal) {
                let other = other as usize;
                if other != quad && self.mesh.faces[other].len() == 4 {
                    let use_it = u8::from(self.diagonal(other, 1) == diagonal);
                    forced.push((other, 1 - use_it));
                }
            }
        }
        true
    }

    fn diagonal(&self, quad: usize, cut: u8) -> u64 {
        let [i, j] = QUAD_DIAGONALS[cut as usize];
        key(self.mesh.faces[quad][i], self.mesh.faces[quad][j])
    }

    /// Returns the polygons that could use a contested diagonal; none if it is not contested.
    fn claimants(&self, diagonal: u64) -> &[(u64, u32)] {
        let start = self.contested.partition_point(|&(key, _)| key < diagonal);
        let length =
            self.contested[start..].iter().take_while(|&&(key, _)| key == diagonal).count();
        &self.contested[start..start + length]
    }

    fn is_contested(&self, diagonal: u64) -> bool {
        self.contested.binary_search_by_key(&diagonal, |&(key, _)| key).is_ok()
    }

    fn is_edge(&self, diagonal: u64) -> bool {
        self.edges.binary_search(&diagonal).is_ok()
    }

    /// Returns whether a diagonal of a quad is no more to be had.
    fn is_gone(&self, diagonal: u64) -> bool {
        self.is_edge(diagonal) || self.taken.contains(&diagonal)
    }

    /// Returns whether all corners of a face exist and are different.
    fn is_sound(&self, face: &[u32]) -> bool {
        let mut corners = face.to_vec();
        corners.sort_unstable();
        let exists = |&v: &u32| (v as usize) < self.mesh.positions.len();
        corners.windows(2).all(|pair| pair[0] != pair[1]) && corners.iter().all(exists)
    }

    fn polygon(&self, face: &[u32]) -> Polygon {
        Polygon::new(face.iter().map(|&v| self.mesh.positions[v as usize]))
    }
}

/// Returns a number for the pair of two vertices.
fn key(a: u32, b: u32) -> u64 {
    u64::from(a.min(b)) << 32 | u64::from(a.max(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    const OCTAHEDRON: [[f64; 3]; 6] = [
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.5, 0.0],
        [0.0, -1.5, 0.0],
        [0.0, 0.0, 2.0],
        [0.0, 0.0, -2.0],
    ];

    fn cut(positions: &[[f64; 3]], faces: &[&[u32]]) -> Result<Vec<Vec<u32>>, CutError> {
        let mut mesh = Mesh::new(positions.to_vec(), faces.iter().collect());
        mesh.triangulate()?;
        Ok(mesh.faces().iter().map(<[u32]>::to_vec).collect())
    }

    /// Returns whether every edge is passed once in each direction.
    fn is_closed(triangles: &[Vec<u32>]) -> bool {
        let sides = triangles.iter().flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
        let sides: Vec<_> = sides.collect();
        let set: BTreeSet<_> = sides.iter().copied().collect();
        set.len() == sides.len() && sides.iter().all(|&[a, b]| set.contains(&[b, a]))
    }

    #[test]
    fn polygons_at_vertices_of_degree_2_share_no_diagonal() {
        let quads: [&[u32]; 4] = [&[5, 2, 4, 0], &[5, 1, 4, 2], &[5, 3, 4, 1], &[5, 0, 4, 3]];
        let triangles = cut(&OCTAHEDRON, &quads).unwrap();
        assert!(triangles.len() == 8 && is_closed(&triangles), "{triangles:?}");
        // Two quads with the same four corners: a tetrahedron comes out.
        let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [1.0, 1.0, 0.0], [0.0, 1.0, 0.1]];
        let triangles = cut(&positions, &[&[0, 1, 2, 3], &[3, 2, 1, 0]]).unwrap();
        assert!(triangles.len() == 4 && is_closed(&triangles), "{triangles:?}");
        // Two hexagons on the same corners.
        let hexagon = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(|k: f64| [k, k * (5.0 - k), 0.1 * k]);
        let triangles = cut(&hexagon, &[&[0, 1, 2, 3, 4, 5], &[5, 4, 3, 2, 1, 0]]).unwrap();
        assert!(triangles.len() == 8 && is_closed(&triangles), "{triangles:?}");
    }

    #[test]
    fn a_polygon_without_a_cut_is_named() {
        // Three quads on the same corners want three diagonals of two.
        let faces: [&[u32]; 4] = [&[0, 4, 5], &[0, 1, 2, 3], &[3, 2, 1, 0], &[0, 1, 2, 3]];
        assert_eq!(cut(&OCTAHEDRON, &faces), Err(CutError { face: 1 }));
        // Both diagonals are edges.
        let faces: [&[u32]; 3] = [&[0, 2, 4], &[1, 3, 4], &[0, 1, 2, 3]];
        assert_eq!(cut(&OCTAHEDRON, &faces), Err(CutError { face: 2 }));
    }

    #[test]
    fn the_better_shaped_cut_is_made_whatever_the_size() {
        for size in [1.0, 1e-300, 1e300] {
            let rhombus = [[0.0, 0.0], [3.0, -1.0], [6.0, 0.0], [3.0, 1.0]];
            let dart = [[0.0, 0.0], [4.0, 3.0], [0.0, 1.0], [-4.0, 3.0]];
            for (points, expected) in
                [(rhombus, [[0, 1, 3], [1, 2, 3]]), (dart, [[0, 1, 2], [0, 2, 3]])]
            {
                let points = points.map(|[x, y]| [size * x, size * y, size]);
                assert_eq!(cut(&points, &[&[0, 1, 2, 3]]).unwrap(), expected, "{size}");
            }
            let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
            let square = square.map(|[x, y]| [size * x, size * y, 0.0]);
            assert_eq!(cut(&square, &[&[0, 1, 2, 3]]).unwrap(), [[0, 1, 2], [0, 2, 3]]);
        }
    }

    #[test]
    fn large_polygons_are_cut_without_using_a_diagonal_twice() {
        for n in [5_u32, 16, 17, 40, 300] {
            let circle = (0..n).map(|k| {
                let angle = f64::from(k) * std::f64::consts::TAU / f64::from(n);
                [angle.cos(), angle.sin(), 0.0]
            });
            let front: Vec<u32> = (0..n).collect();
            let back: Vec<u32> = (0..n).rev().collect();
            let triangles = cut(&circle.collect::<Vec<_>>(), &[&front, &back]).unwrap();
            assert_eq!(triangles.len(), 2 * (n as usize - 2));
            assert!(is_closed(&triangles), "{n}");
        }
    }
}
