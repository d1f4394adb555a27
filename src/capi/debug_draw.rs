//! Debug draw: by callbacks, and into arrays.

use super::Flag;
use super::access::read_world;
use super::def::cookie;
use super::def_check::{check_cookie, flag};
use super::error::c_string;
use super::guard::{c_count, needed, neutral};
use super::id::{mvShapeId, mvWorldId};
use super::math::{mvAABB, mvPos, mvVec3, mvWorldTransform};
use super::mvFloat;
use super::registry::in_callback;
use crate::debug_draw::{Canvas, DrawBuffers, DrawOptions, DrawnShape, InstanceKind};
use crate::error::Result;
use crate::math::{Aabb, Float, Pose, Vec3};
use crate::shape::Shape;
use crate::world::World;
use core::ffi::{c_char, c_int, c_void};
use std::ffi::CString;

/// A colour, 0xRRGGBB.
pub type mvHexColor = u32;

/// What mvWorld_Draw() draws and with what, and what mvWorld_DrawBuffers() puts into arrays. Made by
/// mvDefaultDebugDraw(). Functions get pointers, valid during the call, and numbers; all are in world coordinates, any
/// may be null. They may read the world but not change it.
/// cbindgen:field-names=[internalValue, DrawShapeFcn, DrawSegmentFcn, DrawTransformFcn, DrawPointFcn, DrawSphereFcn, DrawCapsuleFcn, DrawPolygonFcn, DrawBoundsFcn, DrawBoxFcn, DrawStringFcn, drawingBounds, forceScale, jointScale, drawShapes, drawEdges, drawJoints, drawJointExtras, drawBounds, drawMass, drawSleep, drawBodyNames, drawContacts, drawAnchorA, drawGraphColors, drawContactFeatures, drawContactNormals, drawContactForces, drawFrictionForces, drawIslands, tessellate, context]
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDebugDraw {
    /// Shows that the structure was made by its function. Leave it alone.
    pub internal_value: i32,
    /// Draws a shape whose frame is placed by the transform. Where it is null, shapes are drawn by DrawSphereFcn,
    /// DrawCapsuleFcn, DrawBoxFcn and, face by face, DrawPolygonFcn.
    pub draw_shape_fcn: Option<
        unsafe extern "C" fn(
            shapeId: *const mvShapeId,
            transform: *const mvWorldTransform,
            color: mvHexColor,
            context: *mut c_void,
        ),
    >,
    /// Draws a line.
    pub draw_segment_fcn: Option<
        unsafe extern "C" fn(p1: *const mvPos, p2: *const mvPos, color: mvHexColor, context: *mut c_void),
    >,
    /// Draws a frame; its axes as long as you like. Where it is null, DrawSegmentFcn draws the axes.
    pub draw_transform_fcn:
        Option<unsafe extern "C" fn(transform: *const mvWorldTransform, context: *mut c_void)>,
    /// Draws a point; its size is in pixels.
    pub draw_point_fcn:
        Option<unsafe extern "C" fn(p: *const mvPos, size: mvFloat, color: mvHexColor, context: *mut c_void)>,
    /// Draws a ball.
    pub draw_sphere_fcn: Option<
        unsafe extern "C" fn(
            p: *const mvPos,
            radius: mvFloat,
            color: mvHexColor,
            alpha: mvFloat,
            context: *mut c_void,
        ),
    >,
    /// Draws a capsule.
    pub draw_capsule_fcn: Option<
        unsafe extern "C" fn(
            p1: *const mvPos,
            p2: *const mvPos,
            radius: mvFloat,
            color: mvHexColor,
            alpha: mvFloat,
            context: *mut c_void,
        ),
    >,
    /// Draws a face of a hull, or the part of a half-space's surface that is near the scene: a flat convex polygon whose
    /// corners go counter-clockwise seen from outside.
    pub draw_polygon_fcn: Option<
        unsafe extern "C" fn(
            vertices: *const mvPos,
            count: c_int,
            color: mvHexColor,
            alpha: mvFloat,
            context: *mut c_void,
        ),
    >,
    /// Draws a box along the axes. Where it is null, DrawSegmentFcn draws its edges.
    pub draw_bounds_fcn:
        Option<unsafe extern "C" fn(aabb: *const mvAABB, color: mvHexColor, context: *mut c_void)>,
    /// Draws a box with these half extents.
    pub draw_box_fcn: Option<
        unsafe extern "C" fn(
            extents: *const mvVec3,
            transform: *const mvWorldTransform,
            color: mvHexColor,
            context: *mut c_void,
        ),
    >,
    /// Draws a text, in UTF-8.
    pub draw_string_fcn: Option<
        unsafe extern "C" fn(p: *const mvPos, s: *const c_char, color: mvHexColor, context: *mut c_void),
    >,
    /// What lies wholly outside is not drawn; default all that coordinates can reach.
    pub drawing_bounds: mvAABB,
    /// The length of forces [m/N], >= 0; default 1e-4.
    pub force_scale: mvFloat,
    /// A factor on the size of joints, >= 0; default 1.
    pub joint_scale: mvFloat,
    /// Whether shapes are drawn; default true.
    pub draw_shapes: Flag,
    /// Whether the edges of shapes are drawn, as lines; default false.
    pub draw_edges: Flag,
    /// Whether joints are drawn; default true.
    pub draw_joints: Flag,
    /// Whether frames and limits of joints are drawn, too; default false.
    pub draw_joint_extras: Flag,
    /// Whether the boxes that the broad phase knows are drawn; default false.
    pub draw_bounds: Flag,
    /// Whether mass and centre of mass of dynamic bodies are drawn; default false.
    pub draw_mass: Flag,
    /// Whether it is written for how long bodies have been slow, and which are asleep; default false.
    pub draw_sleep: Flag,
    /// Whether the names of bodies are written; default false.
    pub draw_body_names: Flag,
    /// Whether contact points are drawn; default false.
    pub draw_contacts: Flag,
    /// Whether contact points lie on the surface of shape A rather than midway; default false.
    pub draw_anchor_a: Flag,
    /// Whether contact points have the colours of the constraint graph; default false.
    pub draw_graph_colors: Flag,
    /// Whether the features that meet in contact points are written; default false.
    pub draw_contact_features: Flag,
    /// Whether contact normals are drawn; default false.
    pub draw_contact_normals: Flag,
    /// Whether forces along contact normals are drawn, mean over the last step; default false.
    pub draw_contact_forces: Flag,
    /// Whether friction forces are drawn, mean over the last step; default false.
    pub draw_friction_forces: Flag,
    /// Whether islands are drawn, as boxes around their bodies; default false.
    pub draw_islands: Flag,
    /// Whether mvWorld_DrawBuffers() gives triangles for balls, capsules and boxes, too, rather than instances; default
    /// false.
    pub tessellate: Flag,
    /// Passed to the functions.
    pub context: *mut c_void,
}

/// A line of a drawing.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDrawLine {
    /// One end [m].
    pub p1: mvPos,
    /// The other end [m].
    pub p2: mvPos,
    /// Its colour.
    pub color: mvHexColor,
}

/// A triangle of a shape's surface.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDrawTriangle {
    /// The corners, counter-clockwise seen from outside [m].
    pub p1: mvPos,
    /// The second.
    pub p2: mvPos,
    /// The third.
    pub p3: mvPos,
    /// The outward normal, of length 1.
    pub normal: mvVec3,
    /// Its colour.
    pub color: mvHexColor,
    /// Whose it is.
    pub shape_id: mvShapeId,
}

/// What an instance is: one of the mv_draw... constants.
pub type mvDrawInstanceKind = i32;
/// A ball: size is (radius, radius, radius).
pub const mv_drawSphere: mvDrawInstanceKind = 0;
/// A capsule along y: size is (radius, half the length of its segment, radius).
pub const mv_drawCapsule: mvDrawInstanceKind = 1;
/// A box: size is its half extents.
pub const mv_drawBox: mvDrawInstanceKind = 2;

/// A shape that is drawn from a mesh of its kind.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDrawInstance {
    /// The frame in which it is centred.
    pub transform: mvWorldTransform,
    /// By kind [m].
    pub size: mvVec3,
    /// What it is.
    pub kind: mvDrawInstanceKind,
    /// Its colour.
    pub color: mvHexColor,
    /// Whose it is.
    pub shape_id: mvShapeId,
}

/// A point of a drawing.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDrawPoint {
    /// Where [m].
    pub position: mvPos,
    /// In pixels.
    pub size: mvFloat,
    /// Its colour.
    pub color: mvHexColor,
}

/// A text of a drawing.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDrawString {
    /// Where [m].
    pub position: mvPos,
    /// What it says, in UTF-8.
    pub text: *const c_char,
    /// Its colour.
    pub color: mvHexColor,
}

/// A drawing in arrays.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvDrawBuffers {
    /// Edges, joints, boxes, frames, normals and forces.
    pub lines: *const mvDrawLine,
    /// The surfaces of shapes that are no instances.
    pub triangles: *const mvDrawTriangle,
    /// Balls, capsules and boxes.
    pub instances: *const mvDrawInstance,
    /// Contacts, centres of mass and the like.
    pub points: *const mvDrawPoint,
    /// Names and numbers.
    pub strings: *const mvDrawString,
    /// The number of lines.
    pub line_count: c_int,
    /// The number of triangles.
    pub triangle_count: c_int,
    /// The number of instances.
    pub instance_count: c_int,
    /// The number of points.
    pub point_count: c_int,
    /// The number of texts.
    pub string_count: c_int,
}

const DRAW_COOKIE: i32 = cookie::<mvDebugDraw>(100);

neutral! {
    mvDrawBuffers = mvDrawBuffers {
        lines: std::ptr::null(),
        triangles: std::ptr::null(),
        instances: std::ptr::null(),
        points: std::ptr::null(),
        strings: std::ptr::null(),
        line_count: 0,
        triangle_count: 0,
        instance_count: 0,
        point_count: 0,
        string_count: 0,
    };
}

/// Get a drawing with the default values: shapes and joints, without functions.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultDebugDraw() -> mvDebugDraw {
    let d = DrawOptions::default();
    mvDebugDraw {
        internal_value: DRAW_COOKIE,
        draw_shape_fcn: None,
        draw_segment_fcn: None,
        draw_transform_fcn: None,
        draw_point_fcn: None,
        draw_sphere_fcn: None,
        draw_capsule_fcn: None,
        draw_polygon_fcn: None,
        draw_bounds_fcn: None,
        draw_box_fcn: None,
        draw_string_fcn: None,
        drawing_bounds: d.bounds.into(),
        force_scale: d.force_scale,
        joint_scale: d.joint_scale,
        draw_shapes: d.shapes.into(),
        draw_edges: d.edges.into(),
        draw_joints: d.joints.into(),
        draw_joint_extras: d.joint_extras.into(),
        draw_bounds: d.shape_bounds.into(),
        draw_mass: d.mass.into(),
        draw_sleep: d.sleep.into(),
        draw_body_names: d.names.into(),
        draw_contacts: d.contacts.into(),
        draw_anchor_a: d.anchor_a.into(),
        draw_graph_colors: d.graph_colors.into(),
        draw_contact_features: d.contact_features.into(),
        draw_contact_normals: d.contact_normals.into(),
        draw_contact_forces: d.contact_forces.into(),
        draw_friction_forces: d.friction_forces.into(),
        draw_islands: d.islands.into(),
        tessellate: false.into(),
        context: std::ptr::null_mut(),
    }
}

/// Draw a world as it is now. Disabled bodies are not drawn.
///
/// @param worldId the world
/// @param draw what to draw, and the functions that do it
/// @param maskBits shapes with none of these category bits are not drawn; MV_DEFAULT_MASK_BITS for all
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn mvWorld_Draw(world_id: mvWorldId, draw: Option<&mvDebugDraw>, mask_bits: u64) {
    read_world(world_id, |v| {
        let draw = needed("The drawing", draw)?;
        let options = draw.checked(mask_bits)?;
        v.world.draw(&options, &mut Hands { world: v.world, draw, corners: Vec::new() })
    });
}

/// Draw a world as it is now, into arrays. The functions of the drawing are not called.
///
/// @param worldId the world
/// @param draw what to draw
/// @param maskBits shapes with none of these category bits are not drawn; MV_DEFAULT_MASK_BITS for all
/// @return the arrays, empty for bad arguments. They stay valid until the next call of this function for this world, on
/// any thread, or until the world is destroyed.
/// @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_DrawBuffers(
    world_id: mvWorldId,
    draw: Option<&mvDebugDraw>,
    mask_bits: u64,
) -> mvDrawBuffers {
    read_world(world_id, |v| {
        let draw = needed("The drawing", draw)?;
        let options = draw.checked(mask_bits)?;
        let tessellate = flag("tessellate", draw.tessellate)?;
        v.side.drawing(|arrays| {
            arrays.drawing.tessellate = tessellate;
            arrays.drawing.fill(v.world, &options)?;
            Ok(arrays.show())
        })
    })
}

impl mvDebugDraw {
    fn checked(&self, mask_bits: u64) -> Result<DrawOptions> {
        check_cookie("DebugDraw", self.internal_value, DRAW_COOKIE)?;
        Ok(DrawOptions {
            bounds: self.drawing_bounds.raw(),
            mask_bits,
            force_scale: self.force_scale,
            joint_scale: self.joint_scale,
            shapes: flag("drawShapes", self.draw_shapes)?,
            edges: flag("drawEdges", self.draw_edges)?,
            joints: flag("drawJoints", self.draw_joints)?,
            joint_extras: flag("drawJointExtras", self.draw_joint_extras)?,
            shape_bounds: flag("drawBounds", self.draw_bounds)?,
            mass: flag("drawMass", self.draw_mass)?,
            sleep: flag("drawSleep", self.draw_sleep)?,
            names: flag("drawBodyNames", self.draw_body_names)?,
            contacts: flag("drawContacts", self.draw_contacts)?,
            anchor_a: flag("drawAnchorA", self.draw_anchor_a)?,
            graph_colors: flag("drawGraphColors", self.draw_graph_colors)?,
            contact_features: flag("drawContactFeatures", self.draw_contact_features)?,
            contact_normals: flag("drawContactNormals", self.draw_contact_normals)?,
            contact_forces: flag("drawContactForces", self.draw_contact_forces)?,
            friction_forces: flag("drawFrictionForces", self.draw_friction_forces)?,
            islands: flag("drawIslands", self.draw_islands)?,
        })
    }
}

/// How solid shapes are: not seen through.
const SOLID: mvFloat = 1.0;

/// Draws by a program's functions.
struct Hands<'a> {
    world: &'a World,
    draw: &'a mvDebugDraw,
    corners: Vec<mvPos>,
}

// Every call below is sound because who passed the function pointers promises functions of those signatures which do
// not unwind; the pointers they get are valid during the call.
impl Canvas for Hands<'_> {
    fn shape(&mut self, shape: &DrawnShape<'_>) {
        let (draw, world, color, context) = (self.draw, self.world, shape.color, self.draw.context);
        if let Some(fcn) = draw.draw_shape_fcn {
            let (id, transform) = (shape.id.into(), shape.pose.into());
            return in_callback(world, || unsafe {
                fcn(&raw const id, &raw const transform, color, context)
            });
        }
        match shape.shape {
            Shape::Sphere(s) => {
                let Some(fcn) = draw.draw_sphere_fcn else { return };
                let p = shape.pose.point(s.center()).into();
                in_callback(world, || unsafe { fcn(&raw const p, s.radius(), color, SOLID, context) });
            }
            Shape::Capsule(c) => {
                let Some(fcn) = draw.draw_capsule_fcn else { return };
                let (p, q) = (shape.pose.point(c.center1()).into(), shape.pose.point(c.center2()).into());
                in_callback(world, || unsafe {
                    fcn(&raw const p, &raw const q, c.radius(), color, SOLID, context);
                });
            }
            Shape::Box(b) => {
                let Some(fcn) = draw.draw_box_fcn else { return };
                let (extents, transform) = (b.half().into(), shape.pose.into());
                in_callback(world, || unsafe {
                    fcn(&raw const extents, &raw const transform, color, context);
                });
            }
            Shape::Hull(_) | Shape::HalfSpace(_) => {
                let Some(fcn) = draw.draw_polygon_fcn else { return };
                let corners = &mut self.corners;
                shape.faces(&mut |points, _| {
                    corners.clear();
                    corners.extend(points.iter().map(|&p| mvPos::from(p)));
                    let (first, count) = (corners.as_ptr(), c_count(corners.len()));
                    in_callback(world, || unsafe { fcn(first, count, color, SOLID, context) });
                });
            }
        }
    }

    fn segment(&mut self, from: Vec3, to: Vec3, color: u32) {
        let (Some(fcn), context) = (self.draw.draw_segment_fcn, self.draw.context) else { return };
        let (p, q) = (from.into(), to.into());
        in_callback(self.world, || unsafe { fcn(&raw const p, &raw const q, color, context) });
    }

    fn point(&mut self, at: Vec3, size: Float, color: u32) {
        let (Some(fcn), context) = (self.draw.draw_point_fcn, self.draw.context) else { return };
        let p = at.into();
        in_callback(self.world, || unsafe { fcn(&raw const p, size, color, context) });
    }

    fn text(&mut self, at: Vec3, text: &str, color: u32) {
        let (Some(fcn), context) = (self.draw.draw_string_fcn, self.draw.context) else { return };
        let (p, text) = (at.into(), c_string(text));
        in_callback(self.world, || unsafe { fcn(&raw const p, text.as_ptr(), color, context) });
    }

    fn frame(&mut self, pose: &Pose, length: Float) {
        let Some(fcn) = self.draw.draw_transform_fcn else {
            return Lines(self).frame(pose, length);
        };
        let (transform, context) = ((*pose).into(), self.draw.context);
        in_callback(self.world, || unsafe { fcn(&raw const transform, context) });
    }

    fn bounds(&mut self, bounds: &Aabb, color: u32) {
        let Some(fcn) = self.draw.draw_bounds_fcn else {
            return Lines(self).bounds(bounds, color);
        };
        let (aabb, context) = ((*bounds).into(), self.draw.context);
        in_callback(self.world, || unsafe { fcn(&raw const aabb, color, context) });
    }
}

/// Draws what a program has no function for as lines, in the canvas's own way.
struct Lines<'a, 'b>(&'a mut Hands<'b>);

impl Canvas for Lines<'_, '_> {
    fn shape(&mut self, shape: &DrawnShape<'_>) {
        self.0.shape(shape);
    }
    fn segment(&mut self, from: Vec3, to: Vec3, color: u32) {
        self.0.segment(from, to, color);
    }
    fn point(&mut self, at: Vec3, size: Float, color: u32) {
        self.0.point(at, size, color);
    }
    fn text(&mut self, at: Vec3, text: &str, color: u32) {
        self.0.text(at, text, color);
    }
}

/// The arrays behind an [`mvDrawBuffers`].
#[derive(Default)]
pub(super) struct DrawArrays {
    drawing: DrawBuffers,
    lines: Vec<mvDrawLine>,
    triangles: Vec<mvDrawTriangle>,
    instances: Vec<mvDrawInstance>,
    points: Vec<mvDrawPoint>,
    strings: Vec<mvDrawString>,
    texts: Vec<CString>,
}

impl DrawArrays {
    fn show(&mut self) -> mvDrawBuffers {
        let Self { drawing, lines, triangles, instances, points, strings, texts } = self;
        refill(lines, &drawing.lines, |l| mvDrawLine {
            p1: l.points[0].into(),
            p2: l.points[1].into(),
            color: l.color,
        });
        refill(triangles, &drawing.triangles, |t| mvDrawTriangle {
            p1: t.points[0].into(),
            p2: t.points[1].into(),
            p3: t.points[2].into(),
            normal: t.normal.into(),
            color: t.color,
            shape_id: t.shape.into(),
        });
        refill(instances, &drawing.instances, |i| mvDrawInstance {
            transform: i.pose.into(),
            size: i.size.into(),
            kind: match i.kind {
                InstanceKind::Sphere => mv_drawSphere,
                InstanceKind::Capsule => mv_drawCapsule,
                InstanceKind::Box => mv_drawBox,
            },
            color: i.color,
            shape_id: i.shape.into(),
        });
        refill(points, &drawing.points, |p| mvDrawPoint {
            position: p.position.into(),
            size: p.size,
            color: p.color,
        });
        refill(texts, &drawing.texts, |t| c_string(&t.text));
        strings.clear();
        strings.extend(drawing.texts.iter().zip(&*texts).map(|(t, text)| mvDrawString {
            position: t.position.into(),
            text: text.as_ptr(),
            color: t.color,
        }));
        drawing.clear();
        mvDrawBuffers {
            lines: lines.as_ptr(),
            triangles: triangles.as_ptr(),
            instances: instances.as_ptr(),
            points: points.as_ptr(),
            strings: strings.as_ptr(),
            line_count: c_count(lines.len()),
            triangle_count: c_count(triangles.len()),
            instance_count: c_count(instances.len()),
            point_count: c_count(points.len()),
            string_count: c_count(strings.len()),
        }
    }
}

fn refill<T, S>(array: &mut Vec<T>, from: &[S], make: impl Fn(&S) -> T) {
    array.clear();
    array.extend(from.iter().map(make));
}
