//! Projected Gauss–Seidel on the dense problem, point by point with the true circular cone: the yardstick.
//!
//! A point's normal impulse makes its σ_n zero or becomes 0; then its friction makes σ_t zero where μ λ_n allows,
//! by the inverse of its 2×2 block, and is otherwise a step against σ_t of length 1/(the block's greatest
//! eigenvalue), cut to the disc: a fixed point of that slides straight against its friction.
//! [Jean 1999; Catto GDC09 for the order of things]

use super::{ContactProblem, Outcome, ROUGH, Status, V, dense, put_three, three};

/// Runs `iterations` sweeps from the impulses in `lambda` (zeros where its length does not fit), or fewer where the
/// residual falls below `tolerance` \[m/s\], which is looked at every eighth.
pub fn solve(problem: &ContactProblem, lambda: &mut Vec<f64>, iterations: usize, tolerance: f64) -> Outcome {
    let n = problem.size();
    if let Some(status) = problem.refusal() {
        lambda.clear();
        lambda.resize(n, 0.0);
        return Outcome::refused(status);
    }
    if lambda.len() != n {
        lambda.clear();
        lambda.resize(n, 0.0);
    }
    let mut done = 0;
    let mut residual = problem.residual(lambda);
    while done < iterations && residual > tolerance {
        for k in 0..problem.count() {
            visit(problem, lambda, k);
        }
        done += 1;
        if done % 8 == 0 || done == iterations {
            residual = problem.residual(lambda);
        }
    }
    let status = if residual <= tolerance {
        Status::Solved
    } else if residual <= ROUGH * problem.scale() {
        Status::Rough
    } else {
        Status::IterationLimit
    };
    Outcome { status, iterations: done, residual }
}

fn visit(problem: &ContactProblem, lambda: &mut [f64], k: usize) {
    let n = problem.size();
    let row = |r: usize| &problem.w[(3 * k + r) * n..][..n];
    let at = |r: usize, c: usize| row(r)[3 * k + c];
    let mut l: V = three(lambda, k);
    let (wn, b) = (at(0, 0), &problem.b[3 * k..]);
    if wn > 0.0 {
        l.x = (l.x - (b[0] + dense::dot(row(0), lambda)) / wn).max(0.0);
        lambda[3 * k] = l.x;
    }
    let limit = problem.friction(k) * l.x;
    let (k11, k12, k22) = (at(1, 1), at(1, 2), at(2, 2));
    if k11 + k22 > 0.0 {
        let s = [b[1] + dense::dot(row(1), lambda), b[2] + dense::dot(row(2), lambda)];
        let t = friction_step([l.y, l.z], s, [k11, k12, k22], limit);
        (l.y, l.z) = (t[0], t[1]);
        put_three(lambda, k, &l);
    }
}

/// New friction from the present one, the tangential velocity, the block (11, 12, 22) and the greatest length.
#[must_use]
pub fn friction_step(l: [f64; 2], s: [f64; 2], [k11, k12, k22]: [f64; 3], limit: f64) -> [f64; 2] {
    let det = k11 * k22 - k12 * k12;
    if det > 1e-14 * k11 * k22 {
        let t = [l[0] - (k22 * s[0] - k12 * s[1]) / det, l[1] - (k11 * s[1] - k12 * s[0]) / det];
        if t[0] * t[0] + t[1] * t[1] <= limit * limit {
            return t;
        }
    }
    let half = 0.5 * (k11 - k22);
    let greatest = 0.5 * (k11 + k22) + (half * half + k12 * k12).sqrt();
    let t = [l[0] - s[0] / greatest, l[1] - s[1] / greatest];
    let length = (t[0] * t[0] + t[1] * t[1]).sqrt();
    let cut = if length > limit { limit / length } else { 1.0 };
    [t[0] * cut, t[1] * cut]
}
