//! What the shell keeps beside a world because C wants a pointer to it: strings, events, manifolds, hulls,
//! drawings.
//!
//! Readers may ask for these at the same time, so each kind has a lock of its own, held for a moment.

use super::contact::mvManifold;
use super::debug_draw::DrawArrays;
use super::event::EventArrays;
use super::hull_data::{Block, mvHullData};
use crate::world::{ContactId, World};
use core::ffi::c_char;
use std::collections::BTreeMap;
use std::ffi::CString;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Whose name.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Named {
    Body(u32),
    Shape(u32),
}

#[derive(Default)]
pub(super) struct Side {
    names: Mutex<BTreeMap<Named, CString>>,
    events: Mutex<EventArrays>,
    manifolds: Mutex<BTreeMap<ContactId, Box<mvManifold>>>,
    hulls: Mutex<BTreeMap<u32, (u16, Block)>>,
    drawing: Mutex<DrawArrays>,
}

// Sound: events hold users' pointers, which are only handed back, never followed; a drawing's strings point into texts
// beside them.
unsafe impl Send for Side {}
unsafe impl Sync for Side {}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Side {
    /// Forgets everything: another world moves in.
    pub(super) fn clear(&self) {
        lock(&self.names).clear();
        *lock(&self.events) = EventArrays::default();
        lock(&self.manifolds).clear();
        lock(&self.hulls).clear();
        *lock(&self.drawing) = DrawArrays::default();
    }

    /// A step begins: what was valid until then is not any more.
    pub(super) fn begin_step(&self) {
        lock(&self.events).stale();
        lock(&self.manifolds).clear();
    }

    /// The name as a C string that stays until it is asked for after a change.
    pub(super) fn name(&self, whose: Named, name: &str) -> *const c_char {
        if name.is_empty() {
            return c"".as_ptr();
        }
        let mut names = lock(&self.names);
        let kept = names.entry(whose).or_default();
        if kept.as_bytes() != name.as_bytes() {
            *kept = super::error::c_string(name);
        }
        kept.as_ptr()
    }

    /// The arrays of the last step's events, made when they are first asked for.
    pub(super) fn events<R>(&self, world: &World, f: impl FnOnce(&mut EventArrays) -> R) -> R {
        let mut events = lock(&self.events);
        events.fill(world);
        f(&mut events)
    }

    /// The manifold of a contact, kept until the next step.
    pub(super) fn manifold(
        &self,
        contact: ContactId,
        make: impl FnOnce() -> mvManifold,
    ) -> *const mvManifold {
        &raw const **lock(&self.manifolds).entry(contact).or_insert_with(|| Box::new(make()))
    }

    /// The hull of a shape, kept until the shape changes or its slot is used again.
    pub(super) fn hull(
        &self,
        index: u32,
        generation: u16,
        make: impl FnOnce() -> Block,
    ) -> *const mvHullData {
        let mut hulls = lock(&self.hulls);
        if hulls.get(&index).is_none_or(|(g, _)| *g != generation) {
            hulls.insert(index, (generation, make()));
        }
        hulls[&index].1.as_ptr()
    }

    /// The arrays of the latest drawing, to be filled anew.
    pub(super) fn drawing<R>(&self, f: impl FnOnce(&mut DrawArrays) -> R) -> R {
        f(&mut lock(&self.drawing))
    }

    /// A shape got other geometry.
    pub(super) fn forget_hull(&self, index: u32) {
        lock(&self.hulls).remove(&index);
    }
}
