//! Growth with the size of the mesh, on families where something takes long, best of three.
//!
//! `cargo bench --bench growth` for 10⁴, 10⁵ and 10⁶ triangles; `-- 3e4 3e5` for these. Work is
//! counted in triangles visited, link vertices and tests; times are in nanoseconds. All are divided
//! by the number of triangles. The last line of a family gives the exponent between the first and
//! the last size: 1 is linear. Those of counts are exact, those of times hold for the machine.

use std::hint::black_box;
use std::time::Instant;

use triquad::irreducible::{Contractor, Order};
use triquad::mesh::{Format, Mesh};
use triquad::random::Random;
use triquad::{Algorithm, Converter, Report, Triangulation};
use triquad_generators::sculptor::Sculptor;
use triquad_generators::{Surface, grids, random, worst_cases};

const ROUNDS: usize = 3;
const SIZES: [f64; 3] = [1e4, 1e5, 1e6];
/// High genus takes time that grows with its square.
const MOST_OF_HIGH_GENUS: f64 = 1e5;

const COLUMNS: [&str; 11] =
    ["read", "build", "tq", "ps", "local ps", "visits", "gw", "best", "check", "rs", "links"];

fn main() {
    let named: Vec<f64> = std::env::args().skip(1).filter_map(|size| size.parse().ok()).collect();
    let sizes = if named.is_empty() { SIZES.to_vec() } else { named };
    for (name, make) in FAMILIES {
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
            let exponents = std::array::from_fn(|k| format!("{:.2}", exponent(k)));
            print_row("exponent", exponents);
        }
    }
}

fn print_row(name: &str, cells: [String; COLUMNS.len()]) {
    println!("{name:>10} {}", cells.map(|cell| format!("{cell:>9}")).join(""));
}

const HIGH_GENUS: &str = "tori round a pole: genus n / 14";

/// A surface of about so many triangles.
type Make = fn(f64) -> Surface;

const FAMILIES: [(&str, Make); 5] = [
    ("prism: every path passes the same rings", |n| {
        // Thirty times as long as wide.
        let side = (n / 182.0).sqrt().round().max(1.0) as u32;
        worst_cases::prism(side, 30 * side)
    }),
    ("regular sphere", |n| grids::sphere((n / 8.0).sqrt() as u32)),
    ("irregular sphere", |n| {
        let mut random = Random::stream(0, &["irregular"]);
        let regular = grids::sphere((n / 8.0).sqrt() as u32);
        random::irregular(&regular, 2, &mut |bound| random.below(bound))
    }),
    ("regular sphere, numbered at random", |n| {
        let mut random = Random::stream(0, &["shuffled"]);
        let mut sculptor = Sculptor::from(&grids::sphere((n / 8.0).sqrt() as u32));
        sculptor.relabel(&mut |bound| random.below(bound));
        sculptor.into_surface()
    }),
    (HIGH_GENUS, |n| worst_cases::tori_round_a_pole((n / 14.0) as u32)),
];

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
        1e9 * ps.pairing_seconds,
        1e9 * ps.augmentation_seconds,
        ps.paths.triangles_visited as f64,
        1e9 * gw.pairing_seconds,
        1e9 * optimum.pairing_seconds,
        1e9 * tq.check_seconds,
        nanoseconds(reduce),
        links,
    ]
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
