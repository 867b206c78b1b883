//! Every public function has an example, or its module says why not.

use std::path::{Path, PathBuf};

/// What the documentation of a module says of functions that no example calls.
const REASON: &str = "no examples of";

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Returns the Rust files of a folder and its folders.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap()
}

/// Returns the text of the examples in the comments of a source.
fn doc_examples(source: &str) -> String {
    let comment = |line: &str| {
        let line = line.trim_start();
        line.strip_prefix("//!").or(line.strip_prefix("///")).map(str::to_owned)
    };
    let mut inside = false;
    let is_inside = |line: &String| {
        inside ^= line.trim_start().starts_with("```");
        inside
    };
    source.lines().filter_map(comment).filter(is_inside).collect::<Vec<_>>().join("\n")
}

/// Returns the names of the public functions of a source, without those of its tests.
fn public_functions(source: &str) -> impl Iterator<Item = &str> {
    let lines = source.lines().take_while(|line| *line != "#[cfg(test)]").map(str::trim_start);
    let after = lines.filter_map(|line| {
        line.strip_prefix("pub fn ").or_else(|| line.strip_prefix("pub const fn "))
    });
    after.map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap())
}

/// Returns the public modules of the library: name and files.
fn modules() -> Vec<(String, Vec<PathBuf>)> {
    let library = text(&root().join("src/lib.rs"));
    let names = library.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'));
    let files = |name: &str| {
        let file = root().join(format!("src/{name}.rs"));
        if file.exists() { vec![file] } else { sources(&root().join("src").join(name)) }
    };
    names.map(|name| (name.to_owned(), files(name))).collect()
}

/// Returns the comment at the top of a file.
fn page(source: &str) -> String {
    let lines = source.lines().take_while(|line| line.starts_with("//!"));
    lines.map(|line| line.trim_start_matches("//!")).collect::<Vec<_>>().join("")
}

#[test]
fn every_public_function_has_an_example_or_its_module_says_why_not() {
    let all = sources(&root().join("src")).into_iter().map(|path| doc_examples(&text(&path)));
    let programs = sources(&root().join("examples")).into_iter().map(|path| text(&path));
    let examples = all.chain(programs).collect::<Vec<_>>().join("\n");
    let is_called = |name: &str| {
        ["(", "::<"].iter().any(|after| {
            let call = format!("{name}{after}");
            examples
                .match_indices(&call)
                .any(|(at, _)| !examples[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_'))
        })
    };
    let mut missing = Vec::new();
    for (name, files) in modules() {
        let has_reason = files.iter().any(|file| page(&text(file)).contains(REASON));
        for file in files {
            let source = text(&file);
            let without = public_functions(&source).filter(|function| !is_called(function));
            missing.extend(
                without.filter(|_| !has_reason).map(|function| format!("{name}: {function}")),
            );
        }
    }
    assert!(missing.is_empty(), "neither an example nor a reason: {missing:?}");
    assert!(!is_called("no_such_function") && is_called("run"));
}

#[test]
fn every_public_module_has_an_example() {
    for (name, files) in modules() {
        let has_example = files.iter().any(|file| !doc_examples(&text(file)).is_empty());
        assert!(has_example, "{name}");
    }
}
