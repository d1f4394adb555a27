//! H4, J4 and J6: the same scene told otherwise, and what must not make a difference.

use super::{Random, scene};
use crate::case::{Case, TURN, Track, turn_back};
use crate::engines::Motion;
use crate::scene::{Body, Form, Scene};
use crate::vector::{V3, add, norm, scale, sub, unit};

pub fn cases() -> Vec<Case> {
    vec![
        told_otherwise("h4_mirrored", "a heap, and the same seen in a mirror", heap().mirrored(), |m| {
            Motion { position: mirror(m.position), ..m }
        }),
        told_otherwise("h4_turned", "a heap, and the same turned as a whole", heap().turned(TURN), |m| {
            turn_back(&m)
        }),
        told_otherwise("h4_shifted", "a heap, and the same elsewhere", heap().shifted(SHIFT), |m| Motion {
            position: sub(m.position, SHIFT),
            ..m
        }),
        other_order(),
        consistent(),
        far_island("j6_far_island", "a heap, and the same with another heap made after it, far away", false),
        far_island("j6_far_island_first", "a heap, and the same with another heap made before it", true),
    ]
}

const SHIFT: V3 = [7.3, 0.0, -4.9];

fn mirror([x, y, z]: V3) -> V3 {
    [-x, y, z]
}

/// Five boxes that fall onto a floor and each other.
fn heap() -> Scene {
    let mut scene = scene("heap", "");
    scene.floor([30.0, 1.0, 30.0]);
    let mut random = Random::new(44);
    for k in 0..5 {
        let mut three = || [random.half(), random.half(), random.half()];
        let (half, at, velocity, spin, q) = (three(), three(), three(), three(), three());
        let place = [f64::from(k % 2) - 0.5, 0.5 + 0.4 * f64::from(k), f64::from(k / 2 % 2) - 0.5];
        scene.bodies.push(Body {
            velocity,
            spin,
            rotation: unit([q[0], q[1], q[2], 1.0]),
            ..Body::dynamic(Form::Box(half.map(|h| 0.3 + 0.15 * h)), add(place, scale(at, 0.3)))
        });
    }
    scene
}

impl Scene {
    /// Seen in a mirror across x; its boxes are their own images.
    fn mirrored(&self) -> Scene {
        let mut scene = self.clone();
        for body in &mut scene.bodies {
            let ([x, y, z, w], [a, b, c]) = (body.rotation, body.spin);
            body.position = mirror(body.position);
            body.velocity = mirror(body.velocity);
            (body.rotation, body.spin) = ([x, -y, -z, w], [a, -b, -c]);
        }
        scene
    }

    fn shifted(&self, by: V3) -> Scene {
        let mut scene = self.clone();
        for body in &mut scene.bodies {
            body.position = add(body.position, by);
        }
        scene
    }
}

/// The greatest distance between the places of bodies at the end.
fn apart(a: &[Motion], b: &[Motion]) -> f64 {
    a.iter().zip(b).map(|(a, b)| norm(sub(a.position, b.position))).fold(0.0, f64::max)
}

fn compared(scenes: Vec<(Scene, Option<f64>)>, group: char, judge: crate::case::JudgeOfAll) -> Case {
    Case::together(group, scenes, 1.0, judge)
        .primary("greatest distance of a box from its place in the other run, after 1 s")
        .scale(0.6, "m, a box's side")
        .most_rate(240.0)
}

/// The heap, and the other way to tell it, whose motions are told back.
fn told_otherwise(name: &'static str, about: &'static str, other: Scene, back: fn(Motion) -> Motion) -> Case {
    let plain = Scene { name, about, ..heap() };
    let judge = move |tracks: &[Track]| {
        let there: Vec<Motion> = tracks[1].last().iter().map(|&m| back(m)).collect();
        super::verdict(apart(tracks[0].last(), &there))
    };
    compared(vec![(plain, None), (other, None)], 'H', Box::new(judge))
}

fn other_order() -> Case {
    let plain =
        Scene { name: "h4_other_order", about: "a heap, and the same made in another order", ..heap() };
    let mut other = heap();
    other.bodies.reverse();
    let judge = |tracks: &[Track]| {
        let there: Vec<Motion> = tracks[1].last().iter().rev().copied().collect();
        super::verdict(apart(tracks[0].last(), &there))
    };
    compared(vec![(plain, None), (other, None)], 'H', Box::new(judge))
}

/// Against the same engine's own finest steps: a method may be wrong and yet agree with itself.
fn consistent() -> Case {
    let about = "a box falls and slides, against the same engine at 3840 steps a second";
    let mut scene = scene("j4_consistency", about);
    scene.floor([30.0, 1.0, 30.0]);
    scene.bodies.push(Body {
        velocity: [2.0, -1.0, 0.5],
        spin: [0.5, 1.0, -1.5],
        rotation: unit([0.1, 0.05, 0.2, 1.0]),
        ..Body::dynamic(Form::Box([0.5, 0.3, 0.4]), [0.0, 0.8, 0.0])
    });
    let judge = |tracks: &[Track]| {
        let way = norm(sub(tracks[1].last()[0].position, tracks[1].first()[0].position));
        super::verdict(apart(tracks[0].last(), tracks[1].last())).and("way_m", way)
    };
    let fine = scene.clone();
    Case::together('J', vec![(scene, None), (fine, Some(3840.0))], 0.5, Box::new(judge))
        .primary("distance from the place of the finest steps, after 0.5 s")
        .scale(1.0, "m, its length")
        .most_rate(1920.0)
}

/// What is far away is nothing to a heap: the same to the last bit.
fn far_island(name: &'static str, about: &'static str, is_first: bool) -> Case {
    let plain = Scene { name, about, ..heap() };
    let mut other = heap();
    let floor = other.bodies.remove(0);
    let far = heap().shifted([1000.0, 0.0, 1000.0]).bodies;
    let near = other.bodies.clone();
    let order = if is_first { [far, vec![floor], near] } else { [vec![floor], near, far] };
    other.bodies = order.into_iter().flatten().collect();
    let judge = move |tracks: &[Track]| {
        let count = tracks[0].last().len();
        let from = if is_first { tracks[1].last().len() - count } else { 0 };
        let there = &tracks[1].last()[from..from + count];
        let differ = tracks[0].last().iter().zip(there).filter(|(a, b)| a != b).count();
        let off = apart(tracks[0].last(), there);
        super::verdict(off).and("bodies_that_differ", differ as f64)
    };
    compared(vec![(plain, None), (other, None)], 'J', Box::new(judge)).defaults_only()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::rotate;

    /// A mirrored body shows its mirrored corners.
    #[test]
    fn a_mirror_shows_what_is_before_it() {
        let (a, b) = (heap(), heap().mirrored());
        for (a, b) in a.bodies.iter().zip(&b.bodies).skip(1) {
            let corner = |body: &Body, local: V3| add(body.position, rotate(body.rotation, local));
            let off = norm(sub(mirror(corner(a, [0.1, 0.2, 0.3])), corner(b, [-0.1, 0.2, 0.3])));
            assert!(off < 1e-14, "{off}");
        }
        assert_eq!(heap().mirrored().mirrored(), heap());
    }
}
