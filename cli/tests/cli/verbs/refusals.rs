//! Input that is refused, with the reason.

use std::collections::BTreeSet;

use super::meshes::{
    CUBE, TETRAHEDRON, TETRAHEDRON_OFF, ascii_ply, bytes_of, tetrahedron_of, truncated_ascii_stl,
    truncated_binary_stl, truncated_gzip, without_end,
};
use crate::workshop::{Workshop, assert_contains};
use triquad::mesh::Format;
use triquad_generators::{classic, grids};

/// A file that breaks a law, and what the line on standard error must say: place | law | remedy.
type Refusal = (&'static str, Vec<u8>, &'static str);

fn refusal(file: &'static str, content: impl Into<Vec<u8>>, says: &'static str) -> Refusal {
    (file, content.into(), says)
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
        refusal("open.obj", open, "edge 1-3 | boundary edge | (face 1; | close the holes"),
        refusal("coloured.obj", coloured, "edge 1-3 | boundary edge | close the holes"),
        refusal(
            "full.obj",
            two([1, 2, 5, 6]),
            "edge 1-2 | more than two faces (faces 1, 2, 5 and 6) | separate the sheets",
        ),
        refusal(
            "bow-tie.obj",
            two([4, 5, 6, 7]),
            "vertex 4 | several fans of faces (one face of each: 2 and 5) | a vertex of its own",
        ),
        refusal(
            "turned.obj",
            turned,
            "edge 1-2 | same direction | (faces 1 and 2; first of 3) | --orient",
        ),
        refusal("one-sided.off", plane, "edge | non-orientable | (faces | cut the strip"),
        refusal("cube.obj", CUBE, "face 1 | not a triangle | --triangulate"),
        with_line("line.obj", "f 1 2", "face 5 | not a triangle | 2 corners | copy"),
        with_line("nothing.obj", "f", "face 5 | not a triangle | 0 corners | copy"),
        with_line("repeated.obj", "f 1 1 2", "face 5 | repeats a corner | --clean"),
        with_line("duplicate.obj", "f 2 1 3", "face 5 | same corners | (face 1) | --clean"),
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
        with_vertex(
            "comma.obj",
            "v 1 0,5 0",
            "line 2 | '0,5' is not a number: it has a decimal comma",
        ),
        with_vertex("short.obj", "v 1 0", "line 2 | three coordinates | export it again"),
        with_vertex("bare.obj", "v", "line 2 | three coordinates | export it again"),
        refusal("comma.off", off("\n1 0 0", "\n1 0,5 0"), "line 4 | '0,5' | a decimal comma"),
        refusal("word.off", off("\n1 0 0", "\n1 l 0"), "line 4 | 'l' | export it again"),
        refusal("word.ply", ascii_ply("3 0 1 2\n3 0 one 2\n"), "line 15 | 'one' | export it again"),
        refusal("header.ply", header, "line 3 | 'elephant' | export it again"),
    ]
}

/// Files that are not whole, or nothing at all.
fn incomplete_files() -> Vec<Refusal> {
    let whole = bytes_of(&grids::sphere(3), Format::Ply);
    let off = &TETRAHEDRON_OFF[..TETRAHEDRON_OFF.len() - 8];
    let truncated = "the file ends before | it was cut off: copy or export it again";
    let no_faces = "the mesh | has no faces | exported with faces";
    vec![
        refusal(
            "binary.ply",
            without_end(whole, 1),
            "face 72 of 72 | ends before | copy or export it again",
        ),
        refusal(
            "ascii.ply",
            ascii_ply("3 0 1 2\n3 0 1\n"),
            "face 2 of 2 | ends before | copy or export it again",
        ),
        refusal("header.ply", "ply\nformat ascii 1.0\nelement vertex 4\n", truncated),
        refusal("faces.off", off, "face 4 of 4 | ends before | copy or export it again"),
        refusal(
            "vertices.off",
            "OFF\n4 4 6\n0 0 0\n",
            "vertex 2 of 4 | ends before | copy or export it again",
        ),
        refusal(
            "binary.stl",
            truncated_binary_stl(),
            "triangle 2 of 2 | ends before | copy or export it again",
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
        assert_contains(&workshop.fail(&format!("info {file}"), 2), &[file], file);
    }
}

/// Returns what precedes each line of `text` but the first, as long as that is less than `whole`.
fn cuts(text: &str, whole: usize) -> impl Iterator<Item = &str> {
    let ends = text.match_indices('\n').map(|(at, _)| at + 1);
    ends.take_while(move |&end| end < whole).map(|end| &text[..end])
}

/// A file that is cut off in the midst of a line is found to be wrong there. One that ends with a
/// whole line lacks what it announces.
#[test]
fn text_files_that_end_too_early_at_the_end_of_a_line_are_truncated() {
    let off = TETRAHEDRON_OFF.to_owned();
    let ply = ascii_ply("3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    let mut stl = String::from("solid tetrahedron\n");
    for corners in [["0 0 0", "0 1 0", "1 0 0"], ["0 0 0", "1 0 0", "0 0 1"]] {
        stl += "facet normal 0 0 1\nouter loop\n";
        corners.iter().for_each(|corner| stl += &format!("vertex {corner}\n"));
        stl += "endloop\nendfacet\n";
    }
    stl += "endsolid tetrahedron\n";
    let workshop = Workshop::new();
    for (file, text) in [("in.off", off), ("in.ply", ply), ("in.stl", stl)] {
        for cut in cuts(&text, text.len()) {
            workshop.put(file, cut);
            let says = ["the file ends before ", "; it was cut off: copy or export it again"];
            assert_contains(&workshop.fail(&format!("convert {file}"), 2), &says, cut);
            assert_contains(&workshop.fail(&format!("info {file}"), 2), &says, cut);
        }
    }
}

/// OBJ files announce nothing: vertices that are in no face are the only sign of missing ones.
#[test]
fn obj_files_that_may_be_cut_off_get_a_hint() {
    const HINT: &str = "if the file was cut off, copy or export it again";
    let text = String::from_utf8(bytes_of(&grids::sphere(3), Format::Obj)).unwrap();
    let workshop = Workshop::new();
    let mut advice = BTreeSet::new();
    for cut in cuts(&text, text.len()) {
        let of = |keyword: &'static str| cut.lines().filter_map(move |at| at.strip_prefix(keyword));
        let used: BTreeSet<&str> = of("f ").flat_map(str::split_whitespace).collect();
        let kind = match (of("f ").count(), of("v ").count() - used.len()) {
            (0, _) => format!("exported with faces; {HINT}"),
            (_, 0) => "close the holes; --open".into(),
            (_, 1) => format!("close the holes; 1 vertex is in no face: {HINT}"),
            (_, idle) => format!("close the holes; {idle} vertices are in no face: {HINT}"),
        };
        workshop.put("in.obj", cut);
        assert_contains(&workshop.fail("convert in.obj", 2), &[&kind], cut);
        let remedy = kind.trim_end_matches("; --open");
        let violations = workshop.json("info in.obj --json", 2)["violations"].to_string();
        assert_contains(&violations, &[remedy], cut);
        advice.insert(kind.replace(|c: char| c.is_ascii_digit(), ""));
    }
    assert_eq!(advice.len(), 4, "{advice:?}");
}

/// What announces its vertices and faces is whole, and vertices without faces are no sign.
#[test]
fn open_meshes_in_other_files_get_no_hint() {
    let workshop = Workshop::new();
    workshop.put("in.off", "OFF\n4 1 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n");
    let line = workshop.fail("convert in.off", 2);
    assert!(line.contains("close the holes; --open"), "{line}");
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
        (
            "convert in.obj -o out.xyz",
            &["out.xyz", "unknown mesh format", "write .obj, .ply or .off"],
        ),
        (
            "convert in.obj -o out.stl",
            &["out.stl", "read, not written", "write .obj, .ply or .off"],
        ),
        ("convert in.obj -o missing/out.obj", &["missing/out.obj", "make the folder first"]),
        ("convert in.obj -o folder.obj", &["folder.obj", "is a folder", paths]),
        (
            "convert in.obj -o out.obj --stats missing/stats.json",
            &["missing/stats.json", "make the folder first"],
        ),
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
        ("in.obj", "did you mean 'triquad convert in.obj'?"),
        ("convrt in.obj", "did you mean 'convert'?"),
        ("convert in.obj --algoritm ps", "did you mean '--algorithm'?"),
        ("info in.obj --open", "; --open is an option of convert, check"),
        ("--open", "; --open is an option of convert, check"),
        ("generate box --genus=3", "; --genus is an option of generate stand-in"),
        ("convert in.obj --out out.obj", "did you mean '--output'?"),
        ("convert in.obj --algorithm bets", "did you mean 'best'?"),
        ("convert in.obj --algorithm BEST", "did you mean 'best'?"),
        ("convert in.obj --algorithm Blossom", "did you mean 'best'?"),
        ("convert in.obj --algorithm lrs --lrs-variant few_flips", "did you mean 'few-flips'?"),
        ("generate paper botjo -o out.obj", "did you mean 'botijo'?"),
        ("render in.obj", "did you mean 'draw'?"),
        ("view in.obj", "did you mean 'draw'?"),
        ("show in.obj", "did you mean 'draw'?"),
        ("rnder.obj", "did you mean 'triquad convert rnder.obj'?"),
        ("convert", "<IN>"),
        ("convert in.obj --algorithm magic", "magic"),
        ("convert in.obj --augmentation magic", "magic"),
        ("convert in.obj --seed minus", "minus"),
        ("convert in.obj --seed -1", "-1"),
        ("check in.obj", "--against"),
        ("info in.obj --xml", "--xml"),
        ("simplify in.obj", "--vertices"),
        ("simplify in.obj --vertices few", "few"),
        ("simplify in.obj --vertices few", "'triquad simplify --help' explains"),
        ("check in.obj", "'triquad check --help' explains"),
        ("generate box --vertices few", "'triquad generate box --help' explains"),
        ("--threads few info in.obj", "'triquad info --help' explains"),
        ("juggle in.obj", "'triquad --help' explains"),
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
