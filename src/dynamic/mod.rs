//! Dynamic trees and dynamic graphs: forests and graphs that change edge by edge and answer
//! questions in between.
//!
//! | structure | answers | change | question |
//! |---|---|---|---|
//! | [`LinkCutForest`] | paths: lowest common ancestors, values on paths | O(log n) | O(log n) |
//! | [`EulerTourForest`] | trees: size, a marked node | O(log n) | O(log n) |
//! | [`DynamicConnectivity`] | graphs: connected or not | O(log² n) | O(log n) |
//!
//! All costs are amortised, n being the number of nodes. Nodes are numbers `0..n`; everything lies
//! in flat arrays of 32-bit indices, nothing is recursive and nothing random.
//!
//! Each structure has an example. Operations that it does not show have no examples of their own.

// Hidden: one pairing algorithm is the only user. It is public for its benchmark and for the tests
// against naive structures, and may change in any release.
#![doc(hidden)]

mod connectivity;
mod euler_tour;
mod link_cut;
mod none;

pub use connectivity::{Deletion, DynamicConnectivity};
pub use euler_tour::{EulerTourForest, NodeMark};
pub use link_cut::LinkCutForest;
