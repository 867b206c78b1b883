//! Several inputs of one verb: one after the other, each into a folder under its own name.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use triquad::counted::counted;
use triquad::mesh::Format;

use crate::failure::Failure;
use crate::{input, shell, stdio};

/// Options of a verb that takes several inputs.
#[derive(clap::Args, Clone)]
pub struct Several {
    /// More meshes, each converted by itself; a refused one does not stop the others
    #[arg(value_name = "IN")]
    more: Vec<PathBuf>,
    /// Write each result into FOLDER, which is made if it is not there, under the name of its input
    #[arg(long, value_name = "FOLDER")]
    #[arg(conflicts_with_all = [
        "output", "stats", "write_triangulation", "stop_after_paths", "certificate", "given_up",
        "compare",
    ])]
    out_dir: Option<PathBuf>,
    /// The format in FOLDER: obj, ply or off, also with .gz; by default that of each input, and obj
    /// for stl
    #[arg(long, value_name = "EXTENSION")]
    format: Option<String>,
}

impl Several {
    /// Calls `work` with each input and its output, `first` being the first input; with `output`
    /// where there is no folder. `alone` names a given option that excludes a folder.
    ///
    /// Prints every failure. The last failure counts them, with the greatest of their exit codes.
    pub fn each(
        &self,
        first: &Path,
        output: Option<&Path>,
        alone: Option<&str>,
        work: impl Fn(&Path, Option<&Path>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let Some(folder) = &self.out_dir else {
            self.refuse_without_folder(first, alone)?;
            return work(first, output);
        };
        let inputs: Vec<&Path> =
            [first].into_iter().chain(self.more.iter().map(|p| &**p)).collect();
        let outputs = self.outputs(folder, &inputs)?;
        std::fs::create_dir_all(folder)
            .map_err(|error| input::mesh_failure(folder, &error.into()))?;
        let mut codes = Vec::new();
        for (input, output) in inputs.iter().zip(&outputs) {
            if let Err(failure) = work(input, Some(output)) {
                stdio::fail(&failure);
                codes.push(failure.code);
            }
        }
        let Some(&code) = codes.iter().max() else { return Ok(()) };
        let inputs = counted(inputs.len(), "mesh", "meshes");
        let were = if codes.len() == 1 { "was" } else { "were" };
        let message = format!("{} of {inputs} {were} not converted", codes.len());
        Err(Failure::with_code(code, message))
    }

    /// Refuses what needs a folder. The parser's `requires` would not: it requires nothing that
    /// another given option excludes.
    fn refuse_without_folder(&self, first: &Path, alone: Option<&str>) -> Result<(), Failure> {
        let (path, given) = match (&self.more[..], &self.format) {
            ([], None) => return Ok(()),
            ([], Some(format)) => {
                let problem = "names the format of results in a folder";
                let remedy = match alone {
                    Some("-o") => "the name after -o has its own; leave --format out",
                    Some(_) => "leave it out",
                    None => "give --out-dir FOLDER, too, or -o with a name that ends so",
                };
                return Err(Failure::bad(format!("--format {format}: {problem}; {remedy}")));
            }
            ([one], _) => (one, "a second mesh is given".to_owned()),
            (more, _) => {
                (&more[0], format!("{} are given", counted(1 + more.len(), "mesh", "meshes")))
            }
        };
        let name = path.display();
        let is_output = self.more.len() == 1
            && alone != Some("-o")
            && !path.exists()
            && Format::from_path(path).is_ok_and(|format| format != Format::Stl);
        if is_output {
            let (first, word) = (shell::word(first), shell::word(path));
            let remedy = format!("did you mean 'triquad convert {first} -o {word}'?");
            return Err(Failure::bad(format!("{name}: there is no such mesh; {remedy}")));
        }
        let remedy = match alone {
            Some(option) => format!("{option} takes one mesh only: call convert once for each"),
            None => "several meshes need --out-dir FOLDER for their results".into(),
        };
        Err(Failure::bad(format!("{name}: {given}; {remedy}")))
    }

    /// Names the outputs. Refuses two of the same name.
    fn outputs(&self, folder: &Path, inputs: &[&Path]) -> Result<Vec<PathBuf>, Failure> {
        let mut taken = BTreeMap::new();
        let mut outputs = Vec::new();
        for &path in inputs {
            let output = folder.join(self.name(path)?);
            if let Some(other) = taken.insert(output.clone(), path) {
                let (one, other, output) = (other.display(), path.display(), output.display());
                let problem = "would have the same result";
                return Err(Failure::bad(format!(
                    "{one} and {other} {problem}, {output}; convert one of them by itself with -o"
                )));
            }
            outputs.push(output);
        }
        Ok(outputs)
    }

    /// Returns the name of a result: that of the input with the extension of the format.
    fn name(&self, path: &Path) -> Result<String, Failure> {
        let failure = |error| input::mesh_failure(path, &error);
        let format = Format::from_path(path).map_err(failure)?;
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if name == "-" {
            let problem = "standard input has no name for a result in a folder";
            return Err(Failure::bad(format!("-: {problem}; convert it by itself with -o")));
        }
        let cut = |name: &str, tail: &str| {
            let length = name.len().checked_sub(tail.len());
            let is_tail =
                |&at: &usize| name.get(at..).is_some_and(|end| end.eq_ignore_ascii_case(tail));
            length.filter(is_tail).map_or(name.to_owned(), |at| name[..at].to_owned())
        };
        let stem = cut(&cut(&name, ".gz"), &format!(".{format}"));
        match &self.format {
            Some(wanted) => Ok(format!("{stem}.{}", wanted.trim_start_matches('.'))),
            None if format == Format::Stl => Ok(format!("{stem}.obj")),
            None => Ok(name),
        }
    }
}
