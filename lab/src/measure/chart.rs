//! Work against precision: every case on every method with every setting of its ladder.

use super::workers::{self, Claims};
use super::{Options, attribution, checks, cost, ladder, meta, tells, timed_scene, try_case};
use crate::case::{Case, Trial};
use crate::engines::{Maker, Method, Setting};
use crate::progress;
use crate::records::{Attribution, Log, Outcome, Record, SceneRow, Secondary, WorkPrecision};
use crate::scenes;
use crate::table::{Table, milliseconds};
use indicatif::ProgressBar;
use std::collections::BTreeMap;
use std::time::Duration;

/// A point to be measured.
struct Point<'a> {
    case: &'a Case,
    maker: Maker,
    method: Method,
    setting: Setting,
    is_default: bool,
    turned: bool,
}

impl Point<'_> {
    fn row(&self) -> WorkPrecision {
        WorkPrecision {
            scene: self.case.name.into(),
            group: self.case.group.into(),
            engine: self.maker.key.into(),
            method: self.method.name(),
            precision: self.maker.precision.into(),
            turned: self.turned.into(),
            rate_hz: self.setting.rate,
            sub_steps: self.setting.sub_steps,
            iterations: self.setting.iterations,
            accuracy: self.setting.accuracy,
            is_default: self.is_default.into(),
            outcome: Outcome::Refused,
            error: None,
            cost_ms: None,
            resumed: 0,
        }
    }

    /// Fills in outcome, error and cost; gives further measures.
    fn measure(&self, options: &Options, row: &mut WorkPrecision) -> Vec<(&'static str, f64)> {
        let Self { case, maker, method, setting, turned, .. } = self;
        let is_first = *method == (maker.methods)()[0];
        let result = try_case(case, maker, method, setting, *turned, options.budget_of(is_first));
        (row.outcome, row.error) = (result.outcome, result.error);
        let in_time = !matches!(result.outcome, Outcome::Timeout | Outcome::Refused);
        // A short chart does not run a second time what has taken long: reading is little of that.
        let long = 1e3 * LONG / case.duration;
        row.cost_ms = result.cost_ms.filter(|&ms| options.quick && ms > long);
        if row.cost_ms.is_none()
            && in_time
            && let Some(scene) = timed_scene(case)
        {
            let budget = Duration::from_secs_f64(if options.quick { 0.04 } else { 0.25 });
            let whole = if *turned { scene.turned(crate::case::TURN) } else { scene };
            row.cost_ms = cost(maker, &whole, method, setting, case.duration, budget);
        }
        result.more
    }

    /// Whether this one is at least as hard on the same method as another that took too long.
    fn is_beyond(&self, other: &Point) -> bool {
        self.case.name == other.case.name
            && self.maker.key == other.maker.key
            && self.method == other.method
            && self.setting.accuracy.is_some() == other.setting.accuracy.is_some()
            && ladder::work(&self.setting) >= ladder::work(&other.setting)
    }
}

/// A run that has taken as long as this \[s\] tells its cost well enough for a short chart.
const LONG: f64 = 0.1;

/// Everything there is to measure, in order.
fn points<'a>(cases: &'a [Case], options: &Options) -> Vec<Point<'a>> {
    let mut all = Vec::new();
    for case in cases {
        for maker in options.makers() {
            let methods = (maker.methods)();
            for (i, &method) in methods.iter().enumerate() {
                if matches!(case.trial, Trial::Missing) && i > 0 || !tells(case, &method, &methods[0]) {
                    continue;
                }
                for (setting, is_default) in ladder::rungs(case, &maker, &method, i == 0, options.quick) {
                    if matches!(case.trial, Trial::Missing) && !is_default {
                        continue;
                    }
                    all.push(Point { case, maker, method, setting, is_default, turned: false });
                    if is_default && i == 0 && !matches!(case.trial, Trial::Missing) {
                        all.push(Point { case, maker, method, setting, is_default, turned: true });
                    }
                }
            }
        }
    }
    all
}

/// Measures what is not there yet, and says what the defaults give.
///
/// # Errors
/// What the file system says.
pub fn run(options: &Options) -> Result<String, String> {
    let cases: Vec<Case> = scenes::cases().into_iter().filter(|c| options.wants(c.name)).collect();
    let points = points(&cases, options);
    if let Some(worker) = options.worker {
        return measure(options, &cases, &points, worker.resumed, &ProgressBar::hidden());
    }
    let log = Log::<WorkPrecision>::open(&options.directory, options.fresh)?;
    Log::<Secondary>::open(&options.directory, options.fresh)?;
    Log::<Attribution>::open(&options.directory, options.fresh)?;
    meta::write(options, "chart")?;
    write_scenes(&cases, options)?;
    let checks = checks::run(options)?;
    let bar = progress::bar(points.len() as u64, "chart");
    if options.jobs > 1 {
        let path = options.directory.join(WorkPrecision::FILE);
        let before = log.rows().len() as u64;
        let done = || workers::count(&path) - before;
        workers::run(options, "chart", log.is_resumed(), &bar, &done, &mut |key| {
            crashed(options, &points, key)
        })?;
    } else {
        measure(options, &cases, &points, log.is_resumed(), &bar)?;
    }
    bar.finish_and_clear();
    let log = in_order(options, &points)?;
    let attribution = attribution::finish(options, &cases, log.rows())?;
    Ok(format!("{}\n{checks}\n{attribution}", summary(&cases, options, log.rows())))
}

/// Takes case after case on method after method until all are taken.
fn measure(
    options: &Options,
    cases: &[Case],
    points: &[Point],
    resumed: bool,
    bar: &ProgressBar,
) -> Result<String, String> {
    let options = &Options { fresh: false, ..options.clone() };
    let mut log = Log::<WorkPrecision>::open(&options.directory, false)?;
    let mut more = Log::<Secondary>::open(&options.directory, false)?;
    let claims = Claims::shared(options);
    let together = |a: &Point, b: &Point| {
        a.case.name == b.case.name && a.maker.key == b.maker.key && a.method == b.method
    };
    let mut units = 0;
    for (unit, points) in points.chunk_by(together).enumerate() {
        units = unit + 1;
        bar.inc(points.len() as u64);
        if claims.as_ref().is_some_and(|c| !c.take(unit)) {
            continue;
        }
        let mut slow: Vec<&Point> = Vec::new();
        for point in points {
            let mut row = WorkPrecision { resumed: resumed.into(), ..point.row() };
            if log.contains(&row.key()) {
                continue;
            }
            bar.set_message(point.case.name);
            if let Some(claims) = &claims {
                claims.note(unit, &row.key());
            }
            if slow.iter().any(|s| point.is_beyond(s)) {
                row.outcome = Outcome::Timeout;
                log.push(row)?;
                continue;
            }
            let further = point.measure(options, &mut row);
            if row.outcome == Outcome::Timeout {
                slow.push(point);
            }
            for (metric, value) in further {
                more.push(secondary(&row, metric, value))?;
            }
            log.push(row)?;
        }
    }
    attribution::measure(options, cases, claims.as_ref(), units)?;
    Ok(String::new())
}

/// Records that an engine took its process down.
fn crashed(options: &Options, points: &[Point], key: &str) -> Result<(), String> {
    let point = points.iter().find(|p| p.row().key() == key).ok_or(format!("a worker died at {key}"))?;
    let mut log = Log::<WorkPrecision>::open(&options.directory, false)?;
    log.push(WorkPrecision { outcome: Outcome::Crashed, ..point.row() })
}

/// The files in the order of the points, whoever has measured them.
fn in_order(options: &Options, points: &[Point]) -> Result<Log<WorkPrecision>, String> {
    let keys: BTreeMap<String, usize> =
        points.iter().enumerate().map(|(k, point)| (point.row().key(), k)).collect();
    let rank = |key: &str| keys.get(key).copied().unwrap_or(usize::MAX);
    let mut log = Log::<WorkPrecision>::open(&options.directory, false)?;
    log.sort_by_key(|row| rank(&row.key()))?;
    let mut more = Log::<Secondary>::open(&options.directory, false)?;
    more.sort_by_key(|row| {
        let key = row.key();
        (rank(key.rsplit_once('|').map_or("", |(point, _)| point)), key)
    })?;
    Ok(log)
}

fn secondary(row: &WorkPrecision, metric: &str, value: f64) -> Secondary {
    Secondary {
        scene: row.scene.clone(),
        engine: row.engine.clone(),
        method: row.method.clone(),
        precision: row.precision.clone(),
        turned: row.turned,
        rate_hz: row.rate_hz,
        sub_steps: row.sub_steps,
        iterations: row.iterations,
        accuracy: row.accuracy,
        metric: metric.into(),
        value,
    }
}

fn write_scenes(cases: &[Case], options: &Options) -> Result<(), String> {
    let mut log = Log::<SceneRow>::open(&options.directory, options.fresh)?;
    for case in cases {
        log.push(SceneRow {
            scene: case.name.into(),
            group: case.group.into(),
            about: case.about.into(),
            reference: case.reference.name().into(),
            primary: case.primary.into(),
            scale: case.scale.0,
            scale_unit: case.scale.1.into(),
            null_error: case.null_error(),
            duration_s: case.duration,
        })?;
    }
    Ok(())
}

/// A line for each case: what its null simulation gives, and each engine as it comes.
fn summary(cases: &[Case], options: &Options, rows: &[WorkPrecision]) -> String {
    let makers = options.makers();
    let head: Vec<String> = ["scene".to_string(), "nothing moves".to_string()]
        .into_iter()
        .chain(makers.iter().map(|m| m.name.to_string()))
        .collect();
    let mut table = Table::new(&head.iter().map(String::as_str).collect::<Vec<_>>());
    for case in cases {
        let null = case.null_error().map_or("–".into(), |e| format!("{e:.1e}"));
        let cells = makers.iter().map(|maker| {
            let method = (maker.methods)()[0].name();
            let found = rows.iter().find(|r| {
                r.scene == case.name
                    && r.engine == maker.key
                    && r.method == method
                    && r.precision == maker.precision
                    && r.is_default == 1
                    && r.turned == 0
            });
            found.map_or("".into(), |r| match (r.error, r.cost_ms) {
                (Some(e), Some(ms)) => format!("{e:.1e} {}", milliseconds(ms)),
                _ => r.outcome.name().to_string(),
            })
        });
        table.row([case.name.to_string(), null].into_iter().chain(cells));
    }
    format!(
        "Each engine as it comes (60 Hz, 4 sub-steps): error over the scene's scale, CPU time of a simulated second.\n\n{table}"
    )
}
