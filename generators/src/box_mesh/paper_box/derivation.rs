//! The search that recovers the papers' box from its printed counts (`docs/meshes.md`).
//!
//! `cargo test -p triquad-generators derivation -- --nocapture` prints what it finds.

use super::PaperBox;

/// Cavities of B0, and its vertices as printed in Table 3.
const SHAFTS: u64 = 62 * 62;
const VERTICES: u64 = 2_097_150;

/// A lattice box whose shafts are one cell wide, and the parts whose cells have centres.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Candidate {
    /// Cells along x and y.
    plate: [u64; 2],
    /// Depth of a cavity in cells.
    depth: u64,
    /// Cells from the floor of a cavity to the bottom.
    thickness: u64,
    centred: Centred,
}

/// The parts whose cells are cut in four by a centre; the others are cut in two.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Centred {
    plates: bool,
    floors: bool,
    shafts: bool,
    sides: bool,
}

impl Centred {
    fn all() -> impl Iterator<Item = Self> {
        let bit = |kind: u32, part: u32| kind >> part & 1 == 1;
        (0..16).map(move |kind| Self {
            plates: bit(kind, 0),
            floors: bit(kind, 1),
            shafts: bit(kind, 2),
            sides: bit(kind, 3),
        })
    }
}

impl Candidate {
    /// Counts the vertices of the box with cavities only.
    fn vertices(&self) -> u64 {
        let ([x, y], z) = (self.plate, self.depth + self.thickness);
        let lattice = 2 * (x * y + y * z + z * x) + 2 + 4 * self.depth * SHAFTS;
        let Centred { plates, floors, shafts, sides } = self.centred;
        let centres = [
            (plates, 2 * x * y - SHAFTS),
            (floors, SHAFTS),
            (shafts, 4 * self.depth * SHAFTS),
            (sides, 2 * (x + y) * z),
        ];
        lattice + centres.iter().filter(|part| part.0).map(|part| part.1).sum::<u64>()
    }

    /// Counts the vertices that a hole adds in place of a cavity.
    fn vertices_for_a_hole(&self) -> i64 {
        let Centred { plates, floors, shafts, .. } = self.centred;
        let [plates, floors, shafts] = [plates, floors, shafts].map(i64::from);
        let thickness = self.thickness as i64;
        4 * (thickness - 1) + shafts * 4 * thickness - plates - floors
    }
}

/// Lists the boxes with the vertices of B0: plates of 124 to 131 cells each way, floors of 1 to 39.
fn search() -> Vec<Candidate> {
    let mut found = Vec::new();
    let plates = (124..=131).flat_map(|x| (x..=131).map(move |y| [x, y]));
    let shapes = plates.flat_map(|plate| (1..40).map(move |thickness| (plate, thickness)));
    for (plate, thickness) in shapes {
        for (centred, depth) in Centred::all().flat_map(|c| (1..160).map(move |depth| (c, depth))) {
            let candidate = Candidate { plate, depth, thickness, centred };
            if candidate.vertices() == VERTICES {
                println!("{candidate:?}: a hole adds {}", candidate.vertices_for_a_hole());
                found.push(candidate);
            }
        }
    }
    found
}

/// Tables 3 to 5: 2 vertices a hole. Of the two boxes left one has tubes of twice the depth and
/// cells cut in two; the other has degrees 4 and 8, with which BF makes too few tests (Table 6).
#[test]
fn two_boxes_have_the_printed_counts_and_one_of_them_regular_walls() {
    let found = search();
    assert_eq!(found.len(), 4);
    let fitting: Vec<_> = found.iter().filter(|c| c.vertices_for_a_hole() == 2).collect();
    let [low, high] = fitting[..] else { panic!("{fitting:?}") };
    let all = Centred { plates: true, floors: true, shafts: true, sides: true };
    let horizontal = Centred { shafts: false, sides: false, ..all };
    let plate = [125, 127];
    assert_eq!(*low, Candidate { plate, depth: 64, thickness: 1, centred: all });
    assert_eq!(*high, Candidate { plate, depth: 128, thickness: 2, centred: horizontal });
    let PaperBox { shafts, depth, .. } = PaperBox::PUBLISHED;
    assert_eq!((u64::from(shafts).pow(2), u64::from(depth)), (SHAFTS, high.depth));
    assert_eq!(PaperBox::PUBLISHED.cells(), [125, 127, 130]);
}
