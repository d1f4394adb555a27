//! How a world behaves, and what can be measured of it.

use super::access::{read_world, write_world};
use super::guard::{c_count, neutral};
use super::id::mvWorldId;
use super::math::mvVec3;
use super::{Flag, mvFloat};
use crate::error::{Error, ErrorCode};
use core::ffi::c_int;

/// How overlap of contacts is recovered.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvContactTuning {
    /// How stiff contacts are, as a fraction of the sub-step rate.
    pub stiffness: mvFloat,
    /// How strongly recovery is damped; 1 is critical.
    pub damping_ratio: mvFloat,
    /// The greatest speed at which overlap is pushed out [m/s].
    pub contact_speed: mvFloat,
}

/// Milliseconds of the last step, by stage.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvProfile {
    /// The whole step.
    pub step: f32,
    /// Boxes around shapes.
    pub update_bounds: f32,
    /// Pairs of shapes whose boxes meet.
    pub pairs: f32,
    /// Contact points.
    pub collide: f32,
    /// Islands.
    pub islands: f32,
    /// Rehearsals, where an accuracy is to be kept.
    pub rehearse: f32,
    /// Laying out the constraints.
    pub prepare: f32,
    /// Solving, all sub-steps.
    pub solve: f32,
    /// Moving the bodies.
    pub transforms: f32,
    /// Falling asleep.
    pub sleep: f32,
    /// Events.
    pub events: f32,
}

/// How much there is of everything.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvCounters {
    /// Bodies of all types.
    pub body_count: c_int,
    /// Awake bodies, kinematic ones included.
    pub awake_body_count: c_int,
    /// Shapes.
    pub shape_count: c_int,
    /// Joints.
    pub joint_count: c_int,
    /// Pairs of shapes whose boxes meet.
    pub contact_count: c_int,
    /// Contacts that acted in the last step.
    pub constraint_count: c_int,
    /// Those of them that had to be solved one by one.
    pub overflow_count: c_int,
    /// Islands that are awake.
    pub island_count: c_int,
    /// The longest way through the trees of the broad phase.
    pub tree_height: c_int,
    /// Bytes that the world holds.
    pub byte_count: i64,
}

/// Conserved quantities and errors of a world, as it is now.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvStepReport {
    /// Energy of translation and rotation of the dynamic bodies [J].
    pub kinetic_energy: f64,
    /// Energy of the dynamic bodies in the field of gravity, zero at the world's origin [J].
    pub potential_energy: f64,
    /// Sum of the momenta: x, y, z [kg m/s].
    pub linear_momentum: [f64; 3],
    /// Sum of the angular momenta about the world's origin: x, y, z [kg m^2/s].
    pub angular_momentum: [f64; 3],
    /// The deepest overlap of any contact [m].
    pub worst_penetration: mvFloat,
    /// The greatest error of what rigid joints hold: of lengths [m].
    pub joint_gap: mvFloat,
    /// The same of angles [rad].
    pub joint_angle_gap: mvFloat,
    /// The greatest approach speed left at a loaded contact point [m/s].
    pub residual: mvFloat,
    /// The sub-steps of the last step, as it was asked for.
    pub sub_step_count: c_int,
    /// The most sub-steps that an island had in the last step: more than that only with an accuracy to keep.
    pub most_sub_step_count: c_int,
    /// The greatest error that rehearsals of awake islands found last: what a step adds to the motion, as a share of the
    /// way gone in it. 0 without an accuracy.
    pub error: mvFloat,
    /// The solver of the last step: one of the mv_solver... constants.
    pub solver: super::def::mvSolverKind,
    /// The greatest error of the contact laws at any point when the solver was done [m/s]; softStep does not measure
    /// it and leaves 0.
    pub solver_residual: mvFloat,
    /// The islands that an exact solver (lemke, dantzig, proximalAdmm) was asked to solve in the last step.
    pub solve_count: c_int,
    /// Those of them that were too large for it, and swept by projected Gauss-Seidel instead.
    pub too_large_count: c_int,
    /// Those of them that it did not solve, and that were swept instead.
    pub unsolved_count: c_int,
    /// The islands swept instead of solved since the world began.
    pub fallback_count: i64,
    /// Steps so far.
    pub step_count: i64,
    /// Bodies put to rest because their state stopped being finite.
    pub quarantined_count: i64,
    /// How much there is of everything.
    pub counters: mvCounters,
    /// Milliseconds of the last step.
    pub profile: mvProfile,
}

const NO_PROFILE: mvProfile = mvProfile {
    step: 0.0,
    update_bounds: 0.0,
    pairs: 0.0,
    collide: 0.0,
    islands: 0.0,
    rehearse: 0.0,
    prepare: 0.0,
    solve: 0.0,
    transforms: 0.0,
    sleep: 0.0,
    events: 0.0,
};

const NOTHING: mvCounters = mvCounters {
    body_count: 0,
    awake_body_count: 0,
    shape_count: 0,
    joint_count: 0,
    contact_count: 0,
    constraint_count: 0,
    overflow_count: 0,
    island_count: 0,
    tree_height: 0,
    byte_count: 0,
};

neutral! {
    mvContactTuning = mvContactTuning { stiffness: 0.0, damping_ratio: 0.0, contact_speed: 0.0 };
    mvProfile = NO_PROFILE;
    mvCounters = NOTHING;
    mvStepReport = mvStepReport {
        kinetic_energy: 0.0,
        potential_energy: 0.0,
        linear_momentum: [0.0; 3],
        angular_momentum: [0.0; 3],
        worst_penetration: 0.0,
        joint_gap: 0.0,
        joint_angle_gap: 0.0,
        residual: 0.0,
        sub_step_count: 0,
        most_sub_step_count: 0,
        error: 0.0,
        solver: 0,
        solver_residual: 0.0,
        solve_count: 0,
        too_large_count: 0,
        unsolved_count: 0,
        fallback_count: 0,
        step_count: 0,
        quarantined_count: 0,
        counters: NOTHING,
        profile: NO_PROFILE,
    };
}

/// Set gravity, and wake all bodies.
/// @param worldId the world
/// @param gravity the acceleration [m/s^2]
/// @note Errors: mv_errorNotFinite.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetGravity(world_id: mvWorldId, gravity: mvVec3) {
    write_world(world_id, |e| e.world.set_gravity(gravity.raw()));
}

/// Get gravity.
/// @param worldId the world
/// @return the acceleration [m/s^2]; zero for a bad world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetGravity(world_id: mvWorldId) -> mvVec3 {
    read_world(world_id, |v| Ok(v.world.gravity().into()))
}

/// Let bodies fall asleep, or wake all and keep them awake.
/// @param worldId the world
/// @param flag whether bodies may sleep
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_EnableSleeping(world_id: mvWorldId, flag: Flag) {
    write_world(world_id, |e| {
        e.world.enable_sleeping(super::def_check::flag("flag", flag)?);
        Ok(())
    });
}

/// May bodies fall asleep?
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_IsSleepingEnabled(world_id: mvWorldId) -> bool {
    read_world(world_id, |v| Ok(v.world.def().enable_sleep))
}

/// Keep contact impulses from step to step, or not. Off is for experiments.
/// @param worldId the world
/// @param flag whether to keep them
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_EnableWarmStarting(world_id: mvWorldId, flag: Flag) {
    write_world(world_id, |e| {
        e.world.enable_warm_starting(super::def_check::flag("flag", flag)?);
        Ok(())
    });
}

/// Are contact impulses kept from step to step?
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_IsWarmStartingEnabled(world_id: mvWorldId) -> bool {
    read_world(world_id, |v| Ok(v.world.def().enable_warm_starting))
}

/// Set the approach speed up to which nothing bounces.
/// @param worldId the world
/// @param value the speed [m/s], >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetRestitutionThreshold(world_id: mvWorldId, value: mvFloat) {
    write_world(world_id, |e| e.world.set_restitution_threshold(value));
}

/// Get the approach speed up to which nothing bounces.
/// @param worldId the world
/// @return the speed [m/s]; 0 for a bad world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetRestitutionThreshold(world_id: mvWorldId) -> mvFloat {
    read_world(world_id, |v| Ok(v.world.def().restitution_threshold))
}

/// Set the approach speed above which collisions make hit events.
/// @param worldId the world
/// @param value the speed [m/s], >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetHitEventThreshold(world_id: mvWorldId, value: mvFloat) {
    write_world(world_id, |e| e.world.set_hit_event_threshold(value));
}

/// Get the approach speed above which collisions make hit events.
/// @param worldId the world
/// @return the speed [m/s]; 0 for a bad world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetHitEventThreshold(world_id: mvWorldId) -> mvFloat {
    read_world(world_id, |v| Ok(v.world.def().hit_event_threshold))
}

/// Set how overlap of contacts is recovered.
/// @param worldId the world
/// @param stiffness how stiff contacts are, as a fraction of the sub-step rate, > 0 and at most 0.5
/// @param dampingRatio how strongly recovery is damped, > 0; 1 is critical
/// @param contactSpeed the greatest speed at which overlap is pushed out [m/s], >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetContactTuning(
    world_id: mvWorldId,
    stiffness: mvFloat,
    damping_ratio: mvFloat,
    contact_speed: mvFloat,
) {
    write_world(world_id, |e| e.world.set_contact_tuning(stiffness, damping_ratio, contact_speed));
}

/// Get how overlap of contacts is recovered.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetContactTuning(world_id: mvWorldId) -> mvContactTuning {
    read_world(world_id, |v| {
        let d = v.world.def();
        Ok(mvContactTuning {
            stiffness: d.contact_stiffness,
            damping_ratio: d.contact_damping_ratio,
            contact_speed: d.contact_speed,
        })
    })
}

/// Set the greatest speed of bodies.
/// @param worldId the world
/// @param maximumLinearSpeed the speed [m/s], > 0; infinity for no limit
/// @note Errors: mv_errorRange, also for NaN.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetMaximumLinearSpeed(world_id: mvWorldId, maximum_linear_speed: mvFloat) {
    write_world(world_id, |e| e.world.set_maximum_linear_speed(maximum_linear_speed));
}

/// Get the greatest speed of bodies.
/// @param worldId the world
/// @return the speed [m/s], infinity for no limit; 0 for a bad world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetMaximumLinearSpeed(world_id: mvWorldId) -> mvFloat {
    read_world(world_id, |v| Ok(v.world.def().maximum_linear_speed))
}

/// Set the accuracy to keep: see mvWorldDef.accuracy.
/// @param worldId the world
/// @param accuracy the error that a step may add, as a share of the way gone in it, 0 to 1; 0: exactly the sub-steps asked for
/// @note Errors: mv_errorRange, mv_errorNotFinite, mv_errorUnsupported: not 0 with another solver than softStep.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetAccuracy(world_id: mvWorldId, accuracy: mvFloat) {
    write_world(world_id, |e| e.world.set_accuracy(accuracy));
}

/// Get the accuracy to keep.
/// @param worldId the world
/// @return a share of the way; 0 for none, and for a bad world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetAccuracy(world_id: mvWorldId) -> mvFloat {
    read_world(world_id, |v| Ok(v.world.def().accuracy))
}

/// Get the number of bodies that the next step moves.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetAwakeBodyCount(world_id: mvWorldId) -> c_int {
    read_world(world_id, |v| Ok(c_count(v.world.awake_bodies().len())))
}

/// Set the number of threads that step the world. Only 1 is built yet.
/// @param worldId the world
/// @param count the number of threads
/// @note Errors: mv_errorRange below 1, mv_errorUnsupported above.
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_SetWorkerCount(world_id: mvWorldId, count: c_int) {
    write_world(world_id, |_| match count {
        1 => Ok(()),
        2.. => Err(Error::new(ErrorCode::Unsupported, "Only one thread is built yet: count must be 1.")),
        _ => Err(Error::new(ErrorCode::Range, format!("count is {count}; it must be at least 1."))),
    });
}

/// Get the number of threads that step the world.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetWorkerCount(world_id: mvWorldId) -> c_int {
    read_world(world_id, |v| Ok(c_count(v.world.def().worker_count as usize)))
}

/// Get how long the last step took, by stage.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetProfile(world_id: mvWorldId) -> mvProfile {
    read_world(world_id, |v| Ok(v.world.profile().into()))
}

/// Get how much there is of everything.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetCounters(world_id: mvWorldId) -> mvCounters {
    read_world(world_id, |v| Ok(v.world.counters().into()))
}

/// Get conserved quantities and errors. This measures the world as it is now, at about the cost of finding all
/// contact points.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetStepReport(world_id: mvWorldId) -> mvStepReport {
    read_world(world_id, |v| {
        let r = v.world.step_report();
        Ok(mvStepReport {
            kinetic_energy: r.kinetic_energy,
            potential_energy: r.potential_energy,
            linear_momentum: r.linear_momentum,
            angular_momentum: r.angular_momentum,
            worst_penetration: r.worst_penetration,
            joint_gap: r.joint_gap,
            joint_angle_gap: r.joint_angle_gap,
            residual: r.residual,
            sub_step_count: c_count(r.sub_steps as usize),
            most_sub_step_count: c_count(r.most_sub_steps as usize),
            error: r.error,
            solver: r.solve.solver.resolved() as i32,
            solver_residual: r.solve.residual,
            solve_count: c_count(r.solve.solves as usize),
            too_large_count: c_count(r.solve.too_large as usize),
            unsolved_count: c_count(r.solve.failed as usize),
            fallback_count: i64::try_from(r.solve.fallbacks).unwrap_or(i64::MAX),
            step_count: i64::try_from(r.steps).unwrap_or(i64::MAX),
            quarantined_count: i64::try_from(r.quarantined).unwrap_or(i64::MAX),
            counters: r.counters.into(),
            profile: r.profile.into(),
        })
    })
}

/// Get a hash of the state of all bodies and contacts: placements, momenta, impulses and sleep. Two worlds that
/// were made and stepped in the same way have the same hash, on every platform.
/// @param worldId the world
#[unsafe(no_mangle)]
pub extern "C" fn mvWorld_GetStateHash(world_id: mvWorldId) -> u64 {
    read_world(world_id, |v| Ok(v.world.state_hash()))
}

impl From<crate::world::Profile> for mvProfile {
    fn from(p: crate::world::Profile) -> Self {
        Self {
            step: p.step,
            update_bounds: p.update_bounds,
            pairs: p.find_pairs,
            collide: p.update_contacts,
            islands: p.build_islands,
            rehearse: p.rehearse,
            prepare: p.prepare,
            solve: p.solve,
            transforms: p.advance,
            sleep: p.update_sleep,
            events: p.publish_events,
        }
    }
}

impl From<crate::world::Counters> for mvCounters {
    fn from(c: crate::world::Counters) -> Self {
        Self {
            body_count: c_count(c.bodies),
            awake_body_count: c_count(c.awake_bodies),
            shape_count: c_count(c.shapes),
            joint_count: c_count(c.joints),
            contact_count: c_count(c.contacts),
            constraint_count: c_count(c.constraints),
            overflow_count: c_count(c.overflow),
            island_count: c_count(c.islands),
            tree_height: c_count(c.tree_height),
            byte_count: i64::try_from(c.bytes).unwrap_or(i64::MAX),
        }
    }
}
