//! C: friction and rolling.

use super::{G, rods, scene, tops};
use crate::case::{Case, Reference, Threshold, Track};
use crate::engines::Motion;
use crate::scene::{Body, Course, Form, Hold, Joint, Mass, Push, Scene};
use crate::vector::{V3, angle, cross, norm, rotate, scale, sub, turn};
use std::f64::consts::{FRAC_PI_2, PI};

pub fn cases() -> Vec<Case> {
    vec![
        incline("c1_stick", "a box on a slope just below the friction angle", 0.5, 0.98 * 0.5, 10.0),
        incline("c1_slide", "a box on a slope just above the friction angle", 0.5, 1.02 * 0.5, 2.0),
        incline("c1_slide_fast", "a box on a slope, friction 0.4", 0.4, 0.5, 2.0),
        incline_threshold(),
        isotropy(),
        slip_to_roll("c3_slip_to_roll", "a sliding ball begins to roll", 5.0, 0.0, 2.0),
        slip_to_roll("c3_backspin", "a ball with backspin comes back", 5.0, -200.0, 5.0),
        ramp("c4_sphere", "a ball rolls down a slope", 0.4, None),
        ramp("c4_hoop", "a ball with the inertia of a hoop rolls down a slope", 1.0, None),
        ramp("c4_prism_64", "a prism of 64 sides rolls like a cylinder", 0.5, Some(64)),
        ramp("c4_prism_32", "a prism of 32 sides, against a cylinder", 0.5, Some(32)),
        ramp("c4_prism_16", "a prism of 16 sides, against a cylinder", 0.5, Some(16)),
        rolling_plate(),
        drag(),
        drag_sliding(),
        tall_box(),
        tip(),
        push_over(),
        grip(),
    ]
    .into_iter()
    .chain(rods::cases())
    .chain(tops::cases())
    .collect()
}

/// A slope of this angle that falls towards +x: all turned but gravity.
pub fn slope(flat: Scene, angle: f64) -> Scene {
    let gravity = flat.gravity;
    Scene { gravity, ..flat.turned(turn([0.0, 0.0, 1.0], -angle)) }
}

pub fn box_on_floor(name: &'static str, about: &'static str, half: V3, friction: f64) -> Scene {
    let mut scene = scene(name, about);
    let surface = |b: Body| Body { friction, ..b };
    scene.floor_of([50.0, 1.0, 50.0], surface);
    scene.bodies.push(surface(Body::dynamic(Form::Box(half), [0.0, half[1], 0.0])));
    scene
}

fn incline(name: &'static str, about: &'static str, friction: f64, tangent: f64, duration: f64) -> Case {
    let angle = libm::atan(tangent);
    let (s, c) = libm::sincos(angle);
    let scene = slope(box_on_floor(name, about, [0.5, 0.25, 0.5], friction), angle);
    let way = (0.5 * G * (s - friction * c) * duration * duration).max(0.0);
    let judge = move |_: &Scene, track: &Track| {
        let moved = sub(track.last()[0].position, track.first()[0].position);
        let exact = scale([c, -s, 0.0], way);
        let half = track.at(0.5 * duration);
        let late = norm(sub(track.last()[0].position, track.frames[half][0].position)) / (0.5 * duration);
        let verdict = super::verdict(norm(sub(moved, exact)));
        if way == 0.0 { verdict.and("creep_speed", late) } else { verdict }
    };
    let (size, unit) = if way > 0.0 { (way, "m, the way it slides") } else { (1.0, "m, the box's length") };
    Case::run('C', Reference::ClosedForm, scene, duration, Box::new(judge))
        .primary("distance from where it should be at the end")
        .scale(size, unit)
        .most_rate(if way > 0.0 { 1920.0 } else { 480.0 })
}

fn incline_threshold() -> Case {
    let build = |tangent: f64| {
        let flat = box_on_floor("c1_threshold", "", [0.5, 0.25, 0.5], 0.5);
        slope(flat, libm::atan(tangent))
    };
    // Sliding 0.25 % above the threshold covers some 10 mm in 1 s; between half and the end of 2 s it covers 15.
    let beyond = |track: &Track| {
        let middle = &track.frames[track.at(0.5 * track.end())][0];
        norm(sub(track.last()[0].position, middle.position)) > 2e-3
    };
    Case::threshold(
        'C',
        "c1_threshold",
        "the slope on which a box begins to slide",
        2.0,
        Threshold {
            scene: Box::new(build),
            beyond: Box::new(beyond),
            exact: 0.5,
            range: [0.3, 0.8],
            halvings: 11,
        },
    )
}

fn isotropy() -> Case {
    let mut scene = scene("c2_isotropy", "nine boxes slide in nine directions and stop");
    let friction = 0.5;
    let surface = |b: Body| Body { friction, ..b };
    scene.floor_of([100.0, 1.0, 100.0], surface);
    let heading = |k: usize| {
        let (s, c) = libm::sincos(k as f64 * PI / 16.0);
        [c, 0.0, s]
    };
    for k in 0..9 {
        let at = [10.0 * (k % 3) as f64 - 10.0, 0.25, 10.0 * (k / 3) as f64 - 10.0];
        let body = Body::dynamic(Form::Box([0.5, 0.25, 0.5]), at);
        scene.bodies.push(surface(Body { velocity: scale(heading(k), 5.0), ..body }));
    }
    let way = 25.0 / (2.0 * friction * G);
    let judge = move |_: &Scene, track: &Track| {
        let (mut far, mut skew) = (0.0_f64, 0.0_f64);
        for k in 0..9 {
            let moved = sub(track.last()[k].position, track.first()[k].position);
            far = far.max(norm(sub(moved, scale(heading(k), way))));
            let across = norm(cross(moved, heading(k)));
            skew =
                skew.max(if norm(moved) > 0.0 { libm::asin((across / norm(moved)).min(1.0)) } else { 0.0 });
        }
        super::verdict(far).and("heading_rad", skew)
    };
    Case::run('C', Reference::ClosedForm, scene, 1.5, Box::new(judge))
        .primary("greatest distance from where a box should stop")
        .scale(way, "m, the way to the stop")
}

fn slip_to_roll(name: &'static str, about: &'static str, speed: f64, spin: f64, duration: f64) -> Case {
    let mut scene = scene(name, about);
    let surface = |b: Body| Body { friction: 0.2, ..b };
    scene.floor_of([100.0, 1.0, 100.0], surface);
    // Rolling towards +x is a negative turn about z.
    scene.bodies.push(surface(Body {
        velocity: [speed, 0.0, 0.0],
        spin: [0.0, 0.0, -spin],
        ..Body::dynamic(Form::Sphere(0.1), [0.0, 0.1, 0.0])
    }));
    let (v_end, t_roll) = ((5.0 * speed + 0.2 * spin) / 7.0, 2.0 * (speed - 0.1 * spin) / (7.0 * 0.2 * G));
    let judge = move |_: &Scene, track: &Track| {
        let m = &track.last()[0];
        let off = (m.velocity[0] - v_end).abs() / speed;
        let slip = (m.velocity[0] + 0.1 * m.spin[2]).abs() / speed;
        let a = track.frames[track.at(t_roll + 0.1)][0].velocity[0];
        super::verdict(off).and("slip", slip).and("drift", (m.velocity[0] - a).abs() / speed)
    };
    Case::run('C', Reference::ClosedForm, scene, duration, Box::new(judge))
        .primary("error of the speed at the end, over that at the start")
        .most_rate(960.0)
}

fn ramp(name: &'static str, about: &'static str, inertia: f64, sides: Option<usize>) -> Case {
    let mut flat = scene(name, about);
    let (angle, r) = (20.0 * PI / 180.0, 0.5);
    let surface = |b: Body| Body { friction: 0.8, ..b };
    flat.floor_of([100.0, 1.0, 20.0], surface);
    let form = match sides {
        None => Form::Sphere(r),
        Some(n) => {
            // An edge up and down: it starts on a face, whose middle is nearer to the axis.
            let corner = |k: usize, z: f64| {
                let (s, c) = libm::sincos((k as f64 + 0.5) * 2.0 * PI / n as f64 - FRAC_PI_2);
                [r * c, r * s, z]
            };
            flat.clouds.push((0..n).flat_map(|k| [corner(k, -0.5), corner(k, 0.5)]).collect());
            Form::Hull(0)
        }
    };
    let depth = sides.map_or(r, |n| r * libm::cos(PI / n as f64));
    let mass = Some(Mass::new(100.0, [100.0 * inertia * r * r; 3]));
    flat.bodies.push(surface(Body { mass, ..Body::dynamic(form, [0.0, depth, 0.0]) }));
    let scene = slope(flat, angle);
    let way = 0.5 * G * libm::sin(angle) / (1.0 + inertia) * 4.0;
    let judge = move |_: &Scene, track: &Track| {
        let moved = norm(sub(track.last()[0].position, track.first()[0].position));
        let m = &track.last()[0];
        super::verdict((moved - way).abs())
            .and("slip", (norm(m.velocity) - r * norm(m.spin)).abs() / norm(m.velocity).max(1e-9))
    };
    Case::run('C', Reference::ClosedForm, scene, 2.0, Box::new(judge))
        .primary("error of the way rolled in 2 s")
        .scale(way, "m, that way")
        .most_rate(960.0)
}

fn rolling_plate() -> Case {
    let mut scene = scene("c5_rolling_plate", "25 balls roll on a plate that is pushed at 60°");
    // Pairs have √(ab): 0.4 on the ground, 0.8 on the plate.
    let plate = Body {
        density: 10.0 / 400.0,
        friction: 0.4,
        ..Body::dynamic(Form::Box([10.0, 0.5, 10.0]), [0.0, 0.5, 0.0])
    };
    scene.floor_of([60.0, 1.0, 60.0], |floor| Body { friction: 0.4, ..floor });
    scene.bodies.push(plate);
    for k in 0..25 {
        let at = [2.0 * f64::from(k % 5) - 4.0, 1.5, 2.0 * f64::from(k / 5) - 4.0];
        let mass = Some(Mass::new(1.0, [0.1; 3]));
        scene.bodies.push(Body { friction: 1.6, mass, ..Body::dynamic(Form::Sphere(0.5), at) });
    }
    let way = [0.5, 0.0, 0.75_f64.sqrt()];
    scene.pushes.push(Push { body: 1, force: scale(way, 150.0), at: [0.0; 3], course: Course::Constant });
    let f1 = 0.4 * 35.0 * G;
    let a_ball = (150.0 - f1) / 10.0 / (3.5 + 2.5);
    let a_plate = (150.0 - f1 - 25.0 * a_ball) / 10.0;
    let judge = move |_: &Scene, track: &Track| {
        let off = |k: usize| {
            let t = track.times[k];
            let d = |i: usize, a: f64| norm(sub(track.frames[k][i].velocity, scale(way, a * t)));
            let (plate, ball) = (d(0, a_plate), d(13, a_ball));
            plate * plate + ball * ball
        };
        let picks = track.moments(200);
        let mean = picks.iter().map(|&k| off(k)).sum::<f64>() / picks.len() as f64;
        super::verdict(mean.sqrt()).and("squared_error_m2_s2", mean)
    };
    Case::run('C', Reference::ClosedForm, scene, 4.0, Box::new(judge))
        .primary("root mean square of the velocity errors of plate and one ball")
        .scale(4.0 * a_plate, "m/s, the plate's speed at the end")
        .most_rate(960.0)
}

fn drag() -> Case {
    let mut scene = box_on_floor("c8_drag", "a cube is pulled harder and harder", [0.1; 3], 0.4);
    scene.bodies[1].density = 125.0;
    let cap = 0.9 * 2.0 * G;
    let rate = 4.0 * G / cap;
    scene.pushes.push(Push { body: 1, force: [cap, 0.0, 0.0], at: [0.0; 3], course: Course::Ramp(rate) });
    let duration = 1.098;
    // Breaks away at F = μ m g, then F/m − μ g: first growing, then constant.
    let (away, full) = (0.1, 0.45);
    let (slow, rest) = (full - away, duration - full);
    let jerk = 4.0 * G;
    let (v1, x1) = (0.5 * jerk * slow * slow, jerk * slow * slow * slow / 6.0);
    let way = x1 + v1 * rest + 0.5 * (cap - 0.4 * G) * rest * rest;
    let judge = move |_: &Scene, track: &Track| {
        let moved = sub(track.last()[0].position, track.first()[0].position);
        let before = track.frames[track.at(0.09)][0].position[0];
        let height = track.greatest(|f| f[0].position[1]) - 0.1;
        super::verdict((moved[0] - way).abs())
            .and("slip_before_m", before.abs())
            .and("lift_m", height.max(0.0))
            .and("sideways_m", moved[2].abs())
    };
    Case::run('C', Reference::ClosedForm, scene, duration, Box::new(judge))
        .primary("error of the way at the end")
        .scale(way, "m, that way")
}

/// The same with a speed at the start, so that it slides all the time.
fn drag_sliding() -> Case {
    let about = "a sliding cube is pulled harder and harder";
    let mut scene = box_on_floor("c8_drag_sliding", about, [0.1; 3], 0.4);
    scene.bodies[1].density = 125.0;
    scene.bodies[1].velocity = [1.0, 0.0, 0.0];
    let cap = 0.9 * 2.0 * G;
    let course = Course::Ramp(4.0 * G / cap);
    scene.pushes.push(Push { body: 1, force: [cap, 0.0, 0.0], at: [0.0; 3], course });
    let (full, duration) = (0.45, 1.098);
    // The force over the mass is 4 g t, until it is full.
    let v1 = 1.0 + 2.0 * G * full * full - 0.4 * G * full;
    let x1 = full + 2.0 / 3.0 * G * full * full * full - 0.2 * G * full * full;
    let rest = duration - full;
    let way = x1 + v1 * rest + 0.5 * (cap - 0.4 * G) * rest * rest;
    let judge = move |_: &Scene, track: &Track| {
        let moved = sub(track.last()[0].position, track.first()[0].position);
        let height = track.greatest(|f| f[0].position[1]) - 0.1;
        super::verdict((moved[0] - way).abs())
            .and("lift_m", height.max(0.0))
            .and("sideways_m", moved[2].abs())
    };
    Case::run('C', Reference::ClosedForm, scene, duration, Box::new(judge))
        .primary("error of the way at the end")
        .scale(way, "m, that way")
}

fn tall_box() -> Case {
    let mut scene =
        box_on_floor("c9_tall_box", "a box slides at the edge of tipping over", [0.15, 0.3, 0.6], 0.5);
    scene.bodies[1].density = 200.0;
    scene.bodies[1].velocity = [4.0, 0.0, 0.0];
    let way = 16.0 / (2.0 * 0.5 * G);
    let judge = move |_: &Scene, track: &Track| {
        let moved = track.last()[0].position[0];
        let tilt = track.greatest(|f| angle(rotate(f[0].rotation, [0.0, 1.0, 0.0]), [0.0, 1.0, 0.0]));
        super::verdict((moved - way).abs()).and("tilt_rad", tilt)
    };
    Case::run('C', Reference::ClosedForm, scene, 2.0, Box::new(judge))
        .primary("error of the way to the stop")
        .scale(way, "m, that way")
        .most_rate(960.0)
}

fn tip() -> Case {
    let build =
        |tangent: f64| slope(box_on_floor("c10_tip", "", [0.25, 0.5, 0.25], 0.8), libm::atan(tangent));
    let beyond = |track: &Track| {
        let up = |m: &Motion| rotate(m.rotation, [0.0, 1.0, 0.0]);
        angle(up(&track.last()[0]), up(&track.first()[0])) > 0.2
    };
    Case::threshold(
        'C',
        "c10_tip",
        "the slope on which a tall box tips over",
        3.0,
        Threshold {
            scene: Box::new(build),
            beyond: Box::new(beyond),
            exact: 0.5,
            range: [0.3, 0.8],
            halvings: 11,
        },
    )
}

/// A box that is pushed with 0.7 of its weight at a height over its base; friction holds it up to 0.9.
fn push_over() -> Case {
    let build = |height: f64| {
        let mut scene = box_on_floor("c10_push", "", [0.25, 0.5, 0.25], 0.9);
        let force = 0.7 * 1000.0 * 0.25 * G;
        scene.pushes.push(Push {
            body: 1,
            force: [force, 0.0, 0.0],
            at: [-0.25, height - 0.5, 0.0],
            course: Course::Constant,
        });
        scene
    };
    let beyond = |track: &Track| {
        let up = |m: &Motion| rotate(m.rotation, [0.0, 1.0, 0.0]);
        angle(up(&track.last()[0]), up(&track.first()[0])) > 0.2
    };
    Case::threshold(
        'C',
        "c10_push",
        "the height at which a push tips a tall box over",
        3.0,
        Threshold {
            scene: Box::new(build),
            beyond: Box::new(beyond),
            exact: 0.25 / 0.7,
            range: [0.1, 0.9],
            halvings: 11,
        },
    )
}

/// Cubes between two plates that are pressed with this force: 5 cubes of 1 kg and 0.1 m.
pub fn grip_scene(force: f64) -> Scene {
    let mut scene = scene("c14_grip", "five cubes held between two plates");
    let (count, friction) = (5, 0.5);
    let surface = |b: Body| Body { friction, ..b };
    scene.bodies.push(Body { collides: false, ..Body::fixed(Form::Sphere(0.05), [0.0, 1.0, 0.0]) });
    for i in 0..count {
        let x = 0.1 * (f64::from(i) - 0.5 * f64::from(count - 1));
        scene.bodies.push(surface(Body::dynamic(Form::Box([0.05; 3]), [x, 0.0, 0.0])));
    }
    for side in [-1.0, 1.0] {
        let x = side * (0.05 * f64::from(count) + 0.02);
        let plate = scene.bodies.len();
        scene.bodies.push(surface(Body::dynamic(Form::Box([0.02, 0.1, 0.1]), [x, 0.0, 0.0])));
        scene.joints.push(Joint::new(Hold::Slider(None), [0, plate], [[x, -1.0, 0.0], [0.0; 3]]));
        scene.pushes.push(Push {
            body: plate,
            force: [-side * force, 0.0, 0.0],
            at: [0.0; 3],
            course: Course::Constant,
        });
    }
    scene
}

/// The least force that holds them \[N\].
pub const GRIP: f64 = 5.0 * G / (2.0 * 0.5);

/// Whether they hold.
pub fn grip_holds(track: &Track) -> bool {
    track.last()[..5].iter().all(|m| m.position[1] > -0.02)
}

fn grip() -> Case {
    Case::threshold(
        'C',
        "c14_grip",
        "the force between two plates that holds five cubes",
        1.0,
        Threshold {
            scene: Box::new(grip_scene),
            beyond: Box::new(grip_holds),
            exact: GRIP,
            range: [0.5 * GRIP, 3.0 * GRIP],
            halvings: 11,
        },
    )
}
