//! The meshes of the papers' tables by name: Tables 4.1 and 4.2 of the comparison paper, Tables 2
//! to 5 of the paper on irreducible triangulations, whose boxes carry the prefix `ir-`.

use super::recipe::{MeshKind, Recipe};
use triquad_generators::box_mesh::{PaperBox, Walls};

/// A mesh of the papers, and how its like is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaperMesh {
    /// Name on the command line and in records.
    pub name: &'static str,
    /// Genus as printed.
    pub genus: u32,
    /// Vertices as printed.
    pub vertices: u32,
    /// Its recipe.
    pub recipe: Recipe,
}

/// Size of the papers' meshes.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    serde::Serialize,
    serde::Deserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Scale {
    /// As in the papers.
    #[default]
    Full,
    /// A twentieth.
    Small,
    /// A hundredth.
    Demo,
}

impl Scale {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Full, Self::Small, Self::Demo];

    /// Returns the name on the command line and in records.
    pub fn id(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Small => "small",
            Self::Demo => "demo",
        }
    }

    /// Returns the box with about so much fewer shafts, and as much fewer holes.
    fn divided(self, shape: PaperBox) -> PaperBox {
        let shafts = match self {
            Self::Full => shape.shafts,
            Self::Small => 14,
            Self::Demo => 6,
        };
        PaperBox { shafts, holes: shape.holes.div_ceil(self.divisor()), ..shape }
    }

    fn divisor(self) -> u32 {
        match self {
            Self::Full => 1,
            Self::Small => 20,
            Self::Demo => 100,
        }
    }
}

const A1: PaperBox = PaperBox::PUBLISHED;
const B1: PaperBox = with_holes(3500);

const fn with_holes(holes: u32) -> PaperBox {
    PaperBox { holes, ..A1 }
}

/// The box with so many vertices and holes as printed; a test compares its own.
const fn a_box(name: &'static str, vertices: u32, holes: u32) -> PaperMesh {
    PaperMesh { name, genus: holes, vertices, recipe: box_recipe(with_holes(holes)) }
}

const fn box_recipe(shape: PaperBox) -> Recipe {
    Recipe::PaperBox { shape, walls: Walls::Alternating, seed: 0 }
}

const fn with_walls(name: &'static str, walls: Walls) -> PaperMesh {
    PaperMesh {
        recipe: Recipe::PaperBox { shape: A1, walls, seed: 0 },
        ..a_box(name, 2_097_150, 0)
    }
}

/// A mesh of the family of Figure 6, with a name of ours.
const fn figure_6(name: &'static str, sides: u32) -> PaperMesh {
    let recipe = Recipe::StarredBipyramid { sides };
    PaperMesh { name, genus: 0, vertices: 3 * sides + 2, recipe }
}

const fn simplified(name: &'static str, of: PaperBox, vertices: u32) -> PaperMesh {
    PaperMesh { name, genus: of.holes, vertices, recipe: Recipe::SimplifiedBox { of, vertices } }
}

const fn scan(name: &'static str, vertices: u32, genus: u32) -> PaperMesh {
    PaperMesh { name, genus, vertices, recipe: Recipe::StandIn { vertices, genus, seed: 0 } }
}

/// Every mesh of both papers; equal ones under each of their names.
pub const ALL: [PaperMesh; 55] = [
    // Table 4.1 and Table 2.
    scan("armadillo", 171_889, 0),
    scan("botijo", 20_000, 5),
    scan("casting", 5_096, 9),
    scan("eros", 197_230, 0),
    scan("fertility", 19_994, 4),
    scan("filigree", 29_129, 65),
    scan("gargoyle", 97_130, 0),
    scan("hand", 195_557, 0),
    scan("happy-buddha", 543_652, 104),
    scan("iphigenia", 351_750, 4),
    scan("socket", 836, 7),
    // Table 4.2 (a).
    a_box("A1", 2_097_150, 0),
    simplified("A2", A1, 991_416),
    simplified("A3", A1, 745_697),
    simplified("A4", A1, 418_073),
    simplified("A5", A1, 172_354),
    // Table 4.2 (b).
    a_box("B1", 2_104_150, 3500),
    simplified("B2", B1, 994_979),
    simplified("B3", B1, 748_496),
    simplified("B4", B1, 419_852),
    simplified("B5", B1, 173_370),
    // Table 3.
    a_box("ir-B0", 2_097_150, 0),
    simplified("ir-B1", A1, 1_097_150),
    simplified("ir-B2", A1, 597_150),
    simplified("ir-B3", A1, 297_150),
    simplified("ir-B4", A1, 147_150),
    simplified("ir-B5", A1, 72_150),
    simplified("ir-B6", A1, 34_650),
    simplified("ir-B7", A1, 15_900),
    simplified("ir-B8", A1, 8_400),
    simplified("ir-B9", A1, 4_400),
    // Table 4.
    a_box("ir-C0", 2_104_150, 3500),
    simplified("ir-C1", B1, 1_104_150),
    simplified("ir-C2", B1, 604_150),
    simplified("ir-C3", B1, 354_150),
    simplified("ir-C4", B1, 179_150),
    simplified("ir-C5", B1, 91_650),
    simplified("ir-C6", B1, 41_650),
    simplified("ir-C7", B1, 16_650),
    // Table 5.
    a_box("ir-D0", 2_104_150, 3500),
    a_box("ir-D1", 2_103_150, 3000),
    a_box("ir-D2", 2_102_150, 2500),
    a_box("ir-D3", 2_101_150, 2000),
    a_box("ir-D4", 2_100_150, 1500),
    a_box("ir-D5", 2_099_150, 1000),
    a_box("ir-D6", 2_098_150, 500),
    a_box("ir-D7", 2_097_350, 100),
    a_box("ir-D8", 2_097_250, 50),
    a_box("ir-D9", 2_097_170, 10),
    // Figure 6.
    figure_6("ir-F1", 1_000),
    figure_6("ir-F2", 4_000),
    figure_6("ir-F3", 16_000),
    // A1 with other diagonals, which no count determines.
    with_walls("A1-equal", Walls::Equal),
    with_walls("A1-paired", Walls::Paired),
    with_walls("A1-drawn", Walls::Drawn),
];

/// Returns the mesh of that name.
pub fn named(name: &str) -> Option<PaperMesh> {
    ALL.into_iter().find(|mesh| mesh.name == name)
}

/// Returns the mesh that people call so: case, blanks, underscores and hyphens do not matter.
///
/// ```
/// let mesh = triquad_lab::meshes::paper::called("Happy Buddha").unwrap();
/// assert_eq!(mesh.name, "happy-buddha");
/// ```
pub fn called(name: &str) -> Option<PaperMesh> {
    let plain = |name: &str| name.to_lowercase().replace(['_', ' ', '-'], "");
    let wanted = plain(name);
    ALL.into_iter().find(|mesh| plain(mesh.name) == wanted)
}

impl PaperMesh {
    /// Returns the mesh at `scale`: vertices, shafts and genus divided about alike, a genus above 0
    /// not to 0, a scan's vertices not below 200. A box keeps the depth of its shafts.
    pub fn at(mut self, scale: Scale) -> Self {
        if scale == Scale::Full {
            return self;
        }
        let divisor = scale.divisor();
        self.genus = self.genus.div_ceil(divisor);
        self.vertices /= divisor;
        match &mut self.recipe {
            Recipe::Box(_) => {}
            Recipe::PaperBox { shape, .. } => {
                *shape = scale.divided(*shape);
                self.vertices = shape.vertices() as u32;
            }
            Recipe::SimplifiedBox { of, vertices } => {
                *of = scale.divided(*of);
                *vertices = self.vertices;
            }
            Recipe::StarredBipyramid { sides } => {
                *sides /= divisor;
                self.vertices = 3 * *sides + 2;
            }
            Recipe::StandIn { vertices, genus, .. } => {
                // The smallest scans would lose all shape, and vertices enough for their genus.
                self.vertices = self.vertices.max(200.min(*vertices));
                (*vertices, *genus) = (self.vertices, self.genus);
            }
        }
        self
    }

    /// Returns the kind of the mesh in records.
    pub fn kind(&self) -> MeshKind {
        match self.recipe {
            Recipe::Box(_) | Recipe::PaperBox { .. } | Recipe::StarredBipyramid { .. } => {
                MeshKind::Generated
            }
            Recipe::SimplifiedBox { .. } => MeshKind::Simplified,
            Recipe::StandIn { .. } => MeshKind::StandIn,
        }
    }

    /// Returns the number of edges by Euler's formula, 3 (vertices - 2 + 2 genus).
    pub fn edges(&self) -> u32 {
        3 * (self.vertices + 2 * self.genus - 2)
    }

    /// Returns the number of triangles by Euler's formula, 2 (vertices - 2 + 2 genus).
    pub fn triangles(&self) -> u32 {
        2 * (self.vertices + 2 * self.genus - 2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_mesh_of_a_smaller_scale_can_be_made() {
        for mesh in ALL.map(|mesh| mesh.at(Scale::Demo)) {
            let list = mesh.recipe.make().unwrap_or_else(|error| panic!("{}: {error}", mesh.name));
            let built = triquad::Triangulation::build(&list).expect(mesh.name);
            let counts = (built.vertex_count(), built.genus());
            assert_eq!(counts, (mesh.vertices as usize, mesh.genus as usize), "{}", mesh.name);
        }
        for mesh in ALL {
            assert_eq!(mesh.at(Scale::Full), mesh);
            let Recipe::PaperBox { shape, .. } = mesh.recipe else { continue };
            assert_eq!(shape.vertices(), u64::from(mesh.vertices), "{}", mesh.name);
            let small = mesh.at(Scale::Small);
            let ratio = f64::from(mesh.vertices) / f64::from(small.vertices);
            // Shafts come in squares, and 14 in a row are the least that have the holes of B1.
            assert!((17.0..21.0).contains(&ratio), "{}: {ratio}", mesh.name);
        }
    }

    #[test]
    fn a_mesh_is_found_however_its_name_is_written() {
        for mesh in ALL {
            for blank in ["", " ", "_", "-"] {
                let given = mesh.name.replace('-', blank).to_uppercase();
                assert_eq!(called(&given), Some(mesh), "{given}");
            }
        }
        for given in ["A 5", "a_5", "a-5", "A5"] {
            assert_eq!(called(given).map(|mesh| mesh.name), Some("A5"), "{given}");
        }
        for given in ["", "-", "A", "A55", "buddha"] {
            assert_eq!(called(given), None, "{given}");
        }
    }

    /// Edges and triangles as printed, where that row of the table is consistent with itself.
    #[test]
    fn the_counts_are_the_printed_ones() {
        let printed = [
            ("botijo", 60_024, 40_016),
            ("eros", 591_684, 394_456),
            ("filigree", 87_771, 58_514),
            ("gargoyle", 291_384, 194_256),
            ("happy-buddha", 1_631_574, 1_087_716),
            ("iphigenia", 1_055_268, 703_512),
            ("casting", 15_336, 10_224),
            ("fertility", 60_000, 40_000),
            ("hand", 586_665, 391_110),
            ("socket", 2_544, 1_696),
            ("A1", 6_291_444, 4_194_296),
            ("A2", 2_974_242, 1_982_828),
            ("A3", 2_237_085, 1_491_390),
            ("A4", 1_254_213, 836_142),
            ("A5", 517_056, 344_704),
            ("B1", 6_333_444, 4_222_296),
            ("B2", 3_005_931, 2_003_954),
            ("B3", 2_266_482, 1_510_988),
            ("B4", 1_280_550, 853_700),
            ("B5", 541_104, 360_736),
            ("ir-B0", 6_291_444, 4_194_296),
            ("ir-B1", 3_291_444, 2_194_296),
            ("ir-B2", 1_791_444, 1_194_296),
            ("ir-B3", 891_444, 594_296),
            ("ir-B4", 441_444, 294_296),
            ("ir-B5", 216_444, 144_296),
            ("ir-B6", 103_944, 69_296),
            ("ir-B7", 47_694, 31_796),
            ("ir-B8", 25_194, 16_796),
            ("ir-B9", 13_194, 8_796),
            ("ir-C0", 6_333_444, 4_222_296),
            ("ir-C1", 3_333_444, 2_222_296),
            ("ir-C2", 1_833_444, 1_222_296),
            ("ir-C3", 1_083_444, 722_296),
            ("ir-C4", 558_444, 372_296),
            ("ir-C6", 145_944, 97_296),
            ("ir-D0", 6_333_444, 4_222_296),
            ("ir-D1", 6_327_444, 4_218_296),
            ("ir-D2", 6_321_444, 4_214_296),
            ("ir-D3", 6_315_444, 4_210_296),
            ("ir-D4", 6_309_444, 4_206_296),
            ("ir-D5", 6_303_444, 4_202_296),
            ("ir-D6", 6_297_444, 4_198_296),
            ("ir-D7", 6_292_644, 4_195_096),
            ("ir-D8", 6_292_044, 4_194_696),
            ("ir-D9", 6_291_564, 4_194_376),
        ];
        for (name, edges, triangles) in printed {
            let mesh = named(name).expect(name);
            assert_eq!((mesh.edges(), mesh.triangles()), (edges, triangles), "{name}");
        }
        // Armadillo's triangles, and the edges of C5 and C7, contradict the rest of their rows.
        assert_eq!((named("armadillo").unwrap().edges()), 515_661);
        assert_eq!((named("ir-C5").unwrap().triangles()), 197_296);
        assert_eq!((named("ir-C7").unwrap().triangles()), 47_296);
    }
}
