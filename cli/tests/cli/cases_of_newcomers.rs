//! What people stumbled over who tried the tool for the first time: each case with the right value.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Stdio};

use triquad::Mesh;
use triquad_generators::{Surface, grids};

use crate::experiment_text::experiment;
use crate::experiments::Workshop as Laboratory;
use crate::workshop::{Workshop, assert_contains};

/// An experiment and a group that no table is named after.
const EXPERIMENT: &str = experiment!(
    "evening",
    "convert",
    "[\"botijo\", \"ring\"]\nother_data = true",
    r#"algorithms = ["ps", "tq"]
        augmentations = ["tarjan"]
        repetitions = { full = 2, small = 2, demo = 2 }"#,
);
/// Two meshes, two algorithms, twice.
const RUNS: usize = 8;

/// A laboratory with the experiment and a mesh that it names and that lies in the data folder.
fn laboratory() -> Laboratory {
    let shop = Laboratory::new();
    std::fs::write(shop.path("own.toml"), EXPERIMENT).unwrap();
    std::fs::create_dir(shop.path("data")).unwrap();
    let Surface { positions, triangles } = grids::torus(12, 9);
    let ring = Mesh::from_triangles(positions, triangles);
    let mut text = Vec::new();
    ring.write_to(&mut text, triquad::mesh::Format::Obj).unwrap();
    std::fs::write(shop.path("data/ring.obj"), text).unwrap();
    shop
}

fn text(shop: &Laboratory, file: &str) -> String {
    std::fs::read_to_string(shop.path(file)).unwrap()
}

/// The content of a section of the page, by the name that links lead to.
fn section<'p>(page: &'p str, id: &str) -> &'p str {
    let from = page.find(&format!("<details id=\"{id}\"")).unwrap_or_else(|| panic!("{id}"));
    let section = &page[from..];
    &section[..section.find("</details>").unwrap()]
}

fn edges(mesh: &Mesh) -> BTreeSet<[u32; 2]> {
    let faces = mesh.faces().iter();
    let of_face = |face: &[u32]| -> Vec<[u32; 2]> {
        let ends = |k: usize| [face[k], face[(k + 1) % face.len()]];
        (0..face.len()).map(ends).map(|[a, b]| [a.min(b), a.max(b)]).collect()
    };
    faces.flat_map(of_face).collect()
}

/// Seams and borders of materials inside quads are counted, and none is left inside with
/// `--keep-seams`.
#[test]
fn edges_between_materials_are_counted_or_kept() {
    let workshop = Workshop::new();
    let surface = grids::torus(12, 9);
    workshop.put_surface("plain.obj", &surface);
    let plain = String::from_utf8(workshop.get("plain.obj")).unwrap();
    // Bands of two rows of squares, one after the other in the file.
    let band = |face: usize| face / 36 % 2;
    let mut faces = 0..;
    let lines = plain.lines().map(|line| {
        let face = if line.starts_with("f ") { faces.next() } else { None };
        let first = face.filter(|face| face % 36 == 0);
        let material = first.map(|face| format!("usemtl {}\n", ["red", "blue"][band(face)]));
        format!("{}{line}\n", material.unwrap_or_default())
    });
    workshop.put("in.obj", lines.collect::<String>());
    let mesh = workshop.mesh("in.obj");
    let of_band = |wanted: usize| -> BTreeSet<[u32; 2]> {
        let all = mesh.faces().iter().enumerate();
        let faces = all.filter(|(face, _)| band(*face) == wanted).map(|(_, face)| face);
        edges(&Mesh::new(mesh.positions().to_vec(), faces.collect()))
    };
    let borders: BTreeSet<_> = of_band(0).intersection(&of_band(1)).copied().collect();
    for algorithm in ["sg", "ps", "best"] {
        let convert = format!("convert in.obj -o out.obj --algorithm {algorithm} --stats -");
        let stats = workshop.json(&convert, 0);
        let lost = borders.difference(&edges(&workshop.mesh("out.obj"))).count();
        assert!(lost > 0 || algorithm == "best", "{algorithm} loses nothing");
        let note = format!("{lost} of {} edges between materials (inside quads)", borders.len());
        let told = stats["left_out"].to_string();
        assert_eq!(told.contains(&note), lost > 0, "{algorithm}: {lost} in {told}");
        assert_eq!(told.contains("edges between materials"), lost > 0, "{told}");
    }
    let stats = workshop.json("convert in.obj -o out.obj --keep-seams --stats -", 0);
    assert!(borders.is_subset(&edges(&workshop.mesh("out.obj"))), "{stats}");
    assert_eq!(stats["kept_edges"].as_u64(), Some(borders.len() as u64));
    assert_eq!(stats["left_out"], serde_json::json!([]));
}

/// Tables do not hang on the names of experiments and groups; those without runs are not shown.
#[test]
fn experiments_and_groups_may_have_any_name() {
    let shop = laboratory();
    shop.succeed("run own.toml --data data --scale demo --out out");
    let results = shop.results("out");
    assert_eq!(results.records.len(), RUNS);
    for table in ["table_data.csv", "table_quality.csv", "table_memory.csv"] {
        assert_contains(&text(&shop, &format!("out/{table}")), &["ring,PS"], table);
    }
    let scans = text(&shop, "out/table_4_3.csv");
    let row = scans.lines().find(|line| line.starts_with("botijo,ps,")).unwrap();
    assert!(row.contains(",ok 2,"), "{row}");
    let page = text(&shop, "out/index.html");
    assert_contains(&page, &["<h1>Results: evening</h1>"], "title");
    for (table, mesh) in [("table-data", "ring"), ("table-4-3", "botijo")] {
        assert_contains(section(&page, table), &["<table", mesh], table);
    }
    for without_runs in ["table-4-4-i", "table-4-2-a", "table-6", "table-11"] {
        assert!(!page.contains(&format!("\"{without_runs}\"")), "{without_runs}");
        assert!(!page.contains(&format!("\"#{without_runs}\"")), "{without_runs}");
    }
}

/// Beside results on own meshes nothing speaks of papers, flips or algorithms that were not run.
#[test]
fn a_page_of_own_meshes_is_about_what_was_run() {
    let shop = laboratory();
    let text_of = EXPERIMENT.replace("\"botijo\", \"ring\"", "\"ring\"");
    let text_of = text_of.replace("\"ps\", \"tq\"", "\"best\", \"gw\"");
    let text_of =
        text_of.replace("tarjan", "local").replacen("seed", "pictures = \"ring\"\nseed", 1);
    std::fs::write(shop.path("own.toml"), text_of).unwrap();
    shop.succeed("run own.toml --data data --scale full --out out");
    let drawn: BTreeSet<String> = std::fs::read_dir(shop.path("out/pictures"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let views = ["best-close-up", "best-whole", "gw-close-up", "gw-whole"];
    let quads = views.map(|view| format!("quads-{view}.png"));
    assert_eq!(drawn, quads.into_iter().chain(["pictures.csv".to_owned()]).collect());
    let page = text(&shop, "out/index.html");
    assert_contains(
        &page,
        &["BEST on ring: ", "Times and unpaired triangles", "Growth of GW on"],
        "page",
    );
    let absent = [
        "Where the papers print",
        "Meshes that the papers do not have",
        "what edge flips cost",
        "Growth of TQ",
        "Comparison paper",
        "Figure 14",
        "Figure 5.1",
    ];
    for absent in absent {
        assert!(!page.contains(absent), "{absent}");
    }
    let found = shop.run("compare out");
    let said = String::from_utf8(found.stdout).unwrap();
    assert!(found.status.success() && said.lines().count() == 1, "{said}");
    assert_contains(
        &said,
        &["out: none of the ", " claims of the papers can be judged"],
        "compare",
    );
}

/// Times of a program on two meshes: neither as published, nor enough for a power law.
#[test]
fn a_plot_of_imported_times_claims_neither_origin_nor_growth() {
    let shop = Laboratory::new();
    let rows = "mesh,triangles,total_seconds\na,1000,0.5\nb,4000,3\n";
    let plot = |rows: &str| {
        std::fs::write(shop.path("rows.csv"), rows).unwrap();
        shop.succeed("import rows.csv --algorithm mine --out out --other-meshes");
        (text(&shop, "out/plots/total_data.svg"), text(&shop, "out/plots/total_data.csv"))
    };
    let (svg, csv) = plot(rows);
    assert!(!svg.contains("as published"), "{svg}");
    assert!(csv.contains("mine,b,") && csv.lines().all(|line| !line.contains(",1.29")), "{csv}");
    let (_, csv) = plot(&format!("{rows}c,16000,18\n"));
    assert!(csv.contains(",1.29"), "log 6 / log 4: {csv}");
}

/// A mesh that is named, and lies in the data folder too, is one mesh.
#[test]
fn a_plan_has_as_many_runs_as_are_made() {
    let shop = laboratory();
    // At this scale the data folder is used; without the stand-in it takes no longer.
    let text = EXPERIMENT.replace("\"botijo\", ", "");
    std::fs::write(shop.path("own.toml"), text).unwrap();
    let plan = shop.run("plan own.toml --data data --scale full");
    let plan = String::from_utf8(plan.stdout).unwrap();
    assert_contains(&plan, &[&format!("{} runs:", RUNS / 2)], "plan");
    assert_eq!(plan.matches("  ring ").count(), 1, "{plan}");
    shop.succeed("run own.toml --data data --scale full --out out");
    assert_eq!(shop.results("out").records.len(), RUNS / 2);
}

/// Numbers of another seed take the place of the old ones; where rows of two builds are left in a
/// mean, that is told.
#[test]
fn means_over_rows_of_two_builds_are_marked() {
    let shop = laboratory();
    shop.succeed("run own.toml --data data --scale demo --out out");
    let before = shop.results("out").records;
    std::fs::write(shop.path("own.toml"), EXPERIMENT.replace("seed = 3", "seed = 4")).unwrap();
    shop.succeed("run own.toml --data data --scale demo --out out");
    let after = shop.results("out").records;
    assert_eq!((after.len(), text(&shop, "out/runs.csv").lines().count()), (RUNS, 1 + 2 * RUNS));
    let seeds = |records: &[triquad_lab::experiment::RunRecord]| -> BTreeSet<u64> {
        records.iter().map(|record| record.seed).collect()
    };
    assert!(seeds(&before).is_disjoint(&seeds(&after)));
    let mark = "evening: PS on ring: rows of 2 machines or builds";
    let page = text(&shop, "out/index.html");
    assert!(!page.contains("machines or builds"), "{page}");
    // As another build leaves it that was stopped after one run.
    let runs = text(&shop, "out/runs.csv");
    let is_one = |line: &&str| line.contains(",ring,") && line.contains(",ps,");
    let last = runs.lines().rfind(is_one).unwrap();
    let other = last.replacen(&after[0].machine, "another", 1);
    std::fs::write(shop.path("out/runs.csv"), format!("{runs}{other}\n")).unwrap();
    shop.succeed("report out");
    assert_contains(&text(&shop, "out/index.html"), &[mark], "page");
}

/// A torus, its first face missing or its vertices split along the faces.
fn torus_with(change: impl Fn(&mut Surface)) -> Mesh {
    let mut surface = grids::torus(12, 9);
    change(&mut surface);
    Mesh::from_triangles(surface.positions, surface.triangles)
}

/// The genus of a surface with holes is that of the filled surface, wherever it is printed.
#[test]
fn info_and_convert_agree_on_the_genus() {
    let workshop = Workshop::new();
    workshop.put_mesh("open.obj", &torus_with(|torus| torus.triangles.truncate(215)));
    workshop.put_mesh(
        "two.obj",
        &torus_with(|torus| {
            torus.triangles.remove(100);
            torus.triangles.remove(0);
        }),
    );
    assert_contains(&workshop.succeed("convert open.obj --open"), &["(genus 1, 1 bound"], "open");
    for (file, genus) in [("open.obj", "1 with its hole filled"), ("two.obj", "1 with its holes f")]
    {
        let text = workshop.run(&format!("info {file}"));
        let text = String::from_utf8(text.stdout).unwrap();
        assert_contains(&text, &[&format!("genus                  {genus}")], file);
        assert_contains(&text, &["close the holes; or keep them with --open"], file);
        assert_eq!(workshop.json(&format!("info {file} --json"), 2)["genus"], 1);
    }
}

/// Every verb gives the remedy of the mesh at hand.
#[test]
fn check_gives_the_same_remedy_as_convert() {
    let workshop = Workshop::new();
    workshop.put_mesh("whole.obj", &torus_with(|_| {}));
    workshop.put_mesh(
        "split.obj",
        &torus_with(|torus| {
            let corners = torus.triangles.as_flattened().to_vec();
            torus.positions = corners.iter().map(|&v| torus.positions[v as usize]).collect();
            torus.triangles =
                (0..corners.len() as u32 / 3).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]).collect();
        }),
    );
    workshop.succeed("convert whole.obj -o q.obj");
    let remedy = "--weld closes it";
    assert_contains(&workshop.fail("convert split.obj", 2), &[remedy], "convert");
    let line = workshop.fail("check q.obj --against split.obj", 2);
    assert_contains(&line, &["split.obj: ", remedy], "check");
    workshop.succeed("check q.obj --against whole.obj");
    // What the option was asked to do is no loss.
    let run = workshop.run("convert split.obj --weld -o q.obj --stats stats.json");
    let note = "split.obj: note: --weld joined 540 vertices with others\n";
    assert!(run.stderr.ends_with(note) && !run.stderr.contains("carried"), "{}", run.stderr);
    let stats: serde_json::Value = serde_json::from_slice(&workshop.get("stats.json")).unwrap();
    assert_eq!(stats["left_out"], serde_json::json!(["--weld joined 540 vertices with others"]));
    let text = String::from_utf8(workshop.run("info split.obj --weld").stdout).unwrap();
    assert_contains(&text, &["repaired               --weld joined 540"], "info");
    assert!(!text.contains("not read"), "{text}");
}

#[test]
fn faces_that_are_no_quads_are_named_for_what_they_are() {
    let workshop = Workshop::new();
    let tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    workshop.put("in.obj", tetrahedron);
    let check = |face: &str| {
        workshop.put("q.obj", tetrahedron.replace("f 1 3 2", face));
        workshop.fail("check q.obj --against in.obj", 1)
    };
    assert_contains(&check("f 1 3 2"), &["q.obj: face 1 is a triangle; --open allows"], "triangle");
    let penta = check("f 1 3 2 4 1");
    assert_contains(&penta, &["q.obj: face 1 has 5 corners"], "pentagon");
    assert_contains(
        &check("f 1 3 2 9"),
        &["face 1 names a vertex that does", "(vertex 9 of 4)"],
        "",
    );
}

/// A face out of range is named with the vertex, in every format.
#[test]
fn absent_vertices_are_named() {
    let workshop = Workshop::new();
    let points = "0 0 0\n1 0 0\n0 1 0\n";
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
               property float z\nelement face 2\nproperty list uchar int vertex_indices\n\
               end_header\n";
    workshop.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 4\n");
    workshop.put("a.off", format!("OFF\n3 2 0\n{points}3 0 1 2\n3 2 1 3\n"));
    workshop.put("a.ply", format!("{ply}{points}3 0 1 2\n3 2 1 3\n"));
    for file in ["a.obj", "a.off", "a.ply"] {
        let expected = "face 2 names a vertex that does not exist (vertex 4 of 3)";
        assert_contains(&workshop.fail(&format!("convert {file}"), 2), &[expected], file);
        let text = String::from_utf8(workshop.run(&format!("info {file}")).stdout).unwrap();
        assert_contains(&text, &[expected], file);
        let info = workshop.json(&format!("info {file} --json"), 2);
        assert_eq!(info["violations"][0]["absent_vertex"], 4, "{file}");
        assert!(info["violations"][1]["absent_vertex"].is_null(), "{file}");
    }
}

/// A file that was cut off says so once, with the place and the remedy.
#[test]
fn truncated_files_are_told_in_one_sentence() {
    let workshop = Workshop::new();
    let torus = torus_with(|_| {});
    for file in ["a.ply", "a.off", "a.stl", "a.obj.gz", "a.ply.gz"] {
        if file == "a.stl" {
            let mut bytes = vec![0; 84 + 50];
            bytes[80] = 3;
            workshop.put(file, bytes);
        } else {
            workshop.put_mesh(file, &torus);
            let bytes = workshop.get(file);
            workshop.put(file, &bytes[..bytes.len() / 2]);
        }
        let line = workshop.fail(&format!("info {file}"), 2);
        let end = "; it was cut off: copy or export it again";
        assert_contains(&line, &[&format!("{file}: the file ends before "), end], file);
        assert!(!line.contains("truncated") && !line.contains("end of file"), "{line}");
    }
}

#[test]
fn what_was_complete_was_not_completed() {
    let workshop = Workshop::new();
    workshop.put_mesh("in.obj", &torus_with(|_| {}));
    let line = workshop.succeed("convert in.obj --algorithm tq");
    assert!(line.contains("tq left 0 unpaired (0.000 %); ") && !line.contains("complet"), "{line}");
    let line = workshop.succeed("convert in.obj --algorithm sg --seed 1");
    assert_contains(&line, &[" %), completed by local; "], "sg");
}

/// `make test` ends with the tests that did nothing, and why.
#[test]
fn tests_that_skip_are_listed() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../.ci/skipped");
    let shop = Workshop::new();
    if !script.exists() {
        println!("skipped: no .ci beside the package");
        return;
    }
    let listed = |log: &str| {
        shop.put("log", log);
        let list = Command::new(&script).arg(shop.path("log")).stdin(Stdio::null()).output();
        String::from_utf8(list.unwrap().stdout).unwrap()
    };
    let log = "test a::one ... ok\nsuccesses:\n\n---- a::one stdout ----\nskipped: no python\n\n\
               ---- a::two stdout ----\nread\n";
    assert_eq!(listed(log), "Skipped:\n  a::one: no python\n");
    assert_eq!(listed("---- a::two stdout ----\nnot skipped: read\n"), "No test was skipped.\n");
}
