//! The problem itself, and Gauss–Seidel on it.

use super::testing::*;
use super::*;

#[test]
fn projecting_to_the_cone_splits_a_vector_into_cone_and_polar() {
    let mut random = Random(1);
    for mu in [0.0, 0.3, 1.0, 20.0] {
        for _ in 0..200 {
            let v = random.vec(3.0);
            let p = project(&v, mu);
            let rest = v - p;
            assert!(tangent_length(&p) <= mu * p.x + 1e-12, "in the cone");
            // The polar cone: −rest is in the dual, of aperture 1/μ.
            assert!(mu * tangent_length(&rest) <= -rest.x + 1e-12, "in the polar cone");
            assert!(p.dot(&rest).abs() < 1e-12, "at a right angle");
        }
    }
}

#[test]
fn w_is_symmetric_and_says_what_impulses_do_to_velocities() {
    let mut random = Random(2);
    let scene = super::testing::random(&mut random, 4, 9, 2.0);
    let problem = scene.problem(0.5);
    let n = problem.size();
    let lambda: Vec<f64> = (0..n).map(|_| random.within(-1.0, 1.0)).collect();
    // Apply the impulses to the bodies one by one instead.
    let mut moved =
        Scene { masses: scene.masses.clone(), free: scene.free.clone(), points: scene.points.clone() };
    for (k, p) in scene.points.iter().enumerate() {
        let impulse: V = (0..3).map(|r| p.axes[r] * lambda[3 * k + r]).sum();
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            if p.bodies[side] != IMMOVABLE {
                let mass = &scene.masses[p.bodies[side]];
                moved.free[p.bodies[side]][0] += impulse * (sign * mass.inv_mass);
                moved.free[p.bodies[side]][1] += mass.turned_by(&p.arms[side].cross(&impulse)) * sign;
            }
        }
    }
    let mut sigma = Vec::new();
    problem.velocity(&lambda, &mut sigma);
    for (a, b) in sigma.iter().zip(&moved.problem(0.0).b) {
        assert!((a - b).abs() < 1e-12, "{a} instead of {b}");
    }
    for i in 0..n {
        for j in 0..n {
            assert_eq!(problem.w[i * n + j], problem.w[j * n + i]);
        }
    }
}

#[test]
fn the_residual_is_zero_for_solutions_and_only_for_them() {
    let tangent = 0.5;
    let problem = slope(tangent).problem(0.6);
    let weight = 2.0 * FALL / (1.0 + tangent * tangent).sqrt();
    let (normal, friction) = (weight, -weight * tangent);
    // Its tangent axis is x; the moment of friction about the centre shifts the load downhill.
    let mut lambda = vec![0.0; 12];
    let shift = friction * 0.25 / (2.0 * 0.5);
    for (k, x) in [-1.0, 1.0, 1.0, -1.0].into_iter().enumerate() {
        lambda[3 * k] = 0.25 * normal - 0.5 * shift * x;
        let axis = slope(tangent).points[k].axes[1];
        // In proportion to the load, so that every point stays within its cone.
        lambda[3 * k + 1] = -tangent * lambda[3 * k] * axis.x;
    }
    assert!(problem.residual(&lambda) < 1e-12, "{}", problem.residual(&lambda));
    for i in 0..12 {
        let mut wrong = lambda.clone();
        wrong[i] += 0.01;
        assert!(problem.residual(&wrong) > 1e-4, "component {i}");
    }
    assert!(problem.residual(&[f64::NAN; 12]).is_nan());
}

#[test]
fn gauss_seidel_sticks_below_and_slides_above_the_angle_of_friction() {
    let mut lambda = Vec::new();
    let problem = slope(0.45).problem(0.5);
    assert_eq!(gauss_seidel::solve(&problem, &mut lambda, 2000, 1e-10).status, Status::Solved);
    let mut sigma = Vec::new();
    problem.velocity(&lambda, &mut sigma);
    assert!(sigma.iter().all(|s| s.abs() < 1e-8));
    let problem = slope(0.55).problem(0.5);
    lambda.clear();
    assert_eq!(gauss_seidel::solve(&problem, &mut lambda, 2000, 1e-10).status, Status::Solved);
    problem.velocity(&lambda, &mut sigma);
    let expected = FALL * (0.55 - 0.5) / (1.0_f64 + 0.55 * 0.55).sqrt();
    for k in 0..4 {
        assert!((tangent_length(&three(&sigma, k)) - expected).abs() < 1e-8);
    }
}

#[test]
fn gauss_seidel_ends_in_a_named_way_whatever_it_gets() {
    for (name, problem) in degenerate() {
        let mut lambda = Vec::new();
        let outcome = gauss_seidel::solve(&problem, &mut lambda, 200, 1e-9);
        println!("{name}: {} after {}", outcome.status.name(), outcome.iterations);
        assert!(lambda.iter().all(|l| l.is_finite()) || !outcome.status.is_usable(), "{name}");
        assert_eq!(problem.refusal().is_some(), outcome.status == Status::NotFinite, "{name}");
    }
}
