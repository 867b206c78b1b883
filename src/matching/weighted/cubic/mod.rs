//! Nodes of at most three sides, each in one half of a cache line.

mod read;
mod row;
mod rows;
mod view;

pub(super) use rows::Rows;
pub(super) use view::Cubic;
