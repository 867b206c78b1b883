//! The verdicts, by what they say.

use serde::Serialize;

use crate::report::compare::{Comparison, Judged, Verdict};

/// The claims of one verdict.
#[derive(Serialize)]
pub struct Group<'a> {
    name: &'static str,
    title: String,
    class: String,
    mark: &'static str,
    meaning: &'static str,
    /// Whether its claims are unfolded: those that can be judged.
    open: bool,
    claims: Vec<Claim<'a>>,
}

/// A claim.
#[derive(Serialize)]
struct Claim<'a> {
    id: &'a str,
    statement: &'a str,
    source: &'a str,
    kind: &'static str,
    ours: &'a str,
    paper: &'a str,
    why: &'a str,
    detail: &'a str,
}

/// The groups, in the order in which verdicts are counted.
pub fn groups(comparison: &Comparison) -> Vec<Group<'_>> {
    Verdict::ALL.map(|verdict| group(comparison, verdict)).into()
}

fn group(comparison: &Comparison, verdict: Verdict) -> Group<'_> {
    let (mark, meaning) = match verdict {
        Verdict::Reproduced => ("✓", "The claim holds of our records."),
        Verdict::Differs => ("✗", "The claim does not hold of our records."),
        Verdict::NotComparable => ("–", "Our records cannot tell; the reason is given."),
        Verdict::PaperInconsistent => ("!", "The paper's own numbers contradict the claim."),
    };
    let own = comparison.verdicts.iter().filter(|judged| judged.verdict == verdict);
    let name = verdict.name();
    let title = format!("{}{}", name[..1].to_uppercase(), &name[1..]);
    let class = name.replace(' ', "-");
    let open = [Verdict::Reproduced, Verdict::Differs].contains(&verdict);
    Group { name, title, class, mark, meaning, open, claims: own.map(claim).collect() }
}

fn claim(judged: &Judged) -> Claim<'_> {
    // The reason comes first, then the number on each mesh.
    let (why, detail) = judged.detail.split_once(". ").unwrap_or((&judged.detail, ""));
    Claim {
        id: &judged.id,
        statement: &judged.statement,
        source: &judged.source,
        kind: judged.kind.name(),
        ours: &judged.ours,
        paper: &judged.paper,
        why,
        detail,
    }
}
