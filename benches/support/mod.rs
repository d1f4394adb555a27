//! Seeded pairs of solids that break collision methods, and oracles in double: shared by the benches and the tests.
#![allow(dead_code)]

use merev::math::scalar::double;
use merev::math::{quat, quat_about, rotate, vec3};
use merev::shape::Shape;
use merev::{Float, Pose, Quat, Vec3};

pub type Wide = [f64; 3];

/// SplitMix64 (Steele, Lea & Flood 2014).
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    pub fn within(&mut self, lo: Float, hi: Float) -> Float {
        lo + (hi - lo) * ((self.bits() >> 40) as Float / (1_u64 << 24) as Float)
    }

    pub fn one_of(&mut self, list: &[Float]) -> Float {
        list[self.below(list.len())]
    }

    pub fn vec(&mut self, r: Float) -> Vec3 {
        vec3(self.within(-r, r), self.within(-r, r), self.within(-r, r))
    }

    pub fn unit(&mut self) -> Vec3 {
        loop {
            let v = self.vec(1.0);
            let l2 = v.dot(&v);
            if (0.01..=1.0).contains(&l2) {
                return v / l2.sqrt();
            }
        }
    }

    pub fn rotation(&mut self) -> Quat {
        quat(self.within(-1.0, 1.0), self.vec(1.0))
    }
}

/// A solid as points with a radius, and as a shape where it has a volume.
#[derive(Clone, Debug)]
pub struct Solid {
    pub points: Vec<Vec3>,
    pub radius: Float,
    pub shape: Option<Shape>,
}

pub fn cuboid(half: Vec3) -> Solid {
    let sign = |i: usize, k: usize| if i >> k & 1 == 1 { half[k] } else { -half[k] };
    let points = (0..8).map(|i| vec3(sign(i, 0), sign(i, 1), sign(i, 2))).collect();
    Solid { points, radius: 0.0, shape: Shape::try_new_box(2.0 * half.x, 2.0 * half.y, 2.0 * half.z).ok() }
}

/// The hull of a cloud; without a shape where that is refused as flat.
pub fn cloud(points: Vec<Vec3>) -> Solid {
    let shape = Shape::hull(&points).ok();
    let points = match &shape {
        Some(Shape::Hull(h)) => h.vertices().to_vec(),
        _ => points,
    };
    Solid { points, radius: 0.0, shape }
}

pub fn sphere(radius: Float) -> Solid {
    Solid { points: vec![Vec3::zeros()], radius, shape: Shape::try_new_sphere(2.0 * radius).ok() }
}

pub fn capsule(length: Float, radius: Float) -> Solid {
    let end = vec3(0.0, 0.5 * length, 0.0);
    Solid { points: vec![-end, end], radius, shape: Shape::try_new_capsule(length, 2.0 * radius).ok() }
}

/// About `n` vertices on an ellipsoid of these half axes.
pub fn round_hull(random: &mut Random, n: usize, half: Vec3) -> Solid {
    cloud((0..n).map(|_| random.unit().component_mul(&half)).collect())
}

/// `n` vertices on a ball of diameter 1, evenly spread.
pub fn ball(n: usize) -> Shape {
    let points: Vec<Vec3> = (0..n)
        .map(|i| {
            let y = 1.0 - 2.0 * (i as Float + 0.5) / n as Float;
            let (s, c) = merev::math::scalar::sin_cos(2.399_963_2 * i as Float);
            let r = (1.0 - y * y).sqrt();
            vec3(r * c, y, r * s) * 0.5
        })
        .collect();
    Shape::hull(&points).expect("points on a ball have a hull")
}

/// Kinds of input that break methods.
pub const CLASSES: [&str; 12] = [
    "ordinary",
    "thin_gap",
    "flat_tetrahedra",
    "duplicated_collinear",
    "aspect_1e6",
    "sliver_triangles",
    "identical_poses",
    "size_ratio",
    "parallel_faces",
    "parallel_edges",
    "concentric",
    "crossing_capsules",
];

/// The gaps around which methods change their minds.
const GAPS: [Float; 7] = [0.0, 1e-7, -1e-7, 1e-4, -1e-4, -0.1, 0.3];

fn any(random: &mut Random) -> Solid {
    let half = vec3(random.within(0.3, 1.0), random.within(0.3, 1.0), random.within(0.3, 1.0));
    match random.below(6) {
        0 => sphere(half.x),
        1 => capsule(2.0 * half.x, 0.5 * half.y),
        2 | 3 => cuboid(half),
        4 => round_hull(random, 4 + half.x as usize, half),
        _ => {
            let n = 5 + random.below(55);
            round_hull(random, n, half)
        }
    }
}

/// The pose that leaves a gap of `want` along `n`, by the support functions.
fn apart(a: &Solid, b: &Solid, q: Quat, n: Vec3, want: Float) -> Pose {
    let top = a.points.iter().map(|p| n.dot(p)).fold(Float::MIN, Float::max) + a.radius;
    let low = b.points.iter().map(|p| n.dot(&rotate(&q, *p))).fold(Float::MAX, Float::min) - b.radius;
    Pose::new(n * (want + top - low), q)
}

/// A pair of one of the [`CLASSES`].
pub fn pair(random: &mut Random, class: usize) -> (Solid, Solid, Pose) {
    let (mut a, mut b) = (any(random), any(random));
    let mut q = random.rotation();
    let mut n = random.unit();
    let mut want = random.within(-0.3, 0.3);
    match class {
        0 => {}
        1 => want = random.one_of(&GAPS),
        2 => {
            let h = random.one_of(&[0.0, 1e-8, 1e-6, 1e-4]);
            let flat = |random: &mut Random| {
                let turn = random.rotation();
                let points = (0..4).map(|_| {
                    let mut p = random.vec(1.0);
                    p.z *= h;
                    rotate(&turn, p)
                });
                cloud(points.collect())
            };
            (a, b) = (flat(random), if random.below(2) == 0 { flat(random) } else { b });
            want = random.one_of(&GAPS);
        }
        3 => {
            let (p, d) = (random.vec(1.0), random.vec(1.0));
            let mut points: Vec<Vec3> = (0..6).map(|i| p + d * (i / 2) as Float).collect();
            if random.below(2) == 0 {
                points.extend([p + random.unit(), p + random.unit(), p + random.unit()]);
            }
            a = Solid { points, radius: 0.0, shape: None };
            want = random.one_of(&GAPS);
        }
        4 => {
            let thin = |random: &mut Random| match random.below(3) {
                0 => cuboid(vec3(10.0, 1e-5, 10.0)),
                1 => cuboid(vec3(10.0, 1e-5, 1e-5)),
                _ => round_hull(random, 20, vec3(10.0, 1e-5, 10.0)),
            };
            a = thin(random);
            if random.below(2) == 0 {
                b = thin(random);
            }
            want = random.one_of(&GAPS);
        }
        5 => {
            let sliver = vec![
                vec3(0.331_916_57, 0.382_771_94, -0.465_963_87),
                vec3(0.378_853_9, -0.246_981_6, -0.440_359_06),
                vec3(0.331_879_1, 0.382_861_1, -0.465_974),
            ];
            a = Solid { points: sliver, radius: 0.0, shape: None };
            want = random.one_of(&GAPS);
        }
        6 => {
            b = a.clone();
            return (a, b, Pose::new(Vec3::zeros(), Quat::identity()));
        }
        7 => {
            let k = random.one_of(&[1e-3, 1e-2, 1e2, 1e4]);
            let half = vec3(k, k * random.within(0.3, 1.0), k);
            a = if random.below(2) == 0 { cuboid(half) } else { round_hull(random, 30, half) };
            want = random.one_of(&GAPS) * k.min(1.0);
        }
        8 => {
            a = cuboid(vec3(random.within(0.3, 2.0), random.within(0.3, 2.0), random.within(0.3, 2.0)));
            b = cuboid(vec3(random.within(0.3, 2.0), random.within(0.3, 2.0), random.within(0.3, 2.0)));
            q = quat_about(Vec3::y(), random.one_of(&[0.0, 0.0, 0.7, 1e-7, 1e-4]));
            n = Vec3::y();
            want = random.one_of(&GAPS);
            let mut pose = apart(&a, &b, q, n, want);
            pose.p += vec3(random.within(-0.5, 0.5), 0.0, random.within(-0.5, 0.5));
            return (a, b, pose);
        }
        9 => {
            a = cuboid(vec3(0.5, 0.5, 2.0));
            b = cuboid(vec3(0.5, 0.5, 1.0));
            let turn = quat_about(Vec3::z(), core::f64::consts::FRAC_PI_4 as Float);
            q = turn * quat_about(Vec3::z(), random.one_of(&[0.0, 1e-7, 1e-4]));
            n = vec3(0.707_106_77, 0.707_106_77, 0.0);
            want = random.one_of(&GAPS);
        }
        10 => {
            let p = random.one_of(&[0.0, 0.0, 1e-30, 1e-9]);
            return (a, b, Pose::new(vec3(p, 0.0, p), q));
        }
        _ => {
            a = capsule(2.0, 0.2);
            b = capsule(1.0, random.within(0.05, 0.5));
            let p = rotate(&q, vec3(0.0, random.within(-0.5, 0.5), 0.0)) * random.one_of(&[0.0, 1.0]);
            let axis = [Vec3::x(), Vec3::y(), random.unit()][random.below(3)];
            return (a, b, Pose::new(p, quat_about(axis, random.within(0.0, 3.0))));
        }
    }
    let pose = apart(&a, &b, q, n, want);
    (a, b, pose)
}

fn sub(a: Wide, b: Wide) -> Wide {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Wide, b: Wide) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Wide, b: Wide) -> Wide {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn scaled(a: Wide, k: f64) -> Wide {
    [a[0] * k, a[1] * k, a[2] * k]
}

fn wide(v: Vec3) -> Wide {
    [double(v.x), double(v.y), double(v.z)]
}

/// Both clouds in the frame of A, in double.
pub struct Clouds {
    pub a: Vec<Wide>,
    pub b: Vec<Wide>,
    pub radii: f64,
    /// The largest coordinate.
    pub scale: f64,
}

impl Clouds {
    pub fn new(a: &Solid, b: &Solid, pose: &Pose) -> Self {
        let [x, y, z, w] = [double(pose.q.i), double(pose.q.j), double(pose.q.k), double(pose.q.w)];
        let s = 2.0 / (x * x + y * y + z * z + w * w);
        let place = |p: &Vec3| {
            let (u, v) = ([x, y, z], wide(*p));
            let t = cross(u, v);
            let r: Wide = std::array::from_fn(|k| v[k] + s * (w * t[k] + cross(u, t)[k]));
            let o = wide(pose.p);
            [r[0] + o[0], r[1] + o[1], r[2] + o[2]]
        };
        let (ca, cb): (Vec<_>, Vec<_>) =
            (a.points.iter().map(|p| wide(*p)).collect(), b.points.iter().map(place).collect());
        let radii = double(a.radius + b.radius);
        let scale = ca.iter().chain(&cb).flatten().fold(radii, |s, x| s.max(x.abs()));
        Self { a: ca, b: cb, radii, scale }
    }

    /// The vertex of the difference A − B farthest along `d`.
    fn support(&self, d: Wide) -> Wide {
        let best = |points: &[Wide], sign: f64| {
            let mut best = (f64::MIN, points[0]);
            for p in points {
                let h = sign * dot(*p, d);
                if h > best.0 {
                    best = (h, *p);
                }
            }
            best.1
        };
        sub(best(&self.a, 1.0), best(&self.b, -1.0))
    }

    /// Bounds of the distance of the cores: the least norm in the difference by Wolfe's method (1976), its corral
    /// solved by trying all subsets; the lower one is that of the plane through the best support point.
    pub fn distance(&self) -> (f64, f64) {
        let mut corral = vec![self.support([0.0, 1.0, 0.0])];
        let (mut upper, mut lower) = (f64::MAX, 0.0_f64);
        for _ in 0..400 {
            let (v, kept) = least_norm(&corral);
            let length = dot(v, v).sqrt();
            if length < upper {
                upper = length;
            } else if corral.len() > 1 {
                break;
            }
            if kept.len() == 4 || length <= 1e-14 * self.scale {
                return (0.0, 0.0);
            }
            let w = self.support(scaled(v, -1.0));
            lower = lower.max(dot(v, w) / length);
            if upper - lower <= 1e-14 * self.scale || kept.contains(&w) {
                break;
            }
            corral = kept;
            corral.push(w);
        }
        (lower, upper)
    }

    /// The least depth of the cores, by the gaps along all cross products of directions between vertices, which
    /// hold all normals of faces and all crossings of edges: exact, but of the fourth order. `None` where the
    /// difference has no volume or the clouds are too large.
    pub fn depth(&self) -> Option<f64> {
        if self.a.len().max(self.b.len()) > 10 {
            return None;
        }
        let directions = |points: &[Wide]| {
            let mut all = Vec::new();
            for (i, p) in points.iter().enumerate() {
                all.extend(points[..i].iter().map(|q| sub(*p, *q)).filter(|d| dot(*d, *d) > 0.0));
            }
            all
        };
        let mut all = directions(&self.a);
        all.extend(directions(&self.b));
        let mut least = f64::MAX;
        for (i, u) in all.iter().enumerate() {
            for v in &all[..i] {
                let n = cross(*u, *v);
                let l2 = dot(n, n);
                if l2 <= 1e-20 * dot(*u, *u) * dot(*v, *v) {
                    continue;
                }
                let n = scaled(n, 1.0 / l2.sqrt());
                for n in [n, scaled(n, -1.0)] {
                    least = least.min(dot(self.support(n), n));
                }
            }
        }
        (least < f64::MAX).then_some(least)
    }
}

/// The point of least norm of a hull of up to four points and the points that carry it: the best of all subsets.
fn least_norm(points: &[Wide]) -> (Wide, Vec<Wide>) {
    let n = points.len();
    let mut best: (f64, Wide, Vec<Wide>) = (f64::MAX, [0.0; 3], Vec::new());
    for set in 1..1_usize << n {
        let members: Vec<Wide> = (0..n).filter(|i| set >> i & 1 == 1).map(|i| points[i]).collect();
        let Some(t) = affine(&members) else { continue };
        if t.iter().any(|t| *t < 0.0) {
            continue;
        }
        let mut p = [0.0; 3];
        for (m, t) in members.iter().zip(&t) {
            p = [p[0] + m[0] * t, p[1] + m[1] * t, p[2] + m[2] * t];
        }
        let norm = dot(p, p);
        if norm < best.0 {
            best = (norm, p, members);
        }
    }
    (best.1, best.2)
}

/// The weights of the point of least norm in the span of these points, by Gram–Schmidt with two passes; `None` where
/// they span less than they should.
fn affine(points: &[Wide]) -> Option<Vec<f64>> {
    let n = points.len() - 1;
    let edges: Vec<Wide> = points[1..].iter().map(|p| sub(*p, points[0])).collect();
    let mut basis: Vec<Wide> = Vec::new();
    for e in &edges {
        let mut rest = *e;
        for _ in 0..2 {
            for q in &basis {
                rest = sub(rest, scaled(*q, dot(*q, rest)));
            }
        }
        let length = dot(rest, rest).sqrt();
        if length <= 1e-12 * dot(*e, *e).sqrt() || length == 0.0 {
            return None;
        }
        basis.push(scaled(rest, 1.0 / length));
    }
    let mut t = vec![0.0; n + 1];
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|i| dot(basis[k], edges[i]) * t[i + 1]).sum();
        t[k + 1] = (-dot(basis[k], points[0]) - sum) / dot(basis[k], edges[k]);
    }
    t[0] = 1.0 - t[1..].iter().sum::<f64>();
    Some(t)
}

/// The p-quantile of sorted numbers; 0 where there are none.
pub fn quantile(sorted: &[f64], p: f64) -> f64 {
    if sorted.is_empty() { 0.0 } else { sorted[((sorted.len() - 1) as f64 * p).round() as usize] }
}

/// Writes docs/measured/`name`; rows of an older run stay where their first `keys` cells are not among the new ones'.
pub fn write_csv(name: &str, head: &str, rows: &[String], keys: usize) {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/measured").join(name);
    let key = |row: &str| row.split(',').take(keys).map(str::to_owned).collect::<Vec<_>>();
    let old = std::fs::read_to_string(&path).unwrap_or_default();
    let new: std::collections::BTreeSet<_> = rows.iter().map(|r| key(r)).collect();
    let mut lines = vec![head.to_owned()];
    if old.lines().next() == Some(head) {
        lines.extend(old.lines().skip(1).filter(|r| !new.contains(&key(r))).map(str::to_owned));
    }
    lines.extend(rows.iter().cloned());
    std::fs::create_dir_all(path.parent().expect("a folder")).expect("docs/measured can be made");
    std::fs::write(&path, lines.join("\n") + "\n").expect("docs/measured can be written");
}
