//! Proofs that a pairing is the best.

use super::objective::{Leftover, Objective};
use crate::dual::{DualGraph, Matching};
use crate::matching::weighted::{Barrier, Certificate, CertificateError, Solution, verify};
use crate::triangulation::HalfEdgeId;

/// A proof that a matching is the best by an objective.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Proof {
    /// Criteria of the matching.
    pub objective: Objective,
    /// Dual values that no other matching can beat.
    pub certificate: Certificate,
    /// A set of triangles that shows on its own that no pairing leaves fewer, by the formula of
    /// Tutte and Berge; empty if nothing is left, none if triangles are left at a price.
    pub barrier: Option<Barrier>,
    /// Sum of the costs of the pairs, and of the prices of triangles left at a price of their own.
    pub cost: i128,
    /// Sides of edges that were to be kept and lie inside a quad; each that of the lower triangle.
    pub given_up: Vec<HalfEdgeId>,
}

impl Proof {
    /// Puts the parts of a proof about `matching` together. O(n).
    ///
    /// Nothing is proved before [`Proof::verify`].
    pub fn new(
        objective: Objective,
        certificate: Certificate,
        barrier: Option<Barrier>,
        dual: &DualGraph,
        matching: &Matching,
    ) -> Self {
        let given_up = given_up(&objective, dual, matching);
        let cost = objective.cost(dual, matching);
        Self { objective, certificate, barrier, cost, given_up }
    }

    /// Puts a solution in the words of the objective. O(n).
    pub(super) fn of_solution(
        objective: Objective,
        solution: Solution,
        dual: &DualGraph,
        matching: &Matching,
    ) -> Self {
        let barrier = match (objective.leftover(), objective.price()) {
            (Leftover::Fewest, Some(price)) => {
                // Potentials are in halves: triangles left have twice the price, those of the set
                // minus that, others about 0.
                Some(Barrier { nodes: solution.certificate.below(-price) })
            }
            _ => None,
        };
        let given_up = given_up(&objective, dual, matching);
        let left = matching.unpaired_count();
        let cost = objective.cost_of_solution(solution.cost, given_up.len(), left);
        debug_assert_eq!(cost, objective.cost(dual, matching));
        Self { objective, certificate: solution.certificate, barrier, cost, given_up }
    }

    /// Checks that the proof proves `matching` to be the best in `dual`. O(n).
    ///
    /// Shares no code with the solver.
    ///
    /// # Errors
    /// The first defect of matching, certificate or barrier.
    pub fn verify(&self, dual: &DualGraph, matching: &Matching) -> Result<(), ProofError> {
        let problem = self.objective.problem(dual);
        verify(&problem, matching, &self.certificate)?;
        let Some(barrier) = &self.barrier else { return Ok(()) };
        if barrier.nodes.iter().any(|&node| node as usize >= dual.len()) {
            return Err(ProofError::Barrier);
        }
        let proved = barrier.least_unpaired(&problem);
        if proved == matching.unpaired_count() { Ok(()) } else { Err(ProofError::Barrier) }
    }
}

/// A reason why a proof proves nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProofError {
    /// The dual values are not those of an optimum.
    #[error(transparent)]
    Certificate(#[from] CertificateError),
    /// The barrier does not show that so many triangles must be left.
    #[error("the barrier does not show that as many triangles as are left must be")]
    Barrier,
}

/// Returns the sides of edges to keep between two mates, those of the lower triangles.
fn given_up(objective: &Objective, dual: &DualGraph, matching: &Matching) -> Vec<HalfEdgeId> {
    let kept = objective.kept();
    match kept.is_empty() {
        true => Vec::new(),
        false => matching.sides(dual).filter(|&side| kept.contains(side)).collect(),
    }
}
