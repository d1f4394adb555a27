//! Where worlds live, and who may touch them now.
//!
//! A world has a place; its id is the place and how often that place was used. The place keeps the generations
//! of the old world's bodies and shapes, so that their ids stay stale in the next world there. A place whose own
//! generations are used up, or whose world broke, is never used again.
//!
//! Each place has a lock that never waits: any number of readers, or one writer. Who finds it taken is told so.
//! A thread that is inside a step or a query of a world (in a callback) is known by [`INSIDE`].

use super::guard::caught;
use super::id::mvWorldId;
use super::side::Side;
use crate::error::{Error, ErrorCode, Result};
use crate::world::{Identity, World, WorldDef};
use std::cell::{RefCell, UnsafeCell};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::*};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

/// Places: index1 of a world id is 1 … 65535.
const PLACES: usize = u16::MAX as usize;
/// Places are made in blocks that never move.
const BLOCK: usize = 1024;

/// The state of a lock that a writer holds.
const WRITER: u32 = u32::MAX;

struct Place {
    /// The number of readers, or [`WRITER`].
    lock: AtomicU32,
    /// How often the place was used.
    generation: AtomicU32,
    live: AtomicBool,
    /// Set when a panic was caught: the world may be half changed.
    faulted: AtomicBool,
    world: UnsafeCell<Option<Box<World>>>,
    side: Side,
}

// Sound: `world` is only reached through the lock, shared by readers and alone by a writer; the rest is atomic or
// has locks of its own. World itself may be shared and sent, which the next function has the compiler prove.
unsafe impl Sync for Place {}
unsafe impl Send for Place {}
const _: () = {
    const fn may_be_shared<T: Send + Sync>() {}
    may_be_shared::<World>();
};

/// What a reader sees.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub world: &'a World,
    pub side: &'a Side,
}

/// What a writer has.
pub(super) struct Edit<'a> {
    pub world: &'a mut World,
    pub side: &'a Side,
}

/// A world of which this thread is running a callback, and that callbacks may read.
struct Inside {
    place: usize,
    world: *const World,
}

thread_local! {
    static INSIDE: RefCell<Vec<Inside>> = const { RefCell::new(Vec::new()) };
}

/// What is free.
struct Free {
    /// Places never used start here.
    fresh: usize,
    /// Places used before, lowest first.
    used: BinaryHeap<Reverse<usize>>,
    /// What the last world of each of those left.
    identities: BTreeMap<usize, Identity>,
    live: usize,
}

fn free() -> MutexGuard<'static, Free> {
    static FREE: Mutex<Free> =
        Mutex::new(Free { fresh: 0, used: BinaryHeap::new(), identities: BTreeMap::new(), live: 0 });
    FREE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The place with this index; none if no world has ever been near it.
fn place(index: usize) -> Option<&'static Place> {
    block(index).get().map(|b| &b[index % BLOCK])
}

fn block(index: usize) -> &'static OnceLock<Box<[Place]>> {
    static BLOCKS: [OnceLock<Box<[Place]>>; PLACES / BLOCK + 1] =
        [const { OnceLock::new() }; PLACES / BLOCK + 1];
    &BLOCKS[index / BLOCK]
}

fn new_block() -> Box<[Place]> {
    let place = || Place {
        lock: AtomicU32::new(0),
        generation: AtomicU32::new(0),
        live: AtomicBool::new(false),
        faulted: AtomicBool::new(false),
        world: UnsafeCell::new(None),
        side: Side::default(),
    };
    std::iter::repeat_with(place).take(BLOCK).collect()
}

/// Ends a hold on a lock.
struct Hold<'a>(&'a AtomicU32, bool);

impl Drop for Hold<'_> {
    fn drop(&mut self) {
        if self.1 {
            self.0.store(0, Release);
        } else {
            self.0.fetch_sub(1, Release);
        }
    }
}

impl Place {
    fn try_read(&self) -> Option<Hold<'_>> {
        let more = |n| if n < WRITER - 1 { Some(n + 1) } else { None };
        self.lock.fetch_update(Acquire, Relaxed, more).ok().map(|_| Hold(&self.lock, false))
    }

    fn try_write(&self) -> Option<Hold<'_>> {
        let taken = self.lock.compare_exchange(0, WRITER, Acquire, Relaxed);
        taken.ok().map(|_| Hold(&self.lock, true))
    }

    /// Whether a world of this generation lives here, or any for generation 0.
    fn holds(&self, generation: u16) -> bool {
        self.live.load(Acquire) && (generation == 0 || self.generation.load(Acquire) == u32::from(generation))
    }
}

/// How a call names a world.
#[derive(Clone, Copy)]
pub(super) struct Target {
    index: usize,
    /// 0: whatever world is there; the caller looks up an id in it.
    generation: u16,
    what: &'static str,
}

impl Target {
    pub(super) fn world(id: mvWorldId) -> Result<Self> {
        if id.index1 == 0 {
            return Err(Error::new(ErrorCode::Null, "The world id is null."));
        }
        // A generation of 0 never was.
        if id.generation == 0 {
            return Err(gone("world"));
        }
        Ok(Self { index: usize::from(id.index1) - 1, generation: id.generation, what: "world" })
    }

    pub(super) fn of(index1: i32, world0: u16, what: &'static str) -> Result<Self> {
        if index1 == 0 {
            return Err(Error::new(ErrorCode::Null, format!("The {what} id is null.")));
        }
        Ok(Self { index: usize::from(world0), generation: 0, what })
    }

    fn place(self) -> Result<&'static Place> {
        place(self.index)
            .filter(|p| self.index < PLACES && p.holds(self.generation))
            .ok_or_else(|| gone(self.what))
    }
}

fn gone(what: &str) -> Error {
    let whose = if what == "world" { "The world".to_owned() } else { format!("The {what}'s world") };
    Error::new(ErrorCode::Stale, format!("{whose} was destroyed or never was."))
}

fn busy() -> Error {
    Error::new(ErrorCode::Busy, "Another thread is using the world.")
}

fn check_fault(place: &Place) -> Result<()> {
    if place.faulted.load(Acquire) {
        return Err(Error::new(
            ErrorCode::Faulted,
            "An internal fault was caught in this world earlier; it can only be destroyed.",
        ));
    }
    Ok(())
}

/// `f`, whose internal faults break the world. A panic goes on to the guard, which stands around every call.
fn watched<R>(place: &Place, f: impl FnOnce() -> Result<R>) -> Result<R> {
    struct Watch<'a>(&'a Place);
    impl Drop for Watch<'_> {
        fn drop(&mut self) {
            self.0.faulted.store(true, Release);
        }
    }
    let watch = Watch(place);
    let result = f();
    if !matches!(&result, Err(e) if e.code() == ErrorCode::Internal) {
        std::mem::forget(watch);
    }
    result
}

pub(super) fn read<R>(target: Target, f: impl FnOnce(View<'_>) -> Result<R>) -> Result<R> {
    let place = target.place()?;
    let Some(_hold) = place.try_read() else {
        return read_inside(target, place, f);
    };
    if !place.holds(target.generation) {
        return Err(gone(target.what));
    }
    check_fault(place)?;
    // Sound: this thread holds the lock as a reader, so nobody writes; `live` says that there is a world.
    let world = unsafe { (*place.world.get()).as_deref() }.ok_or_else(|| gone(target.what))?;
    watched(place, || f(View { world, side: &place.side }))
}

/// A read while somebody writes: allowed in a callback of that very step.
fn read_inside<R>(target: Target, place: &Place, f: impl FnOnce(View<'_>) -> Result<R>) -> Result<R> {
    let mine =
        |i: &RefCell<Vec<Inside>>| i.borrow().iter().rev().find(|i| i.place == target.index).map(|i| i.world);
    let world = INSIDE.try_with(mine).ok().flatten().ok_or_else(busy)?;
    // Sound: [`in_callback`] put the pointer there, keeps the reference it came from alive until the callback
    // returns, and takes it away then; the world is only read meanwhile.
    let world = unsafe { &*world };
    watched(place, || f(View { world, side: &place.side }))
}

fn locked() -> Error {
    Error::new(
        ErrorCode::Locked,
        "The world is inside a step or a query of this thread: callbacks must not change it.",
    )
}

pub(super) fn write<R>(target: Target, f: impl FnOnce(Edit<'_>) -> Result<R>) -> Result<R> {
    let place = target.place()?;
    let Some(_hold) = place.try_write() else {
        return Err(if is_inside(target.index) { locked() } else { busy() });
    };
    if !place.holds(target.generation) {
        return Err(gone(target.what));
    }
    check_fault(place)?;
    // Sound: this thread holds the lock as the writer, so nobody else reads or writes.
    let world = unsafe { (*place.world.get()).as_deref_mut() }.ok_or_else(|| gone(target.what))?;
    watched(place, || f(Edit { world, side: &place.side }))
}

fn is_inside(index: usize) -> bool {
    INSIDE.try_with(|i| i.borrow().iter().any(|i| i.place == index)).unwrap_or(false)
}

/// Runs one callback of a step or a query, during which this thread may read `world`, and is known to be inside.
pub(super) fn in_callback<R>(world: &World, f: impl FnOnce() -> R) -> R {
    struct Leave;
    impl Drop for Leave {
        fn drop(&mut self) {
            let _ = INSIDE.try_with(|i| i.borrow_mut().pop());
        }
    }
    let here = Inside { place: usize::from(world.identity.tag), world };
    let _ = INSIDE.try_with(|i| i.borrow_mut().push(here));
    let _leave = Leave;
    f()
}

/// Puts a new world into the lowest free place, after `prepare` had a go at it.
pub(super) fn create(def: &WorldDef, prepare: impl FnOnce(&mut World)) -> Result<mvWorldId> {
    def.validate()?;
    let (index, identity) = {
        let mut free = free();
        let index = match free.used.pop() {
            Some(Reverse(index)) => index,
            None if free.fresh < PLACES => {
                free.fresh += 1;
                free.fresh - 1
            }
            None => return Err(Error::new(ErrorCode::Capacity, "There are too many worlds.")),
        };
        let identity = free.identities.remove(&index).unwrap_or_else(|| Identity::new(index as u16));
        free.live += 1;
        (index, identity)
    };
    let place = &block(index).get_or_init(new_block)[index % BLOCK];
    // A place where this fails, which nothing known can make it do, stays empty for good.
    let made = caught(|| World::try_with_identity(def, identity));
    let mut world = made.inspect_err(|_| free().live -= 1)?;
    prepare(&mut world);
    // Somebody with an id of an older world may be looking in; that takes no time.
    let _hold = loop {
        match place.try_write() {
            Some(hold) => break hold,
            None => std::hint::spin_loop(),
        }
    };
    // Sound: the lock is held as the writer.
    unsafe { *place.world.get() = Some(Box::new(world)) };
    place.side.clear();
    place.faulted.store(false, Release);
    let generation = place.generation.fetch_add(1, AcqRel) + 1;
    place.live.store(true, Release);
    Ok(mvWorldId { index1: index as u16 + 1, generation: generation as u16 })
}

/// Takes a world out of its place. The only thing that can be done with a faulted world.
pub(super) fn destroy(id: mvWorldId) -> Result<()> {
    let target = Target::world(id)?;
    let place = target.place()?;
    let Some(hold) = place.try_write() else {
        return Err(if is_inside(target.index) { locked() } else { busy() });
    };
    if !place.holds(target.generation) {
        return Err(gone("world"));
    }
    place.live.store(false, Release);
    // Sound: the lock is held as the writer.
    let world = unsafe { (*place.world.get()).take() };
    place.side.clear();
    let faulted = place.faulted.load(Acquire);
    let last = place.generation.load(Acquire) >= u32::from(u16::MAX);
    drop(hold);
    let identity = caught(|| Ok(world.map(|w| w.into_identity())));
    let mut free = free();
    free.live -= 1;
    if let Ok(Some(identity)) = identity
        && !faulted
        && !last
    {
        free.identities.insert(target.index, identity);
        free.used.push(Reverse(target.index));
    }
    Ok(())
}

pub(super) fn world_count() -> usize {
    free().live
}

/// Whether this names a world that lives.
pub(super) fn is_world(id: mvWorldId) -> bool {
    Target::world(id).and_then(Target::place).is_ok()
}

/// The id of the world whose tag is this.
pub(super) fn world_id(tag: u16) -> mvWorldId {
    let generation = place(usize::from(tag)).map_or(0, |p| p.generation.load(Acquire));
    mvWorldId { index1: tag + 1, generation: generation as u16 }
}

/// What all worlds hold, as far as they can be read now.
pub(super) fn for_each_world(mut f: impl FnMut(View<'_>)) {
    let end = free().fresh;
    for index in 0..end {
        let target = Target { index, generation: 0, what: "world" };
        let _ = read(target, |view| {
            f(view);
            Ok(())
        });
    }
}

#[cfg(test)]
mod tests {
    use super::super::*;
    use super::*;

    fn new_world() -> mvWorldId {
        mvCreateWorld(Some(&mvDefaultWorldDef()))
    }

    #[test]
    fn a_panic_breaks_its_world_alone() {
        let (broken, whole) = (new_world(), new_world());
        let _: () = access::write_world(broken, |_| panic!("on purpose"));
        assert_eq!(mvGetLastError(), mv_errorInternal);
        for _ in 0..2 {
            assert_eq!(mvWorld_GetGravity(broken).y, 0.0);
            assert_eq!(mvGetLastError(), mv_errorFaulted);
        }
        mvWorld_Step(broken, 0.01, 1);
        assert_eq!(mvGetLastError(), mv_errorFaulted);
        assert!(mvWorld_IsValid(broken));
        assert_eq!(mvWorld_GetGravity(whole).y, -10.0);
        mvDestroyWorld(broken);
        assert!(!mvWorld_IsValid(broken));
        mvDestroyWorld(whole);
        assert_eq!(mvGetLastError(), mv_errorNone);
        // Nobody moves in where something broke.
        let next: Vec<_> = (0..3).map(|_| new_world()).collect();
        assert!(next.iter().all(|w| w.index1 != broken.index1));
        next.into_iter().for_each(|w| mvDestroyWorld(w));
    }

    #[test]
    fn a_place_whose_generations_are_used_up_retires() {
        let first = new_world();
        let place = place(usize::from(first.index1) - 1).unwrap();
        place.generation.store(u32::from(u16::MAX), Release);
        let last = mvWorldId { index1: first.index1, generation: u16::MAX };
        assert!(mvWorld_IsValid(last) && !mvWorld_IsValid(first));
        mvDestroyWorld(last);
        let others: Vec<_> = (0..3).map(|_| new_world()).collect();
        assert!(others.iter().all(|w| w.index1 != first.index1));
        others.into_iter().for_each(|w| mvDestroyWorld(w));
    }
}
