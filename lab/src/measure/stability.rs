//! Where methods fail: the hardest value of a stressor that a method survives, by bisection.

use super::workers::{self, Claims};
use super::{Options, ladder, meta, run as run_scene};
use crate::case::Track;
use crate::engines::{Maker, Method, Setting};
use crate::metrics::kinetic;
use crate::progress;
use crate::records::{Log, Outcome, Record, Stability, WITH_ACCURACY};
use crate::scene::{Body, Form, Scene};
use crate::scenes::{group_c, group_d, group_e, group_f_j};
use crate::table::Table;
use crate::vector::{norm, sub};
use indicatif::ProgressBar;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Something that is made harder until a method fails.
struct Stressor {
    scene: &'static str,
    name: &'static str,
    unit: &'static str,
    /// The mildest value and the hardest that is tried.
    range: [f64; 2],
    whole: bool,
    duration: f64,
    build: fn(f64) -> Scene,
    /// With which setting, where the stressor is one.
    setting: fn(f64) -> Setting,
    survives: fn(f64, &Scene, &Track) -> bool,
    /// Which methods it tells something about, beside the engine's first.
    tells: fn(&Method, &Method) -> bool,
}

fn as_it_comes(_: f64) -> Setting {
    ladder::default_setting()
}

fn upright(track: &Track, height: f64) -> bool {
    let top = |f: &[crate::engines::Motion]| f[f.len() - 1].position;
    norm(sub(top(track.first()), top(track.last()))) < height
}

fn stressors() -> Vec<Stressor> {
    let solver = |m: &Method, first: &Method| m.integrator == first.integrator;
    let integrator = |m: &Method, first: &Method| m.solver == first.solver;
    vec![
        Stressor {
            scene: "heavy_on_light",
            name: "mass ratio",
            unit: "1",
            range: [1.0, 1e6],
            whole: false,
            duration: 5.0,
            build: |r| group_d::tower("heavy_on_light", "", &[1.0, r]),
            setting: as_it_comes,
            survives: |_, _, track| upright(track, 0.1) && group_d::tower_overlap(track.last()) < 0.1,
            tells: solver,
        },
        Stressor {
            scene: "tower",
            name: "stack height",
            unit: "cubes",
            range: [2.0, 128.0],
            whole: true,
            duration: 10.0,
            build: |n| group_d::tower("tower", "", &vec![1000.0; n as usize]),
            setting: as_it_comes,
            survives: |n, _, track| upright(track, 0.05 * n.max(4.0)),
            tells: solver,
        },
        Stressor {
            scene: "hanging_chain",
            name: "chain length",
            unit: "links",
            range: [2.0, 128.0],
            whole: true,
            duration: 3.0,
            build: |n| group_e::hanging_scene("hanging_chain", "", n as usize, 100.0),
            setting: as_it_comes,
            survives: |n, _, track| group_e::stretch(track.last(), n as usize) < 0.02,
            tells: solver,
        },
        Stressor {
            scene: "loaded_chain",
            name: "mass ratio",
            unit: "1",
            range: [1.0, 1e6],
            whole: false,
            duration: 3.0,
            build: |r| group_e::hanging_scene("loaded_chain", "", 20, r),
            setting: as_it_comes,
            survives: |_, _, track| group_e::stretch(track.last(), 20) < 0.02,
            tells: solver,
        },
        Stressor {
            scene: "grip",
            name: "time step",
            unit: "ms",
            range: [1.0, 200.0],
            whole: false,
            duration: 1.0,
            build: |_| group_c::grip_scene(1.5 * group_c::GRIP),
            setting: |ms| Setting { rate: 1e3 / ms, ..ladder::default_setting() },
            survives: |_, _, track| group_c::grip_holds(track),
            tells: solver,
        },
        Stressor {
            scene: "tower_of_five",
            name: "time step",
            unit: "ms",
            range: [1.0, 200.0],
            whole: false,
            duration: 5.0,
            build: |_| group_d::tower("tower_of_five", "", &[1000.0; 5]),
            setting: |ms| Setting { rate: 1e3 / ms, ..ladder::default_setting() },
            survives: |_, _, track| upright(track, 0.25),
            tells: solver,
        },
        Stressor {
            scene: "bullets",
            name: "speed",
            unit: "m/s",
            range: [0.5, 1000.0],
            whole: false,
            duration: 0.25,
            build: |v| group_f_j::bullet_scene(v, false),
            setting: as_it_comes,
            survives: |_, _, track| group_f_j::tunnelled(track) == 0,
            tells: solver,
        },
        Stressor {
            scene: "far_stack",
            name: "distance from the origin",
            unit: "m",
            range: [10.0, 1e7],
            whole: false,
            duration: 5.0,
            build: group_f_j::far_stack_scene,
            setting: as_it_comes,
            survives: |_, _, track| upright(track, 0.02),
            tells: solver,
        },
        Stressor {
            scene: "plate",
            name: "aspect ratio",
            unit: "side / thickness",
            range: [2.0, 1e5],
            whole: false,
            duration: 2.0,
            build: |a| group_f_j::plate_scene(2.0 / a),
            setting: as_it_comes,
            survives: |a, _, track| (track.last()[0].position[1] - 1.0 / a).abs() < 1.0 / a,
            tells: solver,
        },
        Stressor {
            scene: "tumbling",
            name: "spin",
            unit: "rad/s",
            range: [0.5, 1e4],
            whole: false,
            duration: 3.0,
            build: spinning,
            setting: as_it_comes,
            survives: |_, scene, track| {
                let e = kinetic(scene, track.first());
                (kinetic(scene, track.last()) / e - 1.0).abs() < 0.1
            },
            tells: integrator,
        },
    ]
}

/// The box of A3, this fast.
fn spinning(w: f64) -> Scene {
    let mut scene = Scene::new("tumbling", "", 0);
    scene.gravity = [0.0; 3];
    scene.bodies.push(Body {
        spin: [0.02 * w, w, 0.02 * w],
        density: 10.0 / (0.1 * 0.4 * 0.9),
        ..Body::dynamic(Form::Box([0.05, 0.2, 0.45]), [0.0; 3])
    });
    scene
}

/// The hardest value that passed, the mildest that failed, and how.
fn search(search: &Search, options: &Options) -> (Option<f64>, Option<f64>, Outcome) {
    let Search { stressor: s, maker, method, accuracy } = search;
    let mut how = Outcome::Ok;
    let mut passes = |value: f64| {
        let scene = (s.build)(value);
        let budget = 2 * options.budget();
        let setting = Setting { accuracy: *accuracy, ..(s.setting)(value) };
        let ended = run_scene(maker, &scene, method, &setting, s.duration, false, budget);
        let ok = match &ended {
            Ok(run) => (s.survives)(value, &scene, &run.track),
            Err(_) => false,
        };
        if !ok {
            how = ended.err().unwrap_or(if s.name == "speed" { Outcome::Tunnelled } else { Outcome::Ok });
        }
        ok
    };
    let tidy = |x: f64| if s.whole { x.round() } else { x };
    let [mildest, hardest] = s.range;
    if !passes(mildest) {
        return (None, Some(mildest), how);
    }
    let (mut low, mut high, mut factor) = (mildest, None, 4.0);
    while low < hardest {
        let next = tidy((low * factor).min(hardest));
        if passes(next) {
            low = next;
        } else {
            high = Some(next);
            break;
        }
        factor = 4.0;
    }
    let Some(mut failed) = high else { return (Some(hardest), None, Outcome::Ok) };
    for _ in 0..if options.quick { 2 } else { 5 } {
        let middle = tidy((low * failed).sqrt());
        if middle <= low || middle >= failed {
            break;
        }
        if passes(middle) { low = middle } else { failed = middle }
    }
    (Some(low), Some(failed), how)
}

/// What is searched for: a stressor on a method.
struct Search {
    stressor: Rc<Stressor>,
    maker: Maker,
    method: Method,
    /// The sub-steps of the setting are then the least.
    accuracy: Option<f64>,
}

impl Search {
    fn row(&self) -> Stability {
        Stability {
            scene: self.stressor.scene.into(),
            engine: self.maker.key.into(),
            method: self.accuracy.map_or_else(
                || self.method.name(),
                |accuracy| format!("{}{WITH_ACCURACY}{accuracy}", self.method.solver),
            ),
            stressor: self.stressor.name.into(),
            unit: self.stressor.unit.into(),
            harder: "larger".into(),
            survived: None,
            failed: None,
            outcome: Outcome::Ok,
        }
    }
}

/// Everything there is to search for, in order.
fn searches(options: &Options) -> Vec<Search> {
    let mut all = Vec::new();
    for stressor in stressors().into_iter().filter(|s| options.wants(s.scene)) {
        let stressor = Rc::new(stressor);
        for maker in options.makers().into_iter().filter(|m| m.key != "merev_c") {
            let methods = (maker.methods)();
            for &method in methods.iter().filter(|m| (stressor.tells)(m, &methods[0])) {
                all.push(Search { stressor: stressor.clone(), maker, method, accuracy: None });
            }
            if maker.key == "merev" {
                all.push(Search {
                    stressor: stressor.clone(),
                    maker,
                    method: methods[0],
                    accuracy: Some(0.01),
                });
            }
        }
    }
    all
}

/// Searches what is not there yet.
///
/// # Errors
/// What the file system says.
pub fn run(options: &Options) -> Result<String, String> {
    let searches = searches(options);
    if options.worker.is_some() {
        return measure(options, &searches, &ProgressBar::hidden());
    }
    let log = Log::<Stability>::open(&options.directory, options.fresh)?;
    meta::write(options, "stability")?;
    let bar = progress::bar(searches.len() as u64, "stability");
    if options.jobs > 1 {
        let path = options.directory.join(Stability::FILE);
        let before = log.rows().len() as u64;
        let done = || workers::count(&path) - before;
        workers::run(options, "stability", log.is_resumed(), &bar, &done, &mut |key| {
            let found = searches.iter().find(|s| s.row().key() == key);
            let row = found.ok_or(format!("a worker died at {key}"))?.row();
            let mut log = Log::<Stability>::open(&options.directory, false)?;
            log.push(Stability { outcome: Outcome::Crashed, ..row })
        })?;
    } else {
        measure(options, &searches, &bar)?;
    }
    bar.finish_and_clear();
    let mut log = Log::<Stability>::open(&options.directory, false)?;
    let keys: BTreeMap<String, usize> =
        searches.iter().enumerate().map(|(k, s)| (s.row().key(), k)).collect();
    log.sort_by_key(|row| keys.get(&row.key()).copied().unwrap_or(usize::MAX))?;
    Ok(table(log.rows()))
}

/// Takes search after search until all are taken.
fn measure(options: &Options, searches: &[Search], bar: &ProgressBar) -> Result<String, String> {
    let mut log = Log::<Stability>::open(&options.directory, false)?;
    let claims = Claims::shared(options);
    for (unit, s) in searches.iter().enumerate() {
        bar.inc(1);
        let mut row = s.row();
        if log.contains(&row.key()) || claims.as_ref().is_some_and(|c| !c.take(unit)) {
            continue;
        }
        bar.set_message(s.stressor.scene);
        if let Some(claims) = &claims {
            claims.note(unit, &row.key());
        }
        (row.survived, row.failed, row.outcome) = search(s, options);
        log.push(row)?;
    }
    Ok(String::new())
}

fn table(rows: &[Stability]) -> String {
    let mut table = Table::new(&["scene", "stressor", "engine", "method", "survived", "failed", "how"]);
    for r in rows {
        let number = |x: Option<f64>| x.map_or("–".to_string(), |x| format!("{x:.4}"));
        table.row([
            r.scene.clone(),
            format!("{} [{}]", r.stressor, r.unit),
            r.engine.clone(),
            r.method.clone(),
            number(r.survived),
            number(r.failed),
            r.outcome.name().into(),
        ]);
    }
    table.to_string()
}
