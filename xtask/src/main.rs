//! Chores of the repository: `cargo xtask header [--check]`, `cargo xtask tables [--check]`,
//! `cargo xtask migration [--check]`.

use std::path::PathBuf;
use std::process::ExitCode;

mod csv;
mod header;
mod migration;
mod tables;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let done = match args[..] {
        ["header"] => header::write(),
        ["header", "--check"] => header::check(),
        ["migration"] => migration::write(),
        ["migration", "--check"] => migration::check(),
        ["tables"] => tables::write(),
        ["tables", "--check"] => tables::check(),
        _ => Err("usage: xtask header [--check] | migration [--check] | tables [--check]".into()),
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
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}
