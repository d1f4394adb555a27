use super::super::contact_problem::testing::{self, *};
use super::super::contact_problem::{tangent_length, three};
use super::*;

fn solved(problem: &ContactProblem, facets: usize) -> Vec<f64> {
    let mut lambda = Vec::new();
    let outcome = Dantzig::default().solve(problem, facets, &mut lambda);
    assert!(outcome.status.is_usable(), "{outcome:?}");
    lambda
}

fn velocities(problem: &ContactProblem, lambda: &[f64]) -> Vec<f64> {
    let mut sigma = Vec::new();
    problem.velocity(lambda, &mut sigma);
    sigma
}

#[test]
fn a_block_on_a_slope_sticks_or_slides_by_its_angle() {
    for facets in [4, 8, 16] {
        let problem = slope(0.45).problem(0.5);
        let lambda = solved(&problem, facets);
        assert!(velocities(&problem, &lambda).iter().all(|s| s.abs() < 1e-8), "{facets} facets stick");
    }
}

#[test]
fn sliding_is_the_closed_form_of_the_polygon() {
    // Downhill is a corner of the polygon.
    for facets in [4_usize, 6, 8] {
        let problem = slope(0.55).problem(0.5);
        let sigma = velocities(&problem, &solved(&problem, facets));
        let downhill = FALL * 0.05 / (1.0_f64 + 0.55 * 0.55).sqrt();
        for k in 0..4 {
            let along = tangent_length(&three(&sigma, k));
            assert!((along - downhill).abs() < 1e-6, "{facets} facets: {along} instead of {downhill}");
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
                assert!((g / w - 1.0).abs() < 1e-5, "{masses:?} {mu}: {got:?} instead of {want:?}");
            }
        }
    }
}

#[test]
fn a_stack_of_50_is_exact_without_friction() {
    let problem = stack(&[1.0; 50]).problem(0.0);
    let lambda = solved(&problem, 8);
    for (i, got) in interfaces(&lambda).into_iter().enumerate() {
        let want = (50 - i) as f64 * FALL;
        assert!((got / want - 1.0).abs() < 1e-8, "interface {i}: {got} instead of {want}");
    }
}

#[test]
fn frictionless_problems_agree_with_the_oracle() {
    let mut random = Random(6);
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
fn bounds_of_any_kind_are_kept_and_w_has_the_signs_they_ask() {
    let mut random = Random(7);
    for round in 0..200 {
        let n = 1 + random.below(20);
        let rank = 1 + random.below(n);
        let half: Vec<f64> = (0..n * rank).map(|_| random.within(-1.0, 1.0)).collect();
        let mut a = vec![0.0; n * n];
        for i in 0..n {
            for j in 0..n {
                a[i * n + j] = dense::dot(&half[i * rank..][..rank], &half[j * rank..][..rank]);
            }
        }
        // b in the range of A: unbounded rows have a solution then.
        let v: Vec<f64> = (0..n).map(|_| random.within(-1.0, 1.0)).collect();
        let b: Vec<f64> = (0..n).map(|i| dense::dot(&a[i * n..][..n], &v)).collect();
        let mut bound = || match random.below(3) {
            0 => 0.0,
            1 => random.within(0.0, 0.7),
            _ => f64::INFINITY,
        };
        let lo: Vec<f64> = (0..n).map(|_| -bound()).collect();
        let hi: Vec<f64> = (0..n).map(|_| bound()).collect();
        let mut dantzig = Dantzig::default();
        let outcome = dantzig.bounded(&a, &b, &lo, &hi);
        assert!(outcome.status.is_usable(), "round {round}: {outcome:?}");
        for i in 0..n {
            let x = dantzig.solution()[i];
            let w = b[i] + dense::dot(&a[i * n..][..n], dantzig.solution());
            assert!(x >= lo[i] && x <= hi[i]);
            let off = x - (x - w).clamp(lo[i], hi[i]);
            assert!(off.abs() < 1e-6, "round {round}, row {i}: x {x}, w {w}, {} … {}", lo[i], hi[i]);
        }
    }
}

#[test]
fn friction_polygons_agree_with_the_oracle_at_the_load_they_found() {
    let mut random = Random(8);
    let (mut settled, rounds) = (0, 30);
    for round in 0..rounds {
        let facets = [4, 6, 8][round % 3];
        let (bodies, points) = (1 + random.below(4), 1 + random.below(8));
        let problem = testing::random(&mut random, bodies, points, 1.0).problem(random.within(0.1, 0.6));
        let mut lambda = Vec::new();
        let outcome = Dantzig::default().solve(&problem, facets, &mut lambda);
        if outcome.status != Status::Solved {
            println!("round {round}: {}", outcome.status.name());
            continue;
        }
        settled += 1;
        let radius: Vec<f64> = (0..points).map(|k| problem.friction(k) * lambda[3 * k]).collect();
        let (sigma, _) = oracle(&problem, &problem.b, &Rule::Prism(facets, &radius));
        let off = velocity_error(&problem, &lambda, &sigma);
        assert!(off < 1e-5, "round {round}: velocities differ by {off:e}");
    }
    println!("{settled} of {rounds} settled");
    assert!(settled * 10 >= rounds * 7, "only {settled} of {rounds} settled");
}

#[test]
fn what_has_no_solution_says_so() {
    let wedge = degenerate().into_iter().find(|(name, _)| *name == "wedged").unwrap().1;
    let status = Dantzig::default().solve(&wedge, 8, &mut Vec::new()).status;
    assert!(!status.is_usable(), "{status:?}");
}

#[test]
fn whatever_comes_in_a_named_status_comes_out() {
    let mut dantzig = Dantzig::default();
    for (name, problem) in degenerate() {
        let mut lambda = Vec::new();
        let outcome = dantzig.solve(&problem, 8, &mut lambda);
        println!("{name}: {} after {}", outcome.status.name(), outcome.iterations);
        assert!(lambda.iter().all(|l| l.is_finite()), "{name}");
        assert_eq!(problem.refusal().is_some(), outcome.status == Status::NotFinite, "{name}");
    }
    let large = stack(&[1.0; 60]).problem(0.5);
    assert_eq!(dantzig.solve(&large, 8, &mut Vec::new()).status, Status::TooLarge);
}

/// Gaps are measured with rounding, so what touches at four corners is asked for slightly different velocities.
#[test]
fn noise_in_hyperstatic_contacts_does_no_harm() {
    let mut random = Random(12);
    let (mut failed, mut lambda) = (0, Vec::new());
    let mut dantzig = Dantzig::default();
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
        let outcome = dantzig.solve(&problem, 8, &mut lambda);
        if !outcome.status.is_usable() {
            println!("noise {noise:e}, {rounding:e}: {outcome:?}");
            failed += 1;
        }
    }
    assert_eq!(failed, 0);
}
