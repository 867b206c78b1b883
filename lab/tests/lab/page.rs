//! The page: well-formed, complete in itself, navigable, honest about what is missing.

use std::collections::HashSet;
use std::process::Command;

use roxmltree::{Document, Node, ParsingOptions};
use triquad::augmentation::Augmentation;
use triquad_lab::algorithms::AlgorithmFacts;
use triquad_lab::experiment::results::{DamagedRow, MachineFacts};
use triquad_lab::experiment::{Job, Outcome, Results, RunRecord, Task};
use triquad_lab::meshes::paper::Scale;
use triquad_lab::meshes::{MeshKind, Origin};
use triquad_lab::paper::Table;
use triquad_lab::pictures::{PictureRecord, Subject};
use triquad_lab::report::defects::Defect;
use triquad_lab::report::page::{self, Parts, PictureFile};
use triquad_lab::report::plots::{self, Plot};
use triquad_lab::report::{Summary, compare, tables};

/// The page without its plots, which take the longest.
fn page_of(results: &Results) -> String {
    page_with(results, &[])
}

fn page_with_plots(results: &Results) -> String {
    page_with(results, &plots::all(&Summary::new(results)))
}

fn page_without_pictures(results: &Results) -> String {
    page_of_parts(results, &[], &[])
}

fn page_with(results: &Results, plots: &[Plot]) -> String {
    page_of_parts(results, plots, &pictures())
}

fn page_of_parts(results: &Results, plots: &[Plot], pictures: &[PictureFile]) -> String {
    let summary = Summary::new(results);
    let tables = tables::all(&summary);
    page::render(&Parts {
        results,
        summary: &summary,
        tables: &tables,
        comparison: &compare::judge(&summary),
        tolerances: &compare::tolerances(&summary),
        plots,
        pictures,
        defects: &Defect::all(results, &summary),
    })
}

/// A picture of each subject.
fn pictures() -> Vec<PictureFile> {
    let png = include_bytes!("../../../docs/box.png").to_vec();
    let of = |subject, algorithm: &str| {
        let record = PictureRecord {
            subject,
            algorithm: algorithm.into(),
            mesh: "botijo".into(),
            flipped_edges: 1234,
            ..PictureRecord::default()
        };
        PictureFile { record, png: png.clone() }
    };
    vec![of(Subject::Box, ""), of(Subject::Quads, "lrs"), of(Subject::Quads, "lrs few-flips")]
}

/// The records of the papers' tables, with `local` beside `tarjan`: each of these takes LRS twice
/// as long as PS.
fn both_augmentations() -> Results {
    let mut results = crate::records::of_the_papers();
    let conversions = results.records.iter().filter(|run| run.id.mesh.experiment == "comparison");
    let local = |run: &RunRecord| {
        let mut run = run.clone();
        let is_lrs = run.id.job.algorithm() == "lrs";
        run.id.job = run.id.job.with_augmentation(Augmentation::Local);
        run.measured.pairing_seconds = Some(if is_lrs { 2.0 } else { 1.0 });
        run.measured.augmentation_seconds = Some(0.0);
        run
    };
    let local: Vec<RunRecord> = conversions.map(local).collect();
    results.records.extend(local);
    results
}

fn parsed(page: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(page, options).expect("well-formed")
}

fn elements<'a>(page: &'a Document<'a>, name: &'a str) -> impl Iterator<Item = Node<'a, 'a>> {
    page.descendants().filter(move |node| node.is_element() && node.tag_name().name() == name)
}

/// Checks what holds of every page about the papers' experiments.
fn check(page: &str) {
    check_form(page);
    let tables = Table::ALL.map(|table| table.file.trim_end_matches(".csv").replace('_', "-"));
    let figures = ["5-11", "5-12", "5-13", "5-14", "14", "15", "16", "17", "18"];
    for id in tables.into_iter().chain(figures.map(|number| format!("figure-{number}"))) {
        assert!(page.contains(&format!("id=\"{id}\"")), "{id} cannot be found");
        assert!(page.contains(&format!("href=\"#{id}\"")), "{id} is not in the contents");
    }
}

/// Checks what holds of every page, whatever the records.
fn check_form(page: &str) {
    let document = parsed(page);
    let ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    let known: HashSet<&str> = ids.iter().copied().collect();
    assert_eq!(ids.len(), known.len(), "an id is there twice");
    for node in document.descendants() {
        for name in ["href", "src", "data", "poster", "action"] {
            let Some(target) = node.attribute(name) else { continue };
            let inside = target.strip_prefix('#').is_some_and(|id| known.contains(id));
            assert!(inside || target.starts_with("data:image/png;base64,"), "{name}={target:.60}");
        }
        if let Some(heading) = node.attribute("aria-labelledby") {
            assert!(known.contains(heading), "{heading}");
        }
    }
    let style = elements(&document, "style").next().and_then(|node| node.text()).unwrap();
    assert!(!style.contains("url(") && !style.contains("@import"));
    assert_eq!(elements(&document, "script").count(), 0);
    for (name, count) in [("h1", 1), ("main", 1), ("nav", 1), ("header", 1), ("footer", 1)] {
        assert_eq!(elements(&document, name).count(), count, "{name}");
    }
    for table in elements(&document, "table") {
        assert!(table.children().any(|child| child.has_tag_name("caption")));
        let region = table.parent_element().unwrap();
        let focusable = region.attribute("tabindex") == Some("0");
        assert!(focusable && region.attribute("aria-label").is_some_and(|label| !label.is_empty()));
    }
    assert!(elements(&document, "th").all(|cell| cell.attribute("scope").is_some()));
    assert!(elements(&document, "img").all(|image| image.attribute("alt") != Some("")));
}

/// The headings of the sections, in order, without that of the contents.
fn headings(page: &str) -> Vec<String> {
    let document = parsed(page);
    let headings = elements(&document, "h2").filter(|heading| heading.attribute("id").is_some());
    headings.map(|heading| heading.text().unwrap().to_owned()).collect()
}

#[test]
fn a_full_page_is_well_formed_small_and_the_same_again() {
    let results = both_augmentations();
    let page = page_with_plots(&results);
    check(&page);
    assert!(page.len() < 5_000_000, "{} bytes", page.len());
    assert!(page == page_with_plots(&results), "two renderings differ");
    for run in &results.records {
        assert!(page.contains(&run.command), "{}", run.command);
    }
    let judged = compare::judge(&Summary::new(&results)).verdicts;
    assert!(judged.iter().all(|claim| page.contains(&format!("id=\"claim-{}\"", claim.id))));
    assert!(page.contains("1234 of"), "flipped edges are counted");
}

/// Tables 4.3 and 4.4 have LRS faster on A1 to A5, Happy Buddha and Iphigenia.
/// These, with a path by `rebuild` on each mesh that costs as much as one by `tarjan`.
fn with_rebuild(results: &Results) -> Results {
    let mut results = results.clone();
    let is_timed = |run: &&RunRecord| run.id.job.names().augmentation == Some("tarjan");
    let rebuilt = |run: &RunRecord| {
        let mut run = run.clone();
        run.id.job = run.id.job.with_augmentation(Augmentation::Rebuild);
        run
    };
    let rebuilt: Vec<RunRecord> = results.records.iter().filter(is_timed).map(rebuilt).collect();
    results.records.extend(rebuilt);
    results
}

#[test]
fn whether_lrs_still_beats_ps_is_answered_from_the_records() {
    let mut results = both_augmentations();
    let page = page_of(&results);
    assert!(page.contains("No: with the better augmentation LRS no longer beats PS where it did."));
    assert!(page.contains("LRS is faster on 7 of 16 meshes; with ours it is faster on 0 of these"));
    assert!(!page.contains("set up anew for each path it is"));
    assert!(
        page_of(&with_rebuild(&results)).contains("anew for each path it is faster on 7 of 16.")
    );
    // Another experiment on the same meshes adds no mesh.
    let mut others = results.records.clone();
    others.retain(|run| run.id.job.algorithm() == "sg");
    others.iter_mut().for_each(|run| run.id.mesh.experiment = "zz".into());
    let more = Results { records: [results.records.clone(), others].concat(), ..results.clone() };
    assert!(page_of(&more).contains("LRS is faster on 7 of 16 meshes; with ours"));
    results.records.iter_mut().for_each(|run| run.parallel_jobs = 2);
    assert!(page_of(&results).contains("runs went on side by side, so that their times"));
    results.records.retain(|run| run.id.job.names().augmentation == Some("tarjan"));
    results.records.iter_mut().for_each(|run| run.parallel_jobs = 1);
    assert!(page_of(&results).contains("no mesh has PS and LRS under both augmentations"));
}

#[test]
fn of_smaller_meshes_nothing_is_concluded_about_the_papers() {
    let mut results = both_augmentations();
    results.planned.iter_mut().for_each(|cell| cell.id.mesh.scale = Scale::Demo);
    for run in &mut results.records {
        run.id.mesh.scale = Scale::Demo;
        run.mesh_kind = MeshKind::Generated;
    }
    let page = page_of(&results);
    let found = page.split("id=\"found\"").nth(1).unwrap().split("</section>").next().unwrap();
    for said in [
        "Of those that could be decided at scale demo, these are reproduced",
        "not comparable with the printed ones at scale demo. ",
        "Undecided: at scale demo LRS beats PS on most meshes with neither augmentation. With the",
        "than BF on 28 of 28 boxes at scale demo. ",
    ] {
        assert!(found.contains(said), "{said}: {found}");
    }
    assert!(!found.contains("no longer") && !found.contains("within 1.5 %"), "{found}");
    // Where LRS wins mostly, the better augmentation decides also at this scale.
    for run in &mut results.records {
        let is_published = run.id.job.names().augmentation == Some("tarjan");
        if is_published && run.id.job.algorithm() == "lrs" {
            run.measured.augmentation_seconds = Some(0.0);
            run.measured.pairing_seconds = Some(1e-3);
        }
    }
    assert!(page_of(&results).contains("LRS no longer beats PS where it did. With the"));
}

#[test]
fn meshes_are_labelled_by_their_origin_and_every_label_is_defined() {
    let known = include_str!("../../../experiments/origins.csv");
    let mut results = crate::records::of_the_papers();
    for run in &mut results.records {
        let of_mesh = |line: &&str| line.split(',').nth(1) == Some(run.id.mesh.name.as_str());
        let hash = known.lines().find(of_mesh).and_then(|line| line.split(',').next());
        run.mesh_sha256 = hash.unwrap_or_default().into();
        if run.id.mesh.name == "hand" {
            run.mesh_kind = MeshKind::StandIn;
        }
    }
    let page = page_of(&results);
    let labels = ["socket <small>original", "botijo <small>derived", "eros <small>file"];
    let others = ["A1 <small>generated", "A2 <small>simplified", "hand† <small>stand-in"];
    for label in labels.into_iter().chain(others) {
        assert!(page.contains(&format!("<th scope=\"row\">{label}</small>")), "{label}");
    }
    assert!(!page.contains("<small>real</small>"));
    for origin in Origin::ALL {
        assert!(page.contains(&format!("<dt>{}</dt><dd>mesh: ", origin.id())), "{origin:?}");
    }
}

#[test]
fn no_records_give_a_page_that_says_so() {
    let page = page_of(&Results::default());
    check(&page);
    assert!(page.contains("there is no record of any run"));
    assert!(page.contains("No run is recorded for this table."));
    assert!(page.contains("Nothing is recorded for this figure."));
}

/// A run of PS on a mesh of somebody's own.
fn own_run(group: &str) -> RunRecord {
    let mut run = crate::records::run("mine", group, "botijo", "ps");
    run.id.mesh.name = "chair".into();
    run.measured.unpaired_triangles = Some(4);
    run.measured.total_seconds = Some(0.25);
    run
}

/// Sections that every page has at its end.
const LAST: [&str; 4] = [
    "Limits, and what is not comparable",
    "What is missing or damaged",
    "Machines and builds",
    "Commands",
];

#[test]
fn own_results_come_first_under_their_name_and_nothing_is_said_of_what_nobody_ran() {
    let plain = |page: &str| page.replace(" open=\"\"", "");
    for group in ["scans", "own"] {
        let run = own_run(group);
        let planned = vec![crate::records::planned(&run, 1)];
        let machines = [(run.machine.clone(), MachineFacts::new())].into();
        let results = Results { planned, machines, records: vec![run], ..Results::default() };
        let page = page_without_pictures(&results);
        check_form(&page);
        assert!(page.contains("<title>Results: mine (triquad)</title>"), "{group}");
        assert!(page.contains("<h1>Results: mine</h1>"), "{group}");
        assert!(page.contains("This page is made of 1 recorded run."), "{page:.3000}");
        let sections: Vec<String> =
            ["Tables", "Definitions"].into_iter().chain(LAST).map(str::to_owned).collect();
        assert_eq!(headings(&page), sections, "{group}");
        let tables = plain(&page);
        let first = tables.find("<details id=").map(|at| &tables[at..at + 29]);
        assert_eq!(first, Some("<details id=\"table-data\"><sum"), "{group}");
        assert!(page.contains("<p>Nothing: every planned run has a row"), "{group}");
        for absent in ["0 of 0", "class=\"warning\"", "class=\"missing\"", "table-augmentation"] {
            assert!(!page.contains(absent), "{group}: {absent}");
        }
    }
}

#[test]
fn beside_own_results_the_papers_have_only_what_was_run() {
    // A program on a mesh of the paper, and an import that calls itself by the paper's name.
    let mut program = own_run("own");
    program.id.mesh.name = "botijo".into();
    program.id.job = Job::program(Task::Convert, "mymatch");
    let mut imported = program.clone();
    imported.id.mesh.experiment = "comparison".into();
    imported.machine = "imported mymatch".into();
    for (run, name) in [(program, "mine"), (imported, "mymatch")] {
        // There is no plan.
        let machines = [(run.machine.clone(), MachineFacts::new())].into();
        let records = vec![run];
        let page = page_without_pictures(&Results { machines, records, ..Results::default() });
        check_form(&page);
        assert!(page.contains(&format!("<h1>Results: {name}</h1>")), "{name}");
        let sections = ["Tables", "Comparison paper", "Definitions", "References"];
        let sections: Vec<String> = sections.into_iter().chain(LAST).map(str::to_owned).collect();
        assert_eq!(headings(&page), sections, "{name}");
        for id in ["table-4-1", "table-4-3"] {
            assert!(page.contains(&format!("<details id=\"{id}\" open=\"\">")), "{name}: {id}");
        }
        assert!(!page.contains("table-4-2-a") && !page.contains("figure-"), "{name}");
        assert!(!page.contains("<th scope=\"row\">eros"), "{name}: a mesh that nobody ran");
        assert!(page.contains("1 thing is missing or damaged: see the list below."), "{name}");
    }
    // Among the papers' own runs they change nothing of the order.
    let mut results = both_augmentations();
    results.records.push(own_run("own"));
    let page = page_of(&results);
    assert!(page.contains("<h1>Two papers on triangulations, run again</h1>"));
    let sections = [
        "What was found",
        "Definitions",
        "Verdicts",
        "What changes with a better augmentation",
        "Comparison paper",
        "Paper on irreducible triangulations",
        "More plots",
        "More tables",
        "References",
    ];
    let sections: Vec<String> = sections.into_iter().chain(LAST).map(str::to_owned).collect();
    assert_eq!(headings(&page), sections);
}

#[test]
fn findings_without_evidence_are_left_out() {
    let mut results = crate::records::of_the_papers();
    let has_all = page_of(&results);
    assert_eq!(has_all.matches("See the counts").count(), 1);
    let reductions = "RS visits fewer link vertices than S on 18 and than BF on 28 of 28 boxes; it is \
                      faster than S on 28 of 28 boxes and than BF on 28 of 28 boxes.";
    assert!(has_all.contains(reductions));
    results.records.retain(|run| run.id.mesh.experiment == "comparison");
    let page = page_of(&results);
    assert!(page.contains("<h1>Two papers") && page.contains("these are reproduced: "));
    assert!(!page.contains("0 of 0") && !page.contains("See the counts"), "{page:.4000}");
    results.records.truncate(1);
    assert!(page_of(&results).contains("These records decide none of the "));
}

/// The texts of the cells of a table's row, found by its mesh and algorithm, with their classes.
fn cells_of(page: &str, table: &str, row: [&str; 2]) -> Vec<Vec<(String, String)>> {
    let document = parsed(page);
    let table = document.descendants().find(|node| node.attribute("id") == Some(table)).unwrap();
    let text = |node: Node| node.text().unwrap_or_default().trim().to_owned();
    let is_row = |node: &Node| {
        let mut cells = node.children().filter(Node::is_element);
        node.has_tag_name("tr")
            && row.iter().all(|name| cells.next().is_some_and(|c| text(c) == *name))
    };
    let row = table.descendants().find(is_row).expect(row[0]);
    let cells = row.children().filter(|node| node.has_tag_name("td"));
    let parts = |cell: Node| {
        let elements = cell.children().filter(Node::is_element);
        let smalls =
            elements.map(|part| (part.attribute("class").unwrap_or_default().into(), text(part)));
        std::iter::once((String::new(), text(cell))).chain(smalls).collect()
    };
    cells.map(parts).collect()
}

#[test]
fn times_of_two_machines_are_not_compared_and_no_difference_is_a_fault() {
    let mut results = crate::records::of_the_papers();
    for run in &mut results.records {
        let measured = &mut run.measured;
        for seconds in [&mut measured.pairing_seconds, &mut measured.augmentation_seconds] {
            *seconds = seconds.map(|seconds| seconds / 1000.0);
        }
        measured.unpaired_triangles = measured.unpaired_triangles.map(|count| 2 * count);
    }
    let page = page_of(&results);
    let cells = cells_of(&page, "table-4-3", ["botijo", "LRS"]);
    let part = |class: &str, text: &str| (class.to_owned(), text.to_owned());
    // (a), seconds: a thousand times as fast as printed.
    assert_eq!(cells[1], [part("", "0.0007035"), part("", "paper 0.7035")]);
    assert_eq!(cells[4], [part("", "0.000018"), part("", "paper 0.01820")]);
    // (c), a count.
    let twice = [part("", "124"), part("", "paper 62"), part("difference more", "▲ × 2.000")];
    assert_eq!(cells[3], twice);
    let style = page.split("<style>").nth(1).unwrap().split("</style>").next().unwrap();
    let rule = style.lines().find(|line| line.starts_with(".difference.more")).unwrap();
    assert!(rule.contains("var(--other)") && !rule.contains("--bad"), "{rule}");
}

#[test]
fn every_algorithm_is_defined_where_it_was_run() {
    let page = page_of(&crate::records::of_the_papers());
    for facts in AlgorithmFacts::all() {
        let words = format!("<dt>{}</dt><dd>{}</dd>", facts.label, facts.meaning);
        assert!(page.contains(&words.replace('\'', "&#x27;")), "{words}");
    }
    let results = Results { records: vec![own_run("own")], ..Results::default() };
    let page = page_of(&results);
    assert!(page.contains("<dt>PS</dt><dd>Pulli and Segal") && !page.contains("<dt>SG</dt>"));
    let is_defined = |word: &str| page.contains(&format!("<dt>{word}</dt>"));
    assert!(["α", "tarjan", "file"].into_iter().all(is_defined));
    // Nothing was contracted, no stand-in made.
    let unused = ["ε", "ℓ (irreducible)", "d·d a test", "rebuild", "local", "stand-in"];
    assert!(!unused.into_iter().any(is_defined));
}

#[test]
fn what_is_missing_damaged_or_failed_is_listed_and_escaped() {
    let mut results = crate::records::of_the_papers();
    let lost = results.records.iter().position(|run| run.id.job.algorithm() == "ps").unwrap();
    results.records.remove(lost);
    let failed = results.records.iter_mut().find(|run| run.id.job.algorithm() == "ds").unwrap();
    failed.outcome = Outcome::Timeout;
    failed.reason = "more than <1200> seconds".into();
    let problem = "a <script> & more".into();
    results.damaged.push(DamagedRow { line: 77, text: "x".into(), problem });
    let page = page_of(&results);
    check(&page);
    assert!(page.contains("PS on botijo: 1 planned run has no row"));
    assert!(page.contains("timeout 1 (more than &lt;1200&gt; seconds)"));
    assert!(page.contains("line 77: damaged and left out: a &lt;script&gt; &amp; more"));
    assert!(page.contains("nothing about the machine bench"));
    assert!(!page.contains("Pictures are not drawn"));
    // They are no damage: there are as many things as with them.
    let note = "<strong>Note:</strong> ";
    let things =
        |page: &str| page.split(note).nth(1).unwrap().split(' ').next().unwrap().to_owned();
    let without = page_without_pictures(&results);
    assert!(without.contains("Pictures are not drawn: <code>triquad report DIR --pictures "));
    assert_eq!(things(&without), things(&page));
}

#[test]
fn stand_ins_and_smaller_scales_are_marked() {
    let mut results = crate::records::of_the_papers();
    for run in &mut results.records {
        run.mesh_kind = MeshKind::StandIn;
        run.id.mesh.scale = Scale::Demo;
    }
    let page = page_of(&results);
    assert!(page.contains("botijo†") && page.contains("Scale demo: the meshes are smaller"));
    assert!(!page.contains("▲") && !page.contains("▼"), "numbers of other sizes are compared");
    for same in page.match_indices("genus of the paper&#x27;s scan") {
        let sentence = page[..same.0].rsplit("† ").next().unwrap();
        assert!(sentence.starts_with("At full scale a stand-in has"), "{sentence}");
    }
    assert!(page.contains("At full scale a stand-in has the vertex count"));
    assert!(page_of(&both_augmentations()).contains("= equal"));
}

#[test]
fn a_browser_shows_it_at_the_widths_of_a_phone_and_a_desk() {
    let Some(browser) = browser() else {
        eprintln!("skipped: no chromium to open the page with");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("index.html");
    std::fs::write(&file, page_with_plots(&both_augmentations())).unwrap();
    for width in [360, 1280] {
        let picture = folder.path().join(format!("{width}.png"));
        let status = Command::new(browser)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"])
            .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
            .arg(format!("--window-size={width},1600"))
            .arg(format!("--screenshot={}", picture.display()))
            .arg(format!("file://{}", file.display()))
            .output()
            .unwrap()
            .status;
        assert!(status.success());
        let decoder = png::Decoder::new(std::io::Cursor::new(std::fs::read(&picture).unwrap()));
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        let channels = reader.info().bytes_per_pixel();
        let dark = pixels.chunks(channels).filter(|pixel| pixel[0] < 100).count();
        assert!(dark > 2_000, "hardly anything is to be seen at {width}: {dark} dark pixels");
    }
}

fn browser() -> Option<&'static str> {
    ["chromium", "chromium-browser", "google-chrome"]
        .into_iter()
        .find(|name| Command::new(name).arg("--version").output().is_ok())
}
