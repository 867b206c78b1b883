//! Everything that is counted and timed of one conversion.

use std::fmt;

use crate::augmentation::{Augmentation, AugmentationStats};
use crate::irreducible::Discipline;
use crate::pairing::{Algorithm, LRS_ORDER};
use crate::quadrangulation::SharpEdges;
use crate::quadrangulation::quality::Quality;
use crate::triangulation::Triangulation;

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
    /// Edges n_e of the triangulation.
    pub edges: usize,
    /// Triangles n_f.
    pub triangles: usize,
    /// Genus, summed over components.
    pub genus: usize,
    /// Connected components.
    pub components: usize,
    /// Quads; 0 if the conversion was stopped.
    pub quads: usize,
    /// Vertices of degree 2, where two quads share two edges; known from the check.
    pub degree_two_vertices: usize,
    /// Triangles k that the initial pairing left unpaired: column (c).
    pub unpaired_triangles: usize,
    /// Edges of the triangulation whose triangles were paired that the input does not have.
    pub edge_flips: usize,
    /// Counts of the augmentation.
    pub paths: AugmentationStats,
    /// Whether [`Progress`](super::Progress) stopped the augmentation.
    pub stopped: bool,
    /// Total cost of the pairing, if `best` was given coordinates.
    pub total_cost: Option<i128>,
    /// Whether a certificate was verified that no perfect pairing costs less.
    pub is_proved_least: bool,
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

impl Report {
    /// Makes a report of a conversion that has not begun.
    pub(super) fn new(
        algorithm: Algorithm,
        augmentation: Augmentation,
        seed: u64,
        triangulation: &Triangulation,
    ) -> Self {
        Self {
            algorithm,
            lrs_order: LRS_ORDER,
            augmentation,
            seed,
            vertices: triangulation.vertex_count(),
            edges: triangulation.edge_count(),
            triangles: triangulation.triangle_count(),
            genus: triangulation.genus(),
            components: triangulation.component_count(),
            quads: 0,
            degree_two_vertices: 0,
            unpaired_triangles: 0,
            edge_flips: 0,
            paths: AugmentationStats::default(),
            stopped: false,
            total_cost: None,
            is_proved_least: false,
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
            return write!(f, "{}: total cost {cost}{proof}", self.algorithm);
        }
        write!(
            f,
            "{} left {} unpaired ({:.3} %), completed by {}",
            self.algorithm,
            self.unpaired_triangles,
            100.0 - self.paired_percent(),
            self.augmentation,
        )
    }

    /// Writes the shape of the quads, if it was measured.
    fn fmt_shape(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Some(quality), Some(sharp)) = (&self.quality, &self.sharp_edges) else {
            return Ok(());
        };
        write!(
            f,
            "; quality {:.3} in the mean, {:.3} at worst, {} folded; {} of {} sharp edges kept; {} \
             vertices of degree 2",
            quality.mean,
            quality.minimum,
            quality.folded,
            sharp.kept,
            sharp.all,
            self.degree_two_vertices,
        )
    }

    /// Writes the outcome of a conversion that was stopped.
    fn fmt_stopped(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} triangles (genus {}), no quads; {} left {} unpaired ({:.3} %), stopped after {} of \
             {} augmenting paths by {}; paired in {:.3} s, augmented for {:.3} s",
            self.triangles,
            self.genus,
            self.algorithm,
            self.unpaired_triangles,
            100.0 - self.paired_percent(),
            self.paths.paths,
            self.unpaired_triangles / 2,
            self.augmentation,
            self.pairing_seconds,
            self.augmentation_seconds,
        )
    }
}

impl fmt::Display for Report {
    /// Writes the summary as one line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.stopped {
            return self.fmt_stopped(f);
        }
        write!(
            f,
            "{} triangles (genus {}) -> {} quads on the same {} vertices; ",
            self.triangles, self.genus, self.quads, self.vertices,
        )?;
        self.fmt_pairing(f)?;
        self.fmt_shape(f)?;
        write!(f, "; paired in {:.3} s", self.total_seconds())
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Report {
    /// Writes one map with the names of `--stats` and of the records, derived columns included.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
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
        map.serialize_entry("quads", &self.quads)?;
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
            map.serialize_entry("cost_seconds", &self.cost_seconds)?;
        }
        map.serialize_entry("build_seconds", &self.build_seconds)?;
        map.serialize_entry("pairing_seconds", &self.pairing_seconds)?;
        map.serialize_entry("shuffle_seconds", &self.shuffle_seconds)?;
        map.serialize_entry("augmentation_seconds", &self.augmentation_seconds)?;
        map.serialize_entry("total_seconds", &self.total_seconds())?;
        map.serialize_entry("check_seconds", &self.check_seconds)?;
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
