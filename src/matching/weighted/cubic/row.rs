//! One node.

use super::super::number::Number;

/// One node. 32 bytes with 32-bit numbers.
///
/// State, from the lowest bit: mate side (2, 3 for the ground), parent side (2), label (2), whether
/// there is a mate (1), mark (1), set (the rest).
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub(super) struct Row<N: Number> {
    pub(super) twins: [u32; 3],
    pub(super) costs: [N; 3],
    pub(super) potential: N,
    pub(super) state: N::State,
}

/// First bit of the set in a state.
pub(super) const SET: u32 = 8;

/// State of a node without mate, label, mark and set.
pub(super) const EMPTY: u64 = u64::MAX << SET;
