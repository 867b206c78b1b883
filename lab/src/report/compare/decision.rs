//! From a claim's numbers to its verdict.

use triquad::counted::counted;

use super::evidence::Evidence;
use crate::meshes::paper::Scale;
use crate::report::claims::{Cause, Claim, ClaimKind, Finding, MeshNumber, Need};
use crate::report::summary::Summary;

/// Verdict on a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// It holds of our records.
    Reproduced,
    /// It holds of our records, as it must, by a theorem or a definition.
    ByConstruction,
    /// Other runs of the same would decide otherwise too often.
    Undecided,
    /// It does not hold of our records.
    Differs,
    /// Our records do not bear on it.
    NotComparable,
    /// The paper's own numbers contradict it.
    PaperInconsistent,
}

impl Verdict {
    /// All of them, in the order in which they are counted.
    pub const ALL: [Self; 6] = [
        Self::Reproduced,
        Self::ByConstruction,
        Self::Undecided,
        Self::Differs,
        Self::NotComparable,
        Self::PaperInconsistent,
    ];

    /// Returns the verdict in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::ByConstruction => "by construction",
            Self::Undecided => "undecided",
            Self::Differs => "differs",
            Self::NotComparable => "not comparable",
            Self::PaperInconsistent => "paper inconsistent",
        }
    }
}

/// A verdict and its reason.
pub(super) struct Decision {
    pub verdict: Verdict,
    pub reason: String,
}

/// Share of resamples that may disagree with the verdict.
const MOST_DISAGREEING: f64 = 0.05;

/// Decides on a claim.
pub(super) fn decide(
    claim: &Claim,
    summary: &Summary,
    ours: &Evidence,
    printed: &[MeshNumber],
) -> Decision {
    let test = (!ours.points.is_empty()).then(|| claim.predicate.test(&ours.points, printed));
    let decision = |verdict, reason: String| Decision { verdict, reason };
    if let Some(reason) = &claim.inconsistent {
        let holds = match test {
            Some(test) if ours.missing.is_empty() && test.holds => "; of our records it holds",
            Some(_) if ours.missing.is_empty() => "; of our records it does not hold",
            _ => "",
        };
        return decision(Verdict::PaperInconsistent, format!("{reason}{holds}"));
    }
    if let Some(reason) = hindrance(claim, summary) {
        return decision(Verdict::NotComparable, reason);
    }
    match test {
        None => decision(Verdict::NotComparable, "no mesh can be judged".into()),
        Some(test) => decide_test(claim, ours, printed, &test),
    }
}

/// Decides on a test whose numbers can be judged.
fn decide_test(claim: &Claim, ours: &Evidence, printed: &[MeshNumber], test: &Finding) -> Decision {
    let is_whole = ours.missing.is_empty();
    let is_refuted = !test.broken_on.is_empty() || is_whole && !test.holds;
    let share = disagreement(claim, ours, printed, test.holds);
    let is_noise = share > MOST_DISAGREEING;
    let decision = |verdict, reason: String| Decision { verdict, reason };
    if !is_whole && (!is_refuted || is_noise) {
        let judged = ours.points.len();
        let all = counted(claim.mesh_names().len(), "mesh", "meshes");
        return decision(Verdict::NotComparable, format!("only {judged} of {all}"));
    }
    if is_noise {
        let word = if test.holds { "holds" } else { "does not hold" };
        let reason = format!("{word}, but {:.0} % of the resamples say otherwise", 100.0 * share);
        return decision(Verdict::Undecided, reason);
    }
    match &claim.by_construction {
        _ if is_refuted && test.broken_on.is_empty() => {
            decision(Verdict::Differs, "does not hold".into())
        }
        _ if is_refuted => {
            let meshes = test.broken_on.join(", ");
            decision(Verdict::Differs, format!("does not hold on {meshes}"))
        }
        Some(theorem) => decision(Verdict::ByConstruction, theorem.clone()),
        None => decision(Verdict::Reproduced, "holds".into()),
    }
}

/// Returns the share of resamples of the whole test that end otherwise than the means. Meshes are
/// resampled apart from each other. O(1000 tests).
pub(super) fn disagreement(
    claim: &Claim,
    ours: &Evidence,
    printed: &[MeshNumber],
    holds: bool,
) -> f64 {
    let resamples = ours.draws.iter().map(Vec::len).max().unwrap_or(0);
    if resamples == 0 || claim.predicate.is_not_tested() {
        return 0.0;
    }
    let mut points = ours.points.clone();
    let mut others = 0_usize;
    for resample in 0..resamples {
        for (point, draws) in points.iter_mut().zip(&ours.draws) {
            if let Some(&[value, along]) = draws.get(resample) {
                (point.value, point.along) = (value, along);
            }
        }
        others += usize::from(claim.predicate.test(&points, printed).holds != holds);
    }
    others as f64 / resamples as f64
}

/// Returns what a difference is due to, and what speaks for that. The causes that claims name are
/// of the papers' sizes.
pub(super) fn cause(
    claim: &Claim,
    summary: &Summary,
    ours: &Evidence,
    test: Option<&Finding>,
) -> (Cause, String) {
    if let Some(scale) = smaller_scale(claim, summary) {
        return (Cause::Scale, format!("the meshes of scale {} are smaller", scale.id()));
    }
    if let Some(cause) = claim.cause {
        return (cause, claim.evidence.clone());
    }
    let broken = test.map_or(&[][..], |test| &test.broken_on);
    let named: Vec<&String> = if broken.is_empty() {
        ours.points.iter().map(|point| &point.mesh).collect()
    } else {
        broken.iter().collect()
    };
    // Times have other reasons too.
    if !claim.is_about_times() && named.iter().all(|mesh| ours.stand_ins.contains(mesh)) {
        return (Cause::StandIn, "all meshes that break it are stand-ins".into());
    }
    (Cause::Unknown, String::new())
}

/// Returns what keeps a claim from being judged, whatever its numbers.
fn hindrance(claim: &Claim, summary: &Summary) -> Option<String> {
    if claim.kind == ClaimKind::Seconds {
        Some("seconds of another machine and compiler; an estimate, not a test".into())
    } else if claim.is_about_times() && summary.is_parallel() {
        Some("the runs went on beside others on the same machine, so that times say little".into())
    } else if claim.needs.contains(&Need::PaperSize) {
        let smaller = smaller_scale(claim, summary)?.id();
        Some(format!("depends on sizes, and the meshes of scale {smaller} are smaller"))
    } else {
        None
    }
}

/// Returns the scale of the records that a claim is judged on; `None` at the papers' sizes.
fn smaller_scale(claim: &Claim, summary: &Summary) -> Option<Scale> {
    let first = summary.of_paper(claim.experiment).next();
    first.filter(|cell| !cell.is_full_scale()).map(|cell| cell.id.mesh.scale)
}
