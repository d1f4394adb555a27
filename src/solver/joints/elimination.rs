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

/// A plan is made only if a factorization takes at most so many multiplications for each joint, and in all.
const MOST_PER_JOINT: u64 = 12_000;
const MOST: u64 = 400_000;

/// Below this share of its least part before elimination a pivot belongs to a row that others have made redundant, or soon
/// will (bars that come to lie in one line): taken at its word it would push with thousands of newtons against what
/// rounding left of its error.
const REDUNDANT: f64 = 2e-3;

/// Below this share of itself before elimination a pivot is what rounding left.
const ROUNDING: f64 = 1e-12;

/// What is known from the topology alone.
#[derive(Clone, Debug, Default)]
pub struct Elimination {
    /// Nodes in order of elimination.
    pub order: Vec<u32>,
    /// Rows of the node at each position.
    dim: Vec<usize>,
    /// Where its unknowns begin.
    start: Vec<usize>,
    /// For each position its later neighbours (positions), and where their blocks are.
    later: Vec<Vec<(usize, usize)>>,
    diagonal: Vec<usize>,
    /// For each position the blocks that its elimination changes: (k, l, block), k ≥ l.
    changes: Vec<Vec<(usize, usize, usize)>>,
    values: usize,
    unknowns: usize,
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
            let d = dims[node as usize];
            plan.dim.push(d);
            plan.start.push(plan.unknowns);
            plan.unknowns += d;
            plan.diagonal.push(plan.values);
            plan.values += d * d;
        }
        for (i, nodes) in later_nodes.iter().enumerate() {
            let mut list: Vec<usize> = nodes.iter().map(|&v| position[v as usize]).collect();
            list.sort_unstable();
            let blocks = list
                .into_iter()
                .map(|k| {
                    let at = plan.values;
                    plan.values += plan.dim[k] * plan.dim[i];
                    (k, at)
                })
                .collect();
            plan.later.push(blocks);
        }
        for i in 0..n {
            let mut changes = Vec::new();
            for (a, &(k, _)) in plan.later[i].iter().enumerate() {
                for &(l, _) in &plan.later[i][..=a] {
                    changes.push((k, l, plan.block(k, l)));
                }
            }
            plan.changes.push(changes);
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
        self.start[position]
    }

    /// Where block (k, l) is, k ≥ l being positions; its rows are those of k.
    fn block(&self, k: usize, l: usize) -> usize {
        if k == l {
            return self.diagonal[k];
        }
        let list = &self.later[l];
        let at = list.binary_search_by_key(&k, |e| e.0).expect("fill was planned for");
        list[at].1
    }

    /// The pairs of positions whose block of W may be other than zero, k > l, with where it is.
    pub fn blocks(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        self.later.iter().enumerate().flat_map(|(l, list)| list.iter().map(move |&(k, at)| (k, l, at)))
    }

    /// Where the diagonal block of a position is.
    #[must_use]
    pub fn diagonal(&self, position: usize) -> usize {
        self.diagonal[position]
    }

    /// Factors W in place: its lower blocks stand in `w` (rows of the later position first), its diagonal in `size`, and in
    /// `least` about what is left of that at least, unless the row is redundant.
    pub fn factor(&self, w: &mut [f64], size: &[f64], least: &[f64]) {
        for i in 0..self.order.len() {
            let d = self.dim[i];
            let at = self.diagonal[i];
            let own = self.start[i]..self.start[i] + d;
            cholesky(&mut w[at..at + d * d], &size[own.clone()], &least[own]);
            for &(k, block) in &self.later[i] {
                // L_ki = A_ki C⁻ᵀ.
                for r in 0..self.dim[k] {
                    let row = block + r * d;
                    for c in 0..d {
                        let mut sum = w[row + c];
                        for e in 0..c {
                            sum -= w[row + e] * w[at + c * d + e];
                        }
                        w[row + c] = sum / w[at + c * d + c];
                    }
                }
            }
            let mut change = self.changes[i].iter();
            for (a, &(k, lk)) in self.later[i].iter().enumerate() {
                for &(l, ll) in &self.later[i][..=a] {
                    let &(_, _, target) = change.next().expect("one for each pair");
                    let (dk, dl) = (self.dim[k], self.dim[l]);
                    for r in 0..dk {
                        for c in 0..dl {
                            let mut sum = 0.0;
                            for e in 0..d {
                                sum += w[lk + r * d + e] * w[ll + c * d + e];
                            }
                            w[target + r * dl + c] -= sum;
                        }
                    }
                }
            }
        }
    }

    /// Solves for the right-hand side `x`, by position, in place.
    pub fn solve(&self, w: &[f64], x: &mut [f64]) {
        for i in 0..self.order.len() {
            let (d, at, s) = (self.dim[i], self.diagonal[i], self.start[i]);
            for r in 0..d {
                let mut sum = x[s + r];
                for e in 0..r {
                    sum -= w[at + r * d + e] * x[s + e];
                }
                x[s + r] = sum / w[at + r * d + r];
            }
            for &(k, block) in &self.later[i] {
                let sk = self.start[k];
                for r in 0..self.dim[k] {
                    let mut sum = 0.0;
                    for e in 0..d {
                        sum += w[block + r * d + e] * x[s + e];
                    }
                    x[sk + r] -= sum;
                }
            }
        }
        for i in (0..self.order.len()).rev() {
            let (d, at, s) = (self.dim[i], self.diagonal[i], self.start[i]);
            for &(k, block) in &self.later[i] {
                let sk = self.start[k];
                for r in 0..self.dim[k] {
                    let xk = x[sk + r];
                    for e in 0..d {
                        x[s + e] -= w[block + r * d + e] * xk;
                    }
                }
            }
            for r in (0..d).rev() {
                let mut sum = x[s + r];
                for e in r + 1..d {
                    sum -= w[at + e * d + r] * x[s + e];
                }
                x[s + r] = sum / w[at + r * d + r];
            }
        }
    }
}

/// Solves one dense system in place: W in its lower triangle, its diagonal in `size`, the right-hand side in `x`.
pub fn solve_dense(w: &mut [f64], size: &[f64], x: &mut [f64]) {
    cholesky(w, size, size);
    let d = size.len();
    for r in 0..d {
        for e in 0..r {
            x[r] -= w[r * d + e] * x[e];
        }
        x[r] /= w[r * d + r];
    }
    for r in (0..d).rev() {
        for e in r + 1..d {
            x[r] -= w[e * d + r] * x[e];
        }
        x[r] /= w[r * d + r];
    }
}

/// The Cholesky factor of a d × d block, in place in its lower triangle; see [`Elimination::factor`].
fn cholesky(a: &mut [f64], size: &[f64], least: &[f64]) {
    let d = size.len();
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
