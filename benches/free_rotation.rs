//! Turning bodies through one sub-step.

use divan::{Bencher, black_box};
use merev::integrate::{PrincipalAxes, moser_veselov, turn_by};
use merev::math::{quat_about, vec3};
use merev::{Float, Mat3, Quat};

fn main() {
    divan::main();
}

/// Independent bodies, as a world has them: what counts is throughput.
const BODIES: usize = 100;

fn bodies() -> Vec<Quat> {
    (0..BODIES).map(|i| quat_about(vec3(1.0, 0.5, -0.2), i as Float)).collect()
}

/// Turns of 0.02 rad and of 0.2 rad.
#[divan::bench(args = [1, 10])]
fn tumble_100(bencher: Bencher, speed: u32) {
    let axes = PrincipalAxes::of(&Mat3::new(0.8, 0.02, 0.0, 0.02, 0.7, 0.1, 0.0, 0.1, 0.2));
    let (l, mut bodies) = (vec3(0.1, 3.4, 0.05) * speed as Float, bodies());
    bencher.bench_local(|| {
        let l = black_box(l);
        for q in &mut bodies {
            *q = moser_veselov(q, l, &axes, 1.0 / 240.0);
        }
    });
}

#[divan::bench]
fn constant_spin_100(bencher: Bencher) {
    let mut bodies = bodies();
    bencher.bench_local(|| {
        let w = black_box(vec3(0.01, 0.02, -0.005));
        for q in &mut bodies {
            *q = turn_by(q, w);
        }
    });
}
