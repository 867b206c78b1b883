//! Images as text: two pixels a character, the upper in the foreground of `▀`.

use std::io::{self, IsTerminal};

use anstyle::{Ansi256Color, Color, RgbColor, Style};
use terminal_size::{Height, Width, terminal_size};
use triquad_render::Image;

use super::xterm;

/// Colours that the text may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Palette {
    /// 24 bits.
    True,
    /// The 256 colours of xterm.
    Indexed,
    /// None, and no escape codes.
    Plain,
}

/// Columns and lines where there is no terminal.
const USUAL: (usize, usize) = (80, 24);

/// The most columns and lines that are filled.
const MOST: usize = 1000;

/// From no light to full light.
const SHADES: [char; 5] = [' ', '░', '▒', '▓', '█'];

impl Palette {
    /// Returns what standard output can show and the environment allows.
    pub fn of_standard_output() -> Self {
        let forced = anstyle_query::clicolor_force();
        let allowed = !anstyle_query::no_color() && anstyle_query::clicolor() != Some(false);
        let capable = io::stdout().is_terminal() && anstyle_query::term_supports_ansi_color();
        match () {
            () if !(forced || allowed && capable) => Self::Plain,
            () if anstyle_query::truecolor() => Self::True,
            () => Self::Indexed,
        }
    }

    fn colour(self, pixel: [u8; 4]) -> Option<Color> {
        let [red, green, blue, opacity] = pixel;
        match self {
            _ if opacity < 128 => None,
            Self::True => Some(RgbColor(red, green, blue).into()),
            Self::Indexed => Some(Ansi256Color(xterm::nearest([red, green, blue])).into()),
            Self::Plain => None,
        }
    }
}

/// Returns the width and height of the picture that fills the window but for the line of the
/// prompt.
pub fn size_in_pixels() -> [usize; 2] {
    let window =
        terminal_size().map(|(Width(columns), Height(lines))| (columns.into(), lines.into()));
    let named = |name: &str| std::env::var(name).ok()?.parse().ok();
    let (columns, lines) =
        window.unwrap_or((named("COLUMNS").unwrap_or(USUAL.0), named("LINES").unwrap_or(USUAL.1)));
    [columns.clamp(2, MOST), 2 * lines.saturating_sub(1).clamp(1, MOST)]
}

/// Returns the image as lines of text, without those that would be empty above and below.
pub fn text(image: &Image, palette: Palette) -> String {
    let nothing = [[0; 4]];
    let row = |y: usize| {
        let pixels = image.pixels().get(y * image.width()..(y + 1) * image.width());
        pixels.unwrap_or(&nothing).iter().copied()
    };
    let line = |y: usize| {
        let lower = row(y + 1).chain(std::iter::repeat([0; 4]));
        let pairs: Vec<_> = row(y).zip(lower).collect();
        if palette == Palette::Plain { shaded(&pairs) } else { coloured(&pairs, palette) }
    };
    let lines: Vec<String> = (0..image.height()).step_by(2).map(line).collect();
    let is_full = |line: &String| !line.is_empty();
    let first = lines.iter().position(is_full).unwrap_or(0);
    let end = lines.iter().rposition(is_full).map_or(0, |last| last + 1);
    lines[first..end].join("\n")
}

/// Sets colours only where they change.
fn coloured(pairs: &[([u8; 4], [u8; 4])], palette: Palette) -> String {
    let mut line = String::new();
    let mut now = Style::new();
    for &(upper, lower) in pairs {
        let (character, style) = match (palette.colour(upper), palette.colour(lower)) {
            (None, None) => (' ', Style::new()),
            (None, lower) => ('▄', Style::new().fg_color(lower)),
            (upper, lower) => ('▀', Style::new().fg_color(upper).bg_color(lower)),
        };
        if style != now {
            line += &format!("{now:#}{style}");
            now = style;
        }
        line.push(character);
    }
    // Spaces after the last change stay invisible.
    let end = if now == Style::new() { line.trim_end_matches(' ').len() } else { line.len() };
    line.truncate(end);
    line + &format!("{now:#}")
}

fn shaded(pairs: &[([u8; 4], [u8; 4])]) -> String {
    let light = |[red, green, blue, opacity]: [u8; 4]| {
        let luma = 299 * u32::from(red) + 587 * u32::from(green) + 114 * u32::from(blue);
        luma * u32::from(opacity)
    };
    let full = 2 * 255 * 255 * 1000;
    let shade = |&(upper, lower): &([u8; 4], [u8; 4])| {
        let share = (light(upper) + light(lower)) * SHADES.len() as u32 / full;
        SHADES[(share as usize).min(SHADES.len() - 1)]
    };
    pairs.iter().map(shade).collect::<String>().trim_end_matches(' ').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: [u8; 4] = [255, 0, 0, 255];
    const WHITE: [u8; 4] = [255; 4];
    const CLEAR: [u8; 4] = [0; 4];

    #[test]
    fn two_pixels_make_a_half_block_in_their_colours() {
        let image =
            Image::new(4, [[RED, CLEAR, WHITE, CLEAR], [WHITE, RED, CLEAR, CLEAR]].concat());
        let expected = "\u{1b}[38;2;255;0;0m\u{1b}[48;2;255;255;255m▀\u{1b}[0m\u{1b}[38;2;255;0;0m▄\
                        \u{1b}[0m\u{1b}[38;2;255;255;255m▀\u{1b}[0m";
        assert_eq!(text(&image, Palette::True), expected);
        let indexed = "\u{1b}[38;5;196m\u{1b}[48;5;231m▀\u{1b}[0m\u{1b}[38;5;196m▄\
                       \u{1b}[0m\u{1b}[38;5;231m▀\u{1b}[0m";
        assert_eq!(text(&image, Palette::Indexed), indexed);
    }

    #[test]
    fn without_colours_light_becomes_a_shade() {
        let grey = |value| [value, value, value, 255];
        let upper = [grey(255), grey(160), grey(110), grey(60), CLEAR, CLEAR];
        let image = Image::new(6, [upper, upper].concat());
        assert_eq!(text(&image, Palette::Plain), "█▓▒░");
    }

    #[test]
    fn empty_lines_above_and_below_are_left_out_and_an_odd_row_is_drawn() {
        let rows = [[CLEAR; 2], [CLEAR; 2], [WHITE; 2], [WHITE; 2], [CLEAR; 2], [CLEAR; 2]];
        let image = Image::new(2, rows.concat());
        assert_eq!(text(&image, Palette::Plain), "██");
        let odd = Image::new(2, vec![WHITE; 6]);
        assert_eq!(text(&odd, Palette::Plain), "██\n▒▒");
        assert_eq!(text(&Image::new(1, vec![CLEAR]), Palette::True), "");
    }
}
