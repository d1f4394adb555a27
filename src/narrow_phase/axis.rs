//! The table of pairs whose axis comes from GJK where they are apart and from a search for the depth where they
//! overlap, on and above its diagonal. Half-spaces and round pairs have closed forms in every way.

use super::contact::Manifold;
use super::{Cache, Methods, analytic, polytopes, segment};
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
    use Shape::{Box, Capsule, HalfSpace, Hull, Sphere};
    match (a, b) {
        (HalfSpace(_), HalfSpace(_)) => {}
        (HalfSpace(h), Sphere(s)) => analytic::half_space_sphere(h, s, pose, margin, out),
        (HalfSpace(h), Capsule(c)) => analytic::half_space_capsule(h, c, pose, margin, out),
        (HalfSpace(h), Box(b)) => analytic::half_space_polytope(h, b, pose, margin, out),
        (HalfSpace(h), Hull(b)) => analytic::half_space_polytope(h, b.as_ref(), pose, margin, out),
        (Box(a), Box(b)) => polytopes::by_gjk(a, b, pose, margin, methods, cache, out),
        (Box(a), Hull(b)) => polytopes::by_gjk(a, b.as_ref(), pose, margin, methods, cache, out),
        (Hull(a), Hull(b)) => polytopes::by_gjk(a.as_ref(), b.as_ref(), pose, margin, methods, cache, out),
        (Sphere(a), Box(b)) => segment::sphere_polytope(a, b, pose, margin, methods.gjk, out),
        (Sphere(a), Hull(b)) => segment::sphere_polytope(a, b.as_ref(), pose, margin, methods.gjk, out),
        (Capsule(a), Box(b)) => segment::capsule_polytope(a, b, pose, margin, methods, out),
        (Capsule(a), Hull(b)) => segment::capsule_polytope(a, b.as_ref(), pose, margin, methods, out),
        (Sphere(a), Sphere(b)) => analytic::sphere_sphere(a, b, pose, margin, out),
        (Sphere(a), Capsule(b)) => analytic::sphere_capsule(a, b, pose, margin, out),
        (Capsule(a), Capsule(b)) => analytic::capsule_capsule(a, b, pose, margin, out),
        _ => unreachable!("the pair is in order"),
    }
}
