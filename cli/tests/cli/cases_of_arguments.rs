//! Outputs that would destroy something, options without effect, folders that are none: each ends
//! with one line, a remedy that is true, and no file changed.

use triquad_generators::classic;

use crate::experiment_text::experiment;
use crate::workshop::{Workshop, assert_contains};

const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

const EXPERIMENT: &str = experiment!(
    "tiny",
    "convert",
    r#"["botijo"]"#,
    r#"algorithms = ["tq"]
        augmentations = ["local"]
        repetitions = { full = 1, small = 1, demo = 1 }"#,
);

fn workshop() -> Workshop {
    let workshop = Workshop::new();
    for name in ["in.obj", "other.obj"] {
        workshop.put(name, TETRAHEDRON);
    }
    workshop.put("file", "no folder");
    workshop.put("tiny.toml", EXPERIMENT);
    std::fs::create_dir(workshop.path("folder")).unwrap();
    workshop
}

/// Exit code 2, one line with all parts, all files as they were.
fn assert_refused(table: &[(&str, &[&str])]) {
    let workshop = workshop();
    for (arguments, parts) in table {
        assert_contains(&workshop.fail(arguments, 2), parts, arguments);
    }
}

#[test]
fn no_output_replaces_an_input() {
    let own = "would overwrite the mesh of the same name; give it a file of its own";
    assert_refused(&[
        ("convert in.obj --stats in.obj", &["--stats", own]),
        ("convert in.obj -o in.obj", &["-o", own]),
        ("convert in.obj --write-triangulation in.obj", &["--write-triangulation", own]),
        ("convert in.obj --certificate in.obj", &["--certificate", own]),
        ("convert in.obj --keep-sharp 30 --given-up in.obj", &["--given-up", own]),
        ("irreducible in.obj -o in.obj", &["-o", own]),
        ("simplify in.obj --vertices 4 -o in.obj", &["in.obj"]),
        ("convert in.obj -o a.obj --stats a.obj", &["a.obj"]),
    ]);
}

#[test]
fn options_without_effect_are_refused() {
    assert_refused(&[
        (
            "convert in.obj --algorithm tq --lrs-variant few-flips",
            &["--lrs-variant: tq has no such thing", "use --algorithm lrs"],
        ),
        ("convert in.obj --lrs-order queue", &["--lrs-order: best has no", "--algorithm lrs"]),
        ("convert in.obj --algorithm tq --certificate c", &["--certificate", "--algorithm best"]),
        ("convert in.obj --algorithm tq --keep-sharp 30", &["best"]),
        ("check - --against -", &["standard input can be one of the meshes only"]),
    ]);
    let workshop = workshop();
    workshop.succeed("convert in.obj --algorithm lrs --lrs-variant few-flips --lrs-order queue");
    workshop.succeed("convert in.obj --compare --lrs-variant few-flips");
}

/// What needs another option needs it beside options that exclude that one, too.
#[test]
fn meshes_and_options_that_would_be_passed_over_are_refused() {
    let folder = "several meshes need --out-dir FOLDER for their results";
    let second = "other.obj: a second mesh is given; ";
    let format = "--format ply: names the format of results in a folder; ";
    assert_refused(&[
        ("convert in.obj other.obj", &[second, folder]),
        ("convert in.obj other.obj in.obj", &["other.obj: 3 meshes are given; ", folder]),
        ("convert in.obj other.obj -o q.obj", &[second, "-o takes one mesh only: call convert"]),
        ("convert in.obj nothere.obj -o q.obj", &["nothere.obj: a second mesh", "-o takes one"]),
        ("convert in.obj other.obj --stats -", &[second, "--stats takes one mesh only"]),
        ("convert in.obj other.obj --compare", &[second, "--compare takes one mesh only"]),
        ("convert in.obj other.obj --certificate c", &[second, "--certificate takes one mesh"]),
        ("convert in.obj other.obj --given-up g", &[second, "--given-up takes one mesh"]),
        ("convert in.obj other.obj --stop-after-paths 1", &[second, "--stop-after-paths takes"]),
        (
            "convert in.obj other.obj --write-triangulation k.obj",
            &[second, "--write-triangulation takes one mesh only"],
        ),
        ("convert in.obj q.obj", &["q.obj: ", "did you mean 'triquad convert in.obj -o q.obj'?"]),
        ("convert in.obj q.ply.gz --stats s", &["did you mean 'triquad convert in.obj -o q.ply."]),
        ("convert in.obj nothere.stl", &["nothere.stl: a second mesh is given; ", folder]),
        ("convert in.obj --format ply", &[format, "give --out-dir FOLDER, too"]),
        ("convert in.obj --format ply -o q.obj", &[format, "leave --format out"]),
        ("convert in.obj --format ply --compare", &[format, "leave it out"]),
        ("check in.obj --against in.obj --cost c", &["--cost c: ", "give --certificate FILE"]),
        (
            "check in.obj --against in.obj --cost c --triangulation in.obj",
            &["--cost c: belongs to a certificate; ", "leave it out"],
        ),
    ]);
}

#[test]
fn places_that_cannot_be_written_to_are_named_with_their_remedy() {
    let no_folder = "there is no folder missing; make the folder first";
    let no_file = "file: is a file, not a folder; name a folder";
    assert_refused(&[
        ("convert in.obj -o missing/out.obj", &["missing/out.obj", no_folder]),
        ("convert in.obj --stats missing/a.json", &["missing/a.json", no_folder]),
        ("convert in.obj -o folder", &["folder"]),
        ("run tiny.toml --scale demo --out file", &[no_file]),
        ("merge folder --out file", &[no_file]),
        ("report missing", &["missing/runs.csv", "'triquad run'"]),
        ("report file", &["file/runs.csv", "'triquad run'"]),
        ("report folder", &["folder/runs.csv", "'triquad run'"]),
        ("compare missing", &["missing/runs.csv", "'triquad run'"]),
    ]);
}

#[test]
fn numbers_of_experiments_have_limits_and_nothing_is_named_twice_or_in_vain() {
    let workshop = workshop();
    let table = [
        ("timeout_seconds = 60", "timeout_seconds = 0", "timeout_seconds = 0: must be from 1 to"),
        ("gigabytes = 4", "gigabytes = 0", "memory_gigabytes = 0: must be from 1 to"),
        ("gigabytes = 4", "gigabytes = 36028797018963968", "must be from 1 to 1000000"),
        ("demo = 1", "demo = 4294967295", "demo = 4294967295: must be from 1 to 10000"),
        ("full = 1", "full = 0", "full = 0: must be from 1 to"),
        ("[\"tq\"]", "[\"tq\", \"tq\"]", "group \"all\" names tq local twice"),
        ("[\"local\"]", "[\"local\", \"local\"]", "group \"all\" names tq local twice"),
        ("\"all\"", "\"two\\nlines\"", "has a line break"),
        (
            "[\"local\"]",
            "[\"local\"]\norders = [\"file\"]",
            "bad.toml: line 14: orders has no effect",
        ),
    ];
    for (from, to, part) in table {
        assert!(EXPERIMENT.contains(from), "{from}");
        workshop.put("bad.toml", EXPERIMENT.replace(from, to));
        for verb in ["plan bad.toml", "run bad.toml --scale demo --out out"] {
            assert_contains(&workshop.fail(verb, 2), &["bad.toml", part], to);
        }
    }
}

#[cfg(unix)]
#[test]
fn protected_files_and_links_to_nothing_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let workshop = workshop();
    let mode = std::fs::Permissions::from_mode(0o444);
    std::fs::set_permissions(workshop.path("other.obj"), mode).unwrap();
    symlink("nowhere.obj", workshop.path("link.obj")).unwrap();
    for (target, part) in [("other.obj", "write-protected"), ("link.obj", "is a link to a file")] {
        for options in ["-o", "--stats", "--write-triangulation"] {
            let arguments = format!("convert in.obj {options} {target}");
            assert_contains(&workshop.fail(&arguments, 2), &[target, part], &arguments);
        }
    }
    assert!(workshop.path("link.obj").is_symlink());
}

#[test]
fn check_compares_numbers_and_tells_orientation_apart() {
    let workshop = workshop();
    workshop.put_surface("octahedron.obj", &classic::octahedron());
    workshop.succeed("convert octahedron.obj -o quads.obj");
    let quads = String::from_utf8(workshop.get("quads.obj")).unwrap();
    workshop.put("minus.obj", quads.replace(" 0.0", " -0.0"));
    workshop.succeed("check minus.obj --against octahedron.obj");
    let turned = quads.lines().map(|line| match line.strip_prefix("f ") {
        Some(corners) => {
            let mut corners: Vec<&str> = corners.split(' ').collect();
            corners.reverse();
            format!("f {}\n", corners.join(" "))
        }
        None => format!("{line}\n"),
    });
    workshop.put("turned.obj", turned.collect::<String>());
    let line = workshop.fail("check turned.obj --against octahedron.obj", 1);
    assert_contains(&line, &["turned.obj", "opposite orientation"], "turned");
}

/// The command of a row can be pasted into a shell, whatever the mesh is called.
#[test]
fn commands_of_rows_are_quoted() {
    let workshop = workshop();
    std::fs::create_dir(workshop.path("data")).unwrap();
    std::fs::copy(workshop.path("in.obj"), workshop.path("data/two words;$(x).obj")).unwrap();
    workshop.put("own.toml", EXPERIMENT.replace("meshes = [\"botijo\"]", "other_data = true"));
    workshop.succeed("run own.toml --data data --out out");
    let mut rows = csv::Reader::from_path(workshop.path("out/runs.csv")).unwrap();
    let column = rows.headers().unwrap().iter().position(|name| name == "command").unwrap();
    let commands: Vec<_> = rows.records().map(|row| row.unwrap()[column].to_owned()).collect();
    let mesh = "'two words;$(x).obj'";
    let expected = format!("triquad convert {mesh} --algorithm tq --augmentation local");
    assert!(commands.len() == 1 && commands[0].starts_with(&expected), "{commands:?}");
}
