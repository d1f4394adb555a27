//! Runs as charts take them: one point a setting, with values that can be drawn.

use crate::records::{Outcome, WorkPrecision};
use std::collections::BTreeMap;

/// Errors below this are drawn and compared as this: nobody asks for less, and a logarithm of 0 has no place.
pub const FLOOR: f64 = 1e-12;

/// A setting of an engine in a scene. A scene that was run upright and turned as a whole counts with the worse of
/// the two, so that no engine gains from axes that happen to fit.
#[derive(Clone, Debug)]
pub struct Setting {
    pub scene: String,
    pub engine: String,
    pub method: String,
    pub precision: String,
    pub rate_hz: f64,
    pub sub_steps: u32,
    pub iterations: u32,
    pub accuracy: Option<f64>,
    /// The setting as it comes, of this method.
    pub is_default: bool,
    /// The engine as it comes: the default setting of its default method.
    pub as_it_comes: bool,
    pub outcome: Outcome,
    /// Finite and not negative; there only if all runs ended well.
    pub error: Option<f64>,
    /// CPU milliseconds for a simulated second; finite and above 0.
    pub cost_ms: Option<f64>,
    /// How many runs were taken together.
    pub runs: usize,
}

impl Setting {
    /// Cost and error, where both are known. The error is at least [`FLOOR`].
    pub fn point(&self) -> Option<(f64, f64)> {
        Some((self.cost_ms?, self.error?.max(FLOOR)))
    }

    /// The step that a method sees \[s\].
    pub fn step(&self) -> f64 {
        1.0 / (self.rate_hz * f64::from(self.sub_steps.max(1)))
    }

    /// In words, as a reader would set it.
    pub fn words(&self) -> String {
        let mut text = format!("{} Hz × {}", self.rate_hz, self.sub_steps);
        if self.iterations > 0 {
            text += &format!(" × {} sweeps", self.iterations);
        }
        if let Some(accuracy) = self.accuracy {
            text += &format!(", accuracy {accuracy:e}");
        }
        text
    }

    fn new(row: &WorkPrecision) -> Self {
        let error = row.error.filter(|e| e.is_finite() && *e >= 0.0);
        // A run that says it went well and has no error to show did not go well.
        let outcome = if row.outcome == Outcome::Ok && error.is_none() { Outcome::Nan } else { row.outcome };
        Self {
            scene: row.scene.clone(),
            engine: row.engine.clone(),
            method: row.method.clone(),
            precision: row.precision.clone(),
            rate_hz: row.rate_hz,
            sub_steps: row.sub_steps,
            iterations: row.iterations,
            accuracy: row.accuracy,
            is_default: row.is_default != 0,
            as_it_comes: false,
            outcome,
            error: error.filter(|_| outcome == Outcome::Ok),
            cost_ms: row.cost_ms.filter(|c| c.is_finite() && *c > 0.0),
            runs: 1,
        }
    }

    fn join(&mut self, other: Self) {
        if self.outcome == Outcome::Ok {
            self.outcome = other.outcome;
        }
        self.error = self.error.zip(other.error).map(|(a, b)| a.max(b));
        self.cost_ms = match (self.cost_ms, other.cost_ms) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        };
        self.is_default |= other.is_default;
        self.runs += 1;
    }
}

/// The settings of all runs, in the order in which they first appear.
pub fn settings(rows: &[WorkPrecision]) -> Vec<Setting> {
    let mut all: Vec<Setting> = Vec::new();
    let mut places = BTreeMap::new();
    for row in rows {
        let key = key(row);
        let setting = Setting::new(row);
        match places.get(&key) {
            Some(&at) => {
                let known: &mut Setting = &mut all[at];
                known.join(setting);
            }
            None => {
                places.insert(key, all.len());
                all.push(setting);
            }
        }
    }
    // Each method has a default setting; the engine's own method is the first that is run.
    let mut seen = BTreeMap::new();
    for setting in all.iter_mut().filter(|s| s.is_default) {
        let place = (setting.scene.clone(), setting.engine.clone(), setting.precision.clone());
        let first = seen.entry(place).or_insert_with(|| setting.method.clone());
        setting.as_it_comes = *first == setting.method;
    }
    all
}

fn key(row: &WorkPrecision) -> String {
    let WorkPrecision { scene, engine, method, precision, rate_hz, sub_steps, iterations, accuracy, .. } =
        row;
    format!("{scene}|{engine}|{method}|{precision}|{rate_hz:?}|{sub_steps}|{iterations}|{accuracy:?}")
}

/// Names in the order in which they first appear, each once.
pub fn distinct<'a>(names: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for name in names {
        if !all.iter().any(|known| known == name) {
            all.push(name.to_owned());
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::show::samples::run;

    #[test]
    fn the_worse_of_two_orientations_counts() {
        let mut rows = vec![run("s", "merev", 60.0, 1.0, 1e-3); 2];
        rows[1].turned = 1;
        rows[1].error = Some(4e-3);
        rows[1].cost_ms = Some(0.5);
        let all = settings(&rows);
        assert_eq!(all.len(), 1);
        assert_eq!(all[0].point(), Some((1.0, 4e-3)));
        rows[1].outcome = Outcome::Exploded;
        let all = settings(&rows);
        assert_eq!((all[0].outcome, all[0].point()), (Outcome::Exploded, None));
    }

    #[test]
    fn an_engine_comes_with_one_method() {
        let mut rows = vec![run("s", "merev", 60.0, 1.0, 1e-3); 2];
        rows[1].method = "lemke".into();
        let all = settings(&rows);
        assert_eq!([all[0].as_it_comes, all[1].as_it_comes], [true, false]);
        assert!(all[0].is_default && all[1].is_default);
    }

    #[test]
    fn what_cannot_be_drawn_has_no_point() {
        for error in [None, Some(f64::NAN), Some(f64::INFINITY), Some(-1.0)] {
            let row = WorkPrecision { error, ..run("s", "merev", 60.0, 1.0, 1.0) };
            let all = settings(&[row]);
            assert_eq!((all[0].outcome, all[0].point()), (Outcome::Nan, None), "{error:?}");
        }
        for cost_ms in [None, Some(f64::NAN), Some(0.0)] {
            let row = WorkPrecision { cost_ms, ..run("s", "merev", 60.0, 1.0, 1.0) };
            assert_eq!(settings(&[row])[0].point(), None, "{cost_ms:?}");
        }
        let row = run("s", "merev", 60.0, 2.0, 0.0);
        assert_eq!(settings(&[row])[0].point(), Some((2.0, FLOOR)));
    }
}
