//! Poses as 16-bit integers: positions on a grid over the box that the bodies stay in, rotations as components.

use crate::programs::{Frame, Pose};

/// Packed poses: frame after frame, body after body, seven little-endian 16-bit integers.
pub struct Packed {
    /// Least coordinates [m].
    pub low: [f64; 3],
    /// Width of the grid [m].
    pub step: [f64; 3],
    pub bytes: Vec<u8>,
}

/// Packs the poses at the start and after every step. A body that is not there yet has rotation 0.
pub fn pack(start: &[Pose], frames: &[Frame], bodies: usize) -> Packed {
    let all = || std::iter::once(start).chain(frames.iter().map(|f| f.poses.as_slice()));
    let (mut low, mut high) = ([f64::MAX; 3], [f64::MIN; 3]);
    for pose in all().flatten() {
        for k in 0..3 {
            low[k] = low[k].min(f64::from(pose[k]));
            high[k] = high[k].max(f64::from(pose[k]));
        }
    }
    let mut step = [0.0; 3];
    for k in 0..3 {
        if low[k] > high[k] {
            (low[k], high[k]) = (0.0, 0.0);
        }
        step[k] = ((high[k] - low[k]) / 65535.0).max(1e-9);
    }
    let mut bytes = Vec::with_capacity((frames.len() + 1) * bodies * 14);
    for poses in all() {
        for i in 0..bodies {
            let Some(pose) = poses.get(i) else {
                bytes.extend([0; 14]);
                continue;
            };
            for k in 0..3 {
                let cell = ((f64::from(pose[k]) - low[k]) / step[k]).round() as u16;
                bytes.extend(cell.to_le_bytes());
            }
            for &component in &pose[3..] {
                bytes.extend(((component * 32767.0).round() as i16).to_le_bytes());
            }
        }
    }
    Packed { low, step, bytes }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(poses: Vec<Pose>) -> Frame {
        Frame { time: 0.0, elapsed: 0.0, hit_speed: 0.0, measures: None, poses }
    }

    #[test]
    fn poses_come_back_within_half_a_cell() {
        let start = [[-5.0, 0.5, 0.0, 0.0, 0.0, 0.0, 1.0]];
        let later = frame(vec![[5.0, 9.5, 0.0, 0.5, -0.5, 0.5, -0.5], [1.234, 2.0, 0.0, 0.6, 0.0, 0.0, 0.8]]);
        let packed = pack(&start, std::slice::from_ref(&later), 2);
        assert_eq!(packed.bytes.len(), 2 * 2 * 14);
        let value = |frame: usize, body: usize, k: usize| {
            let at = 14 * (2 * frame + body) + 2 * k;
            let raw = [packed.bytes[at], packed.bytes[at + 1]];
            if k < 3 {
                packed.low[k] + packed.step[k] * f64::from(u16::from_le_bytes(raw))
            } else {
                f64::from(i16::from_le_bytes(raw)) / 32767.0
            }
        };
        for (body, pose) in later.poses.iter().enumerate() {
            for (k, &x) in pose.iter().enumerate() {
                let cell = if k < 3 { packed.step[k] } else { 1.0 / 32767.0 };
                assert!((value(1, body, k) - f64::from(x)).abs() <= 0.51 * cell + 1e-7, "{body} {k}");
            }
        }
        // The second body is not there at the start.
        assert!((3..7).all(|k| value(0, 1, k) == 0.0));
    }
}
