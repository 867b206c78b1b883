//! Numbers in README and documents are those of the records in the repository.

use std::path::{Path, PathBuf};

use triquad_lab::experiment::Results;
use triquad_lab::report::{Summary, documents, plots};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The newest folder of results in the repository; their names begin with the date.
fn newest_results() -> Results {
    newest("20")
}

/// The newest results of `experiments/quality.toml`.
fn newest_quality() -> Results {
    newest("quality-20")
}

fn newest(prefix: &str) -> Results {
    let folders = std::fs::read_dir(root().join("results")).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path()).filter(|path| {
        path.is_dir() && path.file_name().unwrap().to_str().unwrap().starts_with(prefix)
    });
    Results::read(&folders.max().expect("a folder of results")).unwrap()
}

/// README and every document, with its text.
fn documents() -> Vec<(PathBuf, String)> {
    let docs = std::fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let markdown = docs.filter(|path| path.extension().is_some_and(|name| name == "md"));
    let paths = markdown.chain([root().join("README.md")]);
    paths.map(|path| (path.clone(), std::fs::read_to_string(&path).unwrap())).collect()
}

#[test]
fn tables_in_the_documents_are_those_of_the_newest_results() {
    let (results, quality, mut tables) = (newest_results(), newest_quality(), 0);
    for (path, text) in documents() {
        let filled = documents::fill(&text, &results).unwrap();
        assert!(filled == text, "{}: run `make documents`", path.display());
        if path.ends_with("quality.md") {
            let filled = documents::fill(&text, &quality).unwrap();
            assert!(filled == text, "{}: run `make documents`", path.display());
            assert!(text.contains("| fandisk_12946 | best | 0.0 |"));
        }
        tables += text.matches("<!-- table: ").count();
    }
    assert!(tables > 5, "only {tables} tables");
}

#[test]
fn a_changed_digit_in_a_table_is_put_right() {
    let results = newest_results();
    let (_, readme) = documents().pop().unwrap();
    let table = readme.find("<!-- table: conversions -->").unwrap();
    let rows = table + readme[table..].find("|---|").unwrap();
    let digit = rows + readme[rows..].find(|c: char| c.is_ascii_digit()).unwrap();
    let mut wrong = readme.clone();
    wrong.insert(digit, '7');
    assert_eq!(documents::fill(&wrong, &results).unwrap(), readme);
}

#[test]
fn the_plots_in_the_documents_are_those_of_the_newest_results() {
    let plots = [(newest_results(), "lrs_against_ps"), (newest_quality(), "side_by_side_mean")];
    for (results, name) in plots {
        let plot = plots::named(&Summary::new(&results), name).unwrap();
        let kept = std::fs::read_to_string(root().join(format!("docs/{name}.svg"))).unwrap();
        assert!(kept == plot.svg, "run `make documents`");
    }
}
