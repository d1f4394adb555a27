//! What is printed of a comparison.

use super::{Change, Findings, Options, Volume, is_ours};
use crate::records::Outcome;
use crate::show::settings::distinct;
use crate::table::Table;

/// How many lines of a list are shown.
const SHOWN: usize = 20;

pub fn text(findings: &Findings, options: &Options, machines: &(Option<String>, Option<String>)) -> String {
    let mut out = format!(
        "{} runs are in both; {} have the same outcome and an error with the same bits, {} differ.\n",
        findings.common,
        findings.same,
        findings.changes.len()
    );
    if findings.common == 0 {
        return out + "Nothing can be compared.\n";
    }
    if let (Some(before), Some(after)) = machines
        && before != after
    {
        out += &format!("The machine was {before} and is {after}: costs tell little.\n");
    }
    if findings.pace != 1.0 {
        out += &format!(
            "The other engines take {:.2} times what they did; costs are divided by that.\n",
            findings.pace
        );
    }
    if findings.noise > options.noise {
        out += &format!(
            "Costs of the other engines differ by up to {:.2} times from that, so that is the noise here.\n",
            findings.noise
        );
    }
    out += &changes("Worse: errors and outcomes", findings, |c| c.growth() > 1.0);
    out += &changes("Better: errors and outcomes", findings, |c| c.growth() < 1.0);
    out += &changes("Took too long in one of the two, and does not count", findings, Change::is_late);
    if !options.errors {
        out += &volumes(findings);
    }
    out += &medians(findings);
    out +=
        if findings.is_regression(options) { "\nmerev got worse.\n" } else { "\nmerev did not get worse.\n" };
    out
}

fn value((outcome, error): (Outcome, Option<f64>)) -> String {
    match (outcome, error) {
        (Outcome::Ok, Some(error)) => format!("{error:.3e}"),
        (outcome, _) => outcome.name().into(),
    }
}

fn changes(title: &str, findings: &Findings, choose: impl Fn(&Change) -> bool) -> String {
    let mut chosen: Vec<&Change> = findings.changes.iter().filter(|c| choose(c)).collect();
    if chosen.is_empty() {
        return String::new();
    }
    // The largest change first, whichever way; merev before the others.
    let size = |c: &Change| c.growth().max(1.0 / c.growth());
    chosen.sort_by(|a, b| (!is_ours(&a.engine)).cmp(&!is_ours(&b.engine)).then(size(b).total_cmp(&size(a))));
    let mut table = Table::new(&["scene", "engine", "setting", "error before", "now"]);
    for c in chosen.iter().take(SHOWN) {
        let mark = if c.is_default { " (default)" } else { "" };
        table.row([
            c.scene.clone(),
            c.engine.clone(),
            format!("{}{mark}", c.setting),
            value(c.before),
            value(c.after),
        ]);
    }
    let more = chosen.len().saturating_sub(SHOWN);
    let more = if more > 0 { format!("and {more} more\n") } else { String::new() };
    format!("\n{title}\n{table}{more}")
}

fn volumes(findings: &Findings) -> String {
    let mut out = String::new();
    for (title, choose) in [("Worse", Volume::is_worse as fn(&Volume) -> bool), ("Better", Volume::is_better)]
    {
        let mut chosen: Vec<&Volume> = findings.volumes.iter().filter(|v| choose(v)).collect();
        if chosen.is_empty() {
            continue;
        }
        chosen.sort_by(|a, b| (b.before - b.after).abs().total_cmp(&(a.before - a.after).abs()));
        let mut table = Table::new(&["scene", "engine", "before", "now", "least", "most"]);
        for v in chosen {
            let [before, after] = [v.before, v.after].map(|x| format!("{x:.3}"));
            let [most, least] = [v.bounds.0, v.bounds.1].map(|x| format!("{x:.3}"));
            table.row([v.scene.clone(), v.engine.clone(), before, after, least, most]);
        }
        out += &format!(
            "\n{title}: hypervolumes, with costs {:.2} times as high and as low\n{table}",
            findings.noise
        );
    }
    out
}

/// One line an engine: the quartiles over all scenes.
fn medians(findings: &Findings) -> String {
    let mut table =
        Table::new(&["engine", "scenes", "lower quartile", "median", "upper quartile", "median before"]);
    for engine in distinct(findings.volumes.iter().map(|v| v.engine.as_str())) {
        let own = findings.volumes.iter().filter(|v| v.engine == engine);
        let mut now: Vec<f64> = own.clone().map(|v| v.after).collect();
        let mut before: Vec<f64> = own.map(|v| v.before).collect();
        now.sort_by(f64::total_cmp);
        before.sort_by(f64::total_cmp);
        let at = |all: &[f64], share: f64| {
            format!("{:.3}", all[((all.len() - 1) as f64 * share).round() as usize])
        };
        let row = [at(&now, 0.25), at(&now, 0.5), at(&now, 0.75), at(&before, 0.5)];
        table.row([engine, now.len().to_string()].into_iter().chain(row));
    }
    format!("\nHypervolumes in decades × decades\n{table}")
}
