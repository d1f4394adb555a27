//! The head of the page: what was measured, who wins, where merev loses.

use super::super::axis::label;
use super::super::data::{Data, Entrant};
use super::super::overview as panels;
use super::super::profile::{BUDGETS_MS, TOLERANCES};
use super::super::svg::escape;
use super::super::verdict::{self, Duel};
use super::super::{palette, settings::distinct};

pub fn intro(data: &Data, engines: &[String]) -> String {
    let names: Vec<String> = engines.iter().map(|e| escape(&palette::title(e))).collect();
    let runs: usize = data.settings.iter().map(|s| s.runs).sum();
    let mut out = format!(
        "<p>{} scenes, each with a reference that no engine has a say in; {runs} runs of {}. Every point is a \
         setting; the cost is CPU time of one thread.</p>\n",
        data.scenes.len(),
        if names.is_empty() { "no engine".to_owned() } else { names.join(", ") }
    );
    if let Some(meta) = &data.meta {
        let quick = if meta.quick {
            " A quick run: few settings and few repeats, so read it as a sketch."
        } else {
            ""
        };
        out += &format!(
            "<p class=\"faint\">{} · {} · {} · merev {}.{quick}</p>\n",
            escape(&meta.date),
            escape(&meta.machine),
            escape(&meta.compiler),
            escape(&meta.version)
        );
    }
    out
}

pub fn overview(data: &Data) -> String {
    let entrants = &data.entrants();
    let mut out = String::from(
        "<p>Everybody stands here with the method it comes with, at the best of its settings. Where an engine has \
         several methods, a dashed line shows what choosing the best of them for each scene would give; that is \
         knowledge which nobody has beforehand, so it takes no part in the verdicts.</p>\n<div class=\"verdicts\">\n",
    );
    if !data.settings.is_empty() {
        out += &card("Error at default settings (below 1e-6: even)", &verdict(&verdict::defaults(data)));
    }
    for tolerance in TOLERANCES {
        let about = format!("Least cost at error ≤ {}", label(tolerance));
        let mut said = solved(data, entrants, tolerance);
        said += &verdict(&verdict::precision(data, tolerance));
        out += &card(&about, &said);
    }
    if !data.stability.is_empty() {
        out += &card("Stressors", &verdict(&verdict::stressors(&data.stability)));
    }
    if !data.race.is_empty() {
        out += &card("Time a step", &verdict(&verdict::races(&data.race)));
    }
    let failed: Vec<&str> = data.checks.iter().filter(|c| !c.pass).map(|c| c.check.as_str()).collect();
    if !failed.is_empty() {
        let text =
            format!("<p><span class=\"lose\">Failed:</span> {}</p>", escape(&distinct(failed).join(", ")));
        out += &card("Checks of the adapters", &text);
    }
    out += "</div>\n";
    if data.settings.is_empty() {
        return out + "<p class=\"faint\">No work–precision runs: <code>merev chart</code> makes them.</p>\n";
    }
    let inline = |svgs: Vec<super::super::svg::Svg>| svgs.iter().map(|s| s.inline()).collect::<String>();
    out += &legend(entrants);
    out += "<h4>How many scenes within a budget</h4>\n<p>The share of scenes that an engine solves to the error named, \
            with the best of its settings that fits the budget. Higher is better.</p>\n";
    out += &format!("<div class=\"panels\">{}</div>\n", inline(panels::budget(data, entrants)));
    out += &format!("<div class=\"scroll\">{}</div>\n", budget_table(data, entrants));
    out += "<h4>How often close to the best</h4>\n<p>The share of scenes that an engine solves at no more than so many \
            times the cost of whoever is cheapest there. The left end tells how often it wins, the right end how often \
            it gets there at all. Only the leading curve is safe to name: how the others rank depends on it.</p>\n";
    out + &format!("<div class=\"panels\">{}</div>\n", inline(panels::performance(data, entrants)))
}

fn card(title: &str, body: &str) -> String {
    format!("<div class=\"verdict\"><h4>{}</h4>{body}</div>\n", escape(title))
}

/// How many scenes each entrant solves at all.
fn solved(data: &Data, entrants: &[Entrant], tolerance: f64) -> String {
    let costs = data.costs(entrants, tolerance);
    let count = |k: usize| costs.iter().filter(|row| row.get(k).is_some_and(Option::is_some)).count();
    let said: Vec<String> =
        entrants.iter().enumerate().map(|(k, e)| format!("{}: {}", escape(&e.name()), count(k))).collect();
    format!("<p>Of {} scenes solved by {}.</p>", costs.len(), said.join("; "))
}

/// How many losses are named before the fold.
const NAMED: usize = 8;

fn verdict(duels: &[Duel]) -> String {
    if duels.is_empty() {
        return "<p class=\"faint\">No other engine to compare with.</p>".into();
    }
    let (even, rest): (Vec<&Duel>, Vec<&Duel>) = duels.iter().partition(|d| d.is_even());
    let (mut lost, won): (Vec<&Duel>, Vec<&Duel>) = rest.into_iter().partition(|d| d.is_lost());
    lost.sort_by(|a, b| a.factor.total_cmp(&b.factor));
    let mut out = format!(
        "<p>Against the best of the others merev <span class=\"win\">wins {}</span>, <span class=\"lose\">loses \
         {}</span>, even {}.</p>",
        won.len(),
        lost.len(),
        even.len()
    );
    let words = |duels: &[&Duel]| duels.iter().map(|d| escape(&d.words())).collect::<Vec<_>>().join("; ");
    if !lost.is_empty() {
        let (first, more) = lost.split_at(lost.len().min(NAMED));
        out += &format!("<p><span class=\"lose\">Where it loses:</span> {}.</p>", words(first));
        if !more.is_empty() {
            out += &format!(
                "<details><summary>and in {} more</summary><p>{}.</p></details>",
                more.len(),
                words(more)
            );
        }
    }
    if !won.is_empty() {
        out += &format!("<details><summary>Where it wins</summary><p>{}.</p></details>", words(&won));
    }
    if !even.is_empty() {
        out += &format!("<details><summary>Where it is even</summary><p>{}.</p></details>", words(&even));
    }
    out
}

/// Share of scenes by engine, tolerance and budget.
fn budget_table(data: &Data, entrants: &[Entrant]) -> String {
    let mut out = String::from("<table><thead><tr><th>share of scenes solved</th>");
    for tolerance in TOLERANCES {
        for budget in BUDGETS_MS {
            out += &format!("<th>{}<small>{} ms</small></th>", label(tolerance), label(budget));
        }
    }
    out += "</tr></thead><tbody>\n";
    let curves = TOLERANCES.map(|tolerance| panels::budget_curves(data, entrants, tolerance));
    for (k, entrant) in entrants.iter().enumerate() {
        let (engine, name) = (escape(&entrant.engine), escape(&entrant.name()));
        out += &format!("<tr data-e=\"{engine}\"><td>{name}</td>");
        for (curves, _) in curves.iter().zip(TOLERANCES) {
            for budget in BUDGETS_MS {
                let share = curves[k].at(budget);
                let rivals = entrants.iter().zip(curves).filter(|(e, _)| e.choice.is_none());
                let leads = rivals.map(|(_, c)| c.at(budget)).all(|other| other <= share);
                let best = leads && share > 0.0 && entrant.choice.is_none();
                let text = format!("{:.0} %", 100.0 * share);
                out += &if best { format!("<td><b>{text}</b></td>") } else { format!("<td>{text}</td>") };
            }
        }
        out += "</tr>\n";
    }
    out + "</tbody></table>"
}

/// The entrants' marks and names.
fn legend(entrants: &[Entrant]) -> String {
    let one = |e: &Entrant| {
        format!(
            "<span><svg viewBox=\"0 0 14 14\" aria-hidden=\"true\"><path {} d=\"{}\"/></svg>{}</span>",
            panels::fill_of(e),
            palette::look(&e.engine).mark.path(7.0, 7.0, 4.6),
            escape(&e.name())
        )
    };
    format!("<div class=\"legend-line\">{}</div>\n", entrants.iter().map(one).collect::<String>())
}
