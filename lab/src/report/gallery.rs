//! The pictures beside the records: which there are, and what they show.

use std::io::{self, Write};
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::figures::{QuadScene, View, box_picture};
use triquad::Mesh;
use triquad::atomic_file::AtomicFile;
use triquad_render::Image;

/// A row of `pictures/pictures.csv`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Shown {
    /// Name of the file, beside `pictures.csv`.
    pub file: String,
    /// `quads` or `box`.
    pub subject: String,
    /// `whole` or `close-up`.
    pub view: String,
    /// Name of the mesh.
    pub mesh: String,
    /// `real`, `generated`, `simplified` or `stand-in`.
    pub mesh_kind: String,
    /// Algorithm and variant, as on the command line.
    pub algorithm: String,
    /// Number of quads.
    pub quads: usize,
    /// Number of edges of the quads.
    pub edges: usize,
    /// How many of them the input does not have: marked.
    pub flipped_edges: usize,
    /// Quads of scaled Jacobian below [`POOR`](super::figures::POOR): tinted.
    pub poor_quads: usize,
    /// What it was made from: pictures of equal keys are equal.
    pub key: String,
}

const VIEWS: [(View, &str); 2] = [(View::Whole, "whole"), (View::CloseUp, "close-up")];

/// Reads `pictures.csv` in `folder`; nothing if there is none or if it is damaged.
pub fn read(folder: &Path) -> Vec<Shown> {
    let Ok(mut reader) = csv::Reader::from_path(folder.join("pictures.csv")) else {
        return Vec::new();
    };
    let rows: Result<_, _> = reader.deserialize().collect();
    rows.unwrap_or_default()
}

/// Writes `pictures.csv` in `folder`.
///
/// # Errors
/// Those of the file system.
pub fn write(folder: &Path, rows: &[Shown]) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    let bytes = writer.into_inner().map_err(|error| io::Error::other(error.to_string()))?;
    put(&folder.join("pictures.csv"), &bytes)
}

/// Draws the quads that `about` tells of, as in Figures 5.11 to 5.14 of Lemos et al.: two files.
///
/// # Errors
/// The mesh cannot be drawn, or a file not be written.
pub fn draw_quads(
    folder: &Path,
    about: &Shown,
    quads: &Mesh,
    input: &Mesh,
) -> io::Result<Vec<Shown>> {
    let scene = QuadScene::new(quads, input);
    let mut rows = Vec::new();
    for (view, name) in VIEWS {
        let file = format!("quads-{}-{name}.png", about.algorithm.replace(' ', "-"));
        save(folder, &file, &scene.draw(view).map_err(io::Error::other)?)?;
        rows.push(Shown {
            file,
            subject: "quads".into(),
            view: name.into(),
            quads: scene.quad_count(),
            edges: scene.edge_count(),
            flipped_edges: scene.flipped_count(),
            poor_quads: scene.poor_count(),
            ..about.clone()
        });
    }
    Ok(rows)
}

/// Draws the box, as in Figure 14 of Ramaswami and Siqueira: two files.
///
/// # Errors
/// A file cannot be written.
pub fn draw_box(folder: &Path, about: &Shown) -> io::Result<Vec<Shown>> {
    let draw = |(view, name): (View, &str)| {
        let file = format!("box-{name}.png");
        save(folder, &file, &box_picture(view))?;
        Ok(Shown { file, subject: "box".into(), view: name.into(), ..about.clone() })
    };
    VIEWS.into_iter().map(draw).collect()
}

fn save(folder: &Path, file: &str, image: &Image) -> io::Result<()> {
    put(&folder.join(file), &image.small_png())
}

fn put(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = AtomicFile::create(path)?;
    file.write_all(bytes)?;
    file.commit()
}
