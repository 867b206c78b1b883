//! A claim's number on every mesh, from what the papers print.

use crate::meshes::paper;
use crate::report::claims::{Claim, Expression, Factor, Point, Predicate};
use crate::report::paper::{LinkTestRow, PairingRow, RatioRow, Table};

/// The rows of the papers' tables.
pub struct Printed {
    pairings: Vec<PairingRow>,
    link_tests: Vec<LinkTestRow>,
    ratios: Vec<RatioRow>,
}

impl Printed {
    /// Reads them.
    pub fn new() -> Self {
        Self {
            pairings: Table::ALL.iter().flat_map(Table::pairing_rows).collect(),
            link_tests: Table::ALL.iter().flat_map(Table::link_test_rows).collect(),
            ratios: Table::ALL.iter().flat_map(Table::ratio_rows).collect(),
        }
    }

    /// The number of `claim` on those of its meshes for which the paper prints it. Sizes are the
    /// corrected ones of [`paper::ALL`].
    pub fn evidence(&self, claim: &Claim) -> Vec<Point> {
        claim.mesh_names().iter().filter_map(|mesh| self.point(claim, mesh)).collect()
    }

    fn point(&self, claim: &Claim, mesh: &str) -> Option<Point> {
        let size = paper::named(mesh)?;
        let in_text = match &claim.predicate {
            Predicate::AsPrinted { numbers, .. } => numbers.get(mesh).copied(),
            _ => None,
        };
        let along = claim.predicate.along();
        Some(Point {
            mesh: mesh.to_owned(),
            value: in_text.or_else(|| self.value(mesh, &claim.value))?,
            interval: None,
            along: along.map_or(Some(0.0), |along| self.value(mesh, along))?,
            triangles: size.triangles().into(),
            genus: size.genus.into(),
        })
    }

    fn value(&self, mesh: &str, expression: &Expression) -> Option<f64> {
        if let Some(ratio) = self.ratio_of_times(mesh, expression) {
            return Some(ratio);
        }
        let product =
            |product: f64, factor: &Factor| Some(factor.apply(product, self.number(mesh, factor)?));
        expression.factors.iter().try_fold(1.0, product)
    }

    fn number(&self, mesh: &str, factor: &Factor) -> Option<f64> {
        let name = factor.number.name;
        let Some(algorithm) = factor.algorithm.as_deref() else {
            let size = paper::named(mesh)?;
            return match name {
                "vertices" => Some(size.vertices.into()),
                "edges" => Some(size.edges().into()),
                "triangles" => Some(size.triangles().into()),
                "genus" => Some(size.genus.into()),
                _ => None,
            };
        };
        self.pairing(mesh, algorithm, name).or_else(|| self.link_tests(mesh, algorithm, name))
    }

    /// Tables 4.3 and 4.4.
    fn pairing(&self, mesh: &str, algorithm: &str, name: &str) -> Option<f64> {
        let PairingRow {
            pairing_seconds,
            paired_percent,
            unpaired_triangles,
            augmentation_seconds,
            total_seconds,
            ..
        } = self.pairings.iter().find(|row| row.mesh == mesh && row.algorithm == algorithm)?;
        match name {
            "pairing_seconds" => Some(*pairing_seconds),
            "paired_percent" => Some(*paired_percent),
            "unpaired_triangles" => Some(*unpaired_triangles),
            "augmentation_seconds" => Some(*augmentation_seconds),
            "total_seconds" => Some(*total_seconds),
            _ => None,
        }
    }

    /// Tables 6, 8 and 10; that RS tests no edge twice is not printed there.
    fn link_tests(&self, mesh: &str, algorithm: &str, name: &str) -> Option<f64> {
        let row = self.link_tests.iter().find(|row| row.mesh == mesh)?;
        match (algorithm, name) {
            ("rs", "link_condition_tests") => Some(row.rs_link_condition_tests),
            ("schipper", "link_condition_tests") => Some(row.schipper_link_condition_tests),
            ("brute-force", "link_condition_tests") => Some(row.brute_force_link_condition_tests),
            ("schipper", "edges_tested_more_than_once") => {
                Some(row.schipper_edges_tested_more_than_once)
            }
            ("brute-force", "edges_tested_more_than_once") => {
                Some(row.brute_force_edges_tested_more_than_once)
            }
            _ => None,
        }
    }

    /// Tables 7, 9 and 11, which print no times but their ratios.
    fn ratio_of_times(&self, mesh: &str, expression: &Expression) -> Option<f64> {
        let row = self.ratios.iter().find(|row| row.mesh == mesh)?;
        match expression.text() {
            "schipper.seconds / rs.seconds" => Some(row.schipper_to_rs_seconds),
            "brute-force.seconds / rs.seconds" => Some(row.brute_force_to_rs_seconds),
            "schipper.seconds / brute-force.seconds" => Some(row.schipper_to_brute_force_seconds),
            "brute-force.seconds / schipper.seconds" => {
                Some(1.0 / row.schipper_to_brute_force_seconds)
            }
            _ => None,
        }
    }
}
