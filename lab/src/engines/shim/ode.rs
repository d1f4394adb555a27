//! ODE, as the system has it installed.

use super::{Shim, places};
use crate::engines::{Method, Setting};
use crate::scene::Scene;

shim!(ode_create ode_step ode_push ode_motions ode_is_broken ode_destroy ode_version);

const SOLVERS: [&str; 2] = ["quick_step", "world_step"];
const INTEGRATORS: [&str; 2] = ["", "finite_rotation"];

/// Sweeps, then Dantzig's pivots; then a rotation by the whole angle instead of a first-order one.
pub fn methods() -> Vec<Method> {
    let quick = Method { solver: SOLVERS[0], integrator: INTEGRATORS[0], iterates: true };
    vec![
        quick,
        Method { solver: SOLVERS[1], iterates: false, ..quick },
        Method { integrator: INTEGRATORS[1], ..quick },
    ]
}

pub fn build(scene: &Scene, method: &Method, setting: &Setting) -> Result<Shim, String> {
    if setting.iterations > 0 && !method.iterates {
        return Err("it does not iterate".into());
    }
    Shim::new(&FUNCTIONS, scene, setting, places(method, &SOLVERS, &INTEGRATORS)?)
}
