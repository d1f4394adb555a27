//! Closed loops and trees of bodies on joints, against an integration of high order: the benchmark problems A03 to A05
//! of IFToMM's library of multibody problems, and a body on four legs.

use super::group_e::{ground, point, rod};
use super::scene;
use crate::case::{Case, Judge, Reference, Track};
use crate::engines::Motion;
use crate::metrics::{angular_momentum, energy_change, kinetic, momentum};
use crate::references::mechanism;
use crate::scene::{Body, Form, Hold, Joint, Load, Mass, Scene};
use crate::vector::{STILL, V3, add, angle_between, conjugate, cross, norm, rotate, scale, sub, times, turn};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, TAU};
use std::sync::OnceLock;

pub fn cases() -> Vec<Case> {
    vec![squeezer(), bricard(), governor(), robot_floats(), robot_falls()]
}

/// Joins two bodies at a point of the world, the joint's axes turned by `axes` from those of the world.
fn join(scene: &mut Scene, hold: Hold, bodies: [usize; 2], at: V3, axes: crate::vector::Q4) {
    let of = bodies.map(|b| (scene.bodies[b].position, conjugate(scene.bodies[b].rotation)));
    scene.joints.push(Joint {
        hold,
        bodies,
        local: of.map(|(p, back)| rotate(back, sub(at, p))),
        axes: of.map(|(_, back)| times(back, axes)),
    });
}

/// A turn that takes z to an axis of the world.
fn z_to(axis: usize) -> crate::vector::Q4 {
    match axis {
        0 => turn([0.0, 1.0, 0.0], FRAC_PI_2),
        1 => turn([1.0, 0.0, 0.0], -FRAC_PI_2),
        _ => STILL,
    }
}

/// The greatest gap of the joints that hold points together.
fn gap(scene: &Scene, frame: &[Motion]) -> f64 {
    // The first body is the ground at the origin, the others are dynamic; all have their centres at their origins.
    let place = |b: usize, local: V3| if b == 0 { local } else { point(&frame[b - 1], local) };
    let held = scene.joints.iter().filter(|j| matches!(j.hold, Hold::Ball | Hold::Hinge));
    held.map(|j| norm(sub(place(j.bodies[0], j.local[0]), place(j.bodies[1], j.local[1]))))
        .fold(0.0, f64::max)
}

/// Thirty times a second, every rate of the ladder has a frame.
fn grid(duration: f64) -> Vec<f64> {
    (1..=(30.0 * duration) as usize).map(|k| k as f64 / 30.0).collect()
}

/// The greatest distance of a body's centre from its integrated way, and the energy over a size of it.
fn followed(duration: f64, size: Option<f64>) -> Judge {
    let truth = OnceLock::new();
    Box::new(move |scene: &Scene, track: &Track| {
        let times = grid(duration);
        let truth: &Vec<Vec<Motion>> = truth.get_or_init(|| mechanism::motions(scene, &times, 1e-11));
        assert_eq!(truth.len(), times.len(), "{}: the integration ends before", scene.name);
        let mut worst = 0.0_f64;
        for (t, exact) in times.iter().zip(truth) {
            let frame = &track.frames[track.at(*t)];
            let off = frame.iter().zip(exact).map(|(a, b)| norm(sub(a.position, b.position)));
            worst = off.fold(worst, f64::max);
        }
        let verdict = super::verdict(worst).and("joint_gap_m", track.greatest(|f| gap(scene, f)));
        match size {
            Some(size) => verdict.and("energy", energy_change(scene, &track.frames, size)),
            None => verdict,
        }
    })
}

fn follow(scene: Scene, duration: f64, length: f64, size: Option<f64>) -> Case {
    Case::run('E', Reference::GoldenValues, scene, duration, followed(duration, size))
        .primary("greatest distance of a body's centre from its integrated way")
        .scale(length, "m, the mechanism's size")
        .most_rate(960.0)
}

/// Angles of the squeezer at its start: β, θ, γ, φ, δ, Ω, ε.
const SQUEEZER: [f64; 7] = [
    -0.061_713_890_014_276_45,
    0.0,
    0.455_279_819_163_070_4,
    0.222_668_390_165_885_88,
    0.487_364_979_543_842_55,
    -0.222_668_390_165_885_88,
    1.230_547_444_549_821_2,
];

/// Ten times as long, a thousand times as heavy and a hundred times as slow as the published one, which lives for 30 ms
/// and is 7 cm large: without gravity its way is the same. Names of lengths are those of the publication.
fn squeezer_scene() -> Scene {
    let mut scene = scene("e6_squeezer", "Andrews' squeezer: seven bodies, a spring and a motor");
    scene.gravity = [0.0; 3];
    scene.bodies.push(ground());
    let [beta, theta, gamma, phi, delta, omega, epsilon] = SQUEEZER;
    let along = |angle: f64, x: f64, y: f64| {
        let (s, c) = libm::sincos(angle);
        [x * c - y * s, x * s + y * c, 0.0]
    };
    let fixed = |x: f64, y: f64| [x, y, 0.0];
    let (a, b, c) = (fixed(-0.06934, -0.00227), fixed(-0.03635, 0.03273), fixed(0.014, 0.072));
    let crank = along(beta, 0.007, 0.0);
    let elbow = sub(crank, along(beta + theta, 0.028, 0.0));
    // K3 and K7 are drawn along −y of their angles.
    let (lower, upper) = (add(a, along(delta, 0.04, 0.0)), add(a, along(epsilon, 0.0, -0.04)));
    let bodies = [
        (0.04325, 2.194e-6, beta, along(beta, 0.00092, 0.0)),
        (0.00365, 4.410e-7, beta + theta, sub(crank, along(beta + theta, 0.0115, 0.0))),
        (0.02373, 5.255e-6, gamma, add(b, along(gamma, 0.01043, -0.01874))),
        (0.00706, 5.667e-7, phi + delta, add(lower, along(phi + delta, 0.0, -(0.02 - 0.01421)))),
        (0.07050, 1.169e-5, delta, add(a, along(delta, 0.02308, 0.00916))),
        (0.00706, 5.667e-7, omega + epsilon, add(upper, along(omega + epsilon, 0.02 - 0.01421, 0.0))),
        (0.05498, 1.912e-5, epsilon, add(a, along(epsilon, -0.00449, -0.01228))),
    ];
    for (mass, inertia, angle, at) in bodies {
        scene.bodies.push(Body {
            collides: false,
            rotation: turn([0.0, 0.0, 1.0], angle),
            mass: Some(Mass::new(1e3 * mass, [1e5 * inertia; 3])),
            ..Body::dynamic(Form::Sphere(0.02), scale(at, 10.0))
        });
    }
    let ties = [
        ([0, 1], [0.0; 3]),
        ([1, 2], crank),
        ([0, 3], b),
        ([2, 3], elbow),
        ([2, 4], elbow),
        ([2, 6], elbow),
        ([0, 5], a),
        ([5, 4], lower),
        ([0, 7], a),
        ([7, 6], upper),
    ];
    for (pair, at) in ties {
        join(&mut scene, Hold::Hinge, pair, scale(at, 10.0), STILL);
    }
    let arm = scale([0.02 - 0.01043, 0.01874 - 0.018, 0.0], 10.0);
    scene.loads.push(Load::Torque(1, [0.0, 0.0, 0.33]));
    let anchor = scale(c, 10.0);
    scene.loads.push(Load::Spring { body: 3, at: arm, anchor, stiffness: 453.0, rest: 0.7785 });
    scene
}

fn squeezer() -> Case {
    follow(squeezer_scene(), 3.0, 0.4, None)
}

/// Five rods of 1 m and 1 kg along the edges of a cube, on six hinges.
fn bricard_scene() -> Scene {
    let mut scene = scene("e6_bricard", "Bricard's loop of six hinges falls, more held than it need be");
    scene.bodies.push(ground());
    let corners: [V3; 6] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, -1.0, 1.0],
        [0.0, -1.0, 1.0],
        [0.0, 0.0, 1.0],
    ];
    for pair in corners.windows(2) {
        let way = sub(pair[1], pair[0]);
        // From x to the rod: a quarter turn about what is across both, or none.
        let axis = cross([1.0, 0.0, 0.0], way);
        let rotation = if norm(axis) > 0.0 { turn(axis, FRAC_PI_2) } else { STILL };
        scene.bodies.push(Body { rotation, ..rod(1.0, 1.0, scale(add(pair[0], pair[1]), 0.5)) });
    }
    for (k, axis) in [1, 2, 0, 1, 2, 0].into_iter().enumerate() {
        let next = (k + 1) % 6;
        join(&mut scene, Hold::Hinge, [k, next], corners[k], z_to(axis));
    }
    scene
}

fn bricard() -> Case {
    follow(bricard_scene(), 3.0, 1.0, Some(5.0 * super::G))
}

/// A shaft that turns freely, a slider on it, and two rods with balls that are tied to the slider; all turn at 2π/s. The
/// published one has stiff springs where this one has couplers.
fn governor_scene() -> Scene {
    let mut scene = scene("e6_governor", "a fly-ball governor swings up and down as it turns");
    scene.bodies.push(ground());
    let spinning = |body: Body| {
        let spin = [0.0, TAU, 0.0];
        Body { spin, velocity: cross(spin, body.position), collides: false, ..body }
    };
    let heavy = |mass: f64, inertia: V3, at: V3| Body {
        mass: Some(Mass::new(mass, inertia)),
        ..Body::dynamic(Form::Sphere(0.05), at)
    };
    scene.bodies.push(spinning(heavy(0.3, [0.025, 0.01, 0.025], [0.0, 0.5, 0.0])));
    scene.bodies.push(spinning(heavy(3.0, [0.005; 3], [0.0, 0.5, 0.0])));
    join(&mut scene, Hold::Hinge, [0, 1], [0.0; 3], z_to(1));
    // The slide is along x of the joint.
    join(&mut scene, Hold::Slider(None), [1, 2], [0.0, 0.5, 0.0], turn([0.0, 0.0, 1.0], FRAC_PI_2));
    let (s, c) = libm::sincos(FRAC_PI_6);
    // A rod of 0.3 kg and 1 m, at its end a ball of 5 kg whose own moments are 0.01 kg m².
    let centre = (0.3 * 0.5 + 5.0) / 5.3;
    let across = 0.025 + 0.3 * (centre - 0.5) * (centre - 0.5) + 5.0 * (1.0 - centre) * (1.0 - centre) + 0.01;
    for side in [1.0, -1.0] {
        let pivot = [side * 0.05, 1.0, 0.0];
        let along = |r: f64| add(pivot, [side * r * c, -r * s, 0.0]);
        let arm = scene.bodies.len();
        let rotation = turn([0.0, 0.0, 1.0], -side * FRAC_PI_6);
        let body = heavy(5.3, [0.01, across, across], along(centre));
        scene.bodies.push(spinning(Body { rotation, ..body }));
        let (upper, lower) = (along(0.5), [side * 0.05, 0.5, 0.0]);
        let body = rod(0.15, 0.5, scale(add(upper, lower), 0.5));
        scene.bodies.push(spinning(Body { rotation: turn([0.0, 0.0, 1.0], side * FRAC_PI_6), ..body }));
        join(&mut scene, Hold::Hinge, [1, arm], pivot, STILL);
        join(&mut scene, Hold::Hinge, [arm, arm + 1], upper, STILL);
        join(&mut scene, Hold::Ball, [arm + 1, 2], lower, STILL);
    }
    scene
}

fn governor() -> Case {
    // The energy of its turning.
    let scene = governor_scene();
    let start: Vec<Motion> = Motion::start(&scene);
    let size = kinetic(&scene, &start);
    follow(scene, 3.0, 1.0, Some(size))
}

/// A trunk of 20 kg on four legs of three links each, hinged as those of walking robots are: at the hip about the way
/// it faces, x, at hip and knee about what is across, z. It is no model of any robot.
fn robot(name: &'static str, about: &'static str) -> Scene {
    let mut scene = scene(name, about);
    let loose = |half: V3, at: V3, mass: f64| {
        let density = mass / (8.0 * half[0] * half[1] * half[2]);
        Body { collides: false, density, ..Body::dynamic(Form::Box(half), at) }
    };
    scene.bodies.push(ground());
    let (velocity, spin) = ([0.3, 0.5, -0.2], [0.4, 0.7, -0.5]);
    scene.bodies.push(Body { velocity, spin, ..loose([0.3, 0.08, 0.15], [0.0; 3], 20.0) });
    for leg in 0..4 {
        let (front, left) = (if leg < 2 { 1.0 } else { -1.0 }, if leg % 2 == 0 { 1.0 } else { -1.0 });
        let links = [
            (0, [front * 0.3, 0.0, left * 0.12], [0.04, 0.04, 0.04], [front * 0.3, 0.0, left * 0.18], 1.5),
            (2, [front * 0.3, 0.0, left * 0.2], [0.03, 0.14, 0.03], [front * 0.3, -0.14, left * 0.2], 2.0),
            (2, [front * 0.3, -0.28, left * 0.2], [0.02, 0.14, 0.02], [front * 0.3, -0.42, left * 0.2], 0.6),
        ];
        // Each leg swings in its own way.
        let rates = [0.8 * left, 2.0 * front + 0.3 * left, -1.5 + 0.4 * front * left];
        let mut parent = 1;
        for ((axis, hinge, half, at, mass), rate) in links.into_iter().zip(rates) {
            let mut turning = [0.0; 3];
            turning[axis] = rate;
            let before: Body = scene.bodies[parent];
            let spin = add(before.spin, turning);
            let velocity = add(
                add(before.velocity, cross(before.spin, sub(hinge, before.position))),
                cross(spin, sub(at, hinge)),
            );
            let link = scene.bodies.len();
            scene.bodies.push(Body { spin, velocity, ..loose(half, at, mass) });
            join(&mut scene, Hold::Hinge, [parent, link], hinge, z_to(axis));
            parent = link;
        }
    }
    scene
}

fn robot_case(scene: Scene, duration: f64, judge: Judge) -> Case {
    Case::run('E', Reference::Invariant, scene, duration, judge).most_rate(960.0)
}

/// Changes of momentum and of angular momentum, over the sums of their sizes at the start.
fn momenta(scene: &Scene, track: &Track, gravity: V3) -> (f64, f64) {
    let (p0, l0) = (momentum(scene, track.first()), angular_momentum(scene, track.first()));
    let masses = crate::case::masses(scene);
    let total: f64 = masses.iter().map(|m| m.0).sum();
    let sizes = masses.iter().zip(track.first()).fold((0.0, 0.0), |(p, l), ((m, i), b)| {
        let reach = norm(b.position) * norm(b.velocity) * m;
        (p + m * norm(b.velocity), l + reach + i[1] * norm(b.spin))
    });
    let fallen = scale(gravity, total * track.end());
    let p = norm(sub(momentum(scene, track.last()), add(p0, fallen))) / sizes.0;
    let l = norm(sub(angular_momentum(scene, track.last()), l0)) / sizes.1;
    (p, l)
}

fn robot_floats() -> Case {
    let mut scene = robot("e9_robot_floats", "a body on four legs of three links, swinging in empty space");
    scene.gravity = [0.0; 3];
    let judge = |scene: &Scene, track: &Track| {
        let (p, l) = momenta(scene, track, [0.0; 3]);
        let e = energy_change(scene, &track.frames, kinetic(scene, track.first()));
        super::verdict(p.max(l).max(e))
            .and("momentum", p)
            .and("angular_momentum", l)
            .and("energy", e)
            .and("joint_gap_m", track.greatest(|f| gap(scene, f)))
    };
    robot_case(scene, 5.0, Box::new(judge))
        .primary("greatest change of energy, momentum or angular momentum, over their sizes")
}

fn robot_falls() -> Case {
    let scene = robot("e9_robot_falls", "the same in free fall, against its integrated way");
    let truth = OnceLock::new();
    let duration = 1.0;
    let judge = move |scene: &Scene, track: &Track| {
        let times = grid(duration);
        let truth: &Vec<Vec<Motion>> = truth.get_or_init(|| mechanism::motions(scene, &times, 1e-11));
        assert_eq!(truth.len(), times.len(), "the integration ends before");
        let (mut off, mut turned) = (0.0_f64, 0.0_f64);
        for (t, exact) in times.iter().zip(truth) {
            for (a, b) in track.frames[track.at(*t)].iter().zip(exact) {
                off = off.max(norm(sub(a.position, b.position)));
                turned = turned.max(angle_between(a.rotation, b.rotation));
            }
        }
        let e = energy_change(scene, &track.frames, kinetic(scene, track.first()));
        super::verdict(off)
            .and("angle_rad", turned)
            .and("energy", e)
            .and("joint_gap_m", track.greatest(|f| gap(scene, f)))
    };
    Case { reference: Reference::GoldenValues, ..robot_case(scene, duration, Box::new(judge)) }
        .primary("greatest distance of a body's centre from its integrated way")
        .scale(0.56, "m, the length of a leg")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::energy;

    fn at(scene: &Scene, times: &[f64]) -> Vec<Vec<Motion>> {
        let found = mechanism::motions(scene, times, 1e-11);
        assert_eq!(found.len(), times.len());
        found
    }

    /// The angle of a body in the plane.
    fn angle(m: &Motion) -> f64 {
        2.0 * libm::atan2(m.rotation[2], m.rotation[3])
    }

    /// The figures that the collection of test problems for solvers prints for 30 ms, whole turns left out.
    #[test]
    fn the_squeezer_is_the_published_one() {
        let printed = [
            15.810_771_196_299_04,
            -15.756_371_059_842_98,
            0.040_822_240_130_731_01,
            -0.534_730_116_322_694_8,
            0.524_409_965_880_530_4,
            0.534_730_116_322_694_8,
            1.048_080_741_042_263,
        ];
        let [beta, theta, gamma, phi, delta, omega, epsilon] = printed;
        let exact = [beta, beta + theta, gamma, phi + delta, delta, omega + epsilon, epsilon];
        let scene = squeezer_scene();
        assert!(gap(&scene, &Motion::start(&scene)) < 1e-12);
        let end = &at(&scene, &[3.0])[0];
        for (m, exact) in end.iter().zip(exact) {
            let off = (angle(m) - exact).rem_euclid(TAU);
            assert!(off.min(TAU - off) < 1e-7, "{} {exact}", angle(m));
        }
    }

    /// Their joints hold and their energy stays: what their equations do not know of.
    #[test]
    fn loops_stay_closed_and_keep_their_energy() {
        for scene in [bricard_scene(), governor_scene(), robot("robot", "")] {
            let start = Motion::start(&scene);
            let e = energy(&scene, &start);
            for frame in at(&scene, &[1.0, 3.0]) {
                assert!(gap(&scene, &frame) < 1e-8, "{}: {}", scene.name, gap(&scene, &frame));
                let off = (energy(&scene, &frame) - e).abs();
                assert!(off < 1e-7, "{}: {off}", scene.name);
                let moved = frame.iter().zip(&start).map(|(a, b)| norm(sub(a.position, b.position)));
                assert!(moved.fold(0.0, f64::max) > 0.1, "{}", scene.name);
            }
        }
    }
}
