//! All scenes at once: performance profiles and data profiles.

use super::axis::{self, LogAxis, label};
use super::data::{Data, Entrant};
use super::palette::look;
use super::profile::{self, BUDGETS_MS, FRAMES, Steps, TOLERANCES};
use super::svg::{Anchor, FAINT, INK, Svg};

const WIDTH: f64 = 340.0;
const LEFT: f64 = 50.0;
const TOP: f64 = 30.0;
const PLOT: [f64; 2] = [WIDTH - LEFT - 12.0, 200.0];

/// A panel for each tolerance: how often an engine costs at most τ times the best.
pub fn performance(data: &Data, entrants: &[Entrant]) -> Vec<Svg> {
    let panel = |tolerance| {
        let curves = profile::performance(&data.costs(entrants, tolerance), entrants.len());
        let ends = curves.iter().flat_map(|c| c.0.iter().map(|step| step.0));
        let high = ends.fold(10.0, f64::max) * 1.15;
        let axis = LogAxis::new(1.0, high, LEFT, LEFT + PLOT[0]);
        let ticks = axis.ticks().into_iter().map(|v| (axis.pixel(v), label(v))).collect::<Vec<_>>();
        let name = format!("performance, error ≤ {}", label(tolerance));
        panel(&name, "cost over that of the best", entrants, &curves, &axis, &ticks, 1.0)
    };
    TOLERANCES.into_iter().map(panel).collect()
}

/// A panel for each tolerance: how many scenes an engine solves with a budget of so many milliseconds a frame.
pub fn budget(data: &Data, entrants: &[Entrant]) -> Vec<Svg> {
    let panel = |tolerance| {
        let curves = budget_curves(data, entrants, tolerance);
        let ends = curves.iter().flat_map(|c| c.0.iter().map(|step| step.0));
        let (low, high) = ends.fold((0.25, 32.0), |(low, high): (f64, f64), x| (low.min(x), high.max(x)));
        let axis = LogAxis::new(low / 1.5, 2.0 * high, LEFT, LEFT + PLOT[0]);
        let mut ticks: Vec<(f64, String)> = BUDGETS_MS.map(|ms| (axis.pixel(ms), label(ms))).into();
        ticks.extend(
            axis.ticks().into_iter().filter(|v| *v < 0.2 || *v > 32.0).map(|v| (axis.pixel(v), label(v))),
        );
        // Numbers that would run into each other are left out, those of the budgets last of all.
        let mut kept: Vec<(f64, String)> = Vec::new();
        for tick in ticks {
            if kept.iter().all(|k| (k.0 - tick.0).abs() > 17.0) {
                kept.push(tick);
            }
        }
        let name = format!("budget, error ≤ {}", label(tolerance));
        panel(&name, "CPU ms a frame at 60 Hz", entrants, &curves, &axis, &kept, low / 1.5)
    };
    TOLERANCES.into_iter().map(panel).collect()
}

/// Data profiles over milliseconds a frame.
pub fn budget_curves(data: &Data, entrants: &[Entrant], tolerance: f64) -> Vec<Steps> {
    let mut costs = data.costs(entrants, tolerance);
    costs.iter_mut().flatten().flatten().for_each(|cost| *cost /= FRAMES);
    profile::data(&costs, entrants.len())
}

fn panel(
    name: &str,
    x_name: &str,
    entrants: &[Entrant],
    curves: &[Steps],
    x: &LogAxis,
    ticks: &[(f64, String)],
    start: f64,
) -> Svg {
    let mut svg = Svg::new(WIDTH, TOP + PLOT[1] + 42.0, &format!("Share of scenes: {name}"));
    svg.text(LEFT + PLOT[0] / 2.0, 18.0, Anchor::Middle, 12.5, INK, name);
    let y = |share: f64| TOP + PLOT[1] * (1.0 - share / 1.04);
    let shares = [0.0, 0.25, 0.5, 0.75, 1.0].map(|s| (y(s), format!("{} %", 100.0 * s)));
    axis::frame(&mut svg, [LEFT, TOP, PLOT[0], PLOT[1]], ticks, &shares, [x_name, ""]);
    // The first engine is drawn last, so that none lies over it.
    for (k, (entrant, curve)) in entrants.iter().zip(curves).enumerate().rev() {
        let look = look(&entrant.engine);
        // Curves that run together lie beside each other instead.
        let shift = 1.1 * k as f64;
        let mut d = format!("M{} {}", super::svg::num(x.pixel(start)), super::svg::num(y(0.0) - shift));
        for &(at, share) in &curve.0 {
            d += &format!("H{}V{}", super::svg::num(x.pixel(at)), super::svg::num(y(share) - shift));
        }
        d += &format!("H{}", super::svg::num(LEFT + PLOT[0]));
        svg.path(
            &d,
            &format!(
                r#"class="s-{}" fill="none" stroke="{}" stroke-width="2.2" stroke-linejoin="round"{}"#,
                look.engine,
                look.colour,
                if entrant.choice.is_some() { r#" stroke-dasharray="5 3""# } else { "" }
            ),
        );
        let at = LEFT + PLOT[0] - 8.0 - 13.0 * k as f64;
        let mark = look.mark.path(at, y(curve.at(x.value(at))) - shift, 4.0);
        svg.path(&mark, &fill_of(entrant));
    }
    svg
}

/// Panels side by side with a legend below, for a picture that stands alone.
pub fn sheet(title: &str, panels: &[Svg], entrants: &[Entrant]) -> Svg {
    let width = panels.iter().map(|p| p.width).sum::<f64>().max(WIDTH);
    let tall = panels.iter().map(|p| p.height).fold(0.0, f64::max);
    // Marks and names from left to right, in as many rows as they need.
    let wide = |e: &Entrant| 34.0 + super::svg::text_width(&e.name(), 12.0);
    let (mut places, mut x, mut y) = (Vec::new(), LEFT, tall + 50.0);
    for entrant in entrants {
        if x + wide(entrant) > width && x > LEFT {
            (x, y) = (LEFT, y + 20.0);
        }
        places.push((x, y));
        x += wide(entrant);
    }
    let mut svg = Svg::new(width, y + 16.0, title);
    svg.text(width / 2.0, 22.0, Anchor::Middle, 15.0, INK, title);
    let mut x = 0.0;
    for panel in panels {
        svg.place(x, 32.0, panel);
        x += panel.width;
    }
    for (entrant, (x, y)) in entrants.iter().zip(places) {
        let (look, name) = (look(&entrant.engine), entrant.name());
        svg.path(&look.mark.path(x, y, 4.5), &fill_of(entrant));
        svg.text(x + 10.0, y + 4.0, Anchor::Start, 12.0, INK, &name);
    }
    if entrants.is_empty() {
        svg.text(width / 2.0, tall + 54.0, Anchor::Middle, 12.0, FAINT, "no engine was run");
    }
    svg
}

/// How an entrant's mark is filled: hollow where it may choose its method.
pub fn fill_of(entrant: &Entrant) -> String {
    let look = look(&entrant.engine);
    let (engine, colour) = (look.engine, look.colour);
    if entrant.choice.is_some() {
        format!(r##"class="s-{engine} hollow" fill="#ffffff" stroke="{colour}" stroke-width="1.6""##)
    } else {
        format!(r#"class="f-{engine}" fill="{colour}""#)
    }
}
