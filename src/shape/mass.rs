use crate::math::{Float, Mat3, Pose, Vec3, rotation_matrix};

/// Mass, centre of mass and inertia of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassData {
    /// \[kg\]
    pub mass: Float,
    /// The centre of mass in the shape's (or body's) frame \[m\].
    pub center: Vec3,
    /// The inertia tensor about the centre of mass, in the axes of the shape's (or body's) frame \[kg m²\].
    pub inertia: Mat3,
}

impl MassData {
    /// Of nothing.
    pub const ZERO: MassData = MassData {
        mass: 0.0,
        center: Vec3::new(0.0, 0.0, 0.0),
        inertia: Mat3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    };

    /// The same solid seen from another frame.
    #[must_use]
    pub fn placed(&self, dst_from_src: &Pose) -> Self {
        let r = rotation_matrix(&dst_from_src.q);
        Self {
            mass: self.mass,
            center: dst_from_src.point(self.center),
            inertia: r * self.inertia * r.transpose(),
        }
    }

    /// Both solids taken as one, in their common frame (parallel-axis theorem).
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        if mass <= 0.0 {
            return Self::ZERO;
        }
        let d = other.center - self.center;
        let reduced = self.mass * (other.mass / mass);
        Self {
            mass,
            center: self.center + d * (other.mass / mass),
            inertia: self.inertia + other.inertia + point_inertia(d) * reduced,
        }
    }
}

/// The inertia of 1 kg at `d` about the origin: |d|² 1 − d dᵀ.
fn point_inertia(d: Vec3) -> Mat3 {
    let (xx, yy, zz) = (d.x * d.x, d.y * d.y, d.z * d.z);
    let (xy, xz, yz) = (-d.x * d.y, -d.x * d.z, -d.y * d.z);
    Mat3::new(yy + zz, xy, xz, xy, xx + zz, yz, xz, yz, xx + yy)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{quat_about, vec3};
    use crate::shape::Shape;

    #[test]
    fn two_half_boxes_are_one_box() {
        let whole = Shape::new_box(2.0, 1.0, 3.0).mass_data(5.0);
        let half = Shape::new_box(1.0, 1.0, 3.0).mass_data(5.0);
        let at = |x| half.placed(&Pose::translation(vec3(x, 0.0, 0.0)));
        let both = at(-0.5).with(&at(0.5));
        assert!((both.mass - whole.mass).abs() < 1e-5 * whole.mass);
        assert!((both.inertia - whole.inertia).abs().max() < 1e-5 * whole.inertia.max());
        let turn = Pose::new(vec3(0.0, 4.0, 0.0), quat_about(Vec3::z(), crate::math::scalar::PI * 0.5));
        let turned = whole.placed(&turn);
        assert!((turned.inertia.m11 - whole.inertia.m22).abs() < 1e-5 * whole.inertia.max());
        assert_eq!(turned.center, vec3(0.0, 4.0, 0.0));
    }
}
