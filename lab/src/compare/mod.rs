//! Measurements against an earlier state: what got better, what got worse, and whether that is more than noise.

mod baseline;
mod report;

use crate::records::{self, Meta, Outcome, Record, WorkPrecision};
use crate::show::hypervolume::{Corner, hypervolume};
use crate::show::pareto;
use crate::show::settings::{distinct, settings};
use baseline::Baseline;
use std::collections::BTreeMap;
use std::path::Path;

/// Where the hypervolumes of each scene end.
type Corners = BTreeMap<String, Corner>;

/// How to compare.
pub struct Options {
    /// Costs may differ by this factor without anything having changed.
    pub noise: f64,
    /// A single bit of an error of merev that differs is a regression: for code that should compute the same.
    pub exact: bool,
    /// Costs and what they lead to do not count: for a build that is not made for speed.
    pub errors: bool,
}

/// An error or outcome that is not what it was.
#[derive(Clone, Debug, PartialEq)]
struct Change {
    scene: String,
    engine: String,
    setting: String,
    is_default: bool,
    before: (Outcome, Option<f64>),
    after: (Outcome, Option<f64>),
}

/// The hypervolume of an engine in a scene.
#[derive(Clone, Debug, PartialEq)]
struct Volume {
    scene: String,
    engine: String,
    before: f64,
    after: f64,
    /// As if all costs were lower, and higher, by the noise.
    bounds: (f64, f64),
}

/// What came of it.
struct Findings {
    /// Runs that are in both.
    common: usize,
    /// Runs of which the error has the very same bits and the outcome is the same.
    same: usize,
    changes: Vec<Change>,
    volumes: Vec<Volume>,
    /// What the same work of engines other than merev costs now over what it did: how fast this machine is today.
    pace: f64,
    /// By which factor costs differ without anything having changed: the option, or more if the costs of the other
    /// engines say so.
    noise: f64,
    /// Runs of merev that took too long now and did not before.
    newly_late: usize,
}

/// An error may grow by this factor, at a default setting, before that alone is a regression.
const GROWTH: f64 = 1.1;

/// Whether a run takes too long can hang on a moment of the machine; so many of merev's that newly do, as a share of
/// all, are chance.
const LATE: f64 = 0.02;

/// Compares the records in `directory` with the baseline: what to print, and whether merev got worse.
///
/// # Errors
/// Records that cannot be read; no runs; no baseline.
pub fn run(directory: &Path, baseline: &Path, options: &Options) -> Result<(String, bool), String> {
    let now: Vec<WorkPrecision> = records::read(directory)?;
    if now.is_empty() {
        return Err(format!("there are no runs in {}; `merev chart` makes them", directory.display()));
    }
    let base = Baseline::read(baseline)?;
    let findings = find(&base, &now, options.noise);
    let machines = (base.meta.as_ref().map(|m| m.machine.clone()), Meta::read(directory).map(|m| m.machine));
    let is_worse = findings.is_regression(options);
    Ok((report::text(&findings, options, &machines), is_worse))
}

/// Makes the runs in `directory` the baseline.
///
/// # Errors
/// No runs; what the file system says.
pub fn accept(directory: &Path, baseline: &Path) -> Result<String, String> {
    baseline::accept(directory, baseline)
}

fn is_ours(engine: &str) -> bool {
    engine.starts_with("merev")
}

fn find(base: &Baseline, now: &[WorkPrecision], noise: f64) -> Findings {
    let before: BTreeMap<String, &WorkPrecision> = base.runs.iter().map(|r| (r.key(), r)).collect();
    let pairs: Vec<(&WorkPrecision, &WorkPrecision)> =
        now.iter().filter_map(|r| before.get(&r.key()).map(|b| (*b, r))).collect();
    let mut changes = Vec::new();
    for (b, a) in &pairs {
        if b.outcome != a.outcome || b.error.map(f64::to_bits) != a.error.map(f64::to_bits) {
            changes.push(Change {
                scene: a.scene.clone(),
                engine: a.engine.clone(),
                setting: format!(
                    "{} {}{} {} Hz × {} × {}",
                    a.method,
                    a.precision,
                    if a.turned != 0 { " turned" } else { "" },
                    a.rate_hz,
                    a.sub_steps,
                    a.iterations
                ),
                is_default: a.is_default != 0,
                before: (b.outcome, b.error),
                after: (a.outcome, a.error),
            });
        }
    }
    let (pace, spread) = pace(&pairs);
    let noise = noise.max(spread);
    let late = |(b, a): &&(&WorkPrecision, &WorkPrecision)| {
        b.outcome == Outcome::Timeout || a.outcome == Outcome::Timeout
    };
    let newly_late = pairs.iter().filter(|(b, a)| {
        is_ours(&a.engine) && a.outcome == Outcome::Timeout && b.outcome != Outcome::Timeout
    });
    let newly_late = newly_late.count();
    // A run that took too long in one of the two is no measurement of the other.
    let in_time: Vec<_> = pairs.iter().filter(|pair| !late(pair)).collect();
    let old: Vec<WorkPrecision> = in_time.iter().map(|(b, _)| (*b).clone()).collect();
    let new: Vec<WorkPrecision> = in_time
        .iter()
        .map(|(_, a)| WorkPrecision { cost_ms: a.cost_ms.map(|c| c / pace), ..(*a).clone() })
        .collect();
    let volumes = volumes(base, &old, &new, noise);
    let (common, same) = (pairs.len(), pairs.len() - changes.len());
    Findings { common, same, changes, volumes, pace, noise, newly_late }
}

/// The median ratio of costs of the engines that are not merev, and the factor around it within which 99 of 100 of
/// them lie; 1 and 1 with too few of them.
fn pace(pairs: &[(&WorkPrecision, &WorkPrecision)]) -> (f64, f64) {
    let others = pairs.iter().filter(|(b, _)| !is_ours(&b.engine));
    let mut ratios: Vec<f64> = others
        .filter_map(|(b, a)| Some(a.cost_ms? / b.cost_ms?))
        .filter(|r| r.is_finite() && *r > 0.0)
        .collect();
    if ratios.len() < 10 {
        return (1.0, 1.0);
    }
    ratios.sort_by(f64::total_cmp);
    let pace = ratios[ratios.len() / 2];
    let mut off: Vec<f64> = ratios.iter().map(|r| (r / pace).max(pace / r)).collect();
    off.sort_by(f64::total_cmp);
    (pace, off[(off.len() - 1) * 99 / 100])
}

fn volumes(base: &Baseline, old: &[WorkPrecision], new: &[WorkPrecision], noise: f64) -> Vec<Volume> {
    let (old, new) = (settings(old), settings(new));
    let mut all = Vec::new();
    for scene in distinct(new.iter().map(|s| s.scene.as_str())) {
        let corner = base.corner(&scene);
        for engine in distinct(new.iter().filter(|s| s.scene == scene).map(|s| s.engine.as_str())) {
            let volume = |all: &[crate::show::settings::Setting], factor: f64| {
                let own = all.iter().filter(|s| s.scene == scene && s.engine == engine);
                let points = own.filter_map(|s| s.point()).map(|(cost, error)| (cost * factor, error));
                hypervolume(&pareto::front(points), corner)
            };
            all.push(Volume {
                before: volume(&old, 1.0),
                after: volume(&new, 1.0),
                bounds: (volume(&new, 1.0 / noise), volume(&new, noise)),
                scene: scene.clone(),
                engine,
            });
        }
    }
    all
}

impl Change {
    /// Whether it got worse: a failure where there was none, or a larger error. By how much, for sorting.
    fn growth(&self) -> f64 {
        match (self.before, self.after) {
            ((Outcome::Ok, Some(b)), (Outcome::Ok, Some(a))) => {
                // Below the floor of charts nobody sees a difference.
                let floor = crate::show::settings::FLOOR;
                a.max(floor) / b.max(floor)
            }
            ((_, _), (Outcome::Timeout, _)) | ((Outcome::Timeout, _), (_, _)) => 1.0,
            ((Outcome::Ok, _), (after, _)) if after != Outcome::Ok => f64::INFINITY,
            ((before, _), (Outcome::Ok, _)) if before != Outcome::Ok => 0.0,
            _ => 1.0,
        }
    }

    /// Whether a run took too long, before or now.
    fn is_late(&self) -> bool {
        self.before.0 == Outcome::Timeout || self.after.0 == Outcome::Timeout
    }

    /// Worse beyond what a change of round-off explains.
    fn is_regression(&self) -> bool {
        is_ours(&self.engine)
            && (self.growth() == f64::INFINITY || (self.is_default && self.growth() > GROWTH))
    }
}

impl Volume {
    fn is_worse(&self) -> bool {
        self.bounds.0 < self.before - 1e-9
    }

    fn is_better(&self) -> bool {
        self.bounds.1 > self.before + 1e-9
    }
}

impl Findings {
    fn is_regression(&self, options: &Options) -> bool {
        let ours = |change: &&Change| is_ours(&change.engine);
        self.changes.iter().any(Change::is_regression)
            || !options.errors && self.volumes.iter().any(|v| is_ours(&v.engine) && v.is_worse())
            || !options.errors && self.newly_late as f64 > (LATE * self.common as f64).max(3.0)
            || (options.exact && self.changes.iter().filter(ours).any(|c| !c.is_late()))
    }
}

#[cfg(test)]
mod tests;
