//! Measuring: runs of cases on engines, and the files that they fill.

pub mod attribution;
pub mod chart;
pub mod checks;
mod ladder;
pub mod meta;
pub mod race;
pub mod stability;
pub mod workers;

use crate::case::{self, TURN, Track, Trial};
use crate::engines::{Engine, Maker, Method, Motion, Setting};
use crate::records::Outcome;
use crate::scene::{Hold, Joint, Kind, Load, Scene, pull};
use crate::vector::{V3, add, cross, norm, rotate, scale, sub};
use cpu_time::ThreadTime;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// What all commands that measure are told.
#[derive(Clone, Debug)]
pub struct Options {
    /// Where the files go.
    pub directory: PathBuf,
    /// Little of everything, in a few minutes.
    pub quick: bool,
    /// Begin anew instead of going on.
    pub fresh: bool,
    /// On the other engines too.
    pub peers: bool,
    /// Only cases and scenes whose name has this in it.
    pub only: Option<String>,
    /// In how many processes.
    pub jobs: usize,
    /// This process is one of them.
    pub worker: Option<workers::Worker>,
}

impl Options {
    fn wants(&self, name: &str) -> bool {
        self.only.as_ref().is_none_or(|part| name.contains(part.as_str()))
    }

    /// The engines that are asked for, ours through C included.
    fn makers(&self) -> Vec<Maker> {
        let ours = |m: &Maker| m.key == "merev" || m.key == "merev_c";
        crate::engines::ALL.iter().copied().filter(|m| self.peers || ours(m)).collect()
    }

    /// How much CPU time a run may take.
    fn budget(&self) -> Duration {
        Duration::from_secs_f64(if self.quick { 0.5 } else { 3.0 })
    }

    /// The same for methods beside the one that an engine comes with: in a short chart, half of it.
    fn budget_of(&self, is_first: bool) -> Duration {
        if self.quick && !is_first { self.budget() / 2 } else { self.budget() }
    }
}

/// The most motions that are kept of a run.
const KEPT: usize = 600_000;

/// A world of a scene on its way.
struct Runner<'a> {
    scene: &'a Scene,
    setting: &'a Setting,
    engine: Box<dyn Engine>,
    motions: Vec<Motion>,
    /// For each body of the scene, its place among the dynamic ones.
    dynamic: Vec<Option<usize>>,
}

impl<'a> Runner<'a> {
    fn new(maker: &Maker, scene: &'a Scene, method: &Method, setting: &'a Setting) -> Result<Self, Outcome> {
        let engine = (maker.build)(scene, method, setting).map_err(|_| Outcome::Refused)?;
        let mut count = 0;
        let dynamic = scene
            .bodies
            .iter()
            .map(|b| {
                (b.kind == Kind::Dynamic).then(|| {
                    count += 1;
                    count - 1
                })
            })
            .collect();
        Ok(Self { scene, setting, engine, motions: Motion::start(scene), dynamic })
    }

    /// Puts a load on for the next step: a torque as two forces.
    fn put(&mut self, load: &Load) {
        match *load {
            Load::Torque(body, torque) => {
                let Some(i) = self.dynamic[body] else { return };
                let (place, arm) = (self.motions[i].position, across(torque));
                let force = scale(cross(torque, arm), 0.5);
                self.engine.push(body, force, add(place, arm));
                self.engine.push(body, scale(force, -1.0), sub(place, arm));
            }
            Load::Spring { body, at, anchor, stiffness, rest } => {
                let Some(i) = self.dynamic[body] else { return };
                let m = &self.motions[i];
                let place = add(m.position, rotate(m.rotation, sub(at, self.scene.bodies[body].center())));
                self.engine.push(body, pull(place, anchor, stiffness, rest), place);
            }
        }
    }

    /// Step number `k`, from 0. Forces are those of its middle, at the places of its start.
    fn step(&mut self, k: usize) {
        if !self.scene.pushes.is_empty() || !self.scene.loads.is_empty() {
            self.engine.motions(&mut self.motions);
        }
        for push in &self.scene.pushes {
            let Some(i) = self.dynamic[push.body] else { continue };
            let m = &self.motions[i];
            let arm = sub(push.at, self.scene.bodies[push.body].center());
            let point = add(m.position, rotate(m.rotation, arm));
            let force = push.at_time((k as f64 + 0.5) * self.setting.dt());
            self.engine.push(push.body, force, point);
        }
        for load in &self.scene.loads {
            self.put(load);
        }
        self.engine.step();
    }
}

/// A direction across another.
fn across(v: V3) -> V3 {
    let axis = if v[0].abs() < v[1].abs() { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let side = cross(v, axis);
    scale(side, 1.0 / norm(side))
}

/// Beyond this speed \[m/s\] a scene has exploded: ten times what it has, and what falling gives it, allow.
fn speed_limit(scene: &Scene, duration: f64) -> f64 {
    let fastest = scene.bodies.iter().map(|b| norm(b.velocity)).fold(0.0, f64::max);
    let push = scene.pushes.iter().map(|p| norm(p.force)).fold(0.0, f64::max);
    let springs = scene.joints.iter().map(|j| spring_speed(scene, j)).fold(0.0, f64::max);
    10.0 * (fastest + springs + (norm(scene.gravity) + push) * duration + 3.0)
}

/// What a joint's spring gives at most to what it is meant for, from where its points are at the start.
fn spring_speed(scene: &Scene, joint: &Joint) -> f64 {
    let (Hold::Slider(Some(spring)) | Hold::Spring(_, spring)) = joint.hold else { return 0.0 };
    let point = |k: usize| {
        let body = &scene.bodies[joint.bodies[k]];
        add(body.position, rotate(body.rotation, joint.local[k]))
    };
    std::f64::consts::TAU * spring.hertz * norm(sub(point(1), point(0)))
}

/// What a run has given.
pub struct Run {
    pub track: Track,
    /// The engine's own, of its last step.
    residual: Option<f64>,
    /// CPU time, reading included \[s\].
    spent: f64,
}

/// CPU time of this thread since then \[s\]: other load does not make a run time out.
fn since(start: ThreadTime) -> f64 {
    start.try_elapsed().map_or(0.0, |d| d.as_secs_f64())
}

/// Runs a scene, and gives the way of its bodies, or how else it ended. The budget is of CPU time.
pub fn run(
    maker: &Maker,
    scene: &Scene,
    method: &Method,
    setting: &Setting,
    duration: f64,
    turned: bool,
    budget: Duration,
) -> Result<Run, Outcome> {
    let whole = if turned { scene.turned(TURN) } else { scene.clone() };
    let mut runner = Runner::new(maker, &whole, method, setting)?;
    let steps = (duration * setting.rate).round().max(1.0) as usize;
    let stride = (steps * whole.dynamic_count()).div_ceil(KEPT).max(1);
    let limit = speed_limit(scene, duration);
    let mut track = Track::default();
    let keep = |track: &mut Track, k: usize, motions: &[Motion]| {
        track.times.push(k as f64 * setting.dt());
        track.frames.push(if turned {
            motions.iter().map(case::turn_back).collect()
        } else {
            motions.to_vec()
        });
    };
    let mut motions = Vec::new();
    runner.engine.motions(&mut motions);
    keep(&mut track, 0, &motions);
    let (start, budget) = (ThreadTime::now(), budget.as_secs_f64());
    for k in 0..steps {
        runner.step(k);
        if (k + 1) % stride == 0 || k + 1 == steps {
            runner.engine.motions(&mut motions);
            let finite = |m: &Motion| {
                m.position.iter().chain(&m.rotation).chain(&m.velocity).chain(&m.spin).all(|x| x.is_finite())
            };
            if !motions.iter().all(finite) {
                return Err(Outcome::Nan);
            }
            if motions.iter().any(|m| norm(m.velocity) > limit) {
                return Err(Outcome::Exploded);
            }
            keep(&mut track, k + 1, &motions);
        }
        if since(start) > budget {
            return Err(Outcome::Timeout);
        }
    }
    if runner.engine.is_broken() {
        return Err(Outcome::Nan);
    }
    Ok(Run { track, residual: runner.engine.residual(), spent: since(start) })
}

/// CPU milliseconds of this thread for a simulated second: the median of repeats, as many as `budget` has room for,
/// at most seven. Nothing is read in between.
fn cost(
    maker: &Maker,
    scene: &Scene,
    method: &Method,
    setting: &Setting,
    duration: f64,
    budget: Duration,
) -> Option<f64> {
    let steps = (duration * setting.rate).round().max(1.0) as usize;
    let (mut all, begin) = (Vec::new(), Instant::now());
    while all.is_empty() || all.len() < 7 && begin.elapsed() < budget {
        let mut runner = Runner::new(maker, scene, method, setting).ok()?;
        // The first step, which allocates, is left out where there are others.
        let skip = usize::from(steps > 10);
        (0..skip).for_each(|k| runner.step(k));
        let start = ThreadTime::try_now().ok()?;
        (skip..steps).for_each(|k| runner.step(k));
        let spent = start.try_elapsed().ok()?.as_secs_f64();
        all.push(1e3 * spent / ((steps - skip) as f64 * setting.dt()));
    }
    Some(crate::race::median(&all))
}

/// What a trial gives with a setting: its error over its scale, and further measures; or how else it ended.
pub struct Tried {
    pub outcome: Outcome,
    pub error: Option<f64>,
    pub more: Vec<(&'static str, f64)>,
    /// CPU milliseconds for a simulated second, reading included, if it was a single run.
    pub cost_ms: Option<f64>,
}

/// Runs a case once, or as often as its threshold needs.
pub fn try_case(
    case: &case::Case,
    maker: &Maker,
    method: &Method,
    setting: &Setting,
    turned: bool,
    budget: Duration,
) -> Tried {
    let failed = |outcome| Tried { outcome, error: None, more: Vec::new(), cost_ms: None };
    match &case.trial {
        Trial::Missing => failed(Outcome::Refused),
        Trial::Run(scene, judge) => match run(maker, scene, method, setting, case.duration, turned, budget) {
            Err(outcome) => failed(outcome),
            Ok(Run { track, residual, spent }) => {
                let tried = judged(case, judge(scene, &track), residual);
                Tried { cost_ms: Some(1e3 * spent / track.end()), ..tried }
            }
        },
        Trial::Together(scenes, judge) => {
            let begin = ThreadTime::now();
            let mut tracks = Vec::new();
            for (scene, rate) in scenes {
                let setting = Setting { rate: rate.unwrap_or(setting.rate), ..*setting };
                let left = budget.checked_sub(begin.elapsed()).unwrap_or_default();
                match run(maker, scene, method, &setting, case.duration, turned, left) {
                    Err(outcome) => return failed(outcome),
                    Ok(run) => tracks.push(run.track),
                }
            }
            judged(case, judge(&tracks), None)
        }
        Trial::Threshold(threshold) => {
            let mut ended = Outcome::Ok;
            let begin = ThreadTime::now();
            let found = case::bisect(threshold, |value| {
                let scene = (threshold.scene)(value);
                let left = (4 * budget).checked_sub(begin.elapsed()).unwrap_or_default();
                match run(maker, &scene, method, setting, case.duration, turned, left) {
                    Ok(run) => Some((threshold.beyond)(&run.track)),
                    Err(outcome) => {
                        ended = outcome;
                        None
                    }
                }
            });
            match found {
                None => failed(ended),
                Some(x) => Tried {
                    outcome: Outcome::Ok,
                    error: Some((x - threshold.exact).abs() / threshold.exact.abs()),
                    more: vec![("found", x)],
                    cost_ms: None,
                },
            }
        }
    }
}

/// What a judge has said, over the case's scale.
fn judged(case: &case::Case, verdict: case::Verdict, residual: Option<f64>) -> Tried {
    let mut more = verdict.more;
    more.extend(residual.map(|r| ("residual", r)));
    let outcome = verdict.outcome.unwrap_or(Outcome::Ok);
    let error = verdict.error / case.scale.0;
    if !error.is_finite() {
        return Tried { outcome: Outcome::Nan, error: None, more, cost_ms: None };
    }
    Tried { outcome, error: (outcome == Outcome::Ok).then_some(error), more, cost_ms: None }
}

/// The scene that a case's time is taken on.
fn timed_scene(case: &case::Case) -> Option<Scene> {
    match &case.trial {
        Trial::Run(scene, _) => Some(scene.clone()),
        Trial::Together(scenes, _) => Some(scenes[0].0.clone()),
        Trial::Threshold(t) => Some((t.scene)(t.exact)),
        Trial::Missing => None,
    }
}

/// Whether a method has anything to say about a case.
fn tells(case: &case::Case, method: &Method, first: &Method) -> bool {
    match case.vary {
        _ if method == first => true,
        case::Vary::Integrators => method.solver == first.solver,
        case::Vary::Solvers => method.integrator == first.integrator,
        case::Vary::Nothing => false,
    }
}

#[cfg(test)]
mod tests;
