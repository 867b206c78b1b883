//! Converts small meshes that it makes itself with every algorithm there is, and prints the table.
//!
//! `make demo`, or `cargo run --release --example demo`.

use triquad::clock::SystemClock;
use triquad::mesh::FaceList;
use triquad::random::Random;
use triquad::{Algorithm, Augmentation, Settings, convert_list};
use triquad_generators::random::{Mix, irregular, random_surface};
use triquad_generators::{Surface, classic, grids};

fn main() {
    println!(
        "{:28} {:>9} {:>5}  {:9} {:12} {:>8} {:>9} {:>7} {:>6}",
        "mesh",
        "triangles",
        "genus",
        "algorithm",
        "augmentation",
        "unpaired",
        "paired %",
        "seconds",
        "quads"
    );
    for (name, surface) in meshes() {
        for algorithm in Algorithm::ALL {
            for augmentation in Augmentation::ALL {
                print_row(name, &surface, Settings { algorithm, augmentation, seed: 0 });
            }
        }
    }
}

fn meshes() -> Vec<(&'static str, Surface)> {
    let mut random = Random::stream(0, &["demo"]);
    let mut below = |bound| random.below(bound);
    vec![
        ("seven-vertex torus", classic::seven_vertex_torus()),
        ("regular torus", grids::torus(60, 40)),
        ("irregular sphere", irregular(&grids::sphere(30), 4, &mut below)),
        ("irregular torus", irregular(&grids::torus(50, 70), 4, &mut below)),
        ("random surface of genus 5", random_surface(5, 4000, Mix::Balanced, &mut below)),
        ("random surface of genus 104", random_surface(104, 8000, Mix::Balanced, &mut below)),
    ]
}

fn print_row(name: &str, surface: &Surface, settings: Settings) {
    let list = FaceList::from_triangles(surface.positions.clone(), surface.triangles.clone());
    let converted = convert_list(list, false, &settings, &SystemClock::default(), &mut ());
    // A result that failed its check would be an error here.
    let (_, summary) = converted.expect("a generated surface is a triangulation");
    println!(
        "{:28} {:>9} {:>5}  {:9} {:12} {:>8} {:>9.3} {:>7.4} {:>6}",
        name,
        summary.triangles,
        summary.genus,
        settings.algorithm.id(),
        settings.augmentation.id(),
        summary.unpaired_triangles,
        summary.paired_percent(),
        summary.total_seconds(),
        summary.check.quads,
    );
}
