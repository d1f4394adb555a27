//! The race: time a step, and beside it what came of it. Time alone does not tell: whoever lets bodies sink into each
//! other has less to do.

use super::axis::{LogAxis, label, short};
use super::palette::{self, look};
use super::settings::distinct;
use super::svg::{Anchor, FAINT, GRID, INK, Svg, escape};
use crate::records::Race;

/// A scene's rows, the fastest first.
pub struct Heat<'a> {
    pub scene: String,
    pub rows: Vec<&'a Race>,
    /// merev's median, or the fastest one where merev did not run.
    pub base_ms: f64,
}

pub fn heats(records: &[Race]) -> Vec<Heat<'_>> {
    let heat = |scene: String| {
        let good = |r: &&Race| r.scene == scene && r.median_ms.is_finite() && r.median_ms > 0.0;
        let mut rows: Vec<&Race> = records.iter().filter(good).collect();
        rows.sort_by(|a, b| a.median_ms.total_cmp(&b.median_ms));
        let ours = rows.iter().find(|r| r.engine == "merev").or(rows.first());
        let base_ms = ours.map(|r| r.median_ms)?;
        Some(Heat { scene, rows, base_ms })
    };
    distinct(records.iter().map(|r| r.scene.as_str())).into_iter().filter_map(heat).collect()
}

/// A length in millimetres, as tables show it.
fn millimeters(m: f64) -> String {
    short(1e3 * m)
}

/// The qualities of a row: names and values as shown. Smaller is better in size for each.
pub fn qualities(r: &Race) -> [(&'static str, f64, String); 6] {
    let length = |name, m: f64| (name, m.abs(), millimeters(m));
    [
        length("sagged [mm]", r.sagged_m),
        length("sideways [mm]", r.sideways_m),
        length("overlap [mm]", r.overlap_m),
        length("joint gap [mm]", r.joint_gap_m),
        ("energy change", r.energy_change.abs(), share(r.energy_change)),
        ("residual [m/s]", r.residual.abs(), short(r.residual)),
    ]
}

fn share(x: f64) -> String {
    if !x.is_finite() || x == 0.0 || x.abs() < 1e-5 { short(x) } else { format!("{} %", short(100.0 * x)) }
}

/// The table of the page: a block a scene, the fastest first, the best of each quality in bold.
pub fn html(records: &[Race]) -> String {
    let mut out = String::from(
        "<table class=\"race\"><thead><tr><th>scene</th><th>engine</th><th>median [ms]</th><th>minimum [ms]</th>\
         <th>merev / it</th>",
    );
    let Some(first) = records.first() else { return String::new() };
    for (name, ..) in qualities(first) {
        out += &format!("<th>{name}</th>");
    }
    out += "<th>first step [ms]</th></tr></thead>\n";
    for heat in heats(records) {
        out += "<tbody>";
        for (k, row) in heat.rows.iter().enumerate() {
            let engine = escape(&row.engine);
            out += &format!("<tr data-e=\"{engine}\"{}>", if k == 0 { " class=\"first\"" } else { "" });
            if k == 0 {
                let about = format!("{} bodies, {} steps", row.bodies, row.steps);
                out += &format!(
                    "<th rowspan=\"{}\">{}<small>{about}</small></th>",
                    heat.rows.len(),
                    escape(&heat.scene)
                );
            }
            let mark = if k == 0 { " <b class=\"tag\">fastest</b>" } else { "" };
            out += &format!(
                "<th class=\"t-{}\">{}{mark}</th>",
                look(&row.engine).engine,
                escape(&palette::title(&row.engine))
            );
            let ratio = short(heat.base_ms / row.median_ms);
            let (median, minimum) = (short(row.median_ms), short(row.minimum_ms));
            out += &format!("<td>{median}</td><td>{minimum}</td><td>{ratio}</td>");
            for (at, (_, size, text)) in qualities(row).into_iter().enumerate() {
                let least = heat.rows.iter().map(|r| qualities(r)[at].1).fold(f64::INFINITY, f64::min);
                // Where all are alike none is the best.
                let alike = heat.rows.iter().all(|r| qualities(r)[at].1 == size);
                let best = !alike && size.is_finite() && size == least;
                out += &if best { format!("<td><b>{text}</b></td>") } else { format!("<td>{text}</td>") };
            }
            out += &format!("<td>{}</td></tr>\n", short(row.first_ms));
        }
        out += "</tbody>\n";
    }
    out + "</table>\n"
}

const ROW: f64 = 27.0;
const SIDE: f64 = 132.0;
const WIDTH: f64 = 440.0;

/// Two panels: the times over merev's, and the worst overlap.
pub fn panels(records: &[Race]) -> [Svg; 2] {
    let heats = heats(records);
    let time = |heat: &Heat<'_>, row: &Race| row.median_ms / heat.base_ms;
    // Less than a micrometre is none.
    let overlap = |_: &Heat<'_>, row: &Race| if row.overlap_m < 1e-6 { 1e-3 } else { 1e3 * row.overlap_m };
    [
        dots("time over merev's (left of 1: faster than merev)", &heats, &time, Some(1.0)),
        dots("worst overlap [mm] (left is better; from 0.001)", &heats, &overlap, None),
    ]
}

fn dots(name: &str, heats: &[Heat<'_>], value: &dyn Fn(&Heat<'_>, &Race) -> f64, line: Option<f64>) -> Svg {
    let mut svg = Svg::new(WIDTH, ROW * heats.len() as f64 + 64.0, name);
    svg.text(8.0, 18.0, Anchor::Start, 13.5, INK, name);
    let values = heats.iter().flat_map(|heat| heat.rows.iter().map(|row| value(heat, row)));
    let axis = LogAxis::around(values.chain(line).map(|v| v.max(1e-6)), SIDE, WIDTH - 14.0);
    let (top, bottom) = (28.0, 28.0 + ROW * heats.len() as f64);
    for tick in axis.ticks() {
        svg.line([axis.pixel(tick), top, axis.pixel(tick), bottom], GRID, 1.0, "", "grid");
        svg.text(axis.pixel(tick), bottom + 16.0, Anchor::Middle, 12.5, FAINT, &label(tick));
    }
    if let Some(at) = line {
        svg.line([axis.pixel(at), top, axis.pixel(at), bottom], INK, 1.3, "7 4", "null");
    }
    for (k, heat) in heats.iter().enumerate() {
        let y = top + ROW * (k as f64 + 0.5);
        svg.text(SIDE - 8.0, y + 4.0, Anchor::End, 12.5, INK, &heat.scene);
        svg.line([SIDE, y, WIDTH - 14.0, y], GRID, 1.0, "", "grid");
        for (at, row) in heat.rows.iter().enumerate() {
            let value = value(heat, row);
            // One below the other, so that equals are all seen.
            let y = y + 5.0 * (at as f64 - (heat.rows.len() as f64 - 1.0) / 2.0);
            if !value.is_finite() {
                continue;
            }
            let look = look(&row.engine);
            svg.open(&format!(r#"data-e="{}""#, escape(&row.engine)));
            svg.path(
                &look.mark.path(axis.pixel(value.max(1e-6)), y, 4.4),
                &format!(r#"class="f-{}" fill="{}""#, look.engine, look.colour),
            );
            svg.close();
        }
    }
    svg
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(scene: &str, engine: &str, median_ms: f64, overlap_m: f64) -> Race {
        Race {
            scene: scene.into(),
            engine: engine.into(),
            bodies: 10,
            steps: 100,
            median_ms,
            minimum_ms: median_ms,
            first_ms: f64::NAN,
            sagged_m: 0.0,
            sideways_m: 0.0,
            overlap_m,
            joint_gap_m: f64::NAN,
            energy_change: -0.01,
            residual: 0.0,
        }
    }

    #[test]
    fn the_fastest_comes_first_and_the_best_is_bold() {
        let records = [
            row("pile", "merev", 3.0, 1e-4),
            row("pile", "box3d", 2.0, 2e-2),
            row("odd", "ode", f64::NAN, 0.0),
        ];
        let all = heats(&records);
        assert_eq!(all.len(), 1, "a race without a time is none");
        assert_eq!((all[0].rows[0].engine.as_str(), all[0].base_ms), ("box3d", 3.0));
        let text = html(&records);
        assert!(
            text.contains("Box3D <b class=\"tag\">fastest</b></th><td>2</td><td>2</td><td>1.5</td>"),
            "{text}"
        );
        assert!(text.contains("<td><b>0.1</b></td>") && text.contains("<td>20</td>"), "{text}");
        assert!(!text.contains("NaN"));
    }

    #[test]
    fn panels_are_drawn_from_whatever_there_is() {
        for records in [vec![], vec![row("a", "merev", 1.0, f64::NAN), row("a", "x", 1e-9, -1.0)]] {
            for svg in panels(&records) {
                let text = svg.file();
                roxmltree::Document::parse(&text).unwrap();
                assert!(!text.contains("NaN") && !text.contains("inf\""));
            }
        }
    }
}
