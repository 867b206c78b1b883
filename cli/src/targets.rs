//! The files that a verb writes: opened before the work starts, complete or absent afterwards.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::atomic_file::AtomicFile;
use triquad::mesh::{Format, Mesh, Output, io_remedy};

use crate::failure::Failure;
use crate::input::Fate;
use crate::{input, stdio};

/// Names of the files to read and to write; `-` is standard input or output.
#[derive(Clone, Copy)]
pub struct Paths<'a> {
    pub input: &'a Path,
    pub output: Option<&'a Path>,
    /// A second mesh: triangles.
    pub triangles: Option<&'a Path>,
    pub stats: Option<&'a Path>,
    pub certificate: Option<&'a Path>,
    /// Edges given up.
    pub given_up: Option<&'a Path>,
}

impl<'a> Paths<'a> {
    /// Returns paths of which only the input is named.
    pub fn of(input: &'a Path) -> Self {
        let none = None;
        Self {
            input,
            output: none,
            triangles: none,
            stats: none,
            certificate: none,
            given_up: none,
        }
    }

    /// Returns the options that name files to write, in the order of their names here.
    fn targets(&self) -> [(&'static str, Option<&'a Path>); 5] {
        [
            ("-o", self.output),
            ("--write-triangulation", self.triangles),
            ("--stats", self.stats),
            ("--certificate", self.certificate),
            ("--given-up", self.given_up),
        ]
    }
}

/// Meshes and statistics to be written.
pub struct Targets<'a> {
    paths: Paths<'a>,
    mesh: Option<Output>,
    triangles: Option<Output>,
    stats: Option<TextTarget<'a>>,
    certificate: Option<TextTarget<'a>>,
    given_up: Option<TextTarget<'a>>,
}

impl<'a> Targets<'a> {
    /// Opens the files. Refuses names that mean the same file.
    pub fn open(paths: Paths<'a>) -> Result<Self, Failure> {
        refuse_shared_files(paths)?;
        let open_mesh =
            |path: &Path| Output::create(path).map_err(|error| input::mesh_failure(path, &error));
        Ok(Self {
            paths,
            mesh: paths.output.map(open_mesh).transpose()?,
            triangles: paths.triangles.map(open_mesh).transpose()?,
            stats: paths.stats.map(TextTarget::open).transpose()?,
            certificate: paths.certificate.map(TextTarget::open).transpose()?,
            given_up: paths.given_up.map(TextTarget::open).transpose()?,
        })
    }

    /// Writes the mesh, if requested.
    pub fn write_mesh(&mut self, mesh: &Mesh) -> Result<(), Failure> {
        write_to(self.mesh.take(), self.paths.output, mesh)
    }

    /// Writes the triangles, if requested.
    pub fn write_triangles(&mut self, mesh: &Mesh) -> Result<(), Failure> {
        write_to(self.triangles.take(), self.paths.triangles, mesh)
    }

    /// Writes the certificate, if requested.
    pub fn write_certificate(
        &mut self,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Failure> {
        self.certificate.take().map_or(Ok(()), |target| target.write(write))
    }

    /// Writes edges as pairs of vertices counted from 1, if requested.
    pub fn write_given_up(&mut self, edges: &[[u32; 2]]) -> Result<(), Failure> {
        let Some(target) = self.given_up.take() else { return Ok(()) };
        target.write(|out| {
            let number = |v: u32| u64::from(v) + 1;
            edges.iter().try_for_each(|&[a, b]| writeln!(out, "{} {}", number(a), number(b)))
        })
    }

    /// Writes the statistics as JSON, if requested.
    fn write_stats(&mut self, stats: &impl Serialize) -> Result<(), Failure> {
        let Some(target) = self.stats.take() else { return Ok(()) };
        let json = serde_json::to_string_pretty(stats)
            .map_err(|error| Failure::bad(format!("{}: {error}", target.path.display())))?;
        target.write(|out| writeln!(out, "{json}"))
    }

    /// Writes the statistics, then prints what was not carried over and the summary. In this order
    /// a failure stays a single line.
    pub fn finish(self, stats: &impl Serialize, fate: &Fate, summary: &str) -> Result<(), Failure> {
        let is_nothing = self.paths.output.is_none() && self.paths.triangles.is_none();
        let tail = if is_nothing { "; nothing written: no -o" } else { "" };
        self.finish_without_mesh(stats, fate, &format!("{summary}{tail}"))
    }

    /// Does the same where there is no mesh to be written.
    pub fn finish_without_mesh(
        mut self,
        stats: &impl Serialize,
        fate: &Fate,
        summary: &str,
    ) -> Result<(), Failure> {
        let Paths { input, output, .. } = self.paths;
        self.write_stats(stats)?;
        fate.tell(input);
        let target = output.filter(|&path| !is_stdio(path));
        let target = target.map(|path| format!(" -> {}", path.display())).unwrap_or_default();
        self.report(&stdio::one_line(&format!("{}{target}: {summary}", input.display())))
    }

    /// Returns whether the mesh goes to a format without attributes.
    pub fn drops_attributes(&self) -> bool {
        let format = self.paths.output.and_then(|path| Format::from_path(path).ok());
        format.is_some_and(|format| format != Format::Obj)
    }

    /// Prints the summary on standard error if standard output takes a mesh or statistics.
    fn report(&self, line: &str) -> Result<(), Failure> {
        if self.paths.targets().into_iter().filter_map(|target| target.1).any(is_stdio) {
            stdio::note(line);
            Ok(())
        } else {
            stdio::summarise(line)
        }
    }
}

/// A text to be written, complete or not at all; `-` is standard output.
struct TextTarget<'a> {
    path: &'a Path,
    /// None is standard output.
    file: Option<AtomicFile>,
}

impl<'a> TextTarget<'a> {
    fn open(path: &'a Path) -> Result<Self, Failure> {
        let file = match is_stdio(path) {
            true => None,
            false => Some(AtomicFile::create(path).map_err(|error| text_failure(path, &error))?),
        };
        Ok(Self { path, file })
    }

    fn write(self, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
        let Some(mut file) = self.file else { return stdio::say_by(write) };
        let written = write(&mut file).and_then(|()| file.commit());
        written.map_err(|error| text_failure(self.path, &error))
    }
}

fn write_to(output: Option<Output>, path: Option<&Path>, mesh: &Mesh) -> Result<(), Failure> {
    let (Some(output), Some(path)) = (output, path) else { return Ok(()) };
    output.write(mesh).map_err(|error| input::mesh_failure(path, &error))
}

/// Refuses targets that would mix, overwrite each other or overwrite the input.
fn refuse_shared_files(paths: Paths<'_>) -> Result<(), Failure> {
    let options = paths.targets().into_iter();
    let targets: Vec<_> = options.filter_map(|(option, path)| Some((option, path?))).collect();
    for (i, &(option, one)) in targets.iter().enumerate() {
        for &(other, path) in &targets[i + 1..] {
            if is_stdio(one) && is_stdio(path) {
                return Err(Failure::bad(format!(
                    "{option} - and {other} - would mix on standard output; send one of them to a \
                     file"
                )));
            }
            refuse_overwriting(one, other, path)?;
        }
        refuse_overwriting(paths.input, option, one)?;
    }
    Ok(())
}

/// Refuses `path`, given to `option`, if it is the file `kept`.
fn refuse_overwriting(kept: &Path, option: &str, path: &Path) -> Result<(), Failure> {
    if is_stdio(path) || identity(path).is_none_or(|file| identity(kept) != Some(file)) {
        return Ok(());
    }
    let problem = "would overwrite the mesh of the same name; give it a file of its own";
    Err(Failure::bad(format!("{}: {option} {problem}", path.display())))
}

/// Returns the canonical path of `path`, or of its folder if the file does not exist yet.
fn identity(path: &Path) -> Option<PathBuf> {
    let through_folder = || {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        Some(folder.unwrap_or(Path::new(".")).canonicalize().ok()?.join(path.file_name()?))
    };
    path.canonicalize().ok().or_else(through_folder)
}

fn is_stdio(path: &Path) -> bool {
    path.as_os_str() == "-"
}

fn text_failure(path: &Path, error: &std::io::Error) -> Failure {
    let problem = input::system_problem(error);
    Failure::bad(format!("{}: {problem}; {}", path.display(), io_remedy(error)))
}
