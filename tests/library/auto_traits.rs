//! Which types cross threads, and which errors fit in a box. Checked when this is compiled.

use triquad::clock::{SteppingClock, SystemClock};
use triquad::dual::DualGraphError;
use triquad::irreducible::{Irreducible, IrreducibleError};
use triquad::mesh::{Attributes, AttributesError, CornerIndices, Faces, TextList};
use triquad::pairing::{InitialPairing, Objective, Proof, ProofError};
use triquad::quadrangulation::quality::Quality;
use triquad::quadrangulation::{CostCountError, Keep, MixedCheck, NoSuchEdge};
use triquad::random::Random;
use triquad::simplify::{Simplifier, SimplifyError};
use triquad::triangulation::{EdgeSet, OpenTriangulation, ParseIdError, ShrinkingTriangulation};
use triquad::{
    Algorithm, Augmentation, AugmentationStats, CheckReport, ConvertError, Converted, DualGraph,
    Matching, Mesh, Mismatch, PerfectMatching, Quadrangulated, Quadrangulation, Report, Survey,
    Triangulation, UnknownNameError,
};

const fn crosses_threads<T: Send + Sync + 'static>() {}

const fn is_boxable_error<T: std::error::Error + Send + Sync + 'static>() {}

macro_rules! assert_all {
    ($check:ident: $($kind:ty),+ $(,)?) => { const _: () = { $($check::<$kind>();)+ }; };
}

assert_all!(crosses_threads: Mesh, Faces, Attributes, CornerIndices, TextList);
assert_all!(crosses_threads: Triangulation, ShrinkingTriangulation, Survey);
assert_all!(crosses_threads: DualGraph, Matching, PerfectMatching, InitialPairing<'static>);
assert_all!(crosses_threads: OpenTriangulation, EdgeSet, Keep, Objective, Proof, MixedCheck);
assert_all!(is_boxable_error: ProofError, NoSuchEdge, CostCountError);
assert_all!(crosses_threads: Algorithm, Augmentation, AugmentationStats);
assert_all!(crosses_threads: Quadrangulation, CheckReport, Quality);
assert_all!(crosses_threads: Converted, Quadrangulated<'static>, Report);
assert_all!(crosses_threads: Irreducible, Simplifier, Random, SystemClock, SteppingClock);
assert_all!(is_boxable_error: ConvertError, Survey, Box<Survey>, Mismatch, DualGraphError);
assert_all!(is_boxable_error: AttributesError, IrreducibleError, SimplifyError);
assert_all!(is_boxable_error: UnknownNameError, ParseIdError);

#[cfg(feature = "files")]
mod files {
    use super::{crosses_threads, is_boxable_error};
    use triquad::MeshError;
    use triquad::atomic_file::AtomicFile;
    use triquad::mesh::{Format, Output};

    assert_all!(crosses_threads: AtomicFile, Format, Output);
    assert_all!(is_boxable_error: MeshError);
}
