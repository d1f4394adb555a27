//! `cargo xtask abi [--write]`: the binary interface against the one that is written down (docs/abi.md).
//! Needs abidw and abidiff, of the package abigail-tools.

use crate::{Outcome, output, root, run};
use std::path::PathBuf;
use std::process::Command;

/// The interface as abidw sees it: functions, structs, sizes, offsets.
fn baseline() -> PathBuf {
    root().join("docs/abi/merev.xml")
}

/// A library with full debug information, which says what structs are made of; not optimised, to be built fast.
fn library() -> Outcome<PathBuf> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(root()).args(["rustc", "--quiet", "-p", "merev", "--lib", "--crate-type", "cdylib"]);
    run(cargo.args(["--profile", "abi", "--target-dir"]).arg(root().join("target")))?;
    Ok(root().join("target/abi/libmerev.so"))
}

/// Writes the baseline anew.
pub fn write() -> Outcome {
    std::fs::create_dir_all(baseline().parent().expect("a file in a folder"))?;
    let mut abidw = Command::new("abidw");
    abidw.args(["--no-show-locs", "--no-corpus-path", "--no-comp-dir-path", "--out-file"]).arg(baseline());
    run(abidw.arg(library()?))
}

/// Fails if a program built against the baseline might not work with the library of today.
pub fn check() -> Outcome {
    let library = library()?;
    let mut abidiff = Command::new("abidiff");
    abidiff.args(["--no-added-syms", "--no-show-locs"]).arg(baseline()).arg(&library);
    match output(&mut abidiff) {
        Ok(_) => {
            println!("the binary interface holds what docs/abi/merev.xml says");
            Ok(())
        }
        Err(e) => {
            Err(format!("{e}\nThe binary interface has changed; docs/abi.md says what may change when.")
                .into())
        }
    }
}
