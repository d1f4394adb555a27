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

/// The folder that cargo marked as its own, above OUT_DIR.
fn target_dir() -> PathBuf {
    let out = PathBuf::from(std::env::var("OUT_DIR").expect("cargo sets OUT_DIR"));
    let marked = out.ancestors().find(|d| d.join("CACHEDIR.TAG").exists());
    marked.expect("OUT_DIR is in a target folder").to_owned()
}
