//! A half-space A against everything that has a lowest point.

use crate::math::{Float, Pose, Vec3};
use crate::narrow_phase::contact::{Manifold, feature};
use crate::narrow_phase::frame::Frame;
use crate::narrow_phase::manifold::reduce::{Candidate, reduce};
use crate::shape::{Capsule, HalfSpace, Polytope, Sphere};

/// Adds the contact of a ball of B at `p` (in the frame of A).
fn add_ball(h: &HalfSpace, p: Vec3, radius: Float, margin: Float, id: u32, out: &mut Manifold) {
    let separation = h.height(p) - radius;
    if separation <= margin {
        out.normal = h.normal();
        out.push(p - h.normal() * (radius + 0.5 * separation), separation, id);
    }
}

pub(in crate::narrow_phase) fn half_space_sphere(
    h: &HalfSpace,
    s: &Sphere,
    pose: &Pose,
    margin: Float,
    out: &mut Manifold,
) {
    add_ball(h, pose.point(s.center()), s.radius(), margin, feature::vertex_b(0), out);
}

pub(in crate::narrow_phase) fn half_space_capsule(
    h: &HalfSpace,
    c: &Capsule,
    pose: &Pose,
    margin: Float,
    out: &mut Manifold,
) {
    add_ball(h, pose.point(c.center1()), c.radius(), margin, feature::vertex_b(0), out);
    add_ball(h, pose.point(c.center2()), c.radius(), margin, feature::vertex_b(1), out);
}

pub(in crate::narrow_phase) fn half_space_polytope<P: Polytope>(
    h: &HalfSpace,
    p: &P,
    pose: &Pose,
    margin: Float,
    out: &mut Manifold,
) {
    // In the frame of B first: a body far above costs one dot product a vertex.
    let down = -pose.vector_back(h.normal());
    let base = h.height(pose.p);
    if base - down.dot(&p.vertex(p.support(down))) > margin {
        return;
    }
    let frame = Frame::new(pose);
    if p.vertex_count() <= 32 {
        gather::<P, 32>(h, p, &frame, margin, out);
    } else {
        gather::<P, 256>(h, p, &frame, margin, out);
    }
}

fn gather<P: Polytope, const N: usize>(
    h: &HalfSpace,
    p: &P,
    frame: &Frame,
    margin: Float,
    out: &mut Manifold,
) {
    let mut low = [Candidate::default(); N];
    let mut n = 0;
    for i in 0..p.vertex_count() {
        let v = frame.point(p.vertex(i));
        let separation = h.height(v);
        if separation <= margin {
            low[n] = Candidate {
                point: v - h.normal() * (0.5 * separation),
                separation,
                feature: feature::vertex_b(i),
            };
            n += 1;
        }
    }
    out.normal = h.normal();
    reduce(&low[..n], out);
}
