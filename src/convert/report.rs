//! Everything that is counted and timed of one conversion.

use std::fmt;

use crate::augmentation::{Augmentation, AugmentationStats};
use crate::counted::counted;
use crate::irreducible::Discipline;
use crate::pairing::{Algorithm, LRS_ORDER};
use crate::quadrangulation::SharpEdges;
use crate::quadrangulation::quality::Quality;
use crate::triangulation::{Survey, Triangulation};

/// Counts, quality and times of a conversion. Times are in seconds.
///
/// Columns (a) to (e) are those of Lemos et al., Tables 4.3 and 4.4.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// Algorithm of the initial pairing.
    pub algorithm: Algorithm,
    /// Order in which `lrs` tests the edges at a vertex; the others have no use for it.
    pub lrs_order: Discipline,
    /// Kind of augmentation.
    pub augmentation: Augmentation,
    /// Master seed of the random choices.
    pub seed: u64,
    /// Referenced vertices n_v.
    pub vertices: usize,
    /// Vertices of the mesh in no face; 0 without a mesh.
    pub unreferenced_vertices: usize,
    /// Edges n_e of the triangulation.
    pub edges: usize,
    /// Triangles n_f.
    pub triangles: usize,
    /// Genus, summed over the two-sided components; holes count as filled.
    pub genus: usize,
    /// Connected components.
    pub components: usize,
    /// Boundary loops, if the surface was open or one-sided.
    pub boundary_loops: Option<usize>,
    /// Cross-caps of the one-sided components, if there are any.
    pub non_orientable_genus: Option<usize>,
    /// Quads; 0 if the conversion was stopped.
    pub quads: usize,
    /// Triangles left over, if some might have been.
    pub leftover_triangles: Option<usize>,
    /// Vertices of degree 2, where two quads share two edges; known from the check.
    pub degree_two_vertices: usize,
    /// Triangles k that the initial pairing left unpaired: column (c).
    pub unpaired_triangles: usize,
    /// Edges of the triangulation whose triangles were paired that the input does not have.
    pub edge_flips: usize,
    /// Counts of the augmentation.
    pub paths: AugmentationStats,
    /// True if [`Progress`](super::Progress) stopped the augmentation.
    pub stopped: bool,
    /// Total cost of the pairing, if `best` was given coordinates.
    pub total_cost: Option<i128>,
    /// True if a certificate was verified that no pairing with these aims costs less.
    pub is_proved_least: bool,
    /// True if a barrier was verified that shows that no pairing leaves fewer triangles.
    pub is_proved_fewest: bool,
    /// Edges to keep, if any were requested.
    pub kept_edges: Option<usize>,
    /// Those of them that were given up, as few as can be.
    pub given_up_edges: Option<usize>,
    /// Shape of the quads; none without a check.
    pub quality: Option<Quality>,
    /// Sharp edges and those kept; none without a check.
    pub sharp_edges: Option<SharpEdges>,
    /// Adjacency and validation, with the flips of `orient`.
    pub build_seconds: f64,
    /// The part of column (a) in which costs of edges are computed; 0 but for `best`.
    pub cost_seconds: f64,
    /// Column (a): from the triangulation to the initial pairing, its dual graph included.
    pub pairing_seconds: f64,
    /// The part of column (a) in which edges or triangles are shuffled; 0 but for `sg` and `ps`.
    pub shuffle_seconds: f64,
    /// Column (d): from the initial pairing to the perfect one.
    pub augmentation_seconds: f64,
    /// The check of the result, from the two meshes alone.
    pub check_seconds: f64,
}

/// Counts of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Size {
    /// Referenced vertices n_v.
    pub vertices: usize,
    /// Edges n_e.
    pub edges: usize,
    /// Triangles n_f.
    pub triangles: usize,
    /// Genus, summed over the two-sided components.
    pub genus: usize,
    /// Connected components.
    pub components: usize,
}

impl From<&Triangulation> for Size {
    fn from(triangulation: &Triangulation) -> Self {
        Self {
            vertices: triangulation.vertex_count(),
            edges: triangulation.edge_count(),
            triangles: triangulation.triangle_count(),
            genus: triangulation.genus(),
            components: triangulation.component_count(),
        }
    }
}

impl From<&Survey> for Size {
    fn from(survey: &Survey) -> Self {
        Self {
            vertices: survey.vertices,
            edges: survey.edges,
            triangles: survey.triangles,
            genus: survey.handles.unwrap_or(0),
            components: survey.components,
        }
    }
}

impl Report {
    /// Makes a report of a conversion that has not begun.
    pub(super) fn new(
        algorithm: Algorithm,
        augmentation: Augmentation,
        seed: u64,
        size: Size,
    ) -> Self {
        Self {
            algorithm,
            lrs_order: LRS_ORDER,
            augmentation,
            seed,
            vertices: size.vertices,
            unreferenced_vertices: 0,
            edges: size.edges,
            triangles: size.triangles,
            genus: size.genus,
            components: size.components,
            boundary_loops: None,
            non_orientable_genus: None,
            quads: 0,
            leftover_triangles: None,
            degree_two_vertices: 0,
            unpaired_triangles: 0,
            edge_flips: 0,
            paths: AugmentationStats::default(),
            stopped: false,
            total_cost: None,
            is_proved_least: false,
            is_proved_fewest: false,
            kept_edges: None,
            given_up_edges: None,
            quality: None,
            sharp_edges: None,
            build_seconds: 0.0,
            cost_seconds: 0.0,
            pairing_seconds: 0.0,
            shuffle_seconds: 0.0,
            augmentation_seconds: 0.0,
            check_seconds: 0.0,
        }
    }

    /// Returns column (b): the share of triangles that the initial pairing paired, in percent.
    pub fn paired_percent(&self) -> f64 {
        100.0 * (self.triangles - self.unpaired_triangles) as f64 / self.triangles as f64
    }

    /// Returns column (e): (a) + (d).
    pub fn total_seconds(&self) -> f64 {
        self.pairing_seconds + self.augmentation_seconds
    }

    /// Writes how the pairing came about.
    fn fmt_pairing(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(cost) = self.total_cost {
            let proof = if self.is_proved_least { ", proved least" } else { "" };
            write!(f, "{}: total cost {cost}{proof}", self.algorithm)?;
            return self.fmt_given_up(f);
        }
        write!(
            f,
            "{} left {} unpaired ({:.3} %)",
            self.algorithm,
            self.unpaired_triangles,
            100.0 - self.paired_percent(),
        )?;
        // Nothing was left to be completed, or nothing of that could be.
        if self.unpaired_triangles == 0 || self.paths.paths == 0 {
            return Ok(());
        }
        write!(f, ", completed by {}", self.augmentation)
    }

    /// Writes how many edges to keep were given up, if there were any.
    fn fmt_given_up(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.kept_edges, self.given_up_edges) {
            (Some(0), _) => write!(f, "; there is no edge to keep"),
            (Some(all), Some(0)) => write!(f, "; none of {} to keep given up", edges(all)),
            (Some(all), Some(lost)) => {
                write!(f, "; {lost} of {} to keep given up, proved fewest", edges(all))
            }
            _ => Ok(()),
        }
    }

    /// Writes the topology: genus, cross-caps and holes. One-sided surfaces have no genus.
    fn fmt_topology(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.genus, self.non_orientable_genus) {
            (genus, None) => write!(f, "(genus {genus}")?,
            (0, Some(cross_caps)) => write!(f, "(non-orientable genus {cross_caps}")?,
            (genus, Some(cross_caps)) => {
                write!(f, "(genus {genus}, non-orientable genus {cross_caps}")?;
            }
        }
        match self.boundary_loops {
            None => write!(f, ")"),
            Some(loops) => {
                write!(f, ", {})", counted(loops, "boundary loop", "boundary loops"))
            }
        }
    }

    /// Writes how many triangles are left, if some might have been.
    fn fmt_left(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(left) = self.leftover_triangles else { return Ok(()) };
        let left = triangles(left);
        let proof = if self.is_proved_fewest { " (proved fewest)" } else { "" };
        write!(f, " and {left} left over{proof}")
    }

    /// Writes the shape of the quads, if it was measured.
    fn fmt_shape(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Some(quality), Some(sharp)) = (&self.quality, &self.sharp_edges) else {
            return Ok(());
        };
        if self.quads > 0 {
            let [mean, worst] = [quality.mean, quality.minimum].map(three_digits);
            let folded = quality.folded;
            write!(f, "; quality {mean} in the mean, {worst} at worst, {folded} folded")?;
        }
        if sharp.all > 0 {
            write!(f, "; {} of {} over 30 degrees kept", sharp.kept, edges(sharp.all))?;
        }
        match self.degree_two_vertices {
            0 => Ok(()),
            count => write!(f, "; {} of degree 2", vertices(count)),
        }
    }

    /// Writes the outcome of a conversion that was stopped.
    fn fmt_stopped(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} (genus {}), no quads; {} left {} unpaired ({:.3} %), stopped after {} of {} by {}; \
             paired in {}, augmented for {}",
            triangles(self.triangles),
            self.genus,
            self.algorithm,
            self.unpaired_triangles,
            100.0 - self.paired_percent(),
            self.paths.paths,
            counted(self.unpaired_triangles / 2, "augmenting path", "augmenting paths"),
            self.augmentation,
            duration(self.pairing_seconds),
            duration(self.augmentation_seconds),
        )
    }
}

impl fmt::Display for Report {
    /// Writes the summary as one line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.stopped {
            return self.fmt_stopped(f);
        }
        write!(f, "{} ", triangles(self.triangles))?;
        self.fmt_topology(f)?;
        write!(f, " -> {}", counted(self.quads, "quad", "quads"))?;
        self.fmt_left(f)?;
        write!(f, " on the same {}", vertices(self.vertices))?;
        match self.unreferenced_vertices {
            0 => write!(f, "; ")?,
            more => write!(f, " ({more} more in no face); ")?,
        }
        self.fmt_pairing(f)?;
        self.fmt_shape(f)?;
        write!(f, "; paired in {}", duration(self.total_seconds()))
    }
}

fn triangles(count: usize) -> String {
    counted(count, "triangle", "triangles")
}

fn edges(count: usize) -> String {
    counted(count, "edge", "edges")
}

fn vertices(count: usize) -> String {
    counted(count, "vertex", "vertices")
}

/// Writes a number with three digits behind the point, zero without a sign.
fn three_digits(value: f64) -> String {
    let text = format!("{value:.3}");
    if text == "-0.000" { "0.000".into() } else { text }
}

/// Writes seconds; short ones with more digits, so that they are not 0.
fn duration(seconds: f64) -> String {
    if seconds < 0.01 { format!("{seconds:.6} s") } else { format!("{seconds:.3} s") }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Report {
    /// Writes one map with the names of `--stats` and of the records, derived columns included.
    /// Times are rounded to nanoseconds.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use crate::clock::to_nanoseconds;
        use serde::ser::SerializeMap;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("algorithm", self.algorithm.id())?;
        if let Algorithm::Lrs(expansion) = self.algorithm {
            map.serialize_entry("lrs_variant", expansion.id())?;
            map.serialize_entry("lrs_order", self.lrs_order.id())?;
        }
        map.serialize_entry("augmentation", self.augmentation.id())?;
        map.serialize_entry("seed", &self.seed)?;
        map.serialize_entry("vertices", &self.vertices)?;
        map.serialize_entry("edges", &self.edges)?;
        map.serialize_entry("triangles", &self.triangles)?;
        map.serialize_entry("genus", &self.genus)?;
        map.serialize_entry("components", &self.components)?;
        if let Some(loops) = self.boundary_loops {
            map.serialize_entry("boundary_loops", &loops)?;
        }
        if let Some(cross_caps) = self.non_orientable_genus {
            map.serialize_entry("non_orientable_genus", &cross_caps)?;
        }
        map.serialize_entry("quads", &self.quads)?;
        if let Some(left) = self.leftover_triangles {
            map.serialize_entry("leftover_triangles", &left)?;
            map.serialize_entry("proved_fewest", &self.is_proved_fewest)?;
        }
        map.serialize_entry("degree_two_vertices", &self.degree_two_vertices)?;
        map.serialize_entry("unpaired_triangles", &self.unpaired_triangles)?;
        map.serialize_entry("paired_percent", &self.paired_percent())?;
        map.serialize_entry("edge_flips", &self.edge_flips)?;
        map.serialize_entry("augmenting_paths", &self.paths.paths)?;
        if self.stopped {
            map.serialize_entry("stopped_after_paths", &self.paths.paths)?;
        }
        if let Some(cost) = self.total_cost {
            map.serialize_entry("total_cost", &cost)?;
            map.serialize_entry("proved_least", &self.is_proved_least)?;
            map.serialize_entry("cost_seconds", &to_nanoseconds(self.cost_seconds))?;
        }
        if let (Some(all), Some(given_up)) = (self.kept_edges, self.given_up_edges) {
            map.serialize_entry("kept_edges", &all)?;
            map.serialize_entry("given_up_edges", &given_up)?;
        }
        map.serialize_entry("build_seconds", &to_nanoseconds(self.build_seconds))?;
        map.serialize_entry("pairing_seconds", &to_nanoseconds(self.pairing_seconds))?;
        map.serialize_entry("shuffle_seconds", &to_nanoseconds(self.shuffle_seconds))?;
        map.serialize_entry("augmentation_seconds", &to_nanoseconds(self.augmentation_seconds))?;
        map.serialize_entry("total_seconds", &to_nanoseconds(self.total_seconds()))?;
        map.serialize_entry("check_seconds", &to_nanoseconds(self.check_seconds))?;
        map.serialize_entry("augmenting_path_length_mean", &self.paths.mean_length())?;
        map.serialize_entry("augmenting_path_length_max", &self.paths.longest)?;
        map.serialize_entry("augmentation_triangles_visited", &self.paths.triangles_visited)?;
        if let Some(quality) = &self.quality {
            map.serialize_entry("quality_minimum", &quality.minimum)?;
            map.serialize_entry("quality_mean", &quality.mean)?;
            map.serialize_entry("folded_quads", &quality.folded)?;
            map.serialize_entry("quality_histogram", &quality.histogram[..])?;
        }
        if let Some(sharp) = &self.sharp_edges {
            map.serialize_entry("sharp_edges", &sharp.all)?;
            map.serialize_entry("sharp_edges_kept", &sharp.kept)?;
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;

    /// What there is nothing of is left out, as far as it was not asked for.
    #[test]
    fn a_summary_has_no_empty_parts() {
        let size = Size { vertices: 8, edges: 18, triangles: 12, genus: 0, components: 1 };
        let mut report = Report::new(Algorithm::Best, Augmentation::Local, 0, size);
        report.quality = Some(Quality::new(&Mesh::default()));
        report.quads = 6;
        let summary = |report: &Report, all, kept| {
            let sharp_edges = Some(SharpEdges { all, kept });
            let summary = Report { sharp_edges, ..report.clone() }.to_string();
            let (_, shape) = summary.split_once(" folded").unwrap();
            shape.split_once("; paired in").unwrap().0.to_owned()
        };
        assert_eq!(summary(&report, 0, 0), "");
        assert_eq!(summary(&report, 2, 0), "; 0 of 2 edges over 30 degrees kept");
        report.degree_two_vertices = 1;
        assert_eq!(summary(&report, 0, 0), "; 1 vertex of degree 2");
    }

    /// A sum of times has no more digits than its parts.
    #[cfg(feature = "serde")]
    #[test]
    fn times_are_written_in_whole_nanoseconds() {
        let size = Size { vertices: 8, edges: 18, triangles: 12, genus: 0, components: 1 };
        let mut report = Report::new(Algorithm::Best, Augmentation::Local, 0, size);
        let sum = 0.000_275_845 + 0.000_032_001;
        report.total_cost = Some(1);
        for time in [
            &mut report.build_seconds,
            &mut report.cost_seconds,
            &mut report.pairing_seconds,
            &mut report.shuffle_seconds,
            &mut report.augmentation_seconds,
            &mut report.check_seconds,
        ] {
            *time = sum;
        }
        let written = serde_json::to_value(&report).expect("a map");
        let times = written.as_object().expect("a map").iter();
        let times: Vec<_> = times.filter(|(name, _)| name.ends_with("seconds")).collect();
        assert_eq!(times.len(), 7);
        for (name, time) in times {
            let parts = if name == "total_seconds" { 2 } else { 1 };
            assert_eq!(*time, f64::from(307_846 * parts) / 1e9, "{name}");
        }
    }

    #[test]
    fn zero_has_no_sign() {
        assert_eq!(
            [-0.0004, -0.0, 0.0004, -0.0006].map(three_digits),
            ["0.000", "0.000", "0.000", "-0.001"]
        );
    }
}
