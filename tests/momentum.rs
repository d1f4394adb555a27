//! An isolated pile keeps its momentum and angular momentum (accuracy.md I4).

mod common;

use common::Random;
use merev::math::{Vec3, length, scalar::double, vec3};
use merev::world::{BodyDef, ShapeDef, WorldDef};
use merev::{Float, Shape, World};

/// Σ p, Σ (L + x × p), Σ |p| and Σ |L + x × p|, in double precision.
fn totals(world: &World) -> ([f64; 3], [f64; 3], f64, f64) {
    let wide = |v: Vec3| [double(v.x), double(v.y), double(v.z)];
    let norm = |a: [f64; 3]| a.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (mut p, mut l, mut sum_p, mut sum_l) = ([0.0; 3], [0.0; 3], 0.0, 0.0);
    for id in world.bodies() {
        let body = world.body(id).unwrap();
        let (x, pb, lb) = (wide(body.world_center()), wide(body.momentum()), wide(body.angular_momentum()));
        let mut own = lb;
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            own[i] += x[j] * pb[k] - x[k] * pb[j];
            p[i] += pb[i];
        }
        for i in 0..3 {
            l[i] += own[i];
        }
        sum_p += norm(pb);
        sum_l += norm(own);
    }
    (p, l, sum_p, sum_l)
}

fn pile(shapes: impl Fn(&mut Random) -> Shape, inward: Float, seconds: usize) -> (f64, f64) {
    let def = WorldDef { gravity: Vec3::zeros(), enable_sleep: false, ..WorldDef::default() };
    let mut world = World::try_new(&def).unwrap();
    let mut random = Random(11);
    for i in 0..100 {
        let cell = vec3((i % 5) as Float - 2.0, (i / 5 % 5) as Float - 2.0, (i / 25) as Float - 1.5) * 2.2;
        let mut body = BodyDef::dynamic(cell);
        body.rotation = random.rotation();
        body.linear_velocity = random.vec(1.0) - cell * inward;
        body.angular_velocity = random.vec(2.0);
        let mut surface = ShapeDef { density: 1.0, ..ShapeDef::default() };
        surface.material.restitution = random.within(0.0, 0.8);
        world.create_body_with_shape(&body, &surface, shapes(&mut random)).unwrap();
    }
    let (p0, l0, sum_p, sum_l) = totals(&world);
    let mut touched = 0;
    for _ in 0..seconds * 60 {
        world.try_step(1.0 / 60.0, 4).unwrap();
        touched += world.contact_begin_events().len();
    }
    assert!(touched > 50, "only {touched} contacts began: no pile");
    let (p, l, ..) = totals(&world);
    let off = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt();
    assert!(world.bodies().all(|b| length(world.body(b).unwrap().world_center()) < 1e4));
    (off(p, p0) / sum_p, off(l, l0) / sum_l)
}

#[test]
fn a_pile_of_mixed_bodies_keeps_p_and_l_for_60_s() {
    for (name, inward) in [("meeting", 0.5), ("meeting fast", 1.5), ("imploding", 4.0)] {
        let (dp, dl) = pile(Random::shape, inward, 60);
        println!("{name}: dP/Σ|p| {dp:e}, dL/Σ|l| {dl:e}");
        assert!(dp < 1e-6, "{name}: momentum is off by {dp:e} of Σ|p|");
        assert!(dl < 1e-5, "{name}: angular momentum is off by {dl:e} of Σ|l|");
    }
}

#[test]
fn a_pile_of_hulls_keeps_p_and_l_for_60_s() {
    let hull = |random: &mut Random| {
        let points: Vec<Vec3> = (0..6 + random.below(20)).map(|_| random.vec(0.7)).collect();
        Shape::hull(&points).unwrap()
    };
    let (dp, dl) = pile(hull, 0.5, 60);
    println!("hulls: dP/Σ|p| {dp:e}, dL/Σ|l| {dl:e}");
    assert!(dp < 1e-6, "momentum is off by {dp:e} of Σ|p|");
    assert!(dl < 1e-5, "angular momentum is off by {dl:e} of Σ|l|");
}
