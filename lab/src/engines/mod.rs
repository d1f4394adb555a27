//! Engines behind one contract, so that a scene runs on each of them with the same settings.
//!
//! To add one, write its adapter in a file of its own and list it in [`ALL`]. Rules of fairness: bodies and
//! shapes exactly as the scene says, events off, one thread, damping off, speed clamps as high as they go, the
//! restitution threshold of the scene, friction and restitution of a pair as the scene has them after mixing.

#[cfg(feature = "peers")]
mod box3d;
pub mod merev;
mod merev_c;
#[cfg(feature = "peers")]
mod rapier;
#[cfg(any(feature = "ode", feature = "mujoco", feature = "bullet"))]
mod shim;

use crate::scene::{Body, Kind, Scene};
use crate::vector::{Q4, V3, add, rotate};

/// Where a dynamic body is and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Of the centre of mass [m].
    pub position: V3,
    /// x, y, z, w.
    pub rotation: Q4,
    /// Of the centre of mass [m/s].
    pub velocity: V3,
    /// [rad/s], world axes.
    pub spin: V3,
}

impl Motion {
    /// As the scene has it at the start.
    pub fn of(body: &Body) -> Self {
        let Body { position, rotation, velocity, spin, .. } = *body;
        let center =
            if body.has_offset() { add(position, rotate(rotation, body.center())) } else { position };
        Self { position: center, rotation, velocity, spin }
    }

    /// Of all dynamic bodies at the start.
    pub fn start(scene: &Scene) -> Vec<Self> {
        scene.bodies.iter().filter(|b| b.kind == Kind::Dynamic).map(Self::of).collect()
    }
}

/// A world in some engine.
pub trait Engine {
    /// Moves the world by one step of the scene.
    fn step(&mut self);
    /// Puts a force \[N\] on a body of the scene at a world point \[m\], for the next step.
    fn push(&mut self, body: usize, force: V3, point: V3);
    /// Fills `out` with the dynamic bodies, in the scene's order.
    fn motions(&self, out: &mut Vec<Motion>);
    /// What the stages of the last step took, as the engine itself tells it \[ms\]; always the same stages.
    fn stages(&self) -> Vec<(&'static str, f32)> {
        Vec::new()
    }
    /// The greatest error of the contact solver in the last step \[m/s\], where the engine tells it.
    fn residual(&self) -> Option<f64> {
        None
    }
    /// Whether the engine itself has noticed that its state is not finite, and put bodies away.
    fn is_broken(&self) -> bool {
        false
    }
}

/// How to step a scene: a point of the work–precision plots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Steps a second.
    pub rate: f64,
    pub sub_steps: u32,
    /// Sweeps a sub-step; 0 is the method's own number.
    pub iterations: u32,
    /// The engine's accuracy knob.
    pub accuracy: Option<f64>,
}

impl Setting {
    pub fn new(rate: f64, sub_steps: u32) -> Self {
        Self { rate, sub_steps, iterations: 0, accuracy: None }
    }

    /// That of a scene of the race.
    pub fn of(scene: &Scene) -> Self {
        Self::new(1.0 / scene.dt, scene.sub_steps)
    }

    pub fn dt(&self) -> f64 {
        1.0 / self.rate
    }
}

/// A way of an engine to solve and to integrate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Method {
    /// As the engine calls it.
    pub solver: &'static str,
    /// As the engine calls it; empty where it has one only.
    pub integrator: &'static str,
    /// Whether it sweeps, so that a number of iterations means something.
    pub iterates: bool,
}

impl Method {
    pub fn name(&self) -> String {
        if self.integrator.is_empty() {
            self.solver.to_string()
        } else {
            format!("{}/{}", self.solver, self.integrator)
        }
    }
}

/// Builds a world, or says why not.
pub type Build = fn(&Scene, &Method, &Setting) -> Result<Box<dyn Engine>, String>;

/// An engine that can build scenes.
#[derive(Clone, Copy)]
pub struct Maker {
    /// As tables call it.
    pub name: &'static str,
    /// As files call it.
    pub key: &'static str,
    /// f32 or f64.
    pub precision: &'static str,
    /// What it comes with first, then the others.
    pub methods: fn() -> Vec<Method>,
    /// Builds a world, or says why not.
    pub build: Build,
}

impl Maker {
    /// A world of a scene of the race: the engine's own method, the scene's steps.
    ///
    /// # Errors
    /// Why the engine refuses the scene.
    pub fn race(&self, scene: &Scene) -> Result<Box<dyn Engine>, String> {
        (self.build)(scene, &(self.methods)()[0], &Setting::of(scene))
    }
}

/// The engines that were built in; ours comes first.
pub const ALL: &[Maker] = &[
    Maker {
        name: "merev",
        key: "merev",
        precision: merev::PRECISION,
        methods: merev::methods,
        build: |scene, method, setting| Ok(Box::new(merev::Merev::new(scene, method, setting)?)),
    },
    Maker {
        name: "merev (C)",
        key: "merev_c",
        precision: merev::PRECISION,
        methods: merev_c::methods,
        build: |scene, method, setting| Ok(Box::new(merev_c::MerevC::new(scene, method, setting)?)),
    },
    #[cfg(feature = "peers")]
    Maker {
        name: "Box3D",
        key: "box3d",
        precision: "f32",
        methods: box3d::methods,
        build: |scene, _, setting| Ok(Box::new(box3d::Box3d::new(scene, setting)?)),
    },
    #[cfg(feature = "peers")]
    Maker {
        name: "Rapier",
        key: "rapier",
        precision: "f32",
        methods: rapier::methods,
        build: |scene, _, setting| Ok(Box::new(rapier::Rapier::new(scene, setting)?)),
    },
    #[cfg(feature = "ode")]
    Maker {
        name: "ODE",
        key: "ode",
        precision: "f64",
        methods: shim::ode::methods,
        build: |scene, method, setting| Ok(Box::new(shim::ode::build(scene, method, setting)?)),
    },
    #[cfg(feature = "mujoco")]
    Maker {
        name: "MuJoCo",
        key: "mujoco",
        precision: "f64",
        methods: shim::mujoco::methods,
        build: |scene, method, setting| Ok(Box::new(shim::mujoco::build(scene, method, setting)?)),
    },
    #[cfg(feature = "bullet")]
    Maker {
        name: "Bullet",
        key: "bullet",
        precision: "f32",
        methods: shim::bullet::methods,
        build: |scene, method, setting| Ok(Box::new(shim::bullet::build(scene, method, setting)?)),
    },
];

/// Ours only, or all but those that are ours in another guise.
pub fn racers(peers: bool) -> Vec<Maker> {
    ALL.iter().copied().filter(|m| m.key == "merev" || peers && m.key != "merev_c").collect()
}

/// Version and licence of the engines that are libraries of the machine.
pub fn libraries() -> Vec<String> {
    #[allow(unused_mut, reason = "features add to it")]
    let mut all: Vec<String> = Vec::new();
    #[cfg(feature = "ode")]
    all.push(format!(
        "ODE {} (LGPL-2.1-or-later or BSD-3-Clause), as the system has it, f64",
        shim::version(&shim::ode::FUNCTIONS)
    ));
    #[cfg(feature = "mujoco")]
    all.push(format!(
        "MuJoCo {} (Apache-2.0), as its wheel has it, f64",
        shim::version(&shim::mujoco::FUNCTIONS)
    ));
    #[cfg(feature = "bullet")]
    all.push(format!("Bullet {} (Zlib), as the system has it, f32", shim::version(&shim::bullet::FUNCTIONS)));
    all
}

/// Whether any engine but ours was built in.
pub fn has_peers() -> bool {
    racers(true).len() > 1
}
