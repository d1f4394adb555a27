//! The seed's interface: every call, every panic with its sentence, and the sample program against physics.

use merev::math::{length, quat_about, rotate, rotation_matrix, vec3};
use merev::solver::SolverKind;
use merev::world::{BodyDef, BodyType, WorldDef};
use merev::{
    AABB, BodyId, ErrorCode, Float, Mat3, Quat, RigidBodyId, RigidbodyBuilder, Shape, StaticBodyId,
    StaticbodyBuilder, Vec3, World, WorldBuilder, WorldConfig,
};

#[path = "../examples/bouncing_ball.rs"]
#[allow(dead_code, reason = "only `main` uses what is printed")]
mod bouncing_ball;

const PI: Float = std::f64::consts::PI as Float;

fn close(a: Float, b: Float) -> bool {
    (a - b).abs() <= 2e-5 * (1.0 + a.abs().max(b.abs()))
}

fn near(a: Vec3, b: Vec3) -> bool {
    (a - b).amax() <= 2e-5 * (1.0 + a.amax().max(b.amax()))
}

// ---- the sample program -----------------------------------------------------------------------------------------

#[test]
fn the_sample_program_hits_the_floor_when_and_as_fast_as_physics_says() {
    let hits = bouncing_ball::run(12.0);
    assert!(hits.len() >= 10);
    for (k, hit) in hits.iter().take(10).enumerate() {
        let exact = bouncing_ball::exact(k, hit.time);
        let late = hit.time - exact.time;
        assert!((-1e-3..=0.0101).contains(&late), "hit {k} comes {late} s late");
        let error = (hit.momentum / exact.momentum - 1.0).abs();
        assert!(error < 2e-3, "hit {k}: {} instead of {}", hit.momentum, exact.momentum);
    }
}

// ---- configuration ----------------------------------------------------------------------------------------------

#[test]
fn defaults_are_those_of_the_document() {
    let config = WorldConfig::default();
    assert_eq!(config.gravity, vec3(0.0, -10.0, 0.0));
    assert_eq!((config.friction, config.bounciness, config.solver_steps), (0.6, 0.0, 4));
    assert_eq!((config.rb_separation_force, config.sb_separation_force), (1.0, 1.0));
    let mut world = World::new(config);
    let ball = world.add_rigidbody(Shape::new_sphere(1.0)).finish();
    assert!(close(world.get(ball).unwrap().mass(), PI / 6.0), "density 1");
    world.update(0.5);
    assert!(close(world.get(ball).unwrap().position().y, -1.25));
}

#[test]
fn a_builder_sets_the_broad_phase() {
    use merev::broad_phase::BroadPhaseKind;
    let run = |kind| {
        let mut world = WorldBuilder::new().broad_phase(kind).build();
        world.add_staticbody(Shape::new_box(10.0, 1.0, 10.0)).pos(0.0, -1.0, 0.0).finish();
        let ball = world.add_rigidbody(Shape::new_sphere(1.0)).finish();
        (0..50).for_each(|_| world.update(0.01));
        (world.step_report().counters.tree_height, *world.get(ball).unwrap().position())
    };
    let (none, plain) = run(BroadPhaseKind::BruteForce);
    let (one, tree) = run(BroadPhaseKind::Omt);
    assert_eq!((none, one, plain), (0, 1, tree));
}

/// How fast a ball falls after a second.
fn gravity_of(builder: WorldBuilder) -> Vec3 {
    let mut world = builder.build();
    let ball = world.add_rigidbody(Shape::new_sphere(1.0)).mass(2.0).finish();
    world.update(1.0);
    world.get(ball).unwrap().momentum() / 2.0
}

#[test]
fn a_builder_sets_gravity() {
    assert!(near(gravity_of(WorldBuilder::new()), vec3(0.0, -10.0, 0.0)));
    assert_eq!(gravity_of(WorldBuilder::new().no_gravity()), Vec3::zeros());
    assert!(near(gravity_of(WorldBuilder::new().down_gravity(3.0)), vec3(0.0, -3.0, 0.0)));
    let g = vec3(1.0, 2.0, -4.0);
    assert!(near(gravity_of(WorldBuilder::new().gravity(g)), g));
    assert!(near(gravity_of(WorldBuilder::new().try_gravity(g).unwrap()), g));
    assert!(near(gravity_of(WorldBuilder::new().try_down_gravity(-2.0).unwrap()), vec3(0.0, 2.0, 0.0)));
}

/// The speed at which a ball leaves the floor that it hits at 10 m/s.
fn rebound(builder: WorldBuilder) -> Float {
    let mut world = builder.build();
    world.add_staticbody(Shape::new_box(10.0, 1.0, 10.0)).pos(0.0, -0.5, 0.0).finish();
    let ball = world.add_rigidbody(Shape::new_sphere(1.0)).mass(1.0).pos(0.0, 5.5, 0.0).finish();
    for _ in 0..101 {
        world.update(0.01);
    }
    world.get(ball).unwrap().momentum().y
}

#[test]
fn a_builder_sets_bounciness() {
    assert!(rebound(WorldBuilder::new()).abs() < 0.01);
    assert!(rebound(WorldBuilder::new().bounciness(0.7).no_bounce()).abs() < 0.01);
    assert!((rebound(WorldBuilder::new().max_bounce()) - 9.9).abs() < 0.02);
    assert!((rebound(WorldBuilder::new().bounciness(0.5)) - 4.9).abs() < 0.02);
    assert!((rebound(WorldBuilder::new().try_bounciness(0.5).unwrap()) - 4.9).abs() < 0.02);
}

/// How far a box that is pushed off at 2 m/s slides.
fn slide(builder: WorldBuilder) -> Float {
    let mut world = builder.build();
    world.add_staticbody(Shape::new_box(50.0, 1.0, 50.0)).pos(0.0, -0.5, 0.0).finish();
    let id = world.add_rigidbody(Shape::new_box(1.0, 0.2, 1.0)).mass(1.0).pos(0.0, 0.1, 0.0).finish();
    world.body_mut(id.into()).unwrap().set_linear_velocity(vec3(2.0, 0.0, 0.0)).unwrap();
    for _ in 0..100 {
        world.update(0.01);
    }
    world.get(id).unwrap().position().x
}

#[test]
fn a_builder_sets_friction() {
    // v² / 2 μ g
    assert!((slide(WorldBuilder::new().friction(0.4)) - 0.5).abs() < 0.02);
    assert!((slide(WorldBuilder::new().try_friction(0.8).unwrap()) - 0.25).abs() < 0.02);
    assert!((slide(WorldBuilder::new()) - 0.2 / 0.6).abs() < 0.02);
    assert!((slide(WorldBuilder::new().no_friction()) - 2.0).abs() < 0.01);
}

/// How fast a ball is pushed out that overlaps a static one, and two that overlap each other, by half a metre.
fn push_out(builder: &WorldBuilder) -> [Float; 2] {
    [true, false].map(|fixed| {
        let mut world = builder.clone().no_gravity().build();
        if fixed {
            world.add_staticbody(Shape::new_sphere(2.0)).finish();
        } else {
            world.add_rigidbody(Shape::new_sphere(2.0)).finish();
        }
        let ball = world.add_rigidbody(Shape::new_sphere(2.0)).pos(1.5, 0.0, 0.0).finish();
        world.update(0.01);
        (world.get(ball).unwrap().position().x - 1.5) / 0.01
    })
}

#[test]
fn separation_forces_scale_the_push_out_of_their_kind_of_contact() {
    let plain = WorldBuilder::new();
    let [fixed, free] = push_out(&plain);
    assert!(fixed > 0.5 && free > 0.25, "{fixed} {free}");
    let [a, b] = push_out(&plain.clone().sb_separation_force(0.5));
    assert!((a / fixed - 0.5).abs() < 0.05 && b == free, "{a} of {fixed}");
    let [a, b] = push_out(&plain.clone().try_rb_separation_force(0.5).unwrap());
    assert!(a == fixed && (b / free - 0.5).abs() < 0.05, "{b} of {free}");
    let none = plain.rb_separation_force(0.0).try_sb_separation_force(0.0).unwrap();
    assert!(push_out(&none).iter().all(|v| v.abs() < 1e-6));
}

#[test]
fn solver_steps_are_sub_steps() {
    let mut world = WorldBuilder::new().solver_steps(7).build();
    world.update(0.01);
    assert_eq!(world.step_report().sub_steps, 7);
    let mut world = WorldBuilder::new().try_solver_steps(1).unwrap().try_build().unwrap();
    world.try_update(0.01).unwrap();
    assert_eq!(world.step_report().sub_steps, 1);
}

#[test]
fn solver_steps_are_the_iterations_of_a_solver_that_iterates() {
    let mut world = WorldBuilder::new().solver(SolverKind::SequentialImpulse).solver_steps(7).build();
    world.update(0.01);
    let report = world.step_report();
    assert_eq!((report.sub_steps, report.solve.solver), (1, SolverKind::SequentialImpulse));
    let builder = WorldBuilder::new().solver(SolverKind::ProjectedGaussSeidel).solver_iterations(3);
    let mut world = builder.friction_facets(4).shuffle_contacts(false).over_correct(true).build();
    world.update(0.01);
    assert_eq!(world.step_report().sub_steps, 4);
}

fn refused<T>(result: merev::Result<T>, code: ErrorCode, sentence: &str) {
    let Err(error) = result else { panic!("{sentence}: should be refused") };
    assert_eq!((error.code(), error.sentence()), (code, sentence));
}

#[test]
fn bad_settings_are_refused() {
    use ErrorCode::{NotFinite, Range};
    let new = WorldBuilder::new;
    refused(
        new().try_gravity(vec3(0.0, Float::NAN, 0.0)),
        NotFinite,
        "gravity is (0, NaN, 0); it must be finite.",
    );
    refused(new().try_down_gravity(Float::INFINITY), NotFinite, "gravity is inf; it must be finite.");
    refused(new().try_solver_steps(0), Range, "solver_steps is 0; it must be 1 … 1000.");
    refused(new().try_solver_steps(1001), Range, "solver_steps is 1001; it must be 1 … 1000.");
    refused(
        new().try_solver_iterations(10_001),
        Range,
        "solver_iterations is 10001; it must lie between 0 and 10000.",
    );
    refused(new().try_friction_facets(2), Range, "friction_facets is 2; it must lie between 3 and 64.");
    refused(
        new().try_rb_separation_force(-1.0),
        Range,
        "rb_separation_force is -1; it must not be negative.",
    );
    refused(
        new().try_sb_separation_force(Float::NAN),
        NotFinite,
        "sb_separation_force is NaN; it must be finite.",
    );
    refused(new().try_bounciness(1.5), Range, "bounciness is 1.5; it must lie between 0 and 1.");
    refused(new().try_friction(-0.5), Range, "friction is -0.5; it must not be negative.");
    let config = WorldConfig { friction: -0.5, ..WorldConfig::default() };
    refused(World::try_new(config), Range, "friction is -0.5; it must not be negative.");
    refused(WorldBuilder::new().build().try_update(-1.0), Range, "time_step is -1; it must not be negative.");
}

/// A test for each plain call that panics with its error's sentence.
macro_rules! panics {
    ($($name:ident: $sentence:literal, $call:expr;)*) => {$(
        #[test]
        #[should_panic(expected = $sentence)]
        fn $name() {
            let _ = $call;
        }
    )*};
}

fn ball(world: &mut World) -> RigidbodyBuilder<'_> {
    world.add_rigidbody(Shape::new_sphere(1.0))
}

fn floor(world: &mut World) -> StaticbodyBuilder<'_> {
    world.add_staticbody(Shape::new_box(1.0, 1.0, 1.0))
}

fn world() -> World {
    WorldBuilder::new().build()
}

fn not_a_rotation() -> Quat {
    Quat::new_unchecked(merev::Quat::identity().into_inner() * 2.0)
}

const NAN: Vec3 = Vec3::new(0.0, Float::NAN, 0.0);

panics! {
    gravity_panics: "gravity is (0, NaN, 0); it must be finite.", WorldBuilder::new().gravity(NAN);
    down_gravity_panics: "gravity is NaN; it must be finite.", WorldBuilder::new().down_gravity(Float::NAN);
    solver_steps_panics: "solver_steps is 0; it must be 1 … 1000.", WorldBuilder::new().solver_steps(0);
    rb_separation_force_panics: "rb_separation_force is -2; it must not be negative.",
        WorldBuilder::new().rb_separation_force(-2.0);
    sb_separation_force_panics: "sb_separation_force is -2; it must not be negative.",
        WorldBuilder::new().sb_separation_force(-2.0);
    bounciness_panics: "bounciness is 2; it must lie between 0 and 1.", WorldBuilder::new().bounciness(2.0);
    friction_panics: "friction is -1; it must not be negative.", WorldBuilder::new().friction(-1.0);
    new_world_panics: "solver_steps is 0; it must be 1 … 1000.",
        World::new(WorldConfig { solver_steps: 0, ..WorldConfig::default() });
    update_panics: "time_step is NaN; it must be finite.", world().update(Float::NAN);
    mass_panics: "mass is 0; it must be greater than 0.", ball(&mut world()).mass(0.0).finish();
    position_panics: "position is (0, NaN, 0); it must be finite.", ball(&mut world()).position(NAN).finish();
    pos_panics: "position is (inf, 0, 0); it must be finite.",
        ball(&mut world()).pos(Float::INFINITY, 0.0, 0.0).finish();
    rotation_panics: "rotation is not a unit quaternion.",
        ball(&mut world()).rotation(not_a_rotation()).finish();
    finish_panics: "A half-space has no mass; its body must be static.",
        world().add_rigidbody(Shape::half_space(Vec3::y(), 0.0).unwrap()).finish();
    static_position_panics: "position is (0, NaN, 0); it must be finite.",
        floor(&mut world()).position(NAN).finish();
    static_pos_panics: "position lies more than", floor(&mut world()).pos(0.0, 1e10, 0.0).finish();
    static_rotation_panics: "rotation is not a unit quaternion.",
        floor(&mut world()).rotation(not_a_rotation()).finish();
    new_box_panics: "Half the box's height is -0.5; it must be greater than 0.", Shape::new_box(1.0, -1.0, 1.0);
    new_sphere_panics: "The sphere's radius is -0.5; it must be greater than 0.", Shape::new_sphere(-1.0);
    new_capsule_panics: "The capsule's", Shape::new_capsule(1.0, Float::NAN);
}

// ---- bodies -----------------------------------------------------------------------------------------------------

#[test]
fn a_builder_that_is_not_finished_creates_nothing() {
    let mut world = world();
    let _ = world.add_rigidbody(Shape::new_sphere(1.0)).mass(2.0).pos(1.0, 2.0, 3.0);
    let _ = world.add_staticbody(Shape::new_sphere(1.0)).pos(1.0, 2.0, 3.0);
    let _ = RigidbodyBuilder::new(&mut world, Shape::new_sphere(1.0));
    assert_eq!((world.body_count(), world.shape_count()), (0, 0));
}

#[test]
fn bad_bodies_are_refused_and_leave_nothing_behind() {
    use ErrorCode::{NotFinite, Range};
    let mut world = world();
    refused(ball(&mut world).try_mass(-1.0), Range, "mass is -1; it must be greater than 0.");
    refused(ball(&mut world).try_mass(Float::INFINITY), NotFinite, "mass is inf; it must be finite.");
    refused(ball(&mut world).try_position(NAN), NotFinite, "position is (0, NaN, 0); it must be finite.");
    let inf = Float::INFINITY;
    refused(
        ball(&mut world).try_pos(0.0, 0.0, inf),
        NotFinite,
        "position is (0, 0, inf); it must be finite.",
    );
    refused(ball(&mut world).try_rotation(not_a_rotation()), Range, "rotation is not a unit quaternion.");
    refused(floor(&mut world).try_position(NAN), NotFinite, "position is (0, NaN, 0); it must be finite.");
    refused(
        floor(&mut world).try_pos(inf, 0.0, 0.0),
        NotFinite,
        "position is (inf, 0, 0); it must be finite.",
    );
    refused(floor(&mut world).try_rotation(not_a_rotation()), Range, "rotation is not a unit quaternion.");
    let plane = Shape::half_space(Vec3::y(), 0.0).unwrap();
    refused(
        world.add_rigidbody(plane).try_finish(),
        Range,
        "A half-space has no mass; its body must be static.",
    );
    assert!(world.add_rigidbody(Shape::new_sphere(1.0)).mass(Float::MIN_POSITIVE).try_finish().is_err());
    assert_eq!((world.body_count(), world.shape_count()), (0, 0));
}

#[test]
fn a_rigid_body_tells_its_state() {
    let mut world = WorldBuilder::new().no_gravity().build();
    let q = quat_about(vec3(1.0, 2.0, 3.0), 0.7);
    let p = vec3(1.0, -2.0, 3.0);
    let id: RigidBodyId =
        world.add_rigidbody(Shape::new_box(1.0, 2.0, 3.0)).mass(6.0).position(p).rotation(q).finish();
    let body = world.get(id).unwrap();
    assert_eq!(body.id(), id);
    assert_eq!(body.shape(), &Shape::new_box(1.0, 2.0, 3.0));
    assert_eq!((body.mass(), *body.inv_mass()), (6.0, 1.0 / 6.0));
    assert!(near(*body.position(), p));
    assert!(body.rotation().angle_to(&q) < 1e-3);
    assert_eq!((*body.momentum(), *body.angular_momentum()), (Vec3::zeros(), Vec3::zeros()));
    // m/12 (h² + d², d² + w², w² + h²) = (6.5, 5, 2.5), turned.
    let r = rotation_matrix(&q);
    let expected: Mat3 = r * Mat3::from_diagonal(&vec3(1.0 / 6.5, 0.2, 0.4)) * r.transpose();
    assert!((body.inverse_inertia() - expected).amax() < 1e-5);

    let (v, w) = (vec3(1.0, 2.0, 3.0), vec3(-1.0, 0.5, 2.0));
    let mut change = world.body_mut(id.into()).unwrap();
    change.set_linear_velocity(v).unwrap();
    change.set_angular_velocity(w).unwrap();
    let body = world.get(id).unwrap();
    assert!(near(*body.momentum(), v * 6.0));
    assert!(near(body.inverse_inertia() * body.angular_momentum(), w));
    let point = p + vec3(0.3, -0.2, 0.5);
    assert!(near(body.local_velocity(point), v + w.cross(&(point - p))));
}

#[test]
fn impulse_effectiveness_is_what_an_impulse_does() {
    let mut world = WorldBuilder::new().no_gravity().build();
    let q = quat_about(vec3(0.0, 1.0, 3.0), 1.1);
    let id = world.add_rigidbody(Shape::new_box(1.0, 2.0, 3.0)).mass(2.0).rotation(q).finish();
    let (point, u) = (vec3(0.4, -0.3, 0.9), vec3(0.6, 0.0, -0.8));
    let expected = world.get(id).unwrap().impulse_effectiveness(point, u);
    world.body_mut(id.into()).unwrap().apply_linear_impulse(u * 3.0, point, true).unwrap();
    let gained = world.get(id).unwrap().local_velocity(point).dot(&u);
    assert!(close(gained, 3.0 * expected), "{gained}");
    let center = world.get(id).unwrap().impulse_effectiveness(Vec3::zeros(), u);
    assert!(close(center, 0.5));
}

#[test]
fn masses_and_inertias_are_those_of_solids() {
    let mut world = world();
    let ball = world.add_rigidbody(Shape::new_sphere(2.0)).mass(5.0).finish();
    let inverse = world.get(ball).unwrap().inverse_inertia()[(0, 0)];
    assert!(close(inverse, 1.0 / (0.4 * 5.0)), "2/5 m r²");
    let block = world.add_rigidbody(Shape::new_box(1.0, 2.0, 3.0)).finish();
    assert!(close(world.get(block).unwrap().mass(), 6.0), "full side lengths, density 1");
    let capsule = world.add_rigidbody(Shape::new_capsule(2.0, 1.0)).finish();
    assert!(close(world.get(capsule).unwrap().mass(), PI / 6.0 + PI / 2.0));
}

#[test]
fn a_static_body_tells_its_state() {
    let mut world = world();
    let q = quat_about(vec3(1.0, 2.0, 3.0), 0.7);
    let id: StaticBodyId =
        world.add_staticbody(Shape::new_sphere(1.0)).position(vec3(1.0, 2.0, 3.0)).rotation(q).finish();
    world.update(1.0);
    let body = world.get(id).unwrap();
    assert_eq!(body.id(), id);
    assert_eq!(body.shape(), &Shape::new_sphere(1.0));
    assert_eq!(*body.position(), vec3(1.0, 2.0, 3.0));
    assert!(near(rotate(body.rotation(), Vec3::x()), rotate(&q, Vec3::x())));
    let other = StaticbodyBuilder::new(&mut world, Shape::new_sphere(1.0)).pos(7.0, 8.0, 9.0).try_finish();
    assert_eq!(*world.get(other.unwrap()).unwrap().position(), vec3(7.0, 8.0, 9.0));
}

#[test]
fn bodies_are_listed_by_kind_and_found_until_they_are_gone() {
    let mut world = world();
    let a = floor(&mut world).finish();
    let b = ball(&mut world).pos(3.0, 0.0, 0.0).finish();
    let c = ball(&mut world).pos(6.0, 0.0, 0.0).finish();
    // Bodies of the other interface are listed, too, if they have a shape.
    world.create_body(&BodyDef::dynamic(Vec3::zeros())).unwrap();
    assert_eq!(world.staticbodies().map(|s| s.id()).collect::<Vec<_>>(), [a]);
    assert_eq!(world.rigidbodies().map(|r| r.id()).collect::<Vec<_>>(), [b, c]);
    assert_eq!(world.rigidbodies().map(|r| r.position().x).collect::<Vec<_>>(), [3.0, 6.0]);

    world.destroy_body(BodyId::from(b)).unwrap();
    assert!(world.get(b).is_none() && world.get(c).is_some());
    refused(world.try_get(b), ErrorCode::Stale, "The body was destroyed.");
    world.body_mut(c.into()).unwrap().set_type(BodyType::Static).unwrap();
    assert!(world.get(c).is_none());
    refused(world.try_get(c), ErrorCode::Stale, "The body is no longer a dynamic one with a shape.");
    assert_eq!((world.rigidbodies().count(), world.staticbodies().count()), (0, 2));
    world.destroy_body(a.into()).unwrap();
    assert!(world.get(a).is_none());
}

#[test]
fn contacts_carry_the_impulses_that_changed_the_momentum() {
    let mut world = WorldBuilder::new().friction(0.5).build();
    world.add_staticbody(Shape::new_box(20.0, 1.0, 20.0)).pos(0.0, -0.5, 0.0).finish();
    let id = world.add_rigidbody(Shape::new_box(1.0, 1.0, 1.0)).mass(2.0).pos(0.0, 0.5, 0.0).finish();
    world.body_mut(id.into()).unwrap().set_linear_velocity(vec3(3.0, 0.0, 1.0)).unwrap();
    for _ in 0..300 {
        let before = *world.get(id).unwrap().momentum();
        world.update(0.01);
        let gained = world.get(id).unwrap().momentum() - before;
        let mut sum = vec3(0.0, -10.0 * 2.0 * 0.01, 0.0);
        for (point, normal, impulse) in world.contacts() {
            assert!(point.y.abs() < 0.01 && near(normal, Vec3::y()) && impulse.dot(&normal) > 0.0);
            sum += impulse;
        }
        assert!((gained - sum).amax() < 1e-4, "{gained} {sum}");
    }
    assert!(world.contacts().count() > 0, "at rest it still presses");
    let momentum = length(*world.get(id).unwrap().momentum());
    assert!(momentum < 1e-3, "{momentum}");
}

#[test]
fn what_is_merely_near_is_no_contact() {
    let mut world = WorldBuilder::new().no_gravity().build();
    floor(&mut world).finish();
    ball(&mut world).pos(0.0, 1.0001, 0.0).finish();
    world.update(0.01);
    assert_eq!(world.contacts().count(), 0);
}

#[test]
fn boxes_hold_their_shapes() {
    let mut world = world();
    floor(&mut world).finish();
    let id = ball(&mut world).pos(0.0, 5.0, 0.0).finish();
    for _ in 0..20 {
        world.update(0.05);
        let boxes: Vec<(&AABB, usize)> = world.aabbs().collect();
        assert_eq!(boxes.iter().map(|b| b.1).collect::<Vec<_>>(), [0, 1]);
        assert!(boxes[1].0.contains(&world.body(id.into()).unwrap().aabb()));
    }
    world.body_mut(id.into()).unwrap().disable();
    assert_eq!(world.aabbs().count(), 1);
}

#[test]
fn a_world_of_either_plan_can_be_updated() {
    let mut world = World::try_new(&WorldDef::default()).unwrap();
    let ball = ball(&mut world).finish();
    world.update(0.5);
    assert!(close(world.get(ball).unwrap().position().y, -1.25));
}

#[test]
fn the_builder_chooses_the_narrow_phase() {
    use merev::narrow_phase::{GjkKind, ManifoldKind, NarrowPhaseKind};
    for kind in NarrowPhaseKind::ALL {
        for manifold in ManifoldKind::ALL {
            let builder = WorldBuilder::new().narrow_phase(kind).gjk(GjkKind::Barycentric).manifold(manifold);
            let Ok(mut world) = builder.try_build() else {
                assert!(!manifold.is_built());
                continue;
            };
            world.add_staticbody(Shape::new_box(10.0, 1.0, 10.0)).pos(0.0, -0.5, 0.0).finish();
            let id = world.add_rigidbody(Shape::new_box(1.0, 1.0, 1.0)).pos(0.0, 0.6, 0.0).finish();
            (0..100).for_each(|_| world.update(0.01));
            let y = world.get(id).unwrap().position().y;
            assert!((y - 0.5).abs() < 1e-3, "{kind:?} {manifold:?}: {y}");
        }
    }
}
