//! `--open`: surfaces with boundary and one-sided ones, and the check of what comes of them.

use serde_json::Value;
use triquad::Algorithm;
use triquad::mesh::{Faces, Mesh};
use triquad_generators::{classic, grids};

use crate::surfaces::face_list;
use crate::workshop::{Workshop, assert_contains};

/// A sphere with many holes of one triangle each.
fn sphere_with_holes() -> Mesh {
    let mut surface = grids::sphere(8);
    let mut is_taken = vec![false; surface.positions.len()];
    surface.triangles.retain(|triangle| {
        let removed = triangle.iter().all(|&v| !is_taken[v as usize]);
        if removed {
            triangle.iter().for_each(|&v| is_taken[v as usize] = true);
        }
        !removed
    });
    face_list(&surface)
}

fn faces_of(mesh: &Mesh) -> Vec<Vec<u32>> {
    mesh.faces().iter().map(<[u32]>::to_vec).collect()
}

#[test]
fn an_open_surface_is_converted_on_request() {
    let workshop = Workshop::new();
    let mesh = sphere_with_holes();
    workshop.put_mesh("in.obj", &mesh);
    let line = workshop.fail("convert in.obj -o out.obj", 2);
    assert_contains(&line, &["in.obj", "boundary-edge", "--open"], "refusal");
    let mut fewest = None;
    for algorithm in Algorithm::ALL.into_iter().filter(|algorithm| algorithm.works_on_open()) {
        let options = format!("--open --algorithm {algorithm} -o out.obj --stats -");
        let stats = workshop.json(&format!("convert in.obj {options}"), 0);
        let left = stats["leftover_triangles"].as_u64().unwrap();
        let triangles = mesh.faces().len() as u64;
        assert_eq!(2 * stats["quads"].as_u64().unwrap() + left, triangles);
        assert_eq!(left, *fewest.get_or_insert(left), "{algorithm}");
        assert_eq!((left % 2, &stats["proved_fewest"]), (triangles % 2, &true.into()));
        assert!(stats["boundary_loops"].as_u64().unwrap() > 3);
        let report = workshop.succeed("check out.obj --against in.obj");
        assert_contains(&report, &["out.obj: ok"], "check");
        workshop.succeed("check out.obj --against in.obj --open");
    }
    // A mesh on other vertices is no conversion: the first thing to say is what is wrong with IN.
    workshop.put("other.obj", "v 0 0 0\n");
    let line = workshop.fail("check other.obj --against in.obj", 2);
    assert_contains(&line, &["in.obj", "boundary-edge", "--open"], "check");
    let line = workshop.fail("check other.obj --against in.obj --open", 1);
    assert_contains(&line, &["other.obj", "vertex"], "check");
    let table = workshop.succeed("convert in.obj --open --compare");
    assert_eq!(table.lines().count(), 1 + Algorithm::ALL.len() + 1);
    let reason = "ds, gw and lrs take closed, two-sided surfaces only";
    assert_eq!(table.lines().last(), Some(reason), "{table}");
}

#[test]
fn what_needs_a_closed_surface_says_so() {
    let workshop = Workshop::new();
    workshop.put_mesh("in.obj", &sphere_with_holes());
    let (open, closed): (Vec<_>, Vec<_>) =
        Algorithm::ALL.into_iter().partition(|algorithm| algorithm.works_on_open());
    let remedy =
        format!("use one of: {}", open.iter().map(|a| a.id()).collect::<Vec<_>>().join(", "));
    for algorithm in closed.into_iter().map(Algorithm::id) {
        let line = workshop.fail(&format!("convert in.obj --open --algorithm {algorithm}"), 2);
        assert_contains(&line, &[algorithm, "closed", &remedy], algorithm);
    }
    let line = workshop.fail("irreducible in.obj --open -o out.obj", 2);
    assert_contains(&line, &["in.obj", "closed"], "irreducible");
    let line = workshop.fail("irreducible in.obj -o out.obj", 2);
    assert_contains(&line, &["boundary-edge", "'triquad convert in.obj --open'"], "irreducible");
    let line = workshop.fail("simplify in.obj --vertices 9 -o out.obj", 2);
    assert_contains(&line, &["boundary-edge"], "simplify");
}

#[test]
fn other_laws_are_not_relaxed() {
    let workshop = Workshop::new();
    let mesh = sphere_with_holes();
    let mut faces = faces_of(&mesh);
    faces[5].reverse();
    workshop.put_mesh("turned.obj", &mesh.clone().with_faces(faces.iter().collect()));
    let line = workshop.fail("convert turned.obj --open -o out.obj", 2);
    assert_contains(&line, &["inconsistent-orientation", "--orient"], "turned");
    workshop.succeed("convert turned.obj --open --orient -o out.obj");
    workshop.succeed("check out.obj --against turned.obj --orient");
}

#[test]
fn one_sided_surfaces_are_converted_and_have_a_genus_of_their_own() {
    for (surface, genus, left) in [
        (classic::projective_plane(), 1, 0),
        (classic::klein_bottle(5, 4), 2, 0),
        (classic::moebius_strip(7), 1, 0),
    ] {
        let workshop = Workshop::new();
        workshop.put_surface("in.obj", &surface);
        let line = workshop.fail("convert in.obj", 2);
        assert_contains(&line, &["--open"], "refusal");
        let stats = workshop.json("convert in.obj --open -o out.obj --stats -", 0);
        assert_eq!(stats["leftover_triangles"], left);
        assert_eq!(stats["non_orientable_genus"], genus);
        workshop.succeed("check out.obj --against in.obj");
        let info = workshop.json("info in.obj --json", 2);
        assert_eq!(info["non_orientable_genus"], genus);
        assert_eq!(info["genus"], Value::Null);
        let run = workshop.run("info in.obj");
        let text = String::from_utf8(run.stdout).unwrap();
        let expected = [
            &format!("non-orientable genus   {genus}")[..],
            "genus                  none (the surface is one-sided)",
            "; or keep it one-sided with --open",
        ];
        assert_contains(&text, &expected, "info");
        let summary = workshop.succeed("convert in.obj --open -o again.obj");
        assert_contains(&summary, &[&format!("(non-orientable genus {genus}")], "summary");
    }
}

#[test]
fn the_check_refuses_missing_doubled_and_turned_faces() {
    let workshop = Workshop::new();
    let mesh = sphere_with_holes();
    workshop.put_mesh("in.obj", &mesh);
    workshop.succeed("convert in.obj --quad-dominant 0.1 --open -o out.obj");
    let faces = faces_of(&workshop.mesh("out.obj"));
    let first_of = |corners| faces.iter().position(|face: &Vec<u32>| face.len() == corners);
    let [triangle, quad] = [3, 4].map(|corners| first_of(corners).unwrap());
    let refuse = |change: &dyn Fn(&mut Vec<Vec<u32>>), told: &str| {
        let mut faces = faces.clone();
        change(&mut faces);
        workshop.put_mesh("bad.obj", &mesh.clone().with_faces(faces.iter().collect::<Faces>()));
        let line = workshop.fail("check bad.obj --against in.obj", 1);
        assert_contains(&line, &["bad.obj", told], told);
    };
    refuse(&|faces| drop(faces.remove(triangle)), "lies in no face");
    refuse(&|faces| drop(faces.remove(quad)), "lies in no face");
    refuse(&|faces| faces.push(faces[triangle].clone()), "lies in two faces");
    refuse(&|faces| faces.push(faces[quad].clone()), "lies in two faces");
    refuse(&|faces| faces[triangle].reverse(), "is turned against the triangles");
    refuse(&|faces| faces[quad].swap(0, 1), "is not two triangles");
}

#[test]
fn triangles_are_no_quads_of_a_closed_surface_unless_they_may_be_left() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &grids::sphere(5));
    let stats = workshop.json("convert in.obj --quad-dominant 0 -o out.obj --stats -", 0);
    assert_eq!(stats["proved_fewest"], false);
    assert!(stats["leftover_triangles"].as_u64().unwrap() > 0);
    let line = workshop.fail("check out.obj --against in.obj", 1);
    assert_contains(&line, &["face", "--open"], "check");
    workshop.succeed("check out.obj --against in.obj --open");
    let stats = workshop.json("convert in.obj --quad-dominant 1e9 -o out.obj --stats -", 0);
    assert_eq!(stats["leftover_triangles"], 0);
    workshop.succeed("check out.obj --against in.obj");
    let line = workshop.fail("convert --quad-dominant in.obj", 2);
    assert_contains(&line, &["price"], "a name for a price");
}

/// Numbers that `convert` and `check` both print.
const SHARED: [&str; 8] = [
    "quads",
    "degree_two_vertices",
    "quality_minimum",
    "quality_mean",
    "quality_histogram",
    "folded_quads",
    "sharp_edges",
    "sharp_edges_kept",
];

#[test]
fn the_check_measures_from_the_files_what_the_conversion_has_measured() {
    let workshop = Workshop::new();
    workshop.put_mesh("open.obj", &sphere_with_holes());
    workshop.put_surface("closed.obj", &grids::sphere(6));
    let cases = [
        ("open.obj", "--open --algorithm ps", ""),
        ("closed.obj", "--algorithm best", ""),
        ("closed.obj", "--quad-dominant 0.05", "--open"),
        ("closed.obj", "--algorithm lrs --write-triangulation k.obj", "--triangulation k.obj"),
    ];
    for (mesh, convert, check) in cases {
        let told = workshop.json(&format!("convert {mesh} {convert} -o quads.obj --stats -"), 0);
        let check = format!("check quads.obj --against {mesh} {check} --stats -");
        let measured = workshop.json(&check, 0);
        for name in SHARED {
            assert_eq!(measured[name], told[name], "{convert}: {name}");
        }
        let left = told["leftover_triangles"].as_u64().unwrap_or(0);
        assert_eq!(measured["leftover_triangles"], left);
        assert!(measured["quality_one_percent"].as_f64() >= measured["quality_minimum"].as_f64());
    }
    workshop.fail("check closed.obj --against closed.obj --stats wrong.json", 1);
    assert!(!workshop.path("wrong.json").exists());
}

#[test]
fn where_there_are_no_quads_none_are_judged() {
    let workshop = Workshop::new();
    workshop.put("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let line = workshop.succeed("convert in.obj --open -o out.obj");
    assert_contains(&line, &["-> 0 quads and 1 triangle left over"], "summary");
    assert!(!line.contains("quality") && !line.contains("folded"), "{line}");
    let table = workshop.succeed("convert in.obj --open --compare");
    let best = table.lines().find(|line| line.starts_with("best ")).unwrap();
    let words: Vec<&str> = best.split_whitespace().collect();
    assert_eq!(words[..6], ["best", "0", "1", "-", "-", "-"], "{table}");
}
