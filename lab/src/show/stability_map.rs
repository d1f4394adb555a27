//! The stability map: how much of each stressor each method bears. Dark is strong, pale is weak, so that it reads in
//! grey as well; a cell that begins with ≥ passed the hardest value that was tried.

use super::axis::short;
use super::palette;
use super::settings::distinct;
use super::svg::{Anchor, FAINT, INK, Svg, escape};
use crate::records::Stability;

/// The map: columns are (engine, method), rows are (scene, stressor).
pub struct Map<'a> {
    pub columns: Vec<(String, String)>,
    pub rows: Vec<Row<'a>>,
}

pub struct Row<'a> {
    pub scene: &'a str,
    pub stressor: &'a str,
    pub unit: &'a str,
    pub harder: &'a str,
    pub cells: Vec<Option<&'a Stability>>,
}

impl<'a> Map<'a> {
    pub fn new(records: &'a [Stability]) -> Self {
        let mut columns: Vec<(String, String)> = Vec::new();
        let mut rows: Vec<Row<'a>> = Vec::new();
        for r in records {
            let column = (r.engine.clone(), r.method.clone());
            if !columns.contains(&column) {
                columns.push(column);
            }
            if !rows.iter().any(|row| row.scene == r.scene && row.stressor == r.stressor) {
                rows.push(Row {
                    scene: &r.scene,
                    stressor: &r.stressor,
                    unit: &r.unit,
                    harder: &r.harder,
                    cells: Vec::new(),
                });
            }
        }
        // What engines come with stands side by side, then what else they have, each in the order of the runs, in
        // which an engine's own method is the first.
        let own: Vec<(String, String)> = distinct(columns.iter().map(|c| c.0.as_str()))
            .into_iter()
            .filter_map(|e| columns.iter().find(|c| c.0 == e).cloned())
            .collect();
        columns.sort_by_key(|c| (!own.contains(c), palette::rank(&c.0).0, c.0.clone()));
        for row in &mut rows {
            let of = |(engine, method): &(String, String)| {
                records.iter().find(|r| {
                    r.scene == row.scene
                        && r.stressor == row.stressor
                        && r.engine == *engine
                        && r.method == *method
                })
            };
            row.cells = columns.iter().map(of).collect();
        }
        Self { columns, rows }
    }
}

impl Row<'_> {
    /// How strong each cell is among its row, from 0 (survives nothing) to 1.
    pub fn strengths(&self) -> Vec<Option<f64>> {
        let log = |r: &Stability| {
            let value = survived(r).filter(|v| *v > 0.0).map(libm::log10);
            value.map(|v| if self.harder == "smaller" { -v } else { v })
        };
        let logs: Vec<f64> = self.cells.iter().flatten().filter_map(|r| log(r)).collect();
        let low = logs.iter().copied().fold(f64::INFINITY, f64::min);
        let high = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let strength = |r: &Stability| match log(r) {
            // Differences of less than a hundredth of a decade are no differences.
            Some(_) if high - low < 0.01 => 0.8,
            Some(v) => 0.2 + 0.8 * (v - low) / (high - low),
            None => 0.0,
        };
        self.cells.iter().map(|cell| cell.map(strength)).collect()
    }

    /// The stressor with its unit.
    pub fn name(&self) -> String {
        let unit = if matches!(self.unit, "" | "1") { String::new() } else { format!(" [{}]", self.unit) };
        format!("{}{unit}", self.stressor)
    }
}

fn survived(r: &Stability) -> Option<f64> {
    r.survived.filter(|v| v.is_finite())
}

/// What stands in a cell.
pub fn cell_text(r: &Stability) -> String {
    match (survived(r), r.failed.filter(|v| v.is_finite())) {
        (Some(v), None) => format!("{} {}", if r.harder == "smaller" { "≤" } else { "≥" }, short(v)),
        (Some(v), Some(_)) => short(v),
        (None, Some(_)) => "none".into(),
        (None, None) => r.outcome.name().into(),
    }
}

/// What a cell says when pointed at.
pub fn cell_words(r: &Stability) -> String {
    let unit = &r.unit;
    let survived =
        survived(r).map_or("survives none".to_owned(), |v| format!("survives {} {unit}", short(v)));
    match r.failed.filter(|v| v.is_finite()) {
        Some(v) => format!("{survived}; fails at {} {unit} ({})", short(v), r.outcome.name()),
        None => format!("{survived}; nothing harder was tried"),
    }
}

/// The colour of a strength, and that of the text on it: one hue, ever darker.
pub fn shade(strength: f64) -> (String, &'static str) {
    let t = strength.clamp(0.0, 1.0);
    let mix = |a: f64, b: f64| (a + t * (b - a)) as u8;
    let colour = format!("#{:02x}{:02x}{:02x}", mix(240.0, 8.0), mix(245.0, 56.0), mix(250.0, 104.0));
    (colour, if t > 0.5 { "#ffffff" } else { "#14212e" })
}

const CELL: [f64; 2] = [86.0, 24.0];
const SIDE: f64 = 250.0;
const HEAD: f64 = 74.0;

/// The map as a picture.
pub fn draw(records: &[Stability]) -> Svg {
    let map = Map::new(records);
    let width = (SIDE + CELL[0] * map.columns.len() as f64 + 8.0).max(420.0);
    let mut svg = Svg::new(width, HEAD + CELL[1] * map.rows.len() as f64 + 30.0, "Stability map");
    svg.text(8.0, 20.0, Anchor::Start, 14.0, INK, "Largest stressor survived");
    for (k, (engine, method)) in map.columns.iter().enumerate() {
        let x = SIDE + CELL[0] * (k as f64 + 0.5);
        let look = palette::look(engine);
        svg.path(&look.mark.path(x, 30.0, 4.5), &format!(r#"fill="{}""#, look.colour));
        svg.text(x, 48.0, Anchor::Middle, 11.5, INK, &palette::title(engine));
        // A method of two parts takes two lines.
        let (first, second) = method.split_once('/').unwrap_or((method, ""));
        svg.text(x, 59.0, Anchor::Middle, 8.5, FAINT, &first.chars().take(18).collect::<String>());
        svg.text(x, 69.0, Anchor::Middle, 8.5, FAINT, &second.chars().take(18).collect::<String>());
    }
    for (i, row) in map.rows.iter().enumerate() {
        let y = HEAD + CELL[1] * i as f64;
        let text = format!("{} · {}", row.scene, row.name());
        svg.text(SIDE - 8.0, y + 16.0, Anchor::End, 11.0, INK, &text.chars().take(44).collect::<String>());
        for (k, (cell, strength)) in row.cells.iter().zip(row.strengths()).enumerate() {
            let x = SIDE + CELL[0] * k as f64;
            let (Some(cell), Some(strength)) = (cell, strength) else { continue };
            let (colour, ink) = shade(strength);
            svg.rect([x + 1.0, y + 1.0, CELL[0] - 2.0, CELL[1] - 2.0], &colour, "cell");
            svg.text_of_class(
                x + CELL[0] / 2.0,
                y + 16.0,
                Anchor::Middle,
                11.5,
                ink,
                "cell",
                &cell_text(cell),
            );
        }
    }
    let y = HEAD + CELL[1] * map.rows.len() as f64 + 18.0;
    let legend = "Darker bears more, within a row. ≥: the hardest that was tried. none: the mildest failed.";
    svg.text(8.0, y, Anchor::Start, 10.0, FAINT, legend);
    svg
}

/// The map as a table of the page.
pub fn html(records: &[Stability]) -> String {
    let map = Map::new(records);
    let mut out = String::from("<table class=\"map\"><thead><tr><th>scene</th><th>stressor</th>");
    for (engine, method) in &map.columns {
        let (name, method) =
            (escape(&palette::title(engine)), escape(method).replace('/', "/<wbr>").replace('_', "_<wbr>"));
        out += &format!("<th data-e=\"{}\">{name}<small>{method}</small></th>", escape(engine));
    }
    out += "</tr></thead><tbody>\n";
    for row in &map.rows {
        out += &format!("<tr><th>{}</th><th>{}</th>", escape(row.scene), escape(&row.name()));
        for ((cell, strength), (engine, _)) in row.cells.iter().zip(row.strengths()).zip(&map.columns) {
            let engine = escape(engine);
            let (Some(cell), Some(strength)) = (cell, strength) else {
                out += &format!("<td data-e=\"{engine}\"></td>");
                continue;
            };
            let ((colour, ink), text, words) = (shade(strength), cell_text(cell), cell_words(cell));
            out += &format!(
                "<td data-e=\"{engine}\" style=\"background:{colour};color:{ink}\" title=\"{}\">{}</td>",
                escape(&words),
                escape(&text)
            );
        }
        out += "</tr>\n";
    }
    out + "</tbody></table>\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::Outcome;

    fn row(engine: &str, survived: Option<f64>, failed: Option<f64>) -> Stability {
        Stability {
            scene: "stack <1>".into(),
            engine: engine.into(),
            method: "soft_step/moser_veselov".into(),
            stressor: "mass ratio".into(),
            unit: "kg/kg".into(),
            harder: "larger".into(),
            survived,
            failed,
            outcome: Outcome::Exploded,
        }
    }

    #[test]
    fn a_stronger_cell_is_darker() {
        let records = [
            row("merev", Some(1000.0), None),
            row("box3d", Some(10.0), Some(20.0)),
            row("ode", None, Some(1.0)),
        ];
        let map = Map::new(&records);
        assert_eq!(map.rows[0].strengths(), [Some(1.0), Some(0.2), Some(0.0)]);
        let grey = |s: f64| u32::from_str_radix(&shade(s).0[1..3], 16).unwrap();
        assert!(grey(1.0) < grey(0.5) && grey(0.5) < grey(0.2) && grey(0.2) < grey(0.0));
        let texts: Vec<String> = records.iter().map(cell_text).collect();
        assert_eq!(texts, ["≥ 1000", "10", "none"]);
    }

    #[test]
    fn what_engines_come_with_stands_side_by_side() {
        let other = Stability { method: "lemke".into(), ..row("merev", Some(1.0), None) };
        let records = [row("merev", None, None), other, row("box3d", None, None)];
        let names: Vec<String> =
            Map::new(&records).columns.into_iter().map(|c| c.0 + " " + &c.1[..5]).collect();
        assert_eq!(names, ["merev soft_", "box3d soft_", "merev lemke"]);
    }

    #[test]
    fn what_is_no_number_is_drawn_as_none() {
        let records = [
            row("merev", Some(f64::NAN), Some(f64::NAN)),
            row("ode", Some(0.0), None),
            row("newton", None, None),
        ];
        for records in [&records[..], &[]] {
            let svg = draw(records).file();
            roxmltree::Document::parse(&svg).unwrap();
            let html = html(records);
            assert!(!svg.contains("NaN") && !html.contains("NaN") && !html.contains("<1>"), "{html}");
        }
    }
}
