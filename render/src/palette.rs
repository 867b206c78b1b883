//! At most 256 colours for an image, so that its file is small.

/// Bits of each colour that are distinguished when colours are counted.
const BITS: u32 = 5;

/// The most colours.
const MOST: usize = 256;

/// Colours near each other: how many pixels have them, and the sum of their values.
#[derive(Clone, Copy, Debug, Default)]
struct Bin {
    /// Red, green and blue, in [`BITS`] bits each.
    place: [u8; 3],
    pixels: u64,
    sum: [u64; 3],
}

/// Colours that stand for those of an image, and for each pixel which, by median cut (Heckbert,
/// *Color image quantization for frame buffer display*, 1982). The opacity of pixels is not looked
/// at. O(pixels).
pub fn reduce(pixels: &[[u8; 4]]) -> (Vec<[u8; 3]>, Vec<u8>) {
    let mut bins = count(pixels);
    let boxes = cut(&mut bins);
    let mut of_place = vec![0; 1 << (3 * BITS)];
    let mut colours = Vec::with_capacity(boxes.len());
    for (i, range) in boxes.into_iter().enumerate() {
        let (mut sum, mut total) = ([0; 3], 0);
        for bin in &bins[range] {
            of_place[index(bin.place)] = i as u8;
            total += bin.pixels;
            sum = [0, 1, 2].map(|c| sum[c] + bin.sum[c]);
        }
        colours.push(sum.map(|sum| ((sum + total / 2) / total) as u8));
    }
    (colours, pixels.iter().map(|&pixel| of_place[index(place(pixel))]).collect())
}

fn place([red, green, blue, _]: [u8; 4]) -> [u8; 3] {
    [red, green, blue].map(|value| value >> (8 - BITS))
}

fn index(place: [u8; 3]) -> usize {
    place.into_iter().fold(0, |index, value| index << BITS | usize::from(value))
}

/// Returns the bins that have a pixel.
fn count(pixels: &[[u8; 4]]) -> Vec<Bin> {
    let mut bins = vec![Bin::default(); 1 << (3 * BITS)];
    for &pixel in pixels {
        let place = place(pixel);
        let bin = &mut bins[index(place)];
        bin.place = place;
        bin.pixels += 1;
        bin.sum = [0, 1, 2].map(|c| bin.sum[c] + u64::from(pixel[c]));
    }
    bins.retain(|bin| bin.pixels > 0);
    bins
}

/// Sorts the bins into boxes: again and again the box of most pixels times extent is cut where half
/// of its pixels are on either side.
fn cut(bins: &mut [Bin]) -> Vec<std::ops::Range<usize>> {
    let mut boxes = vec![(weight(bins), 0..bins.len())];
    while boxes.len() < MOST {
        let heaviest = (0..boxes.len()).max_by_key(|&i| boxes[i].0.0).expect("there is a box");
        let ((weight_now, axis), range) = boxes[heaviest].clone();
        if weight_now == 0 {
            break;
        }
        let inside = &mut bins[range.clone()];
        inside.sort_unstable_by_key(|bin| (bin.place[axis], bin.place));
        let middle = range.start + median(inside);
        boxes[heaviest] = (weight(&bins[range.start..middle]), range.start..middle);
        boxes.push((weight(&bins[middle..range.end]), middle..range.end));
    }
    boxes.into_iter().map(|(_, range)| range).filter(|range| !range.is_empty()).collect()
}

/// Pixels of a box times its longest side, and which that is; 0 if it cannot be cut.
fn weight(bins: &[Bin]) -> (u64, usize) {
    let side = |axis: usize| {
        let values = bins.iter().map(|bin| bin.place[axis]);
        values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
    };
    let longest = (0..3).max_by_key(|&axis| side(axis)).expect("there are three");
    (bins.iter().map(|bin| bin.pixels).sum::<u64>() * u64::from(side(longest)), longest)
}

/// Returns the number of bins, of two or more, that make half of the pixels.
fn median(bins: &[Bin]) -> usize {
    let half = bins.iter().map(|bin| bin.pixels).sum::<u64>() / 2;
    let mut before = 0;
    let reached = bins.iter().position(|bin| {
        before += bin.pixels;
        before > half
    });
    reached.unwrap_or(0).clamp(1, bins.len() - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_colours_stay_what_they_are() {
        let given = [[255, 255, 255, 255], [10, 200, 30, 255], [0, 0, 0, 0], [10, 200, 30, 9]];
        let (colours, indices) = reduce(&given);
        assert_eq!(colours.len(), 3);
        for (pixel, index) in given.iter().zip(indices) {
            assert_eq!(colours[usize::from(index)], pixel[..3]);
        }
    }

    #[test]
    fn many_colours_become_256_near_them() {
        let pixels: Vec<[u8; 4]> = (0..1 << 16)
            .map(|i: u32| [(i % 64 * 4) as u8, (i / 64 % 64 * 4) as u8, (i >> 12 << 4) as u8, 255])
            .collect();
        let (colours, indices) = reduce(&pixels);
        assert_eq!(colours.len(), MOST);
        let distance = |(pixel, index): (&[u8; 4], u8)| {
            (0..3).map(|c| pixel[c].abs_diff(colours[usize::from(index)][c])).max().unwrap()
        };
        assert!(pixels.iter().zip(indices).map(distance).max().unwrap() <= 48);
    }

    #[test]
    fn no_pixels_have_no_colours() {
        assert_eq!(reduce(&[]), (vec![], vec![]));
    }
}
