//! How many sub-steps an island gets where the world has an accuracy to keep.
//!
//! A step is *rehearsed* now and then: taken with a half and a quarter of the sub-steps (or, where they are few, with
//! more), and thrown away. How the three answers close in on each other tells the error of each of them, and whether
//! more sub-steps would help at all \[Richardson 1911\]: the differences of a smooth motion fall by a constant factor,
//! those of a heap of colliding bodies do not.
//!
//! What such a comparison finds too late is a column that buckles, since it begins as slowly as one likes; what that needs is
//! known beforehand, see [`Column`].

use crate::math::{Float, Quat, Vec3, length, scalar};

/// An island's number of sub-steps is the world's times two to the power of its level, at most this.
pub const GREATEST_LEVEL: i32 = 5;

/// No island gets, or is rehearsed with, more sub-steps than this.
const MOST_SUB_STEPS: u32 = 1000;

/// The shortest and the longest time between rehearsals, in steps.
const SHORTEST_WAIT: u32 = 4;
const LONGEST_WAIT: u32 = 32;

/// As long without rehearsals, if more sub-steps were tried in vain.
const LONG_WAIT: u32 = 128;

/// The differences between answers have to fall by this factor from one to the next, or more sub-steps are of no use.
const LEAST_GAIN: Float = 1.7;

/// What more sub-steps are chosen for: this share of the allowed error, as a motion has easy moments and hard ones.
const GOAL: Float = 0.5;

/// An error that would stay below this share of what is allowed with half the sub-steps is a reason to halve them, if it
/// is found so often in a row. Each change of the sub-steps is a small disturbance: a pendulum's energy is kept to within
/// a constant times h² only as long as h stays.
const LOW: Float = 0.25;
const LOW_COUNT: u32 = 12;

/// By how much the contacts of a column have to be stiffer than what it just stands on.
const SAFETY: Float = 4.0;

/// The sub-steps of an island, and what is known of its error.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Pacing {
    /// It gets the world's number of sub-steps times two to this power.
    pub level: i32,
    /// Whether this step is.
    pub rehearsed: bool,
    /// Steps until the next rehearsal; 0: this one.
    wait: u32,
    /// How long the last wait was.
    last_wait: u32,
    /// The least level that keeps the island standing.
    least: i32,
    /// How many rehearsals in a row have found the error low.
    low: u32,
    /// Whether the last rehearsal asked for more sub-steps, and was not believed yet.
    asks: bool,
    /// By how many levels the last choice rose, and the error that this was to stay below.
    rise: i32,
    hope: Float,
    /// The error that the last rehearsal found: what a step adds, as a share of the way gone in it.
    pub error: Float,
}

impl Pacing {
    /// Before a step with this number of sub-steps: says whether it is to be rehearsed.
    pub fn begin_step(&mut self, sub_steps: u32) -> bool {
        self.level = self.level.min(most_level(sub_steps));
        let [_, _, finest] = self.levels(sub_steps);
        self.wait == 0 && finest <= most_level(sub_steps)
    }

    /// A step that is not rehearsed has been taken.
    pub fn pass(&mut self) {
        self.wait = self.wait.saturating_sub(1);
    }

    /// Islands have become one: it does what the more demanding of them needs, and looks again soon.
    pub fn join(&mut self, other: &Pacing) {
        self.level = self.level.max(other.level);
        self.error = self.error.max(other.error);
        self.wait = self.wait.min(other.wait);
        self.low = 0;
    }

    /// The three levels that a rehearsed step is taken at, from coarse to fine; the island's own is among them.
    pub fn levels(&self, sub_steps: u32) -> [i32; 3] {
        // Only so often can the world's number be halved.
        let coarsest = -(sub_steps.trailing_zeros() as i32);
        let finest = self.level.max(coarsest + 2);
        [finest - 2, finest - 1, finest]
    }

    /// The levels that are tried besides the island's own.
    pub fn trials(&self, sub_steps: u32) -> [i32; 2] {
        match self.levels(sub_steps) {
            [a, b, c] if c == self.level => [a, b],
            [a, b, c] if b == self.level => [a, c],
            [_, b, c] => [b, c],
        }
    }

    /// Takes note of what the island needs so as not to buckle, where the world's sub-steps make contacts of this
    /// stiffness \[rad/s\].
    pub fn stand(&mut self, column: Option<Column>, gravity: Float, stiffness: Float) {
        let least = column.map_or(0.0, |column| column.least_stiffness(gravity));
        let missing = SAFETY * least / (stiffness * stiffness);
        // Stiffness grows with the square of the sub-steps.
        self.least = if missing > 1.0 { (0.5 * scalar::log2(missing)).ceil() as i32 } else { 0 };
    }

    /// Chooses by what a rehearsal has shown: how far the answers of neighbouring levels lie apart, from coarse to fine,
    /// and what the accuracy allows, all as shares of the way.
    pub fn choose(&mut self, apart: [Float; 2], allowed: Float, sub_steps: u32) {
        let [_, _, finest] = self.levels(sub_steps);
        // Answers that agree exactly leave nothing to gain.
        let gain = if apart[1] > 0.0 { apart[0] / apart[1] } else { Float::INFINITY };
        let converges = gain >= LEAST_GAIN;
        // Second order is the best that there is; more is chance.
        let gain = if converges { gain.min(4.0) } else { LEAST_GAIN };
        self.error = apart[1] / (gain - 1.0);
        for _ in self.level..finest {
            self.error *= gain;
        }
        let most = most_level(sub_steps);
        self.wait = if self.rise > 0 && self.error > self.hope {
            self.give_up()
        } else if self.error > allowed && converges && self.level < most {
            self.ask_for_more(gain, allowed, most)
        } else {
            self.stay_or_fall(self.error * gain < LOW * allowed || !converges && self.error <= allowed)
        };
        self.level = self.level.max(self.least.min(most));
    }

    /// More sub-steps were in vain: a while without. As the others, says for how many steps.
    fn give_up(&mut self) -> u32 {
        self.level -= self.rise;
        (self.rise, self.asks, self.low) = (0, false, 0);
        LONG_WAIT
    }

    /// An impact in just one step is no reason; if two steps in a row want more, there are more.
    fn ask_for_more(&mut self, gain: Float, allowed: Float, most: i32) -> u32 {
        (self.rise, self.low) = (0, 0);
        self.asks = !self.asks;
        if self.asks {
            return 1;
        }
        let mut left = self.error;
        while left > GOAL * allowed && self.level < most && self.rise < 2 {
            left /= gain;
            self.level += 1;
            self.rise += 1;
        }
        self.hope = 0.5 * self.error;
        self.last_wait = SHORTEST_WAIT;
        self.last_wait
    }

    /// What stays as it is is looked at ever more seldom.
    fn stay_or_fall(&mut self, is_low: bool) -> u32 {
        (self.rise, self.asks) = (0, false);
        self.low = if is_low { self.low + 1 } else { 0 };
        self.last_wait = (2 * self.last_wait).clamp(SHORTEST_WAIT, LONGEST_WAIT);
        if self.low >= LOW_COUNT && self.level > self.least {
            self.level -= 1;
            self.low = 0;
            self.last_wait = SHORTEST_WAIT;
        }
        self.last_wait
    }
}

/// The highest level that stays within the most sub-steps.
fn most_level(sub_steps: u32) -> i32 {
    GREATEST_LEVEL.min((MOST_SUB_STEPS / sub_steps).max(1).ilog2() as i32)
}

/// An island as something that stands.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// How many bodies it has.
    pub bodies: usize,
    /// Of constraints above each other.
    pub height: u32,
    /// How many times its own weight a body carries, at most.
    pub ratio: Float,
    /// Of its smallest body \[m\].
    pub size: Float,
}

impl Column {
    /// The square of the least stiffness ω of its contacts \[rad²/s²\]. A chain of n blocks of the size L on springs m ω²
    /// buckles under its weight where n³ > 7.84 ω² L / g (Greenhill's column of n parts); a body's load in blocks
    /// stands for one n, and n columns that lean on each other are stiffer by n².
    fn least_stiffness(&self, gravity: Float) -> Float {
        let height = self.height as Float;
        let breadth = (self.bodies as Float / height).max(1.0);
        self.ratio * height * height * gravity / (7.84 * self.size * breadth * breadth)
    }
}

/// What a step has done to a body.
#[derive(Clone, Copy, Debug)]
pub struct Moved {
    /// \[m\]
    pub by: Vec3,
    /// Turn.
    pub turned: Quat,
    /// Velocity at the end \[m/s\].
    pub v: Vec3,
    /// \[rad/s\]
    pub w: Vec3,
}

impl Moved {
    /// The way of the body's farthest point, or what its velocity makes of it in a step \[m\]; `extent` is the distance
    /// of that point \[m\].
    pub fn way(&self, extent: Float, dt: Float) -> Float {
        let way = length(self.by) + extent * angle(&self.turned);
        way.max((length(self.v) + extent * length(self.w)) * dt)
    }

    /// How far another answer lies apart: of places, and of velocities by what they make of the next step \[m\].
    pub fn apart(&self, other: &Moved, extent: Float, dt: Float) -> Float {
        let place = length(self.by - other.by) + extent * angle(&(self.turned * other.turned.conjugate()));
        let speed = length(self.v - other.v) + extent * length(self.w - other.w);
        place.max(speed * dt)
    }
}

/// The angle of a turn of less than half a circle \[rad\].
fn angle(q: &Quat) -> Float {
    let sine = length(Vec3::new(q.i, q.j, q.k));
    2.0 * scalar::atan2(sine, q.w.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A motion whose error falls by four with each doubling, from `first` at level 0.
    fn smooth(pacing: &mut Pacing, first: Float, allowed: Float, sub_steps: u32) {
        let error = |level: i32| first * 16.0 / (1u64 << (2 * (level + 2))) as Float;
        let [a, b, c] = pacing.levels(sub_steps);
        pacing.choose([error(a) - error(b), error(b) - error(c)], allowed, sub_steps);
    }

    #[test]
    fn the_error_of_a_smooth_motion_is_found_and_met_and_no_more() {
        for sub_steps in [1, 2, 4, 6] {
            let mut pacing = Pacing::default();
            smooth(&mut pacing, 1.0, 1e-3, sub_steps);
            assert!((pacing.error - 1.0).abs() < 1e-3 && pacing.level == 0, "{pacing:?}");
            for _ in 0..9 {
                smooth(&mut pacing, 1.0, 1e-3, sub_steps);
            }
            assert_eq!(pacing.level, 5, "4⁻⁵ is the first below 1e-3");
            // The motion slows down.
            for _ in 0..80 {
                smooth(&mut pacing, 1e-5, 1e-3, sub_steps);
            }
            assert_eq!(pacing.level, 0);
        }
    }

    #[test]
    fn where_more_sub_steps_do_not_help_there_are_no_more() {
        let mut pacing = Pacing { level: 1, ..Pacing::default() };
        for _ in 0..10 {
            pacing.choose([0.5, 0.4], 1e-3, 4);
        }
        assert_eq!(pacing.level, 1);
        assert!(!pacing.begin_step(4));
        pacing.low = 0;
        for _ in 0..LOW_COUNT {
            pacing.choose([0.0, 0.0], 1e-3, 4);
        }
        assert_eq!((pacing.level, pacing.error), (0, 0.0));
        // The answers come nearer to each other, but the error does not fall.
        for _ in 0..10 {
            pacing.choose([0.4, 0.1], 1e-3, 4);
            assert!(pacing.level <= 2);
        }
        assert_eq!(pacing.level, 0);
    }

    /// Fifty cubes of a metre, at 240 sub-steps a second with 50 Hz: it takes 16 in place of 4; a pyramid as high does not.
    #[test]
    fn a_column_gets_what_it_stands_on() {
        let stiffness = 2.0 * scalar::PI * 50.4;
        let column = Column { bodies: 50, height: 50, ratio: 50.0, size: 0.87 };
        let mut pacing = Pacing::default();
        pacing.stand(Some(column), 10.0, stiffness);
        pacing.choose([0.0, 0.0], 1e-2, 4);
        assert_eq!(pacing.level, 2);
        pacing.stand(Some(Column { bodies: 1275, ..column }), 10.0, stiffness);
        for _ in 0..40 {
            pacing.choose([0.0, 0.0], 1e-2, 4);
        }
        assert_eq!(pacing.level, 0);
    }

    #[test]
    fn sub_steps_have_an_end() {
        let mut pacing = Pacing::default();
        for _ in 0..20 {
            smooth(&mut pacing, 1.0, 1e-9, 100);
        }
        assert_eq!(pacing.level, 3);
        // A step with another number of sub-steps keeps within it, too, and is not rehearsed beyond it.
        assert!(!Pacing::default().begin_step(999) && Pacing::default().begin_step(1000));
        pacing.begin_step(400);
        assert_eq!(pacing.level, 1);
    }

    #[test]
    fn levels_are_three_that_divide() {
        assert_eq!(Pacing::default().levels(4), [-2, -1, 0]);
        assert_eq!(Pacing::default().levels(6), [-1, 0, 1]);
        assert_eq!(Pacing::default().levels(1), [0, 1, 2]);
        assert_eq!(Pacing::default().trials(6), [-1, 1]);
        assert_eq!(Pacing { level: 3, ..Pacing::default() }.levels(1), [1, 2, 3]);
        assert_eq!(Pacing::default().trials(1), [1, 2]);
    }
}
