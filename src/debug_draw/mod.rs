//! Debug draw: what a world looks like, told to a [`Canvas`]. There is no renderer here, and the world is only read.
//!
//! [`World::draw`] walks over the world once for each thing that [`DrawOptions`] asks for. A canvas may draw at once,
//! or collect: [`DrawBuffers`] is the canvas that fills arrays of lines, triangles, instances, points and texts.

mod bodies;
mod buffers;
mod contacts;
mod joints;
mod shape;
#[cfg(test)]
mod tests;

pub use buffers::{DrawBuffers, Instance, InstanceKind, Line, Point, Text, Triangle};
pub use shape::DrawnShape;

use crate::error::{Error, ErrorCode, Result, check};
use crate::math::tolerance::MAX_COORDINATE;
use crate::math::{Aabb, Float, Pose, Vec3, vec3};
use crate::world::World;

/// A colour, 0xRRGGBB.
pub type Color = u32;

/// The colours that things have. A shape with a colour of its own keeps that.
pub mod colors {
    use super::Color;

    /// Shapes of static bodies.
    pub const STATIC: Color = 0x8c_a0_94;
    /// Shapes of kinematic bodies.
    pub const KINEMATIC: Color = 0x5b_8d_ef;
    /// Shapes of dynamic bodies that are awake.
    pub const AWAKE: Color = 0xe8_b8_4a;
    /// Shapes of bodies that sleep.
    pub const ASLEEP: Color = 0x8c_96_a8;
    /// Edges of shapes.
    pub const EDGE: Color = 0x20_24_2c;
    /// Joints: from the bodies to the frames.
    pub const JOINT: Color = 0x3c_b0_c0;
    /// What a joint moves along or about.
    pub const AXIS: Color = 0x30_70_f0;
    /// Limits of joints.
    pub const LIMIT: Color = 0xd0_40_70;
    /// Boxes of the broad phase.
    pub const BOUNDS: Color = 0xd8_a5_20;
    /// Boxes around islands.
    pub const ISLAND: Color = 0xff_45_00;
    /// Centres of mass.
    pub const MASS: Color = 0xf0_f0_f0;
    /// Names and numbers.
    pub const TEXT: Color = 0xc0_c8_d8;
    /// Contact points that touch.
    pub const TOUCHING: Color = 0x30_d0_50;
    /// Contact points with a gap.
    pub const NEAR: Color = 0x50_70_d0;
    /// Contact normals.
    pub const NORMAL: Color = 0xf0_f0_f0;
    /// Forces along contact normals.
    pub const FORCE: Color = 0xf0_60_30;
    /// Friction forces.
    pub const FRICTION: Color = 0xf0_d0_30;
    /// The axes of a frame: x, y, z.
    pub const FRAME: [Color; 3] = [0xe0_40_40, 0x40_c0_40, 0x40_60_e0];
}

/// What is drawn, and how large.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawOptions {
    /// What lies wholly outside is not drawn; default all that coordinates can reach.
    pub bounds: Aabb,
    /// Shapes with none of these category bits are not drawn; default all bits.
    pub mask_bits: u64,
    /// Length of forces \[m/N\], ≥ 0; default 10⁻⁴.
    pub force_scale: Float,
    /// A factor on the size of joints, ≥ 0; default 1.
    pub joint_scale: Float,
    /// Shapes; default true.
    pub shapes: bool,
    /// Edges of shapes, as segments; default false.
    pub edges: bool,
    /// Joints; default true.
    pub joints: bool,
    /// Frames and limits of joints; default false.
    pub joint_extras: bool,
    /// The boxes that the broad phase knows; default false.
    pub shape_bounds: bool,
    /// Mass and centre of mass of dynamic bodies; default false.
    pub mass: bool,
    /// How long bodies have been slow, and who sleeps; default false.
    pub sleep: bool,
    /// Names of bodies; default false.
    pub names: bool,
    /// Contact points; default false.
    pub contacts: bool,
    /// Whether contact points lie on the surface of shape A rather than midway; default false.
    pub anchor_a: bool,
    /// Whether contact points have the colours of the constraint graph; default false.
    pub graph_colors: bool,
    /// Which features meet in contact points; default false.
    pub contact_features: bool,
    /// Contact normals; default false.
    pub contact_normals: bool,
    /// Forces along contact normals, mean over the last step; default false.
    pub contact_forces: bool,
    /// Friction forces on shape B, mean over the last step; default false.
    pub friction_forces: bool,
    /// Islands, as boxes around their bodies; default false.
    pub islands: bool,
}

impl Default for DrawOptions {
    fn default() -> Self {
        let far = vec3(MAX_COORDINATE, MAX_COORDINATE, MAX_COORDINATE);
        Self {
            bounds: Aabb { lower: -far, upper: far },
            mask_bits: u64::MAX,
            force_scale: 1e-4,
            joint_scale: 1.0,
            shapes: true,
            edges: false,
            joints: true,
            joint_extras: false,
            shape_bounds: false,
            mass: false,
            sleep: false,
            names: false,
            contacts: false,
            anchor_a: false,
            graph_colors: false,
            contact_features: false,
            contact_normals: false,
            contact_forces: false,
            friction_forces: false,
            islands: false,
        }
    }
}

impl DrawOptions {
    /// Draws nothing: to switch single things on.
    #[must_use]
    pub fn nothing() -> Self {
        Self { shapes: false, joints: false, ..Self::default() }
    }

    /// Checks every number.
    ///
    /// # Errors
    /// NotFinite, Range.
    pub fn validate(&self) -> Result<()> {
        check::finite_vec("drawing bounds", self.bounds.lower)?;
        check::finite_vec("drawing bounds", self.bounds.upper)?;
        if !self.bounds.is_valid() {
            return Err(Error::new(
                ErrorCode::Range,
                "The drawing bounds are inside out; the least corner must come first.",
            ));
        }
        check::not_negative("force_scale", self.force_scale)?;
        check::not_negative("joint_scale", self.joint_scale)?;
        Ok(())
    }

    fn sees(&self, point: Vec3) -> bool {
        self.bounds.overlaps(&Aabb { lower: point, upper: point })
    }
}

/// Where a world is drawn. Everything is in world coordinates.
pub trait Canvas {
    /// A shape.
    fn shape(&mut self, shape: &DrawnShape<'_>);
    /// A line from one point to another.
    fn segment(&mut self, from: Vec3, to: Vec3, color: Color);
    /// A point, `size` pixels wide.
    fn point(&mut self, at: Vec3, size: Float, color: Color);
    /// A text.
    fn text(&mut self, at: Vec3, text: &str, color: Color);

    /// A frame; its axes are `length` long \[m\].
    fn frame(&mut self, pose: &Pose, length: Float) {
        for (k, color) in colors::FRAME.into_iter().enumerate() {
            let mut axis = Vec3::zeros();
            axis[k] = length;
            self.segment(pose.p, pose.point(axis), color);
        }
    }

    /// A box along the axes.
    fn bounds(&mut self, bounds: &Aabb, color: Color) {
        let corner = |k: usize| {
            let side = |bit: usize| if k >> bit & 1 == 0 { bounds.lower[bit] } else { bounds.upper[bit] };
            vec3(side(0), side(1), side(2))
        };
        for k in 0..8 {
            for bit in (0..3).filter(|bit| k >> bit & 1 == 0) {
                self.segment(corner(k), corner(k | 1 << bit), color);
            }
        }
    }
}

impl World {
    /// Tells `canvas` what the world looks like now. Bodies that are disabled are not drawn.
    ///
    /// # Errors
    /// What [`DrawOptions::validate`] says.
    pub fn draw(&self, options: &DrawOptions, canvas: &mut dyn Canvas) -> Result<()> {
        options.validate()?;
        let scene = bodies::extent(self, options);
        if options.shapes || options.edges {
            bodies::shapes(self, options, &scene, canvas);
        }
        if options.joints {
            joints::joints(self, options, canvas);
        }
        if options.shape_bounds {
            bodies::shape_bounds(self, options, &scene, canvas);
        }
        if options.islands {
            bodies::islands(self, options, canvas);
        }
        bodies::notes(self, options, canvas);
        contacts::contacts(self, options, canvas);
        Ok(())
    }
}
