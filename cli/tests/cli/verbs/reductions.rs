//! What `simplify` and `irreducible` do.

use super::meshes::{TETRAHEDRON, bytes_of, irregular_mesh, tetrahedron_of};
use crate::workshop::{Workshop, assert_contains, assert_has_fields};
use serde_json::Value;
use triquad::Law;
use triquad::mesh::{Format, Mesh};
use triquad_generators::random::Mix;
use triquad_generators::testing::random_of;
use triquad_generators::{classic, grids};

const SIMPLIFY_FIELDS: [&str; 19] = [
    "schema",
    "input",
    "vertices",
    "edges",
    "triangles",
    "genus",
    "components",
    "result_vertices",
    "result_edges",
    "result_triangles",
    "contractions",
    "largest_degree",
    "smallest_angle_degrees",
    "largest_angle_degrees",
    "read_seconds",
    "build_seconds",
    "seconds",
    "write_seconds",
    "peak_memory_bytes",
];

#[test]
fn simplify_leaves_as_many_vertices_as_asked_for() {
    let workshop = Workshop::new();
    workshop.put_surface("in.ply", &grids::torus(20, 15));
    let summary = workshop.succeed("simplify in.ply --vertices 77 -o out.obj --stats stats.json");
    let parts = ["in.ply -> out.obj: 300 -> 77 vertices, 154 triangles (genus 1)", "degree"];
    assert_contains(&summary, &parts, "summary");
    let info = workshop.json("info out.obj --json", 0);
    for (field, expected) in [("vertices", 77), ("triangles", 154), ("genus", 1)] {
        assert_eq!(info[field], expected, "{field}");
    }
    let stats: Value = serde_json::from_slice(&workshop.get("stats.json")).unwrap();
    assert_has_fields(&stats, &SIMPLIFY_FIELDS);
    let counts = [
        ("vertices", 300),
        ("edges", 900),
        ("triangles", 600),
        ("genus", 1),
        ("components", 1),
        ("result_vertices", 77),
        ("result_edges", 231),
        ("result_triangles", 154),
        ("contractions", 223),
    ];
    for (field, expected) in counts {
        assert_eq!(stats[field], expected, "{field}");
    }
    // The library's bytes, whichever way in and out.
    let piped = workshop.run_with_input(
        "simplify - --vertices 77 -o -",
        &bytes_of(&grids::torus(20, 15), Format::Obj),
    );
    assert_eq!((piped.code, piped.stdout), (Some(0), workshop.get("out.obj")));
    assert_contains(&piped.stderr, &["77 vertices"], "summary");
}

#[test]
fn plain_simplification_is_another_one() {
    let workshop = Workshop::new();
    workshop.succeed("generate paper-box --shafts 3 --depth 9 --holes 2 -o in.obj");
    let simplified = |options: &str| {
        workshop.succeed(&format!("simplify in.obj --vertices 200 {options} -o out.obj"));
        let report = workshop.json("info out.obj --json", 0);
        assert_eq!((&report["vertices"], &report["genus"]), (&200.into(), &2.into()));
        workshop.get("out.obj")
    };
    assert_ne!(simplified(""), simplified("--plain"));
    assert_eq!(simplified("--plain"), simplified("--plain"));
}

#[test]
fn lrs_tests_edges_in_either_order() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &irregular_mesh());
    let converted = |order: &str| {
        let stats = workshop.json(&format!("convert in.obj --algorithm lrs {order} --stats -"), 0);
        (stats["lrs_order"].as_str().unwrap().to_owned(), stats["edge_flips"].clone())
    };
    assert_eq!(converted(""), converted("--lrs-order stack"));
    let [stack, queue] = ["--lrs-order stack", "--lrs-order queue"].map(converted);
    assert_eq!((stack.0.as_str(), queue.0.as_str()), ("stack", "queue"));
    assert_ne!(stack.1, queue.1);
}

#[test]
fn simplify_refuses_what_cannot_be() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &classic::seven_vertex_torus());
    let line = workshop.fail("simplify in.obj --vertices 8 -o out.obj --stats s.json", 2);
    assert_contains(&line, &["in.obj: 8 vertices wanted", "ask for 7 or fewer"], "too many");
    let line = workshop.fail("simplify in.obj --vertices 6 -o out.obj --stats s.json", 2);
    assert_contains(&line, &["in.obj: 6 vertices wanted", "ask for 7 or more"], "too few");
    workshop.put("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let line = workshop.fail("simplify open.obj --vertices 3 -o out.obj", 2);
    assert_contains(&line, &["open.obj", Law::NoBoundary.name()], "open");
}

#[test]
fn simplify_tells_what_it_does_not_carry_over() {
    let workshop = Workshop::new();
    workshop.put("in.obj", format!("{TETRAHEDRON}g rest\n{}", tetrahedron_of([5, 6, 7, 8])));
    let vertices = "v 3 0 0\nv 4 0 0\nv 3 1 0\nv 3 0 1\n";
    let mesh = workshop.get("in.obj");
    workshop.put("in.obj", [vertices.as_bytes(), &mesh].concat());
    let run = workshop.run("simplify in.obj --vertices 8 -o out.obj");
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_contains(&run.stderr, &["not carried over", "groups"], "note");
}

const IRREDUCIBLE_FIELDS: [&str; 23] = [
    "components",
    "check_seconds",
    "schema",
    "input",
    "algorithm",
    "order",
    "seed",
    "vertices",
    "edges",
    "triangles",
    "genus",
    "result_vertices",
    "result_edges",
    "result_triangles",
    "contractions",
    "link_condition_tests",
    "edges_tested_more_than_once",
    "link_vertices_visited",
    "degree_products",
    "read_seconds",
    "build_seconds",
    "seconds",
    "peak_memory_bytes",
];

#[test]
fn irreducible_keeps_a_few_vertices_where_they_are() {
    let workshop = Workshop::new();
    let surface = irregular_mesh();
    workshop.put_surface("in.obj", &surface);
    let genus = workshop.json("info in.obj --json", 0)["genus"].as_u64().unwrap();
    for method in triquad::irreducible::Contractor::ALL {
        for order in ["file", "random"] {
            workshop.succeed(&format!(
                "irreducible in.obj -o out.ply --stats stats.json --seed 3 --algorithm {method} \
                 --order {order}"
            ));
            let stats: Value = serde_json::from_slice(&workshop.get("stats.json")).unwrap();
            assert_has_fields(&stats, &IRREDUCIBLE_FIELDS);
            assert_eq!(stats.as_object().unwrap().len(), IRREDUCIBLE_FIELDS.len());
            let (vertices, triangles) = (surface.positions.len(), surface.triangles.len());
            for (field, expected) in [
                ("vertices", vertices),
                ("edges", 3 * triangles / 2),
                ("triangles", triangles),
                ("seed", 3),
            ] {
                assert_eq!(stats[field], expected, "{field}");
            }
            assert_eq!(
                (&stats["algorithm"], &stats["order"]),
                (&method.id().into(), &order.into())
            );
            assert_eq!(stats["genus"], genus);
            let result = workshop.mesh("out.ply");
            assert_eq!(stats["result_vertices"], result.positions().len());
            assert_eq!(stats["result_triangles"], result.faces().len());
            assert_eq!(stats["result_edges"], 3 * result.faces().len() / 2);
            assert_eq!(stats["contractions"], vertices - result.positions().len());
            assert_eq!(workshop.json("info out.ply --json", 0)["genus"], genus);
            let mut rest = surface.positions.iter();
            assert!(
                result.positions().iter().all(|p| rest.any(|q| q == p)),
                "moved or out of order"
            );
        }
    }
}

#[test]
fn irreducible_goes_by_algorithm_order_and_seed() {
    let workshop = Workshop::new();
    workshop.put_surface("in.off", &random_of(4, 300, Mix::Balanced, 2));
    let bytes = |options: &str| {
        workshop.succeed(&format!("irreducible in.off -o out.obj {options}"));
        workshop.get("out.obj")
    };
    assert_eq!(bytes(""), bytes("--algorithm rs --order file --seed 0"));
    assert_eq!(bytes(""), bytes("--seed 1"), "no seed without randomness");
    for random in ["--order random", "--algorithm brute-force"] {
        let seeded = |seed| bytes(&format!("{random} --seed {seed}"));
        assert_eq!(seeded(1), seeded(1));
        assert_ne!(seeded(1), seeded(2));
    }
    assert_ne!(bytes(""), bytes("--algorithm schipper"));
}

#[test]
fn irreducible_minds_its_files() {
    let workshop = Workshop::new();
    workshop.put("in.obj", TETRAHEDRON);
    let line = workshop.fail("irreducible in.obj --stats in.obj", 2);
    assert_contains(&line, &["--stats"], "statistics over the input");
    workshop.fail("irreducible in.obj -o - --stats -", 2);
    workshop.fail("irreducible in.obj --algorithm tq", 2);
    workshop.fail("irreducible in.obj -o out.stl", 2);
    workshop.put("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let line = workshop.fail("irreducible open.obj -o out.obj --stats s.json", 2);
    assert_contains(&line, &["open.obj", "boundary-edge"], "an open mesh");
    let run = workshop.run_with_input("irreducible - -o -", TETRAHEDRON.as_bytes());
    assert_eq!(run.code, Some(0), "{run:?}");
    let result = Mesh::parse(&run.stdout, Format::Obj).unwrap();
    assert_eq!((result.positions().len(), result.faces().len()), (4, 4));
    assert_contains(&run.stderr, &["4 vertices", "irreducible"], "the summary");
}
