//! The front door: from triangles to quads, checked, counted and timed.
//!
//! Uses all rooms of the chain; nothing uses it.

mod aims;
mod closed;
mod converted;
mod converter;
mod error;
mod mixed;
mod progress;
mod report;

pub use aims::Aims;
pub use converted::{Converted, Quadrangulated};
pub use converter::Converter;
pub use error::ConvertError;
pub use progress::{Progress, Stage};
pub use report::Report;
