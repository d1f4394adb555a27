//! Random calls of the C functions with random arguments, good and bad: nothing may crash, hang or break a world,
//! and what fails must leave the world as it was.
//!
//! Every seed is a story of its own. `MEREV_RANDOM_SECONDS` sets how long to go on (default 3, an hour is 3600);
//! `MEREV_RANDOM_SEED` plays one seed alone, as the failure message says.

use core::ffi::{c_char, c_int, c_void};
use merev::capi::*;
use std::cell::Cell;
use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};
use std::time::{Duration, Instant};

#[path = "capi_random/values.rs"]
mod values;
use values::Random;

/// How many calls a story has.
const CALLS: u32 = 3000;
/// More than this in one world would make steps slow.
const MOST_BODIES: usize = 40;

/// Everything a story has got hold of, dead or alive.
struct Story {
    seed: u64,
    r: Random,
    worlds: Vec<mvWorldId>,
    bodies: Vec<mvBodyId>,
    shapes: Vec<mvShapeId>,
    joints: Vec<mvJointId>,
    contacts: Vec<mvContactId>,
    hulls: Vec<*mut mvHullData>,
    boxes: Vec<mvBoxHull>,
    /// Whether pointers that calls return may be followed: not where other threads step the same worlds.
    alone: bool,
    now: &'static str,
}

impl Story {
    fn new(seed: u64) -> Self {
        Self {
            seed,
            r: Random::new(seed),
            worlds: vec![mvWorldId::default()],
            bodies: vec![mvBodyId::default()],
            shapes: vec![mvShapeId::default()],
            joints: vec![mvJointId::default()],
            contacts: vec![mvContactId::default()],
            hulls: Vec::new(),
            boxes: Vec::new(),
            alone: true,
            now: "",
        }
    }

    fn world(&mut self) -> mvWorldId {
        match self.r.below(40) {
            0 => mvWorldId { index1: self.r.word() as u16, generation: self.r.word() as u16 },
            1 => mvWorldId::default(),
            _ => self.worlds[self.r.late(self.worlds.len())],
        }
    }

    fn body(&mut self) -> mvBodyId {
        match self.r.below(60) {
            0 => mvBodyId {
                index1: self.r.word() as i32,
                world0: self.r.word() as u16,
                generation: self.r.word() as u16,
            },
            1 => mvBodyId { index1: self.r.below(20) as i32, world0: self.r.below(4) as u16, generation: 1 },
            2 => mvBodyId::default(),
            _ => self.bodies[self.r.late(self.bodies.len())],
        }
    }

    fn shape(&mut self) -> mvShapeId {
        match self.r.below(60) {
            0 => mvShapeId {
                index1: self.r.word() as i32,
                world0: self.r.word() as u16,
                generation: self.r.word() as u16,
            },
            1 => mvShapeId { index1: self.r.below(20) as i32, world0: self.r.below(4) as u16, generation: 1 },
            2 => mvShapeId::default(),
            _ => self.shapes[self.r.late(self.shapes.len())],
        }
    }

    fn joint(&mut self) -> mvJointId {
        match self.r.below(60) {
            0 => mvJointId {
                index1: self.r.word() as i32,
                world0: self.r.word() as u16,
                generation: self.r.word() as u16,
            },
            1 => mvJointId { index1: self.r.below(20) as i32, world0: self.r.below(4) as u16, generation: 1 },
            2 => mvJointId::default(),
            _ => self.joints[self.r.late(self.joints.len())],
        }
    }

    /// A hull of any origin, or null.
    fn hull(&mut self) -> *const mvHullData {
        match self.r.below(8) {
            0 => null(),
            1..=3 if !self.hulls.is_empty() => self.hulls[self.r.below(self.hulls.len())],
            _ if !self.boxes.is_empty() => &self.boxes[self.r.below(self.boxes.len())].base,
            _ => null(),
        }
    }

    fn world_def(&mut self) -> mvWorldDef {
        let mut d = mvDefaultWorldDef();
        match self.r.below(13) {
            0 => d.gravity = self.r.vec(),
            1 => d.restitution_threshold = self.r.num(),
            2 => d.contact_stiffness = self.r.num(),
            3 => d.maximum_linear_speed = self.r.num(),
            4 => d.worker_count = self.r.below(3) as u32,
            5 => d.broad_phase = self.r.choice(),
            6 => d.narrow_phase = self.r.choice(),
            7 => d.solver = self.r.choice(),
            8 => d.internal_value = self.r.word() as i32,
            9 => d.enable_sleep = self.r.flag(),
            10 => d.accuracy = 1e-3,
            11 => d.friction_callback = Some(mixing),
            _ => {}
        }
        d
    }

    fn body_def(&mut self) -> mvBodyDef {
        let mut d = mvDefaultBodyDef();
        d.r#type = if self.r.below(20) == 0 { self.r.choice() } else { [0, 1, 2, 2, 2, 2][self.r.below(6)] };
        d.position = self.r.place();
        d.rotation = self.r.quat();
        match self.r.below(12) {
            0 => d.linear_velocity = self.r.vec(),
            1 => d.angular_velocity = self.r.vec(),
            2 => d.linear_damping = self.r.num(),
            3 => d.gravity_scale = self.r.num(),
            4 => d.sleep_threshold = self.r.num(),
            5 => d.is_awake = self.r.flag(),
            6 => d.is_enabled = self.r.flag(),
            7 => d.motion_locks.angular_x = self.r.flag(),
            8 => d.motion_locks.linear_y = self.r.flag(),
            9 => d.internal_value = self.r.word() as i32,
            10 => d.name = c"name".as_ptr(),
            _ => {}
        }
        d
    }

    fn shape_def(&mut self) -> mvShapeDef {
        let mut d = mvDefaultShapeDef();
        d.base_material.restitution = [0.0, 0.5, 1.0][self.r.below(3)];
        match self.r.below(16) {
            0 => d.density = self.r.num(),
            1 => d.base_material.friction = self.r.num(),
            2 => d.base_material.tangent_velocity = self.r.vec(),
            3 => d.base_material.rolling_resistance = self.r.num(),
            4 => d.filter.group_index = self.r.choice(),
            5 => d.filter.mask_bits = self.r.word(),
            6 => d.enable_custom_filtering = 1,
            7 => d.enable_pre_solve_events = 1,
            8 => d.enable_hit_events = self.r.flag(),
            9 => d.update_body_mass = self.r.flag(),
            10 => d.internal_value = self.r.word() as i32,
            11 => d.base_material.static_friction = self.r.num(),
            12 => d.base_material.restitution = self.r.num(),
            _ => {}
        }
        d
    }

    /// Throws half of the old things away now and then, so that a story does not only hold dead ones.
    fn tidy(&mut self) {
        fn halve<T>(v: &mut Vec<T>, most: usize) {
            if v.len() > most {
                v.drain(1..most / 2);
            }
        }
        halve(&mut self.worlds, 12);
        halve(&mut self.bodies, 120);
        halve(&mut self.shapes, 120);
        halve(&mut self.joints, 120);
        halve(&mut self.contacts, 60);
        halve(&mut self.boxes, 12);
    }

    fn end(&mut self) {
        for &w in &self.worlds {
            mvDestroyWorld(w);
        }
        for &h in &self.hulls {
            // Sound: the story made it and has not destroyed it yet.
            unsafe { mvDestroyHull(h) };
        }
        mvGetLastError();
    }
}

thread_local! {
    static STORY: Cell<*mut Story> = const { Cell::new(null_mut()) };
    /// How many calls ended with each code.
    static COUNTS: Cell<[u32; 14]> = const { Cell::new([0; 14]) };
}

/// What every callback does: it calls something. Changes of the world are refused, the rest must work.
fn in_callback() -> usize {
    let story = STORY.with(Cell::get);
    if story.is_null() {
        return 1;
    }
    // Sound: the story outlives the call that runs the callback, and is not used while the callback runs, since the
    // calls are given copies of its parts.
    let story = unsafe { &mut *story };
    STORY.with(|s| s.set(null_mut()));
    let (now, answer) = (story.now, story.r.below(5));
    if story.r.below(4) == 0 {
        act(story);
    }
    story.now = now;
    STORY.with(|s| s.set(story));
    answer
}

unsafe extern "C" fn mixing(a: mvFloat, _: u64, _: mvFloat, _: u64, _: *mut c_void) -> mvFloat {
    [a, 0.0, mvFloat::NAN, -1.0, 1e30][in_callback()]
}

unsafe extern "C" fn filter(_: mvShapeId, _: mvShapeId, _: *mut c_void) -> Flag {
    [1, 1, 1, 0, 77][in_callback()]
}

unsafe extern "C" fn pre_solve(_: mvShapeId, _: mvShapeId, _: mvPos, _: mvVec3, _: *mut c_void) -> Flag {
    [1, 1, 1, 0, 255][in_callback()]
}

unsafe extern "C" fn overlap(_: mvShapeId, _: *mut c_void) -> Flag {
    [1, 1, 1, 0, 3][in_callback()]
}

unsafe extern "C" fn segment(p: *const mvPos, _: *const mvPos, color: mvHexColor, _: *mut c_void) {
    // Sound: valid during the call.
    assert!(in_callback() < 5 && unsafe { *p }.x.is_finite() && color <= 0xff_ff_ff);
}

unsafe extern "C" fn draw_shape(
    shape: *const mvShapeId,
    at: *const mvWorldTransform,
    _: mvHexColor,
    _: *mut c_void,
) {
    // Sound: valid during the call.
    let (shape, at) = unsafe { (*shape, *at) };
    assert!(in_callback() < 5 && mvShape_IsValid(shape) && at.p.x.is_finite());
}

unsafe extern "C" fn polygon(corners: *const mvPos, n: c_int, _: mvHexColor, _: mvFloat, _: *mut c_void) {
    // Sound: as many as it says.
    let corners = unsafe { std::slice::from_raw_parts(corners, n as usize) };
    assert!(in_callback() < 5 && n >= 3 && corners.iter().all(|p| p.x.is_finite()));
}

unsafe extern "C" fn string(_: *const mvPos, text: *const c_char, _: mvHexColor, _: *mut c_void) {
    // Sound: a string that is valid during the call.
    assert!(in_callback() < 5 && !unsafe { CStr::from_ptr(text) }.is_empty());
}

unsafe extern "C" fn cast(
    _: mvShapeId,
    _: mvPos,
    _: mvVec3,
    fraction: mvFloat,
    _: u64,
    _: c_int,
    _: c_int,
    _: *mut c_void,
) -> mvFloat {
    [1.0, -1.0, fraction, 0.0, mvFloat::NAN][in_callback()]
}

type Act = (&'static str, fn(&mut Story));

#[path = "capi_random/acts.rs"]
mod acts;
#[path = "capi_random/joints.rs"]
mod joints;

fn act(s: &mut Story) {
    let (name, act) = acts::ACTS[s.r.below(acts::ACTS.len())];
    s.now = name;
    mvGetLastError();
    act(s);
    let code = mvGetLastError();
    let seed = s.seed;
    assert!(
        (0..mv_errorFaulted).contains(&code),
        "MEREV_RANDOM_SEED={seed}, {name}: code {code}: {}",
        message()
    );
}

fn message() -> String {
    // Sound: never null, valid until the next failure of this thread.
    unsafe { CStr::from_ptr(mvGetLastErrorMessage()) }.to_string_lossy().into_owned()
}

/// Plays one seed.
fn play(seed: u64) {
    let mut story = Story::new(seed);
    for call in 0..CALLS {
        let told = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| checked_act(&mut story)));
        if let Err(why) = told {
            let why = why.downcast_ref::<String>().cloned().unwrap_or_default();
            panic!("MEREV_RANDOM_SEED={seed}, call {call} ({}): {why}", story.now);
        }
    }
    story.end();
}

/// One call; if it fails, no world may have changed.
fn checked_act(s: &mut Story) {
    s.tidy();
    STORY.with(|c| c.set(s));
    let watched = s.r.below(16) == 0;
    let hashes = |s: &Story| -> Vec<u64> { s.worlds.iter().map(|&w| mvWorld_GetStateHash(w)).collect() };
    let before = if watched { hashes(s) } else { Vec::new() };
    let (name, act) = acts::ACTS[s.r.below(acts::ACTS.len())];
    s.now = name;
    let worlds = s.worlds.len();
    mvGetLastError();
    act(s);
    let code = mvGetLastError();
    STORY.with(|c| c.set(null_mut()));
    assert!((0..mv_errorFaulted).contains(&code), "code {code}: {}", message());
    let mut counts = COUNTS.with(Cell::get);
    counts[code as usize] += 1;
    COUNTS.with(|c| c.set(counts));
    if code != 0 {
        assert!(message().starts_with("mv"), "the message names the function: {}", message());
    }
    // A step whose callbacks failed is no failure of the step.
    if watched && code != 0 && s.worlds.len() == worlds && !name.starts_with("step") {
        assert_eq!(before, hashes(s), "code {code} and yet the world changed: {}", message());
        mvGetLastError();
    }
}

fn seconds() -> Duration {
    let text = std::env::var("MEREV_RANDOM_SECONDS").unwrap_or_default();
    Duration::from_secs_f64(text.parse().unwrap_or(3.0))
}

/// The stories invent ids, which may hit worlds of the other test in this process; a world that is in use answers
/// with an error then. So one test runs after the other.
static ONE_AT_A_TIME: std::sync::Mutex<()> = std::sync::Mutex::new(());

#[test]
fn random_calls_break_nothing() {
    let _alone = ONE_AT_A_TIME.lock();
    if let Ok(seed) = std::env::var("MEREV_RANDOM_SEED") {
        return play(seed.parse().expect("a seed is a number"));
    }
    let end = Instant::now() + seconds();
    let mut seed = 1;
    while Instant::now() < end {
        play(seed);
        seed += 1;
    }
    println!("{} stories of {CALLS} calls; by error code: {:?}", seed - 1, COUNTS.with(Cell::get));
}

/// Two threads play in the same worlds: many calls are refused as busy, none may do harm.
#[test]
fn random_calls_of_two_threads_break_nothing() {
    let _alone = ONE_AT_A_TIME.lock();
    let end = Instant::now() + seconds() / 3;
    let def = mvDefaultWorldDef();
    let shared: Vec<mvWorldId> = (0..3).map(|_| mvCreateWorld(Some(&def))).collect();
    std::thread::scope(|scope| {
        for thread in 0..2 {
            let shared = shared.clone();
            scope.spawn(move || {
                let mut seed = 1_000_000 * (thread + 1);
                while Instant::now() < end {
                    let mut story = Story::new(seed);
                    story.alone = false;
                    story.worlds.extend(&shared);
                    for _ in 0..CALLS {
                        story.tidy();
                        STORY.with(|c| c.set(&mut story));
                        act(&mut story);
                        STORY.with(|c| c.set(null_mut()));
                    }
                    story.worlds.retain(|w| !shared.iter().any(|s| s.index1 == w.index1));
                    story.end();
                    seed += 1;
                }
            });
        }
    });
    shared.into_iter().for_each(|w| mvDestroyWorld(w));
}

/// A string that may be null, and may not be UTF-8.
fn name(r: &mut Random) -> Option<CString> {
    match r.below(5) {
        0 => None,
        1 => Some(CString::new([0xff, 0x41]).unwrap()),
        _ => Some(CString::new(format!("n{}", r.below(1000))).unwrap()),
    }
}
