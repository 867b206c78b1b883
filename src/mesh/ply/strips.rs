//! Triangle strips of a PLY file (element `tristrips`), as the Stanford tools write them.

use super::header::{Element, Kind, Scalar};
use super::source::Source;
use super::{Faces, MAX_CORNERS, for_each_record};
use crate::mesh::error::MeshError;

/// Reads strips as triangles, behind those that `faces` has.
pub(super) fn read_strips(
    element: &Element,
    source: &mut impl Source,
    faces: &mut Faces,
) -> Result<(), MeshError> {
    let plan = element.plan();
    for &(is_corners, kind) in &plan {
        if let Kind::List { item, .. } = kind
            && is_corners
        {
            // A value ends one triangle at most. Lists that double would take twice as much.
            faces.reserve(3 * (source.rest().len() / source.least_size(item)));
        }
    }
    for_each_record(element, 0, || {
        for &(is_corners, kind) in &plan {
            match kind {
                Kind::List { count, item } if is_corners => {
                    read_strip(source, count, item, faces)?;
                }
                _ => source.skip_property(kind)?,
            }
        }
        Ok(())
    })
}

/// Reads one list, in which -1 begins another strip.
///
/// Every other triangle of a strip is turned. A triangle that repeats a corner joins two parts of
/// a strip and has no area: it is no face.
fn read_strip(
    source: &mut impl Source,
    count: Scalar,
    item: Scalar,
    faces: &mut Faces,
) -> Result<(), MeshError> {
    let length = source.index(count, "the length of a strip")?;
    let (mut last, mut seen) = ([0; 2], 0);
    for _ in 0..length {
        let Some(vertex) = source.index_or_restart(item)? else {
            seen = 0;
            continue;
        };
        let [a, b] = last;
        if seen >= 2 && a != b && b != vertex && a != vertex {
            faces.push(&if seen % 2 == 0 { [a, b, vertex] } else { [b, a, vertex] });
            if faces.corners().len() > MAX_CORNERS {
                return Err(MeshError::TooLarge);
            }
        }
        last = [b, vertex];
        seen += 1;
    }
    Ok(())
}
