//! The tests that claims are put to: what must hold of a number on several meshes.

use std::collections::BTreeMap;

use serde::Deserialize;
use triquad::counted::counted;

use super::expression::Expression;
use crate::report::number::{seconds, significant};
use crate::report::power_law::PowerLaw;
use crate::report::statistics::Statistics;

/// A number on a mesh, with what some tests need beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshNumber {
    /// The mesh.
    pub mesh: String,
    /// The number.
    pub value: f64,
    /// 95 % of the bootstrap, where there were repetitions.
    pub interval: Option<(f64, f64)>,
    /// What it is drawn against, for tests that have such a thing; otherwise 0.
    pub along: f64,
    /// n_f of the mesh.
    pub triangles: f64,
    /// g of the mesh.
    pub genus: f64,
}

/// Direction in which a number goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Direction {
    /// It grows.
    Rises,
    /// It gets less.
    Falls,
}

/// The test.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(tag = "type", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Predicate {
    /// On every mesh: not below `low`, not above `high`.
    Range {
        /// Least value.
        low: Option<f64>,
        /// Greatest value.
        high: Option<f64>,
    },
    /// On every mesh: the printed number, within a factor of `tolerance` either way; 1 for
    /// equality.
    AsPrinted {
        /// At least 1.
        tolerance: f64,
        /// The printed numbers, where they are not in the paper's tables.
        #[serde(default)]
        numbers: BTreeMap<String, f64>,
    },
    /// On every mesh of genus 0 exactly `sphere`; on others at most `slope` g + `offset`.
    GenusBound {
        /// At genus 0.
        sphere: f64,
        /// For each handle.
        slope: f64,
        /// And once.
        offset: f64,
    },
    /// Below 1 on these meshes, not below 1 on the others.
    BelowOneOnlyOn {
        /// Some of the claim's meshes.
        winners: Vec<String>,
    },
    /// Rises or falls along a number: in at least `share` of the pairs of meshes that differ in it.
    Monotone {
        /// The horizontal axis.
        along: Expression,
        /// The direction.
        direction: Direction,
        /// 1 for all pairs.
        share: f64,
    },
    /// The exponent of a power of another number lies between `low` and `high`.
    Exponent {
        /// The base of the power.
        along: Expression,
        /// Least exponent.
        low: f64,
        /// Greatest exponent.
        high: f64,
    },
    /// Nowhere greater than on this mesh.
    LargestOn {
        /// One of the claim's meshes.
        mesh: String,
    },
    /// The greatest value is at most `factor` times the least.
    Constant {
        /// At least 1.
        factor: f64,
    },
    /// δt / (δf δg) is constant within `factor`, δ being the relative change from the mesh `base`.
    ProductLaw {
        /// The mesh that the others are compared with.
        base: String,
        /// At least 1.
        factor: f64,
    },
    /// Nothing is tested: seconds, scaled by the median of the paper's to our `along`, beside the
    /// printed ones.
    Scaled {
        /// The seconds that the scale is taken from.
        along: Expression,
    },
}

/// The outcome of a test.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// True if the points pass.
    pub holds: bool,
    /// The number that decided, or the range of the values, in words.
    pub found: String,
    /// Meshes on which it does not hold, where each is tested for itself.
    pub broken_on: Vec<String>,
}

impl Predicate {
    /// Returns the number that this one is drawn against.
    pub fn along(&self) -> Option<&Expression> {
        match self {
            Self::Monotone { along, .. }
            | Self::Exponent { along, .. }
            | Self::Scaled { along } => Some(along),
            _ => None,
        }
    }

    /// Returns the test with limits that are `slack` times as far away; `None` if it has no limit
    /// that could move.
    ///
    /// Factors f become 1 + (f - 1) `slack`, intervals grow about their middle, shares of pairs
    /// come closer to or go farther from all. A lone limit moves by a fifth of itself a unit of
    /// slack.
    pub fn with_slack(&self, slack: f64) -> Option<Self> {
        let wider = |factor: f64| 1.0 + (factor - 1.0) * slack;
        let about_middle = |low: f64, high: f64| {
            let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0 * slack);
            (middle - half, middle + half)
        };
        let lone = 0.2 * (slack - 1.0);
        let mut test = self.clone();
        match &mut test {
            Self::Range { low: Some(low), high: Some(high) } if *low < *high => {
                (*low, *high) = about_middle(*low, *high);
            }
            Self::Range { low: Some(low), high: None } => *low *= 1.0 - lone,
            Self::Range { low: None, high: Some(high) } => *high *= 1.0 + lone,
            Self::AsPrinted { tolerance: factor, .. } if *factor > 1.0 => *factor = wider(*factor),
            Self::Constant { factor } | Self::ProductLaw { factor, .. } => *factor = wider(*factor),
            Self::Exponent { low, high, .. } => (*low, *high) = about_middle(*low, *high),
            Self::Monotone { share, .. } if *share < 1.0 => {
                *share = (1.0 - (1.0 - *share) * slack).clamp(0.5, 1.0);
            }
            Self::Monotone { share, .. } => *share = (1.0 - lone.max(0.0)).max(0.5),
            _ => return None,
        }
        Some(test)
    }

    /// Returns the limits in words.
    pub fn limits(&self) -> String {
        let bound = |name: &str, bound: &Option<f64>| {
            bound.map(|bound| format!("{name} {}", significant(bound)))
        };
        match self {
            Self::Range { low, high } => {
                let bounds = [bound("at least", low), bound("at most", high)];
                bounds.into_iter().flatten().collect::<Vec<_>>().join(", ")
            }
            Self::AsPrinted { tolerance, .. } => format!("within a factor of {tolerance}"),
            Self::Constant { factor } | Self::ProductLaw { factor, .. } => {
                format!("constant within a factor of {factor}")
            }
            Self::Exponent { low, high, .. } => format!("exponent from {low} to {high}"),
            Self::Monotone { share, .. } => {
                format!("in {} % of the pairs", significant(100.0 * share))
            }
            _ => "none".into(),
        }
    }

    /// Returns whether it tests nothing.
    pub fn is_not_tested(&self) -> bool {
        matches!(self, Self::Scaled { .. })
    }

    /// Returns whether it has the printed numbers itself.
    pub fn has_numbers(&self) -> bool {
        matches!(self, Self::AsPrinted { numbers, .. } if !numbers.is_empty())
    }

    /// Tests `points`, of which there must be some; `printed` has the paper's own, as far as it
    /// prints them.
    pub fn test(&self, points: &[MeshNumber], printed: &[MeshNumber]) -> Finding {
        match self {
            Self::Monotone { direction, share, .. } => monotone(points, *direction, *share),
            Self::Exponent { low, high, .. } => exponent(points, *low, *high),
            Self::LargestOn { mesh } => largest_on(points, mesh),
            Self::Constant { factor } => constant(points, *factor),
            Self::ProductLaw { base, factor } => product_law(points, base, *factor),
            Self::Scaled { .. } => scaled(points, printed),
            _ => self.pointwise(points, printed),
        }
    }

    fn pointwise(&self, points: &[MeshNumber], printed: &[MeshNumber]) -> Finding {
        let holds_at = |point: &&MeshNumber| self.holds_at(point, printed);
        let broken = points.iter().filter(|point| !holds_at(point));
        let broken_on: Vec<String> = broken.map(|point| point.mesh.clone()).collect();
        Finding { holds: broken_on.is_empty(), found: range_of(points), broken_on }
    }

    fn holds_at(&self, point: &MeshNumber, printed: &[MeshNumber]) -> bool {
        let value = point.value;
        match self {
            Self::Range { low, high } => {
                low.is_none_or(|low| value >= low) && high.is_none_or(|high| value <= high)
            }
            Self::AsPrinted { tolerance, numbers } => {
                let in_table = printed.iter().find(|other| other.mesh == point.mesh);
                let number =
                    numbers.get(&point.mesh).copied().or(in_table.map(|other| other.value));
                // Twice rounded, equal numbers may differ in their last bit.
                number.is_some_and(|number| within(value, number, tolerance * (1.0 + 1e-12)))
            }
            Self::GenusBound { sphere, .. } if point.genus == 0.0 => value == *sphere,
            Self::GenusBound { slope, offset, .. } => value <= slope * point.genus + offset,
            Self::BelowOneOnlyOn { winners } => (value < 1.0) == winners.contains(&point.mesh),
            _ => unreachable!("the other tests are of several meshes at once"),
        }
    }
}

/// Returns whether `value` and `number` differ by a factor of at most `tolerance`.
fn within(value: f64, number: f64, tolerance: f64) -> bool {
    value <= number * tolerance && value * tolerance >= number
}

/// Returns the least and the greatest value in words.
fn range_of(points: &[MeshNumber]) -> String {
    let (low, high) = extremes(points);
    let meshes = counted(points.len(), "mesh", "meshes");
    if low == high {
        format!("{} on {meshes}", significant(low))
    } else {
        format!("{} to {} on {meshes}", significant(low), significant(high))
    }
}

fn extremes(points: &[MeshNumber]) -> (f64, f64) {
    let values = points.iter().map(|point| point.value);
    (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max))
}

fn whole(holds: bool, found: String) -> Finding {
    Finding { holds, found, broken_on: Vec::new() }
}

fn monotone(points: &[MeshNumber], direction: Direction, share: f64) -> Finding {
    let (mut pairs, mut agreeing) = (0_usize, 0_usize);
    for (i, one) in points.iter().enumerate() {
        for other in points[..i].iter().filter(|other| other.along != one.along) {
            let rises = (one.value - other.value) * (one.along - other.along);
            pairs += 1;
            agreeing += usize::from(match direction {
                Direction::Rises => rises > 0.0,
                Direction::Falls => rises < 0.0,
            });
        }
    }
    let holds = pairs > 0 && agreeing as f64 >= share * pairs as f64;
    let word = if direction == Direction::Rises { "rises" } else { "falls" };
    let pairs = counted(pairs, "pair", "pairs");
    whole(holds, format!("{word} in {agreeing} of {pairs} of meshes; {}", range_of(points)))
}

fn exponent(points: &[MeshNumber], low: f64, high: f64) -> Finding {
    let pairs: Vec<(f64, f64)> = points.iter().map(|point| (point.along, point.value)).collect();
    let Some(fit) = PowerLaw::through(&pairs) else {
        return whole(false, "no exponent: sizes or values do not differ".into());
    };
    let interval =
        fit.interval.map_or(String::new(), |(low, high)| format!(" [{low:.3}, {high:.3}]"));
    let meshes = counted(fit.n, "mesh", "meshes");
    let found = format!("exponent {:.3}{interval} on {meshes}", fit.exponent);
    whole((low..=high).contains(&fit.exponent), found)
}

fn largest_on(points: &[MeshNumber], mesh: &str) -> Finding {
    let mut sorted: Vec<&MeshNumber> = points.iter().collect();
    sorted.sort_by(|one, other| other.value.total_cmp(&one.value));
    let largest = sorted[0];
    let found = format!("largest on {}: {}", largest.mesh, significant(largest.value));
    whole(largest.mesh == mesh, found)
}

fn constant(points: &[MeshNumber], factor: f64) -> Finding {
    let (low, high) = extremes(points);
    whole(low > 0.0 && high <= low * factor, range_of(points))
}

fn product_law(points: &[MeshNumber], base: &str, factor: f64) -> Finding {
    let Some(base) = points.iter().find(|point| point.mesh == base) else {
        return whole(false, "the mesh to compare with is missing".into());
    };
    let change = |number: fn(&MeshNumber) -> f64, point: &MeshNumber| {
        (number(point) - number(base)) / number(base)
    };
    let law = |point: &MeshNumber| {
        let product = change(|p| p.triangles, point) * change(|p| p.genus, point);
        MeshNumber { value: change(|p| p.value, point) / product, ..point.clone() }
    };
    let others = points.iter().filter(|point| point.mesh != base.mesh);
    let laws: Vec<MeshNumber> = others.map(law).collect();
    if laws.is_empty() || laws.iter().any(|point| !point.value.is_finite()) {
        return whole(false, "sizes or genera do not differ".into());
    }
    let test = constant(&laws, factor);
    Finding { found: format!("δt/(δf δg): {}", test.found), ..test }
}

fn scaled(points: &[MeshNumber], printed: &[MeshNumber]) -> Finding {
    let both: Vec<(&MeshNumber, &MeshNumber)> = points
        .iter()
        .filter_map(|ours| Some((ours, printed.iter().find(|paper| paper.mesh == ours.mesh)?)))
        .collect();
    let factors: Vec<f64> = both.iter().map(|(ours, paper)| paper.along / ours.along).collect();
    let Some(Statistics { median: factor, .. }) = Statistics::from_values(&factors) else {
        return whole(false, "no printed seconds".into());
    };
    let estimates = both.iter().map(|(ours, paper)| {
        let estimate = seconds(ours.value * factor);
        format!("{} {estimate} (printed {})", ours.mesh, seconds(paper.value))
    });
    let estimates: Vec<String> = estimates.collect();
    whole(true, format!("estimates, ours × {}: {}", significant(factor), estimates.join("; ")))
}
