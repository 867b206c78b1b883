//! Origin of a mesh as reports state it: that of known files is finer than the kind in records.

use std::sync::LazyLock;

use serde::Deserialize;

use super::MeshKind;

/// Origin of a mesh in reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Origin {
    /// The paper's own mesh.
    Original,
    /// Made from another version of the paper's scan, with the paper's counts.
    Derived,
    /// Any other file.
    File,
    /// Made to order.
    Generated,
    /// Simplified from a generated mesh.
    Simplified,
    /// Made in place of a scan that was not at hand.
    StandIn,
}

/// A row of `experiments/origins.csv`.
#[derive(Debug, Deserialize)]
struct KnownFile {
    sha256: String,
    /// Name of the mesh in the papers' tables.
    #[cfg(test)]
    mesh: String,
    origin: Origin,
}

/// The files whose origin is known.
static KNOWN: LazyLock<Vec<KnownFile>> = LazyLock::new(|| {
    let text = include_str!("../../experiments/origins.csv");
    let rows = csv::Reader::from_reader(text.as_bytes()).into_deserialize();
    rows.collect::<Result<_, _>>().expect("experiments/origins.csv has these columns")
});

impl Origin {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Original,
        Self::Derived,
        Self::File,
        Self::Generated,
        Self::Simplified,
        Self::StandIn,
    ];

    /// Returns the origin of a mesh of that kind, whose file has that hash.
    pub fn of(kind: MeshKind, sha256: &str) -> Self {
        match kind {
            MeshKind::Real => KNOWN
                .iter()
                .find(|file| file.sha256 == sha256)
                .map_or(Self::File, |file| file.origin),
            MeshKind::Generated => Self::Generated,
            MeshKind::Simplified => Self::Simplified,
            MeshKind::StandIn => Self::StandIn,
        }
    }

    /// Returns its word in reports.
    pub fn id(self) -> &'static str {
        match self {
            Self::Original => "original",
            Self::Derived => "derived",
            Self::File => "file",
            Self::Generated => "generated",
            Self::Simplified => "simplified",
            Self::StandIn => "stand-in",
        }
    }

    /// Returns the meaning of its word.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Original => "mesh: the paper's own",
            Self::Derived => {
                "mesh: made from another version of the paper's scan, with the paper's counts and \
                 shape, not its connectivity"
            }
            Self::File => "mesh: another file; its origin is not recorded",
            Self::Generated => "mesh: made to order",
            Self::Simplified => "mesh: simplified from a generated one",
            Self::StandIn => {
                "mesh: generated in place of a scan, of another shape; at full scale with its \
                 number of vertices and genus (†)"
            }
        }
    }

    /// Returns `†` for a stand-in, nothing for the others.
    pub fn dagger(self) -> &'static str {
        if self == Self::StandIn { "†" } else { "" }
    }

    /// Returns whether the mesh is from a file, and has its size at any scale.
    pub fn is_file(self) -> bool {
        matches!(self, Self::Original | Self::Derived | Self::File)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meshes::paper;

    #[test]
    fn a_known_file_is_found_by_its_hash_alone() {
        let known = |mesh| KNOWN.iter().find(|file| file.mesh == mesh).unwrap();
        let of = |hash: &str| Origin::of(MeshKind::Real, hash);
        assert_eq!(of(&known("socket").sha256), Origin::Original);
        assert_eq!(of(&known("botijo").sha256), Origin::Derived);
        assert_eq!([of(""), of(&"0".repeat(64))], [Origin::File; 2]);
        assert_eq!(Origin::of(MeshKind::StandIn, &known("socket").sha256), Origin::StandIn);
    }

    #[test]
    fn known_files_are_scans_of_the_papers_and_listed_once() {
        for (at, file) in KNOWN.iter().enumerate() {
            let mesh = paper::named(&file.mesh).expect(&file.mesh);
            assert_eq!(mesh.kind(), MeshKind::StandIn, "{}", file.mesh);
            assert!(matches!(file.origin, Origin::Original | Origin::Derived), "{file:?}");
            assert!(file.sha256.len() == 64, "{file:?}");
            assert!(KNOWN[..at].iter().all(|other| other.sha256 != file.sha256), "{file:?}");
        }
    }

    #[test]
    fn words_are_those_of_the_file() {
        for origin in Origin::ALL {
            let text = format!("\"{}\"", origin.id());
            assert_eq!(serde_json::from_str::<Origin>(&text).unwrap(), origin);
        }
    }
}
