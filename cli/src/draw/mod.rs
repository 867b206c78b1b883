//! `triquad draw`.

mod scene;
mod terminal;
mod xterm;

use std::io;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use triquad::Mesh;
use triquad::atomic_file::AtomicFile;
use triquad_render::{Camera, Image, Lines, PictureError, Section};

use crate::failure::Failure;
use crate::formats::reads;
use crate::input::Reading;
use crate::progress::StatusLine;
use crate::{input, shell, stdio};
use scene::Scene;

/// Draw a mesh: to a PNG file, or here in the terminal
///
/// Without -o the picture is made of half-block characters and fills the window: in 24-bit colour
/// where COLORTERM is truecolor, else in 256 colours. With NO_COLOR set, or where standard output
/// is no terminal, it is plain shades of the characters ░▒▓█; CLICOLOR_FORCE=1 keeps the colours.
/// Any mesh can be drawn, also one that cannot be converted.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad draw quads.obj\n  \
                        triquad draw quads.obj -o quads.png --against bunny.obj\n  \
                        triquad draw part.stl -o part.png --up z --azimuth -60 --elevation 35")]
pub struct Arguments {
    #[arg(value_name = "IN", help = reads("The mesh"))]
    input: PathBuf,
    /// The picture, a .png file; '-' for standard output
    #[arg(short, long, value_name = "OUT.png")]
    output: Option<PathBuf>,
    /// Draw this mesh too, on the left and from the same side: the triangles that quads come from,
    /// or quads of another origin. May be given more than once, from left to right
    #[arg(long, value_name = "MESH")]
    against: Vec<PathBuf>,
    /// Meaning of colours: quality (of quads: light blue is square, yellow is askew, orange is
    /// nearly folded, red is folded) or none; back sides are grey
    #[arg(long, visible_alias = "color", default_value = "quality", value_name = "NAME")]
    colour: Colour,
    /// Edges: on or off; by default on in files and off in the terminal
    #[arg(long, value_name = "ON|OFF")]
    edges: Option<Switch>,
    /// Turn the eye round the mesh by so many degrees, to the right of the front
    #[arg(long, default_value_t = 25.0, value_name = "DEG", allow_negative_numbers = true)]
    azimuth: f64,
    /// Raise the eye above the horizon by so many degrees
    #[arg(long, default_value_t = 20.0, value_name = "DEG", allow_negative_numbers = true)]
    elevation: f64,
    /// The axis that points up: y (the front is towards z) or z (the front is against y)
    #[arg(long, default_value = "y", value_name = "AXIS")]
    up: Up,
    /// Enlarge; at 1 the whole mesh is seen
    #[arg(long, default_value_t = 1.0, value_name = "X", allow_negative_numbers = true)]
    zoom: f64,
    /// Cut away what lies beyond a plane: a point of it, and the direction to be cut away
    #[arg(long, num_args = 6, value_names = ["X", "Y", "Z", "DX", "DY", "DZ"])]
    #[arg(allow_negative_numbers = true)]
    section: Option<Vec<f64>>,
    /// Width and height in pixels of the file
    #[arg(long, num_args = 2, value_names = ["W", "H"], default_values_t = [1600, 1200])]
    size: Vec<usize>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Colour {
    Quality,
    None,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Switch {
    On,
    Off,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Up {
    Y,
    Z,
}

/// Reads, draws, and writes or shows.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let status = StatusLine::new("reading the mesh");
    let target = arguments.output.as_deref().map(Target::open).transpose()?;
    let paths = arguments.against.iter().chain([&arguments.input]);
    let meshes = paths.map(|path| Ok((path.as_path(), input::read(path, Reading::default())?)));
    let meshes: Vec<(&Path, Mesh)> = meshes.collect::<Result<_, Failure>>()?;
    status.say("drawing");
    let size = match &target {
        Some(_) => [arguments.size[0], arguments.size[1]],
        None => terminal::size_in_pixels(),
    };
    let image = arguments.draw(&meshes, size, target.is_some())?;
    drop(status);
    match target {
        Some(target) => target.write(&image),
        None => stdio::say(&terminal::text(&image, terminal::Palette::of_standard_output())),
    }
}

impl Arguments {
    /// Draws the meshes side by side into `size` pixels.
    fn draw(
        &self,
        meshes: &[(&Path, Mesh)],
        [width, height]: [usize; 2],
        to_file: bool,
    ) -> Result<Image, Failure> {
        let edges = self.edges.map_or(to_file, |edges| edges == Switch::On);
        let count = meshes.len();
        let scene = |place: usize| Scene {
            // All together have the whole width.
            width: (place + 1) * width / count - place * width / count,
            height,
            camera: self.camera(),
            lines: Lines { edges, ..Lines::default() },
            section: self.section.as_deref().map(section),
            by_quality: self.colour == Colour::Quality,
            background: to_file.then_some([255; 3]),
        };
        let draw = |(place, (path, mesh)): (usize, &(&Path, Mesh))| {
            scene(place).draw(mesh).map_err(|error| self.failure(path, &error))
        };
        let images: Vec<Image> = meshes.iter().enumerate().map(draw).collect::<Result<_, _>>()?;
        Ok(scene::beside(&images))
    }

    fn camera(&self) -> Camera {
        let (azimuth, elevation) = (self.azimuth.to_radians(), self.elevation.to_radians());
        // The last bits of a sine differ between machines; pictures must not.
        let rounded = |x: f64| (x * f64::from(1 << 20)).round() / f64::from(1 << 20);
        let right = rounded(elevation.cos() * azimuth.sin());
        let front = rounded(elevation.cos() * azimuth.cos());
        let above = rounded(elevation.sin());
        let (direction, up) = match self.up {
            Up::Y => ([right, above, front], [0.0, 1.0, 0.0]),
            Up::Z => ([right, -front, above], [0.0, 0.0, 1.0]),
        };
        Camera { direction, up, zoom: self.zoom, ..Camera::default() }
    }

    fn failure(&self, path: &Path, error: &PictureError) -> Failure {
        let of_mesh = format!("; 'triquad info {}' has more", shell::word(path));
        let remedy = match error {
            PictureError::Size { .. } => "; give a smaller --size, of 1 or more",
            PictureError::Section => "; give a direction that is not 0",
            PictureError::Camera(_) => "; use finite angles and a positive --zoom",
            PictureError::NotFinite(_) | PictureError::Vertex(_) => &of_mesh,
            _ => "",
        };
        Failure::bad(format!("{}: {error}{remedy}", path.display()))
    }
}

fn section(numbers: &[f64]) -> Section {
    let three = |first: usize| [0, 1, 2].map(|i| numbers[first + i]);
    Section { point: three(0), normal: three(3) }
}

/// Target of a picture, opened before the work starts.
enum Target<'a> {
    File(&'a Path, AtomicFile),
    StandardOutput,
}

impl<'a> Target<'a> {
    fn open(path: &'a Path) -> Result<Self, Failure> {
        if path.as_os_str() == "-" {
            return Ok(Self::StandardOutput);
        }
        if !path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("png")) {
            let problem = "pictures are PNG files; give a name that ends in .png";
            return Err(Failure::bad(format!("{}: {problem}", path.display())));
        }
        AtomicFile::create(path)
            .map(|file| Self::File(path, file))
            .map_err(|error| Self::failure(path, &error))
    }

    fn write(self, image: &Image) -> Result<(), Failure> {
        match self {
            Self::File(path, mut file) => {
                let written = image.write_png(&mut file).and_then(|()| file.commit());
                written.map_err(|error| Self::failure(path, &error))?;
                let (width, height) = (image.width(), image.height());
                stdio::summarise(&format!("{}: {width} x {height} pixels", path.display()))
            }
            Self::StandardOutput => stdio::say_by(|out| image.write_png(out)),
        }
    }

    fn failure(path: &Path, error: &io::Error) -> Failure {
        Failure::bad(format!("{}: {error}; check the path and its permissions", path.display()))
    }
}
