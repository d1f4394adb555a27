//! The C programs of `lab/c`, which use the library as anyone would, and what they hand over.

use std::ffi::{c_int, c_void};
use std::time::Instant;

/// Mirrors `LabFrame` of c/lab.h.
#[repr(C)]
struct RawFrame {
    time: f64,
    elapsed: f64,
    hit_speed: f64,
    measured: c_int,
    energy: f64,
    momentum: [f64; 3],
    penetration: f64,
    poses: *const f32,
    body_count: c_int,
}

/// Mirrors `LabHost` of c/lab.h.
#[repr(C)]
struct RawHost {
    context: *mut c_void,
    now: extern "C" fn(*mut c_void) -> f64,
    frame: extern "C" fn(*mut c_void, *const RawFrame),
}

unsafe extern "C" {
    fn labBouncingBall(host: *const RawHost, steps: c_int) -> c_int;
    fn labPyramid(
        host: *const RawHost,
        rows: c_int,
        steps: c_int,
        measure_every: c_int,
        strike_after: c_int,
    ) -> c_int;
}

/// A measured state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// Kinetic and potential [J].
    pub energy: f64,
    /// [kg m/s]
    pub momentum: [f64; 3],
    /// Deepest overlap [m].
    pub penetration: f64,
}

/// Position x, y, z [m] and rotation x, y, z, w.
pub type Pose = [f32; 7];

/// The world after a step.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Since the start [s].
    pub time: f64,
    /// What the step took [s].
    pub elapsed: f64,
    /// Greatest approach speed of a hit in this step; 0 for none [m/s].
    pub hit_speed: f64,
    pub measures: Option<Measures>,
    /// The moving bodies in order of creation.
    pub poses: Vec<Pose>,
}

struct Context<'a> {
    start: Instant,
    frames: Vec<Frame>,
    progress: &'a mut dyn FnMut(),
}

extern "C" fn now(context: *mut c_void) -> f64 {
    // SAFETY: the context is the one that `run` made, alive while the program runs, and used by nobody else now.
    let context = unsafe { &*context.cast::<Context>() };
    context.start.elapsed().as_secs_f64()
}

extern "C" fn take(context: *mut c_void, frame: *const RawFrame) {
    // SAFETY: as in `now`; the frame and its poses live during the call.
    let (context, raw, flat) = unsafe {
        let raw = &*frame;
        let flat = std::slice::from_raw_parts(raw.poses, 7 * raw.body_count as usize);
        (&mut *context.cast::<Context>(), raw, flat)
    };
    let (poses, _) = flat.as_chunks::<7>();
    context.frames.push(Frame {
        time: raw.time,
        elapsed: raw.elapsed,
        hit_speed: raw.hit_speed,
        measures: (raw.measured != 0).then_some(Measures {
            energy: raw.energy,
            momentum: raw.momentum,
            penetration: raw.penetration,
        }),
        poses: poses.to_vec(),
    });
    (context.progress)();
}

fn run(
    progress: &mut dyn FnMut(),
    program: impl FnOnce(*const RawHost) -> c_int,
) -> Result<Vec<Frame>, String> {
    let mut context = Context { start: Instant::now(), frames: Vec::new(), progress };
    let host = RawHost { context: (&raw mut context).cast(), now, frame: take };
    match program(&raw const host) {
        0 => Ok(context.frames),
        code => Err(format!("a call of the library failed with code {code}")),
    }
}

/// The bouncing ball for so many steps of 1/100 s, every step measured.
pub fn bouncing_ball(steps: usize, progress: &mut dyn FnMut()) -> Result<Vec<Frame>, String> {
    // SAFETY: the program calls back with the host's context only, and returns before the host ends.
    run(progress, |host| unsafe { labBouncingBall(host, steps as c_int) })
}

/// How a pyramid is run.
#[derive(Clone, Copy, Debug)]
pub struct PyramidRun {
    pub rows: usize,
    /// Steps of 1/60 s.
    pub steps: usize,
    /// The world is measured after the first step, every so many steps, and after the last.
    pub measure_every: usize,
    /// After how many steps a ball strikes it; 0 for never.
    pub strike_after: usize,
}

/// A pyramid of cubes.
pub fn pyramid(how: PyramidRun, progress: &mut dyn FnMut()) -> Result<Vec<Frame>, String> {
    let [rows, steps, every, strike] =
        [how.rows, how.steps, how.measure_every, how.strike_after].map(|x| x as c_int);
    // SAFETY: as above.
    run(progress, |host| unsafe { labPyramid(host, rows, steps, every, strike) })
}
