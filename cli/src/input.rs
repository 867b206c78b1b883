//! Reads input meshes; words what is wrong with them.

use std::path::Path;

use triquad::counted::counted;
use triquad::mesh::{Attributes, Format, MeshError, Reader, refuse_endless};
use triquad::triangulation::OpenTriangulation;
use triquad::{Element, Law, Mesh, Survey, Triangulation};

use crate::failure::{Facts, Failure};
use crate::remedies::Way;
use crate::{remedies, shell, stdio};

/// Options of reading a mesh.
#[derive(clap::Args, Clone, Copy, Default)]
pub struct Reading {
    /// Join vertices at equal coordinates, or at most EPS apart; the first of them keeps its place
    #[arg(long, value_name = "EPS", num_args = 0..=1, default_missing_value = "0")]
    #[arg(value_parser = distance)]
    pub weld: Option<f64>,
    /// Greatest size of an expanded gzip file, such as 40G [default: 256 MiB, or 100 times the size
    /// of the file if that is more]
    #[arg(long, value_name = "BYTES", value_parser = bytes)]
    pub max_expanded: Option<u64>,
}

/// Options that turn a mesh into a triangulation.
#[derive(clap::Args, Clone, Copy, Default)]
pub struct Repairs {
    /// Drop faces that repeat a corner, and faces that repeat an earlier one
    #[arg(long)]
    pub clean: bool,
    /// Flip faces until neighbours agree on orientation
    #[arg(long)]
    pub orient: bool,
    /// First cut faces of four or more corners into triangles, the best-shaped ones that make no
    /// edge twice
    #[arg(long)]
    pub triangulate: bool,
    #[command(flatten)]
    pub reading: Reading,
}

impl Repairs {
    /// Returns the number of repairs that are on.
    pub fn number(&self) -> usize {
        let Self { clean, orient, triangulate, reading } = self;
        let on = [*clean, *orient, *triangulate, reading.weld.is_some()];
        on.into_iter().filter(|&is_on| is_on).count()
    }

    /// Returns the options as they are typed, those of reading included.
    pub fn words(&self) -> Vec<String> {
        let Self { clean, orient, triangulate, reading } = *self;
        let expanded = reading.max_expanded.map(|bytes| format!("--max-expanded {bytes}"));
        let weld = reading.weld.map(|distance| match distance {
            0.0 => "--weld".into(),
            _ => format!("--weld {distance:e}"),
        });
        let others = [(clean, "--clean"), (triangulate, "--triangulate"), (orient, "--orient")];
        let others = others.into_iter().filter(|(is_on, _)| *is_on);
        let others = others.map(|(_, option)| option.to_owned());
        expanded.into_iter().chain(weld).chain(others).collect()
    }

    /// Returns the file as a word of a shell, and behind it the options.
    fn behind(&self, path: &Path) -> String {
        let mut words = vec![shell::word(path)];
        words.extend(self.words());
        words.join(" ")
    }
}

/// Parses the distance of `--weld`.
fn distance(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| format!("'{text}' is not a distance"))?;
    let is_distance = value >= 0.0 && value.is_finite();
    is_distance.then_some(value).ok_or_else(|| format!("'{text}' is not a distance from 0 on"))
}

/// Parses a number of bytes: with K, M, G or T, so many times 1024 bytes and so on.
fn bytes(text: &str) -> Result<u64, String> {
    let unit = |c: char| "KMGT".find(c.to_ascii_uppercase()).map(|power| 10 * (power as u32 + 1));
    let (digits, shift) = match text.chars().last().and_then(unit) {
        Some(shift) => (&text[..text.len() - 1], shift),
        None => (text, 0),
    };
    let bytes = digits.parse::<u64>().ok().and_then(|count| count.checked_mul(1 << shift));
    bytes.ok_or_else(|| format!("'{text}' is not a number of bytes, such as 5000000 or 40G"))
}

/// Reads a mesh, and welds it if requested.
pub fn read(path: &Path, reading: Reading) -> Result<Mesh, Failure> {
    let reader = reading.max_expanded.map_or(Reader::new(), |max| Reader::new().max_expanded(max));
    let mut mesh = reader.read(path).map_err(|error| mesh_failure(path, &error))?;
    if let Some(distance) = reading.weld {
        let dropped = mesh.weld(distance).dropped_faces;
        if dropped > 0 && mesh.faces().is_empty() {
            let path = path.display();
            let problem = "--weld leaves no face at this distance";
            return Err(Failure::bad(format!("{path}: {problem}; give a smaller distance")));
        }
    }
    Ok(mesh)
}

/// Reads a text: costs, edges, a certificate.
pub fn read_text(path: &Path) -> Result<String, Failure> {
    let text = refuse_endless(path).and_then(|()| std::fs::read_to_string(path));
    text.map_err(|error| {
        let remedy = "check the path and its permissions";
        Failure::bad(format!("{}: {error}; {remedy}", path.display()))
    })
}

/// What became of the content of a file, in words.
#[derive(Default)]
pub struct Fate {
    /// What is not carried over.
    pub left_out: Vec<String>,
    /// What options have changed, each with its name.
    pub repairs: Vec<String>,
}

impl Fate {
    /// Returns what a mesh that was read and repaired has come to.
    pub fn of(mesh: &Mesh) -> Self {
        let by_option = |deed: &String| format!("--{deed}");
        let repairs = mesh.repairs().iter().map(by_option).collect();
        Self { left_out: mesh.left_out().to_vec(), repairs }
    }

    /// Returns the same for a result of positions and faces alone.
    pub fn of_faces(mesh: &Mesh) -> Self {
        let mut fate = Self::of(mesh);
        let names = mesh.attributes().map(Attributes::names).unwrap_or_default();
        fate.left_out.extend(names.into_iter().map(String::from));
        fate
    }

    /// Returns all of it, as `--stats` has it.
    pub fn all(&self) -> Vec<String> {
        [&self.left_out[..], &self.repairs].concat()
    }

    /// Prints it on standard error.
    pub fn tell(&self, path: &Path) {
        tell_left_out(path, &self.left_out);
        if !self.repairs.is_empty() {
            stdio::note(&format!("{}: note: {}", path.display(), self.repairs.join(", ")));
        }
    }
}

/// Prints on standard error the content of the file that is not carried over.
fn tell_left_out(path: &Path, left_out: &[String]) {
    /// Of more kinds only the number is told.
    const SHOWN: usize = 20;
    let mut shown = left_out[..left_out.len().min(SHOWN)].to_vec();
    if left_out.len() > SHOWN {
        shown.push(format!("{} more", left_out.len() - SHOWN));
    }
    if !shown.is_empty() {
        let what = shown.join(", ");
        stdio::note(&format!("{}: note: not carried over: {what}", path.display()));
    }
}

/// Reads a mesh that must be a triangulation of closed surfaces, after its repairs.
pub fn read_triangulation(path: &Path, repairs: Repairs) -> Result<Mesh, Failure> {
    let mut mesh = read(path, repairs.reading)?;
    build(path, &mut mesh, repairs)?;
    Ok(mesh)
}

/// Builds the triangulation of a mesh read from `path`, after its repairs.
pub fn build(path: &Path, mesh: &mut Mesh, repairs: Repairs) -> Result<Triangulation, Failure> {
    repair(path, mesh, repairs)?;
    let triangulation = build_oriented(mesh, repairs);
    triangulation
        .map_err(|survey| refusal(path, Some(mesh), &survey, repairs, Some(OpenWay::Elsewhere)))
}

/// Builds the triangulation, after faces are turned if requested.
pub fn build_oriented(mesh: &mut Mesh, repairs: Repairs) -> Result<Triangulation, Box<Survey>> {
    if repairs.orient { Triangulation::build_oriented(mesh) } else { Triangulation::build(mesh) }
}

/// A surface with its mesh.
pub enum Built {
    Closed(Triangulation),
    /// With boundary or one-sided, and what makes it so.
    Open(OpenTriangulation, Box<Survey>),
}

/// Reads a mesh that must be a triangulation of surfaces, closed or not, after its repairs.
pub fn read_surface(path: &Path, repairs: Repairs) -> Result<(Mesh, Built), Failure> {
    let mut mesh = read(path, repairs.reading)?;
    repair(path, &mut mesh, repairs)?;
    let mut survey = match build_oriented(&mut mesh, repairs) {
        Ok(triangulation) => return Ok((mesh, Built::Closed(triangulation))),
        Err(survey) => survey,
    };
    if !survey.is_open_surface(false) {
        // What is allowed is no reason, so it comes last.
        let is_allowed = |law| matches!(law, Law::NoBoundary | Law::Orientable);
        survey.violations.sort_by_key(|violation| is_allowed(violation.law));
        return Err(refusal(path, Some(&mesh), &survey, repairs, None));
    }
    let open = OpenTriangulation::build(&mesh);
    let open = open.map_err(|survey| refusal(path, Some(&mesh), &survey, repairs, None))?;
    Ok((mesh, Built::Open(open, survey)))
}

/// Drops faces and cuts polygons into triangles, as requested.
pub fn repair(path: &Path, mesh: &mut Mesh, repairs: Repairs) -> Result<(), Failure> {
    if repairs.clean {
        mesh.clean();
    }
    if !repairs.triangulate {
        return Ok(());
    }
    mesh.triangulate().map_err(|error| {
        let remedy = "the mesh may be sound: cut this face in another program";
        Failure::bad(format!("{}: {error}; {remedy}", path.display()))
    })
}

/// Makes the failure of a file that could not be read or written.
pub fn mesh_failure(path: &Path, error: &MeshError) -> Failure {
    let remedy = match error {
        MeshError::Expanded(_) => "if it is to be that large, raise the limit with --max-expanded",
        error => error.remedy(),
    };
    let (remedy, element) = (remedy.to_owned(), error.element());
    let problem = match error {
        MeshError::File { error, .. } => return mesh_failure(path, error),
        MeshError::Io(error) => system_problem(error),
        error => error.to_string(),
    };
    let failure = Failure::bad(format!("{}: {problem}; {remedy}", path.display()));
    let file = Some(path.display().to_string());
    failure.with(Facts { file, element, remedy: Some(remedy), ..Facts::default() })
}

/// Returns what an error of the operating system is, without its number.
pub fn system_problem(error: &std::io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or_default().to_owned()
}

/// What to say of a surface with boundary or one side that is refused as such.
#[derive(Clone, Copy)]
pub enum OpenWay {
    /// `convert` takes it.
    Convert,
    /// `convert` takes it, and this verb does not.
    Elsewhere,
    /// `check` takes it.
    Check,
}

impl OpenWay {
    /// Returns the remedy, for the options with which `convert` takes the mesh.
    fn remedy(self, path: &Path, repairs: Repairs, way: &Way) -> String {
        let beyond = way.beyond(repairs);
        let options = beyond.join(" ");
        match (self, beyond.len()) {
            (Self::Convert, 1) => {
                format!("{options} converts it and leaves over as few triangles as possible")
            }
            (Self::Convert, _) => {
                format!("{options} convert it and leave over as few triangles as possible")
            }
            (Self::Elsewhere, 1) => {
                let file = shell::word(path);
                format!("only 'triquad convert {file} {way}' and check take it as it is")
            }
            (Self::Elsewhere, _) => {
                format!("only 'triquad convert {} {way}' and check take it", shell::word(path))
            }
            (Self::Check, 1) => format!("{options} allows it"),
            (Self::Check, _) => format!("{options} allow it"),
        }
    }
}

/// Makes the failure of a mesh that is no triangulation: its first broken law, the number of
/// others, what to say if it can stay open, and the lines of the file that could not be read. The
/// remedy is better if the mesh is at hand.
pub fn refusal(
    path: &Path,
    mesh: Option<&Mesh>,
    survey: &Survey,
    repairs: Repairs,
    open: Option<OpenWay>,
) -> Failure {
    let first = &survey.violations[0];
    let others = match survey.violations.len() - 1 {
        0 => String::new(),
        more => {
            let file = repairs.behind(path);
            let more = counted(more, "other law is", "other laws are");
            format!(" (and {more} broken, see 'triquad info {file}')")
        }
    };
    // Readers of OBJ files expect numbers that count from 1.
    let from_one = match (Format::from_path(path), first.element) {
        (Ok(Format::Obj), _) | (_, Element::Mesh) => "",
        _ => ", counted from 1",
    };
    let name = first.law.name();
    let refused = mesh.map(|mesh| remedies::Refused::new(mesh, path, repairs));
    let mut remedy = match &refused {
        Some(refused) => refused.full_remedy(first),
        None => remedies::general(first.law, repairs).to_string(),
    };
    let way = match &refused {
        Some(refused) => refused.options(),
        None => survey.is_open_surface(repairs.orient).then_some(Way { repairs, is_open: true }),
    };
    if let (Some(open), Some(way)) = (open, way.filter(|way| way.is_open)) {
        remedy = format!("{remedy}; {}", open.remedy(path, repairs, &way));
    }
    let file = path.display().to_string();
    let unknown =
        mesh.and_then(Mesh::unknown_lines).map(|lines| format!("; not understood: {lines}"));
    let unknown = unknown.unwrap_or_default();
    let message = format!("{file}: {first}{from_one} [{name}]{others}; {remedy}{unknown}");
    let (law, element) = (Some(name), Some(first.element.to_string()));
    let (file, count, remedy) = (Some(file), Some(first.count), Some(remedy));
    Failure::bad(message).with(Facts { file, law, element, count, remedy })
}
