//! The numbers of a run that claims speak of, by name.

use crate::experiment::RunRecord;

/// A number that runs have.
#[derive(Debug)]
pub struct Number {
    /// Its name, that of the column of `runs.csv`; but `augmentation_seconds` and `total_seconds`
    /// are extrapolated where the augmentation was stopped.
    pub name: &'static str,
    /// True if it depends on the machine.
    pub is_time: bool,
    /// Takes it from a row.
    pub of: fn(&RunRecord) -> Option<f64>,
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// A count of a row.
macro_rules! count {
    ($name:ident) => {
        Number {
            name: stringify!($name),
            is_time: false,
            of: |run| run.measured.$name.map(|count| count as f64),
        }
    };
}

/// A time of a row.
macro_rules! time {
    ($name:ident, $of:expr) => {
        Number { name: stringify!($name), is_time: true, of: $of }
    };
}

/// All of them.
static NUMBERS: [Number; 20] = [
    count!(vertices),
    count!(edges),
    count!(triangles),
    count!(genus),
    count!(unpaired_triangles),
    Number { name: "paired_percent", is_time: false, of: |run| run.measured.paired_percent },
    count!(edge_flips),
    count!(augmenting_paths),
    Number {
        name: "augmenting_path_length_mean",
        is_time: false,
        of: |run| run.measured.augmenting_path_length_mean,
    },
    count!(augmentation_triangles_visited),
    count!(link_condition_tests),
    count!(edges_tested_more_than_once),
    count!(link_vertices_visited),
    count!(degree_products),
    count!(result_vertices),
    count!(peak_memory_bytes),
    time!(pairing_seconds, |run| run.measured.pairing_seconds),
    time!(augmentation_seconds, RunRecord::whole_augmentation_seconds),
    time!(total_seconds, RunRecord::whole_total_seconds),
    time!(seconds, |run| run.measured.seconds),
];

impl Number {
    /// Returns the number of that name.
    pub fn named(name: &str) -> Option<&'static Self> {
        NUMBERS.iter().find(|number| number.name == name)
    }
}
