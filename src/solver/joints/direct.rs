//! Hard rows at once, and rows with bounds on top of them.
//!
//! The unbounded rows of a component are solved by [`Elimination`]. A bounded row that pushes (a limit, a strong motor)
//! is solved with what that makes the unbounded rows do in answer, so that its mobility is the one the mechanism leaves
//! it; friction and weak motors are solved alone, and the unbounded rows after them.

use super::Placed;
use super::blocks::Blocks;
use super::elimination::Elimination;
use super::row::{PUSH_SPEED, PUSH_SPEED_ANGULAR, Pair, SolverRow};
use crate::math::Float;
use crate::math::scalar::{double, single};
use crate::solver::rows::Rows;

/// The last factor of a component.
#[derive(Debug, Default)]
pub struct Factor {
    values: Vec<f64>,
    /// What unit impulses of bounded rows make the unbounded ones do.
    responses: Vec<f64>,
    /// What the diagonal of the factored system was raised by.
    damping: f64,
}

impl Factor {
    /// Whether it is that of W itself.
    pub fn is_exact(&self) -> bool {
        self.damping == 0.0
    }

    /// Bytes held.
    pub fn byte_count(&self) -> usize {
        (self.values.capacity() + self.responses.capacity()) * 8
    }
}

/// Scratch of the solves.
#[derive(Debug, Default)]
pub struct Direct {
    blocks: Blocks,
    size: Vec<f64>,
    least: Vec<f64>,
    unknown: Vec<f64>,
    wanted: Vec<f64>,
}

impl Direct {
    /// Bytes held.
    pub fn byte_count(&self) -> usize {
        let lists = [&self.size, &self.least, &self.unknown, &self.wanted];
        self.blocks.byte_count() + lists.iter().map(|l| l.capacity() * 8).sum::<usize>()
    }
}

/// For what system impulses are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Of {
    /// That of the rows as they are.
    Rows,
    /// The same, which is known to be that of the last call.
    SameRows,
    /// That of the last call, be it damped.
    LastCall,
}

/// The joints of a component, to be solved.
pub struct System<'a> {
    pub plan: &'a Elimination,
    pub list: &'a [Placed],
    pub solver_rows: &'a mut [SolverRow],
    /// Its unbounded rows, in the order of the plan.
    pub hard: &'a [u32],
    /// Its rows with bounds, in their own order.
    pub bounded: &'a [u32],
    /// Solver rows of the bodies.
    pub members: &'a [u32],
    pub rows: &'a mut Rows,
    pub work: &'a mut Direct,
    pub factor: &'a mut Factor,
}

/// How often bounded and unbounded rows of a component are solved in turn, at most: until the bounded ones stay.
const ROUNDS: usize = 4;

impl System<'_> {
    /// The impulses of a pass. Says whether the joints contradicted each other.
    pub fn impulses(&mut self, of: Of, aim: Aim) -> bool {
        if of != Of::LastCall {
            self.factor.responses.clear();
            self.bounded.iter().for_each(|&k| self.solver_rows[k as usize].response = None);
        }
        self.solve_at_once(of == Of::Rows, aim);
        if self.bounded.is_empty() {
            return self.factor.damping > 0.0;
        }
        let energy = energy_within_reach(self.members, self.rows, Aim::Push);
        for _ in 0..ROUNDS {
            let (mut moved, mut disturbed) = (false, false);
            for k in self.bounded.iter().map(|&k| k as usize) {
                if !self.solver_rows[k].wants_change(self.rows) {
                    continue;
                }
                if self.solver_rows[k].is_condensed() {
                    moved |= self.solve_condensed(k, energy);
                } else {
                    disturbed |= self.solver_rows[k].solve(self.rows);
                }
            }
            if disturbed {
                self.solve_at_once(false, aim);
            }
            if !moved && !disturbed {
                break;
            }
        }
        self.factor.damping > 0.0
    }

    /// Solves a bounded row together with what its impulse makes the unbounded rows of its component do: these stay
    /// solved. Says whether its impulse changed by more than a little.
    fn solve_condensed(&mut self, k: usize, energy: f64) -> bool {
        let n = self.plan.unknowns();
        let start = match self.solver_rows[k].response {
            Some(start) => start,
            None => self.respond(k),
        };
        let change = self.solver_rows[k].change(self.rows, energy);
        if change == 0.0 {
            return false;
        }
        self.solver_rows[k].lambda += change;
        self.solver_rows[k].apply(change, self.rows);
        let Self { plan, list, hard, solver_rows, rows, factor, .. } = self;
        let answer = &factor.responses[start..start + n];
        apply(plan, list, hard, solver_rows, rows, |u| single(answer[u] * double(change)));
        change.abs() > 1e-4 * self.solver_rows[k].lambda.abs()
    }

    /// Finds what a unit impulse of a bounded row makes the unbounded ones do.
    fn respond(&mut self, k: usize) -> usize {
        let row = &self.solver_rows[k];
        let mut y = std::mem::take(&mut self.work.unknown);
        y.clear();
        y.extend(self.hard.iter().map(|&hard| -self.solver_rows[hard as usize].coupling(row, self.rows)));
        let mut coupling = std::mem::take(&mut self.work.wanted);
        coupling.clear();
        coupling.extend_from_slice(&y);
        self.plan.solve(&self.factor.values, &mut y);
        let with: f64 = y.iter().zip(&coupling).map(|(a, b)| a * b).sum();
        let start = self.factor.responses.len();
        self.factor.responses.extend_from_slice(&y);
        (self.work.unknown, self.work.wanted) = (y, coupling);
        let mobility = self.solver_rows[k].coupling(&self.solver_rows[k], self.rows) - with;
        self.solver_rows[k].set_response(start, mobility);
        start
    }

    /// Solves the unbounded rows at once.
    fn solve_at_once(&mut self, factor: bool, aim: Aim) {
        let mut wanted = std::mem::take(&mut self.work.wanted);
        wanted.clear();
        let mut energy = energy_within_reach(self.members, self.rows, aim);
        for &k in self.hard {
            let row = &self.solver_rows[k as usize];
            let right = row.right_side(self.rows);
            energy += row.spring_energy(right);
            wanted.push(right);
        }
        if factor {
            self.factor.damping = 0.0;
        }
        let mut anew = factor;
        loop {
            if anew {
                self.factorize();
            }
            self.work.unknown.clear();
            self.work.unknown.extend_from_slice(&wanted);
            self.plan.solve(&self.factor.values, &mut self.work.unknown);
            // Joints that contradict each other make a system next to singular, whose answer would tear them apart:
            // what hard rows do to velocities takes no more energy than there is.
            let work: f64 = wanted.iter().zip(&self.work.unknown).map(|(a, b)| a * b).sum();
            if work <= energy {
                break;
            }
            if self.factor.damping >= 1.0 {
                self.work.unknown.iter_mut().for_each(|x| *x *= energy / work);
                break;
            }
            self.factor.damping = if self.factor.damping == 0.0 { 1e-4 } else { self.factor.damping * 100.0 };
            anew = true;
        }
        self.work.wanted = wanted;
        let Self { plan, list, hard, solver_rows, rows, work, .. } = self;
        apply(plan, list, hard, solver_rows, rows, |u| single(work.unknown[u]));
    }

    /// Factors the system: W, its diagonal, and the least part of that by one body.
    fn factorize(&mut self) {
        let Direct { blocks, size, least, .. } = &mut *self.work;
        let Factor { values: factor, damping, .. } = &mut *self.factor;
        factor.clear();
        factor.resize(self.plan.values(), 0.0);
        blocks.lay_out(self.plan, self.list, self.hard, self.solver_rows, self.rows);
        blocks.fill(self.plan, factor);
        size.clear();
        least.clear();
        for (position, &node) in self.plan.order.iter().enumerate() {
            let (d, at) = (self.plan.dim(position), self.plan.diagonal(position));
            for (r, &k) in self.hard[self.plan.start(position)..][..d].iter().enumerate() {
                let row = &self.solver_rows[k as usize];
                let own = &mut factor[at + r * d + r];
                *own = *own * (1.0 + *damping) + row.compliance();
                size.push(*own);
                least.push(row.least_share(self.list[node as usize].arm, self.rows) + row.compliance());
            }
        }
        self.plan.factor(factor, size, least);
    }
}

/// Changes the impulses of the unbounded rows by what `change` says of each unknown.
fn apply(
    plan: &Elimination,
    list: &[Placed],
    hard: &[u32],
    solver_rows: &mut [SolverRow],
    rows: &mut Rows,
    change: impl Fn(usize) -> Float,
) {
    for (position, &node) in plan.order.iter().enumerate() {
        let mut pair = Pair::of(list[node as usize].body, rows);
        for u in plan.start(position)..plan.start(position) + plan.dim(position) {
            let row = &mut solver_rows[hard[u] as usize];
            let change = change(u);
            row.lambda += change;
            pair.apply(row, change, rows);
        }
        pair.give_back(rows);
    }
}

/// What hard rows are solved for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aim {
    /// To push errors out.
    Push,
    /// To bend the way of bodies to their circles.
    Bend,
    /// To take velocities away.
    Rest,
}

/// How much |Δv|² (by mass) hard rows may do to some bodies: to take velocities away it is at most |v|², to bend a way
/// by a quarter of a radian a sub-step less; pushing adds what its speed makes of the masses.
fn energy_within_reach(members: &[u32], rows: &Rows, aim: Aim) -> f64 {
    let (share, push) = match aim {
        Aim::Push => (2.0, 2.0),
        Aim::Bend => (0.5, 1e-6),
        Aim::Rest => (1.1, 1e-6),
    };
    members.iter().fold(0.0, |sum, &m| {
        let (row, aux) = (&rows.row[m as usize], &rows.aux[m as usize]);
        if row.inv_mass() == 0.0 {
            return sum;
        }
        let (v, w) = (row.v(), row.w());
        let fast = push * PUSH_SPEED * PUSH_SPEED + share * v.dot(&v);
        let turning = share * w.dot(&w) + push * PUSH_SPEED_ANGULAR * PUSH_SPEED_ANGULAR;
        sum + double(fast / row.inv_mass()) + double(turning * aux.moments.max())
    })
}
