//! What refusals advise: it is not on already, and it works when pasted.

use triquad_generators::{Surface, grids};

use super::meshes::{CUBE, TETRAHEDRON, tetrahedron_of};
use crate::workshop::{Workshop, assert_contains, finish};

/// The tetrahedron as four loose triangles, vertices that belong together `gap` apart at most.
fn soup(gap: f64) -> String {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut text = String::new();
    for (face, triangle) in [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].into_iter().enumerate() {
        for corner in triangle {
            let [x, y, z]: [f64; 3] = corners[corner];
            text += &format!("v {} {y} {z}\n", x + gap * face as f64 / 3.0);
        }
    }
    for face in 0..4 {
        text += &format!("f {} {} {}\n", 3 * face + 1, 3 * face + 2, 3 * face + 3);
    }
    text
}

/// The same without gaps, and without the last triangle.
fn open_soup() -> String {
    soup(0.0).replace("f 10 11 12\n", "")
}

/// An octahedron with a slit: one vertex is two, `gap` apart. The ends of the slit have no twins.
fn slit(gap: f64) -> String {
    let vertices = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n";
    let faces = "f 1 3 5\nf 3 2 5\nf 2 4 7\nf 4 1 7\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
    format!("{vertices}v {gap} 0 1\n{faces}")
}

/// A mesh, options that are on, the advice, and the options with which it can be converted.
type Case = (String, &'static str, &'static str, Option<&'static str>);

fn cases() -> Vec<Case> {
    let with = |lines: &str| format!("{TETRAHEDRON}{lines}\n");
    let open = TETRAHEDRON[..TETRAHEDRON.len() - 8].to_owned();
    let turned = TETRAHEDRON.replace("f 1 3 2", "f 1 2 3");
    let bow_tie =
        format!("{TETRAHEDRON}v 2 0 0\nv 0 2 0\nv 0 0 2\n{}", tetrahedron_of([4, 5, 6, 7]));
    let cut_off = "it has 2 corners and is the last: if the file was cut off, copy";
    vec![
        (soup(0.0), "", "--weld closes it: it joins vertices at equal", Some("--weld")),
        (soup(2e-6), "", "--weld 1e-5 closes it", Some("--weld 1e-5")),
        (soup(2e-6), "--weld", "--weld 1e-5 closes it", Some("--weld 1e-5")),
        (soup(2e-6), "--weld 1e-7", "--weld 1e-5 closes it", Some("--weld 1e-5")),
        (slit(0.0), "", "--weld closes it: it joins vertices at equal", Some("--weld")),
        (slit(2e-6), "", "--weld 1e-5 closes it", Some("--weld 1e-5")),
        (open.clone(), "", "close the holes", Some("--open")),
        (open, "--weld", "close the holes", Some("--weld --open")),
        (
            open_soup(),
            "",
            "--weld joins 8 vertices and leaves 3 of 9 boundary edges; then close",
            Some("--weld --open"),
        ),
        (open_soup(), "--weld", "close the holes", Some("--weld --open")),
        (CUBE.into(), "", "--triangulate cuts", Some("--triangulate")),
        (CUBE.into(), "--orient", "--triangulate cuts", Some("--triangulate --orient")),
        (with("f 1 2"), "", cut_off, Some("--clean")),
        (with("f 1 2"), "--triangulate", cut_off, Some("--clean --triangulate")),
        (with("f 1 1 2"), "", "--clean drops degenerate", Some("--clean")),
        (with("f 1 1 2 3"), "--triangulate", "--clean drops", Some("--clean --triangulate")),
        (with("f 2 1 3"), "", "--clean drops faces", Some("--clean")),
        (turned.clone(), "", "--orient flips", Some("--orient")),
        (format!("{turned}f 2 1 3\n"), "", "--clean drops", Some("--clean --orient")),
        (bow_tie, "--orient", "give each fan a vertex", None),
    ]
}

/// Returns each option that `text` names, with its number if it has one.
fn options(text: &str) -> Vec<String> {
    // The command that shows the other laws repeats what is on.
    let without = text.split_once(" (and ").and_then(|(before, rest)| {
        let (_, after) = rest.split_once("')")?;
        Some(format!("{before}{after}"))
    });
    let text = without.as_deref().unwrap_or(text);
    let words: Vec<&str> = text.split_whitespace().collect();
    let option = |(at, word): (usize, &&str)| {
        let name = word.trim_matches(|c: char| !c.is_ascii_alphanumeric() && c != '-');
        let number = words.get(at + 1).filter(|next| next.parse::<f64>().is_ok());
        name.starts_with("--").then(|| match number {
            Some(number) => format!("{name} {number}"),
            None => name.to_owned(),
        })
    };
    words.iter().enumerate().filter_map(option).collect()
}

#[test]
fn no_remedy_is_on_already_and_the_options_that_info_names_work() {
    for (mesh, on, advice, way) in cases() {
        let workshop = Workshop::new();
        workshop.put("in.obj", &mesh);
        let what = format!("{on}, {advice}");
        let line = workshop.fail(&format!("convert in.obj {on}"), 2);
        assert_contains(&line, &[advice], &what);
        assert!(options(&line).iter().all(|option| !options(on).contains(option)), "{line}");
        let run = workshop.run(&format!("info in.obj {on}"));
        assert_eq!(run.code, Some(2), "{what}: {run:?}");
        let stdout = String::from_utf8(run.stdout).unwrap();
        assert_contains(&stdout, &[advice], &what);
        let Some(way) = way else {
            assert_contains(&run.stderr, &["it cannot be converted as it is"], &what);
            continue;
        };
        assert_contains(&run.stderr, &[&format!("'triquad convert in.obj {way}'")], &what);
        let repairs = |options: &str| options.replace("--open", "").matches("--").count();
        let more = "but more options are needed";
        // The remedy may be none of the options.
        let suffices = !advice.contains("--") || repairs(way) <= repairs(on) + 1;
        assert!(line.contains(more) != suffices, "{line}");
        workshop.succeed(&format!("convert in.obj {way} -o out.obj"));
        workshop.succeed(&format!("check out.obj --against in.obj {way}"));
        let closed = way.replace("--open", "");
        let code = if closed == way { 0 } else { 2 };
        assert_eq!(workshop.run(&format!("info in.obj {closed}")).code, Some(code), "{what}");
    }
}

/// A torus of 120 faces and 180 edges without face `hole`, every corner its own vertex, at most
/// `noise` from its place.
fn soup_of_torus(hole: usize, noise: f64) -> Surface {
    let mut torus = torus_without(hole);
    let corners = torus.triangles.as_flattened().iter().enumerate();
    let place = |(at, &v): (usize, &u32)| {
        let [x, y, z] = torus.positions[v as usize];
        [x + noise * (at % 3) as f64 / 3.0, y, z]
    };
    torus.positions = corners.map(place).collect();
    torus.triangles =
        (0..torus.triangles.len() as u32).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]).collect();
    torus
}

fn torus_without(hole: usize) -> Surface {
    let mut torus = grids::torus(10, 6);
    torus.triangles.remove(hole);
    torus
}

/// The torus without face `hole`, its first ring of vertices there twice.
fn torus_with_seam(hole: usize) -> Surface {
    let mut torus = torus_without(hole);
    torus.positions.extend_from_within(..6);
    let last = torus.triangles.iter_mut().skip(107);
    last.flatten().filter(|v| **v < 6).for_each(|v| *v += 60);
    torus
}

#[test]
fn welding_that_leaves_fewer_boundary_edges_is_advised_and_works() {
    let workshop = Workshop::new();
    let loose = |turn: bool| {
        let mut torus = torus_without(50);
        let first = torus.triangles[0];
        torus.positions.extend(first.map(|v| torus.positions[v as usize]));
        torus.triangles[0] = if turn { [61, 60, 62] } else { [60, 61, 62] };
        torus
    };
    for (name, mesh, edges, joined, option) in [
        ("soup", soup_of_torus(119, 0.0), 357, 297, "--weld"),
        ("noise", soup_of_torus(119, 1e-7), 357, 297, "--weld 1e-7"),
        ("seam", torus_with_seam(50), 15, 6, "--weld"),
        ("bow-tie", torus_with_seam(119), 15, 6, "--weld"),
        ("loose", loose(false), 9, 3, "--weld"),
        ("turned", loose(true), 9, 3, "--weld"),
    ] {
        workshop.put_surface("in.obj", &mesh);
        let advice =
            format!("{option} joins {joined} vertices and leaves 3 of {edges} boundary edges");
        let run = workshop.run("info in.obj");
        let stdout = String::from_utf8(run.stdout).unwrap();
        let both = format!("{advice}; then close the holes; or keep them with --open");
        assert_contains(&stdout, &[&both], name);
        assert!(!stdout.contains("a vertex of its own"), "{stdout}");
        let orient = if name == "turned" { " --orient" } else { "" };
        let way = format!("{option}{orient} --open");
        assert_contains(&run.stderr, &[&format!("'triquad convert in.obj {way}'")], name);
        let line = workshop.fail("convert in.obj", 2);
        let told = [&advice[..], &format!("; {way} convert it and leave over as few")];
        assert_contains(&line, &told, name);
        let line = workshop.fail("irreducible in.obj", 2);
        assert_contains(&line, &[&format!("only 'triquad convert in.obj {way}'")], name);
        let stats = workshop.json(&format!("convert in.obj {way} -o out.obj --stats -"), 0);
        assert_eq!(stats["leftover_triangles"], 1, "{name}");
        workshop.succeed(&format!("check out.obj --against in.obj {way}"));
        // Without the welding a conversion says what it misses.
        let run = workshop.run(&format!("convert in.obj{orient} --open"));
        assert_eq!(run.code, Some(if name == "bow-tie" { 2 } else { 0 }), "{run:?}");
        let note = if name == "bow-tie" { "--weld mends it" } else { &format!("note: {advice}\n") };
        assert_contains(&run.stderr, &[note], name);
    }
}

#[test]
fn welding_that_does_not_help_is_not_advised() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &torus_without(50));
    assert!(!workshop.fail("convert in.obj", 2).contains("--weld"));
    let run = workshop.run("convert in.obj --open");
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    // Two solids that meet at a vertex, as loose triangles: without welding nothing is paired.
    let mut solids = soup(0.0);
    for line in soup(0.0).lines() {
        let words: Vec<&str> = line.split(' ').collect();
        solids += &match words[0] {
            "v" => format!("v -{} -{} -{}\n", words[1], words[2], words[3]),
            _ => {
                words[1..].iter().fold("f".into(), |face, v| {
                    format!("{face} {}", v.parse::<usize>().unwrap() + 12)
                }) + "\n"
            }
        };
    }
    workshop.put("in.obj", solids);
    let line = workshop.fail("convert in.obj", 2);
    let advice = "--weld closes it: it joins vertices at equal coordinates; it then breaks";
    assert_contains(&line, &[advice, "several-fans, but no options suffice"], "solids");
    assert_contains(&workshop.run("info in.obj").stderr, &["cannot be converted"], "solids");
}

#[test]
fn a_side_that_is_cut_on_one_face_only_is_a_t_junction() {
    let workshop = Workshop::new();
    let cut = TETRAHEDRON.replace("f 1 2 4", "v 0.5 0 0\nf 1 5 4\nf 5 2 4");
    assert!(cut.contains("v 0.5"));
    workshop.put("in.obj", cut);
    let advice = "vertex 5 lies on edge 1-2, a T-junction: cut the face of that edge there";
    assert_contains(&workshop.fail("convert in.obj", 2), &[advice], "convert");
    let stdout = String::from_utf8(workshop.run("info in.obj").stdout).unwrap();
    assert_contains(&stdout, &[advice], "info");
}

#[test]
fn faces_that_are_turned_or_cut_are_counted() {
    let workshop = Workshop::new();
    let turned = TETRAHEDRON.replace("f 1 3 2", "f 1 2 3");
    let open = turned.rsplit_once("f ").unwrap().0;
    workshop.put("cube.obj", CUBE);
    workshop.put("turned.obj", &turned);
    workshop.put("open.obj", open);
    for (arguments, deed) in [
        ("cube.obj --triangulate", "--triangulate cut 6 faces into triangles"),
        ("turned.obj --orient", "--orient turned 1 face"),
        ("open.obj --orient --open", "--orient turned 1 face"),
    ] {
        let said = workshop.run(&format!("convert {arguments} -o out.obj")).stderr;
        assert_contains(&said, &[&format!("note: {deed}\n")], arguments);
        let info = workshop.run(&format!("info {}", arguments.replace("--open", "")));
        let info = String::from_utf8(info.stdout).unwrap();
        assert_contains(&info, &[&format!("repaired               {deed}")], arguments);
    }
}

#[test]
fn faces_that_hang_by_an_edge_are_the_ones_to_remove() {
    let workshop = Workshop::new();
    let with = |faces: &str| format!("{TETRAHEDRON}v 2 0 0\nv 0 2 0\n{faces}");
    for (fins, advice) in [
        ("f 1 2 5\n", "remove face 5: it hangs on the mesh by one edge alone"),
        ("f 6 1 5\nf 1 2 5\n", "remove faces 5 and 6: they hang on the mesh by one edge alone"),
    ] {
        workshop.put("in.obj", with(fins));
        let stdout = String::from_utf8(workshop.run("info in.obj").stdout).unwrap();
        // The overfull edge, the boundary and the fans.
        assert_eq!(stdout.matches(advice).count(), 3, "{stdout}");
        for verb in ["convert in.obj", "convert in.obj --open", "check in.obj --against in.obj"] {
            assert_contains(&workshop.fail(verb, 2), &["[overfull-edge]", advice], verb);
        }
    }
    // Of two faces at one edge none is known to be too many.
    workshop.put("in.obj", with("f 1 2 5\nf 5 6 1\nf 2 6 5\nf 6 2 1\n"));
    let advice = ["edge 1-2 ", "separate the sheets", "docs/formats.md"];
    assert_contains(&workshop.fail("convert in.obj", 2), &advice, "two solids");
}

/// Quads of a column with lids of their own, its last vertices 5e-8 from the first.
fn column(more: &str) -> String {
    let mut text = String::new();
    let ring = |z: f64| {
        let at = move |k: u32| 0.125 * std::f64::consts::PI * f64::from(k);
        (0..=16).map(move |k| [at(k).cos(), at(k).sin() - 5e-8 * f64::from(k / 16), z])
    };
    for [x, y, z] in [ring(0.0), ring(1.0), ring(0.0), ring(1.0)].into_iter().flatten() {
        text += &format!("v {x} {y} {z}\n");
    }
    for k in 1..=16 {
        text += &format!("f {k} {} {} {}\n", k + 1, k + 18, k + 17);
    }
    let lid = |first: u32| (first..first + 16).map(|v| format!(" {v}")).collect::<Vec<_>>();
    let under: String = lid(35).into_iter().rev().collect();
    format!("{text}f{under}\nf{}\n{more}", lid(52).concat())
}

#[test]
fn a_repeated_face_of_any_size_is_what_to_drop() {
    let workshop = Workshop::new();
    let way = "--weld 1e-7 --clean --triangulate";
    let reversed = "f 4 21 20 3\n";
    for (mesh, way) in [
        (format!("{CUBE}{}\n", CUBE.trim().rsplit_once('\n').unwrap().1), "--clean --triangulate"),
        (column(reversed), way),
        (column("f 20 21 4 3\n"), way),
    ] {
        workshop.put("in.obj", mesh);
        let run = workshop.run("info in.obj");
        let stdout = String::from_utf8(run.stdout).unwrap();
        assert!(!stdout.contains("remove face"), "{stdout}");
        for law in ["[duplicate-face]", "[overfull-edge]"] {
            let advice = format!("{law}\n          --clean drops faces that are there twice");
            assert_contains(&stdout, &[&advice], law);
        }
        assert_contains(&run.stderr, &[&format!("'triquad convert in.obj {way}'")], "info");
        workshop.succeed(&format!("convert in.obj {way} -o out.obj"));
        workshop.succeed(&format!("check out.obj --against in.obj {way}"));
    }
    // In another order it is another face.
    workshop.put("in.obj", format!("{CUBE}f 1 3 2 4\n"));
    let stdout = String::from_utf8(workshop.run("info in.obj").stdout).unwrap();
    assert_contains(&stdout, &["[duplicate-face]\n          remove one of them"], "twisted");
}

#[test]
fn the_remedy_of_a_bow_tie_can_be_done() {
    let workshop = Workshop::new();
    let formats = include_str!("../../../../docs/formats.md");
    let triangle = |corners: [[f32; 3]; 3]| {
        let vertex = |[x, y, z]: [f32; 3]| format!("vertex {x} {y} {z}\n");
        format!(
            "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n",
            corners.map(vertex).concat()
        )
    };
    let solid = |s: f32| {
        let [o, x, y, z] = [[0.0; 3], [s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s]];
        [[o, y, x], [o, x, z], [x, y, z], [y, o, z]].map(triangle).concat()
    };
    workshop.put("in.stl", format!("solid a\n{}{}endsolid a\n", solid(1.0), solid(-1.0)));
    let bow_tie =
        format!("{TETRAHEDRON}v 2 0 0\nv 0 2 0\nv 0 0 2\n{}", tetrahedron_of([4, 5, 6, 7]));
    workshop.put("in.obj", bow_tie);
    let (section, format) = ("Other repairs", "do it in another format");
    let (_, repairs) = formats.split_once(&format!("\n## {section}\n")).unwrap();
    let (repairs, _) = repairs.split_once("\n## ").unwrap();
    // What was tried, in this order.
    let edges = "meshing_repair_non_manifold_edges(method=\"Split Vertices\")\n";
    let filters = format!("{edges}m.meshing_repair_non_manifold_vertices()\n");
    assert_contains(repairs, &[&filters], "a command that does it");
    for (name, is_stl) in [("in.stl", true), ("in.obj", false)] {
        let line = workshop.fail(&format!("convert {name}"), 2);
        assert_contains(&line, &["[several-fans]", "docs/formats.md", section], name);
        assert_eq!(line.contains(format), is_stl, "{line}");
    }
}

#[test]
fn faces_that_welding_drops_do_not_hide_the_distance() {
    let workshop = Workshop::new();
    // A sliver in the seam.
    workshop.put("in.obj", column("f 17 1 18\n"));
    let run = workshop.run("info in.obj");
    let stdout = String::from_utf8(run.stdout).unwrap();
    assert_contains(&stdout, &["no, but it is with --weld 1e-7"], "closed");
    let way = "--weld 1e-7 --triangulate";
    assert_contains(&run.stderr, &[&format!("'triquad convert in.obj {way}'")], "info");
    workshop.succeed(&format!("convert in.obj {way} -o out.obj"));
}

/// What `--open` allows is a broken law in `info` all the same.
#[test]
fn other_laws_are_as_many_as_info_lists() {
    let workshop = Workshop::new();
    let fan = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n";
    let bow_tie = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n";
    for mesh in [fan, bow_tie] {
        workshop.put("in.obj", mesh);
        let laws = workshop.json("info in.obj --json", 2)["violations"].as_array().unwrap().len();
        assert_contains(&workshop.run("info in.obj").stderr, &[&format!("{laws} laws")], "info");
        let others = match laws {
            2 => "(and 1 other law is broken, see".into(),
            laws => format!("(and {} other laws are broken, see", laws - 1),
        };
        for options in ["", "--open", "--open --orient"] {
            let line = workshop.fail(&format!("convert in.obj {options}"), 2);
            assert_contains(&line, &[&others], options);
        }
    }
    let line = workshop.fail("convert in.obj --open", 2);
    assert_contains(&line, &["[several-fans]"], "what is allowed is not the reason");
}

/// What `check` takes is no reason, and its options are.
#[test]
fn check_names_the_repairs_that_convert_had() {
    let workshop = Workshop::new();
    let mut turned = torus_without(50);
    turned.triangles[70].reverse();
    for (name, mesh, law, remedy, options) in [
        ("turned", turned, "inconsistent-orientation", "--orient flips faces", "--orient"),
        ("bow-tie", torus_with_seam(119), "several-fans", "--weld mends it", "--weld"),
        ("seam", torus_with_seam(50), "boundary-edge", "--weld --open allow it", "--weld"),
    ] {
        workshop.put_surface("in.obj", &mesh);
        workshop.succeed(&format!("convert in.obj {options} --open -o out.obj"));
        let line = workshop.fail("check out.obj --against in.obj", 2);
        assert_contains(&line, &[&format!("[{law}]"), remedy], name);
        workshop.succeed(&format!("check out.obj --against in.obj {options}"));
    }
    let line = workshop.fail("check out.obj --against in.obj --open", 1);
    let told = "the quad mesh has 60 vertices, the triangle mesh 66; with --weld it has as many";
    assert_contains(&line, &[told], "--open");
}

/// What is counted is told apart from what is not.
#[test]
fn a_mesh_without_boundary_that_is_not_closed_says_why() {
    let workshop = Workshop::new();
    let only = "v 0 0 0\nv 1 0 0\nf 1 1 2\n".to_owned();
    for (mesh, closed, faces) in [
        (only, "no: no face has three corners of its own", "1 (1 triangle), 1 in no other count"),
        (format!("{TETRAHEDRON}f 1 1 2\nf 2 3 3\n"), "yes", "6 (6 triangles), 2 in no other count"),
        (
            format!("{TETRAHEDRON}f 1 2 4\n"),
            "no: some edges belong to more than two faces",
            "5 (5 triangles)\n",
        ),
        (TETRAHEDRON[..TETRAHEDRON.len() - 8].to_owned(), "no\n", "3 (3 triangles)\n"),
    ] {
        workshop.put("in.obj", mesh);
        let stdout = String::from_utf8(workshop.run("info in.obj").stdout).unwrap();
        let rows = [
            format!("\n  closed                 {closed}"),
            format!("\n  faces                  {faces}"),
        ];
        assert_contains(&stdout, &[&rows[0], &rows[1]], closed);
    }
}

/// A face too many at an edge, and a face that `--orient` flips.
#[test]
fn other_laws_are_those_after_faces_are_flipped() {
    let workshop = Workshop::new();
    let mut torus = grids::torus(10, 6);
    torus.triangles[70].reverse();
    let [a, b, _] = torus.triangles[0];
    torus.triangles.push([a, b, 60]);
    torus.positions.push([9.0; 3]);
    workshop.put_surface("in.obj", &torus);
    for options in ["--orient", "--weld --orient"] {
        let info = format!("info in.obj {options}");
        let laws =
            workshop.json(&format!("{info} --json"), 2)["violations"].as_array().unwrap().len();
        assert_eq!(laws, 3);
        let others = format!("(and 2 other laws are broken, see 'triquad {info}')");
        for verb in [
            "convert in.obj",
            "convert in.obj --open",
            "irreducible in.obj",
            "check in.obj --against in.obj",
            "simplify in.obj --vertices 20",
        ] {
            assert_contains(&workshop.fail(&format!("{verb} {options}"), 2), &[&others], verb);
        }
    }
}

#[test]
fn a_remedy_that_does_not_suffice_says_so() {
    let workshop = Workshop::new();
    // A degenerate face, and two solids that share a vertex.
    let bow_tie =
        format!("{TETRAHEDRON}v 2 0 0\nv 0 2 0\nv 0 0 2\n{}", tetrahedron_of([4, 5, 6, 7]));
    workshop.put("in.obj", format!("{bow_tie}f 1 1 2\n"));
    let line = workshop.fail("convert in.obj", 2);
    let told = ["see 'triquad info in.obj'", "--clean drops", "but no options suffice"];
    assert_contains(&line, &told, "a bow-tie");
    assert_contains(&workshop.run("info in.obj").stderr, &["cannot be converted"], "info");
    workshop.put("in.obj", format!("{CUBE}f 1 1 2\n"));
    let line = workshop.fail("convert in.obj", 2);
    assert_contains(&line, &["--triangulate cuts", "but more options are needed"], "a cube");
    workshop.put("in.obj", CUBE);
    assert!(!workshop.fail("convert in.obj", 2).contains("but "));
}

/// The other laws are those of the mesh that the options leave.
#[test]
fn the_command_that_shows_the_other_laws_has_the_options_of_reading() {
    let workshop = Workshop::new();
    // A boundary and edges of many faces, with the options of repair as without.
    let fan = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n";
    workshop.put("in.obj", fan);
    workshop.put("quads.obj", fan);
    for on in ["", " --weld", " --weld 1e-5 --clean", " --max-expanded 5000 --triangulate --orient"]
    {
        for verb in ["convert in.obj", "irreducible in.obj", "check quads.obj --against in.obj"] {
            let line = workshop.fail(&format!("{verb}{on}"), 2);
            assert_contains(&line, &[&format!("see 'triquad info in.obj{on}')")], verb);
        }
        let run = workshop.run(&format!("info in.obj{on}"));
        assert_contains(&run.stderr, &["in.obj: breaks "], on);
    }
    workshop.put("in.obj", &TETRAHEDRON[..TETRAHEDRON.len() - 8]);
    let line = workshop.fail("irreducible in.obj --weld --clean", 2);
    assert_contains(&line, &["only 'triquad convert in.obj --weld --clean --open'"], "open");
}

#[test]
#[cfg(unix)]
fn commands_in_messages_can_be_pasted() {
    let workshop = Workshop::new();
    let open = &TETRAHEDRON[..TETRAHEDRON.len() - 8];
    for name in ["in.obj", "an open mesh.obj", "it's $HOME.obj"] {
        workshop.put(name, open);
        let run = finish(workshop.spawn(&["info", name]));
        let (_, command) = run.stderr.split_once("with 'triquad ").expect("a command");
        let command = command.trim_end().strip_suffix('\'').expect("an end of the command");
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", &format!("\"$TRIQUAD\" {command}")]);
        shell.env("TRIQUAD", env!("CARGO_BIN_EXE_triquad")).current_dir(workshop.path(""));
        let done = shell.output().unwrap();
        assert!(done.status.success(), "{command}: {done:?}");
    }
}

#[test]
fn a_mesh_from_a_pipe_gets_no_remedy_that_is_on() {
    for (mesh, on, _, _) in cases() {
        let run = Workshop::new().run_with_input(&format!("convert - {on}"), mesh.as_bytes());
        assert_eq!(run.code, Some(2), "{run:?}");
        assert!(options(&run.stderr).iter().all(|option| !options(on).contains(option)), "{run:?}");
    }
}

#[test]
fn what_cleaning_and_welding_drop_is_counted_and_named() {
    let workshop = Workshop::new();
    workshop.put("in.obj", format!("{TETRAHEDRON}f 1 1 2\nf 2 1 3\nf 3 2 1\nf 4 4 4\n"));
    let run = workshop.run("convert in.obj --clean -o out.obj --stats stats.json");
    assert_eq!(run.code, Some(0), "{run:?}");
    let notes =
        ["--clean dropped 2 degenerate faces", "--clean dropped 2 faces that were there twice"];
    assert_contains(&run.stderr, &notes, "note");
    assert!(!run.stderr.contains("not carried over"), "{run:?}");
    let stats = String::from_utf8(workshop.get("stats.json")).unwrap();
    assert_contains(&stats, &notes, "stats");
    workshop.put("close.obj", soup(0.0).replace("v 0 0 0\n", "v 0 0 0.5\n"));
    let line = workshop.fail("convert close.obj --weld 10", 2);
    assert_contains(&line, &["close.obj", "--weld leaves no face", "smaller distance"], "weld");
}
