//! W of the joints of a component, in the blocks of its plan.
//!
//! Of every node it is laid out first, in double precision, what its rows see of each body and what their impulses do
//! to it. A block between two nodes is then, over the bodies they share, the sum of products of small matrices, whose
//! elements in one row are computed side by side.

use super::Placed;
use super::elimination::{Elimination, by_size};
use super::row::SolverRow;
use crate::math::scalar::double;
use crate::solver::rows::Rows;

/// What the rows of each node see of its bodies, and do to them.
#[derive(Debug, Default)]
pub struct Blocks {
    sides: Vec<Side>,
    /// The sides of the node at each position; one place more at the end.
    first: Vec<usize>,
    /// Of each side six numbers for each row, row by row: what it sees of v and of ω.
    seen: Vec<f64>,
    /// Of each side six lists with a number for each row: what it does to v but for the inverse mass, and to ω.
    done: Vec<f64>,
}

/// A body that moves, of a node.
#[derive(Clone, Copy, Debug)]
struct Side {
    body: u32,
    inv_mass: f64,
    /// Where its numbers begin.
    at: usize,
}

impl Blocks {
    /// Bytes held.
    pub fn byte_count(&self) -> usize {
        self.sides.capacity() * size_of::<Side>()
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
        self.sides.clear();
        self.first.clear();
        self.seen.clear();
        self.done.clear();
        for (position, &node) in plan.order.iter().enumerate() {
            self.first.push(self.sides.len());
            let d = plan.dim(position);
            let own = &hard[plan.start(position)..][..d];
            let Some(&one) = own.first() else { continue };
            let count = solver_rows[one as usize].side_count();
            for (side, &body) in
                list[node as usize].body[..count].iter().enumerate().filter(|(_, b)| **b != 0)
            {
                let at = self.seen.len();
                self.sides.push(Side { body, inv_mass: double(rows.row[body as usize].inv_mass()), at });
                self.done.resize(at + 6 * d, 0.0);
                let done = &mut self.done[at..];
                for (r, &k) in own.iter().enumerate() {
                    let (seen, turn) = solver_rows[k as usize].exact_side(side, rows);
                    self.seen.extend_from_slice(&seen);
                    for e in 0..3 {
                        done[e * d + r] = seen[e];
                        done[(3 + e) * d + r] = turn[e];
                    }
                }
            }
        }
        self.first.push(self.sides.len());
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
        for a in &self.sides[self.first[k]..self.first[k + 1]] {
            for b in &self.sides[self.first[l]..self.first[l + 1]] {
                if a.body == b.body {
                    let (seen, done) = (&self.seen[a.at..], &self.done[b.at..]);
                    by_size!(d, d => add_products(block, seen, done, b.inv_mass, d));
                }
            }
        }
    }
}

/// Adds to a block of `d` columns what its rows see of what its columns do to one body.
#[inline(always)]
fn add_products(block: &mut [f64], seen: &[f64], done: &[f64], inv_mass: f64, d: usize) {
    let (linear, angular) = done[..6 * d].split_at(3 * d);
    let ([x, y, z], [u, v, w]) = (thirds(linear, d), thirds(angular, d));
    for (row, seen) in block.chunks_exact_mut(d).zip(seen.chunks_exact(6)) {
        for c in 0..d {
            let linear = seen[0] * x[c] + seen[1] * y[c] + seen[2] * z[c];
            let angular = seen[3] * u[c] + seen[4] * v[c] + seen[5] * w[c];
            row[c] += linear * inv_mass + angular;
        }
    }
}

/// Three lists of length `d` that stand one after the other.
#[inline(always)]
fn thirds(lists: &[f64], d: usize) -> [&[f64]; 3] {
    [&lists[..d], &lists[d..2 * d], &lists[2 * d..3 * d]]
}
