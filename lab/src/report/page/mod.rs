//! The report as one page of HTML: no script, nothing from elsewhere; plots and pictures are inside.
//!
//! What is said is decided here, how it looks in the templates and the style sheet beside this file.

mod better;
mod entries;
mod facts;
mod figure;
mod table;
mod verdicts;

use minijinja::Environment;
use minijinja::value::Serde;
use serde::Serialize;

use super::compare::Comparison;
use super::gallery::Shown;
use super::plots::Plot;
use super::summary::Summary;
use super::tables::ReportTable;
use crate::experiment::Results;

/// A picture with what it shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictured {
    /// What it shows.
    pub shown: Shown,
    /// The file.
    pub png: Vec<u8>,
}

/// Everything the page is made of.
#[derive(Clone, Copy, Debug)]
pub struct Parts<'a> {
    /// The records.
    pub results: &'a Results,
    /// The records in cells.
    pub summary: &'a Summary,
    /// Every table.
    pub tables: &'a [ReportTable],
    /// Every verdict.
    pub comparison: &'a Comparison,
    /// Every plot that could be made.
    pub plots: &'a [Plot],
    /// Every picture that is there.
    pub pictures: &'a [Pictured],
}

/// What the template is filled with.
#[derive(Serialize)]
struct Page<'a> {
    style: &'static str,
    records: usize,
    warnings: Vec<String>,
    verdicts: Vec<verdicts::Group<'a>>,
    better: better::Better<'a>,
    papers: Vec<entries::PaperPart<'a>>,
    other_plots: Vec<&'a Plot>,
    other_pictures: Vec<figure::Figure>,
    other_tables: Vec<table::View>,
    limits: Vec<String>,
    defects: Vec<String>,
    machines: Vec<facts::Machine<'a>>,
    commands: Vec<facts::Commands<'a>>,
}

/// Renders the page; what is missing is said to be missing. The same parts give the same bytes.
pub fn render(parts: &Parts) -> String {
    let papers = entries::papers(parts);
    let page = Page {
        style: include_str!("style.css"),
        records: parts.results.records.len(),
        warnings: facts::warnings(parts),
        verdicts: verdicts::groups(parts.comparison),
        better: better::of(parts),
        other_plots: entries::other_plots(parts),
        other_pictures: entries::other_pictures(parts),
        other_tables: entries::other_tables(parts),
        papers,
        limits: facts::limits(parts.summary),
        defects: facts::defects(parts),
        machines: facts::machines(parts.results),
        commands: facts::commands(parts.summary),
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
