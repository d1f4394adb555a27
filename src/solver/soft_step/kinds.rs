//! Kinds of contacts: which terms a contact has. Each kind has its own array of blocks and its own kernels, so a
//! scene pays for what it models: no column and no branch for rolling, conveyors, restitution or points that are
//! not there.

use super::contact_block::{
    ContactBlock, Extra, Friction, FrictionPart, FullFriction, Impact, ImpactPart, NoFriction, NoImpact,
    tangents,
};
use super::impact;
use crate::body::NONE;
use crate::constraint::Contact;
use crate::math::{Float, Vec3};
use crate::simd::{Four, Lane, V3};
use crate::solver::SubStep;
use crate::solver::rows::Rows;
use std::ops::Range;

/// How many kinds there are.
pub const KINDS: usize = 18;

/// The kind of a contact: 1, 2 or up to 4 points; no, dry or full friction; without or with restitution.
#[must_use]
pub fn kind_of(c: &Contact) -> usize {
    let points = match c.count {
        1 => 0,
        2 => 1,
        _ => 2,
    };
    let friction = if c.rolling_lever > 0.0 || c.conveyor != Vec3::zeros() {
        2
    } else {
        usize::from(c.friction > 0.0 || c.static_friction > 0.0)
    };
    (points * 3 + friction) * 2 + usize::from(c.restitution > 0.0)
}

/// What filling a block needs to know of a contact besides the contact.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// Stable index.
    pub index: u32,
    /// Solver rows of A and B.
    pub rows: [u32; 2],
    /// Centre of A minus centre of B \[m\].
    pub offset: Vec3,
    /// How soft it is, see [`ContactBlock`].
    pub soft: [Float; 4],
    /// The memory filter's rate, per step.
    pub alpha: Float,
    /// This step's sub-step over the last one's: impulses are per sub-step.
    pub impulse_scale: Float,
}

/// All blocks of one kind at one width.
pub trait Kind: Send + Sync + std::fmt::Debug {
    /// Forgets all blocks, keeps their memory.
    fn clear(&mut self);
    /// Appends blocks for these contacts, which share no moving body.
    fn append(&mut self, contacts: &[Contact], placed: &[Placed], rows: &Rows) -> Range<u32>;
    /// Applies last step's impulses.
    fn warm_start(&self, range: Range<u32>, rows: &mut Rows);
    /// The soft sweep.
    fn solve(&mut self, range: Range<u32>, rows: &mut Rows, sub: &SubStep);
    /// A relax sweep, the last of the sub-step or one before.
    fn relax(&mut self, range: Range<u32>, rows: &mut Rows, sub: &SubStep, last: bool);
    /// Finds the impacts of this sub-step, before forces act.
    fn find_impacts(&mut self, range: Range<u32>, rows: &Rows, sub: &SubStep);
    /// Takes the impulses of impacts out of what is carried to the next sub-step.
    fn end_impacts(&mut self, range: Range<u32>, rows: &mut Rows);
    /// Writes impulses back.
    fn store(&mut self, contacts: &mut [Contact]);
    /// Bytes held.
    fn byte_count(&self) -> usize;
}

#[derive(Debug)]
struct Blocks<L: Lane, const P: usize, F, R> {
    blocks: Vec<ContactBlock<L, P, F, R>>,
}

fn blocks<L: Lane, const P: usize, F: FrictionPart<L, P>, R: ImpactPart<L, P>>() -> Box<dyn Kind> {
    Box::new(Blocks::<L, P, F, R> { blocks: Vec::new() })
}

/// Every kind, in the order of [`kind_of`].
#[must_use]
pub fn all_kinds<L: Lane>() -> Vec<Box<dyn Kind>> {
    fn of_points<L: Lane, const P: usize>(out: &mut Vec<Box<dyn Kind>>) {
        out.push(blocks::<L, P, NoFriction, NoImpact>());
        out.push(blocks::<L, P, NoFriction, Impact<L, P>>());
        out.push(blocks::<L, P, Friction<L, P>, NoImpact>());
        out.push(blocks::<L, P, Friction<L, P>, Impact<L, P>>());
        out.push(blocks::<L, P, FullFriction<L, P>, NoImpact>());
        out.push(blocks::<L, P, FullFriction<L, P>, Impact<L, P>>());
    }
    let mut out = Vec::with_capacity(KINDS);
    of_points::<L, 1>(&mut out);
    of_points::<L, 2>(&mut out);
    of_points::<L, 4>(&mut out);
    out
}

/// The kinds one at a time and four at a time.
#[derive(Debug)]
pub struct KindTable {
    /// By width (0: one, 1: four) and kind.
    pub by_width: [Vec<Box<dyn Kind>>; 2],
}

impl Default for KindTable {
    fn default() -> Self {
        Self { by_width: [all_kinds::<Float>(), all_kinds::<Four>()] }
    }
}

impl<L: Lane, const P: usize, F: FrictionPart<L, P>, R: ImpactPart<L, P>> Kind for Blocks<L, P, F, R> {
    fn clear(&mut self) {
        self.blocks.clear();
    }

    fn append(&mut self, contacts: &[Contact], placed: &[Placed], rows: &Rows) -> Range<u32> {
        let start = self.blocks.len();
        crate::memory::make_room(&mut self.blocks, placed.len().div_ceil(L::N));
        for group in placed.chunks(L::N) {
            self.blocks.push(ContactBlock::empty());
            let block = self.blocks.last_mut().expect("pushed above");
            for (lane, place) in group.iter().enumerate() {
                fill(block, lane, &contacts[place.index as usize], place);
            }
            block.prepare(rows);
        }
        start as u32..self.blocks.len() as u32
    }

    fn warm_start(&self, range: Range<u32>, rows: &mut Rows) {
        for block in &self.blocks[range.start as usize..range.end as usize] {
            block.warm_start(rows);
        }
    }

    fn solve(&mut self, range: Range<u32>, rows: &mut Rows, sub: &SubStep) {
        for block in &mut self.blocks[range.start as usize..range.end as usize] {
            block.solve::<false, false>(rows, sub);
        }
    }

    fn relax(&mut self, range: Range<u32>, rows: &mut Rows, sub: &SubStep, last: bool) {
        for block in &mut self.blocks[range.start as usize..range.end as usize] {
            if last {
                block.solve::<true, true>(rows, sub);
            } else {
                block.solve::<true, false>(rows, sub);
            }
        }
    }

    fn find_impacts(&mut self, range: Range<u32>, rows: &Rows, sub: &SubStep) {
        for block in &mut self.blocks[range.start as usize..range.end as usize] {
            impact::find(block, rows, sub);
        }
    }

    fn end_impacts(&mut self, range: Range<u32>, rows: &mut Rows) {
        for block in &mut self.blocks[range.start as usize..range.end as usize] {
            impact::end(block, rows);
        }
    }

    fn store(&mut self, contacts: &mut [Contact]) {
        for block in &mut self.blocks {
            for lane in 0..L::N {
                let source = block.source.as_ref()[lane];
                if source != NONE {
                    store(block, lane, &mut contacts[source as usize]);
                }
            }
        }
    }

    fn byte_count(&self) -> usize {
        self.blocks.capacity() * size_of::<ContactBlock<L, P, F, R>>()
    }
}

/// Copies a contact into one lane of a block.
fn fill<L: Lane, const P: usize, F: FrictionPart<L, P>, R: ImpactPart<L, P>>(
    block: &mut ContactBlock<L, P, F, R>,
    lane: usize,
    c: &Contact,
    at: &Placed,
) {
    block.a.as_mut()[lane] = at.rows[0];
    block.b.as_mut()[lane] = at.rows[1];
    block.source.as_mut()[lane] = at.index;
    block.normal.put(lane, c.normal);
    block.offset.put(lane, at.offset);
    for (column, value) in block.soft.iter_mut().zip(at.soft) {
        column.put(lane, value);
    }
    for (column, value) in block.rounding.iter_mut().zip(c.rounding) {
        column.put(lane, value);
    }
    let scale = at.impulse_scale;
    let mean_gap = c.points().iter().map(|q| q.impulse - q.memory).sum::<Float>() / Float::from(c.count);
    let (mut center, mut load) = (Vec3::zeros(), 0.0);
    for (p, q) in block.points.iter_mut().zip(c.points()) {
        p.r.put(lane, q.anchor);
        p.separation.put(lane, q.separation);
        p.mass.put(lane, 1.0);
        p.lambda.put(lane, q.impulse * scale);
        p.memory.put(lane, (q.memory + at.alpha * mean_gap) * scale);
        center += q.anchor * q.impulse;
        load += q.impulse;
    }
    if let Some(f) = block.friction.dry() {
        let center = if load > 0.0 {
            center / load
        } else {
            c.points().iter().fold(Vec3::zeros(), |s, q| s + q.anchor) / Float::from(c.count)
        };
        f.r.put(lane, center);
        f.mu.put(lane, c.friction);
        f.mu_static.put(lane, c.static_friction.max(c.friction));
        let t = tangents::<Float>(V3::new(c.normal.x, c.normal.y, c.normal.z)).map(|t| t.get(0));
        f.lambda[0].put(lane, c.friction_impulse.dot(&t[0]) * scale);
        f.lambda[1].put(lane, c.friction_impulse.dot(&t[1]) * scale);
        f.twist.put(lane, c.twist_impulse * scale);
        if let Some(e) = block.friction.extra() {
            e.lever.put(lane, c.rolling_lever);
            e.lambda[0].put(lane, c.rolling_impulse.dot(&t[0]) * scale);
            e.lambda[1].put(lane, c.rolling_impulse.dot(&t[1]) * scale);
            e.conveyor[0].put(lane, c.conveyor.dot(&t[0]));
            e.conveyor[1].put(lane, c.conveyor.dot(&t[1]));
        }
    }
    if let Some(r) = block.impact.get() {
        r.restitution.put(lane, c.restitution);
    }
}

/// Copies the impulses of one lane back to its contact.
fn store<L: Lane, const P: usize, F: FrictionPart<L, P>, R: ImpactPart<L, P>>(
    block: &mut ContactBlock<L, P, F, R>,
    lane: usize,
    c: &mut Contact,
) {
    let count = c.count as usize;
    for (p, q) in block.points.iter().zip(&mut c.points[..count]) {
        q.impulse = p.lambda.get(lane);
        q.memory = p.memory.get(lane);
        q.total = p.total.get(lane);
    }
    let n = V3::new(c.normal.x, c.normal.y, c.normal.z);
    let t = tangents::<Float>(n).map(|t| t.get(0));
    if let Some(f) = block.friction.dry() {
        let (l, sum): (&Friction<L, P>, _) = (f, f.total);
        c.friction_impulse = t[0] * l.lambda[0].get(lane) + t[1] * l.lambda[1].get(lane);
        c.total_friction = t[0] * sum[0].get(lane) + t[1] * sum[1].get(lane);
        c.twist_impulse = l.twist.get(lane);
    }
    if let Some(e) = block.friction.extra() {
        let e: &Extra<L> = e;
        c.rolling_impulse = t[0] * e.lambda[0].get(lane) + t[1] * e.lambda[1].get(lane);
    }
}
