//! The facts that experiments and reports need of each algorithm: one row an algorithm.
//!
//! Programs and algorithms that are not ours have rows too, made when their names are first read.
//! The costs were measured on two cores at 2 to 3 GHz; they decide about estimates only.

use std::sync::{Mutex, PoisonError};

/// Mark of a point in a plot; each differs from the others without its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A disc.
    Circle,
    /// A square on its side.
    Square,
    /// A triangle on its side.
    Up,
    /// A triangle on its tip.
    Down,
    /// A square on its tip.
    Diamond,
    /// Two strokes.
    Cross,
}

impl Mark {
    /// Every mark.
    const ALL: [Self; 6] =
        [Self::Circle, Self::Square, Self::Up, Self::Down, Self::Diamond, Self::Cross];
}

/// Colour and mark in plots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Colour of Okabe and Ito's palette, which no common colour blindness confounds.
    pub colour: [u8; 3],
    /// Mark of every point.
    pub mark: Mark,
}

/// Okabe and Ito's palette (*Color Universal Design*, 2008), without its yellow, which is hardly
/// visible on white.
pub const ORANGE: [u8; 3] = [230, 159, 0];
/// Of the same palette.
pub const SKY: [u8; 3] = [86, 180, 233];
/// Of the same palette.
pub const GREEN: [u8; 3] = [0, 158, 115];
/// Of the same palette.
pub const BLUE: [u8; 3] = [0, 114, 178];
/// Of the same palette.
pub const VERMILION: [u8; 3] = [213, 94, 0];
/// Of the same palette.
pub const PURPLE: [u8; 3] = [204, 121, 167];
/// For the papers' own numbers.
pub const GREY: [u8; 3] = [110, 110, 110];

/// Every colour of a look, the most distinct ones first.
const COLOURS: [[u8; 3]; 7] = [BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, GREY];

impl Look {
    /// Returns a look for each of `wanted`, no two alike as long as there are enough: its own for
    /// the first that wants it; for later ones the next mark in the same colour that nothing has.
    pub(crate) fn distinct(wanted: &[Self]) -> Vec<Self> {
        let mut taken = wanted.to_vec();
        let mut looks = Vec::new();
        for (at, look) in wanted.iter().enumerate() {
            let is_first = !wanted[..at].contains(look);
            let free = || look.others().find(|other| !taken.contains(other));
            let found = if is_first { *look } else { free().unwrap_or(*look) };
            taken.push(found);
            looks.push(found);
        }
        looks
    }

    /// Returns the other looks: first those of the same colour, from the next mark on.
    fn others(self) -> impl Iterator<Item = Self> {
        let colours = COLOURS.into_iter().filter(move |&colour| colour != self.colour);
        let colours = std::iter::once(self.colour).chain(colours);
        let marks = move || {
            let next = Mark::ALL.into_iter().cycle().skip_while(move |&mark| mark != self.mark);
            next.skip(1).take(Mark::ALL.len())
        };
        colours.flat_map(move |colour| marks().map(move |mark| Self { colour, mark }))
    }
}

/// Facts about an algorithm; a variant counts as one.
#[derive(Debug)]
pub struct AlgorithmFacts {
    /// Name in experiment files and records; a variant follows after a space.
    pub name: &'static str,
    /// Name in the papers, with what is not as published.
    pub label: &'static str,
    /// Its meaning in a line, for the definitions of the page.
    pub meaning: &'static str,
    /// Look in plots.
    pub look: Look,
    /// Seconds for each triangle, augmentation excluded.
    pub seconds: f64,
    /// Bytes for each triangle.
    pub bytes: f64,
    /// Unpaired triangles, column (c): for each triangle, for each handle, and once.
    pub unpaired: [f64; 3],
}

/// Every algorithm, those of the papers first: the order of tables and plots.
static ALGORITHMS: &[AlgorithmFacts] = &[
    row(
        ["sg", "SG"],
        "simple greedy: takes edges in random order, pairs their triangles if both are free",
        (ORANGE, Mark::Circle),
        (0.15e-6, 120.0),
        [0.125, 0.0, 0.0],
    ),
    row(
        ["ps", "PS"],
        "Pulli and Segal: greedy with four priorities, from triangles in random order",
        (BLUE, Mark::Square),
        (0.15e-6, 120.0),
        [0.001, 0.0, 0.0],
    ),
    row(
        ["ds", "DS"],
        "Diks and Stanczyk: a perfect pairing at once, in O(n log² n)",
        (GREEN, Mark::Up),
        (25e-6, 450.0),
        [0.0, 0.0, 0.0],
    ),
    row(
        ["lrs", "LRS"],
        "Lemos, Ramaswami, Siqueira: contracts to an irreducible triangulation, expands again",
        (VERMILION, Mark::Diamond),
        (0.5e-6, 160.0),
        [0.0, 12.0, 4.0],
    ),
    row(
        ["lrs few-flips", "LRS few-flips"],
        "LRS with an expansion of ours that keeps more of the input's edges",
        (PURPLE, Mark::Cross),
        (0.8e-6, 160.0),
        [0.0, 12.0, 4.0],
    ),
    row(
        ["velho", "Velho"],
        "SG with the longest edge first, after Velho; the paper prints no numbers of it",
        (SKY, Mark::Circle),
        (0.3e-6, 140.0),
        [0.125, 0.0, 0.0],
    ),
    row(
        ["gw", "GW"],
        "Gawrychowski and Wasylkiewicz: a perfect pairing at once, in O(n log n)",
        (SKY, Mark::Down),
        (2.4e-6, 120.0),
        [0.0, 0.0, 0.0],
    ),
    row(
        ["best", "BEST"],
        "ours: the perfect pairing of least total cost; the default of triquad convert",
        (GREEN, Mark::Circle),
        (0.6e-6, 190.0),
        [0.0; 3],
    ),
    row(
        ["tq", "TQ"],
        "ours, for speed: PS that pairs each stranded triangle at once; leaves a few at most",
        (GREY, Mark::Circle),
        (0.15e-6, 120.0),
        [0.0, 0.0, 2.0],
    ),
    row(
        ["rs", "RS"],
        "Ramaswami and Siqueira: irreducible triangulations, each edge tested once",
        (BLUE, Mark::Square),
        (0.15e-6, 120.0),
        [0.0; 3],
    ),
    row(
        ["schipper", "S"],
        "Schipper: contracts at a vertex of least degree",
        (VERMILION, Mark::Diamond),
        (0.7e-6, 120.0),
        [0.0; 3],
    ),
    row(
        ["brute-force", "BF"],
        "brute force: tests edges in random order until none can be contracted",
        (GREEN, Mark::Up),
        (1.0e-6, 120.0),
        [0.0; 3],
    ),
];

const fn row(
    [name, label]: [&'static str; 2],
    meaning: &'static str,
    (colour, mark): ([u8; 3], Mark),
    (seconds, bytes): (f64, f64),
    unpaired: [f64; 3],
) -> AlgorithmFacts {
    let look = Look { colour, mark };
    AlgorithmFacts { name, label, meaning, look, seconds, bytes, unpaired }
}

impl AlgorithmFacts {
    /// Returns the facts of the algorithm of that name, if it has a row.
    pub fn named(name: &str) -> Option<&'static Self> {
        ALGORITHMS.iter().find(|facts| facts.name == name)
    }

    /// Returns the row of a program or algorithm that is not ours, the same for the same name.
    ///
    /// There are as few as there are names, and they stay for the life of the process.
    pub fn other(name: &str) -> &'static Self {
        static OTHERS: Mutex<Vec<&AlgorithmFacts>> = Mutex::new(Vec::new());
        let mut others = OTHERS.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = others.iter().find(|facts| facts.name == name) {
            return known;
        }
        let name: &'static str = Box::leak(name.into());
        let facts: &'static Self = Box::leak(Box::new(row(
            [name, name],
            "not of triquad",
            look_of(name),
            // Nothing is estimated for it.
            (0.0, 0.0),
            [0.0; 3],
        )));
        others.push(facts);
        facts
    }

    /// Returns every row of ours, in the order of tables and plots.
    pub fn all() -> &'static [Self] {
        ALGORITHMS
    }

    /// Returns the row's number, from 0; those that are not ours share the number after the last.
    pub fn rank(&self) -> usize {
        ALGORITHMS.iter().position(|facts| facts.name == self.name).unwrap_or(ALGORITHMS.len())
    }
}

/// Returns colour and mark of a name that is not ours. They depend on the name alone.
fn look_of(name: &str) -> ([u8; 3], Mark) {
    const COLOURS: [[u8; 3]; 4] = [GREY, PURPLE, SKY, ORANGE];
    const MARKS: [Mark; 3] = [Mark::Cross, Mark::Down, Mark::Up];
    let sum = name.bytes().fold(0_usize, |sum, byte| sum.wrapping_mul(31) + usize::from(byte));
    (COLOURS[sum % COLOURS.len()], MARKS[sum % MARKS.len()])
}

#[cfg(test)]
mod tests {
    use triquad::pairing::Algorithm;

    use super::*;

    #[test]
    fn looks_that_are_wanted_twice_differ_by_their_marks() {
        let look = |colour, mark| Look { colour, mark };
        let [square, up] = [look(BLUE, Mark::Square), look(BLUE, Mark::Up)];
        let looks = Look::distinct(&[square, square, up, square]);
        assert_eq!(looks, [square, look(BLUE, Mark::Down), up, look(BLUE, Mark::Diamond)]);
        // More than there are marks.
        let looks = Look::distinct(&[square; 8]);
        assert!((1..8).all(|at| !looks[..at].contains(&looks[at])), "{looks:?}");
        assert!(looks[..6].iter().all(|look| look.colour == BLUE));
    }

    #[test]
    fn a_meaning_says_perfect_of_exactly_those_that_leave_no_triangle() {
        for algorithm in Algorithm::ALL {
            let facts = AlgorithmFacts::named(algorithm.id()).expect("a row for each");
            let says = facts.meaning.contains("perfect pairing");
            assert_eq!(says, facts.unpaired == [0.0; 3], "{}", facts.meaning);
        }
    }
}
