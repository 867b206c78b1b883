//! A canvas of pixels on which charts are drawn, by any backend of `plotters` and at any scale.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::algorithms::{Look, Mark};

/// The family of all text: the font that is part of the program, then what a browser may have.
pub const FAMILY: &str = "DejaVu Sans, Verdana, Arial, sans-serif";

/// Colour of text and axes.
pub const INK: RGBColor = RGBColor(34, 34, 34);
/// Colour of grid lines.
pub const GRID: RGBColor = RGBColor(221, 221, 221);
/// Colour of the canvas.
pub const PAPER: RGBColor = RGBColor(255, 255, 255);

/// Result of drawing.
pub type Drawn<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

/// A canvas; lengths and sizes of text are in units of `scale` pixels, positions in pixels.
pub struct Canvas<'a, DB: DrawingBackend> {
    /// Its pixels.
    pub area: &'a DrawingArea<DB, Shift>,
    /// Pixels in a unit.
    pub scale: i32,
}

/// Converts a colour of the palette.
pub fn colour([red, green, blue]: [u8; 3]) -> RGBColor {
    RGBColor(red, green, blue)
}

impl<DB: DrawingBackend> Canvas<'_, DB> {
    /// Writes `text` beside a place: `left`, `middle` or `right` of the text is there.
    pub fn text(&self, text: &str, at: (i32, i32), size: i32, side: HPos) -> Drawn<DB> {
        let style = self.style(size).pos(Pos::new(side, VPos::Center));
        self.area.draw(&Text::new(text, at, style))
    }

    /// Returns the style of text of that size.
    pub fn style(&self, size: i32) -> TextStyle<'static> {
        (FAMILY, size * self.scale).into_font().color(&INK)
    }

    /// Returns the width of a text in pixels.
    pub fn width(&self, text: &str, size: i32) -> i32 {
        let found = self.area.estimate_text_size(text, &self.style(size));
        found.map_or(0, |(width, _)| width as i32)
    }

    /// Draws a line through places, `width` tenths of a unit wide.
    pub fn line(&self, places: Vec<(i32, i32)>, paint: RGBColor, width: i32) -> Drawn<DB> {
        let stroke_width = (width * self.scale / 10).max(1) as u32;
        let style = ShapeStyle { color: paint.to_rgba(), filled: false, stroke_width };
        self.area.draw(&PathElement::new(places, style))
    }

    /// Draws a filled rectangle.
    pub fn bar(&self, corners: [(i32, i32); 2], paint: RGBColor) -> Drawn<DB> {
        self.area.draw(&Rectangle::new(corners, paint.filled()))
    }

    /// Draws a mark around a place; `hollow` for what is not the paper's own mesh.
    pub fn mark(&self, (x, y): (i32, i32), look: Look, hollow: bool) -> Drawn<DB> {
        let paint = colour(look.colour);
        let radius = 5 * self.scale;
        if look.mark == Mark::Circle {
            let fill = if hollow { PAPER } else { paint };
            self.area.draw(&Circle::new((x, y), radius, fill.filled()))?;
            let stroke_width = (2 * self.scale) as u32;
            let rim = ShapeStyle { color: paint.to_rgba(), filled: false, stroke_width };
            return self.area.draw(&Circle::new((x, y), radius, rim));
        }
        let place = |&(dx, dy): &(i32, i32)| (x + dx * radius / 10, y + dy * radius / 10);
        if look.mark == Mark::Cross {
            let reach = if hollow { 7 } else { 10 };
            for stroke in [[(-reach, -reach), (reach, reach)], [(-reach, reach), (reach, -reach)]] {
                let width = if hollow { 12 } else { 28 };
                self.line(stroke.iter().map(place).collect(), paint, width)?;
            }
            return Ok(());
        }
        let mut outline: Vec<_> = outline(look.mark).iter().map(place).collect();
        let fill = if hollow { PAPER } else { paint };
        self.area.draw(&Polygon::new(outline.clone(), fill.filled()))?;
        outline.push(outline[0]);
        self.line(outline, paint, 16)
    }
}

/// Corners of a mark, in tenths of its radius.
fn outline(mark: Mark) -> &'static [(i32, i32)] {
    match mark {
        Mark::Square => &[(-9, -9), (9, -9), (9, 9), (-9, 9)],
        Mark::Up => &[(0, -11), (11, 9), (-11, 9)],
        Mark::Down => &[(0, 11), (11, -9), (-11, -9)],
        Mark::Circle | Mark::Diamond | Mark::Cross => &[(0, -12), (12, 0), (0, 12), (-12, 0)],
    }
}
