//! One step, as a list of its stages.

use super::{BodyType, World};
use crate::body::{NONE, SetId};
use crate::error::{Error, ErrorCode, Result, check};
use crate::math::{Float, Vec3};
use crate::solver::{Lanes, Settings};
use std::time::Instant;

impl World {
    /// Moves the world by `dt` seconds in `sub_steps` equal parts. With `dt` 0 only contacts are brought up to
    /// date.
    ///
    /// # Errors
    /// NotFinite or Range: `dt` is not a finite number ≥ 0 or has no inverse, or `sub_steps` is not in 1 … 1000.
    pub fn try_step(&mut self, dt: Float, sub_steps: u32) -> Result<()> {
        check::not_negative("time_step", dt)?;
        if !(1..=1000).contains(&sub_steps) {
            return Err(Error::new(
                ErrorCode::Range,
                format!("sub_steps is {sub_steps}; it must be 1 … 1000."),
            ));
        }
        if dt > 0.0 && !(sub_steps as Float / dt).is_finite() {
            return Err(Error::new(
                ErrorCode::Range,
                format!("time_step is {dt}; its sub-steps are too short to be counted."),
            ));
        }
        let settings = self.begin(dt, sub_steps);
        let mut clock = Clock::start();
        self.update_bounds(dt);
        self.profile.update_bounds = clock.lap();
        self.find_pairs();
        self.profile.find_pairs = clock.lap();
        self.update_contacts(dt);
        self.profile.update_contacts = clock.lap();
        self.build_islands();
        self.profile.build_islands = clock.lap();
        if dt > 0.0 {
            self.rehearse(&settings);
            self.profile.rehearse = clock.lap();
            self.work.prepare(
                &self.bodies,
                &mut self.contacts,
                &self.joints,
                &mut self.islands,
                &settings,
                None,
            );
            self.profile.prepare = clock.lap();
            self.work.solve(&self.bodies, &mut self.contacts, &mut self.joints, &settings);
            self.judge_rehearsals(&settings);
            self.profile.solve = clock.lap();
            self.advance(dt);
            self.profile.advance = clock.lap();
            self.update_sleep(dt);
            self.profile.update_sleep = clock.lap();
        }
        self.publish_events(dt);
        self.profile.publish_events = clock.lap();
        self.end(&settings);
        self.profile.step = clock.total();
        Ok(())
    }

    fn begin(&mut self, dt: Float, sub_steps: u32) -> Settings {
        self.events.begin_step();
        self.scratch.fell_asleep.clear();
        self.profile = super::Profile::default();
        // As the thesis has it: the steps of an iterative solver are its iterations, unless they are given apart.
        let (sub_steps, iterations) = match self.def.solver_iterations {
            0 if self.def.solver.iterates() => (1, sub_steps),
            0 => (sub_steps, 1),
            n => (sub_steps, n),
        };
        Settings {
            solver: self.def.solver,
            integrator: self.def.integrator,
            gravity: self.def.gravity,
            dt,
            sub_steps,
            last_h: self.last_h,
            stiffness: self.def.contact_stiffness,
            damping_ratio: self.def.contact_damping_ratio,
            push_out_between_moving: self.def.contact_speed * self.seed.rb_separation_force,
            push_out_on_static: self.def.contact_speed * self.seed.sb_separation_force,
            restitution_threshold: self.def.restitution_threshold,
            maximum_linear_speed: self.def.maximum_linear_speed,
            warm_starting: self.def.enable_warm_starting,
            load_memory: self.def.enable_load_memory && self.def.enable_warm_starting,
            wide: self.def.lanes != Lanes::One,
            iterations,
            friction_facets: self.def.friction_facets,
            shuffle: self.def.shuffle_contacts,
            over_correct: self.def.over_correct,
            separation_between_moving: self.seed.rb_separation_force,
            separation_on_static: self.seed.sb_separation_force,
        }
    }

    /// Stage 8: poses, momenta and world inertia; kinematic bodies go their way.
    fn advance(&mut self, dt: Float) {
        let mut broken = std::mem::take(&mut self.scratch.broken);
        broken.clear();
        self.work.bodies.write_back(&mut self.bodies, &mut broken);
        let set = &mut self.bodies.sets[SetId::AWAKE.0 as usize];
        for row in 0..set.len() {
            if self.bodies.bodies[set.index[row] as usize].island == NONE {
                let (v, w) = (set.velocity(row), set.angular_velocity(row));
                let mut motion = set.motion[row];
                motion.shift(v * dt);
                motion.q = crate::integrate::turn_by(&motion.q, w * dt);
                if motion.is_finite() {
                    set.motion[row] = motion;
                } else {
                    broken.push(set.index[row]);
                }
            }
        }
        for &body in &broken {
            self.quarantine(body as usize);
        }
        self.scratch.broken = broken;
        self.keep_boxes_around_shapes();
    }

    /// Stage 11: forces act for one step only.
    fn end(&mut self, settings: &Settings) {
        if settings.dt > 0.0 {
            let set = &mut self.bodies.sets[SetId::AWAKE.0 as usize];
            for drive in &mut set.drive {
                (drive.force, drive.torque) = (Vec3::zeros(), Vec3::zeros());
            }
            self.last_h = settings.dt / settings.sub_steps as Float;
        }
        self.last_sub_steps = settings.sub_steps;
        self.counts.steps += 1;
    }

    /// A body whose state stopped being finite keeps its last finite one and is disabled.
    fn quarantine(&mut self, body: usize) {
        let (set, row) = self.bodies.at_mut(body);
        let motion = &mut set.motion[row];
        (motion.p, motion.l) = (Vec3::zeros(), Vec3::zeros());
        self.bodies.bodies[body].quarantined = true;
        self.counts.quarantined += 1;
        debug_assert!(self.bodies.bodies[body].body_type != BodyType::Static);
        self.disable_body(body);
    }
}

/// Milliseconds of each stage.
struct Clock {
    start: Instant,
    last: Instant,
}

impl Clock {
    fn start() -> Self {
        let now = Instant::now();
        Self { start: now, last: now }
    }

    fn lap(&mut self) -> f32 {
        let now = Instant::now();
        let ms = now.duration_since(self.last).as_secs_f32() * 1e3;
        self.last = now;
        ms
    }

    fn total(&self) -> f32 {
        self.start.elapsed().as_secs_f32() * 1e3
    }
}
