//! F to J: fast bodies, geometry, scale, long runs, ensembles.

use super::{MESH, group_a, group_c, group_d, scene};
use crate::case::{Case, Reference, Track};
use crate::engines::Motion;
use crate::metrics::{angular_momentum, apexes, energy, kinetic, momentum};
use crate::records::Outcome;
use crate::scene::{Body, Form, Joint, Scene};
use crate::vector::{V3, add, norm, rotate, scale, sub, unit};

pub fn cases() -> Vec<Case> {
    vec![
        bullet("f1_wall_50", "balls at 50 m/s against a wall of 20 mm", bullet_scene(50.0, false), 50.0),
        bullet("f1_wall_300", "balls at 300 m/s against a wall of 20 mm", bullet_scene(300.0, false), 300.0),
        bullet("f1_thin_wall_50", "balls at 50 m/s against a wall of 2 mm", thin_wall_scene(50.0), 50.0),
        bullet(
            "f2_plate_50",
            "balls at 50 m/s against loose plates of 20 mm",
            bullet_scene(50.0, true),
            50.0,
        ),
        ghost(),
        ledge(),
        bounce_house(),
        thin_box(),
        Case::missing('F', "f5_into_mesh", "fast hulls into a mesh", MESH),
        seam(),
        thin_plate(),
        needle(),
        extreme_size(),
        on_a_globe(),
        Case::missing(
            'G',
            "g2_closest_points",
            "a million pairs of shapes",
            "bodies' motions do not show distances and normals; `cargo bench --bench fuzz_pairs` measures them",
        ),
        Case::missing('G', "g3_sliver", "the normal of a sliver triangle", MESH),
        Case::missing('G', "g1_internal_edges", "a box slides over a triangle grid", MESH),
        Case::missing('G', "g4_plate_on_mesh", "thin plates on a mesh", MESH),
        Case::missing('G', "g5_large_triangle", "a small box on a large triangle", MESH),
        far_drift("h1_far_1km", "a free body 1 km from the origin", 1e3),
        far_drift("h1_far_20km", "a free body 20 km from the origin", 2e4),
        far_drift("h1_far_1000km", "a free body 1000 km from the origin", 1e6),
        far_drift("h1_far_5km", "a free body 5 km from the origin", 5e3),
        far_drift("h1_far_100km", "a free body 100 km from the origin", 1e5),
        far_stack("h2_far_stack_1km", "five boxes 1 km from the origin", 1e3),
        far_stack("h2_far_stack_20km", "five boxes 20 km from the origin", 2e4),
        scaled("h3_small", "five cubes of 1 cm", 0.01),
        scaled("h3_large", "five cubes of 100 m", 100.0),
        boosted(),
        creep(),
        resting_stack(),
        long_spin(),
        billiard(),
        momentum_audit(),
        dice(),
        Case::missing('J', "j5_tosses", "measured tosses of a cube", "the data are not shipped with the lab"),
    ]
}

fn bullet(name: &'static str, about: &'static str, scene: Scene, speed: f64) -> Case {
    let loose = scene.dynamic_count() > BULLETS;
    let scene = Scene { name, about, ..scene };
    let judge = move |scene: &Scene, track: &Track| {
        let through = tunnelled(track);
        let off = track.last()[..BULLETS].iter().map(|m| m.velocity[0].max(0.0)).fold(0.0, f64::max);
        let exact = if loose { speed * ball_mass() / (ball_mass() + plate_mass()) } else { 0.0 };
        let p = norm(momentum(scene, track.first()));
        let lost = norm(sub(momentum(scene, track.last()), momentum(scene, track.first()))) / p;
        let mut verdict = super::verdict((off - exact).abs())
            .and("tunnelling_rate", through as f64 / BULLETS as f64)
            .and("momentum", if loose { lost } else { 0.0 });
        if through > 0 {
            verdict.outcome = Some(Outcome::Tunnelled);
        }
        verdict
    };
    Case::run('F', Reference::ClosedForm, scene, 0.25, Box::new(judge))
        .primary("greatest error of the speed after the impact; tunnelled if any ball comes through")
        .scale(speed, "m/s, the speed before")
}

const BULLETS: usize = 20;

fn ball_mass() -> f64 {
    1000.0 * 4.0 / 3.0 * std::f64::consts::PI * 0.05 * 0.05 * 0.05
}

fn plate_mass() -> f64 {
    1000.0 * 0.02
}

/// Balls that meet walls at different phases of a step.
pub fn bullet_scene(speed: f64, loose: bool) -> Scene {
    let mut scene = scene("bullets", "");
    scene.gravity = [0.0; 3];
    for k in 0..BULLETS {
        // From a step of 1/60 s away, by twentieths of it.
        let x = -0.5 - speed / 60.0 * (1.0 + k as f64 / BULLETS as f64);
        let velocity = [speed, 0.0, 0.0];
        scene.bodies.push(Body { velocity, ..Body::dynamic(Form::Sphere(0.05), [x, 0.0, 3.0 * k as f64]) });
    }
    for k in 0..BULLETS {
        let at = [0.01, 0.0, 3.0 * k as f64];
        let form = Form::Box([0.01, 0.5, 0.5]);
        scene.bodies.push(if loose { Body::dynamic(form, at) } else { Body::fixed(form, at) });
    }
    scene
}

/// The same with walls of 2 mm, whose near side is where it was.
fn thin_wall_scene(speed: f64) -> Scene {
    let mut scene = bullet_scene(speed, false);
    for wall in &mut scene.bodies[BULLETS..] {
        wall.form = Form::Box([0.001, 0.5, 0.5]);
        wall.position[0] = 0.001;
    }
    scene
}

/// How many balls have come through.
pub fn tunnelled(track: &Track) -> usize {
    let last = track.last();
    (0..BULLETS)
        .filter(|&k| {
            let wall = last.get(BULLETS + k).map_or(0.01, |m| m.position[0]);
            last[k].position[0] > wall
        })
        .count()
}

fn ghost() -> Case {
    let mut scene = scene("f4_ghost", "a box flies past the edge of another at 20 m/s, 5 mm away");
    scene.gravity = [0.0; 3];
    scene.bodies.push(Body::fixed(Form::Box([0.5; 3]), [0.0, -0.5, 0.0]));
    let velocity = [20.0, 0.0, 0.0];
    scene.bodies.push(Body { velocity, ..Body::dynamic(Form::Box([0.5; 3]), [-3.0, 0.505, 0.0]) });
    let judge = |_: &Scene, track: &Track| {
        let m = &track.last()[0];
        super::verdict(norm(sub(m.velocity, [20.0, 0.0, 0.0]))).and("spin_rad_s", norm(m.spin))
    };
    Case::run('F', Reference::ClosedForm, scene, 0.4, Box::new(judge))
        .primary("change of velocity")
        .scale(20.0, "m/s, its speed")
}

fn ledge() -> Case {
    let mut scene = scene("f4_ledge", "a ball flies under a ledge at 20 m/s, 5 mm away");
    scene.gravity = [0.0; 3];
    scene.bodies.push(Body::fixed(Form::Box([0.5, 0.1, 0.5]), [0.0, 0.1, 0.0]));
    let velocity = [20.0, 0.0, 0.0];
    scene.bodies.push(Body { velocity, ..Body::dynamic(Form::Sphere(0.2), [-3.0, -0.205, 0.0]) });
    let judge = |_: &Scene, track: &Track| {
        let m = &track.last()[0];
        super::verdict(norm(sub(m.velocity, [20.0, 0.0, 0.0]))).and("spin_rad_s", norm(m.spin))
    };
    Case::run('F', Reference::ClosedForm, scene, 0.4, Box::new(judge))
        .primary("change of velocity")
        .scale(20.0, "m/s, its speed")
}

/// Ten boxes of 1 m in a room of 10 m whose walls are 10 cm thick.
fn thin_box() -> Case {
    let mut scene = scene("f5_thin_box", "ten boxes at 400 m/s in a room with thin walls");
    scene.gravity = [0.0; 3];
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let (mut half, mut at) = ([5.2; 3], [0.0; 3]);
            (half[axis], at[axis]) = (0.05, 5.05 * side);
            scene.bodies.push(Body::fixed(Form::Box(half), at));
        }
    }
    let mut random = super::Random::new(5);
    for k in 0..10 {
        let at = [k % 3, k / 3 % 3, k / 9].map(|i| 2.0 * f64::from(i) - 2.0);
        let way = unit_of([random.half(), random.half(), random.half()]);
        let velocity = scale(way, 400.0);
        scene.bodies.push(Body { velocity, ..Body::dynamic(Form::Box([0.5; 3]), at) });
    }
    let judge = |_: &Scene, track: &Track| {
        let out = |m: &&Motion| m.position.iter().any(|x| x.abs() > 5.0);
        let escaped = track.last().iter().filter(out).count();
        let mut verdict = super::verdict(escaped as f64 / 10.0).and("escaped", escaped as f64);
        if escaped > 0 {
            verdict.outcome = Some(Outcome::Tunnelled);
        }
        verdict
    };
    Case::run('F', Reference::Invariant, scene, 1.0, Box::new(judge))
        .primary("share of boxes outside at the end; tunnelled if any is")
        .most_rate(240.0)
}

fn bounce_house() -> Case {
    let mut scene = scene("f6_bounce_house", "an elastic ball in a box of 1 m at 10 m/s");
    scene.gravity = [0.0; 3];
    scene.restitution_threshold = Some(0.0);
    let surface = |b: Body| Body { restitution: 1.0, friction: 0.0, ..b };
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let (mut half, mut at) = ([1.5; 3], [0.0; 3]);
            (half[axis], at[axis]) = (0.5, side);
            scene.bodies.push(surface(Body::fixed(Form::Box(half), at)));
        }
    }
    let velocity = scale(unit_of([0.6, 0.7, 0.4]), 10.0);
    scene.bodies.push(surface(Body { velocity, ..Body::dynamic(Form::Sphere(0.1), [0.03, -0.05, 0.07]) }));
    let start = [0.03, -0.05, 0.07];
    // The ball's centre is a point in a box of half side 0.4: unfolded, its way is straight.
    let fold = |x: f64| {
        let u = (x + 0.4).rem_euclid(1.6);
        if u < 0.8 { u - 0.4 } else { 1.2 - u }
    };
    let judge = move |scene: &Scene, track: &Track| {
        let k = track.at(1.0);
        let there = [0, 1, 2].map(|i| fold(start[i] + velocity[i] * track.times[k]));
        let off = norm(sub(track.frames[k][0].position, there));
        let e = kinetic(scene, track.first());
        let escaped = track.last()[0].position.iter().any(|x| x.abs() > 0.6);
        let energy = (kinetic(scene, track.last()) / e - 1.0).abs();
        let mut verdict = super::verdict(off).and("energy", energy);
        if escaped {
            verdict.outcome = Some(Outcome::Tunnelled);
        }
        verdict
    };
    Case::run('F', Reference::ClosedForm, scene, 10.0, Box::new(judge))
        .primary("distance from the billiard's way after 1 s")
        .scale(0.8, "m, the room")
        .most_rate(960.0)
}

fn unit_of(v: V3) -> V3 {
    scale(v, 1.0 / norm(v))
}

fn seam() -> Case {
    let mut scene = scene("g1_seam", "a box slides without friction over ten slabs side by side");
    let surface = |b: Body| Body { friction: 0.0, ..b };
    for k in 0..10 {
        let at = [2.0 * f64::from(k), -0.5, 0.0];
        scene.bodies.push(surface(Body::fixed(Form::Box([1.0, 0.5, 2.0]), at)));
    }
    let velocity = [5.0, 0.0, 0.0];
    scene.bodies.push(surface(Body { velocity, ..Body::dynamic(Form::Box([0.25; 3]), [0.0, 0.25, 0.1]) }));
    let judge = |_: &Scene, track: &Track| {
        let off = track.greatest(|f| norm(sub(f[0].velocity, [5.0, 0.0, 0.0])));
        let turn = track.greatest(|f| norm(f[0].spin));
        super::verdict(off).and("spin_rad_s", turn).and("speed_loss", 1.0 - track.last()[0].velocity[0] / 5.0)
    };
    Case::run('G', Reference::ClosedForm, scene, 3.0, Box::new(judge))
        .primary("greatest change of velocity")
        .scale(5.0, "m/s, its speed")
        .most_rate(960.0)
}

/// A square plate of this thickness over its side of 2 m, dropped flat from 1 cm.
pub fn plate_scene(thickness: f64) -> Scene {
    let mut scene = scene("g4_thin_plate", "a plate of 2 m and 2 mm falls flat");
    scene.floor([20.0, 1.0, 20.0]);
    let half = [1.0, 0.5 * thickness, 1.0];
    scene.bodies.push(Body::dynamic(Form::Box(half), [0.0, 0.01 + half[1], 0.0]));
    scene
}

fn thin_plate() -> Case {
    let judge = |_: &Scene, track: &Track| {
        let m = &track.last()[0];
        let low = (-4..5).fold(f64::INFINITY, |low: f64, k| {
            let corner = [if k % 2 == 0 { 1.0 } else { -1.0 }, -0.001, if k < 0 { 1.0 } else { -1.0 }];
            low.min(add(m.position, rotate(m.rotation, corner))[1])
        });
        super::verdict((m.position[1] - 0.001).abs().max(low.abs())).and("speed_m_s", norm(m.velocity))
    };
    Case::run('G', Reference::ClosedForm, plate_scene(0.002), 3.0, Box::new(judge))
        .primary("greatest error of the height of its centre and of its lowest corner")
        .scale(0.002, "m, its thickness")
        .most_rate(480.0)
}

fn needle() -> Case {
    let mut scene = scene("g4_needle", "a needle of 1 m and 1 mm falls flat");
    scene.floor([20.0, 1.0, 20.0]);
    scene.bodies.push(Body::dynamic(Form::Box([0.5, 0.0005, 0.0005]), [0.0, 0.0105, 0.0]));
    let judge = |_: &Scene, track: &Track| {
        let m = &track.last()[0];
        let off =
            [-0.5, 0.0, 0.5].map(|x| (add(m.position, rotate(m.rotation, [x, 0.0, 0.0]))[1] - 5e-4).abs());
        super::verdict(off.into_iter().fold(0.0, f64::max)).and("speed_m_s", norm(m.velocity))
    };
    Case::run('G', Reference::ClosedForm, scene, 2.0, Box::new(judge))
        .primary("greatest error of the height of its middle and its ends")
        .scale(0.001, "m, its thickness")
        .most_rate(480.0)
}

/// The ground is level to 1e-8 m under the box, and its middle a kilometre away.
fn on_a_globe() -> Case {
    let mut scene = scene("g5_on_a_globe", "a box of 1 cm on a ball of 2 km");
    scene.bodies.push(Body::fixed(Form::Sphere(1000.0), [0.0, -1000.0, 0.0]));
    scene.bodies.push(Body::dynamic(Form::Box([0.005; 3]), [0.0, 0.005, 0.0]));
    let judge = |_: &Scene, track: &Track| {
        let moved = norm(sub(track.last()[0].position, track.first()[0].position));
        super::verdict(moved).and("speed_m_s", norm(track.last()[0].velocity))
    };
    Case::run('G', Reference::ClosedForm, scene, 2.0, Box::new(judge))
        .primary("distance from its place, at the end")
        .scale(0.01, "m, its side")
        .most_rate(480.0)
}

fn extreme_size() -> Case {
    let mut scene = scene("g5_extreme_size", "a box of 1 cm on one of 2 km");
    scene.bodies.push(Body::fixed(Form::Box([1000.0; 3]), [0.0, -1000.0, 0.0]));
    scene.bodies.push(Body::dynamic(Form::Box([0.005; 3]), [0.0, 0.005, 0.0]));
    let judge = |_: &Scene, track: &Track| {
        let moved = norm(sub(track.last()[0].position, track.first()[0].position));
        super::verdict(moved).and("speed_m_s", norm(track.last()[0].velocity))
    };
    Case::run('G', Reference::ClosedForm, scene, 5.0, Box::new(judge))
        .primary("distance from its place, at the end")
        .scale(0.01, "m, its side")
        .most_rate(480.0)
}

fn far_drift(name: &'static str, about: &'static str, far: f64) -> Case {
    let mut scene = scene(name, about);
    scene.gravity = [0.0; 3];
    let (start, velocity) = (add([far; 3], [0.013, 0.027, 0.041]), [0.37, 0.11, -0.23]);
    scene.bodies.push(Body { velocity, ..Body::dynamic(Form::Sphere(0.5), start) });
    let judge = move |_: &Scene, track: &Track| {
        // From where the engine put it: the rounding of the first place is no drift.
        let moved = sub(track.last()[0].position, track.first()[0].position);
        super::verdict(norm(sub(moved, scale(velocity, track.end()))))
    };
    Case::run('H', Reference::ClosedForm, scene, 10.0, Box::new(judge))
        .primary("error of the way")
        .scale(10.0 * norm(velocity), "m, the way")
        .integrators()
        .most_rate(480.0)
}

/// Five boxes of 0.2 m, this far from the origin along all axes.
pub fn far_stack_scene(far: f64) -> Scene {
    let mut scene = scene("h2_far_stack", "five boxes far from the origin");
    let shift = add([far; 3], [0.013, 0.027, 0.041]);
    scene.bodies.push(Body::fixed(Form::Box([5.0, 1.0, 5.0]), add(shift, [0.0, -1.0, 0.0])));
    for k in 0..5 {
        let at = add(shift, [0.0, 0.1 + 0.2 * f64::from(k), 0.0]);
        scene.bodies.push(Body::dynamic(Form::Box([0.1; 3]), at));
    }
    scene
}

fn far_stack(name: &'static str, about: &'static str, far: f64) -> Case {
    let scene = Scene { name, about, ..far_stack_scene(far) };
    let judge = |_: &Scene, track: &Track| {
        let late = &track.frames[track.len() / 2..];
        let speed = |f: &Vec<Motion>| f.iter().map(|m| norm(m.velocity)).fold(0.0, f64::max);
        super::verdict(track.farthest(track.last()))
            .and("late_speed_m_s", late.iter().map(speed).fold(0.0, f64::max))
    };
    Case::run('H', Reference::ClosedForm, scene, 5.0, Box::new(judge))
        .primary("greatest distance of a box from its place, at the end")
        .scale(0.2, "m, the side")
        .most_rate(480.0)
}

fn scaled(name: &'static str, about: &'static str, size: f64) -> Case {
    let mut scene = scene(name, about);
    scene.floor([50.0 * size, size, 50.0 * size]);
    for k in 0..5 {
        let at = [0.0, size * (0.5 + f64::from(k)), 0.0];
        scene.bodies.push(Body::dynamic(Form::Box([0.5 * size; 3]), at));
    }
    let judge = |_: &Scene, track: &Track| super::verdict(track.farthest(track.last()));
    Case::run('H', Reference::ClosedForm, scene, 5.0, Box::new(judge))
        .primary("greatest distance of a cube from its place, at the end")
        .scale(size, "m, the side")
        .most_rate(480.0)
}

fn boosted() -> Case {
    let mut scene = scene("h4_boost", "a stack of five on a floor that moves at 3 m/s");
    let velocity = [3.0, 0.0, 1.0];
    scene.bodies.push(Body {
        kind: crate::scene::Kind::Kinematic,
        velocity,
        ..Body::fixed(Form::Box([20.0, 1.0, 20.0]), [0.0, -1.0, 0.0])
    });
    for k in 0..5 {
        let cube = Body::dynamic(Form::Box([0.5; 3]), [0.0, 0.5 + f64::from(k), 0.0]);
        scene.bodies.push(Body { velocity, ..cube });
    }
    let judge = move |_: &Scene, track: &Track| {
        let pairs = track.first().iter().zip(track.last());
        let way = scale(velocity, track.end());
        let off = pairs.map(|(a, b)| norm(sub(sub(b.position, a.position), way)));
        super::verdict(off.fold(0.0, f64::max))
    };
    Case::run('H', Reference::ClosedForm, scene, 5.0, Box::new(judge))
        .primary("greatest distance of a cube from its place on the floor, at the end")
        .scale(1.0, "m, the side")
        .most_rate(480.0)
}

fn creep() -> Case {
    let about = "a box on a slope at 0.9 of the friction angle, for a minute";
    let flat = group_c::box_on_floor("i1_creep", about, [0.5, 0.25, 0.5], 0.5);
    let scene = group_c::slope(flat, libm::atan(0.45));
    let judge = |_: &Scene, track: &Track| {
        let late = &track.frames[track.len() / 6];
        let moved = norm(sub(track.last()[0].position, late[0].position));
        super::verdict(moved).and("creep_m_per_h", moved * 3600.0 * 6.0 / (5.0 * track.end()))
    };
    Case::run('I', Reference::Invariant, scene, 60.0, Box::new(judge))
        .primary("way after the first sixth of the time")
        .scale(1.0, "m, the side")
        .most_rate(240.0)
}

fn resting_stack() -> Case {
    let about = "ten cubes on each other for two minutes: what they would creep in an hour";
    let scene = group_d::tower("i1_stack", about, &[1000.0; 10]);
    let judge = |_: &Scene, track: &Track| {
        let from = track.len() / 6;
        let pairs = || track.frames[from].iter().zip(track.last());
        let moved = pairs().map(|(a, b)| norm(sub(b.position, a.position))).fold(0.0, f64::max);
        let turned = pairs().map(|(a, b)| crate::vector::angle_between(a.rotation, b.rotation));
        let hours = (track.end() - track.times[from]) / 3600.0;
        super::verdict(moved / hours).and("turn_rad_per_h", turned.fold(0.0, f64::max) / hours)
    };
    Case::run('I', Reference::Invariant, scene, 120.0, Box::new(judge))
        .primary("greatest way of a cube after the first sixth of the time, an hour")
        .scale(1.0, "m/h")
        .most_rate(60.0)
        .defaults_only()
}

fn billiard() -> Case {
    let mut scene = scene("i3_billiard", "an elastic ball bounces 20 cm high for two minutes");
    scene.restitution_threshold = Some(0.0);
    let surface = |b: Body| Body { restitution: 1.0, friction: 0.0, ..b };
    scene.floor_of([5.0, 1.0, 5.0], surface);
    scene.bodies.push(surface(Body::dynamic(Form::Sphere(0.05), [0.0, 0.25, 0.0])));
    let judge = |_: &Scene, track: &Track| {
        let heights = track.series(|f| f[0].position[1] - 0.05);
        let found = apexes(&heights, &track.series(|f| f[0].velocity[1]), super::G);
        // At the height that it has, it should have bounced about so often.
        let enough = 0.8 * track.end() / (2.0 * (2.0 * 0.2 / super::G).sqrt());
        let off = |h: &f64| (h / 0.2 - 1.0).abs();
        let late = &found[found.len() - found.len().min(10)..];
        let worst = late.iter().map(off).fold(0.0, f64::max);
        let count = found.len() as f64;
        let drift = late.last().map_or(0.0, |h| (h / found[0] - 1.0) / count.max(1.0));
        super::verdict(if count > 0.5 * enough { worst } else { 1.0 })
            .and("drift_per_bounce", drift)
            .and("bounces", count)
    };
    Case::run('I', Reference::ClosedForm, scene, 120.0, Box::new(judge))
        .primary("greatest relative error of the last ten heights; 1 if it no longer bounces")
        .most_rate(240.0)
}

fn long_spin() -> Case {
    let mut scene = scene("i2_long_spin", "the tumbling box for five minutes");
    scene.gravity = [0.0; 3];
    scene.bodies.push(group_a::box_of_ten([0.1, 5.0, 0.1]));
    Case::run('I', Reference::Invariant, scene, 300.0, Box::new(group_a::kept_spin))
        .primary("greatest change of energy or of angular momentum, over their size")
        .integrators()
        .most_rate(120.0)
}

fn momentum_audit() -> Case {
    let mut scene = scene("i4_momentum", "forty boxes collide in empty space, some of them tied together");
    scene.gravity = [0.0; 3];
    let mut random = super::Random::new(4);
    for k in 0..40 {
        let at = [k % 4, k / 4 % 4, k / 16].map(|i| 1.1 * f64::from(i) - 1.6);
        let mut three = || [random.half(), random.half(), random.half()];
        let (half, velocity, spin, q) = (three(), three(), three(), three());
        scene.bodies.push(Body {
            velocity: sub(scale(velocity, 4.0), at),
            spin: scale(spin, 6.0),
            rotation: unit([q[0], q[1], q[2], 1.0]),
            ..Body::dynamic(Form::Box(half.map(|h| 0.3 + 0.2 * h)), at)
        });
    }
    for k in 0..10 {
        let (a, b) = (4 * k, 4 * k + 1);
        let middle = scale(add(scene.bodies[a].position, scene.bodies[b].position), 0.5);
        let local = [a, b].map(|i| {
            let body = &scene.bodies[i];
            rotate(crate::vector::conjugate(body.rotation), sub(middle, body.position))
        });
        scene.joints.push(Joint::ball([a, b], local));
    }
    let judge = |scene: &Scene, track: &Track| {
        let sizes = |f: &[Motion]| {
            crate::case::masses(scene).iter().zip(f).fold((0.0, 0.0), |(p, l), ((m, i), motion)| {
                let reach = norm(motion.position) * norm(motion.velocity) * m;
                (p + m * norm(motion.velocity), l + reach + i[1] * norm(motion.spin))
            })
        };
        let (p0, l0) = (momentum(scene, track.first()), angular_momentum(scene, track.first()));
        let (sp, sl) = sizes(track.first());
        let p = norm(sub(momentum(scene, track.last()), p0)) / sp;
        let l = norm(sub(angular_momentum(scene, track.last()), l0)) / sl;
        super::verdict(p.max(l)).and("momentum", p).and("angular_momentum", l)
    };
    Case::run('I', Reference::Invariant, scene, 10.0, Box::new(judge))
        .primary("change of momentum and of angular momentum, over the sums of their sizes")
        .most_rate(240.0)
}

fn dice() -> Case {
    let mut scene = scene("j2_dice", "150 cubes are thrown: how often does each face lie up");
    scene.floor([60.0, 1.0, 60.0]);
    let mut random = super::Random::new(6);
    for k in 0..150 {
        let at = [3.0 * f64::from(k % 15) - 21.0, 1.2, 3.0 * f64::from(k / 15) - 15.0];
        let mut three = || [random.half(), random.half(), random.half()];
        let (v, w, q, r) = (three(), three(), three(), random.half());
        scene.bodies.push(Body {
            velocity: scale(v, 2.0),
            spin: scale(w, 20.0),
            rotation: unit([q[0], q[1], q[2], r]),
            restitution: 0.3,
            ..Body::dynamic(Form::Box([0.25; 3]), at)
        });
    }
    let judge = |scene: &Scene, track: &Track| {
        let mut counts = [0.0; 6];
        for m in track.last() {
            let up = rotate(crate::vector::conjugate(m.rotation), [0.0, 1.0, 0.0]);
            let axis = (0..3).max_by(|&a, &b| up[a].abs().total_cmp(&up[b].abs())).unwrap_or(0);
            counts[2 * axis + usize::from(up[axis] < 0.0)] += 1.0;
        }
        let chi2: f64 = counts.iter().map(|c: &f64| (c - 25.0) * (c - 25.0) / 25.0).sum();
        let left = energy(scene, track.last()) / energy(scene, track.first());
        super::verdict(chi2).and("energy_left", left)
    };
    Case::run('J', Reference::Invariant, scene, 4.0, Box::new(judge))
        .primary("χ² of the faces against equal shares; 11 is the 95 % bound")
        .scale(11.07, "the 95 % bound of χ² with 5 degrees")
        .most_rate(120.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_that_is_still_at_the_wall_has_not_tunnelled() {
        let scene = bullet_scene(50.0, false);
        let track = Track::null(&scene, 0.1);
        assert_eq!(tunnelled(&track), 0);
    }
}
