//! Quickhull (Barber, Dobkin & Huhdanpaa 1996): grow a tetrahedron by the farthest point that still lies outside,
//! over and over. All in double, on points moved to the middle and scaled to size 1, so that neither the scale
//! nor the place of the cloud matters.

use crate::shape::ray::Wide;

/// A triangle of the growing hull.
struct Triangle {
    v: [u32; 3],
    /// The triangle across the edge from `v[i]` to the next vertex.
    across: [u32; 3],
    normal: Wide,
    offset: f64,
    /// The points outside this triangle and no other, and the farthest of them.
    outside: Vec<u32>,
    farthest: (f64, u32),
    alive: bool,
}

impl Triangle {
    /// `None` where the corners span no area.
    fn new(points: &[Wide], v: [u32; 3]) -> Option<Self> {
        let [a, b, c] = v.map(|i| points[i as usize]);
        let n = (b - a).cross(&(c - a));
        let l = n.dot(&n).sqrt();
        if l < 1e-18 {
            return None;
        }
        let normal = n / l;
        let offset = normal.dot(&(a + b + c)) / 3.0;
        Some(Self { v, across: [0; 3], normal, offset, outside: Vec::new(), farthest: (0.0, 0), alive: true })
    }

    fn height(&self, p: &Wide) -> f64 {
        self.normal.dot(p) - self.offset
    }

    fn take(&mut self, height: f64, point: u32) {
        self.outside.push(point);
        if height > self.farthest.0 {
            self.farthest = (height, point);
        }
    }

    /// Forgets the farthest point, which could not be added.
    fn skip_farthest(&mut self, points: &[Wide]) {
        let skipped = self.farthest.1;
        let rest = std::mem::take(&mut self.outside);
        self.farthest = (0.0, 0);
        for p in rest.into_iter().filter(|&p| p != skipped) {
            self.take(self.height(&points[p as usize]), p);
        }
    }
}

/// An edge of the horizon: the rim of what the new point sees.
struct Rim {
    from: u32,
    to: u32,
    beyond: u32,
}

/// The triangles of the hull of `points`, counter-clockwise from outside, grown from the tetrahedron `seed`. Points
/// within `flat` of the hull count as inside. At most `max_vertices` vertices: the farthest points come first, so
/// what is left out then is what matters least.
/// `None` where a face of the seed is too thin to have a plane.
pub(super) fn triangles(
    points: &[Wide],
    seed: [u32; 4],
    flat: f64,
    max_vertices: usize,
) -> Option<Vec<[u32; 3]>> {
    let mut hull = tetrahedron(points, seed)?;
    let mut uses = vec![0_u32; points.len()];
    for t in &hull {
        t.v.iter().for_each(|&v| uses[v as usize] += 1);
    }
    let mut vertices = 4;
    let all: Vec<u32> = (0..points.len() as u32).filter(|i| !seed.contains(i)).collect();
    distribute(points, &mut hull, 0, &all, flat);
    let (mut visible, mut rim) = (Vec::new(), Vec::new());
    while vertices < max_vertices {
        let best = (0..hull.len()).filter(|&i| hull[i].alive && hull[i].farthest.0 > flat);
        // The first of equals: `max_by` would take the last.
        let Some(start) = best.reduce(|a, b| if hull[b].farthest.0 > hull[a].farthest.0 { b } else { a })
        else {
            break;
        };
        let eye = hull[start].farthest.1;
        look(points, &hull, start as u32, eye, flat, &mut visible, &mut rim);
        let fan: Option<Vec<Triangle>> = in_order(&mut rim)
            .then(|| rim.iter().map(|r| Triangle::new(points, [r.from, r.to, eye])).collect())
            .flatten();
        let Some(fan) = fan else {
            hull[start].skip_farthest(points);
            continue;
        };
        let mut orphans = Vec::new();
        for &f in &visible {
            let t = &mut hull[f as usize];
            t.alive = false;
            orphans.append(&mut t.outside);
            for v in t.v {
                uses[v as usize] -= 1;
                vertices -= usize::from(uses[v as usize] == 0);
            }
        }
        orphans.retain(|&p| p != eye);
        let (first, n) = (hull.len() as u32, rim.len() as u32);
        for (i, (mut t, r)) in fan.into_iter().zip(&rim).enumerate() {
            let i = i as u32;
            t.across = [r.beyond, first + (i + 1) % n, first + (i + n - 1) % n];
            let outer = &mut hull[r.beyond as usize];
            let k = outer.v.iter().position(|&v| v == r.to).expect("a rim edge belongs to the face beyond");
            outer.across[k] = first + i;
            for v in t.v {
                vertices += usize::from(uses[v as usize] == 0);
                uses[v as usize] += 1;
            }
            hull.push(t);
        }
        distribute(points, &mut hull, first as usize, &orphans, flat);
    }
    Some(hull.iter().filter(|t| t.alive).map(|t| t.v).collect())
}

/// The four triangles of the first solid, turned outwards; `None` where one is too thin to have a plane.
fn tetrahedron(points: &[Wide], [a, b, c, d]: [u32; 4]) -> Option<Vec<Triangle>> {
    let p = |i: u32| points[i as usize];
    let up = (p(b) - p(a)).cross(&(p(c) - p(a))).dot(&(p(d) - p(a)));
    let (b, c) = if up > 0.0 { (c, b) } else { (b, c) };
    // Seen from d the triangle a b c turns clockwise: it looks away from d.
    let faces =
        [([a, b, c], [1, 2, 3]), ([b, a, d], [0, 3, 2]), ([c, b, d], [0, 1, 3]), ([a, c, d], [0, 2, 1])];
    faces
        .into_iter()
        .map(|(v, across)| {
            let mut t = Triangle::new(points, v)?;
            t.across = across;
            Some(t)
        })
        .collect()
}

/// Gives each of `which` to the triangle from `first` on that it lies farthest above, if any.
fn distribute(points: &[Wide], hull: &mut [Triangle], first: usize, which: &[u32], flat: f64) {
    for &i in which {
        let p = &points[i as usize];
        let mut best = (flat, usize::MAX);
        for (k, t) in hull.iter().enumerate().skip(first) {
            let h = t.height(p);
            if h > best.0 {
                best = (h, k);
            }
        }
        if best.1 != usize::MAX {
            hull[best.1].take(best.0, i);
        }
    }
}

/// Finds the triangles that the eye sees, from `start` on, and the rim of that region. Triangles that the eye
/// sees edge-on go too: a new triangle beside one of them could have no area.
fn look(
    points: &[Wide],
    hull: &[Triangle],
    start: u32,
    eye: u32,
    flat: f64,
    visible: &mut Vec<u32>,
    rim: &mut Vec<Rim>,
) {
    visible.clear();
    rim.clear();
    visible.push(start);
    let mut next = 0;
    while next < visible.len() {
        let t = &hull[visible[next] as usize];
        next += 1;
        for k in 0..3 {
            let beyond = t.across[k];
            if visible.contains(&beyond) {
                continue;
            }
            if hull[beyond as usize].height(&points[eye as usize]) > -flat {
                visible.push(beyond);
            } else {
                rim.push(Rim { from: t.v[k], to: t.v[(k + 1) % 3], beyond });
            }
        }
    }
}

/// Sorts the rim into one closed loop; `false` where it is none.
fn in_order(rim: &mut [Rim]) -> bool {
    for i in 1..rim.len() {
        let Some(k) = (i..rim.len()).find(|&k| rim[k].from == rim[i - 1].to) else {
            return false;
        };
        rim.swap(i, k);
    }
    let closed = rim.len() >= 3 && rim[rim.len() - 1].to == rim[0].from;
    let mut starts: Vec<u32> = rim.iter().map(|r| r.from).collect();
    starts.sort_unstable();
    starts.dedup();
    closed && starts.len() == rim.len()
}
