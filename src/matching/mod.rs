//! Matchings in graphs: alternating trees and blossoms (Edmonds), for pairing and augmentation, and
//! perfect matchings of least cost ([`weighted`]).
//!
//! Uses [`dual`](crate::dual) alone.

mod forest;
mod rescue;
mod single_tree;
pub mod weighted;

pub(crate) use forest::{Forest, Place, TreeId};
pub(crate) use rescue::Rescue;
pub(crate) use single_tree::{Augmented, augment_from};
