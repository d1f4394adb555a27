use super::super::contact_problem::testing::{self, *};
use super::*;

fn exact() -> Options {
    Options { iterations: 20_000, tolerance: 1e-9, corrected: true }
}

fn solved(problem: &ContactProblem, options: &Options) -> Vec<f64> {
    let mut lambda = Vec::new();
    let outcome = ProximalAdmm::default().solve(problem, options, &mut lambda);
    assert_eq!(outcome.status, Status::Solved, "{outcome:?}");
    lambda
}

fn velocities(problem: &ContactProblem, lambda: &[f64]) -> Vec<f64> {
    let mut sigma = Vec::new();
    problem.velocity(lambda, &mut sigma);
    sigma
}

#[test]
fn a_block_on_a_slope_sticks_or_slides_by_its_angle_whatever_its_heading() {
    for k in 0..8 {
        let turn = f64::from(k) * 0.2;
        let placed = |tangent: f64| {
            let mut scene = slope(tangent);
            let v = scene.free[0][0];
            let (s, c) = libm::sincos(turn);
            scene.free[0][0] = V::new(c * v.x, v.y, s * v.x);
            scene.problem(0.5)
        };
        let problem = placed(0.45);
        assert!(velocities(&problem, &solved(&problem, &exact())).iter().all(|s| s.abs() < 1e-7), "sticks");
        let problem = placed(0.55);
        let sigma = velocities(&problem, &solved(&problem, &exact()));
        let expected = FALL * 0.05 / (1.0_f64 + 0.55 * 0.55).sqrt();
        for k in 0..4 {
            let s = tangent_length(&three(&sigma, k));
            assert!((s - expected).abs() < 1e-7, "slides at {s} instead of {expected}");
            assert!(sigma[3 * k].abs() < 1e-7, "and stays on the slope");
        }
    }
}

#[test]
fn stacks_of_any_mass_ratio_carry_their_weight() {
    for decade in 0..=6 {
        let ratio = libm::pow(10.0, f64::from(decade));
        for (masses, mu) in [([1.0, ratio], 0.0), ([ratio, 1.0], 0.6), ([1.0, ratio], 0.6)] {
            let problem = stack(&masses).problem(mu);
            let mut lambda = Vec::new();
            let mut admm = ProximalAdmm::default();
            let outcome = admm.solve(&problem, &exact(), &mut lambda);
            println!("{masses:?} {mu}: {outcome:?}, {} factorisations", admm.factorisations);
            assert!(outcome.status.is_usable(), "{masses:?}: {outcome:?}");
            let got = interfaces(&lambda);
            let want = [(masses[0] + masses[1]) * FALL, masses[1] * FALL];
            for (g, w) in got.iter().zip(want) {
                assert!((g / w - 1.0).abs() < 1e-3, "{masses:?} {mu}: {got:?} instead of {want:?}");
            }
        }
    }
}

#[test]
fn a_stack_of_50_carries_its_weight() {
    let problem = stack(&[1.0; 50]).problem(0.6);
    let mut lambda = Vec::new();
    let outcome = ProximalAdmm::default().solve(&problem, &Options::default(), &mut lambda);
    println!("{outcome:?}");
    assert!(outcome.status.is_usable(), "{outcome:?}");
    for (i, got) in interfaces(&lambda).into_iter().enumerate() {
        let want = (50 - i) as f64 * FALL;
        assert!((got / want - 1.0).abs() < 1e-2, "interface {i}: {got} instead of {want}");
    }
}

#[test]
fn the_associated_problem_agrees_with_the_oracle() {
    let mut random = Random(9);
    for round in 0..30 {
        let (bodies, points) = (1 + random.below(5), 1 + random.below(15));
        let problem = testing::random(&mut random, bodies, points, 1.0).problem(random.within(0.1, 1.0));
        let lambda = solved(&problem, &Options { corrected: false, tolerance: 1e-7, ..exact() });
        let (sigma, objective) = oracle(&problem, &problem.b, &Rule::Cone);
        let off = velocity_error(&problem, &lambda, &sigma);
        assert!(off < 1e-5, "round {round}: velocities differ by {off:e}");
        assert!(objective_error(&problem, &lambda, objective) < 1e-8, "not the least energy");
    }
}

/// At the solution De Saxcé's term is a constant: the convex problem with it has the same velocities.
#[test]
fn coulombs_law_agrees_with_the_oracle_for_the_correction_it_found() {
    let mut random = Random(10);
    let mut rough = 0;
    for round in 0..40 {
        let (bodies, points) = (1 + random.below(5), 1 + random.below(12));
        let problem = testing::random(&mut random, bodies, points, 1.0).problem(random.within(0.1, 0.8));
        let mut lambda = Vec::new();
        let outcome = ProximalAdmm::default().solve(&problem, &exact(), &mut lambda);
        if outcome.status != Status::Solved {
            println!("round {round}: {outcome:?}");
            rough += 1;
            continue;
        }
        let sigma = velocities(&problem, &lambda);
        let mut corrected = problem.b.clone();
        for k in 0..points {
            corrected[3 * k] += problem.friction(k) * tangent_length(&three(&sigma, k));
        }
        let (expected, _) = oracle(&problem, &corrected, &Rule::Cone);
        let off = velocity_error(&problem, &lambda, &expected);
        assert!(off < 1e-5, "round {round}: velocities differ by {off:e}");
    }
    assert!(rough <= 4, "{rough} of 40 were not solved");
}

#[test]
fn frictionless_problems_agree_with_the_oracle() {
    let mut random = Random(11);
    for round in 0..30 {
        let (bodies, points) = (1 + random.below(6), 2 + random.below(20));
        let problem = testing::random(&mut random, bodies, points, 1.0).problem(0.0);
        let lambda = solved(&problem, &exact());
        let (sigma, objective) = oracle(&problem, &problem.b, &Rule::None);
        let off = velocity_error(&problem, &lambda, &sigma);
        assert!(off < 1e-5, "round {round}: velocities differ by {off:e}");
        assert!(objective_error(&problem, &lambda, objective) < 1e-8, "not the least energy");
    }
}

#[test]
fn a_good_start_saves_iterations() {
    let problem = stack(&[1.0; 5]).problem(0.5);
    let mut admm = ProximalAdmm::default();
    let mut lambda = Vec::new();
    let cold = admm.solve(&problem, &Options::default(), &mut lambda);
    let warm = admm.solve(&problem, &Options::default(), &mut lambda);
    assert!(cold.status == Status::Solved && warm.status == Status::Solved);
    assert!(cold.iterations > 10 && warm.iterations == 0, "{cold:?}, {warm:?}");
}

#[test]
fn what_has_no_solution_says_so() {
    let wedge = degenerate().into_iter().find(|(name, _)| *name == "wedged").unwrap().1;
    let status = ProximalAdmm::default().solve(&wedge, &Options::default(), &mut Vec::new()).status;
    assert!(!status.is_usable(), "{status:?}");
}

#[test]
fn whatever_comes_in_a_named_status_comes_out() {
    let mut admm = ProximalAdmm::default();
    for (name, problem) in degenerate() {
        let mut lambda = Vec::new();
        let outcome = admm.solve(&problem, &Options::default(), &mut lambda);
        println!("{name}: {} after {}", outcome.status.name(), outcome.iterations);
        assert!(lambda.iter().all(|l| l.is_finite()), "{name}");
        assert_eq!(problem.refusal().is_some(), outcome.status == Status::NotFinite, "{name}");
    }
    let large = stack(&[1.0; 70]).problem(0.5);
    assert_eq!(admm.solve(&large, &Options::default(), &mut Vec::new()).status, Status::TooLarge);
}
