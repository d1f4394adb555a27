//! W of the joints of a component, in the blocks of its plan.
//!
//! Of every node it is laid out first, in double precision, what its rows see of each body and what their impulses do
//! to it. A block between two nodes is then, over the bodies they share, the sum of products of small matrices, whose
//! elements in one row are computed side by side.

use super::Placed;
use super::elimination::{Elimination, by_size};
use super::row::SolverRow;
use crate::constraint::joint::Side;
use crate::math::scalar::double;
use crate::solver::rows::{ExactInertia, Rows};

/// What the rows of each node see of its bodies, and do to them.
#[derive(Debug, Default)]
pub struct Blocks {
    moving: Vec<Moving>,
    /// Those of the node at each position; one place more at the end.
    first: Vec<usize>,
    /// Of each side six numbers for each row, row by row: what it sees of v and of ω.
    seen: Vec<f64>,
    /// Of each side six lists with a number for each row: what it does to v but for the inverse mass, and to ω. The
    /// lists have an even length.
    done: Vec<f64>,
}

/// A body that moves, of a node.
#[derive(Clone, Copy, Debug)]
struct Moving {
    body: u32,
    inv_mass: f64,
    /// Where its numbers begin.
    seen: usize,
    done: usize,
}

impl Blocks {
    /// Bytes held.
    pub fn byte_count(&self) -> usize {
        self.moving.capacity() * size_of::<Moving>()
            + (self.first.capacity() + self.seen.capacity() + self.done.capacity()) * 8
    }

    /// Lays the nodes of a component out: `hard` are its unbounded rows in the order of the plan.
    pub fn lay_out(
        &mut self,
        plan: &Elimination,
        list: &[Placed],
        hard: &[u32],
        solver_rows: &[SolverRow],
        rows: &Rows,
    ) {
        self.moving.clear();
        self.first.clear();
        let (mut seen_end, mut done_end) = (0, 0);
        for (position, &node) in plan.order.iter().enumerate() {
            self.first.push(self.moving.len());
            let d = plan.dim(position);
            let own = &hard[plan.start(position)..][..d];
            let Some(&one) = own.first() else { continue };
            for side in 0..solver_rows[one as usize].side_count() {
                let body = list[node as usize].body[side];
                if body == 0 {
                    continue;
                }
                let inv_mass = double(rows.row[body as usize].inv_mass());
                self.moving.push(Moving { body, inv_mass, seen: seen_end, done: done_end });
                let seen = take(&mut self.seen, &mut seen_end, 6 * d);
                let done = take(&mut self.done, &mut done_end, 6 * even(d));
                let inertia = rows.inertia[body as usize].exact();
                let own = own.iter().map(|&k| solver_rows[k as usize].side(side));
                by_size!(d, d => lay_out_side(own, &inertia, seen, done, d));
            }
        }
        self.first.push(self.moving.len());
    }

    /// Fills the blocks on the diagonal and below it. What is 0 must be so before.
    pub fn fill(&self, plan: &Elimination, w: &mut [f64]) {
        for position in 0..plan.order.len() {
            let (d, at) = (plan.dim(position), plan.diagonal(position));
            self.add(position, position, d, &mut w[at..at + d * d]);
        }
        for (k, l, at) in plan.blocks() {
            let d = plan.dim(l);
            self.add(k, l, d, &mut w[at..at + plan.dim(k) * d]);
        }
    }

    /// Adds what the nodes `k` and `l`, which has `d` rows, have to do with each other.
    fn add(&self, k: usize, l: usize, d: usize, block: &mut [f64]) {
        for a in &self.moving[self.first[k]..self.first[k + 1]] {
            for b in &self.moving[self.first[l]..self.first[l + 1]] {
                if a.body == b.body {
                    let (seen, done) = (&self.seen[a.seen..], &self.done[b.done..]);
                    by_size!(d, d => add_products(block, seen, done, b.inv_mass, d));
                }
            }
        }
    }
}

/// The next even number.
#[inline(always)]
fn even(d: usize) -> usize {
    d + d % 2
}

/// The next `count` numbers of a list that is only ever made longer, whatever they were.
fn take<'a>(list: &'a mut Vec<f64>, end: &mut usize, count: usize) -> &'a mut [f64] {
    let start = *end;
    *end += count;
    if list.len() < *end {
        list.resize(*end, 0.0);
    }
    &mut list[start..*end]
}

/// Lays out what `d` rows see of a body with this inverse inertia, and do to it.
#[inline(always)]
fn lay_out_side<'a>(
    own: impl Iterator<Item = &'a Side>,
    inertia: &ExactInertia,
    seen: &mut [f64],
    done: &mut [f64],
    d: usize,
) {
    let done = &mut done[..6 * even(d)];
    for (r, (Side { linear, angular }, seen)) in own.zip(seen.chunks_exact_mut(6)).take(d).enumerate() {
        let (linear, angular) = ([0, 1, 2].map(|e| double(linear[e])), [0, 1, 2].map(|e| double(angular[e])));
        let turn = inertia.times(angular);
        for e in 0..3 {
            seen[e] = linear[e];
            seen[3 + e] = angular[e];
            done[e * even(d) + r] = linear[e];
            done[(3 + e) * even(d) + r] = turn[e];
        }
    }
}

/// Adds to a block of `d` columns what its rows see of what its columns do to one body, two columns side by side.
#[inline(always)]
fn add_products(block: &mut [f64], seen: &[f64], done: &[f64], inv_mass: f64, d: usize) {
    let done = &done[..6 * even(d)];
    for (row, seen) in block.chunks_exact_mut(d).zip(seen.chunks_exact(6)) {
        for c in (0..d).step_by(2) {
            let two = |e: usize| [done[e * even(d) + c], done[e * even(d) + c + 1]];
            let [x, y, z, u, v, w] = [two(0), two(1), two(2), two(3), two(4), two(5)];
            let product = |i: usize| {
                let linear = seen[0] * x[i] + seen[1] * y[i] + seen[2] * z[i];
                let angular = seen[3] * u[i] + seen[4] * v[i] + seen[5] * w[i];
                linear * inv_mass + angular
            };
            row[c] += product(0);
            if c + 1 < d {
                row[c + 1] += product(1);
            }
        }
    }
}
