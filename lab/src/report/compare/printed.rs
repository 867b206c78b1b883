//! A claim's number on every mesh, from what the papers print.

use std::collections::{BTreeMap, HashMap};

use crate::meshes::paper;
use crate::paper::{Table, TableKind};
use crate::report::claims::{Claim, Expression, Factor, MeshNumber, Predicate};

/// The numbers of the papers' tables, by mesh and by what is measured, as in their columns:
/// `ps_total_seconds`, `rs_link_condition_tests`, `schipper_to_rs_seconds`.
pub struct Printed(HashMap<(String, String), f64>);

impl Printed {
    /// Reads the tables.
    pub fn new() -> Self {
        let mut numbers = HashMap::new();
        for table in Table::ALL.iter().filter(|table| table.kind != TableKind::Meshes) {
            for row in csv::Reader::from_reader(table.text.as_bytes()).into_deserialize() {
                let row: BTreeMap<String, String> =
                    row.expect("a table has as many fields as names");
                // Tables of pairings have a row for each algorithm, the others columns for each.
                let of = row.get("algorithm").map_or(String::new(), |name| format!("{name}_"));
                let numbers_of_row = row.iter().filter_map(|(column, field)| {
                    let quantity = format!("{of}{column}");
                    Some(((row["mesh"].clone(), quantity), field.parse().ok()?))
                });
                numbers.extend(numbers_of_row);
            }
        }
        Self(numbers)
    }

    fn get(&self, mesh: &str, quantity: &str) -> Option<f64> {
        self.0.get(&(mesh.to_owned(), quantity.replace('-', "_"))).copied()
    }

    /// Returns the number of `claim` on those of its meshes for which the paper prints it. Sizes
    /// are the corrected ones of [`paper::ALL`].
    pub fn evidence(&self, claim: &Claim) -> Vec<MeshNumber> {
        claim.mesh_names().iter().filter_map(|mesh| self.point(claim, mesh)).collect()
    }

    fn point(&self, claim: &Claim, mesh: &str) -> Option<MeshNumber> {
        let size = paper::named(mesh)?;
        let in_text = match &claim.predicate {
            Predicate::AsPrinted { numbers, .. } => numbers.get(mesh).copied(),
            _ => None,
        };
        let along = claim.predicate.along();
        Some(MeshNumber {
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
        let Some(job) = factor.job else {
            let size = paper::named(mesh)?;
            return match name {
                "vertices" => Some(size.vertices.into()),
                "edges" => Some(size.edges().into()),
                "triangles" => Some(size.triangles().into()),
                "genus" => Some(size.genus.into()),
                _ => None,
            };
        };
        self.get(mesh, &format!("{}_{name}", job.algorithm()))
    }

    /// Returns the ratio of times of Tables 7, 9 and 11, which print no times.
    fn ratio_of_times(&self, mesh: &str, expression: &Expression) -> Option<f64> {
        let [top, bottom] = &expression.factors[..] else { return None };
        let is_time = |factor: &Factor| factor.number.name == "seconds";
        if !bottom.divides || !is_time(top) || !is_time(bottom) {
            return None;
        }
        let [top, bottom] = [top.job?, bottom.job?].map(|job| job.algorithm());
        let ratio = |top, bottom| self.get(mesh, &format!("{top}_to_{bottom}_seconds"));
        ratio(top, bottom).or_else(|| ratio(bottom, top).map(|inverse| 1.0 / inverse))
    }
}
