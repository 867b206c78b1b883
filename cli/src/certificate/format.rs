//! Parts that reading and writing share.

pub(super) const FIRST_LINE: &str = "triquad-certificate 1";
