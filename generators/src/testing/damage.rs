//! Damaged files, for readers that must survive them.

use std::ops::Range;

/// Numbers at which readers break, as text.
const EXTREMES: [&str; 14] = [
    "0",
    "-1",
    "1",
    "255",
    "65536",
    "99999999",
    "2147483647",
    "2147483648",
    "4294967295",
    "-9223372036854775808",
    "18446744073709551616",
    "1e999",
    "nan",
    "-inf",
];

/// Returns `file` with one to four kinds of damage done to it; `below(n)` is a uniform draw from
/// `0..n`.
///
/// Bits and bytes change, pieces disappear, occur twice or come from `other`, the end is missing,
/// numbers become extreme, lines change places. At most four times as long as both together.
pub fn damaged(file: &[u8], other: &[u8], below: &mut dyn FnMut(u32) -> u32) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for _ in 0..=below(4) {
        damage(&mut bytes, other, below);
    }
    bytes.truncate(4 * (file.len() + other.len()));
    bytes
}

fn damage(bytes: &mut Vec<u8>, other: &[u8], below: &mut dyn FnMut(u32) -> u32) {
    let piece = piece_of(bytes.len(), below);
    let place = below(bytes.len() as u32 + 1) as usize;
    match below(9) {
        0 => flip(bytes, |_| 1, below),
        1 => flip(bytes, |below| below(255) as u8 + 1, below),
        2 => drop(bytes.drain(piece)),
        3 => {
            let copy = bytes[piece].to_vec();
            insert(bytes, place, &copy);
        }
        4 => insert(bytes, place, &other[piece_of(other.len(), below)]),
        5 => bytes.truncate(place),
        6 => replace_binary_number(bytes, place, below),
        7 => swap_lines(bytes, below),
        _ => replace_number(bytes, place, below),
    }
}

/// A stretch of something that is `length` long: mostly short, sometimes anything.
fn piece_of(length: usize, below: &mut dyn FnMut(u32) -> u32) -> Range<usize> {
    let start = below(length as u32 + 1) as usize;
    let longest = if below(4) == 0 { length } else { 40 };
    start..length.min(start + below(longest as u32 + 1) as usize)
}

fn insert(bytes: &mut Vec<u8>, place: usize, piece: &[u8]) {
    bytes.splice(place..place, piece.iter().copied());
}

/// Changes one byte by an exclusive or with what `mask` draws, shifted by up to seven bits.
fn flip(
    bytes: &mut [u8],
    mask: impl Fn(&mut dyn FnMut(u32) -> u32) -> u8,
    below: &mut dyn FnMut(u32) -> u32,
) {
    if !bytes.is_empty() {
        let place = below(bytes.len() as u32) as usize;
        bytes[place] ^= mask(below).rotate_left(below(8));
    }
}

/// Replaces the digits at `place` or after it.
fn replace_number(bytes: &mut Vec<u8>, place: usize, below: &mut dyn FnMut(u32) -> u32) {
    let digit = |byte: &u8| byte.is_ascii_digit();
    let Some(start) = bytes[place..].iter().position(digit).map(|offset| place + offset) else {
        return;
    };
    let length = bytes[start..].iter().take_while(|&byte| digit(byte)).count();
    let extreme = EXTREMES[below(EXTREMES.len() as u32) as usize];
    bytes.splice(start..start + length, extreme.bytes());
}

/// Writes four bytes that are a very large, very small or special number in many encodings.
fn replace_binary_number(bytes: &mut [u8], place: usize, below: &mut dyn FnMut(u32) -> u32) {
    let number = [0, 1, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff, 0x00ff_ffff, 0x7fc0_0000];
    let number: u32 = number[below(7) as usize];
    let four = if below(2) == 0 { number.to_le_bytes() } else { number.to_be_bytes() };
    bytes[place..].iter_mut().zip(four).for_each(|(byte, new)| *byte = new);
}

fn swap_lines(bytes: &mut Vec<u8>, below: &mut dyn FnMut(u32) -> u32) {
    let mut lines: Vec<&[u8]> = bytes.split_inclusive(|&byte| byte == b'\n').collect();
    if lines.len() > 1 {
        let count = lines.len() as u32;
        lines.swap(below(count) as usize, below(count) as usize);
    }
    *bytes = lines.concat();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::draws;
    use std::collections::HashSet;

    #[test]
    fn damaged_files_differ_and_stay_short() {
        let file = b"v 1 2 3\nv 4 5 6\nf 1 2 3\n";
        let mut below = draws(1);
        let files: HashSet<_> = (0..1000).map(|_| damaged(file, b"other", &mut below)).collect();
        assert!(files.len() > 750, "{}", files.len());
        assert!(files.iter().all(|bytes| bytes.len() <= 4 * (file.len() + 5)));
    }

    #[test]
    fn empty_files_can_be_damaged() {
        let mut below = draws(2);
        (0..1000).for_each(|_| drop(damaged(b"", b"", &mut below)));
    }
}
