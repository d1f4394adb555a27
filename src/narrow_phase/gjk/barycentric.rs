//! The point of a simplex closest to the origin by barycentric coordinates: the oracle of this room.
//!
//! For points A₁ … Aₙ₊₁ in any dimension the point P = Aₙ₊₁ + Σ tᵢ Aᵢ′ with Aᵢ′ = Aᵢ − Aₙ₊₁ of least |P|² solves
//! Σⱼ (Aᵢ′·Aⱼ′) tⱼ = −Aₙ₊₁·Aᵢ′, and Σ tᵢ = 1. Where the matrix is singular, every sub-simplex is tried; where a
//! coordinate is negative, those without one of the negative vertices are.
//!
//! The products square the condition of the simplex. Where they leave few digits, the same least-squares problem is
//! solved once more by orthogonalising the Aᵢ′, and all faces are looked at whatever the signs say.

use super::simplex::{Best, Simplex, SubAlgorithm, Weights};
use crate::shape::Wide;

pub(super) struct Barycentric;

impl SubAlgorithm for Barycentric {
    fn weights(s: &Simplex) -> Weights {
        closest(s, &[0, 1, 2, 3][..s.len()])
    }
}

/// Pivots below this share of the greatest leave the solution too few digits.
const DOUBT: f64 = 1e-6;

/// The orthogonalised edges below this share of their length are rounding: the simplex is flat.
const SINGULAR: f64 = 1e-13;

/// What is known of the point closest to the origin in the span of a simplex.
enum Solution {
    /// The coordinates have digits to spare.
    Clear(Weights),
    /// They may be wrong, perhaps in sign.
    Doubtful(Weights),
    /// The vertices span less than they should.
    Singular,
}

/// The weights of the closest point of the sub-simplex of these vertices.
fn closest(s: &Simplex, members: &[usize]) -> Weights {
    let mut best = Best::new();
    match members {
        [only] => {
            let mut weight = [0.0; 4];
            weight[*only] = 1.0;
            return weight;
        }
        _ => match solve(s, members) {
            Solution::Clear(t) if members.iter().all(|&i| t[i] >= 0.0) => return t,
            Solution::Clear(t) => descend(s, members, |i| t[i] < 0.0, &mut best),
            Solution::Doubtful(t) => {
                if members.iter().all(|&i| t[i] >= 0.0) {
                    best.offer(s, t);
                }
                descend(s, members, |_| true, &mut best);
            }
            Solution::Singular => descend(s, members, |_| true, &mut best),
        },
    }
    best.weight
}

/// Offers the closest points of the sub-simplices that lack one of the vertices that `leaves`.
fn descend(s: &Simplex, members: &[usize], leaves: impl Fn(usize) -> bool, best: &mut Best) {
    for &out in members.iter().filter(|&&i| leaves(i)) {
        let (mut rest, mut n) = ([0; 4], 0);
        for &i in members.iter().filter(|&&i| i != out) {
            rest[n] = i;
            n += 1;
        }
        best.offer(s, closest(s, &rest[..n]));
    }
}

/// The coordinates of the closest point of the span of these vertices.
fn solve(s: &Simplex, members: &[usize]) -> Solution {
    let n = members.len() - 1;
    let last = s.w(members[n]);
    let mut edges = [Wide::zeros(); 3];
    let mut size: f64 = 0.0;
    for (e, &i) in edges.iter_mut().zip(&members[..n]) {
        *e = s.w(i) - last;
        size = size.max(e.amax());
    }
    if size <= 0.0 || !size.is_normal() {
        return Solution::Singular;
    }
    let edges = edges.map(|e| e / size);
    let last = last / size;
    let spread = |t: [f64; 4]| {
        let mut weight = [0.0; 4];
        members.iter().zip(t).for_each(|(&i, t)| weight[i] = t);
        weight
    };
    match by_products(&edges[..n], &last) {
        Some(t) => Solution::Clear(spread(t)),
        None => match by_orthogonal_edges(&edges[..n], &last) {
            Some(t) => Solution::Doubtful(spread(t)),
            None => Solution::Singular,
        },
    }
}

/// Solves the n + 1 equations by elimination with row exchanges; `None` where the pivots are small.
fn by_products(edges: &[Wide], last: &Wide) -> Option<[f64; 4]> {
    let n = edges.len();
    let mut m = [[0.0; 5]; 4];
    for (row, a) in m.iter_mut().zip(edges) {
        for (x, b) in row.iter_mut().zip(edges) {
            *x = a.dot(b);
        }
        row[4] = -last.dot(a);
    }
    for x in &mut m[n][..=n] {
        *x = 1.0;
    }
    m[n][4] = 1.0;
    let mut greatest: f64 = 0.0;
    for k in 0..=n {
        let p = (k..=n).fold(k, |p, i| if m[i][k].abs() > m[p][k].abs() { i } else { p });
        m.swap(k, p);
        let pivot = m[k][k];
        greatest = greatest.max(pivot.abs());
        if pivot.abs() <= DOUBT * greatest {
            return None;
        }
        for i in k + 1..=n {
            let f = m[i][k] / pivot;
            let upper = m[k];
            for (x, y) in m[i].iter_mut().zip(upper).skip(k) {
                *x -= f * y;
            }
        }
    }
    let mut t = [0.0; 4];
    for k in (0..=n).rev() {
        let sum: f64 = (k + 1..=n).map(|j| m[k][j] * t[j]).sum();
        t[k] = (m[k][4] - sum) / m[k][k];
    }
    Some(t)
}

/// Solves the same problem from orthogonal directions that span the edges, the longest rest first.
fn by_orthogonal_edges(edges: &[Wide], last: &Wide) -> Option<[f64; 4]> {
    let n = edges.len();
    let mut rest = [Wide::zeros(); 3];
    rest[..n].copy_from_slice(edges);
    let mut order = [0, 1, 2];
    let (mut q, mut r) = ([Wide::zeros(); 3], [[0.0; 3]; 3]);
    for k in 0..n {
        let p = (k..n).fold(k, |p, i| if rest[order[i]].norm() > rest[order[p]].norm() { i } else { p });
        order.swap(k, p);
        let e = edges[order[k]];
        let mut left = rest[order[k]];
        // Once more against the directions before: rounding has brought back some of them.
        for d in &q[..k] {
            left -= d * d.dot(&left);
        }
        let length = left.norm();
        if length <= SINGULAR * e.norm() {
            return None;
        }
        q[k] = left / length;
        for i in k + 1..n {
            let x = &mut rest[order[i]];
            *x -= q[k] * q[k].dot(x);
        }
    }
    for k in 0..n {
        for i in k..n {
            r[k][i] = q[k].dot(&edges[order[i]]);
        }
    }
    let mut t = [0.0; 4];
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|i| r[k][i] * t[order[i]]).sum();
        t[order[k]] = (-q[k].dot(last) - sum) / r[k][k];
    }
    t[n] = 1.0 - t[..n].iter().sum::<f64>();
    Some(t)
}
