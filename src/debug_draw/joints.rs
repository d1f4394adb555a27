//! What is drawn of joints: lines from the bodies to the frames, the axes of what is free, and, as extras, frames and
//! limits.

use super::shape::arc;
use super::{Canvas, DrawOptions, colors};
use crate::constraint::joint::{Geometry, JointKind, Limit, SphericalJoint};
use crate::math::scalar::{PI, sin_cos};
use crate::math::{Aabb, Float, Pose, Vec3};
use crate::world::{JointRef, World};

/// The size of points, in pixels.
const POINT_SIZE: Float = 6.0;
/// The size of a joint with a scale of 1 \[m\]: half the length of its axis.
const SIZE: Float = 0.25;

pub(super) fn joints(world: &World, options: &DrawOptions, canvas: &mut dyn Canvas) {
    for &index in &world.joints.live {
        let index = index as usize;
        let joint = &world.joints.joints[index];
        if !joint.active {
            continue;
        }
        let g = joint.geometry(&world.bodies);
        let (a, b) = (g.origin_a, g.origin_a + g.d);
        let origins = [0, 1].map(|side| {
            let (set, row) = world.bodies.at(joint.bodies[side] as usize);
            set.origin(row).p
        });
        if !Aabb::of_points(&[a, b, origins[0], origins[1]]).overlaps(&options.bounds) {
            continue;
        }
        let size = SIZE * joint.draw_scale * options.joint_scale;
        let mut pen = Pen { g, a, b, size, canvas: &mut *canvas };
        match &joint.kind {
            JointKind::Filter => pen.line(origins[0], origins[1]),
            JointKind::Gear(gear) | JointKind::RackPinion(gear) => {
                let [first, second] =
                    gear.joints.map(|slot| JointRef { world, index: slot as usize }.geometry().origin_a);
                pen.line(first, second);
            }
            kind => {
                pen.line(origins[0], a);
                pen.line(origins[1], b);
                pen.free(kind);
                if options.joint_extras {
                    pen.extras(kind);
                }
            }
        }
    }
}

/// Draws one joint.
struct Pen<'a> {
    g: Geometry,
    /// The origins of the frames.
    a: Vec3,
    b: Vec3,
    size: Float,
    canvas: &'a mut dyn Canvas,
}

impl Pen<'_> {
    fn line(&mut self, from: Vec3, to: Vec3) {
        self.canvas.segment(from, to, colors::JOINT);
    }

    fn dot(&mut self, at: Vec3) {
        self.canvas.point(at, POINT_SIZE, colors::JOINT);
    }

    /// Axis `k` of frame `side`, both ways.
    fn axis(&mut self, side: usize, k: usize) {
        let at = if side == 0 { self.a } else { self.b };
        let u = self.g.axis(side, k) * self.size;
        self.canvas.segment(at - u, at + u, colors::AXIS);
    }

    /// What the joint lets the bodies do.
    fn free(&mut self, kind: &JointKind) {
        match kind {
            JointKind::Distance(_) | JointKind::Motor(_) => {
                self.line(self.a, self.b);
                self.dot(self.a);
                self.dot(self.b);
            }
            JointKind::Pulley(pulley) => {
                let [over_a, over_b] = pulley.ground;
                for (from, to) in [(self.a, over_a), (over_a, over_b), (over_b, self.b)] {
                    self.line(from, to);
                }
                self.dot(over_a);
                self.dot(over_b);
            }
            JointKind::Revolute(_) | JointKind::Parallel(_) => self.axis(0, 2),
            JointKind::Prismatic(_) | JointKind::Screw(_) => self.axis(0, 0),
            JointKind::Wheel(_) => {
                self.axis(0, 0);
                self.axis(1, 2);
            }
            JointKind::Universal(_) => {
                self.axis(0, 0);
                self.axis(1, 1);
            }
            JointKind::SixDof(_) => {
                for k in 0..3 {
                    self.axis(0, k);
                }
            }
            JointKind::Spherical(_) | JointKind::Weld(_) => self.dot(self.a),
            JointKind::Filter | JointKind::Gear(_) | JointKind::RackPinion(_) => {}
        }
    }

    /// Frames and limits.
    fn extras(&mut self, kind: &JointKind) {
        for (side, p) in [(0, self.a), (1, self.b)] {
            self.canvas.frame(&Pose { p, q: self.g.q[side] }, self.size);
        }
        match kind {
            JointKind::Revolute(j) => self.angles(2, &j.drive.limit),
            JointKind::Screw(j) => self.angles(0, &j.drive.limit),
            JointKind::Prismatic(j) => self.lengths(self.g.axis(0, 0), &j.drive.limit),
            JointKind::Wheel(j) => self.lengths(self.g.axis(0, 0), &j.suspension.limit),
            JointKind::Distance(j) => {
                let along = crate::math::normalize_or(self.g.d, self.g.axis(0, 0));
                self.lengths(along, &j.limit);
            }
            JointKind::Spherical(j) => self.cone(j),
            _ => {}
        }
    }

    /// Limits of a turn about axis `k` of frame A: where the next axis of frame B may point.
    fn angles(&mut self, k: usize, limit: &Limit) {
        if !limit.enable {
            return;
        }
        let axes = [(k + 1) % 3, (k + 2) % 3].map(|k| self.g.axis(0, k) * self.size);
        arc(self.canvas, self.a, (axes[0], axes[1]), (limit.lower, limit.upper), colors::LIMIT);
        for angle in [limit.lower, limit.upper] {
            let (sine, cosine) = sin_cos(angle);
            self.canvas.segment(self.a, self.a + axes[0] * cosine + axes[1] * sine, colors::LIMIT);
        }
    }

    /// Limits of a slide.
    fn lengths(&mut self, along: Vec3, limit: &Limit) {
        if limit.enable {
            let [lower, upper] = [limit.lower, limit.upper].map(|x| self.a + along * x);
            self.canvas.segment(lower, upper, colors::LIMIT);
            self.canvas.point(lower, POINT_SIZE, colors::LIMIT);
            self.canvas.point(upper, POINT_SIZE, colors::LIMIT);
        }
    }

    /// The rim of the cone in which z of frame B stays, and some lines to it.
    fn cone(&mut self, joint: &SphericalJoint) {
        if !joint.enable_cone_limit {
            return;
        }
        const STEPS: usize = 16;
        let frame = Pose { p: self.a, q: self.g.q[0] };
        let rim = |k: usize| {
            let (sine, cosine) = sin_cos(2.0 * PI * (k % STEPS) as Float / STEPS as Float);
            // A turn by this rotation vector across z, as far as the cone goes in its direction.
            let (x, y) = (joint.cone_angle[0] * cosine, joint.cone_angle[1] * sine);
            let angle = (x * x + y * y).sqrt();
            let (sa, ca) = sin_cos(angle);
            let tip = if angle > 0.0 { Vec3::new(y * sa / angle, -x * sa / angle, ca) } else { Vec3::z() };
            frame.point(tip * self.size)
        };
        for k in 0..STEPS {
            self.canvas.segment(rim(k), rim(k + 1), colors::LIMIT);
            if k % 4 == 0 {
                self.canvas.segment(self.a, rim(k), colors::LIMIT);
            }
        }
    }
}
