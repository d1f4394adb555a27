//! What every integrator must do, judged by the exact motion.

use super::{IntegratorKind, PrincipalAxes, turn_by};
use crate::math::tolerance::EPSILON;
use crate::math::{Float, Quat, Vec3, length, quat_about, rotate, rotate_back, vec3};

const SINGLE: bool = size_of::<Float>() == 4;

fn tumbling_box() -> PrincipalAxes {
    let tilt = quat_about(vec3(0.2, -1.0, 0.4), 1.1);
    PrincipalAxes { moments: vec3(9.7 / 12.0, 8.2 / 12.0, 1.7 / 12.0), body_from_principal: tilt }
}

fn angle_between(a: &Quat, b: &Quat) -> Float {
    let d = a.conjugate() * b;
    2.0 * length(vec3(d.i, d.j, d.k))
}

fn energy(q: &Quat, l: Vec3, axes: &PrincipalAxes) -> Float {
    let p = rotate_back(&axes.body_from_principal, rotate_back(q, l));
    0.5 * p.dot(&p.component_div(&axes.moments))
}

fn after(kind: IntegratorKind, l: Vec3, axes: &PrincipalAxes, time: Float, steps: usize) -> Quat {
    let h = time / steps as Float;
    (0..steps).fold(quat_about(vec3(1.0, 2.0, -0.5), 0.7), |q, _| kind.turn(&q, l, axes, h))
}

/// Of Moser and Veselov with a step so short that nothing is left of its error: a method that knows no elliptic
/// function.
fn reference(l: Vec3, axes: &PrincipalAxes, time: Float) -> Quat {
    after(IntegratorKind::MoserVeselov, l, axes, time, if SINGLE { 400 } else { 20_000 })
}

#[test]
fn kinds_have_names_and_numbers() {
    for (i, kind) in IntegratorKind::ALL.into_iter().enumerate() {
        assert_eq!(kind as usize, i + 1);
        assert!(!kind.name().is_empty() && kind.name() != "auto");
    }
}

#[test]
fn errors_fall_by_the_order_of_the_method() {
    let axes = tumbling_box();
    let l = vec3(0.6, -1.2, 0.9);
    let exact = reference(l, &axes, 0.5);
    for kind in IntegratorKind::ALL {
        let error = |steps| angle_between(&after(kind, l, &axes, 0.5, steps), &exact);
        let (coarse, fine) = (error(40), error(80));
        let (least, most, bound) = match kind {
            IntegratorKind::Auto => unreachable!("not in the list"),
            IntegratorKind::ExplicitEuler | IntegratorKind::SemiImplicitEuler => (1.5, 2.7, 0.6),
            IntegratorKind::SymmetricSplitting | IntegratorKind::LieMidpoint => (3.0, 5.0, 0.05),
            // In f32 rounding hides the fourth order at steps that small.
            _ if SINGLE => (0.0, Float::MAX, 2e-4),
            IntegratorKind::MoserVeselov | IntegratorKind::Rk4 => (10.0, 22.0, 1e-3),
            IntegratorKind::ExactRotation => (0.0, Float::MAX, 1e-9),
        };
        let name = kind.name();
        assert!(coarse < bound, "{name}: {coarse} rad");
        assert!(coarse / fine > least && coarse / fine < most, "{name}: {coarse} and {fine} rad");
    }
}

#[test]
fn exact_rotation_meets_the_closed_period() {
    // Of the box of A3, T = 6.05684415802102 s: after it the body-frame momentum is what it was.
    let axes = PrincipalAxes {
        moments: vec3(9.7 / 12.0, 8.2 / 12.0, 1.7 / 12.0),
        body_from_principal: Quat::identity(),
    };
    let p = axes.moments.component_mul(&vec3(0.1, 5.0, 0.1));
    let period = 6.056_844_158_021_02_f64 as Float;
    let end = (0..100)
        .fold(Quat::identity(), |q, _| IntegratorKind::ExactRotation.turn(&q, p, &axes, period / 100.0));
    let error = length(rotate_back(&end, p) - p) / length(p);
    assert!(error < if SINGLE { 3e-4 } else { 1e-10 }, "{error}");
}

#[test]
fn energy_stays_where_the_method_promises_it() {
    let axes = tumbling_box();
    let q0 = quat_about(vec3(1.0, 2.0, -0.5), 0.7);
    let l = rotate(&q0, rotate(&axes.body_from_principal, axes.moments.component_mul(&vec3(0.1, 5.0, 0.1))));
    for kind in IntegratorKind::ALL {
        let e0 = energy(&q0, l, &axes);
        let (mut q, mut worst) = (q0, 0.0 as Float);
        for _ in 0..2400 {
            q = kind.turn(&q, l, &axes, 1.0 / 240.0);
            worst = worst.max((energy(&q, l, &axes) - e0).abs() / e0);
        }
        // accuracy.md §3.2: explicit 1.5, midpoint and splitting 3e-5, RK4 below 1e-8, the others rounding.
        let rounding = if SINGLE { 2e-5 } else { 1e-12 };
        let (least, most) = match kind {
            IntegratorKind::Auto => unreachable!("not in the list"),
            IntegratorKind::ExplicitEuler | IntegratorKind::SemiImplicitEuler => (0.1, 4.0),
            IntegratorKind::SymmetricSplitting | IntegratorKind::LieMidpoint => (5e-6, 1e-4),
            IntegratorKind::Rk4 => (0.0, if SINGLE { 2e-5 } else { 1e-8 }),
            IntegratorKind::MoserVeselov | IntegratorKind::ExactRotation => (0.0, rounding),
        };
        assert!(worst >= least && worst <= most, "{}: {worst}", kind.name());
    }
}

#[test]
fn spheres_turn_by_omega_t() {
    let axes = PrincipalAxes { moments: vec3(0.4, 0.4, 0.4), body_from_principal: Quat::identity() };
    let q0 = quat_about(vec3(1.0, 2.0, -0.5), 0.7);
    for kind in IntegratorKind::ALL {
        let end = (0..240).fold(q0, |q, _| kind.turn(&q, vec3(0.8, -0.4, 1.2), &axes, 1.0 / 240.0));
        let error = angle_between(&end, &turn_by(&q0, vec3(2.0, -1.0, 3.0)));
        let euler = matches!(kind, IntegratorKind::ExplicitEuler | IntegratorKind::SemiImplicitEuler);
        assert!(error < if euler { 1e-3 } else { 5e-5 }, "{}: {error}", kind.name());
    }
}

#[test]
fn degenerate_input_gives_finite_output_of_length_one() {
    for kind in IntegratorKind::ALL {
        for moments in [
            vec3(1e-6, 1.0, 1.0),
            vec3(1.0, 1.0, 1e-3),
            vec3(1.0, 0.5, 0.500_000_1),
            vec3(1.0, 1.0, 1.0),
            vec3(1e-22, 2e-22, 2.5e-22),
            vec3(3e9, 4e9, 1e9),
        ] {
            let axes = PrincipalAxes { moments, body_from_principal: Quat::identity() };
            for omega in [
                Vec3::zeros(),
                vec3(0.0, 5.0, 0.0),
                vec3(1e-30, 0.0, 0.0),
                vec3(40.0, 0.1, 3.0),
                vec3(1e6, -1e6, 1e6),
            ] {
                for h in [0.0, 1e-6, 1.0 / 60.0, 10.0, -0.01] {
                    let q = kind.turn(&Quat::identity(), moments.component_mul(&omega), &axes, h);
                    let size = q.w * q.w + q.i * q.i + q.j * q.j + q.k * q.k;
                    assert!((size - 1.0).abs() < 8.0 * EPSILON, "{} {moments} {omega} {h}", kind.name());
                }
            }
        }
    }
}

#[test]
fn symmetric_methods_go_back_the_way_they_came() {
    let axes = tumbling_box();
    let (q0, l) = (quat_about(vec3(1.0, 2.0, -0.5), 0.7), vec3(0.6, -1.2, 0.9));
    for kind in [
        IntegratorKind::MoserVeselov,
        IntegratorKind::SymmetricSplitting,
        IntegratorKind::LieMidpoint,
        IntegratorKind::ExactRotation,
    ] {
        let there = kind.turn(&q0, l, &axes, 0.05);
        let error = angle_between(&kind.turn(&there, l, &axes, -0.05), &q0);
        assert!(error < if SINGLE { 2e-6 } else { 1e-13 }, "{}: {error}", kind.name());
    }
}
