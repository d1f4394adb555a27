//! MuJoCo, as its Python wheel brings it.

use super::{Shim, places};
use crate::engines::{Method, Setting};
use crate::scene::Scene;

shim!(mujoco_create mujoco_step mujoco_push mujoco_motions mujoco_is_broken mujoco_destroy mujoco_version);

const SOLVERS: [&str; 3] = ["newton", "pgs", "cg"];
const INTEGRATORS: [&str; 3] = ["implicitfast", "rk4", "euler"];

/// Its Newton solver first, then the other solvers, then the other integrators.
pub fn methods() -> Vec<Method> {
    let method = |solver: usize, integrator: usize| Method {
        solver: SOLVERS[solver],
        integrator: INTEGRATORS[integrator],
        iterates: solver > 0,
    };
    vec![method(0, 0), method(1, 0), method(2, 0), method(0, 1), method(0, 2)]
}

pub fn build(scene: &Scene, method: &Method, setting: &Setting) -> Result<Shim, String> {
    if setting.iterations > 0 && !method.iterates {
        return Err("it ends when it has found the minimum".into());
    }
    Shim::new(&FUNCTIONS, scene, setting, places(method, &SOLVERS, &INTEGRATORS)?)
}
