use super::*;
use crate::error::ErrorCode;
use crate::math::tolerance::EPSILON;
use crate::math::{quat_about, scalar, vec3};
use crate::shape::polytope::assert_consistent;
use crate::shape::testing::Random;

/// The brute-force oracle: tables agree, every input point lies inside every plane, every vertex is an input point.
fn check(points: &[Vec3], hull: &Hull) {
    assert_consistent(hull);
    let reach = points.iter().map(|p| p.amax()).fold(0.0, Float::max);
    for (i, f) in hull.faces().iter().enumerate() {
        for p in points {
            let h = f.normal.dot(p) - f.offset;
            assert!(h <= (60.0 * EPSILON + 5e-11) * reach, "face {i}: a point stands out by {h}");
        }
        for &v in hull.face_loop(i) {
            let h = f.normal.dot(&hull.vertices[v as usize]) - f.offset;
            assert!(h.abs() <= (60.0 * EPSILON + 5e-11) * reach, "face {i}: a vertex is off by {h}");
        }
    }
    assert!(hull.vertices.iter().all(|v| points.contains(v)));
}

fn grid_cube(n: usize) -> Vec<Vec3> {
    let at = |i: usize| i as Float / (n - 1) as Float - 0.5;
    let mut points = Vec::new();
    for i in 0..n {
        for j in 0..n {
            for k in 0..n {
                points.push(vec3(at(i), at(j), at(k)));
            }
        }
    }
    points
}

fn cylinder(sides: usize, radius: Float, height: Float) -> Vec<Vec3> {
    (0..sides)
        .flat_map(|i| {
            let (s, c) = scalar::sin_cos(i as Float / sides as Float * 2.0 * scalar::PI);
            [vec3(radius * c, radius * s, -0.5 * height), vec3(radius * c, radius * s, 0.5 * height)]
        })
        .collect()
}

#[test]
fn random_clouds() {
    let mut random = Random(1);
    for n in [4, 5, 6, 8, 13, 30, 100, 255] {
        for _ in 0..20 {
            let points = random.cloud(n, vec3(1.0, 0.7, 0.4));
            check(&points, &Hull::new(&points).unwrap());
            let points: Vec<_> = (0..n).map(|_| random.vec(1.0)).collect();
            if let Ok(hull) = Hull::new(&points) {
                check(&points, &hull);
            }
        }
    }
}

#[test]
fn a_cube_of_grid_points_has_six_faces_however_it_lies() {
    let mut random = Random(2);
    for n in [2, 3, 5, 9] {
        let points = grid_cube(n);
        let mut poses = vec![Pose::IDENTITY, Pose::translation(vec3(100.0, -50.0, 20.0))];
        poses.extend((0..30).map(|_| random.pose(3.0)));
        for pose in poses {
            let placed: Vec<_> = points.iter().map(|&p| pose.point(p)).collect();
            let hull = Hull::new(&placed).unwrap();
            check(&placed, &hull);
            assert_eq!((hull.vertices.len(), hull.edges.len(), hull.faces.len()), (8, 12, 6));
            assert!((hull.volume - 1.0).abs() < 2e-4);
        }
    }
}

#[test]
fn cylinders_needles_and_plates_keep_their_faces() {
    for sides in [3, 8, 32, 64, 127] {
        let points = cylinder(sides, 0.5, 1.0);
        let hull = Hull::new(&points).unwrap();
        check(&points, &hull);
        assert_eq!((hull.vertices.len(), hull.faces.len()), (2 * sides, sides + 2));
    }
    let mut random = Random(3);
    for size in [vec3(1.0, 1e-4, 1e-4), vec3(1.0, 1.0, 1e-4)] {
        for _ in 0..30 {
            let q = random.rotation();
            let points: Vec<_> =
                grid_cube(4).iter().map(|p| crate::math::rotate(&q, p.component_mul(&size))).collect();
            let hull = Hull::new(&points).unwrap();
            check(&points, &hull);
            let volume = size.x * size.y * size.z;
            assert!((hull.volume - volume).abs() < 0.01 * volume, "{} against {volume}", hull.volume);
        }
    }
}

#[test]
fn scale_and_place_do_not_matter() {
    let mut random = Random(4);
    for _ in 0..20 {
        // Multiples of 2⁻¹⁰, so that scaling and shifting are exact.
        let points: Vec<_> = random
            .cloud(40, vec3(1.0, 1.0, 1.0))
            .iter()
            .map(|p| p.map(|x| (x * 1024.0).round() / 1024.0))
            .collect();
        let hull = Hull::new(&points).unwrap();
        for scale in [1.0 / 1024.0, 1024.0] {
            let scaled = Hull::new(&points.iter().map(|p| p * scale).collect::<Vec<_>>()).unwrap();
            assert_eq!(hull.loops, scaled.loops);
        }
        let shift = vec3(16.0, -8.0, 4.0);
        let shifted = Hull::new(&points.iter().map(|p| p + shift).collect::<Vec<_>>()).unwrap();
        // The rounding that a face must forgive grows with the coordinates: a nearly flat pair may merge.
        assert_eq!(hull.vertices.len(), shifted.vertices.len());
        assert!(shifted.faces.len().abs_diff(hull.faces.len()) <= 3);
    }
}

#[test]
fn many_points_are_reduced_to_the_limit() {
    let mut random = Random(5);
    let points = random.cloud(100_000, vec3(1.0, 1.0, 1.0));
    let hull = Hull::new(&points).unwrap();
    assert_consistent(&hull);
    assert!((200..=MAX_HULL_VERTICES).contains(&hull.vertices.len()));
    let ball = 4.0 / 3.0 * scalar::PI;
    assert!(hull.volume > 0.93 * ball && hull.volume < ball);
    let small = Hull::with_max_vertices(&points, 12).unwrap();
    assert_consistent(&small);
    assert!(small.vertices.len() <= 12 && small.volume > 0.45 * ball);
}

#[test]
fn mass_agrees_with_a_box_and_with_counting() {
    let size = vec3(0.4, 1.0, 2.5);
    let pose = Pose::new(vec3(3.0, -1.0, 0.5), quat_about(vec3(1.0, 2.0, -0.3), 0.8));
    let points: Vec<_> = grid_cube(2).iter().map(|p| pose.point(p.component_mul(&size))).collect();
    let hull = Hull::new(&points).unwrap().mass_data(7.0);
    let exact = crate::shape::Shape::new_box(size.x, size.y, size.z).mass_data(7.0).placed(&pose);
    assert!((hull.mass - exact.mass).abs() < 1e-5 * exact.mass);
    assert!(crate::math::length(hull.center - exact.center) < 1e-5);
    assert!((hull.inertia - exact.inertia).abs().max() < 1e-5 * exact.inertia.max());
    // A random hull against the share of random points inside.
    let mut random = Random(6);
    let hull = Hull::new(&random.cloud(20, vec3(1.0, 1.0, 1.0))).unwrap();
    let (mut inside, mut sum, mut square, n) = (0, Vec3::zeros(), Mat3::zeros(), 200_000);
    for _ in 0..n {
        let p = random.vec(1.0);
        if hull.contains(p) {
            let d = p - hull.center;
            inside += 1;
            sum += d;
            square += Mat3::identity() * d.dot(&d) - d * d.transpose();
        }
    }
    let cell = 8.0 / n as Float;
    assert!((inside as Float * cell - hull.volume).abs() < 0.02 * hull.volume);
    assert!(crate::math::length(sum * cell) < 0.01 * hull.volume);
    assert!((square * cell - hull.unit_inertia).abs().max() < 0.03 * hull.unit_inertia.max());
}

#[test]
fn climbing_finds_the_farthest_vertex() {
    let mut random = Random(7);
    for n in [40, 120, 255] {
        let hull = Hull::new(&random.cloud(n, vec3(1.0, 0.5, 0.8))).unwrap();
        for _ in 0..1000 {
            let d = random.unit();
            let best = hull.vertices.iter().map(|v| v.dot(&d)).fold(-Float::MAX, Float::max);
            assert!(hull.vertices[hull.support(d)].dot(&d) >= best - 4.0 * EPSILON);
        }
    }
}

#[test]
fn what_has_no_volume_is_refused() {
    let code = |points: &[Vec3]| Hull::new(points).unwrap_err().code();
    let line: Vec<_> = (0..9).map(|i| vec3(1.0, 2.0, 3.0) * i as Float).collect();
    let flat: Vec<_> = (0..9).map(|i| vec3((i % 3) as Float, (i / 3) as Float, 1.0)).collect();
    for points in [&grid_cube(2)[..3], &[vec3(1.0, 1.0, 1.0); 7], &line, &flat] {
        assert_eq!(code(points), ErrorCode::Degenerate);
    }
    let mut cube = grid_cube(2);
    cube[3].y = Float::NAN;
    assert_eq!(code(&cube), ErrorCode::NotFinite);
    cube[3].y = 2e9;
    assert_eq!(code(&cube), ErrorCode::Range);
    assert_eq!(Hull::with_max_vertices(&grid_cube(2), 3).unwrap_err().code(), ErrorCode::Range);
}

#[test]
fn doubled_and_inner_points_vanish() {
    let mut points = grid_cube(2);
    points.extend(grid_cube(2));
    let mut random = Random(8);
    points.extend((0..200).map(|_| random.vec(0.5)));
    let hull = Hull::new(&points).unwrap();
    check(&points, &hull);
    assert_eq!(hull.vertices.len(), 8);
}
