//! Records by what they repeat: one cell for each mesh, algorithm and way of running it.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::statistics::Statistics;
use crate::experiment::results::Planned;
use crate::experiment::{Outcome, Results, RunRecord};
use crate::meshes::paper;

/// Everything of one way of running one algorithm on one mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cell {
    /// Name of the experiment file.
    pub experiment: String,
    /// `full`, `small` or `demo`.
    pub scale: String,
    /// Group of meshes within the experiment.
    pub group: String,
    /// Name of the mesh.
    pub mesh: String,
    /// `real`, `generated`, `simplified` or `stand-in`; empty where no run of the mesh has a row.
    pub mesh_kind: String,
    /// `sg ps ds gw lrs tq`, or `rs schipper brute-force`.
    pub algorithm: String,
    /// For `lrs`: `printed` or `few-flips`.
    pub lrs_variant: Option<String>,
    /// For conversions: `tarjan` or `local`.
    pub augmentation: Option<String>,
    /// For irreducible triangulations: `file` or `random`.
    pub order: Option<String>,
    /// Repetitions that the plan asks for; 0 where no plan names the cell.
    pub repetitions_planned: u32,
    /// The rows there are, by repetition, whatever their outcome.
    pub runs: Vec<RunRecord>,
}

/// The cells of a results folder, planned or run, in the order of the papers.
///
/// By experiment, scale (largest first), group, mesh (as in the papers' tables, then by triangles and
/// name), algorithm (those of the papers first) and variant, augmentation (`tarjan` first) or order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    cells: Vec<Cell>,
}

/// What tells cells apart: experiment, scale, group, mesh, algorithm, variant, augmentation, order.
type Key = [String; 8];

impl Summary {
    /// Sorts the records and the plan of `results` into cells. O(n log n).
    pub fn of(results: &Results) -> Self {
        let mut cells = BTreeMap::<Key, Cell>::new();
        for planned in &results.planned {
            let cell = Cell::of_plan(planned);
            // A plan that was split over machines may name a cell more than once.
            let planned_so_far = &mut cells.entry(cell.key()).or_insert(cell).repetitions_planned;
            *planned_so_far = planned.repetitions.max(*planned_so_far);
        }
        for record in &results.records {
            let cell = Cell::of_record(record);
            cells.entry(cell.key()).or_insert(cell).runs.push(record.clone());
        }
        let mut cells: Vec<Cell> = cells.into_values().collect();
        for cell in &mut cells {
            cell.runs.sort_by_key(|run| run.repetition);
        }
        tell_kinds_and_sort(&mut cells);
        Self { cells }
    }

    /// All cells, in order.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// The cell of an algorithm on a mesh; of several scales, the largest. O(cells).
    ///
    /// `variant` is `None` for all but `lrs`, whose `None` is `printed`; `how` is the augmentation of
    /// a conversion or the order of an irreducible triangulation.
    pub fn cell(
        &self,
        experiment: &str,
        mesh: &str,
        algorithm: &str,
        variant: Option<&str>,
        how: &str,
    ) -> Option<&Cell> {
        let variant = variant.or((algorithm == "lrs").then_some("printed"));
        self.cells.iter().find(|cell| {
            cell.experiment == experiment
                && cell.mesh == mesh
                && cell.algorithm == algorithm
                && cell.lrs_variant.as_deref() == variant
                && cell.how() == how
        })
    }

    /// The cells of an experiment, and of one of its groups if that is named.
    pub fn of_group<'a>(
        &'a self,
        experiment: &'a str,
        group: Option<&'a str>,
    ) -> impl Iterator<Item = &'a Cell> {
        self.cells.iter().filter(move |cell| {
            cell.experiment == experiment && group.is_none_or(|group| cell.group == group)
        })
    }

    /// Whether some row was run beside others on the same machine, so that times are not ranked.
    pub fn is_parallel(&self) -> bool {
        self.cells.iter().any(Cell::is_parallel)
    }
}

impl Cell {
    fn of_plan(planned: &Planned) -> Self {
        Self {
            experiment: planned.experiment.clone(),
            scale: planned.scale.clone(),
            group: planned.group.clone(),
            mesh: planned.mesh.clone(),
            algorithm: planned.algorithm.clone(),
            lrs_variant: planned.lrs_variant.clone(),
            augmentation: planned.augmentation.clone(),
            order: planned.order.clone(),
            ..Self::default()
        }
    }

    fn of_record(record: &RunRecord) -> Self {
        Self {
            experiment: record.experiment.clone(),
            scale: record.scale.clone(),
            group: record.group.clone(),
            mesh: record.mesh.clone(),
            algorithm: record.algorithm.clone(),
            lrs_variant: record.lrs_variant.clone(),
            augmentation: record.augmentation.clone(),
            order: record.order.clone(),
            ..Self::default()
        }
    }

    fn key(&self) -> Key {
        let or_nothing = |name: &Option<String>| name.clone().unwrap_or_default();
        [
            self.experiment.clone(),
            self.scale.clone(),
            self.group.clone(),
            self.mesh.clone(),
            self.algorithm.clone(),
            or_nothing(&self.lrs_variant),
            or_nothing(&self.augmentation),
            or_nothing(&self.order),
        ]
    }

    /// The augmentation of a conversion, or the order of an irreducible triangulation.
    pub fn how(&self) -> &str {
        self.augmentation.as_deref().or(self.order.as_deref()).unwrap_or_default()
    }

    /// What the papers call the algorithm, with what is not as the papers have it: `PS`, `LRS`,
    /// `LRS few-flips`, `PS local`, `RS random`.
    pub fn label(&self) -> String {
        let name = match self.algorithm.as_str() {
            "schipper" => "S".into(),
            "brute-force" => "BF".into(),
            other => other.to_uppercase(),
        };
        let variant = self.lrs_variant.as_deref().filter(|&variant| variant != "printed");
        let how = Some(self.how()).filter(|how| !["", "tarjan", "file"].contains(how));
        [Some(name.as_str()), variant, how].into_iter().flatten().collect::<Vec<_>>().join(" ")
    }

    /// The runs that ended well.
    pub fn ok_runs(&self) -> impl Iterator<Item = &RunRecord> {
        self.runs.iter().filter(|run| run.is_ok())
    }

    /// Describes a number of the runs that ended well; `None` where none has it, as a finite number.
    pub fn statistics(&self, number: impl Fn(&RunRecord) -> Option<f64>) -> Option<Statistics> {
        let values: Vec<f64> =
            self.ok_runs().filter_map(number).filter(|value| value.is_finite()).collect();
        Statistics::of(&values)
    }

    /// The mean of a number over the runs that ended well.
    pub fn mean(&self, number: impl Fn(&RunRecord) -> Option<f64>) -> Option<f64> {
        self.statistics(number).map(|statistics| statistics.mean)
    }

    /// A count that belongs to the mesh: that of the first run that has it.
    pub fn count(&self, number: impl Fn(&RunRecord) -> Option<u64>) -> Option<u64> {
        self.runs.iter().find_map(number)
    }

    /// How the runs ended, in words: `ok 8, timeout 1, missing 1`.
    pub fn outcome_text(&self) -> String {
        let ended = OUTCOMES.iter().map(|&(outcome, name)| {
            (name, self.runs.iter().filter(|run| run.outcome == outcome).count())
        });
        let parts = ended.chain([("missing", self.missing())]).filter(|(_, runs)| *runs > 0);
        parts.map(|(name, runs)| format!("{name} {runs}")).collect::<Vec<_>>().join(", ")
    }

    /// Planned repetitions without a row.
    pub fn missing(&self) -> usize {
        (self.repetitions_planned as usize).saturating_sub(self.runs.len())
    }

    /// Whether the augmentation of some run was stopped, so that its times are extrapolated.
    pub fn is_extrapolated(&self) -> bool {
        self.ok_runs().any(RunRecord::is_extrapolated)
    }

    /// Whether some run was beside others on the same machine.
    pub fn is_parallel(&self) -> bool {
        self.runs.iter().any(|run| run.parallel_jobs > 1)
    }

    /// Whether the mesh stands for one that was not at hand.
    pub fn is_stand_in(&self) -> bool {
        self.mesh_kind == "stand-in"
    }
}

/// How runs may end, in the order in which they are told, and the words of records for it.
const OUTCOMES: [(Outcome, &str); 6] = [
    (Outcome::Ok, "ok"),
    (Outcome::Timeout, "timeout"),
    (Outcome::OutOfMemory, "out-of-memory"),
    (Outcome::Crash, "crash"),
    (Outcome::Invalid, "invalid"),
    (Outcome::Skipped, "skipped"),
];

/// Takes the kind and size of a mesh from whatever run knows them, and puts the cells in order.
fn tell_kinds_and_sort(cells: &mut [Cell]) {
    type Mesh = [String; 3];
    let mesh = |cell: &Cell| [cell.experiment.clone(), cell.scale.clone(), cell.mesh.clone()];
    let mut known = BTreeMap::<Mesh, (String, u64)>::new();
    for cell in cells.iter() {
        let (kind, triangles) = known.entry(mesh(cell)).or_default();
        for run in &cell.runs {
            if kind.is_empty() {
                kind.clone_from(&run.mesh_kind);
            }
            *triangles = (*triangles).max(run.triangles.unwrap_or(0));
        }
    }
    for cell in cells.iter_mut() {
        cell.mesh_kind.clone_from(&known[&mesh(cell)].0);
    }
    cells.sort_by_cached_key(|cell| {
        let triangles = known[&mesh(cell)].1;
        (
            (rank(&["comparison", "irreducible"], &cell.experiment), cell.experiment.clone()),
            rank(&["full", "small", "demo"], &cell.scale),
            (rank(&["scans", "A", "B", "C", "D", "data"], &cell.group), cell.group.clone()),
            (mesh_rank(&cell.mesh), triangles, cell.mesh.clone()),
            rank(&ALGORITHMS, &cell.algorithm),
            Reverse(cell.lrs_variant.clone()),
            Reverse(cell.augmentation.clone()),
            cell.order.clone(),
        )
    });
}

/// Algorithms in the order of the papers' tables, then ours.
const ALGORITHMS: [&str; 9] =
    ["sg", "ps", "ds", "lrs", "gw", "tq", "rs", "schipper", "brute-force"];

/// The place of `name` in `order`; after all of them if it has none.
fn rank(order: &[&str], name: &str) -> usize {
    order.iter().position(|&other| other == name).unwrap_or(order.len())
}

/// The place of a mesh in the papers' tables.
fn mesh_rank(name: &str) -> usize {
    paper::ALL.iter().position(|mesh| mesh.name == name).unwrap_or(paper::ALL.len())
}
