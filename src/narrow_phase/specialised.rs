//! The table of pairs by closed forms and separating axes, on and above its diagonal; boxes among themselves are
//! taken before.
//!
//! | pair | way |
//! |---|---|
//! | sphere, capsule – sphere, capsule | closed form |
//! | sphere – box | closed form |
//! | box – box | 15 axes, cached |
//! | box, hull – hull (small) | faces and edges with Gauss-map pruning |
//! | hull – hull (large) | GJK and EPA: edge pairs would be too many |
//! | sphere, capsule – box, hull | GJK while the core is outside, faces and edges inside |
//! | half-space – all | closed form |

use super::contact::Manifold;
use super::{Cache, Methods, analytic, axis, polytopes};
use crate::math::{Float, Pose};
use crate::shape::Shape;

pub(super) fn collide(
    a: &Shape,
    b: &Shape,
    pose: &Pose,
    margin: Float,
    methods: Methods,
    cache: &mut Cache,
    out: &mut Manifold,
) {
    use Shape::{Box, Hull, Sphere};
    match (a, b) {
        (Box(a), Hull(b)) => polytopes::collide(a, b.as_ref(), pose, margin, methods, cache, out),
        (Hull(a), Hull(b)) => polytopes::collide(a.as_ref(), b.as_ref(), pose, margin, methods, cache, out),
        (Sphere(a), Box(b)) => analytic::sphere_box(a, b, pose, margin, out),
        _ => axis::collide(a, b, pose, margin, methods, cache, out),
    }
}
