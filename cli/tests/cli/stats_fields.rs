//! The table of fields of `--stats` in `docs/cli.md`: each verb has the rows of what it writes.

use std::collections::{BTreeMap, BTreeSet};

use triquad_generators::classic;
use triquad_generators::random::Mix;
use triquad_generators::testing::random_of;

use crate::documents::root;
use crate::option_tables::{cells, literals};
use crate::workshop::Workshop;

type Fields = BTreeMap<String, BTreeSet<String>>;

const VERBS: [&str; 4] = ["convert", "check", "simplify", "irreducible"];

/// Runs that write, all together, every field that there is.
const RUNS: &[&str] = &[
    "convert in.obj -o quads.obj --keep-sharp 30",
    "convert in.obj --algorithm lrs",
    "convert in.obj --algorithm sg --stop-after-paths 1",
    "convert strip.obj --open",
    "check quads.obj --against in.obj",
    "simplify in.obj --vertices 20",
    "irreducible in.obj",
];

/// Returns the fields that each verb writes.
fn written() -> Fields {
    let workshop = Workshop::new();
    workshop.put_surface("in.obj", &random_of(1, 60, Mix::Balanced, 5));
    workshop.put_surface("strip.obj", &classic::moebius_strip(7));
    let mut fields = Fields::new();
    for run in RUNS {
        let stats = workshop.json(&format!("{run} --stats -"), 0);
        let verb = run.split(' ').next().unwrap_or_default();
        let names = stats.as_object().unwrap().keys().cloned();
        fields.entry(verb.to_owned()).or_default().extend(names);
    }
    fields
}

/// Returns the fields that the page has for each verb; no row comes twice.
fn on_page(page: &str) -> Fields {
    let section = page.split("\n## Fields of `--stats`\n").nth(1).expect("the section");
    let section = section.split("\n## ").next().unwrap_or_default();
    let mut fields = Fields::new();
    for cells in section.lines().filter_map(cells).skip(2) {
        let verbs = if cells[3] == "all" { VERBS.to_vec() } else { literals(&cells[3]) };
        assert!(!verbs.is_empty() && !cells[2].is_empty(), "{cells:?}");
        for verb in verbs {
            for field in literals(&cells[0]) {
                let is_new = fields.entry(verb.to_owned()).or_default().insert(field.to_owned());
                assert!(is_new, "{verb}: {field} comes twice");
            }
        }
    }
    fields
}

#[test]
fn every_field_of_stats_is_documented_for_the_verbs_that_write_it() {
    let page = std::fs::read_to_string(root().join("docs/cli.md")).unwrap();
    let (written, on_page) = (written(), on_page(&page));
    for verb in VERBS {
        let [written, on_page] = [&written, &on_page].map(|fields| &fields[verb]);
        let undocumented: Vec<_> = written.difference(on_page).collect();
        let invented: Vec<_> = on_page.difference(written).collect();
        assert!(undocumented.is_empty(), "{verb}: not in docs/cli.md: {undocumented:?}");
        assert!(invented.is_empty(), "{verb}: in docs/cli.md alone: {invented:?}");
    }
    assert_eq!(on_page.len(), VERBS.len(), "{:?}", on_page.keys());
}
