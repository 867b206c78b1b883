//! Seconds and memory of whole conversions, each in a process of its own, best of three; and of
//! making the same meshes irreducible.
//!
//! `cargo bench --bench speed` (or `make bench`) uses meshes that it makes itself; the environment
//! variable `MESHES` names others, separated by white space. If `LEMON` names a program that is
//! called as `LEMON VARIANT FILE.dual` and prints JSON with `algo_s` (the seconds that LEMON's
//! maximum matching takes on the dual graph), the least of its variants' seconds is the yardstick
//! L, and times are given as multiples of it too. On small meshes petgraph's maximum matching of
//! the dual graph is timed beside ours. A `.dual` file holds 32-bit integers: the number of nodes,
//! the number of edges, and both ends of each edge.

use std::collections::BTreeMap;
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;
use triquad::irreducible::Contractor;
use triquad::mesh::{Mesh, Output};
use triquad::random::Random;
use triquad::{Algorithm, DualGraph, Triangulation};
use triquad_generators::{grids, random};

const ROUNDS: usize = 3;
/// DS takes about 15 µs a triangle: beyond this one is left out.
const DS_LIMIT: f64 = 1.1e6;
/// petgraph takes seconds for this many triangles, and its time grows with their square.
const PETGRAPH_LIMIT: f64 = 50e3;
const VARIANTS: [&str; 3] = ["lemon_greedydense", "lemon_dense", "lemon_run"];

type Result<T> = std::result::Result<T, Box<dyn Error>>;

fn main() -> Result<()> {
    // Cargo starts in the folder of the crate; files are named from that of the repository.
    std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))?;
    let folder = tempfile::tempdir()?;
    let meshes = match std::env::var("MESHES") {
        Ok(named) if !named.trim().is_empty() => {
            named.split_whitespace().map(PathBuf::from).collect()
        }
        _ => make_meshes(folder.path())?,
    };
    println!(
        "seconds, best of {ROUNDS}: read, build, (a) pairing, (d) augmentation, (e) = (a) + (d)"
    );
    println!(
        "{:24} {:>9} {:>4} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>6} {:>8} {:>7} {:>7} {:>7}",
        "mesh",
        "triangles",
        "",
        "read",
        "build",
        "(a)",
        "(d)",
        "(e)",
        "check",
        "B/tri",
        "unp. %",
        "L",
        "build/L",
        "(e)/L"
    );
    for path in meshes {
        bench(&path, folder.path())?;
    }
    Ok(())
}

/// Irregular spheres as from a scanner, small and large, a regular torus, and a larger torus, as
/// OBJ files.
fn make_meshes(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut random = Random::stream(0, &["bench"]);
    let [small, large] = [70, 354]
        .map(|n| random::irregular(&grids::sphere(n), 3, &mut |bound| random.below(bound)));
    let surfaces = [
        ("sphere-small", small),
        ("sphere-irregular", large),
        ("torus-1m", grids::torus(708, 708)),
        ("torus-4m", grids::torus(1450, 1450)),
    ];
    let write = |(name, surface): (&str, triquad_generators::Surface)| -> Result<PathBuf> {
        let path = folder.join(name).with_extension("obj");
        let list = Mesh::from_triangles(surface.positions, surface.triangles);
        Output::create(&path)?.write(&list)?;
        Ok(path)
    };
    surfaces.into_iter().map(write).collect()
}

/// The least value of each time, and the last of every other number.
type Best = BTreeMap<String, f64>;

fn bench(path: &Path, folder: &Path) -> Result<()> {
    let lemon = std::env::var_os("LEMON");
    let dual = folder.join("mesh.dual");
    if lemon.is_some() {
        write_dual(path, &dual)?;
    }
    let mut best: BTreeMap<&str, Best> = BTreeMap::new();
    let mut yardstick = f64::INFINITY;
    // Interleaved: a slow minute of the machine then hits everything alike.
    for _ in 0..ROUNDS {
        for algorithm in Algorithm::ALL.map(Algorithm::id) {
            let size = best.get("tq").map_or(0.0, |tq| tq["triangles"]);
            if algorithm != "ds" || size <= DS_LIMIT {
                keep_best(best.entry(algorithm).or_default(), &run("convert", path, algorithm)?);
            }
        }
        for method in Contractor::ALL.map(Contractor::id) {
            keep_best(best.entry(method).or_default(), &run("irreducible", path, method)?);
        }
        for variant in VARIANTS {
            if let Some(program) = &lemon {
                yardstick = yardstick.min(lemon_seconds(Path::new(program), variant, &dual)?);
            }
        }
    }
    for algorithm in Algorithm::ALL.map(Algorithm::id) {
        if let Some(best) = best.get(algorithm) {
            print_row(path, algorithm, best, lemon.is_some().then_some(yardstick));
        }
    }
    if best["tq"]["triangles"] <= PETGRAPH_LIMIT {
        println!("{:24.24} {:>14} {:>23.3}", "", "petgraph", petgraph_seconds(path)?);
    }
    for method in Contractor::ALL.map(Contractor::id) {
        print_irreducible(method, &best[method], lemon.is_some().then_some(yardstick));
    }
    Ok(())
}

/// The seconds that petgraph's maximum matching takes on the dual graph.
fn petgraph_seconds(path: &Path) -> Result<f64> {
    let triangulation = Triangulation::build(&Mesh::read(path)?)?;
    let dual = DualGraph::new(&triangulation);
    let graph =
        petgraph::graph::UnGraph::<(), ()>::from_edges(edges(&dual).map(<(u32, u32)>::from));
    let start = std::time::Instant::now();
    let matching = petgraph::algo::maximum_matching(&graph);
    let seconds = start.elapsed().as_secs_f64();
    assert!(matching.is_perfect());
    Ok(seconds)
}

/// Runs `verb` on the mesh by `algorithm`; returns its statistics.
fn run(verb: &str, path: &Path, algorithm: &str) -> Result<Value> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_triquad"));
    let output =
        command.arg(verb).arg(path).args(["--algorithm", algorithm, "--stats", "-"]).output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    Ok(serde_json::from_slice(&output.stdout)?)
}

fn keep_best(best: &mut Best, stats: &Value) {
    let numbers = stats.as_object().into_iter().flatten();
    for (name, value) in numbers.filter_map(|(name, value)| Some((name, value.as_f64()?))) {
        let entry = best.entry(name.clone()).or_insert(value);
        *entry = if name.ends_with("seconds") { entry.min(value) } else { value };
    }
}

fn lemon_seconds(program: &Path, variant: &str, dual: &Path) -> Result<f64> {
    let output = Command::new(program).arg(variant).arg(dual).output()?;
    let json: Value = serde_json::from_slice(&output.stdout)?;
    json["algo_s"].as_f64().ok_or_else(|| "the LEMON program gave no algo_s".into())
}

fn write_dual(path: &Path, dual: &Path) -> Result<()> {
    let triangulation = Triangulation::build(&Mesh::read(path)?)?;
    let graph = DualGraph::new(&triangulation);
    let mut file = std::io::BufWriter::new(std::fs::File::create(dual)?);
    let counts = [graph.len() as u32, edges(&graph).count() as u32];
    for number in counts.into_iter().chain(edges(&graph).flatten()) {
        file.write_all(&number.to_le_bytes())?;
    }
    Ok(file.flush()?)
}

/// Both ends of each edge of a dual graph.
fn edges(dual: &DualGraph) -> impl Iterator<Item = [u32; 2]> {
    let around = |f| dual.neighbours(f).filter(move |&g| f < g).map(move |g| [f, g]);
    dual.triangles().flat_map(around).map(|ends| ends.map(|f| f.index() as u32))
}

fn print_row(path: &Path, algorithm: &str, best: &Best, yardstick: Option<f64>) {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let total = best["pairing_seconds"] + best["augmentation_seconds"];
    let bytes = best
        .get("peak_memory_bytes")
        .map_or("-".into(), |bytes| format!("{:.0}", bytes / best["triangles"]));
    let in_l = |seconds: f64| yardstick.map_or("-".into(), |l| format!("{:.2}", seconds / l));
    println!(
        "{:24.24} {:>9} {:>4} {:>7.3} {:>7.3} {:>7.3} {:>7.3} {:>7.3} {:>7.3} {:>6} {:>8.4} {:>7} {:>7} {:>7}",
        name,
        best["triangles"],
        algorithm,
        best["read_seconds"],
        best["build_seconds"],
        best["pairing_seconds"],
        best["augmentation_seconds"],
        total,
        best["check_seconds"],
        bytes,
        100.0 - best["paired_percent"],
        yardstick.map_or("-".into(), |l| format!("{l:.4}")),
        in_l(best["build_seconds"]),
        in_l(total),
    );
}

fn print_irreducible(method: &str, best: &Best, yardstick: Option<f64>) {
    let (seconds, tests) = (best["seconds"], best["link_condition_tests"]);
    let in_l = yardstick.map_or("-".into(), |l| format!("{:.2}", seconds / l));
    let bytes = best
        .get("peak_memory_bytes")
        .map_or("-".into(), |bytes| format!("{:.0}", bytes / best["triangles"]));
    println!(
        "    irreducible, {method:11}: {seconds:.3} s ({in_l} L), {tests} tests of {:.0} ns, {} edges \
         tested again, {} vertices left, {bytes} B/tri",
        1e9 * seconds / tests,
        best["edges_tested_more_than_once"],
        best["result_vertices"],
    );
}
