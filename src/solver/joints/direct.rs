//! Hard rows at once, and rows with bounds on top of them.
//!
//! The unbounded rows of a component are solved by [`Elimination`]. A bounded row that pushes (a limit, a strong motor)
//! is solved with what that makes the unbounded rows do in answer, so that its mobility is the one the mechanism leaves
//! it; friction and weak motors are solved alone, and the unbounded rows after them.

use super::Placed;
use super::elimination::Elimination;
use super::row::{PUSH_SPEED, PUSH_SPEED_ANGULAR, SolverRow};
use crate::math::scalar::{double, single};
use crate::solver::rows::Rows;

/// Scratch of the solves, and the last factor.
#[derive(Debug, Default)]
pub struct Direct {
    factor: Vec<f64>,
    size: Vec<f64>,
    least: Vec<f64>,
    unknown: Vec<f64>,
    wanted: Vec<f64>,
    /// What unit impulses of bounded rows make the unbounded ones do.
    responses: Vec<f64>,
    /// What the diagonal of the factored system was raised by.
    damping: f64,
}

impl Direct {
    /// Bytes held.
    pub fn byte_count(&self) -> usize {
        let lists = [&self.factor, &self.size, &self.least, &self.unknown, &self.wanted, &self.responses];
        lists.iter().map(|l| l.capacity() * 8).sum()
    }
}

/// The joints of a component, to be solved.
pub struct System<'a> {
    pub plan: &'a Elimination,
    pub list: &'a [Placed],
    pub solver_rows: &'a mut [SolverRow],
    /// Solver rows of the bodies.
    pub members: &'a [u32],
    pub rows: &'a mut Rows,
    pub work: &'a mut Direct,
}

/// How often bounded and unbounded rows of a component are solved in turn, at most: until the bounded ones stay.
const ROUNDS: usize = 4;

impl System<'_> {
    /// The impulses of a pass; without `factor` the system is that of the last call. Says whether the joints contradicted
    /// each other.
    pub fn impulses(&mut self, factor: bool, aim: Aim) -> bool {
        let range = super::rows_of(self.list);
        if factor {
            self.work.responses.clear();
            self.solver_rows[range.clone()].iter_mut().for_each(|row| row.response = None);
        }
        self.solve_at_once(factor, aim);
        if self.solver_rows[range.clone()].iter().all(|row| row.unbounded) {
            return self.work.damping > 0.0;
        }
        let energy = energy_within_reach(self.members, self.rows, Aim::Push);
        for _ in 0..ROUNDS {
            let (mut moved, mut disturbed) = (false, false);
            for k in range.clone() {
                if self.solver_rows[k].unbounded || !self.solver_rows[k].wants_change(self.rows) {
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
        self.work.damping > 0.0
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
        let mut y = self.work.responses[start..start + n].iter();
        for &node in &self.plan.order {
            for row in
                self.solver_rows[self.list[node as usize].rows.clone()].iter_mut().filter(|r| r.unbounded)
            {
                let also = single(y.next().expect("one for each") * double(change));
                row.lambda += also;
                row.apply(also, self.rows);
            }
        }
        change.abs() > 1e-4 * self.solver_rows[k].lambda.abs()
    }

    /// Finds what a unit impulse of a bounded row makes the unbounded ones do.
    fn respond(&mut self, k: usize) -> usize {
        let row = &self.solver_rows[k];
        let mut y = std::mem::take(&mut self.work.unknown);
        y.clear();
        y.extend(self.hard_order().map(|hard| -hard.coupling(row, self.rows)));
        let mut coupling = std::mem::take(&mut self.work.wanted);
        coupling.clear();
        coupling.extend_from_slice(&y);
        self.plan.solve(&self.work.factor, &mut y);
        let with: f64 = y.iter().zip(&coupling).map(|(a, b)| a * b).sum();
        let start = self.work.responses.len();
        self.work.responses.extend_from_slice(&y);
        (self.work.unknown, self.work.wanted) = (y, coupling);
        let mobility = self.solver_rows[k].coupling(&self.solver_rows[k], self.rows) - with;
        self.solver_rows[k].set_response(start, mobility);
        start
    }

    /// The unbounded rows, in the order of the plan.
    fn hard_order(&self) -> impl Iterator<Item = &SolverRow> {
        self.plan.order.iter().flat_map(|&node| {
            self.solver_rows[self.list[node as usize].rows.clone()].iter().filter(|r| r.unbounded)
        })
    }

    /// Solves the unbounded rows at once.
    fn solve_at_once(&mut self, factor: bool, aim: Aim) {
        let mut wanted = std::mem::take(&mut self.work.wanted);
        wanted.clear();
        wanted.extend(self.hard_order().map(|row| row.right_side(self.rows)));
        let mut energy = energy_within_reach(self.members, self.rows, aim);
        for (row, &wanted) in self.hard_order().zip(&wanted) {
            energy += row.spring_energy(wanted);
        }
        if factor {
            self.work.damping = 0.0;
        }
        let mut anew = factor;
        loop {
            if anew {
                self.factor();
            }
            self.work.unknown.clear();
            self.work.unknown.extend_from_slice(&wanted);
            self.plan.solve(&self.work.factor, &mut self.work.unknown);
            // Joints that contradict each other make a system next to singular, whose answer would tear them apart:
            // what hard rows do to velocities takes no more energy than there is.
            let work: f64 = wanted.iter().zip(&self.work.unknown).map(|(a, b)| a * b).sum();
            if work <= energy {
                break;
            }
            if self.work.damping >= 1.0 {
                self.work.unknown.iter_mut().for_each(|x| *x *= energy / work);
                break;
            }
            self.work.damping = if self.work.damping == 0.0 { 1e-4 } else { self.work.damping * 100.0 };
            anew = true;
        }
        self.work.wanted = wanted;
        for (position, &node) in self.plan.order.iter().enumerate() {
            let own = self.solver_rows[self.list[node as usize].rows.clone()].iter_mut();
            let changes = &self.work.unknown[self.plan.start(position)..];
            for (row, &change) in own.filter(|r| r.unbounded).zip(changes) {
                let change = single(change);
                row.lambda += change;
                row.apply(change, self.rows);
            }
        }
    }

    /// Factors the system.
    fn factor(&mut self) {
        let Direct { factor, size, least, damping, .. } = &mut *self.work;
        for (list, len) in [
            (&mut *factor, self.plan.values()),
            (&mut *size, self.plan.unknowns()),
            (&mut *least, self.plan.unknowns()),
        ] {
            list.clear();
            list.resize(len, 0.0);
        }
        assemble(self.plan, self.list, self.solver_rows, self.rows, *damping, factor, size, least);
        self.plan.factor(factor, size, least);
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

/// Fills W of a component, its diagonal, and the least part of that by one body.
#[allow(clippy::too_many_arguments)]
fn assemble(
    plan: &Elimination,
    list: &[Placed],
    solver_rows: &[SolverRow],
    rows: &Rows,
    damping: f64,
    w: &mut [f64],
    size: &mut [f64],
    least: &mut [f64],
) {
    for (position, &node) in plan.order.iter().enumerate() {
        let placed = &list[node as usize];
        let own = || solver_rows[placed.rows.clone()].iter().filter(|r| r.unbounded);
        let d = own().count();
        let (at, start) = (plan.diagonal(position), plan.start(position));
        for (r, row) in own().enumerate() {
            for (c, other) in own().enumerate().take(r + 1) {
                w[at + r * d + c] = row.coupling(other, rows);
            }
            w[at + r * d + r] = w[at + r * d + r] * (1.0 + damping) + row.compliance();
            size[start + r] = w[at + r * d + r];
            least[start + r] = row.least_share(placed.arm, rows) + row.compliance();
        }
    }
    for (k, l, at) in plan.blocks() {
        let (a, b) = (&list[plan.order[k] as usize], &list[plan.order[l] as usize]);
        let own = |p: &Placed| solver_rows[p.rows.clone()].iter().filter(|r| r.unbounded);
        let d = own(b).count();
        for (r, row) in own(a).enumerate() {
            for (c, other) in own(b).enumerate() {
                w[at + r * d + c] = row.coupling(other, rows);
            }
        }
    }
}
