//! Where merev wins and where it loses, said plainly from the records.

use super::axis::short;
use super::data::{Data, Entrant};
use super::palette::title;
use super::pareto;
use super::settings::Setting;
use crate::records::{Outcome, Race, Stability};

/// Whether an engine is merev, called through Rust or through C.
pub fn is_ours(engine: &str) -> bool {
    engine == "merev" || engine == "merev_c"
}

/// Factors up to this are no difference.
const EVEN: f64 = 1.05;

/// A scene, stressor or race in which merev was held against others.
#[derive(Clone, Debug, PartialEq)]
pub struct Duel {
    pub what: String,
    /// The best of the others.
    pub rival: String,
    /// How many times better merev is than that rival; below 1 it is worse. Infinite or 0 where only one of them
    /// got there at all.
    pub factor: f64,
}

impl Duel {
    pub fn is_lost(&self) -> bool {
        self.factor < 1.0 / EVEN
    }

    /// Whether the two differ by no more than times do from run to run.
    pub fn is_even(&self) -> bool {
        (1.0 / EVEN..=EVEN).contains(&self.factor)
    }

    /// The rival, and by how much.
    pub fn words(&self) -> String {
        let (name, rival) = (&self.what, title(&self.rival));
        if self.factor == 0.0 {
            format!("{name} (only {rival} gets there)")
        } else if self.is_even() {
            format!("{name} (even with {rival})")
        } else if self.factor == f64::INFINITY {
            format!("{name} (no other gets there)")
        } else {
            let factor = if self.is_lost() { 1.0 / self.factor } else { self.factor };
            let word = if self.is_lost() { "ahead" } else { "behind" };
            format!("{name} ({rival} {word} by {}×)", short(factor))
        }
    }
}

/// Of several (engine, value), less being better: ours and the best of the others.
fn duel(what: &str, values: impl IntoIterator<Item = (String, Option<f64>)>) -> Option<Duel> {
    let (mut ours, mut other, mut rivals) = (f64::INFINITY, (f64::INFINITY, String::new()), 0);
    for (engine, value) in values {
        let value = value.filter(|v| v.is_finite() && *v > 0.0).unwrap_or(f64::INFINITY);
        if is_ours(&engine) {
            ours = ours.min(value);
        } else {
            rivals += 1;
            if value < other.0 {
                other = (value, engine);
            }
        }
    }
    if rivals == 0 || (ours == f64::INFINITY && other.0 == f64::INFINITY) {
        return None;
    }
    let factor = if ours == f64::INFINITY { 0.0 } else { other.0 / ours };
    Some(Duel { what: what.to_owned(), rival: other.1, factor })
}

/// Who reaches a tolerance more cheaply, scene by scene, each with the method it comes with. Scenes that nobody else
/// was run on, or that nobody solves, are left out.
pub fn precision(data: &Data, tolerance: f64) -> Vec<Duel> {
    each(data, |scene, entrant| pareto::cost_of(&data.front_of(scene, entrant), tolerance))
}

/// Errors below this are round-off of single precision: who is less wrong then is chance.
const EXACT: f64 = 1e-6;

/// Who is more exact as it comes, whatever it costs.
pub fn defaults(data: &Data) -> Vec<Duel> {
    each(data, |scene, entrant| {
        let own = |s: &&Setting| s.scene == scene && s.engine == entrant.engine && s.as_it_comes;
        data.settings.iter().filter(own).filter_map(|s| s.error).map(|e| e.max(EXACT)).reduce(f64::min)
    })
}

/// A duel for each scene, of a value of each engine that was run on it.
fn each(data: &Data, value: impl Fn(&str, &Entrant) -> Option<f64>) -> Vec<Duel> {
    let entrants: Vec<Entrant> = data.entrants().into_iter().filter(|e| e.choice.is_none()).collect();
    let took_part = |scene: &str, e: &Entrant| {
        let own = |s: &Setting| s.scene == scene && s.engine == e.engine && s.outcome != Outcome::Refused;
        data.settings.iter().any(own)
    };
    let values = |scene: &str| -> Vec<(String, Option<f64>)> {
        let part = entrants.iter().filter(|e| took_part(scene, e));
        part.map(|e| (e.engine.clone(), value(scene, e))).collect()
    };
    data.scenes_run().filter_map(|scene| duel(&scene.scene, values(&scene.scene))).collect()
}

/// Who takes less time in the races.
pub fn races(rows: &[Race]) -> Vec<Duel> {
    let scenes = super::settings::distinct(rows.iter().map(|r| r.scene.as_str()));
    let times = |scene: &String| {
        let own: Vec<_> = rows.iter().filter(|r| r.scene == *scene).collect();
        let there = own.into_iter().filter(|r| r.median_ms.is_finite());
        duel(scene, there.map(|r| (r.engine.clone(), Some(r.median_ms))))
    };
    scenes.iter().filter_map(times).collect()
}

/// Who bears more of a stressor, taking the best method of each engine.
pub fn stressors(rows: &[Stability]) -> Vec<Duel> {
    let name = |r: &Stability| format!("{}: {}", r.scene, r.stressor);
    let names: Vec<String> = rows.iter().map(name).collect();
    let bear = |r: &Stability| {
        let value = r.survived.filter(|v| v.is_finite() && *v > 0.0);
        (r.engine.clone(), value.map(|v| if r.harder == "smaller" { v } else { 1.0 / v }))
    };
    let all = super::settings::distinct(names.iter().map(String::as_str));
    all.iter().filter_map(|what| duel(what, rows.iter().filter(|r| name(r) == *what).map(bear))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stability(engine: &str, method: &str, harder: &str, survived: Option<f64>) -> Stability {
        Stability {
            scene: "stack".into(),
            engine: engine.into(),
            method: method.into(),
            stressor: harder.into(),
            unit: String::new(),
            harder: harder.into(),
            survived,
            failed: None,
            outcome: Outcome::Ok,
        }
    }

    #[test]
    fn the_best_method_of_each_side_fights() {
        let rows = [
            stability("merev", "a", "larger", Some(10.0)),
            stability("merev", "b", "larger", Some(40.0)),
            stability("box3d", "c", "larger", Some(80.0)),
            stability("rapier", "d", "larger", None),
            stability("merev", "a", "smaller", Some(0.1)),
            stability("box3d", "c", "smaller", Some(0.3)),
        ];
        let duels = stressors(&rows);
        assert_eq!(duels.len(), 2);
        assert!(duels[0].is_lost() && (duels[0].factor - 0.5).abs() < 1e-12, "{duels:?}");
        assert_eq!(duels[0].words(), "stack: larger (Box3D ahead by 2×)");
        assert!(!duels[1].is_lost() && (duels[1].factor - 3.0).abs() < 1e-12);
    }

    #[test]
    fn who_alone_gets_there_wins() {
        let both = |ours, other| duel("s", [("merev".into(), ours), ("ode".into(), other)]);
        assert_eq!(both(None, None), None);
        assert_eq!(both(Some(1.0), None).unwrap().words(), "s (no other gets there)");
        assert_eq!(both(None, Some(1.0)).unwrap().words(), "s (only ODE gets there)");
        assert_eq!(both(Some(f64::NAN), Some(1.0)).unwrap().factor, 0.0);
        assert_eq!(duel("s", [("merev".into(), Some(1.0)), ("merev_c".into(), Some(2.0))]), None);
    }
}
