//! Everything that is counted and timed of one conversion.

use std::fmt;

use crate::augmentation::{Augmentation, AugmentationStats};
use crate::pairing::Algorithm;
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
    /// Shape of the quads; none without a check.
    pub quality: Option<Quality>,
    /// Adjacency and validation, with the flips of `orient`.
    pub build_seconds: f64,
    /// Column (a): from the triangulation to the initial pairing, its dual graph included.
    pub pairing_seconds: f64,
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
            quality: None,
            build_seconds: 0.0,
            pairing_seconds: 0.0,
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
            "{} triangles (genus {}) -> {} quads on the same {} vertices; {} left {} unpaired \
             ({:.3} %), completed by {}; paired in {:.3} s",
            self.triangles,
            self.genus,
            self.quads,
            self.vertices,
            self.algorithm,
            self.unpaired_triangles,
            100.0 - self.paired_percent(),
            self.augmentation,
            self.total_seconds(),
        )
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
        map.serialize_entry("build_seconds", &self.build_seconds)?;
        map.serialize_entry("pairing_seconds", &self.pairing_seconds)?;
        map.serialize_entry("augmentation_seconds", &self.augmentation_seconds)?;
        map.serialize_entry("total_seconds", &self.total_seconds())?;
        map.serialize_entry("check_seconds", &self.check_seconds)?;
        map.serialize_entry("augmenting_path_length_mean", &self.paths.mean_length())?;
        map.serialize_entry("augmenting_path_length_max", &self.paths.longest)?;
        map.serialize_entry("augmentation_triangles_visited", &self.paths.triangles_visited)?;
        if let Some(quality) = &self.quality {
            map.serialize_entry("quality_minimum", &quality.minimum)?;
            map.serialize_entry("quality_mean", &quality.mean)?;
            map.serialize_entry("quality_histogram", &quality.histogram[..])?;
        }
        map.end()
    }
}
