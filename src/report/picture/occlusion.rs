//! How much of the sky a visible point does not see, from the depth of its surroundings alone.

/// Directions on the screen, each looked along both ways; lengths are near 1.
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

/// How far to look, in shares of the longer side of the image.
const STEPS: [f32; 6] = [0.0018, 0.004, 0.008, 0.015, 0.026, 0.042];

/// Hidden share of the sky for each pixel, 0 to 1, from the nearness of all pixels (in pixels; minus
/// infinity where nothing is). O(pixels).
///
/// Along a line on the screen the surroundings rise to one angle on one side and to another on the
/// other; a plane, however tilted, rises on one side by what it falls on the other and hides nothing.
pub fn occlusion(near: &[f32], [width, height]: [usize; 2]) -> Vec<f32> {
    let longer = width.max(height) as f32;
    let steps = STEPS.map(|step| (step * longer).max(1.0));
    let hidden = |at: usize| {
        if near[at] == f32::NEG_INFINITY {
            return 0.0;
        }
        let (x, y) = ((at % width) as f32, (at / width) as f32);
        let rise = |[dx, dy]: [f32; 2], step: f32| {
            let (x, y) = ((x + dx * step).round(), (y + dy * step).round());
            let inside = x >= 0.0 && y >= 0.0 && x < width as f32 && y < height as f32;
            let there = if inside { near[y as usize * width + x as usize] } else { near[at] };
            sine(there - near[at], step, steps[STEPS.len() - 1])
        };
        let along = |[dx, dy]: [f32; 2]| {
            let highest = |[dx, dy]: [f32; 2]| {
                steps.iter().fold(-1.0, |most: f32, &step| most.max(rise([dx, dy], step)))
            };
            (highest([dx, dy]) + highest([-dx, -dy])).max(0.0) / 2.0
        };
        DIRECTIONS.into_iter().map(along).sum::<f32>() / DIRECTIONS.len() as f32
    };
    (0..near.len()).map(hidden).collect()
}

/// Sine of the angle to a point `rise` above and `run` away; what rises far beyond `reach` is
/// something else in front and hides little.
fn sine(rise: f32, run: f32, reach: f32) -> f32 {
    if rise == f32::NEG_INFINITY {
        return -1.0;
    }
    let sine = rise / (rise * rise + run * run).sqrt();
    if rise > reach { sine * (reach / rise) } else { sine }
}
