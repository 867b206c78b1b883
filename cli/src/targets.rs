//! The files that a verb writes: opened before the work starts, complete or absent afterwards.

use std::io::Write;
use std::path::{Path, PathBuf};

use serde::Serialize;
use triquad::atomic_file::AtomicFile;
use triquad::mesh::{Format, Mesh, Output, io_remedy};

use crate::failure::Failure;
use crate::{input, stdio};

/// Names of the files to read and to write; `-` is standard input or output.
#[derive(Clone, Copy)]
pub struct Paths<'a> {
    pub input: &'a Path,
    pub output: Option<&'a Path>,
    /// A second mesh: triangles.
    pub triangles: Option<&'a Path>,
    pub stats: Option<&'a Path>,
}

/// Meshes and statistics to be written.
pub struct Targets<'a> {
    paths: Paths<'a>,
    mesh: Option<Output>,
    triangles: Option<Output>,
    stats: Option<AtomicFile>,
}

impl<'a> Targets<'a> {
    /// Opens the files. Refuses names that mean the same file.
    pub fn open(paths: Paths<'a>) -> Result<Self, Failure> {
        refuse_shared_files(paths)?;
        let open_mesh =
            |path: &Path| Output::create(path).map_err(|error| input::mesh_failure(path, &error));
        let open_stats =
            |path: &Path| AtomicFile::create(path).map_err(|error| stats_failure(path, &error));
        Ok(Self {
            paths,
            mesh: paths.output.map(open_mesh).transpose()?,
            triangles: paths.triangles.map(open_mesh).transpose()?,
            stats: paths.stats.filter(|&path| !is_stdio(path)).map(open_stats).transpose()?,
        })
    }

    /// Writes the mesh, if it was asked for.
    pub fn write_mesh(&mut self, mesh: &Mesh) -> Result<(), Failure> {
        write_to(self.mesh.take(), self.paths.output, mesh)
    }

    /// Writes the triangles, if they were asked for.
    pub fn write_triangles(&mut self, mesh: &Mesh) -> Result<(), Failure> {
        write_to(self.triangles.take(), self.paths.triangles, mesh)
    }

    /// Writes the statistics as JSON, if they were asked for.
    fn write_stats(&mut self, stats: &impl Serialize) -> Result<(), Failure> {
        let Some(path) = self.paths.stats else { return Ok(()) };
        let json = serde_json::to_string_pretty(stats)
            .map_err(|error| Failure::bad(format!("{}: {error}", path.display())))?;
        match self.stats.take() {
            None => stdio::say(&json),
            Some(mut file) => {
                let written = writeln!(file, "{json}").and_then(|()| file.commit());
                written.map_err(|error| stats_failure(path, &error))
            }
        }
    }

    /// Writes the statistics, then prints what was not carried over and the summary. In this order
    /// a failure stays a single line.
    pub fn finish(
        self,
        stats: &impl Serialize,
        left_out: &[String],
        summary: &str,
    ) -> Result<(), Failure> {
        let is_nothing = self.paths.output.is_none() && self.paths.triangles.is_none();
        let tail = if is_nothing { "; nothing written: no -o" } else { "" };
        self.finish_without_mesh(stats, left_out, &format!("{summary}{tail}"))
    }

    /// Does the same where there is no mesh to be written.
    pub fn finish_without_mesh(
        mut self,
        stats: &impl Serialize,
        left_out: &[String],
        summary: &str,
    ) -> Result<(), Failure> {
        let Paths { input, output, .. } = self.paths;
        self.write_stats(stats)?;
        input::tell_left_out(input, left_out);
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
        let Paths { output, triangles, stats, .. } = self.paths;
        if [output, triangles, stats].into_iter().flatten().any(is_stdio) {
            stdio::complain(line);
            Ok(())
        } else {
            stdio::say(line)
        }
    }
}

fn write_to(output: Option<Output>, path: Option<&Path>, mesh: &Mesh) -> Result<(), Failure> {
    let (Some(output), Some(path)) = (output, path) else { return Ok(()) };
    output.write(mesh).map_err(|error| input::mesh_failure(path, &error))
}

/// Refuses targets that would mix, overwrite each other or overwrite the input.
fn refuse_shared_files(paths: Paths<'_>) -> Result<(), Failure> {
    let Paths { input, output, triangles, stats } = paths;
    let options = [("-o", output), ("--write-triangulation", triangles), ("--stats", stats)];
    let targets: Vec<_> =
        options.into_iter().filter_map(|(option, path)| Some((option, path?))).collect();
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
        refuse_overwriting(input, option, one)?;
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

fn stats_failure(path: &Path, error: &std::io::Error) -> Failure {
    Failure::bad(format!(
        "{}: {}; {}",
        path.display(),
        input::system_problem(error),
        io_remedy(error)
    ))
}
