//! The thesis's iterative solver (chapter 7.2): the impulse of its chapter 4.3 at every contact point, again and again.
//!
//! Where a point approaches faster than its target u (0, or −ε v⁻ with the approach speed v⁻ before the step):
//!   |J_n| = (u − n·v) / (T_A⁻¹(n) + T_B⁻¹(n)),   then along the slip ŝ   |J_s| = min(|s| / (T_A⁻¹(ŝ) + T_B⁻¹(ŝ)), μ |J_n|),
//! with the static coefficient deciding whether the point sticks and the sliding one how strongly it slides. Impulses
//! only push; none is ever taken back, and nothing is remembered from step to step.
//!
//! The separation forces of the thesis's configuration push overlapping bodies apart: u is at least
//! force · overlap · [`SHARE`]/h, as a velocity that stays with the bodies (that is the thesis's; it costs energy's
//! conservation, which the other solvers keep).
//!
//! Both improvements that the thesis names are options: another order of the points in every iteration
//! ([`Settings::shuffle`]: shuffled within an island, seeded by the iteration's number) and larger corrections in the
//! first iterations ([`Settings::over_correct`]: [`GREATEST`] times the impulse, falling to once in the last).

use super::points::{Point, apply, relative};
use super::rigid::Rigid;
use super::rows::Rows;
use super::{Settings, SubStep};
use crate::math::Float;

/// Which share of an overlap a separation force of 1 pushes out in a sub-step.
pub const SHARE: Float = 0.2;

/// The factor on corrections in the first iteration, where they are larger.
pub const GREATEST: Float = 1.5;

/// Memory that is kept between steps.
#[derive(Debug, Default)]
pub struct Workspace {
    order: Vec<u32>,
}

impl Workspace {
    /// Takes every batch through its sub-steps.
    pub fn solve(&mut self, step: &mut Rigid<'_>) {
        let settings = step.settings;
        step.run(false, |step, batch| {
            let range = step.points.range(step.rows, batch);
            for p in &mut step.points.points[range] {
                p.lambda = [0.0; 3];
                separate(p, &step.sub, settings);
            }
            for iteration in 0..settings.iterations {
                let factor = correction(iteration, settings);
                step.sweep_joints(batch);
                for place in step.rows.batches[batch].islands.clone() {
                    let island = step.points.of_island[place].clone();
                    self.arrange(island.len(), iteration, settings.shuffle);
                    let points = &mut step.points.points[island];
                    for &i in &self.order {
                        visit(&mut points[i as usize], &mut step.rows.rows, factor);
                    }
                }
            }
        });
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.order.capacity() * 4
    }
}

/// Raises the target of an overlapping point to the speed that its separation force asks for.
fn separate(p: &mut Point, sub: &SubStep, settings: &Settings) {
    if p.gap < 0.0 {
        let (force, most) = if p.on_static {
            (settings.separation_on_static, settings.push_out_on_static)
        } else {
            (settings.separation_between_moving, settings.push_out_between_moving)
        };
        let speed = (-p.gap * force * SHARE * sub.inv_h).min(most);
        p.target[0] = p.target[0].max(speed);
    }
}

/// The factor on the corrections of an iteration.
fn correction(iteration: u32, settings: &Settings) -> Float {
    if !settings.over_correct || settings.iterations < 2 {
        return 1.0;
    }
    let left = 1.0 - iteration as Float / (settings.iterations - 1) as Float;
    1.0 + (GREATEST - 1.0) * left
}

/// The impulse of one point, by the formulas of the module.
fn visit(p: &mut Point, rows: &mut Rows, factor: Float) {
    let [kn, k11, k12, k22] = p.k;
    let approach = p.target[0] - relative(rows, p).dot(&p.axes[0]);
    if approach <= 0.0 || kn <= 0.0 {
        return;
    }
    let normal = factor * approach / kn;
    p.lambda[0] += normal;
    apply(rows, p, p.axes[0] * normal);
    let v = relative(rows, p);
    let slip = [v.dot(&p.axes[1]) - p.target[1], v.dot(&p.axes[2]) - p.target[2]];
    let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
    if speed <= 0.0 {
        return;
    }
    let along = [slip[0] / speed, slip[1] / speed];
    let k = along[0] * along[0] * k11 + 2.0 * along[0] * along[1] * k12 + along[1] * along[1] * k22;
    if k <= 0.0 {
        return;
    }
    let wanted = speed / k;
    let size = if wanted <= p.friction[0] * normal { wanted } else { wanted.min(p.friction[1] * normal) };
    let change = [-along[0] * size, -along[1] * size];
    p.lambda[1] += change[0];
    p.lambda[2] += change[1];
    apply(rows, p, p.axes[1] * change[0] + p.axes[2] * change[1]);
}

impl Workspace {
    /// The order of an island's points in an iteration: as they lie, or shuffled (Fisher and Yates, SplitMix64).
    fn arrange(&mut self, count: usize, iteration: u32, shuffle: bool) {
        self.order.clear();
        self.order.extend(0..count as u32);
        if !shuffle {
            return;
        }
        let mut state = u64::from(iteration);
        for i in (1..count).rev() {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            self.order.swap(i, ((z ^ (z >> 31)) % (i as u64 + 1)) as usize);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_iteration_has_its_own_order_of_all_points() {
        let mut work = Workspace::default();
        let mut orders = Vec::new();
        for iteration in 0..8 {
            work.arrange(20, iteration, true);
            let mut sorted = work.order.clone();
            sorted.sort_unstable();
            assert!(sorted.iter().copied().eq(0..20));
            assert!(!orders.contains(&work.order), "an order came twice");
            orders.push(work.order.clone());
            work.arrange(20, iteration, true);
            assert_eq!(orders.last(), Some(&work.order), "the same number gives the same order");
        }
        work.arrange(20, 3, false);
        assert!(work.order.iter().copied().eq(0..20));
    }
}
