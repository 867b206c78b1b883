//! Reason why there is no picture.

/// Reason why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The mesh has no face.
    #[error("the mesh has no face to draw")]
    NoFaces,
    /// A size is zero, or there would be more than 2^28 samples.
    #[error("no image of {width} x {height} pixels of {samples} x {samples} samples can be drawn")]
    Size {
        /// Pixels in a row.
        width: usize,
        /// Rows.
        height: usize,
        /// Samples along a side of a pixel.
        samples: usize,
    },
    /// A face or highlighted edge has a vertex that does not exist.
    #[error("there is no vertex {0} (counted from 0)")]
    Vertex(u32),
    /// A coordinate of a vertex used is NaN or infinite.
    #[error("vertex {0} (counted from 0) has a coordinate that is not finite")]
    NotFinite(u32),
    /// The camera cannot look like that.
    #[error("camera: {0}")]
    Camera(&'static str),
    /// The plane of the section has no direction, or something is not finite.
    #[error("the plane of the section is not defined")]
    Section,
    /// Line widths and shares have to be finite and not negative.
    #[error("a width, opacity or shade is negative or not finite")]
    Style,
    /// Not one colour for each face.
    #[error("the number of colours is {colours}, that of faces {faces}")]
    Colours {
        /// Number of colours.
        colours: usize,
        /// Number of faces.
        faces: usize,
    },
}
