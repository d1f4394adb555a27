//! A static library that minds its own business.
//!
//! A Rust static library carries the standard library, and two of them in one program define the same symbols
//! (rust-lang/rust#44322). So the archive is linked into one object, of which only the C functions are visible.

use crate::{Outcome, output, run};
use std::path::Path;
use std::process::Command;

/// Writes `to`: what the functions called mv... of `from` need, with nothing else visible.
pub fn isolate(from: &Path, to: &Path) -> Outcome {
    let object = from.with_extension("o");
    let mut link = Command::new("ld");
    // Groups are dissolved: a group of the same name in another object would take its place.
    link.args(["-r", "--gc-sections", "--force-group-allocation", "-o"]).arg(&object);
    for function in functions(from)? {
        link.arg("-u").arg(function);
    }
    run(link.arg(from))?;
    let mut hide = Command::new("objcopy");
    // Bitcode is of no use to C, and ar with LLVM's plugin stumbles over it.
    hide.args(["--strip-debug", "-R", ".llvmbc", "-R", ".llvmcmd", "--wildcard", "--keep-global-symbol=mv*"]);
    run(hide.arg(&object))?;
    let _ = std::fs::remove_file(to);
    // D: no times in the archive, so that the same source gives the same bytes.
    run(Command::new("ar").arg("rcsD").arg(to).arg(&object))
}

/// The C functions an archive or object defines, sorted.
pub fn functions(library: &Path) -> Outcome<Vec<String>> {
    let listing = output(Command::new("nm").args(["-g", "--defined-only"]).arg(library))?;
    let mut names: Vec<String> = listing
        .lines()
        .filter_map(|line| line.split_once(" T ").map(|(_, name)| name.to_owned()))
        .filter(|name| name.starts_with("mv"))
        .collect();
    names.sort();
    names.dedup();
    if names.is_empty() {
        return Err(format!("no function called mv... in {}", library.display()).into());
    }
    Ok(names)
}
