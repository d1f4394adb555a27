use super::super::contact_problem::testing::{self, *};
use super::*;

fn solved(problem: &ContactProblem, facets: usize) -> Vec<f64> {
    let mut lambda = Vec::new();
    let outcome = Lemke::default().solve(problem, facets, &mut lambda);
    assert_eq!(outcome.status, Status::Solved, "{outcome:?}");
    lambda
}

fn velocities(problem: &ContactProblem, lambda: &[f64]) -> Vec<f64> {
    let mut sigma = Vec::new();
    problem.velocity(lambda, &mut sigma);
    sigma
}

#[test]
fn a_block_on_a_slope_sticks_or_slides_by_its_angle() {
    for facets in [3, 4, 5, 8, 16] {
        let problem = slope(0.45).problem(0.5 / libm::cos(core::f64::consts::PI / facets as f64));
        let lambda = solved(&problem, facets);
        assert!(velocities(&problem, &lambda).iter().all(|s| s.abs() < 1e-9), "{facets} facets stick");
    }
    // Downhill is a corner of the pyramid for these numbers: the closed form holds to rounding.
    for facets in [4, 8, 16] {
        let problem = slope(0.55).problem(0.5);
        let sigma = velocities(&problem, &solved(&problem, facets));
        let expected = FALL * 0.05 / (1.0_f64 + 0.55 * 0.55).sqrt();
        for k in 0..4 {
            let s = super::super::contact_problem::tangent_length(&super::super::contact_problem::three(
                &sigma, k,
            ));
            assert!((s - expected).abs() < 1e-9, "{facets} facets: slides at {s}");
        }
    }
}

#[test]
fn stacks_of_any_mass_ratio_carry_their_weight() {
    for decade in 0..=6 {
        let ratio = libm::pow(10.0, f64::from(decade));
        for (masses, mu) in [([1.0, ratio], 0.0), ([ratio, 1.0], 0.0), ([1.0, ratio], 0.6)] {
            let lambda = solved(&stack(&masses).problem(mu), 8);
            let got = interfaces(&lambda);
            let want = [(masses[0] + masses[1]) * FALL, masses[1] * FALL];
            for (g, w) in got.iter().zip(want) {
                assert!((g / w - 1.0).abs() < 1e-6, "{masses:?} {mu}: {got:?} instead of {want:?}");
            }
        }
    }
}

#[test]
fn a_stack_of_50_is_exact_without_friction() {
    let masses = [1.0; 50];
    let problem = stack(&masses).problem(0.0);
    let lambda = solved(&problem, 8);
    for (i, got) in interfaces(&lambda).into_iter().enumerate() {
        let want = (50 - i) as f64 * FALL;
        assert!((got / want - 1.0).abs() < 1e-8, "interface {i}: {got} instead of {want}");
    }
    assert!(velocities(&problem, &lambda).iter().all(|s| s.abs() < 1e-9));
}

#[test]
fn frictionless_problems_agree_with_the_oracle() {
    let mut random = Random(3);
    for round in 0..40 {
        let decades = f64::from(round % 4);
        let (bodies, points) = (1 + random.below(6), 2 + random.below(25));
        let problem = testing::random(&mut random, bodies, points, decades).problem(0.0);
        let lambda = solved(&problem, 8);
        let (sigma, objective) = oracle(&problem, &problem.b, &Rule::None);
        let off = velocity_error(&problem, &lambda, &sigma);
        assert!(off < 1e-5, "round {round}: velocities differ by {off:e}");
        assert!(objective_error(&problem, &lambda, objective) < 1e-8, "not the least energy");
    }
}

#[test]
fn friction_pyramids_agree_with_the_oracle_at_the_load_they_found() {
    let mut random = Random(4);
    for round in 0..30 {
        let facets = [3, 4, 5, 8][round % 4];
        let (bodies, points) = (1 + random.below(4), 1 + random.below(8));
        let problem = testing::random(&mut random, bodies, points, 1.0).problem(random.within(0.1, 1.0));
        let lambda = solved(&problem, facets);
        let radius: Vec<f64> = (0..points).map(|k| problem.friction(k) * lambda[3 * k]).collect();
        let (sigma, _) = oracle(&problem, &problem.b, &Rule::Prism(facets, &radius));
        let off = velocity_error(&problem, &lambda, &sigma);
        assert!(off < 1e-5, "round {round}, {facets} facets: velocities differ by {off:e}");
    }
}

/// The associated pyramid is a quadratic program; its conditions of optimality are a complementarity problem.
#[test]
fn the_convex_pyramid_agrees_with_the_oracle() {
    let mut random = Random(5);
    for _ in 0..15 {
        let facets = 6;
        let (bodies, points) = (1 + random.below(3), 1 + random.below(5));
        let problem = testing::random(&mut random, bodies, points, 1.0).problem(0.5);
        // x = Σ βⱼ (1/μ, dⱼ) spans the pyramid: min ½ xᵀWx + bᵀx over β ≥ 0 is w = GᵀWG β + Gᵀb.
        let (size, n) = (problem.size(), points * facets);
        let generator = |a: usize| {
            let (s, c) = direction(a % facets, facets);
            (3 * (a / facets), [1.0 / 0.5, c, s])
        };
        let (mut m, mut q) = (vec![0.0; n * n], vec![0.0; n]);
        for i in 0..n {
            let (ri, gi) = generator(i);
            q[i] = (0..3).map(|d| gi[d] * problem.b[ri + d]).sum();
            for j in 0..n {
                let (rj, gj) = generator(j);
                m[i * n + j] =
                    (0..9).map(|d| gi[d / 3] * gj[d % 3] * problem.w[(ri + d / 3) * size + rj + d % 3]).sum();
            }
        }
        let mut lemke = Lemke::default();
        assert_eq!(lemke.complementarity(&m, &q).status, Status::Solved);
        let mut lambda = vec![0.0; size];
        for (i, beta) in lemke.solution().iter().enumerate() {
            let (r, g) = generator(i);
            (0..3).for_each(|d| lambda[r + d] += beta * g[d]);
        }
        let (sigma, objective) = oracle(&problem, &problem.b, &Rule::Pyramid(facets));
        assert!(velocity_error(&problem, &lambda, &sigma) < 1e-5);
        assert!(objective_error(&problem, &lambda, objective) < 1e-8, "not the least energy");
    }
}

#[test]
fn a_problem_that_cycles_without_the_lexicographic_rule_ends() {
    // Kostreva's example (1979), on which Lemke's method with the plain ratio test may cycle for ever.
    let m = [1.0, 2.0, 0.0, 0.0, 1.0, 2.0, 2.0, 0.0, 1.0];
    let mut lemke = Lemke::default();
    let outcome = lemke.complementarity(&m, &[-1.0, -1.0, -1.0]);
    assert_eq!(outcome.status, Status::Solved);
    for z in lemke.solution() {
        assert!((z - 1.0 / 3.0).abs() < 1e-12, "{:?}", lemke.solution());
    }
    assert!(outcome.iterations < 20);
}

#[test]
fn what_has_no_solution_ends_in_a_ray() {
    // w = −z − 1 is never ≥ 0 with z ≥ 0; and a wedge.
    assert_eq!(Lemke::default().complementarity(&[-1.0], &[-1.0]).status, Status::Ray);
    let wedge = degenerate().into_iter().find(|(name, _)| *name == "wedged").unwrap().1;
    assert_eq!(Lemke::default().solve(&wedge, 8, &mut Vec::new()).status, Status::Ray);
}

#[test]
fn whatever_comes_in_a_named_status_comes_out() {
    let mut lemke = Lemke::default();
    for (name, problem) in degenerate() {
        let mut lambda = Vec::new();
        let outcome = lemke.solve(&problem, 8, &mut lambda);
        println!("{name}: {} after {}", outcome.status.name(), outcome.iterations);
        assert!(lambda.iter().all(|l| l.is_finite()), "{name}");
        assert_eq!(problem.refusal().is_some(), outcome.status == Status::NotFinite, "{name}");
    }
    let large = stack(&[1.0; 60]).problem(0.5);
    assert_eq!(lemke.solve(&large, 8, &mut Vec::new()).status, Status::TooLarge);
}

/// Gaps are measured with rounding, so what touches at four corners is asked for slightly different velocities.
#[test]
fn noise_in_hyperstatic_contacts_does_no_harm() {
    let mut random = Random(12);
    let (mut failed, mut lambda) = (0, Vec::new());
    let mut lemke = Lemke::default();
    for round in 0..200 {
        let mut scene = stack(&[1.0; 5]);
        // Places rounded to single precision, and not.
        let rounding = [0.0, 6e-8, 1e-4][round % 3];
        for p in &mut scene.points {
            p.arms.iter_mut().for_each(|arm| *arm += random.vec(rounding));
        }
        let mut problem = scene.problem(0.6);
        let noise = [1e-9, 1e-7, 1e-5, 1e-3][round % 4];
        problem.b.iter_mut().for_each(|b| *b += random.within(-noise, noise));
        let outcome = lemke.solve(&problem, 8, &mut lambda);
        if !outcome.status.is_usable() {
            println!("noise {noise:e}, {rounding:e}: {outcome:?}");
            failed += 1;
        }
    }
    assert_eq!(failed, 0);
}
