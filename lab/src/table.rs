//! Plain aligned tables.

/// A table; its first column is aligned to the left, the others to the right.
#[derive(Default)]
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    pub fn new(head: &[&str]) -> Self {
        Self { rows: vec![head.iter().map(ToString::to_string).collect()] }
    }

    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().collect());
    }
}

impl std::fmt::Display for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let cell = |row: &Vec<String>, k: usize| row.get(k).map_or(0, |c| c.chars().count());
        let widths: Vec<usize> =
            (0..columns).map(|k| self.rows.iter().map(|r| cell(r, k)).max().unwrap_or(0)).collect();
        for (i, row) in self.rows.iter().enumerate() {
            let mut line = String::new();
            for (k, text) in row.iter().enumerate() {
                let width = widths[k];
                if k == 0 {
                    line += &format!("{text:<width$}");
                } else {
                    line += &format!("  {text:>width$}");
                }
            }
            writeln!(f, "{}", line.trim_end())?;
            if i == 0 {
                let rule = widths.iter().sum::<usize>() + 2 * columns.saturating_sub(1);
                writeln!(f, "{}", "-".repeat(rule))?;
            }
        }
        Ok(())
    }
}

/// A length in the unit that suits it.
pub fn length(meters: f64) -> String {
    let size = meters.abs();
    if size >= 1.0 || size == 0.0 {
        format!("{meters:.3} m")
    } else if size >= 1e-4 {
        format!("{:.3} mm", 1e3 * meters)
    } else {
        format!("{:.3} µm", 1e6 * meters)
    }
}

/// Milliseconds with three significant digits.
pub fn milliseconds(ms: f64) -> String {
    let digits = if ms >= 100.0 {
        0
    } else if ms >= 10.0 {
        1
    } else if ms >= 1.0 {
        2
    } else {
        4
    };
    format!("{ms:.digits$} ms")
}

/// A share in percent, or in scientific notation where it is small.
pub fn share(x: f64) -> String {
    if x == 0.0 {
        "0".into()
    } else if x.abs() < 1e-4 {
        format!("{x:+.1e}")
    } else {
        format!("{:+.3} %", 100.0 * x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned() {
        let mut table = Table::new(&["scene", "time"]);
        table.row(["a".into(), "1.5 µm".into()]);
        table.row(["long name".into(), "2".into()]);
        let text = table.to_string();
        let widths: Vec<usize> = text.lines().map(|l| l.chars().count()).collect();
        assert_eq!(widths, [17, 17, 17, 17], "{text}");
    }

    #[test]
    fn units_suit_the_size() {
        assert_eq!(length(98.5), "98.500 m");
        assert_eq!(length(-0.0124), "-12.400 mm");
        assert_eq!(length(3.2e-6), "3.200 µm");
        assert_eq!(milliseconds(12.83), "12.8 ms");
        assert_eq!(share(-0.0123), "-1.230 %");
    }
}
