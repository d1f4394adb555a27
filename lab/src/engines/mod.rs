//! Engines behind one contract, so that a scene runs on each of them with the same settings.
//!
//! To add one, write its adapter in a file of its own and list it in [`ALL`]. Rules of fairness: bodies and
//! shapes exactly as the scene says, events off, one thread, damping off, speed clamps as high as they go, the
//! restitution threshold of the scene.

#[cfg(feature = "peers")]
mod box3d;
pub mod merev;

use crate::scene::Scene;

/// Where a dynamic body is and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// [m]
    pub position: [f32; 3],
    /// x, y, z, w.
    pub rotation: [f32; 4],
    /// Of the centre of mass [m/s].
    pub velocity: [f32; 3],
    /// [rad/s], world axes.
    pub spin: [f32; 3],
}

/// A world in some engine.
pub trait Engine {
    /// Moves the world by one step of the scene.
    fn step(&mut self);
    /// Fills `out` with the dynamic bodies, in the scene's order.
    fn motions(&self, out: &mut Vec<Motion>);
    /// What the stages of the last step took, as the engine itself tells it \[ms\]; always the same stages.
    fn stages(&self) -> Vec<(&'static str, f32)>;
}

/// An engine that can build scenes.
#[derive(Clone, Copy)]
pub struct Maker {
    pub name: &'static str,
    pub build: fn(&Scene) -> Box<dyn Engine>,
}

/// The engines that were built in; ours comes first.
pub const ALL: &[Maker] = &[
    Maker { name: "merev", build: |scene| Box::new(merev::Merev::new(scene)) },
    #[cfg(feature = "peers")]
    Maker { name: "Box3D", build: |scene| Box::new(box3d::Box3d::new(scene)) },
];
