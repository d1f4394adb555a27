//! Bullet, as the system has it installed, in single precision.

use super::{Shim, places};
use crate::engines::{Method, Setting};
use crate::scene::Scene;

shim!(bullet_create bullet_step bullet_push bullet_motions bullet_is_broken bullet_destroy bullet_version);

const SOLVERS: [&str; 3] = ["sequential_impulse", "nncg", "mlcp_dantzig"];

/// Its sweeps first, then its other solvers.
pub fn methods() -> Vec<Method> {
    let method = |k: usize| Method { solver: SOLVERS[k], integrator: "", iterates: k < 2 };
    (0..SOLVERS.len()).map(method).collect()
}

pub fn build(scene: &Scene, method: &Method, setting: &Setting) -> Result<Shim, String> {
    if setting.iterations > 0 && !method.iterates {
        return Err("it does not iterate".into());
    }
    Shim::new(&FUNCTIONS, scene, setting, places(method, &SOLVERS, &[""])?)
}
