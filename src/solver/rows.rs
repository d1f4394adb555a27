//! What the solver knows of a body: a row of 64 bytes (f32) that every constraint gathers, a row of world
//! inverse inertia, and a slower part that only the passes over bodies touch.

use crate::math::scalar::double;
use crate::math::{Float, Mat3, Quat, Vec3, rotate, rotate_back, rotation_matrix, vec3};
use crate::simd::{Lane, Quad, Sym3, V3};

/// The solver row, as four quads: (v, 1/m) (ω, –) (Δx, –) (Δq). Δx and Δq are displacement and turn since the
/// step began. Row 0 of a workspace is the immovable row: all static bodies share it, nothing writes it.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Row(pub [Quad; 4]);

impl Row {
    /// At rest, and immovable.
    pub const IMMOVABLE: Row = Row([[0.0; 4], [0.0; 4], [0.0; 4], [0.0, 0.0, 0.0, 1.0]]);

    /// Velocity \[m/s\].
    #[inline(always)]
    pub fn v(&self) -> Vec3 {
        vec3(self.0[0][0], self.0[0][1], self.0[0][2])
    }
    /// Angular velocity \[rad/s\].
    #[inline(always)]
    pub fn w(&self) -> Vec3 {
        vec3(self.0[1][0], self.0[1][1], self.0[1][2])
    }
    /// Displacement \[m\].
    #[inline(always)]
    pub fn dx(&self) -> Vec3 {
        vec3(self.0[2][0], self.0[2][1], self.0[2][2])
    }
    /// Turn.
    #[inline(always)]
    pub fn dq(&self) -> Quat {
        let [x, y, z, w] = self.0[3];
        Quat::new_unchecked(nalgebra::Quaternion::new(w, x, y, z))
    }
    /// Inverse mass \[1/kg\].
    #[inline(always)]
    pub fn inv_mass(&self) -> Float {
        self.0[0][3]
    }
    /// Sets the velocity.
    #[inline(always)]
    pub fn set_v(&mut self, v: Vec3) {
        self.0[0][0] = v.x;
        self.0[0][1] = v.y;
        self.0[0][2] = v.z;
    }
    /// Sets the angular velocity.
    #[inline(always)]
    pub fn set_w(&mut self, w: Vec3) {
        self.0[1][0] = w.x;
        self.0[1][1] = w.y;
        self.0[1][2] = w.z;
    }
    /// Sets the displacement.
    #[inline(always)]
    pub fn set_dx(&mut self, d: Vec3) {
        self.0[2][0] = d.x;
        self.0[2][1] = d.y;
        self.0[2][2] = d.z;
    }
    /// Sets the turn.
    #[inline(always)]
    pub fn set_dq(&mut self, q: &Quat) {
        self.0[3] = [q.i, q.j, q.k, q.w];
    }
}

/// World inverse inertia: (xx, xy, xz, yy) (yz, zz, –, –).
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct InertiaRow(pub [Quad; 2]);

impl InertiaRow {
    /// Of a body that does not turn.
    pub const ZERO: InertiaRow = InertiaRow([[0.0; 4]; 2]);

    /// From a symmetric matrix.
    #[inline(always)]
    pub fn new(m: &Mat3) -> Self {
        Self([[m.m11, m.m12, m.m13, m.m22], [m.m23, m.m33, 0.0, 0.0]])
    }

    /// The sum of the diagonal: an upper bound of what a unit angular impulse turns.
    #[inline(always)]
    pub fn trace(&self) -> Float {
        self.0[0][0] + self.0[0][3] + self.0[1][1]
    }

    /// I_w⁻¹ v.
    #[inline(always)]
    pub fn times(&self, v: Vec3) -> Vec3 {
        let [[xx, xy, xz, yy], [yz, zz, ..]] = self.0;
        vec3(xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z)
    }

    /// The same in double precision.
    #[inline(always)]
    pub fn exact(&self) -> ExactInertia {
        ExactInertia(self.0.map(|quad| quad.map(double)))
    }
}

/// World inverse inertia in double precision, laid out like [`InertiaRow`].
#[derive(Clone, Copy, Debug)]
pub struct ExactInertia([[f64; 4]; 2]);

impl ExactInertia {
    /// I_w⁻¹ v.
    #[inline(always)]
    pub fn times(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [[xx, xy, xz, yy], [yz, zz, ..]] = self.0;
        [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z]
    }
}

/// A body's part that only the passes over bodies touch.
#[derive(Clone, Copy, Debug)]
pub struct Aux {
    /// Acceleration by gravity and forces \[m/s²\].
    pub accel: Vec3,
    /// Torque about the centre of mass \[N m\].
    pub torque: Vec3,
    /// Velocities after forces and before constraints, in this sub-step.
    pub before: [Vec3; 2],
    /// Velocities after the first group of impulses (and the turn) of this sub-step.
    pub middle: [Vec3; 2],
    /// What constraints changed in the last sub-step: Δv, and Δω or, with [`Aux::spin`], ΔL.
    pub warm: [Vec3; 2],
    /// Change of L by the first group of impulses of this sub-step, with [`Aux::spin`].
    pub first_dl: Vec3,
    /// Velocities when the step began.
    pub begin: [Vec3; 2],
    /// Current angular momentum, with [`Aux::spin`].
    pub l: Vec3,
    /// World from principal axes: now, and when the step began; with [`Aux::spin`].
    pub q: [Quat; 2],
    /// Factors on the velocities by damping, per sub-step.
    pub damping: [Float; 2],
    /// Mass \[kg\].
    pub mass: Float,
    /// Principal moments \[kg m²\].
    pub moments: Vec3,
    /// The row in the set of awake bodies.
    pub awake_row: u32,
    /// Whether the free rotation is integrated by Moser–Veselov and I_w⁻¹ refreshed every sub-step.
    pub spin: bool,
    /// Whether constraints held the body in the last sub-step.
    pub supported: bool,
    /// Whether velocities are given and constraints cannot change them.
    pub kinematic: bool,
    /// Whether any direction is locked.
    pub locked: bool,
    /// Whether the body has joints.
    pub jointed: bool,
    /// Whether they are solved at once.
    pub planned: bool,
    /// Whether it has contacts.
    pub touched: bool,
    /// Momentum that joints gave it in this sub-step, and Δω or, with [`Aux::spin`], ΔL; where it has contacts.
    pub joint: [Vec3; 2],
    /// Momentum of that when the bodies were moved.
    pub joint_middle: Vec3,
    /// What is added to its moments of inertia for the step \[kg m²\], see [`Rows::bear`].
    pub extra: Float,
}

impl Aux {
    /// Whether the body is moved by less than its velocity, as its acceleration acts all through the sub-step: joints
    /// that are solved at once reckon with that. Contacts and meshes, whose impulses converge over many sub-steps, must
    /// want the same of them in both passes.
    #[inline(always)]
    pub fn lags(&self) -> bool {
        self.planned && !self.touched
    }
}

/// I_w ω of a spinning body.
#[inline]
pub fn inertia_times(aux: &Aux, w: Vec3) -> Vec3 {
    rotate(&aux.q[0], rotate_back(&aux.q[0], w).component_mul(&aux.moments))
}

/// I_w⁻¹ by the moments and the present rotation of the principal axes.
#[inline]
pub fn inverse_inertia(aux: &Aux) -> Mat3 {
    let r = rotation_matrix(&aux.q[0]);
    let inv = aux.moments.map(|m| 1.0 / m);
    let scaled = Mat3::from_columns(&[r.column(0) * inv.x, r.column(1) * inv.y, r.column(2) * inv.z]);
    scaled * r.transpose()
}

/// The rows of all bodies of a step, ordered by batch and island.
#[derive(Debug, Default)]
pub struct Rows {
    /// The solver rows.
    pub row: Vec<Row>,
    /// World inverse inertia.
    pub inertia: Vec<InertiaRow>,
    /// The rest.
    pub aux: Vec<Aux>,
}

/// The velocities and properties of one body in each lane.
#[derive(Clone, Copy)]
pub struct Gathered<L> {
    /// Velocity.
    pub v: V3<L>,
    /// Angular velocity.
    pub w: V3<L>,
    /// Inverse mass.
    pub inv_mass: L,
    /// Inverse inertia.
    pub inv_inertia: Sym3<L>,
    /// The unused element of the quad of ω, to be written back.
    spare: L,
}

impl Rows {
    /// Makes a body bear a load \[N m\], |force| · |arm| summed over what pulls at both of its ends. A force that stays while the body
    /// turns under it acts as a torsion spring of that stiffness k; explicit in time, that is unstable where h² k
    /// exceeds four times the inertia, as of a light link that carries a thousand times its weight. Such a body turns
    /// as if its moments were greater, by so much that h² k ≤ 2 I (Andrews, Teichmann & Kövecses 2017 do the like).
    /// Its angular velocity is right, its angular momentum then not kept to rounding. Says whether
    /// its inertia changed; with `from` > 1 it only grows, and only by more than that factor.
    pub fn bear(&mut self, i: usize, load: Float, h: Float, from: Float) -> bool {
        let aux = &mut self.aux[i];
        let least = aux.moments.min() - aux.extra;
        if aux.kinematic || least <= 0.0 || self.inertia[i].trace() == 0.0 || aux.locked {
            return false;
        }
        let extra = (0.5 * h * h * load - least).max(0.0);
        // Small changes are not worth a new tensor.
        if (extra - aux.extra).abs() <= 0.1 * (least + aux.extra)
            || (from > 1.0 && extra < from * (least + aux.extra))
        {
            return false;
        }
        let change = extra - aux.extra;
        aux.extra = extra;
        aux.moments += Vec3::repeat(change);
        if aux.spin {
            let w = self.row[i].w();
            aux.l = inertia_times(aux, w);
        }
        self.inertia[i] = InertiaRow::new(&inverse_inertia(aux));
        true
    }

    /// Gathers velocities, mass and inertia.
    #[inline(always)]
    pub fn gather<L: Lane>(&self, index: &L::Index) -> Gathered<L> {
        let index = index.as_ref();
        let [vx, vy, vz, inv_mass] = L::gather(|i| self.row[index[i] as usize].0[0]);
        let [wx, wy, wz, spare] = L::gather(|i| self.row[index[i] as usize].0[1]);
        let [xx, xy, xz, yy] = L::gather(|i| self.inertia[index[i] as usize].0[0]);
        let [yz, zz, ..] = L::gather(|i| self.inertia[index[i] as usize].0[1]);
        Gathered {
            v: V3::new(vx, vy, vz),
            w: V3::new(wx, wy, wz),
            inv_mass,
            inv_inertia: Sym3 { xx, xy, xz, yy, yz, zz },
            spare,
        }
    }

    /// Gathers displacements and turns.
    #[inline(always)]
    pub fn gather_moves<L: Lane>(&self, index: &L::Index) -> (V3<L>, V3<L>, L) {
        let index = index.as_ref();
        let [x, y, z, _] = L::gather(|i| self.row[index[i] as usize].0[2]);
        let [qx, qy, qz, qw] = L::gather(|i| self.row[index[i] as usize].0[3]);
        (V3::new(x, y, z), V3::new(qx, qy, qz), qw)
    }

    /// Scatters velocities. Row 0 is never written.
    #[inline(always)]
    pub fn scatter<L: Lane>(&mut self, index: &L::Index, g: &Gathered<L>) {
        let index = index.as_ref();
        L::scatter([g.v.x, g.v.y, g.v.z, g.inv_mass], |i, q| {
            if index[i] != 0 {
                self.row[index[i] as usize].0[0] = q;
            }
        });
        L::scatter([g.w.x, g.w.y, g.w.z, g.spare], |i, q| {
            if index[i] != 0 {
                self.row[index[i] as usize].0[1] = q;
            }
        });
    }
}

/// (Rᵀ − 1) n for the rotation (u, w): the change of n·r under the rotation of r is r · this.
#[inline(always)]
pub fn turned_back_minus<L: Lane>(u: V3<L>, w: L, n: V3<L>) -> V3<L> {
    let t = n.cross(u).times(L::splat(2.0));
    t.times(w) + t.cross(u)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{quat_about, rotate};

    #[test]
    fn a_row_is_one_cache_line() {
        assert_eq!(size_of::<Row>(), 16 * size_of::<Float>());
        assert_eq!(align_of::<Row>(), 64);
    }

    #[test]
    fn turning_a_normal_back_measures_how_far_an_anchor_moved_along_it() {
        let q = quat_about(vec3(1.0, -0.4, 2.0), 0.7);
        let (n, r) = (vec3(0.6, 0.0, 0.8), vec3(1.0, 2.0, -3.0));
        let u = V3::<Float>::new(q.i, q.j, q.k);
        let m = turned_back_minus(u, q.w, V3::new(n.x, n.y, n.z));
        let want = n.dot(&(rotate(&q, r) - r));
        assert!((m.dot(V3::new(r.x, r.y, r.z)) - want).abs() < 1e-5);
    }
}
