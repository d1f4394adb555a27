//! Puts merev_cffi.h where maturin looks for the header of a library: header.h in the target folder.

use std::path::{Path, PathBuf};

fn main() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("merev_cffi.h");
    println!("cargo:rerun-if-changed={}", source.display());
    println!("cargo:rerun-if-changed=build.rs");
    let target = target_dir().join("header.h");
    std::fs::copy(&source, &target)
        .unwrap_or_else(|e| panic!("{} to {}: {e}", source.display(), target.display()));
}

/// OUT_DIR is target/\[triple/\]profile/build/package/out.
fn target_dir() -> PathBuf {
    let variable = |name| std::env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"));
    let out = PathBuf::from(variable("OUT_DIR"));
    let above = out.ancestors().nth(4).expect("OUT_DIR is in a target folder");
    let triple = above.file_name().is_some_and(|name| name == variable("TARGET").as_str());
    if triple { above.parent().expect("a triple is in a target folder") } else { above }.to_owned()
}
