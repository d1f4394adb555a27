//! Spheres and capsules among themselves, and a sphere against a box.

use crate::math::{Float, Pose, Vec3, abs, any_tangent, length, length_squared, normalize_or};
use crate::narrow_phase::contact::{Manifold, feature};
use crate::shape::{Capsule, Cuboid, Sphere};

pub(in crate::narrow_phase) fn sphere_sphere(
    a: &Sphere,
    b: &Sphere,
    pose: &Pose,
    margin: Float,
    out: &mut Manifold,
) {
    out.between_balls((a.center(), a.radius()), (pose.point(b.center()), b.radius()), margin, Vec3::y(), 0);
}

pub(in crate::narrow_phase) fn sphere_capsule(
    a: &Sphere,
    b: &Capsule,
    pose: &Pose,
    margin: Float,
    out: &mut Manifold,
) {
    let p = b.on_segment(pose.point_back(a.center()));
    // A centre on the axis may leave along any normal of the axis.
    let fallback = any_tangent(pose.vector(normalize_or(b.center2() - b.center1(), Vec3::y())));
    out.between_balls((a.center(), a.radius()), (pose.point(p), b.radius()), margin, fallback, 0);
}

/// Outside, the closest point of the box decides; inside, the nearest face.
pub(in crate::narrow_phase) fn sphere_box(
    a: &Sphere,
    b: &Cuboid,
    pose: &Pose,
    margin: Float,
    out: &mut Manifold,
) {
    let (c, half) = (pose.point_back(a.center()), b.half());
    let on_box = c.zip_map(&half, |x, h| x.clamp(-h, h));
    let d = on_box - c;
    let distance = length(d);
    let reach = a.radius() + margin;
    if distance > reach {
        return;
    }
    let normal;
    let gap;
    if distance > 0.0 && length_squared(d) > Float::MIN_POSITIVE * 4.0 {
        (normal, gap) = (d / distance, distance);
    } else {
        let room = half - abs(c);
        let k = if room.x <= room.y && room.x <= room.z {
            0
        } else if room.y <= room.z {
            1
        } else {
            2
        };
        let mut n = Vec3::zeros();
        n[k] = if c[k] >= 0.0 { -1.0 } else { 1.0 };
        (normal, gap) = (n, -room[k]);
        if gap - a.radius() > margin {
            return;
        }
    }
    let separation = gap - a.radius();
    out.normal = pose.vector(normal);
    out.push(pose.point(c + normal * (0.5 * (gap + a.radius()))), separation, 0);
}

pub(in crate::narrow_phase) fn capsule_capsule(
    a: &Capsule,
    b: &Capsule,
    pose: &Pose,
    margin: Float,
    out: &mut Manifold,
) {
    let (p, q) = ([a.center1(), a.center2()], [pose.point(b.center1()), pose.point(b.center2())]);
    let (u, v) = (p[1] - p[0], q[1] - q[0]);
    let (s, t) = closest_of_segments(p, q);
    let d = q[0] + v * t - (p[0] + u * s);
    let (distance, reach) = (length(d), a.radius() + b.radius());
    if distance - reach > margin {
        return;
    }
    let across = u.cross(&v);
    let fallback = normalize_or(across, any_tangent(u / length(u)));
    let normal = normalize_or(d, fallback);
    out.normal = normal;
    // Side by side: one point at each end of the stretch where both axes run along each other, provided that the
    // gap there is the gap along the normal, that is, that the axes do not cross like an X.
    let uu = length_squared(u);
    let along = |x: Vec3| (x - p[0]).dot(&u) / uu;
    let on_b = [along(q[0]), along(q[1])];
    let (first, last) = if on_b[0] <= on_b[1] { (0, 1) } else { (1, 0) };
    let lower = if on_b[first] > FLUSH {
        (on_b[first], feature::vertex_b(first))
    } else {
        (0.0, feature::vertex_a(0))
    };
    let upper = if on_b[last] < 1.0 - FLUSH {
        (on_b[last], feature::vertex_b(last))
    } else {
        (1.0, feature::vertex_a(1))
    };
    if upper.0 - lower.0 > 1e-3 && distance > 1e-3 * reach {
        let span = on_b[last] - on_b[first];
        let ends = [lower, upper].map(|(s, id)| {
            let on_a = p[0] + u * s;
            let on_b = q[first] + (q[last] - q[first]) * ((s - on_b[first]) / span).clamp(0.0, 1.0);
            let d = on_b - on_a;
            let gap = normal.dot(&d);
            let astray = length(d - normal * gap) > CROSSING * (reach + gap.abs());
            (on_a + normal * (0.5 * (gap + a.radius() - b.radius())), gap - reach, id, astray)
        });
        if ends.iter().all(|e| !e.3) {
            for (point, separation, id, _) in ends {
                if separation <= margin {
                    out.push(point, separation, id);
                }
            }
            // The gap of straight axes is least at an end, up to rounding.
            if out.count > 0 {
                return;
            }
        }
    }
    let on_a = p[0] + u * s;
    out.push(
        on_a + normal * (0.5 * (distance + a.radius() - b.radius())),
        distance - reach,
        feature::edges(0, 0),
    );
}

/// Axes that stray sideways by more than this share of the radii cross; within it the gap of the round surfaces
/// differs from the gap along the normal by half its square.
pub(in crate::narrow_phase) const CROSSING: Float = 0.03;

/// Ends that lie side by side within this share of the length count as A's: rounding must not decide whose they are.
pub(in crate::narrow_phase) const FLUSH: Float = 1e-4;

/// The parameters in 0 … 1 of the closest points of two segments (Ericson, Real-Time Collision Detection 2005,
/// 5.1.9). Of parallel segments the middle of the common stretch is taken: it is the same seen from both.
pub(in crate::narrow_phase) fn closest_of_segments(p: [Vec3; 2], q: [Vec3; 2]) -> (Float, Float) {
    let (u, v, r) = (p[1] - p[0], q[1] - q[0], p[0] - q[0]);
    let (uu, vv, uv) = (u.dot(&u), v.dot(&v), u.dot(&v));
    let (ur, vr) = (u.dot(&r), v.dot(&r));
    let denominator = length_squared(u.cross(&v));
    let s = if denominator > 1e-9 * uu * vv {
        ((uv * vr - ur * vv) / denominator).clamp(0.0, 1.0)
    } else {
        let (x, y) = (-ur / uu, (uv - ur) / uu);
        (0.5 * (x.min(y).clamp(0.0, 1.0) + x.max(y).clamp(0.0, 1.0))).clamp(0.0, 1.0)
    };
    let t = (uv * s + vr) / vv;
    if t < 0.0 {
        ((-ur / uu).clamp(0.0, 1.0), 0.0)
    } else if t > 1.0 {
        (((uv - ur) / uu).clamp(0.0, 1.0), 1.0)
    } else {
        (s, t)
    }
}
