//! One scene on every engine that was built in, side by side.

use crate::engines::merev::{Merev, double};
use crate::engines::{self, Maker, Motion};
use crate::progress;
use crate::records::Race;
use crate::scene::Scene;
use crate::table::{Table, length, milliseconds, share};
use merev::world::StepReport;
use std::time::{Duration, Instant};

/// How long an engine may take for one run before it is left out.
const LIMIT: Duration = Duration::from_secs(60);

/// From when on the time that is still to come can be told.
const SETTLED: Duration = Duration::from_secs(4);

/// A run that takes longer is not repeated \[ms\].
const SLOW: f64 = 20e3;

/// What to run.
pub struct Options {
    /// Steps, the first one included.
    pub steps: usize,
    pub repeats: usize,
    /// Engines other than ours too.
    pub peers: bool,
    /// Say what each engine says its stages took.
    pub stages: bool,
}

/// What an engine made of a scene.
struct Entry {
    maker: Maker,
    /// Mean time of a step, the first one left out, for each repeat \[ms\].
    times: Vec<f64>,
    /// Of the first step, for each repeat \[ms\].
    first: Vec<f64>,
    motions: Vec<Motion>,
    /// What the engine says of its last step \[m/s\].
    residual: Option<f64>,
    /// Sums over all timed steps \[ms\].
    stages: Vec<(&'static str, f64)>,
    /// Why it takes no part: it refuses the scene, or takes too long.
    left_out: Option<String>,
}

/// Runs the scene on the engines in turn, `repeats` times, so that what else the machine does meets all of them
/// alike, and gives the report.
///
/// # Errors
/// Why ours refuses the scene.
pub fn run(scene: &Scene, options: &Options) -> Result<String, String> {
    let bar = progress::bar(length_of(options), scene.name);
    let entries = race(scene, options, &|steps| bar.inc(steps))?;
    bar.finish_and_clear();
    Ok(report(scene, options, &entries))
}

/// How many steps a race takes.
fn length_of(options: &Options) -> u64 {
    (options.repeats * engines::racers(options.peers).len() * options.steps) as u64
}

/// The same, as rows of race.csv. The row of an engine that is left out has no numbers.
///
/// # Errors
/// Why ours refuses the scene.
pub fn rows(scene: &Scene, options: &Options, advance: &dyn Fn(u64)) -> Result<Vec<Race>, String> {
    let entries = race(scene, options, advance)?;
    let start = Motion::start(scene);
    let before = Merev::measure(scene, &start);
    Ok(entries.iter().map(|entry| row(scene, options, entry, &start, before.as_ref())).collect())
}

fn race(scene: &Scene, options: &Options, advance: &dyn Fn(u64)) -> Result<Vec<Entry>, String> {
    race_of(&engines::racers(options.peers), scene, options, advance)
}

/// The first of them has to take part.
fn race_of(
    makers: &[Maker],
    scene: &Scene,
    options: &Options,
    advance: &dyn Fn(u64),
) -> Result<Vec<Entry>, String> {
    let entry = |maker| Entry {
        maker,
        times: Vec::new(),
        first: Vec::new(),
        motions: Vec::new(),
        residual: None,
        stages: Vec::new(),
        left_out: None,
    };
    let mut entries: Vec<Entry> = makers.iter().copied().map(entry).collect();
    for _ in 0..options.repeats {
        for entry in entries.iter_mut().filter(|e| e.left_out.is_none() && !e.is_slow(options)) {
            entry.left_out = once(scene, options, entry).err();
            advance(options.steps as u64);
        }
    }
    match &entries[0].left_out {
        Some(why) => Err(why.clone()),
        None => Ok(entries),
    }
}

impl Entry {
    /// Whether it has taken so long that it runs once only.
    fn is_slow(&self, options: &Options) -> bool {
        self.times.iter().any(|ms| ms * options.steps as f64 > SLOW)
    }
}

/// One run of one engine.
fn once(scene: &Scene, options: &Options, entry: &mut Entry) -> Result<(), String> {
    let mut engine = entry.maker.race(scene)?;
    let begin = Instant::now();
    engine.step();
    let first = begin.elapsed();
    let start = Instant::now();
    for done in 2..=options.steps {
        engine.step();
        if options.stages {
            add_stages(&mut entry.stages, &engine.stages());
        }
        // What will not be in time is not waited for.
        let spent = begin.elapsed();
        if spent > LIMIT || spent > SETTLED && spent.mul_f64(options.steps as f64 / done as f64) > LIMIT {
            return Err(format!("takes more than {} s", LIMIT.as_secs()));
        }
    }
    let elapsed = start.elapsed().as_secs_f64();
    if engine.is_broken() {
        return Err("does not come to the end".into());
    }
    entry.first.push(1e3 * first.as_secs_f64());
    entry.times.push(1e3 * elapsed / (options.steps - 1) as f64);
    engine.motions(&mut entry.motions);
    entry.residual = engine.residual();
    Ok(())
}

fn add_stages(sums: &mut Vec<(&'static str, f64)>, step: &[(&'static str, f32)]) {
    sums.resize(step.len(), ("", 0.0));
    for (sum, &(name, ms)) in sums.iter_mut().zip(step) {
        *sum = (name, sum.1 + f64::from(ms));
    }
}

/// A line for each engine: the mean time of its stages.
fn stage_lines(options: &Options, entries: &[Entry]) -> String {
    let steps = (options.repeats * (options.steps - 1)) as f64;
    let mut text = String::new();
    for entry in entries.iter().filter(|e| e.left_out.is_none() && !e.stages.is_empty()) {
        let parts = entry.stages.iter().map(|(name, ms)| format!("{name} {}", milliseconds(ms / steps)));
        text += &format!("{}: {}\n", entry.maker.name, parts.collect::<Vec<_>>().join(", "));
    }
    text
}

fn row(
    scene: &Scene,
    options: &Options,
    entry: &Entry,
    start: &[Motion],
    before: Option<&StepReport>,
) -> Race {
    let is_in = entry.left_out.is_none();
    let after = if is_in { Merev::measure(scene, &entry.motions) } else { None };
    let after = after.as_ref();
    let moved = |f: &dyn Fn() -> f64| if is_in { f() } else { f64::NAN };
    let of = |f: &dyn Fn(&StepReport) -> f64| after.map_or(f64::NAN, f);
    Race {
        scene: scene.name.into(),
        engine: entry.maker.key.into(),
        bodies: scene.dynamic_count(),
        steps: options.steps,
        median_ms: moved(&|| median(&entry.times)),
        minimum_ms: moved(&|| minimum(&entry.times)),
        first_ms: moved(&|| median(&entry.first)),
        sagged_m: moved(&|| height(start, &entry.motions).1),
        sideways_m: moved(&|| sideways(start, &entry.motions)),
        overlap_m: of(&|r| double(r.worst_penetration)),
        joint_gap_m: of(&|r| double(r.joint_gap)),
        energy_change: of(&|r| before.map_or(f64::NAN, |b| change(parts(b), parts(r)))),
        residual: entry.residual.unwrap_or(f64::NAN),
    }
}

fn report(scene: &Scene, options: &Options, entries: &[Entry]) -> String {
    let start = Motion::start(scene);
    let before = Merev::measure(scene, &start);
    let ours = median(&entries[0].times);
    let mut table = Table::new(&[
        "engine",
        "median",
        "minimum",
        "ours/it",
        "top",
        "sagged",
        "sideways",
        "overlap",
        "energy change",
    ]);
    let mut left_out = String::new();
    for entry in entries {
        if let Some(why) = &entry.left_out {
            left_out += &format!("{} is left out: {why}.\n", entry.maker.name);
            continue;
        }
        let row = row(scene, options, entry, &start, before.as_ref());
        table.row([
            entry.maker.name.to_string(),
            milliseconds(row.median_ms),
            milliseconds(row.minimum_ms),
            format!("{:.2}", ours / row.median_ms),
            length(height(&start, &entry.motions).0),
            length(row.sagged_m),
            length(row.sideways_m),
            length(row.overlap_m),
            share(row.energy_change),
        ]);
    }
    let awake = if scene.sleep { "on" } else { "off" };
    format!(
        "{}: {}\n{} dynamic bodies, {} steps of {:.4} s in {} sub-steps, sleep {awake}, one thread; {} repeats in turn, first \
         step not timed.\nState after the last step, measured for all with one ruler.\n\n{table}{left_out}{}",
        scene.name,
        scene.about,
        scene.dynamic_count(),
        options.steps,
        scene.dt,
        scene.sub_steps,
        options.repeats,
        stage_lines(options, entries),
    )
}

/// Kinetic and potential.
fn parts(report: &StepReport) -> [f64; 2] {
    [report.kinetic_energy, report.potential_energy]
}

/// The change of energy, over the greatest of its parts: heights count from anywhere, so that the sum may be nothing.
fn change(before: [f64; 2], after: [f64; 2]) -> f64 {
    let size = before.iter().chain(&after).fold(0.0, |m: f64, e| m.max(e.abs()));
    if size > 0.0 { (after[0] + after[1] - before[0] - before[1]) / size } else { 0.0 }
}

/// Height of the highest centre, and how much the body that began highest has come down \[m\].
fn height(start: &[Motion], end: &[Motion]) -> (f64, f64) {
    let y = |m: &Motion| m.position[1];
    let top = end.iter().map(y).fold(f64::MIN, f64::max);
    let first = (0..start.len()).max_by(|&i, &k| y(&start[i]).total_cmp(&y(&start[k])));
    (top, first.map_or(0.0, |i| y(&start[i]) - y(&end[i])))
}

/// The farthest that a centre has moved sideways \[m\].
fn sideways(start: &[Motion], end: &[Motion]) -> f64 {
    let pairs = start.iter().zip(end);
    pairs
        .map(|(a, b)| {
            let d = |k: usize| b.position[k] - a.position[k];
            (d(0) * d(0) + d(2) * d(2)).sqrt()
        })
        .fold(0.0, f64::max)
}

pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    match sorted.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => sorted[n / 2],
        n => 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]),
    }
}

pub fn minimum(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An engine that refuses a scene is left out, and has a row without numbers; the others race.
    #[test]
    fn who_refuses_is_left_out() {
        let scene = crate::scenes::find("stack_10").unwrap();
        let options = Options { steps: 3, repeats: 2, peers: false, stages: false };
        let refusing = Maker { build: |_, _, _| Err("no cubes".into()), ..engines::ALL[0] };
        let entries = race_of(&[engines::ALL[0], refusing], &scene, &options, &|_| {}).unwrap();
        assert_eq!(entries[1].left_out.as_deref(), Some("no cubes"));
        let start = Motion::start(&scene);
        let rows = [&entries[0], &entries[1]].map(|e| row(&scene, &options, e, &start, None));
        assert!(rows[0].median_ms > 0.0 && rows[0].sagged_m.is_finite());
        assert!(rows[1].median_ms.is_nan() && rows[1].overlap_m.is_nan() && rows[1].sagged_m.is_nan());
        assert!(report(&scene, &options, &entries).contains("merev is left out: no cubes."));
        assert!(race_of(&[refusing], &scene, &options, &|_| {}).is_err());
    }

    #[test]
    fn median_of_odd_even_and_none() {
        assert_eq!(median(&[3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), 2.5);
        assert!(median(&[]).is_nan());
    }

    /// What has fallen from height 0 has turned one into the other, and lost nothing.
    #[test]
    fn a_fall_from_nothing_changes_no_energy() {
        assert_eq!(change([0.0; 2], [3.0, -3.0]), 0.0);
        assert_eq!(change([0.0; 2], [3.0, -4.0]), -0.25);
    }

    /// Two cubes that overlap by 10 mm are measured to do so, from whichever engine the places come.
    #[test]
    fn the_ruler_measures_overlap_and_energy() {
        let mut scene = crate::scenes::find("stack_10").unwrap();
        scene.bodies.truncate(2);
        let motion =
            Motion { position: [0.0, 0.49, 0.0], rotation: [0.0, 0.0, 0.0, 1.0], ..Motion::default() };
        let still = Merev::measure(&scene, &[motion]).unwrap();
        assert!((still.worst_penetration - 0.01).abs() < 1e-6, "{still:?}");
        assert!((still.potential_energy - 4900.0).abs() < 0.01, "{still:?}");
        let moving = Merev::measure(&scene, &[Motion { velocity: [2.0, 0.0, 0.0], ..motion }]).unwrap();
        assert!((moving.kinetic_energy - 2000.0).abs() < 0.01, "{moving:?}");
    }
}
