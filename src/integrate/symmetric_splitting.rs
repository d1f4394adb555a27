//! Symmetric splitting (Dullweber, Leimkuhler & McLachlan 1997). The kinetic energy Σ pᵢ²/2Iᵢ is split into its three
//! terms; under one alone the body turns about a principal axis at constant speed, which is exact, and
//!
//! ```text
//! turn₁(h/2) turn₂(h/2) turn₃(h) turn₂(h/2) turn₁(h/2)
//! ```
//!
//! is a step of second order that keeps L and the symplectic form; the energy oscillates within a band of h².
//! Five turns in a plane, no iteration: a fixed cost.

use super::{Integrator, PrincipalAxes};
use crate::math::{Float, Quat, Vec3, quat, rotate_back, scalar, vec3};

/// Symmetric splitting.
#[derive(Clone, Copy, Debug)]
pub struct SymmetricSplitting;

impl Integrator for SymmetricSplitting {
    const LAG: Float = 0.5;

    fn turn(q: &Quat, l: Vec3, axes: &PrincipalAxes, h: Float) -> Quat {
        let mut q = q * axes.body_from_principal;
        let mut p = rotate_back(&q, l);
        for (axis, part) in [(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)] {
            let angle = part * h * p[axis] / axes.moments[axis];
            let (s, c) = scalar::sin_cos(0.5 * angle);
            let mut v = Vec3::zeros();
            v[axis] = s;
            // In the body's frame p turns the other way.
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            let (cos, sin) = (c * c - s * s, 2.0 * s * c);
            (p[j], p[k]) = (cos * p[j] + sin * p[k], cos * p[k] - sin * p[j]);
            let u = vec3(q.i, q.j, q.k);
            q = quat(q.w * c - u.dot(&v), v * q.w + u * c + u.cross(&v));
        }
        q * axes.body_from_principal.conjugate()
    }
}
