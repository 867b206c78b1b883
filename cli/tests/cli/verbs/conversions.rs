//! What `convert` does.

use std::io::Read as _;

use super::meshes::{CUBE, TETRAHEDRON, irregular_mesh, with_faces};
use crate::workshop::{Workshop, assert_contains, finish};
use serde_json::Value;
use triquad::mesh::{Format, Mesh};
use triquad_generators::random::Mix;
use triquad_generators::testing::{beside, random_of};
use triquad_generators::{classic, grids};

#[test]
fn convert_check_and_info_do_their_work() {
    let workshop = Workshop::new();
    workshop.put_surface("in.ply", &irregular_mesh());
    let summary = workshop.succeed("convert in.ply -o out.obj");
    assert_eq!(summary.lines().count(), 1);
    assert_contains(&summary, &["in.ply -> out.obj", "genus 1"], "summary");
    let report = workshop.succeed("check out.obj --against in.ply");
    assert_contains(&report, &["out.obj: ok", "in.ply"], "check");
    let info = workshop.succeed("info in.ply");
    assert_contains(&info, &["genus                  1", "closed                 yes"], "info");
    let triangles = workshop.mesh("in.ply");
    assert_eq!(workshop.mesh("out.obj").faces().len(), triangles.faces().len() / 2);
}

#[test]
fn every_algorithm_augmentation_and_format_works_together() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &irregular_mesh());
    for algorithm in triquad::Algorithm::ALL {
        for augmentation in triquad::Augmentation::ALL {
            for output in
                ["out.obj", "out.ply", "out.off", "out.obj.gz", "out.ply.gz", "out.off.gz"]
            {
                workshop.succeed(&format!(
                    "convert in.obj -o {output} --algorithm {algorithm} --augmentation {augmentation} \
                     --write-triangulation paired.obj"
                ));
                workshop.succeed(&format!(
                    "check {output} --against in.obj --triangulation paired.obj"
                ));
            }
        }
    }
}

#[test]
fn the_triangulation_whose_triangles_were_paired_is_written() {
    let workshop = Workshop::new();
    let mesh = irregular_mesh();
    workshop.put_surface("in.obj", &mesh);
    workshop.succeed("convert in.obj --write-triangulation same.obj");
    assert_eq!(workshop.mesh("same.obj"), workshop.mesh("in.obj"));

    workshop.succeed("convert in.obj --algorithm lrs -o out.obj --write-triangulation k.ply");
    let line = workshop.fail("check out.obj --against in.obj", 1);
    let told = ["out.obj", "is not two triangles", "--write-triangulation", "--triangulation"];
    assert_contains(&line, &told, "quads of flipped triangles");
    let line = workshop.fail("check out.obj --against in.obj --triangulation in.obj", 1);
    assert!(!line.contains("--triangulation"), "{line}");
    let report = workshop.succeed("check out.obj --against in.obj --triangulation k.ply");
    assert_contains(&report, &["out.obj: ok", "k.ply"], "check");
    workshop.put_surface("sphere.obj", &grids::sphere(4));
    workshop.fail("check out.obj --against sphere.obj --triangulation k.ply", 1);
    workshop.fail("check out.obj --against in.obj --triangulation sphere.obj", 1);
    let cut = with_faces(&workshop.mesh("k.ply"), |faces| drop(faces.pop()));
    workshop.put_mesh("cut.obj", &cut);
    workshop.fail("check out.obj --against in.obj --triangulation cut.obj", 2);

    for (arguments, told) in [
        ("-o out.obj --write-triangulation out.obj", "--write-triangulation would overwrite"),
        ("--stats s.obj --write-triangulation s.obj", "--stats would overwrite"),
        ("-o - --write-triangulation -", "would mix on standard output"),
        ("--stats - --write-triangulation -", "would mix on standard output"),
    ] {
        let line = workshop.fail(&format!("convert in.obj {arguments}"), 2);
        assert_contains(&line, &[told], arguments);
    }
}

#[test]
fn without_output_nothing_is_written() {
    let workshop = Workshop::new();
    workshop.put("in.obj", TETRAHEDRON);
    assert_contains(&workshop.succeed("convert in.obj"), &["4 triangles", "2 quads"], "summary");
    assert_eq!(workshop.names().len(), 1);
}

#[test]
fn faults_that_can_be_mended_are_mended_on_request() {
    let turned = TETRAHEDRON.replace("f 1 3 2", "f 1 2 3");
    let turned_cube = CUBE.replace("f 5 6 7 8", "f 8 7 6 5");
    let table = [
        (turned.as_str(), "--orient", "4-4-2"),
        (CUBE, "--triangulate", "8-12-6"),
        (turned_cube.as_str(), "--orient --triangulate", "8-12-6"),
    ];
    for (text, repairs, counts) in table {
        let workshop = Workshop::new();
        workshop.put("in.obj", text);
        workshop.fail("convert in.obj -o out.obj", 2);
        workshop.succeed(&format!("convert in.obj -o out.obj {repairs}"));
        workshop.succeed(&format!("check out.obj --against in.obj {repairs}"));
        workshop.fail("check out.obj --against in.obj", 2);
        let quads = workshop.mesh("out.obj");
        let triangles = 2 * quads.faces().len();
        assert_eq!(
            format!("{}-{triangles}-{}", quads.positions().len(), quads.faces().len()),
            counts,
            "{repairs}"
        );
    }
}

#[test]
fn what_cannot_be_mended_is_refused_all_the_same() {
    let workshop = Workshop::new();
    workshop.put("open.obj", &TETRAHEDRON[..TETRAHEDRON.len() - 8]);
    workshop.put_surface("plane.obj", &classic::projective_plane());
    for (file, law) in [("open.obj", "boundary-edge"), ("plane.obj", "non-orientable")] {
        let line = workshop.fail(&format!("convert {file} -o out.obj --orient --triangulate"), 2);
        assert_contains(&line, &[file, law], file);
    }
}

#[test]
fn unreferenced_vertices_stay_where_they_are() {
    let workshop = Workshop::new();
    workshop.put(
        "in.obj",
        "v 7 7 7\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 0 1 0\nv 0 0 1\nv -0.0 1e-300 9\n\
                            f 2 5 3\nf 2 3 6\nf 3 5 6\nf 5 2 6\n",
    );
    workshop.succeed("convert in.obj -o out.obj");
    workshop.succeed("check out.obj --against in.obj");
    let [triangles, quads] = ["in.obj", "out.obj"].map(|name| workshop.mesh(name));
    assert_eq!(quads.positions(), triangles.positions());
    let info = workshop.json("info in.obj --json", 0);
    assert_eq!((&info["vertices"], &info["unreferenced_vertices"]), (&4.into(), &3.into()));
    assert_eq!(info["euler_characteristic"], 2);
}

#[test]
fn components_are_converted_together() {
    let workshop = Workshop::new();
    workshop.put_surface("in.off", &beside(&irregular_mesh(), &random_of(2, 50, Mix::Flips, 1)));
    let stats = workshop.json("convert in.off -o out.off --stats -", 0);
    assert_eq!((&stats["components"], &stats["genus"]), (&2.into(), &3.into()));
    workshop.succeed("check out.off --against in.off");
}

#[test]
fn the_seed_decides_the_bytes() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &irregular_mesh());
    for algorithm in triquad::Algorithm::ALL.map(triquad::Algorithm::id) {
        for extension in ["obj", "obj.gz", "ply"] {
            let mut results =
                ["7", "7", "8"].into_iter().zip(["a", "b", "c"]).map(|(seed, name)| {
                    let output = format!("{name}.{extension}");
                    workshop.succeed(&format!(
                        "convert in.obj -o {output} --algorithm {algorithm} --seed {seed}"
                    ));
                    workshop.get(&output)
                });
            let [first, same, other] = [(); 3].map(|()| results.next().unwrap());
            assert!(first == same, "{algorithm} to {extension}: equal seeds, other bytes");
            let matters = ["sg", "ps"].contains(&algorithm);
            assert_eq!(first != other, matters, "{algorithm} to {extension}: another seed");
        }
    }
}

#[test]
fn standard_input_and_output_are_obj() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &irregular_mesh());
    workshop.succeed("convert in.obj -o out.obj");
    let input = workshop.get("in.obj");
    let run = workshop.run_with_input("convert - -o -", &input);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    assert!(run.stdout == workshop.get("out.obj"));
    assert_eq!(run.stderr.lines().count(), 1, "the summary: {}", run.stderr);

    let run = workshop.run_with_input("info - --json", &input);
    let info: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!((&info["genus"], info["violations"].as_array().unwrap().len()), (&1.into(), 0));
    let run = workshop.run_with_input("check out.obj --against -", &input);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
}

#[test]
fn data_and_summary_do_not_mix() {
    let workshop = Workshop::new();
    workshop.put("in.obj", TETRAHEDRON);
    let run = workshop.run("convert in.obj -o out.obj --stats -");
    serde_json::from_slice::<Value>(&run.stdout).unwrap();
    assert_eq!(run.stderr.lines().count(), 1, "{}", run.stderr);
    let run = workshop.run("convert in.obj -o - --stats stats.json");
    assert_eq!(Mesh::parse(&run.stdout, Format::Obj).unwrap().faces().len(), 2);
    assert_eq!(run.stderr.lines().count(), 1, "{}", run.stderr);
    let line = workshop.fail("convert in.obj -o - --stats -", 2);
    assert_contains(&line, &["-o -", "--stats -", "file"], "both to standard output");
}

#[test]
fn a_reader_that_goes_away_causes_no_panic() {
    let workshop = Workshop::new();
    // Far more than a pipe holds.
    workshop.put_surface("in.obj", &grids::sphere(70));
    for arguments in
        ["convert in.obj -o -", "convert in.obj --stats -", "convert in.obj", "info in.obj --json"]
    {
        let mut child = workshop.spawn(&arguments.split(' ').collect::<Vec<_>>());
        let mut stdout = child.stdout.take().unwrap();
        if arguments.ends_with("-o -") {
            stdout.read_exact(&mut [0; 10]).unwrap();
        }
        drop(stdout);
        let run = finish(child);
        assert!(matches!(run.code, Some(0 | 2)), "{arguments}: {run:?}");
        assert!(!run.stderr.contains("panicked"), "{arguments}: {run:?}");
    }
}
