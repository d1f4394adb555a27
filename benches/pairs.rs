//! What a pair costs: time and iterations of each GJK kind, of EPA and MPR, and of both kinds of manifolds, against
//! the number of vertices and the gap: `cargo bench --bench pairs -- [--quick]`. Writes docs/measured/gjk.csv,
//! depth.csv and manifold.csv, in which it replaces the rows of this precision.

mod support;

use merev::math::quat_about;
use merev::math::scalar::double;
use merev::narrow_phase::{
    Cache, GjkKind, Manifold, ManifoldKind, Methods, NarrowPhaseKind, collide, distance_by, penetration,
};
use merev::shape::Shape;
use merev::{Float, Pose, Vec3};
use std::hint::black_box;
use std::time::Instant;
use support::{Random, ball, quantile};

const VERTICES: [usize; 7] = [4, 8, 16, 32, 64, 128, 250];

/// The gaps between the shapes along the line of their centres, with their names.
const GAPS: [(&str, Float); 5] = [("deep", -0.1), ("-1e-4", -1e-4), ("0+", 1e-7), ("1e-4", 1e-4), ("1", 1.0)];

fn precision() -> &'static str {
    if size_of::<Float>() == 4 { "f32" } else { "f64" }
}

/// Shape pairs of diameter 1, turned at random, with this gap.
fn poses(shape: &Shape, gap: Float, count: usize) -> Vec<Pose> {
    let mut random = Random(9);
    (0..count)
        .map(|_| {
            let (q, n) = (random.rotation(), random.unit());
            // Close up to a small gap first, so that the last move is along the normal that it leaves.
            let mut pose = Pose::new(n * 3.0, q);
            for target in [1e-3, 1e-3, 1e-3, 1e-3, gap] {
                let d = distance_by(shape, shape, &pose, GjkKind::Auto);
                pose.p += d.normal * (target - d.distance);
            }
            pose
        })
        .collect()
}

/// The medians of several runs of `f` over all poses, in ns a call: the times of single poses, sorted.
fn times(poses: &[Pose], rounds: usize, mut f: impl FnMut(&Pose)) -> Vec<f64> {
    const INNER: usize = 16;
    let mut all: Vec<f64> = poses
        .iter()
        .map(|pose| {
            let mut runs: Vec<f64> = (0..rounds)
                .map(|_| {
                    let start = Instant::now();
                    (0..INNER).for_each(|_| f(black_box(pose)));
                    start.elapsed().as_nanos() as f64 / INNER as f64
                })
                .collect();
            runs.sort_by(f64::total_cmp);
            quantile(&runs, 0.5)
        })
        .collect();
    all.sort_by(f64::total_cmp);
    all
}

fn cells(sorted: &[f64]) -> String {
    format!("{:.0},{:.0},{:.0}", quantile(sorted, 0.5), quantile(sorted, 0.99), quantile(sorted, 1.0))
}

fn main() {
    let quick = std::env::args().any(|a| a == "--quick");
    let (count, rounds) = if quick { (40, 3) } else { (400, 7) };
    let (mut gjk, mut depth, mut manifold) = (Vec::new(), Vec::new(), Vec::new());
    for vertices in VERTICES {
        let shape = ball(vertices);
        for (name, gap) in GAPS {
            let poses = poses(&shape, gap, count);
            for kind in &GjkKind::ALL[1..] {
                let ns = times(&poses, rounds, |p| {
                    black_box(distance_by(&shape, &shape, p, *kind));
                });
                let mut n: Vec<f64> = poses
                    .iter()
                    .map(|p| f64::from(distance_by(&shape, &shape, p, *kind).iterations))
                    .collect();
                n.sort_by(f64::total_cmp);
                gjk.push(format!(
                    "{},{},{vertices},{name},{},{}",
                    precision(),
                    kind.name(),
                    cells(&ns),
                    cells(&n)
                ));
            }
            if gap < 0.0 {
                for (method, kind) in [("epa", NarrowPhaseKind::GjkEpa), ("mpr", NarrowPhaseKind::GjkMpr)] {
                    let find = |p: &Pose| penetration(&shape, &shape, p, kind).expect("a bounded shape");
                    let ns = times(&poses, rounds, |p| {
                        black_box(find(p));
                    });
                    let mut n: Vec<f64> = poses.iter().map(|p| f64::from(find(p).iterations)).collect();
                    n.sort_by(f64::total_cmp);
                    let found: Vec<f64> = poses.iter().map(|p| double(find(p).depth)).collect();
                    let mean = found.iter().sum::<f64>() / found.len() as f64;
                    depth.push(format!(
                        "{},{method},{vertices},{name},{},{},{mean:.6}",
                        precision(),
                        cells(&ns),
                        cells(&n)
                    ));
                }
            }
        }
    }
    let cube = Shape::new_box(1.0, 1.0, 1.0);
    let mut random = Random(10);
    let mut lying = |a: &Shape, b: &Shape| -> Vec<Pose> {
        let _ = (a, b);
        (0..count)
            .map(|_| {
                let place = Vec3::new(random.within(-0.3, 0.3), 0.999, random.within(-0.3, 0.3));
                Pose::new(place, quat_about(Vec3::y(), random.within(-3.0, 3.0)))
            })
            .collect()
    };
    let prism = |n: usize| {
        let rim = |y: Float| {
            (0..n).map(move |i| {
                let angle = core::f64::consts::TAU * i as f64 / n as f64;
                let (s, c) = merev::math::scalar::sin_cos(angle as Float);
                Vec3::new(0.5 * c, y, 0.5 * s)
            })
        };
        Shape::hull(&rim(-0.5).chain(rim(0.5)).collect::<Vec<_>>()).expect("a prism has a hull")
    };
    let (p6, p32, p100) = (prism(6), prism(32), prism(100));
    let pairs: [(&str, &Shape, &Shape); 5] = [
        ("box on box", &cube, &cube),
        ("box on prism 6", &cube, &p6),
        ("prism 6 on prism 6", &p6, &p6),
        ("prism 32 on prism 32", &p32, &p32),
        ("prism 100 on prism 100", &p100, &p100),
    ];
    for (name, a, b) in pairs {
        let poses = lying(a, b);
        for kind in &ManifoldKind::ALL[1..] {
            if !kind.is_built() {
                continue;
            }
            let methods = Methods { manifold: *kind, ..Methods::default() };
            let mut out = Manifold::default();
            let mut cache = Cache::default();
            let ns =
                times(&poses, rounds, |p| collide(a, b, p, 0.01, methods, &mut cache, black_box(&mut out)));
            let mut points = 0;
            for p in &poses {
                collide(a, b, p, 0.01, methods, &mut Cache::default(), &mut out);
                points += out.count;
            }
            let mean = points as f64 / poses.len() as f64;
            manifold.push(format!("{},{},{name},{},{mean:.2}", precision(), kind.name(), cells(&ns)));
        }
    }
    let head =
        "precision,kind,vertices,gap,ns p50,ns p99,ns max,iterations p50,iterations p99,iterations max";
    support::write_csv("gjk.csv", head, &gjk, 1);
    support::write_csv("depth.csv", &format!("{head},mean depth"), &depth, 1);
    support::write_csv("manifold.csv", "precision,kind,pair,ns p50,ns p99,ns max,mean points", &manifold, 1);
    for row in gjk.iter().chain(&depth).chain(&manifold) {
        println!("{row}");
    }
}
