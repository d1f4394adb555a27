//! Joints against golden values, on every engine that was built in: how far a pendulum, a double pendulum and chains
//! are from what they should do, and how far a hanging chain stretches. Every scene runs as it stands and turned as a
//! whole by a rotation, and the worse of the two counts.

use crate::case::TURN;
use crate::engines::{self, Engine, Maker, Motion};
use crate::progress;
use crate::references::chain;
use crate::scene::Scene;
use crate::scenes::{G, group_e, joints};
use crate::table::{Table, length};
use crate::vector::{self, Q4, V3, conjugate, norm, rotate, times};
use std::f64::consts::FRAC_PI_2;

/// A chain of rods, what is measured, rods, their length \[m\], and after how many steps.
type Swing = (fn() -> Scene, &'static str, usize, f64, usize);

const SWINGS: [Swing; 5] = [
    (joints::double_pendulum, "double pendulum, tip at 1 s", 2, 1.0, 60),
    (joints::double_pendulum, "double pendulum, tip at 2 s", 2, 1.0, 120),
    (joints::double_pendulum, "double pendulum, tip at 3 s", 2, 1.0, 180),
    (joints::chain_10, "chain of 10, tip at 1 s", 10, 0.2, 60),
    (joints::chain_20, "chain of 20, tip at 0.5 s", 20, 0.2, 30),
];

/// About these the pendulum's scene is turned by a radian, too: how far a single-precision engine is off depends on how
/// its axes lie.
const DIRECTIONS: [V3; 9] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.6, 0.8, 0.0],
    [0.0, 0.6, 0.8],
    [0.8, 0.0, 0.6],
    [-0.6, 0.0, 0.8],
    [0.8, -0.6, 0.0],
    [0.0, 0.8, -0.6],
];

/// A radian about an axis, and then the turn of the copy.
fn spun(turn: Option<Q4>, axis: V3) -> Q4 {
    let own = vector::turn(axis, 1.0);
    turn.map_or(own, |q| times(q, own))
}

/// Runs all of it and gives the report.
pub fn run(peers: bool) -> String {
    let makers: Vec<Maker> = engines::racers(peers);
    let mut table =
        Table::new(&[&["quantity"][..], &makers.iter().map(|m| m.name).collect::<Vec<_>>()].concat());
    let bar = progress::bar((SWINGS.len() + 6) as u64, "joints");
    let mut line = |name: &str, measure: &dyn Fn(&Maker, Option<Q4>) -> String| {
        let cells = makers.iter().map(|m| {
            let (a, b) = (measure(m, None), measure(m, Some(TURN)));
            if a == b { a } else { format!("{a} / {b}") }
        });
        table.row(std::iter::once(name.to_string()).chain(cells).collect::<Vec<_>>());
        bar.inc(1);
    };
    line("pendulum from 90°, period", &|m, turn| format!("{:.1e}", pendulum(m, turn).0));
    line("pendulum, worst gap", &|m, turn| length(pendulum(m, turn).1));
    line("pendulum, period in nine more directions: median", &|m, turn| {
        let mut errors = DIRECTIONS.map(|axis| pendulum(m, Some(spun(turn, axis))).0);
        errors.sort_by(f64::total_cmp);
        format!("{:.1e}, at worst {:.1e}", errors[DIRECTIONS.len() / 2], errors[DIRECTIONS.len() - 1])
    });
    for (scene, name, count, size, step) in SWINGS {
        let tip = chain::tips(count, size, G, &[step as f64 / 60.0])[0];
        line(name, &|m, turn| length(off(m, &scene(), step, tip, turn)));
    }
    for last in [1.0, 100.0, 1e4] {
        let name = format!("20 links hanging 10 s, the last {last} kg: stretched by");
        line(&name, &|m, turn| length(stretch(m, last, turn)));
    }
    bar.finish_and_clear();
    format!(
        "Joints at 60 Hz and 4 sub-steps: distances from golden values; as the scene stands / turned as a whole.\n\n{table}"
    )
}

/// The scene turned as a whole, gravity included.
fn turned(scene: &Scene, turn: Option<Q4>) -> Scene {
    turn.map_or_else(|| scene.clone(), |q| scene.turned(q))
}

fn build(maker: &Maker, scene: &Scene) -> Box<dyn Engine> {
    maker.race(scene).expect("an engine that has ball joints")
}

/// Where a point of a body is, turned back.
fn place(motion: &Motion, local: V3, turn: Option<Q4>) -> V3 {
    let p = group_e::point(motion, local);
    turn.map_or(p, |q| rotate(conjugate(q), p))
}

/// How far the tip is from where it should be \[m\].
fn off(maker: &Maker, scene: &Scene, step: usize, tip: [f64; 2], turn: Option<Q4>) -> f64 {
    let mut engine = build(maker, &turned(scene, turn));
    (0..step).for_each(|_| engine.step());
    let mut motions = Vec::new();
    engine.motions(&mut motions);
    let last = scene.joints.last().expect("a chain");
    let p = place(&motions[motions.len() - 1], last.local[1].map(|c| -c), turn);
    norm([p[0] - tip[0], p[1] - tip[1], p[2]])
}

/// The relative error of a pendulum's period, and the greatest error of its length \[m\].
fn pendulum(maker: &Maker, turn: Option<Q4>) -> (f64, f64) {
    let scene = joints::pendulum();
    let mut engine = build(maker, &turned(&scene, turn));
    let (mut motions, mut last, mut crossings, mut gap) = (Vec::new(), 1.0, Vec::new(), 0.0_f64);
    for step in 1..=scene.steps {
        engine.step();
        engine.motions(&mut motions);
        let p = place(&motions[0], [0.0; 3], turn);
        gap = gap.max((norm(p) - 1.0).abs());
        if last > 0.0 && p[0] <= 0.0 {
            crossings.push((step as f64 - p[0] / (p[0] - last)) * scene.dt);
        }
        last = p[0];
    }
    let n = crossings.len().saturating_sub(1).max(1);
    let period = (crossings.last().unwrap_or(&f64::NAN) - crossings.first().unwrap_or(&f64::NAN)) / n as f64;
    ((period / group_e::pendulum_period(FRAC_PI_2, true) - 1.0).abs(), gap)
}

/// How much longer than 4 m a hanging chain is \[m\].
fn stretch(maker: &Maker, last: f64, turn: Option<Q4>) -> f64 {
    let scene = joints::hanging_chain(last);
    let mut engine = build(maker, &turned(&scene, turn));
    (0..scene.steps).for_each(|_| engine.step());
    let mut motions = Vec::new();
    engine.motions(&mut motions);
    let end = place(&motions[motions.len() - 1], [0.1, 0.0, 0.0], turn);
    (norm(end) - 4.0).abs()
}
