//! The verdict on every claim of the papers.
//!
//! A claim is tested on our records, and on the papers' own printed numbers beside it. What cannot be
//! judged is said to be not comparable, with the reason; nothing is left out.

mod bootstrap;
mod ours;
mod printed;

use printed::Printed;

use super::claims::{self, Claim, Kind, Need, Point, Predicate, Test};
use super::number::significant;
use super::summary::Summary;

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds of our records.
    Reproduced,
    /// It does not hold of our records.
    Differs,
    /// Our records cannot tell.
    NotComparable,
    /// The paper's own numbers contradict it.
    PaperInconsistent,
}

impl Verdict {
    /// All of them, in the order in which they are counted.
    pub const ALL: [Self; 4] =
        [Self::Reproduced, Self::Differs, Self::NotComparable, Self::PaperInconsistent];

    /// In words.
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
    pub kind: Kind,
    /// What became of it.
    pub verdict: Verdict,
    /// Our numbers.
    pub ours: String,
    /// The paper's.
    pub paper: String,
    /// Why the verdict is what it is.
    pub reason: String,
    /// The reason, and our number on every mesh.
    pub detail: String,
}

/// Every claim, judged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// In the order of the papers.
    pub verdicts: Vec<Judged>,
}

impl Comparison {
    /// Number of claims of that verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.verdicts.iter().filter(|judged| judged.verdict == verdict).count()
    }

    /// The verdicts as comma-separated values.
    pub fn csv(&self) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let header = ["id", "verdict", "kind", "statement", "source", "ours", "paper", "detail"];
        writer.write_record(header).expect("memory takes everything");
        for judged in &self.verdicts {
            let Judged { id, statement, source, kind, verdict, ours, paper, detail, .. } = judged;
            let row = [id, verdict.name(), kind.name(), statement, source, ours, paper, detail];
            writer.write_record(row).expect("memory takes everything");
        }
        let bytes = writer.into_inner().expect("memory takes everything");
        String::from_utf8(bytes).expect("made of strings")
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

/// What is known of a claim's number, mesh by mesh.
#[derive(Default)]
struct Evidence {
    points: Vec<Point>,
    /// Mesh, and why it has no point.
    missing: Vec<(String, String)>,
    /// Kinds of the meshes and the like, by mesh, as far as they matter to a reader.
    remarks: Vec<(String, String)>,
}

fn judge_one(claim: &Claim, printed: &[Point], summary: &Summary) -> Judged {
    let ours = ours::evidence(claim, summary);
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
        detail: detail(&reason, &ours, test.as_ref()),
        reason,
    }
}

/// Whether the claim holds of what the papers print; `None` where they print too little to tell.
pub fn holds_of_the_paper(claim: &Claim) -> Option<bool> {
    let printed = Printed::new().evidence(claim);
    let complete = printed.len() == claim.mesh_names().len();
    complete.then(|| claim.predicate.test(&printed, &printed).holds)
}

/// The verdict and its reason.
fn verdict(
    claim: &Claim,
    summary: &Summary,
    ours: &Evidence,
    test: Option<&Test>,
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

/// The verdict of a test that nothing stands in the way of.
fn judge_test(claim: &Claim, ours: &Evidence, test: &Test) -> (Verdict, String) {
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

/// What keeps a claim from being judged, whatever its numbers.
fn hindrance(claim: &Claim, summary: &Summary) -> Option<String> {
    let first = summary.of_group(&claim.experiment, None).next();
    let scale = first.map_or("full", |cell| cell.scale.as_str());
    if claim.kind == Kind::Seconds {
        Some("seconds of another machine and compiler; an estimate, not a test".into())
    } else if claim.is_about_times() && summary.is_parallel() {
        Some("the runs went on beside others on the same machine, so that times say little".into())
    } else if claim.needs.contains(&Need::PaperSize) && scale != "full" {
        Some(format!("depends on sizes, and the meshes of scale {scale} are smaller"))
    } else {
        None
    }
}

fn paper_text(claim: &Claim, printed: &[Point]) -> String {
    let found = (!printed.is_empty()).then(|| claim.predicate.test(printed, printed).found);
    match found {
        Some(found) if claim.paper.is_empty() => found,
        // The printed numbers are those of the text.
        Some(_) if matches!(&claim.predicate, Predicate::AsPrinted { numbers, .. } if !numbers.is_empty()) => {
            claim.paper.clone()
        }
        Some(found) => format!("{}; in its tables {found}", claim.paper),
        None => claim.paper.clone(),
    }
}

/// The reason, every mesh with its number, and the meshes without.
fn detail(reason: &str, ours: &Evidence, test: Option<&Test>) -> String {
    let broken = |mesh: &String| test.is_some_and(|test| test.broken_on.contains(mesh));
    let remark = |mesh: &String| {
        let found = ours.remarks.iter().find(|(name, _)| name == mesh);
        found.map_or(String::new(), |(_, remark)| format!(" ({remark})"))
    };
    let number = |point: &Point| {
        // Where every repetition gives the same, there is nothing to say.
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
    let mut parts = vec![reason.to_owned()];
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
