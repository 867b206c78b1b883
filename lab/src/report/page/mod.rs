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
mod topic;
mod verdicts;

use minijinja::Environment;
use minijinja::value::Serde;
use serde::Serialize;
use triquad::counted::counted;

pub use parts::{Parts, PictureFile};

use topic::Topic;

use super::plots::Plot;

/// Content of the template.
#[derive(Serialize)]
struct Page<'a> {
    style: &'static str,
    title: String,
    is_own: bool,
    /// Templates of the sections before the limits, in order.
    sections: Vec<&'static str>,
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
    /// True if the page has a place for pictures and none is drawn.
    lacks_pictures: bool,
    machines: Vec<provenance::MachineView<'a>>,
    commands: Vec<provenance::GroupCommands<'a>>,
}

/// Renders the page; what is missing is named. The same parts give the same bytes.
pub fn render(parts: &Parts) -> String {
    let topic = Topic::of(parts.summary);
    let is_own = topic.is_own();
    let defects: Vec<String> = parts.defects.iter().map(ToString::to_string).collect();
    let lrs_against_ps = lrs_against_ps::section(parts);
    let mut page = Page {
        style: include_str!("style.css"),
        title: topic.title(),
        is_own,
        sections: Vec::new(),
        records: parts.results.records.len(),
        warnings: limits::warnings(parts, &defects),
        findings: match topic {
            Topic::Papers => findings::findings(parts, &lrs_against_ps),
            Topic::Own(_) => Vec::new(),
        },
        definitions: definitions::definitions(parts.summary, &topic),
        verdicts: verdicts::groups(parts),
        tolerances: verdicts::tolerances(parts),
        tested: parts.tolerances.len(),
        lrs_against_ps,
        papers: paper_sections::papers(parts, &topic),
        other_plots: paper_sections::other_plots(parts),
        other_pictures: paper_sections::other_pictures(parts, &topic),
        other_tables: match topic {
            Topic::Papers => paper_sections::other_tables(parts),
            Topic::Own(_) => paper_sections::own_tables(parts),
        },
        limits: limits::limits(parts.summary, &topic),
        defects,
        // Only the papers' experiments have pictures.
        lacks_pictures: parts.pictures.is_empty() && !is_own,
        machines: provenance::machines(parts.results),
        commands: provenance::commands(parts.summary),
    };
    page.sections = page.sections_in_order(parts);
    let templates = environment();
    let template = templates.get_template("page.html").expect("it was added");
    template.render(Serde(page)).expect("the template fits what it is filled with")
}

impl Page<'_> {
    /// Returns the templates of the sections before the limits. Own results come before what the
    /// papers have of the same, and sections without content are left out there.
    fn sections_in_order(&self, parts: &Parts) -> Vec<&'static str> {
        if !self.is_own {
            return vec![
                "definitions",
                "verdicts",
                "better_augmentation",
                "papers",
                "other_plots",
                "other_tables",
                "references",
            ];
        }
        let has_papers = !self.papers.is_empty();
        let sections = [
            ("other_tables", !self.other_tables.is_empty()),
            ("other_plots", !(self.other_plots.is_empty() && self.other_pictures.is_empty())),
            ("papers", has_papers),
            ("better_augmentation", self.lrs_against_ps.is_answered()),
            ("verdicts", parts.comparison.says_anything()),
            ("definitions", true),
            ("references", has_papers),
        ];
        sections.into_iter().filter(|section| section.1).map(|section| section.0).collect()
    }
}

fn environment() -> Environment<'static> {
    let mut templates = Environment::new();
    templates
        .add_filter("counted", |count: usize, one: String, many: String| counted(count, one, many));
    let parts = [
        ("page.html", include_str!("page.html")),
        ("table.html", include_str!("table.html")),
        ("plot.html", include_str!("plot.html")),
        ("picture.html", include_str!("picture.html")),
        ("sections/definitions.html", include_str!("sections/definitions.html")),
        ("sections/verdicts.html", include_str!("sections/verdicts.html")),
        ("sections/better_augmentation.html", include_str!("sections/better_augmentation.html")),
        ("sections/papers.html", include_str!("sections/papers.html")),
        ("sections/other_plots.html", include_str!("sections/other_plots.html")),
        ("sections/other_tables.html", include_str!("sections/other_tables.html")),
        ("sections/references.html", include_str!("sections/references.html")),
    ];
    for (name, text) in parts {
        templates.add_template(name, text).expect("the templates are well formed");
    }
    templates
}
