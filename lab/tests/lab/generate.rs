//! Meshes made to order: counts, equal bytes, the papers' tables, the cache.

use triquad::Mesh;
use triquad::random::Random;
use triquad::simplify::{Rule, Simplifier};
use triquad::{Algorithm, Converter, Triangulation};
use triquad_lab::meshes::paper::{self, PaperMesh};
use triquad_lab::meshes::{BoxShape, Cache, GenerateError, PaperBox, Recipe, Walls};

fn built(list: &Mesh) -> Triangulation {
    Triangulation::build(list).unwrap_or_else(|survey| panic!("{survey}"))
}

/// A hash of every bit of a mesh (FNV-1a).
fn fingerprint(list: &Mesh) -> u64 {
    let coordinates =
        list.positions().as_flattened().iter().flat_map(|x| x.to_bits().to_le_bytes());
    let corners = list.faces().corners().iter().flat_map(|corner| corner.to_le_bytes());
    coordinates.chain(corners).fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

fn small_box() -> BoxShape {
    BoxShape { cavities: 5, holes: 4, vertices: 1234 }
}

fn small_paper_box() -> PaperBox {
    PaperBox { shafts: 3, depth: 30, holes: 4 }
}

fn small_recipes() -> [Recipe; 6] {
    let paper_box = |walls| Recipe::PaperBox { shape: small_paper_box(), walls, seed: 1 };
    [
        Recipe::Box(small_box()),
        paper_box(Walls::Alternating),
        paper_box(Walls::Drawn),
        Recipe::SimplifiedBox { of: small_paper_box(), vertices: 321 },
        Recipe::StandIn { vertices: 500, genus: 3, seed: 0 },
        Recipe::StandIn { vertices: 500, genus: 3, seed: 1 },
    ]
}

/// Whoever changes these numbers increases the edition of the cache.
#[test]
fn every_bit_is_the_same_on_every_machine() {
    let fingerprints = small_recipes().map(|recipe| fingerprint(&recipe.make().unwrap()));
    assert_eq!(
        fingerprints.map(|fingerprint| format!("{fingerprint:016x}")),
        [
            "ce1498acbe78c383",
            "bc246d895ef7d5df",
            "672da54ac64596f7",
            "afcfe7ee090cf862",
            "08237a22891717f8",
            "d4f111c028dad600",
        ]
    );
}

#[test]
fn vertices_and_genus_are_those_asked_for() {
    let expected = [(1234, 4), (2366, 4), (2366, 4), (321, 4), (500, 3), (500, 3)];
    for (recipe, (vertices, genus)) in small_recipes().into_iter().zip(expected) {
        let triangulation = built(&recipe.make().unwrap());
        assert_eq!((triangulation.vertex_count(), triangulation.genus()), (vertices, genus));
        assert_eq!(triangulation.unreferenced_vertex_count(), 0);
    }
    for (vertices, genus) in [(4, 0), (50, 0), (2000, 0), (300, 1), (836, 7), (3000, 20)] {
        let triangulation = built(&Recipe::StandIn { vertices, genus, seed: 7 }.make().unwrap());
        assert_eq!(triangulation.vertex_count(), vertices as usize);
        assert_eq!(triangulation.genus(), genus as usize);
        assert_eq!(triangulation.component_count(), 1);
    }
}

/// As scans are: far from all degrees being 6.
#[test]
fn stand_ins_are_irregular() {
    let list = Recipe::StandIn { vertices: 5000, genus: 2, seed: 0 }.make().unwrap();
    let mut degrees = vec![0u32; list.positions().len()];
    list.faces().corners().iter().for_each(|&v| degrees[v as usize] += 1);
    let six = degrees.iter().filter(|&&degree| degree == 6).count();
    assert!((1000..3000).contains(&six), "{six} of 5000 vertices have degree 6");
}

/// The comparison paper on A1 to A5 (section 4): the less regular a mesh, the more triangles its
/// greedy algorithm leaves unpaired. Of A1's cavities a tenth, with as many vertices each.
#[test]
fn what_pulli_segal_leaves_grows_with_irregularity() {
    let list = BoxShape { cavities: 384, holes: 0, vertices: 209_496 }.surface().unwrap();
    let list = Mesh::from_triangles(list.positions, list.triangles);
    let regular = built(&list);
    let mut simplifier = Simplifier::new(regular.clone(), list.positions());
    let [a, b] = [99_040, 17_217].map(|vertices| {
        simplifier.reduce_to(vertices).unwrap();
        simplifier.result().1
    });
    let share = |triangulation: &Triangulation| {
        let pair =
            |seed| Algorithm::PulliSegal.pair(triangulation, &mut Random::stream(seed, &["box"]));
        let unpaired: usize = (0..4).map(|seed| pair(seed).matching.unpaired_count()).sum();
        unpaired as f64 / (4 * triangulation.triangle_count()) as f64
    };
    let [first, second, last] = [&regular, &a, &b].map(share);
    assert!(first < 1e-4 && 2.0 * first < second && 2.0 * second < last, "{first} {second} {last}");
}

#[test]
fn what_cannot_be_made_is_refused() {
    let too_small = Recipe::Box(BoxShape { vertices: 100, ..small_box() });
    assert!(matches!(too_small.make(), Err(GenerateError::Box(_))));
    let not_so_few = Recipe::SimplifiedBox { of: small_paper_box(), vertices: 9 };
    assert!(matches!(not_so_few.make(), Err(GenerateError::Simplify(_))));
    let shape = PaperBox { holes: 10, ..small_paper_box() };
    let too_many_holes = Recipe::PaperBox { shape, walls: Walls::Equal, seed: 0 };
    assert!(matches!(too_many_holes.make(), Err(GenerateError::PaperBox(_))));
    let too_few = Recipe::StandIn { vertices: 3, genus: 0, seed: 0 };
    assert!(matches!(too_few.make(), Err(GenerateError::Simplify(_))));
    for (vertices, genus) in [(1 << 31, 0), (120_000_000, 0), (1000, 10_000_000), (4, u32::MAX)] {
        let too_large = Recipe::StandIn { vertices, genus, seed: 0 }.make();
        assert!(matches!(too_large, Err(GenerateError::TooLarge { .. })), "{vertices}, {genus}");
    }
}

#[test]
fn the_cache_gives_what_would_be_made_and_makes_it_once() {
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::new(folder.path().join("new/folder"));
    for recipe in small_recipes() {
        let made = recipe.make().unwrap();
        assert_eq!(fingerprint(&cache.get(&recipe).unwrap()), fingerprint(&made));
        if matches!(recipe, Recipe::Box(_) | Recipe::PaperBox { .. }) {
            assert!(!cache.file(&recipe).exists(), "a box is made faster than it is read");
            continue;
        }
        let kept = cache.file(&recipe);
        let before = kept.metadata().unwrap().modified().unwrap();
        assert_eq!(fingerprint(&cache.get(&recipe).unwrap()), fingerprint(&made));
        assert_eq!(kept.metadata().unwrap().modified().unwrap(), before);
        // What is damaged is made anew.
        std::fs::write(&kept, "ply\nformat").unwrap();
        assert_eq!(fingerprint(&cache.get(&recipe).unwrap()), fingerprint(&made));
        assert!(kept.metadata().unwrap().len() > 1000);
    }
    assert!(matches!(
        cache.get(&Recipe::StandIn { vertices: 3, genus: 0, seed: 0 }),
        Err(GenerateError::Simplify(_))
    ));
}

#[test]
fn a_folder_that_cannot_be_made_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "").unwrap();
    let cache = Cache::new(file);
    assert!(matches!(cache.get(&small_recipes()[4]), Err(GenerateError::Cache { .. })));
}

fn assert_is(mesh: &PaperMesh, list: &Mesh) {
    let triangulation = built(list);
    let counts = [
        triangulation.vertex_count(),
        triangulation.edge_count(),
        triangulation.triangle_count(),
        triangulation.genus(),
    ];
    let printed = [mesh.vertices, mesh.edges(), mesh.triangles(), mesh.genus];
    assert_eq!(counts, printed.map(|count| count as usize), "{}", mesh.name);
    assert_eq!(triangulation.component_count(), 1, "{}", mesh.name);
}

/// The boxes of Tables 4.2, 3, 4 and 5, and everything that is simplified from them.
fn assert_hierarchy(of: &str) {
    let root = paper::named(of).unwrap();
    let Recipe::PaperBox { shape, .. } = root.recipe else { panic!("{of} is a box") };
    let list = root.recipe.make().unwrap();
    let mut simplifier = Simplifier::with_rule(built(&list), list.positions(), Rule::Plain);
    let simplified =
        |mesh: &PaperMesh| matches!(mesh.recipe, Recipe::SimplifiedBox { of, .. } if of == shape);
    let mut meshes: Vec<PaperMesh> = paper::ALL.into_iter().filter(simplified).collect();
    meshes.sort_by_key(|mesh| std::cmp::Reverse(mesh.vertices));
    assert!(meshes.len() > 10);
    for mesh in meshes {
        simplifier.reduce_to(mesh.vertices as usize).unwrap();
        assert_is(&mesh, &simplifier.result().0);
    }
}

#[test]
fn the_hierarchies_of_a1_have_the_printed_counts() {
    assert_hierarchy("A1");
}

#[test]
fn the_hierarchies_of_b1_have_the_printed_counts() {
    assert_hierarchy("B1");
}

#[test]
fn the_boxes_have_the_printed_counts_and_convert() {
    for mesh in paper::ALL.iter().filter(|mesh| matches!(mesh.recipe, Recipe::PaperBox { .. })) {
        assert_is(mesh, &mesh.recipe.make().unwrap());
    }
    for name in ["A1", "B1"] {
        let triangulation = built(&paper::named(name).unwrap().recipe.make().unwrap());
        for algorithm in [Algorithm::PulliSegal, Algorithm::EagerRescue] {
            let mut converter = Converter::new().algorithm(algorithm);
            let quads = converter.quadrangulate(&triangulation).unwrap().quadrangulation;
            assert_eq!(2 * quads.len(), triangulation.triangle_count());
        }
    }
}

#[test]
fn the_small_stand_ins_of_scans_have_the_printed_counts() {
    for mesh in paper::ALL.iter().filter(|mesh| mesh.vertices < 30_000) {
        if matches!(mesh.recipe, Recipe::StandIn { .. }) {
            assert_is(mesh, &mesh.recipe.make().unwrap());
        }
    }
}
