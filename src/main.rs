use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(glint::cli::run(std::env::args_os().collect()))
}
