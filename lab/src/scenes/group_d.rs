//! D: stacks, masonry and mass ratios.

use super::{G, scene};
use crate::case::{Case, Reference, Threshold, Track};
use crate::engines::Motion;
use crate::metrics::kinetic;
use crate::references::statics;
use crate::scene::{Body, Form, Mass, Scene};
use crate::vector::{norm, sub, turn};
use std::f64::consts::PI;

pub fn cases() -> Vec<Case> {
    vec![
        ratio("d1_ratio_1", "a cube on an equal one", 1.0),
        ratio("d1_ratio_10", "10 kg on 1 kg", 10.0),
        ratio("d1_ratio_100", "100 kg on 1 kg", 100.0),
        ratio("d1_ratio_1000", "1000 kg on 1 kg", 1000.0),
        equal_stack("d2_stack_10", "ten cubes on each other", 10),
        equal_stack("d2_stack_20", "twenty cubes on each other", 20),
        equal_stack("d2_stack_50", "fifty cubes on each other", 50).defaults_only().most_rate(60.0),
        heavy_apex(),
        doubling(),
        card_house("d5_card_house", "a house of cards of three levels", 3, 0.7),
        card_house("d5_card_house_4", "a house of cards of four levels, friction 0.8", 4, 0.8)
            .defaults_only(),
        arch_thickness(),
        arch_friction(),
        kapla(),
        one_step(
            "d9_one_step_stack",
            "the first step of ten cubes on each other",
            tower("", "", &[1000.0; 10]),
        ),
        one_step("d9_one_step_ratio", "the first step of 100 kg on 1 kg", tower("", "", &[1.0, 100.0])),
        one_step("d9_one_step_pyramid", "the first step of a pyramid of six boxes", small_pyramid()),
        Case::missing(
            'D',
            "d9_fclib",
            "stored contact problems",
            "the collection of problems is not shipped with the lab",
        ),
    ]
}

/// Cubes with side 1 m of these masses on each other.
pub fn tower(name: &'static str, about: &'static str, masses: &[f64]) -> Scene {
    let mut scene = scene(name, about);
    scene.floor([50.0, 1.0, 50.0]);
    for (i, &density) in masses.iter().enumerate() {
        let cube = Body::dynamic(Form::Box([0.5; 3]), [0.0, 0.5 + i as f64, 0.0]);
        scene.bodies.push(Body { density, ..cube });
    }
    scene
}

/// The deepest overlap of a tower of unit cubes.
pub fn tower_overlap(frame: &[Motion]) -> f64 {
    let mut floor = -0.5;
    let mut worst = 0.0_f64;
    for m in frame {
        worst = worst.max(1.0 - (m.position[1] - floor));
        floor = m.position[1];
    }
    worst
}

/// How far the worst cube is from where it began, sideways.
pub fn drift(track: &Track) -> f64 {
    let pairs = track.first().iter().zip(track.last());
    pairs.fold(0.0, |worst, (a, b)| {
        let d = sub(b.position, a.position);
        worst.max(norm([d[0], 0.0, d[2]]))
    })
}

fn ratio(name: &'static str, about: &'static str, heavy: f64) -> Case {
    let judge = |_: &Scene, track: &Track| {
        let last = track.last();
        let sunk = track.farthest(last);
        let speed = last.iter().map(|m| norm(m.velocity)).fold(0.0, f64::max);
        super::verdict(sunk.max(tower_overlap(last)))
            .and("overlap", tower_overlap(last))
            .and("worst_overlap", track.greatest(tower_overlap))
            .and("speed_m_s", speed)
    };
    Case::run('D', Reference::ClosedForm, tower(name, about, &[1.0, heavy]), 10.0, Box::new(judge))
        .primary("greatest of overlap and of a cube's distance from its place, at the end")
        .scale(1.0, "m, the side")
        .most_rate(480.0)
}

fn equal_stack(name: &'static str, about: &'static str, count: usize) -> Case {
    let judge = move |scene: &Scene, track: &Track| {
        let (first, last) = (track.first(), track.last());
        let sag = (first[count - 1].position[1] - last[count - 1].position[1]).abs();
        let off = sag.max(drift(track));
        super::verdict(off)
            .and("sag_m", sag)
            .and("drift_m", drift(track))
            .and("overlap", tower_overlap(last))
            .and("energy", kinetic(scene, last) / (1000.0 * G))
    };
    Case::run('D', Reference::ClosedForm, tower(name, about, &vec![1000.0; count]), 20.0, Box::new(judge))
        .primary("greatest of the top's sag and of a cube's way sideways, at the end")
        .scale(count as f64, "m, the height")
        .most_rate(240.0)
}

fn heavy_apex() -> Case {
    let mut scene = scene("d3_heavy_apex", "a pyramid of ten rows under a top 100 times as heavy");
    scene.floor([50.0, 1.0, 50.0]);
    for row in 0..10 {
        for k in 0..10 - row {
            let at = [2.0 * f64::from(k) + f64::from(row), 1.0 + 2.0 * f64::from(row), 0.0];
            let density = if row == 9 { 1e5 } else { 1e3 };
            scene.bodies.push(Body { density, ..Body::dynamic(Form::Box([1.0; 3]), at) });
        }
    }
    let judge = |_: &Scene, track: &Track| {
        let top = |f: &[Motion]| f[f.len() - 1].position;
        super::verdict(norm(sub(top(track.first()), top(track.last())))).and("drift_m", drift(track))
    };
    Case::run('D', Reference::ClosedForm, scene, 10.0, Box::new(judge))
        .primary("distance of the top from its place, at the end")
        .scale(2.0, "m, the side")
        .most_rate(240.0)
}

fn doubling() -> Case {
    let mut scene = scene("d4_doubling", "six cubes, each twice as large as the one below");
    scene.floor([100.0, 1.0, 100.0]);
    let (mut side, mut bottom) = (0.25, 0.0);
    for _ in 0..6 {
        let half = 0.5 * side;
        scene.bodies.push(Body::dynamic(Form::Box([half; 3]), [0.0, bottom + half, 0.0]));
        (bottom, side) = (bottom + side, 2.0 * side);
    }
    let judge =
        |_: &Scene, track: &Track| super::verdict(track.farthest(track.last())).and("drift_m", drift(track));
    Case::run('D', Reference::ClosedForm, scene, 10.0, Box::new(judge))
        .primary("greatest distance of a cube from its place, at the end")
        .scale(0.25, "m, the least side")
        .most_rate(480.0)
}

fn card_house(name: &'static str, about: &'static str, levels: i32, friction: f64) -> Case {
    let mut scene = scene(name, about);
    let surface = |b: Body| Body { friction, ..b };
    scene.floor_of([5.0, 1.0, 5.0], surface);
    let (half, thin, tilt) = (0.2, 0.005, 25.0 * PI / 180.0);
    let (s, c) = libm::sincos(tilt);
    // Half the width of a leaning pair at its feet, and its height.
    let (reach, height) = (2.0 * (half * s + thin * c), 2.0 * (half * c + thin * s));
    for level in 0..levels {
        let bottom = f64::from(level) * (height + 2.0 * thin);
        let pairs = levels - level;
        for k in 0..pairs {
            let x = reach * (2.0 * f64::from(k) - f64::from(pairs - 1));
            for side in [-1.0, 1.0] {
                let rotation = turn([0.0, 0.0, 1.0], side * tilt);
                let at = [x + side * 0.5 * reach, bottom + 0.5 * height, 0.0];
                let form = Form::Box([thin, half, 0.1]);
                scene.bodies.push(surface(Body { rotation, ..Body::dynamic(form, at) }));
            }
        }
        for k in 0..pairs - 1 {
            let x = reach * (2.0 * f64::from(k) - f64::from(pairs - 2));
            // As long as the pairs are apart, less a little.
            let form = Form::Box([reach - 1e-3, thin, 0.1]);
            scene.bodies.push(surface(Body::dynamic(form, [x, bottom + height + thin, 0.0])));
        }
    }
    let judge = |_: &Scene, track: &Track| {
        let fell = (0..track.len()).find(|&k| track.farthest(&track.frames[k]) > 0.1);
        super::verdict(track.farthest(track.last()))
            .and("stood_s", track.times[fell.unwrap_or(track.len() - 1)])
    };
    Case::run('D', Reference::Invariant, scene, 5.0, Box::new(judge))
        .primary("greatest distance of a card from its place, at the end")
        .scale(0.4, "m, a card's length")
        .most_rate(480.0)
}

/// Half a circle of 25 stones of mean radius 5 m between two immovable ones.
fn arch(thickness: f64, friction: f64) -> Scene {
    let mut scene = scene("arch", "");
    let (count, radius) = (25, 5.0);
    let step = PI / f64::from(count);
    let (inner, outer) = (radius * (1.0 - 0.5 * thickness), radius * (1.0 + 0.5 * thickness));
    let surface = |b: Body| Body { friction, ..b };
    // The feet rest on the floor: the last joints are level.
    scene.floor_of([20.0, 1.0, 20.0], surface);
    // A stone in a frame whose y is outward, its centre of mass at the origin.
    let (s, c) = libm::sincos(0.5 * step);
    let area = 0.5 * (outer * outer - inner * inner) * libm::sin(step);
    let centre =
        2.0 / 3.0 * c * (outer * outer * outer - inner * inner * inner) / (outer * outer - inner * inner);
    let corners =
        [[-s * inner, c * inner], [s * inner, c * inner], [s * outer, c * outer], [-s * outer, c * outer]];
    let local = corners.map(|[x, y]| [x, y - centre]);
    scene.clouds.push(local.iter().flat_map(|&[x, y]| [[x, y, -0.5], [x, y, 0.5]]).collect());
    // About z, of the outline.
    let mut polar = 0.0;
    let (mut xx, mut yy) = (0.0, 0.0);
    for i in 0..4 {
        let ([ax, ay], [bx, by]) = (local[i], local[(i + 1) % 4]);
        let cross = ax * by - bx * ay;
        xx += cross * (ax * ax + ax * bx + bx * bx) / 12.0;
        yy += cross * (ay * ay + ay * by + by * by) / 12.0;
        polar = xx + yy;
    }
    let mass = 1000.0 * area;
    let along = mass / 12.0;
    let inertia = [1000.0 * yy + along, 1000.0 * xx + along, 1000.0 * polar];
    for k in 0..count {
        let angle = step * (f64::from(k) + 0.5) - 0.5 * PI;
        let (s, c) = libm::sincos(angle);
        let body = Body::dynamic(Form::Hull(0), [centre * s, centre * c, 0.0]);
        let rotation = turn([0.0, 0.0, 1.0], -angle);
        scene.bodies.push(surface(Body { rotation, mass: Some(Mass::new(mass, inertia)), ..body }));
    }
    scene
}

/// Whether no stone has gone far.
fn arch_stands(track: &Track) -> bool {
    track.farthest(track.last()) < 0.05
}

fn arch_thickness() -> Case {
    Case::threshold(
        'D',
        "d6_arch_thickness",
        "the thickness over radius at which an arch of 25 stones stands",
        3.0,
        Threshold {
            scene: Box::new(|t| arch(t, 0.8)),
            beyond: Box::new(arch_stands),
            exact: statics::least_thickness(25),
            range: [0.05, 0.25],
            halvings: 8,
        },
    )
    .most_rate(240.0)
}

fn arch_friction() -> Case {
    Case::threshold(
        'D',
        "d6_arch_friction",
        "the friction with which an arch of 25 stones and thickness 0.2 stands",
        3.0,
        Threshold {
            scene: Box::new(|mu| arch(0.2, mu)),
            beyond: Box::new(arch_stands),
            exact: statics::least_friction(25, 0.2),
            range: [0.1, 0.8],
            halvings: 8,
        },
    )
    .most_rate(240.0)
}

/// The contact problem of a scene at rest, alone: one step without what steps before it have left. Its answer is that
/// nothing moves; unsolved, all fall by g times the step.
fn one_step(name: &'static str, about: &'static str, scene: Scene) -> Case {
    let scene = Scene { name, about, ..scene };
    let judge = |_: &Scene, track: &Track| {
        let fall = G * track.end();
        let speed = track.last().iter().map(|m| norm(m.velocity)).fold(0.0, f64::max);
        super::verdict(speed / fall).and("moved", track.farthest(track.last()) / (fall * track.end()))
    };
    Case::run('D', Reference::ClosedForm, scene, 1e-3, Box::new(judge))
        .primary("greatest speed after one step")
        .scale(1.0, "g times the step")
        .most_rate(960.0)
}

fn small_pyramid() -> Scene {
    let mut scene = tower("", "", &[]);
    for row in 0..3 {
        for k in 0..3 - row {
            let at = [1.1 * (f64::from(k) + 0.5 * f64::from(row)), 0.5 + f64::from(row), 0.0];
            scene.bodies.push(Body::dynamic(Form::Box([0.5; 3]), at));
        }
    }
    scene
}

fn kapla() -> Case {
    let mut scene = scene("d7_kapla", "a tower of 60 plates, three crossed on three");
    scene.floor([10.0, 1.0, 10.0]);
    for layer in 0..20 {
        let across = layer % 2 == 1;
        for k in -1..=1 {
            let d = 0.15 * f64::from(k);
            let (half, at) =
                if across { ([0.2, 0.02, 0.05], [0.0, d]) } else { ([0.05, 0.02, 0.2], [d, 0.0]) };
            let y = 0.02 + 0.04 * f64::from(layer);
            let density = 10.0 / (8.0 * half[0] * half[1] * half[2]);
            scene.bodies.push(Body { density, ..Body::dynamic(Form::Box(half), [at[0], y, at[1]]) });
        }
    }
    let judge =
        |_: &Scene, track: &Track| super::verdict(track.farthest(track.last())).and("drift_m", drift(track));
    Case::run('D', Reference::ClosedForm, scene, 10.0, Box::new(judge))
        .primary("greatest distance of a plate from its place, at the end")
        .scale(0.8, "m, the height")
        .most_rate(240.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engines::merev::{Merev, double};

    #[test]
    fn an_arch_and_a_house_of_cards_begin_without_overlap() {
        let overlap =
            |scene: &Scene| double(Merev::measure(scene, &Motion::start(scene)).unwrap().worst_penetration);
        assert!(overlap(&arch(0.2, 0.6)) < 1e-5, "{}", overlap(&arch(0.2, 0.6)));
        if let crate::case::Trial::Run(scene, _) = card_house("", "", 4, 0.8).trial {
            assert!(overlap(&scene) < 1e-4, "{}", overlap(&scene));
        }
    }
}
