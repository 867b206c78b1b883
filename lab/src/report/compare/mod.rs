//! The verdict on every claim of the papers.
//!
//! A claim is tested on our records, and on the papers' own printed numbers beside it. What cannot
//! be judged is not comparable, with the reason; nothing is left out.

mod bootstrap;
mod evidence;
mod printed;

use evidence::Evidence;
use printed::Printed;

use super::claims::{self, Claim, ClaimKind, Finding, MeshNumber, Need};
use super::number::significant;
use super::summary::Summary;
use crate::csv_text;

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds of our records.
    Reproduced,
    /// It does not hold of our records.
    Differs,
    /// Our records do not decide it.
    NotComparable,
    /// The paper's own numbers contradict it.
    PaperInconsistent,
}

impl Verdict {
    /// All of them, in the order in which they are counted.
    pub const ALL: [Self; 4] =
        [Self::Reproduced, Self::Differs, Self::NotComparable, Self::PaperInconsistent];

    /// Returns the verdict in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::Differs => "differs",
            Self::NotComparable => "not comparable",
            Self::PaperInconsistent => "paper inconsistent",
        }
    }
}

/// A claim with its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// Short name of the claim.
    pub id: String,
    /// What is claimed.
    pub statement: String,
    /// Where.
    pub source: String,
    /// What kind of number it is about.
    pub kind: ClaimKind,
    /// What became of it.
    pub verdict: Verdict,
    /// Our numbers.
    pub ours: String,
    /// The paper's.
    pub paper: String,
    /// Why the verdict is what it is.
    pub reason: String,
    /// Our number on every mesh, and the meshes without.
    pub by_mesh: String,
}

/// Every claim, judged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// In the order of the papers.
    pub verdicts: Vec<Judged>,
}

impl Comparison {
    /// Returns the number of claims of that verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.verdicts.iter().filter(|judged| judged.verdict == verdict).count()
    }

    /// Returns the verdicts as comma-separated values.
    pub fn csv(&self) -> String {
        let header = ["id", "verdict", "kind", "statement", "source", "ours", "paper", "detail"];
        let row = |judged: &Judged| {
            let Judged { id, statement, source, kind, verdict, ours, paper, .. } = judged;
            let row = [id, verdict.name(), kind.name(), statement, source, ours, paper];
            row.map(str::to_owned).into_iter().chain([judged.detail()]).collect::<Vec<_>>()
        };
        let header = header.map(str::to_owned).to_vec();
        csv_text::of_texts(std::iter::once(header).chain(self.verdicts.iter().map(row)))
    }
}

impl Judged {
    /// Returns the reason, and our number on every mesh.
    pub fn detail(&self) -> String {
        let parts = [self.reason.as_str(), &self.by_mesh];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(". ")
    }
}

/// Judges every claim of `experiments/claims.toml`. O(claims · meshes · (cells + repetitions)).
pub fn judge(summary: &Summary) -> Comparison {
    judge_claims(&claims::all(), summary)
}

/// Judges `claims`.
pub fn judge_claims(claims: &[Claim], summary: &Summary) -> Comparison {
    let printed = Printed::new();
    let judge = |claim| judge_one(claim, &printed.evidence(claim), summary);
    Comparison { verdicts: claims.iter().map(judge).collect() }
}

fn judge_one(claim: &Claim, printed: &[MeshNumber], summary: &Summary) -> Judged {
    let ours = evidence::evidence(claim, summary);
    let test = (!ours.points.is_empty()).then(|| claim.predicate.test(&ours.points, printed));
    let (verdict, reason) = verdict(claim, summary, &ours, test.as_ref());
    Judged {
        id: claim.id.clone(),
        statement: claim.statement.clone(),
        source: claim.source.clone(),
        kind: claim.kind,
        verdict,
        ours: test.as_ref().map(|test| test.found.clone()).unwrap_or_default(),
        paper: paper_text(claim, printed),
        by_mesh: by_mesh(&ours, test.as_ref()),
        reason,
    }
}

/// Returns whether the claim holds of what the papers print; `None` where they print too little.
pub fn holds_of_the_paper(claim: &Claim) -> Option<bool> {
    let printed = Printed::new().evidence(claim);
    let complete = printed.len() == claim.mesh_names().len();
    complete.then(|| claim.predicate.test(&printed, &printed).holds)
}

/// Returns the verdict and its reason.
fn verdict(
    claim: &Claim,
    summary: &Summary,
    ours: &Evidence,
    test: Option<&Finding>,
) -> (Verdict, String) {
    if let Some(reason) = &claim.inconsistent {
        let holds = match test {
            Some(test) if ours.missing.is_empty() => {
                if test.holds {
                    "; of our records it holds"
                } else {
                    "; of our records it does not hold"
                }
            }
            _ => "",
        };
        return (Verdict::PaperInconsistent, format!("{reason}{holds}"));
    }
    if let Some(reason) = hindrance(claim, summary) {
        return (Verdict::NotComparable, reason);
    }
    match test {
        None => (Verdict::NotComparable, "no mesh can be judged".into()),
        Some(test) => judge_test(claim, ours, test),
    }
}

/// Returns the verdict of a test whose numbers can be judged.
fn judge_test(claim: &Claim, ours: &Evidence, test: &Finding) -> (Verdict, String) {
    let refuted: Vec<&str> = test
        .broken_on
        .iter()
        .filter(|mesh| !test.undecided_on.contains(mesh))
        .map(String::as_str)
        .collect();
    if !refuted.is_empty() {
        (Verdict::Differs, format!("does not hold on {}", refuted.join(", ")))
    } else if !ours.missing.is_empty() {
        let (judged, all) = (ours.points.len(), claim.mesh_names().len());
        (Verdict::NotComparable, format!("only {judged} of {all} meshes"))
    } else if test.holds {
        (Verdict::Reproduced, "holds".into())
    } else if test.undecided_on.is_empty() {
        (Verdict::Differs, "does not hold".into())
    } else {
        let undecided = test.undecided_on.join(", ");
        (Verdict::NotComparable, format!("undecided within the noise on {undecided}"))
    }
}

/// Returns what keeps a claim from being judged, whatever its numbers.
fn hindrance(claim: &Claim, summary: &Summary) -> Option<String> {
    let first = summary.of_paper(claim.experiment).next();
    if claim.kind == ClaimKind::Seconds {
        Some("seconds of another machine and compiler; an estimate, not a test".into())
    } else if claim.is_about_times() && summary.is_parallel() {
        Some("the runs went on beside others on the same machine, so that times say little".into())
    } else if claim.needs.contains(&Need::PaperSize) {
        let smaller = first.filter(|cell| !cell.is_full_scale())?.id.mesh.scale.id();
        Some(format!("depends on sizes, and the meshes of scale {smaller} are smaller"))
    } else {
        None
    }
}

fn paper_text(claim: &Claim, printed: &[MeshNumber]) -> String {
    let found = (!printed.is_empty()).then(|| claim.predicate.test(printed, printed).found);
    match found {
        Some(found) if claim.paper.is_empty() => found,
        // The printed numbers are those of the text.
        Some(_) if claim.predicate.has_numbers() => claim.paper.clone(),
        Some(found) => format!("{}; in its tables {found}", claim.paper),
        None => claim.paper.clone(),
    }
}

/// Returns every mesh with its number, and the meshes without.
fn by_mesh(ours: &Evidence, test: Option<&Finding>) -> String {
    let broken = |mesh: &String| test.is_some_and(|test| test.broken_on.contains(mesh));
    let remark = |mesh: &String| {
        let found = ours.remarks.iter().find(|(name, _)| name == mesh);
        found.map_or(String::new(), |(_, remark)| format!(" ({remark})"))
    };
    let number = |point: &MeshNumber| {
        // Equal repetitions have no interval.
        let interval = point.interval.filter(|(low, high)| low < high);
        let interval = interval.map_or(String::new(), |(low, high)| {
            format!(" [{}, {}]", significant(low), significant(high))
        });
        let mark = if broken(&point.mesh) { " ✗" } else { "" };
        format!(
            "{}{} {}{interval}{mark}",
            point.mesh,
            remark(&point.mesh),
            significant(point.value)
        )
    };
    let mut parts = Vec::new();
    parts.extend(
        (!ours.points.is_empty())
            .then(|| ours.points.iter().map(number).collect::<Vec<_>>().join("; ")),
    );
    parts.extend((!ours.missing.is_empty()).then(|| {
        let missing = ours.missing.iter().map(|(mesh, why)| format!("{mesh} ({why})"));
        format!("without: {}", missing.collect::<Vec<_>>().join(", "))
    }));
    parts.join(". ")
}
