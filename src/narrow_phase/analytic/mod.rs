//! Pairs with a closed form.

mod half_space;
mod round;

pub(super) use half_space::{half_space_capsule, half_space_polytope, half_space_sphere};
pub(super) use round::{
    CROSSING, FLUSH, capsule_capsule, closest_of_segments, sphere_box, sphere_capsule, sphere_sphere,
};
