//! Mass properties of a body, and the two products the solver needs: I_w⁻¹ and I_w · w.

use crate::integrate::PrincipalAxes;
use crate::math::{Float, Mat3, Quat, Vec3, rotate, rotate_back, rotation_matrix};
use crate::shape::MassData;
use crate::world::MotionLocks;

/// Mass, centre and inertia of a body. Written when shapes or mass data change.
#[derive(Clone, Copy, Debug)]
pub struct MassProps {
    /// \[kg\]; 0 for bodies without mass.
    pub mass: Float,
    /// \[1/kg\]; 0 for static, kinematic and massless bodies.
    pub inv_mass: Float,
    /// Centre of mass in the body frame \[m\].
    pub center: Vec3,
    /// Inertia about the centre of mass, body axes \[kg m²\].
    pub inertia: Mat3,
    /// Its inverse; zero where the body cannot turn.
    pub inv_inertia: Mat3,
    /// Principal moments \[kg m²\].
    pub moments: Vec3,
    /// Body from principal axes.
    pub principal: Quat,
    /// Whether all moments are equal, so that ω is constant in free flight.
    pub isotropic: bool,
    /// Greatest distance of a point of the body from the centre of mass \[m\].
    pub extent: Float,
}

impl MassProps {
    /// A body that nothing moves.
    pub const IMMOVABLE: MassProps = MassProps {
        mass: 0.0,
        inv_mass: 0.0,
        center: Vec3::new(0.0, 0.0, 0.0),
        inertia: Mat3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        inv_inertia: Mat3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        moments: Vec3::new(0.0, 0.0, 0.0),
        principal: Quat::new_unchecked(nalgebra::Quaternion::new(1.0, 0.0, 0.0, 0.0)),
        isotropic: true,
        extent: 0.0,
    };

    /// From the sum of the shapes (or the user's own figures). A mass of 0 gives a body that keeps its velocity; so
    /// does one beyond the range of numbers, itself, its inverse or its centre.
    #[must_use]
    pub fn new(data: &MassData, extent: Float) -> Self {
        let has_inverse = |x: Float| x > 0.0 && x.is_finite() && (1.0 / x).is_finite();
        if !has_inverse(data.mass) || !crate::math::is_finite(data.center) {
            return Self { extent, ..Self::IMMOVABLE };
        }
        let axes = PrincipalAxes::of(&data.inertia);
        let turns = axes.moments.iter().all(|&m| has_inverse(m));
        let isotropic = !turns || crate::integrate::is_isotropic(axes.moments);
        let inv_inertia = if turns {
            let r = rotation_matrix(&axes.body_from_principal);
            r * Mat3::from_diagonal(&axes.moments.map(|m| 1.0 / m)) * r.transpose()
        } else {
            Mat3::zeros()
        };
        Self {
            mass: data.mass,
            inv_mass: 1.0 / data.mass,
            center: data.center,
            inertia: data.inertia,
            inv_inertia,
            moments: axes.moments,
            principal: axes.body_from_principal,
            isotropic,
            extent,
        }
    }

    /// Whether torques turn the body.
    #[inline(always)]
    #[must_use]
    pub fn turns(&self) -> bool {
        self.inv_inertia.m11 > 0.0
    }

    /// I_w⁻¹ at rotation `q`: what angular impulses are multiplied with. Locked axes take no part: the inverse
    /// is that of the free axes' block.
    #[must_use]
    pub fn world_inv_inertia(&self, q: &Quat, locks: &MotionLocks) -> Mat3 {
        if !self.turns() {
            return Mat3::zeros();
        }
        if locks.angular != [false; 3] {
            return inverse_of_free_block(&self.world_inertia(q), locks.angular);
        }
        if self.isotropic {
            return Mat3::from_diagonal_element(1.0 / self.moments.x);
        }
        let r = rotation_matrix(q);
        symmetric(&(r * self.inv_inertia * r.transpose()))
    }

    /// I_w at rotation `q`.
    #[must_use]
    pub fn world_inertia(&self, q: &Quat) -> Mat3 {
        if self.isotropic {
            return Mat3::from_diagonal_element(self.moments.x);
        }
        let r = rotation_matrix(q);
        symmetric(&(r * self.inertia * r.transpose()))
    }

    /// I_w · w at rotation `q`.
    #[inline]
    #[must_use]
    pub fn inertia_times(&self, q: &Quat, w: Vec3) -> Vec3 {
        if self.isotropic { w * self.moments.x } else { rotate(q, self.inertia * rotate_back(q, w)) }
    }
}

/// The mean of `m` and its transpose: rounding must not make an inertia tensor unsymmetric.
fn symmetric(m: &Mat3) -> Mat3 {
    (m + m.transpose()) * 0.5
}

/// The inverse of the block of `m` whose axes are not locked, zero elsewhere.
fn inverse_of_free_block(m: &Mat3, locked: [bool; 3]) -> Mat3 {
    let mut block = *m;
    for k in 0..3 {
        if locked[k] {
            for j in 0..3 {
                block[(k, j)] = 0.0;
                block[(j, k)] = 0.0;
            }
            block[(k, k)] = 1.0;
        }
    }
    let mut inverse = block.try_inverse().unwrap_or_else(Mat3::zeros);
    for k in 0..3 {
        if locked[k] {
            inverse[(k, k)] = 0.0;
        }
    }
    inverse
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{quat_about, vec3};

    fn brick() -> MassProps {
        let data =
            MassData { mass: 2.0, center: Vec3::zeros(), inertia: Mat3::from_diagonal(&vec3(1.0, 2.0, 4.0)) };
        MassProps::new(&data, 1.0)
    }

    #[test]
    fn inverse_and_inertia_undo_each_other() {
        let (m, q) = (brick(), quat_about(vec3(1.0, 2.0, -1.0), 0.8));
        let w = vec3(0.3, -1.0, 2.0);
        let back = m.world_inv_inertia(&q, &MotionLocks::default()) * m.inertia_times(&q, w);
        assert!(crate::math::length(back - w) < 1e-5);
    }

    #[test]
    fn a_locked_axis_neither_turns_nor_couples() {
        let (m, q) = (brick(), quat_about(vec3(1.0, 2.0, -1.0), 0.8));
        let locks = MotionLocks { angular: [false, true, false], ..Default::default() };
        let inv = m.world_inv_inertia(&q, &locks);
        assert_eq!((inv * vec3(1.0, 2.0, 3.0)).y, 0.0);
        let w = vec3(0.7, 0.0, -0.2);
        let back = inv * (m.world_inertia(&q) * w);
        assert!(crate::math::length(back - w) < 1e-5);
    }
}
