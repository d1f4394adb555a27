//! The seed's sample program: a ball falls on a floor from 4 m and bounces, 100 updates a second. Prints every hit
//! beside what the document printed and what physics says.

use merev::math::scalar::double;
use merev::{Float, Shape, WorldBuilder};

const STEP: f64 = 1.0 / 100.0;
const GRAVITY: f64 = 10.0;
const BOUNCINESS: f64 = 0.9;
/// From the ball's lowest point to the floor \[m\].
const HEIGHT: f64 = 4.0;
/// A ball of diameter 1 and density 1 \[kg\].
const MASS: f64 = std::f64::consts::PI / 6.0;

/// The end of an update in which the ball hit the floor \[s\], and its momentum along y then \[kg m/s\].
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    pub time: f64,
    pub momentum: f64,
}

/// Runs the sample for `seconds`.
#[cfg_attr(feature = "f64", allow(clippy::unnecessary_cast, clippy::useless_conversion))]
pub fn run(seconds: f64) -> Vec<Hit> {
    let mut world = WorldBuilder::new()
        .down_gravity(GRAVITY as Float)
        .bounciness(BOUNCINESS as Float)
        .friction(0.1)
        .build();
    world.add_staticbody(Shape::new_box(10.0, 1.0, 10.0)).pos(0.0, -5.0, 0.0).finish();
    let ball = world.add_rigidbody(Shape::new_sphere(1.0)).finish();

    let mut hits = Vec::new();
    let mut touched = false;
    for step in 1..=(seconds / STEP).round() as u32 {
        world.update(STEP as Float);
        let touches = world.contacts().count() > 0;
        if touches && !touched {
            let ball = world.get(ball).expect("nobody removes the ball");
            hits.push(Hit { time: f64::from(step) * STEP, momentum: double(ball.momentum().y) });
        }
        touched = touches;
    }
    hits
}

/// The closed form: when the ball hits the floor for the `k`-th time (from 0), and its momentum at `time` if that
/// was the last hit.
pub fn exact(k: usize, time: f64) -> Hit {
    let fall = (2.0 * HEIGHT / GRAVITY).sqrt();
    let (mut at, mut leaves) = (fall, GRAVITY * fall * BOUNCINESS);
    for _ in 0..k {
        at += 2.0 * leaves / GRAVITY;
        leaves *= BOUNCINESS;
    }
    Hit { time: at, momentum: MASS * (leaves - GRAVITY * (time - at)) }
}

/// What the document printed: time \[s\] and momentum \[kg m/s\].
pub const PUBLISHED: [(f64, f64); 23] = [
    (0.90, 4.26564),
    (2.54, 3.91772),
    (4.05, 3.63313),
    (5.45, 3.37763),
    (6.75, 3.13593),
    (7.95, 2.85678),
    (9.05, 2.63047),
    (10.07, 2.47649),
    (11.02, 2.26403),
    (11.90, 2.14356),
    (12.73, 2.01920),
    (13.51, 1.89271),
    (14.24, 1.76392),
    (14.92, 1.63219),
    (15.56, 1.57970),
    (16.17, 1.47846),
    (16.75, 1.43818),
    (17.30, 1.31296),
    (17.82, 1.30229),
    (18.32, 1.20360),
    (18.79, 1.15167),
    (19.24, 1.10437),
    (19.67, 1.04832),
];

fn main() {
    let hits = run(20.0);
    println!("hit | published: time s, momentum | merev: time s, momentum | exact: time s, momentum then");
    for (k, (time, momentum)) in PUBLISHED.iter().enumerate() {
        let Some(hit) = hits.get(k) else { continue };
        let exact = exact(k, hit.time);
        println!(
            "{:3} | {time:15.2}  {momentum:11.5} | {:11.2}  {:11.5} | {:11.4}  {:11.5}",
            k + 1,
            hit.time,
            hit.momentum,
            exact.time,
            exact.momentum
        );
    }
    let rest = (2.0 * HEIGHT / GRAVITY).sqrt() * (1.0 + BOUNCINESS) / (1.0 - BOUNCINESS);
    let last = hits.last().map_or(0.0, |h| h.time);
    println!("{} hits, the last one at {last:.2} s; all bouncing ends at {rest:.3} s.", hits.len());
}
