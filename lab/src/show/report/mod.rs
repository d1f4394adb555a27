//! The report: one page that needs nothing else, from the records of a directory.

mod overview;
mod scenes;
mod tables;

use super::data::Data;
use super::palette::{LOOKS, Look};
use super::svg::escape;
use super::{palette, race_chart as race, stability_map as stability};

const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// The page.
pub fn page(data: &Data) -> String {
    let engines = data.engines();
    // Parts are put in one by one from the left, so that what a part says is never taken for a mark.
    let mut out = String::new();
    let mut rest = PAGE;
    while let Some((before, after)) = rest.split_once("{{") {
        let Some((name, after)) = after.split_once("}}") else { break };
        out += before;
        out += &match name {
            "css" => STYLE.replace("{{engines}}", &engine_styles()),
            "js" => SCRIPT.to_owned(),
            "intro" => overview::intro(data, &engines),
            "overview" => overview::overview(data),
            "filters" => scenes::filters(data, &engines),
            "scenes" => scenes::scenes(data, &engines),
            "stability" => stability_part(data),
            "race" => race_part(data),
            "checks" => tables::checks(data),
            "meta" => tables::meta(data),
            "data" => scenes::json(data),
            other => format!("<!-- no part {other} -->"),
        };
        rest = after;
    }
    out + rest
}

/// Colours of the engines on dark pages.
fn engine_styles() -> String {
    let mut out = String::from("@media (prefers-color-scheme: dark) {\n");
    for Look { engine, dark, .. } in LOOKS {
        out += &format!(
            "  svg .f-{engine} {{ fill: {dark}; stroke: {dark}; }} svg .s-{engine} {{ stroke: {dark}; }}\n"
        );
    }
    out + "}\n"
}

/// A mark as a small picture, for legends.
fn badge(engine: &str) -> String {
    let look = palette::look(engine);
    format!(
        r#"<svg viewBox="0 0 14 14" aria-hidden="true"><path class="f-{}" fill="{}" d="{}"/></svg>"#,
        look.engine,
        look.colour,
        look.mark.path(7.0, 7.0, 4.6)
    )
}

fn legend(engines: &[String]) -> String {
    let one = |e: &String| {
        format!("<span data-e=\"{}\">{}{}</span>", escape(e), badge(e), escape(&palette::title(e)))
    };
    format!("<div class=\"legend-line\">{}</div>\n", engines.iter().map(one).collect::<String>())
}

fn stability_part(data: &Data) -> String {
    if data.stability.is_empty() {
        return "<p class=\"faint\">Not measured: <code>merev stability</code> does.</p>".into();
    }
    format!(
        "<p>The hardest value of each stressor that a method survives, found by bisection. Within a row darker bears \
         more; ≥ or ≤ marks the hardest value that was tried; <i>none</i>: the mildest failed already. Point at a \
         cell to see how it fails.</p>\n<div class=\"scroll\">{}</div>\n",
        stability::html(&data.stability)
    )
}

fn race_part(data: &Data) -> String {
    if data.race.is_empty() {
        return "<p class=\"faint\">Not measured: <code>merev race</code> does.</p>".into();
    }
    let mut engines = super::settings::distinct(data.race.iter().map(|r| r.engine.as_str()));
    engines.sort_by(|a, b| palette::rank(a).cmp(&palette::rank(b)));
    let [times, overlaps] = race::panels(&data.race);
    format!(
        "<p>Milliseconds a step, runs in turns in one process, one thread; and what came of it, measured by one ruler \
         for all engines. <i>merev / it</i> above 1: that engine takes less time than merev. The best of each quality \
         is bold.</p>\n{}<div class=\"panels two\">{}{}</div>\n<div class=\"scroll\">{}</div>\n",
        legend(&engines),
        times.inline(),
        overlaps.inline(),
        race::html(&data.race)
    )
}

#[cfg(test)]
mod browser_test;
#[cfg(test)]
mod tests;
#[cfg(test)]
pub use tests::sample;
