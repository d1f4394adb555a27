//! A row of a joint, ready to be solved.

use super::oscillator::Oscillator;
use crate::constraint::joint::{Joint, JointRow, Law, MAX_ROWS, Side};
use crate::math::scalar::{double, single};
use crate::math::{Float, Vec3};
use crate::solver::SubStep;
use crate::solver::rows::Rows;

/// Errors are pushed out at no more than this \[m/s\].
pub const PUSH_SPEED: Float = 4.0;
/// The same for angles \[rad/s\].
pub const PUSH_SPEED_ANGULAR: Float = 8.0;

/// What a pass is after.
#[derive(Clone, Copy, Debug)]
pub enum Pass {
    /// About the right velocities, to look ahead with.
    Guess,
    /// The right place at the end of the sub-step, where the error would be `predicted` if nothing changed.
    Solve {
        /// C there.
        predicted: Float,
    },
    /// The right velocity there.
    Relax,
}

/// See the module. Its impulse follows λ ← scale · λ + mass · (aim − scale · Ċ), within its bounds; a hard row has the
/// scale 1.
#[derive(Clone, Debug)]
pub struct SolverRow {
    /// Solver rows of bodies A and B, and of two more.
    bodies: [u32; 4],
    /// What it sees of them.
    sides: [Side; 4],
    /// How many there are, two or four.
    count: usize,
    /// I_w⁻¹ times their angular parts.
    turn: [Vec3; 2],
    law: Law,
    /// Whether λ has no bounds: hard rows and springs of any strength.
    pub unbounded: bool,
    angular: bool,
    /// At what share of the full speed the error is pushed out.
    pub share: Float,
    /// The error, where the Jacobian was taken.
    c: Float,
    /// Error and Ċ when the sub-step began, for springs.
    start: [Float; 2],
    /// Motion of its spring.
    oscillator: Oscillator,
    /// Effective mass of the row alone; 0 for hard rows, which are never solved alone.
    mass: Float,
    /// What a unit impulse does to Ċ with the unbounded rows of its component following.
    mobility: f64,
    /// Where what they do stands.
    pub response: Option<usize>,
    /// Impulse of this sub-step.
    pub lambda: Float,
    /// What of it acted before the bodies were moved.
    before_move: Float,
    least: Float,
    most: Float,
    aim: Float,
    scale: Float,
}

impl SolverRow {
    /// A row without impulse; `h` is the sub-step \[s\]. Hard rows of a mesh are springs of that frequency and damping
    /// ratio: what is solved one after another would ring if it were rigid.
    pub fn new(
        draft: &JointRow,
        joint: &Joint,
        bodies: [u32; 4],
        h: Float,
        mesh: Option<[Float; 2]>,
    ) -> Self {
        let mut law = draft.law;
        if law == Law::Equal && joint.hertz > 0.0 {
            let force = [Float::NEG_INFINITY, Float::INFINITY];
            law = Law::Spring { hertz: joint.hertz, damping_ratio: joint.damping_ratio, force };
        } else if let (Law::Equal, Some([hertz, damping_ratio])) = (law, mesh) {
            let force = [Float::NEG_INFINITY, Float::INFINITY];
            law = Law::Spring { hertz, damping_ratio, force };
        }
        let (least, most) = match law {
            Law::Equal => (Float::NEG_INFINITY, Float::INFINITY),
            Law::AtLeast => (0.0, Float::INFINITY),
            Law::Spring { force, .. } => (force[0] * h, force[1] * h),
            Law::Motor { max, .. } => (-max * h, max * h),
        };
        let oscillator = match law {
            Law::Spring { hertz, damping_ratio, .. } => Oscillator::new(hertz, damping_ratio, h),
            _ => Oscillator::default(),
        };
        Self {
            bodies,
            sides: [Side::default(); 4],
            count: 2,
            turn: [Vec3::zeros(); 2],
            law,
            unbounded: law.is_unbounded(),
            angular: draft.angular,
            share: joint.push,
            c: draft.c,
            start: [0.0; 2],
            oscillator,
            mass: 0.0,
            mobility: 0.0,
            response: None,
            lambda: 0.0,
            before_move: 0.0,
            least,
            most,
            aim: 0.0,
            scale: 1.0,
        }
    }

    /// Takes error and Jacobian from a draft of the same row.
    pub fn place(&mut self, draft: &JointRow, rows: &Rows) {
        self.sides[..2].copy_from_slice(&draft.sides);
        if let Some(more) = draft.more {
            self.sides[2..].copy_from_slice(&more);
            self.count = 4;
        }
        self.c = draft.c;
        self.weigh(rows);
    }

    /// Takes how its bodies yield.
    pub fn weigh(&mut self, rows: &Rows) {
        for k in 0..2 {
            let inertia = &rows.inertia[self.bodies[k] as usize];
            self.turn[k] = inertia.times(self.sides[k].angular);
        }
        if !self.is_hard() {
            let k = single(self.coupling(self, rows));
            self.mass = if k > 0.0 { 1.0 / k } else { 0.0 };
        }
    }

    /// The sides with their bodies.
    #[inline]
    fn parts(&self) -> impl Iterator<Item = (usize, &Side)> {
        let bodies = self.bodies[..self.count].iter().map(|&b| b as usize);
        bodies.zip(&self.sides[..self.count]).filter(|p| p.0 != 0)
    }

    /// One of its sides.
    pub fn side(&self, side: usize) -> &Side {
        &self.sides[side]
    }

    /// Whether it is a hard row: it does not give.
    pub fn is_hard(&self) -> bool {
        self.law == Law::Equal
    }

    /// How many bodies it has, the immovable one counted: two or four.
    pub fn side_count(&self) -> usize {
        self.count
    }

    /// Ċ.
    #[inline]
    pub fn speed(&self, rows: &Rows) -> Float {
        // What does not move adds nothing.
        self.bodies[..self.count].iter().zip(&self.sides).fold(0.0, |sum, (&b, side)| {
            let row = &rows.row[b as usize];
            sum + (side.linear.dot(&row.v()) + side.angular.dot(&row.w()))
        })
    }

    /// By how much Ċ is ahead of the mean speed over the sub-step, where bodies are moved by less than their velocity.
    fn ahead(&self, lead: &[[Vec3; 2]], lag: Float) -> Float {
        self.bodies[..self.count].iter().zip(&self.sides).fold(0.0, |sum, (&b, side)| {
            let [accel, turn] = &lead[b as usize];
            sum + (side.linear.dot(accel) + side.angular.dot(turn)) * lag
        })
    }

    /// Notes error and speed at the start of a sub-step.
    pub fn note_start(&mut self, rows: &Rows) {
        if let Law::Spring { .. } = self.law {
            self.start = [self.c, self.speed(rows)];
        }
    }

    /// How fast the error is pushed out.
    fn push(&self, sub: &SubStep) -> Float {
        let most = self.share * if self.angular { PUSH_SPEED_ANGULAR } else { PUSH_SPEED };
        let push = (self.c * sub.inv_h).max(-most);
        if self.law == Law::Equal { push.min(most) } else { push }
    }

    /// Sets what the row is after in this pass; `lead` is by how much bodies are ahead of their mean motion, per time.
    #[inline]
    pub fn want(&mut self, pass: Pass, rows: &Rows, sub: &SubStep, lead: &[[Vec3; 2]], lag: Float) {
        (self.scale, self.aim) = match (self.law, pass) {
            (Law::Equal | Law::AtLeast, Pass::Solve { predicted }) => {
                (1.0, self.speed(rows) - self.push(sub) - (predicted - self.c) * sub.inv_h)
            }
            (Law::Equal | Law::AtLeast, Pass::Guess) => {
                let push = self.push(sub);
                (1.0, self.ahead(lead, lag) - push)
            }
            (Law::Equal, Pass::Relax) => (1.0, 0.0),
            (Law::AtLeast, Pass::Relax) => (1.0, -self.c.max(0.0) * sub.inv_h),
            (Law::Motor { speed, .. }, Pass::Guess | Pass::Solve { .. }) => {
                (1.0, speed + self.ahead(lead, lag))
            }
            (Law::Motor { speed, .. }, Pass::Relax) => (1.0, speed),
            (Law::Spring { .. }, pass) => {
                // The acceleration by everything else is (Ċ without the spring − start) / h.
                let (of, extra) = match pass {
                    Pass::Guess | Pass::Solve { .. } => (self.oscillator.mean, self.ahead(lead, lag)),
                    Pass::Relax => (self.oscillator.end, 0.0),
                };
                let per_speed = of[2] * sub.inv_h;
                let aim = of[0] * self.start[0] + (of[1] - per_speed) * self.start[1] + extra;
                (1.0 - per_speed, aim)
            }
        };
    }

    /// Applies the impulse `change`.
    #[inline]
    pub fn apply(&self, change: Float, rows: &mut Rows) {
        for k in 0..2 {
            let b = self.bodies[k] as usize;
            if b != 0 {
                let row = &mut rows.row[b];
                row.set_v(row.v() + self.sides[k].linear * (change * row.inv_mass()));
                row.set_w(row.w() + self.turn[k] * change);
            }
        }
        for k in 2..self.count {
            let (b, side) = (self.bodies[k] as usize, &self.sides[k]);
            if b != 0 {
                let row = &mut rows.row[b];
                row.set_v(row.v() + side.linear * (change * row.inv_mass()));
                row.set_w(row.w() + rows.inertia[b].times(side.angular * change));
            }
        }
    }

    /// Whether the row is solved with the unbounded ones of its component following: what has no or a great bound.
    /// Friction yields anyway.
    pub fn is_condensed(&self) -> bool {
        match self.law {
            Law::Motor { speed, max } => speed != 0.0 || max == Float::INFINITY,
            _ => true,
        }
    }

    /// Whether it would change at all: most limits are far away.
    pub fn wants_change(&self, rows: &Rows) -> bool {
        let free = self.mass * (self.aim - self.scale * self.speed(rows));
        self.lambda != 0.0 || free.max(self.least).min(self.most) != 0.0
    }

    /// What the others do stands there, and leaves the row this mobility.
    pub fn set_response(&mut self, at: usize, mobility: f64) {
        self.response = Some(at);
        // Where the others leave it nothing to move, an impulse would only be rounding.
        let least = 1e-6 / double(self.mass.max(Float::MIN_POSITIVE));
        self.mobility = if mobility > least { mobility } else { f64::INFINITY };
    }

    /// By how much the impulse has to change, the others following; it adds no more than this energy.
    pub fn change(&self, rows: &Rows, energy: f64) -> Float {
        let wanted = self.right_side(rows);
        let change = wanted / (self.mobility + self.compliance());
        let work = change * wanted;
        let reach = energy + self.spring_energy(wanted);
        let free = self.lambda + single(if work > reach { change * (reach / work) } else { change });
        free.max(self.least).min(self.most) - self.lambda
    }

    /// Solves this row alone; says whether its impulse changed by more than a little.
    pub fn solve(&mut self, rows: &mut Rows) -> bool {
        let free = self.scale * self.lambda + self.mass * (self.aim - self.scale * self.speed(rows));
        let lambda = free.max(self.least).min(self.most);
        let change = lambda - self.lambda;
        self.lambda = lambda;
        if change == 0.0 {
            return false;
        }
        self.apply(change, rows);
        change.abs() > 1e-4 * lambda.abs()
    }

    /// The element of W between this row and another: what an impulse of one changes of the other's Ċ. In double
    /// precision: what single precision rounds off would make redundant rows look free.
    pub fn coupling(&self, other: &SolverRow, rows: &Rows) -> f64 {
        let mut sum = 0.0;
        for (a, side) in self.parts() {
            for (b, there) in other.parts() {
                if a == b {
                    let linear = exact_dot(side.linear, there.linear.map(double).into());
                    let turn = rows.inertia[b].exact().times(there.angular.map(double).into());
                    sum += linear * double(rows.row[b].inv_mass()) + exact_dot(side.angular, turn);
                }
            }
        }
        sum
    }

    /// About what is left of the row's own element of W, at least, when other rows hold its bodies without making it
    /// redundant: the body yields along with all its mass, and turns about its joint, `arms` from its centre, instead of
    /// about itself.
    pub fn least_share(&self, arms: [Vec3; 2], rows: &Rows) -> f64 {
        let mut least = f64::INFINITY;
        for (k, side) in self.sides[..self.count].iter().enumerate() {
            let b = self.bodies[k] as usize;
            if b == 0 {
                continue;
            }
            let inv_mass = rows.row[b].inv_mass();
            let linear = side.linear.dot(&side.linear) * inv_mass;
            let angular = || {
                let moment = rows.aux[b].moments.max();
                let arm = arms.get(k).copied().unwrap_or_default();
                let orbit = if inv_mass > 0.0 { arm.dot(&arm) / inv_mass } else { 0.0 };
                if moment > 0.0 { side.angular.dot(&side.angular) / (moment + orbit) } else { 0.0 }
            };
            let share = double(if linear > 0.0 { linear } else { angular() });
            if share > 0.0 {
                least = least.min(share);
            }
        }
        least
    }

    /// For a spring that wants this of the system: about twice the energy it may add.
    pub fn spring_energy(&self, wanted: f64) -> f64 {
        match self.law {
            Law::Spring { .. } => 4.0 * wanted * wanted * double(self.mass),
            _ => 0.0,
        }
    }

    /// What softness adds to the diagonal of W.
    pub fn compliance(&self) -> f64 {
        if self.scale >= 1.0 {
            return 0.0;
        }
        let scale = double(self.scale.max(1e-6));
        (1.0 - scale) / (scale * double(self.mass.max(Float::MIN_POSITIVE)))
    }

    /// The right-hand side of W · change = …
    pub fn right_side(&self, rows: &Rows) -> f64 {
        let aim = double(self.aim) / double(self.scale.max(1e-6));
        aim - double(self.speed(rows)) - self.compliance() * double(self.lambda)
    }

    /// The error that a hard row or a limit has, and how much of it the sub-step is to take away.
    pub fn error(&self, sub: &SubStep) -> (Float, Float) {
        let error = match self.law {
            Law::Equal => self.c.abs(),
            Law::AtLeast => (-self.c).max(0.0),
            _ => 0.0,
        };
        (error, if error > 0.0 { self.push(sub).abs() * sub.h } else { 0.0 })
    }

    /// The linear impulse on body A or B.
    pub fn impulse_on(&self, side: usize) -> Vec3 {
        self.sides[side].linear * self.lambda
    }

    /// Before the row is placed anew: adds what acted so far to the sums on B, and on B about `arm_b`.
    pub fn add_before_move(&mut self, total: &mut Vec3, angular: &mut Vec3, arm_b: Vec3) {
        self.before_move = self.lambda;
        self.add(self.lambda, total, angular, arm_b);
    }

    /// Adds what acted since then.
    pub fn add_after_move(&self, total: &mut Vec3, angular: &mut Vec3, arm_b: Vec3) {
        self.add(self.lambda - self.before_move, total, angular, arm_b);
    }

    fn add(&self, impulse: Float, total: &mut Vec3, angular: &mut Vec3, arm_b: Vec3) {
        let p = self.sides[1].linear * impulse;
        *total += p;
        *angular += self.sides[1].angular * impulse - arm_b.cross(&p);
    }
}

/// The bodies A and B of a joint while impulses of its rows act on them, one after another.
pub struct Pair {
    bodies: [u32; 2],
    v: [Vec3; 2],
    w: [Vec3; 2],
    inv_mass: [Float; 2],
}

impl Pair {
    /// With the velocities they have.
    #[inline]
    pub fn of(bodies: [u32; 4], rows: &Rows) -> Self {
        let bodies = [bodies[0], bodies[1]];
        let [a, b] = bodies.map(|b| &rows.row[b as usize]);
        Self { bodies, v: [a.v(), b.v()], w: [a.w(), b.w()], inv_mass: [a.inv_mass(), b.inv_mass()] }
    }

    /// Applies the impulse `change` of a row.
    #[inline]
    pub fn apply(&mut self, row: &SolverRow, change: Float, rows: &mut Rows) {
        if row.count > 2 {
            self.give_back(rows);
            row.apply(change, rows);
            *self = Self::of(row.bodies, rows);
            return;
        }
        for k in 0..2 {
            self.v[k] += row.sides[k].linear * (change * self.inv_mass[k]);
            self.w[k] += row.turn[k] * change;
        }
    }

    /// Gives the bodies the velocities that they have now.
    #[inline]
    pub fn give_back(&self, rows: &mut Rows) {
        for k in 0..2 {
            if self.bodies[k] != 0 {
                let row = &mut rows.row[self.bodies[k] as usize];
                row.set_v(self.v[k]);
                row.set_w(self.w[k]);
            }
        }
    }
}

/// Of two vectors, the first exact in single precision.
fn exact_dot(a: Vec3, b: [f64; 3]) -> f64 {
    double(a.x) * b[0] + double(a.y) * b[1] + double(a.z) * b[2]
}

/// Solves the unbounded rows of one joint as a block.
pub fn solve_block(list: &mut [SolverRow], rows: &mut Rows) {
    let mut index = [0; MAX_ROWS];
    let mut d = 0;
    for (i, row) in list.iter().enumerate() {
        if row.unbounded {
            index[d] = i;
            d += 1;
        }
    }
    let index = &index[..d];
    let mut w = [0.0; MAX_BLOCK * MAX_BLOCK];
    let (mut size, mut x) = ([0.0; MAX_BLOCK], [0.0; MAX_BLOCK]);
    if d > MAX_BLOCK {
        // More springs than a block has room for: one after another.
        index.iter().for_each(|&i| {
            list[i].solve(rows);
        });
        return;
    }
    for (r, &i) in index.iter().enumerate() {
        for (c, &j) in index[..=r].iter().enumerate() {
            w[r * d + c] = list[i].coupling(&list[j], rows);
        }
        w[r * d + r] += list[i].compliance();
        size[r] = w[r * d + r];
        x[r] = list[i].right_side(rows);
    }
    super::elimination::solve_dense(&mut w[..d * d], &size[..d], &mut x[..d]);
    for (&i, &change) in index.iter().zip(&x) {
        let change = single(change);
        list[i].lambda += change;
        list[i].apply(change, rows);
    }
}

/// The most rows of a block: six hard ones and six springs.
const MAX_BLOCK: usize = 12;
