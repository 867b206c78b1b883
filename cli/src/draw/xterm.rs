//! The 256 colours of xterm: the one of most alike hue and light.
//!
//! The cube has six levels a channel. What is nearest to a pale blue by distance alone is lavender
//! or green, and hues have a meaning here.

use std::sync::LazyLock;

/// Levels of each channel in the cube of 6 x 6 x 6 colours. It begins at 16, greys after it at 232.
const LEVELS: [u8; 6] = [0, 95, 135, 175, 215, 255];

/// The first 16 colours are those that the user has chosen: unknown here.
const FIRST: u8 = 16;

static COLOURS: LazyLock<Vec<Seen>> =
    LazyLock::new(|| (FIRST..=u8::MAX).map(|number| Seen::from(channels(number))).collect());

/// Returns the number of the colour that looks most like `rgb`.
pub fn nearest(rgb: [u8; 3]) -> u8 {
    let seen = Seen::from(rgb);
    let distances = COLOURS.iter().map(|colour| seen.distance(colour));
    let best = (FIRST..=u8::MAX).zip(distances).min_by(|a, b| a.1.total_cmp(&b.1));
    best.map_or(FIRST, |(number, _)| number)
}

/// Returns red, green and blue of a colour from `FIRST` on.
fn channels(number: u8) -> [u8; 3] {
    if number >= 232 {
        return [8 + 10 * (number - 232); 3];
    }
    let place = number - FIRST;
    [place / 36, place / 6 % 6, place % 6].map(|level| LEVELS[usize::from(level)])
}

/// A colour as the eye takes it apart.
struct Seen {
    light: f64,
    red_green: f64,
    yellow_blue: f64,
}

impl From<[u8; 3]> for Seen {
    fn from(rgb: [u8; 3]) -> Self {
        let [red, green, blue] = rgb.map(f64::from);
        Self {
            light: 0.299 * red + 0.587 * green + 0.114 * blue,
            red_green: red - green,
            yellow_blue: (red + green) / 2.0 - blue,
        }
    }
}

impl Seen {
    /// How colourful it is. Square roots are the same on every machine, `hypot` is not.
    fn chroma(&self) -> f64 {
        (self.red_green * self.red_green + self.yellow_blue * self.yellow_blue).sqrt()
    }

    /// Returns how unlike two colours are. Another hue counts most, more or less of it least.
    fn distance(&self, other: &Self) -> f64 {
        let square = |x: f64| x * x;
        let chroma = square(self.chroma() - other.chroma());
        let across = square(self.red_green - other.red_green)
            + square(self.yellow_blue - other.yellow_blue)
            - chroma;
        square(self.light - other.light) + 0.5 * chroma + 4.0 * across
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_of_the_palette_are_themselves() {
        for number in FIRST..=u8::MAX {
            assert_eq!(nearest(channels(number)), number);
        }
    }

    #[test]
    fn pale_and_dark_blues_and_oranges_keep_their_hue_or_become_grey() {
        let shades = |[red, green, blue]: [u32; 3]| {
            let dim = move |share: u32| [red, green, blue].map(|c| (c * share / 100) as u8);
            (40..=100).map(move |share| channels(nearest(dim(share))))
        };
        // From light blue and from orange, each to a colour that is nearly grey.
        for share in 0..=10 {
            let pale = |from: [u32; 3]| {
                [0, 1, 2].map(|c| (from[c] * (10 - share) + [222, 228, 236][c] * share) / 10)
            };
            for [red, green, blue] in shades(pale([150, 196, 226])) {
                assert!(red < green && green < blue || red == green && green == blue);
            }
        }
        for [red, green, blue] in shades([250, 205, 110]).chain(shades([236, 112, 20])) {
            assert!(red > green && green > blue || red == green && green == blue);
        }
    }
}
