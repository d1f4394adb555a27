//! Convex hulls and mass in double precision, for engines that do not take them from points and density as the scene
//! means them. Nothing here is shared with an engine.

use crate::scene::{Body, Form, Scene};
use crate::vector::{Q4, STILL, V3, add, cross, dot, norm, rotate, scale, sub, unit};

/// The faces of a hull.
#[derive(Clone, Debug, Default)]
pub struct Hull {
    pub points: Vec<V3>,
    /// Outward normal and offset.
    pub planes: Vec<[f64; 4]>,
    /// Corners by index, counter-clockwise from outside; in the order of the planes.
    pub faces: Vec<Vec<u32>>,
}

impl Hull {
    /// By trying all triples of points: clouds of the lab have few. Points inside belong to no face. None if the cloud
    /// is flat.
    pub fn of(points: &[V3]) -> Option<Self> {
        let size = points.iter().map(|p| norm(*p)).fold(0.0, f64::max);
        let close = 1e-9 * size;
        let mut hull = Self { points: points.to_vec(), ..Self::default() };
        let mut seen = std::collections::HashSet::new();
        for i in 0..points.len() {
            for j in i + 1..points.len() {
                for k in j + 1..points.len() {
                    let n = cross(sub(points[j], points[i]), sub(points[k], points[i]));
                    if norm(n) <= close * size {
                        continue;
                    }
                    let n = scale(n, 1.0 / norm(n));
                    let Some(n) = outward(points, n, points[i], close) else { continue };
                    let d = dot(n, points[i]);
                    let on: Vec<u32> = (0..points.len() as u32)
                        .filter(|&p| (dot(n, points[p as usize]) - d).abs() <= close)
                        .collect();
                    if seen.insert(on.clone()) {
                        hull.planes.push([n[0], n[1], n[2], d]);
                        hull.faces.push(polygon(points, &on, n));
                    }
                }
            }
        }
        (hull.faces.len() >= 4).then_some(hull)
    }

    /// Volume, centre, and the integral of x xᵀ about the origin.
    fn moments(&self) -> Moments {
        let mut sum = Moments::default();
        for face in &self.faces {
            for pair in face[1..].windows(2) {
                let [a, b, c] = [face[0], pair[0], pair[1]].map(|i| self.points[i as usize]);
                let (det, s) = (dot(a, cross(b, c)), add(add(a, b), c));
                sum.volume += det / 6.0;
                for i in 0..3 {
                    sum.first[i] += det / 24.0 * s[i];
                    for k in 0..3 {
                        sum.second[i][k] +=
                            det / 120.0 * (a[i] * a[k] + b[i] * b[k] + c[i] * c[k] + s[i] * s[k]);
                    }
                }
            }
        }
        sum
    }
}

/// The normal of a plane through a point, away from all points; None if they lie on both sides.
fn outward(points: &[V3], n: V3, on: V3, close: f64) -> Option<V3> {
    let d = dot(n, on);
    let (mut above, mut below) = (false, false);
    for p in points {
        let h = dot(n, *p) - d;
        above |= h > close;
        below |= h < -close;
        if above && below {
            return None;
        }
    }
    (above != below).then(|| if above { scale(n, -1.0) } else { n })
}

/// The outline of points in a plane with this normal, counter-clockwise seen against it (Andrew's chain).
fn polygon(points: &[V3], on: &[u32], n: V3) -> Vec<u32> {
    let u = unit_of(if n[0].abs() < 0.6 { cross(n, [1.0, 0.0, 0.0]) } else { cross(n, [0.0, 1.0, 0.0]) });
    let v = cross(n, u);
    let flat = |i: u32| [dot(points[i as usize], u), dot(points[i as usize], v)];
    let mut order = on.to_vec();
    order.sort_by(|&a, &b| flat(a).partial_cmp(&flat(b)).expect("finite points"));
    let half = |order: &mut dyn Iterator<Item = u32>| {
        let mut chain: Vec<u32> = Vec::new();
        for p in order {
            while let [.., a, b] = chain[..] {
                let (a, b, c) = (flat(a), flat(b), flat(p));
                let turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
                if turn > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut outline = half(&mut order.iter().copied());
    outline.extend(half(&mut order.iter().rev().copied()));
    outline
}

fn unit_of(v: V3) -> V3 {
    scale(v, 1.0 / norm(v))
}

/// Of a solid of density 1.
#[derive(Clone, Copy, Debug, Default)]
struct Moments {
    volume: f64,
    first: V3,
    /// The integral of x xᵀ.
    second: [V3; 3],
}

impl Moments {
    /// Of something symmetric about the origin's planes, by its volume and the mean of x², y², z².
    fn plain(volume: f64, mean: V3) -> Self {
        let mut second = [[0.0; 3]; 3];
        (0..3).for_each(|k| second[k][k] = volume * mean[k]);
        Self { volume, first: [0.0; 3], second }
    }

    /// Adds another that is moved and turned.
    fn add(&mut self, other: &Self, at: V3, turn: Q4) {
        let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| rotate(turn, e));
        let first = rotate(turn, other.first);
        for i in 0..3 {
            for k in 0..3 {
                let mut turned = 0.0;
                for a in 0..3 {
                    for b in 0..3 {
                        turned += columns[a][i] * other.second[a][b] * columns[b][k];
                    }
                }
                self.second[i][k] +=
                    turned + first[i] * at[k] + at[i] * first[k] + other.volume * at[i] * at[k];
            }
        }
        self.first = add(self.first, add(first, scale(at, other.volume)));
        self.volume += other.volume;
    }
}

/// Mass, and where its centre and principal axes lie in the frame of the body.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    pub mass: f64,
    pub centre: V3,
    pub axes: Q4,
    pub inertia: V3,
}

impl Solid {
    /// Of a body of a scene: as it is written down, or by shape and density.
    pub fn of(scene: &Scene, hulls: &[Hull], body: &Body) -> Self {
        if let Some(m) = body.mass {
            return Self { mass: m.mass, centre: m.center, axes: STILL, inertia: m.inertia };
        }
        let moments = match body.form {
            Form::Box([x, y, z]) => cuboid([x, y, z]),
            Form::Sphere(r) => Moments::plain(4.0 / 3.0 * std::f64::consts::PI * r * r * r, [r * r / 5.0; 3]),
            Form::Capsule(half, r) => capsule(half, r),
            Form::Hull(k) => hulls[k].moments(),
            Form::Boxes(k) => {
                let mut sum = Moments::default();
                scene.compounds[k].iter().for_each(|p| sum.add(&cuboid(p.half), p.position, p.rotation));
                sum
            }
        };
        Self::from(&moments, body.density)
    }

    fn from(m: &Moments, density: f64) -> Self {
        let centre = scale(m.first, 1.0 / m.volume);
        let mut second = m.second;
        for i in 0..3 {
            for k in 0..3 {
                second[i][k] -= m.volume * centre[i] * centre[k];
            }
        }
        let (axes, [x, y, z]) = principal(second);
        let inertia = [y + z, x + z, x + y].map(|s| density * s);
        Self { mass: density * m.volume, centre, axes, inertia }
    }
}

fn cuboid(half: V3) -> Moments {
    Moments::plain(8.0 * half[0] * half[1] * half[2], half.map(|h| h * h / 3.0))
}

/// A cylinder along y and two half balls.
fn capsule(half: f64, r: f64) -> Moments {
    let pi = std::f64::consts::PI;
    let (cylinder, ball) = (2.0 * pi * r * r * half, 4.0 / 3.0 * pi * r * r * r);
    let across = cylinder * r * r / 4.0 + ball * r * r / 5.0;
    // A half ball's centre is 3/8 r beyond its base.
    let along = cylinder * half * half / 3.0 + ball * (r * r / 5.0 + half * half + 0.75 * half * r);
    let volume = cylinder + ball;
    Moments::plain(volume, [across, along, across].map(|s| s / volume))
}

/// Axes and values of a symmetric matrix, by Jacobi's rotations; no turn where it is diagonal already.
fn principal(mut m: [V3; 3]) -> (Q4, V3) {
    let size = m[0][0] + m[1][1] + m[2][2];
    let mut axes = STILL;
    for _ in 0..50 {
        let off = |p: usize, q: usize| m[p][q].abs();
        let (p, q) = [(0, 1), (0, 2), (1, 2)]
            .into_iter()
            .max_by(|&a, &b| off(a.0, a.1).total_cmp(&off(b.0, b.1)))
            .expect("three");
        if off(p, q) <= 1e-14 * size {
            break;
        }
        let angle = 0.5 * libm::atan2(2.0 * m[p][q], m[p][p] - m[q][q]);
        // The third axis, about which p turns to q.
        let mut third = [0.0; 3];
        third[3 - p - q] = if q == p + 1 { 1.0 } else { -1.0 };
        let turn = crate::vector::turn(third, angle);
        axes = unit(crate::vector::times(axes, turn));
        let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| rotate(turn, e));
        let times = |v: V3| [dot(m[0], v), dot(m[1], v), dot(m[2], v)];
        let images = columns.map(times);
        for i in 0..3 {
            for k in 0..3 {
                m[i][k] = dot(columns[i], images[k]);
            }
        }
    }
    (axes, [m[0][0], m[1][1], m[2][2]])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: V3, b: V3) {
        assert!(norm(sub(a, b)) < 1e-12 * (1.0 + norm(b)), "{a:?} {b:?}");
    }

    fn corners(half: V3) -> Vec<V3> {
        (0..8).map(|i| [0, 1, 2].map(|k| if i >> k & 1 == 0 { -half[k] } else { half[k] })).collect()
    }

    #[test]
    fn a_cloud_of_corners_is_a_box() {
        let half = [0.5, 1.0, 2.0];
        let mut points = corners(half);
        points.push([0.1, 0.2, 0.3]);
        let hull = Hull::of(&points).unwrap();
        assert_eq!(hull.planes.len(), 6);
        for (face, plane) in hull.faces.iter().zip(&hull.planes) {
            let n = [plane[0], plane[1], plane[2]];
            let [a, b, c] = [face[0], face[1], face[2]].map(|i| points[i as usize]);
            assert_eq!(face.len(), 4);
            assert!(dot(cross(sub(b, a), sub(c, b)), n) > 0.0 && plane[3] > 0.0);
        }
        let (a, b) = (Solid::from(&hull.moments(), 3.0), Solid::from(&cuboid(half), 3.0));
        near(a.inertia, b.inertia);
        near(a.centre, [0.0; 3]);
        assert!((a.mass - 24.0).abs() < 1e-12);
        assert!(Hull::of(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]).is_none());
    }

    /// A box that is moved and turned has its old moments about its new axes.
    #[test]
    fn a_moved_box_is_still_a_box() {
        let (half, at) = ([0.5, 1.0, 2.0], [3.0, -2.0, 1.0]);
        let q = unit([0.2, -0.5, 0.3, 0.79]);
        let mut sum = Moments::default();
        sum.add(&cuboid(half), at, q);
        let points: Vec<V3> = corners(half).into_iter().map(|p| add(at, rotate(q, p))).collect();
        let hull = Hull::of(&points).unwrap();
        for moments in [sum, hull.moments()] {
            let solid = Solid::from(&moments, 2.0);
            near(solid.centre, at);
            let mut found = solid.inertia;
            found.sort_by(f64::total_cmp);
            let mut exact = Solid::from(&cuboid(half), 2.0).inertia;
            exact.sort_by(f64::total_cmp);
            near(found, exact);
            // The axis of the least inertia is the long side's.
            let least = (0..3).find(|&k| solid.inertia[k] == found[0]).unwrap();
            let mut e = [0.0; 3];
            e[least] = 1.0;
            let (mine, theirs) = (rotate(solid.axes, e), rotate(q, [0.0, 0.0, 1.0]));
            assert!((dot(mine, theirs).abs() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_capsule_without_length_is_a_ball() {
        let solid = Solid::from(&capsule(0.0, 0.5), 1.0);
        near(solid.inertia, [0.4 * solid.mass * 0.25; 3]);
        // Long and thin, it is a rod.
        let rod = Solid::from(&capsule(50.0, 0.01), 1.0);
        assert!((rod.inertia[0] / (rod.mass * 1e4 / 12.0) - 1.0).abs() < 1e-3);
    }
}
