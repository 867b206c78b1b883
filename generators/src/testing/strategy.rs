//! Surfaces that shrink.

use proptest::collection::vec;
use proptest::prelude::*;

use crate::classic::{seven_vertex_torus, tetrahedron};
use crate::sculptor::{Operation, Sculptor};
use crate::surface::Surface;

/// Returns surfaces of genus 0 to 3 made by fewer than 40 edits of a small one.
///
/// A failing case shrinks to fewer edits, to earlier places and to a lower genus.
pub fn sculpted_surface() -> impl Strategy<Value = Surface> {
    let operation = prop_oneof![
        any::<u32>().prop_map(Operation::SplitFace),
        any::<u32>().prop_map(Operation::SplitEdge),
        any::<u32>().prop_map(Operation::Flip),
    ];
    (0..4usize, vec(operation, 0..40)).prop_map(|(genus, operations)| {
        let torus = seven_vertex_torus();
        let mut sculptor = Sculptor::from(&if genus == 0 { tetrahedron() } else { torus.clone() });
        (1..genus).for_each(|_| sculptor.join(&torus, 0));
        operations.into_iter().for_each(|operation| sculptor.apply(operation));
        sculptor.into_surface()
    })
}
