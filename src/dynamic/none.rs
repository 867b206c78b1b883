//! The index that stands for "no node" or "no edge".

/// No node, no edge.
pub(super) const NONE: u32 = u32::MAX;
