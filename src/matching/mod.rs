//! What pairing and augmentation both search with: alternating trees and blossoms (Edmonds).
//!
//! Uses [`dual`](crate::dual) alone.

mod forest;
mod rescue;
mod single_tree;

pub(crate) use forest::{Forest, Place, TreeId};
pub(crate) use rescue::Rescue;
pub(crate) use single_tree::augment_from;
