//! From samples to pixels: means of light, and less of it in hollows.

use super::canvas::Canvas;
use super::image::Image;
use super::light::{decode, encode};
use super::occlusion::occlusion;

/// Ink of the edges goes from 0 to this, that of highlighted edges on from there to twice as much.
pub const FULL_INK: u8 = 127;

/// Settings that turn samples into pixels.
#[derive(Debug)]
pub struct Finish {
    /// Samples along each side of a pixel.
    pub samples: usize,
    /// Behind everything; None is transparent.
    pub background: Option<[u8; 3]>,
    /// Colours of edges and highlighted edges.
    pub inks: [[u8; 3]; 2],
    /// Darkening of hollows, 0 to 1.
    pub depth_shade: f64,
}

impl Finish {
    /// Makes each square of samples a pixel. O(samples).
    pub fn image(&self, canvas: &Canvas) -> Image {
        let (width, height) = (canvas.width / self.samples, canvas.height / self.samples);
        let light: [f64; 256] = std::array::from_fn(|value| decode(value as u8));
        let hollows = (self.depth_shade > 0.0).then(|| {
            let near = pixel_nearness(canvas, self.samples);
            occlusion(&near, [width, height])
        });
        let pixel = |at: usize| {
            let shade = hollows.as_ref().map_or(0.0, |hollows| f64::from(hollows[at]));
            self.pixel(canvas, &light, [at % width, at / width], 1.0 - self.depth_shade * shade)
        };
        Image::new(width, (0..width * height).map(pixel).collect())
    }

    fn pixel(
        &self,
        canvas: &Canvas,
        light: &[f64; 256],
        [x, y]: [usize; 2],
        brightness: f64,
    ) -> [u8; 4] {
        let (mut sum, mut opacity) = ([0.0; 3], 0.0);
        for sample in square(canvas.width, [x, y], self.samples) {
            let face = if canvas.near[sample] > f32::NEG_INFINITY { 1.0 } else { 0.0 };
            let (ink, share) = self.ink(canvas.ink[sample]);
            for i in 0..3 {
                let below = face * brightness * light[usize::from(canvas.colour[sample][i])];
                sum[i] += below + share * (light[usize::from(ink[i])] - below);
            }
            opacity += face + share * (1.0 - face);
        }
        let all = (self.samples * self.samples) as f64;
        if let Some(behind) = self.background {
            let colour = [0, 1, 2]
                .map(|i| encode((sum[i] + (all - opacity) * light[usize::from(behind[i])]) / all));
            return [colour[0], colour[1], colour[2], 255];
        }
        if opacity == 0.0 {
            return [0; 4];
        }
        let colour = sum.map(|part| encode(part / opacity));
        [colour[0], colour[1], colour[2], (255.0 * opacity / all).round() as u8]
    }

    /// Returns colour and opacity of a stored strength.
    fn ink(&self, strength: u8) -> ([u8; 3], f64) {
        let highlight = strength > FULL_INK;
        let above = if highlight { strength - FULL_INK } else { strength };
        (self.inks[usize::from(highlight)], f64::from(above.min(FULL_INK)) / f64::from(FULL_INK))
    }
}

/// Iterates over the samples of a pixel.
fn square(width: usize, [x, y]: [usize; 2], samples: usize) -> impl Iterator<Item = usize> {
    let first = y * samples * width + x * samples;
    (0..samples).flat_map(move |row| {
        let start = first + row * width;
        start..start + samples
    })
}

/// Returns the mean nearness of the faces seen in each pixel, in pixels; minus infinity where there
/// is none.
fn pixel_nearness(canvas: &Canvas, samples: usize) -> Vec<f32> {
    let (width, height) = (canvas.width / samples, canvas.height / samples);
    let mean = |at: usize| {
        let (mut sum, mut count) = (0.0, 0.0);
        for sample in square(canvas.width, [at % width, at / width], samples) {
            if canvas.near[sample] > f32::NEG_INFINITY {
                sum += canvas.near[sample];
                count += 1.0;
            }
        }
        if count > 0.0 { sum / count / samples as f32 } else { f32::NEG_INFINITY }
    };
    (0..width * height).map(mean).collect()
}
