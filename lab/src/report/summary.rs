//! Records by what they repeat: one cell for each mesh and job.

use std::cmp::Reverse;
use std::collections::HashMap;

use super::statistics::Statistics;
use crate::experiment::import::machine_name;
use crate::experiment::{Job, Measured, MeshId, Outcome, Results, RunId, RunRecord};
use crate::meshes::paper::Scale;
use crate::meshes::{self, Origin};
use crate::paper::Paper;

/// All repetitions of one job on one mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The job that is repeated.
    pub id: RunId,
    /// Group of the mesh in the tables of the paper, whatever the experiment file calls it; `data`
    /// for a mesh that the paper does not have.
    pub group: &'static str,
    /// Origin of the mesh; `None` where no run of the mesh has a row.
    pub origin: Option<Origin>,
    /// Planned repetitions; 0 where no plan names the cell.
    pub repetitions_planned: u32,
    /// The rows, by repetition, whatever their outcome.
    pub runs: Vec<RunRecord>,
}

/// The cells of a results folder, planned or run, in the order of the papers.
///
/// By experiment, scale (largest first), group, mesh (as in the papers' tables, then by triangles
/// and name), algorithm (those of the papers first), augmentation (`tarjan` first) or order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    cells: Vec<Cell>,
}

impl Summary {
    /// Sorts the records and the plan of `results` into cells. O(n log n).
    pub fn new(results: &Results) -> Self {
        let mut cells = HashMap::<&RunId, Cell>::new();
        for planned in &results.planned {
            let cell = cells.entry(&planned.id).or_insert_with(|| Cell::new(&planned.id));
            // A plan that was split over machines may name a cell more than once.
            cell.repetitions_planned = cell.repetitions_planned.max(planned.repetitions);
        }
        for record in &results.records {
            let cell = cells.entry(&record.id).or_insert_with(|| Cell::new(&record.id));
            cell.runs.push(record.clone());
        }
        let mut cells: Vec<Cell> = cells.into_values().collect();
        let mut groups = HashMap::new();
        for cell in &mut cells {
            cell.runs.sort_by_key(|run| run.repetition);
            let (paper, mesh) = (Paper::on(cell.id.job.task()), cell.id.mesh.name.clone());
            let place = (paper.task(), mesh);
            cell.group = groups.entry(place).or_insert_with_key(|(_, mesh)| paper.group_of(mesh));
        }
        set_origins_and_sort(&mut cells);
        Self { cells }
    }

    /// Returns all cells, in order.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// Returns the cell of a job on a mesh of a paper; of several scales, the largest. O(cells).
    pub fn cell(&self, paper: Paper, mesh: &str, job: Job) -> Option<&Cell> {
        self.of_mesh(paper, mesh).find(|cell| cell.id.job == job)
    }

    /// Returns the cells of a mesh of a paper. O(cells).
    pub fn of_mesh<'n>(
        &self,
        paper: Paper,
        mesh: &'n str,
    ) -> impl Iterator<Item = &Cell> + use<'_, 'n> {
        self.of_paper(paper).filter(move |cell| cell.id.mesh.name == mesh)
    }

    /// Returns whether something is planned or done on a mesh of a paper. O(cells).
    pub fn has_mesh(&self, paper: Paper, mesh: &str) -> bool {
        self.of_mesh(paper, mesh).next().is_some()
    }

    /// Returns the cells whose jobs do what the algorithms of a paper do. O(cells).
    pub fn of_paper(&self, paper: Paper) -> impl Iterator<Item = &Cell> {
        self.cells.iter().filter(move |cell| cell.id.job.task() == paper.task())
    }

    /// Returns a cell on each mesh of a paper, once even if several experiments or groups have runs
    /// on it. O(cells · meshes).
    pub fn meshes(&self, paper: Paper) -> Vec<&Cell> {
        let mut meshes: Vec<&Cell> = Vec::new();
        for cell in self.of_paper(paper) {
            if meshes.iter().all(|seen| seen.mesh() != cell.mesh()) {
                meshes.push(cell);
            }
        }
        meshes
    }

    /// Returns the programs and algorithms that are not ours, as they stand in tables. O(cells).
    pub fn programs(&self, paper: Paper) -> Vec<Job> {
        let mut programs: Vec<Job> =
            self.of_paper(paper).map(|cell| cell.id.job).filter(|job| job.is_program()).collect();
        programs.sort_by_key(|job| job.label());
        programs.dedup();
        programs
    }

    /// Returns the cells on meshes on which some result was measured from its file, also those
    /// whose program is not installed. O(cells).
    pub fn measured_from_files(&self, paper: Paper) -> Vec<&Cell> {
        let cells: Vec<&Cell> = self.of_paper(paper).collect();
        let is_measured =
            |cell: &&Cell| cell.runs.iter().any(|run| run.measured.quality_one_percent.is_some());
        let on_mesh = cells.chunk_by(|one, other| one.id.mesh == other.id.mesh);
        on_mesh.filter(|cells| cells.iter().any(is_measured)).flatten().copied().collect()
    }

    /// Returns the cells on the meshes of a group of a paper. O(cells).
    pub fn of_group<'n>(
        &self,
        paper: Paper,
        group: &'n str,
    ) -> impl Iterator<Item = &Cell> + use<'_, 'n> {
        self.of_paper(paper).filter(move |cell| cell.group == group)
    }

    /// Returns whether there are results, and none belongs to the papers' experiments. O(cells).
    pub fn is_own(&self) -> bool {
        !self.cells.is_empty() && !self.cells.iter().any(Cell::is_of_paper)
    }

    /// Returns whether some row was run beside others on the same machine: times are not ranked.
    pub fn is_parallel(&self) -> bool {
        self.cells.iter().any(Cell::is_parallel)
    }
}

impl Cell {
    fn new(id: &RunId) -> Self {
        let (id, runs) = (id.clone(), Vec::new());
        Self { id, group: "", origin: None, repetitions_planned: 0, runs }
    }

    /// Returns the name of its mesh.
    pub fn mesh(&self) -> &str {
        &self.id.mesh.name
    }

    /// Returns the name of its mesh, marked if it is a stand-in.
    pub fn marked_mesh(&self) -> String {
        format!("{}{}", self.mesh(), self.origin.map_or("", Origin::dagger))
    }

    /// Returns whether a paper has the experiment and the mesh, and the algorithm is ours.
    fn is_of_paper(&self) -> bool {
        let paper = Paper::on(self.id.job.task());
        self.id.mesh.experiment == paper.experiment()
            && self.group != "data"
            && !self.id.job.is_program()
            && !self.was_imported()
    }

    /// Returns whether somebody else measured its runs.
    pub fn was_imported(&self) -> bool {
        let source = machine_name(self.id.job.facts().name);
        self.runs.iter().any(|run| run.machine == source)
    }

    /// Returns the label of its job: `PS`, `LRS few-flips`, `PS local`, `RS random`.
    pub fn label(&self) -> String {
        self.id.job.label()
    }

    /// Returns the runs that ended well.
    pub fn ok_runs(&self) -> impl Iterator<Item = &RunRecord> {
        self.runs.iter().filter(|run| run.is_ok())
    }

    /// Describes a number of the runs that ended well; `None` where none has it, as a finite
    /// number.
    pub fn statistics(&self, number: impl Fn(&RunRecord) -> Option<f64>) -> Option<Statistics> {
        Statistics::from_values(&self.sample(number))
    }

    /// Returns a number of each run that ended well and has it, as a finite number.
    pub fn sample(&self, number: impl Fn(&RunRecord) -> Option<f64>) -> Vec<f64> {
        self.ok_runs().filter_map(number).filter(|value| value.is_finite()).collect()
    }

    /// Returns the mean of a number over the runs that ended well.
    pub fn mean(&self, number: impl Fn(&RunRecord) -> Option<f64>) -> Option<f64> {
        self.statistics(number).map(|statistics| statistics.mean)
    }

    /// Returns the mean of a count over the runs that ended well.
    pub fn mean_count(&self, count: impl Fn(&Measured) -> Option<u64>) -> Option<f64> {
        self.mean(|run| count(&run.measured).map(|count| count as f64))
    }

    /// Returns a count that belongs to the mesh: that of the first run that has it.
    pub fn count(&self, count: impl Fn(&Measured) -> Option<u64>) -> Option<u64> {
        self.runs.iter().find_map(|run| count(&run.measured))
    }

    /// Returns how the runs ended, in words: `ok 8, timeout 1, missing 1`.
    pub fn outcome_text(&self) -> String {
        let ended = Outcome::ALL.iter().map(|&outcome| {
            (outcome.id(), self.runs.iter().filter(|run| run.outcome == outcome).count())
        });
        let parts = ended.chain([("missing", self.missing())]).filter(|(_, runs)| *runs > 0);
        parts.map(|(name, runs)| format!("{name} {runs}")).collect::<Vec<_>>().join(", ")
    }

    /// Returns the number of planned repetitions without a row.
    pub fn missing(&self) -> usize {
        (self.repetitions_planned as usize).saturating_sub(self.runs.len())
    }

    /// Returns whether the augmentation of some run was stopped, so that its times are
    /// extrapolated.
    pub fn is_extrapolated(&self) -> bool {
        self.ok_runs().any(RunRecord::is_extrapolated)
    }

    /// Returns whether some run was beside others on the same machine.
    pub fn is_parallel(&self) -> bool {
        self.runs.iter().any(|run| run.parallel_jobs > 1)
    }

    /// Returns whether its time is that of a whole process that is not ours.
    pub fn has_wall_clock_times(&self) -> bool {
        let is_whole = |run: &RunRecord| {
            let own = [run.measured.total_seconds, run.measured.seconds];
            run.process_seconds.is_some_and(|wall| wall > 0.0) && own.contains(&run.process_seconds)
        };
        self.id.job.is_program() && self.ok_runs().any(is_whole)
    }

    /// Returns whether the mesh stands for one that was not at hand.
    pub fn is_stand_in(&self) -> bool {
        self.origin == Some(Origin::StandIn)
    }

    /// Returns whether the mesh has the paper's size.
    pub fn is_full_scale(&self) -> bool {
        self.id.mesh.scale == Scale::Full
    }

    /// Returns the scale of a mesh that was made smaller than the paper's; files keep their size.
    pub fn smaller_scale(&self) -> Option<Scale> {
        let is_file = self.origin.is_some_and(Origin::is_file);
        (!self.is_full_scale() && !is_file).then_some(self.id.mesh.scale)
    }
}

/// Takes the origin of a cell from its own runs; else, as its size, from other runs on the mesh,
/// ours before imported ones. Sorts the cells.
fn set_origins_and_sort(cells: &mut [Cell]) {
    let mesh = |MeshId { experiment, scale, name, .. }: &MeshId| {
        (experiment.clone(), *scale, name.clone())
    };
    let mut known = HashMap::<_, (Option<Origin>, u64)>::new();
    let origin_of = |run: &RunRecord| Origin::of(run.mesh_kind, &run.mesh_sha256);
    let (imported, ours): (Vec<&Cell>, Vec<&Cell>) =
        cells.iter().partition(|cell| cell.was_imported());
    for cell in ours.into_iter().chain(imported) {
        let (origin, triangles) = known.entry(mesh(&cell.id.mesh)).or_default();
        for run in &cell.runs {
            origin.get_or_insert_with(|| origin_of(run));
            *triangles = (*triangles).max(run.measured.triangles.unwrap_or(0));
        }
    }
    for cell in cells.iter_mut() {
        cell.origin = cell.runs.first().map(origin_of).or(known[&mesh(&cell.id.mesh)].0);
    }
    cells.sort_by_cached_key(|cell| {
        let RunId { mesh: id, job } = &cell.id;
        let papers = [Paper::Comparison, Paper::Irreducible].map(Paper::experiment);
        let name = |name: &String| name.clone();
        (
            (rank(&papers, &id.experiment), name(&id.experiment)),
            id.scale,
            rank(&["scans", "A", "B", "C", "D", "data"], cell.group),
            (mesh_rank(&id.name), known[&mesh(id)].1, name(&id.name)),
            name(&id.group),
            (job.facts().rank(), job.facts().name),
            Reverse(job.names().augmentation),
            job.names().order,
        )
    });
}

/// Returns the place of `name` in `order`; after all of them if it has none.
fn rank(order: &[&str], name: &str) -> usize {
    order.iter().position(|&other| other == name).unwrap_or(order.len())
}

/// Returns the place of a mesh in the papers' tables.
fn mesh_rank(name: &str) -> usize {
    let meshes = meshes::paper::ALL;
    meshes.iter().position(|mesh| mesh.name == name).unwrap_or(meshes.len())
}
