//! Checks of the adapters: a wrong frame or unit would show here first.

use super::{Options, ladder, run as run_scene};
use crate::case::{Track, Trial};
use crate::engines::{Maker, Motion};
use crate::records::{Check, Log, Record};
use crate::scenes::{self, group_a};
use crate::table::Table;
use crate::vector::{angle_between, norm, sub};
use std::time::Duration;

/// All checks of an engine: name, value, bound.
pub fn of(maker: &Maker) -> Vec<(&'static str, f64, f64)> {
    vec![
        ("a2_stable_spin", stable_spin(maker, false), 1e-2),
        ("a2_stable_spin_turned", stable_spin(maker, true), 1e-2),
        ("null_simulation", null(maker), 1e-5),
        ("repeats", repeats(maker), 0.0),
    ]
}

/// A2 at 240 Hz: place, angle, velocity and spin are those of the closed form. Infinite if it does not run. A wrong
/// frame or unit is off by about 1; what a sum of ten thousand steps rounds to in f32 is a few thousandths.
fn stable_spin(maker: &Maker, turned: bool) -> f64 {
    let track = spin_track(maker, turned);
    track.map_or(f64::INFINITY, |t| group_a::stable_spin_error(&t))
}

fn spin_track(maker: &Maker, turned: bool) -> Option<Track> {
    let setting = crate::engines::Setting { rate: 240.0, ..ladder::default_setting() };
    let (scene, method) = (group_a::stable_spin_scene(), (maker.methods)()[0]);
    run_scene(maker, &scene, &method, &setting, 10.0, turned, Duration::from_secs(10))
        .ok()
        .map(|run| run.track)
}

/// What an engine says of a scene in which nothing has happened yet, against the scene: places over their size,
/// angles, velocities and spins over theirs; the worst of all cases.
fn null(maker: &Maker) -> f64 {
    let method = (maker.methods)()[0];
    let mut worst = 0.0_f64;
    for case in scenes::cases() {
        let Trial::Run(scene, _) = &case.trial else { continue };
        let Ok(engine) = (maker.build)(scene, &method, &ladder::default_setting()) else { continue };
        let mut there = Vec::new();
        engine.motions(&mut there);
        let start = Motion::start(scene);
        if there.len() != start.len() {
            return f64::INFINITY;
        }
        for (a, b) in start.iter().zip(&there) {
            let off = |p: [f64; 3], q: [f64; 3]| norm(sub(p, q)) / norm(p).max(1.0);
            worst = worst
                .max(off(a.position, b.position))
                .max(off(a.velocity, b.velocity))
                .max(off(a.spin, b.spin))
                .max(angle_between(a.rotation, b.rotation));
        }
    }
    worst
}

/// How far two runs of A2 and of a heap are from each other: not a bit.
fn repeats(maker: &Maker) -> f64 {
    let heap = scenes::cases().into_iter().find(|c| c.name == "b9_overlap").expect("a case");
    let method = (maker.methods)()[0];
    let error = || {
        super::try_case(&heap, maker, &method, &ladder::default_setting(), false, Duration::from_secs(10))
            .error
    };
    let ends = [spin_track(maker, false), spin_track(maker, false)];
    let same = match &ends {
        [Some(a), Some(b)] => a.last() == b.last(),
        _ => false,
    };
    if same && error() == error() { 0.0 } else { f64::INFINITY }
}

/// Checks every engine, and says how they fare.
///
/// # Errors
/// What the file system says.
pub fn run(options: &Options) -> Result<String, String> {
    let mut log = Log::<Check>::open(&options.directory, options.fresh)?;
    let mut table = Table::new(&["check", "engine", "value", "bound", "pass"]);
    for maker in options.makers() {
        let probe =
            Check { check: "repeats".into(), engine: maker.key.into(), value: 0.0, bound: 0.0, pass: true };
        if log.contains(&probe.key()) {
            continue;
        }
        for (check, value, bound) in of(&maker) {
            let pass = value <= bound;
            log.push(Check { check: check.into(), engine: maker.key.into(), value, bound, pass })?;
        }
    }
    for row in log.rows() {
        let pass = if row.pass { "yes" } else { "NO" };
        table.row([
            row.check.clone(),
            row.engine.clone(),
            format!("{:.1e}", row.value),
            format!("{:.0e}", row.bound),
            pass.into(),
        ]);
    }
    Ok(table.to_string())
}
