//! A step in steady state allocates nothing.

#[path = "common/scenes.rs"]
mod scenes;

use merev::broad_phase::{BroadPhaseKind, Layer};
use merev::math::vec3;
use merev::solver::SolverKind;
use merev::{Aabb, Float, Quat, WorldDef};
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

/// One test, as the counter counts for the whole program.
#[test]
fn steps_and_broad_phases_in_steady_state_allocate_nothing() {
    a_standing_pyramid();
    every_broad_phase();
}

fn a_standing_pyramid() {
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

/// Boxes on a grid, of which every fifth goes around a small square.
fn every_broad_phase() {
    for kind in BroadPhaseKind::ALL {
        let mut broad_phase = kind.build();
        let at = |i: u32, step: u32| {
            let turn = [(0.0, 0.0), (0.4, 0.0), (0.4, 0.4), (0.0, 0.4)][(i + step) as usize % 4];
            let corner = vec3((i % 10) as Float, (i / 10 % 10) as Float, (i / 100) as Float);
            Aabb::around(corner + vec3(turn.0, turn.1, 0.0), vec3(0.45, 0.45, 0.45))
        };
        for i in 0..1000 {
            broad_phase.insert(i, &at(i, 0), if i % 3 == 0 { Layer::Static } else { Layer::Moving });
        }
        let moved: Vec<u32> = (0..1000).step_by(5).collect();
        let (mut pairs, mut before) = (Vec::with_capacity(4000), 0);
        for step in 0..200 {
            if step == 120 {
                before = ALLOCATIONS.load(Relaxed);
            }
            moved.iter().for_each(|&i| broad_phase.update(i, &at(i, step)));
            broad_phase.find_pairs(&moved, &mut pairs);
        }
        let during = ALLOCATIONS.load(Relaxed) - before;
        assert!(!pairs.is_empty());
        assert_eq!(during, 0, "80 steps of {} made {during} allocations", kind.name());
    }
}
