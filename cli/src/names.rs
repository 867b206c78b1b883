//! Algorithms and the like as values of options.

use std::ffi::{OsStr, OsString};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command};
use triquad_lab::meshes::paper::{self, PaperMesh};

/// Returns a parser of the names of `all`, which help and errors list.
pub fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    all: [T; N],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.map(name)).map(move |given| {
        let named = all.into_iter().find(|&one| name(one) == given);
        named.expect("one of the possible values")
    })
}

/// Parser of names of the papers' meshes, as people write them; help and errors list them all.
#[derive(Clone)]
pub struct MeshOfPapers;

fn mesh_names() -> [&'static str; paper::ALL.len()] {
    paper::ALL.map(|mesh| mesh.name)
}

impl TypedValueParser for MeshOfPapers {
    type Value = PaperMesh;

    fn parse_ref(
        &self,
        command: &Command,
        argument: Option<&Arg>,
        value: &OsStr,
    ) -> Result<PaperMesh, clap::Error> {
        if let Some(mesh) = value.to_str().and_then(paper::called) {
            return Ok(mesh);
        }
        let named = PossibleValuesParser::new(mesh_names()).parse_ref(command, argument, value)?;
        Ok(paper::called(&named).expect("one of the possible values"))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(mesh_names().into_iter().map(PossibleValue::new)))
    }
}

/// Gives each `--weld` that no number follows the value 0, so that a name may follow it.
pub fn with_weld_values(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let is_number = |text: &OsString| text.to_str().is_some_and(|text| text.parse::<f64>().is_ok());
    let mut arguments = arguments.peekable();
    let mut given = Vec::new();
    while let Some(argument) = arguments.next() {
        let is_bare = argument == "--weld" && !arguments.peek().is_some_and(is_number);
        given.push(if is_bare { "--weld=0".into() } else { argument });
    }
    given
}
