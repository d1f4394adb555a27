//! Measuring: runs of cases on engines, and the files that they fill.

pub mod attribution;
pub mod chart;
pub mod checks;
mod ladder;
pub mod meta;
pub mod race;
pub mod stability;

use crate::case::{self, TURN, Track, Trial};
use crate::engines::{Engine, Maker, Method, Motion, Setting};
use crate::records::Outcome;
use crate::scene::{Hold, Joint, Kind, Scene};
use crate::vector::{add, norm, rotate, sub};
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

    /// How long a run may take.
    fn budget(&self) -> Duration {
        Duration::from_secs_f64(if self.quick { 0.5 } else { 3.0 })
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

    /// Step number `k`, from 0. Forces are those of its middle, at the places of its start.
    fn step(&mut self, k: usize) {
        if !self.scene.pushes.is_empty() {
            self.engine.motions(&mut self.motions);
        }
        for push in &self.scene.pushes {
            let Some(i) = self.dynamic[push.body] else { continue };
            let m = &self.motions[i];
            let point = add(m.position, rotate(m.rotation, push.at));
            let force = push.at_time((k as f64 + 0.5) * self.setting.dt());
            self.engine.push(push.body, force, point);
        }
        self.engine.step();
    }
}

/// What springs give at the start: their stretch times their frequency \[m/s\].
fn spring_speed(scene: &Scene) -> f64 {
    let speed = |j: &Joint| {
        let ends = [0, 1].map(|k| {
            let body = &scene.bodies[j.bodies[k]];
            add(body.position, rotate(body.rotation, j.local[k]))
        });
        let apart = norm(sub(ends[1], ends[0]));
        let (stretch, hertz) = match j.hold {
            Hold::Slider(Some(s)) => (apart, s.hertz),
            Hold::Spring(length, s) => (apart - length, s.hertz),
            _ => (0.0, 0.0),
        };
        stretch.abs() * std::f64::consts::TAU * hertz
    };
    scene.joints.iter().map(speed).fold(0.0, f64::max)
}

/// Beyond this speed \[m/s\] a scene has exploded: ten times what it has, and what falling and springs give it, allow.
fn speed_limit(scene: &Scene, duration: f64) -> f64 {
    let fastest = scene.bodies.iter().map(|b| norm(b.velocity)).fold(0.0, f64::max);
    let push = scene.pushes.iter().map(|p| norm(p.force)).fold(0.0, f64::max);
    10.0 * (fastest + spring_speed(scene) + (norm(scene.gravity) + push) * duration + 3.0)
}

/// Runs a scene, and gives the way of its bodies, or how else it ended; and what the engine says of its last step.
pub fn run(
    maker: &Maker,
    scene: &Scene,
    method: &Method,
    setting: &Setting,
    duration: f64,
    turned: bool,
    budget: Duration,
) -> Result<(Track, Option<f64>), Outcome> {
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
    let start = Instant::now();
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
        if start.elapsed() > budget {
            return Err(Outcome::Timeout);
        }
    }
    if runner.engine.is_broken() {
        return Err(Outcome::Nan);
    }
    Ok((track, runner.engine.residual()))
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
    let failed = |outcome| Tried { outcome, error: None, more: Vec::new() };
    match &case.trial {
        Trial::Missing => failed(Outcome::Refused),
        Trial::Run(scene, judge) => match run(maker, scene, method, setting, case.duration, turned, budget) {
            Err(outcome) => failed(outcome),
            Ok((track, residual)) => {
                let verdict = judge(scene, &track);
                let mut more = verdict.more;
                more.extend(residual.map(|r| ("residual", r)));
                let outcome = verdict.outcome.unwrap_or(Outcome::Ok);
                let error = verdict.error / case.scale.0;
                if !error.is_finite() {
                    return Tried { outcome: Outcome::Nan, error: None, more };
                }
                Tried { outcome, error: (outcome == Outcome::Ok).then_some(error), more }
            }
        },
        Trial::Threshold(threshold) => {
            let mut ended = Outcome::Ok;
            let begin = Instant::now();
            let found = case::bisect(threshold, |value| {
                let scene = (threshold.scene)(value);
                let left = (4 * budget).checked_sub(begin.elapsed()).unwrap_or_default();
                match run(maker, &scene, method, setting, case.duration, turned, left) {
                    Ok((track, _)) => Some((threshold.beyond)(&track)),
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
                },
            }
        }
    }
}

/// The scene that a case's time is taken on.
fn timed_scene(case: &case::Case) -> Option<Scene> {
    match &case.trial {
        Trial::Run(scene, _) => Some(scene.clone()),
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
    }
}

#[cfg(test)]
mod tests;
