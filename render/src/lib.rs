//! Pictures of meshes, drawn on the CPU. The same mesh and settings give the same bytes on every
//! machine.
//!
//! Faces go through a depth buffer of several samples a pixel. Lines are drawn above them where
//! they are not hidden. Hollows are darkened by the depths around them. Only `+ - * /` and the
//! square root act on coordinates.
//!
//! ```
//! use triquad_render::{Camera, Picture, Polygons};
//!
//! let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//! let mesh = Polygons::uniform(&positions, &[0, 1, 2], 3);
//! let camera = Camera { direction: [0.0, 0.0, 1.0], ..Camera::default() };
//! let image = Picture { camera, width: 60, height: 40, ..Picture::new(mesh) }.draw()?;
//! assert_eq!((image.width(), image.height()), (60, 40));
//! # Ok::<(), triquad_render::PictureError>(())
//! ```

mod camera;
mod canvas;
mod draw;
mod edges;
mod error;
mod faces;
mod image;
mod light;
mod occlusion;
mod palette;
mod polygons;
mod request;
mod resolve;
mod section;
mod vector;

pub use camera::Camera;
pub use error::PictureError;
pub use image::Image;
pub use polygons::Polygons;
pub use request::{Lines, Picture};
pub use section::Section;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
