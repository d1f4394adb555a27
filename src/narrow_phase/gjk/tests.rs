//! Every kind against the oracle and against the optimality condition: p is the point of a simplex closest to the
//! origin exactly where p · (w − p) ≥ 0 for all vertices w.

use super::*;
use crate::shape::testing::Random;

fn reduced(kind: GjkKind, mut s: Simplex) -> (Wide, Simplex) {
    let p = match kind {
        GjkKind::Auto | GjkKind::SignedVolumes => s.reduce::<SignedVolumes>(),
        GjkKind::Barycentric => s.reduce::<Barycentric>(),
        GjkKind::CutSpace => s.reduce::<CutSpace>(),
        GjkKind::Johnson => s.reduce::<Johnson>(),
    };
    (p, s)
}

fn simplex(points: &[Wide]) -> Simplex {
    let mut s = Simplex::default();
    for (i, w) in points.iter().enumerate() {
        s.push(Vertex { w: *w, id: (i as u16, 0) });
    }
    s
}

/// A simplex of 2 … 4 vertices of size 1, flat by `thin`, with or without the origin inside.
fn random_simplex(random: &mut Random, round: usize, thin: f64) -> Simplex {
    let shift = wide(random.vec(1.0)) * (round % 2) as f64;
    let turn = random.rotation();
    let points: Vec<Wide> = (0..2 + round % 3)
        .map(|_| {
            let mut w = random.vec(1.0);
            w.z *= crate::math::scalar::single(thin);
            wide(crate::math::rotate(&turn, w)) + shift
        })
        .collect();
    simplex(&points)
}

fn optimality(p: &Wide, all: &Simplex) -> f64 {
    all.vertices().iter().map(|v| p.dot(&(v.w - p))).fold(f64::MAX, f64::min)
}

#[test]
fn every_kind_finds_the_closest_point_of_a_simplex() {
    let mut random = Random(11);
    for round in 0..6_000 {
        let all = random_simplex(&mut random, round, 1.0);
        let (oracle, _) = reduced(GjkKind::Barycentric, all);
        for kind in GjkKind::ALL {
            let (p, s) = reduced(kind, all);
            assert!((p - oracle).norm() <= 1e-9, "{kind:?} round {round}: {p} {oracle}");
            assert!((s.weights().iter().sum::<f64>() - 1.0).abs() < 1e-12);
            if s.len() < 4 {
                assert!(optimality(&p, &all) >= -1e-10, "{kind:?} round {round}");
            }
        }
    }
}

#[test]
fn the_oracle_and_the_default_stand_flat_simplices() {
    let mut random = Random(12);
    for round in 0..20_000 {
        let thin = [1e-3, 1e-5, 1e-7, 0.0][round % 4];
        let all = random_simplex(&mut random, round / 4, thin);
        let (oracle, s) = reduced(GjkKind::Barycentric, all);
        let bound = if s.len() == 4 { 1e-9 } else { 0.0 };
        assert!(s.len() == 4 || optimality(&oracle, &all) >= -1e-12, "round {round} {thin}");
        let (p, s) = reduced(GjkKind::SignedVolumes, all);
        assert!(s.len() == 4 || optimality(&p, &all) >= -1e-12, "round {round} {thin}");
        assert!((p.norm() - oracle.norm()).abs() <= 1e-7 + bound, "round {round} {thin}: {p} {oracle}");
    }
}

/// The cut-space and Johnson kinds lose digits on flat simplices, but what they return is a point of the simplex.
#[test]
fn every_kind_returns_a_point_of_a_degenerate_simplex() {
    let mut random = Random(13);
    let tiny = Wide::new(1e-160, 0.0, 0.0);
    let mut cases: Vec<Vec<Wide>> = vec![
        vec![Wide::zeros(); 4],
        vec![Wide::x(); 4],
        vec![Wide::x(), Wide::x(), Wide::y(), Wide::y()],
        vec![Wide::x(), Wide::x() * 2.0, Wide::x() * 3.0, Wide::x() * 4.0],
        vec![-Wide::x(), Wide::x(), Wide::x() * 2.0, Wide::x() * 3.0],
        vec![Wide::x(), Wide::y(), -Wide::x(), -Wide::y()],
        vec![tiny, -tiny, tiny * 2.0, tiny * 3.0],
        vec![
            Wide::x() * 1e9,
            Wide::x() * 1e9 + Wide::y() * 1e-7,
            Wide::z() * 1e9,
            Wide::x() * 1e9 - Wide::y(),
        ],
    ];
    for _ in 0..2_000 {
        let (p, q) = (wide(random.vec(1.0)), wide(random.vec(1.0)));
        let k = wide(random.vec(2.0));
        cases.push(vec![p, q, p + (q - p) * k.x, p + (q - p) * k.y]);
        cases.push(vec![p, p, q, p + (q - p) * k.z]);
        cases.push(vec![p, q, p + q, p - q * k.x]);
    }
    for points in &cases {
        let size = points.iter().map(|p| p.norm()).fold(0.0, f64::max);
        for n in 1..=4 {
            let all = simplex(&points[..n]);
            let (oracle, _) = reduced(GjkKind::Barycentric, all);
            for kind in GjkKind::ALL {
                let (p, s) = reduced(kind, all);
                assert!((1..=n).contains(&s.len()), "{kind:?} {points:?}");
                assert!(s.weights().iter().all(|k| k.is_finite() && *k > 0.0), "{kind:?} {points:?}");
                assert!((s.weights().iter().sum::<f64>() - 1.0).abs() < 1e-9);
                if s.len() < 4 {
                    assert!(p.norm() >= oracle.norm() - 1e-7 * size, "{kind:?} {points:?}");
                    // Johnson's cofactors of collinear points are rounding: it may take a wrong one for the closest.
                    let slack = if kind == GjkKind::Johnson { size } else { 1e-5 * size };
                    assert!(p.norm() <= oracle.norm() + slack, "{kind:?} {points:?} {p} {oracle}");
                }
            }
        }
    }
}

#[test]
fn names_are_those_of_the_files() {
    let names: Vec<_> = GjkKind::ALL.iter().map(|k| k.name()).collect();
    assert_eq!(names, ["auto", "barycentric", "cut_space", "signed_volumes", "johnson"]);
    for (i, kind) in GjkKind::ALL.iter().enumerate() {
        assert_eq!(*kind as usize, i);
    }
}
