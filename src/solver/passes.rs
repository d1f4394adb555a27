//! The passes over bodies of a sub-step.

use super::bodies::Bodies;
use super::rows::{InertiaRow, Row, inertia_times, inverse_inertia};
use super::{Settings, SubStep};
use crate::body::store::without;
use crate::body::{BodyStore, NONE};
use crate::integrate::{Integrator, PrincipalAxes, with_integrator};
use crate::math::{Float, Quat, Vec3, length};

impl Bodies {
    /// Velocities after forces, damping and (but for the first sub-step) what constraints changed last time.
    pub fn apply_forces(&mut self, batch: usize, first: bool, sub: &SubStep, settings: &Settings) {
        let range = self.batches[batch].rows.clone();
        let h = sub.h;
        for i in range {
            let (row, aux, inertia) = (&mut self.rows.row[i], &mut self.rows.aux[i], &self.rows.inertia[i]);
            let mut v = row.v() + aux.accel * h;
            let mut w = row.w();
            if aux.torque != Vec3::zeros() {
                w += inertia.times(aux.torque * h);
                aux.l += aux.torque * h;
            }
            if aux.damping != [1.0; 2] {
                v *= aux.damping[0];
                w *= aux.damping[1];
                aux.l *= aux.damping[1];
            }
            if settings.maximum_linear_speed.is_finite() {
                let speed = length(v);
                if speed > settings.maximum_linear_speed {
                    v *= settings.maximum_linear_speed / speed;
                }
            }
            aux.before = [v, w];
            if !first && settings.warm_starting {
                v += aux.warm[0];
                w += if aux.spin { inertia.times(aux.warm[1]) } else { aux.warm[1] };
            }
            row.set_v(v);
            row.set_w(w);
        }
    }

    /// Moves and turns the bodies of a batch by their velocities.
    pub fn move_bodies(&mut self, batch: usize, bodies: &BodyStore, sub: &SubStep) {
        with_integrator!(sub.integrator, I => self.move_by::<I>(batch, bodies, sub.h));
    }

    fn move_by<I: Integrator>(&mut self, batch: usize, bodies: &BodyStore, h: Float) {
        for i in self.batches[batch].rows.clone() {
            let (row, aux, inertia) =
                (&mut self.rows.row[i], &mut self.rows.aux[i], &mut self.rows.inertia[i]);
            if aux.locked {
                let locks = &bodies.awake().drive[aux.awake_row as usize].locks;
                row.set_v(without(row.v(), locks.linear));
                row.set_w(without(row.w(), locks.angular));
            }
            let (v, mut w) = (row.v(), row.w());
            // Without a constraint the way may be exact: v has had the whole sub-step's acceleration, the way half.
            let free = v == aux.before[0] && w == aux.before[1];
            let lag = if free || aux.lags() { I::LAG * h } else { 0.0 };
            row.set_dx(row.dx() + (v - aux.accel * lag) * h);
            if aux.spin {
                aux.first_dl = if free { Vec3::zeros() } else { inertia_times(aux, w - aux.before[1]) };
                aux.l += aux.first_dl;
                let axes = PrincipalAxes { moments: aux.moments, body_from_principal: Quat::identity() };
                aux.q[0] = I::turn(&aux.q[0], aux.l - aux.torque * lag, &axes, h);
                row.set_dq(&(aux.q[0] * aux.q[1].conjugate()));
                *inertia = InertiaRow::new(&inverse_inertia(aux));
                w = inertia.times(aux.l);
                row.set_w(w);
            } else {
                let mean = if aux.torque == Vec3::zeros() { w } else { w - inertia.times(aux.torque) * lag };
                turn_row::<I>(row, mean * h);
            }
            aux.middle = [v, w];
            aux.joint_middle = aux.joint[0];
        }
        for i in self.batches[batch].kinematic.clone() {
            let row = &mut self.rows.row[i];
            row.set_dx(row.dx() + row.v() * h);
            let w = row.w();
            turn_row::<I>(row, w * h);
        }
    }

    /// Notes what constraints changed in this sub-step, for the next one's warm start.
    pub fn carry_over(&mut self, batch: usize, bodies: &BodyStore) {
        for i in self.batches[batch].rows.clone() {
            let (row, aux) = (&mut self.rows.row[i], &mut self.rows.aux[i]);
            if aux.locked {
                let locks = &bodies.awake().drive[aux.awake_row as usize].locks;
                row.set_v(without(row.v(), locks.linear));
                row.set_w(without(row.w(), locks.angular));
            }
            let (v, w) = (row.v(), row.w());
            let dv = v - aux.before[0];
            if aux.spin {
                let dw = w - aux.middle[1];
                let dl = if dw == Vec3::zeros() { dw } else { inertia_times(aux, dw) };
                aux.l += dl;
                aux.warm = [dv, aux.first_dl + dl];
            } else {
                aux.warm = [dv, w - aux.before[1]];
            }
            // Joints warm-start by themselves, as their arms turn.
            if aux.jointed {
                aux.warm[0] -= aux.joint[0] * row.inv_mass();
                aux.warm[1] -= if aux.spin { aux.joint[1] } else { self.rows.inertia[i].times(aux.joint[1]) };
                if !aux.touched {
                    aux.warm = [Vec3::zeros(); 2];
                }
            }
            aux.supported = aux.warm[0] != Vec3::zeros() || aux.warm[1] != Vec3::zeros();
        }
    }

    /// Impulses act at points fixed for the step while bodies move on: a pair that moved by Δx against each other
    /// loses Δx × P of angular momentum. Each body of an isolated island gets L −= (Δx − Δx̄) × ΔP for the momentum
    /// ΔP that constraints gave it, Δx̄ being the island's mean displacement (any would do, as ΣΔP = 0; this one
    /// makes the result independent of the island's velocity).
    pub fn keep_angular_momentum(&mut self, batch: usize, after_relax: bool) {
        for range in self.isolated[self.batches[batch].isolated.clone()].iter().cloned() {
            let (mut mass, mut shift) = (0.0, Vec3::zeros());
            for i in range.clone() {
                mass += self.rows.aux[i].mass;
                shift += self.rows.row[i].dx() * self.rows.aux[i].mass;
            }
            let mean = if mass > 0.0 { shift / mass } else { Vec3::zeros() };
            for i in range {
                let (row, aux) = (&mut self.rows.row[i], &mut self.rows.aux[i]);
                let since = if after_relax { aux.middle[0] } else { aux.before[0] };
                let mut dp = (row.v() - since) * aux.mass;
                if aux.jointed {
                    // Joints act at the present places and lose nothing.
                    dp -= if after_relax { aux.joint[0] - aux.joint_middle } else { aux.joint[0] };
                    if !aux.touched {
                        continue;
                    }
                }
                if dp == Vec3::zeros() {
                    continue;
                }
                let lost = (row.dx() - mean).cross(&dp);
                let dw = self.rows.inertia[i].times(lost);
                row.set_w(row.w() - dw);
                // Not an impulse of a constraint: it is no part of the warm start.
                aux.before[1] -= dw;
                if aux.spin {
                    aux.l -= lost;
                }
            }
        }
    }

    /// Writes moves and momenta back to the bodies. Bodies whose state stopped being finite keep the one they
    /// began the step with; their stable indices are returned in `broken`.
    pub fn write_back(&self, bodies: &mut BodyStore, broken: &mut Vec<u32>) {
        let set = &mut bodies.sets[crate::body::SetId::AWAKE.0 as usize];
        for batch in &self.batches {
            for i in batch.rows.clone() {
                let (row, aux) = (&self.rows.row[i], &self.rows.aux[i]);
                let at = aux.awake_row as usize;
                debug_assert!(aux.awake_row != NONE);
                let (v, w, dx, dq) = (row.v(), row.w(), row.dx(), row.dq());
                let old = set.motion[at];
                let mut new = old;
                new.shift(dx);
                new.q = if aux.spin { aux.q[0] * set.mass[at].principal.conjugate() } else { dq * old.q };
                new.q = crate::math::quat(new.q.w, Vec3::new(new.q.i, new.q.j, new.q.k));
                let (dv, dw) = (v - aux.begin[0], w - aux.begin[1]);
                new.p = if aux.mass > 0.0 { old.p + dv * aux.mass } else { v };
                new.l = if aux.spin && aux.extra == 0.0 {
                    aux.l
                } else if aux.spin {
                    set.mass[at].inertia_times(&new.q, w)
                } else if set.mass[at].turns() {
                    old.l + set.mass[at].inertia_times(&old.q, dw)
                } else {
                    w
                };
                if !new.is_finite() {
                    broken.push(set.index[at]);
                    continue;
                }
                set.motion[at] = new;
                if !set.mass[at].isotropic {
                    set.refresh_inertia(at);
                }
            }
        }
    }
}

/// Δq turned by the rotation vector `a` \[rad\].
#[inline]
fn turn_row<I: Integrator>(row: &mut Row, a: Vec3) {
    if a != Vec3::zeros() {
        row.set_dq(&I::turn_by(&row.dq(), a));
    }
}
