//! Sub-steps by the accuracy that a world has to keep, see [`crate::island::pacing`].

use super::World;
use crate::body::SetId;
use crate::island::pacing::{Column, Moved, Pacing};
use crate::math::{Float, length, scalar::PI};
use crate::solver::bodies::Bodies;
use crate::solver::{Settings, Work};

/// Rehearsals of a step. Nothing in it outlives the step but memory.
#[derive(Debug, Default)]
pub(crate) struct Rehearsal {
    work: Work,
    /// What the two trials did, by awake row.
    moved: [Vec<Option<Moved>>; 2],
}

impl Clone for Rehearsal {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Rehearsal {
    pub fn byte_count(&self) -> usize {
        let rows: usize = self.moved.iter().map(|list| list.capacity()).sum();
        self.work.byte_count() + rows * size_of::<Option<Moved>>()
    }
}

impl World {
    /// Tries the coming step with other numbers of sub-steps on the islands whose turn it is.
    pub(super) fn rehearse(&mut self, settings: &Settings) {
        if self.def.accuracy == 0.0 || !self.choose_rehearsed(settings.sub_steps) {
            return;
        }
        let Rehearsal { work, moved } = &mut self.rehearsal;
        for (trial, moved) in moved.iter_mut().enumerate() {
            work.prepare(
                &self.bodies,
                &mut self.contacts,
                &self.joints,
                &mut self.islands,
                settings,
                Some(trial),
            );
            work.rehearse(&self.bodies, &self.joints, settings);
            moved.clear();
            moved.resize(self.bodies.awake().len(), None);
            for row in work.bodies.islands.iter().flat_map(|island| island.rows.clone()) {
                moved[work.bodies.rows.aux[row].awake_row as usize] = Some(of_row(&work.bodies, row));
            }
        }
    }

    /// Which awake islands are to be rehearsed: those whose turn it is, but for free bodies that have an exact way.
    fn choose_rehearsed(&mut self, sub_steps: u32) -> bool {
        let mut any = false;
        for island in &mut self.islands.islands {
            let Some(&first) = island.bodies.first() else { continue };
            let body = &self.bodies.bodies[first as usize];
            island.pacing.rehearsed = false;
            if body.set != SetId::AWAKE {
                continue;
            }
            let is_free = island.bodies.len() == 1 && body.joints.is_empty() && body.contacts.is_empty();
            if is_free && self.bodies.awake().mass[body.row as usize].isotropic {
                // It may come from an island that needed more.
                if island.pacing.level > 0 {
                    island.pacing = Pacing::default();
                }
                continue;
            }
            island.pacing.rehearsed = island.pacing.begin_step(sub_steps);
            any |= island.pacing.rehearsed;
        }
        any
    }

    /// Compares the step that was taken with its rehearsals, and chooses the sub-steps of the next ones.
    pub(super) fn judge_rehearsals(&mut self, settings: &Settings) {
        let allowed = self.def.accuracy;
        if allowed == 0.0 {
            return;
        }
        let gravity = length(settings.gravity);
        let stiffness = 2.0 * PI * settings.stiffness / settings.h();
        let bodies = &self.work.bodies;
        for awake in &bodies.islands {
            let island = &mut self.islands.islands[awake.id as usize];
            if !island.pacing.rehearsed {
                island.pacing.pass();
                continue;
            }
            let [low, high] = island.pacing.trials(settings.sub_steps);
            let (mut way, mut size): (Float, Float) = (0.0, Float::INFINITY);
            let mut apart: [Float; 2] = [0.0; 2];
            for row in awake.rows.clone() {
                let at = bodies.rows.aux[row].awake_row as usize;
                let own = of_row(bodies, row);
                let trials = [self.rehearsal.moved[0][at], self.rehearsal.moved[1][at]];
                let [Some(first), Some(second)] = trials else { continue };
                // From coarse to fine.
                let answers = match island.pacing.level {
                    level if level > high => [first, second, own],
                    level if level > low => [first, own, second],
                    _ => [own, first, second],
                };
                let extent = self.bodies.awake().mass[at].extent;
                // Next to rest, what a body of its size does under gravity in its own time, √(L/g), is the measure.
                let own_way = own.way(extent, settings.dt) + (gravity * extent).sqrt() * settings.dt;
                way += own_way * own_way;
                size = size.min(extent);
                for (k, apart) in apart.iter_mut().enumerate() {
                    let distance = answers[k].apart(&answers[k + 1], extent, settings.dt);
                    *apart += distance * distance;
                }
            }
            let stands = island.anchored && awake.constraints > 0 && size > 0.0;
            let column = stands.then(|| Column {
                bodies: awake.rows.len(),
                height: island.height,
                ratio: self.work.soft_step.ratio_of(awake.id),
                size,
            });
            island.pacing.stand(column, gravity, stiffness);
            // Root mean squares of all its bodies; where nothing moves, there is no error.
            let apart = apart.map(|a| if way > 0.0 { (a / way).sqrt() } else { 0.0 });
            island.pacing.choose(apart, allowed, settings.sub_steps);
        }
    }

    /// The most sub-steps that an awake island had in the last step, and the greatest error that the rehearsals of awake
    /// islands found last; the world's own number, and 0, without an accuracy.
    pub(super) fn pace(&self) -> (u32, Float) {
        let mut pace = (self.last_sub_steps, 0.0);
        if self.def.accuracy > 0.0 {
            for batch in &self.work.bodies.batches {
                pace.0 = pace.0.max(self.last_sub_steps << batch.level);
            }
            for island in self.islands.islands.iter().filter(|island| !island.bodies.is_empty()) {
                let body = &self.bodies.bodies[island.bodies[0] as usize];
                if body.set == SetId::AWAKE {
                    pace.1 = island.pacing.error.max(pace.1);
                }
            }
        }
        pace
    }
}

/// What the step has done to the body of a solver row.
fn of_row(bodies: &Bodies, row: usize) -> Moved {
    let row = &bodies.rows.row[row];
    Moved { by: row.dx(), turned: row.dq(), v: row.v(), w: row.w() }
}
