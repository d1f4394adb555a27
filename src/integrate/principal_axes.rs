use crate::math::{Float, Mat3, Quat, Vec3, quat, tolerance::EPSILON, vec3};

/// The frame in which an inertia tensor is diagonal. Computed once when a body's mass changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    /// The principal moments of inertia \[kg m²\], along x, y and z of the principal frame. In no certain order: a
    /// tensor that is diagonal already keeps its axes.
    pub moments: Vec3,
    /// The principal axes in the body's frame, right-handed.
    pub body_from_principal: Quat,
}

/// Sweeps of Jacobi's method; it converges quadratically, and five suffice for 3×3 in double precision.
const SWEEPS: usize = 8;

impl PrincipalAxes {
    /// The principal axes of a symmetric tensor \[kg m²\] in the body's frame, by Jacobi's rotations
    /// \[Golub, Van Loan §8.5\]: only + − × ÷ √, so the same bits everywhere. The lower triangle is not read.
    #[must_use]
    pub fn of(inertia: &Mat3) -> Self {
        let mut a = *inertia;
        let mut q = Quat::identity();
        for _ in 0..SWEEPS {
            for (i, j) in [(0, 1), (0, 2), (1, 2)] {
                // What cannot change a diagonal element any more is rounding.
                if a[(i, j)].abs() <= 0.5 * EPSILON * a[(i, i)].abs().min(a[(j, j)].abs()) {
                    a[(i, j)] = 0.0;
                    continue;
                }
                q = rotate_away(&mut a, i, j, &q);
            }
        }
        Self { moments: vec3(a[(0, 0)], a[(1, 1)], a[(2, 2)]), body_from_principal: q }
    }

    /// Whether the body turns at constant ω: see [`is_isotropic`].
    #[must_use]
    pub fn is_isotropic(&self) -> bool {
        is_isotropic(self.moments)
    }
}

/// Turns the axes i < j of the symmetric matrix `a` (upper triangle) so that its element (i, j) vanishes; returns
/// `q` with that turn applied.
fn rotate_away(a: &mut Mat3, i: usize, j: usize, q: &Quat) -> Quat {
    let k = 3 - i - j;
    // t = tan of the smaller of the two angles that do it.
    let theta = (a[(j, j)] - a[(i, i)]) / (2.0 * a[(i, j)]);
    let t = if theta.abs() < 1.0 / EPSILON {
        (if theta < 0.0 { -1.0 } else { 1.0 }) / (theta.abs() + (theta * theta + 1.0).sqrt())
    } else {
        0.5 / theta
    };
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    let upper = |r: usize, c: usize| (r.min(c), r.max(c));
    let (aik, ajk) = (a[upper(i, k)], a[upper(j, k)]);
    let shift = t * a[(i, j)];
    a[(i, i)] -= shift;
    a[(j, j)] += shift;
    a[(i, j)] = 0.0;
    a[upper(i, k)] = c * aik - s * ajk;
    a[upper(j, k)] = s * aik + c * ajk;

    // The new axes are c i − s j and s i + c j: a turn about the axis i × j = ±k by an angle of tangent −t.
    let half = 1.0 + c;
    let mut axis = Vec3::zeros();
    axis[k] = if (i + 1) % 3 == j { -s } else { s };
    let turned = q * quat(half, axis);
    quat(turned.w, vec3(turned.i, turned.j, turned.k))
}

/// How far the moments of a body may differ, relative to the largest, for it to count as isotropic. Its ω then
/// strays by no more than this share of ω² t, which is within the rounding of a world inertia in f32.
pub const ISOTROPY: Float = 4e-6;

/// Whether the moments are equal up to [`ISOTROPY`]: a sphere or a cube, whose ω is constant and whose turn
/// [`turn_by`](super::turn_by) gives exactly.
#[inline]
#[must_use]
pub fn is_isotropic(moments: Vec3) -> bool {
    moments.max() - moments.min() <= ISOTROPY * moments.max()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{quat_about, rotation_matrix};

    fn check(inertia: Mat3) -> PrincipalAxes {
        let axes = PrincipalAxes::of(&inertia);
        let r = rotation_matrix(&axes.body_from_principal);
        let rebuilt = r * Mat3::from_diagonal(&axes.moments) * r.transpose();
        let error = (rebuilt - inertia).amax() / inertia.amax();
        assert!(error < 40.0 * EPSILON, "{inertia} rebuilt with an error of {error}");
        axes
    }

    #[test]
    fn a_diagonal_tensor_keeps_its_axes() {
        let axes = check(Mat3::from_diagonal(&vec3(0.808333, 0.683333, 0.141667)));
        assert_eq!(axes.body_from_principal, Quat::identity());
        assert_eq!(axes.moments, vec3(0.808333, 0.683333, 0.141667));
    }

    #[test]
    fn turned_tensors_are_taken_apart() {
        for moments in [
            vec3(1.0, 2.0, 2.5),
            vec3(3.0, 1.0, 3.0),
            vec3(1.0, 1.0, 1.0),
            vec3(1e-6, 1.0, 1.0),
            vec3(2e-15, 1e-15, 1.5e-15),
            vec3(1e12, 2e12, 2.5e12),
        ] {
            for i in 0..200 {
                let f = i as Float;
                let q = quat_about(vec3(1.0, 0.1 * f - 3.0, 0.37 * f - 20.0), 0.1 * f);
                let r = rotation_matrix(&q);
                let inertia = r * Mat3::from_diagonal(&moments) * r.transpose();
                let axes = check((inertia + inertia.transpose()) * 0.5);
                let mut found = [axes.moments.x, axes.moments.y, axes.moments.z];
                let mut expected = [moments.x, moments.y, moments.z];
                found.sort_unstable_by(Float::total_cmp);
                expected.sort_unstable_by(Float::total_cmp);
                for (a, b) in found.iter().zip(expected) {
                    assert!(
                        (a - b).abs() < 40.0 * EPSILON * moments.max(),
                        "{found:?} instead of {expected:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn spheres_and_cubes_are_isotropic() {
        assert!(is_isotropic(vec3(0.4, 0.4, 0.4)) && is_isotropic(vec3(1.0, 1.000001, 1.0)));
        assert!(!is_isotropic(vec3(1.0, 1.0001, 1.0)) && !is_isotropic(vec3(1.0, 1.0, 0.0)));
    }
}
