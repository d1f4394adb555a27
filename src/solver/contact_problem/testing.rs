//! Scenes and oracles for the tests of the dense solvers. The oracle is clarabel, an interior-point method by other
//! people: it solves quadratic programs over orthants and second-order cones.

use super::{ContactProblem, IMMOVABLE, Mass, PointArms, V};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus,
    SupportedConeT,
};

/// SplitMix64 (Steele, Lea & Flood 2014).
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
    pub fn within(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }
    pub fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
    pub fn vec(&mut self, r: f64) -> V {
        V::new(self.within(-r, r), self.within(-r, r), self.within(-r, r))
    }
}

/// A scene of bodies and points, with the bodies' free velocities.
#[derive(Default)]
pub struct Scene {
    pub masses: Vec<Mass>,
    pub free: Vec<[V; 2]>,
    pub points: Vec<PointArms>,
}

/// n, t₁, t₂ with this n.
pub fn axes(n: V) -> [V; 3] {
    let t = if n.x.abs() < 0.9 { V::x() } else { V::y() };
    let t = (t - n * n.dot(&t)).normalize();
    [n, t, n.cross(&t)]
}

impl Scene {
    /// A box of mass `m` and full sides `size`, with the velocity `v`.
    pub fn cuboid(&mut self, m: f64, size: V, v: V) -> usize {
        let s = size.component_mul(&size);
        let i = V::new(s.y + s.z, s.x + s.z, s.x + s.y) * (m / 12.0);
        let inv_inertia = [1.0 / i.x, 0.0, 0.0, 1.0 / i.y, 0.0, 1.0 / i.z];
        self.masses.push(Mass { inv_mass: 1.0 / m, inv_inertia });
        self.free.push([v, V::zeros()]);
        self.masses.len() - 1
    }

    /// The problem with this friction everywhere.
    pub fn problem(&self, mu: f64) -> ContactProblem {
        let mut problem = ContactProblem::default();
        problem.assemble(&self.points, &self.masses);
        problem.mu.fill(mu);
        for (k, p) in self.points.iter().enumerate() {
            let v = |side: usize| match p.bodies[side] {
                IMMOVABLE => V::zeros(),
                b => self.free[b][0] + self.free[b][1].cross(&p.arms[side]),
            };
            let relative = v(1) - v(0);
            for (r, axis) in p.axes.iter().enumerate() {
                problem.b[3 * k + r] = axis.dot(&relative);
            }
        }
        problem
    }
}

/// The four corners of the lower face of `upper` on the upper face of `lower`, sides 1 along x and z, both of height
/// `height`; `lower` may be immovable, its centre then counts as `height` below the face, too.
fn face(scene: &mut Scene, lower: usize, upper: usize, height: f64) {
    for (x, z) in [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)] {
        scene.points.push(PointArms {
            bodies: [lower, upper],
            axes: axes(V::y()),
            arms: [V::new(x, 0.5 * height, z), V::new(x, -0.5 * height, z)],
        });
    }
}

/// What gravity adds to a velocity in a step of the scenes \[m/s\].
pub const FALL: f64 = 10.0 / 60.0;

/// A box of 1 × ½ × 1 on a slope of this tangent, in the frame of the slope, after one step of free fall.
pub fn slope(tangent: f64) -> Scene {
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    let mut scene = Scene::default();
    let v = V::new(tangent * cosine, -cosine, 0.0) * FALL;
    let body = scene.cuboid(2.0, V::new(1.0, 0.5, 1.0), v);
    face(&mut scene, IMMOVABLE, body, 0.5);
    scene
}

/// Unit cubes of these masses on each other and on the ground, after one step of free fall.
pub fn stack(masses: &[f64]) -> Scene {
    let mut scene = Scene::default();
    let mut below = IMMOVABLE;
    for &m in masses {
        let body = scene.cuboid(m, V::new(1.0, 1.0, 1.0), V::new(0.0, -FALL, 0.0));
        face(&mut scene, below, body, 1.0);
        below = body;
    }
    scene
}

/// `points` random contacts between `bodies` random boxes and the immovable, random velocities.
pub fn random(random: &mut Random, bodies: usize, points: usize, decades: f64) -> Scene {
    let mut scene = Scene::default();
    for _ in 0..bodies {
        let size = V::new(random.within(0.3, 2.0), random.within(0.3, 2.0), random.within(0.3, 2.0));
        let mass = libm::pow(10.0, random.within(0.0, decades));
        let v = random.vec(1.0);
        let body = scene.cuboid(mass, size, v);
        scene.free[body][1] = random.vec(1.0);
    }
    for _ in 0..points {
        let b = random.below(bodies);
        let a = random.below(bodies + 1);
        let a = if a == b || a == bodies { IMMOVABLE } else { a };
        let n = random.vec(1.0);
        let n = if n.norm() > 0.1 { n.normalize() } else { V::y() };
        scene.points.push(PointArms {
            bodies: [a, b],
            axes: axes(n),
            arms: [random.vec(1.0), random.vec(1.0)],
        });
    }
    scene
}

/// What a friction rule asks of (λ_n, λ_t).
pub enum Rule<'a> {
    /// λ_t = 0.
    None,
    /// The circular cone.
    Cone,
    /// The regular polygon of so many corners, inscribed in the disc of radius μ λ_n.
    Pyramid(usize),
    /// The same polygon, with radii that are given for each point.
    Prism(usize, &'a [f64]),
}

/// Velocities and objective of min ½ λᵀWλ + cᵀλ under a rule, by clarabel, with c given instead of b.
pub fn oracle(problem: &ContactProblem, c: &[f64], rule: &Rule<'_>) -> (Vec<f64>, f64) {
    let (n, count) = (problem.size(), problem.count());
    // Scaled by points: interior-point methods like W with a diagonal near 1.
    let scale: Vec<f64> = (0..n).map(|i| 1.0 / problem.mobility(i / 3).max(1e-300).sqrt()).collect();
    let size = c.iter().enumerate().fold(0.0, |m: f64, (i, v)| m.max((v * scale[i]).abs())).max(1e-300);
    // Rows g x ≤ h (or in a cone) as triples.
    let (mut rows, mut h) = (Vec::<(usize, usize, f64)>::new(), Vec::<f64>::new());
    let mut cones = Vec::<SupportedConeT<f64>>::new();
    for k in 0..count {
        let (s, mu) = (scale[3 * k], problem.friction(k));
        match rule {
            Rule::Cone if mu > 0.0 => {
                let r = h.len();
                rows.extend([(r, 3 * k, -mu), (r + 1, 3 * k + 1, -1.0), (r + 2, 3 * k + 2, -1.0)]);
                h.extend([0.0; 3]);
                cones.push(SecondOrderConeT(3));
            }
            Rule::Pyramid(facets) | Rule::Prism(facets, _) if mu > 0.0 => {
                // A polygon by its faces: their normals lie between the corners, at cos(π/F) of the radius.
                let inner = libm::cos(core::f64::consts::PI / *facets as f64);
                rows.push((h.len(), 3 * k, -1.0));
                h.push(0.0);
                for j in 0..*facets {
                    let (sin, cos) = libm::sincos(core::f64::consts::TAU * (j as f64 + 0.5) / *facets as f64);
                    let r = h.len();
                    rows.extend([(r, 3 * k + 1, cos), (r, 3 * k + 2, sin)]);
                    if let Rule::Prism(_, radius) = rule {
                        h.push(radius[k] * inner / s / size);
                    } else {
                        rows.push((r, 3 * k, -mu * inner));
                        h.push(0.0);
                    }
                }
                cones.push(NonnegativeConeT(1 + facets));
            }
            _ => {
                let r = h.len();
                rows.push((r, 3 * k, -1.0));
                for t in 1..3 {
                    rows.extend([(r + 2 * t - 1, 3 * k + t, 1.0), (r + 2 * t, 3 * k + t, -1.0)]);
                }
                h.extend([0.0; 5]);
                cones.push(NonnegativeConeT(5));
            }
        }
    }
    let (mut pi, mut pj, mut pv) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..n {
        for j in i..n {
            pi.push(i);
            pj.push(j);
            pv.push(problem.w[i * n + j] * scale[i] * scale[j]);
        }
    }
    let p = CscMatrix::new_from_triplets(n, n, pi, pj, pv);
    let (gi, rest): (Vec<usize>, Vec<(usize, f64)>) = rows.iter().map(|r| (r.0, (r.1, r.2))).unzip();
    let (gj, gv) = rest.into_iter().unzip();
    let g = CscMatrix::new_from_triplets(h.len(), n, gi, gj, gv);
    let q: Vec<f64> = c.iter().enumerate().map(|(i, v)| v * scale[i] / size).collect();
    // As tight as the method gets on this problem.
    let x = [1e-12, 1e-11, 1e-10, 1e-9]
        .into_iter()
        .find_map(|tolerance| {
            let settings = DefaultSettingsBuilder::default()
                .verbose(false)
                .tol_gap_abs(tolerance)
                .tol_gap_rel(tolerance)
                .tol_feas(tolerance)
                .build()
                .unwrap();
            let mut solver = DefaultSolver::new(&p, &q, &g, &h, &cones, settings).unwrap();
            solver.solve();
            (solver.solution.status == SolverStatus::Solved).then(|| solver.solution.x.clone())
        })
        .expect("the oracle solves it");
    let lambda: Vec<f64> = x.iter().enumerate().map(|(i, v)| v * scale[i] * size).collect();
    let mut sigma = Vec::new();
    problem.velocity(&lambda, &mut sigma);
    let moved: Vec<f64> = sigma.iter().zip(&problem.b).map(|(s, b)| s - b).collect();
    let objective = lambda.iter().zip(&moved).zip(c).map(|((l, m), c)| l * (0.5 * m + c)).sum();
    (sigma, objective)
}

/// The greatest difference of two velocity vectors, as a share of the scale of the problem.
pub fn velocity_error(problem: &ContactProblem, lambda: &[f64], sigma: &[f64]) -> f64 {
    let mut own = Vec::new();
    problem.velocity(lambda, &mut own);
    own.iter().zip(sigma).map(|(a, b)| (a - b).abs()).fold(0.0, super::worse) / problem.scale()
}

/// How far an objective is from the oracle's, as a share of the energy that b stands for.
pub fn objective_error(problem: &ContactProblem, lambda: &[f64], objective: f64) -> f64 {
    let energy: f64 = problem.b.iter().enumerate().map(|(i, b)| b * b / problem.mobility(i / 3)).sum();
    (problem.objective(lambda) - objective).abs() / energy
}

/// Normal impulses of the interfaces of a stack from the bottom up.
pub fn interfaces(lambda: &[f64]) -> Vec<f64> {
    lambda.chunks(12).map(|four| four.chunks(3).map(|l| l[0]).sum()).collect()
}

/// Problems that are degenerate in every way we know, with names.
pub fn degenerate() -> Vec<(&'static str, ContactProblem)> {
    let mut all = vec![("no points", ContactProblem::new(0)), ("no mass", ContactProblem::new(2))];
    let mut falling = ContactProblem::new(1);
    falling.b[0] = -1.0;
    falling.mu[0] = 0.5;
    all.push(("no mass and falling", falling));
    let base = || stack(&[1.0, 2.0]).problem(0.5);
    let mut zero_row = base();
    for i in 0..24 {
        (zero_row.w[i * 24 + 3], zero_row.w[3 * 24 + i]) = (0.0, 0.0);
    }
    all.push(("a row of zeros", zero_row));
    let mut scene = stack(&[1.0, 1.0]);
    let twice: Vec<PointArms> = scene.points.iter().flat_map(|p| [*p, *p, *p]).collect();
    scene.points = twice;
    all.push(("every point three times", scene.problem(0.7)));
    for (name, value) in [("NaN", f64::NAN), ("infinite", f64::INFINITY)] {
        let mut broken = base();
        broken.w[5] = value;
        all.push((if name == "NaN" { "NaN in W" } else { "infinity in W" }, broken));
        let mut broken = base();
        broken.b[5] = value;
        all.push((if name == "NaN" { "NaN in b" } else { "infinity in b" }, broken));
    }
    let mut broken = base();
    broken.mu[1] = f64::NAN;
    all.push(("NaN friction", broken));
    for (name, mu) in [("no friction", 0.0), ("negative friction", -1.0), ("huge friction", 1e30)] {
        let mut problem = slope(0.5).problem(mu);
        problem.mu[2] = mu;
        all.push((name, problem));
    }
    let mut infinite = slope(0.5).problem(f64::INFINITY);
    infinite.mu[0] = 0.1;
    all.push(("infinite friction", infinite));
    // Two immovable jaws close in on a body: nothing helps.
    let mut scene = Scene::default();
    let body = scene.cuboid(1.0, V::new(1.0, 1.0, 1.0), V::zeros());
    for side in [-1.0, 1.0] {
        let n = V::new(-side, 0.0, 0.0);
        scene.points.push(PointArms {
            bodies: [IMMOVABLE, body],
            axes: axes(n),
            arms: [V::zeros(), V::new(0.5 * side, 0.0, 0.0)],
        });
    }
    let mut wedged = scene.problem(0.3);
    (wedged.b[0], wedged.b[3]) = (-1.0, -1.0);
    all.push(("wedged", wedged));
    // A tiny and a vast scale.
    let mut tiny = base();
    tiny.b.iter_mut().for_each(|v| *v *= 1e-200);
    all.push(("tiny velocities", tiny));
    let mut vast = base();
    vast.w.iter_mut().for_each(|v| *v *= 1e150);
    all.push(("vast mobility", vast));
    let mut indefinite = base();
    indefinite.w.iter_mut().for_each(|v| *v = -*v);
    all.push(("negative mass", indefinite));
    all
}
