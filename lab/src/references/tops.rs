//! Bodies of revolution on a floor: a disc that rolls steadily, and a ball with its centre of mass off its middle that
//! slides. Up is y.

use super::extrapolation::Flow;
use crate::vector::{Q4, V3, add, cross, dot, norm, rotate, scale, sub, times, unit};

const UP: V3 = [0.0, 1.0, 0.0];

/// A flat cylinder of mass 1 that rolls on the rim of its lower face.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    pub radius: f64,
    /// Half of its thickness.
    pub half: f64,
    pub g: f64,
}

impl Disc {
    /// Moments about a diameter and about its axis, over mass.
    pub fn moments(&self) -> (f64, f64) {
        let square = self.radius * self.radius;
        (0.25 * square + self.half * self.half / 3.0, 0.5 * square)
    }

    /// How fast it goes round, tilted by an angle, with its centre of mass at rest. The spin lies along the line to the
    /// contact point, and Ω up × L is the torque of the floor; without thickness it is Ω² = 4 g / (a sin α).
    pub fn rate(&self, tilt: f64) -> f64 {
        let (s, c) = libm::sincos(tilt);
        let (across, along) = self.moments();
        let lever = self.radius * c - self.half * s;
        (self.g * lever / (s * (across * c - along * self.half / self.radius * s))).sqrt()
    }
}

/// A ball on a floor, its centre of mass off its middle, against its axis, by `offset`; mass 1.
#[derive(Clone, Copy, Debug)]
pub struct Top {
    pub radius: f64,
    pub offset: f64,
    /// About any axis through the centre of mass, over mass: those of the cases are equal.
    pub moment: f64,
    pub friction: f64,
    pub g: f64,
}

impl Top {
    /// Where its axis points, and its spin, at the given times, as long as it slides. It begins without a velocity,
    /// turned by `rotation`, its axis y in its own frame.
    pub fn motions(&self, rotation: Q4, spin: V3, ends: &[f64]) -> Vec<[V3; 2]> {
        let arm = |n: V3| sub(scale(n, self.offset), scale(UP, self.radius));
        let slope = |y: &[f64], d: &mut [f64]| {
            let (q, w) = ([y[0], y[1], y[2], y[3]], [y[4], y[5], y[6]]);
            let n = rotate(q, UP);
            let s = arm(n);
            let turning = cross(w, s);
            // The contact keeps the height.
            let v = [y[7], -turning[1], y[8]];
            let slip = add(v, turning);
            let slip = [slip[0], 0.0, slip[2]];
            let force = sub(UP, scale(slip, self.friction / norm(slip)));
            let turned = scale(cross(s, force), 1.0 / self.moment);
            let inward = cross(w, scale(cross(w, n), self.offset));
            let load = (self.g - inward[1]) / (1.0 + cross(turned, s)[1]);
            let half = times([w[0], w[1], w[2], 0.0], q).map(|x| 0.5 * x);
            d[..4].copy_from_slice(&half);
            d[4..7].copy_from_slice(&scale(turned, load));
            (d[7], d[8]) = (load * force[0], load * force[2]);
        };
        let mut start = rotation.to_vec();
        start.extend(spin);
        start.extend([0.0, 0.0]);
        let mut flow = Flow::new(slope, start, 1e-11);
        let mut found = Vec::new();
        for &t in ends {
            if !flow.advance(t) {
                break;
            }
            let axis = rotate(unit([flow.y[0], flow.y[1], flow.y[2], flow.y[3]]), UP);
            found.push([axis, [flow.y[4], flow.y[5], flow.y[6]]]);
        }
        found
    }

    /// Jellett's integral for a spin and an axis, over mass: −L · (from the centre of mass to the contact).
    pub fn jellett(&self, spin: V3, axis: V3) -> f64 {
        self.moment * (self.radius * spin[1] - self.offset * dot(spin, axis))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::{angle, conjugate, turn};

    /// A vector in a body's frame.
    fn own(q: Q4, w: V3) -> V3 {
        rotate(conjugate(q), w)
    }

    /// The catalogue's figure.
    #[test]
    fn a_coin_goes_round_as_fast_as_the_catalogue_says() {
        let coin = Disc { radius: 0.05, half: 0.0, g: 9.81 };
        assert!((coin.rate(5.0_f64.to_radians()) - 94.8924).abs() < 5e-4, "{}", coin.rate(0.0872665));
    }

    /// Rolling without slip by its equations, from where the closed form says: the tilt stays, and it goes round at its
    /// rate.
    #[test]
    fn a_rolling_disc_stays_as_it_is() {
        let disc = Disc { radius: 0.5, half: 0.02, g: 9.81 };
        let tilt = 0.5;
        let (across, along) = disc.moments();
        let slope = |y: &[f64], d: &mut [f64]| {
            let (q, w) = ([y[0], y[1], y[2], y[3]], [y[4], y[5], y[6]]);
            let n = rotate(q, UP);
            let down = sub(scale(n, n[1]), UP);
            let e = scale(down, 1.0 / norm(down));
            let r = sub(scale(e, disc.radius), scale(n, disc.half));
            let n_dot = cross(w, n);
            let down_dot = add(scale(n, n_dot[1]), scale(n_dot, n[1]));
            let e_dot = scale(sub(down_dot, scale(e, dot(e, down_dot))), 1.0 / norm(down));
            let r_dot = sub(scale(e_dot, disc.radius), scale(n_dot, disc.half));
            let local = own(q, w);
            let l = rotate(q, [across * local[0], along * local[1], across * local[2]]);
            let torque = sub(cross(r, sub(scale(UP, disc.g), cross(w, r_dot))), cross(w, l));
            // (I + r² − r rᵀ) w' = torque, by elimination.
            let mut m = [[0.0; 4]; 3];
            for k in 0..3 {
                let mut unit = [0.0; 3];
                unit[k] = 1.0;
                let u = own(q, unit);
                let i = rotate(q, [across * u[0], along * u[1], across * u[2]]);
                for row in 0..3 {
                    m[row][k] = i[row] - r[row] * r[k] + if row == k { dot(r, r) } else { 0.0 };
                }
            }
            (0..3).for_each(|row| m[row][3] = torque[row]);
            for k in 0..3 {
                for row in 0..3 {
                    if row != k {
                        let f = m[row][k] / m[k][k];
                        (0..4).for_each(|c| m[row][c] -= f * m[k][c]);
                    }
                }
            }
            let turning = times([w[0], w[1], w[2], 0.0], q).map(|x| 0.5 * x);
            d[..4].copy_from_slice(&turning);
            (0..3).for_each(|k| d[4 + k] = m[k][3] / m[k][k]);
        };
        let rate = disc.rate(tilt);
        let (s, c) = libm::sincos(tilt);
        let (e, n) = ([c, -s, 0.0], [s, c, 0.0]);
        let w = add(scale(e, -rate * s), scale(n, rate * s * disc.half / disc.radius));
        let mut start = turn([0.0, 0.0, 1.0], -tilt).to_vec();
        start.extend(w);
        let mut flow = Flow::new(slope, start, 1e-12);
        assert!(flow.advance(3.0));
        let axis = rotate([flow.y[0], flow.y[1], flow.y[2], flow.y[3]], UP);
        assert!((angle(axis, UP) - tilt).abs() < 1e-8, "{}", angle(axis, UP));
        let exact = rotate(turn(UP, 3.0 * rate), n);
        assert!(angle(axis, exact) < 1e-6, "{axis:?} {exact:?}");
    }

    /// Friction may do what it likes: Jellett's integral stays; and with the spin that it has, the top turns over.
    #[test]
    fn a_top_turns_over_and_keeps_its_integral() {
        let top = Top { radius: 0.02, offset: 0.006, moment: 0.4 * 0.02 * 0.02, friction: 0.3, g: 9.81 };
        let rotation = turn([0.0, 0.0, 1.0], 0.1);
        let ends: Vec<f64> = (1..=40).map(|k| 0.05 * f64::from(k)).collect();
        let motions = top.motions(rotation, [0.0, 150.0, 0.0], &ends);
        let start = top.jellett([0.0, 150.0, 0.0], rotate(rotation, UP));
        for [axis, spin] in &motions {
            let off = top.jellett(*spin, *axis) / start - 1.0;
            assert!(off.abs() < 1e-9, "{off}");
        }
        let tilts: Vec<f64> = motions.iter().map(|m| angle(m[0], UP)).collect();
        println!("{tilts:.3?}");
        assert!(tilts.last().unwrap() > &2.5, "{tilts:?}");
    }
}
