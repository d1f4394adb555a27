//! Small records that are made up, for tests alone.

use crate::records::{Outcome, SceneRow, WorkPrecision};

/// A run with a default setting but for the rate.
pub fn run(scene: &str, engine: &str, rate_hz: f64, cost_ms: f64, error: f64) -> WorkPrecision {
    WorkPrecision {
        scene: scene.into(),
        group: "A".into(),
        engine: engine.into(),
        method: "soft_step".into(),
        precision: "f32".into(),
        turned: 0,
        rate_hz,
        sub_steps: 4,
        iterations: 0,
        accuracy: None,
        is_default: u8::from(rate_hz == 60.0),
        outcome: Outcome::Ok,
        error: Some(error),
        cost_ms: Some(cost_ms),
        resumed: 0,
    }
}

/// A scene that fits.
pub fn scene(name: &str) -> SceneRow {
    SceneRow {
        scene: name.into(),
        group: "A".into(),
        about: "made up".into(),
        reference: "closed form".into(),
        primary: "distance from the closed form over the scale".into(),
        scale: 1.0,
        scale_unit: "m".into(),
        null_error: Some(1.0),
        duration_s: 10.0,
    }
}
