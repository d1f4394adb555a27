//! Hulls as C sees them: one block of bytes that can be copied, with offsets counted from its start.
//!
//! Nothing in such a block is believed: version, size and hash are checked, and what the engine works with is
//! rebuilt from the points. A block that was tampered with is refused or is just another hull.

use super::guard::{Neutral, neutral};
use super::math::{mvAABB, mvMatrix3, mvPlane, mvTransform, mvVec3};
use super::{MV_ABI_REVISION, mvFloat};
use crate::error::{Error, ErrorCode, Result};
use crate::math::{Float, Pose, Vec3, length, length_squared};
use crate::shape::{Cuboid, Hull, MassData, Polytope, Shape};
use std::mem::{offset_of, size_of};
use std::sync::Arc;

/// The most vertices of a hull.
pub const MV_MAX_HULL_VERTICES: i32 = 255;

/// A vertex of a hull.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvHullVertex {
    /// One of the half-edges that start here.
    pub edge: u16,
}

/// A half-edge: one direction of an edge, belonging to the face on its left.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvHullHalfEdge {
    /// The next half-edge around the face, counter-clockwise seen from outside.
    pub next: u16,
    /// The half-edge in the other direction.
    pub twin: u16,
    /// The vertex where it starts.
    pub origin: u16,
    /// The face on its left.
    pub face: u16,
}

/// A face of a hull.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvHullFace {
    /// One of the half-edges around it.
    pub edge: u16,
}

/// A convex hull: this struct followed by its arrays, byteCount bytes in all. It may be copied as a block, with
/// alignment 8; offsets are in bytes from the start of this struct. It is read only: a changed hull is refused.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvHullData {
    /// Identifies a hull of this version and precision of the library, and of this many bytes.
    pub version: u64,
    /// A hash of all bytes, counted with this field as 0.
    pub hash: u64,
    /// The box around the hull.
    pub aabb: mvAABB,
    /// The area of the surface [m^2].
    pub surface_area: mvFloat,
    /// The volume [m^3].
    pub volume: mvFloat,
    /// The least distance from the center to a face [m].
    pub inner_radius: mvFloat,
    /// The greatest distance from the center to a vertex [m].
    pub outer_radius: mvFloat,
    /// The centre of mass [m].
    pub center: mvVec3,
    /// The inertia about the center for a density of 1 [m^5].
    pub central_inertia: mvMatrix3,
    /// Half the side lengths, if the hull was made as a box; zero otherwise.
    pub box_half_widths: mvVec3,
    /// Where the box is, if the hull was made as one.
    pub box_transform: mvTransform,
    /// The number of vertices and of points.
    pub vertex_count: i32,
    /// Where the vertices are: mvGetHullVertices().
    pub vertex_offset: i32,
    /// Where the points are: mvGetHullPoints().
    pub point_offset: i32,
    /// The number of half-edges: twice the number of edges.
    pub edge_count: i32,
    /// Where the half-edges are: mvGetHullEdges().
    pub edge_offset: i32,
    /// The number of faces and of planes.
    pub face_count: i32,
    /// Where the planes of the faces are: mvGetHullPlanes().
    pub plane_offset: i32,
    /// Where the faces are: mvGetHullFaces().
    pub face_offset: i32,
    /// The number of bytes of the whole hull.
    pub byte_count: i32,
    /// Zero.
    pub padding: i32,
}

/// A box as a hull: a plain value that needs no destroying. Pass the address of its base where a hull is wanted.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvBoxHull {
    /// The hull, whose offsets lead to the arrays below.
    pub base: mvHullData,
    /// The corners: bit 0, 1, 2 of the index is set where x, y, z of the box's frame is positive.
    pub box_points: [mvVec3; 8],
    /// The planes of the faces -x, +x, -y, +y, -z, +z.
    pub box_planes: [mvPlane; 6],
    /// The half-edges.
    pub box_edges: [mvHullHalfEdge; 24],
    /// The vertices.
    pub box_vertices: [mvHullVertex; 8],
    /// The faces.
    pub box_faces: [mvHullFace; 6],
    /// Zero.
    pub padding: [u16; 2],
}

// No byte is left to chance, so that hulls can be hashed and compared as blocks.
const _: () = {
    let (f, n) = (size_of::<Float>(), size_of::<mvHullData>());
    assert!(n == 16 + 32 * f + 40);
    assert!(size_of::<mvBoxHull>() == n + (24 + 24) * f + 24 * 8 + 16 + 12 + 4);
};

const EMPTY: mvHullData = mvHullData {
    version: 0,
    hash: 0,
    aabb: mvAABB::NEUTRAL,
    surface_area: 0.0,
    volume: 0.0,
    inner_radius: 0.0,
    outer_radius: 0.0,
    center: mvVec3::NEUTRAL,
    central_inertia: mvMatrix3::NEUTRAL,
    box_half_widths: mvVec3::NEUTRAL,
    box_transform: mvTransform::NEUTRAL,
    vertex_count: 0,
    vertex_offset: 0,
    point_offset: 0,
    edge_count: 0,
    edge_offset: 0,
    face_count: 0,
    plane_offset: 0,
    face_offset: 0,
    byte_count: 0,
    padding: 0,
};

neutral! {
    // A box that no function accepts.
    mvBoxHull = mvBoxHull {
        base: EMPTY,
        box_points: [mvVec3::NEUTRAL; 8],
        box_planes: [mvPlane::NEUTRAL; 6],
        box_edges: [mvHullHalfEdge { next: 0, twin: 0, origin: 0, face: 0 }; 24],
        box_vertices: [mvHullVertex { edge: 0 }; 8],
        box_faces: [mvHullFace { edge: 0 }; 6],
        padding: [0; 2],
    };
}

/// What stands in `version`. The byte count is mixed in, so that a wrong one is found before it is believed.
const fn version(byte_count: i32) -> u64 {
    let kind = 0x6d76_4875_6c6c_0000 ^ (size_of::<mvHullData>() as u64) << 4 ^ MV_ABI_REVISION as u64;
    (kind ^ byte_count as u32 as u64).wrapping_mul(0xd6e8_feb8_6659_fd93).rotate_left(31)
}

/// The greatest possible size of a hull in bytes: a check before anything is read.
const MAX_BYTES: usize = 1 << 20;

/// The arrays of a hull before they are laid out.
pub(super) struct Tables {
    head: mvHullData,
    points: Vec<mvVec3>,
    planes: Vec<mvPlane>,
    edges: Vec<mvHullHalfEdge>,
    vertices: Vec<mvHullVertex>,
    faces: Vec<mvHullFace>,
}

impl Tables {
    pub(super) fn of_hull(hull: &Hull) -> Self {
        let mut tables = Self::new(hull, &Pose::IDENTITY);
        let solid = Shape::Hull(Arc::new(hull.clone()));
        tables.set_mass(&solid.mass_data(1.0), solid.outer_radius(hull.center()));
        tables
    }

    pub(super) fn of_box(cuboid: Cuboid, pose: &Pose) -> Self {
        let mut tables = Self::new(&cuboid, pose);
        let mass = Shape::Box(cuboid).mass_data(1.0).placed(pose);
        tables.set_mass(&mass, length(cuboid.half()));
        tables.head.box_half_widths = cuboid.half().into();
        tables.head.box_transform = (*pose).into();
        tables
    }

    fn new(solid: &impl Polytope, pose: &Pose) -> Self {
        let points: Vec<Vec3> = (0..solid.vertex_count()).map(|i| pose.point(solid.vertex(i))).collect();
        let mut edges = Vec::with_capacity(2 * solid.edge_count());
        let mut vertices = vec![mvHullVertex { edge: 0 }; points.len()];
        let (mut faces, mut planes, mut area) = (Vec::new(), Vec::new(), 0.0);
        // The two directions of each edge, in the order in which the faces come by.
        let mut directions = vec![[None::<u16>; 2]; solid.edge_count()];
        for face in 0..solid.face_count() {
            let around = solid.face_vertices(face);
            let first = edges.len();
            for (k, &v) in around.iter().enumerate() {
                let e = edges.len() as u16;
                let next = (first + (k + 1) % around.len()) as u16;
                edges.push(mvHullHalfEdge { next, twin: 0, origin: u16::from(v), face: face as u16 });
                vertices[v as usize].edge = e;
                let seen = &mut directions[solid.face_edges(face)[k] as usize];
                seen[usize::from(seen[0].is_some())] = Some(e);
            }
            let corner = |k: usize| points[around[k] as usize] - points[around[0] as usize];
            area +=
                (1..around.len() - 1).map(|k| 0.5 * length(corner(k).cross(&corner(k + 1)))).sum::<Float>();
            faces.push(mvHullFace { edge: first as u16 });
            let (n, offset) = solid.plane(face);
            let n = pose.vector(n);
            planes.push(mvPlane { normal: n.into(), offset: offset + n.dot(&pose.p) });
        }
        for pair in directions {
            if let [Some(a), Some(b)] = pair {
                edges[a as usize].twin = b;
                edges[b as usize].twin = a;
            }
        }
        let head = mvHullData {
            aabb: crate::math::Aabb::of_points(&points).into(),
            surface_area: area,
            inner_radius: solid.inner_radius(),
            ..EMPTY
        };
        Self { head, points: points.into_iter().map(Into::into).collect(), planes, edges, vertices, faces }
    }

    fn set_mass(&mut self, mass: &MassData, outer_radius: Float) {
        self.head.volume = mass.mass;
        self.head.center = mass.center.into();
        self.head.central_inertia = mass.inertia.into();
        self.head.outer_radius = outer_radius;
    }

    /// One block, with room for every array.
    pub(super) fn block(mut self) -> Block {
        let mut end = size_of::<mvHullData>();
        let mut take = |bytes: usize| {
            let start = end;
            end = (end + bytes).next_multiple_of(8);
            start as i32
        };
        self.head.point_offset = take(size_of_val(&*self.points));
        self.head.plane_offset = take(size_of_val(&*self.planes));
        self.head.edge_offset = take(size_of_val(&*self.edges));
        self.head.vertex_offset = take(size_of_val(&*self.vertices));
        self.head.face_offset = take(size_of_val(&*self.faces));
        self.head.byte_count = end as i32;
        let mut words = vec![0u64; end / 8].into_boxed_slice();
        self.write(&mut words);
        Block(words)
    }

    /// A box as a value.
    pub(super) fn box_value(mut self) -> mvBoxHull {
        self.head.point_offset = offset_of!(mvBoxHull, box_points) as i32;
        self.head.plane_offset = offset_of!(mvBoxHull, box_planes) as i32;
        self.head.edge_offset = offset_of!(mvBoxHull, box_edges) as i32;
        self.head.vertex_offset = offset_of!(mvBoxHull, box_vertices) as i32;
        self.head.face_offset = offset_of!(mvBoxHull, box_faces) as i32;
        self.head.byte_count = size_of::<mvBoxHull>() as i32;
        let mut words = [0u64; size_of::<mvBoxHull>() / 8];
        self.write(&mut words);
        // Sound: as many bytes as an mvBoxHull, which is valid for any bits.
        unsafe { std::mem::transmute(words) }
    }

    fn write(&mut self, words: &mut [u64]) {
        self.head.version = version(self.head.byte_count);
        self.head.vertex_count = self.vertices.len() as i32;
        self.head.edge_count = self.edges.len() as i32;
        self.head.face_count = self.faces.len() as i32;
        put(words, 0, &[self.head]);
        put(words, self.head.point_offset, &self.points);
        put(words, self.head.plane_offset, &self.planes);
        put(words, self.head.edge_offset, &self.edges);
        put(words, self.head.vertex_offset, &self.vertices);
        put(words, self.head.face_offset, &self.faces);
        let hash = hash(words);
        words[offset_of!(mvHullData, hash) / 8] = hash;
    }
}

/// Copies `values` to byte `offset` of `words`.
fn put<T: Copy>(words: &mut [u64], offset: i32, values: &[T]) {
    let bytes = size_of_val(values);
    let offset = offset as usize;
    assert!(offset + bytes <= size_of_val(words));
    // Sound: just checked to fit; T are structs of numbers without padding bytes (checked above by size).
    unsafe {
        let to = words.as_mut_ptr().cast::<u8>().add(offset);
        std::ptr::copy_nonoverlapping(values.as_ptr().cast::<u8>(), to, bytes);
    }
}

/// The hash of a block, whose field `hash` counts as 0.
fn hash(words: &[u64]) -> u64 {
    words.iter().enumerate().fold(0x9e37_79b9_7f4a_7c15, |h: u64, (i, &w)| {
        let w = if i == offset_of!(mvHullData, hash) / 8 { 0 } else { w };
        (h ^ w).wrapping_mul(0xd6e8_feb8_6659_fd93).rotate_left(29)
    })
}

/// A hull in one allocation.
pub(super) struct Block(Box<[u64]>);

impl Block {
    pub(super) fn as_ptr(&self) -> *const mvHullData {
        self.0.as_ptr().cast()
    }

    pub(super) fn into_raw(self) -> (*mut mvHullData, usize) {
        let n = self.0.len();
        (Box::into_raw(self.0).cast(), n)
    }

    /// The block that [`Block::into_raw`] gave away.
    ///
    /// # Safety
    /// Pointer and count come from there, and only once.
    pub(super) unsafe fn from_raw(data: *mut mvHullData, words: usize) -> Self {
        // Sound: by contract, this is the slice that was leaked.
        Self(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(data.cast::<u64>(), words)) })
    }
}

/// The words of a hull that C passes in, checked as a whole.
///
/// # Safety
/// `hull` is null or points to an mvHullData; if it is one that this library made, all its bytes are there and
/// nobody changes them during `'a`.
pub(super) unsafe fn checked<'a>(hull: *const mvHullData) -> Result<(&'a mvHullData, &'a [u64])> {
    if hull.is_null() {
        return Err(Error::new(ErrorCode::Null, "The hull is null."));
    }
    if !hull.is_aligned() {
        return Err(Error::new(ErrorCode::Range, "The hull is not aligned to 8 bytes."));
    }
    // Sound: not null, aligned, and an mvHullData by contract, which is valid for any bits.
    let head = unsafe { &*hull };
    let bytes = head.byte_count as usize;
    let bad = |why: &'static str| Err(Error::new(ErrorCode::Definition, why));
    if head.version != version(head.byte_count) {
        return bad("The hull was not made by this version of the library, or its byte count was changed.");
    }
    if head.byte_count < 0 || bytes < size_of::<mvHullData>() || bytes > MAX_BYTES || !bytes.is_multiple_of(8)
    {
        return bad("The hull has a wrong byte count.");
    }
    // Sound: the version says that this library made it, so by contract all its bytes are there.
    let words = unsafe { std::slice::from_raw_parts(hull.cast::<u64>(), bytes / 8) };
    if hash(words) != head.hash {
        return bad("The hull was changed after it was made: its hash is wrong.");
    }
    Ok((head, words))
}

/// The points of a checked hull.
pub(super) fn points(head: &mvHullData, words: &[u64]) -> Result<Vec<Vec3>> {
    let (n, start) = (head.vertex_count as usize, head.point_offset as usize);
    let fits = n <= MV_MAX_HULL_VERTICES as usize
        && start <= size_of_val(words)
        && start.is_multiple_of(align_of::<mvVec3>())
        && n * size_of::<mvVec3>() <= size_of_val(words) - start;
    if head.vertex_count < 0 || head.point_offset < 0 || !fits {
        return Err(Error::new(ErrorCode::Definition, "The hull's points lie outside of it."));
    }
    // Sound: inside the block, as just checked; mvVec3 is valid for any bits.
    let points =
        unsafe { std::slice::from_raw_parts(words.as_ptr().cast::<u8>().add(start).cast::<mvVec3>(), n) };
    Ok(points.iter().map(|p| p.raw()).collect())
}

/// The solid of a hull that C passes in, and its placement: boxes stay boxes.
///
/// # Safety
/// As for [`checked`].
pub(super) unsafe fn solid(hull: *const mvHullData) -> Result<(Shape, Pose)> {
    // Sound: by this function's contract.
    let (head, words) = unsafe { checked(hull) }?;
    if length_squared(head.box_half_widths.raw()) > 0.0 {
        let cuboid = Cuboid::new(head.box_half_widths.raw())?;
        return Ok((Shape::Box(cuboid), head.box_transform.pose("The box's transform")?));
    }
    Ok((Shape::Hull(super::hull::shared(head.hash, points(head, words)?)?), Pose::IDENTITY))
}
