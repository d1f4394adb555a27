//! docs/migration.md: every public name of Box2D and Box3D, and what it is called here or why it is missing.
//!
//! The peers' names are lists in docs/migration; a name with the prefix mv that our header has is the counterpart, and
//! docs/migration/rules.txt tells of the others. Nothing may be left over, on either side.

use std::collections::BTreeSet;
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

fn folder() -> PathBuf {
    crate::root().join("docs/migration")
}

fn path() -> PathBuf {
    crate::root().join("docs/migration.md")
}

/// Writes the page.
pub fn write() -> Result<()> {
    Ok(std::fs::write(path(), generate()?)?)
}

/// Fails unless the committed page is what header, names and rules give.
pub fn check() -> Result<()> {
    if std::fs::read_to_string(path())? == generate()? {
        Ok(())
    } else {
        Err("docs/migration.md is stale: run `cargo xtask migration`".into())
    }
}

/// What becomes of a name.
#[derive(Clone)]
enum Fate {
    Named { names: Vec<String>, note: String },
    Missing(String),
}

struct Rule {
    pattern: String,
    fate: Fate,
    used: bool,
}

fn generate() -> Result<String> {
    let ours = our_names()?;
    let mut rules = rules(&ours)?;
    let mut out = String::from(HEAD);
    for (title, file) in [("Box3D", "box3d.txt"), ("Box2D", "box2d.txt")] {
        let text = std::fs::read_to_string(folder().join(file))?;
        let (mut same, mut others, mut missing) = (Vec::new(), Vec::new(), Vec::new());
        for line in text.lines().filter(|l| !l.starts_with('#') && !l.is_empty()) {
            let (kind, name) = line.split_once(' ').ok_or(format!("{file}: {line}: kind and name"))?;
            match fate(name, &ours, &mut rules)? {
                None => same.push((kind, name)),
                Some(Fate::Named { names, note }) => others.push((name, names, note)),
                Some(Fate::Missing(why)) => missing.push((kind, name, why)),
            }
        }
        if same.len() < 200 {
            return Err(format!("{file}: only {} names were recognised", same.len()).into());
        }
        section(&mut out, title, &text, &same, &others, &missing)?;
    }
    match rules.iter().find(|r| !r.used) {
        Some(rule) => Err(format!("rules.txt: no name needs the rule {}", rule.pattern).into()),
        None => Ok(out),
    }
}

/// What our header declares: functions and types.
fn our_names() -> Result<BTreeSet<String>> {
    let text = std::fs::read_to_string(crate::root().join("include/merev.h"))?;
    let mut names = BTreeSet::new();
    // Without comments, whose words are no declarations.
    let mut rest = text.as_str();
    while let Some((code, comment)) = rest.split_once("/*") {
        words(code, &mut names);
        rest = comment.split_once("*/").map_or("", |(_, after)| after);
    }
    words(rest, &mut names);
    Ok(names)
}

fn words(code: &str, names: &mut BTreeSet<String>) {
    let pieces = code.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    names.extend(pieces.filter(|w| w.starts_with("mv")).map(str::to_owned));
}

fn rules(ours: &BTreeSet<String>) -> Result<Vec<Rule>> {
    let text = std::fs::read_to_string(folder().join("rules.txt"))?;
    let mut rules = Vec::new();
    for line in text.lines().filter(|l| !l.starts_with('#') && !l.is_empty()) {
        let wrong = || format!("rules.txt: {line}");
        let (pattern, rest) = line.split_once(' ').ok_or_else(wrong)?;
        let fate = if let Some(why) = rest.strip_prefix("- ") {
            Fate::Missing(why.to_owned())
        } else {
            let (names, note) = rest.split_once(" : ").unwrap_or((rest, ""));
            let names: Vec<String> =
                names.strip_prefix("= ").ok_or_else(wrong)?.split_whitespace().map(str::to_owned).collect();
            if let Some(unknown) = names.iter().find(|n| !ours.contains(*n)) {
                return Err(format!("rules.txt: {unknown} is not in the header").into());
            }
            Fate::Named { names, note: note.to_owned() }
        };
        rules.push(Rule { pattern: pattern.to_owned(), fate, used: false });
    }
    Ok(rules)
}

/// `None`: the same name with our prefix.
fn fate(name: &str, ours: &BTreeSet<String>, rules: &mut [Rule]) -> Result<Option<Fate>> {
    if ours.contains(&format!("mv{}", &name[2..])) {
        return Ok(None);
    }
    match rules.iter_mut().find(|r| fits(&r.pattern, name)) {
        Some(rule) => {
            rule.used = true;
            Ok(Some(rule.fate.clone()))
        }
        None => {
            Err(format!("rules.txt says nothing of {name}, and the header has no mv{}", &name[2..]).into())
        }
    }
}

/// `?` is any one character, `*` any number of them.
fn fits(pattern: &str, name: &str) -> bool {
    let Some(first) = pattern.chars().next() else { return name.is_empty() };
    let rest = &pattern[first.len_utf8()..];
    match first {
        '*' => (0..=name.len()).any(|k| fits(rest, &name[k..])),
        _ => name
            .chars()
            .next()
            .is_some_and(|c| (first == '?' || first == c) && fits(rest, &name[c.len_utf8()..])),
    }
}

type Other<'a> = (&'a str, Vec<String>, String);

fn section(
    out: &mut String,
    title: &str,
    list: &str,
    same: &[(&str, &str)],
    others: &[Other<'_>],
    missing: &[(&str, &str, String)],
) -> Result<()> {
    let whole = same.len() + others.len() + missing.len();
    let source = list.lines().next().unwrap_or("").trim_start_matches("# Public names of ");
    writeln!(out, "\n## {title}\n\nNames of {}", source.trim_end_matches(": kind and name."))?;
    writeln!(
        out,
        "\n{whole} functions, structures, enumerations and callbacks: {} have the same name here, {} another, {} are missing.",
        same.len(),
        others.len(),
        missing.len()
    )?;
    writeln!(out, "\n### {title}: another name here\n\n| {title} | merev | |\n|---|---|---|")?;
    for (name, names, note) in others {
        let names: Vec<String> = names.iter().map(|n| format!("`{n}`")).collect();
        writeln!(out, "| `{name}` | {} | {note} |", names.join(", "))?;
    }
    writeln!(out, "\n### {title}: missing\n\n| {title} | why |\n|---|---|")?;
    let reasons: BTreeSet<&str> = missing.iter().map(|(_, _, why)| why.as_str()).collect();
    for reason in reasons {
        let names: Vec<String> = missing
            .iter()
            .filter(|(_, _, why)| why == reason)
            .map(|(_, name, _)| format!("`{name}`"))
            .collect();
        writeln!(out, "| {} | {reason} |", names.join(" "))?;
    }
    writeln!(out, "\n### {title}: the same name\n\n| {title} | merev | |\n|---|---|---|")?;
    for (kind, name) in same {
        let kind = if *kind == "function" { "" } else { *kind };
        writeln!(out, "| `{name}` | `mv{}` | {kind} |", &name[2..])?;
    }
    Ok(())
}

const HEAD: &str = "# Coming from Box2D or Box3D

Written by `cargo xtask migration`, which also checks it against `include/merev.h`; the rules are in
[migration/rules.txt](migration/rules.txt).

Most lines move by a new prefix: `b3` or `b2` becomes `mv`. What differs everywhere:

- Calls with wrong arguments are refused with an error, `mvGetLastError()`; nothing asserts.
- A definition's `internalValue` comes first; definitions come from their `mvDefault…Def()` as before.
- Units are SI and there is no length scale. Gravity is (0, −10, 0) unless said otherwise; no axis is up.
- Mixing, filter and pre-solve callbacks get a `context`; those of debug draw get pointers instead of structures.
- Arrays instead of callbacks: each query also has a form that fills an array (`…All`, `…Closest`).
- Enumerators are `mv_…` constants of integer types.
- From Box2D: vectors have three components, rotations are quaternions (`mvQuat`, `mvMakeQuatFromAxisAngle`), angular
  velocities and torques are vectors, a body is built of spheres, capsules, boxes and hulls.
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_fresh() {
        check().unwrap();
    }

    #[test]
    fn patterns_fit() {
        assert!(fits("b?*Sensor*", "b3World_GetSensorEvents") && fits("b2Rot", "b2Rot"));
        assert!(
            !fits("b2Rot", "b2Rotation") && !fits("b3*", "b2X") && fits("b2Rot_Get*Axis", "b2Rot_GetXAxis")
        );
    }
}
