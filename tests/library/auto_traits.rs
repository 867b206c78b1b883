//! Which types cross threads, and which errors fit in a box and are named as errors. Checked when
//! this is compiled.

use triquad::clock::{SteppingClock, SystemClock};
use triquad::dual::DualGraphError;
use triquad::irreducible::{Irreducible, IrreducibleError};
use triquad::matching::weighted::{CertificateError, SolveError};
use triquad::mesh::{Attributes, AttributesError, CornerIndices, Faces, TextList};
use triquad::pairing::cubic::CubicGraphError;
use triquad::pairing::{InitialPairing, Objective, Proof, ProofError};
use triquad::quadrangulation::quality::Quality;
use triquad::quadrangulation::{CostCountError, Keep, MixedCheck, NoSuchEdgeError};
use triquad::random::Random;
use triquad::simplify::{Simplifier, SimplifyError};
use triquad::triangulation::{EdgeSet, OpenTriangulation, ParseIdError, ShrinkingTriangulation};
use triquad::{
    Algorithm, Augmentation, AugmentationStats, CheckError, CheckReport, ConvertError, Converted,
    DualGraph, Matching, Mesh, PerfectMatching, Quadrangulated, Quadrangulation, Report, Survey,
    Triangulation, UnknownNameError,
};

const fn crosses_threads<T: Send + Sync + 'static>() {}

const fn is_boxable_error<T: std::error::Error + Send + Sync + 'static>() {}

/// Returns whether a type is named as an error. A survey is a report first.
const fn is_named_as_error(name: &str) -> bool {
    let name = name.as_bytes();
    matches!(name, [.., b'E', b'r', b'r', b'o', b'r'] | b"Survey" | b"Box<Survey>")
}

macro_rules! assert_errors {
    ($($kind:ty),+ $(,)?) => {
        const _: () = { $(
            is_boxable_error::<$kind>();
            assert!(is_named_as_error(stringify!($kind)));
        )+ };
    };
}

macro_rules! assert_all {
    ($check:ident: $($kind:ty),+ $(,)?) => { const _: () = { $($check::<$kind>();)+ }; };
}

assert_all!(crosses_threads: Mesh, Faces, Attributes, CornerIndices, TextList);
assert_all!(crosses_threads: Triangulation, ShrinkingTriangulation, Survey);
assert_all!(crosses_threads: DualGraph, Matching, PerfectMatching, InitialPairing<'static>);
assert_all!(crosses_threads: OpenTriangulation, EdgeSet, Keep, Objective, Proof, MixedCheck);
assert_errors!(ProofError, NoSuchEdgeError, CostCountError);
assert_all!(crosses_threads: Algorithm, Augmentation, AugmentationStats);
assert_all!(crosses_threads: Quadrangulation, CheckReport, Quality);
assert_all!(crosses_threads: Converted, Quadrangulated<'static>, Report);
assert_all!(crosses_threads: Irreducible, Simplifier, Random, SystemClock, SteppingClock);
assert_errors!(ConvertError, Survey, Box<Survey>, CheckError, DualGraphError);
assert_errors!(AttributesError, IrreducibleError, SimplifyError, CubicGraphError);
assert_errors!(SolveError, CertificateError);
assert_errors!(UnknownNameError, ParseIdError);

#[cfg(feature = "files")]
mod files {
    use super::{crosses_threads, is_boxable_error, is_named_as_error};
    use triquad::MeshError;
    use triquad::atomic_file::{AtomicFile, NoFolderError};
    use triquad::mesh::{Format, Output};

    assert_all!(crosses_threads: AtomicFile, Format, Output);
    assert_errors!(MeshError, NoFolderError);
}
