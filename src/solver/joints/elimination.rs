//! Solves the hard rows of joints that hang together all at once.
//!
//! The system is W λ = r with W = J M⁻¹ Jᵀ, in blocks: one node for each joint, and a block between two joints that
//! share a moving body. It is factored W = L Lᵀ by block Cholesky, in an order chosen once per topology: always the
//! joint that leaves the fewest new blocks (minimum degree). A chain or a tree fills nothing, so its cost grows with
//! the number of joints; where loops would fill too much there is no plan, and the joints are solved one by one.
//!
//! Redundant rows (a closed planar loop, two joints on one pair) make W singular: their pivots vanish but for
//! rounding. Such a pivot is put back to the size it had before elimination, which keeps the redundant impulse where
//! it is and leaves the others right.
//!
//! What is done to a block is written once for every number of rows, and compiled for the usual ones apart (see
//! [`by_size`]): loops of known length.

use std::ops::Range;

/// A plan is made only if a factorization takes at most so many multiplications for each joint, and in all.
const MOST_PER_JOINT: u64 = 12_000;
const MOST: u64 = 400_000;

/// Below this share of its least part before elimination a pivot belongs to a row that others have made redundant, or soon
/// will (bars that come to lie in one line): taken at its word it would push with thousands of newtons against what
/// rounding left of its error.
const REDUNDANT: f64 = 2e-3;

/// Below this share of itself before elimination a pivot is what rounding left.
const ROUNDING: f64 = 1e-12;

/// Evaluates an expression with a number of rows, known when it is compiled for those that most joints have.
macro_rules! by_size {
    (@ $d:expr, $size:ident => $result:expr) => {{
        let $size: usize = $d;
        $result
    }};
    ($d:expr, $size:ident => $result:expr) => {
        match $d {
            1 => by_size!(@ 1, $size => $result),
            3 => by_size!(@ 3, $size => $result),
            5 => by_size!(@ 5, $size => $result),
            6 => by_size!(@ 6, $size => $result),
            other => by_size!(@ other, $size => $result),
        }
    };
}
pub(super) use by_size;

/// What is known from the topology alone.
#[derive(Clone, Debug, Default)]
pub struct Elimination {
    /// Nodes in order of elimination.
    pub order: Vec<u32>,
    /// By position.
    nodes: Vec<Node>,
    /// Their later neighbours, one node after the other.
    later: Vec<Later>,
    /// Where the blocks are that the elimination of a node changes, one for each pair of its later neighbours.
    targets: Vec<usize>,
    values: usize,
    unknowns: usize,
}

/// A node at its position.
#[derive(Clone, Debug)]
struct Node {
    /// How many rows it has.
    dim: usize,
    /// Where its unknowns begin.
    start: usize,
    /// Where its diagonal block is. These come first of all.
    diagonal: usize,
    /// Where its blocks with its later neighbours are.
    column: Range<usize>,
    /// Those neighbours in the list.
    later: Range<usize>,
    /// The targets in the list.
    targets: Range<usize>,
}

/// A later neighbour of a node, and their block.
#[derive(Clone, Copy, Debug)]
struct Later {
    position: usize,
    dim: usize,
    start: usize,
    /// Where the block is; its rows are those of the later node.
    block: usize,
}

impl Elimination {
    /// A plan for nodes of these dimensions with these edges; `None` where it would cost too much.
    #[must_use]
    pub fn plan(dims: &[usize], edges: &[(u32, u32)]) -> Option<Self> {
        let n = dims.len();
        let mut near: Vec<Vec<u32>> = vec![Vec::new(); n];
        for &(a, b) in edges {
            if a != b && !near[a as usize].contains(&b) {
                near[a as usize].push(b);
                near[b as usize].push(a);
            }
        }
        let limit = MOST.min(MOST_PER_JOINT * n as u64).max(MOST_PER_JOINT);
        let mut position = vec![usize::MAX; n];
        let (mut order, mut later_nodes, mut cost) = (Vec::with_capacity(n), Vec::with_capacity(n), 0u64);
        let weight = |near: &[Vec<u32>], v: usize| near[v].iter().map(|&u| dims[u as usize]).sum::<usize>();
        for step in 0..n {
            let next = (0..n)
                .filter(|&v| position[v] == usize::MAX)
                .min_by_key(|&v| (weight(&near, v), v))
                .expect("a node is left");
            let w = weight(&near, next) as u64;
            let d = dims[next] as u64;
            cost += d * d * d + d * d * w + d * w * w;
            if cost > limit {
                return None;
            }
            position[next] = step;
            order.push(next as u32);
            let mut left = std::mem::take(&mut near[next]);
            left.sort_unstable();
            for &u in &left {
                near[u as usize].retain(|&v| v as usize != next);
                for &v in &left {
                    if u != v && !near[u as usize].contains(&v) {
                        near[u as usize].push(v);
                    }
                }
            }
            later_nodes.push(left);
        }
        let mut plan = Self { order, ..Self::default() };
        for &node in &plan.order {
            let dim = dims[node as usize];
            let (start, diagonal) = (plan.unknowns, plan.values);
            plan.nodes.push(Node { dim, start, diagonal, column: 0..0, later: 0..0, targets: 0..0 });
            plan.unknowns += dim;
            plan.values += dim * dim;
        }
        for (i, nodes) in later_nodes.iter().enumerate() {
            let mut list: Vec<usize> = nodes.iter().map(|&v| position[v as usize]).collect();
            list.sort_unstable();
            let (column, first) = (plan.values, plan.later.len());
            for k in list {
                let Node { dim, start, .. } = plan.nodes[k];
                plan.later.push(Later { position: k, dim, start, block: plan.values });
                plan.values += dim * plan.nodes[i].dim;
            }
            plan.nodes[i].column = column..plan.values;
            plan.nodes[i].later = first..plan.later.len();
        }
        for i in 0..n {
            let first = plan.targets.len();
            for a in plan.nodes[i].later.clone() {
                for b in plan.nodes[i].later.start..=a {
                    plan.targets.push(plan.block(plan.later[a].position, plan.later[b].position));
                }
            }
            plan.nodes[i].targets = first..plan.targets.len();
        }
        Some(plan)
    }

    /// How many unknowns there are.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// How many numbers the factor takes.
    #[must_use]
    pub fn values(&self) -> usize {
        self.values
    }

    /// Where the unknowns of the node at a position begin.
    #[must_use]
    pub fn start(&self, position: usize) -> usize {
        self.nodes[position].start
    }

    /// Where block (k, l) is, k ≥ l being positions; its rows are those of k.
    fn block(&self, k: usize, l: usize) -> usize {
        if k == l {
            return self.nodes[k].diagonal;
        }
        let list = &self.later[self.nodes[l].later.clone()];
        let at = list.binary_search_by_key(&k, |e| e.position).expect("fill was planned for");
        list[at].block
    }

    /// The pairs of positions whose block of W may be other than zero, k > l, with where it is.
    pub fn blocks(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        self.nodes.iter().enumerate().flat_map(|(l, node)| {
            self.later[node.later.clone()].iter().map(move |later| (later.position, l, later.block))
        })
    }

    /// How many rows the node at a position has.
    #[must_use]
    pub fn dim(&self, position: usize) -> usize {
        self.nodes[position].dim
    }

    /// Where the diagonal block of a position is.
    #[must_use]
    pub fn diagonal(&self, position: usize) -> usize {
        self.nodes[position].diagonal
    }

    /// Factors W in place: its lower blocks stand in `w` (rows of the later position first), its diagonal in `size`, and in
    /// `least` about what is left of that at least, unless the row is redundant.
    pub fn factor(&self, w: &mut [f64], size: &[f64], least: &[f64]) {
        for node in self.nodes.iter().filter(|node| node.dim > 0) {
            by_size!(node.dim, d => self.eliminate(node, d, w, size, least));
        }
    }

    /// Takes a node with `d` rows out of the system.
    #[inline(always)]
    fn eliminate(&self, node: &Node, d: usize, w: &mut [f64], size: &[f64], least: &[f64]) {
        let own = node.start..node.start + d;
        let (before, after) = w.split_at_mut(node.column.end);
        let (before, column) = before.split_at_mut(node.column.start);
        let diagonal = &mut before[node.diagonal..][..d * d];
        cholesky(diagonal, d, &size[own.clone()], &least[own]);
        // L_ki = A_ki C⁻ᵀ.
        for row in column.chunks_exact_mut(d) {
            for c in 0..d {
                let mut sum = row[c];
                for e in 0..c {
                    sum -= row[e] * diagonal[c * d + e];
                }
                row[c] = sum / diagonal[c * d + c];
            }
        }
        let later = &self.later[node.later.clone()];
        let mut targets = self.targets[node.targets.clone()].iter();
        for (a, k) in later.iter().enumerate() {
            let rows_k = &column[k.block - node.column.start..][..k.dim * d];
            for (b, l) in later[..=a].iter().enumerate() {
                let rows_l = &column[l.block - node.column.start..][..l.dim * d];
                let &target = targets.next().expect("one for each pair");
                if a == b {
                    // Of a block on the diagonal the lower half is all that counts.
                    let target = &mut before[target..][..k.dim * k.dim];
                    for (r, row) in rows_k.chunks_exact(d).enumerate() {
                        subtract_products(&mut target[r * k.dim..][..=r], row, rows_l, d);
                    }
                } else {
                    let target = &mut after[target - node.column.end..][..k.dim * l.dim];
                    for (r, row) in rows_k.chunks_exact(d).enumerate() {
                        subtract_products(&mut target[r * l.dim..][..l.dim], row, rows_l, d);
                    }
                }
            }
        }
    }

    /// Solves for the right-hand side `x`, by position, in place.
    pub fn solve(&self, w: &[f64], x: &mut [f64]) {
        for node in self.nodes.iter().filter(|node| node.dim > 0) {
            by_size!(node.dim, d => self.solve_forward(node, d, w, x));
        }
        for node in self.nodes.iter().rev().filter(|node| node.dim > 0) {
            by_size!(node.dim, d => self.solve_back(node, d, w, x));
        }
    }

    /// Finds the part of L⁻¹ x of a node with `d` rows, and takes what it does from those of its later neighbours.
    #[inline(always)]
    fn solve_forward(&self, node: &Node, d: usize, w: &[f64], x: &mut [f64]) {
        let (x, after) = x.split_at_mut(node.start + d);
        let x = &mut x[node.start..];
        forward(&w[node.diagonal..][..d * d], d, x);
        for later in &self.later[node.later.clone()] {
            let block = &w[later.block..][..later.dim * d];
            let there = &mut after[later.start - node.start - d..][..later.dim];
            subtract_products(there, x, block, d);
        }
    }

    /// Finds the part of L⁻ᵀ x of a node with `d` rows from those of its later neighbours.
    #[inline(always)]
    fn solve_back(&self, node: &Node, d: usize, w: &[f64], x: &mut [f64]) {
        let (x, after) = x.split_at_mut(node.start + d);
        let x = &mut x[node.start..];
        for later in &self.later[node.later.clone()] {
            let block = &w[later.block..][..later.dim * d];
            let there = &after[later.start - node.start - d..][..later.dim];
            for (row, xk) in block.chunks_exact(d).zip(there) {
                for e in 0..d {
                    x[e] -= row[e] * xk;
                }
            }
        }
        back(&w[node.diagonal..][..d * d], d, x);
    }
}

/// Solves one dense system in place: W in its lower triangle, its diagonal in `size`, the right-hand side in `x`.
pub fn solve_dense(w: &mut [f64], size: &[f64], x: &mut [f64]) {
    let d = size.len();
    cholesky(w, d, size, size);
    forward(w, d, x);
    back(w, d, x);
}

/// Of each of the rows of length `d` takes its product with `row` from one of the numbers.
#[inline(always)]
fn subtract_products(numbers: &mut [f64], row: &[f64], rows: &[f64], d: usize) {
    for (number, other) in numbers.iter_mut().zip(rows.chunks_exact(d)) {
        let mut sum = 0.0;
        for e in 0..d {
            sum += row[e] * other[e];
        }
        *number -= sum;
    }
}

/// x ← L⁻¹ x for the lower triangle L of a d × d block.
#[inline(always)]
fn forward(l: &[f64], d: usize, x: &mut [f64]) {
    for r in 0..d {
        let mut sum = x[r];
        for e in 0..r {
            sum -= l[r * d + e] * x[e];
        }
        x[r] = sum / l[r * d + r];
    }
}

/// x ← L⁻ᵀ x.
#[inline(always)]
fn back(l: &[f64], d: usize, x: &mut [f64]) {
    for r in (0..d).rev() {
        let mut sum = x[r];
        for e in r + 1..d {
            sum -= l[e * d + r] * x[e];
        }
        x[r] = sum / l[r * d + r];
    }
}

/// The Cholesky factor of a d × d block, in place in its lower triangle; see [`Elimination::factor`].
#[inline(always)]
fn cholesky(a: &mut [f64], d: usize, size: &[f64], least: &[f64]) {
    for c in 0..d {
        let mut pivot = a[c * d + c];
        for e in 0..c {
            pivot -= a[c * d + e] * a[c * d + e];
        }
        if pivot <= REDUNDANT * least[c] || pivot <= ROUNDING * size[c] {
            pivot = if size[c] > 0.0 { size[c] } else { 1.0 };
        }
        let root = pivot.sqrt();
        a[c * d + c] = root;
        for r in c + 1..d {
            let mut sum = a[r * d + c];
            for e in 0..c {
                sum -= a[r * d + e] * a[c * d + e];
            }
            a[r * d + c] = sum / root;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::scalar::double;
    use crate::shape::testing::Random;

    /// A random system W = J M⁻¹ Jᵀ over joints between bodies, with its plan; returns the greatest residual of a
    /// solution, relative to the right-hand side.
    fn residual(joints: &[(u32, u32)], dims: &[usize], double_last: bool) -> f64 {
        let bodies = joints.iter().map(|j| j.0.max(j.1)).max().unwrap() as usize + 1;
        let mut random = Random(5);
        let mut edges = Vec::new();
        for (i, a) in joints.iter().enumerate() {
            for (j, b) in joints.iter().enumerate().skip(i + 1) {
                // Body 0 does not move.
                if [a.0, a.1].iter().any(|x| *x != 0 && (*x == b.0 || *x == b.1)) {
                    edges.push((i as u32, j as u32));
                }
            }
        }
        let plan = Elimination::plan(dims, &edges).expect("small");
        let mut rows: Vec<Vec<Vec<f64>>> = Vec::new();
        for (i, &(a, b)) in joints.iter().enumerate() {
            let mut block = vec![vec![0.0; 6 * bodies]; dims[i]];
            for row in &mut block {
                for body in [a, b].into_iter().filter(|&x| x != 0) {
                    for k in 0..6 {
                        row[6 * body as usize + k] = double(random.vec(1.0).x);
                    }
                }
            }
            rows.push(block);
        }
        if double_last {
            let last = rows.len() - 1;
            rows[last] = rows[last - 1].clone();
        }
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let mut w = vec![0.0; plan.values()];
        let mut size = vec![0.0; plan.unknowns()];
        let node = |position: usize| plan.order[position] as usize;
        for p in 0..joints.len() {
            let block = &rows[node(p)];
            for r in 0..block.len() {
                for c in 0..block.len() {
                    w[plan.diagonal(p) + r * block.len() + c] = dot(&block[r], &block[c]);
                }
                size[plan.start(p) + r] = dot(&block[r], &block[r]);
            }
        }
        for (k, l, at) in plan.blocks() {
            for r in 0..rows[node(k)].len() {
                for c in 0..rows[node(l)].len() {
                    w[at + r * rows[node(l)].len() + c] = dot(&rows[node(k)][r], &rows[node(l)][c]);
                }
            }
        }
        // A right-hand side in the range of W.
        let velocity: Vec<f64> = (0..6 * bodies).map(|_| double(random.vec(1.0).y)).collect();
        let mut x: Vec<f64> = vec![0.0; plan.unknowns()];
        for p in 0..joints.len() {
            for (r, row) in rows[node(p)].iter().enumerate() {
                x[plan.start(p) + r] = dot(row, &velocity);
            }
        }
        let wanted = x.clone();
        plan.factor(&mut w, &size, &size);
        plan.solve(&w, &mut x);
        let mut after = vec![0.0; 6 * bodies];
        for p in 0..joints.len() {
            for (r, row) in rows[node(p)].iter().enumerate() {
                for (v, j) in after.iter_mut().zip(row) {
                    *v += j * x[plan.start(p) + r];
                }
            }
        }
        let mut worst = 0.0_f64;
        for p in 0..joints.len() {
            for (r, row) in rows[node(p)].iter().enumerate() {
                worst = worst.max((dot(row, &after) - wanted[plan.start(p) + r]).abs());
            }
        }
        worst
    }

    #[test]
    fn chains_trees_and_loops_are_solved() {
        let chain: Vec<_> = (0..30).map(|i| (i, i + 1)).collect();
        assert!(residual(&chain, &[3; 30], false) < 1e-9);
        let tree = [(0, 1), (1, 2), (1, 3), (3, 4), (3, 5), (1, 6), (6, 7)];
        assert!(residual(&tree, &[3, 5, 1, 2, 3, 2, 4], false) < 1e-10);
        let ring = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0)];
        assert!(residual(&ring, &[3, 3, 3, 3, 3], false) < 1e-10);
    }

    #[test]
    fn redundant_rows_do_no_harm() {
        let twice = [(0, 1), (1, 2), (1, 2)];
        assert!(residual(&twice, &[3, 3, 3], true) < 1e-6);
    }

    #[test]
    fn a_grid_that_would_fill_has_no_plan() {
        let n = 60_u32;
        let at = |x: u32, y: u32| x * n + y + 1;
        let mut joints = Vec::new();
        for x in 0..n {
            for y in 0..n {
                if x + 1 < n {
                    joints.push((at(x, y), at(x + 1, y)));
                }
                if y + 1 < n {
                    joints.push((at(x, y), at(x, y + 1)));
                }
            }
        }
        let mut edges = Vec::new();
        for (i, a) in joints.iter().enumerate() {
            for (j, b) in joints.iter().enumerate().skip(i + 1).take(3 * n as usize) {
                if a.0 == b.0 || a.0 == b.1 || a.1 == b.0 || a.1 == b.1 {
                    edges.push((i as u32, j as u32));
                }
            }
        }
        assert!(Elimination::plan(&vec![3; joints.len()], &edges).is_none());
        let chain: Vec<_> = (0..2000).map(|i| (i, i + 1)).collect();
        assert!(Elimination::plan(&[3; 2001], &chain).is_none_or(|plan| plan.unknowns() == 6003));
    }
}
