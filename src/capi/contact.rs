//! Contacts and their manifolds as C sees them.

use super::access::is_contact;
use super::guard::neutral;
use super::id::{mvContactId, mvShapeId};
use super::math::{ORIGIN, ZERO3, mvPos, mvVec3};
use super::mvFloat;
use super::registry::View;
use super::side::Side;
use crate::world::ContactData;
use core::ffi::c_int;

/// A point of contact.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvManifoldPoint {
    /// Where, at the start of the last step [m].
    pub point: mvPos,
    /// The point, from the centre of mass of body A, in world axes [m].
    pub anchor_a: mvVec3,
    /// The point, from the centre of mass of body B, in world axes [m].
    pub anchor_b: mvVec3,
    /// The gap between the surfaces at the start of the last step, negative where they overlap [m].
    pub separation: mvFloat,
    /// The impulse along the normal in the last sub-step [N s].
    pub normal_impulse: mvFloat,
    /// The sum of the impulses along the normal over the last step [N s].
    pub total_normal_impulse: mvFloat,
    /// The velocity along the normal at the start of the last step, negative when approaching [m/s].
    pub normal_velocity: mvFloat,
    /// Which features of the shapes meet; the same number in the next step means the same features.
    pub feature_id: u32,
}

/// The points of contact that share a normal.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvManifold {
    /// The points, the first pointCount of them.
    pub points: [mvManifoldPoint; 4],
    /// The normal from shape A to shape B, of length 1.
    pub normal: mvVec3,
    /// The sum of the friction impulses on body B over the last step [N s].
    pub friction_impulse: mvVec3,
    /// The number of points, 0 to 4.
    pub point_count: c_int,
}

/// Two touching shapes.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvContactData {
    /// The contact.
    pub contact_id: mvContactId,
    /// The first shape.
    pub shape_id_a: mvShapeId,
    /// The second shape.
    pub shape_id_b: mvShapeId,
    /// The manifolds. Valid until the next step, or until the world is destroyed.
    pub manifolds: *const mvManifold,
    /// The number of manifolds.
    pub manifold_count: c_int,
}

const NO_POINT: mvManifoldPoint = mvManifoldPoint {
    point: ORIGIN,
    anchor_a: ZERO3,
    anchor_b: ZERO3,
    separation: 0.0,
    normal_impulse: 0.0,
    total_normal_impulse: 0.0,
    normal_velocity: 0.0,
    feature_id: 0,
};

neutral! {
    mvManifold = mvManifold { points: [NO_POINT; 4], normal: ZERO3, friction_impulse: ZERO3, point_count: 0 };
}

impl From<&ContactData> for mvManifold {
    fn from(c: &ContactData) -> Self {
        let mut points = [NO_POINT; 4];
        for (out, p) in points.iter_mut().zip(&c.points[..c.count]) {
            *out = mvManifoldPoint {
                point: p.point.into(),
                anchor_a: p.anchor_a.into(),
                anchor_b: p.anchor_b.into(),
                separation: p.separation,
                normal_impulse: p.normal_impulse,
                total_normal_impulse: p.total_normal_impulse,
                normal_velocity: p.normal_velocity,
                feature_id: p.feature,
            };
        }
        Self {
            points,
            normal: c.normal.into(),
            friction_impulse: c.friction_impulse.into(),
            point_count: c.count as c_int,
        }
    }
}

/// A contact for C; its manifold is kept until the next step.
pub(super) fn contact_data(side: &Side, c: &ContactData) -> mvContactData {
    mvContactData {
        contact_id: c.contact.into(),
        shape_id_a: c.shape_a.into(),
        shape_id_b: c.shape_b.into(),
        manifolds: side.manifold(c.contact, || c.into()),
        manifold_count: 1,
    }
}

/// Does this contact exist? A contact exists while the boxes of its shapes meet.
#[unsafe(no_mangle)]
pub extern "C" fn mvContact_IsValid(id: mvContactId) -> bool {
    is_contact(id, |view: View<'_>| view.world.contains_contact(id.into()))
}
