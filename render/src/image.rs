//! Pixels, and the file that they go to.

use std::io::{self, Write};

use super::palette;

/// An image; rows from top to bottom, pixels from left to right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    width: usize,
    height: usize,
    pixels: Vec<[u8; 4]>,
}

impl Image {
    /// Makes an image of pixels given row after row.
    ///
    /// # Panics
    /// If `width` is 0 or does not divide the number of pixels.
    pub fn new(width: usize, pixels: Vec<[u8; 4]>) -> Self {
        assert!(width > 0 && pixels.len().is_multiple_of(width));
        Self { width, height: pixels.len() / width, pixels }
    }

    /// Pixels in a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Returns the number of rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Returns red, green, blue and opacity of all pixels, row after row. Colour is not multiplied
    /// by opacity.
    pub fn pixels(&self) -> &[[u8; 4]] {
        &self.pixels
    }

    /// Returns the pixel `x` from the left and `y` from the top.
    ///
    /// # Panics
    /// If the image has no such pixel.
    pub fn pixel(&self, x: usize, y: usize) -> [u8; 4] {
        assert!(x < self.width, "column {x} of an image of width {}", self.width);
        self.pixels[y * self.width + x]
    }

    /// Writes the image to `out` as PNG with all colours and opacity.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_png(&self, out: impl Write) -> io::Result<()> {
        let mut encoder = png::Encoder::new(out, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgba);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        Ok(writer.finish()?)
    }

    /// Returns the image as a small PNG file: of at most 256 colours, as if all pixels were opaque.
    /// O(pixels).
    pub fn small_png(&self) -> Vec<u8> {
        let (colours, indices) = palette::reduce(&self.pixels);
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(colours.into_flattened());
        encoder.set_compression(png::Compression::High);
        encoder.set_filter(png::Filter::NoFilter);
        let mut writer = encoder.write_header().expect("a palette and a size that are not empty");
        writer.write_image_data(&indices).expect("an index for each pixel");
        writer.finish().expect("memory takes all bytes");
        bytes
    }
}
