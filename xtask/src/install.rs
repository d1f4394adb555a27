//! `cargo xtask install`: the C library as a distribution would ship it.
//!
//! Shared and static library, header, C++ header, pkg-config file and CMake package, from the templates in cmake/.
//! Engine, shell and standard library are optimised as one (profile `dist`), which needs the crate without its Rust
//! form: rlib in the list of crate types switches link-time optimisation off.

use crate::{Outcome, root, run};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

mod archive;
pub mod names;

use names::Names;

pub const USAGE: &str = "install [--prefix /usr/local] [--libdir lib] [--destdir DIR] [--features f64] \
     [--no-default-features] [--profile dist]";

/// What to install, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Where the files will be used.
    pub prefix: PathBuf,
    /// Where libraries are, relative to the prefix; "lib/x86_64-linux-gnu" on Debian.
    pub libdir: String,
    /// Put in front of the prefix while files are written, for packagers.
    pub destdir: PathBuf,
    pub features: Vec<String>,
    pub default_features: bool,
    /// The cargo profile.
    pub profile: String,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            prefix: "/usr/local".into(),
            libdir: "lib".into(),
            destdir: PathBuf::new(),
            features: Vec::new(),
            default_features: true,
            profile: "dist".into(),
        }
    }
}

impl Options {
    /// From the words after `install`; `--option value` and `--option=value` are the same.
    pub fn parse(args: &[&str]) -> Outcome<Self> {
        let mut options = Self::default();
        let mut words = args.iter().flat_map(|a| match a.split_once('=') {
            Some((name, value)) if name.starts_with("--") => vec![name, value],
            _ => vec![*a],
        });
        while let Some(name) = words.next() {
            if name == "--no-default-features" {
                options.default_features = false;
                continue;
            }
            let value = words.next().ok_or_else(|| format!("{name} needs a value\nusage: xtask {USAGE}"))?;
            match name {
                "--prefix" => options.prefix = value.into(),
                "--libdir" => options.libdir = value.trim_matches('/').into(),
                "--destdir" => options.destdir = value.into(),
                "--features" => options.features.extend(value.split([',', ' ']).map(str::to_owned)),
                "--profile" => options.profile = value.into(),
                _ => return Err(format!("no option {name}\nusage: xtask {USAGE}").into()),
            }
        }
        options.prefix = std::path::absolute(&options.prefix)?;
        if options.libdir.is_empty() || options.libdir.split('/').any(|part| matches!(part, "" | "." | ".."))
        {
            return Err("--libdir is a folder below the prefix".into());
        }
        Ok(options)
    }

    /// A place below the prefix, as written to now.
    pub fn staged(&self, below: &str) -> PathBuf {
        let prefix = self.prefix.join(below);
        match self.destdir.as_os_str().is_empty() {
            true => prefix,
            false => self.destdir.join(prefix.strip_prefix("/").unwrap_or(&prefix)),
        }
    }

    pub fn double(&self) -> bool {
        self.features.iter().any(|f| f == "f64")
    }
}

/// Builds and installs.
pub fn install(options: &Options) -> Outcome {
    if !cfg!(target_os = "linux") {
        return Err("xtask install knows Linux only; elsewhere build with `cargo build --release`".into());
    }
    let names = Names::new(options.double(), env!("CARGO_PKG_VERSION"));
    let built = build(options, &names)?;
    let libdir = options.staged(&options.libdir);
    for dir in [libdir.join("pkgconfig"), libdir.join("cmake/merev"), options.staged("include")] {
        fs::create_dir_all(dir)?;
    }

    write(&libdir.join(names.file()), &fs::read(built.join("libmerev.so"))?)?;
    link(&names.file(), &libdir.join(names.soname()))?;
    link(&names.soname(), &libdir.join(format!("lib{}.so", names.name)))?;
    archive::isolate(&built.join("libmerev.a"), &libdir.join(format!("lib{}.a", names.name)))?;
    for header in ["include/merev.h", "bindings/cpp/merev.hpp"] {
        let from = root().join(header);
        write(&options.staged("include").join(from.file_name().unwrap()), &fs::read(from)?)?;
    }

    let system =
        names::system_libraries(options.default_features || options.features.contains(&"clipper2".into()));
    let fill = |template: &str, target: String, up: &str| -> Outcome {
        let text = fs::read_to_string(root().join("cmake").join(template))?;
        write(&libdir.join(target), names.fill(&text, &options.libdir, up, &system, template).as_bytes())
    };
    let depth = options.libdir.split('/').count();
    fill("merev.pc.in", format!("pkgconfig/{}.pc", names.name), &up(depth + 1))?;
    fill("merev-config.cmake.in", "cmake/merev/merev-config.cmake".into(), &up(depth + 2))?;
    fill("merev-config-version.cmake.in", "cmake/merev/merev-config-version.cmake".into(), "")?;
    fill("merev-precision.cmake.in", format!("cmake/merev/merev-{}.cmake", names.component()), "")?;
    println!(
        "installed {} {} in {}",
        names.name,
        names.version,
        options.staged(".").components().as_path().display()
    );
    Ok(())
}

/// "../.." from as many folders deep.
fn up(folders: usize) -> String {
    vec![".."; folders].join("/")
}

/// Builds the libraries of one precision; each has a target folder of its own, since cargo gives both the same name.
pub fn build(options: &Options, names: &Names) -> Outcome<PathBuf> {
    let target = root().join(if options.double() { "target/f64" } else { "target" });
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(root()).args(["rustc", "-p", "merev", "--lib", "--crate-type", "cdylib,staticlib"]);
    cargo.args(["--profile", &options.profile]).arg("--target-dir").arg(&target);
    if !options.default_features {
        cargo.arg("--no-default-features");
    }
    if !options.features.is_empty() {
        cargo.arg("--features").arg(options.features.join(","));
    }
    // Cargo by itself gives a shared library no SONAME.
    cargo.args(["--", "-C", &format!("link-arg=-Wl,-soname,{}", names.soname())]);
    run(&mut cargo)?;
    Ok(target.join(if options.profile == "dev" { "debug" } else { &options.profile }))
}

/// Writes a file unless it is there already: what depends on it need not be built again.
fn write(path: &Path, bytes: &[u8]) -> Outcome {
    if fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    // Not in place: a running program may have the old library mapped.
    let _ = fs::remove_file(path);
    Ok(fs::write(path, bytes).map_err(|e| format!("{}: {e}", path.display()))?)
}

/// A symbolic link to a neighbour.
fn link(neighbour: &str, path: &Path) -> Outcome {
    #[cfg(unix)]
    if fs::read_link(path).ok().as_deref() != Some(Path::new(neighbour)) {
        let _ = fs::remove_file(path);
        std::os::unix::fs::symlink(neighbour, path)?;
    }
    let _ = (neighbour, path);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_become_options() {
        let words = [
            "--prefix=/opt/m",
            "--libdir",
            "lib/x86_64-linux-gnu/",
            "--destdir",
            "/stage",
            "--features",
            "f64",
        ];
        let options = Options::parse(&words).unwrap();
        assert_eq!(options.libdir, "lib/x86_64-linux-gnu");
        assert_eq!(options.staged("include"), Path::new("/stage/opt/m/include"));
        assert!(options.double() && options.default_features);
        assert_eq!(Options::parse(&[]).unwrap(), Options::default());
        assert_eq!(Options::default().staged("lib"), Path::new("/usr/local/lib"));
    }

    #[test]
    fn wrong_words_are_refused() {
        for words in
            [vec!["--prefix"], vec!["--colour", "red"], vec!["--libdir", "../lib"], vec!["--libdir="]]
        {
            assert!(Options::parse(&words).is_err(), "{words:?}");
        }
    }

    #[test]
    fn a_file_that_is_the_same_is_left_alone() {
        let path = std::env::temp_dir().join(format!("merev-write-{}", std::process::id()));
        write(&path, b"one").unwrap();
        let before = fs::metadata(&path).unwrap().modified().unwrap();
        write(&path, b"one").unwrap();
        assert_eq!(fs::metadata(&path).unwrap().modified().unwrap(), before);
        write(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        fs::remove_file(path).unwrap();
    }
}
