//! Surfaces: static and sliding friction, rolling resistance, conveyors, mixing, pre-solve, custom filters; and what
//! becomes of bodies whose state stops being finite.

#[path = "common/scenes.rs"]
mod scenes;

use merev::math::{Vec3, quat_about, scalar, vec3};
use merev::world::{BodyDef, ShapeDef, SurfaceMaterial};
use merev::{Float, Shape};
use scenes::{Scene, cube, orientations, sleepless};
use std::sync::Arc;

fn surface(material: SurfaceMaterial) -> ShapeDef {
    ShapeDef { material, ..ShapeDef::default() }
}

/// How far a block slides in `seconds` on a slope of this steepness.
fn slide(material: SurfaceMaterial, steepness: Float, speed: Float, seconds: usize) -> Float {
    let angle = scalar::atan2(steepness, 1.0);
    let mut scene = Scene::new(&sleepless(), quat_about(Vec3::z(), 0.0));
    let tilt = quat_about(Vec3::z(), -angle);
    let mut floor = BodyDef::fixed(tilt * vec3(0.0, -0.5, 0.0));
    floor.rotation = tilt;
    scene.add(&floor, &surface(material), Shape::new_box(200.0, 1.0, 200.0));
    let mut block = BodyDef::dynamic(tilt * vec3(0.0, 0.25, 0.0));
    block.rotation = tilt;
    block.linear_velocity = tilt * vec3(speed, 0.0, 0.0);
    let block = scene.add(&block, &surface(material), Shape::new_box(1.0, 0.5, 1.0));
    let start = scene.position(block);
    scene.steps(60 * seconds);
    (scene.position(block) - start).dot(&(tilt * Vec3::x()))
}

#[test]
fn static_friction_holds_what_sliding_friction_would_not() {
    let material = SurfaceMaterial { friction: 0.3, static_friction: 0.6, ..SurfaceMaterial::default() };
    // At rest on a slope between the two coefficients it stays; given a push it slides on, faster and faster.
    assert!(slide(material, 0.5, 0.0, 3).abs() < 1e-3);
    let moved = slide(material, 0.5, 1.0, 2);
    let angle = scalar::atan2(0.5, 1.0);
    let exact = 1.0 * 2.0 + 0.5 * 10.0 * (scalar::sin(angle) - 0.3 * scalar::cos(angle)) * 4.0;
    assert!((moved / exact - 1.0).abs() < 0.01, "slid {moved} m, by Coulomb {exact} m");
}

#[test]
fn a_conveyor_carries_a_box_at_its_speed() {
    for turn in orientations() {
        let mut scene = Scene::new(&sleepless(), turn);
        let belt = SurfaceMaterial { tangent_velocity: vec3(1.5, 0.0, 0.0), ..SurfaceMaterial::default() };
        scene.floor(&surface(belt));
        let load = scene.add(&BodyDef::dynamic(vec3(0.0, 0.5, 0.0)), &ShapeDef::default(), cube());
        scene.steps(120);
        let v = scene.velocity(load);
        assert!((v - vec3(1.5, 0.0, 0.0)).amax() < 1e-3, "the box moves at {v:?}");
    }
}

#[test]
fn rolling_resistance_stops_a_ball_in_time() {
    // Torque ρ r N about the contact point: a = (5/7) ρ g.
    let material = SurfaceMaterial { rolling_resistance: 0.05, friction: 1.0, ..SurfaceMaterial::default() };
    let mut scene = Scene::new(&sleepless(), orientations()[1]);
    scene.floor(&ShapeDef {
        material: SurfaceMaterial { friction: 1.0, ..Default::default() },
        ..Default::default()
    });
    let mut ball = BodyDef::dynamic(vec3(0.0, 0.5, 0.0));
    ball.linear_velocity = vec3(2.0, 0.0, 0.0);
    ball.angular_velocity = vec3(0.0, 0.0, -4.0);
    let ball = scene.add(&ball, &surface(material), Shape::new_sphere(1.0));
    let decay = 5.0 / 7.0 * 0.05 * 10.0;
    scene.steps(120);
    let v = scene.velocity(ball).x;
    assert!((v - (2.0 - decay * 2.0)).abs() < 0.02, "after 2 s it rolls at {v} m/s");
    scene.steps(300);
    assert!(scene.velocity(ball).amax() < 1e-3);
}

#[test]
fn mixing_callbacks_decide_at_once() {
    let slope = |friction: Float| {
        let mut scene = Scene::new(&sleepless(), quat_about(Vec3::z(), 0.0));
        scene.world.set_friction_mixing(Some(Arc::new(move |_, _, a, _, b| {
            assert_eq!((a.min(b), a.max(b)), (3, 4));
            friction
        })));
        let mut material = SurfaceMaterial { user_material_id: 3, ..SurfaceMaterial::default() };
        scene.floor(&surface(material));
        material.user_material_id = 4;
        let mut block = BodyDef::dynamic(vec3(0.0, 0.5, 0.0));
        block.linear_velocity = vec3(1.0, 0.0, 0.0);
        let block = scene.add(&block, &surface(material), cube());
        scene.steps(60);
        scene.position(block).x
    };
    assert!((slope(0.0) - 1.0).abs() < 1e-3, "without friction it slides 1 m");
    assert!((slope(0.5) - 0.1).abs() < 2e-3, "with μ 0.5 it stops after v²/(2μg) = 0.1 m");
    assert!(slope(Float::NAN) > 0.999, "an answer that is no number counts as 0");
}

#[test]
fn pre_solve_and_custom_filters_let_bodies_pass() {
    let drop = |set_up: &dyn Fn(&mut Scene), def: ShapeDef| {
        let mut scene = Scene::new(&sleepless(), orientations()[0]);
        set_up(&mut scene);
        scene.floor(&def);
        let block = scene.add(&BodyDef::dynamic(vec3(0.0, 0.6, 0.0)), &ShapeDef::default(), cube());
        scene.steps(60);
        scene.position(block).y
    };
    let pre = ShapeDef { enable_pre_solve_events: true, ..ShapeDef::default() };
    let custom = ShapeDef { enable_custom_filtering: true, ..ShapeDef::default() };
    let refuse_pre = |s: &mut Scene| s.world.set_pre_solve(Some(Arc::new(|_, _, _, _, _| false)));
    let refuse_pair = |s: &mut Scene| s.world.set_custom_filter(Some(Arc::new(|_, _, _| false)));
    assert!(drop(&|_| (), ShapeDef::default()) > 0.49);
    assert!(drop(&refuse_pre, pre) < -3.0 && drop(&refuse_pre, ShapeDef::default()) > 0.49);
    assert!(drop(&refuse_pair, custom) < -3.0 && drop(&refuse_pair, ShapeDef::default()) > 0.49);
}

#[test]
fn a_body_that_leaves_the_numbers_is_put_back_disabled_and_counted() {
    let mut scene = Scene::new(&sleepless(), orientations()[0]);
    scene.floor(&ShapeDef::default());
    let bystander = scene.add(&BodyDef::dynamic(vec3(5.0, 0.5, 0.0)), &ShapeDef::default(), cube());
    let body = scene.add(&BodyDef::dynamic(vec3(0.0, 3.0, 0.0)), &ShapeDef::default(), cube());
    scene.steps(5);
    let last = scene.position(body);
    scene.world.body_mut(body).unwrap().apply_force_to_center(vec3(Float::MAX, 0.0, 0.0), true).unwrap();
    scene.world.body_mut(body).unwrap().apply_force_to_center(vec3(Float::MAX, 0.0, 0.0), true).unwrap();
    scene.steps(1);
    let view = scene.world.body(body).unwrap();
    assert!(view.is_quarantined() && !view.is_enabled() && view.linear_velocity() == Vec3::zeros());
    assert_eq!(scene.position(body), last);
    assert_eq!(scene.world.step_report().quarantined, 1);
    scene.world.body_mut(body).unwrap().enable();
    scene.steps(120);
    assert!(!scene.world.body(body).unwrap().is_quarantined());
    assert!((scene.position(body).y - 0.5).abs() < 1e-3 && (scene.position(bystander).y - 0.5).abs() < 1e-3);
}
