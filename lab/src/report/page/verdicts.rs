//! The claims, by their verdicts.

use serde::Serialize;

use crate::report::compare::{Comparison, Judged, Verdict};

/// The claims of one verdict.
#[derive(Serialize)]
pub struct VerdictGroup<'a> {
    name: &'static str,
    title: &'static str,
    class: String,
    mark: &'static str,
    meaning: &'static str,
    /// Whether its claims are unfolded: those that can be judged.
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
    detail: &'a str,
}

/// Returns the groups, in the order in which verdicts are counted.
pub fn groups(comparison: &Comparison) -> Vec<VerdictGroup<'_>> {
    Verdict::ALL.map(|verdict| group(comparison, verdict)).into()
}

fn group(comparison: &Comparison, verdict: Verdict) -> VerdictGroup<'_> {
    let (title, mark, meaning) = match verdict {
        Verdict::Reproduced => ("Reproduced", "✓", "The claim holds of our records."),
        Verdict::Differs => ("Differs", "✗", "The claim does not hold of our records."),
        Verdict::NotComparable => {
            ("Not comparable", "–", "Our records do not decide it; the reason is given.")
        }
        Verdict::PaperInconsistent => {
            ("Paper inconsistent", "!", "The paper's own numbers contradict the claim.")
        }
    };
    let own = comparison.verdicts.iter().filter(|judged| judged.verdict == verdict);
    let name = verdict.name();
    let class = name.replace(' ', "-");
    let open = [Verdict::Reproduced, Verdict::Differs].contains(&verdict);
    VerdictGroup {
        name,
        title,
        class,
        mark,
        meaning,
        open,
        claims: own.map(ClaimView::from).collect(),
    }
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
            detail: &judged.by_mesh,
        }
    }
}
