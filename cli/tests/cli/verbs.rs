//! The command-line tool as its users meet it: files, exit codes, one line of reasons, no remains.

use std::io::Read as _;
use std::process::Command;

use crate::surfaces::face_list;
use crate::workshop::{Workshop, assert_contains, finish};
use serde_json::Value;
use triquad::Law;
use triquad::mesh::{Faces, Format, Mesh};
use triquad_generators::random::Mix;
use triquad_generators::testing::{beside, random_of};
use triquad_generators::{Surface, classic, grids};

// Meshes.

const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

const TETRAHEDRON_OFF: &str =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

fn bytes_of(surface: &Surface, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    face_list(surface).write_to(&mut bytes, format).unwrap();
    bytes
}

fn without_end(mut bytes: Vec<u8>, missing: usize) -> Vec<u8> {
    bytes.truncate(bytes.len() - missing);
    bytes
}

fn ascii_ply(faces: &str) -> String {
    let count = faces.lines().count();
    format!(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         element face {count}\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n{faces}"
    )
}

/// Two triangles, of which the second is cut off.
fn truncated_binary_stl() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend(2u32.to_le_bytes());
    bytes.extend([0; 99]);
    bytes
}

fn truncated_ascii_stl() -> &'static str {
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
}

fn truncated_gzip() -> Vec<u8> {
    let workshop = Workshop::new();
    workshop.put_surface("a.obj.gz", &grids::sphere(6));
    without_end(workshop.get("a.obj.gz"), 300)
}

/// A mesh of more than 500 triangles for which the greedy algorithms have many choices.
fn irregular_mesh() -> Surface {
    random_of(1, 400, Mix::Balanced, 5)
}

// What should work.

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
    assert_contains(&line, &["out.obj", "is not two triangles"], "quads of flipped triangles");
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

// Statistics.

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

fn assert_has_fields(json: &Value, fields: &[&str]) {
    for field in fields {
        assert!(json.get(field).is_some(), "no field {field} in {json}");
    }
}

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
        assert_has_fields(violation, &["law", "element", "count", "remedy"]);
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

// What is refused.

/// A file that breaks a law, and what the line on standard error must say: place | law | remedy.
type Refusal = (&'static str, Vec<u8>, &'static str);

fn refusal(file: &'static str, content: impl Into<Vec<u8>>, says: &'static str) -> Refusal {
    (file, content.into(), says)
}

fn tetrahedron_of([a, b, c, d]: [usize; 4]) -> String {
    format!("f {a} {c} {b}\nf {a} {b} {d}\nf {b} {c} {d}\nf {c} {a} {d}\n")
}

/// The tetrahedron with one more line.
fn with_line(file: &'static str, line: &str, says: &'static str) -> Refusal {
    refusal(file, format!("{TETRAHEDRON}{line}\n"), says)
}

/// The tetrahedron with another second vertex.
fn with_vertex(file: &'static str, line: &str, says: &'static str) -> Refusal {
    refusal(file, TETRAHEDRON.replace("v 1 0 0", line), says)
}

/// Surfaces that break a law of the surface itself.
fn broken_surfaces() -> Vec<Refusal> {
    let open = &TETRAHEDRON[..TETRAHEDRON.len() - 8];
    // What is not carried over is no reason for a second line.
    let coloured = open.replace(" 0\n", " 0 1 1 1\n");
    let two =
        |shared| format!("{TETRAHEDRON}v 2 0 0\nv 0 2 0\nv 0 0 2\n{}", tetrahedron_of(shared));
    let turned = TETRAHEDRON.replace("f 1 3 2", "f 1 2 3");
    let plane = bytes_of(&classic::projective_plane(), Format::Off);
    vec![
        refusal("open.obj", open, "edge 1-3 | boundary edge | close the holes"),
        refusal("coloured.obj", coloured, "edge 1-3 | boundary edge | close the holes"),
        refusal(
            "full.obj",
            two([1, 2, 5, 6]),
            "edge 1-2 | more than two faces | separate the sheets",
        ),
        refusal("bow-tie.obj", two([4, 5, 6, 7]), "vertex 4 | several fans | a vertex of its own"),
        refusal("turned.obj", turned, "edge 1-2 | same direction | --orient"),
        refusal("one-sided.off", plane, "edge | non-orientable | cut the strip"),
        refusal("cube.obj", CUBE, "face 1 | not a triangle | --triangulate"),
        with_line("line.obj", "f 1 2", "face 5 | not a triangle | remove"),
        with_line("nothing.obj", "f", "face 5 | not a triangle | remove"),
        with_line("repeated.obj", "f 1 1 2", "face 5 | repeats a corner | remove degenerate"),
        with_line("duplicate.obj", "f 2 1 3", "face 5 | same corners | remove duplicate"),
    ]
}

/// Numbers and indices that mean nothing.
fn wrong_numbers() -> Vec<Refusal> {
    let off = |from, to| TETRAHEDRON_OFF.replace(from, to);
    let header = "ply\nformat ascii 2 bits\nelephant 3\n";
    vec![
        with_line("far.obj", "f 3 1 9", "face 5 | does not exist | correct the face"),
        refusal(
            "far.ply",
            ascii_ply("3 0 1 2\n3 0 4 3\n"),
            "face 2 | does not exist | correct the face",
        ),
        refusal("far.off", off("3 0 1 3", "3 0 1 4"), "face 2 | does not exist | correct the face"),
        with_line("zero.obj", "f 0 1 2", "line 9 | indices start at 1 | export it again"),
        with_line("before.obj", "f -1 -2 -5", "line 9 | out of range | export it again"),
        with_line("huge.obj", "f 1 2 99999999999", "line 9 | not an index | export it again"),
        with_line("corner.obj", "f 1 2 x", "line 9 | 'x' is not an index | export it again"),
        refusal("minus.off", off("3 0 1 3", "3 0 -1 3"), "line 8 | '-1' | export it again"),
        with_vertex("nan.obj", "v nan 0 0", "vertex 2 | NaN or infinite | correct the vertex"),
        with_vertex("inf.obj", "v 1 -inf 0", "vertex 2 | NaN or infinite | correct the vertex"),
        with_vertex("large.obj", "v 1 0 1e999", "vertex 2 | NaN or infinite | correct the vertex"),
        refusal(
            "nan.off",
            off("\n1 0 0", "\nnan 0 0"),
            "vertex 2 | NaN or infinite | correct the vertex",
        ),
        with_vertex("word.obj", "v 1 zero 0", "line 2 | 'zero' is not a number | export it again"),
        with_vertex("comma.obj", "v 1 0,5 0", "line 2 | '0,5' is not a number | export it again"),
        with_vertex("short.obj", "v 1 0", "line 2 | three coordinates | export it again"),
        with_vertex("bare.obj", "v", "line 2 | three coordinates | export it again"),
        refusal("word.off", off("\n1 0 0", "\n1 l 0"), "line 4 | 'l' | export it again"),
        refusal("word.ply", ascii_ply("3 0 1 2\n3 0 one 2\n"), "line 15 | 'one' | export it again"),
        refusal("header.ply", header, "line 3 | 'elephant' | export it again"),
    ]
}

/// Files that are not whole, or nothing at all.
fn incomplete_files() -> Vec<Refusal> {
    let whole = bytes_of(&grids::sphere(3), Format::Ply);
    let off = &TETRAHEDRON_OFF[..TETRAHEDRON_OFF.len() - 8];
    let truncated = "end of file | truncated | copy or export the file again";
    let no_faces = "the mesh | has no faces | exported with faces";
    vec![
        refusal("binary.ply", without_end(whole, 1), "face 72 of 72 | truncated | copy or export"),
        refusal(
            "ascii.ply",
            ascii_ply("3 0 1 2\n3 0 1\n"),
            "face 2 of 2 | truncated | copy or export",
        ),
        refusal("header.ply", "ply\nformat ascii 1.0\nelement vertex 4\n", truncated),
        refusal("faces.off", off, "face 4 of 4 | truncated | copy or export"),
        refusal(
            "vertices.off",
            "OFF\n4 4 6\n0 0 0\n",
            "vertex 2 of 4 | truncated | copy or export",
        ),
        refusal(
            "binary.stl",
            truncated_binary_stl(),
            "triangle 2 of 2 | truncated | copy or export",
        ),
        refusal("ascii.stl", truncated_ascii_stl(), truncated),
        refusal("zipped.obj.gz", truncated_gzip(), truncated),
        refusal("points.obj", "v 0 0 0\nv 1 0 0\n", no_faces),
        refusal("points.off", "OFF\n1 0 0\n1 2 3\n", no_faces),
        refusal("points.ply", ascii_ply(""), no_faces),
        refusal("solid.stl", "solid nothing\nendsolid nothing\n", no_faces),
        refusal("empty.obj", "", no_faces),
        refusal("empty.obj.gz", "", no_faces),
        refusal("empty.ply", "", truncated),
        refusal("empty.off", "", truncated),
        refusal("empty.stl", "", truncated),
    ]
}

#[test]
fn bad_input_is_refused_with_place_law_and_remedy() {
    let refusals = [broken_surfaces(), wrong_numbers(), incomplete_files()];
    for (file, content, says) in refusals.into_iter().flatten() {
        let assert_told = |line: &str| {
            assert_contains(line, &[file], file);
            assert_contains(line, &says.split(" | ").collect::<Vec<_>>(), file);
        };
        let workshop = Workshop::new();
        workshop.put(file, content);
        let convert = format!("convert {file} -o out.obj --stats stats.json");
        assert_told(&workshop.fail(&convert, 2));
        workshop.put("out.obj", "v 0 0 0\n");
        workshop.put("stats.json", "older stats");
        assert_told(&workshop.fail(&convert, 2));
        assert_told(&workshop.fail(&format!("check out.obj --against {file}"), 2));
        if file == "cube.obj" {
            // Quads that close up are a sound mesh, only no triangulation.
            workshop.succeed("info cube.obj");
        } else {
            assert_contains(&workshop.fail(&format!("info {file}"), 2), &[file], file);
        }
    }
}

#[test]
fn files_that_cannot_be_read_or_written_are_refused() {
    let paths = "check the path and its permissions";
    let reading = "use .obj, .ply, .off or .stl";
    let own = "a file of its own";
    let table: [(&str, &[&str]); 22] = [
        ("convert in.obj -o in.obj", &["in.obj: -o would overwrite", own]),
        ("convert in.obj -o ./in.obj", &["./in.obj: -o would overwrite", own]),
        ("irreducible in.obj -o in.obj", &["in.obj: -o would overwrite", own]),
        (
            "convert in.obj --write-triangulation in.obj",
            &["in.obj: --write-triangulation would overwrite", own],
        ),
        ("convert in.obj -o out.obj --stats out.obj", &["out.obj", "overwrite", own]),
        ("convert in.obj -o out.obj --stats ./out.obj", &["out.obj", "overwrite", own]),
        ("convert in.obj -o out.obj --stats in.obj", &["in.obj", "overwrite", own]),
        ("convert missing.obj -o out.obj", &["missing.obj", paths]),
        ("check missing.obj --against in.obj", &["missing.obj", paths]),
        ("check in.obj --against missing.obj", &["missing.obj", paths]),
        ("info missing.obj", &["missing.obj", paths]),
        ("convert folder.obj -o out.obj", &["folder.obj", paths]),
        ("info folder.obj", &["folder.obj", paths]),
        ("convert in.xyz -o out.obj", &["in.xyz", "unknown mesh format", reading]),
        ("convert in -o out.obj", &["in: ", "unknown mesh format", reading]),
        ("info in.gz", &["in.gz", "unknown mesh format", reading]),
        ("convert in.obj -o out.xyz", &["out.xyz", "unknown mesh format", ".obj"]),
        (
            "convert in.obj -o out.stl",
            &["out.stl", "read, not written", "write .obj, .ply or .off"],
        ),
        ("convert in.obj -o missing/out.obj", &["missing/out.obj", paths]),
        ("convert in.obj -o folder.obj", &["folder.obj", "is a folder", paths]),
        ("convert in.obj -o out.obj --stats missing/stats.json", &["missing/stats.json", paths]),
        ("convert in.obj -o out.obj --stats folder.obj", &["folder.obj", "is a folder", paths]),
    ];
    let workshop = Workshop::new();
    for name in ["in.obj", "in.xyz", "in", "in.gz"] {
        workshop.put(name, TETRAHEDRON);
    }
    std::fs::create_dir(workshop.path("folder.obj")).unwrap();
    for (arguments, parts) in table {
        assert_contains(&workshop.fail(arguments, 2), parts, arguments);
    }
}

#[test]
fn a_read_only_folder_is_refused_before_any_work() {
    let workshop = Workshop::new();
    workshop.put("in.obj", TETRAHEDRON);
    let folder = workshop.path("locked");
    std::fs::create_dir(&folder).unwrap();
    let set_read_only = |read_only| {
        let mut permissions = std::fs::metadata(&folder).unwrap().permissions();
        permissions.set_readonly(read_only);
        std::fs::set_permissions(&folder, permissions).unwrap();
    };
    set_read_only(true);
    // Root and some file systems do not care.
    if std::fs::write(folder.join("probe"), "").is_ok() {
        println!("skipped: read-only folders can be written to here");
        return;
    }
    for arguments in
        ["convert in.obj -o locked/out.obj", "convert in.obj -o out.obj --stats locked/stats.json"]
    {
        let line = workshop.fail(arguments, 2);
        assert_contains(&line, &["locked/", "check the path and its permissions"], arguments);
    }
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
    set_read_only(false);
}

#[test]
fn wrong_usage_ends_with_2() {
    let workshop = Workshop::new();
    workshop.put("in.obj", TETRAHEDRON);
    let table = [
        ("", "Usage"),
        ("juggle in.obj", "juggle"),
        ("convert", "<IN>"),
        ("convert in.obj --algorithm magic", "magic"),
        ("convert in.obj --augmentation magic", "magic"),
        ("convert in.obj --seed minus", "minus"),
        ("convert in.obj --seed -1", "-1"),
        ("check in.obj", "--against"),
        ("info in.obj --xml", "--xml"),
        ("simplify in.obj", "--vertices"),
        ("simplify in.obj --vertices few", "few"),
    ];
    for (arguments, named) in table {
        let run = workshop.run(arguments);
        assert_eq!(run.code, Some(2), "{arguments}: {run:?}");
        assert_contains(&run.stderr, &[named], arguments);
        assert!(run.stdout.is_empty(), "{arguments}: {run:?}");
        assert!(arguments.is_empty() || run.stderr.lines().count() == 1, "{arguments}: {run:?}");
    }
    for arguments in
        ["--help", "--version", "convert --help", "check --help", "info --help", "simplify --help"]
    {
        assert!(!workshop.succeed(arguments).is_empty());
    }
}

// What simplify does.

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

// What generate makes.

#[test]
fn boxes_are_made_to_order() {
    let workshop = Workshop::new();
    let wanted = "generate box --vertices 1000 --cavities 3 --holes 2";
    let line = workshop.succeed(&format!("{wanted} -o box.obj"));
    assert_contains(&line, &["box.obj", "1000 vertices", "2004 triangles", "genus 2"], wanted);
    let report = workshop.json("info box.obj --json", 0);
    assert_eq!((&report["vertices"], &report["genus"]), (&1000.into(), &2.into()));
    workshop.succeed(&format!("{wanted} --seed 5 -o again.obj"));
    assert_eq!(workshop.get("box.obj"), workshop.get("again.obj"));
    let printed = workshop.run(&format!("{wanted} -o -"));
    assert_eq!((printed.code, printed.stdout), (Some(0), workshop.get("box.obj")));
}

#[test]
fn boxes_of_the_papers_kind_are_made_to_order() {
    let workshop = Workshop::new();
    let wanted = "generate paper-box --shafts 3 --depth 5";
    // 2 (7 · 9 + 9 · 7 + 7 · 7) + 2 lattice vertices outside, 2 · 63 centres, 9 · 20 in shafts.
    for (holes, vertices, triangles) in [(0, 658, 1312), (4, 666, 1344)] {
        let line = workshop.succeed(&format!("{wanted} --holes {holes} -o box.obj"));
        let counts = format!("{vertices} vertices, {triangles} triangles, genus {holes}");
        assert_contains(&line, &[counts.as_str()], wanted);
        let report = workshop.json("info box.obj --json", 0);
        assert_eq!((&report["vertices"], &report["genus"]), (&vertices.into(), &holes.into()));
    }
    let drawn = |seed| {
        workshop.succeed(&format!("{wanted} --walls drawn --seed {seed} -o drawn.obj"));
        workshop.get("drawn.obj")
    };
    assert_eq!(drawn(1), drawn(1));
    assert_ne!(drawn(1), drawn(2));
    let line = workshop.fail("generate paper-box --shafts 3 --holes 10 -o no.obj", 2);
    assert_contains(&line, &["10 holes, but only 9 shafts", "fewer holes"], "too many holes");
}

#[test]
fn stand_ins_are_kept_in_the_cache() {
    let workshop = Workshop::new();
    let wanted = "generate stand-in --vertices 700 --genus 3 --cache kept";
    // Each mesh has a seal beside it.
    workshop.succeed(&format!("{wanted} -o one.ply"));
    assert_eq!(workshop.path("kept").read_dir().unwrap().count(), 2);
    workshop.succeed(&format!("{wanted} --seed 0 -o same.ply"));
    assert_eq!(workshop.path("kept").read_dir().unwrap().count(), 2);
    workshop.succeed(&format!("{wanted} --seed 1 -o other.ply"));
    assert_eq!(workshop.get("one.ply"), workshop.get("same.ply"));
    assert_ne!(workshop.get("one.ply"), workshop.get("other.ply"));
    let report = workshop.json("info one.ply --json", 0);
    assert_eq!((&report["vertices"], &report["genus"]), (&700.into(), &3.into()));
}

#[test]
fn the_papers_meshes_are_made_by_name() {
    let workshop = Workshop::new();
    workshop.succeed("generate paper socket --cache kept -o socket.off");
    let report = workshop.json("info socket.off --json", 0);
    assert_eq!((&report["triangles"], &report["genus"]), (&1696.into(), &7.into()));
    let line = workshop.fail("generate paper A9 -o a9.obj", 2);
    assert_contains(&line, &["A9", "ir-B4"], "an unknown name");
}

#[test]
fn what_cannot_be_made_is_refused_with_the_minimum() {
    let workshop = Workshop::new();
    let line = workshop.fail("generate box --vertices 31 --holes 1 -o box.obj", 2);
    assert_contains(&line, &["at least 32 vertices, not 31"], "too small a box");
    let line = workshop.fail("generate stand-in --vertices 8 --genus 2 -o no.obj --cache .", 2);
    assert_contains(&line, &["8 vertices wanted", "ask for more"], "too small a stand-in");
    let line = workshop.fail("generate box --vertices 100 -o box.xyz", 2);
    assert_contains(&line, &["box.xyz"], "an unknown format");
    let line = workshop.fail("generate box --vertices 100", 2);
    assert_contains(&line, &["--output"], "no target");
}

// What the check finds.

/// The vertices of `mesh` with its faces changed.
fn with_faces(mesh: &Mesh, change: impl FnOnce(&mut Vec<Vec<u32>>)) -> Mesh {
    let mut faces: Vec<Vec<u32>> = mesh.faces().iter().map(<[u32]>::to_vec).collect();
    change(&mut faces);
    mesh.clone().with_faces(Faces::from_iter(faces))
}

#[test]
fn check_says_no_to_wrong_quads() {
    let workshop = Workshop::new();
    let mesh = random_of(1, 40, Mix::Balanced, 2);
    workshop.put_surface("in.obj", &mesh);
    workshop.succeed("convert in.obj -o quads.obj");
    let good = workshop.mesh("quads.obj");

    let mut moved = good.clone();
    let last_bit = &mut moved.positions_mut()[6][2];
    *last_bit = f64::from_bits(last_bit.to_bits() + 1);
    let more = [good.positions(), &[[5.0; 3]]].concat();
    let one_more = Mesh::new(more, good.faces().clone());
    // The same vertices in the same places, but numbered another way in the triangles.
    let mut other = mesh.clone();
    let vertices = other.positions.len() as u32;
    other
        .triangles
        .iter_mut()
        .for_each(|triangle| *triangle = triangle.map(|v| (v + 1) % vertices));
    workshop.put_surface("other.obj", &other);
    workshop.succeed("convert other.obj -o other_quads.obj");

    let table = [
        ("a vertex moved", moved, "vertex 7 has other coordinates"),
        ("a vertex more", one_more, "vertices"),
        ("corners of two quads swapped", with_faces(&good, |faces| swap_corners(faces)), ""),
        ("a quad with two corners swapped", with_faces(&good, |faces| faces[3].swap(0, 1)), ""),
        ("a quad turned over", with_faces(&good, |faces| faces[3].reverse()), ""),
        (
            "all quads turned over",
            with_faces(&good, |faces| faces.iter_mut().for_each(|face| face.reverse())),
            "",
        ),
        ("a quad missing", with_faces(&good, |faces| drop(faces.remove(4))), ""),
        ("a quad doubled", with_faces(&good, |faces| faces.push(faces[4].clone())), ""),
        ("a quad instead of another", with_faces(&good, |faces| faces[5] = faces[4].clone()), ""),
        ("a triangle among them", with_faces(&good, |faces| faces[2].truncate(3)), "face 3"),
        ("an index too high", with_faces(&good, |faces| faces[2][1] = vertices), "face 3"),
        ("a corner repeated", with_faces(&good, |faces| faces[2][1] = faces[2][0]), ""),
        ("the triangles themselves", face_list(&mesh), "face 1"),
        ("quads of another mesh", workshop.mesh("other_quads.obj"), ""),
    ];
    for (name, quads, expected) in table {
        workshop.put_mesh("wrong.obj", &quads);
        let line = workshop.fail("check wrong.obj --against in.obj", 1);
        assert_contains(&line, &["wrong.obj", expected], name);
    }
    workshop.succeed("check quads.obj --against in.obj");
}

/// Exchanges the first corners of two quads that share none.
fn swap_corners(faces: &mut [Vec<u32>]) {
    let far = (1..faces.len()).find(|&k| faces[k].iter().all(|v| !faces[0].contains(v)));
    let (first, others) = faces.split_at_mut(far.expect("more than a few quads"));
    std::mem::swap(&mut first[0][0], &mut others[0][0]);
}

#[test]
fn turned_quads_are_the_same_quads() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &irregular_mesh());
    workshop.succeed("convert in.obj -o quads.obj");
    let turned = with_faces(&workshop.mesh("quads.obj"), |faces| {
        faces.iter_mut().enumerate().for_each(|(k, face)| face.rotate_left(k % 4));
        faces.reverse();
    });
    workshop.put_mesh("turned.obj", &turned);
    workshop.succeed("check turned.obj --against in.obj");
}

// Irreducible triangulations.

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

// Interrupts.

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing_behind() {
    use std::time::Duration;

    let workshop = Workshop::new();
    // 300,000 triangles, of which simple greedy leaves tens of thousands to slow searches.
    workshop.put_surface("in.ply", &grids::sphere(194));
    let arguments =
        "convert in.ply -o out.obj --stats stats.json --augmentation tarjan --algorithm sg";
    let mut child = workshop.spawn(&arguments.split(' ').collect::<Vec<_>>());
    // Long enough to be among the searches, which take far longer.
    std::thread::sleep(Duration::from_millis(1500));
    assert!(child.try_wait().unwrap().is_none(), "it was over too soon to be interrupted");
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let run = finish(child);
    assert!(matches!(run.code, None | Some(130)), "{run:?}");
    assert!(!run.stderr.contains("panicked"), "{run:?}");
    assert_eq!(workshop.names().into_iter().collect::<Vec<_>>(), ["in.ply"]);
}
