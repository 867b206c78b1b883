//! Sizes of a box of the papers' kind, its counts, and reasons why there may be none.

use std::fmt;

/// Cells from the floor of a cavity to the bottom.
pub(super) const THICKNESS: u32 = 2;

/// A box of the papers' kind. [`PaperBox::PUBLISHED`] is theirs.
///
/// ```
/// use triquad_generators::box_mesh::PaperBox;
///
/// assert_eq!(PaperBox::PUBLISHED.vertices(), 2_097_150);
/// assert_eq!(PaperBox { holes: 3500, ..PaperBox::PUBLISHED }.vertices(), 2_104_150);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaperBox {
    /// Shafts in a row of the array, and rows.
    pub shafts: u32,
    /// Depth of a cavity in cells.
    pub depth: u32,
    /// Shafts that go through: the genus. The others are cavities.
    pub holes: u32,
}

/// The diagonals that cut the cells of walls, outer sides included. All cells of one wall have the
/// same, so that nearly all vertices there have degree 6.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Walls {
    /// `/\/\`: the four walls of a shaft turn by turn.
    #[default]
    Alternating,
    /// `////`: the same all round a shaft, as a screw.
    Equal,
    /// `//\\`: two and two, so that opposite walls of a shaft have parallel diagonals.
    Paired,
    /// Drawn for each wall of each shaft.
    Drawn,
}

/// Reason why there is no such box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImpossiblePaperBoxError {
    /// Cavities without depth.
    NoDepth,
    /// More holes than shafts.
    TooManyHoles {
        /// Requested holes.
        holes: u32,
        /// Shafts there are.
        shafts: u64,
    },
    /// The surface would have more than 2³¹ half-edges.
    TooManyHalfEdges,
}

impl PaperBox {
    /// The box of A1 and B0: 62 × 62 cavities, 128 deep.
    pub const PUBLISHED: Self = Self { shafts: 62, depth: 128, holes: 0 };

    /// Returns the numbers of cells along the box: 2m + 1, 2m + 3 and the depth + 2. O(1).
    pub fn cells(&self) -> [u64; 3] {
        let [shafts, depth] = [self.shafts, self.depth].map(u64::from);
        [2 * shafts + 1, 2 * shafts + 3, depth + u64::from(THICKNESS)]
    }

    /// Returns the number of vertices; saturates. O(1).
    pub fn vertices(&self) -> u64 {
        let [x, y, z] = self.cells().map(u128::from);
        let [shafts, depth, holes] = [self.shafts, self.depth, self.holes].map(u128::from);
        let outside = 2 * (x * y + y * z + z * x) + 2;
        let centres = 2 * x * y;
        // A cavity has a centre less in the top and one more on its floor.
        let cavities = 4 * depth * shafts * shafts;
        let holes = 2 * holes;
        u64::try_from(outside + centres + cavities + holes).unwrap_or(u64::MAX)
    }

    /// Returns the number of triangles by Euler's formula, 2 (vertices - 2 + 2 genus). O(1).
    pub fn triangles(&self) -> u64 {
        (self.vertices() - 2).saturating_add(2 * u64::from(self.holes)).saturating_mul(2)
    }
}

impl Walls {
    /// All patterns.
    pub const ALL: [Self; 4] = [Self::Alternating, Self::Equal, Self::Paired, Self::Drawn];

    /// Returns the name on the command line and in keys.
    pub fn id(self) -> &'static str {
        match self {
            Self::Alternating => "alternating",
            Self::Equal => "equal",
            Self::Paired => "paired",
            Self::Drawn => "drawn",
        }
    }

    /// Returns for the four walls round a shaft, or round the box, whether their diagonals are
    /// turned.
    pub(super) fn turned(self, below: &mut dyn FnMut(u32) -> u32) -> [bool; 4] {
        match self {
            Self::Alternating => [true, false, true, false],
            Self::Equal => [false; 4],
            Self::Paired => [false, false, true, true],
            Self::Drawn => [0; 4].map(|_: u32| below(2) == 1),
        }
    }
}

impl fmt::Display for ImpossiblePaperBoxError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDepth => write!(f, "shafts are at least 1 cell deep, not 0"),
            Self::TooManyHoles { holes, shafts } => {
                write!(f, "more holes ({holes}) than shafts ({shafts})")
            }
            Self::TooManyHalfEdges => write!(f, "the box would have more than 2^31 half-edges"),
        }
    }
}

impl std::error::Error for ImpossiblePaperBoxError {}
