//! Spheres, capsules and mass as C sees them.

use super::guard::neutral;
use super::math::{ZERO3, mvMatrix3, mvVec3};
use super::mvFloat;
use crate::error::{Result, check};
use crate::shape::{Capsule, MassData, Sphere};

/// A ball.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvSphere {
    /// The centre [m].
    pub center: mvVec3,
    /// The radius [m], at least 1e-5.
    pub radius: mvFloat,
}

/// All points within a radius of a segment.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvCapsule {
    /// The centre of one end [m].
    pub center1: mvVec3,
    /// The centre of the other end [m], at least 1e-5 from the first.
    pub center2: mvVec3,
    /// The radius [m], at least 1e-5.
    pub radius: mvFloat,
}

/// Mass, centre of mass and inertia.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvMassData {
    /// The mass [kg].
    pub mass: mvFloat,
    /// The centre of mass in the frame of the shape or body [m].
    pub center: mvVec3,
    /// The inertia about the centre of mass, in the axes of the shape or body [kg m^2].
    pub inertia: mvMatrix3,
}

neutral! {
    mvSphere = mvSphere { center: ZERO3, radius: 0.0 };
    mvCapsule = mvCapsule { center1: ZERO3, center2: ZERO3, radius: 0.0 };
    mvMassData = mvMassData { mass: 0.0, center: ZERO3, inertia: mvMatrix3 { cx: ZERO3, cy: ZERO3, cz: ZERO3 } };
}

impl mvSphere {
    pub(super) fn solid(&self) -> Result<Sphere> {
        Sphere::new(self.center.raw(), self.radius)
    }
}

impl mvCapsule {
    pub(super) fn solid(&self) -> Result<Capsule> {
        Capsule::new(self.center1.raw(), self.center2.raw(), self.radius)
    }
}

impl From<Sphere> for mvSphere {
    fn from(s: Sphere) -> Self {
        Self { center: s.center().into(), radius: s.radius() }
    }
}

impl From<Capsule> for mvCapsule {
    fn from(c: Capsule) -> Self {
        Self { center1: c.center1().into(), center2: c.center2().into(), radius: c.radius() }
    }
}

impl From<MassData> for mvMassData {
    fn from(m: MassData) -> Self {
        Self { mass: m.mass, center: m.center.into(), inertia: m.inertia.into() }
    }
}

impl mvMassData {
    pub(super) fn checked(&self) -> Result<MassData> {
        Ok(MassData {
            mass: check::not_negative("mass", self.mass)?,
            center: self.center.point("center")?,
            inertia: self.inertia.finite("inertia")?,
        })
    }
}
