//! The tables of options in `docs/cli.md`: each verb has exactly the rows of its options.
//!
//! | section | verbs of a row |
//! |---|---|
//! | named by verbs, tables without a column of verbs | all verbs of the section |
//! | with a column of verbs | those named there; `both` or `all`: every verb of the section |

use std::collections::{BTreeMap, BTreeSet};

use crate::documents::{help, long_options, root, verbs};

type Options = BTreeMap<String, BTreeSet<String>>;

/// Titles of the columns that name verbs.
const COLUMNS_OF_VERBS: &[&str] = &["verb", "verbs", "of"];

/// Returns the words of a text that stand in backticks.
pub fn literals(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// Returns the cells of a row of a table. A bar behind a backslash is part of its cell.
pub fn cells(line: &str) -> Option<Vec<String>> {
    let row = line.strip_prefix('|')?.replace("\\|", "/");
    Some(row.split('|').map(|cell| cell.trim().to_owned()).collect())
}

/// Returns the options of each verb on the page. `sections` has the verbs of the sections whose
/// heading does not name them, each with the words before it.
fn options_on(page: &str, sections: &BTreeMap<&str, (&str, Vec<String>)>) -> Options {
    let mut found = Options::new();
    for section in page.split("\n## ").skip(1) {
        let heading = section.lines().next().unwrap_or_default();
        let named = || ("", literals(heading).into_iter().map(str::to_owned).collect());
        let (before, verbs) = sections.get(heading).cloned().unwrap_or_else(named);
        let mut titles = Vec::new();
        for line in section.lines() {
            let Some(cells) = cells(line) else {
                titles.clear();
                continue;
            };
            if titles.is_empty() {
                titles = cells;
                continue;
            }
            if titles[0] != "option" {
                continue;
            }
            let column = titles.iter().position(|title| COLUMNS_OF_VERBS.contains(&&**title));
            let of_row = match column.map(|column| &*cells[column]) {
                None | Some("both" | "all") => verbs.clone(),
                Some(text) => literals(text).into_iter().map(str::to_owned).collect(),
            };
            for verb in of_row {
                assert!(verbs.contains(&verb), "{heading}: {verb} is no verb of it");
                found.entry(format!("{before}{verb}")).or_default().extend(long_options(&cells[0]));
            }
        }
    }
    found
}

/// Returns the options of a help text that are not those of every verb, alternative names too.
fn options_in(help: &str) -> BTreeSet<String> {
    let own = help.split("\nEverywhere:").next().unwrap_or_default();
    let mut found = BTreeSet::new();
    for line in own.lines() {
        let text = line.trim_start();
        let is_option = text.starts_with('-') && line.len() - text.len() <= 6;
        if is_option {
            let name = text.split(['<', '[']).next().unwrap_or_default();
            found.extend(long_options(name.split("  ").next().unwrap_or_default()));
        } else if text.starts_with("[alias") {
            found.extend(long_options(text));
        }
    }
    found.remove("--help");
    found.remove("--version");
    found
}

#[test]
fn each_verb_has_exactly_its_options_in_the_tables_of_the_page() {
    let page = std::fs::read_to_string(root().join("docs/cli.md")).unwrap();
    let mut expected = Options::new();
    let mut kinds = Vec::new();
    let of_all = verbs(&help(&[]));
    for verb in &of_all {
        let text = help(&[verb]);
        for kind in verbs(&text) {
            assert_eq!(verb, "generate", "the only verb with verbs of its own");
            expected.insert(format!("generate {kind}"), options_in(&help(&[verb, &kind])));
            kinds.push(kind);
        }
        expected.insert(verb.clone(), options_in(&text));
    }
    expected.retain(|_, options| !options.is_empty());
    assert!(expected.len() > 12, "{expected:?}");
    let sections =
        BTreeMap::from([("`generate`", ("generate ", kinds)), ("Experiments", ("", of_all))]);
    let found = options_on(&page, &sections);
    let verbs: BTreeSet<&String> = expected.keys().chain(found.keys()).collect();
    let none = BTreeSet::new();
    let mut wrong = Vec::new();
    for verb in verbs {
        let [page, help] = [&found, &expected].map(|of| of.get(verb).unwrap_or(&none));
        let list = |options: BTreeSet<&String>, what: &str| {
            (!options.is_empty()).then(|| format!("{verb}: {what} {options:?}"))
        };
        wrong.extend(list(help.difference(page).collect(), "not on the page:"));
        wrong.extend(list(page.difference(help).collect(), "on the page alone:"));
    }
    assert!(wrong.is_empty(), "docs/cli.md\n{}", wrong.join("\n"));
}

#[test]
fn a_row_counts_for_its_verbs_and_in_tables_of_options_alone() {
    let page = [
        "",
        "## `a` and `b`",
        "",
        "| option | verb | meaning |",
        "|---|---|---|",
        "| `-o`, `--out X\\|Y` | both | not `--no` |",
        "| `--one` | `a` | |",
        "",
        "| other | |",
        "|---|---|",
        "| `--not` | |",
    ];
    let found = options_on(&page.join("\n"), &BTreeMap::new());
    assert_eq!(found["a"], long_options("--out --one"));
    assert_eq!(found["b"], long_options("--out"));
    let help = [
        "Options:",
        "      --colour <N>",
        "          --deep",
        "          [alias: --color]",
        "  -s, --short  Text --none",
        "",
        "Everywhere:",
        "  -q, --quiet",
    ];
    assert_eq!(options_in(&help.join("\n")), long_options("--colour --color --short"));
}
