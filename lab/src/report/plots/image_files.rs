//! From a chart to the bytes of its files.

use plotters::prelude::*;
use plotters::style::register_font;

use super::canvas::FAMILY;
use super::chart::Chart;
use super::draw::{WIDTH, draw, height};
use triquad_render::Image;

/// Pixels of a unit in an SVG file: its coordinates are whole numbers.
const SVG_SCALE: u32 = 2;

/// Pixels of a unit in a PNG file, and samples along a side of a pixel.
const PNG_SCALE: u32 = 2;
const SAMPLES: u32 = 2;

/// DejaVu Sans with the characters that plots need; `font/LICENSE` is its licence.
const FONT: &[u8] = include_bytes!("font/DejaVuSans-subset.ttf");

/// Makes the font known, which may be done again and again.
fn make_font_known() {
    let known = register_font(FAMILY, FontStyle::Normal, FONT);
    assert!(known.is_ok(), "the font is a font");
}

/// Draws the chart as SVG: no script, no style sheet, nothing from elsewhere.
pub fn svg(chart: &Chart) -> String {
    make_font_known();
    let mut text = String::new();
    let size = (WIDTH * SVG_SCALE, height(chart) * SVG_SCALE);
    let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
    draw(chart, &area, SVG_SCALE as i32).expect("memory takes everything");
    area.present().expect("memory takes everything");
    drop(area);
    text
}

/// Draws the chart as PNG. O(pixels).
pub fn png(chart: &Chart) -> Vec<u8> {
    make_font_known();
    let scale = PNG_SCALE * SAMPLES;
    let (width, height) = (WIDTH * scale, height(chart) * scale);
    let mut samples = vec![0; (width * height * 3) as usize];
    let area = BitMapBackend::with_buffer(&mut samples, (width, height)).into_drawing_area();
    draw(chart, &area, scale as i32).expect("memory takes everything");
    area.present().expect("memory takes everything");
    drop(area);
    halved(&samples, width as usize).small_png()
}

/// Returns an image whose pixels are means of [`SAMPLES`]² samples.
fn halved(samples: &[u8], width: usize) -> Image {
    let along = SAMPLES as usize;
    let (columns, rows) = (width / along, samples.len() / 3 / width / along);
    let pixel = |at: usize| {
        let first = at / columns * along * width + at % columns * along;
        let square = (0..along * along).map(|i| first + i / along * width + i % along);
        let mean = |c: usize| {
            let sum: u32 = square.clone().map(|at| u32::from(samples[3 * at + c])).sum();
            (sum / (SAMPLES * SAMPLES)) as u8
        };
        [mean(0), mean(1), mean(2), 255]
    };
    Image::new(columns, (0..columns * rows).map(pixel).collect())
}
