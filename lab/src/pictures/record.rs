//! The rows of `pictures.csv`: which pictures there are, and what they show.

use std::io;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::meshes::MeshKind;
use crate::{csv_text, whole_file};

/// Subject of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Subject {
    /// Quads that an algorithm made.
    #[default]
    Quads,
    /// The box of both papers.
    Box,
}

/// Visible part of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum View {
    /// All of it.
    #[default]
    Whole,
    /// The middle of it, enlarged.
    CloseUp,
}

impl View {
    /// Both, in the order of the page.
    pub const ALL: [Self; 2] = [Self::Whole, Self::CloseUp];

    /// Returns the name in files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Whole => "whole",
            Self::CloseUp => "close-up",
        }
    }
}

/// A row of `pictures/pictures.csv`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PictureRecord {
    /// Name of the file, beside `pictures.csv`.
    pub file: String,
    /// The subject.
    pub subject: Subject,
    /// The visible part.
    pub view: View,
    /// Name of the mesh; empty for the box.
    pub mesh: String,
    /// Origin of the mesh.
    pub mesh_kind: Option<MeshKind>,
    /// Algorithm and variant, as in experiment files.
    pub algorithm: String,
    /// Number of quads.
    pub quads: usize,
    /// Number of edges of the quads.
    pub edges: usize,
    /// Edges that the input does not have: marked.
    pub flipped_edges: usize,
    /// Quads of scaled Jacobian below [`POOR`](super::POOR): tinted.
    pub poor_quads: usize,
    /// Key of what it was made from: pictures of equal keys are equal.
    pub key: String,
}

impl PictureRecord {
    /// Reads `pictures.csv` in `folder`; nothing if there is none or if it is damaged.
    pub fn read_all(folder: &Path) -> Vec<Self> {
        let Ok(mut reader) = csv::Reader::from_path(folder.join("pictures.csv")) else {
            return Vec::new();
        };
        let rows: Result<_, _> = reader.deserialize().collect();
        rows.unwrap_or_default()
    }

    /// Writes `pictures.csv` in `folder`.
    pub(super) fn write_all(folder: &Path, rows: &[Self]) -> io::Result<()> {
        whole_file::write(&folder.join("pictures.csv"), &csv_text::with_header(rows)?)
    }
}
