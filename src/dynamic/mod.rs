//! Dynamic trees and dynamic graphs: forests and graphs that change edge by edge, and questions
//! about them in between.
//!
//! | structure | answers | change | question |
//! |---|---|---|---|
//! | [`LinkCutForest`] | paths: lowest common ancestors, values on paths | O(log n) | O(log n) |
//! | [`EulerTourForest`] | trees: size, a marked node | O(log n) | O(log n) |
//! | [`DynamicConnectivity`] | graphs: connected or not | O(log² n) | O(log n) |
//!
//! All costs are amortised, n being the number of nodes. Nodes are numbers `0..n`; everything lies in
//! flat arrays of 32-bit indices, nothing is recursive and nothing random.

mod connectivity;
mod euler_tour;
mod link_cut;

pub use connectivity::{Deletion, DynamicConnectivity};
pub use euler_tour::{EulerTourForest, Mark};
pub use link_cut::LinkCutForest;

/// Stands for "no node" or "no edge".
const NONE: u32 = u32::MAX;
