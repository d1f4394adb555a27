use super::*;
use crate::constraint::joint::{
    DistanceJoint, JointKind, Limit, PrismaticJoint, RevoluteJoint, SphericalJoint, UniversalJoint,
    WeldJoint, WheelJoint,
};
use crate::shape::Shape;
use crate::world::{BodyDef, BodyId, BodyType, JointDef, ShapeDef, WorldDef};

const TOLERANCE: Float = 1e-5;

fn world() -> World {
    World::try_new(&WorldDef::default()).unwrap()
}

fn body(world: &mut World, kind: BodyType, at: Vec3, shape: Shape) -> BodyId {
    let def = BodyDef { body_type: kind, position: at, name: "bob".to_owned(), ..BodyDef::default() };
    world.create_body_with_shape(&def, &ShapeDef::default(), shape).unwrap().0
}

fn drawn(world: &World, options: &DrawOptions, tessellate: bool) -> DrawBuffers {
    let mut buffers = DrawBuffers { tessellate, ..DrawBuffers::default() };
    buffers.fill(world, options).unwrap();
    buffers
}

/// A cube on a plane, at rest after some steps.
fn cube_on_plane() -> World {
    let mut w = world();
    body(&mut w, BodyType::Static, Vec3::zeros(), Shape::half_space(Vec3::y(), 0.0).unwrap());
    body(&mut w, BodyType::Dynamic, vec3(3.0, 0.5, -1.0), Shape::new_box(1.0, 1.0, 1.0));
    for _ in 0..20 {
        w.try_step(1.0 / 60.0, 4).unwrap();
    }
    w
}

#[test]
fn nothing_asked_for_is_nothing_drawn() {
    let buffers = drawn(&cube_on_plane(), &DrawOptions::nothing(), true);
    assert_eq!(buffers, DrawBuffers { tessellate: true, ..DrawBuffers::default() });
}

#[test]
fn a_cube_has_twelve_edges_and_triangles_that_face_outwards() {
    let w = cube_on_plane();
    let center = w.body(w.bodies().nth(1).unwrap()).unwrap().world_center();
    let far = Aabb::around(center, vec3(0.6, 0.6, 0.6));
    let options = DrawOptions { shapes: true, edges: true, mask_bits: 1, ..DrawOptions::nothing() };
    let b = drawn(&w, &options, true);
    let (cube, plane): (Vec<_>, Vec<_>) = b.triangles.iter().partition(|t| t.shape.index1 == 2);
    assert_eq!((cube.len(), plane.len()), (12, 2));
    let area: Float = cube.iter().map(|t: &&Triangle| area(&t.points)).sum();
    assert!((area - 6.0).abs() < 1e-4, "{area}");
    for t in &cube {
        let middle = (t.points[0] + t.points[1] + t.points[2]) / 3.0;
        assert!(t.normal.dot(&(middle - center)) > 0.4 && winds_about(t));
        assert_eq!(t.color, colors::AWAKE);
    }
    assert!(plane.iter().all(|t| t.points.iter().all(|p| p.y.abs() < TOLERANCE) && winds_about(t)));
    // 12 of the cube, all 1 m long, at its place; 4 around the plane's patch.
    let of_cube: Vec<_> = b.lines.iter().filter(|l| far.overlaps(&Aabb::of_points(&l.points))).collect();
    assert_eq!(b.lines.len(), 16);
    let short = of_cube.iter().filter(|l| (length(l) - 1.0).abs() < TOLERANCE).count();
    assert_eq!(short, 12);
}

fn length(l: &Line) -> Float {
    crate::math::length(l.points[1] - l.points[0])
}

fn area(p: &[Vec3; 3]) -> Float {
    0.5 * crate::math::length((p[1] - p[0]).cross(&(p[2] - p[0])))
}

fn winds_about(t: &Triangle) -> bool {
    let [a, b, c] = t.points;
    (b - a).cross(&(c - a)).dot(&t.normal) > 0.0
}

#[test]
fn round_shapes_are_closed_and_nearly_as_large_as_they_are() {
    for (shape, volume) in [
        (Shape::new_sphere(2.0), 4.18879),
        (Shape::new_capsule(2.0, 1.0), crate::math::scalar::PI * (1.0 / 6.0 + 0.5)),
        (Shape::hull(&[Vec3::zeros(), Vec3::x(), Vec3::y(), Vec3::z()]).unwrap(), 1.0 / 6.0),
    ] {
        let mut w = world();
        body(&mut w, BodyType::Dynamic, vec3(1.0, 2.0, 3.0), shape);
        let b = drawn(&w, &DrawOptions::default(), true);
        // By the divergence theorem; a surface with a hole would not give the same from every origin.
        let inside = |from: Vec3| -> Float {
            let part = |t: &Triangle| {
                let [p, q, r] = t.points.map(|p| p - from);
                p.dot(&q.cross(&r)) / 6.0
            };
            b.triangles.iter().map(part).sum()
        };
        let (here, there) = (inside(Vec3::zeros()), inside(vec3(3.0, -2.0, 5.0)));
        assert!((here - there).abs() < 1e-3, "{here} {there}");
        assert!(here > 0.86 * volume && here < 1.0001 * volume, "{here} of {volume}");
        assert!(b.triangles.iter().all(winds_about));
    }
}

#[test]
fn instances_say_where_and_how_large() {
    let mut w = world();
    body(&mut w, BodyType::Kinematic, vec3(1.0, 2.0, 3.0), Shape::new_capsule(2.0, 1.0));
    body(&mut w, BodyType::Static, vec3(4.0, 0.0, 0.0), Shape::new_sphere(0.5));
    body(&mut w, BodyType::Static, vec3(0.0, 0.0, 9.0), Shape::new_box(1.0, 2.0, 3.0));
    let b = drawn(&w, &DrawOptions::default(), false);
    assert_eq!((b.instances.len(), b.triangles.len(), b.lines.len()), (3, 0, 0));
    let [pill, ball, cuboid] = [b.instances[0], b.instances[1], b.instances[2]];
    assert_eq!(
        (pill.kind, pill.size, pill.color),
        (InstanceKind::Capsule, vec3(0.5, 1.0, 0.5), colors::KINEMATIC)
    );
    assert!(crate::math::length(pill.pose.p - vec3(1.0, 2.0, 3.0)) < TOLERANCE);
    assert_eq!(
        (ball.kind, ball.size, ball.pose.p),
        (InstanceKind::Sphere, vec3(0.25, 0.25, 0.25), vec3(4.0, 0.0, 0.0))
    );
    assert_eq!(
        (cuboid.kind, cuboid.size, cuboid.color),
        (InstanceKind::Box, vec3(0.5, 1.0, 1.5), colors::STATIC)
    );
    // What is outside or masked is not there.
    let near = Aabb::around(vec3(4.0, 0.0, 0.0), vec3(1.0, 1.0, 1.0));
    let options = DrawOptions { bounds: near, ..DrawOptions::default() };
    assert_eq!(drawn(&w, &options, false).instances, [ball]);
    let options = DrawOptions { mask_bits: 0, ..DrawOptions::default() };
    assert_eq!(drawn(&w, &options, false).instances, []);
}

#[test]
fn capsules_point_where_they_point() {
    for (p, q) in [
        (Vec3::x(), -Vec3::x()),
        (Vec3::y(), -Vec3::y()),
        (-Vec3::y(), Vec3::y()),
        (vec3(1.0, 2.0, 3.0), Vec3::zeros()),
    ] {
        let mut w = world();
        let shape = Shape::Capsule(crate::shape::Capsule::new(p, q, 0.25).unwrap());
        body(&mut w, BodyType::Static, Vec3::zeros(), shape);
        let pill = drawn(&w, &DrawOptions::default(), false).instances[0];
        let ends = [1.0, -1.0].map(|s| pill.pose.point(vec3(0.0, s * pill.size.y, 0.0)));
        let off = |a: Vec3, b: Vec3| crate::math::length(ends[0] - a) + crate::math::length(ends[1] - b);
        assert!(off(p, q).min(off(q, p)) < 1e-5, "{p} {q}: {ends:?}");
    }
}

#[test]
fn contacts_show_points_normals_and_the_weight() {
    let w = cube_on_plane();
    let on = DrawOptions {
        contacts: true,
        contact_normals: true,
        contact_forces: true,
        contact_features: true,
        ..DrawOptions::nothing()
    };
    let b = drawn(&w, &on, false);
    assert_eq!((b.points.len(), b.texts.len(), b.lines.len()), (4, 4, 8));
    let (forces, normals): (Vec<_>, Vec<_>) = b.lines.iter().partition(|l| l.color == colors::FORCE);
    assert_eq!((forces.len(), normals.len()), (4, 4));
    // 1000 kg at 10 m/s², 10⁻⁴ m/N.
    let sum: Float = forces.iter().copied().map(length).sum();
    assert!((sum - 1.0).abs() < 1e-2, "{sum}");
    for line in &b.lines {
        assert!((line.points[1] - line.points[0]).y.abs() > 0.9 * length(line));
    }
    for p in &b.points {
        assert!(p.position.y.abs() < 1e-3 && ((p.position.x - 3.0).abs() - 0.5).abs() < 1e-3);
        assert_eq!(p.color, colors::TOUCHING);
    }
    let colored = DrawOptions { contacts: true, graph_colors: true, ..DrawOptions::nothing() };
    assert!(drawn(&w, &colored, false).points.iter().all(|p| p.color != colors::TOUCHING));
}

#[test]
fn joints_are_lines_between_bodies_and_frames() {
    let mut w = world();
    let a = body(&mut w, BodyType::Static, Vec3::zeros(), Shape::new_sphere(0.2));
    let b = body(&mut w, BodyType::Dynamic, vec3(0.0, -3.0, 0.0), Shape::new_sphere(0.2));
    let kind = JointKind::Distance(DistanceJoint { length: 2.0, ..DistanceJoint::default() });
    let frame = Pose::translation(vec3(0.0, 1.0, 0.0));
    w.create_joint(&JointDef::new(kind, a, b).frames(Pose::IDENTITY, frame)).unwrap();
    let options = DrawOptions { joints: true, ..DrawOptions::nothing() };
    let drawing = drawn(&w, &options, false);
    let ends: Vec<_> = drawing.lines.iter().map(|l| l.points).collect();
    let (anchor, origin) = (vec3(0.0, -2.0, 0.0), vec3(0.0, -3.0, 0.0));
    assert_eq!(ends, [[Vec3::zeros(), Vec3::zeros()], [origin, anchor], [Vec3::zeros(), anchor]]);
    assert_eq!(drawing.points.len(), 2);
    let extras = DrawOptions { joint_extras: true, ..options };
    assert_eq!(drawn(&w, &extras, false).lines.len(), 3 + 6);
}

/// What is drawn between a static body at the origin and one at `at`, in the colour asked for.
fn joint_lines(kind: JointKind, at: Pose, color: Color) -> Vec<[Vec3; 2]> {
    let mut w = world();
    let a = body(&mut w, BodyType::Static, Vec3::zeros(), Shape::new_sphere(0.2));
    let b = body(&mut w, BodyType::Dynamic, at.p, Shape::new_sphere(0.2));
    w.body_mut(b).unwrap().set_transform(&at).unwrap();
    w.create_joint(&JointDef::new(kind, a, b)).unwrap();
    let options =
        DrawOptions { joints: true, joint_extras: true, joint_scale: 4.0, ..DrawOptions::nothing() };
    let lines = drawn(&w, &options, false).lines;
    lines.iter().filter(|l| l.color == color).map(|l| l.points).collect()
}

#[test]
fn limits_are_drawn_where_they_stop() {
    let limit = Limit { enable: true, lower: 0.25, upper: 1.25 };
    let mut hinge = RevoluteJoint::default();
    hinge.drive.limit = limit;
    let lines = joint_lines(JointKind::Revolute(hinge), Pose::IDENTITY, colors::LIMIT);
    // With a scale of 4 the arc has a radius of 1 m; the last two lines lead to its ends.
    let ends: Vec<Vec3> = lines[lines.len() - 2..].iter().map(|l| l[1]).collect();
    for (end, angle) in ends.iter().zip([0.25, 1.25]) {
        let (sine, cosine) = crate::math::scalar::sin_cos(angle);
        assert!(crate::math::length(end - vec3(cosine, sine, 0.0)) < 1e-5, "{end}");
    }
    assert_eq!(lines[0][0], ends[0]);
    assert!(crate::math::length(lines[lines.len() - 3][1] - ends[1]) < 1e-5);

    let mut slide = PrismaticJoint::default();
    slide.drive.limit = limit;
    let lines = joint_lines(JointKind::Prismatic(slide), Pose::IDENTITY, colors::LIMIT);
    assert_eq!(lines, [[vec3(0.25, 0.0, 0.0), vec3(1.25, 0.0, 0.0)]]);
}

#[test]
fn the_cone_is_where_the_swing_ends() {
    let joint =
        SphericalJoint { enable_cone_limit: true, cone_angle: [0.8, 0.3], ..SphericalJoint::default() };
    let lines = joint_lines(JointKind::Spherical(joint), Pose::IDENTITY, colors::LIMIT);
    assert_eq!(lines.len(), 16 + 4);
    // A swing about x by as much as the cone lets takes z to a point of the rim; likewise about y.
    for (axis, angle) in [(Vec3::x(), 0.8), (Vec3::y(), 0.3)] {
        let tip = crate::math::rotate(&crate::math::quat_about(axis, angle), Vec3::z());
        let nearest = lines.iter().map(|l| crate::math::length(l[1] - tip)).fold(Float::MAX, Float::min);
        assert!(nearest < 1e-5, "{nearest}");
    }
}

#[test]
fn axes_are_those_of_what_is_free() {
    let turned = Pose::new(vec3(0.0, 0.0, 0.0), crate::math::quat_about(Vec3::y(), 1.0));
    for (kind, axes) in [
        (JointKind::Revolute(RevoluteJoint::default()), vec![Vec3::z()]),
        (JointKind::Prismatic(PrismaticJoint::default()), vec![Vec3::x()]),
        (JointKind::Universal(UniversalJoint::default()), vec![Vec3::x(), Vec3::y()]),
        (JointKind::Weld(WeldJoint::default()), vec![]),
    ] {
        let lines = joint_lines(kind, turned, colors::AXIS);
        assert_eq!(lines, axes.iter().map(|&u| [-u, u]).collect::<Vec<_>>());
    }
    // A wheel spins about z of its own frame.
    let lines = joint_lines(JointKind::Wheel(WheelJoint::default()), turned, colors::AXIS);
    let spin = turned.vector(Vec3::z());
    assert_eq!(lines.len(), 2);
    assert!(crate::math::length(lines[1][1] - spin) < 1e-5);
}

#[test]
fn islands_bounds_mass_names_and_sleep() {
    let mut w = cube_on_plane();
    let islands = DrawOptions { islands: true, ..DrawOptions::nothing() };
    let lines = drawn(&w, &islands, false).lines;
    assert_eq!(lines.len(), 12);
    assert!(lines.iter().all(|l| l.color == colors::ISLAND && (length(l) - 1.0).abs() < 1e-3));
    let bounds = DrawOptions { shape_bounds: true, ..DrawOptions::nothing() };
    let lines = drawn(&w, &bounds, false).lines;
    assert_eq!(lines.len(), 24);
    assert!(lines.iter().all(|l| length(l) < 100.0 && length(l) > 0.0));
    let mass = DrawOptions { mass: true, ..DrawOptions::nothing() };
    let drawing = drawn(&w, &mass, false);
    assert_eq!((drawing.points.len(), drawing.texts[0].text.as_str()), (1, "1000.000 kg"));
    let names = DrawOptions { names: true, ..DrawOptions::nothing() };
    assert_eq!(drawn(&w, &names, false).texts.iter().filter(|t| t.text == "bob").count(), 2);
    let sleep = DrawOptions { sleep: true, ..DrawOptions::nothing() };
    assert!(drawn(&w, &sleep, false).texts[0].text.starts_with("slow for 0."));
    for _ in 0..60 {
        w.try_step(1.0 / 60.0, 4).unwrap();
    }
    let drawing = drawn(&w, &DrawOptions { shapes: true, sleep: true, ..DrawOptions::nothing() }, false);
    assert_eq!(drawing.texts[0].text, "asleep");
    assert_eq!(drawing.instances[0].color, colors::ASLEEP);
}

#[test]
fn bad_options_are_refused() {
    let w = world();
    let mut buffers = DrawBuffers::default();
    let nan = DrawOptions { force_scale: Float::NAN, ..DrawOptions::default() };
    assert_eq!(buffers.fill(&w, &nan).unwrap_err().code(), ErrorCode::NotFinite);
    let negative = DrawOptions { joint_scale: -1.0, ..DrawOptions::default() };
    assert_eq!(buffers.fill(&w, &negative).unwrap_err().code(), ErrorCode::Range);
    let inside_out = DrawOptions { bounds: Aabb::EMPTY, ..DrawOptions::default() };
    assert_eq!(buffers.fill(&w, &inside_out).unwrap_err().code(), ErrorCode::Range);
}
