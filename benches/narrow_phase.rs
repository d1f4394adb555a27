//! What a contact costs, in ns a call: `cargo bench --bench narrow_phase`.

use merev::math::{quat_about, vec3};
use merev::narrow_phase::{Cache, Manifold, Methods, NarrowPhaseKind, collide, distance};
use merev::shape::Shape;
use merev::{Float, Pose, Vec3};
use std::hint::black_box;
use std::time::Instant;

/// The best of several runs over many slightly different poses, in ns a call.
fn time(mut f: impl FnMut(usize)) -> f64 {
    (0..15)
        .map(|_| {
            let start = Instant::now();
            (0..20_000).for_each(&mut f);
            start.elapsed().as_nanos() as f64 / 20_000.0
        })
        .fold(f64::MAX, f64::min)
}

fn ball(n: usize) -> Shape {
    let points: Vec<Vec3> = (0..n)
        .map(|i| {
            let y = 1.0 - 2.0 * (i as Float + 0.5) / n as Float;
            let (s, c) = merev::math::scalar::sin_cos(2.399_963_2 * i as Float);
            let r = (1.0 - y * y).sqrt();
            vec3(r * c, y, r * s) * 0.5
        })
        .collect();
    Shape::hull(&points).unwrap()
}

fn main() {
    let cube = Shape::new_box(1.0, 1.0, 1.0);
    let corners: Vec<Vec3> = (0..8)
        .map(|i| vec3((i & 1) as Float, (i >> 1 & 1) as Float, (i >> 2) as Float) - vec3(0.5, 0.5, 0.5))
        .collect();
    let hull = Shape::hull(&corners).unwrap();
    let sphere = Shape::new_sphere(1.0);
    let capsule = Shape::new_capsule(1.0, 0.5);
    let floor = Shape::half_space(Vec3::y(), 0.0).unwrap();
    let (b12, b60, b200) = (ball(12), ball(60), ball(200));
    let up = |y: Float| vec3(0.1, y, 0.05);
    let yaw = quat_about(Vec3::y(), 0.5);
    let tilt = quat_about(vec3(1.0, 0.2, 0.7), 0.9);
    let none = Pose::IDENTITY.q;
    let lying = quat_about(Vec3::z(), merev::math::scalar::PI * 0.5);
    let cases: Vec<(&str, &Shape, &Shape, Pose)> = vec![
        ("box-box aligned", &cube, &cube, Pose::new(up(0.9999), none)),
        ("box-box exactly on top", &cube, &cube, Pose::new(vec3(0.0, 0.9999, 0.0), none)),
        ("box-box yaw", &cube, &cube, Pose::new(up(0.9999), yaw)),
        ("box-box edges", &cube, &cube, Pose::new(up(1.15), tilt)),
        ("box-box apart", &cube, &cube, Pose::new(up(1.05), yaw)),
        ("box-hull8 aligned", &cube, &hull, Pose::new(up(0.9999), none)),
        ("hull8-hull8 yaw", &hull, &hull, Pose::new(up(0.9999), yaw)),
        ("ball12-ball12", &b12, &b12, Pose::new(up(0.9), tilt)),
        ("ball60-ball60", &b60, &b60, Pose::new(up(0.97), tilt)),
        ("ball200-ball200", &b200, &b200, Pose::new(up(0.97), tilt)),
        ("box-ball60", &cube, &b60, Pose::new(up(0.98), tilt)),
        ("sphere-sphere", &sphere, &sphere, Pose::new(up(0.98), none)),
        ("sphere-box", &sphere, &cube, Pose::new(up(0.98), tilt)),
        ("sphere-hull8", &sphere, &hull, Pose::new(up(0.98), none)),
        ("capsule-capsule", &capsule, &capsule, Pose::new(vec3(0.45, 0.1, 0.0), none)),
        ("capsule-box lying", &cube, &capsule, Pose::new(up(0.7499), lying)),
        ("floor-box", &floor, &cube, Pose::new(up(0.4999), yaw)),
        ("floor-ball200", &floor, &b200, Pose::new(up(0.49), yaw)),
    ];
    println!("{:<26}{:>10}{:>10}{:>10}{:>8}", "", "auto", "gjk_epa", "distance", "points");
    for (name, a, b, pose) in cases {
        let mut m = Manifold::default();
        let at = |i: usize| Pose::new(pose.p + vec3((i % 7) as Float, 0.0, (i % 5) as Float) * 1e-5, pose.q);
        let mut cache = Cache::default();
        let auto = time(|i| {
            collide(a, b, black_box(&at(i)), 0.01, Methods::default(), &mut cache, black_box(&mut m))
        });
        let points = m.count;
        let mut cache = Cache::default();
        let gjk = time(|i| {
            collide(
                a,
                b,
                black_box(&at(i)),
                0.01,
                NarrowPhaseKind::GjkEpa.into(),
                &mut cache,
                black_box(&mut m),
            )
        });
        let far = time(|i| {
            black_box(distance(a, b, black_box(&at(i))));
        });
        println!("{name:<26}{auto:>10.0}{gjk:>10.0}{far:>10.0}{points:>8}");
    }
}
