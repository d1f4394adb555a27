//! The work–precision chart of a scene: error against cost, both logarithmic; down and left is better.

use super::axis::{self, LogAxis};
use super::palette::{self, look};
use super::settings::{FLOOR, Setting, distinct};
use super::svg::{Anchor, FAINT, GRID, INK, Svg, escape, num, text_width};
use super::{order, pareto};
use crate::records::{Outcome, SceneRow};

const WIDTH: f64 = 440.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 14.0;
const PLOT: f64 = 290.0;
/// Errors beyond this are drawn on it: how wrong a result is matters no more.
const TOP_ERROR: f64 = 100.0;
/// Height of the strip for runs that failed.
const STRIP: f64 = 20.0;

/// Draws the chart. `settings` are those of the scene, each with its number in the data of the page. `titled`: with
/// the scene's name above, for a picture that stands alone.
pub fn draw(scene: &SceneRow, settings: &[(usize, &Setting)], titled: bool) -> Svg {
    let engines = engines(settings);
    let top = if titled { 34.0 } else { 8.0 } + STRIP;
    let legend_top = top + PLOT + 56.0;
    let legend: Vec<(&str, String)> = engines.iter().flat_map(|e| legend_of(e, settings)).collect();
    let height = legend_top + 18.0 * legend.len() as f64 + 8.0;
    let about = format!("Error against CPU milliseconds per simulated second in the scene {}", scene.scene);
    let mut svg = Svg::new(WIDTH, height, &about);
    if titled {
        svg.text(WIDTH / 2.0, 20.0, Anchor::Middle, 14.0, INK, &scene.scene);
    }

    let points = settings.iter().filter_map(|(_, s)| s.point());
    // Where things should stay where they are, nothing but round-off is wrong if nothing moves.
    let null_error = scene.null_error.filter(|e| e.is_finite() && *e > 1e-9);
    let costs = settings.iter().filter_map(|(_, s)| s.cost_ms);
    let x = LogAxis::around(costs, LEFT, WIDTH - RIGHT);
    let errors = points.map(|p| p.1.min(TOP_ERROR)).chain(null_error.map(|e| e.clamp(FLOOR, TOP_ERROR)));
    let y = LogAxis::around(errors, top + PLOT, top);

    let tick = |axis: &LogAxis| -> Vec<(f64, String)> {
        axis.ticks().into_iter().map(|v| (axis.pixel(v), axis::label(v))).collect()
    };
    let area = [LEFT, top, WIDTH - LEFT - RIGHT, PLOT];
    axis::frame(&mut svg, area, &tick(&x), &tick(&y), ["CPU ms per simulated second", "error"]);
    strip(&mut svg, top);
    for (bound, name) in [(2e-2, "looks right"), (1e-3, "engineering"), (1e-6, "reference")] {
        if y.holds(bound) {
            let py = y.pixel(bound);
            svg.line([LEFT, py, WIDTH - RIGHT, py], FAINT, 0.8, "1 4", "axis");
            svg.text(LEFT + 4.0, py - 3.0, Anchor::Start, 10.5, FAINT, name);
        }
    }
    if let Some(error) = null_error {
        let py = y.pixel(error);
        svg.line([LEFT, py, WIDTH - RIGHT, py], INK, 1.3, "7 4", "null");
        svg.text(WIDTH - RIGHT - 4.0, py - 4.0, Anchor::End, 11.5, INK, "nothing moves");
    }

    for engine in &engines {
        front_of(&mut svg, engine, settings, &x, &y);
    }
    for (index, setting) in settings {
        mark(&mut svg, *index, setting, &x, &y, top);
    }
    if settings.iter().all(|(_, s)| s.point().is_none()) {
        svg.text(
            WIDTH / 2.0,
            top + PLOT / 2.0,
            Anchor::Middle,
            13.0,
            FAINT,
            "no run ended with an error to show",
        );
    }
    for (k, (engine, text)) in legend.iter().enumerate() {
        legend_row(&mut svg, engine, text, legend_top + 18.0 * k as f64);
    }
    svg
}

fn engines(settings: &[(usize, &Setting)]) -> Vec<String> {
    let mut engines = distinct(settings.iter().map(|(_, s)| s.engine.as_str()));
    engines.sort_by(|a, b| palette::rank(a).cmp(&palette::rank(b)));
    engines
}

/// The strip above the plot, in which failed runs are marked.
fn strip(svg: &mut Svg, top: f64) {
    let y = top - STRIP;
    svg.rect([LEFT, y, WIDTH - LEFT - RIGHT, STRIP], GRID, "strip");
    svg.text(LEFT - 6.0, y + 14.0, Anchor::End, 12.0, FAINT, "failed");
}

/// The heavy line: from each point of the front along its error to the cost of the next, since whoever may spend
/// more may also stay with the cheaper setting.
fn front_of(svg: &mut Svg, engine: &str, settings: &[(usize, &Setting)], x: &LogAxis, y: &LogAxis) {
    let own = settings.iter().filter(|(_, s)| s.engine == engine).filter_map(|(_, s)| s.point());
    let front = pareto::front(own);
    let mut d = String::new();
    for (k, &(cost, error)) in front.iter().enumerate() {
        let (px, py) = (num(x.pixel(cost)), num(y.pixel(error)));
        d += &if k == 0 { format!("M{px} {py}") } else { format!("H{px}V{py}") };
    }
    if front.len() > 1 {
        let look = look(engine);
        let attributes = format!(
            r#"class="front s-{}" data-e="{}" fill="none" stroke="{}" stroke-width="2.6" stroke-linejoin="round""#,
            look.engine,
            escape(engine),
            look.colour
        );
        svg.path(&d, &attributes);
    }
}

/// The mark of a setting: filled in single precision, hollow in double; a ring around a default.
fn mark(svg: &mut Svg, index: usize, setting: &Setting, x: &LogAxis, y: &LogAxis, top: f64) {
    if setting.outcome == Outcome::Refused || (setting.outcome == Outcome::Ok && setting.point().is_none()) {
        return;
    }
    let look = look(&setting.engine);
    // A run that failed before its time was taken stands at the left end; one that took too long, at the right.
    let end = if setting.outcome == Outcome::Timeout { WIDTH - RIGHT - 6.0 } else { LEFT + 6.0 };
    let px = setting.cost_ms.map_or(end, |cost| x.pixel(cost));
    let py = setting.point().map_or(top - STRIP / 2.0, |(_, error)| y.pixel(error));
    let failed = setting.outcome != Outcome::Ok;
    let data = format!(
        r#"data-i="{index}" data-x="{}" data-y="{}" data-e="{}""#,
        num(px),
        num(py),
        escape(&setting.engine)
    );
    svg.open(&format!(r#"class="p{}" {data}"#, if failed { " failed" } else { "" }));
    if setting.as_it_comes && !failed {
        let ring = palette::Mark::Disc.path(px, py, 8.5);
        svg.path(&ring, &format!(r#"class="ring" fill="none" stroke="{INK}" stroke-width="1.6""#));
    }
    let (engine, colour) = (look.engine, look.colour);
    if failed {
        let (l, r, t, b) = (num(px - 3.5), num(px + 3.5), num(py - 3.5), num(py + 3.5));
        let d = format!("M{l} {t}L{r} {b}M{l} {b}L{r} {t}");
        svg.path(&d, &format!(r#"class="s-{engine}" fill="none" stroke="{colour}" stroke-width="1.7""#));
    } else {
        let radius = if setting.as_it_comes { 4.2 } else { 3.3 };
        let (fill, class) = if setting.precision == "f64" { ("none", "s") } else { (colour, "f") };
        let opacity = if setting.as_it_comes { "1" } else { "0.55" };
        svg.path(
            &look.mark.path(px, py, radius),
            &format!(
                r#"class="{class}-{engine}" fill="{fill}" stroke="{colour}" stroke-width="1.1" opacity="{opacity}""#
            ),
        );
    }
    svg.close();
}

/// The lines of the legend for an engine: its own method and those on its front, with the order that was measured.
fn legend_of<'a>(engine: &'a str, settings: &[(usize, &Setting)]) -> Vec<(&'a str, String)> {
    let own: Vec<&Setting> = settings.iter().map(|(_, s)| *s).filter(|s| s.engine == engine).collect();
    let name = palette::title(engine);
    if own.iter().all(|s| s.outcome == Outcome::Refused) {
        return vec![(engine, format!("{name} cannot run this"))];
    }
    let front = pareto::front(own.iter().filter_map(|s| s.point()));
    let leads = |s: &&&Setting| s.as_it_comes || s.point().is_some_and(|p| front.contains(&p));
    let methods = distinct(own.iter().filter(leads).map(|s| s.method.as_str()));
    let all = distinct(own.iter().map(|s| s.method.as_str())).len();
    let mut words: Vec<String> = Vec::new();
    for method in &methods {
        let of_method: Vec<&Setting> = own.iter().copied().filter(|s| s.method == *method).collect();
        // Round-off would bend the ladder of a lower precision: orders are taken apart, the higher one first.
        let mut precisions = distinct(of_method.iter().map(|s| s.precision.as_str()));
        precisions.sort_by(|a, b| b.cmp(a));
        let order = precisions
            .iter()
            .find_map(|p| order::of_method(of_method.iter().copied().filter(|s| s.precision == *p)));
        words.push(match order {
            Some(order) => format!("{method} (order {order:.1})"),
            None => method.clone(),
        });
    }
    if all > methods.len() {
        words.push(format!("{} more", all - methods.len()));
    }
    // As many methods a line as there is room for.
    let mut lines: Vec<(&str, String)> = Vec::new();
    let mut line = name;
    for (k, word) in words.into_iter().enumerate() {
        let longer = format!("{line}{} {word}", if k == 0 { " ·" } else { "," });
        if k > 0 && text_width(&longer, 12.0) > WIDTH - 30.0 {
            lines.push((engine, line + ","));
            line = format!("  {word}");
        } else {
            line = longer;
        }
    }
    lines.push((engine, line));
    lines
}

fn legend_row(svg: &mut Svg, engine: &str, text: &str, y: f64) {
    let look = look(engine);
    svg.open(&format!(r#"class="legend" data-e="{}""#, escape(engine)));
    if !text.starts_with(' ') {
        svg.path(
            &look.mark.path(16.0, y, 4.6),
            &format!(r#"class="f-{}" fill="{}""#, look.engine, look.colour),
        );
    }
    svg.text(27.0, y + 4.0, Anchor::Start, 12.0, INK, text);
    svg.close();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::WorkPrecision;
    use crate::show::samples::{run, scene};
    use crate::show::settings::settings;

    fn drawn(rows: &[WorkPrecision], null_error: Option<f64>) -> String {
        let all = settings(rows);
        let numbered: Vec<(usize, &Setting)> = all.iter().enumerate().collect();
        let svg = draw(&SceneRow { null_error, ..scene("s") }, &numbered, true).file();
        roxmltree::Document::parse(&svg).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        svg
    }

    #[test]
    fn a_chart_has_all_that_was_measured() {
        let mut rows: Vec<WorkPrecision> =
            [30.0, 60.0, 120.0, 240.0].map(|hz| run("s", "merev", hz, hz / 60.0, 0.1 / (hz * hz))).into();
        rows.push(WorkPrecision {
            outcome: Outcome::Exploded,
            error: None,
            ..run("s", "box3d", 60.0, 0.5, 1.0)
        });
        let svg = drawn(&rows, Some(1.0));
        assert_eq!(svg.matches("class=\"p\"").count(), 4);
        assert_eq!(svg.matches("class=\"p failed\"").count(), 1);
        assert_eq!(svg.matches("class=\"ring\"").count(), 1);
        assert_eq!(svg.matches("class=\"front ").count(), 1);
        assert!(svg.contains("soft_step (order 2.0)") && svg.contains("nothing moves"), "{svg}");
    }

    #[test]
    fn whatever_the_records_hold_a_chart_is_drawn() {
        let base = run("<s> & \"t\"", "merev", 60.0, 1.0, 1.0);
        let mut rows = vec![base.clone()];
        for (k, error) in
            [None, Some(f64::NAN), Some(f64::INFINITY), Some(0.0), Some(1e30)].into_iter().enumerate()
        {
            for outcome in [Outcome::Ok, Outcome::Nan, Outcome::Refused, Outcome::Timeout] {
                for cost_ms in [None, Some(f64::NAN), Some(0.0), Some(1e-9)] {
                    let rate_hz = [0.0, f64::NAN, 60.0][k % 3];
                    rows.push(WorkPrecision { outcome, error, cost_ms, rate_hz, ..base.clone() });
                }
            }
        }
        for row in &rows {
            drawn(std::slice::from_ref(row), Some(f64::NAN));
        }
        drawn(&rows, None);
        drawn(&[], Some(0.0));
    }
}
