//! A case: a scene, what is true about it, and how far a run is from that.

use crate::engines::Motion;
use crate::records::Outcome;
use crate::scene::{Form, Kind, Scene};
use crate::vector::{self, Q4, V3};

/// Where the truth comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A formula.
    ClosedForm,
    /// An integration of high order in minimal coordinates, in `references`.
    GoldenValues,
    /// What must stay as it is.
    Invariant,
    /// A parameter beyond which the outcome changes.
    Threshold,
}

impl Reference {
    pub fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::GoldenValues => "golden values",
            Self::Invariant => "invariant",
            Self::Threshold => "threshold",
        }
    }
}

/// Which methods tell something about the case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vary {
    /// Nothing touches: solvers have nothing to do.
    Integrators,
    /// Contacts or joints are what matters.
    Solvers,
    /// It is for engines as they come.
    Nothing,
}

/// A run: the dynamic bodies at times from 0, turned back if the scene was turned.
#[derive(Clone, Debug, Default)]
pub struct Track {
    pub times: Vec<f64>,
    pub frames: Vec<Vec<Motion>>,
}

impl Track {
    pub fn len(&self) -> usize {
        self.times.len()
    }

    pub fn first(&self) -> &[Motion] {
        &self.frames[0]
    }

    pub fn last(&self) -> &[Motion] {
        &self.frames[self.len() - 1]
    }

    pub fn end(&self) -> f64 {
        self.times[self.len() - 1]
    }

    /// About `count` moments of the run, evenly spread, the start left out and the end among them.
    pub fn moments(&self, count: usize) -> Vec<usize> {
        let n = self.len() - 1;
        let mut picks: Vec<usize> = (1..=count).map(|k| (k * n).div_ceil(count)).filter(|&k| k > 0).collect();
        picks.dedup();
        picks
    }

    /// The moment nearest to a time.
    pub fn at(&self, time: f64) -> usize {
        let k = self.times.partition_point(|&t| t < time);
        if k == 0 {
            return 0;
        }
        if k >= self.len() || time - self.times[k - 1] <= self.times[k] - time { k - 1 } else { k }
    }

    /// One number of each frame.
    pub fn series(&self, f: impl Fn(&[Motion]) -> f64) -> Vec<f64> {
        self.frames.iter().map(|frame| f(frame)).collect()
    }

    /// The greatest value of a frame's number.
    pub fn greatest(&self, f: impl Fn(&[Motion]) -> f64) -> f64 {
        self.frames.iter().map(|frame| f(frame)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// How far the body that went farthest is from where it began, in some frame.
    pub fn farthest(&self, frame: &[Motion]) -> f64 {
        let pairs = self.first().iter().zip(frame);
        pairs.map(|(a, b)| vector::norm(vector::sub(b.position, a.position))).fold(0.0, f64::max)
    }

    /// A run in which nothing moves.
    pub fn null(scene: &Scene, duration: f64) -> Self {
        let still = |m: Motion| Motion { velocity: [0.0; 3], spin: [0.0; 3], ..m };
        let frame: Vec<Motion> = Motion::start(scene);
        let frozen: Vec<Motion> = frame.iter().copied().map(still).collect();
        let steps = (60.0 * duration).ceil() as usize;
        let times = (0..=steps).map(|k| duration * k as f64 / steps as f64).collect();
        let frames = (0..=steps).map(|k| if k == 0 { frame.clone() } else { frozen.clone() }).collect();
        Self { times, frames }
    }
}

/// What a judge says of a run.
#[derive(Clone, Debug, Default)]
pub struct Verdict {
    /// The primary error, in the unit of the case's scale.
    pub error: f64,
    /// Further measures, each over its own natural scale.
    pub more: Vec<(&'static str, f64)>,
    /// Where the run has ended otherwise than it should.
    pub outcome: Option<Outcome>,
}

impl Verdict {
    pub fn new(error: f64) -> Self {
        Self { error, ..Self::default() }
    }

    pub fn and(mut self, name: &'static str, value: f64) -> Self {
        self.more.push((name, value));
        self
    }
}

pub type Judge = Box<dyn Fn(&Scene, &Track) -> Verdict>;

/// What a judge says of several runs.
pub type JudgeOfAll = Box<dyn Fn(&[Track]) -> Verdict>;

/// How a case is measured.
pub enum Trial {
    /// One run, and what a judge says of it.
    Run(Scene, Judge),
    /// A run of each scene, with the setting's rate or one of its own \[Hz\], and what a judge says of all.
    Together(Vec<(Scene, Option<f64>)>, JudgeOfAll),
    /// Runs for a parameter, until where the outcome changes is known.
    Threshold(Threshold),
    /// It cannot be done yet; what is primary says why.
    Missing,
}

/// A parameter beyond which the outcome changes.
pub struct Threshold {
    pub scene: Box<dyn Fn(f64) -> Scene>,
    /// Whether the run shows the outcome of large values.
    pub beyond: Box<dyn Fn(&Track) -> bool>,
    /// Where it should change.
    pub exact: f64,
    /// Between which values it is looked for.
    pub range: [f64; 2],
    /// How often the range is halved.
    pub halvings: usize,
}

/// A case.
pub struct Case {
    pub name: &'static str,
    pub about: &'static str,
    pub group: char,
    pub reference: Reference,
    /// What the error is.
    pub primary: &'static str,
    /// What it is divided by, and its unit.
    pub scale: (f64, &'static str),
    /// How long a run is \[s\].
    pub duration: f64,
    pub vary: Vary,
    /// The most steps a second that are worth it; long runs have fewer.
    pub most_rate: f64,
    pub trial: Trial,
}

impl Case {
    /// A case of one run, whose scene has gravity of 9.81 m/s² unless it says otherwise.
    pub fn run(group: char, reference: Reference, scene: Scene, duration: f64, judge: Judge) -> Self {
        Self {
            name: scene.name,
            about: scene.about,
            group,
            reference,
            primary: "",
            scale: (1.0, "1"),
            duration,
            vary: Vary::Solvers,
            most_rate: 1920.0,
            trial: Trial::Run(scene, judge),
        }
    }

    /// A case of several runs that are compared with each other; named after the first scene.
    pub fn together(
        group: char,
        scenes: Vec<(Scene, Option<f64>)>,
        duration: f64,
        judge: JudgeOfAll,
    ) -> Self {
        Self {
            name: scenes[0].0.name,
            about: scenes[0].0.about,
            group,
            reference: Reference::Invariant,
            primary: "",
            scale: (1.0, "1"),
            duration,
            vary: Vary::Solvers,
            most_rate: 480.0,
            trial: Trial::Together(scenes, judge),
        }
    }

    /// A case whose answer is a parameter.
    pub fn threshold(
        group: char,
        name: &'static str,
        about: &'static str,
        duration: f64,
        threshold: Threshold,
    ) -> Self {
        Self {
            name,
            about,
            group,
            reference: Reference::Threshold,
            primary: "|found − exact| / exact",
            scale: (threshold.exact, "of the parameter"),
            duration,
            vary: Vary::Solvers,
            most_rate: 480.0,
            trial: Trial::Threshold(threshold),
        }
    }

    /// A case that no engine of the lab can do yet.
    pub fn missing(group: char, name: &'static str, about: &'static str, why: &'static str) -> Self {
        Self {
            name,
            about,
            group,
            reference: Reference::Invariant,
            primary: why,
            scale: (1.0, "1"),
            duration: 0.0,
            vary: Vary::Solvers,
            most_rate: 60.0,
            trial: Trial::Missing,
        }
    }

    pub fn primary(mut self, text: &'static str) -> Self {
        self.primary = text;
        self
    }

    pub fn scale(mut self, size: f64, unit: &'static str) -> Self {
        self.scale = (size, unit);
        self
    }

    /// What engines come with is enough: others cost more than they tell.
    pub fn defaults_only(mut self) -> Self {
        self.vary = Vary::Nothing;
        self
    }

    pub fn integrators(mut self) -> Self {
        self.vary = Vary::Integrators;
        self
    }

    pub fn most_rate(mut self, rate: f64) -> Self {
        self.most_rate = rate;
        self
    }

    /// The error of a simulation in which nothing moves, over the scale.
    pub fn null_error(&self) -> Option<f64> {
        match &self.trial {
            Trial::Run(scene, judge) => {
                Some(judge(scene, &Track::null(scene, self.duration)).error / self.scale.0)
            }
            Trial::Together(scenes, judge) => {
                let null = |(scene, _): &(Scene, _)| Track::null(scene, self.duration);
                Some(judge(&scenes.iter().map(null).collect::<Vec<_>>()).error / self.scale.0)
            }
            Trial::Threshold(t) => {
                let found = bisect(t, |value| {
                    let scene = (t.scene)(value);
                    Some((t.beyond)(&Track::null(&scene, self.duration)))
                });
                found.map(|x| (x - t.exact).abs() / t.exact.abs())
            }
            Trial::Missing => None,
        }
    }
}

/// Where the outcome changes; the end of the range if it does not within. None if a run has no outcome.
pub fn bisect(t: &Threshold, mut beyond: impl FnMut(f64) -> Option<bool>) -> Option<f64> {
    let [mut low, mut high] = t.range;
    if beyond(low)? {
        return Some(low);
    }
    if !beyond(high)? {
        return Some(high);
    }
    for _ in 0..t.halvings {
        let middle = 0.5 * (low + high);
        if beyond(middle)? { high = middle } else { low = middle }
    }
    Some(0.5 * (low + high))
}

/// The rotation of the runs that are turned as a whole: anything that no axis has a part in.
pub const TURN: Q4 = [0.2, -0.5, 0.3, 0.787_400_787_401_181_1];

/// A motion turned back.
pub fn turn_back(m: &Motion) -> Motion {
    let q = vector::conjugate(TURN);
    Motion {
        position: vector::rotate(q, m.position),
        rotation: vector::times(q, m.rotation),
        velocity: vector::rotate(q, m.velocity),
        spin: vector::rotate(q, m.spin),
    }
}

/// Mass and principal moments of the dynamic bodies.
pub fn masses(scene: &Scene) -> Vec<(f64, V3)> {
    let of = |body: &crate::scene::Body| {
        if let Some(m) = body.mass {
            return (m.mass, m.inertia);
        }
        match body.form {
            Form::Box([x, y, z]) => {
                let m = 8.0 * x * y * z * body.density;
                (m, [y * y + z * z, x * x + z * z, x * x + y * y].map(|s| m * s / 3.0))
            }
            Form::Sphere(r) => {
                let m = 4.0 / 3.0 * std::f64::consts::PI * r * r * r * body.density;
                (m, [0.4 * m * r * r; 3])
            }
            // Hulls and capsules of the cases have their mass written down.
            Form::Capsule(..) | Form::Hull(_) | Form::Boxes(_) => (f64::NAN, [f64::NAN; 3]),
        }
    };
    scene.bodies.iter().filter(|b| b.kind == Kind::Dynamic).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bisection_finds_the_change() {
        let t = Threshold {
            scene: Box::new(|_| Scene::new("t", "", 1)),
            beyond: Box::new(|_| false),
            exact: 0.3,
            range: [0.0, 1.0],
            halvings: 20,
        };
        assert!((bisect(&t, |x| Some(x > 0.3)).unwrap() - 0.3).abs() < 1e-6);
        assert_eq!(bisect(&t, |_| Some(true)), Some(0.0));
        assert_eq!(bisect(&t, |_| Some(false)), Some(1.0));
        assert_eq!(bisect(&t, |x| (x < 0.5).then_some(false)), None);
    }

    #[test]
    fn moments_end_with_the_end() {
        let track = Track { times: (0..=10).map(f64::from).collect(), frames: vec![Vec::new(); 11] };
        assert_eq!(track.moments(2), [5, 10]);
        assert_eq!(track.moments(100).len(), 10);
        assert_eq!((track.at(3.2), track.at(99.0), track.at(-1.0)), (3, 10, 0));
    }
}
