//! Chores of the repository: run `cargo xtask` to see them.

use std::error::Error;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

mod abi;
mod check_install;
mod cpp;
mod csv;
#[cfg(feature = "header")]
mod header;
mod install;
mod migration;
mod tables;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let done = match args[..] {
        #[cfg(feature = "header")]
        ["header"] => header::write().and_then(|()| cpp::write()),
        #[cfg(feature = "header")]
        ["header", "--check"] => header::check().and_then(|()| cpp::check()),
        ["tables"] => tables::write(),
        ["tables", "--check"] => tables::check(),
        ["migration"] => migration::write(),
        ["migration", "--check"] => migration::check(),
        ["install", ref options @ ..] => install::Options::parse(options).and_then(|o| install::install(&o)),
        ["check-install", ref options @ ..] => check_install::check(options),
        ["abi"] => abi::check(),
        ["abi", "--write"] => abi::write(),
        _ => Err(format!(
            "usage: xtask header [--check]\n       xtask tables [--check]\n       xtask migration [--check]\n       xtask {}\n       \
             xtask check-install [--profile abi]\n       xtask abi [--write]",
            install::USAGE
        )
        .into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("{e}");
            ExitCode::FAILURE
        }
    }
}

/// The root of the repository.
fn root() -> PathBuf {
    // Cargo says where it runs this from; the place it was compiled in may be another by now.
    let own = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    PathBuf::from(own).parent().expect("xtask is below the root").to_owned()
}

/// Runs a command; its output is shown.
fn run(command: &mut Command) -> Outcome {
    match command.status().map_err(|e| format!("{command:?}: {e}"))? {
        status if status.success() => Ok(()),
        status => Err(format!("{command:?}: {status}").into()),
    }
}

/// Runs a command for what it prints.
fn output(command: &mut Command) -> Outcome<String> {
    let out = command.output().map_err(|e| format!("{command:?}: {e}"))?;
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    match out.status.success() {
        true => Ok(text),
        false => {
            Err(format!("{command:?}: {}\n{text}{}", out.status, String::from_utf8_lossy(&out.stderr)).into())
        }
    }
}
