//! The claims, by their verdicts; those that differ, by what that is due to.

use serde::Serialize;

use super::parts::Parts;
use crate::report::claims::Cause;
use crate::report::compare::{Judged, ToleranceRow, Verdict};

/// The claims of one verdict.
#[derive(Serialize)]
pub struct VerdictGroup<'a> {
    name: &'static str,
    title: &'static str,
    class: String,
    mark: &'static str,
    meaning: &'static str,
    count: usize,
    parts: Vec<VerdictPart<'a>>,
}

/// Claims of one verdict that belong together.
#[derive(Serialize)]
struct VerdictPart<'a> {
    /// Cause of a difference; empty where there is no difference.
    cause: String,
    /// True if its claims are unfolded: those that differ.
    open: bool,
    claims: Vec<ClaimView<'a>>,
}

/// A claim.
#[derive(Serialize)]
struct ClaimView<'a> {
    id: &'a str,
    statement: &'a str,
    source: &'a str,
    kind: &'static str,
    ours: &'a str,
    paper: &'a str,
    why: &'a str,
    evidence: &'a str,
    detail: &'a str,
}

/// A claim whose verdict depends on its limits.
#[derive(Serialize)]
pub struct ToleranceView<'a> {
    id: &'a str,
    limits: &'a str,
    origin: &'static str,
    verdicts: Vec<&'static str>,
}

/// Order of the page: what differs first.
const ORDER: [Verdict; 6] = [
    Verdict::Differs,
    Verdict::Undecided,
    Verdict::PaperInconsistent,
    Verdict::Reproduced,
    Verdict::ByConstruction,
    Verdict::NotComparable,
];

/// Returns the groups, those that need an explanation first.
pub fn groups<'a>(parts: &Parts<'a>) -> Vec<VerdictGroup<'a>> {
    ORDER.map(|verdict| group(parts, verdict)).into()
}

fn group<'a>(parts: &Parts<'a>, verdict: Verdict) -> VerdictGroup<'a> {
    let (title, mark, meaning) = words(verdict);
    let judged = &parts.comparison.verdicts;
    let own: Vec<&Judged> = judged.iter().filter(|judged| judged.verdict == verdict).collect();
    let name = verdict.name();
    VerdictGroup {
        name,
        title,
        class: name.replace(' ', "-"),
        mark,
        meaning,
        count: own.len(),
        parts: if verdict == Verdict::Differs { by_cause(&own) } else { vec![part(&own)] },
    }
}

fn words(verdict: Verdict) -> (&'static str, &'static str, &'static str) {
    match verdict {
        Verdict::Reproduced => ("Reproduced", "✓", "The claim holds of our records."),
        Verdict::ByConstruction => (
            "By construction",
            "≡",
            "The claim holds of our records, as a theorem or a definition says it must: it is no \
             evidence.",
        ),
        Verdict::Undecided => (
            "Undecided",
            "~",
            "Of 1000 resamples of the runs, more than 5 % decide otherwise than their means.",
        ),
        Verdict::Differs => ("Differs", "✗", "The claim does not hold of our records."),
        Verdict::NotComparable => {
            ("Not comparable", "–", "Our records do not bear on it; the reason is given.")
        }
        Verdict::PaperInconsistent => {
            ("Paper inconsistent", "!", "The paper's own numbers contradict the claim.")
        }
    }
}

fn by_cause<'a>(judged: &[&'a Judged]) -> Vec<VerdictPart<'a>> {
    let due_to = |cause: Cause| {
        let is_due = |judged: &&&Judged| judged.cause.as_ref().is_some_and(|due| due.0 == cause);
        let own: Vec<&Judged> = judged.iter().filter(is_due).copied().collect();
        let cause = format!("{} ({})", sentence(cause), own.len());
        VerdictPart { cause, open: true, ..part(&own) }
    };
    Cause::ALL.map(due_to).into_iter().filter(|part| !part.claims.is_empty()).collect()
}

/// Returns a cause in words.
fn sentence(cause: Cause) -> &'static str {
    match cause {
        Cause::Mesh => "Mesh: the box is not the papers'",
        Cause::Simplifier => "Simplifier: the papers' is not published",
        Cause::StandIn => "Stand-in: the scans were not at hand",
        Cause::Implementation => "Implementation: the claim is about theirs, ours is another",
        Cause::Machine => "Machine: the claim is about theirs",
        Cause::Scale => "Scale: the meshes are smaller than the papers'",
        Cause::Unknown => "Unknown: nobody has looked into it",
    }
}

fn part<'a>(judged: &[&'a Judged]) -> VerdictPart<'a> {
    let claims = judged.iter().map(|judged| ClaimView::from(*judged)).collect();
    VerdictPart { cause: String::new(), open: false, claims }
}

impl<'a> From<&'a Judged> for ClaimView<'a> {
    fn from(judged: &'a Judged) -> Self {
        Self {
            id: &judged.id,
            statement: &judged.statement,
            source: &judged.source,
            kind: judged.kind.name(),
            ours: &judged.ours,
            paper: &judged.paper,
            why: &judged.reason,
            evidence: judged.cause.as_ref().map_or("", |(_, evidence)| evidence),
            detail: &judged.by_mesh,
        }
    }
}

/// Returns the claims whose verdict depends on their limits.
pub fn tolerances<'a>(parts: &Parts<'a>) -> Vec<ToleranceView<'a>> {
    let view = |row: &'a ToleranceRow| ToleranceView {
        id: &row.id,
        limits: &row.limits,
        origin: row.origin,
        verdicts: row.verdicts.map(Verdict::name).into(),
    };
    parts.tolerances.iter().filter(|row| row.depends()).map(view).collect()
}
