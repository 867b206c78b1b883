//! Odd arguments and files: each ends soon, with one line and a true remedy.

use crate::experiments::Workshop as Laboratory;
use crate::workshop::{Workshop, assert_contains};
use triquad_generators::classic;

fn workshop() -> Workshop {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &classic::octahedron());
    workshop
}

/// Some devices never end, and what is read of them is kept.
#[cfg(unix)]
#[test]
fn devices_are_no_inputs() {
    let workshop = workshop();
    std::os::unix::fs::symlink("/dev/zero", workshop.path("zero.ply")).unwrap();
    for arguments in [
        "convert in.obj --cost /dev/zero",
        "convert in.obj --keep-edges /dev/zero",
        "check in.obj --against in.obj --certificate /dev/zero",
        "import /dev/zero --algorithm mine --out out",
        "info zero.ply",
        "draw zero.ply -o picture.png",
    ] {
        let run = workshop.run(arguments);
        assert_eq!((run.code, run.stderr.lines().count()), (Some(2), 1), "{arguments}: {run:?}");
        assert_contains(&run.stderr, &["zero", "is a device, not a file"], arguments);
    }
}

#[test]
fn so_many_threads_are_refused() {
    let workshop = workshop();
    for threads in ["0", "1025", "100000", "18446744073709551615", "18446744073709551616", "-1"] {
        let line = workshop.fail(&format!("convert in.obj --threads={threads}"), 2);
        assert_contains(&line, &["--threads", "from 1 to 1024"], threads);
    }
    workshop.succeed("convert in.obj --threads 64");
}

#[test]
fn welding_everything_to_one_vertex_is_told() {
    let workshop = workshop();
    for distance in ["1e308", "9"] {
        let line = workshop.fail(&format!("convert in.obj --weld={distance}"), 2);
        assert_contains(&line, &["in.obj", "leaves no face", "smaller distance"], distance);
    }
}

/// A name with a line break would make every row of the folder unreadable.
#[test]
fn names_of_imported_algorithms_fit_a_row() {
    let shop = Laboratory::new();
    std::fs::write(shop.path("rows.csv"), "mesh,total_seconds\nbotijo,1\n").unwrap();
    let import = |name: &str| {
        let mut command = shop.command("import rows.csv --out out --algorithm");
        let output = command.arg(name).output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    for name in ["", "a\nb", "\u{7}", "=1+1", "@x", " x", &"x".repeat(61)] {
        let (code, line) = import(name);
        assert_eq!((code, line.lines().count()), (Some(2), 1), "{name:?}: {line}");
    }
    for name in ["mine", "Blossom V (2009)", "größer", &"x".repeat(60)] {
        assert_eq!(import(name), (Some(0), String::new()), "{name:?}");
    }
    assert_eq!(shop.results("out").records.len(), 4);
}
