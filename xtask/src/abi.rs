//! `cargo xtask abi [--write]`: the binary interface against the one that is written down (docs/abi.md).
//! Needs abidw and abidiff, of the package abigail-tools.

use crate::install::{Options, build, names::Names};
use crate::{Outcome, output, root};
use std::path::PathBuf;
use std::process::Command;

/// The interface as abidw sees it: functions, structs, sizes, offsets.
fn baseline() -> PathBuf {
    root().join("docs/abi/merev.xml")
}

/// A library with full debug information, which says what structs are made of; not optimised, to be built fast.
fn library() -> Outcome<PathBuf> {
    let options = Options { profile: "abi".into(), ..Options::default() };
    Ok(build(&options, &Names::new(false, env!("CARGO_PKG_VERSION")))?.join("libmerev.so"))
}

/// Writes the baseline anew.
pub fn write() -> Outcome {
    let mut abidw = Command::new("abidw");
    abidw.args(["--no-show-locs", "--no-corpus-path", "--no-comp-dir-path", "--no-elf-needed"]);
    let text = output(abidw.arg(library()?))?;
    std::fs::create_dir_all(baseline().parent().expect("a file in a folder"))?;
    Ok(std::fs::write(baseline(), portable(&text))?)
}

/// With numbers for the paths of compilation units, which are those of this machine and compiler, and without the units
/// that describe nothing.
fn portable(xml: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for line in xml.lines() {
        let tag = line.trim_start();
        if tag == "</abi-instr>" && lines.last().is_some_and(|l| l.trim_start().starts_with("<abi-instr ")) {
            lines.pop();
        } else if let Some((before, rest)) =
            line.split_once(" path='").filter(|_| tag.starts_with("<abi-instr "))
        {
            let after = rest.split_once('\'').map_or("", |(_, after)| after);
            lines.push(format!("{before} path='{}'{after}", lines.len()));
        } else {
            lines.push(line.to_owned());
        }
    }
    lines.join("\n") + "\n"
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_and_empty_units_are_left_out() {
        let xml = "<abi-corpus>\n  <abi-instr size='64' path='/a/b' language='C'>\n  </abi-instr>\n  \
                   <abi-instr path='/c'>\n    <x/>\n  </abi-instr>\n</abi-corpus>\n";
        assert_eq!(
            portable(xml),
            "<abi-corpus>\n  <abi-instr path='1'>\n    <x/>\n  </abi-instr>\n</abi-corpus>\n"
        );
    }

    /// What is written down belongs to the header: the same functions, and no path of the machine that wrote it.
    #[test]
    fn the_baseline_knows_the_functions() {
        let xml = std::fs::read_to_string(baseline()).unwrap();
        assert!(!xml.contains(" path='/") && xml.contains("name='mvBodyDef' size-in-bits="));
        let header = std::fs::read_to_string(root().join("include/merev.h")).unwrap();
        for name in xml.split("<elf-symbol name='").skip(1).filter_map(|piece| piece.split('\'').next()) {
            assert!(header.contains(&format!("{name}(")), "{name} is gone from merev.h");
        }
    }
}
