//! The verdict on every claim of the papers.
//!
//! A claim is tested on our records, and on the papers' own printed numbers beside it. What cannot
//! be judged is not comparable, with the reason; nothing is left out.

mod bootstrap;
mod decision;
mod evidence;
mod lacks;
mod printed;
mod tolerances;

use evidence::Evidence;
use printed::Printed;

pub use decision::Verdict;
pub use lacks::Lacks;
pub use tolerances::{ToleranceRow, tolerances, tolerances_csv};

use decision::{Decision, decide};

use super::claims::{self, Cause, Claim, ClaimKind, Finding, LimitOrigin, MeshNumber};
use super::number::{seconds, significant};
use super::summary::Summary;
use crate::csv_text;

/// A claim with its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// Short name of the claim.
    pub id: String,
    /// The claim in words.
    pub statement: String,
    /// Where.
    pub source: String,
    /// Kind of number that it is about.
    pub kind: ClaimKind,
    /// The verdict.
    pub verdict: Verdict,
    /// Our numbers.
    pub ours: String,
    /// The paper's.
    pub paper: String,
    /// Reason of the verdict.
    pub reason: String,
    /// Cause of a difference, and what speaks for that; of claims that differ only.
    pub cause: Option<(Cause, String)>,
    /// Origin of the limits of the test.
    pub limit: LimitOrigin,
    /// Our number on every mesh, and the meshes without.
    pub by_mesh: String,
    /// What it takes to judge it and the records do not have.
    pub lacks: Lacks,
}

/// Every claim, judged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// In the order of the papers.
    pub verdicts: Vec<Judged>,
}

impl Comparison {
    /// Returns the claim that cannot be judged for want of the least, among those that the records
    /// have an algorithm of on a mesh of; `None` if there is none.
    pub fn nearest(&self) -> Option<&Judged> {
        let wanting = self
            .verdicts
            .iter()
            .filter(|judged| judged.verdict == Verdict::NotComparable && judged.lacks.is_near());
        wanting.min_by_key(|judged| judged.lacks.number())
    }

    /// Returns whether any claim is about these records.
    pub fn says_anything(&self) -> bool {
        let silent = [Verdict::NotComparable, Verdict::PaperInconsistent];
        self.verdicts.iter().any(|judged| !silent.contains(&judged.verdict))
    }

    /// Returns the number of claims of that verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.verdicts.iter().filter(|judged| judged.verdict == verdict).count()
    }

    /// Returns the verdicts as comma-separated values.
    pub fn csv(&self) -> String {
        let header = [
            "id",
            "verdict",
            "kind",
            "statement",
            "source",
            "ours",
            "paper",
            "detail",
            "cause",
            "evidence",
            "limit_from",
        ];
        let row = |judged: &Judged| {
            let Judged { id, statement, source, kind, verdict, ours, paper, limit, .. } = judged;
            let detail = judged.detail();
            let (cause, evidence) = match &judged.cause {
                Some((cause, evidence)) => (cause.name(), evidence.as_str()),
                None => ("", ""),
            };
            let row = [
                id,
                verdict.name(),
                kind.name(),
                statement,
                source,
                ours,
                paper,
                &detail,
                cause,
                evidence,
                limit.name(),
            ];
            row.map(str::to_owned).to_vec()
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

/// Judges every claim of `experiments/claims.toml`. O(claims · meshes · (cells + repetitions)), and
/// 1000 resamples.
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
    let Decision { verdict, reason } = decide(claim, summary, &ours, printed);
    let cause = (verdict == Verdict::Differs)
        .then(|| decision::cause(claim, summary, &ours, test.as_ref()));
    Judged {
        id: claim.id.clone(),
        statement: claim.statement.clone(),
        source: claim.source.clone(),
        kind: claim.kind,
        verdict,
        ours: test.as_ref().map(|test| test.found.clone()).unwrap_or_default(),
        paper: paper_text(claim, printed),
        // Where nothing can be compared, no mesh breaks anything.
        by_mesh: by_mesh(&ours, test.as_ref().filter(|_| verdict != Verdict::NotComparable)),
        reason,
        cause,
        limit: claim.limit,
        lacks: Lacks::new(claim, summary, &ours),
    }
}

/// Returns whether the claim holds of what the papers print; `None` where they print too little.
pub fn holds_of_the_paper(claim: &Claim) -> Option<bool> {
    let printed = Printed::new().evidence(claim);
    let complete = printed.len() == claim.mesh_names().len();
    complete.then(|| claim.predicate.test(&printed, &printed).holds)
}

fn paper_text(claim: &Claim, printed: &[MeshNumber]) -> String {
    if claim.kind == ClaimKind::Seconds {
        // Ours are scaled to them; they themselves are not.
        let of_mesh = |point: &MeshNumber| format!("{} {}", point.mesh, seconds(point.value));
        return printed.iter().map(of_mesh).collect::<Vec<_>>().join("; ");
    }
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
