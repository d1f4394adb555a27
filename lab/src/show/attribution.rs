//! Attribution bars: what remains of an error when one of its sources is made exact. A source whose bar is much
//! shorter than that of the total is where the error comes from.

use super::axis::{LogAxis, label, short};
use super::palette::{self, look};
use super::settings::distinct;
use super::svg::{Anchor, FAINT, GRID, INK, Svg};
use crate::records::Attribution;

const WIDTH: f64 = 440.0;
const LEFT: f64 = 130.0;
const RIGHT: f64 = 62.0;
const ROW: f64 = 17.0;

/// In the order in which bars stand; whatever else there is comes after.
const SOURCES: [(&str, &str); 5] = [
    ("total", "as it comes"),
    ("integrator", "integrator exact"),
    ("contact_law", "contact law exact"),
    ("solver", "solver exact"),
    ("geometry", "geometry exact"),
];

/// The bars of a scene, engine by engine; nothing if there are none.
pub fn draw(scene: &str, rows: &[Attribution], titled: bool) -> Option<Svg> {
    let own: Vec<&Attribution> =
        rows.iter().filter(|r| r.scene == scene && r.error.is_finite() && r.error >= 0.0).collect();
    if own.is_empty() {
        return None;
    }
    let mut engines = distinct(own.iter().map(|r| r.engine.as_str()));
    engines.sort_by(|a, b| palette::rank(a).cmp(&palette::rank(b)));
    let top = if titled { 32.0 } else { 6.0 };
    let height = top + own.len() as f64 * ROW + engines.len() as f64 * 22.0 + 40.0;
    let mut svg = Svg::new(WIDTH, height, &format!("Sources of the error in {scene}"));
    if titled {
        svg.text(WIDTH / 2.0, 20.0, Anchor::Middle, 14.0, INK, &format!("{scene}: sources of the error"));
    }
    // A logarithmic axis has no zero to begin at: bars begin a decade below the shortest.
    let errors = || own.iter().map(|r| r.error.max(1e-12));
    let start = errors().fold(f64::INFINITY, f64::min) / 10.0;
    let axis = LogAxis::around(errors().chain([start]), LEFT, WIDTH - RIGHT);
    let bottom = height - 36.0;
    for tick in axis.ticks() {
        let x = axis.pixel(tick);
        svg.line([x, top, x, bottom], GRID, 1.0, "", "grid");
        svg.text(x, bottom + 15.0, Anchor::Middle, 12.5, FAINT, &label(tick));
    }
    svg.text((LEFT + WIDTH - RIGHT) / 2.0, bottom + 31.0, Anchor::Middle, 13.0, INK, "error that remains");
    let mut y = top;
    for engine in &engines {
        let look = look(engine);
        svg.text(8.0, y + 15.0, Anchor::Start, 13.0, INK, &palette::title(engine));
        y += 22.0;
        let mut bars: Vec<&&Attribution> = own.iter().filter(|r| r.engine == *engine).collect();
        let place = |r: &Attribution| SOURCES.iter().position(|s| s.0 == r.source).unwrap_or(SOURCES.len());
        bars.sort_by_key(|r| place(r));
        for row in bars {
            let name = SOURCES.iter().find(|s| s.0 == row.source).map_or(row.source.as_str(), |s| s.1);
            svg.text(LEFT - 8.0, y + 10.0, Anchor::End, 12.0, INK, name);
            let x = axis.pixel(row.error.max(1e-12));
            let total = row.source == "total";
            svg.path(
                &format!("M{} {}H{}v11H{}Z", LEFT, super::svg::num(y + 1.0), super::svg::num(x), LEFT),
                &format!(
                    r#"class="f-{}" fill="{}" opacity="{}""#,
                    look.engine,
                    look.colour,
                    if total { "1" } else { "0.55" }
                ),
            );
            svg.text(x + 5.0, y + 10.0, Anchor::Start, 12.0, INK, &short(row.error));
            y += ROW;
        }
    }
    Some(svg)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_drawn_for_what_is_a_number() {
        let row = |source: &str, error| Attribution {
            scene: "s".into(),
            engine: "merev".into(),
            source: source.into(),
            error,
        };
        let rows = [row("solver", 0.0), row("total", 1e-3), row("magic", f64::NAN), row("else", 2.0)];
        let svg = draw("s", &rows, true).unwrap().file();
        roxmltree::Document::parse(&svg).unwrap();
        assert_eq!(svg.matches("class=\"f-merev\"").count(), 3);
        assert!(svg.find("as it comes") < svg.find("solver exact") && !svg.contains("NaN"));
        assert!(draw("t", &rows, true).is_none());
    }
}
