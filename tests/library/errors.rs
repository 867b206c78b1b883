//! Errors as `main` prints them: by `Debug`, with the file, the law and the remedy.

use std::path::Path;

use triquad::{Converter, Mesh, Triangulation};
use triquad_generators::grids;

#[test]
fn an_error_that_main_returns_names_file_law_and_remedy() {
    let absent = format!("{:?}", Mesh::read("absent.obj").unwrap_err());
    assert!(absent.starts_with("absent.obj: ") && absent.contains("; check the path"), "{absent}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cut.obj");
    std::fs::write(&path, "v 0 0 0\nv 0 0\n").unwrap();
    let error = Mesh::read(&path).unwrap_err();
    let expected = format!("{}: line 2: a vertex needs three coordinates", path.display());
    assert!(error.to_string().starts_with(&expected), "{error}");
    assert!(format!("{error:?}").ends_with("; correct the file there or export it again"));
    assert!(error.without_path().to_string().starts_with("line 2: "));

    let sphere = grids::sphere(3);
    let mesh = Mesh::from_triangles(sphere.positions, sphere.triangles);
    assert!(Triangulation::build(&mesh).is_ok());
    let unwritable = format!("{:?}", mesh.write("quads.xyz").unwrap_err());
    assert!(unwritable.starts_with("quads.xyz: unknown mesh format"), "{unwritable}");
    assert!(unwritable.ends_with("; write .obj, .ply or .off, each also with .gz"), "{unwritable}");
    let mut triangles: Vec<[u32; 3]> = mesh.faces().corners().as_chunks().0.to_vec();
    triangles.pop();
    let open = Mesh::from_triangles(mesh.positions().to_vec(), triangles);
    let refused = format!("{:?}", Converter::new().run(&open).unwrap_err());
    assert!(
        refused.contains("boundary edge") && refused.contains(" [boundary-edge]; "),
        "{refused}"
    );
}

/// The library is used without the command: its messages name functions, not options.
#[test]
fn no_text_of_the_library_names_an_option_of_the_command() {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    let mut lines = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            for line in text.lines().filter(|line| !line.trim_start().starts_with("//")) {
                lines += 1;
                let mut behind = line.split("--").skip(1);
                let is_option = |rest: &str| rest.starts_with(|c: char| c.is_ascii_lowercase());
                assert!(!behind.any(is_option), "{}: {line}", path.display());
            }
        }
    }
    assert!(lines > 1000);
}
