//! Engines in C and C++, each through a shim in `c` that takes the scene as plain data (`c/peer.h`). What they have in
//! common is here: the data, and frames. A body of theirs is its centre of mass with its principal axes.

mod solid;

use super::{Engine, Method, Motion, Setting};
use crate::scene::{Body, Form, Hold, Joint, Kind, Scene};
use crate::vector::{Q4, STILL, V3, add, conjugate, cross, rotate, sub, times, turn, unit};
use solid::{Hull, Solid};
use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::ptr::NonNull;

#[repr(C)]
struct RawHull {
    points: *const V3,
    point_count: c_uint,
    planes: *const [f64; 4],
    plane_count: c_uint,
    polygons: *const c_uint,
}

#[repr(C)]
#[derive(Clone, Copy)]
struct RawShape {
    kind: c_int,
    hull: c_uint,
    size: V3,
    position: V3,
    rotation: Q4,
}

#[repr(C)]
struct RawBody {
    kind: c_int,
    first_shape: c_uint,
    shape_count: c_uint,
    collides: c_int,
    position: V3,
    rotation: Q4,
    velocity: V3,
    spin: V3,
    mass: f64,
    inertia: V3,
    friction: f64,
    restitution: f64,
}

#[repr(C)]
struct RawJoint {
    kind: c_int,
    springs: c_int,
    bodies: [c_uint; 2],
    position: [V3; 2],
    rotation: [Q4; 2],
    length: f64,
    stiffness: f64,
    damping: f64,
}

/// A scene as `c/peer.h` has it.
#[repr(C)]
pub struct RawScene {
    gravity: V3,
    restitution_threshold: f64,
    sleeps: c_int,
    hull_count: c_uint,
    shape_count: c_uint,
    body_count: c_uint,
    joint_count: c_uint,
    hulls: *const RawHull,
    shapes: *const RawShape,
    bodies: *const RawBody,
    joints: *const RawJoint,
}

#[repr(C)]
pub struct RawSetting {
    dt: f64,
    sub_steps: c_uint,
    iterations: c_uint,
    solver: c_int,
    integrator: c_int,
}

#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct RawMotion {
    position: V3,
    rotation: Q4,
    velocity: V3,
    spin: V3,
}

/// The functions of an engine's shim.
pub struct Functions {
    pub create: unsafe extern "C" fn(*const RawScene, *const RawSetting, *mut c_char, c_uint) -> *mut c_void,
    pub step: unsafe extern "C" fn(*mut c_void),
    pub push: unsafe extern "C" fn(*mut c_void, c_uint, *const f64, *const f64),
    pub motions: unsafe extern "C" fn(*const c_void, *mut RawMotion),
    pub is_broken: unsafe extern "C" fn(*const c_void) -> c_int,
    pub destroy: unsafe extern "C" fn(*mut c_void),
    pub version: unsafe extern "C" fn() -> *const c_char,
}

/// Declares the functions of a shim, as `PEER_FUNCTIONS` does, and their table `FUNCTIONS`.
macro_rules! shim {
    ($create:ident $step:ident $push:ident $motions:ident $is_broken:ident $destroy:ident $version:ident) => {
        unsafe extern "C" {
            fn $create(
                scene: *const super::RawScene,
                setting: *const super::RawSetting,
                why: *mut std::ffi::c_char,
                why_size: std::ffi::c_uint,
            ) -> *mut std::ffi::c_void;
            fn $step(world: *mut std::ffi::c_void);
            fn $push(
                world: *mut std::ffi::c_void,
                body: std::ffi::c_uint,
                force: *const f64,
                torque: *const f64,
            );
            fn $motions(world: *const std::ffi::c_void, out: *mut super::RawMotion);
            fn $is_broken(world: *const std::ffi::c_void) -> std::ffi::c_int;
            fn $destroy(world: *mut std::ffi::c_void);
            fn $version() -> *const std::ffi::c_char;
        }

        pub const FUNCTIONS: super::Functions = super::Functions {
            create: $create,
            step: $step,
            push: $push,
            motions: $motions,
            is_broken: $is_broken,
            destroy: $destroy,
            version: $version,
        };
    };
}

#[cfg(feature = "bullet")]
pub mod bullet;
#[cfg(feature = "mujoco")]
pub mod mujoco;
#[cfg(feature = "ode")]
pub mod ode;

/// The version of the library behind a shim.
pub fn version(functions: &Functions) -> String {
    // SAFETY: the shim returns a string that lives as long as the program.
    unsafe { CStr::from_ptr((functions.version)()) }.to_string_lossy().into_owned()
}

/// A world of a scene behind a shim.
pub struct Shim {
    functions: &'static Functions,
    world: NonNull<c_void>,
    /// All bodies, in the scene's order.
    solids: Vec<Solid>,
    /// From what the scene takes for the place of each to its centre of mass.
    offsets: Vec<V3>,
    /// Which of them are dynamic.
    dynamic: Vec<usize>,
    raw: std::cell::RefCell<Vec<RawMotion>>,
    /// Engines keep pointers into it.
    _hulls: Hulls,
}

/// Hulls as engines take them.
struct Hulls {
    hulls: Vec<Hull>,
    polygons: Vec<Vec<c_uint>>,
}

impl Hulls {
    fn new(scene: &Scene) -> Result<Self, String> {
        let hulls: Option<Vec<Hull>> = scene.clouds.iter().map(|c| Hull::of(c)).collect();
        let hulls = hulls.ok_or("a cloud of points is flat")?;
        let list = |h: &Hull| h.faces.iter().flat_map(|f| [&[f.len() as u32], &f[..]].concat()).collect();
        let polygons = hulls.iter().map(list).collect();
        Ok(Self { hulls, polygons })
    }

    fn raw(&self) -> Vec<RawHull> {
        let pairs = self.hulls.iter().zip(&self.polygons);
        let raw = pairs.map(|(hull, polygons)| RawHull {
            points: hull.points.as_ptr(),
            point_count: hull.points.len() as c_uint,
            planes: hull.planes.as_ptr(),
            plane_count: hull.planes.len() as c_uint,
            polygons: polygons.as_ptr(),
        });
        raw.collect()
    }
}

/// A body's mass and frame; what does not move has the frame that the scene gives it.
fn solid(scene: &Scene, hulls: &[Hull], body: &Body) -> Solid {
    if body.kind == Kind::Dynamic {
        Solid::of(scene, hulls, body)
    } else {
        Solid { mass: 0.0, centre: [0.0; 3], axes: STILL, inertia: [0.0; 3] }
    }
}

/// The shapes of a body, in the frame of the body.
fn shapes(scene: &Scene, body: &Body) -> Vec<RawShape> {
    let plain = |kind, hull, size| RawShape { kind, hull, size, position: [0.0; 3], rotation: STILL };
    match body.form {
        Form::Box(half) => vec![plain(0, 0, half)],
        Form::Sphere(r) => vec![plain(1, 0, [r, 0.0, 0.0])],
        // Theirs lie along z.
        Form::Capsule(half, r) => {
            let rotation = turn([1.0, 0.0, 0.0], -std::f64::consts::FRAC_PI_2);
            vec![RawShape { rotation, ..plain(2, 0, [r, half, 0.0]) }]
        }
        Form::Hull(k) => vec![plain(3, k as c_uint, [0.0; 3])],
        Form::Boxes(k) => scene.compounds[k]
            .iter()
            .map(|p| RawShape { position: p.position, rotation: p.rotation, ..plain(0, 0, p.half) })
            .collect(),
    }
}

/// A place in the body's frame, in that of its mass.
fn inner(solid: &Solid, position: V3, rotation: Q4) -> (V3, Q4) {
    let back = conjugate(solid.axes);
    (rotate(back, sub(position, solid.centre)), times(back, rotation))
}

fn raw_joint(joint: &Joint, solids: &[Solid]) -> RawJoint {
    let (kind, length, spring) = match joint.hold {
        Hold::Ball => (0, 0.0, None),
        Hold::Hinge => (1, 0.0, None),
        Hold::Slider(spring) => (2, 0.0, spring),
        Hold::Weld => (3, 0.0, None),
        Hold::Rod(length) => (4, length, None),
        Hold::Spring(length, spring) => (5, length, Some(spring)),
    };
    let ends = [0, 1].map(|k| inner(&solids[joint.bodies[k]], joint.local[k], joint.axes[k]));
    RawJoint {
        kind,
        springs: spring.is_some().into(),
        bodies: joint.bodies.map(|b| b as c_uint),
        position: ends.map(|e| e.0),
        rotation: ends.map(|e| e.1),
        length,
        stiffness: spring.map_or(0.0, |s| s.stiffness()),
        damping: spring.map_or(0.0, |s| s.damping()),
    }
}

impl Shim {
    /// A world, with the places of the method's solver and integrator in the engine's lists.
    pub fn new(
        functions: &'static Functions,
        scene: &Scene,
        setting: &Setting,
        [solver, integrator]: [usize; 2],
    ) -> Result<Self, String> {
        if setting.accuracy.is_some() {
            return Err("it has no such setting".into());
        }
        let hulls = Hulls::new(scene)?;
        let solids: Vec<Solid> = scene.bodies.iter().map(|b| solid(scene, &hulls.hulls, b)).collect();
        let (mut raw_shapes, mut raw_bodies) = (Vec::new(), Vec::new());
        for (body, solid) in scene.bodies.iter().zip(&solids) {
            let first_shape = raw_shapes.len() as c_uint;
            raw_shapes.extend(shapes(scene, body).into_iter().map(|s| {
                let (position, rotation) = inner(solid, s.position, s.rotation);
                RawShape { position, rotation, ..s }
            }));
            raw_bodies.push(RawBody {
                kind: body.kind as c_int,
                first_shape,
                shape_count: raw_shapes.len() as c_uint - first_shape,
                collides: body.collides.into(),
                position: add(body.position, rotate(body.rotation, solid.centre)),
                rotation: times(body.rotation, solid.axes),
                velocity: body.velocity,
                spin: body.spin,
                mass: solid.mass,
                inertia: solid.inertia,
                friction: body.friction,
                restitution: body.restitution,
            });
        }
        let raw_joints: Vec<RawJoint> = scene.joints.iter().map(|j| raw_joint(j, &solids)).collect();
        let raw_hulls = hulls.raw();
        let raw = RawScene {
            gravity: scene.gravity,
            restitution_threshold: scene.restitution_threshold.unwrap_or(-1.0),
            sleeps: scene.sleep.into(),
            hull_count: raw_hulls.len() as c_uint,
            shape_count: raw_shapes.len() as c_uint,
            body_count: raw_bodies.len() as c_uint,
            joint_count: raw_joints.len() as c_uint,
            hulls: raw_hulls.as_ptr(),
            shapes: raw_shapes.as_ptr(),
            bodies: raw_bodies.as_ptr(),
            joints: raw_joints.as_ptr(),
        };
        let raw_setting = RawSetting {
            dt: setting.dt() / f64::from(setting.sub_steps),
            sub_steps: setting.sub_steps,
            iterations: setting.iterations,
            solver: solver as c_int,
            integrator: integrator as c_int,
        };
        let mut why = [0_u8; 256];
        // SAFETY: all pointers are to live values of the lengths given; hulls live as long as the world; the shim ends
        // `why` with a zero within its length.
        let world = unsafe {
            (functions.create)(
                &raw const raw,
                &raw const raw_setting,
                why.as_mut_ptr().cast(),
                why.len() as c_uint,
            )
        };
        let Some(world) = NonNull::new(world) else {
            let text = CStr::from_bytes_until_nul(&why).map_or("".into(), |s| s.to_string_lossy());
            return Err(text.into_owned());
        };
        let of_kind = |i: &usize| scene.bodies[*i].kind == Kind::Dynamic;
        Ok(Self {
            functions,
            world,
            dynamic: (0..scene.bodies.len()).filter(of_kind).collect(),
            raw: vec![RawMotion::default(); solids.len()].into(),
            offsets: scene.bodies.iter().zip(&solids).map(|(b, s)| sub(s.centre, b.center())).collect(),
            solids,
            _hulls: hulls,
        })
    }

    /// Where all bodies are, as the engine has them.
    fn read(&self) -> std::cell::RefMut<'_, Vec<RawMotion>> {
        let mut raw = self.raw.borrow_mut();
        // SAFETY: the world lives as long as self; there is one motion for each body.
        unsafe { (self.functions.motions)(self.world.as_ptr(), raw.as_mut_ptr()) };
        raw
    }
}

impl Engine for Shim {
    fn step(&mut self) {
        // SAFETY: the world lives as long as self.
        unsafe { (self.functions.step)(self.world.as_ptr()) }
    }

    fn push(&mut self, body: usize, force: V3, point: V3) {
        let torque = cross(sub(point, self.read()[body].position), force);
        // SAFETY: the world lives as long as self, and has a body of this index.
        unsafe {
            (self.functions.push)(self.world.as_ptr(), body as c_uint, force.as_ptr(), torque.as_ptr());
        }
    }

    fn motions(&self, out: &mut Vec<Motion>) {
        let raw = self.read();
        out.clear();
        out.extend(self.dynamic.iter().map(|&i| {
            let (m, solid) = (&raw[i], &self.solids[i]);
            let rotation = times(m.rotation, conjugate(solid.axes));
            Motion {
                position: sub(m.position, rotate(unit(rotation), self.offsets[i])),
                rotation,
                velocity: m.velocity,
                spin: m.spin,
            }
        }));
    }

    fn is_broken(&self) -> bool {
        // SAFETY: the world lives as long as self.
        unsafe { (self.functions.is_broken)(self.world.as_ptr()) != 0 }
    }
}

impl Drop for Shim {
    fn drop(&mut self) {
        // SAFETY: the world is destroyed once, and nothing uses it afterwards.
        unsafe { (self.functions.destroy)(self.world.as_ptr()) }
    }
}

/// The places of a method's solver and integrator in an engine's lists.
fn places(method: &Method, solvers: &[&str], integrators: &[&str]) -> Result<[usize; 2], String> {
    let find = |list: &[&str], name: &str| {
        list.iter().position(|n| *n == name).ok_or_else(|| format!("it has no {name}"))
    };
    Ok([find(solvers, method.solver)?, find(integrators, method.integrator)?])
}

#[cfg(test)]
mod tests;
