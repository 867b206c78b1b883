//! A folder of its own for each test, and the tool run in it as a user would.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};

use serde_json::Value;
use tempfile::TempDir;
use triquad::mesh::{Mesh, Output};
use triquad_generators::Surface;

use crate::surfaces::face_list;

/// A folder of its own for each test, in which the tool runs.
pub struct Workshop(pub TempDir);

/// What a run of the tool left.
#[derive(Debug)]
pub struct Run {
    /// None if a signal ended it.
    pub code: Option<i32>,
    pub stdout: Vec<u8>,
    pub stderr: String,
}

impl Workshop {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn put(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).unwrap();
    }

    pub fn put_mesh(&self, name: &str, mesh: &Mesh) {
        Output::create(self.path(name)).unwrap().write(mesh).unwrap();
    }

    pub fn put_surface(&self, name: &str, surface: &Surface) {
        self.put_mesh(name, &face_list(surface));
    }

    pub fn get(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub fn mesh(&self, name: &str) -> Mesh {
        Mesh::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The names of all files and folders.
    pub fn names(&self) -> BTreeSet<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    /// What all files hold, by name; nothing for folders.
    pub fn content(&self) -> BTreeMap<String, Vec<u8>> {
        let content = |name: String| (std::fs::read(self.path(&name)).unwrap_or_default(), name);
        self.names().into_iter().map(content).map(|(bytes, name)| (name, bytes)).collect()
    }

    pub fn spawn(&self, arguments: &[&str]) -> Child {
        let mut command = Command::new(env!("CARGO_BIN_EXE_triquad"));
        command.args(arguments).current_dir(self.0.path());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command.spawn().unwrap()
    }

    /// Runs the tool; arguments are separated by blanks.
    pub fn run(&self, arguments: &str) -> Run {
        self.run_with_input(arguments, b"")
    }

    pub fn run_with_input(&self, arguments: &str, input: &[u8]) -> Run {
        let mut child = self.spawn(&arguments.split_whitespace().collect::<Vec<_>>());
        // A tool that does not want the input may end before it has taken it.
        let _ = child.stdin.take().unwrap().write_all(input);
        finish(child)
    }

    /// Runs the tool, which must succeed; returns its standard output.
    pub fn succeed(&self, arguments: &str) -> String {
        let run = self.run(arguments);
        assert_eq!(run.code, Some(0), "{arguments}: {run:?}");
        String::from_utf8(run.stdout).unwrap()
    }

    /// Runs the tool, which must print JSON on standard output and end with `code`.
    pub fn json(&self, arguments: &str, code: i32) -> Value {
        let run = self.run(arguments);
        assert_eq!(run.code, Some(code), "{arguments}: {run:?}");
        serde_json::from_slice(&run.stdout)
            .unwrap_or_else(|error| panic!("{arguments}: {error}: {run:?}"))
    }

    /// Runs the tool, which must end with `code`, one line on standard error and no change to any
    /// file; returns the line.
    pub fn fail(&self, arguments: &str, code: i32) -> String {
        let before = self.content();
        let run = self.run(arguments);
        assert_eq!(run.code, Some(code), "{arguments}: {run:?}");
        assert_eq!(run.stderr.lines().count(), 1, "{arguments}: {run:?}");
        assert!(!run.stderr.contains("panicked"), "{arguments}: {run:?}");
        let after = self.content();
        assert!(before == after, "{arguments} changed the folder to {:?}", after.keys());
        run.stderr
    }
}

pub fn finish(child: Child) -> Run {
    let output = child.wait_with_output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    Run { code: output.status.code(), stdout: output.stdout, stderr }
}

pub fn assert_contains(line: &str, parts: &[&str], what: &str) {
    for part in parts {
        assert!(line.contains(part), "{what}: '{part}' is not in '{}'", line.trim_end());
    }
}

/// Fails unless an object has these fields.
pub fn assert_has_fields(json: &Value, fields: &[&str]) {
    for field in fields {
        assert!(json.get(field).is_some(), "no field {field} in {json}");
    }
}
