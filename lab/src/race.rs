//! One scene on every engine that was built in, side by side.

use crate::engines::{self, Maker, Motion, merev::Merev};
use crate::progress;
use crate::scene::{Kind, Scene};
use crate::table::{Table, length, milliseconds, share};
use std::time::Instant;

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
    motions: Vec<Motion>,
    /// Sums over all timed steps \[ms\].
    stages: Vec<(&'static str, f64)>,
}

/// Runs the scene on the engines in turn, `repeats` times, so that what else the machine does meets all of them
/// alike, and gives the report.
pub fn run(scene: &Scene, options: &Options) -> String {
    let makers = engines::ALL.iter().take(if options.peers { usize::MAX } else { 1 });
    let mut entries: Vec<Entry> = makers
        .map(|&maker| Entry { maker, times: Vec::new(), motions: Vec::new(), stages: Vec::new() })
        .collect();
    let bar = progress::bar((options.repeats * entries.len() * options.steps) as u64, scene.name);
    for _ in 0..options.repeats {
        for entry in &mut entries {
            let mut engine = (entry.maker.build)(scene);
            engine.step();
            let start = Instant::now();
            for _ in 1..options.steps {
                engine.step();
                if options.stages {
                    add_stages(&mut entry.stages, &engine.stages());
                }
            }
            let elapsed = start.elapsed().as_secs_f64();
            entry.times.push(1e3 * elapsed / (options.steps - 1) as f64);
            engine.motions(&mut entry.motions);
            bar.inc(options.steps as u64);
        }
    }
    bar.finish_and_clear();
    report(scene, options, &entries)
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
    for entry in entries.iter().filter(|e| !e.stages.is_empty()) {
        let parts = entry.stages.iter().map(|(name, ms)| format!("{name} {}", milliseconds(ms / steps)));
        text += &format!("{}: {}\n", entry.maker.name, parts.collect::<Vec<_>>().join(", "));
    }
    text
}

fn report(scene: &Scene, options: &Options, entries: &[Entry]) -> String {
    let start: Vec<Motion> = scene
        .bodies
        .iter()
        .filter(|b| b.kind == Kind::Dynamic)
        .map(|b| Motion { position: b.position, rotation: b.rotation, velocity: b.velocity, spin: [0.0; 3] })
        .collect();
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
    for entry in entries {
        let (middle, least) = (median(&entry.times), minimum(&entry.times));
        let after = Merev::measure(scene, &entry.motions);
        let energy = |r: &merev::world::StepReport| r.kinetic_energy + r.potential_energy;
        let (top, sag) = height(&start, &entry.motions);
        table.row([
            entry.maker.name.to_string(),
            milliseconds(middle),
            milliseconds(least),
            format!("{:.2}", ours / middle),
            length(top),
            length(sag),
            length(sideways(&start, &entry.motions)),
            length(f64::from(after.worst_penetration)),
            share(change(energy(&before), energy(&after))),
        ]);
    }
    let awake = if scene.sleep { "on" } else { "off" };
    format!(
        "{}: {}\n{} dynamic bodies, {} steps of {:.4} s in {} sub-steps, sleep {awake}, one thread; {} repeats in turn, first \
         step not timed.\nState after the last step, measured for all with one ruler.\n\n{table}{}",
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

/// The change as a share of the larger of the two.
fn change(before: f64, after: f64) -> f64 {
    let size = before.abs().max(after.abs());
    if size > 0.0 { (after - before) / size } else { 0.0 }
}

/// Height of the highest centre, and how much the body that began highest has come down \[m\].
fn height(start: &[Motion], end: &[Motion]) -> (f64, f64) {
    let y = |m: &Motion| f64::from(m.position[1]);
    let top = end.iter().map(y).fold(f64::MIN, f64::max);
    let first = (0..start.len()).max_by(|&i, &k| y(&start[i]).total_cmp(&y(&start[k])));
    (top, first.map_or(0.0, |i| y(&start[i]) - y(&end[i])))
}

/// The farthest that a centre has moved sideways \[m\].
fn sideways(start: &[Motion], end: &[Motion]) -> f64 {
    let pairs = start.iter().zip(end);
    pairs
        .map(|(a, b)| {
            let d = |k: usize| f64::from(b.position[k] - a.position[k]);
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

    #[test]
    fn median_of_odd_even_and_none() {
        assert_eq!(median(&[3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]), 2.5);
        assert!(median(&[]).is_nan());
    }

    /// Two cubes that overlap by 10 mm are measured to do so, from whichever engine the places come.
    #[test]
    fn the_ruler_measures_overlap_and_energy() {
        let mut scene = crate::scenes::find("stack_10").unwrap();
        scene.bodies.truncate(2);
        let motion =
            Motion { position: [0.0, 0.49, 0.0], rotation: [0.0, 0.0, 0.0, 1.0], ..Motion::default() };
        let still = Merev::measure(&scene, &[motion]);
        assert!((still.worst_penetration - 0.01).abs() < 1e-6, "{still:?}");
        assert!((still.potential_energy - 4900.0).abs() < 0.01, "{still:?}");
        let moving = Merev::measure(&scene, &[Motion { velocity: [2.0, 0.0, 0.0], ..motion }]);
        assert!((moving.kinetic_energy - 2000.0).abs() < 0.01, "{moving:?}");
    }
}
