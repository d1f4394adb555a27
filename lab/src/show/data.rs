//! All that was measured, as it lies in a directory.

use super::palette;
use super::pareto;
use super::settings::{Setting, distinct, settings};
use crate::records::{self, Attribution, Check, Meta, Race, SceneRow, Secondary, Stability, WorkPrecision};
use std::path::Path;

pub struct Data {
    pub scenes: Vec<SceneRow>,
    pub settings: Vec<Setting>,
    pub secondary: Vec<Secondary>,
    pub attribution: Vec<Attribution>,
    pub stability: Vec<Stability>,
    pub race: Vec<Race>,
    pub checks: Vec<Check>,
    pub meta: Option<Meta>,
}

impl Data {
    /// Reads a directory. Files that are not there have no rows.
    ///
    /// # Errors
    /// A file that does not hold what it should.
    pub fn read(directory: &Path) -> Result<Self, String> {
        let runs: Vec<WorkPrecision> = records::read(directory)?;
        let mut scenes: Vec<SceneRow> = records::read(directory)?;
        // A scene whose row is missing must not vanish from the report.
        for run in &runs {
            if !scenes.iter().any(|s| s.scene == run.scene) {
                scenes.push(unknown(run));
            }
        }
        scenes.sort_by(|a, b| (&a.group, &a.scene).cmp(&(&b.group, &b.scene)));
        Ok(Self {
            scenes,
            settings: settings(&runs),
            secondary: records::read(directory)?,
            attribution: records::read(directory)?,
            stability: records::read(directory)?,
            race: records::read(directory)?,
            checks: records::read(directory)?,
            meta: Meta::read(directory),
        })
    }

    /// The engines of the work–precision runs that did run, in the order of legends.
    pub fn engines(&self) -> Vec<String> {
        let ran = self.settings.iter().filter(|s| s.outcome != records::Outcome::Refused);
        let mut engines = distinct(ran.map(|s| s.engine.as_str()));
        engines.sort_by(|a, b| palette::rank(a).cmp(&palette::rank(b)));
        engines
    }

    /// The settings of a scene, each with its number among all.
    pub fn settings_of(&self, scene: &str) -> Vec<(usize, &Setting)> {
        self.settings.iter().enumerate().filter(|(_, s)| s.scene == scene).collect()
    }

    /// The front of an engine in a scene, over all its methods, precisions and settings.
    pub fn front(&self, scene: &str, engine: &str) -> Vec<(f64, f64)> {
        let own = self.settings.iter().filter(|s| s.scene == scene && s.engine == engine);
        pareto::front(own.filter_map(Setting::point))
    }

    /// For each scene the cost at which each of the engines reaches a tolerance.
    pub fn costs(&self, engines: &[String], tolerance: f64) -> Vec<Vec<Option<f64>>> {
        let cost = |scene: &str, engine: &str| pareto::cost_of(&self.front(scene, engine), tolerance);
        self.scenes_run().map(|s| engines.iter().map(|e| cost(&s.scene, e)).collect()).collect()
    }

    /// The scenes that at least one engine was run on: what all engines refuse says nothing of any.
    pub fn scenes_run(&self) -> impl Iterator<Item = &SceneRow> {
        let ran = |scene: &&SceneRow| {
            self.settings.iter().any(|s| s.scene == scene.scene && s.outcome != records::Outcome::Refused)
        };
        self.scenes.iter().filter(ran)
    }
}

fn unknown(run: &WorkPrecision) -> SceneRow {
    SceneRow {
        scene: run.scene.clone(),
        group: run.group.clone(),
        about: "not described".into(),
        reference: "not described".into(),
        primary: "not described".into(),
        scale: 1.0,
        scale_unit: String::new(),
        null_error: None,
        duration_s: 0.0,
    }
}
