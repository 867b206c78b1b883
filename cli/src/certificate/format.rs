//! What reading and writing have in common.

pub(super) const FIRST_LINE: &str = "triquad-certificate 1";
