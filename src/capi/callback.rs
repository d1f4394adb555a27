//! C callbacks as the engine calls them. While one runs, its thread may read the world and is known to be inside.

use super::def::{mvCustomFilterFcn, mvFrictionCallback, mvPreSolveFcn, mvRestitutionCallback};
use super::registry::in_callback;
use crate::world::{CustomFilter, Mixing, PreSolve};
use core::ffi::c_void;
use std::sync::Arc;

/// A user's pointer: handed back, never followed.
#[derive(Clone, Copy)]
struct Context(*mut c_void);

// Sound: the pointer is only passed back to the user's own function, which answers for its threads.
unsafe impl Send for Context {}
unsafe impl Sync for Context {}

impl Context {
    fn get(self) -> *mut c_void {
        self.0
    }
}

// Every call below is sound because who passed the function pointer promises a function of that signature which
// does not unwind; all arguments are plain values.

pub(super) fn custom_filter(fcn: mvCustomFilterFcn, context: *mut c_void) -> Option<Arc<CustomFilter>> {
    let (fcn, context) = (fcn?, Context(context));
    Some(Arc::new(move |world, a, b| {
        in_callback(world, || unsafe { fcn(a.into(), b.into(), context.get()) } != 0)
    }))
}

pub(super) fn pre_solve(fcn: mvPreSolveFcn, context: *mut c_void) -> Option<Arc<PreSolve>> {
    let (fcn, context) = (fcn?, Context(context));
    Some(Arc::new(move |world, a, b, point, normal| {
        in_callback(
            world,
            || unsafe { fcn(a.into(), b.into(), point.into(), normal.into(), context.get()) } != 0,
        )
    }))
}

pub(super) fn friction(fcn: mvFrictionCallback, context: *mut c_void) -> Option<Arc<Mixing>> {
    let (fcn, context) = (fcn?, Context(context));
    Some(Arc::new(move |world, a, ia, b, ib| {
        in_callback(world, || unsafe { fcn(a, ia, b, ib, context.get()) })
    }))
}

pub(super) fn restitution(fcn: mvRestitutionCallback, context: *mut c_void) -> Option<Arc<Mixing>> {
    let (fcn, context) = (fcn?, Context(context));
    Some(Arc::new(move |world, a, ia, b, ib| {
        in_callback(world, || unsafe { fcn(a, ia, b, ib, context.get()) })
    }))
}
