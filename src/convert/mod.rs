//! The front door: from triangles to quads, checked, counted and timed.
//!
//! Uses all rooms of the chain; nothing uses it.

mod converted;
mod converter;
mod error;
mod progress;
mod report;

pub use converted::{Converted, Quadrangulated};
pub use converter::Converter;
pub use error::ConvertError;
pub use progress::{Progress, Stage};
pub use report::Report;
