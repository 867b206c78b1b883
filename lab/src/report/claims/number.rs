//! The numbers of a run that claims speak of, by name.

use crate::experiment::RunRecord;
use crate::report::path_price::PathPrice;

/// Takes a number from a row at a price of an augmenting path.
pub type AtPrice = fn(PathPrice, &RunRecord) -> Option<f64>;

/// A number that runs have.
#[derive(Debug)]
pub struct Number {
    /// Its name, that of the column of `runs.csv`; but `augmentation_seconds` and `total_seconds`
    /// are extrapolated where the augmentation was stopped.
    pub name: &'static str,
    /// True if it depends on the machine.
    pub is_time: bool,
    /// Takes it at a price of an augmenting path; `None` where no path is in it.
    pub at_price: Option<AtPrice>,
    /// Takes it from a row.
    pub of: fn(&RunRecord) -> Option<f64>,
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// A number of a row that no machine changes.
const fn untimed(name: &'static str, of: fn(&RunRecord) -> Option<f64>) -> Number {
    Number { name, is_time: false, at_price: None, of }
}

/// A time of a row, without augmenting paths.
const fn time(name: &'static str, of: fn(&RunRecord) -> Option<f64>) -> Number {
    Number { name, is_time: true, at_price: None, of }
}

/// A count of a row.
macro_rules! count {
    ($name:ident) => {
        untimed(stringify!($name), |run| run.measured.$name.map(|count| count as f64))
    };
}

/// All of them.
static NUMBERS: [Number; 20] = [
    count!(vertices),
    count!(edges),
    count!(triangles),
    count!(genus),
    count!(unpaired_triangles),
    untimed("paired_percent", |run| run.measured.paired_percent),
    count!(edge_flips),
    count!(augmenting_paths),
    untimed("augmenting_path_length_mean", |run| run.measured.augmenting_path_length_mean),
    count!(augmentation_triangles_visited),
    count!(link_condition_tests),
    count!(edges_tested_more_than_once),
    count!(link_vertices_visited),
    count!(degree_products),
    count!(result_vertices),
    count!(peak_memory_bytes),
    time("pairing_seconds", |run| run.measured.pairing_seconds),
    Number {
        at_price: Some(PathPrice::augmentation_seconds),
        ..time("augmentation_seconds", RunRecord::whole_augmentation_seconds)
    },
    Number {
        at_price: Some(PathPrice::total_seconds),
        ..time("total_seconds", RunRecord::whole_total_seconds)
    },
    time("seconds", |run| run.measured.seconds),
];

impl Number {
    /// Returns the number of that name.
    pub fn named(name: &str) -> Option<&'static Self> {
        NUMBERS.iter().find(|number| number.name == name)
    }
}
