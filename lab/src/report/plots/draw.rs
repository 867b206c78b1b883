//! From a chart to a drawing: title, axes, points, bars, and names beside what they name.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::axis::{Axis, Spread};
use super::canvas::{Canvas, Drawn, GRID, INK, PAPER, colour};
use super::chart::{Bar, Chart, Point, Series};
use crate::algorithms::{BLUE, GREY, Look, Mark, ORANGE};
use crate::meshes::Origin;
use crate::report::power_law::PowerLaw;

/// Units from side to side.
pub const WIDTH: u32 = 640;

/// Units of a row.
const ROW: u32 = 21;

/// Units of a line of notes.
const NOTE: u32 = 18;

/// Sizes of text, in units.
const TITLE: i32 = 18;
const TEXT: i32 = 16;
const SMALL: i32 = 14;

/// Units above the axes: title, then names of what the plot shows or of its side.
const HEAD: u32 = 62;

/// Units between the axes and the notes.
const FOOT: u32 = 54;

/// Positions of values on the canvas.
type Places<'a, DB> = ChartContext<'a, DB, Cartesian2d<Axis, Axis>>;

/// Units from top to bottom.
pub fn height(chart: &Chart) -> u32 {
    let inside = if chart.rows.is_empty() { 300 } else { ROW * chart.rows.len() as u32 };
    HEAD + inside + FOOT + NOTE * chart.notes.len() as u32 + 6
}

/// Draws a chart on a canvas of [`WIDTH`] × [`height`] units of `scale` pixels.
pub fn draw<DB: DrawingBackend>(
    chart: &Chart,
    area: &DrawingArea<DB, Shift>,
    scale: i32,
) -> Drawn<DB> {
    let canvas = Canvas { area, scale };
    area.fill(&PAPER)?;
    canvas.text(&chart.title, (8 * scale, 15 * scale), TITLE, HPos::Left)?;
    let places = axes(chart, &canvas)?;
    if let Some((at, sides)) = chart.line {
        draw_line(&canvas, &places, at, sides)?;
    }
    for bar in &chart.bars {
        draw_bar(&canvas, &places, bar)?;
    }
    if chart.y_spread == Spread::Rows {
        draw_key(&canvas, chart)?;
    } else {
        draw_names(&canvas, &places, chart)?;
    }
    for series in &chart.series {
        draw_series(&canvas, &places, series)?;
    }
    let bottom = height(chart) as i32 - 6;
    for (i, note) in chart.notes.iter().rev().enumerate() {
        let y = bottom - (NOTE as i32) * i as i32 - NOTE as i32 / 2;
        canvas.text(note, (10 * scale, y * scale), SMALL, HPos::Left)?;
    }
    Ok(())
}

/// Draws axes and grid.
fn axes<'a, DB: DrawingBackend>(
    chart: &Chart,
    canvas: &Canvas<'a, DB>,
) -> Result<Places<'a, DB>, DrawingAreaErrorKind<DB::ErrorType>> {
    let (units, rows) = (canvas.scale as u32, !chart.rows.is_empty());
    let right = if !chart.bars.is_empty() {
        84
    } else if rows {
        20
    } else {
        132
    };
    let names = chart.rows.iter().map(|name| canvas.width(name, TEXT)).max().unwrap_or(0) as u32;
    let (x, y) = chart.axes();
    let mut places = ChartBuilder::on(canvas.area)
        .margin_top(HEAD * units)
        .margin_bottom((6 + NOTE * chart.notes.len() as u32) * units)
        .margin_left(8 * units)
        .margin_right(right * units)
        .x_label_area_size(FOOT * units)
        .y_label_area_size(if rows { names + 14 * units } else { 58 * units })
        .build_cartesian_2d(x, y)?;
    let mut mesh = places.configure_mesh();
    if !chart.bars.is_empty() {
        mesh.disable_y_mesh();
    }
    mesh.set_tick_mark_size(LabelAreaPosition::Bottom, 8 * units)
        .set_tick_mark_size(LabelAreaPosition::Left, 6 * units)
        .light_line_style(TRANSPARENT)
        .bold_line_style(ShapeStyle { color: GRID.to_rgba(), filled: false, stroke_width: units })
        .axis_style(ShapeStyle { color: INK.to_rgba(), filled: false, stroke_width: units })
        .label_style(canvas.style(if rows { TEXT - 1 } else { TEXT }))
        .axis_desc_style(canvas.style(TEXT))
        .x_labels(40)
        .y_labels(400)
        .x_desc(chart.x_name.as_str())
        .draw()?;
    if !chart.y_name.is_empty() {
        let at = (8 * canvas.scale, (HEAD as i32 - 18) * canvas.scale);
        canvas.text(&chart.y_name, at, TEXT, HPos::Left)?;
    }
    Ok(places)
}

/// Returns the pixel of a point, if the axes have a place for it.
fn pixel<DB: DrawingBackend>(places: &Places<DB>, x: f64, y: f64) -> Option<(i32, i32)> {
    let axes = places.as_coord_spec();
    let place = (axes.x_spec().place(x)?, axes.y_spec().place(y)?);
    Some(places.backend_coord(&place))
}

/// Draws the line at a value of x, with what lies on either side of it.
fn draw_line<DB: DrawingBackend>(
    canvas: &Canvas<DB>,
    places: &Places<DB>,
    at: f64,
    sides: [&str; 2],
) -> Drawn<DB> {
    let (low, high) = places.as_coord_spec().y_spec().bounds();
    let Some(x) = places.as_coord_spec().x_spec().place(at) else { return Ok(()) };
    let ends = [low, high].map(|y| places.backend_coord(&(x, y)));
    canvas.line(ends.into(), INK, 20)?;
    let (x, y, gap) = (ends[1].0, ends[1].1 - 9 * canvas.scale, 8 * canvas.scale);
    canvas.text(sides[0], (x - gap, y), SMALL, HPos::Right)?;
    canvas.text(sides[1], (x + gap, y), SMALL, HPos::Left)
}

/// Draws the two parts of a bar, the paper's total, and to the right its text.
fn draw_bar<DB: DrawingBackend>(canvas: &Canvas<DB>, places: &Places<DB>, bar: &Bar) -> Drawn<DB> {
    let (low, _) = places.as_coord_spec().x_spec().bounds();
    let origin = places.backend_coord(&(low, -(bar.row as f64)));
    let half = (ROW as i32 - 5) * canvas.scale / 2;
    let mut end = origin.0;
    let ends = bar.parts.map(|parts| parts.map(|part| pixel(places, part, bar.row as f64)));
    for (place, paint) in ends.into_iter().flatten().zip([BLUE, ORANGE]) {
        let Some((x, y)) = place else { continue };
        canvas.bar([(end, y - half), (x, y + half)], colour(paint))?;
        end = x.max(end);
    }
    if bar.origin == Some(Origin::StandIn) {
        for x in (origin.0..end).step_by(7 * canvas.scale as usize).skip(1) {
            canvas.line(vec![(x, origin.1 - half), (x, origin.1 + half)], PAPER, 10)?;
        }
    }
    let look = Look { colour: GREY, mark: Mark::Down };
    if let Some(at) = bar.paper.and_then(|paper| pixel(places, paper, bar.row as f64)) {
        canvas.mark(at, look, true)?;
    }
    // In a column of their own, totals are not taken for the paper's; outcomes need more room.
    let right = places.plotting_area().get_pixel_range().0.end;
    let start = if bar.parts.is_some() { right } else { origin.0 };
    canvas.text(&bar.text, (start + 8 * canvas.scale, origin.1), SMALL, HPos::Left)
}

/// Draws points, their ranges, and the lines that join them.
fn draw_series<DB: DrawingBackend>(
    canvas: &Canvas<DB>,
    places: &Places<DB>,
    series: &Series,
) -> Drawn<DB> {
    let paint = colour(series.look.colour);
    let at = |point: &Point| pixel(places, point.x, point.y);
    if series.joined {
        canvas.line(series.points.iter().filter_map(at).collect(), paint, 16)?;
    }
    for point in &series.points {
        let Some((x, y)) = at(point) else { continue };
        let range = point.range.map(|(low, high)| [low, high].map(|y| pixel(places, point.x, y)));
        if let Some([Some(low), Some(high)]) = range {
            canvas.line(vec![low, high], paint, 14)?;
        }
        canvas.mark((x, y), series.look, point.origin == Some(Origin::StandIn))?;
        if point.extrapolated {
            canvas.text("*", (x + 7 * canvas.scale, y - 3 * canvas.scale), TEXT, HPos::Left)?;
        }
    }
    Ok(())
}

/// Writes the names of series, and of the parts of bars, in a row above the axes.
fn draw_key<DB: DrawingBackend>(canvas: &Canvas<DB>, chart: &Chart) -> Drawn<DB> {
    let (left, mut y) = (14 * canvas.scale, 36 * canvas.scale);
    let mut x = left;
    for series in &chart.series {
        let end = x + 10 * canvas.scale + canvas.width(&series.name, TEXT);
        if end > WIDTH as i32 * canvas.scale {
            (x, y) = (left, y + 17 * canvas.scale);
        }
        canvas.mark((x, y), series.look, false)?;
        canvas.text(&series.name, (x + 10 * canvas.scale, y), TEXT, HPos::Left)?;
        x += canvas.width(&series.name, TEXT) + 32 * canvas.scale;
    }
    if chart.bars.is_empty() {
        return Ok(());
    }
    let column = ((WIDTH as i32 - 76) * canvas.scale, (HEAD as i32 - 9) * canvas.scale);
    canvas.text("total", column, SMALL, HPos::Left)?;
    let half = 6 * canvas.scale;
    for (paint, name) in [(BLUE, "(a) initial pairing"), (ORANGE, "(d) augmentation")] {
        canvas.bar([(x - half, y - half), (x + half, y + half)], colour(paint))?;
        canvas.text(name, (x + 10 * canvas.scale, y), TEXT, HPos::Left)?;
        x += canvas.width(name, TEXT) + 34 * canvas.scale;
    }
    if chart.bars.iter().any(|bar| bar.paper.is_some()) {
        canvas.mark((x, y), Look { colour: GREY, mark: Mark::Down }, true)?;
        canvas.text("total in the paper", (x + 10 * canvas.scale, y), TEXT, HPos::Left)?;
    }
    Ok(())
}

/// Writes the name of each series, with its exponent, to the right of its last point.
fn draw_names<DB: DrawingBackend>(
    canvas: &Canvas<DB>,
    places: &Places<DB>,
    chart: &Chart,
) -> Drawn<DB> {
    let last = |series: &Series| {
        let places = series.points.iter().filter_map(|point| pixel(places, point.x, point.y));
        places.max_by_key(|place| place.0)
    };
    let mut ends: Vec<_> =
        chart.series.iter().filter_map(|series| Some((last(series)?, series))).collect();
    ends.sort_by_key(|((x, y), _)| (*y, *x));
    let (xs, ys) = places.plotting_area().get_pixel_range();
    let tall = |series: &Series| (if series.fit.is_some() { 36 } else { 20 }) * canvas.scale;
    let below: i32 = ends.iter().map(|(_, series)| tall(series)).sum();
    let (mut free, mut rest) = (ys.start, below);
    for ((x, y), series) in ends {
        let top = (y - 9 * canvas.scale).min(ys.end + 8 * canvas.scale - rest).max(free);
        (free, rest) = (top + tall(series), rest - tall(series));
        let at = (xs.end + 18 * canvas.scale, top + 9 * canvas.scale);
        canvas.line(vec![(x, y), (at.0 - 8 * canvas.scale, at.1)], GRID, 10)?;
        canvas.mark(at, series.look, false)?;
        canvas.text(&series.name, (at.0 + 10 * canvas.scale, at.1), TEXT, HPos::Left)?;
        if let Some(fit) = series.fit {
            let at = (at.0 + 10 * canvas.scale, at.1 + 16 * canvas.scale);
            canvas.text(&exponent(fit), at, SMALL, HPos::Left)?;
        }
    }
    Ok(())
}

/// Writes an exponent with half the length of its interval.
fn exponent(fit: PowerLaw) -> String {
    match fit.interval {
        Some((low, high)) => format!("n^{:.2} ± {:.2}", fit.exponent, (high - low) / 2.0),
        None => format!("n^{:.2}", fit.exponent),
    }
}
