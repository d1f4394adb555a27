//! The main run: the C programs, a table of what they cost and how well they keep what physics keeps, and the
//! replay page.

use crate::bounce;
use crate::programs::{self, Frame, Pose, PyramidRun};
use crate::progress;
use crate::race::median;
use crate::replay::{self, Color, Look, Recording};
use crate::table::{Table, length, milliseconds, share};
use std::path::{Path, PathBuf};

/// Steps of the ball: 20 s.
const BALL_STEPS: usize = 2000;
/// Steps for which the small pyramid stands before a ball strikes it.
const STAND_STEPS: usize = 300;

const SMALL: PyramidRun =
    PyramidRun { rows: 10, steps: STAND_STEPS + 300, measure_every: 1, strike_after: STAND_STEPS };
const LARGE: PyramidRun = PyramidRun { rows: 100, steps: 200, measure_every: 100, strike_after: 0 };

/// What the programs made.
struct Outcome {
    ball: Vec<Frame>,
    small: Vec<Frame>,
    large: Vec<Frame>,
}

/// Runs everything, writes the page and gives the report.
pub fn run() -> Result<String, String> {
    if merev::capi::mvIsDoublePrecision() != cfg!(feature = "f64") {
        return Err("library and C programs differ in precision; choose it with the lab's feature f64".into());
    }
    let outcome = simulate()?;
    let path = write_replay(&outcome)?;
    let version = merev::capi::mvGetVersion();
    Ok(format!(
        "merev {}.{}.{}, run through its C interface\n\n{}\n{}\nreplay: {}\n",
        version.major,
        version.minor,
        version.revision,
        hit_table(&outcome.ball),
        summary(&outcome),
        path.display()
    ))
}

fn simulate() -> Result<Outcome, String> {
    // A step of the large pyramid is worth many of the others.
    let weight = 50;
    let bar = progress::bar((BALL_STEPS + SMALL.steps + weight * LARGE.steps) as u64, "bouncing ball");
    let ball = programs::bouncing_ball(BALL_STEPS, &mut || bar.inc(1))?;
    bar.set_message("pyramid of 10 rows");
    let small = programs::pyramid(SMALL, &mut || bar.inc(1))?;
    bar.set_message("pyramid of 100 rows");
    let large = programs::pyramid(LARGE, &mut || bar.inc(weight as u64))?;
    bar.finish_and_clear();
    Ok(Outcome { ball, small, large })
}

/// Every hit beside the closed form, two to a line.
fn hit_table(frames: &[Frame]) -> String {
    let seen = bounce::hits(frames);
    let dt = frames[0].time;
    let own_frame = |hit: &&bounce::Hit| 2.0 * hit.speed / bounce::GRAVITY > dt;
    let distinct = bounce::distinct_hits(dt).min(seen.iter().take_while(own_frame).count());
    let head = ["hit", "exact [s]", "found [s]", "error [ms]", "leaves [m/s]", "found [m/s]"];
    let mut table = Table::new(&[&head[..], &["|"], &head[..]].concat());
    let cells = |k: usize| {
        let (time, speed) = (bounce::exact_time(k), bounce::exact_speed(k + 1));
        let hit = seen[k];
        [
            k.to_string(),
            format!("{time:.4}"),
            format!("{:.4}", hit.time),
            format!("{:+.3}", 1e3 * (hit.time - time)),
            format!("{speed:.4}"),
            format!("{:.4}", hit.speed),
        ]
    };
    let half = distinct.div_ceil(2);
    for k in 0..half {
        let mut row = cells(k).to_vec();
        if k + half < distinct {
            row.push("|".into());
            row.extend(cells(k + half));
        }
        table.row(row);
    }
    let worst = |range: std::ops::Range<usize>| {
        1e3 * range.map(|k| (seen[k].time - bounce::exact_time(k)).abs()).fold(0.0, f64::max)
    };
    let rest = frames.iter().rev().find(|f| f.hit_speed > 0.0).map_or(0.0, |f| f.time);
    format!(
        "A ball falls {} m, restitution {}, steps of {dt} s: every hit until hits come faster than steps.\n\n{table}\n\
         worst error {:.3} ms, of the first ten hits {:.3} ms; exact end of all bouncing {:.3} s, last hit in the step that ends at {rest:.2} s\n",
        bounce::FALL,
        bounce::RESTITUTION,
        worst(0..distinct),
        worst(0..distinct.min(10)),
        bounce::exact_end(),
    )
}

/// Time of a step, drifts and overlap of each run.
fn summary(outcome: &Outcome) -> String {
    let mut table = Table::new(&[
        "run",
        "bodies",
        "steps",
        "time per step",
        "energy drift",
        "momentum drift",
        "deepest overlap",
    ]);
    let standing = &outcome.small[..STAND_STEPS];
    let rows = [
        ("bouncing ball", &outcome.ball[..], ball_drift(&outcome.ball)),
        ("pyramid of 10 rows", standing, pyramid_drift(standing, SMALL.rows)),
        ("pyramid of 100 rows", &outcome.large[..], pyramid_drift(&outcome.large, LARGE.rows)),
    ];
    for (name, frames, (energy, momentum)) in rows {
        let times: Vec<f64> = frames[1..].iter().map(|f| 1e3 * f.elapsed).collect();
        let overlap = frames.iter().filter_map(|f| f.measures).map(|m| m.penetration).fold(0.0, f64::max);
        table.row([
            name.to_string(),
            frames[0].poses.len().to_string(),
            frames.len().to_string(),
            milliseconds(median(&times)),
            share(energy),
            share(momentum),
            length(overlap),
        ]);
    }
    format!(
        "{table}\nTimes are medians, the first step left out. Drifts are the worst of the run: the ball's from its \
         closed form, as shares\nof its first energy and momentum at impact; a standing pyramid's energy as a share \
         of its potential energy, its momentum\nas a share of what gravity gives it in a second.\n"
    )
}

/// The worst deviations from the closed form: energy, and momentum sideways. Frames within a step of a hit are
/// left out of the energy, which jumps there.
fn ball_drift(frames: &[Frame]) -> (f64, f64) {
    let dt = frames[0].time;
    let start = bounce::MASS * bounce::GRAVITY * bounce::FALL;
    let hits: Vec<f64> = (0..bounce::distinct_hits(dt)).map(bounce::exact_time).collect();
    let (mut energy, mut momentum) = (0.0_f64, 0.0_f64);
    for (frame, m) in frames.iter().filter_map(|f| f.measures.map(|m| (f, m))) {
        momentum = momentum.max(m.momentum[0].abs()).max(m.momentum[2].abs());
        if hits.iter().all(|t| (t - frame.time).abs() > dt) {
            let share = (m.energy + start) / start;
            let error = share - bounce::exact_energy(frame.time);
            if error.abs() > energy.abs() {
                energy = error;
            }
        }
    }
    (energy, momentum / (bounce::MASS * bounce::exact_speed(0)))
}

/// The worst change of energy, as a share of the potential energy of the pyramid as it was built, and the worst
/// momentum, as a share of weight × 1 s.
fn pyramid_drift(frames: &[Frame], rows: usize) -> (f64, f64) {
    let cubes = (0..rows).flat_map(|row| std::iter::repeat_n(row as f64 + 0.5, rows - row));
    let (mut start, mut weight) = (0.0, 0.0);
    for height in cubes {
        weight += 100.0 * bounce::GRAVITY;
        start += 100.0 * bounce::GRAVITY * height;
    }
    let (mut energy, mut momentum) = (0.0_f64, 0.0_f64);
    for m in frames.iter().filter_map(|f| f.measures) {
        let change = (m.energy - start) / start;
        if change.abs() > energy.abs() {
            energy = change;
        }
        let size = m.momentum.iter().map(|p| p * p).sum::<f64>().sqrt();
        momentum = momentum.max(size / weight);
    }
    (energy, momentum)
}

const ORANGE: Color = [0.86, 0.22, 0.05];
/// From the lowest row of a pyramid to the highest.
const RAMP: [Color; 4] = [[0.03, 0.13, 0.36], [0.02, 0.33, 0.38], [0.72, 0.50, 0.06], [0.80, 0.18, 0.05]];
const SLATE: Color = [0.20, 0.24, 0.30];
const UPRIGHT: [f32; 4] = [0.0, 0.0, 0.0, 1.0];

fn at(x: f32, y: f32, z: f32) -> Pose {
    let [i, j, k, w] = UPRIGHT;
    [x, y, z, i, j, k, w]
}

/// Writes the page into the target folder and gives its path.
fn write_replay(outcome: &Outcome) -> Result<PathBuf, String> {
    let page = replay::page(&[ball_recording(&outcome.ball), pyramid_recording(&outcome.small)]);
    let target = std::env::var_os("CARGO_TARGET_DIR")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../target"), PathBuf::from);
    let path = target.join("merev").join("replay.html");
    let write = || -> std::io::Result<PathBuf> {
        std::fs::create_dir_all(target.join("merev"))?;
        std::fs::write(&path, page)?;
        path.canonicalize()
    };
    write().map_err(|e| format!("{} is not written: {e}", path.display()))
}

fn ball_recording(frames: &[Frame]) -> Recording<'_> {
    Recording {
        name: "ball",
        title: "Ball",
        about: "bouncing ball, restitution 0.9",
        dt: frames[0].time,
        bodies: vec![(Look::Sphere(0.5), ORANGE)],
        fixed: vec![([0.0, -5.0, 0.0], [5.0, 0.5, 5.0], SLATE)],
        ground: -5.5,
        target: [0.0, -3.1, 0.0],
        distance: 21.0,
        yaw: 0.6,
        pitch: 0.24,
        radius: 9.0,
        start: vec![at(0.0, 0.0, 0.0)],
        frames,
    }
}

fn pyramid_recording(frames: &[Frame]) -> Recording<'_> {
    let rows = SMALL.rows;
    let (mut bodies, mut start) = (Vec::new(), Vec::new());
    for row in 0..rows {
        for column in 0..rows - row {
            let x = column as f32 + 0.5 * (1.0 + row as f32 - rows as f32);
            start.push(at(x, 0.5 + row as f32, 0.0));
            // From blue below to red above, neighbours a little apart.
            let t = row as f32 / (rows - 1) as f32 * (RAMP.len() - 1) as f32;
            let below = (t as usize).min(RAMP.len() - 2);
            let light = [1.0, 0.82, 0.91][column % 3];
            let mix = |k: usize| {
                light * (RAMP[below][k] + (t - below as f32) * (RAMP[below + 1][k] - RAMP[below][k]))
            };
            bodies.push((Look::Box([0.5; 3]), [mix(0), mix(1), mix(2)]));
        }
    }
    bodies.push((Look::Sphere(0.9), ORANGE));
    Recording {
        name: "pyramid",
        title: "Pyramid",
        about: "10 rows stand, then a ball strikes",
        dt: frames[0].time,
        bodies,
        fixed: Vec::new(),
        ground: 0.0,
        target: [0.0, 4.2, 0.0],
        distance: 24.0,
        yaw: -0.55,
        pitch: 0.22,
        radius: 17.0,
        start,
        frames,
    }
}
