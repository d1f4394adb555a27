//! A card for each scene: what it is, its chart, the sources of its error, and its numbers.

use super::super::axis::{label, short};
use super::super::data::Data;
use super::super::profile::{BUDGETS_MS, FRAMES};
use super::super::settings::{Setting, distinct};
use super::super::svg::escape;
use super::super::{attribution, order, palette, pareto, work_precision};
use super::badge;
use crate::records::{Outcome, SceneRow};
use serde_json::json;
use std::collections::BTreeMap;

/// What the groups of scenes are about.
const GROUPS: [(&str, &str); 10] = [
    ("A", "free motion"),
    ("B", "contact and restitution"),
    ("C", "friction and rolling"),
    ("D", "stacks and mass ratios"),
    ("E", "joints and chains"),
    ("F", "fast bodies"),
    ("G", "geometry"),
    ("H", "scale and precision"),
    ("I", "long runs"),
    ("J", "ensembles and chaos"),
];

pub fn filters(data: &Data, engines: &[String]) -> String {
    let mut out = String::from("<form class=\"filters\"><fieldset><legend>Engines</legend>");
    for engine in engines {
        let (name, e) = (escape(&palette::title(engine)), escape(engine));
        out += &format!(
            "<label><input type=\"checkbox\" name=\"engine\" value=\"{e}\" checked>{}{name}</label>",
            badge(engine)
        );
    }
    out += "</fieldset>";
    let select = |name: &str, all: &str, values: Vec<(String, String)>| {
        let options: String = values
            .iter()
            .map(|(v, t)| format!("<option value=\"{}\">{}</option>", escape(v), escape(t)))
            .collect();
        format!(
            "<label>{name} <select name=\"{name}\"><option value=\"\">{all}</option>{options}</select></label>"
        )
    };
    let mut groups = distinct(data.scenes.iter().map(|s| s.group.as_str()));
    groups.sort();
    let named = |g: String| {
        let about = GROUPS.iter().find(|known| known.0 == g).map(|known| format!(": {}", known.1));
        (g.clone(), g + &about.unwrap_or_default())
    };
    out += &select("group", "all", groups.into_iter().map(named).collect());
    let same = |all: Vec<String>| all.into_iter().map(|v| (v.clone(), v)).collect();
    out += &select("method", "all", same(distinct(data.settings.iter().map(|s| s.method.as_str()))));
    out += &select("precision", "both", same(distinct(data.settings.iter().map(|s| s.precision.as_str()))));
    out + "</form>\n<p class=\"faint\">Down and left is better. The heavy line is the best an engine does at each cost; \
           rings are settings as the engine comes; hollow marks are double precision; crosses above are runs that \
           failed. The dashed line is the error of a world in which nothing moves: a result near it says nothing. \
           Point at a mark, or touch it, to read it.</p>\n"
}

pub fn scenes(data: &Data, engines: &[String]) -> String {
    let mut out = String::from("<div class=\"scenes\">\n");
    for scene in &data.scenes {
        out += &card(data, scene, engines);
    }
    out + "</div>\n"
}

fn card(data: &Data, scene: &SceneRow, engines: &[String]) -> String {
    let settings = data.settings_of(&scene.scene);
    let mut out = format!(
        "<article class=\"scene\" id=\"scene-{0}\" data-group=\"{1}\"><h3>{0}</h3><p>{2}</p>\n",
        escape(&scene.scene),
        escape(&scene.group),
        escape(&scene.about)
    );
    let null = scene.null_error.filter(|e| e.is_finite()).map_or("–".to_owned(), short);
    let (scale, seconds) = (short(scene.scale), short(scene.duration_s));
    // "1" is how a scale without a unit is written.
    let unit = if scene.scale_unit == "1" { String::new() } else { escape(&scene.scale_unit) };
    out += &format!(
        "<dl><dt>reference</dt><dd>{}</dd><dt>error</dt><dd>{}; over {scale} {unit}</dd>\
         <dt>if nothing moved</dt><dd>{null}</dd><dt>simulated</dt><dd>{seconds} s</dd></dl>\n",
        escape(&scene.reference),
        escape(&scene.primary)
    );
    if settings.is_empty() {
        out += "<p class=\"faint\">Not run.</p>\n";
    } else if settings.iter().all(|(_, s)| s.outcome == Outcome::Refused) {
        out += "<p class=\"faint\">Refused by every engine here, or not possible yet.</p>\n";
    } else {
        out += &format!(
            "<div class=\"chart\">{}</div>\n",
            work_precision::draw(scene, &settings, false).inline()
        );
        out += &format!(
            "<details><summary>Numbers</summary><div class=\"scroll\">{}</div><div class=\"scroll\">{}</div></details>\n",
            numbers(&settings, engines),
            methods(&settings, engines)
        );
    }
    if let Some(bars) = attribution::draw(&scene.scene, &data.attribution, false) {
        out +=
            &format!("<details><summary>Where the error comes from</summary>{}</details>\n", bars.inline());
    }
    out + "</article>\n"
}

/// Each engine: as it comes, the least error within each budget, and how many settings failed.
fn numbers(settings: &[(usize, &Setting)], engines: &[String]) -> String {
    let mut out = String::from(
        "<table><thead><tr><th>engine</th><th>default<small>error</small></th><th>default<small>CPU ms/s</small></th>",
    );
    for budget in BUDGETS_MS {
        out += &format!("<th>error within<small>{} ms a frame</small></th>", label(budget));
    }
    out += "<th>failed</th></tr></thead><tbody>\n";
    for engine in engines {
        let own: Vec<&Setting> = settings.iter().map(|(_, s)| *s).filter(|s| s.engine == *engine).collect();
        if own.is_empty() {
            continue;
        }
        let default = own.iter().find(|s| s.as_it_comes);
        let error = match default {
            Some(s) if s.outcome != Outcome::Ok => s.outcome.name().to_owned(),
            Some(s) => s.error.map_or("–".to_owned(), short),
            None => "–".to_owned(),
        };
        let cost = default.and_then(|s| s.cost_ms).map_or("–".to_owned(), short);
        let (e, name) = (escape(engine), escape(&palette::title(engine)));
        out += &format!("<tr data-e=\"{e}\"><td>{name}</td><td>{error}</td><td>{cost}</td>");
        let front = pareto::front(own.iter().filter_map(|s| s.point()));
        for budget in BUDGETS_MS {
            let text = pareto::error_within(&front, budget * FRAMES).map_or("–".to_owned(), short);
            out += &format!("<td>{text}</td>");
        }
        let ran = own.iter().filter(|s| s.outcome != Outcome::Refused);
        let failed = ran.clone().filter(|s| s.outcome != Outcome::Ok).count();
        out += &format!("<td>{failed} of {}</td></tr>\n", ran.count());
    }
    out + "</tbody></table>"
}

/// Each method: its measured order, what it does by default, and how exact it gets at all.
fn methods(settings: &[(usize, &Setting)], engines: &[String]) -> String {
    let mut out = String::from(
        "<table><thead><tr><th>method</th><th>order</th><th>default<small>error</small></th>\
         <th>default<small>CPU ms/s</small></th><th>least error</th><th>failed</th></tr></thead><tbody>\n",
    );
    for engine in engines {
        let own: Vec<&Setting> = settings.iter().map(|(_, s)| *s).filter(|s| s.engine == *engine).collect();
        for (method, precision) in pairs(&own) {
            let ran: Vec<&Setting> =
                own.iter().copied().filter(|s| s.method == method && s.precision == precision).collect();
            let default = ran.iter().find(|s| s.is_default);
            let error = default.map_or("–".to_owned(), |s| s.error.map_or(s.outcome.name().into(), short));
            let cost = default.and_then(|s| s.cost_ms).map_or("–".to_owned(), short);
            let order = order::of_method(ran.iter().copied()).map_or("–".to_owned(), |p| format!("{p:.1}"));
            let least = ran.iter().filter_map(|s| s.error).fold(f64::INFINITY, f64::min);
            let failed = ran.iter().filter(|s| s.outcome != Outcome::Ok).count();
            out += &format!(
                "<tr data-e=\"{}\"><td>{}, {} {}</td><td>{order}</td><td>{error}</td><td>{cost}</td><td>{}</td>\
                 <td>{failed} of {}</td></tr>\n",
                escape(engine),
                escape(&palette::title(engine)),
                escape(&method).replace('/', "/<wbr>").replace('_', "_<wbr>"),
                escape(&precision),
                short(least),
                ran.len()
            );
        }
    }
    out + "</tbody></table>"
}

/// Methods and precisions that were run, each once.
fn pairs(settings: &[&Setting]) -> Vec<(String, String)> {
    let mut all = Vec::new();
    for setting in settings {
        let pair = (setting.method.clone(), setting.precision.clone());
        if !all.contains(&pair) {
            all.push(pair);
        }
    }
    all
}

/// What is said of each mark.
pub fn json(data: &Data) -> String {
    type Key<'a> = (&'a str, &'a str, &'a str, &'a str, u64, u32, u32, Option<u64>);
    let mut further: BTreeMap<Key, BTreeMap<&str, f64>> = BTreeMap::new();
    for row in &data.secondary {
        let accuracy = row.accuracy.map(f64::to_bits);
        let key: Key = (
            &row.scene,
            &row.engine,
            &row.method,
            &row.precision,
            row.rate_hz.to_bits(),
            row.sub_steps,
            row.iterations,
            accuracy,
        );
        // Of the two orientations the worse.
        let known = further.entry(key).or_default().entry(&row.metric).or_insert(row.value);
        if row.value.abs() > known.abs() {
            *known = row.value;
        }
    }
    let run = |s: &Setting| {
        let mut lines = Vec::new();
        match (s.outcome, s.error) {
            (Outcome::Ok, Some(error)) => lines.push(format!("error {}", short(error))),
            (outcome, _) => lines.push(outcome.name().to_owned()),
        }
        if let Some(cost) = s.cost_ms {
            lines.push(format!("{} CPU ms a second, {} ms a frame", short(cost), short(cost / FRAMES)));
        }
        if s.as_it_comes {
            lines.push("as the engine comes".into());
        }
        let accuracy = s.accuracy.map(f64::to_bits);
        let key: Key = (
            &s.scene,
            &s.engine,
            &s.method,
            &s.precision,
            s.rate_hz.to_bits(),
            s.sub_steps,
            s.iterations,
            accuracy,
        );
        if let Some(metrics) = further.get(&key) {
            lines.extend(metrics.iter().map(|(name, v)| format!("{} {}", name.replace('_', " "), short(*v))));
        }
        json!({
            "engine": s.engine, "title": palette::title(&s.engine), "method": s.method, "precision": s.precision,
            "setting": s.words(), "lines": lines,
        })
    };
    let runs: Vec<_> = data.settings.iter().map(run).collect();
    // Within a script element no text may close it.
    json!({ "runs": runs }).to_string().replace('<', "\\u003c")
}
