//! What every shape promises, checked against sampling.

use super::testing::Random;
use super::*;
use crate::error::ErrorCode;
use crate::math::tolerance::EPSILON;
use crate::math::{Mat3, length, vec3};

fn each(rounds: usize, mut f: impl FnMut(&Shape, &mut Random)) {
    let mut random = Random(41);
    for kind in 0..4 {
        for _ in 0..rounds {
            let shape = random.shape(kind);
            f(&shape, &mut random);
        }
    }
}

/// How far the shape reaches along the unit vector `d`.
fn reach(shape: &Shape, d: Vec3) -> Float {
    let core = shape.core().unwrap();
    core.points.point(core.points.support(&wide(d))).dot(&d) + core.radius
}

#[test]
fn boxes_are_tight() {
    each(200, |shape, random| {
        let pose = random.pose(3.0);
        let b = shape.aabb(&pose);
        for k in 0..3 {
            let mut d = Vec3::zeros();
            d[k] = 1.0;
            let (up, down) = (reach(shape, pose.vector_back(d)), reach(shape, pose.vector_back(-d)));
            assert!((b.upper[k] - (pose.p[k] + up)).abs() < 1e-5);
            assert!((b.lower[k] - (pose.p[k] - down)).abs() < 1e-5);
        }
    });
}

#[test]
fn closest_points_lie_on_the_surface_and_nothing_is_closer() {
    each(100, |shape, random| {
        for _ in 0..20 {
            let p = random.vec(3.0);
            let q = shape.closest_point(p);
            if shape.contains(p) {
                assert_eq!(p, q);
                continue;
            }
            // The plane through q across p − q holds the whole shape: nothing is closer.
            let n = (p - q) / length(p - q);
            assert!((reach(shape, n) - n.dot(&q)).abs() < 30.0 * EPSILON, "{shape:?} {p}");
        }
    });
}

#[test]
fn rays_hit_where_they_enter() {
    let mut hits = 0;
    each(100, |shape, random| {
        for _ in 0..20 {
            let o = random.vec(4.0);
            let d = (random.vec(1.0) - o) * random.within(0.5, 2.0);
            let starts_inside = shape.contains(o);
            match shape.ray_cast(o, d, 1.0) {
                Some(hit) if starts_inside => {
                    assert_eq!((hit.fraction, hit.normal), (0.0, Vec3::zeros()));
                }
                Some(hit) => {
                    hits += 1;
                    assert!(length(shape.closest_point(hit.point) - hit.point) < 1e-5);
                    assert!((length(hit.normal) - 1.0).abs() < 1e-5 && hit.normal.dot(&d) <= 0.0);
                    assert!((reach(shape, hit.normal) - hit.normal.dot(&hit.point)).abs() < 1e-4);
                    for k in 0..10 {
                        assert!(!shape.contains(o + d * (hit.fraction * k as Float / 10.1)));
                    }
                    assert!(shape.ray_cast(o, d, hit.fraction * 0.99).is_none());
                }
                None => {
                    assert!((0..=50).all(|k| !shape.contains(o + d * (k as Float / 50.0))));
                }
            }
        }
    });
    assert!(hits > 500, "{hits}");
}

#[test]
fn far_rays_keep_their_aim() {
    // From 10 km, 1 mm beside the rim of a ball of 1 m. In f32 the plain discriminant has no digit left here.
    let ball = Shape::new_sphere(2.0);
    let ray = |y: Float| ball.ray_cast(vec3(-10_000.0, y, 0.0), vec3(20_000.0, 0.0, 0.0), 1.0);
    assert!(ray(0.999).is_some() && ray(1.001).is_none());
    let hit = ray(0.6).unwrap();
    assert!((hit.point.x + 0.8).abs() < 2e-3 && (hit.normal.y - 0.6).abs() < 1e-3);
    let floor = Shape::half_space(Vec3::y(), 1.0).unwrap();
    let hit = floor.ray_cast(vec3(0.0, 11.0, 0.0), vec3(3.0, -20.0, 0.0), 1.0).unwrap();
    assert_eq!((hit.fraction, hit.normal), (0.5, Vec3::y()));
    assert!(floor.ray_cast(vec3(0.0, 11.0, 0.0), vec3(0.0, 1.0, 0.0), 1.0).is_none());
    // Along a face, and with a zero translation.
    let cube = Shape::new_box(2.0, 2.0, 2.0);
    assert!(cube.ray_cast(vec3(-3.0, 1.0, 0.0), vec3(6.0, 0.0, 0.0), 1.0).is_some());
    assert!(cube.ray_cast(vec3(-3.0, 0.0, 0.0), Vec3::zeros(), 1.0).is_none());
    assert!(ball.ray_cast(vec3(-3.0, 0.0, 0.0), Vec3::zeros(), 1.0).is_none());
}

#[test]
fn mass_agrees_with_counting() {
    each(2, |shape, random| {
        let b = shape.aabb(&Pose::IDENTITY);
        let (center, half) = (b.center(), b.half());
        let exact = shape.mass_data(2.0);
        let n = 300_000;
        let cell = 2.0 * 8.0 * half.x * half.y * half.z / n as Float;
        let (mut mass, mut first, mut second) = (0.0, Vec3::zeros(), Mat3::zeros());
        for _ in 0..n {
            let p = center + random.vec(1.0).component_mul(&half);
            if shape.contains(p) {
                let d = p - exact.center;
                mass += cell;
                first += d * cell;
                second += (Mat3::identity() * d.dot(&d) - d * d.transpose()) * cell;
            }
        }
        assert!((mass - exact.mass).abs() < 0.015 * exact.mass, "{shape:?}");
        assert!(length(first) < 0.015 * exact.mass);
        assert!((second - exact.inertia).abs().max() < 0.025 * exact.inertia.max(), "{shape:?}");
        assert!((exact.mass - 2.0 * shape.volume()).abs() <= 1e-6 * exact.mass);
    });
}

#[test]
fn radii_bound_the_shape() {
    each(100, |shape, random| {
        let from = random.vec(1.0);
        let outer = shape.outer_radius(from);
        let farthest = (0..2000)
            .map(|_| {
                let core = shape.core().unwrap();
                let d = random.unit();
                let p = core.points.point(core.points.support(&wide(d)));
                length(p - from) + core.radius
            })
            .fold(0.0, Float::max);
        assert!(farthest <= outer + 1e-5 && farthest > outer - 0.05);
        // The inner ball is inside: no direction reaches less far from the centre of mass.
        let center = shape.mass_data(1.0).center;
        for _ in 0..100 {
            let d = random.unit();
            assert!(reach(shape, d) - d.dot(&center) >= shape.inner_radius() - 1e-5);
        }
    });
}

#[test]
fn the_box_of_a_half_space_is_finite_and_tight_where_it_can_be() {
    let floor = Shape::half_space(vec3(0.0, 3.0, 0.0), 2.0).unwrap();
    let b = floor.aabb(&Pose::translation(vec3(5.0, 1.0, 0.0)));
    assert!(b.is_valid() && b.area().is_finite());
    assert_eq!(b.upper.y, 3.0);
    let slope = Shape::half_space(vec3(1.0, 1.0, 0.0), 0.0).unwrap();
    let b = slope.aabb(&Pose::IDENTITY);
    assert!(b.is_valid() && b.upper.x == crate::math::tolerance::MAX_COORDINATE);
    assert_eq!(floor.mass_data(1.0), MassData::ZERO);
}

#[test]
fn bad_sizes_are_refused_with_their_reason() {
    let code = |r: Result<Shape>| r.unwrap_err().code();
    assert_eq!(code(Shape::try_new_box(1.0, 0.0, 1.0)), ErrorCode::Range);
    assert_eq!(code(Shape::try_new_box(1.0, 1e-6, 1.0)), ErrorCode::Degenerate);
    assert_eq!(code(Shape::try_new_box(1.0, Float::NAN, 1.0)), ErrorCode::NotFinite);
    assert_eq!(code(Shape::try_new_sphere(-1.0)), ErrorCode::Range);
    assert_eq!(code(Shape::try_new_sphere(Float::INFINITY)), ErrorCode::NotFinite);
    assert_eq!(code(Shape::try_new_sphere(1e10)), ErrorCode::Range);
    assert_eq!(code(Shape::try_new_capsule(0.0, 1.0)), ErrorCode::Degenerate);
    assert_eq!(code(Shape::half_space(Vec3::zeros(), 0.0)), ErrorCode::Degenerate);
    assert_eq!(code(Shape::half_space(Vec3::y(), 1e10)), ErrorCode::Range);
    let sentence = Shape::try_new_box(1.0, 1e-6, 1.0).unwrap_err().to_string();
    assert!(sentence.contains("height") && sentence.ends_with('.'), "{sentence}");
}

#[test]
#[should_panic(expected = "Half the box's depth is -1")]
fn the_short_constructors_panic_with_the_sentence() {
    let _ = Shape::new_box(1.0, 1.0, -2.0);
}

#[test]
fn the_tables_of_a_box_are_consistent() {
    let b = Cuboid::new(vec3(1.0, 2.0, 3.0)).unwrap();
    polytope::assert_consistent(&b);
    for f in 0..6 {
        let (n, d) = b.plane(f);
        for &v in b.face_vertices(f) {
            assert_eq!(n.dot(&b.vertex(v as usize)), d);
        }
        for (i, (axis, positive)) in cuboid::SIDES[f].into_iter().enumerate() {
            let ends = [i, (i + 1) % 4].map(|i| b.vertex(b.face_vertices(f)[i] as usize)[axis as usize]);
            assert!(ends[0] == ends[1] && (ends[0] > 0.0) == positive && axis as usize != f / 2);
        }
        assert_eq!(b.face_along(n), f);
    }
}
