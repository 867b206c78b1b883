//! Growth with the size of the mesh, on families where something takes long, best of three.
//!
//! `cargo bench --bench growth` for 10⁴, 10⁵ and 10⁶ triangles; `-- 3e4 3e5 prism` for these sizes
//! and the families with this word in their names. Work is counted in triangles visited by the
//! augmentation of the algorithm to the left, in nodes that `best` labels or scans, and in link
//! vertices visited by `rs`; times are in nanoseconds. All are divided by the number of triangles.
//! Visits are means over seeds, the more the smaller the mesh: few triangles stay unpaired there.
//! The last line of a family gives the exponent between the first and the last size: 1 is linear.
//! Those of counts are exact; those of times include what the caches do, and hold for the machine.

use std::hint::black_box;
use std::ops::ControlFlow;
use std::time::Instant;

use triquad::irreducible::{Contractor, Order};
use triquad::matching::weighted::{DualProblem, solve_cubic};
use triquad::mesh::{Format, Mesh};
use triquad::quadrangulation::edge_costs;
use triquad::random::Random;
use triquad::simplify::Simplifier;
use triquad::{Algorithm, Converter, DefaultCost, DualGraph, Report, Triangulation};
use triquad_generators::random::Mix;
use triquad_generators::sculptor::Sculptor;
use triquad_generators::{Surface, grids, organic, random, worst_cases};

const ROUNDS: usize = 3;
const SIZES: [f64; 3] = [1e4, 1e5, 1e6];
/// Triangles of all meshes over which a mean is taken, about.
const SAMPLE: u64 = 1_000_000;
/// High genus takes time that grows with its square.
const MOST_OF_HIGH_GENUS: f64 = 1e5;

const COLUMNS: [&str; 13] = [
    "read", "build", "tq", "visits", "ps", "local ps", "visits", "gw", "best", "nodes", "check",
    "rs", "links",
];

fn main() {
    // Cargo adds an option of its own.
    let words = std::env::args().skip(1).filter(|word| !word.starts_with('-'));
    let (numbers, words): (Vec<_>, Vec<_>) = words.partition(|word| word.parse::<f64>().is_ok());
    let named: Vec<f64> = numbers.iter().filter_map(|size| size.parse().ok()).collect();
    let sizes = if named.is_empty() { SIZES.to_vec() } else { named };
    let is_wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word));
    for (name, make) in FAMILIES.into_iter().filter(|(name, _)| is_wanted(name)) {
        println!("{name}");
        print_row("triangles", COLUMNS.map(str::to_string));
        let most = if name == HIGH_GENUS { MOST_OF_HIGH_GENUS } else { f64::INFINITY };
        let mut rows = Vec::new();
        for &size in sizes.iter().filter(|&&size| size <= most) {
            let surface = make(size);
            let triangles = surface.triangles.len() as f64;
            let row = measure(surface).map(|work| work / triangles);
            print_row(&triangles.to_string(), row.map(|x| format!("{x:.2}")));
            rows.push((triangles, row));
        }
        if let [(few, first), .., (many, last)] = rows[..] {
            let exponent = |k: usize| 1.0 + (last[k] / first[k]).ln() / (many / few).ln();
            // None where nothing had to be visited.
            let cell = |k| Some(exponent(k)).filter(|exponent| exponent.is_finite());
            let cells = std::array::from_fn(|k| match cell(k) {
                Some(exponent) => format!("{exponent:.2}"),
                None => "-".to_owned(),
            });
            print_row("exponent", cells);
        }
    }
}

fn print_row(name: &str, cells: [String; COLUMNS.len()]) {
    println!("{name:>10} {}", cells.map(|cell| format!("{cell:>9}")).join(""));
}

const HIGH_GENUS: &str = "tori round a pole: genus n / 14";

/// A surface of about so many triangles.
type Make = fn(f64) -> Surface;

const FAMILIES: [(&str, Make); 11] = [
    ("prism: every path passes the same rings", |n| {
        let side = prism_side(n);
        worst_cases::prism(side, 30 * side)
    }),
    ("prism with lobes: the same, with blossoms", |n| {
        let side = prism_side(n);
        worst_cases::prism_with_lobes(side, 30 * side)
    }),
    ("regular sphere", sphere),
    ("irregular sphere", |n| random::irregular(&sphere(n), 2, &mut draws("irregular"))),
    ("regular sphere, numbered at random", |n| {
        let mut sculptor = Sculptor::from(&sphere(n));
        sculptor.relabel(&mut draws("shuffled"));
        sculptor.into_surface()
    }),
    ("apollonian: triangles split again and again, numbered at random", |n| {
        random::random_surface(0, (n / 2.0) as usize, Mix::Splits, &mut draws("apollonian"))
    }),
    ("random torus: a grid with diagonals drawn", |n| {
        let side = (n / 2.0).sqrt() as u32;
        random::torus(side, side, &mut draws("torus"))
    }),
    ("slab: equilateral triangles but for a thousandth", |n| {
        worst_cases::slab((n / 4.0).sqrt() as u32, &mut draws("slab"))
    }),
    ("subdivided three times: an irregular sphere", |n| {
        let coarse = random::irregular(&sphere(n / 64.0), 2, &mut draws("subdivided"));
        (0..3).fold(coarse, |surface, _| Sculptor::from(&surface).subdivided())
    }),
    ("stand-in: genus n / 16, low degrees", |n| {
        let genus = (n / 16.0).round() as u32;
        let fine = organic::surface(genus, 18 * genus, &mut draws("stand-in"));
        simplified(fine, 6 * genus as usize)
    }),
    (HIGH_GENUS, |n| worst_cases::tori_round_a_pole((n / 14.0) as u32)),
];

/// Returns the side of a prism of about `n` triangles that is thirty times as long as wide.
fn prism_side(n: f64) -> u32 {
    (n / 182.0).sqrt().round().max(1.0) as u32
}

fn sphere(n: f64) -> Surface {
    grids::sphere((n / 8.0).sqrt() as u32)
}

/// Contracts edges of `surface` until `vertices` are left.
fn simplified(surface: Surface, vertices: usize) -> Surface {
    let mesh = Mesh::from_triangles(surface.positions, surface.triangles);
    let triangulation = Triangulation::build(&mesh).expect("it is a closed surface");
    let mut simplifier = Simplifier::new(triangulation, mesh.positions());
    simplifier.reduce_to(vertices).expect("many more edges can be contracted");
    let (mesh, triangulation) = simplifier.result();
    let corners = |f| triangulation.corners(f).map(|v| v.index() as u32);
    let triangles = triangulation.triangles().map(corners).collect();
    Surface { positions: mesh.positions().to_vec(), triangles }
}

fn draws(name: &str) -> impl FnMut(u32) -> u32 {
    let mut random = Random::stream(0, &[name]);
    move |bound| random.below(bound)
}

/// Returns what [`COLUMNS`] name.
fn measure(surface: Surface) -> [f64; COLUMNS.len()] {
    let mesh = Mesh::from_triangles(surface.positions, surface.triangles);
    let mut file = Vec::new();
    mesh.write_to(&mut file, Format::Obj).expect("memory takes every byte");
    let read = nanoseconds(|| Mesh::parse(&file, Format::Obj).expect("it was just written"));
    let tq = convert(&mesh, Algorithm::EagerRescue);
    let ps = convert(&mesh, Algorithm::PulliSegal);
    let gw = convert(&mesh, Algorithm::GawrychowskiWasylkiewicz);
    let optimum = convert(&mesh, Algorithm::Best);
    let triangulation = Triangulation::build(&mesh).expect("all families are closed surfaces");
    let reduce = || Contractor::RamaswamiSiqueira.reduce(triangulation.clone(), Order::File, 0);
    let links = reduce().counts.link_vertices_visited as f64;
    [
        read,
        1e9 * tq.build_seconds,
        1e9 * tq.total_seconds(),
        mean_visits(&triangulation, Algorithm::EagerRescue),
        1e9 * ps.pairing_seconds,
        1e9 * ps.augmentation_seconds,
        mean_visits(&triangulation, Algorithm::PulliSegal),
        1e9 * gw.pairing_seconds,
        1e9 * optimum.pairing_seconds,
        nodes_of_best(&triangulation, &mesh),
        1e9 * tq.check_seconds,
        nanoseconds(reduce),
        links,
    ]
}

/// Returns how many triangles the augmentation visits in the mean.
fn mean_visits(triangulation: &Triangulation, algorithm: Algorithm) -> f64 {
    let seeds = (SAMPLE / triangulation.triangle_count() as u64).max(1);
    let visits = |seed| {
        let mut converter = Converter::new().algorithm(algorithm).seed(seed);
        let done = converter.quadrangulate(triangulation).expect("nothing stops it");
        done.report.paths.triangles_visited as f64
    };
    (0..seeds).map(visits).sum::<f64>() / seeds as f64
}

/// Returns how many nodes `best` labels or scans.
fn nodes_of_best(triangulation: &Triangulation, mesh: &Mesh) -> f64 {
    let graph = DualGraph::new(triangulation);
    let costs = edge_costs(triangulation, mesh.positions(), &DefaultCost);
    let problem = DualProblem::new(&graph, &costs);
    let solution = solve_cubic(&problem, &mut |_| ControlFlow::Continue(()));
    let work = solution.expect("closed surfaces have a perfect matching").work;
    (work.visits + work.scans) as f64
}

/// Converts `mesh` some times and returns the report of the fastest.
fn convert(mesh: &Mesh, algorithm: Algorithm) -> Report {
    let run = || Converter::new().algorithm(algorithm).run(mesh).expect("it has a surface");
    let reports = (0..ROUNDS).map(|_| run().report().clone());
    reports.min_by(|a, b| a.total_seconds().total_cmp(&b.total_seconds())).expect("some rounds")
}

/// Returns the least time that `operation` takes.
fn nanoseconds<T>(operation: impl Fn() -> T) -> f64 {
    let time = |_| {
        let start = Instant::now();
        black_box(operation());
        1e9 * start.elapsed().as_secs_f64()
    };
    (0..ROUNDS).map(time).fold(f64::INFINITY, f64::min)
}
