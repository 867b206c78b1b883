//! A picture as a page needs it.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde::Serialize;

use super::Pictured;
use crate::report::figures::POOR;
use crate::report::gallery::Shown;

/// A picture and its words.
#[derive(Serialize)]
pub struct Figure {
    data: String,
    width: u32,
    height: u32,
    alt: String,
    caption: String,
}

impl Figure {
    /// The picture, unless its file is no PNG.
    pub fn of(picture: &Pictured) -> Option<Self> {
        let decoder = png::Decoder::new(std::io::Cursor::new(&picture.png));
        let (width, height) = decoder.read_info().ok()?.info().size();
        let (alt, caption) = words(&picture.shown);
        Some(Self { data: BASE64_STANDARD.encode(&picture.png), width, height, alt, caption })
    }
}

/// Alternative text and caption.
fn words(shown: &Shown) -> (String, String) {
    let close = if shown.view == "close-up" { "Close-up: " } else { "" };
    if shown.subject == "box" {
        let alt = match close {
            "" => "A flat box with 62 by 62 square cavities",
            _ => "The box cut open along a row of cavities",
        };
        let caption = "62 × 62 = 3,844 cavities; the paper gives no proportions, these are ours. \
                       Inner sides are orange where the box is cut.";
        return (alt.into(), format!("{alt}. {caption}"));
    }
    let name = shown.algorithm.to_uppercase().replace("FEW-FLIPS", "few-flips");
    let mesh = if shown.mesh_kind == "stand-in" {
        format!("{} († a stand-in of other shape)", shown.mesh)
    } else {
        shown.mesh.clone()
    };
    let alt = format!("{close}quad mesh made by {name} of {mesh}");
    let caption = format!(
        "{close}{name} on {mesh}: {} quads. Blue and wide: {} of {} edges are not in the input \
         (flipped). Orange: {} quads of scaled Jacobian below {POOR}, the stronger the worse.",
        shown.quads, shown.flipped_edges, shown.edges, shown.poor_quads
    );
    (alt, caption)
}
