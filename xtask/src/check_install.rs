//! `cargo xtask check-install`: installs into a scratch folder and uses the library in every way the README names.
//! Needs a C compiler, binutils, cmake and pkg-config.

use crate::install::{Options, install};
use crate::{Outcome, output, root, run};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Examples that simulate too much for a library without optimisation, where they are built but not run.
const HEAVY: [&str; 3] = ["07_methods", "09_ragdoll", "10_vehicle"];

/// With the same options as `install`, but for the places.
pub fn check(words: &[&str]) -> Outcome {
    let scratch = root().join("target/check-install");
    let _ = fs::remove_dir_all(&scratch);
    fs::create_dir_all(&scratch)?;
    let mut options = Options::parse(words)?;
    options.prefix = "/opt/merev".into();
    options.destdir = scratch.join("stage");
    install(&options)?;

    // Everything below uses the files in a place that the installation never heard of.
    let prefix = scratch.join("moved");
    fs::rename(options.staged(""), &prefix)?;
    let check = Check {
        lib: prefix.join(&options.libdir),
        double: options.double(),
        skips: if options.profile == "abi" { &HEAVY } else { &[] },
        scratch,
        prefix,
    };
    check.symbols()?;
    check.pkg_config()?;
    check.golden_hash()?;
    check.beside_another_rust_library()?;
    check.cmake(words)?;
    println!("the installation is fine");
    Ok(())
}

struct Check {
    scratch: PathBuf,
    prefix: PathBuf,
    lib: PathBuf,
    double: bool,
    /// What is built but not run.
    skips: &'static [&'static str],
}

impl Check {
    fn name(&self) -> &'static str {
        if self.double { "merev_f64" } else { "merev" }
    }

    /// Both libraries show the functions of the header, all of them and nothing else; the shared one has its SONAME.
    fn symbols(&self) -> Outcome {
        let declared = declared(&fs::read_to_string(self.prefix.join("include/merev.h"))?);
        let shared = self.lib.join(format!("lib{}.so", self.name()));
        let archive = self.lib.join(format!("lib{}.a", self.name()));
        for (what, arguments, library) in
            [("shared", ["-D", "--defined-only"], &shared), ("static", ["-g", "--defined-only"], &archive)]
        {
            let listing = output(Command::new("nm").args(arguments).arg(library))?;
            let defined: BTreeSet<String> = listing
                .lines()
                .filter(|line| line.split_whitespace().count() == 3)
                .filter_map(|line| line.split_whitespace().last().map(str::to_owned))
                .collect();
            let odd: Vec<_> = defined.symmetric_difference(&declared).collect();
            if !odd.is_empty() || declared.len() < 200 {
                return Err(format!("the {what} library and the header differ: {odd:?}").into());
            }
            println!("{what}: {} functions, as declared, and nothing else", defined.len());
        }
        let real = fs::canonicalize(&shared)?;
        let dynamic = output(Command::new("readelf").arg("-d").arg(&real))?;
        let file = real.file_name().unwrap().to_str().unwrap().to_owned();
        let soname = dynamic.lines().find(|l| l.contains("(SONAME)")).unwrap_or_default();
        let soname = soname.split(['[', ']']).nth(1).unwrap_or_default();
        match !soname.is_empty() && file.starts_with(soname) && self.lib.join(soname).exists() {
            true => Ok(()),
            false => Err(format!("{file} has the SONAME {soname:?}").into()),
        }
    }

    /// What pkg-config says, as words.
    fn flags(&self, arguments: &[&str]) -> Outcome<Vec<String>> {
        let mut command = Command::new("pkg-config");
        command.env("PKG_CONFIG_PATH", self.lib.join("pkgconfig")).args(arguments).arg(self.name());
        Ok(output(&mut command)?.split_whitespace().map(str::to_owned).collect())
    }

    fn run(&self, program: &Path) -> Outcome {
        output(Command::new(program).env("LD_LIBRARY_PATH", &self.lib)).map(|_| ())
    }

    /// All examples by pkg-config, and some with nothing shared at all.
    fn pkg_config(&self) -> Outcome {
        let shared = self.flags(&["--cflags", "--libs"])?;
        let all = [vec!["-static".into()], self.flags(&["--static", "--cflags", "--libs"])?].concat();
        let mut examples = std::fs::read_dir(root().join("examples-c"))?
            .map(|entry| entry.map(|e| e.path()))
            .collect::<Result<Vec<_>, _>>()?;
        examples.retain(|path| path.extension().is_some_and(|e| e == "c"));
        examples.sort();
        for (k, source) in examples.iter().enumerate() {
            self.example(source, "shared", &shared)?;
            if k % 4 == 0 {
                self.example(source, "static", &all)?;
            }
        }
        println!(
            "pkg-config: {} examples built, some of them fully static, too; all but {} run",
            examples.len(),
            self.skips.len()
        );
        Ok(())
    }

    /// The scene of one hash gives the hash that the tests hold the library to, whatever the profile.
    fn golden_hash(&self) -> Outcome {
        let folder = root().join("bindings/same_hash");
        let known = fs::read_to_string(folder.join("golden.txt"))?;
        let mine = if self.double { "f64 " } else { "f32 " };
        let golden =
            known.lines().find_map(|line| line.strip_prefix(mine)).ok_or("golden.txt lacks a line")?;
        let flags = self.flags(&["--cflags", "--libs"])?;
        let hash = self.example(&folder.join("same_hash.c"), "shared", &flags)?;
        if hash.trim() != golden {
            return Err(format!("the scene of one hash gives {}, not {golden}", hash.trim()).into());
        }
        println!("the scene of one hash: {golden}");
        Ok(())
    }

    /// Builds an example and runs it unless it is skipped; what it prints.
    fn example(&self, source: &Path, kind: &str, flags: &[String]) -> Outcome<String> {
        let name = source.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let program = self.scratch.join(format!("{name}-{kind}"));
        let mut cc = Command::new("cc");
        cc.args(["-O1", "-Wall", "-Wextra"]).arg(source).arg("-o").arg(&program).args(flags).arg("-lm");
        run(&mut cc)?;
        if self.skips.contains(&name.as_str()) {
            return Ok(String::new());
        }
        output(Command::new(program).env("LD_LIBRARY_PATH", &self.lib))
    }

    /// Two Rust static libraries in one program, in both orders; panics of both are caught where they should be.
    fn beside_another_rust_library(&self) -> Outcome {
        let folder = root().join("tests/beside");
        let other = self.scratch.join("libother.a");
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let mut command = Command::new(rustc);
        command.args(["--crate-type", "staticlib", "--edition", "2024", "-O", "-C", "lto=fat", "-o"]);
        run(command.arg(&other).arg(folder.join("other.rs")))?;
        let merev = self.lib.join(format!("lib{}.a", self.name()));
        let flags = self.flags(&["--static", "--cflags", "--libs"])?;
        let system = flags.iter().filter(|f| !f.starts_with("-L") && **f != format!("-l{}", self.name()));
        for (k, order) in [[&merev, &other], [&other, &merev]].iter().enumerate() {
            let program = self.scratch.join(format!("beside-{k}"));
            let mut cc = Command::new("cc");
            cc.arg(folder.join("main.c")).arg("-o").arg(&program).args(order.as_slice()).args(system.clone());
            run(&mut cc)?;
            self.run(&program)?;
        }
        println!("static: links beside another Rust library, in both orders");
        Ok(())
    }

    /// find_package on the moved files, and the source tree as a part of another project.
    fn cmake(&self, words: &[&str]) -> Outcome {
        let precision = if self.double { "ON" } else { "OFF" };
        let profile =
            words.iter().position(|w| *w == "--profile").and_then(|k| words.get(k + 1)).unwrap_or(&"dist");
        for (how, settings) in [
            ("find_package", vec![format!("-DCMAKE_PREFIX_PATH={}", self.prefix.display())]),
            (
                "add_subdirectory",
                vec!["-DROUTE=add_subdirectory".into(), format!("-DMEREV_PROFILE={profile}")],
            ),
            ("FetchContent", vec!["-DROUTE=FetchContent".into(), format!("-DMEREV_PROFILE={profile}")]),
        ] {
            let build = self.scratch.join(how);
            let mut configure = Command::new("cmake");
            configure.arg("-S").arg(root().join("tests/cmake")).arg("-B").arg(&build).args(settings);
            output(configure.arg(format!("-DMEREV_DOUBLE={precision}")))?;
            output(Command::new("cmake").arg("--build").arg(&build))?;
            let mut ctest = Command::new("ctest");
            ctest.arg("--test-dir").arg(&build).arg("--output-on-failure");
            if !self.skips.is_empty() {
                ctest.args(["--exclude-regex", &self.skips.join("|")]);
            }
            output(&mut ctest)?;
            println!("{how}: examples run, shared and static");
        }
        Ok(())
    }
}

/// The functions a header declares.
fn declared(header: &str) -> BTreeSet<String> {
    let name = |piece: &str| {
        let head = piece.split('(').next().unwrap_or_default();
        head.split_whitespace().last().map(|word| word.trim_start_matches('*').to_owned())
    };
    header.split("MV_API").skip(1).filter_map(name).filter(|n| n.starts_with("mv")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declared_functions_are_found() {
        let text =
            "#define MV_API\nMV_API int mvOne(void);\nMV_API\nconst char *mvTwo(int mvFloat,\n  int b);\n";
        assert_eq!(declared(text).into_iter().collect::<Vec<_>>(), ["mvOne", "mvTwo"]);
        let header = fs::read_to_string(root().join("include/merev.h")).unwrap();
        assert!(declared(&header).len() > 400);
    }
}
