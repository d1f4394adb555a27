//! Bodies on ideal joints, to near rounding: Newton's and Euler's equations with the joints' conditions on
//! accelerations, M a + Jᵀ λ = f and J a = γ, integrated by extrapolation.
//!
//! Conditions that follow from others (closed loops of hinges have some) are found by pivoting and left out: forces in
//! joints are then not unique, accelerations are. What rounding has left of a gap decays (Baumgarte's way): there is
//! none in the solution, but a loop that spins would tear the gap open. Rods, balls, hinges, slides and welds, loads, no contacts.

use super::extrapolation::Flow;
use crate::case::masses;
use crate::engines::Motion;
use crate::scene::{Body, Hold, Joint, Kind, Load, Scene, pull};
use crate::vector::{Q4, V3, add, conjugate, cross, dot, rotate, scale, sub, times, unit};

/// Numbers of a body in the state: place, rotation, velocity, spin.
const STATE: usize = 13;
/// A condition is taken to follow from others if its pivot has become this share of the greatest.
const RANK: f64 = 1e-12;

/// How fast gaps decay \[1/s\].
const DECAY: f64 = 20.0;

/// A condition on the accelerations of two bodies: what it has of each one's linear and angular, and their sum.
struct Row {
    /// What has to be nothing.
    gap: f64,
    bodies: [usize; 2],
    linear: [V3; 2],
    angular: [V3; 2],
    sum: f64,
}

/// The motions of the dynamic bodies at the given times, which grow from 0; fewer if the integration ends before.
pub fn motions(scene: &Scene, ends: &[f64], tolerance: f64) -> Vec<Vec<Motion>> {
    let dynamic = |b: &&Body| b.kind == Kind::Dynamic;
    let mut start = Vec::new();
    for m in scene.bodies.iter().filter(dynamic).map(Motion::of) {
        start.extend(m.position.iter().chain(&m.rotation).chain(&m.velocity).chain(&m.spin));
    }
    let system = System::new(scene);
    let mut flow = Flow::new(|y: &[f64], d: &mut [f64]| system.slope(y, d), start, tolerance);
    let mut found = Vec::new();
    for &t in ends {
        if !flow.advance(t) {
            break;
        }
        found.push(flow.y.chunks(STATE).map(motion).collect());
    }
    found
}

fn triple(y: &[f64]) -> V3 {
    [y[0], y[1], y[2]]
}

fn motion(y: &[f64]) -> Motion {
    Motion {
        position: triple(y),
        rotation: unit([y[3], y[4], y[5], y[6]]),
        velocity: triple(&y[7..]),
        spin: triple(&y[10..]),
    }
}

struct System<'a> {
    scene: &'a Scene,
    masses: Vec<(f64, V3)>,
    /// For each body of the scene, its place among the dynamic ones.
    dynamic: Vec<Option<usize>>,
}

impl<'a> System<'a> {
    fn new(scene: &'a Scene) -> Self {
        let mut count = 0;
        let mut next = |b: &Body| {
            (b.kind == Kind::Dynamic).then(|| {
                count += 1;
                count - 1
            })
        };
        Self { scene, masses: masses(scene), dynamic: scene.bodies.iter().map(&mut next).collect() }
    }

    fn motion(&self, body: usize, all: &[Motion]) -> Motion {
        self.dynamic[body].map_or_else(|| Motion::of(&self.scene.bodies[body]), |k| all[k])
    }

    fn slope(&self, y: &[f64], d: &mut [f64]) {
        let all: Vec<Motion> = y.chunks(STATE).map(motion).collect();
        let (mut linear, mut angular) = self.forces(&all);
        self.constrain(&all, &mut linear, &mut angular);
        for (k, m) in all.iter().enumerate() {
            let d = &mut d[STATE * k..STATE * (k + 1)];
            let q: Q4 = [y[STATE * k + 3], y[STATE * k + 4], y[STATE * k + 5], y[STATE * k + 6]];
            let turning = times([m.spin[0], m.spin[1], m.spin[2], 0.0], q);
            d[..3].copy_from_slice(&m.velocity);
            d[3..7].copy_from_slice(&turning.map(|x| 0.5 * x));
            d[7..10].copy_from_slice(&linear[k]);
            d[10..].copy_from_slice(&angular[k]);
        }
    }

    /// Accelerations without joints.
    fn forces(&self, all: &[Motion]) -> (Vec<V3>, Vec<V3>) {
        let mut linear = vec![self.scene.gravity; all.len()];
        let mut torque: Vec<V3> = (0..all.len())
            .map(|k| {
                let w = rotate(conjugate(all[k].rotation), all[k].spin);
                let l = [0, 1, 2].map(|i| self.masses[k].1[i] * w[i]);
                scale(rotate(all[k].rotation, cross(w, l)), -1.0)
            })
            .collect();
        for load in &self.scene.loads {
            match *load {
                Load::Torque(body, more) => {
                    let Some(k) = self.dynamic[body] else { continue };
                    torque[k] = add(torque[k], more);
                }
                Load::Spring { body, at, anchor, stiffness, rest } => {
                    let Some(k) = self.dynamic[body] else { continue };
                    let arm = rotate(all[k].rotation, sub(at, self.scene.bodies[body].center()));
                    let force = pull(add(all[k].position, arm), anchor, stiffness, rest);
                    linear[k] = add(linear[k], scale(force, 1.0 / self.masses[k].0));
                    torque[k] = add(torque[k], cross(arm, force));
                }
            }
        }
        let angular = (0..all.len()).map(|k| self.turned(k, &all[k], torque[k])).collect();
        (linear, angular)
    }

    /// The angular acceleration that a torque gives.
    fn turned(&self, k: usize, m: &Motion, torque: V3) -> V3 {
        let local = rotate(conjugate(m.rotation), torque);
        rotate(m.rotation, [0, 1, 2].map(|i| local[i] / self.masses[k].1[i]))
    }

    /// Adds what the joints do.
    fn constrain(&self, all: &[Motion], linear: &mut [V3], angular: &mut [V3]) {
        let rows: Vec<Row> = self.scene.joints.iter().flat_map(|j| self.rows(j, all)).collect();
        let n = rows.len();
        // Of each row, the accelerations that a unit of its force gives.
        let given: Vec<[[V3; 2]; 2]> = rows
            .iter()
            .map(|row| {
                [0, 1].map(|s| match self.dynamic[row.bodies[s]] {
                    None => [[0.0; 3]; 2],
                    Some(k) => [
                        scale(row.linear[s], 1.0 / self.masses[k].0),
                        self.turned(k, &all[k], row.angular[s]),
                    ],
                })
            })
            .collect();
        let mut matrix = vec![0.0; n * n];
        let mut right = vec![0.0; n];
        for i in 0..n {
            right[i] = rows[i].sum - DECAY * DECAY * rows[i].gap;
            for s in 0..2 {
                if let Some(k) = self.dynamic[rows[i].bodies[s]] {
                    let rate = dot(rows[i].linear[s], all[k].velocity) + dot(rows[i].angular[s], all[k].spin);
                    right[i] -= dot(rows[i].linear[s], linear[k])
                        + dot(rows[i].angular[s], angular[k])
                        + 2.0 * DECAY * rate;
                }
            }
            for j in 0..=i {
                let mut value = 0.0;
                for (s, u) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    if rows[i].bodies[s] == rows[j].bodies[u] {
                        value +=
                            dot(rows[i].linear[s], given[j][u][0]) + dot(rows[i].angular[s], given[j][u][1]);
                    }
                }
                matrix[i * n + j] = value;
                matrix[j * n + i] = value;
            }
        }
        let force = solve(n, &mut matrix, &right);
        for ((row, given), force) in rows.iter().zip(&given).zip(force) {
            for (&body, gives) in row.bodies.iter().zip(given) {
                if let Some(k) = self.dynamic[body] {
                    linear[k] = add(linear[k], scale(gives[0], force));
                    angular[k] = add(angular[k], scale(gives[1], force));
                }
            }
        }
    }

    fn rows(&self, joint: &Joint, all: &[Motion]) -> Vec<Row> {
        let m = joint.bodies.map(|b| self.motion(b, all));
        let pair = Pair::new(joint, m, joint.bodies.map(|b| self.scene.bodies[b].center()));
        let axis = |side: usize, k: usize| {
            let mut e = [0.0; 3];
            e[k] = 1.0;
            rotate(m[side].rotation, rotate(joint.axes[side], e))
        };
        let across = |a: usize, b: usize| pair.across(axis(0, a), axis(1, b));
        let together = || [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| pair.along(e));
        match joint.hold {
            Hold::Ball => together().into(),
            Hold::Hinge => {
                let mut rows: Vec<Row> = together().into();
                rows.extend([across(0, 2), across(1, 2)]);
                rows
            }
            Hold::Weld => {
                let mut rows: Vec<Row> = together().into();
                rows.extend([across(0, 1), across(1, 2), across(2, 0)]);
                rows
            }
            Hold::Slider(_) => vec![
                across(0, 1),
                across(1, 2),
                across(2, 0),
                pair.within(axis(0, 1)),
                pair.within(axis(0, 2)),
            ],
            Hold::Rod(length) => vec![pair.apart(length)],
            // A spring holds nothing; the scenes of this module have none between bodies.
            Hold::Spring(..) => Vec::new(),
        }
    }
}

/// Two bodies at a joint.
struct Pair {
    bodies: [usize; 2],
    /// From the centres of mass to the joint's points.
    arms: [V3; 2],
    spin: [V3; 2],
    /// From the first point to the second, and how it changes.
    gap: V3,
    speed: V3,
    /// The part of the points' accelerations that comes from spins, second less first.
    inward: V3,
}

impl Pair {
    fn new(joint: &Joint, m: [Motion; 2], centers: [V3; 2]) -> Self {
        let arms = [0, 1].map(|s| rotate(m[s].rotation, sub(joint.local[s], centers[s])));
        let point = |s: usize| add(m[s].position, arms[s]);
        let speed = |s: usize| add(m[s].velocity, cross(m[s].spin, arms[s]));
        let inward = |s: usize| cross(m[s].spin, cross(m[s].spin, arms[s]));
        Self {
            bodies: joint.bodies,
            arms,
            spin: [m[0].spin, m[1].spin],
            gap: sub(point(1), point(0)),
            speed: sub(speed(1), speed(0)),
            inward: sub(inward(1), inward(0)),
        }
    }

    /// The points do not come apart along a direction of the world.
    fn along(&self, e: V3) -> Row {
        Row {
            bodies: self.bodies,
            gap: dot(e, self.gap),
            linear: [scale(e, -1.0), e],
            angular: [scale(cross(self.arms[0], e), -1.0), cross(self.arms[1], e)],
            sum: -dot(e, self.inward),
        }
    }

    /// The points keep their distance.
    fn apart(&self, length: f64) -> Row {
        let row = self.along(self.gap);
        let gap = 0.5 * (dot(self.gap, self.gap) - length * length);
        Row { gap, sum: row.sum - dot(self.speed, self.speed), ..row }
    }

    /// A direction of the first body and one of the second stay across each other.
    fn across(&self, u: V3, w: V3) -> Row {
        let both = cross(u, w);
        let change = add(cross(cross(self.spin[0], u), w), cross(u, cross(self.spin[1], w)));
        Row {
            bodies: self.bodies,
            gap: dot(u, w),
            linear: [[0.0; 3]; 2],
            angular: [both, scale(both, -1.0)],
            sum: -dot(sub(self.spin[0], self.spin[1]), change),
        }
    }

    /// The second point stays in the plane across a direction of the first body.
    fn within(&self, y: V3) -> Row {
        let row = self.along(y);
        let turning = cross(self.spin[0], y);
        let rest = 2.0 * dot(self.speed, turning) + dot(self.gap, cross(self.spin[0], turning));
        let angular = [add(row.angular[0], cross(y, self.gap)), row.angular[1]];
        Row { angular, sum: row.sum - rest, ..row }
    }
}

/// Cholesky's way with pivots: rows that follow from others get no force.
fn solve(n: usize, a: &mut [f64], right: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..n).collect();
    let greatest = (0..n).map(|i| a[i * n + i]).fold(0.0, f64::max);
    let mut rank = n;
    for k in 0..n {
        let at = |order: &[usize], i: usize, j: usize| order[i] * n + order[j];
        let best = (k..n)
            .max_by(|&i, &j| a[at(&order, i, i)].total_cmp(&a[at(&order, j, j)]))
            .expect("at least one is left");
        order.swap(k, best);
        let pivot = a[at(&order, k, k)];
        if pivot <= RANK * greatest {
            rank = k;
            break;
        }
        let root = pivot.sqrt();
        a[at(&order, k, k)] = root;
        for i in k + 1..n {
            a[at(&order, i, k)] /= root;
        }
        for i in k + 1..n {
            for j in k + 1..=i {
                let value = a[at(&order, i, j)] - a[at(&order, i, k)] * a[at(&order, j, k)];
                a[at(&order, i, j)] = value;
                a[at(&order, j, i)] = value;
            }
        }
    }
    let factor = |i: usize, j: usize| a[order[i] * n + order[j]];
    let mut x = vec![0.0; rank];
    for i in 0..rank {
        x[i] = (right[order[i]] - (0..i).map(|k| factor(i, k) * x[k]).sum::<f64>()) / factor(i, i);
    }
    for i in (0..rank).rev() {
        x[i] = (x[i] - (i + 1..rank).map(|k| factor(k, i) * x[k]).sum::<f64>()) / factor(i, i);
    }
    let mut force = vec![0.0; n];
    for (i, value) in x.into_iter().enumerate() {
        force[order[i]] = value;
    }
    force
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::references::chain;
    use crate::scenes::group_e::{point, rods};
    use crate::vector::norm;

    /// A way that shares nothing with angles of a chain ends where they do.
    #[test]
    fn a_chain_swings_as_its_angles_do() {
        let scene = rods("chain", "", 3, 0.4, 1.0);
        let ends = [0.3, 0.6, 0.9];
        let found = motions(&scene, &ends, 1e-12);
        let exact = chain::tips(3, 0.4, 9.81, &ends);
        for (frame, tip) in found.iter().zip(exact) {
            let off = norm(sub(point(&frame[2], [0.2, 0.0, 0.0]), [tip[0], tip[1], 0.0]));
            assert!(off < 1e-9, "{off}");
        }
        assert_eq!(found.len(), 3);
    }
}
