//! Pictures, several inputs, and how much is printed and how.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;
use triquad_generators::{Surface, classic, grids};

use crate::surfaces::face_list;
use crate::workshop::assert_has_fields;

const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Runs the tool in `folder` with arguments separated by spaces, without colours of the caller.
fn tool(folder: &TempDir, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_triquad"));
    command.current_dir(folder).args(arguments.split_whitespace());
    for name in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "COLORTERM", "COLUMNS", "LINES"] {
        command.env_remove(name);
    }
    command
}

fn run(folder: &TempDir, arguments: &str) -> Output {
    tool(folder, arguments).output().unwrap()
}

/// Returns what was printed, on standard output and standard error, if the exit code is `code`.
#[track_caller]
fn printed(output: &Output, code: i32) -> [String; 2] {
    let texts = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into());
    assert_eq!(output.status.code(), Some(code), "{texts:?}");
    texts
}

/// A folder with `ring.obj`, a torus, its quads `quads.obj`, and `open.obj`, which is refused.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    put(&folder, "ring.obj", &grids::torus(12, 12));
    let mut open = classic::octahedron();
    open.triangles.pop();
    put(&folder, "open.obj", &open);
    printed(&run(&folder, "convert ring.obj -o quads.obj"), 0);
    folder
}

fn put(folder: &TempDir, name: &str, surface: &Surface) {
    face_list(surface).write(folder.path().join(name)).unwrap();
}

fn size(file: &Path) -> [u32; 2] {
    let bytes = std::fs::read(file).unwrap();
    assert!(bytes.starts_with(PNG));
    [16, 20].map(|at| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()))
}

#[test]
fn pictures_have_the_size_asked_for_and_differ_by_what_they_show() {
    let folder = folder();
    let mut seen = Vec::new();
    for (i, options) in [
        "",
        "--colour none",
        "--edges off",
        "--azimuth -60 --elevation 89",
        "--up z",
        "--zoom 2",
        "--section 0 0 0 0 -1 0.5",
        "--against ring.obj",
        "--against ring.obj --against quads.obj",
    ]
    .iter()
    .enumerate()
    {
        let draw = format!("draw quads.obj -o {i}.png --size 160 90 {options}");
        let [stdout, stderr] = printed(&run(&folder, &draw), 0);
        assert_eq!((stdout, stderr), (format!("{i}.png: 160 x 90 pixels\n"), String::new()));
        let file = folder.path().join(format!("{i}.png"));
        assert_eq!(size(&file), [160, 90]);
        seen.push(std::fs::read(file).unwrap());
    }
    let count = seen.len();
    seen.sort();
    seen.dedup();
    assert_eq!(seen.len(), count);
    let bytes = run(&folder, "draw quads.obj -o - --size 160 90").stdout;
    assert!(seen.contains(&bytes));
}

#[test]
fn a_mesh_that_cannot_be_drawn_leaves_no_picture() {
    let folder = folder();
    std::fs::write(folder.path().join("nan.obj"), "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        .unwrap();
    std::fs::write(folder.path().join("far.ply"), far_index()).unwrap();
    std::fs::write(folder.path().join("none.obj"), "v 0 0 0\n").unwrap();
    for (arguments, reason) in [
        ("draw quads.obj -o a.jpg", "a.jpg: pictures are PNG files"),
        ("draw none.obj -o a.png", "none.obj: the mesh has no face to draw"),
        ("draw far.ply -o a.png", "far.ply: there is no vertex 9"),
        ("draw quads.obj -o a.png --size 0 5", "quads.obj: no image of 0 x 5 pixels"),
        ("draw quads.obj -o a.png --zoom -1", "quads.obj: camera: the zoom is not positive"),
        ("draw quads.obj -o a.png --azimuth inf", "quads.obj: camera: a coordinate is not finite"),
        ("draw quads.obj -o a.png --section 0 0 0 0 0 0", "the plane of the section"),
        ("draw nan.obj -o a.png", "nan.obj"),
        ("draw quads.obj -o missing/a.png", "missing/a.png: "),
    ] {
        let [stdout, stderr] = printed(&run(&folder, arguments), 2);
        assert!(stdout.is_empty() && stderr.contains(reason), "{arguments}: {stderr}");
        assert_eq!(stderr.lines().count(), 1, "{arguments}: {stderr}");
    }
    let names = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name());
    assert!(!names.into_iter().any(|name| name.to_string_lossy().ends_with("png")));
}

/// A PLY file with a face of a vertex that does not exist.
fn far_index() -> String {
    let header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
                  property float z\nelement face 1\nproperty list uchar int vertex_indices\n\
                  end_header\n";
    format!("{header}0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n")
}

#[test]
fn without_a_terminal_a_picture_is_plain_shades_that_fit_the_columns_named() {
    let folder = folder();
    let draw = |names: &[(&str, &str)]| {
        let output = tool(&folder, "draw quads.obj").envs(names.iter().copied()).output().unwrap();
        let [stdout, stderr] = printed(&output, 0);
        assert_eq!(stderr, "");
        stdout
    };
    let plain = draw(&[("COLUMNS", "40"), ("LINES", "21")]);
    assert!(plain.chars().all(|c| " ░▒▓█\n".contains(c)), "{plain}");
    let widest = plain.lines().map(|line| line.chars().count()).max().unwrap();
    assert!((30..=40).contains(&widest) && (18..=20).contains(&plain.lines().count()), "{plain}");
    let forced = ("CLICOLOR_FORCE", "1");
    assert!(draw(&[forced, ("COLORTERM", "truecolor")]).contains("\u{1b}[38;2;"));
    assert!(draw(&[forced]).contains("\u{1b}[38;5;"));
    assert!(!draw(&[("COLORTERM", "truecolor"), ("NO_COLOR", "1")]).contains('\u{1b}'));
}

#[test]
fn several_inputs_are_converted_and_the_exit_code_tells_of_the_refused_one() {
    let folder = folder();
    put(&folder, "b.ply.gz", &classic::octahedron());
    let convert = "convert ring.obj open.obj b.ply.gz missing.obj --out-dir new/quads --format off";
    let [stdout, stderr] = printed(&run(&folder, convert), 2);
    assert_eq!(stdout.lines().count(), 2, "{stdout}");
    assert!(stdout.starts_with("ring.obj -> new/quads/ring.off: 288 triangles"), "{stdout}");
    let reasons: Vec<&str> = stderr.lines().collect();
    assert_eq!(reasons.len(), 3, "{stderr}");
    assert!(reasons[0].contains("open.obj: edge") && reasons[1].contains("missing.obj: "));
    assert_eq!(reasons[2], "triquad: 2 of 4 meshes were not converted");
    let mut made: Vec<_> = std::fs::read_dir(folder.path().join("new/quads"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name())
        .collect();
    made.sort();
    assert_eq!(made, ["b.off", "ring.off"]);
    printed(&run(&folder, "convert ring.obj -o alone.off"), 0);
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    assert_eq!(read("alone.off"), read("new/quads/ring.off"));
    let [stdout, _] = printed(&run(&folder, "convert ring.obj b.ply.gz --out-dir same"), 0);
    assert!(stdout.contains("same/ring.obj: ") && stdout.contains("same/b.ply.gz: "), "{stdout}");
}

#[test]
fn several_inputs_that_cannot_be_told_apart_are_refused_before_any_work() {
    let folder = folder();
    std::fs::copy(folder.path().join("ring.obj"), folder.path().join("ring.OBJ")).unwrap();
    for (arguments, reason) in [
        ("convert ring.obj ring.OBJ --out-dir out --format ply", "would have the same result"),
        ("convert ring.obj quads.obj", "--out-dir"),
        ("convert - --out-dir out", "standard input has no name"),
        ("convert ring.obj --out-dir out -o a.obj", "cannot be used with"),
        ("convert ring.obj --format ply", "--out-dir"),
    ] {
        let [stdout, stderr] = printed(&run(&folder, arguments), 2);
        assert!(stdout.is_empty() && stderr.contains(reason), "{arguments}: {stderr}");
        assert_eq!(stderr.lines().count(), 1, "{arguments}: {stderr}");
    }
    assert!(!folder.path().join("out").exists());
}

#[test]
fn failures_are_json_where_that_is_asked_for() {
    let folder = folder();
    let failure = |arguments: &str, code| -> Value {
        let [_, stderr] = printed(&run(&folder, arguments), code);
        assert_eq!(stderr.lines().count(), 1, "{stderr}");
        let failure: Value = serde_json::from_str(&stderr).unwrap();
        assert_eq!(
            (&failure["schema"], &failure["exit_code"]),
            (&"triquad-failure-1".into(), &code.into())
        );
        assert_has_fields(&failure, &["message", "file", "law", "element", "count", "remedy"]);
        failure
    };
    let refused = failure("convert open.obj --json", 2);
    assert_eq!((&refused["file"], &refused["law"]), (&"open.obj".into(), &"boundary-edge".into()));
    assert_eq!(refused["count"], 3);
    assert!(refused["element"].as_str().unwrap().starts_with("edge "));
    let message = refused["message"].as_str().unwrap();
    assert!(message.ends_with(refused["remedy"].as_str().unwrap()), "{message}");
    assert_eq!(failure("--json info missing.obj", 2)["file"], "missing.obj");
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
               property float z\nend_header\n0 0 0\n1 0";
    let stl = [&[0; 80][..], &[2, 0, 0, 0], &[0; 60]].concat();
    for (file, content, element) in [
        ("cut.ply", ply.as_bytes(), "vertex 2"),
        ("cut.off", b"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "face 2"),
        ("cut.stl", &stl, "triangle 2"),
        ("wrong.off", b"OFF\n3 1 0\n0 0 x\n", "line 3"),
    ] {
        std::fs::write(folder.path().join(file), content).unwrap();
        let failure = failure(&format!("info {file} --json"), 2);
        assert_eq!((&failure["element"], &failure["law"]), (&element.into(), &Value::Null));
        assert!(failure["message"].as_str().unwrap().contains(element), "{failure}");
    }
    assert_eq!(failure("check ring.obj --against ring.obj --json", 1)["exit_code"], 1);
    let usage = failure("convert --json", 2);
    assert!(usage["message"].as_str().unwrap().contains("required"), "{usage}");
    failure("info open.obj --json", 2);
}

#[test]
fn quiet_prints_answers_alone_and_verbose_every_step() {
    let folder = folder();
    for (arguments, lines) in [
        ("convert ring.obj -o a.obj -q", 0),
        ("check a.obj --against ring.obj --quiet", 0),
        ("draw a.obj -o a.png --size 80 60 -q", 0),
        ("convert ring.obj -q -o -", 144 + 144),
        ("convert ring.obj -q --out-dir out", 0),
    ] {
        let [stdout, stderr] = printed(&run(&folder, arguments), 0);
        let faces = stdout.lines().filter(|line| line.starts_with(['v', 'f'])).count();
        assert_eq!((stderr.as_str(), faces), ("", lines), "{arguments}");
        assert_eq!(stdout.is_empty(), lines == 0, "{arguments}: {stdout}");
    }
    let [stdout, stderr] = printed(&run(&folder, "-q convert open.obj"), 2);
    assert_eq!((stdout.lines().count(), stderr.lines().count()), (0, 1));
    let [stdout, stderr] = printed(&run(&folder, "convert ring.obj -o a.obj -v"), 0);
    assert_eq!(stdout.lines().count(), 1);
    for step in ["s: reading the mesh", "s: pairing triangles", "s: writing the quads"] {
        assert!(stderr.lines().any(|line| line.starts_with("triquad: 0.") && line.ends_with(step)));
    }
    // `best` leaves nothing to augment, others do.
    assert!(!stderr.contains("augmenting"), "{stderr}");
    let [_, stderr] = printed(&run(&folder, "convert ring.obj --algorithm sg -v"), 0);
    assert!(stderr.contains("s: augmenting paths: "), "{stderr}");
    printed(&run(&folder, "convert ring.obj -q -v"), 2);
}

#[test]
fn completions_and_manual_pages_name_every_verb() {
    let folder = tempfile::tempdir().unwrap();
    let [help, _] = printed(&run(&folder, "--help"), 0);
    let verbs: Vec<&str> = help
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .map_while(|line| line.strip_prefix("  ")?.split(' ').next())
        .filter(|verb| !verb.is_empty())
        .collect();
    assert!(verbs.contains(&"draw") && verbs.len() > 10, "{verbs:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let [script, stderr] = printed(&run(&folder, &format!("completions {shell}")), 0);
        assert_eq!(stderr, "");
        assert!(verbs.iter().all(|verb| script.contains(verb)), "{shell}");
    }
    let [page, _] = printed(&run(&folder, "man"), 0);
    assert!(page.contains(".TH triquad 1") && verbs.iter().all(|verb| page.contains(verb)));
    for verb in verbs.iter().filter(|verb| **verb != "help") {
        let [page, _] = printed(&run(&folder, &format!("man {verb}")), 0);
        assert!(page.contains(&format!(".TH triquad-{verb} 1")), "{verb}: {page}");
        assert!(page.contains(".SH NAME"));
    }
    let [_, stderr] = printed(&run(&folder, "man paint"), 2);
    assert!(stderr.contains("paint: no such verb; use one of: convert, "), "{stderr}");
}
