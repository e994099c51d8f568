//! The command line: the only room that prints.

mod args;
mod check;
mod clock;
mod compare;
mod crosscheck;
pub mod diagnostic;
mod excerpt;
mod exit;
mod explain;
mod golden;
mod in_order;
mod interrupt;
mod json;
mod output;
mod povray;
mod progress;
mod render;
mod scene;
mod stack;
mod streams;
mod syntax;
mod trade;

use args::{Cli, Command};
use clap::{CommandFactory, Parser};
use exit::{Exit, Failure};
use std::ffi::OsString;
use syntax::Syntax;

/// Carries out a command line (the program's name first) and gives the process's exit code.
pub fn run(words: Vec<OsString>) -> u8 {
    let result = match syntax::of(&words) {
        Ok(Syntax::Glint(words)) => glint(words),
        Ok(Syntax::Povray(words)) => povray::run(&words),
        Err(failure) => Err(failure),
    };
    let exit = result.unwrap_or_else(|failure| {
        streams::Streams::new(false).complain(&failure);
        failure.exit
    });
    exit.code()
}

fn glint(words: Vec<OsString>) -> Result<Exit, Failure> {
    let cli = match Cli::try_parse_from(words) {
        Ok(cli) => cli,
        Err(error) => {
            // Help and version go to standard output and are no errors.
            let _ = error.print();
            return Ok(if error.use_stderr() { Exit::Usage } else { Exit::Done });
        }
    };
    match cli.command {
        Command::Render(args) => render::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Crosscheck(args) => crosscheck::run(&args),
        Command::Golden(command) => golden::run(&command),
        Command::Trade(args) => trade::run(&args),
        Command::Compare(args) => compare::run(&args),
        Command::Completions(args) => {
            clap_complete::generate(args.shell, &mut Cli::command(), "glint", &mut std::io::stdout());
            Ok(Exit::Done)
        }
        Command::Explain(args) => explain::run(&args),
    }
}
