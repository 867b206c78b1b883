//! From experiment files to their runs, in the order in which they are executed.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::data_folder::DataMesh;
use super::job::Job;
use super::planned_mesh::{PlannedMesh, PlannedMeshError, Source};
use super::program_spec::ProgramSpec;
use super::results::Planned;
use super::run_id::{MeshId, RunId};
use super::spec::{Experiment, Limits, MeshGroup, RunSpec};
use crate::algorithms::AlgorithmFacts;
use crate::meshes::paper::{self, Scale};
use crate::nearest::slip_of;
use triquad::random::Random;

/// The runs to do, block by block.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Size of the meshes.
    pub scale: Scale,
    /// The blocks. What is compared is in one block, so that it runs together on one machine.
    pub blocks: Vec<Block>,
    /// The meshes whose quads are drawn.
    pub pictured: Vec<Pictured>,
    /// Remarks on the meshes of the data folders.
    pub remarks: Vec<String>,
}

/// A mesh whose quads are drawn.
#[derive(Clone, Debug)]
pub struct Pictured {
    /// The mesh.
    pub mesh: PlannedMesh,
    /// Our algorithms that the experiment runs on it.
    pub algorithms: Vec<&'static AlgorithmFacts>,
}

/// One mesh, one repetition, all its algorithms in a seeded random order.
#[derive(Clone, Debug)]
pub struct Block {
    /// The mesh in its experiment and group.
    pub id: MeshId,
    /// Origin of the mesh.
    pub mesh: PlannedMesh,
    /// Repetition, from 0.
    pub repetition: u32,
    /// When a run is stopped.
    pub limits: Limits,
    /// True if our algorithms leave files, from which they are measured.
    pub measured_from_files: bool,
    /// The jobs.
    pub runs: Vec<PlannedRun>,
    /// The programs of the experiment that are not ours.
    pub programs: Arc<[ProgramSpec]>,
}

/// One run of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlannedRun {
    /// Its job.
    pub job: Job,
    /// Its seed: equal for equal experiment, mesh, algorithm and repetition.
    pub seed: u64,
    /// Repetitions of this job on this mesh in all.
    pub repetitions: u32,
    /// Augmenting paths after which it stops.
    pub stop_after_paths: Option<u64>,
}

impl Plan {
    /// Plans the runs of `experiments`, on the meshes of `data` where a name fits.
    ///
    /// Meshes of a group are in ascending size, so that slow algorithms time out on the smaller
    /// ones.
    ///
    /// # Errors
    /// A mesh is unknown.
    pub fn new(
        experiments: &[Experiment],
        scale: Scale,
        data: &[DataMesh],
    ) -> Result<Self, PlannedMeshError> {
        let mut plan =
            Self { scale, blocks: Vec::new(), pictured: Vec::new(), remarks: Vec::new() };
        let groups = experiments.iter().flat_map(|experiment| &experiment.groups);
        let named: Vec<&String> = groups.flat_map(|group| &group.meshes).collect();
        for experiment in experiments {
            plan.remarks.extend(experiment.remarks.iter().cloned());
            for group in &experiment.groups {
                plan.add_group(experiment, group, data, &named)?;
            }
            if let Some(name) = &experiment.pictures {
                let pictured = plan.pictured(experiment, name);
                plan.pictured.push(pictured.ok_or_else(|| not_run(experiment, name))?);
            }
        }
        plan.remark_unused(data);
        // Two experiments may make the same remark.
        let mut said = BTreeSet::new();
        plan.remarks.retain(|remark| said.insert(remark.clone()));
        Ok(plan)
    }

    /// Returns the mesh of that name with the algorithms that `experiment` runs on it.
    fn pictured(&self, experiment: &Experiment, name: &str) -> Option<Pictured> {
        let of_mesh = self.blocks.iter().filter(|block| block.mesh.name == name);
        let mesh = of_mesh.clone().next()?.mesh.clone();
        let own = of_mesh.filter(|block| block.id.experiment == experiment.name);
        let jobs: Vec<Job> = own.flat_map(|block| &block.runs).map(|run| run.job).collect();
        let is_run = |facts: &&AlgorithmFacts| {
            let is_it = |job: &Job| job.facts().name == facts.name;
            jobs.iter().any(|job| matches!(job, Job::Convert { .. }) && is_it(job))
        };
        Some(Pictured { mesh, algorithms: AlgorithmFacts::all().iter().filter(is_run).collect() })
    }

    fn add_group(
        &mut self,
        experiment: &Experiment,
        group: &MeshGroup,
        data: &[DataMesh],
        named: &[&String],
    ) -> Result<(), PlannedMeshError> {
        let mut meshes = Vec::new();
        for name in &group.meshes {
            let mesh = self.find_mesh(name, data);
            meshes.push(mesh.ok_or_else(|| unknown(experiment, name, data))?);
        }
        for path in &group.files {
            meshes.push(PlannedMesh::of_file(path, || experiment.place_of_file(path))?);
        }
        if group.other_data && self.scale == Scale::Full {
            let own: Vec<String> = meshes.iter().map(|mesh| mesh.name.clone()).collect();
            let others = self.other_data(data, named).into_iter();
            meshes.extend(others.filter(|mesh| !own.contains(&mesh.name)));
        }
        for (place, mesh) in meshes.iter().enumerate() {
            if let Some(other) = meshes[..place].iter().find(|other| other.name == mesh.name) {
                return Err(twice(experiment, group, [other, mesh]));
            }
        }
        meshes.sort_by_key(|mesh| mesh.triangles);
        for mesh in meshes {
            self.add_mesh(experiment, group, &mesh);
        }
        Ok(())
    }

    fn find_mesh(&mut self, name: &str, data: &[DataMesh]) -> Option<PlannedMesh> {
        let Some(paper) = paper::named(name) else {
            return data.iter().find(|mesh| mesh.name == name).map(PlannedMesh::real);
        };
        if self.scale == Scale::Full {
            for mesh in data.iter().filter(|mesh| mesh.is_called(name)) {
                if mesh.has_counts_of(&paper) {
                    return Some(PlannedMesh { name: name.into(), ..PlannedMesh::real(mesh) });
                }
                self.remarks.push(format!(
                    "{} is not the {name} of the papers ({} vertices, genus {}, instead of {}, {})",
                    mesh.path.display(),
                    mesh.vertices,
                    mesh.genus,
                    paper.vertices,
                    paper.genus,
                ));
            }
        }
        Some(PlannedMesh::made(paper, self.scale))
    }

    /// Remarks which meshes of `data` nothing is run on.
    fn remark_unused(&mut self, data: &[DataMesh]) {
        let is_used = |mesh: &DataMesh| {
            let own = |block: &Block| matches!(&block.mesh.source, Source::File(path, _) if *path == mesh.path);
            self.blocks.iter().any(own)
        };
        let unused = data.iter().filter(|mesh| mesh.problem.is_none() && !is_used(mesh));
        let unused: Vec<String> = unused.map(|mesh| mesh.path.display().to_string()).collect();
        if unused.is_empty() {
            return;
        }
        let why = match self.scale {
            Scale::Full => "no group of the experiments names them or has other_data",
            _ => "the papers' scans and other_data are taken from folders at scale full only",
        };
        self.remarks.push(format!("--data: not used: {}; {why}", unused.join(", ")));
    }

    /// Returns the meshes of `data` that are none of the papers' meshes `named`.
    fn other_data(&mut self, data: &[DataMesh], named: &[&String]) -> Vec<PlannedMesh> {
        let is_named = |mesh: &DataMesh| {
            let papers =
                paper::ALL.iter().filter(|paper| named.iter().any(|&name| name == paper.name));
            papers.into_iter().any(|paper| mesh.is_called(paper.name) && mesh.has_counts_of(paper))
        };
        let mut meshes = Vec::new();
        for mesh in data.iter().filter(|&mesh| !is_named(mesh)) {
            match &mesh.problem {
                None => meshes.push(PlannedMesh::real(mesh)),
                Some(problem) => {
                    self.remarks.push(format!("{} is left out: {problem}", mesh.path.display()));
                }
            }
        }
        meshes
    }

    fn add_mesh(&mut self, experiment: &Experiment, group: &MeshGroup, mesh: &PlannedMesh) {
        let repetitions = |run: &RunSpec| run.repetitions(&mesh.name, self.scale);
        let most = group.runs.iter().map(repetitions).max().unwrap_or(0);
        for repetition in 0..most {
            let mut runs = Vec::new();
            for run in group.runs.iter().filter(|run| repetition < repetitions(run)) {
                let jobs = run
                    .jobs(experiment.task, &experiment.programs)
                    .expect("the file has been checked");
                runs.extend(jobs.into_iter().map(|job| PlannedRun {
                    job,
                    seed: seed(experiment, mesh, job, repetition),
                    repetitions: repetitions(run),
                    stop_after_paths: run.stop_after_paths(&mesh.name, self.scale),
                }));
            }
            let words = ["order", &experiment.name, &mesh.name, &repetition.to_string()];
            Random::stream(experiment.seed, &words).shuffle(&mut runs);
            self.blocks.push(Block {
                id: MeshId {
                    experiment: experiment.name.clone(),
                    scale: self.scale,
                    group: group.name.clone(),
                    name: mesh.name.clone(),
                },
                mesh: mesh.clone(),
                repetition,
                limits: experiment.limits,
                measured_from_files: experiment.measured_from_files,
                runs,
                programs: experiment.programs.as_slice().into(),
            });
        }
    }

    /// Keeps every `of`th block, from the `shard`th, counted from 1, so that the repetitions of a
    /// mesh spread over the parts. The first part has the pictures.
    pub fn shard(&mut self, shard: usize, of: usize) {
        let blocks = std::mem::take(&mut self.blocks).into_iter().enumerate();
        let own = blocks.filter(|(place, _)| place % of == shard - 1);
        self.blocks = own.map(|(_, block)| block).collect();
        if shard != 1 {
            self.pictured.clear();
        }
    }

    /// Returns the names of the experiments, in order.
    pub fn experiments(&self) -> BTreeSet<&str> {
        self.blocks.iter().map(|block| block.id.experiment.as_str()).collect()
    }

    /// Returns one row for each mesh and job.
    pub fn rows(&self) -> Vec<Planned> {
        let row = |block: &Block, run: &PlannedRun| Planned {
            id: block.run_id(run),
            repetitions: run.repetitions,
        };
        let first = self.blocks.iter().filter(|block| block.repetition == 0);
        first.flat_map(|block| block.runs.iter().map(|run| row(block, run))).collect()
    }
}

impl Block {
    /// Returns the identity of one of its runs.
    pub fn run_id(&self, run: &PlannedRun) -> RunId {
        RunId { mesh: self.id.clone(), job: run.job }
    }

    /// Returns whether a run of an algorithm of ours leaves a file.
    pub fn leaves_file(&self, run: &PlannedRun) -> bool {
        self.measured_from_files && run.stop_after_paths.is_none()
    }

    /// Returns the program of a job that is not ours.
    pub fn program(&self, job: Job) -> Option<&ProgramSpec> {
        self.programs.iter().find(|program| job == program.job())
    }
}

/// Makes the error that a mesh of a group is not known.
fn unknown(experiment: &Experiment, name: &str, data: &[DataMesh]) -> PlannedMeshError {
    let known = paper::ALL.iter().map(|mesh| mesh.name);
    let known = known.chain(data.iter().map(|mesh| mesh.name.as_str()));
    let nearest = paper::called(name).map(|mesh| mesh.name).or_else(|| slip_of(name, known));
    let (place, nearest) = (experiment.place_of_mesh(name), nearest.map(str::to_owned));
    PlannedMeshError::Unknown { place, name: name.into(), nearest }
}

/// Makes the error that two meshes of a group have one name.
fn twice(
    experiment: &Experiment,
    group: &MeshGroup,
    meshes: [&PlannedMesh; 2],
) -> PlannedMeshError {
    let name = meshes[1].name.clone();
    let paths: Vec<_> = meshes.into_iter().filter_map(PlannedMesh::path).collect();
    let place = match paths.last().filter(|path| group.files.iter().any(|file| file == **path)) {
        Some(path) => experiment.place_of_file(path),
        None => experiment.place_of_mesh(&name),
    };
    let shown: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    let files = match &shown[..] {
        [] => String::new(),
        files => format!(", of {}", files.join(" and ")),
    };
    PlannedMeshError::Twice { place, group: group.name.clone(), name, files }
}

/// Makes the error that the mesh whose results are to be drawn is in no group.
fn not_run(experiment: &Experiment, name: &str) -> PlannedMeshError {
    PlannedMeshError::NotRun { place: experiment.place_of_mesh(name), name: name.into() }
}

/// Returns the seed of a run. It depends on names alone and is the same for each augmentation, so
/// that an added run changes no other.
fn seed(experiment: &Experiment, mesh: &PlannedMesh, job: Job, repetition: u32) -> u64 {
    let words = ["seed", &mesh.name, job.algorithm(), &repetition.to_string()];
    // 32 bits, so that every reader of CSV and JSON keeps all digits.
    u64::from(Random::stream(experiment.seed, &words).below(u32::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meshes::MeshKind;

    fn experiment(groups: &str) -> Experiment {
        let head = "name = \"x\"\ntitle = \"\"\ntask = \"convert\"\nseed = 5\n\
                    [limits]\ntimeout_seconds = 9\nmemory_gigabytes = 2\n";
        toml::from_str(&format!("{head}{groups}")).unwrap()
    }

    const GROUPS: &str = r#"
        [[group]]
        name = "g"
        meshes = ["A1", "A5", "botijo"]
        [[group.run]]
        algorithms = ["sg", "ps"]
        augmentations = ["tarjan", "local"]
        repetitions = { full = 3, small = 2, demo = 2 }
        fewer = { A1 = 1 }
        [[group.run]]
        algorithms = ["gw"]
        augmentations = ["local"]
        repetitions = { full = 1, small = 1, demo = 1 }
    "#;

    fn real(name: &str, vertices: u32, genus: u32) -> DataMesh {
        DataMesh {
            name: name.into(),
            path: format!("{name}.ply").into(),
            sha256: String::new(),
            vertices,
            triangles: 2 * (vertices + 2 * genus - 2),
            genus,
            problem: None,
        }
    }

    #[test]
    fn blocks_hold_what_is_compared_smaller_meshes_first() {
        let plan = Plan::new(&[experiment(GROUPS)], Scale::Full, &[]).unwrap();
        let blocks: Vec<_> = plan
            .blocks
            .iter()
            .map(|block| (&block.mesh.name[..], block.repetition, block.runs.len()))
            .collect();
        let expected = [
            ("botijo", 0, 5),
            ("botijo", 1, 4),
            ("botijo", 2, 4),
            ("A5", 0, 5),
            ("A5", 1, 4),
            ("A5", 2, 4),
            ("A1", 0, 5),
        ];
        assert_eq!(blocks, expected);
        assert_eq!(plan.rows().len(), 15);
        assert_eq!(plan.blocks[0].mesh.kind(), MeshKind::StandIn);
    }

    #[test]
    fn seeds_depend_on_names_alone() {
        let all = Plan::new(&[experiment(GROUPS)], Scale::Full, &[]).unwrap();
        let fewer = GROUPS.replace("\"A5\", ", "").replace("[\"sg\", \"ps\"]", "[\"ps\"]");
        let fewer = Plan::new(&[experiment(&fewer)], Scale::Full, &[]).unwrap();
        let seeds = |plan: &Plan, mesh: &str| {
            let blocks = plan.blocks.iter().filter(|block| block.mesh.name == mesh);
            let runs = blocks.flat_map(|block| block.runs.iter());
            let ps = runs.filter(|run| run.job.name() == "ps tarjan");
            ps.map(|run| run.seed).collect::<Vec<_>>()
        };
        let botijo = seeds(&all, "botijo");
        assert_eq!(botijo, seeds(&fewer, "botijo"));
        assert!(botijo[0] != botijo[1] && botijo[0] != seeds(&all, "A1")[0]);
        let runs = &all.blocks[0].runs;
        let of = |label| runs.iter().find(|run| run.job.name() == label).unwrap().seed;
        assert_eq!(of("sg tarjan"), of("sg local"));
    }

    #[test]
    fn pictures_are_of_what_is_run_on_the_mesh() {
        let mut experiment = experiment(GROUPS);
        experiment.pictures = Some("botijo".into());
        let plan = Plan::new(&[experiment], Scale::Full, &[]).unwrap();
        let [Pictured { mesh, algorithms }] = &plan.pictured[..] else { panic!("{plan:?}") };
        let names: Vec<&str> = algorithms.iter().map(|facts| facts.name).collect();
        assert_eq!((mesh.name.as_str(), &names[..]), ("botijo", &["sg", "ps", "gw"][..]));
    }

    #[test]
    fn shards_share_out_every_block_once() {
        let mut whole = Plan::new(&[experiment(GROUPS)], Scale::Demo, &[]).unwrap();
        whole.pictured.push(Pictured { mesh: whole.blocks[0].mesh.clone(), algorithms: vec![] });
        let names = |plan: &Plan| {
            let name = |block: &Block| format!("{} {}", block.mesh.name, block.repetition);
            plan.blocks.iter().map(name).collect::<Vec<_>>()
        };
        let (mut dealt, mut pictured) = (Vec::new(), 0);
        for shard in 1..=3 {
            let mut part = whole.clone();
            part.shard(shard, 3);
            dealt.extend(names(&part));
            pictured += part.pictured.len();
        }
        dealt.sort();
        let mut all = names(&whole);
        all.sort();
        assert_eq!((dealt, pictured), (all, 1));
    }

    #[test]
    fn a_file_is_the_papers_mesh_only_with_its_counts() {
        let more = GROUPS.replace("meshes = [", "other_data = true\nmeshes = [");
        let experiments = [experiment(&more)];
        let broken = DataMesh { problem: Some("a hole".into()), ..real("torn", 9, 0) };
        let data = [real("Botijo_scan", 20_000, 5), real("botijo-2", 77, 5), broken];
        let plan = Plan::new(&experiments, Scale::Full, &data).unwrap();
        let kind = |name: &str| {
            plan.blocks.iter().find(|block| block.mesh.name == name).map(|b| b.mesh.kind())
        };
        assert_eq!(kind("botijo"), Some(MeshKind::Real));
        assert_eq!(kind("botijo-2"), Some(MeshKind::Real));
        assert_eq!([kind("Botijo_scan"), kind("torn")], [None, None]);
        assert_eq!(plan.remarks.len(), 1, "{:?}", plan.remarks);
        let twice = [experiments[0].clone(), experiments[0].clone()];
        assert_eq!(Plan::new(&twice, Scale::Full, &data).unwrap().remarks, plan.remarks);
        let plan = Plan::new(&experiments, Scale::Demo, &data).unwrap();
        assert_eq!(plan.blocks[0].mesh.kind(), MeshKind::StandIn);
        // Where no experiment names it, it is one of the others.
        let others = experiment(&more.replace("\"botijo\"", ""));
        let plan = Plan::new(&[others], Scale::Full, &data).unwrap();
        assert!(plan.blocks.iter().any(|block| block.mesh.name == "Botijo_scan"));
    }

    #[test]
    fn an_unknown_mesh_is_named() {
        let unknown = experiment(&GROUPS.replace("A5", "A9"));
        let error = Plan::new(&[unknown], Scale::Full, &[]).unwrap_err();
        let expected = "x: \"A9\" is no mesh of the papers and in no data folder; name its folder \
                        with --data, or take it out";
        assert_eq!(error.to_string(), expected);
        for (name, data, meant) in [
            ("A55", vec![], "A5"),
            ("ir_b0", vec![], "ir-B0"),
            ("chairs", vec![real("chair", 9, 0)], "chair"),
        ] {
            let unknown = experiment(&GROUPS.replace("A5", name));
            let error = Plan::new(&[unknown], Scale::Full, &data).unwrap_err().to_string();
            assert_eq!(error, expected.replace("A9", name) + &format!(", or {meant:?} is meant"));
        }
        let mut drawn = experiment(GROUPS);
        drawn.pictures = Some("eros".into());
        let error = Plan::new(&[drawn], Scale::Full, &[]).unwrap_err().to_string();
        assert!(error.starts_with("x: pictures is \"eros\", and no group has it"), "{error}");
    }
}
