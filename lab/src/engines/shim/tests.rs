use crate::engines::{ALL, Engine, Maker, Motion, Setting};
use crate::scene::{Body, Form, Hold, Joint, Kind, Mass, Scene, Spring};
use crate::vector::{V3, angle_between, norm, rotate, sub, unit};

/// The engines behind shims that were built in.
fn makers() -> impl Iterator<Item = &'static Maker> {
    ALL.iter().filter(|m| ["ode", "mujoco", "bullet"].contains(&m.key))
}

fn world(maker: &Maker, scene: &Scene, setting: &Setting) -> Result<Box<dyn Engine>, String> {
    (maker.build)(scene, &(maker.methods)()[0], setting)
}

fn read(engine: &dyn Engine) -> Vec<Motion> {
    let mut motions = Vec::new();
    engine.motions(&mut motions);
    motions
}

fn near(a: V3, b: V3, bound: f64, what: &str) {
    assert!(norm(sub(a, b)) < bound, "{what}: {a:?} {b:?}");
}

fn empty() -> Scene {
    Scene { gravity: [0.0; 3], ..Scene::new("test", "", 1) }
}

/// A hull whose centre of mass is not at its origin, and whose axes are not its principal ones, is read back as it was
/// given, and without gravity goes straight on: its centre of mass does, while it turns.
#[test]
fn a_lopsided_hull_keeps_its_frame() {
    let mut scene = empty();
    scene.clouds.push(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.1, 0.7, 0.0], [0.3, 0.2, 0.5]]);
    let centre = [1.4 / 4.0, 0.9 / 4.0, 0.5 / 4.0];
    scene.bodies.push(Body {
        rotation: unit([0.3, -0.2, 0.5, 0.7]),
        velocity: [1.0, 2.0, -1.0],
        spin: [0.5, 1.0, -0.3],
        ..Body::dynamic(Form::Hull(0), [3.0, 1.0, 2.0])
    });
    let start = Motion::of(&scene.bodies[0]);
    let place = |m: &Motion| {
        let arm = rotate(unit(m.rotation), centre);
        [0, 1, 2].map(|k| m.position[k] + arm[k])
    };
    for maker in makers() {
        let mut engine = world(maker, &scene, &Setting::new(60.0, 4)).unwrap();
        let first = read(&*engine)[0];
        near(first.position, start.position, 1e-6, maker.name);
        near(first.velocity, start.velocity, 1e-6, maker.name);
        near(first.spin, start.spin, 1e-6, maker.name);
        assert!(angle_between(first.rotation, start.rotation) < 1e-6, "{}", maker.name);
        (0..60).for_each(|_| engine.step());
        let last = read(&*engine)[0];
        let there = place(&start);
        near(place(&last), [0, 1, 2].map(|k| there[k] + start.velocity[k]), 1e-4, maker.name);
        assert!(angle_between(last.rotation, start.rotation) > 0.5, "{}", maker.name);
    }
}

/// A force lasts for one step with all its sub-steps; off the centre it turns, too.
#[test]
fn a_push_lasts_for_one_step() {
    let mut scene = empty();
    let mass = Some(Mass { mass: 2.0, inertia: [0.5; 3] });
    scene.bodies.push(Body::fixed(Form::Sphere(0.1), [9.0, 0.0, 0.0]));
    scene.bodies.push(Body { mass, ..Body::dynamic(Form::Sphere(0.1), [0.0; 3]) });
    for maker in makers() {
        let mut engine = world(maker, &scene, &Setting::new(50.0, 4)).unwrap();
        engine.push(1, [0.0, 4.0, 0.0], [0.25, 0.0, 0.0]);
        for _ in 0..2 {
            engine.step();
            let m = read(&*engine)[0];
            near(m.velocity, [0.0, 0.04, 0.0], 1e-6, maker.name);
            near(m.spin, [0.0, 0.0, 0.04], 1e-6, maker.name);
        }
    }
}

/// Friction of a pair is √(ab): 0.9 on 0.4 brakes with 0.6 g.
#[test]
fn friction_is_mixed_as_the_scene_says() {
    let mut scene = Scene::new("test", "", 1);
    scene.floor_of([50.0, 1.0, 50.0], |b| Body { friction: 0.4, ..b });
    let sliding = Body::dynamic(Form::Box([0.5, 0.1, 0.5]), [0.0, 0.1, 0.0]);
    scene.bodies.push(Body { friction: 0.9, velocity: [3.0, 0.0, 0.0], ..sliding });
    for maker in makers() {
        let mut engine = world(maker, &scene, &Setting::new(240.0, 4)).unwrap();
        (0..240).for_each(|_| engine.step());
        let way = read(&*engine)[0].position[0];
        assert!((way / (9.0 / 12.0) - 1.0).abs() < 0.03, "{}: {way}", maker.name);
    }
}

/// A spring to 0 of a slider swings about 0 whichever side of the joint the moving body is on.
#[test]
fn a_slider_springs_back() {
    for swapped in [false, true] {
        let mut scene = empty();
        let mass = Some(Mass { mass: 1.0, inertia: [0.1; 3] });
        scene.bodies.push(Body { collides: false, ..Body::fixed(Form::Sphere(0.1), [0.0; 3]) });
        let at = [0.1, 0.0, 0.0];
        scene.bodies.push(Body { collides: false, mass, ..Body::dynamic(Form::Sphere(0.1), at) });
        let spring = Spring { hertz: 1.0, damping_ratio: 0.0, mass: 1.0 };
        let bodies = if swapped { [1, 0] } else { [0, 1] };
        scene.joints.push(Joint::new(Hold::Slider(Some(spring)), bodies, [[0.0; 3]; 2]));
        for maker in makers() {
            let mut engine = world(maker, &scene, &Setting::new(240.0, 4)).unwrap();
            (0..120).for_each(|_| engine.step());
            near(read(&*engine)[0].position, [-0.1, 0.0, 0.0], 5e-3, maker.name);
        }
    }
}

/// What no engine can do as the scene says, it refuses.
#[test]
fn what_cannot_be_done_is_refused() {
    let mut plain = empty();
    plain.bodies.push(Body::dynamic(Form::Sphere(0.1), [0.0; 3]));
    let mut bouncing = plain.clone();
    bouncing.bodies[0].restitution = 0.5;
    let mut moving = plain.clone();
    moving.bodies[0].kind = Kind::Kinematic;
    let mut rod = plain.clone();
    rod.bodies.push(Body::fixed(Form::Sphere(0.1), [1.0, 0.0, 0.0]));
    rod.joints.push(Joint::new(Hold::Rod(1.0), [0, 1], [[0.0; 3]; 2]));
    let setting = Setting::new(60.0, 4);
    for maker in makers() {
        let takes = |scene: &Scene| world(maker, scene, &setting).is_ok();
        assert!(takes(&plain), "{}", maker.name);
        assert_eq!(takes(&bouncing), maker.key != "mujoco", "{}", maker.name);
        assert_eq!(takes(&moving), maker.key != "mujoco", "{}", maker.name);
        assert_eq!(takes(&rod), maker.key != "bullet", "{}", maker.name);
        let knob = Setting { accuracy: Some(1e-3), ..setting };
        assert!(world(maker, &plain, &knob).is_err(), "{}", maker.name);
    }
}

/// A number that is not finite ends the run, not the program.
#[test]
fn a_broken_world_says_so() {
    let mut scene = empty();
    scene.bodies.push(Body::fixed(Form::Sphere(0.1), [9.0, 0.0, 0.0]));
    scene.bodies.push(Body::dynamic(Form::Sphere(0.1), [0.0; 3]));
    for maker in makers() {
        let mut engine = world(maker, &scene, &Setting::new(60.0, 4)).unwrap();
        engine.push(1, [f64::NAN, 0.0, 0.0], [0.1, 0.0, 0.0]);
        (0..3).for_each(|_| engine.step());
        let m = read(&*engine)[0];
        let finite = m.position.iter().chain(&m.velocity).chain(&m.spin).all(|x| x.is_finite());
        assert!(engine.is_broken() || !finite, "{}", maker.name);
    }
}
