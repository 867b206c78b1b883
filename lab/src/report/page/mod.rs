//! The report as one page of HTML: no script, nothing from elsewhere; plots and pictures are
//! inside.
//!
//! The content is decided here, its look in the templates and the style sheet beside this file.

mod definitions;
mod findings;
mod limits;
mod lrs_against_ps;
mod paper_sections;
mod parts;
mod picture;
mod provenance;
mod table;
mod verdicts;

use minijinja::Environment;
use minijinja::value::Serde;
use serde::Serialize;

pub use parts::{Parts, PictureFile};

use super::plots::Plot;

/// Content of the template.
#[derive(Serialize)]
struct Page<'a> {
    style: &'static str,
    records: usize,
    warnings: Vec<String>,
    findings: Vec<findings::Finding>,
    definitions: Vec<definitions::Definition>,
    verdicts: Vec<verdicts::VerdictGroup<'a>>,
    tolerances: Vec<verdicts::ToleranceView<'a>>,
    tested: usize,
    lrs_against_ps: lrs_against_ps::LrsAgainstPs<'a>,
    papers: Vec<paper_sections::PaperSection<'a>>,
    other_plots: Vec<&'a Plot>,
    other_pictures: Vec<picture::PictureView>,
    other_tables: Vec<table::TableView>,
    limits: Vec<String>,
    defects: Vec<String>,
    machines: Vec<provenance::MachineView<'a>>,
    commands: Vec<provenance::GroupCommands<'a>>,
}

/// Renders the page; what is missing is named. The same parts give the same bytes.
pub fn render(parts: &Parts) -> String {
    let mut defects: Vec<String> = parts.defects.iter().map(ToString::to_string).collect();
    if parts.pictures.is_empty() {
        defects.push("pictures/: no picture is there".into());
    }
    let lrs_against_ps = lrs_against_ps::section(parts);
    let page = Page {
        style: include_str!("style.css"),
        records: parts.results.records.len(),
        warnings: limits::warnings(parts, &defects),
        findings: findings::findings(parts, &lrs_against_ps),
        definitions: definitions::definitions(parts.summary),
        verdicts: verdicts::groups(parts),
        tolerances: verdicts::tolerances(parts),
        tested: parts.tolerances.len(),
        lrs_against_ps,
        papers: paper_sections::papers(parts),
        other_plots: paper_sections::other_plots(parts),
        other_pictures: paper_sections::other_pictures(parts),
        other_tables: paper_sections::other_tables(parts),
        limits: limits::limits(parts.summary),
        defects,
        machines: provenance::machines(parts.results),
        commands: provenance::commands(parts.summary),
    };
    let templates = environment();
    let template = templates.get_template("page.html").expect("it was added");
    template.render(Serde(page)).expect("the template fits what it is filled with")
}

fn environment() -> Environment<'static> {
    let mut templates = Environment::new();
    let parts = [
        ("page.html", include_str!("page.html")),
        ("table.html", include_str!("table.html")),
        ("plot.html", include_str!("plot.html")),
        ("picture.html", include_str!("picture.html")),
    ];
    for (name, text) in parts {
        templates.add_template(name, text).expect("the templates are well formed");
    }
    templates
}
