//! Joints of a world: what is remembered of each.

use super::gear::Coordinate;
use super::geometry::{Angle, Geometry, twist};
use super::parts::{about, along};
use super::{JointKind, JointRow, Law, MAX_ROWS};
use crate::body::{BodyStore, NONE, SetId};
use crate::math::{Float, Pose, Vec3, rotate};
use crate::world::BodyType;

/// A joint.
#[derive(Clone, Debug)]
pub struct Joint {
    /// What it does.
    pub kind: JointKind,
    /// Stable indices of bodies A and B, and for gears of the second joint's A and B; [`NONE`] for none.
    pub bodies: [u32; 4],
    /// Body from frame, at the bodies' origins.
    pub frames: [Pose; 2],
    /// Whether the two bodies collide.
    pub collide_connected: bool,
    /// Stiffness of the hard rows \[Hz\]; 0 is rigid.
    pub hertz: Float,
    /// Their damping ratio.
    pub damping_ratio: Float,
    /// Above this force the joint makes an event \[N\].
    pub force_threshold: Float,
    /// Above this torque the joint makes an event \[N m\].
    pub torque_threshold: Float,
    /// Whether it breaks there.
    pub breakable: bool,
    /// Size in drawings.
    pub draw_scale: Float,
    /// Anything.
    pub user_data: u64,
    /// Whether it acts: all of its bodies are enabled. Written when that changes.
    pub active: bool,
    /// For gears: the coordinates of the joints when this one was made, and with it their part of the constant.
    pub start: [f64; 2],
    /// Impulses of the last sub-step, by row \[N s\]. By `solve`.
    pub impulse: [Float; MAX_ROWS],
    /// The turns that coordinates have made. By `solve`, and when bodies are moved.
    pub turns: [Angle; 2],
    /// Sum of the impulses on B over the last step \[N s\]. By `solve`.
    pub total: Vec3,
    /// Sum of the angular impulses on B about the origin of frame B over the last step \[N m s\]. By `solve`.
    pub total_angular: Vec3,
    /// Length of the step they are of \[s\].
    pub total_dt: Float,
    /// At what share of the full speed errors are pushed out: less where pushing does not help. By `solve`.
    pub push: Float,
}

impl Joint {
    /// The bodies, without the places that are not taken; a gear's may name one twice.
    pub fn members(&self) -> impl Iterator<Item = u32> + '_ {
        self.bodies.iter().copied().filter(|&b| b != NONE)
    }

    /// Whether it ties islands together.
    pub(crate) fn ties(&self) -> bool {
        !matches!(self.kind, JointKind::Filter)
    }

    /// Whether it takes momentum from the world: one of its bodies is immovable, or a fixed point takes part.
    pub(crate) fn holds_to_world(&self, immovable: impl Fn(u32) -> bool) -> bool {
        matches!(self.kind, JointKind::Pulley(_)) || self.members().any(immovable)
    }

    /// Forgets the impulses of the last step.
    pub fn clear_impulses(&mut self) {
        self.impulse = [0.0; MAX_ROWS];
        (self.total, self.total_angular) = (Vec3::zeros(), Vec3::zeros());
    }

    /// Where the frames are.
    #[must_use]
    pub fn geometry(&self, bodies: &BodyStore) -> Geometry {
        let mut g = geometry_of([self.bodies[0], self.bodies[1]], &self.frames, bodies);
        g.turns = self.turns;
        g
    }

    /// Force on B over the last step \[N\], and torque about the origin of frame B \[N m\].
    #[must_use]
    pub fn force_and_torque(&self) -> (Vec3, Vec3) {
        if self.total_dt > 0.0 {
            (self.total / self.total_dt, self.total_angular / self.total_dt)
        } else {
            (Vec3::zeros(), Vec3::zeros())
        }
    }

    /// The errors of its hard rows, by the present poses: of lengths \[m\] and of angles \[rad\].
    #[must_use]
    pub fn separation(&self, bodies: &BodyStore) -> (Float, Float) {
        let (mut linear, mut angular) = (0.0, 0.0);
        self.kind.emit(&self.geometry(bodies), &mut |row: JointRow| {
            let error = match row.law {
                Law::Equal => row.c,
                Law::AtLeast => row.c.min(0.0),
                _ => return,
            };
            if row.angular {
                angular += error * error;
            } else {
                linear += error * error;
            }
        });
        (linear.sqrt(), angular.sqrt())
    }
}

fn geometry_of(pair: [u32; 2], frames: &[Pose; 2], bodies: &BodyStore) -> Geometry {
    let side = |k: usize| {
        let (set, row) = bodies.at(pair[k] as usize);
        let motion = &set.motion[row];
        (motion.x, rotate(&motion.q, frames[k].p - set.mass[row].center), motion.q * frames[k].q)
    };
    let ((xa, arm_a, qa), (xb, arm_b, qb)) = (side(0), side(1));
    Geometry {
        arm: [arm_a, arm_b],
        d: (xb - xa) + (arm_b - arm_a),
        q: [qa, qb],
        origin_a: xa + arm_a,
        turns: [Angle::default(); 2],
    }
}

/// The coordinate of a revolute or prismatic joint, for gears; `None` for others.
#[must_use]
pub fn coordinate(kind: &JointKind, g: &Geometry) -> Option<Coordinate> {
    match kind {
        JointKind::Revolute(_) => {
            let value = g.angle_about(2, 0).radians();
            Some(Coordinate { value, sides: about(g.axis(0, 2)) })
        }
        JointKind::Prismatic(_) => {
            let x = g.axis(0, 0);
            Some(Coordinate { value: g.d.dot(&x), sides: along(x, g.arms_at_b()) })
        }
        _ => None,
    }
}

/// Brings the counted turns up to date with the frames; called at least once per half turn.
pub fn follow_turns(kind: &JointKind, g: &Geometry, turns: &mut [Angle; 2]) {
    let axis = match kind {
        JointKind::Revolute(_) | JointKind::Wheel(_) => 2,
        JointKind::Screw(_) => 0,
        _ => return,
    };
    turns[0] = turns[0].next(twist(&g.relative(), axis));
}

/// All joints of a world, by stable index.
#[derive(Clone, Debug, Default)]
pub struct JointStore {
    /// Destroyed ones are left as they are until the index is used again.
    pub joints: Vec<Joint>,
    /// Indices of the joints in use, sorted.
    pub live: Vec<u32>,
    /// Changes whenever a joint comes, goes, or changes its rows.
    pub version: u64,
}

impl JointStore {
    /// Adds a joint with the stable index `index`; enters it into its bodies' lists.
    pub fn add(&mut self, index: usize, joint: Joint, bodies: &mut BodyStore) {
        for body in joint.members() {
            let list = &mut bodies.bodies[body as usize].joints;
            if !list.contains(&(index as u32)) {
                list.push(index as u32);
            }
        }
        if index == self.joints.len() {
            self.joints.push(joint);
        } else {
            self.joints[index] = joint;
        }
        let place = self.live.partition_point(|&j| (j as usize) < index);
        self.live.insert(place, index as u32);
        self.version += 1;
    }

    /// Takes a joint out of its bodies' lists.
    pub fn remove(&mut self, index: usize, bodies: &mut BodyStore) {
        let members = self.joints[index].bodies;
        for body in members.into_iter().filter(|&b| b != NONE) {
            bodies.bodies[body as usize].joints.retain(|&j| j as usize != index);
        }
        if let Ok(place) = self.live.binary_search(&(index as u32)) {
            self.live.remove(place);
        }
        self.version += 1;
    }

    /// Whether a joint takes part in the step: it acts, and one of its dynamic bodies is awake.
    #[must_use]
    pub fn is_awake(&self, index: u32, bodies: &BodyStore) -> bool {
        let joint = &self.joints[index as usize];
        joint.active
            && joint.members().any(|b| {
                let body = &bodies.bodies[b as usize];
                body.body_type == BodyType::Dynamic && body.set == SetId::AWAKE
            })
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.joints.capacity() * size_of::<Joint>() + self.live.capacity() * 4
    }
}
