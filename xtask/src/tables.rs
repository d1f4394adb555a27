//! Tables in the documents, drawn from files of measurements.
//!
//! What stands between `<!-- csv: PATH -->` and `<!-- /csv -->`, each on a line of its own, is the table of the CSV
//! file at PATH (relative to the Markdown file), cell for cell as it stands there. So no figure is typed by hand.

use crate::csv;
use std::error::Error;
use std::path::{Path, PathBuf};

const OPEN: &str = "<!-- csv:";
const CLOSE: &str = "<!-- /csv -->";

/// Draws every table anew.
pub fn write() -> Result<(), Box<dyn Error>> {
    for (path, before, after) in redrawn(&crate::root())? {
        if before != after {
            std::fs::write(&path, after)?;
            println!("{}", path.display());
        }
    }
    Ok(())
}

/// Fails unless every table is what its file gives.
pub fn check() -> Result<(), Box<dyn Error>> {
    let stale = redrawn(&crate::root())?.into_iter().filter(|(_, before, after)| before != after);
    let stale: Vec<_> = stale.map(|(path, ..)| path.display().to_string()).collect();
    if stale.is_empty() {
        return Ok(());
    }
    Err(format!("stale tables in {}: run `cargo run -p xtask -- tables`", stale.join(", ")).into())
}

/// The path of a document, its text as it is and as it should be.
type Document = (PathBuf, String, String);

/// Every document under `root`.
fn redrawn(root: &Path) -> Result<Vec<Document>, Box<dyn Error>> {
    let mut paths = vec![root.join("README.md")];
    collect(&root.join("docs"), &mut paths)?;
    paths.sort();
    let mut all = Vec::new();
    for path in paths {
        let text = std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        let fresh = redraw(&text, path.parent().unwrap_or(root))
            .map_err(|fault| format!("{}, {fault}", path.display()))?;
        all.push((path, text, fresh));
    }
    Ok(all)
}

/// Lists the Markdown files in a folder and all below it.
fn collect(folder: &Path, paths: &mut Vec<PathBuf>) -> Result<(), Box<dyn Error>> {
    for entry in std::fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, paths)?;
        } else if path.extension().is_some_and(|e| e == "md") {
            paths.push(path);
        }
    }
    Ok(())
}

/// A document with its tables drawn from files below `folder`. Marks in fenced code are left alone.
fn redraw(text: &str, folder: &Path) -> Result<String, String> {
    let mut out = String::with_capacity(text.len());
    let (mut open, mut fenced) = (None, false);
    for (at, line) in (1..).zip(text.split_inclusive('\n')) {
        let mark = line.trim();
        if open.is_none() {
            out += line;
        }
        if open.is_none() && (mark.starts_with("```") || mark.starts_with("~~~")) {
            fenced = !fenced;
        }
        if fenced {
            continue;
        }
        if let Some(name) = mark.strip_prefix(OPEN) {
            let name =
                name.strip_suffix("-->").ok_or(format!("line {at}: the mark does not end in -->"))?.trim();
            if let Some(first) = open.replace(at) {
                return Err(format!("line {first}: {OPEN} … --> without {CLOSE}"));
            }
            if !out.ends_with('\n') {
                out.push('\n');
            }
            let path = folder.join(name);
            let data = std::fs::read_to_string(&path).map_err(|e| format!("line {at}: {name}: {e}"))?;
            let rows = csv::parse(&data).map_err(|fault| format!("line {at}: {name}: {fault}"))?;
            out += &format!("\n{}\n", draw(&rows));
        } else if mark == CLOSE {
            open.take().ok_or(format!("line {at}: {CLOSE} without {OPEN} … -->"))?;
            out += line;
        }
    }
    match open {
        Some(at) => Err(format!("line {at}: {OPEN} … --> without {CLOSE}")),
        None => Ok(out),
    }
}

/// Rows as a Markdown table. Columns that hold a number are set to the right.
fn draw(rows: &[Vec<String>]) -> String {
    let mut out = String::new();
    let mut line = |cells: &mut dyn Iterator<Item = String>| {
        let cells: Vec<String> = cells.collect();
        out += &format!("| {} |\n", cells.join(" | "));
    };
    let escape = |cell: &String| cell.replace('\\', "\\\\").replace('|', "\\|").replace('\n', "<br>");
    line(&mut rows[0].iter().map(escape));
    line(&mut (0..rows[0].len()).map(|k| {
        let numeric = rows[1..].iter().any(|row| row[k].parse::<f64>().is_ok());
        if numeric { "---:" } else { "---" }.to_owned()
    }));
    rows[1..].iter().for_each(|row| line(&mut row.iter().map(escape)));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_of_the_documents_are_fresh() {
        check().unwrap();
    }

    /// A folder with one CSV file, gone when dropped.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("merev-tables-{}-{name}", std::process::id()));
            std::fs::create_dir_all(path.join("docs/below")).unwrap();
            std::fs::write(path.join("a.csv"), "name,time \\[ms\\]\n\"x|y\",1.50\nz,skipped\n").unwrap();
            Self(path)
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn a_table_is_drawn_once_and_then_stays() {
        let folder = Folder::new("stays");
        let before =
            "Text\n<!-- csv: a.csv -->\nold\n<!-- /csv -->\nmore\n```\n<!-- csv: none.csv -->\n```\n";
        let table = "| name | time \\\\[ms\\\\] |\n| --- | ---: |\n| x\\|y | 1.50 |\n| z | skipped |\n";
        let expected = before.replace("old\n", &format!("\n{table}\n"));
        let after = redraw(before, &folder.0).unwrap();
        assert_eq!(after, expected);
        assert_eq!(redraw(&after, &folder.0).unwrap(), after);
    }

    #[test]
    fn stale_documents_are_found_wherever_they_lie() {
        let folder = Folder::new("found");
        std::fs::write(folder.0.join("README.md"), "nothing").unwrap();
        let text = "<!-- csv: ../../a.csv -->\n<!-- /csv -->\n";
        std::fs::write(folder.0.join("docs/below/x.md"), text).unwrap();
        let all = redrawn(&folder.0).unwrap();
        assert_eq!(all.iter().map(|(_, a, b)| a == b).collect::<Vec<_>>(), [true, false]);
    }

    #[test]
    fn faults_are_named() {
        let folder = Folder::new("faults");
        for (text, fault) in [
            ("\n<!-- csv: none.csv -->\n<!-- /csv -->\n", "line 2: none.csv: "),
            ("<!-- csv: a.csv -->\n", "line 1: <!-- csv: … --> without <!-- /csv -->"),
            ("<!-- csv: a.csv -->\n<!-- csv: a.csv -->\n", "line 1: <!-- csv: … --> without"),
            ("<!-- /csv -->\n", "line 1: <!-- /csv --> without"),
            ("<!-- csv: a.csv\n", "line 1: the mark does not end"),
        ] {
            let error = redraw(text, &folder.0).unwrap_err();
            assert!(error.starts_with(fault), "{text:?}: {error}");
        }
    }
}
