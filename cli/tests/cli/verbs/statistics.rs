//! The numbers that `convert` and `info` print.

use super::meshes::{TETRAHEDRON_OFF, irregular_mesh};
use crate::surfaces::face_list;
use crate::workshop::{Workshop, assert_contains, assert_has_fields};
use serde_json::Value;
use triquad::clock::to_nanoseconds;
use triquad::mesh::Mesh;
use triquad_generators::testing::beside;
use triquad_generators::{Surface, classic};

const STATS_FIELDS: [&str; 29] = [
    "schema",
    "input",
    "algorithm",
    "augmentation",
    "seed",
    "vertices",
    "edges",
    "triangles",
    "genus",
    "components",
    "quads",
    "unpaired_triangles",
    "paired_percent",
    "edge_flips",
    "augmenting_paths",
    "read_seconds",
    "build_seconds",
    "pairing_seconds",
    "augmentation_seconds",
    "total_seconds",
    "check_seconds",
    "write_seconds",
    "peak_memory_bytes",
    "augmenting_path_length_mean",
    "augmenting_path_length_max",
    "augmentation_triangles_visited",
    "quality_minimum",
    "quality_mean",
    "quality_histogram",
];

fn assert_near(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() <= 1e-9 * a.abs().max(b.abs()), "{what}: {a} is not {b}");
}

#[test]
fn stats_have_all_fields_and_agree_with_each_other() {
    let workshop = Workshop::new();
    let surface = irregular_mesh();
    workshop.put_surface("in.obj", &surface);
    for algorithm in triquad::Algorithm::ALL {
        for augmentation in triquad::Augmentation::ALL {
            workshop.succeed(&format!(
                "convert in.obj -o out.obj --stats stats.json --seed 3 --algorithm {algorithm} \
                 --augmentation {augmentation}"
            ));
            let stats: Value = serde_json::from_slice(&workshop.get("stats.json")).unwrap();
            assert_has_fields(&stats, &STATS_FIELDS);
            for (field, expected) in [
                ("input", "in.obj"),
                ("algorithm", algorithm.id()),
                ("augmentation", augmentation.id()),
            ] {
                assert_eq!(stats[field], expected);
            }
            assert_stats_are_consistent(&stats, &surface);
            assert_eq!(workshop.mesh("out.obj").faces().len() as u64, stats["quads"]);
        }
    }
}

fn assert_stats_are_consistent(stats: &Value, surface: &Surface) {
    let count = |field: &str| stats[field].as_u64().unwrap_or_else(|| panic!("{field}: {stats}"));
    let number = |field: &str| stats[field].as_f64().unwrap_or_else(|| panic!("{field}: {stats}"));
    let triangles = surface.triangles.len() as u64;
    let expected = [
        ("seed", 3),
        ("vertices", surface.positions.len() as u64),
        ("edges", 3 * triangles / 2),
        ("triangles", triangles),
        ("genus", 1),
        ("components", 1),
        ("quads", triangles / 2),
        ("augmenting_paths", count("unpaired_triangles") / 2),
    ];
    let flips_edges = stats["algorithm"] == "lrs";
    assert_eq!(count("edge_flips") > 0, flips_edges, "{stats}");
    let classes = stats["quality_histogram"].as_array().unwrap().iter();
    assert_eq!(classes.map(|class| class.as_u64().unwrap()).sum::<u64>(), triangles / 2);
    let [least, mean] = ["quality_minimum", "quality_mean"].map(number);
    assert!(-1.0 <= least && least <= mean && mean <= 1.0);
    for (field, expected) in expected {
        assert_eq!(count(field), expected, "{field}");
    }
    assert_eq!(count("unpaired_triangles") % 2, 0);
    let paired = 100.0 * (triangles - count("unpaired_triangles")) as f64 / triangles as f64;
    assert_near(number("paired_percent"), paired, "paired_percent");
    let total = number("pairing_seconds") + number("augmentation_seconds");
    assert_near(number("total_seconds"), total, "total_seconds");
    for field in STATS_FIELDS.iter().filter(|field| field.ends_with("_seconds")) {
        assert!(number(field) >= 0.0, "{field}");
        assert_eq!(stats[field], to_nanoseconds(number(field)), "{field}");
    }
    let (mean, longest) =
        (number("augmenting_path_length_mean"), number("augmenting_path_length_max"));
    let paths = count("augmenting_paths");
    assert!(if paths == 0 { longest == 0.0 } else { 1.0 <= mean && mean <= longest }, "{stats}");
    assert!(count("augmentation_triangles_visited") >= 2 * paths);
    if cfg!(target_os = "linux") {
        assert!(count("peak_memory_bytes") > 1 << 20);
    }
}

const INFO_FIELDS: [&str; 12] = [
    "schema",
    "input",
    "vertices",
    "unreferenced_vertices",
    "edges",
    "triangles",
    "euler_characteristic",
    "genus",
    "components",
    "boundary_loops",
    "orientable",
    "closed",
];

/// A mesh that breaks each law that a mesh with faces can break, one block of vertices a law.
fn mesh_of_all_faults() -> Mesh {
    let flipped = |mut surface: Surface| {
        surface.triangles[0].reverse();
        surface
    };
    let tetrahedron = classic::tetrahedron;
    let glued = |shared: u32| {
        let mut two = beside(&tetrahedron(), &tetrahedron());
        let merge = |v: u32| if (4..4 + shared).contains(&v) { v - 4 } else { v };
        two.triangles.iter_mut().for_each(|triangle| *triangle = triangle.map(merge));
        two
    };
    let blocks = [
        flipped(tetrahedron()),
        classic::projective_plane(),
        glued(1),
        glued(2),
        classic::moebius_strip(7),
    ];
    let surface = blocks.iter().fold(tetrahedron(), |whole, block| beside(&whole, block));
    let (mut positions, mut faces) = face_list(&surface).into_parts();
    positions[0][1] = f64::NAN;
    faces.extend([[0, 1, 9999], [1, 1, 2], surface.triangles[0]]);
    faces.push(&[0, 1, 2, 3]);

    Mesh::new(positions, faces)
}

#[test]
fn info_lists_every_broken_law() {
    let workshop = Workshop::new();
    workshop.put_mesh("faulty.off", &mesh_of_all_faults());
    let info = workshop.json("info faulty.off --json", 2);
    assert_has_fields(&info, &INFO_FIELDS);
    let violations = info["violations"].as_array().unwrap();
    for violation in violations {
        assert_has_fields(violation, &["law", "element", "count", "faces", "remedy"]);
        assert!(violation["count"].as_u64().unwrap() > 0, "{violation}");
        assert!(!violation["remedy"].as_str().unwrap().is_empty(), "{violation}");
    }
    let laws: Vec<&str> =
        violations.iter().map(|violation| violation["law"].as_str().unwrap()).collect();
    let all = [
        "index-out-of-range",
        "non-finite-coordinate",
        "not-a-triangle",
        "repeated-corner",
        "duplicate-face",
        "overfull-edge",
        "boundary-edge",
        "non-orientable",
        "inconsistent-orientation",
        "several-fans",
    ];
    assert_eq!(laws, all);
    let text = String::from_utf8(workshop.run("info faulty.off").stdout).unwrap();
    assert_contains(&text, &all, "as text");
    assert_eq!(
        (&info["orientable"], &info["closed"], &info["genus"]),
        (&false.into(), &false.into(), &Value::Null)
    );
}

#[test]
fn info_tells_the_counts_of_a_sound_mesh() {
    let workshop = Workshop::new();
    workshop.put("in.off", TETRAHEDRON_OFF);
    let info = workshop.json("info in.off --json", 0);
    assert_has_fields(&info, &INFO_FIELDS);
    let expected = [
        ("vertices", 4),
        ("unreferenced_vertices", 0),
        ("edges", 6),
        ("triangles", 4),
        ("euler_characteristic", 2),
        ("genus", 0),
        ("components", 1),
        ("boundary_loops", 0),
    ];
    for (field, expected) in expected {
        assert_eq!(info[field], expected, "{field}");
    }
    assert_eq!((&info["orientable"], &info["closed"]), (&true.into(), &true.into()));
    assert_eq!(info["violations"], Value::Array(Vec::new()));
}
