//! What one run does, as the arguments of the command that does it.

use triquad::augmentation::Augmentation;
use triquad::irreducible::{Contractor, Order};
use triquad::pairing::{Algorithm, Expansion};

/// What a run does to its mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Job {
    /// `triquad convert`.
    Convert {
        /// How triangles are paired at first.
        algorithm: Algorithm,
        /// How the pairing is made perfect.
        augmentation: Augmentation,
    },
    /// `triquad irreducible`.
    Reduce {
        /// How contractible edges are found.
        method: Contractor,
        /// The order of vertices.
        order: Order,
    },
}

impl Job {
    /// Name of the algorithm in records.
    pub fn algorithm(self) -> &'static str {
        match self {
            Self::Convert { algorithm, .. } => algorithm.id(),
            Self::Reduce { method, .. } => method.id(),
        }
    }

    /// For LRS: how it expands.
    pub fn lrs_variant(self) -> Option<&'static str> {
        match self {
            Self::Convert { algorithm: Algorithm::Lrs(expansion), .. } => Some(expansion.id()),
            _ => None,
        }
    }

    /// For conversions: how the pairing is made perfect.
    pub fn augmentation(self) -> Option<&'static str> {
        match self {
            Self::Convert { augmentation, .. } => Some(augmentation.id()),
            Self::Reduce { .. } => None,
        }
    }

    /// For irreducible triangulations: the order of vertices.
    pub fn order(self) -> Option<&'static str> {
        match self {
            Self::Convert { .. } => None,
            Self::Reduce { order, .. } => Some(order.id()),
        }
    }

    /// The verb on the command line.
    pub fn verb(self) -> &'static str {
        match self {
            Self::Convert { .. } => "convert",
            Self::Reduce { .. } => "irreducible",
        }
    }

    /// The options on the command line, those left out that would say the usual.
    pub fn options(self) -> Vec<&'static str> {
        let mut options = vec!["--algorithm", self.algorithm()];
        if let Some(variant) = self.lrs_variant().filter(|&v| v != Expansion::Printed.id()) {
            options.extend(["--lrs-variant", variant]);
        }
        if let Some(augmentation) = self.augmentation() {
            options.extend(["--augmentation", augmentation]);
        }
        if let Some(order) = self.order().filter(|&order| order != Order::File.id()) {
            options.extend(["--order", order]);
        }
        options
    }

    /// What tells this job from others on the same mesh, in words.
    pub fn label(self) -> String {
        let words = [Some(self.algorithm()), self.lrs_variant(), self.augmentation(), self.order()];
        words.into_iter().flatten().collect::<Vec<_>>().join(" ")
    }
}
