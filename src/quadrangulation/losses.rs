//! Attributes of triangles that their quads cannot keep.

use std::collections::HashMap;

use super::edge_ends::corners_at_ends;
use super::edge_quad::quad_corners;
use crate::counted::counted;
use crate::mesh::{Attributes, CornerIndices, TextList};
use crate::triangulation::{HalfEdgeId, Surface, TriangleId};

/// Edges at which an attribute changes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Border {
    /// All such edges of the triangulation given.
    pub edges: usize,
    /// Those inside a quad, where the attribute of one triangle is lost.
    pub inside_quads: usize,
}

/// Attributes that a quad takes from one of its triangles although the other has another, and
/// corners that lose theirs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct AttributeLosses {
    /// Seams of the texture.
    pub texture_seams: Border,
    /// Edges at which normals differ.
    pub normal_seams: Border,
    /// Borders of materials (`usemtl`).
    pub materials: Border,
    /// Borders of groups (`g`, `o`).
    pub groups: Border,
    /// Borders of smoothing groups (`s`).
    pub smoothing_groups: Border,
    /// Quads with a texture coordinate at some corners only; all are dropped there.
    pub quads_without_texture: usize,
    /// Quads with a normal at some corners only; all are dropped there.
    pub quads_without_normals: usize,
}

impl AttributeLosses {
    /// Returns what is lost, in words for the user.
    pub fn notes(&self) -> Vec<String> {
        let borders = [
            (self.texture_seams, "texture seam ", ""),
            (self.normal_seams, "", " between different normals"),
            (self.materials, "", " between materials"),
            (self.groups, "", " between groups"),
            (self.smoothing_groups, "", " between smoothing groups"),
        ];
        let lost = borders.into_iter().filter(|(border, ..)| border.inside_quads > 0);
        let lost = lost.map(|(Border { edges, inside_quads }, before, behind)| {
            let edges = counted(edges, format!("{before}edge"), format!("{before}edges"));
            format!("{inside_quads} of {edges}{behind} (inside quads)")
        });
        let partial = [
            (self.quads_without_texture, "texture coordinates"),
            (self.quads_without_normals, "normals"),
        ];
        let partial = partial.into_iter().filter(|(quads, _)| *quads > 0);
        let partial = partial.map(|(quads, what)| {
            let quads = counted(quads, "quad", "quads");
            format!("the {what} of {quads} (not all corners have one)")
        });
        lost.chain(partial).collect()
    }
}

/// Counts what the quads made by removing `removed` from `paired` lose of `attributes`.
///
/// `input` is the surface that has the attributes, on the vertices of `paired`; `corner` has for a
/// half-edge of `paired` the corner of `input` whose attributes its corner takes. O(n log s) for s
/// sections.
pub(super) fn count(
    attributes: &Attributes,
    input: &impl Surface,
    paired: &impl Surface,
    removed: &[HalfEdgeId],
    corner: impl Fn(HalfEdgeId) -> usize,
) -> AttributeLosses {
    let changes = Changes::new(attributes);
    let mut losses = AttributeLosses::default();
    for side in input.edges() {
        changes.count(input, side, &HalfEdgeId::index, &mut losses, |border| &mut border.edges);
    }
    for &side in removed {
        changes.count(paired, side, &corner, &mut losses, |border| &mut border.inside_quads);
    }
    let partial = |indices: &CornerIndices| {
        let has = |h: HalfEdgeId| indices.get(corner(h)).is_some();
        let is_partial = |&&side: &&HalfEdgeId| {
            let corners = paired.across(side).map(|twin| quad_corners([side, twin]));
            corners.is_some_and(|corners| {
                corners.into_iter().any(has) && !corners.into_iter().all(has)
            })
        };
        if indices.is_empty() { 0 } else { removed.iter().filter(is_partial).count() }
    };
    losses.quads_without_texture = partial(&attributes.corner_texture);
    losses.quads_without_normals = partial(&attributes.corner_normal);
    losses
}

/// Says at which edges attributes change.
struct Changes<'m> {
    attributes: &'m Attributes,
    /// For each section the lines that hold from it on, as indices of sections with equal lines.
    states: Vec<[usize; 4]>,
}

/// Keywords of sections, in the order of a state.
const KEYWORDS: [&str; 4] = ["usemtl", "g", "o", "s"];

impl<'m> Changes<'m> {
    fn new(attributes: &'m Attributes) -> Self {
        let mut first_with = HashMap::new();
        let mut state = [usize::MAX; 4];
        let mut states = vec![state];
        for (index, section) in attributes.sections.iter().enumerate() {
            let line = *first_with.entry(section.line).or_insert(index);
            if let Some(kind) = KEYWORDS.iter().position(|word| *word == section.keyword()) {
                state[kind] = line;
            }
            states.push(state);
        }
        Self { attributes, states }
    }

    /// Counts the edge of `side` at the attributes that change there.
    fn count(
        &self,
        surface: &impl Surface,
        side: HalfEdgeId,
        corner: &impl Fn(HalfEdgeId) -> usize,
        losses: &mut AttributeLosses,
        counter: impl Fn(&mut Border) -> &mut usize,
    ) {
        let Some(twin) = surface.across(side) else { return };
        let ends = corners_at_ends(surface, [side, twin]).map(|pair| pair.map(corner));
        let Attributes { texture_coordinates, normals, corner_texture, corner_normal, .. } =
            self.attributes;
        let [one, other] = [side, twin].map(|side| self.state(side.triangle()));
        let changes = [
            (&mut losses.texture_seams, differ(corner_texture, texture_coordinates, ends)),
            (&mut losses.normal_seams, differ(corner_normal, normals, ends)),
            (&mut losses.materials, one[0] != other[0]),
            (&mut losses.groups, one[1..3] != other[1..3]),
            (&mut losses.smoothing_groups, one[3] != other[3]),
        ];
        for (border, changes) in changes {
            *counter(border) += usize::from(changes);
        }
    }

    /// Returns the state of the sections at a triangle.
    fn state(&self, triangle: TriangleId) -> [usize; 4] {
        let face = triangle.index();
        self.states[self.attributes.sections.count_before(face + 1)]
    }
}

/// Returns whether the two corners at one of the ends have different elements.
fn differ(indices: &CornerIndices, elements: &TextList, ends: [[usize; 2]; 2]) -> bool {
    let element = |index: Option<u32>| index.and_then(|index| elements.get(index as usize));
    !indices.is_empty()
        && ends.into_iter().any(|corners| {
            let [one, other] = corners.map(|corner| indices.get(corner));
            one != other && element(one) != element(other)
        })
}
