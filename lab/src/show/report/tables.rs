//! Checks of the adapters, and what was run on what.

use super::super::axis::short;
use super::super::data::Data;
use super::super::palette;
use super::super::svg::escape;

pub fn checks(data: &Data) -> String {
    if data.checks.is_empty() {
        return "<p class=\"faint\">No checks were made.</p>".into();
    }
    let mut out = String::from(
        "<p>A wrong frame or unit in an adapter shows here: a box that spins about its stable axis, and the error of a \
         world in which nothing moves.</p>\n<div class=\"scroll\"><table><thead><tr><th>check</th><th>engine</th>\
         <th>value</th><th>bound</th><th>result</th></tr></thead><tbody>\n",
    );
    for check in &data.checks {
        let (class, word) = if check.pass { ("pass", "holds") } else { ("fail", "FAILS") };
        out += &format!(
            "<tr data-e=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"{class}\">{word}</td></tr>\n",
            escape(&check.engine),
            escape(&check.check),
            escape(&palette::title(&check.engine)),
            short(check.value),
            short(check.bound)
        );
    }
    out + "</tbody></table></div>\n"
}

pub fn meta(data: &Data) -> String {
    let mut out = String::from(
        "<p>Costs are CPU milliseconds of one thread for a simulated second, medians of repeats. Errors are divided by \
         the scene's natural scale; below 1e-12 they count as 1e-12. Where a scene was run both upright and turned as \
         a whole, the worse counts. Sleep is off. A setting is steps a second × sub-steps × sweeps; engines mean \
         different things by the last two, so compare costs, never counts.</p>\n",
    );
    let Some(meta) = &data.meta else {
        return out + "<p class=\"faint\">There is no meta.json beside the records.</p>\n";
    };
    out += "<div class=\"scroll\"><table><tbody>\n";
    let rows = [
        ("merev", meta.version.clone()),
        ("features", meta.features.join(", ")),
        ("compiler", meta.compiler.clone()),
        ("flags", meta.flags.clone()),
        ("machine", format!("{}, {} cores", meta.machine, meta.cores)),
        ("date", meta.date.clone()),
        ("command", meta.command.clone()),
        ("quick", if meta.quick { "yes".into() } else { "no".into() }),
    ];
    for (name, value) in rows {
        out += &format!("<tr><td>{name}</td><td style=\"text-align:left\">{}</td></tr>\n", escape(&value));
    }
    out + "</tbody></table></div>\n"
}
