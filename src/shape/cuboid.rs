use super::{CorePoints, Edge, MassData, Polytope, RayHit, check_size, ray};
use crate::error::Result;
use crate::math::scalar::double;
use crate::math::{Aabb, Float, Mat3, Pose, Vec3, abs, length, max, min, rotation_matrix, vec3};

/// A box, centred on the shape's frame with its axes along the frame's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    half: Vec3,
}

impl Cuboid {
    /// A box of these half extents \[m\].
    ///
    /// # Errors
    /// A half extent is not a valid size.
    pub fn new(half: Vec3) -> Result<Self> {
        let x = check_size("Half the box's width", half.x)?;
        let y = check_size("Half the box's height", half.y)?;
        let z = check_size("Half the box's depth", half.z)?;
        Ok(Self { half: vec3(x, y, z) })
    }

    /// The half extents \[m\].
    #[must_use]
    #[inline(always)]
    pub fn half(&self) -> Vec3 {
        self.half
    }

    pub(super) fn volume(&self) -> Float {
        8.0 * self.half.x * self.half.y * self.half.z
    }

    pub(super) fn mass_data(&self, density: Float) -> MassData {
        let mass = density * self.volume();
        let (x, y, z) = (self.half.x * self.half.x, self.half.y * self.half.y, self.half.z * self.half.z);
        let inertia = Mat3::from_diagonal(&(vec3(y + z, x + z, x + y) * (mass / 3.0)));
        MassData { mass, center: Vec3::zeros(), inertia }
    }

    #[inline]
    pub(super) fn aabb(&self, pose: &Pose) -> Aabb {
        let r = rotation_matrix(&pose.q);
        let (x, y, z) = (abs(r.column(0).into()), abs(r.column(1).into()), abs(r.column(2).into()));
        Aabb::around(pose.p, x * self.half.x + y * self.half.y + z * self.half.z)
    }

    pub(super) fn outer_radius(&self, from: Vec3) -> Float {
        length(abs(from) + self.half)
    }

    pub(super) fn closest_point(&self, p: Vec3) -> Vec3 {
        max(min(p, self.half), -self.half)
    }

    pub(super) fn contains(&self, p: Vec3) -> bool {
        p.x.abs() <= self.half.x && p.y.abs() <= self.half.y && p.z.abs() <= self.half.z
    }

    pub(super) fn ray_cast(&self, origin: Vec3, translation: Vec3, max_fraction: Float) -> Option<RayHit> {
        if self.contains(origin) {
            return Some(RayHit::inside(origin));
        }
        let mut t = (0.0, double(max_fraction));
        let mut normal = Vec3::zeros();
        for k in 0..3 {
            for side in [-1.0, 1.0] {
                let distance = double(side * origin[k]) - double(self.half[k]);
                if ray::clip(&mut t, distance, double(side * translation[k])) {
                    normal = Vec3::zeros();
                    normal[k] = side;
                }
            }
        }
        // An interval that ends before 0 lies behind the ray.
        if t.0.max(0.0) > t.1 {
            return None;
        }
        RayHit::at(origin, translation, t.0, max_fraction, |_| normal)
    }
}

// Vertex i has the sign bits of i: bit k set means +half[k]. Face 2k is the one at −half[k], 2k + 1 at +half[k].
// Edge 4k + j runs along axis k, from − to +; the bits of j are the signs of the other two axes, lower axis first.

/// The vertices of each face, counter-clockwise from outside.
pub(crate) const LOOPS: [[u8; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// The side of face `f` along edge `i` of its loop: the axis it looks along, and whether towards +.
pub(crate) const SIDES: [[(u8, bool); 4]; 6] = {
    let mut sides = [[(0, false); 4]; 6];
    let mut f = 0;
    while f < 6 {
        let mut i = 0;
        while i < 4 {
            let (v, w) = (LOOPS[f][i], LOOPS[f][(i + 1) % 4]);
            // The three axes are the face's, the edge's and the side's.
            let along = (v ^ w).trailing_zeros() as usize;
            let axis = 3 - f / 2 - along;
            sides[f][i] = (axis as u8, v >> axis & 1 == 1);
            i += 1;
        }
        f += 1;
    }
    sides
};

/// The edge between the two vertices.
const fn edge_between(v: u8, w: u8) -> u16 {
    let (low, axis) = (if v < w { v } else { w } as u16, (v ^ w) as u16);
    match axis {
        1 => low >> 1,
        2 => 4 + (low & 1) + ((low >> 2) << 1),
        _ => 8 + (low & 3),
    }
}

/// The edge that leaves each vertex of each face's loop.
pub(crate) const LOOP_EDGES: [[u16; 4]; 6] = {
    let mut edges = [[0; 4]; 6];
    let mut f = 0;
    while f < 6 {
        let mut i = 0;
        while i < 4 {
            edges[f][i] = edge_between(LOOPS[f][i], LOOPS[f][(i + 1) % 4]);
            i += 1;
        }
        f += 1;
    }
    edges
};

/// The ends of each edge and the faces to its left and right.
const EDGES: [Edge; 12] = {
    let mut edges = [Edge { v: [0, 0], f: [0, 0] }; 12];
    let mut f = 0;
    while f < 6 {
        let mut i = 0;
        while i < 4 {
            let (v, w) = (LOOPS[f][i], LOOPS[f][(i + 1) % 4]);
            let e = LOOP_EDGES[f][i] as usize;
            edges[e].v = if v < w { [v, w] } else { [w, v] };
            edges[e].f[if v < w { 0 } else { 1 }] = f as u16;
            i += 1;
        }
        f += 1;
    }
    edges
};

impl Polytope for Cuboid {
    const IMPLICIT: bool = true;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        8
    }

    #[inline(always)]
    fn vertex(&self, i: usize) -> Vec3 {
        corner(self.half, i)
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        6
    }

    #[inline(always)]
    fn plane(&self, face: usize) -> (Vec3, Float) {
        let mut n = Vec3::zeros();
        n[face >> 1] = if face & 1 == 1 { 1.0 } else { -1.0 };
        (n, self.half[face >> 1])
    }

    #[inline(always)]
    fn face_vertices(&self, face: usize) -> &[u8] {
        &LOOPS[face]
    }

    #[inline(always)]
    fn face_edges(&self, face: usize) -> &[u16] {
        &LOOP_EDGES[face]
    }

    #[inline(always)]
    fn edge_count(&self) -> usize {
        12
    }

    #[inline(always)]
    fn edge(&self, i: usize) -> Edge {
        EDGES[i]
    }

    #[inline(always)]
    fn support(&self, d: Vec3) -> usize {
        usize::from(d.x >= 0.0) | usize::from(d.y >= 0.0) << 1 | usize::from(d.z >= 0.0) << 2
    }

    #[inline(always)]
    fn face_along(&self, d: Vec3) -> usize {
        let a = abs(d);
        let k = if a.x >= a.y && a.x >= a.z {
            0
        } else if a.y >= a.z {
            1
        } else {
            2
        };
        2 * k + usize::from(d[k] >= 0.0)
    }

    #[inline(always)]
    fn center(&self) -> Vec3 {
        Vec3::zeros()
    }

    #[inline(always)]
    fn inner_radius(&self) -> Float {
        self.half.x.min(self.half.y).min(self.half.z)
    }

    #[inline(always)]
    fn reach(&self) -> Float {
        length(self.half)
    }

    #[inline(always)]
    fn core_points(&self) -> CorePoints<'_> {
        CorePoints::Box(self.half)
    }
}

/// Corner `i` of the box with these half extents: bit k of `i` is the sign of axis k.
#[inline(always)]
pub(crate) fn corner(half: Vec3, i: usize) -> Vec3 {
    let s = |k: usize| if i >> k & 1 == 1 { half[k] } else { -half[k] };
    vec3(s(0), s(1), s(2))
}
