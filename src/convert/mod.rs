//! The front door: from triangles to quads, checked, counted and timed.
//!
//! Uses all rooms of the chain; nothing uses it.
//!
//! # Examples
//!
//! Options are chained; the report has every count and time:
//!
//! ```
//! use triquad::quadrangulation::{Keep, ShapeCost};
//! use triquad::{Algorithm, Augmentation, Converter, Mesh};
//!
//! let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let mesh = Mesh::from_triangles(corners, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
//!
//! let best = Converter::new().cost(&ShapeCost).run(&mesh)?;
//! assert!(best.report().is_proved_least);
//! let greedy = Converter::new().algorithm(Algorithm::PulliSegal).seed(7);
//! assert_eq!(greedy.augmentation(Augmentation::Tarjan).run(&mesh)?.report().quads, 2);
//! let mut keep = Keep::default();
//! keep.sharp = Some(30.0);
//! let kept = Converter::new().keep(keep).run(&mesh)?;
//! assert_eq!(kept.report().given_up_edges, Some(2));
//! assert_eq!(kept.given_up().len(), 2);
//!
//! let dominant = Converter::new().quad_dominant(0).run(&mesh)?;
//! assert_eq!(dominant.report().leftover_triangles, Some(4));
//!
//! let open = Mesh::from_triangles(vec![[0.0; 3]; 3], vec![[0, 1, 2]]);
//! let open = Converter::new().open(true).run(&open)?;
//! assert_eq!(open.report().leftover_triangles, Some(1));
//! # Ok::<(), triquad::ConvertError>(())
//! ```
//!
//! The other options are switches, and have no examples of their own.

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
pub use report::{Report, Size};
