//! The command-line tool: parses arguments, calls the library and the laboratory, prints.
//!
//! Each verb is a file: `convert`, `irreducible`, `check`, `info`, `generate`, `simplify`, `plan`,
//! `run`, `merge`, `import`, `report`, `compare`, `paper`, `draw`; `completions` and `man` share
//! `manual`. The other files are shared by several verbs.
//!
//! Exit codes: 0 done; 1 a check failed, or a run did not end well; 2 bad input or usage; 130
//! interrupted. A failure is one line on standard error with the file, the place, the law and the
//! remedy. So is a refusal of memory (Linux).

mod aims;
mod attempt;
mod bad_runs;
mod certificate;
mod check;
mod compare;
mod comparison;
mod convert;
mod draw;
mod experiments;
mod failure;
mod fins;
mod formats;
mod generate;
#[cfg(target_os = "linux")]
mod huge_pages;
mod import;
mod info;
mod input;
mod interrupt;
mod irreducible;
mod machine;
mod manual;
mod merge;
mod names;
#[cfg(target_os = "linux")]
mod out_of_memory;
mod own_program;
mod paper;
mod plan;
mod progress;
mod reduction;
mod remedies;
mod report;
mod results_folder;
mod rim;
mod run;
mod several;
mod shell;
mod simplify;
#[cfg(target_os = "linux")]
mod stack;
mod stdio;
mod targets;
mod threads;
mod welding;

use std::ffi::OsString;
use std::num::NonZeroUsize;
use std::path::Path;
use std::process::ExitCode;
#[cfg(unix)]
use std::sync::Arc;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, CommandFactory, Parser, Subcommand};
use failure::Failure;
use formats::FORMATS;
use triquad_lab::nearest::likely;

#[cfg(target_os = "linux")]
#[global_allocator]
static ALLOCATOR: huge_pages::HugePages = huge_pages::HugePages;

/// All-quadrilateral meshes from triangle meshes of closed surfaces.
///
/// Pairs up edge-adjacent triangles, none left over, and removes the edge between the two of each
/// pair. Every vertex and every other edge stays, and every face is a quad. On a closed surface
/// this is always possible (Petersen's theorem).
#[derive(Parser)]
#[command(version, after_help = format!(
    "Formats: {FORMATS} .stl (read only), each also with .gz; '-' is any of them on standard input, \
     OBJ on standard output.\nExit codes: 0 done, 1 a check failed or a run did not end well, 2 \
     bad input or usage, 130 interrupted.\nMessages: vertices, edges and faces have numbers that \
     count from 1, in file order.\n\n\
     Example: triquad convert bunny.obj -o bunny-quads.obj"
))]
struct Arguments {
    /// Use N threads, by default one for each core; the results are the same
    #[arg(long, global = true, value_name = "N", help_heading = "Everywhere")]
    #[arg(value_parser = threads::count)]
    threads: Option<NonZeroUsize>,
    #[command(flatten)]
    voice: stdio::Voice,
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    Convert(Box<convert::Arguments>),
    Irreducible(irreducible::Arguments),
    Check(check::Arguments),
    Info(info::Arguments),
    Generate(generate::Arguments),
    Simplify(simplify::Arguments),
    Plan(plan::Arguments),
    Run(run::Arguments),
    Merge(merge::Arguments),
    Import(import::Arguments),
    Report(report::Arguments),
    Compare(compare::Arguments),
    Paper(paper::Arguments),
    Draw(draw::Arguments),
    Completions(manual::Completions),
    Man(manual::Manual),
}

/// Ends a run of an experiment with the process that started it, even if that is killed.
fn end_with_parent() {
    #[cfg(target_os = "linux")]
    if std::env::var_os(triquad_lab::experiment::process::RUN_VARIABLE).is_some() {
        use rustix::process::{Signal, set_parent_process_death_signal};
        // If this fails, a run of a killed experiment goes on until it is done.
        let _ = set_parent_process_death_signal(Some(Signal::KILL));
    }
}

/// Becomes the program that the arguments name, if an experiment has started this process for it:
/// the program then ends with the experiment too. Returns only if that is not so, or fails.
#[cfg(unix)]
fn become_foreign_program() -> Option<ExitCode> {
    use std::os::unix::process::CommandExt;
    use triquad_lab::experiment::process::{BECOME, RUN_VARIABLE};
    if std::env::var_os(RUN_VARIABLE).is_none_or(|value| value != BECOME) {
        return None;
    }
    let mut words = std::env::args_os().skip(1);
    let program = words.next()?;
    let error = std::process::Command::new(&program).args(words).env_remove(RUN_VARIABLE).exec();
    stdio::complain(&format!("{}: {error}", program.display()));
    // As a shell does.
    Some(ExitCode::from(127))
}

/// Makes a file that outgrows a limit (`ulimit -f`) an error of writing. The signal would end the
/// process.
#[cfg(unix)]
fn outlive_full_files() {
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

#[cfg(target_os = "linux")]
fn main() -> ExitCode {
    stack::with_enough(tool)
}

#[cfg(not(target_os = "linux"))]
fn main() -> ExitCode {
    tool()
}

/// Runs the verb that the arguments name.
fn tool() -> ExitCode {
    end_with_parent();
    #[cfg(unix)]
    if let Some(code) = become_foreign_program() {
        return code;
    }
    #[cfg(unix)]
    outlive_full_files();
    #[cfg(target_os = "linux")]
    out_of_memory::include_threads();
    interrupt::settle();
    let arguments = names::with_weld_values(std::env::args_os());
    let result = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => {
            stdio::settle(arguments.voice);
            threads::settle(arguments.threads);
            run(arguments.verb)
        }
        Err(error) => return explain_usage(&error),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            stdio::fail(&failure);
            ExitCode::from(failure.code)
        }
    }
}

fn run(verb: Verb) -> Result<(), Failure> {
    match verb {
        Verb::Convert(arguments) => convert::run(&arguments),
        Verb::Irreducible(arguments) => irreducible::run(&arguments),
        Verb::Check(arguments) => check::run(&arguments),
        Verb::Info(arguments) => info::run(&arguments),
        Verb::Generate(arguments) => generate::run(&arguments),
        Verb::Simplify(arguments) => simplify::run(&arguments),
        Verb::Plan(arguments) => plan::run(&arguments),
        Verb::Run(arguments) => run::run(&arguments),
        Verb::Merge(arguments) => merge::run(&arguments),
        Verb::Import(arguments) => import::run(&arguments),
        Verb::Report(arguments) => report::run(&arguments),
        Verb::Compare(arguments) => compare::run(&arguments),
        Verb::Paper(arguments) => paper::run(&arguments),
        Verb::Draw(arguments) => draw::run(&arguments),
        Verb::Completions(arguments) => manual::print_completions::<Arguments>(&arguments),
        Verb::Man(arguments) => manual::print_manual::<Arguments>(&arguments),
    }
}

/// Prints help as it is, and an error in the arguments as one line.
fn explain_usage(error: &clap::Error) -> ExitCode {
    let without_arguments = error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand;
    if without_arguments || !error.use_stderr() {
        return stdio::print_help(error, if without_arguments { 2 } else { 0 });
    }
    let text = error.to_string();
    let first = text.split("\n\n").next().unwrap_or_default();
    let words: Vec<&str> = first.trim_start_matches("error: ").split_whitespace().collect();
    // The arguments that say how to print were not parsed.
    let json = std::env::args_os().any(|argument| argument == "--json");
    stdio::settle(stdio::Voice { json, ..stdio::Voice::default() });
    let remedy = suggestion(error).unwrap_or_else(|| {
        let command = command_of(std::env::args_os().skip(1));
        format!("'{command} --help' explains")
    });
    let failure = Failure::bad(format!("{}; {remedy}", words.join(" ")));
    stdio::fail(&failure);
    ExitCode::from(failure.code)
}

/// Returns the command with the verbs that are among the arguments, for its help.
fn command_of(arguments: impl Iterator<Item = OsString>) -> String {
    let mut command = Arguments::command();
    let mut words = vec!["triquad".to_owned()];
    for argument in arguments {
        if let Some(verb) = command.find_subcommand(&argument) {
            words.push(verb.get_name().to_owned());
            command = verb.clone();
        }
    }
    words.join(" ")
}

/// Verbs of other programs, and ours.
const SYNONYMS_OF_VERBS: [(&str, &str); 8] = [
    ("render", "draw"),
    ("view", "draw"),
    ("show", "draw"),
    ("verify", "check"),
    ("validate", "check"),
    ("decimate", "simplify"),
    ("reduce", "simplify"),
    ("quadrangulate", "convert"),
];

/// Names of algorithms elsewhere, and those of ours that do the same or follow them.
const SYNONYMS_OF_VALUES: [(&str, &str); 4] =
    [("blossom", "best"), ("blossom-quad", "best"), ("greedy", "sg"), ("pulli-segal", "ps")];

/// Returns which verbs have the long option `given`, if any has.
fn verbs_with(given: &str) -> Option<String> {
    fn collect(command: &Command, path: &str, option: &str, verbs: &mut Vec<String>) {
        for verb in command.get_subcommands() {
            let path = format!("{path} {}", verb.get_name());
            let is_it = |arg: &Arg| arg.get_long() == Some(option) && !arg.is_hide_set();
            if verb.get_arguments().any(is_it) {
                verbs.push(path.trim_start().to_owned());
            }
            collect(verb, &path, option, verbs);
        }
    }
    let option = given.strip_prefix("--")?;
    let mut verbs = Vec::new();
    collect(&Arguments::command(), "", option, &mut verbs);
    (!verbs.is_empty()).then(|| verbs.join(", "))
}

/// Returns what was meant, if that can be guessed.
fn suggestion(error: &clap::Error) -> Option<String> {
    let first = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        Some(ContextValue::Strings(texts)) => texts.first().map(String::as_str),
        _ => None,
    };
    // An option of other verbs, unless this verb has one that begins so: '--out' for '--output'.
    if let Some(option) = first(ContextKind::InvalidArg)
        && error.kind() == ErrorKind::UnknownArgument
        && first(ContextKind::SuggestedArg).is_none_or(|similar| !similar.starts_with(option))
        && let Some(verbs) = verbs_with(option)
    {
        return Some(format!("{option} is an option of {verbs}"));
    }
    // A file in the place of a verb: its name may be like that of a verb.
    if let Some(file) = first(ContextKind::InvalidSubcommand)
        && triquad::mesh::Format::from_path(file).is_ok()
    {
        let file = shell::word(Path::new(file));
        return Some(format!("did you mean 'triquad convert {file}'?"));
    }
    let verb = first(ContextKind::InvalidSubcommand);
    let value = first(ContextKind::InvalidValue);
    let synonym = |word: Option<&str>, synonyms: &[(&str, &'static str)]| {
        let word = word?.to_lowercase();
        synonyms.iter().find(|(other, _)| *other == word).map(|&(_, meant)| meant)
    };
    let meant = synonym(verb, &SYNONYMS_OF_VERBS).map(str::to_owned);
    let meant = meant.or_else(|| {
        let Some(ContextValue::Strings(known)) = error.get(ContextKind::ValidValue) else {
            return None;
        };
        let synonym = synonym(value, &SYNONYMS_OF_VALUES);
        let synonym = synonym.filter(|meant| known.iter().any(|name| name == meant));
        let near = || likely(value?, known.iter().map(String::as_str));
        synonym.or_else(near).map(str::to_owned)
    });
    if let Some(meant) = meant {
        return Some(format!("did you mean '{meant}'?"));
    }
    let similar =
        [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    let similar = similar.into_iter().find_map(first)?;
    Some(format!("did you mean '{similar}'?"))
}
