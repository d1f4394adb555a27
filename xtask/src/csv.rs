//! Comma-separated values as RFC 4180 has them, with lines of comment.

/// The rows of a file, the header first, all of one length.
///
/// A cell may be quoted (`"a, b"`, `"say ""so"""`) and may then hold commas, quotes and line breaks. A line that
/// begins with `#` outside of a quoted cell is a comment; blank lines count for nothing.
///
/// # Errors
/// The line, and what is wrong there.
pub fn parse(text: &str) -> Result<Vec<Vec<String>>, String> {
    let mut rows: Vec<Vec<String>> = Vec::new();
    let mut lines = text.lines().enumerate();
    while let Some((at, line)) = lines.next() {
        if line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        let mut row = Vec::new();
        let mut rest = line;
        loop {
            let Some(quoted) = rest.strip_prefix('"') else {
                let (cell, after) = rest.split_once(',').map_or((rest, None), |(c, a)| (c, Some(a)));
                if cell.contains('"') {
                    return Err(format!("line {}: a quote within an unquoted cell", at + 1));
                }
                row.push(cell.trim().to_owned());
                match after {
                    Some(after) => rest = after,
                    None => break,
                }
                continue;
            };
            let mut cell = String::new();
            rest = quoted;
            loop {
                let Some((before, after)) = rest.split_once('"') else {
                    cell += rest;
                    cell.push('\n');
                    let next = lines.next().ok_or(format!("line {}: a quoted cell does not end", at + 1))?;
                    rest = next.1;
                    continue;
                };
                cell += before;
                rest = after;
                match rest.strip_prefix('"') {
                    Some(after) => {
                        cell.push('"');
                        rest = after;
                    }
                    None => break,
                }
            }
            row.push(cell);
            match rest.strip_prefix(',') {
                Some(after) => rest = after,
                None if rest.trim().is_empty() => break,
                None => return Err(format!("line {}: text after a quoted cell", at + 1)),
            }
        }
        if let Some(header) = rows.first()
            && header.len() != row.len()
        {
            return Err(format!("line {}: {} cells under a header of {}", at + 1, row.len(), header.len()));
        }
        rows.push(row);
    }
    if rows.is_empty() { Err("no header".into()) } else { Ok(rows) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_read_as_rfc_4180_has_them() {
        let text = "# a comment\na, b ,c\n\n1,\"x, \"\"y\"\"\",\n\"two\nlines\",3,\"\"\r\n";
        let expected = [["a", "b", "c"], ["1", "x, \"y\"", ""], ["two\nlines", "3", ""]];
        assert_eq!(parse(text).unwrap(), expected);
    }

    #[test]
    fn what_is_malformed_is_said_with_its_line() {
        for (text, fault) in [
            ("", "no header"),
            ("# only\n", "no header"),
            ("a,b\n1\n", "line 2: 1 cells under a header of 2"),
            ("a,b\n1,\"2\n3\n", "line 2: a quoted cell does not end"),
            ("a\n1\"\n", "line 2: a quote within"),
            ("a\n\"1\"2\n", "line 2: text after"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.contains(fault), "{text:?}: {error}");
        }
    }
}
