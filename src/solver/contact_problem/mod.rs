//! All contacts of an island as one dense problem, in double precision whatever [`crate::Float`] is.
//!
//! For K points with the axes (n, t₁, t₂), n from A to B, the relative velocities after the impulses λ are
//!   σ = W λ + b,   W = J M⁻¹ Jᵀ (3K × 3K, symmetric, positive semi-definite),   b = J v_free − target
//! and Coulomb's law with Signorini's condition asks, for each point,
//!   λ_n ≥ 0, σ_n ≥ 0, λ_n σ_n = 0,   |λ_t| ≤ μ λ_n, and λ_t = −μ λ_n σ_t/|σ_t| where it slides.
//! With De Saxcé's correction this is one complementarity between a cone and its dual \[De Saxcé, Feng 1998\]:
//!   K_μ ∋ λ ⊥ σ + (μ|σ_t|, 0, 0) ∈ K_μ*.
//! The error of any λ is measured by the natural map of that, in m/s: see [`ContactProblem::residual`].
//!
//! The files beside this one ([`super::lemke`], [`super::dantzig`], [`super::proximal_admm`]) solve it, each in
//! its own way; [`gauss_seidel`] is the yardstick. Each leaves with a [`Status`].

pub mod dense;
pub mod gauss_seidel;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;

use nalgebra::Vector3;

/// A vector in double precision.
pub type V = Vector3<f64>;

/// Friction coefficients are cut here: 89.994°. Beyond it products with impulses only lose digits.
pub const GREATEST_FRICTION: f64 = 1e4;

/// How a solver ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Status {
    /// The tolerance was reached.
    #[default]
    Solved,
    /// Out of iterations, but the residual is below [`ROUGH`] of the problem's scale: good enough to be used.
    Rough,
    /// Out of iterations.
    IterationLimit,
    /// Nothing improves any more, far from a solution: rounding, or a step of no length.
    Stalled,
    /// A ray: impulses can grow without bound and do not help. The problem has no solution, as for a body wedged
    /// between immovable ones that close in, or none that this method finds.
    Ray,
    /// Normals are solved, but friction limits did not settle.
    FrictionUnsettled,
    /// More points than the method is meant for.
    TooLarge,
    /// A number of the problem is NaN or infinite.
    NotFinite,
}

impl Status {
    /// Every way out.
    pub const ALL: [Status; 8] = [
        Status::Solved,
        Status::Rough,
        Status::IterationLimit,
        Status::Stalled,
        Status::Ray,
        Status::FrictionUnsettled,
        Status::TooLarge,
        Status::NotFinite,
    ];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Status::Solved => "solved",
            Status::Rough => "rough",
            Status::IterationLimit => "iteration_limit",
            Status::Stalled => "stalled",
            Status::Ray => "ray",
            Status::FrictionUnsettled => "friction_unsettled",
            Status::TooLarge => "too_large",
            Status::NotFinite => "not_finite",
        }
    }

    /// Whether the impulses are worth using.
    #[must_use]
    pub fn is_usable(self) -> bool {
        matches!(self, Status::Solved | Status::Rough)
    }
}

/// Up to this share of [`ContactProblem::scale`] a residual is good enough to be used.
pub const ROUGH: f64 = 1e-3;

/// How a solver ended, and how well.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outcome {
    /// How.
    pub status: Status,
    /// Pivots or iterations.
    pub iterations: usize,
    /// What the method itself aims at, as said by it \[m/s\].
    pub residual: f64,
}

impl Outcome {
    /// Nothing was computed.
    #[must_use]
    pub fn refused(status: Status) -> Self {
        Self { status, iterations: 0, residual: f64::INFINITY }
    }
}

/// The place of immovable bodies in a [`PointArms`].
pub const IMMOVABLE: usize = usize::MAX;

/// What of a point makes its rows of W.
#[derive(Clone, Copy, Debug)]
pub struct PointArms {
    /// Places of A and B in the list of masses, or [`IMMOVABLE`].
    pub bodies: [usize; 2],
    /// n, t₁, t₂.
    pub axes: [V; 3],
    /// From the centres of mass to the point \[m\].
    pub arms: [V; 2],
}

/// What resists.
#[derive(Clone, Copy, Debug)]
pub struct Mass {
    /// \[1/kg\]
    pub inv_mass: f64,
    /// I_w⁻¹: xx, xy, xz, yy, yz, zz \[1/(kg m²)\].
    pub inv_inertia: [f64; 6],
}

impl Mass {
    fn turned_by(&self, l: &V) -> V {
        let [xx, xy, xz, yy, yz, zz] = self.inv_inertia;
        V::new(xx * l.x + xy * l.y + xz * l.z, xy * l.x + yy * l.y + yz * l.z, xz * l.x + yz * l.y + zz * l.z)
    }
}

/// See the module.
#[derive(Clone, Debug, Default)]
pub struct ContactProblem {
    count: usize,
    /// W, row after row.
    pub w: Vec<f64>,
    /// Free velocity less target \[m/s\].
    pub b: Vec<f64>,
    /// Coefficients of friction, one a point.
    pub mu: Vec<f64>,
}

impl ContactProblem {
    /// `count` points without mass, velocity or friction.
    #[must_use]
    pub fn new(count: usize) -> Self {
        let mut problem = Self::default();
        problem.reset(count);
        problem
    }

    /// Back to `count` points without anything; memory is kept.
    pub fn reset(&mut self, count: usize) {
        self.count = count;
        let n = 3 * count;
        self.w.clear();
        self.w.resize(n * n, 0.0);
        self.b.clear();
        self.b.resize(n, 0.0);
        self.mu.clear();
        self.mu.resize(count, 0.0);
    }

    /// Number of points K.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// 3K.
    #[must_use]
    pub fn size(&self) -> usize {
        3 * self.count
    }

    /// The friction coefficient of a point, not negative and not above [`GREATEST_FRICTION`].
    #[must_use]
    pub fn friction(&self, point: usize) -> f64 {
        self.mu[point].clamp(0.0, GREATEST_FRICTION)
    }

    /// Whether a problem must be refused: the arrays do not fit, or a number is not one.
    #[must_use]
    pub fn refusal(&self) -> Option<Status> {
        let n = self.size();
        let fits = self.w.len() == n * n && self.b.len() == n && self.mu.len() == self.count;
        let finite = |x: &[f64]| x.iter().all(|v| v.is_finite());
        // Infinite friction is cut like any great one.
        let sane = fits && finite(&self.w) && finite(&self.b) && self.mu.iter().all(|m| !m.is_nan());
        if sane { None } else { Some(Status::NotFinite) }
    }

    /// Fills W from arms and masses.
    pub fn assemble(&mut self, points: &[PointArms], masses: &[Mass]) {
        self.reset(points.len());
        let n = self.size();
        for (i, p) in points.iter().enumerate() {
            for (j, q) in points.iter().enumerate().skip(i) {
                for (side_p, &body) in p.bodies.iter().enumerate() {
                    for (side_q, &other) in q.bodies.iter().enumerate() {
                        if body != other || body == IMMOVABLE {
                            continue;
                        }
                        let mass = &masses[body];
                        let sign = if side_p == side_q { 1.0 } else { -1.0 };
                        for (r, axis) in p.axes.iter().enumerate() {
                            let turn = mass.turned_by(&p.arms[side_p].cross(axis));
                            for (c, with) in q.axes.iter().enumerate() {
                                let k =
                                    axis.dot(with) * mass.inv_mass + turn.dot(&q.arms[side_q].cross(with));
                                self.w[(3 * i + r) * n + 3 * j + c] += sign * k;
                            }
                        }
                    }
                }
            }
        }
        for i in 0..n {
            for j in 0..i {
                // Blocks of the diagonal were filled as a whole; the mean of both halves is symmetric to the bit.
                let same_point = i / 3 == j / 3;
                let upper = self.w[j * n + i];
                let value = if same_point { 0.5 * (upper + self.w[i * n + j]) } else { upper };
                self.w[i * n + j] = value;
                self.w[j * n + i] = value;
            }
        }
    }

    /// The greatest diagonal element of a point's block: how easily it is moved \[1/kg\].
    #[must_use]
    pub fn mobility(&self, point: usize) -> f64 {
        let n = self.size();
        (3 * point..3 * point + 3).map(|i| self.w[i * n + i]).fold(0.0, f64::max)
    }

    /// The greatest |b|, with which residuals are compared \[m/s\].
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.b.iter().fold(0.0, |m, v| m.max(v.abs()))
    }

    /// σ = W λ + b.
    pub fn velocity(&self, lambda: &[f64], sigma: &mut Vec<f64>) {
        let n = self.size();
        sigma.clear();
        sigma.extend((0..n).map(|i| self.b[i] + dense::dot(&self.w[i * n..][..n], lambda)));
    }

    /// ½ λᵀWλ + bᵀλ: what frictionless contact, and the associated problem, minimise \[J\].
    #[must_use]
    pub fn objective(&self, lambda: &[f64]) -> f64 {
        let mut sigma = Vec::new();
        self.velocity(lambda, &mut sigma);
        0.5 * sigma.iter().zip(&self.b).zip(lambda).map(|((s, b), l)| (s + b) * l).sum::<f64>()
    }

    /// The greatest natural-map error of any point \[m/s\]:
    ///   |λ − P_K(λ − σ̂/w)| · w   with w its [`mobility`](Self::mobility) and σ̂ = σ + (μ|σ_t|, 0, 0).
    /// It is 0 for solutions only.
    #[must_use]
    pub fn residual(&self, lambda: &[f64]) -> f64 {
        self.worst(lambda, true)
    }

    /// The same for the associated problem, without De Saxcé's correction.
    #[must_use]
    pub fn associated_residual(&self, lambda: &[f64]) -> f64 {
        self.worst(lambda, false)
    }

    fn worst(&self, lambda: &[f64], corrected: bool) -> f64 {
        let n = self.size();
        (0..self.count)
            .map(|k| {
                let row = |i: usize| self.b[i] + dense::dot(&self.w[i * n..][..n], lambda);
                let (s, l) = (V::new(row(3 * k), row(3 * k + 1), row(3 * k + 2)), three(lambda, k));
                natural_error(&s, &l, self.friction(k), self.mobility(k), corrected)
            })
            .fold(0.0, worse)
    }
}

/// The greater one; NaN is the worst of all.
#[must_use]
pub fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// The natural-map error of one point \[m/s\], for its velocity, impulse, friction and mobility.
#[must_use]
pub fn natural_error(sigma: &V, lambda: &V, mu: f64, mobility: f64, corrected: bool) -> f64 {
    let mut s = *sigma;
    if corrected {
        s.x += mu * tangent_length(sigma);
    }
    if mobility <= 0.0 {
        // Nothing moves: only the velocity along the normal can be wrong.
        return (-sigma.x).max(0.0);
    }
    let step = s / mobility;
    let off = lambda - project(&(lambda - step), mu);
    off.norm() * mobility
}

/// Components 3k … 3k + 2.
#[inline]
#[must_use]
pub fn three(x: &[f64], k: usize) -> V {
    V::new(x[3 * k], x[3 * k + 1], x[3 * k + 2])
}

/// Sets components 3k … 3k + 2.
#[inline]
pub fn put_three(x: &mut [f64], k: usize, v: &V) {
    x[3 * k..3 * k + 3].copy_from_slice(v.as_slice());
}

/// |(y, z)|.
#[inline]
#[must_use]
pub fn tangent_length(v: &V) -> f64 {
    (v.y * v.y + v.z * v.z).sqrt()
}

/// The nearest point of the cone |(y, z)| ≤ μ x.
#[must_use]
pub fn project(v: &V, mu: f64) -> V {
    let t = tangent_length(v);
    if t <= mu * v.x {
        return *v;
    }
    if mu * t <= -v.x {
        return V::zeros();
    }
    let x = (v.x + mu * t) / (1.0 + mu * mu);
    let k = if t > 0.0 { mu * x / t } else { 0.0 };
    V::new(x, k * v.y, k * v.z)
}
