//! Ambient occlusion: the share of the sky hidden from a visible point, from the depth of its
//! surroundings alone.

/// Directions on the screen, each followed both ways; lengths are near 1.
const DIRECTIONS: [[f32; 2]; 8] = [
    [1.0, 0.0],
    [0.924, 0.383],
    [0.707, 0.707],
    [0.383, 0.924],
    [0.0, 1.0],
    [-0.383, 0.924],
    [-0.707, 0.707],
    [-0.924, 0.383],
];

/// Distances of the pixels compared, in shares of the longer side of the image.
const STEPS: [f32; 6] = [0.0018, 0.004, 0.008, 0.015, 0.026, 0.042];

/// A slope that stands for a fall without end.
const CLIFF: f32 = -8.0;

/// Returns the hidden share of the sky for each pixel, 0 to 1, from the nearness of all pixels (in
/// pixels; minus infinity where nothing is). O(pixels).
///
/// Along a line on the screen the surroundings rise to one angle on one side and to another on the
/// other; a plane, however tilted, rises on one side by what it falls on the other and hides
/// nothing.
pub fn occlusion(near: &[f32], [width, height]: [usize; 2]) -> Vec<f32> {
    let longer = width.max(height) as f32;
    let lines = DIRECTIONS.map(|[x, y]| {
        [[x, y], [-x, -y]].map(|way| STEPS.map(|step| Step::new(way, (step * longer).max(1.0))))
    });
    let reach = STEPS[STEPS.len() - 1] * longer;
    let hidden = |at: usize| {
        if near[at] == f32::NEG_INFINITY {
            return 0.0;
        }
        let (x, y) = (at % width, at / width);
        let slope = |step: &Step| {
            let to = [x.wrapping_add_signed(step.x), y.wrapping_add_signed(step.y)];
            // Outside the image nothing is hidden.
            let inside = to[0] < width && to[1] < height;
            let rise =
                if inside { near[to[1] * width + to[0]] - near[at] } else { f32::NEG_INFINITY };
            // A rise far beyond reach is another surface in front, which hides little.
            let fades = rise > reach;
            (if fades { reach * reach / rise } else { rise }) * step.over_length
        };
        let highest = |way: &[Step; 6]| sine(way.iter().map(slope).fold(CLIFF, f32::max));
        let along = |[one, other]: &[[Step; 6]; 2]| (highest(one) + highest(other)).max(0.0) / 2.0;
        lines.iter().map(along).sum::<f32>() / DIRECTIONS.len() as f32
    };
    (0..near.len()).map(hidden).collect()
}

/// From a pixel to one that it is compared with.
#[derive(Clone, Copy)]
struct Step {
    x: isize,
    y: isize,
    over_length: f32,
}

impl Step {
    fn new(way: [f32; 2], length: f32) -> Self {
        let [x, y] = way.map(|part| (part * length).round());
        Self { x: x as isize, y: y as isize, over_length: 1.0 / (x * x + y * y).sqrt() }
    }
}

/// Returns the sine of the angle of a slope.
fn sine(slope: f32) -> f32 {
    slope / (1.0 + slope * slope).sqrt()
}
