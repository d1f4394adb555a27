//! Dense linear algebra of the contact problem: what three solvers need, on plain slices that keep their memory.

/// Σ aᵢ bᵢ, in four partial sums: a fixed order, and four times the speed of one chain of additions.
#[inline]
#[must_use]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (fours_a, fours_b) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = fours_a.remainder().iter().zip(fours_b.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in fours_a.zip(fours_b) {
        for k in 0..4 {
            sums[k] += x[k] * y[k];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// y += k x.
#[inline]
pub fn add_scaled(y: &mut [f64], k: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += k * x;
    }
}

/// Factor L with A = L Lᵀ of a symmetric positive definite matrix of `n` rows; it takes the place of the lower half.
/// False where a pivot is not positive.
#[must_use]
pub fn cholesky(a: &mut [f64], n: usize) -> bool {
    for i in 0..n {
        let (above, row) = a.split_at_mut(i * n);
        let row = &mut row[..n];
        for j in 0..i {
            let other = &above[j * n..][..n];
            row[j] = (row[j] - dot(&row[..j], &other[..j])) / other[j];
        }
        let pivot = row[i] - dot(&row[..i], &row[..i]);
        if pivot.is_nan() || pivot <= 0.0 {
            return false;
        }
        row[i] = pivot.sqrt();
    }
    true
}

/// Solves L Lᵀ x = x in place; L stands in rows of length `stride`.
pub fn cholesky_solve(l: &[f64], stride: usize, x: &mut [f64]) {
    let n = x.len();
    for i in 0..n {
        x[i] = (x[i] - dot(&l[i * stride..][..i], &x[..i])) / l[i * stride + i];
    }
    for i in (0..n).rev() {
        let value = x[i] / l[i * stride + i];
        x[i] = value;
        add_scaled(&mut x[..i], -value, &l[i * stride..][..i]);
    }
}

/// Replaces a square matrix by its LU factors with row pivoting, noting the rows. False where it is singular.
#[must_use]
pub fn lu(a: &mut [f64], n: usize, rows: &mut Vec<usize>) -> bool {
    rows.clear();
    rows.extend(0..n);
    for k in 0..n {
        let best = (k..n).max_by(|&i, &j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs()).then(j.cmp(&i)));
        let p = best.unwrap_or(k);
        if a[p * n + k] == 0.0 || !a[p * n + k].is_finite() {
            return false;
        }
        if p != k {
            let (upper, lower) = a.split_at_mut(p * n);
            upper[k * n..][..n].swap_with_slice(&mut lower[..n]);
            rows.swap(k, p);
        }
        let (upper, lower) = a.split_at_mut((k + 1) * n);
        let pivot_row = &upper[k * n..][..n];
        for row in lower.chunks_exact_mut(n) {
            if row[k] != 0.0 {
                let factor = row[k] / pivot_row[k];
                row[k] = factor;
                add_scaled(&mut row[k + 1..], -factor, &pivot_row[k + 1..]);
            }
        }
    }
    true
}

/// Solves with the factors of [`lu`].
pub fn lu_solve(a: &[f64], n: usize, rows: &[usize], b: &[f64], x: &mut Vec<f64>) {
    x.clear();
    x.extend(rows.iter().map(|&r| b[r]));
    for i in 0..n {
        x[i] -= dot(&a[i * n..][..i], &x[..i]);
    }
    for i in (0..n).rev() {
        let row = &a[i * n..][..n];
        x[i] = (x[i] - dot(&row[i + 1..], &x[i + 1..])) / row[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(n: usize) -> Vec<f64> {
        let mut state = 7_u64;
        (0..n)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
            })
            .collect()
    }

    #[test]
    fn factors_solve_what_they_were_made_from() {
        for n in [1, 2, 5, 13, 30] {
            let (m, want) = (random(n * n), random(n));
            let times =
                |a: &[f64], x: &[f64]| -> Vec<f64> { (0..n).map(|i| dot(&a[i * n..][..n], x)).collect() };
            let near = |x: &[f64]| x.iter().zip(&want).all(|(a, b)| (a - b).abs() < 1e-9);

            let (mut factors, mut rows, mut x) = (m.clone(), Vec::new(), Vec::new());
            assert!(lu(&mut factors, n, &mut rows));
            lu_solve(&factors, n, &rows, &times(&m, &want), &mut x);
            assert!(near(&x), "LU of {n}");

            let mut spd = vec![0.0; n * n];
            for i in 0..n {
                for j in 0..n {
                    spd[i * n + j] = dot(&m[i * n..][..n], &m[j * n..][..n]) + if i == j { 0.1 } else { 0.0 };
                }
            }
            let mut x = times(&spd, &want);
            let mut factor = spd.clone();
            assert!(cholesky(&mut factor, n));
            cholesky_solve(&factor, n, &mut x);
            assert!(near(&x), "Cholesky of {n}");
        }
    }

    #[test]
    fn singular_and_broken_matrices_are_refused() {
        assert!(!cholesky(&mut [1.0, 1.0, 1.0, 1.0 - 1e-3], 2));
        assert!(!cholesky(&mut [f64::NAN], 1));
        assert!(!cholesky(&mut [0.0], 1));
        let mut rows = Vec::new();
        assert!(!lu(&mut [1.0, 2.0, 2.0, 4.0], 2, &mut rows));
        assert!(!lu(&mut [f64::NAN], 1, &mut rows));
    }
}
