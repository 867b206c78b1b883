//! Somebody's own experiments: what their page shows, what a folder takes, which names are known.

use crate::experiment_text::experiment;
use crate::experiments::Workshop;
use crate::workshop::assert_contains;

/// Two algorithms on a mesh of the papers, without the augmentation of their tables.
const EXPERIMENT: &str = experiment!(
    "evening",
    "convert",
    "[\"botijo\"]",
    r#"algorithms = ["ps", "tq"]
        augmentations = ["local"]
        repetitions = { full = 2, small = 2, demo = 2 }"#,
);

fn shop() -> Workshop {
    let shop = Workshop::new();
    std::fs::write(shop.path("own.toml"), EXPERIMENT).unwrap();
    shop
}

fn text(shop: &Workshop, file: &str) -> String {
    std::fs::read_to_string(shop.path(file)).unwrap()
}

/// The content of a section of the page, by the name that links lead to.
fn section<'p>(page: &'p str, id: &str) -> &'p str {
    let from = page.find(&format!("<details id=\"{id}\"")).unwrap_or_else(|| panic!("{id}"));
    let section = &page[from..];
    &section[..section.find("</details>").unwrap()]
}

#[test]
fn the_page_has_the_times_of_every_algorithm_whatever_its_augmentation() {
    let shop = shop();
    shop.succeed("run own.toml --scale demo --out out");
    let page = text(&shop, "out/index.html");
    let times = section(&page, "table-data");
    let columns = ["(a) pairing, s", "(d) augmentation, s", "(e) total, s"];
    assert_contains(times, &columns, "columns");
    assert_contains(times, &["<td>PS local</td>", "<td>TQ local</td>"], "rows");
    let table = text(&shop, "out/table_data.csv");
    let row = table.lines().find(|line| line.starts_with("botijo,TQ local,")).unwrap();
    let total: f64 = row.split(',').nth(6).unwrap().parse().unwrap();
    assert!(total > 0.0, "{row}");
    let papers = section(&page, "table-4-3");
    assert_eq!(papers.matches("not run with tarjan").count(), 1, "PS: {papers}");
    assert_eq!(papers.matches("not planned").count(), 3, "SG, DS and LRS: {papers}");
    assert_contains(papers, &["This table has runs with tarjan"], "note");
}

#[test]
fn a_folder_takes_no_experiment_of_another_name_unawares() {
    let shop = shop();
    shop.succeed("run own.toml --scale demo --out out");
    let before = text(&shop, "out/runs.csv");
    let said = shop.refused("run least.toml --scale demo --out out");
    assert_contains(&said, &["out: ", "\"evening\"", "\"least\"", "--out"], "refusal");
    assert_eq!(text(&shop, "out/runs.csv"), before);
    // The same experiment with more runs, another one beside it, and each of them again.
    let more = EXPERIMENT.replace("\"tq\"", "\"tq\", \"gw\"").replace("demo = 2", "demo = 3");
    std::fs::write(shop.path("own.toml"), more).unwrap();
    shop.succeed("run own.toml --scale demo --out out");
    assert_eq!(shop.results("out").records.len(), 9);
    for files in ["own.toml least.toml", "least.toml", "own.toml"] {
        shop.succeed(&format!("run {files} --scale demo --out out"));
    }
}

#[test]
fn parts_of_an_experiment_and_imported_rows_are_no_other_experiment() {
    let shop = shop();
    for part in 1..=2 {
        shop.succeed(&format!("run own.toml --scale demo --shard {part}/2 --out part-{part}"));
    }
    shop.succeed("merge part-1 part-2 --out whole");
    shop.succeed("run own.toml --scale demo --out whole");
    assert_eq!(shop.results("whole").records.len(), 4);
    std::fs::write(shop.path("rows.csv"), "mesh,total_seconds\nbotijo,0.5\n").unwrap();
    shop.succeed("import rows.csv --algorithm theirs --out theirs");
    shop.succeed("run own.toml --scale demo --out theirs");
    assert_eq!(shop.results("theirs").records.len(), 5);
}

#[test]
fn an_imported_algorithm_of_ours_may_be_in_capitals() {
    let shop = shop();
    std::fs::write(shop.path("rows.csv"), "mesh,total_seconds\nbotijo,0.5\n").unwrap();
    for (name, taken) in [("PS", "ps"), ("Brute-Force", "brute-force")] {
        let said = shop.succeed(&format!("import rows.csv --algorithm {name} --out {taken}"));
        assert_contains(&said, &[&format!("note: {name} is taken as {taken}")], name);
        let records = shop.results(taken).records;
        assert!(!records[0].id.job.is_program() && records[0].is_imported(), "{records:?}");
    }
    // Names of others stay as they are.
    let said = shop.succeed("import rows.csv --algorithm PSS --out pss");
    assert!(said.is_empty(), "{said}");
    assert_eq!(shop.results("pss").records[0].id.job.algorithm(), "PSS");
}
