//! Runs every method of the room on seeded pairs and counts errors and ways out.
#![allow(dead_code)]

use super::support::{CLASSES, Clouds, Random, pair, quantile};
use merev::Float;
use merev::math::scalar::double;
use merev::narrow_phase::{
    Cache, DepthStatus, DistanceStatus, GjkKind, MAX_TRACE_STEPS, Manifold, ManifoldKind, Methods,
    NarrowPhaseKind, Proxy, TraceStep, collide, distance_proxy_traced, penetration,
};

/// What one method did on one class of pairs.
#[derive(Default, Clone)]
pub struct Tally {
    pub pairs: usize,
    /// |Δ| / scale of each pair that has an oracle.
    pub errors: Vec<f64>,
    pub iterations: Vec<f64>,
    pub statuses: [usize; 8],
    /// NaN, infinite or negative where it must not be, or a broken manifold.
    pub bad: usize,
}

/// The methods, in the order of the tallies: GJK kinds, EPA, MPR, then manifolds of all kinds, which only must be sane.
pub fn methods() -> Vec<String> {
    let mut all: Vec<String> = GjkKind::ALL[1..].iter().map(|k| format!("gjk_{}", k.name())).collect();
    all.extend(["epa", "mpr", "manifolds"].map(str::to_owned));
    all
}

pub fn status_names(method: usize) -> Vec<&'static str> {
    match method {
        m if m < GjkKind::ALL.len() - 1 => DistanceStatus::ALL.iter().map(|s| s.name()).collect(),
        m if m < GjkKind::ALL.len() + 1 => DepthStatus::ALL.iter().map(|s| s.name()).collect(),
        _ => vec!["apart", "touching"],
    }
}

/// Runs `count` pairs, class after class in turn: `tallies[method][class]`.
pub fn run(seed: u64, count: usize) -> Vec<Vec<Tally>> {
    let mut random = Random(seed);
    let mut tallies = vec![vec![Tally::default(); CLASSES.len()]; methods().len()];
    let gjk = GjkKind::ALL.len() - 1;
    for round in 0..count {
        let class = round % CLASSES.len();
        let (a, b, pose) = pair(&mut random, class);
        let clouds = Clouds::new(&a, &b, &pose);
        let (lower, upper) = clouds.distance();
        let sure = upper - lower <= 1e-9 * clouds.scale;
        let (pa, pb) = (Proxy::new(&a.points, 0.0).unwrap(), Proxy::new(&b.points, 0.0).unwrap());
        let mut trace = [TraceStep::default(); MAX_TRACE_STEPS];
        for (m, kind) in GjkKind::ALL[1..].iter().enumerate() {
            let tally = &mut tallies[m][class];
            let (d, steps) = distance_proxy_traced(&pa, &pb, &pose, *kind, &mut trace);
            let found = double(d.distance);
            let sane = found.is_finite()
                && found >= 0.0
                && [d.point_a, d.point_b, d.normal].iter().all(|v| v.iter().all(|x| x.is_finite()))
                && steps > 0;
            tally.pairs += 1;
            tally.bad += usize::from(!sane);
            tally.statuses[d.status as usize] += 1;
            tally.iterations.push(f64::from(d.iterations));
            if sure {
                let error = (lower - found).max(found - upper).max(0.0);
                tally.errors.push(error / clouds.scale);
            }
        }
        let (Some(sa), Some(sb)) = (&a.shape, &b.shape) else { continue };
        let overlapping = upper <= 0.0 && sure;
        let oracle =
            if overlapping && a.points.len().max(b.points.len()) > 2 { clouds.depth() } else { None };
        for (m, kind) in [NarrowPhaseKind::GjkEpa, NarrowPhaseKind::GjkMpr].into_iter().enumerate() {
            let tally = &mut tallies[gjk + m][class];
            let d = penetration(sa, sb, &pose, kind).unwrap();
            tally.pairs += 1;
            let sane = d.depth.is_finite()
                && [d.point_a, d.point_b, d.normal].iter().all(|v| v.iter().all(|x| x.is_finite()));
            tally.bad += usize::from(!sane);
            tally.statuses[d.status as usize] += 1;
            tally.iterations.push(f64::from(d.iterations));
            if let Some(exact) = oracle
                && d.status != DepthStatus::Apart
            {
                let error = double(d.depth) - clouds.radii - exact;
                tally.errors.push(error.abs() / clouds.scale);
            }
        }
        let tally = &mut tallies[gjk + 2][class];
        tally.pairs += 1;
        let mut touched = false;
        for kind in NarrowPhaseKind::ALL {
            for manifold in [ManifoldKind::SutherlandHodgman, ManifoldKind::Clipper2] {
                let margin = 0.01 * sa.inner_radius().min(sb.inner_radius());
                let mut out = Manifold::default();
                let methods = Methods { kind, gjk: GjkKind::Auto, manifold };
                collide(sa, sb, &pose, margin, methods, &mut Cache::default(), &mut out);
                touched |= out.count > 0;
                let length = out.normal.dot(&out.normal);
                let sane = out.count == 0
                    || (length - 1.0).abs() < 1e-4
                        && out.points().iter().all(|p| {
                            p.separation <= margin
                                && p.separation.is_finite()
                                && p.point.iter().all(|x: &Float| x.is_finite())
                        });
                // What overlaps by more than rounding must touch.
                let missed = out.count == 0 && overlapping && oracle.is_some_and(|d| d > 1e-5 * clouds.scale);
                tally.bad += usize::from(!sane || missed);
            }
        }
        tally.statuses[usize::from(touched)] += 1;
    }
    for tally in tallies.iter_mut().flatten() {
        tally.errors.sort_by(f64::total_cmp);
        tally.iterations.sort_by(f64::total_cmp);
    }
    tallies
}

/// One row a method and class.
pub fn rows(tallies: &[Vec<Tally>]) -> Vec<String> {
    let precision = if size_of::<Float>() == 4 { "f32" } else { "f64" };
    let mut rows = Vec::new();
    for (m, (method, of_method)) in methods().iter().zip(tallies).enumerate() {
        for (class, t) in CLASSES.iter().zip(of_method) {
            let names = status_names(m);
            let ended: Vec<String> = names
                .iter()
                .zip(t.statuses)
                .filter(|(_, n)| *n > 0)
                .map(|(name, n)| format!("{name} {n}"))
                .collect();
            rows.push(format!(
                "{precision},{method},{class},{},{},{:.1e},{:.1e},{:.1e},{},{},{},{},{}",
                t.pairs,
                t.errors.len(),
                quantile(&t.errors, 0.5),
                quantile(&t.errors, 0.99),
                quantile(&t.errors, 1.0),
                quantile(&t.iterations, 0.5),
                quantile(&t.iterations, 0.99),
                quantile(&t.iterations, 1.0),
                t.bad,
                ended.join("; "),
            ));
        }
    }
    rows
}

pub const HEAD: &str = "precision,method,class,pairs,with oracle,error p50,error p99,error max,\
iterations p50,iterations p99,iterations max,bad,ended";
