//! Draws a mesh file: `cargo run --release --example render -- IN.obj OUT.png`.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use triquad::Mesh;
use triquad_render::{Camera, Lines, Picture, Polygons, Section};

/// Draws a mesh file as PNG.
#[derive(Parser)]
struct Options {
    /// Mesh to draw
    input: PathBuf,
    /// Image to write
    output: PathBuf,
    /// Width and height in pixels
    #[arg(long, num_args = 2, value_names = ["W", "H"], default_values_t = [1600, 1200])]
    size: Vec<usize>,
    /// Direction from the mesh to the eye
    #[arg(long, num_args = 3, allow_negative_numbers = true, default_values_t = Camera::default().direction)]
    from: Vec<f64>,
    /// What is up
    #[arg(long, num_args = 3, allow_negative_numbers = true, default_values_t = Camera::default().up)]
    up: Vec<f64>,
    /// Look from infinity
    #[arg(long)]
    parallel: bool,
    /// Point in the middle of the image
    #[arg(long, num_args = 3, allow_negative_numbers = true)]
    target: Option<Vec<f64>>,
    /// Enlargement; at 1 the whole mesh fits
    #[arg(long, default_value_t = 1.0)]
    zoom: f64,
    /// Take away what lies beyond a plane: a point of it and its normal
    #[arg(long, num_args = 6, allow_negative_numbers = true)]
    section: Option<Vec<f64>>,
    /// Draw faces only
    #[arg(long)]
    no_edges: bool,
    /// Leave the background transparent
    #[arg(long)]
    transparent: bool,
}

fn main() -> ExitCode {
    match draw(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("render: {error}");
            ExitCode::from(2)
        }
    }
}

fn draw(options: &Options) -> Result<(), Box<dyn std::error::Error>> {
    let mesh = Mesh::read(&options.input)?;
    let image = Picture {
        width: options.size[0],
        height: options.size[1],
        camera: options.camera(),
        section: options
            .section
            .as_deref()
            .map(|numbers| Section { point: three(&numbers[..3]), normal: three(&numbers[3..]) }),
        background: if options.transparent { None } else { Some([255; 3]) },
        lines: Lines { edges: !options.no_edges, ..Lines::default() },
        ..Picture::new(polygons(&mesh))
    };
    image.draw()?.write_png(std::fs::File::create(&options.output)?)?;
    Ok(())
}

impl Options {
    fn camera(&self) -> Camera {
        let usual = Camera::default();
        Camera {
            direction: three(&self.from),
            up: three(&self.up),
            distance: if self.parallel { None } else { usual.distance },
            target: self.target.as_deref().map(three),
            zoom: self.zoom,
            ..usual
        }
    }
}

fn three(numbers: &[f64]) -> [f64; 3] {
    [numbers[0], numbers[1], numbers[2]]
}

fn polygons(list: &Mesh) -> Polygons<'_> {
    let corners = list.faces().corners();
    match (list.faces().arity(), list.faces().ends()) {
        (_, Some(ends)) => Polygons::mixed(list.positions(), corners, ends),
        (arity, None) => Polygons::uniform(list.positions(), corners, arity.unwrap_or(3)),
    }
}
