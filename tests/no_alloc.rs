//! A step in steady state allocates nothing.

#[path = "common/scenes.rs"]
mod scenes;

use merev::solver::SolverKind;
use merev::{Quat, WorldDef};
use scenes::{pyramid, sleepless, stack};
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

struct Counting;

static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: everything is passed on to the system's allocator; counting does not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Relaxed);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, p: *mut u8, layout: Layout) {
        unsafe { System.dealloc(p, layout) }
    }
    unsafe fn realloc(&self, p: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Relaxed);
        unsafe { System.realloc(p, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn a_step_in_steady_state_allocates_nothing() {
    let (mut scene, _) = pyramid(&sleepless(), Quat::identity(), 20);
    scene.steps(60);
    let before = ALLOCATIONS.load(Relaxed);
    scene.steps(60);
    let during = ALLOCATIONS.load(Relaxed) - before;
    assert_eq!(during, 0, "60 steps of a standing pyramid made {during} allocations");

    // One test, as the counter is of the whole program.
    for solver in SolverKind::ALL {
        let (mut scene, _) = stack(&WorldDef { solver, ..sleepless() }, Quat::identity(), 3);
        scene.steps(60);
        let before = ALLOCATIONS.load(Relaxed);
        scene.steps(20);
        let during = ALLOCATIONS.load(Relaxed) - before;
        assert_eq!(during, 0, "{}: 20 steps made {during} allocations", solver.name());
    }
}
