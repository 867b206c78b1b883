//! Verdicts under other limits of their tests.

use super::decision::{Verdict, decide};
use super::evidence;
use super::printed::Printed;
use crate::csv_text;
use crate::report::claims::{self, Claim};
use crate::report::summary::Summary;

/// Factors of the limits: half as far away, as stated, twice as far, and between.
pub const SLACKS: [f64; 5] = [0.5, 0.75, 1.0, 1.5, 2.0];

/// A claim under five limits.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceRow {
    /// Short name of the claim.
    pub id: String,
    /// Its limits as stated.
    pub limits: String,
    /// Origin.
    pub origin: &'static str,
    /// The verdict with limits half, three quarters, once, one and a half times and twice as far
    /// away.
    pub verdicts: [Verdict; 5],
}

impl ToleranceRow {
    /// Returns whether the verdict depends on the limits.
    pub fn depends(&self) -> bool {
        self.verdicts.iter().any(|verdict| *verdict != self.verdicts[0])
    }
}

/// Judges every claim that has limits under five of them. O(5 · that of all verdicts).
pub fn tolerances(summary: &Summary) -> Vec<ToleranceRow> {
    let printed = Printed::new();
    let row = |claim: Claim| {
        claim.predicate.with_slack(1.0)?;
        let (ours, printed) = (evidence::evidence(&claim, summary), printed.evidence(&claim));
        let verdicts = SLACKS.map(|slack| {
            let predicate = claim.predicate.with_slack(slack).expect("it has limits");
            let moved = Claim { predicate, ..claim.clone() };
            decide(&moved, summary, &ours, &printed).verdict
        });
        let limits = claim.predicate.limits();
        Some(ToleranceRow { id: claim.id, limits, origin: claim.limit.name(), verdicts })
    };
    claims::all().into_iter().filter_map(row).collect()
}

/// Returns the rows as comma-separated values.
pub fn tolerances_csv(rows: &[ToleranceRow]) -> String {
    let header = [
        "id",
        "limits",
        "limit_from",
        "half",
        "three_quarters",
        "stated",
        "one_and_a_half",
        "twice",
        "depends",
    ];
    let row = |row: &ToleranceRow| {
        let mut fields = vec![row.id.clone(), row.limits.clone(), row.origin.to_owned()];
        fields.extend(row.verdicts.map(|verdict| verdict.name().to_owned()));
        fields.push(if row.depends() { "yes".into() } else { String::new() });
        fields
    };
    let header = header.map(str::to_owned).to_vec();
    csv_text::of_texts(std::iter::once(header).chain(rows.iter().map(row)))
}
