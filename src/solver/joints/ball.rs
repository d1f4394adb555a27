//! Ball joints of a mesh (a cloth, a net), N side by side: what is too entangled to be solved at once is mostly this.
//!
//! With d from A's point to B's and both arms to the middle between them, r_A and r_B,
//!   C = d,   Ċ = v_B + ω_B × r_B − v_A − ω_A × r_A
//!   K = (1/m_A + 1/m_B) 1 − r_A× I_A⁻¹ r_A× − r_B× I_B⁻¹ r_B×
//! and a joint's impulse λ (on B, world axes) changes by K⁻¹ (aim − Ċ). The aims of the two passes are those of every
//! hard row, see the module above. One sweep is far from the solution of a large mesh, and impulses that only ever add
//! up what is left would ring: so the first pass is a soft constraint \[Catto GDC11\], whose impulse leaks.

use crate::body::NONE;
use crate::math::{Float, Vec3};
use crate::simd::{Lane, Quad, Sym3, V3};
use crate::solver::SubStep;
use crate::solver::rows::{Gathered, Rows};

/// N ball joints that share no body.
#[derive(Clone, Copy, Debug)]
pub struct BallBlock<L: Lane> {
    a: L::Index,
    b: L::Index,
    /// Indices of the joints; [`NONE`] in lanes that stand empty.
    pub source: L::Index,
    /// Arms when the step began.
    start: [V3<L>; 2],
    /// From the centre of A to that of B when the step began.
    offset: V3<L>,
    /// Arms to the middle, now.
    arm: [V3<L>; 2],
    /// From A's point to B's, now.
    d: V3<L>,
    /// K⁻¹.
    mass: Sym3<L>,
    /// What Ċ is to become.
    aim: V3<L>,
    /// Impulse of this sub-step.
    pub lambda: V3<L>,
    /// Sum over the step.
    pub total: V3<L>,
}

/// What a block is made from, for one lane.
#[derive(Clone, Copy, Debug)]
pub struct BallSeed {
    /// Of the joint.
    pub source: u32,
    /// Solver rows.
    pub bodies: [u32; 2],
    /// Arms, world axes \[m\].
    pub arm: [Vec3; 2],
    /// Centre of B minus centre of A \[m\].
    pub offset: Vec3,
    /// First impulse \[N s\].
    pub lambda: Vec3,
}

/// R v of the rotation (u, w).
#[inline(always)]
fn turned<L: Lane>(u: V3<L>, w: L, v: V3<L>) -> V3<L> {
    let t = u.cross(v).times(L::splat(2.0));
    v + t.times(w) + u.cross(t)
}

/// The inverse of a symmetric matrix; 0 where it has none.
#[inline(always)]
fn inverse<L: Lane>(m: &Sym3<L>) -> Sym3<L> {
    let xx = m.yy * m.zz - m.yz * m.yz;
    let xy = m.xz * m.yz - m.xy * m.zz;
    let xz = m.xy * m.yz - m.xz * m.yy;
    let det = m.xx * xx + m.xy * xy + m.xz * xz;
    let there = det.gt(L::zero());
    let inv = L::select(there, L::splat(1.0).over(L::select(there, det, L::splat(1.0))), L::zero());
    Sym3 {
        xx: xx * inv,
        xy: xy * inv,
        xz: xz * inv,
        yy: (m.xx * m.zz - m.xz * m.xz) * inv,
        yz: (m.xy * m.xz - m.xx * m.yz) * inv,
        zz: (m.xx * m.yy - m.xy * m.xy) * inv,
    }
}

/// −r× I⁻¹ r×, added to `k`.
#[inline(always)]
fn add_lever<L: Lane>(k: &mut Sym3<L>, r: V3<L>, inv: &Sym3<L>) {
    let zero = L::zero();
    // Columns of r×, that is e_x × … with the sign turned: r × e_k.
    let cx = V3::new(zero, r.z, -r.y);
    let cy = V3::new(-r.z, zero, r.x);
    let cz = V3::new(r.y, -r.x, zero);
    let (ix, iy, iz) = (inv.times(cx), inv.times(cy), inv.times(cz));
    k.xx = k.xx + cx.dot(ix);
    k.xy = k.xy + cx.dot(iy);
    k.xz = k.xz + cx.dot(iz);
    k.yy = k.yy + cy.dot(iy);
    k.yz = k.yz + cy.dot(iz);
    k.zz = k.zz + cz.dot(iz);
}

impl<L: Lane> BallBlock<L> {
    /// A block of up to N joints.
    pub fn new(seeds: &[BallSeed], rows: &Rows) -> Self {
        let zero = V3::zero();
        let nothing = L::zero();
        let mut block = Self {
            a: L::same_index(0),
            b: L::same_index(0),
            source: L::same_index(NONE),
            start: [zero; 2],
            offset: zero,
            arm: [zero; 2],
            d: zero,
            mass: Sym3 { xx: nothing, xy: nothing, xz: nothing, yy: nothing, yz: nothing, zz: nothing },
            aim: zero,
            lambda: zero,
            total: zero,
        };
        for (lane, seed) in seeds.iter().enumerate() {
            block.a.as_mut()[lane] = seed.bodies[0];
            block.b.as_mut()[lane] = seed.bodies[1];
            block.source.as_mut()[lane] = seed.source;
            block.start[0].put(lane, seed.arm[0]);
            block.start[1].put(lane, seed.arm[1]);
            block.offset.put(lane, seed.offset);
            block.lambda.put(lane, seed.lambda);
        }
        block.place(rows);
        block
    }

    /// Arms, error and K⁻¹ at the present places.
    #[inline(always)]
    fn place(&mut self, rows: &Rows) {
        let (xa, ua, wa) = rows.gather_moves::<L>(&self.a);
        let (xb, ub, wb) = rows.gather_moves::<L>(&self.b);
        let (ra, rb) = (turned(ua, wa, self.start[0]), turned(ub, wb, self.start[1]));
        self.d = self.offset + (xb - xa) + (rb - ra);
        let half = self.d.times(L::splat(0.5));
        self.arm = [ra + half, rb - half];
        let (a, b) = (rows.gather::<L>(&self.a), rows.gather::<L>(&self.b));
        let (m, zero) = (a.inv_mass + b.inv_mass, L::zero());
        let mut k = Sym3 { xx: m, xy: zero, xz: zero, yy: m, yz: zero, zz: m };
        add_lever(&mut k, self.arm[0], &a.inv_inertia);
        add_lever(&mut k, self.arm[1], &b.inv_inertia);
        self.mass = inverse(&k);
    }

    #[inline(always)]
    fn speed(&self, a: &Gathered<L>, b: &Gathered<L>) -> V3<L> {
        b.v + b.w.cross(self.arm[1]) - a.v - a.w.cross(self.arm[0])
    }

    #[inline(always)]
    fn apply(&self, p: V3<L>, a: &mut Gathered<L>, b: &mut Gathered<L>) {
        a.v = a.v - p.times(a.inv_mass);
        a.w = a.w - a.inv_inertia.times(self.arm[0].cross(p));
        b.v = b.v + p.times(b.inv_mass);
        b.w = b.w + b.inv_inertia.times(self.arm[1].cross(p));
    }

    /// Applies the impulse of the last sub-step again.
    #[inline(always)]
    pub fn warm_start(&self, rows: &mut Rows) {
        let (mut a, mut b) = (rows.gather::<L>(&self.a), rows.gather::<L>(&self.b));
        self.apply(self.lambda, &mut a, &mut b);
        rows.scatter::<L>(&self.a, &a);
        rows.scatter::<L>(&self.b, &b);
    }

    /// What the first pass is after; `ahead` says where bodies would be if nothing changed.
    #[inline(always)]
    pub fn look_ahead(&mut self, rows: &Rows, ahead: &[[Quad; 2]], rate: Float, push: Float, sub: &SubStep) {
        let gather = |index: &L::Index| {
            let index = index.as_ref();
            let [x, y, z, _] = L::gather(|i| ahead[index[i] as usize][0]);
            let [qx, qy, qz, qw] = L::gather(|i| ahead[index[i] as usize][1]);
            (V3::new(x, y, z), V3::new(qx, qy, qz), qw)
        };
        let ((xa, ua, wa), (xb, ub, wb)) = (gather(&self.a), gather(&self.b));
        let (ra, rb) = (turned(ua, wa, self.start[0]), turned(ub, wb, self.start[1]));
        let predicted = self.offset + (xb - xa) + (rb - ra);
        let inv_h = L::splat(sub.inv_h);
        let rate = L::splat(rate);
        let size = self.d.dot(self.d).sqrt() * rate;
        let most = L::splat(push);
        let beyond = size.gt(most);
        let rate = L::select(beyond, rate * most.over(L::select(beyond, size, most)), rate);
        let (a, b) = (rows.gather::<L>(&self.a), rows.gather::<L>(&self.b));
        self.aim = self.speed(&a, &b) - self.d.times(rate) - (predicted - self.d).times(inv_h);
    }

    /// One sweep towards the aim, by this share of the way and with this share of the impulse leaking.
    #[inline(always)]
    pub fn solve(&mut self, rows: &mut Rows, share: Float, leak: Float) {
        let (mut a, mut b) = (rows.gather::<L>(&self.a), rows.gather::<L>(&self.b));
        let p = self.mass.times(self.aim - self.speed(&a, &b)).times(L::splat(share))
            - self.lambda.times(L::splat(leak));
        self.lambda = self.lambda + p;
        self.apply(p, &mut a, &mut b);
        rows.scatter::<L>(&self.a, &a);
        rows.scatter::<L>(&self.b, &b);
    }

    /// Before the relax pass, at the new places.
    #[inline(always)]
    pub fn begin_relax(&mut self, rows: &Rows) {
        self.place(rows);
        self.aim = V3::zero();
    }

    /// After it.
    #[inline(always)]
    pub fn end(&mut self) {
        self.total = self.total + self.lambda;
    }
}
