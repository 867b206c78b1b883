//! Scans and CAD parts, good and bad, as they are found in the world.
//!
//! The meshes are not part of the project: they are looked for in the folder that the environment
//! variable `TRIQUAD_MESHES` names, or in `../shared/meshes`, and without them the tests pass.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use triquad::irreducible::{Contractor, Discipline, Order, ramaswami_siqueira};
use triquad::mesh::Faces;
use triquad::pairing::{LRS_ORDER, lrs};
use triquad::quadrangulation::Keep;
use triquad::random::Random;
use triquad::simplify::{Shape, Simplifier};
use triquad::triangulation::{HalfEdgeId, LinkMarks, ShrinkingTriangulation};
use triquad::{
    Algorithm, Converter, Expansion, Law, Mesh, Report, Survey, Triangulation, check,
    check_retriangulation,
};

/// The folder of real meshes and what its catalogue says of each.
struct Catalogue {
    folder: PathBuf,
    entries: Vec<Entry>,
}

/// A line of the catalogue, by column name.
struct Entry(HashMap<String, String>);

impl Catalogue {
    /// The catalogue, if there is one here; says so if not.
    fn open() -> Option<Self> {
        let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/meshes");
        let folder =
            std::env::var_os("TRIQUAD_MESHES").map_or_else(|| beside.into(), PathBuf::from);
        let Ok(text) = std::fs::read_to_string(folder.join("catalogue.csv")) else {
            println!("skipped: no real meshes at {}", folder.display());
            return None;
        };
        let mut lines = text.lines().map(fields);
        let names = lines.next().expect("a line of column names");
        let entry = |line: Vec<String>| Entry(names.iter().cloned().zip(line).collect());
        let entries = lines.map(entry).collect();
        Some(Self { folder, entries })
    }

    fn in_folder(&self, folder: &str) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(move |entry| Path::new(entry.file()).starts_with(folder))
    }

    fn read(&self, file: &str) -> Mesh {
        Mesh::read(self.folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
    }
}

/// The fields of a line of comma-separated values; in quotes, commas stand for themselves and two
/// quotes for one.
fn fields(line: &str) -> Vec<String> {
    let mut fields = vec![String::new()];
    let mut quoted = false;
    let mut characters = line.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '"' if quoted && characters.next_if_eq(&'"').is_some() => {
                fields.last_mut().unwrap().push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(String::new()),
            _ => fields.last_mut().unwrap().push(character),
        }
    }
    fields
}

impl Entry {
    fn text(&self, column: &str) -> &str {
        self.0.get(column).unwrap_or_else(|| panic!("the catalogue has no column {column}"))
    }

    fn file(&self) -> &str {
        self.text("file")
    }

    fn count(&self, column: &str) -> usize {
        self.text(column)
            .parse()
            .unwrap_or_else(|error| panic!("{}: {column}: {error}", self.file()))
    }

    /// A number `name=…` of the notes on defective meshes.
    fn measured(&self, name: &str) -> usize {
        let (_, measured) = self.text("notes").split_once("measured: ").expect("what was measured");
        let value = measured.split(' ').find_map(|word| word.strip_prefix(name)?.strip_prefix('='));
        value
            .and_then(|value| value.parse().ok())
            .unwrap_or_else(|| panic!("{}: no {name}", self.file()))
    }
}

#[test]
fn quoted_fields_are_read() {
    assert_eq!(fields(r#"a,,"b, ""c""",d,"#), ["a", "", r#"b, "c""#, "d", ""]);
}

/// Converts by `algorithm` and checks the result against `triangles`.
fn converted(triangles: &Mesh, flip_faces: bool, algorithm: Algorithm, what: &str) -> Report {
    let result = Converter::new().algorithm(algorithm).orient(flip_faces).run(triangles);
    let converted = result.unwrap_or_else(|error| panic!("{what}: {error}"));
    let summary = converted.report().clone();
    let quads = converted.mesh().clone();
    let mut oriented = triangles.clone();
    if flip_faces {
        Survey::new(triangles).orient(&mut oriented);
    }
    let paired = oriented.clone().with_faces(converted.triangles().clone());
    assert_eq!(paired.faces() == oriented.faces(), summary.edge_flips == 0, "{what}");
    assert_eq!(check_retriangulation(&paired, &oriented), Ok(()), "{what}");
    let report = check(&quads, &paired).unwrap_or_else(|mismatch| panic!("{what}: {mismatch}"));
    assert_eq!(2 * report.quads, triangles.faces().len(), "{what}");
    summary
}

// Closed meshes.

#[test]
fn every_closed_mesh_is_converted_by_every_algorithm() {
    let Some(catalogue) = Catalogue::open() else { return };
    for entry in catalogue.in_folder("closed") {
        let triangles = catalogue.read(entry.file());
        for algorithm in Algorithm::ALL {
            // The slowest by far: about 20 µs a triangle.
            if algorithm == Algorithm::DiksStanczyk && triangles.faces().len() > 50_000 {
                continue;
            }
            let what = format!("{} by {algorithm}", entry.file());
            let summary = converted(&triangles, false, algorithm, &what);
            let counts = [summary.vertices, summary.edges, summary.triangles, summary.genus];
            let expected =
                ["vertices", "edges", "triangles", "genus"].map(|column| entry.count(column));
            assert_eq!(counts, expected, "{what}");
            assert_eq!(summary.components, 1, "{what}");
        }
    }
}

#[test]
fn no_sharp_edge_of_a_part_is_lost_that_could_be_kept() {
    let Some(catalogue) = Catalogue::open() else { return };
    let files = ["fandisk_12946", "joint_41808_g2", "casting", "socket"];
    for (name, expected) in files.into_iter().zip([2, 0, 12, 21]) {
        let mesh = catalogue.read(&format!("closed/{name}.obj.gz"));
        let mut keep = Keep::default();
        keep.sharp = Some(30.0);
        let converted = Converter::new().keep(keep.clone()).run(&mesh).unwrap();
        let report = converted.report();
        let sharp = report.sharp_edges.unwrap();
        assert!(report.is_proved_least, "{name}");
        assert_eq!(report.given_up_edges, Some(expected), "{name}");
        assert_eq!((report.kept_edges, sharp.kept), (Some(sharp.all), sharp.all - expected));
        let strict = Converter::new().keep(keep).strict(true).run(&mesh).unwrap();
        let report = strict.report();
        let sharp = report.sharp_edges.unwrap();
        assert!(report.is_proved_fewest && sharp.kept == sharp.all, "{name}");
        assert_eq!(report.leftover_triangles == Some(0), expected == 0, "{name}");
    }
}

#[test]
fn expansion_leaves_as_many_unpaired_as_the_irreducible_triangulation_has() {
    let Some(catalogue) = Catalogue::open() else { return };
    for entry in catalogue.in_folder("closed") {
        let triangulation = Triangulation::build(&catalogue.read(entry.file())).unwrap();
        let k = ShrinkingTriangulation::from(triangulation.clone());
        let order = Order::File.vertex_ids(k.vertex_id_count(), &mut Random::stream(0, &[]));
        let irreducible = ramaswami_siqueira(k, order, Discipline::LastInFirstOut).triangulation;
        let left = irreducible.survivors().1.triangle_count();
        let genus = entry.count("genus");
        assert!(left >= 4 && left <= (56 * genus).saturating_sub(12).max(4));
        let flips = Expansion::ALL.map(|expansion| {
            let pairing = lrs(&triangulation, expansion, LRS_ORDER);
            assert_eq!(pairing.matching.unpaired_count(), left, "{}", entry.file());
            pairing.edge_flips
        });
        let percent = flips.map(|flips| 100.0 * flips as f64 / triangulation.edge_count() as f64);
        println!("{}: {left} unpaired, {percent:.2?} % of the edges flipped", entry.file());
        assert!(3 * flips[1] <= flips[0], "{}: {flips:?}", entry.file());
    }
}

#[test]
fn every_closed_mesh_is_simplified_to_a_tenth() {
    let Some(catalogue) = Catalogue::open() else { return };
    for entry in catalogue.in_folder("closed") {
        let file = entry.file();
        let list = catalogue.read(file);
        let triangulation = Triangulation::build(&list).unwrap();
        let vertices = triangulation.vertex_count().div_ceil(10).max(60 * entry.count("genus"));
        let largest_degree = Shape::new(&list).largest_degree;
        let mut simplifier = Simplifier::new(triangulation, list.positions());
        // Far from the 26g - 4 vertices that an irreducible triangulation of genus g may have.
        let wanted = vertices.min(simplifier.vertex_count());
        simplifier.reduce_to(wanted).unwrap_or_else(|error| panic!("{file}: {error}"));
        let (list, told) = simplifier.result();
        let built = Triangulation::build(&list).unwrap_or_else(|survey| panic!("{file}: {survey}"));
        assert_eq!(built, told, "{file}");
        assert_eq!((built.vertex_count(), built.genus()), (wanted, entry.count("genus")), "{file}");
        let shape = Shape::new(&list);
        let angles = [shape.smallest_angle(), shape.largest_angle()];
        println!("{file}: {wanted} vertices, degree {}, {angles:.1?}", shape.largest_degree);
        assert!(shape.largest_degree <= largest_degree.max(12), "{file}: {shape:?}");
    }
}

/// The mean share of triangles that `algorithm` leaves unpaired, in percent.
fn mean_unpaired_percent(triangulation: &Triangulation, algorithm: Algorithm) -> f64 {
    const SEEDS: u64 = 10;
    let unpaired = (0..SEEDS).map(|seed| {
        // The stream that a conversion with this seed uses.
        let mut random = Random::stream(seed, &[algorithm.id()]);
        algorithm.pair(triangulation, &mut random).matching.unpaired_count()
    });
    100.0 * unpaired.sum::<usize>() as f64
        / (SEEDS as usize * triangulation.triangle_count()) as f64
}

#[test]
fn greedy_pairings_of_scans_are_as_good_as_published() {
    let Some(catalogue) = Catalogue::open() else { return };
    let scans = catalogue.in_folder("closed").filter(|entry| entry.count("triangles") >= 50_000);
    let mut seen = 0;
    for entry in scans {
        let file = entry.file();
        let triangulation = Triangulation::build(&catalogue.read(file)).unwrap();
        let simple = mean_unpaired_percent(&triangulation, Algorithm::SimpleGreedy);
        assert!((12.0..=13.0).contains(&simple), "{file}: simple greedy leaves {simple} %");
        let pulli_segal = mean_unpaired_percent(&triangulation, Algorithm::PulliSegal);
        assert!(pulli_segal <= 0.21, "{file}: Pulli and Segal's leaves {pulli_segal} %");
        println!("{file}: {simple:.3} % {pulli_segal:.4} %");
        seen += 1;
    }
    assert!(seen > 0, "the catalogue lists no large scan");
}

#[test]
fn every_closed_mesh_becomes_irreducible() {
    let Some(catalogue) = Catalogue::open() else { return };
    for entry in catalogue.in_folder("closed") {
        let triangulation = Triangulation::build(&catalogue.read(entry.file())).unwrap();
        let genus = entry.count("genus");
        let mut tests = Vec::new();
        for method in Contractor::ALL {
            let what = format!("{} by {method}", entry.file());
            let result = method.reduce(triangulation.clone(), Order::File, 0);
            let left = &result.triangulation;
            assert_eq!((left.genus(), left.component_count()), (genus, 1), "{what}");
            let allowed = if genus == 0 { 4..=4 } else { 7..=26 * genus - 4 };
            assert!(allowed.contains(&left.vertex_count()), "{what}: {}", left.vertex_count());
            let k = ShrinkingTriangulation::from(left.clone());
            let mut marks = LinkMarks::new(left.vertex_count());
            let mut edges = (0..2 * left.edge_count()).map(HalfEdgeId::new);
            assert!(!edges.any(|h| k.is_contractible(h, &mut marks)), "{what}");
            tests.push(result.counts.link_condition_tests);
        }
        println!("{}: genus {genus}, link condition tests {tests:?}", entry.file());
    }
}

// Defective meshes.

/// The first law that each defective mesh breaks as it is read, and when its faces have been cut
/// into triangles.
const FIRST_BROKEN: [(&str, Option<Law>, Option<Law>); 13] = [
    ("open_pig.off", Some(Law::NoBoundary), Some(Law::NoBoundary)),
    ("bowtie_hourglass.obj", Some(Law::OneFan), Some(Law::OneFan)),
    ("nonmanifold_edge_shared.stl", Some(Law::AtMostTwoFaces), Some(Law::AtMostTwoFaces)),
    ("inconsistent_blobby.off", Some(Law::ConsistentOrientation), Some(Law::ConsistentOrientation)),
    ("nonorientable_moebius.obj", Some(Law::Triangle), Some(Law::NoBoundary)),
    ("components_two_knots.off", None, None),
    // The duplicate is a triangle and one half of a quad.
    // Of two equal quads each is cut the other way, so that no triangle is there twice.
    ("duplicate_faces_suzanne.obj", Some(Law::Triangle), Some(Law::NoBoundary)),
    ("quads_spot.obj", Some(Law::Triangle), None),
    ("polygons_dual_bunny.off", Some(Law::Triangle), None),
    ("isolated_vertices_bunny2.ply", Some(Law::NoBoundary), Some(Law::NoBoundary)),
    ("mess_office_chair.obj", Some(Law::Triangle), Some(Law::DistinctCorners)),
    ("soup_not_convex.obj", Some(Law::NoBoundary), Some(Law::NoBoundary)),
    ("duplicate_vertices_pig.stl", Some(Law::NoBoundary), Some(Law::NoBoundary)),
];

fn first_broken(list: &Mesh) -> Option<Law> {
    let survey = Triangulation::build(list).err()?;
    Some(survey.violations[0].law)
}

#[test]
fn defective_meshes_are_refused_for_what_is_wrong_first() {
    let Some(catalogue) = Catalogue::open() else { return };
    assert_eq!(catalogue.in_folder("defective").count(), FIRST_BROKEN.len());
    for (name, as_read, as_triangles) in FIRST_BROKEN {
        let mut list = catalogue.read(&format!("defective/{name}"));
        assert_eq!(first_broken(&list), as_read, "{name}");
        list.triangulate().unwrap();
        assert_eq!(first_broken(&list), as_triangles, "{name} cut into triangles");
    }
}

#[test]
fn defective_meshes_that_can_be_mended_are_converted() {
    let Some(catalogue) = Catalogue::open() else { return };
    let mendable = |law: Option<Law>| law.is_none() || law == Some(Law::ConsistentOrientation);
    for (name, _, broken) in FIRST_BROKEN.into_iter().filter(|(_, _, law)| mendable(*law)) {
        let mut triangles = catalogue.read(&format!("defective/{name}"));
        triangles.triangulate().unwrap();
        for algorithm in Algorithm::ALL {
            let what = format!("{name} by {algorithm}");
            converted(&triangles, broken.is_some(), algorithm, &what);
        }
    }
}

#[test]
fn two_knots_are_two_tori() {
    let Some(catalogue) = Catalogue::open() else { return };
    let knots = catalogue.read("defective/components_two_knots.off");
    let summary = converted(&knots, false, Algorithm::EagerRescue, "two knots");
    assert_eq!((summary.components, summary.genus), (2, 2));
}

/// The number of elements of `list` that break `law`.
fn broken(survey: &Survey, law: Law) -> usize {
    survey
        .violations
        .iter()
        .find(|violation| violation.law == law)
        .map_or(0, |violation| violation.count)
}

/// Edges with more than two sides, counted as simply as possible.
fn overfull_edges<'f>(faces: impl Iterator<Item = &'f [u32]>) -> usize {
    let mut sides: HashMap<[u32; 2], usize> = HashMap::new();
    for face in faces {
        for k in 0..face.len() {
            let [a, b] = [face[k], face[(k + 1) % face.len()]];
            *sides.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    sides.values().filter(|count| **count > 2).count()
}

fn is_degenerate(face: &[u32]) -> bool {
    (1..face.len()).any(|k| face[..k].contains(&face[k]))
}

/// Cuts every face into triangles at its first corner.
fn fanned(mesh: Mesh) -> Mesh {
    let fan =
        |face: &[u32]| (1..face.len() - 1).flat_map(|i| [0, i, i + 1]).map(|i| face[i]).collect();
    let corners: Vec<Vec<u32>> = mesh.faces().iter().map(fan).collect();
    mesh.with_faces(Faces::uniform(3, corners.concat()))
}

#[test]
fn surveys_count_what_the_catalogue_measured() {
    let Some(catalogue) = Catalogue::open() else { return };
    for entry in catalogue.in_folder("defective") {
        let file = entry.file();
        let list = catalogue.read(file);
        assert_eq!(broken(&Survey::new(&list), Law::Triangle), entry.measured("polys"), "{file}");
        // Everything else was measured on fans of triangles.
        let list = fanned(list);
        let survey = Survey::new(&list);
        let table = [
            ("boundary_edges", broken(&survey, Law::NoBoundary)),
            ("bowtie_vertices", broken(&survey, Law::OneFan)),
            ("degenerate", broken(&survey, Law::DistinctCorners)),
            ("duplicate_faces", broken(&survey, Law::DistinctFaces)),
            ("components", survey.components),
            ("unused_vertices", survey.unreferenced_vertices),
        ];
        for (name, counted) in table {
            assert_eq!(counted, entry.measured(name), "{file}: {name}");
        }
        // The catalogue counts the sides of degenerate faces too. The survey does not: a face of
        // two distinct corners has both its sides on one edge, and the edge is to be told sound
        // or not for when the face has been removed.
        let sound = list.faces().iter().filter(|face| !is_degenerate(face));
        assert_eq!(broken(&survey, Law::AtMostTwoFaces), overfull_edges(sound), "{file}");
        assert_eq!(overfull_edges(list.faces().iter()), entry.measured("edges>2"), "{file}");
        // On a one-sided surface no orientation is consistent, so there the survey tells which
        // edges close a one-sided strip instead of which ones the faces now disagree across.
        if survey.orientable {
            let counted = broken(&survey, Law::ConsistentOrientation);
            assert_eq!(counted, entry.measured("inconsistent_edges"), "{file}");
        }
    }
}

#[test]
fn boundary_loops_of_the_open_pig_agree_with_its_euler_characteristic() {
    let Some(catalogue) = Catalogue::open() else { return };
    let survey = Survey::new(&catalogue.read("defective/open_pig.off"));
    // A sphere with holes; the catalogue speaks of one hole, but counts V - E + F = -5.
    assert_eq!((survey.euler_characteristic, survey.boundary_loops), (-5, 7));
}
