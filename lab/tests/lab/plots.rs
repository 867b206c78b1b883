//! Plots: what is in the records is in them, marked for what it is, and the same again.

use roxmltree::Document;
use triquad::augmentation::Augmentation;
use triquad_lab::experiment::{Outcome, Results, RunRecord};
use triquad_lab::meshes::MeshKind;
use triquad_lab::meshes::paper::Scale;
use triquad_lab::report::Summary;
use triquad_lab::report::plots::{self, Plot};

fn plots_of(results: &Results) -> Vec<Plot> {
    plots::all(&Summary::new(results))
}

/// The plot of that name, of records in which `change` was made.
fn plot(stem: &str, change: impl Fn(&mut RunRecord)) -> Option<Plot> {
    let mut results = crate::records::of_the_papers();
    results.records.retain(|run| run.repetition < 2);
    results.planned.clear();
    results.records.iter_mut().for_each(change);
    plots::named(&Summary::new(&results), stem)
}

/// What is written in a plot.
fn texts(plot: &Plot) -> Vec<String> {
    let svg = Document::parse(&plot.svg).expect("well-formed");
    let texts = svg.descendants().filter(|node| node.has_tag_name("text"));
    texts.filter_map(|node| node.text()).map(|text| text.trim().to_owned()).collect()
}

#[test]
fn every_kind_of_plot_is_made_and_is_the_same_again() {
    let results = crate::records::of_the_papers();
    let (plots, again) = (plots_of(&results), plots_of(&results));
    assert!(plots == again, "two renderings differ");
    let stems: Vec<&str> = plots.iter().map(|plot| plot.stem.as_str()).collect();
    let expected = [
        "figure_15",
        "figure_16",
        "figure_17",
        "figure_18",
        "stack_4_3",
        "stack_4_4_i",
        "stack_4_4_ii",
        "lrs_against_ps",
        "ratio_total_seconds",
        "ratio_unpaired_triangles",
        "ratio_link_condition_tests",
        "total_scans",
        "total_A",
        "total_B",
        "growth_tq_gw_ds",
    ];
    assert_eq!(stems, expected);
    for plot in &plots {
        assert!(plot.png.starts_with(b"\x89PNG") && plot.png.len() < 200_000, "{}", plot.stem);
        let svg = Document::parse(&plot.svg).expect("well-formed");
        assert!(svg.descendants().all(|node| !node.has_attribute("id")), "{}", plot.stem);
        assert!(texts(plot).contains(&plot.title));
        assert!(plot.csv.lines().count() > 5, "{}", plot.csv);
    }
}

#[test]
fn nothing_gives_no_plot() {
    assert_eq!(plots_of(&Results::default()), vec![]);
    let failed = plot("figure_16", |run| run.outcome = Outcome::Crash);
    assert!(failed.is_none(), "nothing ended well");
}

#[test]
fn an_exponent_that_is_in_the_records_is_written_beside_its_algorithm() {
    let quadratic = plot("figure_16", |run| {
        let n = run.measured.triangles.unwrap() as f64;
        run.measured.seconds =
            Some(1e-9 * n * if run.id.job.algorithm() == "rs" { 1.0 } else { n });
    })
    .unwrap();
    let texts = texts(&quadratic);
    assert_eq!(texts.iter().filter(|text| *text == "n^2.00 ± 0.00").count(), 2);
    assert_eq!(texts.iter().filter(|text| *text == "n^1.00 ± 0.00").count(), 1);
    assert!(["RS", "S", "BF", "seconds"].iter().all(|name| texts.contains(&(*name).to_owned())));
}

#[test]
fn stand_ins_extrapolations_and_company_are_told() {
    let said = |plot: &Plot, words: &str| texts(plot).iter().any(|text| text.contains(words));
    let hollow = |plot: &Plot| {
        plot.svg.matches("<polygon").count() > 0 && plot.svg.matches("fill=\"#FFFFFF\"").count() > 1
    };
    let plain = plot("total_scans", |_| {}).unwrap();
    assert!(!hollow(&plain) && !said(&plain, "stand-in") && !said(&plain, "*"));
    let other = plot("total_scans", |run| {
        run.mesh_kind = MeshKind::StandIn;
        run.parallel_jobs = 2;
        run.stopped_after_paths = (run.id.job.algorithm() == "sg").then_some(10);
    })
    .unwrap();
    assert!(hollow(&other) && said(&other, "stand-in") && said(&other, "side by side"));
    assert!(texts(&other).iter().filter(|text| *text == "*").count() == 6);
    assert!(other.csv.contains("stand-in") && other.csv.contains(",yes,"));
    assert!(other.csv != plain.csv);
}

#[test]
fn times_of_runs_in_company_are_not_divided() {
    let alone = plot("lrs_against_ps", |_| {}).unwrap();
    assert!(alone.csv.contains("\ntarjan,"));
    let in_company = plot("lrs_against_ps", |run| run.parallel_jobs = 2).unwrap();
    assert!(!in_company.csv.contains("\ntarjan,") && in_company.csv.contains("\nin the paper,"));
}

/// Each run of PS takes 1 s and has 4 paths of 1 s with `rebuild`, each of LRS 1 s and 2 of 3 s.
#[test]
fn lrs_is_set_against_ps_with_each_augmentation() {
    let mut results = crate::records::of_the_papers();
    let duels = ["ps", "lrs"];
    results.records.retain(|run| duels.contains(&run.id.job.algorithm()));
    for run in &mut results.records {
        run.measured.pairing_seconds = Some(1.0);
        run.measured.unpaired_triangles = Some(if is_lrs(run) { 4 } else { 8 });
    }
    let rebuilt = |run: &RunRecord| {
        let mut run = run.clone();
        run.id.job = run.id.job.with_augmentation(Augmentation::Rebuild);
        run.measured.augmenting_paths = Some(2);
        run.measured.augmentation_seconds = Some(if is_lrs(&run) { 6.0 } else { 2.0 });
        run
    };
    let rebuilt: Vec<RunRecord> = results.records.iter().map(rebuilt).collect();
    results.records.extend(rebuilt);
    let plot = plots::named(&Summary::new(&results), "lrs_against_ps").unwrap();
    assert!(plot.csv.contains("\nrebuild,A1,generated,,1.4,A1\n"), "{}", plot.csv);
    let names = ["rebuild", "tarjan", "in the paper"];
    assert!(names.iter().all(|name| texts(&plot).contains(&(*name).to_owned())));
    results.records.iter_mut().for_each(|run| run.parallel_jobs = 2);
    let plot = plots::named(&Summary::new(&results), "lrs_against_ps").unwrap();
    assert!(!plot.csv.contains("\nrebuild,"), "{}", plot.csv);
}

fn is_lrs(run: &RunRecord) -> bool {
    run.id.job.algorithm() == "lrs"
}

#[test]
fn runs_that_did_not_end_well_keep_their_bar() {
    use triquad_lab::experiment::Outcome;
    let stack = plot("stack_4_3", |run| {
        if run.id.job.algorithm() == "ds" {
            run.outcome = Outcome::Timeout;
        }
    })
    .unwrap();
    let timeouts = texts(&stack).iter().filter(|text| text.contains("timeout")).count();
    assert_eq!(timeouts, 6);
}

#[test]
fn a_smaller_scale_is_not_divided_by_the_papers_numbers() {
    assert!(plot("ratio_unpaired_triangles", |_| {}).is_some());
    assert_eq!(plot("ratio_unpaired_triangles", |run| run.id.mesh.scale = Scale::Demo), None);
}

/// Each point has the origin of its own mesh; a row is marked if a point in it is of a stand-in.
#[test]
fn imported_points_keep_the_kind_of_their_own_mesh() {
    let chart = |is_stand_in: &dyn Fn(&str) -> bool| {
        let chart = plot("ratio_total_seconds", |run| {
            let algorithm = run.id.job.algorithm();
            if run.id.mesh.experiment != "comparison" {
                return;
            }
            run.mesh_kind = MeshKind::StandIn;
            if !is_stand_in(algorithm) {
                (run.mesh_kind, run.machine) = (MeshKind::Real, format!("imported {algorithm}"));
            }
        });
        chart.unwrap()
    };
    let is_noted = |chart: &Plot| texts(chart).iter().any(|text| text.starts_with("hollow"));
    // Whichever stands first.
    for imported in ["sg", "ps"] {
        let chart = chart(&|algorithm| algorithm != imported);
        for (series, algorithm) in [("SG", "sg"), ("PS", "ps"), ("LRS", "lrs")] {
            let kind = if algorithm == imported { "file" } else { "stand-in" };
            let line = format!("\n{series},eros,{kind},");
            assert!(chart.csv.contains(&line), "{line}: {}", chart.csv);
        }
        assert!(texts(&chart).contains(&"eros†".to_owned()) && is_noted(&chart));
    }
    // Velho is not in the plot.
    let chart = chart(&|algorithm| algorithm == "velho");
    assert!(texts(&chart).contains(&"eros".to_owned()) && !is_noted(&chart));
}
