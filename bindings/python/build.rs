//! Writes header.h into the target folder: include/merev.h without directives, comments and inline functions, as cffi
//! reads it. maturin looks for it there.

use std::path::{Path, PathBuf};

fn main() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../include/merev.h");
    println!("cargo:rerun-if-changed={}", source.display());
    println!("cargo:rerun-if-changed=build.rs");
    let text = std::fs::read_to_string(&source).unwrap_or_else(|e| panic!("{}: {e}", source.display()));
    let declarations = declarations(&text);
    assert!(declarations.matches("(").count() > 200, "the header was not understood");
    let out = target_dir().join("header.h");
    std::fs::write(&out, declarations).unwrap_or_else(|e| panic!("{}: {e}", out.display()));
}

/// The folder that cargo marked as its own, above OUT_DIR.
fn target_dir() -> PathBuf {
    let out = PathBuf::from(std::env::var("OUT_DIR").expect("cargo sets OUT_DIR"));
    let marked = out.ancestors().find(|d| d.join("CACHEDIR.TAG").exists());
    marked.expect("OUT_DIR is in a target folder").to_owned()
}

/// What the header declares in single precision.
fn declarations(header: &str) -> String {
    let mut out = String::from("typedef float mvFloat;\n");
    let body = header.split("typedef float mvFloat;\n#endif").nth(1).expect("the header defines mvFloat");
    // The inline part begins where the C++ bracket around the functions ends.
    let end =
        body.rfind("}  // extern \"C\"").or_else(|| body.rfind("} // extern \"C\"")).expect("extern C ends");
    let mut depth = 0;
    for line in without_comments(&body[..end]).lines() {
        if line.starts_with("#if") {
            depth += 1;
        } else if line.starts_with("#endif") {
            depth -= 1;
        } else if depth == 0 && !line.trim().is_empty() {
            out += line.trim_start_matches("MV_API").trim_end();
            out.push('\n');
        }
    }
    out
}

fn without_comments(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((code, comment)) = rest.split_once("/*") {
        out += code;
        rest = comment.split_once("*/").map_or("", |(_, after)| after);
    }
    out + rest
}
