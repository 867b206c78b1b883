//! A picture as the page shows it.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde::Serialize;
use triquad::counted::counted;
use triquad_generators::box_mesh::PaperBox;

use super::parts::PictureFile;
use crate::algorithms::AlgorithmFacts;
use crate::meshes::MeshKind;
use crate::pictures::{DRAWN_DEPTH, POOR, PictureRecord, Subject, View};

/// A picture and its words.
#[derive(Serialize)]
pub struct PictureView {
    data: String,
    width: u32,
    height: u32,
    alt: String,
    caption: String,
}

impl PictureView {
    /// Prepares the picture; `None` if its file is no PNG.
    pub fn new(picture: &PictureFile) -> Option<Self> {
        let decoder = png::Decoder::new(std::io::Cursor::new(&picture.png));
        let (width, height) = decoder.read_info().ok()?.info().size();
        let (alt, caption) = words(&picture.record);
        Some(Self { data: BASE64_STANDARD.encode(&picture.png), width, height, alt, caption })
    }
}

/// Returns alternative text and caption.
fn words(shown: &PictureRecord) -> (String, String) {
    if shown.subject == Subject::Box {
        let alt = match shown.view {
            View::Whole => "A flat box with 62 by 62 square cavities",
            View::CloseUp => "The box cut open along a row of cavities",
        };
        let caption = format!(
            "The 62 × 62 = 3,844 cavities of the box that the printed counts determine, drawn \
             {DRAWN_DEPTH} cells deep instead of {}. Inner sides are orange where the box is cut.",
            PaperBox::PUBLISHED.depth
        );
        return (alt.into(), format!("{alt}. {caption}"));
    }
    let close = if shown.view == View::CloseUp { "Close-up: " } else { "" };
    let name = AlgorithmFacts::named(&shown.algorithm).map_or("?", |facts| facts.label);
    let mesh = match shown.mesh_kind {
        Some(MeshKind::StandIn) => format!("{} († a stand-in of other shape)", shown.mesh),
        _ => shown.mesh.clone(),
    };
    let alt = format!("{close}quad mesh made by {name} of {mesh}");
    let caption = format!(
        "{close}{name} on {mesh}: {}. Blue and wide: {} of {} edges are not in the input \
         (flipped). Orange: {} of scaled Jacobian below {POOR}, the stronger the worse.",
        counted(shown.quads, "quad", "quads"),
        shown.flipped_edges,
        shown.edges,
        counted(shown.poor_quads, "quad", "quads")
    );
    (alt, caption)
}
