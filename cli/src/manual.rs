//! `triquad completions` and `triquad man`: the arguments in other forms.

use clap::{Command, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man;

use crate::failure::Failure;
use crate::stdio;

/// Print the completions of a shell
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
    triquad completions bash > ~/.local/share/bash-completion/completions/triquad\n  \
    triquad completions zsh > \"${fpath[1]}/_triquad\"\n  \
    triquad completions fish > ~/.config/fish/completions/triquad.fish")]
pub struct Completions {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

/// Print a manual page, for man
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  triquad man | man -l -\n  \
                        triquad man convert > ~/.local/share/man/man1/triquad-convert.1")]
pub struct Manual {
    /// The verb whose page is wanted; without it, the page of the whole tool
    #[arg(value_name = "VERB")]
    verb: Option<String>,
}

/// Prints completions.
pub fn print_completions<A: CommandFactory>(arguments: &Completions) -> Result<(), Failure> {
    let mut script = Vec::new();
    let mut tool = A::command().name("triquad");
    clap_complete::generate(arguments.shell, &mut tool, "triquad", &mut script);
    stdio::say_by(|out| out.write_all(&script))
}

/// Prints a manual page.
pub fn print_manual<A: CommandFactory>(arguments: &Manual) -> Result<(), Failure> {
    let mut tool = A::command().name("triquad").disable_help_subcommand(true);
    tool.build();
    let page = match &arguments.verb {
        None => tool,
        Some(verb) => find(&tool, verb)?,
    };
    let mut text = Vec::new();
    Man::new(page).render(&mut text).map_err(|error| Failure::bad(error.to_string()))?;
    stdio::say_by(|out| out.write_all(&text))
}

fn find(tool: &Command, verb: &str) -> Result<Command, Failure> {
    let known = || tool.get_subcommands().map(Command::get_name).collect::<Vec<_>>().join(", ");
    let found = tool.find_subcommand(verb).cloned();
    found.ok_or_else(|| Failure::bad(format!("{verb}: no such verb; use one of: {}", known())))
}
