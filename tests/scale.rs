//! No pair is ever dropped, and a touching pair is cheap.

use merev::math::vec3;
use merev::world::{BodyDef, ShapeDef, WorldDef};
use merev::{Float, Shape, World};

#[test]
fn four_hundred_posts_under_one_plate_give_400_contacts() {
    let mut world = World::try_new(&WorldDef { enable_sleep: false, ..WorldDef::default() }).unwrap();
    for i in 0..400 {
        let at = vec3((i % 20) as Float - 9.5, 0.5, (i / 20) as Float - 9.5);
        let post = Shape::new_box(0.3, 1.0, 0.3);
        world.create_body_with_shape(&BodyDef::fixed(at), &ShapeDef::default(), post).unwrap();
    }
    let plate = BodyDef::dynamic(vec3(0.0, 1.1, 0.0));
    let plate = world
        .create_body_with_shape(&plate, &ShapeDef::default(), Shape::new_box(20.0, 0.2, 20.0))
        .unwrap()
        .0;
    for _ in 0..60 {
        world.try_step(1.0 / 60.0, 4).unwrap();
    }
    assert_eq!(world.counters().constraints, 400);
    assert_eq!(world.body(plate).unwrap().contacts().len(), 400);
    assert!(world.counters().overflow >= 400 - merev::island::color::COLORS);
    let height = world.body(plate).unwrap().transform().p.y;
    assert!((height - 1.1).abs() < 1e-3, "the plate lies at {height}");
}

#[test]
fn spheres_in_one_spot_give_all_their_pairs_under_a_kilobyte_each() {
    let mut world = World::try_new(&WorldDef { enable_sleep: false, ..WorldDef::default() }).unwrap();
    let n = 1500;
    for i in 0..n {
        // Not the same point for all: the pile has to know where to go.
        let at = vec3((i % 10) as Float, (i / 10 % 10) as Float, (i / 100) as Float) * 1e-3;
        world
            .create_body_with_shape(&BodyDef::dynamic(at), &ShapeDef::default(), Shape::new_sphere(1.0))
            .unwrap();
    }
    world.try_step(1.0 / 60.0, 1).unwrap();
    let pairs = n * (n - 1) / 2;
    let counters = world.counters();
    assert_eq!((counters.contacts, counters.constraints), (pairs, pairs));
    let each = if size_of::<Float>() == 4 { 1000 } else { 2000 };
    let bytes = counters.bytes / pairs;
    println!("{bytes} bytes a touching pair");
    assert!(bytes < each, "{bytes} bytes a touching pair");
}
