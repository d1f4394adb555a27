//! The bouncing ball: hits as measured beside hits in closed form.

use crate::programs::Frame;

pub const GRAVITY: f64 = 10.0;
pub const RESTITUTION: f64 = 0.9;
/// How far it falls [m].
pub const FALL: f64 = 4.0;
/// Height of its centre when it touches [m].
const FLOOR: f64 = -4.0;
/// [kg]: diameter 1 m, density 1.
pub const MASS: f64 = std::f64::consts::PI / 6.0;

/// Approach speed of hit `k` [m/s].
pub fn exact_speed(k: usize) -> f64 {
    (0..k).fold((2.0 * GRAVITY * FALL).sqrt(), |v, _| v * RESTITUTION)
}

/// Time of hit `k` [s]: the fall, and flights that take twice the speed at which they began over gravity.
pub fn exact_time(k: usize) -> f64 {
    (1..=k).fold((2.0 * FALL / GRAVITY).sqrt(), |t, j| t + 2.0 * exact_speed(j) / GRAVITY)
}

/// When all bouncing ends [s].
pub fn exact_end() -> f64 {
    (2.0 * FALL / GRAVITY).sqrt() * (1.0 + RESTITUTION) / (1.0 - RESTITUTION)
}

/// Energy above that of lying on the floor, at a time, as a share of that at the start.
pub fn exact_energy(time: f64) -> f64 {
    if time >= exact_end() {
        return 0.0;
    }
    let hits = (0..).take_while(|&k| exact_time(k) <= time && exact_speed(k) > 1e-9).count();
    (0..2 * hits).fold(1.0, |e, _| e * RESTITUTION)
}

/// A hit that was seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// [s]
    pub time: f64,
    /// Speed at which it leaves [m/s].
    pub speed: f64,
}

/// The hits of a run. A frame shows the state after a step, with the ball in flight again: when that flight began
/// follows from height and speed.
pub fn hits(frames: &[Frame]) -> Vec<Hit> {
    let mut hits = Vec::new();
    for frame in frames {
        let Some(measures) = frame.measures else { continue };
        if frame.hit_speed > 0.0 {
            let height = f64::from(frame.poses[0][1]) - FLOOR;
            let speed = measures.momentum[1] / MASS;
            let under_root = (speed * speed + 2.0 * GRAVITY * height).max(0.0);
            let since = (under_root.sqrt() - speed) / GRAVITY;
            hits.push(Hit { time: frame.time - since, speed: under_root.sqrt() });
        }
    }
    hits
}

/// How many hits are farther apart than a step of this length, so that each has a frame of its own.
pub fn distinct_hits(dt: f64) -> usize {
    (0..).take_while(|&k| 2.0 * exact_speed(k + 1) / GRAVITY > dt).count() + 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::Measures;

    #[test]
    fn closed_form_is_that_of_the_textbook() {
        let times = [0.8944, 2.5044, 3.9534, 5.2574];
        for (k, t) in times.into_iter().enumerate() {
            assert!((exact_time(k) - t).abs() < 1e-4, "{k}: {}", exact_time(k));
        }
        assert!((exact_end() - 16.994).abs() < 5e-4);
        assert!((exact_time(400) - exact_end()).abs() < 1e-9);
        assert!((exact_speed(1) - 8.0498).abs() < 1e-4);
        assert!((exact_energy(0.5) - 1.0).abs() < 1e-12);
        assert!((exact_energy(1.0) - 0.81).abs() < 1e-12);
        assert_eq!(exact_energy(17.0), 0.0);
    }

    /// A frame in flight tells when the flight began.
    #[test]
    fn a_hit_is_traced_back() {
        let (since, speed) = (0.006, 5.0);
        let height = speed * since - 0.5 * GRAVITY * since * since;
        let frame = Frame {
            time: 1.0,
            elapsed: 0.0,
            hit_speed: 1.0,
            measures: Some(Measures {
                energy: 0.0,
                momentum: [0.0, MASS * (speed - GRAVITY * since), 0.0],
                penetration: 0.0,
            }),
            poses: vec![[0.0, (height + FLOOR) as f32, 0.0, 0.0, 0.0, 0.0, 1.0]],
        };
        let found = hits(&[frame]);
        assert!((found[0].time - (1.0 - since)).abs() < 1e-6, "{found:?}");
        assert!((found[0].speed - speed).abs() < 1e-6, "{found:?}");
    }

    #[test]
    fn late_hits_come_faster_than_steps() {
        let n = distinct_hits(0.01);
        assert!(2.0 * exact_speed(n - 1) / GRAVITY > 0.01 && 2.0 * exact_speed(n) / GRAVITY <= 0.01, "{n}");
    }
}
