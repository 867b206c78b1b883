//! What `best` aims at: edges to keep, costs from a file, and the certificates of it all.

use triquad::mesh::Mesh;
use triquad_generators::random::Mix;
use triquad_generators::testing::random_of;
use triquad_generators::{Surface, grids};

use crate::surfaces::face_list;
use crate::workshop::{Workshop, assert_contains};

fn irregular() -> Surface {
    random_of(1, 60, Mix::Balanced, 5)
}

/// The edges of a mesh in the order in which its faces first pass them, counted from 1.
fn edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let mut edges: Vec<[u32; 2]> = Vec::new();
    for face in mesh.faces() {
        for k in 0..face.len() {
            let ends = [face[k] + 1, face[(k + 1) % face.len()] + 1];
            if !edges.contains(&ends) && !edges.contains(&[ends[1], ends[0]]) {
                edges.push(ends);
            }
        }
    }
    edges
}

fn lines(edges: &[[u32; 2]]) -> String {
    edges.iter().map(|[a, b]| format!("{a} {b}\n")).collect()
}

/// A folder with a mesh `in.obj` and every second edge of it in `keep.txt`.
fn workshop() -> (Workshop, Vec<[u32; 2]>) {
    let workshop = Workshop::new();
    let mesh = face_list(&irregular());
    workshop.put_mesh("in.obj", &mesh);
    let kept: Vec<_> = edges(&mesh).into_iter().step_by(2).collect();
    workshop.put("keep.txt", lines(&kept));
    (workshop, kept)
}

#[test]
fn edges_given_up_are_counted_and_listed() {
    let (workshop, kept) = workshop();
    let options = "--keep-edges keep.txt -o out.obj --given-up lost.txt --stats -";
    let stats = workshop.json(&format!("convert in.obj {options}"), 0);
    assert_eq!(stats["kept_edges"], kept.len());
    let lost = String::from_utf8(workshop.get("lost.txt")).unwrap();
    assert_eq!(stats["given_up_edges"], lost.lines().count());
    assert!(!lost.is_empty());
    let left = edges(&workshop.mesh("out.obj"));
    let is_left = |[a, b]: [u32; 2]| left.contains(&[a, b]) || left.contains(&[b, a]);
    let listed: Vec<&str> = lost.lines().collect();
    for &[a, b] in &kept {
        let is_lost = [[a, b], [b, a]].iter().any(|[a, b]| listed.contains(&&*format!("{a} {b}")));
        assert!(is_left([a, b]) != is_lost, "{a} {b}");
    }
    workshop.succeed("check out.obj --against in.obj");
    let summary = workshop.succeed("convert in.obj --keep-edges keep.txt");
    assert_contains(&summary, &["edges to keep given up, proved fewest"], "summary");
}

#[test]
fn strictness_leaves_triangles_in_place_of_edges() {
    let (workshop, _) = workshop();
    let options = "--keep-edges keep.txt --strict -o out.obj --given-up lost.txt --stats -";
    let stats = workshop.json(&format!("convert in.obj {options} --certificate proof.txt"), 0);
    assert_eq!((&stats["given_up_edges"], &stats["proved_fewest"]), (&0.into(), &true.into()));
    assert!(stats["leftover_triangles"].as_u64().unwrap() > 0);
    assert!(workshop.get("lost.txt").is_empty());
    let report = workshop.succeed("check out.obj --against in.obj --certificate proof.txt");
    assert_contains(&report, &["proved", "no pairing leaves fewer"], "check");
    let line = workshop.fail("convert in.obj --strict", 2);
    assert_contains(&line, &["--strict", "--keep-sharp"], "nothing to be strict about");
}

#[test]
fn bad_lines_of_edges_are_named() {
    let (workshop, _) = workshop();
    for (text, place) in [
        ("1 x\n", "bad.txt:1"),
        ("\n1\n", "bad.txt:2"),
        ("1 2 3\n", "bad.txt:1"),
        ("0 1\n", "bad.txt:1"),
        ("1 1\n", "bad.txt:1"),
        ("1 999999\n", "bad.txt:1: edge 1-999999"),
        ("1 99999999999\n", "bad.txt:1"),
    ] {
        workshop.put("bad.txt", text);
        let line = workshop.fail("convert in.obj --keep-edges bad.txt -o out.obj", 2);
        assert_contains(&line, &[place], text);
    }
    workshop.fail("convert in.obj --keep-edges absent.txt", 2);
    let line = workshop.fail("convert in.obj --keep-edges keep.txt --algorithm tq", 2);
    assert_contains(&line, &["tq", "use best"], "edges for tq");
    for degrees in ["-1", "181", "x"] {
        workshop.fail(&format!("convert in.obj --keep-sharp={degrees}"), 2);
    }
}

#[test]
fn sharp_edges_of_a_cube_are_kept() {
    let workshop = Workshop::new();
    let cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
                f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    workshop.put("in.obj", cube);
    let stats = workshop.json("convert in.obj --triangulate --keep-sharp 30 --stats -", 0);
    assert_eq!((&stats["kept_edges"], &stats["given_up_edges"]), (&12.into(), &0.into()));
}

#[test]
fn seams_are_read_from_groups_and_materials() {
    let workshop = Workshop::new();
    let octahedron = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n";
    let faces = ["1 3 5", "3 2 5", "2 4 5", "4 1 5", "3 1 6", "2 3 6", "4 2 6", "1 4 6"];
    let face = |face: &&str| format!("f {face}\n");
    let upper: String = faces[..4].iter().map(face).collect();
    let lower: String = faces[4..].iter().map(face).collect();
    workshop.put("in.obj", format!("{octahedron}usemtl a\n{upper}usemtl b\n{lower}"));
    let stats = workshop.json("convert in.obj --keep-seams --stats -", 0);
    assert_eq!((&stats["kept_edges"], &stats["given_up_edges"]), (&4.into(), &0.into()));
}

#[test]
fn costs_are_read_from_a_file() {
    let workshop = Workshop::new();
    let mesh = face_list(&irregular());
    workshop.put_mesh("in.obj", &mesh);
    let count = edges(&mesh).len();
    let costs: Vec<String> = (0..count).map(|edge| (edge * 7919 % 23).to_string()).collect();
    workshop.put("costs.txt", costs.join("\n"));
    let options = "--cost costs.txt -o out.obj --certificate proof.txt --stats -";
    let stats = workshop.json(&format!("convert in.obj {options}"), 0);
    let left = edges(&workshop.mesh("out.obj"));
    let is_left = |[a, b]: [u32; 2]| left.contains(&[a, b]) || left.contains(&[b, a]);
    let removed = edges(&mesh).into_iter().zip(&costs).filter(|(ends, _)| !is_left(*ends));
    let total: i64 = removed.map(|(_, cost)| cost.parse::<i64>().unwrap()).sum();
    assert_eq!(stats["total_cost"], total);
    let check = "check out.obj --against in.obj --certificate proof.txt";
    workshop.succeed(&format!("{check} --cost costs.txt"));
    workshop.fail(check, 2);

    workshop.put("short.txt", costs[1..].join(" "));
    let line = workshop.fail("convert in.obj --cost short.txt", 2);
    let counts = [format!("{} costs", count - 1), format!("{count} edges")];
    assert_contains(&line, &["short.txt", &counts[0], &counts[1]], "wrong count");
    workshop.fail(&format!("{check} --cost short.txt"), 1);
    workshop.put("words.txt", "1 2\n3 many\n");
    let line = workshop.fail("convert in.obj --cost words.txt", 2);
    assert_contains(&line, &["words.txt:2", "many"], "no number");
    workshop.fail("convert in.obj --cost absent.txt", 2);
}

#[test]
fn tampered_certificates_and_other_quads_are_refused() {
    let (workshop, _) = workshop();
    let convert = "convert in.obj --keep-edges keep.txt --keep-sharp 40";
    workshop.succeed(&format!("{convert} -o out.obj --certificate proof.txt"));
    let check = "check out.obj --against in.obj --certificate";
    let report = workshop.succeed(&format!("{check} proof.txt"));
    assert_contains(&report, &["proved", "none gives up fewer than", "none costs less"], "check");

    let proof = String::from_utf8(workshop.get("proof.txt")).unwrap();
    let all: Vec<&str> = proof.lines().collect();
    let start = all.iter().position(|line| line.starts_with("triangles ")).unwrap();
    let refuse = |number: usize, line: &str| {
        let mut changed = all.clone();
        changed[number] = line;
        workshop.put("bad.txt", changed.join("\n") + "\n");
        let run = workshop.run(&format!("{check} bad.txt"));
        assert!(matches!(run.code, Some(1 | 2)), "line {number}: {line}: {run:?}");
        assert_eq!(run.stderr.lines().count(), 1);
    };
    for number in (start + 1..all.len() - 1).step_by(1 + (all.len() - start) / 40) {
        let Some((first, second)) = all[number].split_once(' ') else { continue };
        let Ok(value) = first.parse::<i128>() else { continue };
        refuse(number, &format!("{} {second}", value + 1));
        refuse(number, &format!("{first} {}", second.parse::<i128>().unwrap() + 1));
        refuse(number, first);
        refuse(number, "");
    }
    refuse(0, "triquad-certificate 2");
    refuse(1, "cost shape");
    refuse(1, "cost listed");
    refuse(2, "keep-sharp 10");
    refuse(2, "keep-seams");
    refuse(2, "strict");
    refuse(all.len() - 1, "ends");

    workshop.succeed("convert in.obj -o other.obj --algorithm ps");
    let line = workshop.fail("check other.obj --against in.obj --certificate proof.txt", 1);
    assert_contains(&line, &["proof.txt", "does not prove it"], "other quads");
    workshop.fail(&format!("{check} absent.txt"), 2);
    let line = workshop.fail("convert in.obj --algorithm tq --certificate proof.txt", 2);
    assert_contains(&line, &["tq", "--algorithm best"], "nothing proved");
}

#[test]
fn texts_do_not_overwrite_the_mesh_or_each_other() {
    let (workshop, _) = workshop();
    for options in [
        "--certificate in.obj",
        "--given-up in.obj",
        "--certificate a.txt --given-up a.txt",
        "--certificate a.txt --stats a.txt",
        "--certificate - --stats -",
        "--compare -o out.obj",
    ] {
        workshop.fail(&format!("convert in.obj --keep-edges keep.txt {options}"), 2);
    }
    let run = workshop.run("convert in.obj --certificate -");
    assert_eq!(run.code, Some(0));
    assert!(run.stdout.starts_with(b"triquad-certificate 1\n") && run.stdout.ends_with(b"\nend\n"));
}

#[test]
fn all_algorithms_are_compared_in_a_table() {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &grids::torus(12, 9));
    let table = workshop.succeed("convert in.obj --compare");
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split("  ").collect()).collect();
    let names: Vec<&str> = rows.iter().map(|row| row[0].trim()).collect();
    let expected = triquad::Algorithm::ALL.map(triquad::Algorithm::id);
    assert_eq!(names[1..], expected);
    let mut lines = table.lines();
    let header = lines.next().unwrap();
    let end = header.find("cost").unwrap() + "cost".len();
    let costs: Vec<i64> =
        lines.map(|row| row[..end].rsplit(' ').next().unwrap().parse().unwrap()).collect();
    assert!(costs.iter().all(|&cost| cost >= costs[0]), "{table}");
    assert!(costs.iter().any(|&cost| cost > costs[0]), "{table}");
}

/// Its row alone has another aim than the least cost.
#[test]
fn the_table_says_what_only_best_does_and_what_it_costs() {
    let (workshop, _) = workshop();
    let cost = |options: &str| {
        let stats = workshop.json(&format!("convert in.obj {options} --stats -"), 0);
        stats["total_cost"].to_string()
    };
    let [default, shape] = ["", "--cost shape"].map(cost);
    assert_ne!(default, cost("--keep-edges keep.txt"));
    let (keeps, leaves) = ("only best keeps edges", "only best leaves triangles at a price");
    for (options, deeds, without, cost) in [
        ("--keep-sharp 5", keeps, "--keep-sharp", &default),
        ("--keep-sharp 5 --strict", keeps, "--keep-sharp and --strict", &default),
        ("--keep-edges keep.txt --cost shape", keeps, "--keep-edges", &shape),
        ("--keep-seams --keep-sharp 5", keeps, "--keep-sharp and --keep-seams", &default),
        ("--quad-dominant 0.01", leaves, "--quad-dominant", &default),
    ] {
        let table = workshop.succeed(&format!("convert in.obj --compare {options}"));
        let expected = format!("{deeds}; without {without} its cost is {cost}");
        assert_eq!(table.lines().last(), Some(&expected[..]), "{table}");
    }
    let table = workshop.succeed("convert in.obj --compare --cost shape");
    assert!(!table.contains("only best"), "{table}");
}
