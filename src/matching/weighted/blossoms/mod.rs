//! Alternating trees with blossoms: each search pairs one more node (Edmonds 1965).
//!
//! A search grows a tree from an unpaired top. Potentials of outer nodes rise and those of inner
//! ones fall with a clock, until an edge to a *target*, a top that can be the last of a path,
//! becomes tight. A tree that has scanned as many nodes as a limit allows is cut: its dual progress
//! stays, the tree goes. The limit grows from round to round, so that trees around all roots grow
//! more or less in step. Where many roots would scan much of the graph each, a forest grows from
//! all of them.

mod expand;
mod family;
mod finish;
mod forest;
mod found;
mod join;
mod rounds;
mod search;
mod shrink;
mod split;
mod together;

pub(super) use finish::Outcome;
pub(super) use join::Grown;
pub(super) use search::Trees;
