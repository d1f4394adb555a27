//! Joints against golden values, on every engine that was built in: how far a pendulum, a double pendulum and chains
//! are from what they should do, and how far a hanging chain stretches. Every scene runs as it stands and turned as a
//! whole by a rotation, and the worse of the two counts.

use crate::engines::{self, Engine, Maker, Motion};
use crate::progress;
use crate::scene::Scene;
use crate::scenes::joints;
use crate::table::{Table, length};
use crate::vector::{Q4, V3, add, conjugate, norm, rotate};

/// A scene, what is measured, after how many steps, and where the tip should be then.
type Golden = (fn() -> Scene, &'static str, usize, [f64; 2]);

/// Golden tips from an independent integration in minimal coordinates \[m\].
const GOLDEN: [Golden; 5] = [
    (joints::double_pendulum, "double pendulum, tip at 1 s", 60, [-1.662_115_14, -1.041_466_64]),
    (joints::double_pendulum, "double pendulum, tip at 2 s", 120, [0.313_524_78, -1.914_746_62]),
    (joints::double_pendulum, "double pendulum, tip at 3 s", 180, [1.330_436_83, -1.398_644_86]),
    (joints::chain_10, "chain of 10, tip at 1 s", 60, [-1.764_752_5, -0.927_582_9]),
    (joints::chain_20, "chain of 20, tip at 0.5 s", 30, [3.509_259, -1.226_253]),
];

/// The period of a pendulum of 1 m from 90° under 9.81 m/s² \[s\].
const PERIOD: f64 = 2.367_841_9;

/// The turn of the second run: anything that no axis has a part in.
const TURN: Q4 = [0.2, -0.5, 0.3, 0.787_400_787_401_181];

/// Runs all of it and gives the report.
pub fn run(peers: bool) -> String {
    let makers: Vec<Maker> = engines::racers(peers);
    let mut table =
        Table::new(&[&["quantity"][..], &makers.iter().map(|m| m.name).collect::<Vec<_>>()].concat());
    let bar = progress::bar((GOLDEN.len() + 6) as u64, "joints");
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
    for (scene, name, step, tip) in GOLDEN {
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

/// A point of a body, turned back.
fn point(motion: &Motion, local: V3, turn: Option<Q4>) -> [f64; 3] {
    let p = add(motion.position, rotate(motion.rotation, local));
    turn.map_or(p, |q| rotate(conjugate(q), p))
}

/// How far the tip is from where it should be \[m\].
fn off(maker: &Maker, scene: &Scene, step: usize, tip: [f64; 2], turn: Option<Q4>) -> f64 {
    let mut engine = build(maker, &turned(scene, turn));
    (0..step).for_each(|_| engine.step());
    let mut motions = Vec::new();
    engine.motions(&mut motions);
    let last = scene.joints.last().expect("a chain");
    let p = point(&motions[motions.len() - 1], last.local[1].map(|c| -c), turn);
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
        let p = point(&motions[0], [0.0; 3], turn);
        gap = gap.max((norm(p) - 1.0).abs());
        if last > 0.0 && p[0] <= 0.0 {
            crossings.push((step as f64 - p[0] / (p[0] - last)) * scene.dt);
        }
        last = p[0];
    }
    let n = crossings.len().saturating_sub(1).max(1);
    let period = (crossings.last().unwrap_or(&f64::NAN) - crossings.first().unwrap_or(&f64::NAN)) / n as f64;
    ((period / PERIOD - 1.0).abs(), gap)
}

/// How much longer than 4 m a hanging chain is \[m\].
fn stretch(maker: &Maker, last: f64, turn: Option<Q4>) -> f64 {
    let scene = joints::hanging_chain(last);
    let mut engine = build(maker, &turned(&scene, turn));
    (0..scene.steps).for_each(|_| engine.step());
    let mut motions = Vec::new();
    engine.motions(&mut motions);
    let end = point(&motions[motions.len() - 1], [0.1, 0.0, 0.0], turn);
    (norm(end) - 4.0).abs()
}
