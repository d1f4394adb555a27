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

/// Who takes part in comparisons over all scenes: an engine with its own method, or with the best of all its methods.
#[derive(Clone, Debug, PartialEq)]
pub struct Entrant {
    pub engine: String,
    /// How many methods it may choose from, scene by scene; nothing: its own alone.
    pub choice: Option<usize>,
}

impl Entrant {
    pub fn name(&self) -> String {
        let title = palette::title(&self.engine);
        self.choice.map_or(title.clone(), |n| format!("{title}, best of {n} methods"))
    }
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

    /// Who takes part. To choose the best of many methods for each scene takes knowledge that nobody has beforehand,
    /// so that stands beside the engine as it comes, not in its place. merev called through C computes the same as
    /// through Rust, and is run as it comes only; it is left out where merev is there.
    pub fn entrants(&self) -> Vec<Entrant> {
        let engines = self.engines();
        let has_merev = engines.iter().any(|e| e == "merev");
        let mut all = Vec::new();
        for engine in engines.into_iter().filter(|e| !(has_merev && e == "merev_c")) {
            let methods =
                distinct(self.settings.iter().filter(|s| s.engine == engine).map(|s| s.method.as_str()));
            all.push(Entrant { engine: engine.clone(), choice: None });
            if methods.len() > 1 {
                all.push(Entrant { engine, choice: Some(methods.len()) });
            }
        }
        all
    }

    /// The method that an engine comes with; nothing if no run says so.
    fn own_method(&self, engine: &str) -> Option<&str> {
        self.settings.iter().find(|s| s.engine == engine && s.as_it_comes).map(|s| s.method.as_str())
    }

    /// The front of an entrant in a scene.
    pub fn front_of(&self, scene: &str, entrant: &Entrant) -> Vec<(f64, f64)> {
        let own = if entrant.choice.is_some() { None } else { self.own_method(&entrant.engine) };
        let chosen = self.settings.iter().filter(|s| {
            s.scene == scene && s.engine == entrant.engine && own.is_none_or(|method| s.method == method)
        });
        pareto::front(chosen.filter_map(Setting::point))
    }

    /// For each scene the cost at which each of the entrants reaches a tolerance.
    pub fn costs(&self, entrants: &[Entrant], tolerance: f64) -> Vec<Vec<Option<f64>>> {
        let cost = |scene: &str, e: &Entrant| pareto::cost_of(&self.front_of(scene, e), tolerance);
        self.scenes_run().map(|s| entrants.iter().map(|e| cost(&s.scene, e)).collect()).collect()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::show::report::sample;
    use crate::show::samples::run;

    #[test]
    fn nobody_is_given_the_best_method_unasked() {
        let mut rows = vec![run("s", "merev", 60.0, 1.0, 1e-2), run("s", "merev_c", 60.0, 1.0, 1e-2)];
        rows.push(WorkPrecision { method: "lemke".into(), ..run("s", "merev", 60.0, 0.5, 1e-4) });
        rows.push(run("s", "box3d", 60.0, 2.0, 1e-2));
        let data = Data { scenes: vec![unknown(&rows[0])], settings: settings(&rows), ..sample() };
        let entrants = data.entrants();
        let names: Vec<String> = entrants.iter().map(Entrant::name).collect();
        assert_eq!(names, ["merev", "merev, best of 2 methods", "Box3D"]);
        assert_eq!(data.costs(&entrants, 1e-2), [[Some(1.0), Some(0.5), Some(2.0)]]);
        assert_eq!(data.costs(&entrants, 1e-3), [[None, Some(0.5), None]]);
    }

    #[test]
    fn what_all_refuse_is_no_scene_to_count() {
        let mut rows = vec![run("s", "merev", 60.0, 1.0, 1e-2), run("t", "merev", 60.0, 1.0, 1e-2)];
        rows[1].outcome = records::Outcome::Refused;
        let scenes = rows.iter().map(unknown).collect();
        let data = Data { scenes, settings: settings(&rows), ..sample() };
        assert_eq!(data.scenes_run().count(), 1);
    }
}
