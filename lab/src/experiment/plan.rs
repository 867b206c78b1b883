//! From experiment files to the runs that they ask for, in the order in which they are executed.

use std::collections::BTreeSet;
use std::path::PathBuf;

use super::data::DataMesh;
use super::job::Job;
use super::results::Planned;
use super::spec::{Experiment, Group, Limits, RunSpec};
use crate::meshes::paper::{self, PaperMesh, Scale};
use triquad::random::Random;

/// What is to be run, block by block.
#[derive(Clone, Debug)]
pub struct Plan {
    /// How large the meshes are.
    pub scale: Scale,
    /// One block is one mesh and one repetition with all its algorithms: what is compared runs
    /// together, on one machine.
    pub blocks: Vec<Block>,
    /// The meshes whose quads are drawn.
    pub pictured: Vec<PlannedMesh>,
    /// What a reader should know of the meshes.
    pub remarks: Vec<String>,
}

/// One mesh, one repetition, all its algorithms in a seeded random order.
#[derive(Clone, Debug)]
pub struct Block {
    /// Name of the experiment.
    pub experiment: String,
    /// Name of the group.
    pub group: String,
    /// The mesh.
    pub mesh: PlannedMesh,
    /// From 0.
    pub repetition: u32,
    /// When a run is stopped.
    pub limits: Limits,
    /// What is run.
    pub runs: Vec<PlannedRun>,
}

/// One run of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlannedRun {
    /// What it does.
    pub job: Job,
    /// Its seed: equal for equal experiment, mesh, algorithm and repetition.
    pub seed: u64,
    /// Repetitions of this job on this mesh in all.
    pub repetitions: u32,
    /// Augmenting paths after which it stops.
    pub stop_after_paths: Option<u64>,
}

/// A mesh, and where it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlannedMesh {
    /// Its name in records.
    pub name: String,
    /// n_v.
    pub vertices: u32,
    /// n_f.
    pub triangles: u32,
    /// Genus.
    pub genus: u32,
    /// Where it comes from.
    pub source: Source,
}

/// Where a mesh comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// A file of the user's, and its SHA-256.
    File(PathBuf, String),
    /// Made to order, at a scale.
    Made(PaperMesh, Scale),
}

/// A name that is neither a mesh of the papers nor a file in a data folder.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
#[error("{experiment}: {name:?} is no mesh of the papers and in no data folder")]
pub struct UnknownMesh {
    experiment: String,
    name: String,
}

impl Plan {
    /// What `experiments` ask for, with the meshes of `data` where a name fits.
    ///
    /// Meshes of a group in ascending size, so that what takes too long shows on the smaller ones.
    ///
    /// # Errors
    /// A mesh is unknown.
    pub fn of(
        experiments: &[Experiment],
        scale: Scale,
        data: &[DataMesh],
    ) -> Result<Self, UnknownMesh> {
        let mut plan =
            Self { scale, blocks: Vec::new(), pictured: Vec::new(), remarks: Vec::new() };
        for experiment in experiments {
            for group in &experiment.groups {
                plan.add_group(experiment, group, data)?;
            }
            if let Some(name) = &experiment.pictures {
                let named = plan.blocks.iter().find(|block| block.mesh.name == *name);
                let pictured = named.map(|block| block.mesh.clone());
                plan.pictured.push(pictured.ok_or_else(|| unknown(experiment, name))?);
            }
        }
        // Two experiments may have the same to say.
        let mut said = BTreeSet::new();
        plan.remarks.retain(|remark| said.insert(remark.clone()));
        Ok(plan)
    }

    fn add_group(
        &mut self,
        experiment: &Experiment,
        group: &Group,
        data: &[DataMesh],
    ) -> Result<(), UnknownMesh> {
        let mut meshes = Vec::new();
        for name in &group.meshes {
            let mesh = self.find_mesh(name, data);
            meshes.push(mesh.ok_or_else(|| unknown(experiment, name))?);
        }
        if group.other_data && self.scale == Scale::Full {
            meshes.extend(self.other_data(data));
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

    /// The meshes of `data` that are none of the papers'.
    fn other_data(&mut self, data: &[DataMesh]) -> Vec<PlannedMesh> {
        let is_paper = |mesh: &DataMesh| {
            paper::ALL.iter().any(|paper| mesh.is_called(paper.name) && mesh.has_counts_of(paper))
        };
        let mut meshes = Vec::new();
        for mesh in data.iter().filter(|&mesh| !is_paper(mesh)) {
            match &mesh.problem {
                None => meshes.push(PlannedMesh::real(mesh)),
                Some(problem) => {
                    self.remarks.push(format!("{} is left out: {problem}", mesh.path.display()));
                }
            }
        }
        meshes
    }

    fn add_mesh(&mut self, experiment: &Experiment, group: &Group, mesh: &PlannedMesh) {
        let repetitions = |run: &RunSpec| run.repetitions(&mesh.name, self.scale);
        let most = group.runs.iter().map(repetitions).max().unwrap_or(0);
        for repetition in 0..most {
            let mut runs = Vec::new();
            for run in group.runs.iter().filter(|run| repetition < repetitions(run)) {
                let jobs = run.jobs(experiment.task).expect("the file has been checked");
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
                experiment: experiment.name.clone(),
                group: group.name.clone(),
                mesh: mesh.clone(),
                repetition,
                limits: experiment.limits,
                runs,
            });
        }
    }

    /// Keeps every `of`th block, from the `shard`th, counted from 1. Blocks are dealt out within each
    /// mesh, so that a mesh's repetitions spread. The first part has the pictures.
    pub fn shard(&mut self, shard: usize, of: usize) {
        let mut place = 0..;
        self.blocks.retain(|_| place.next().is_some_and(|i: usize| i % of == shard - 1));
        if shard != 1 {
            self.pictured.clear();
        }
    }

    /// What is planned, one row for each mesh and job.
    pub fn rows(&self) -> Vec<Planned> {
        let first = self.blocks.iter().filter(|block| block.repetition == 0);
        first.flat_map(|block| block.runs.iter().map(|run| self.row(block, run))).collect()
    }

    fn row(&self, block: &Block, run: &PlannedRun) -> Planned {
        let text = |name: Option<&str>| name.map(str::to_owned);
        Planned {
            experiment: block.experiment.clone(),
            scale: self.scale.id().into(),
            group: block.group.clone(),
            mesh: block.mesh.name.clone(),
            algorithm: run.job.algorithm().into(),
            lrs_variant: text(run.job.lrs_variant()),
            augmentation: text(run.job.augmentation()),
            order: text(run.job.order()),
            repetitions: run.repetitions,
        }
    }
}

fn unknown(experiment: &Experiment, name: &str) -> UnknownMesh {
    UnknownMesh { experiment: experiment.name.clone(), name: name.into() }
}

/// A seed of this run alone, the same for each way to augment: adding a run moves no other.
fn seed(experiment: &Experiment, mesh: &PlannedMesh, job: Job, repetition: u32) -> u64 {
    let words = ["seed", &mesh.name, job.algorithm(), &repetition.to_string()];
    // So small that every reader of CSV and JSON keeps all its digits.
    u64::from(Random::stream(experiment.seed, &words).below(u32::MAX))
}

impl PlannedMesh {
    fn real(mesh: &DataMesh) -> Self {
        Self {
            name: mesh.name.clone(),
            vertices: mesh.vertices,
            triangles: mesh.triangles,
            genus: mesh.genus,
            source: Source::File(mesh.path.clone(), mesh.sha256.clone()),
        }
    }

    fn made(paper: PaperMesh, scale: Scale) -> Self {
        let mesh = paper.at(scale);
        Self {
            name: mesh.name.into(),
            vertices: mesh.vertices,
            triangles: mesh.triangles(),
            genus: mesh.genus,
            source: Source::Made(mesh, scale),
        }
    }

    /// `real`, `generated`, `simplified` or `stand-in`.
    pub fn kind(&self) -> &'static str {
        match &self.source {
            Source::File(..) => "real",
            Source::Made(mesh, _) => mesh.kind(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let plan = Plan::of(&[experiment(GROUPS)], Scale::Full, &[]).unwrap();
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
        assert_eq!(plan.blocks[0].mesh.kind(), "stand-in");
    }

    #[test]
    fn seeds_depend_on_names_alone() {
        let all = Plan::of(&[experiment(GROUPS)], Scale::Full, &[]).unwrap();
        let fewer = GROUPS.replace("\"A5\", ", "").replace("[\"sg\", \"ps\"]", "[\"ps\"]");
        let fewer = Plan::of(&[experiment(&fewer)], Scale::Full, &[]).unwrap();
        let seeds = |plan: &Plan, mesh: &str| {
            let blocks = plan.blocks.iter().filter(|block| block.mesh.name == mesh);
            let runs = blocks.flat_map(|block| block.runs.iter());
            let ps = runs.filter(|run| run.job.label() == "ps tarjan");
            ps.map(|run| run.seed).collect::<Vec<_>>()
        };
        let botijo = seeds(&all, "botijo");
        assert_eq!(botijo, seeds(&fewer, "botijo"));
        assert!(botijo[0] != botijo[1] && botijo[0] != seeds(&all, "A1")[0]);
        let runs = &all.blocks[0].runs;
        let of = |label| runs.iter().find(|run| run.job.label() == label).unwrap().seed;
        assert_eq!(of("sg tarjan"), of("sg local"));
    }

    #[test]
    fn shards_share_out_every_block_once() {
        let mut whole = Plan::of(&[experiment(GROUPS)], Scale::Demo, &[]).unwrap();
        whole.pictured.push(whole.blocks[0].mesh.clone());
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
        let plan = Plan::of(&experiments, Scale::Full, &data).unwrap();
        let kind = |name: &str| {
            plan.blocks.iter().find(|block| block.mesh.name == name).map(|b| b.mesh.kind())
        };
        assert_eq!(kind("botijo"), Some("real"));
        assert_eq!(kind("botijo-2"), Some("real"));
        assert_eq!([kind("Botijo_scan"), kind("torn")], [None, None]);
        assert_eq!(plan.remarks.len(), 1, "{:?}", plan.remarks);
        let twice = [experiments[0].clone(), experiments[0].clone()];
        assert_eq!(Plan::of(&twice, Scale::Full, &data).unwrap().remarks, plan.remarks);
        let plan = Plan::of(&experiments, Scale::Demo, &data).unwrap();
        assert_eq!(plan.blocks[0].mesh.kind(), "stand-in");
    }

    #[test]
    fn an_unknown_mesh_is_named() {
        let unknown = experiment(&GROUPS.replace("A5", "A9"));
        let error = Plan::of(&[unknown], Scale::Full, &[]).unwrap_err();
        assert_eq!(error.to_string(), "x: \"A9\" is no mesh of the papers and in no data folder");
    }
}
