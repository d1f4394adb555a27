//! The contact constraint, for N contacts side by side.
//!
//! Normal row of one point, with n from A to B, arms r from the centres of mass to the shared point p:
//!   C = s + n · (Δ_B − Δ_A),   Ċ = n · (v_B + ω_B × r_B − v_A − ω_A × r_A)
//!   m_eff = 1 / (1/m_A + 1/m_B + (r_A×n)·I_A⁻¹(r_A×n) + (r_B×n)·I_B⁻¹(r_B×n))
//! Apart (C > 0) the row only keeps the gap from closing within the sub-step: Ċ ≥ −C/h. Overlapping it is a soft
//! spring [Catto GDC11, Catto Solver2D] whose impulse leaks towards a slowly filtered *memory* of itself instead
//! of towards 0, so that a steady load needs no overlap:
//!   Δλ = −m_eff · mass_scale · (Ċ + rate·C) − impulse_scale · (λ − memory),   λ ≥ 0
//! The relax pass repeats the row with rate = 0 and no softness, after positions were moved: it takes the push-out
//! speed away again.
//!
//! Friction acts at one point a manifold, the centre of its load: a 2×2 block along two tangents, cut to a circle
//! of radius μ Σλ; with more than one point also a torque about the normal, cut to μ Σ λ_i d_i with d_i the
//! distance of point i from the centre.
//!
//! An impact within the sub-step is resolved at its own time t* (see [`Impact`]).
//!
//! Legend: v ω velocity, r arm, n normal, t tangent, s separation, λ impulse, μ friction, h sub-step.

use crate::math::Float;
use crate::simd::{Lane, V3};
use crate::solver::SubStep;
use crate::solver::rows::{Gathered, Rows, turned_back_minus};

/// One contact point in each lane.
#[derive(Clone, Copy, Debug)]
pub struct Point<L> {
    /// From A's centre of mass, world axes.
    pub r: V3<L>,
    /// Gap when the step began.
    pub separation: L,
    /// Effective mass of the normal row.
    pub mass: L,
    /// Normal impulse.
    pub lambda: L,
    /// Filtered normal impulse.
    pub memory: L,
    /// Sum of the normal impulses over the sub-steps.
    pub total: L,
}

/// N contacts of up to P points; `F` is the friction they have, `R` their restitution.
#[derive(Clone, Copy, Debug)]
pub struct ContactBlock<L: Lane, const P: usize, F, R> {
    /// Solver rows of A.
    pub a: L::Index,
    /// Solver rows of B.
    pub b: L::Index,
    /// Stable indices of the contacts; [`crate::body::NONE`] in lanes that stand empty.
    pub source: L::Index,
    /// From A to B.
    pub normal: V3<L>,
    /// Centre of A minus centre of B, so that r_B = r_A + offset.
    pub offset: V3<L>,
    /// Radii of the rounding of A and B; only contacts of up to two points have any.
    pub rounding: [L; 2],
    /// How soft the contacts are: push-out rate \[1/s\], mass scale, impulse scale, greatest push-out speed \[m/s\].
    pub soft: [L; 4],
    /// The points; lanes with fewer have massless ones.
    pub points: [Point<L>; P],
    /// Friction.
    pub friction: F,
    /// Restitution.
    pub impact: R,
}

/// The friction part of a block.
pub trait FrictionPart<L: Lane, const P: usize>: Copy + Send + Sync + std::fmt::Debug + 'static {
    /// Nothing in any lane.
    fn empty() -> Self;
    /// The part that all kinds of friction share, where there is one.
    fn dry(&mut self) -> Option<&mut Friction<L, P>>;
    /// What only some contacts have, where there is one.
    fn extra(&mut self) -> Option<&mut Extra<L>>;
    /// Effective masses, from the bodies at the start of the step.
    fn prepare(&mut self, n: V3<L>, offset: V3<L>, points: &[Point<L>; P], a: &Gathered<L>, b: &Gathered<L>);
    /// Applies the impulses of the last step.
    fn warm_start(&self, n: V3<L>, offset: V3<L>, a: &mut Gathered<L>, b: &mut Gathered<L>);
    /// One sweep. `last` in the relax pass: impulses are added to the step's sum.
    fn solve(
        &mut self,
        n: V3<L>,
        offset: V3<L>,
        points: &[Point<L>; P],
        a: &mut Gathered<L>,
        b: &mut Gathered<L>,
        last: bool,
    );
}

/// No friction.
#[derive(Clone, Copy, Debug)]
pub struct NoFriction;

/// Dry friction at the centre of the load.
#[derive(Clone, Copy, Debug)]
pub struct Friction<L, const P: usize> {
    /// The centre, from A's centre of mass.
    pub r: V3<L>,
    /// Sliding coefficient.
    pub mu: L,
    /// Static coefficient.
    pub mu_static: L,
    /// Inverse of the 2×2 block: 11, 12, 22.
    pub mass: [L; 3],
    /// Impulses along the tangents.
    pub lambda: [L; 2],
    /// Sums of them over the sub-steps.
    pub total: [L; 2],
    /// Distance of each point from the centre.
    pub lever: [L; P],
    /// Effective mass about the normal.
    pub twist_mass: L,
    /// Impulse about the normal.
    pub twist: L,
}

/// Rolling resistance and conveyor velocity, which few contacts have.
#[derive(Clone, Copy, Debug)]
pub struct Extra<L> {
    /// Lever of the rolling resistance.
    pub lever: L,
    /// Inverse of its 2×2 block: 11, 12, 22.
    pub mass: [L; 3],
    /// Its impulses about the tangents.
    pub lambda: [L; 2],
    /// Velocity of B's surface against A's along the tangents.
    pub conveyor: [L; 2],
}

/// Dry friction with rolling resistance and conveyor velocity.
#[derive(Clone, Copy, Debug)]
pub struct FullFriction<L, const P: usize> {
    /// Dry friction.
    pub dry: Friction<L, P>,
    /// The rest.
    pub extra: Extra<L>,
}

/// Restitution of the points of a block. An impact predicted for the sub-step, at the time t* in it when the gap
/// closes, is reflected there and the rest of the sub-step flown freely: the first sweep gives the point the mean
/// normal velocity that leads to the right place, the relax pass the normal velocity that it has then.
#[derive(Clone, Copy, Debug)]
pub struct Impact<L, const P: usize> {
    /// Coefficient of restitution.
    pub restitution: L,
    /// 1 where an impact happens in this sub-step.
    pub on: [L; P],
    /// Mean normal velocity over the sub-step.
    pub mean: [L; P],
    /// Normal velocity at its end.
    pub end: [L; P],
}

/// No restitution.
#[derive(Clone, Copy, Debug)]
pub struct NoImpact;

/// The restitution part of a block.
pub trait ImpactPart<L: Lane, const P: usize>: Copy + Send + Sync + std::fmt::Debug + 'static {
    /// Nothing in any lane.
    fn empty() -> Self;
    /// The data, where there are any.
    fn get(&mut self) -> Option<&mut Impact<L, P>>;
    /// For point `k`: where an impact is on, and its target velocity in the first sweep or in the relax pass.
    fn target(&self, k: usize, relax: bool) -> Option<(L::Mask, L)>;
    /// Where any point has an impact.
    fn struck(&self) -> Option<L::Mask>;
}

/// Sweeps over the points of a manifold that an impact struck. An impact has no next sub-step to be put right in: with
/// one sweep the point that comes first would take most of it, and turn a slender body about its length.
const IMPACT_SWEEPS: usize = 16;

/// What changes a point's velocity by more than this \[m/s\] is an impact, too, if nothing bounces.
const IMPACT_SPEED: Float = 0.1;

impl<L: Lane, const P: usize> ImpactPart<L, P> for NoImpact {
    #[inline(always)]
    fn empty() -> Self {
        Self
    }
    #[inline(always)]
    fn get(&mut self) -> Option<&mut Impact<L, P>> {
        None
    }
    #[inline(always)]
    fn target(&self, _: usize, _: bool) -> Option<(L::Mask, L)> {
        None
    }
    #[inline(always)]
    fn struck(&self) -> Option<L::Mask> {
        None
    }
}

impl<L: Lane, const P: usize> ImpactPart<L, P> for Impact<L, P> {
    fn empty() -> Self {
        let zero = [L::zero(); P];
        Self { restitution: L::zero(), on: zero, mean: zero, end: zero }
    }
    #[inline(always)]
    fn get(&mut self) -> Option<&mut Impact<L, P>> {
        Some(self)
    }
    #[inline(always)]
    fn target(&self, k: usize, relax: bool) -> Option<(L::Mask, L)> {
        Some((self.on[k].gt(L::zero()), if relax { self.end[k] } else { self.mean[k] }))
    }
    #[inline(always)]
    fn struck(&self) -> Option<L::Mask> {
        Some(self.on.iter().fold(L::zero(), |most, &on| most.max(on)).gt(L::zero()))
    }
}

/// Gives B the impulse `p` and the angular impulse `r_b × p`, A the opposite at `r_a`.
#[inline(always)]
fn apply<L: Lane>(a: &mut Gathered<L>, b: &mut Gathered<L>, p: V3<L>, ra: V3<L>, rb: V3<L>) {
    a.v = a.v - p.times(a.inv_mass);
    a.w = a.w - a.inv_inertia.times(ra.cross(p));
    b.v = b.v + p.times(b.inv_mass);
    b.w = b.w + b.inv_inertia.times(rb.cross(p));
}

/// Gives B the angular impulse `l`, A the opposite.
#[inline(always)]
fn apply_angular<L: Lane>(a: &mut Gathered<L>, b: &mut Gathered<L>, l: V3<L>) {
    a.w = a.w - a.inv_inertia.times(l);
    b.w = b.w + b.inv_inertia.times(l);
}

/// Two unit vectors at right angles to n and each other (Duff et al., JCGT 2017).
#[inline(always)]
pub fn tangents<L: Lane>(n: V3<L>) -> [V3<L>; 2] {
    let one = L::splat(1.0);
    let s = L::select(L::zero().gt(n.z), -one, one);
    let k = (-one).over(s + n.z);
    let t = V3::new(one + s * n.x * n.x * k, s * n.x * n.y * k, -(s * n.x));
    [t, n.cross(t)]
}

/// The inverse of the symmetric 2×2 matrix (11, 12, 22); 0 where it has none.
#[inline(always)]
fn inverse2<L: Lane>(k11: L, k12: L, k22: L) -> [L; 3] {
    let det = k11 * k22 - k12 * k12;
    let there = det.gt(L::zero());
    let inv = L::select(there, L::splat(1.0).over(L::select(there, det, L::splat(1.0))), L::zero());
    [k22 * inv, -(k12 * inv), k11 * inv]
}

/// 1/k, 0 where k is not positive.
#[inline(always)]
fn inverse<L: Lane>(k: L) -> L {
    let there = k.gt(L::zero());
    L::select(there, L::splat(1.0).over(L::select(there, k, L::splat(1.0))), L::zero())
}

impl<L: Lane, const P: usize> FrictionPart<L, P> for NoFriction {
    #[inline(always)]
    fn empty() -> Self {
        Self
    }
    #[inline(always)]
    fn dry(&mut self) -> Option<&mut Friction<L, P>> {
        None
    }
    #[inline(always)]
    fn extra(&mut self) -> Option<&mut Extra<L>> {
        None
    }
    #[inline(always)]
    fn prepare(&mut self, _: V3<L>, _: V3<L>, _: &[Point<L>; P], _: &Gathered<L>, _: &Gathered<L>) {}
    #[inline(always)]
    fn warm_start(&self, _: V3<L>, _: V3<L>, _: &mut Gathered<L>, _: &mut Gathered<L>) {}
    #[inline(always)]
    fn solve(
        &mut self,
        _: V3<L>,
        _: V3<L>,
        _: &[Point<L>; P],
        _: &mut Gathered<L>,
        _: &mut Gathered<L>,
        _: bool,
    ) {
    }
}

impl<L: Lane, const P: usize> Friction<L, P> {
    /// One sweep, with the surface of B moving at `conveyor` against that of A.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn sweep(
        &mut self,
        n: V3<L>,
        offset: V3<L>,
        points: &[Point<L>; P],
        a: &mut Gathered<L>,
        b: &mut Gathered<L>,
        conveyor: Option<[L; 2]>,
        last: bool,
    ) {
        let mut load = points[0].lambda;
        for p in &points[1..] {
            load = load + p.lambda;
        }
        let t = tangents(n);
        let (ra, rb) = (self.r, self.r + offset);
        let v = b.v + b.w.cross(rb) - a.v - a.w.cross(ra);
        let (mut v0, mut v1) = (v.dot(t[0]), v.dot(t[1]));
        if let Some(c) = conveyor {
            v0 = v0 + c[0];
            v1 = v1 + c[1];
        }
        let [m11, m12, m22] = self.mass;
        let x = self.lambda[0] - (m11 * v0 + m12 * v1);
        let y = self.lambda[1] - (m12 * v0 + m22 * v1);
        // The circle: beyond the static limit the surfaces slide, and the sliding coefficient holds.
        let size2 = x * x + y * y;
        let sticks_up_to = self.mu_static * load;
        let slides = size2.gt(sticks_up_to * sticks_up_to);
        let one = L::splat(1.0);
        // Sliding friction opposes the slip itself: along the block's inverse times the slip it would not, where the
        // bodies yield more in one direction than in another.
        let step = (m11 + m22) * L::splat(0.5);
        let (sx, sy) = (self.lambda[0] - step * v0, self.lambda[1] - step * v1);
        let size = L::select(slides, sx * sx + sy * sy, one).sqrt();
        let cut = (self.mu * load).over(L::select(size.gt(L::zero()), size, one));
        let x = L::select(slides, sx * cut, x);
        let y = L::select(slides, sy * cut, y);
        let p = t[0].times(x - self.lambda[0]) + t[1].times(y - self.lambda[1]);
        self.lambda = [x, y];
        apply(a, b, p, ra, rb);

        if P > 1 {
            let mut limit = L::zero();
            for (p, &lever) in points.iter().zip(&self.lever) {
                limit = limit + p.lambda * lever;
            }
            let limit = limit * self.mu;
            let wn = n.dot(b.w - a.w);
            let new = (self.twist - self.twist_mass * wn).max(-limit).min(limit);
            let l = n.times(new - self.twist);
            self.twist = new;
            apply_angular(a, b, l);
        }
        if last {
            self.total = [self.total[0] + self.lambda[0], self.total[1] + self.lambda[1]];
        }
    }
}

impl<L: Lane, const P: usize> FrictionPart<L, P> for Friction<L, P> {
    fn empty() -> Self {
        let zero = L::zero();
        Self {
            r: V3::zero(),
            mu: zero,
            mu_static: zero,
            mass: [zero; 3],
            lambda: [zero; 2],
            total: [zero; 2],
            lever: [zero; P],
            twist_mass: zero,
            twist: zero,
        }
    }
    #[inline(always)]
    fn dry(&mut self) -> Option<&mut Friction<L, P>> {
        Some(self)
    }
    #[inline(always)]
    fn extra(&mut self) -> Option<&mut Extra<L>> {
        None
    }

    #[inline(always)]
    fn prepare(&mut self, n: V3<L>, offset: V3<L>, points: &[Point<L>; P], a: &Gathered<L>, b: &Gathered<L>) {
        let t = tangents(n);
        let (ra, rb) = (self.r, self.r + offset);
        let arms = |u: V3<L>| (ra.cross(u), rb.cross(u));
        let ((a0, b0), (a1, b1)) = (arms(t[0]), arms(t[1]));
        let (ia0, ib0) = (a.inv_inertia.times(a0), b.inv_inertia.times(b0));
        let (ia1, ib1) = (a.inv_inertia.times(a1), b.inv_inertia.times(b1));
        let m = a.inv_mass + b.inv_mass;
        self.mass =
            inverse2(m + a0.dot(ia0) + b0.dot(ib0), a0.dot(ia1) + b0.dot(ib1), m + a1.dot(ia1) + b1.dot(ib1));
        if P > 1 {
            let k = n.dot(a.inv_inertia.times(n)) + n.dot(b.inv_inertia.times(n));
            self.twist_mass = inverse(k);
            for (lever, p) in self.lever.iter_mut().zip(points) {
                let d = p.r - self.r;
                let d = d - n.times(n.dot(d));
                *lever = d.dot(d).sqrt();
            }
        }
    }

    #[inline(always)]
    fn warm_start(&self, n: V3<L>, offset: V3<L>, a: &mut Gathered<L>, b: &mut Gathered<L>) {
        let t = tangents(n);
        let p = t[0].times(self.lambda[0]) + t[1].times(self.lambda[1]);
        apply(a, b, p, self.r, self.r + offset);
        if P > 1 {
            apply_angular(a, b, n.times(self.twist));
        }
    }

    #[inline(always)]
    fn solve(
        &mut self,
        n: V3<L>,
        offset: V3<L>,
        points: &[Point<L>; P],
        a: &mut Gathered<L>,
        b: &mut Gathered<L>,
        last: bool,
    ) {
        self.sweep(n, offset, points, a, b, None, last);
    }
}

impl<L: Lane, const P: usize> FrictionPart<L, P> for FullFriction<L, P> {
    fn empty() -> Self {
        let zero = L::zero();
        Self {
            dry: <Friction<L, P> as FrictionPart<L, P>>::empty(),
            extra: Extra { lever: zero, mass: [zero; 3], lambda: [zero; 2], conveyor: [zero; 2] },
        }
    }
    #[inline(always)]
    fn dry(&mut self) -> Option<&mut Friction<L, P>> {
        Some(&mut self.dry)
    }
    #[inline(always)]
    fn extra(&mut self) -> Option<&mut Extra<L>> {
        Some(&mut self.extra)
    }

    #[inline(always)]
    fn prepare(&mut self, n: V3<L>, offset: V3<L>, points: &[Point<L>; P], a: &Gathered<L>, b: &Gathered<L>) {
        self.dry.prepare(n, offset, points, a, b);
        let t = tangents(n);
        let along = |u: V3<L>| a.inv_inertia.times(u) + b.inv_inertia.times(u);
        let (k0, k1) = (along(t[0]), along(t[1]));
        self.extra.mass = inverse2(t[0].dot(k0), t[0].dot(k1), t[1].dot(k1));
    }

    #[inline(always)]
    fn warm_start(&self, n: V3<L>, offset: V3<L>, a: &mut Gathered<L>, b: &mut Gathered<L>) {
        self.dry.warm_start(n, offset, a, b);
        let t = tangents(n);
        apply_angular(a, b, t[0].times(self.extra.lambda[0]) + t[1].times(self.extra.lambda[1]));
    }

    #[inline(always)]
    fn solve(
        &mut self,
        n: V3<L>,
        offset: V3<L>,
        points: &[Point<L>; P],
        a: &mut Gathered<L>,
        b: &mut Gathered<L>,
        last: bool,
    ) {
        // Rolling resistance: a torque against the relative turning about the tangents, up to lever · Σλ.
        let e = &mut self.extra;
        let mut load = points[0].lambda;
        for p in &points[1..] {
            load = load + p.lambda;
        }
        let t = tangents(n);
        let w = b.w - a.w;
        let (w0, w1) = (w.dot(t[0]), w.dot(t[1]));
        let [m11, m12, m22] = e.mass;
        let x = e.lambda[0] - (m11 * w0 + m12 * w1);
        let y = e.lambda[1] - (m12 * w0 + m22 * w1);
        let (size2, limit, one) = (x * x + y * y, e.lever * load, L::splat(1.0));
        let beyond = size2.gt(limit * limit);
        let cut = L::select(beyond, limit.over(L::select(beyond, size2, one).sqrt()), one);
        let (x, y) = (x * cut, y * cut);
        apply_angular(a, b, t[0].times(x - e.lambda[0]) + t[1].times(y - e.lambda[1]));
        e.lambda = [x, y];
        let conveyor = e.conveyor;
        self.dry.sweep(n, offset, points, a, b, Some(conveyor), last);
    }
}

impl<L: Lane, const P: usize, F: FrictionPart<L, P>, R: ImpactPart<L, P>> ContactBlock<L, P, F, R> {
    /// A block without contacts.
    pub fn empty() -> Self {
        let zero = L::zero();
        let point =
            Point { r: V3::zero(), separation: zero, mass: zero, lambda: zero, memory: zero, total: zero };
        Self {
            a: L::same_index(0),
            b: L::same_index(0),
            source: L::same_index(crate::body::NONE),
            // A unit normal, so that empty lanes compute harmless numbers.
            normal: V3::new(zero, zero, L::splat(1.0)),
            offset: V3::zero(),
            rounding: [zero; 2],
            soft: [zero; 4],
            points: [point; P],
            friction: F::empty(),
            impact: R::empty(),
        }
    }

    /// Effective masses, from the bodies at the start of the step.
    #[inline(always)]
    pub fn prepare(&mut self, rows: &Rows) {
        let (a, b) = (rows.gather::<L>(&self.a), rows.gather::<L>(&self.b));
        let m = a.inv_mass + b.inv_mass;
        for p in &mut self.points {
            let (xa, xb) = (p.r.cross(self.normal), (p.r + self.offset).cross(self.normal));
            let k = m + xa.dot(a.inv_inertia.times(xa)) + xb.dot(b.inv_inertia.times(xb));
            // Lanes with fewer points were given mass 0 for those they lack, 1 for the others.
            p.mass = p.mass * inverse(k);
        }
        self.friction.prepare(self.normal, self.offset, &self.points, &a, &b);
    }

    /// Applies the impulses of the last step.
    #[inline(always)]
    pub fn warm_start(&self, rows: &mut Rows) {
        let (mut a, mut b) = (rows.gather::<L>(&self.a), rows.gather::<L>(&self.b));
        for p in &self.points {
            apply(&mut a, &mut b, self.normal.times(p.lambda), p.r, p.r + self.offset);
        }
        self.friction.warm_start(self.normal, self.offset, &mut a, &mut b);
        rows.scatter::<L>(&self.a, &a);
        rows.scatter::<L>(&self.b, &b);
    }

    /// One sweep: soft with push-out, or (`RELAX`) rigid without; impulses of the `LAST` of a sub-step are summed up.
    #[inline(always)]
    pub fn solve<const RELAX: bool, const LAST: bool>(&mut self, rows: &mut Rows, sub: &SubStep) {
        let (mut a, mut b) = (rows.gather::<L>(&self.a), rows.gather::<L>(&self.b));
        let (n, zero, one) = (self.normal, L::zero(), L::splat(1.0));

        // How far the gap of a point has changed since the step began: n·(Δx_B − Δx_A) + r_B·m_B − r_A·m_A.
        let (xa, ua, sa) = rows.gather_moves::<L>(&self.a);
        let (xb, ub, sb) = rows.gather_moves::<L>(&self.b);
        let mut shift = n.dot(xb - xa);
        let (ma, mb) = (turned_back_minus(ua, sa, n), turned_back_minus(ub, sb, n));
        if P < 4 {
            // What turns is the core of a rounded shape, not the point of its surface that touches.
            shift = shift + (self.rounding[0] * n.dot(ma) + self.rounding[1] * n.dot(mb));
        }

        let [rate, mass_scale, impulse_scale, push_out] = self.soft;
        let stiffness = mass_scale * rate;
        let (inv_h, push_out) = (L::splat(sub.inv_h), -push_out);

        self.friction.solve(n, self.offset, &self.points, &mut a, &mut b, LAST);
        // 1 in lanes that an impact struck.
        let mut struck = self.impact.struck().map_or(zero, |struck| L::select(struck, one, zero));
        for round in 0..IMPACT_SWEEPS {
            if round > 0 && (P == 1 || !L::any(struck.gt(zero))) {
                break;
            }
            for (k, p) in self.points.iter_mut().enumerate() {
                let (ra, rb) = (p.r, p.r + self.offset);
                let (ka, kb) = (ra.cross(n), rb.cross(n));
                let s = p.separation + (shift + (rb.dot(mb) - ra.dot(ma)));
                let v = n.dot(b.v - a.v) + (kb.dot(b.w) - ka.dot(a.w));

                let apart = (s * p.mass * stiffness).gt(impulse_scale * p.memory);
                let mut bias =
                    L::select(apart, s * inv_h, if RELAX { zero } else { (rate * s).max(push_out) });
                let mut scale = if RELAX { one } else { L::select(apart, one, mass_scale) };
                let mut leak = if RELAX { zero } else { L::select(apart, zero, impulse_scale) };
                if let Some((on, target)) = self.impact.target(k, RELAX) {
                    bias = L::select(on, -target, bias);
                    scale = L::select(on, one, scale);
                    leak = L::select(on, zero, leak);
                }
                let (ta, tb) = (a.inv_inertia.times(ka), b.inv_inertia.times(kb));
                let mut mass = p.mass;
                if round > 0 {
                    // That of the step's start is wrong where bodies have turned, which many sweeps would blow up.
                    let now = inverse(a.inv_mass + b.inv_mass + ka.dot(ta) + kb.dot(tb));
                    mass = L::select(mass.gt(zero), now, zero);
                }
                let change = -(mass * scale * (v + bias)) - leak * (p.lambda - p.memory);
                let mut lambda = (p.lambda + change).max(zero);
                if round > 0 {
                    // Lanes without an impact stay as they are after the first round, whoever is beside them.
                    lambda = L::select(struck.gt(zero), lambda, p.lambda);
                }
                let change = lambda - p.lambda;
                if P > 1 && round == 0 {
                    let size = change.max(-change);
                    struck = L::select(size.gt(p.mass * L::splat(IMPACT_SPEED)), one, struck);
                }
                p.lambda = lambda;
                if LAST {
                    p.total = p.total + if round == 0 { lambda } else { change };
                }
                let (pa, pb) = (change * a.inv_mass, change * b.inv_mass);
                a.v = a.v - n.times(pa);
                b.v = b.v + n.times(pb);
                a.w = a.w - ta.times(change);
                b.w = b.w + tb.times(change);
            }
        }
        rows.scatter::<L>(&self.a, &a);
        rows.scatter::<L>(&self.b, &b);
    }
}
