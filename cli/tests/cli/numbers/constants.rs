//! Numbers in documents that a file of the repository fixes.

/// A number that a file of the repository fixes.
pub struct Constant {
    pub document: &'static str,
    pub number: &'static str,
    /// The file, or the folder it is in.
    pub file: &'static str,
    /// The text in the file.
    pub text: &'static str,
}

const fn constant(
    document: &'static str,
    number: &'static str,
    file: &'static str,
    text: &'static str,
) -> Constant {
    Constant { document, number, file, text }
}

/// Our algorithms beside programs of others.
const SIDE_BY_SIDE: &str = "results/quality-2026-11-28-xeon-2-cores/table_side_by_side.csv";

pub const CONSTANTS: &[Constant] = &[
    constant("README.md", "1.88", "Cargo.toml", "rust-version = \"1.88\""),
    constant("README.md", "0.7156", SIDE_BY_SIDE, "2000,4004,2,0.0,0.7156,-0.0328,-0.7165,25.0,"),
    constant("README.md", "0.7137", SIDE_BY_SIDE, "2000,4004,2,0.0,0.7137,0.0490,-0.2763,12.0,"),
    constant("README.md", "225", "docs/reproduction.md", "| all | 225 |"),
    constant("README.md", "114", "docs/reproduction.md", "| reproduced | 114 |"),
    constant("README.md", "3.10", "python/pyproject.toml", "requires-python = \">=3.10\""),
    constant("README.md", "2.0", "Cargo.toml", "MIT OR Apache-2.0"),
    constant("docs/cli.md", "130", "lab/src/experiment/process.rs", "INTERRUPTED: i32 = 130"),
    constant("docs/convert.md", "0.35", "cli/src/aims.rs", "default_missing_value = \"0.35\""),
    constant("docs/convert.md", "65,536", "src/quadrangulation/cost.rs", "65536.0"),
    constant("docs/convert.md", "10,000", "src/quadrangulation/cost.rs", "10_000"),
    constant("docs/formats.md", "16", "src/mesh/obj", "1 << 24"),
    constant("docs/formats.md", "256", "src/mesh/files.rs", "256 MiB"),
    constant("docs/formats.md", "100", "src/mesh/gzip.rs", "RATIO: u64 = 100"),
    constant("docs/meshes.md", "1.624", "experiments/paper/table_6.csv", "3406091.5"),
    constant(
        "docs/meshes.md",
        "124",
        "generators/src/box_mesh/paper_box/derivation.rs",
        "124..=131",
    ),
    constant("docs/meshes.md", "131", "generators/src/box_mesh/paper_box/derivation.rs", "x..=131"),
    constant("docs/meshes.md", "159", "generators/src/box_mesh/paper_box/derivation.rs", "1..160"),
    constant("docs/meshes.md", "3,500", "experiments/paper/table_4.csv", "ir-C0,C0,"),
    constant("docs/meshes.md", "136.0", "experiments/paper/table_4_4_i.csv", "A1,A1,ps"),
    constant("docs/own-results.md", "5", "lab/src/experiment/process.rs", "from_millis(5)"),
    constant(
        "docs/performance.md",
        "32,768",
        "src/matching/weighted/limits.rs",
        "divided: 1 << 15",
    ),
    constant("docs/performance.md", "90", "src/augmentation/mod.rs", "90 bytes a"),
    constant("docs/performance.md", "2", "cli/src/huge_pages.rs", "2 << 20"),
    constant("docs/python.md", "3.10", "python/pyproject.toml", "requires-python = \">=3.10\""),
    constant("docs/python.md", "500", "python/tests/test_random.py", "RANDOM = 500"),
    constant("docs/python.md", "1.26", "python/pyproject.toml", "numpy>=1.26"),
    constant("docs/quality.md", "0.5", "src/quadrangulation", "mean: 0.5"),
    constant("docs/quality.md", "0.55", "src/quadrangulation/cost.rs", "0.55 * "),
    constant("docs/quality.md", "0.35", "cli/src/aims.rs", "default_missing_value = \"0.35\""),
    constant("docs/reproduction.md", "5", "lab/src/report/compare", "MOST_DISAGREEING: f64 = 0.05"),
    constant("docs/reproduction.md", "2.4", "experiments/paper/README.md", "2.4 GHz"),
    constant("docs/reproduction.md", "100", "lab/src/report/tables", "100.0 * "),
    constant("docs/reproduction.md", "1.65", "experiments/paper/table_7.csv", "1.65"),
    constant("docs/reproduction.md", "1.64", "experiments/paper/table_7.csv", "1.64"),
];
