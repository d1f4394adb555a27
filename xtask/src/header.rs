//! include/merev.h, made by cbindgen from src/capi.

use cbindgen::{
    Builder, Config, DocumentationLength, DocumentationStyle, Language, RenameRule, SortKey, Style,
};
use std::error::Error;
use std::path::PathBuf;

fn path() -> PathBuf {
    crate::root().join("include/merev.h")
}

/// Writes the header.
pub fn write() -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(path().parent().unwrap())?;
    Ok(std::fs::write(path(), generate()?)?)
}

/// Fails unless the committed header is what the source gives.
pub fn check() -> Result<(), Box<dyn Error>> {
    if std::fs::read_to_string(path())? == generate()? {
        Ok(())
    } else {
        Err("include/merev.h is stale: run `cargo run -p xtask -- header`".into())
    }
}

/// The text of the header.
fn generate() -> Result<String, Box<dyn Error>> {
    let capi = crate::root().join("src/capi");
    let mut config = Config {
        language: Language::C,
        cpp_compat: true,
        no_includes: true,
        style: Style::Both,
        usize_is_size_t: true,
        documentation_style: DocumentationStyle::Doxy,
        documentation_length: DocumentationLength::Full,
        line_length: 110,
        tab_width: 4,
        sort_by: SortKey::None,
        ..Config::default()
    };
    config.header = Some(std::fs::read_to_string(capi.join("header/preamble.h"))?);
    let inline = std::fs::read_to_string(capi.join("header/inline.h"))?;
    config.trailer = Some(format!("{inline}\n#endif /* MEREV_H */"));
    config.function.prefix = Some("MV_API".into());
    config.function.sort_by = Some(SortKey::None);
    config.function.rename_args = RenameRule::CamelCase;
    config.structure.rename_fields = RenameRule::CamelCase;
    config.constant.sort_by = Some(SortKey::None);
    // A byte that C calls bool; Rust checks it before it believes it.
    config.export.rename.insert("Flag".into(), "bool".into());
    // Needed by the inline part or by users, whether or not a function mentions them.
    config.export.include = ["mvVec2", "mvWorldId", "mvBodyId", "mvShapeId", "mvJointId", "mvContactId"]
        .map(str::to_owned)
        .into();

    let mut out = Vec::new();
    Builder::new().with_config(config).with_src(capi.join("mod.rs")).generate()?.write(&mut out);
    let text = names_for_tags(&String::from_utf8(out)?);
    let stray =
        text.lines().find(|l| !l.is_ascii() || l.contains('`') || l.contains("](") || l.contains("\\["));
    match stray {
        Some(line) => Err(format!("Markdown or non-ASCII in the C header: {line}").into()),
        None => Ok(text),
    }
}

/// Structs have a tag and a name; the name is enough wherever they are used. Parameters on lines of their own stay
/// below each other.
fn names_for_tags(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut shift = 0;
    for line in text.split_inclusive('\n') {
        if line.starts_with("typedef struct") {
            out += line;
            continue;
        }
        let indent = line.len() - line.trim_start_matches(' ').len();
        let line = if shift > 0 && indent > shift { &line[shift..] } else { line };
        if line.contains(';') {
            shift = 0;
        } else if let Some((before, _)) = line.split_once('(') {
            shift = "struct ".len() * before.matches("struct mv").count();
        }
        out += &line.replace("struct mv", "mv");
    }
    out
}
