//! A body in a plane whose one contact point slides and sticks on a floor by Coulomb's law, by its modes: a slender rod
//! on a round end, or a box on an edge.
//!
//! The contact point is at r = (l cos θ, −l sin θ − ρ) from the centre of mass, ρ the radius of the end (0 for an
//! edge). With ω = −θ', mass 1 and moment k², N and T the contact's force: x'' = T, y'' = N − g,
//! k² ω' = r_x N − r_y T, and the height is kept: y = l sin θ + ρ. Sliding, T = −μ N sign(v), which leaves
//! N p = g − l ω² sin θ with p = 1 + l cos θ (l cos θ − μ sign(v) (l sin θ + ρ)) / k². Where p is not positive,
//! Painlevé's paradox, the point is stopped at once by an impact without approach [Génot, Brogliato 1999].

use super::extrapolation::Flow;

/// What slides.
#[derive(Clone, Copy, Debug)]
pub struct Rod {
    /// From the centre of mass to the end's centre \[m\].
    pub arm: f64,
    /// Of the end \[m\].
    pub radius: f64,
    /// Moment of inertia over mass \[m²\].
    pub moment: f64,
    pub friction: f64,
    pub g: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// To this side.
    Slide(f64),
    Stick,
}

/// Where it is: the centre's way along the floor, θ, and their changes with time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    pub x: f64,
    pub angle: f64,
    pub speed: f64,
    pub spin: f64,
}

impl State {
    fn of(y: &[f64]) -> Self {
        Self { x: y[0], angle: y[1], speed: y[2], spin: y[3] }
    }

    fn numbers(self) -> Vec<f64> {
        vec![self.x, self.angle, self.speed, self.spin]
    }
}

/// Between looks for a change of the mode \[s\].
const PACE: f64 = 1e-3;

impl Rod {
    /// Of the centre of mass over the floor.
    pub fn height(&self, angle: f64) -> f64 {
        self.arm * libm::sin(angle) + self.radius
    }

    /// l cos θ, l sin θ.
    fn lever(&self, s: State) -> (f64, f64) {
        let (sin, cos) = libm::sincos(s.angle);
        (self.arm * cos, self.arm * sin)
    }

    /// Of the contact point.
    fn slip(&self, s: State) -> f64 {
        s.speed + s.spin * self.height(s.angle)
    }

    /// What the normal force gives the contact point's approach; not positive in Painlevé's paradox.
    fn response(&self, s: State, side: f64) -> f64 {
        let (c, h) = (self.lever(s).0, self.height(s.angle));
        1.0 + c * (c - self.friction * side * h) / self.moment
    }

    /// x'', ω', N, T.
    fn forces(&self, s: State, mode: Mode) -> [f64; 4] {
        let ((c, sin), h) = (self.lever(s), self.height(s.angle));
        let load = self.g - s.spin * s.spin * sin;
        match mode {
            Mode::Slide(side) => {
                let n = load / self.response(s, side);
                let t = -self.friction * n * side;
                [t, (c * n + h * t) / self.moment, n, t]
            }
            Mode::Stick => {
                let turn = (c * load + h * s.spin * s.spin * c) / (self.moment + c * c + h * h);
                let t = -turn * h + s.spin * s.spin * c;
                [t, turn, load - turn * c, t]
            }
        }
    }

    /// How it goes on from here, the contact point stopped if it has no other way. None: it leaves the floor.
    fn choose(&self, s: &mut State) -> Option<Mode> {
        let slip = self.slip(*s);
        if slip.abs() > 1e-9 {
            let side = slip.signum();
            if self.response(*s, side) > 0.0 {
                return Some(Mode::Slide(side));
            }
            self.stop(s);
        }
        let [_, _, n, t] = self.forces(*s, Mode::Stick);
        if n <= 0.0 {
            return None;
        }
        if t.abs() <= self.friction * n {
            return Some(Mode::Stick);
        }
        let side = -t.signum();
        (self.response(*s, side) > 0.0).then_some(Mode::Slide(side))
    }

    /// An impact after which the contact point rests: angular momentum about it stays.
    fn stop(&self, s: &mut State) {
        let (c, h) = (self.lever(*s).0, self.height(s.angle));
        // Moments about the point of x', y' = −ω l cos θ and ω.
        let about = self.moment * s.spin - h * s.speed + c * c * s.spin;
        s.spin = about / (self.moment + c * c + h * h);
        s.speed = -s.spin * h;
    }

    /// Whether a mode has come to its end.
    fn ends(&self, s: State, mode: Mode) -> bool {
        let [_, _, n, t] = self.forces(s, mode);
        match mode {
            _ if n < 0.0 => true,
            Mode::Slide(side) => self.slip(s) * side < 0.0 || self.response(s, side) <= 0.0,
            Mode::Stick => t.abs() > self.friction * n,
        }
    }

    /// The states at the given times, which grow from 0; fewer if it leaves the floor or lies down before.
    pub fn states(&self, start: State, ends: &[f64]) -> Vec<State> {
        let (mut now, mut t) = (start, 0.0);
        let Some(mut mode) = self.choose(&mut now) else { return Vec::new() };
        let mut found = Vec::new();
        for &end in ends {
            while t < end {
                let pace = PACE.min(end - t);
                let next = self.advance(now, mode, pace);
                if !self.ends(next, mode) {
                    (now, t) = (next, if pace < PACE { end } else { t + pace });
                    continue;
                }
                // Where in the pace it ends.
                let (mut low, mut high) = (0.0, pace);
                for _ in 0..50 {
                    let middle = 0.5 * (low + high);
                    let is_over = self.ends(self.advance(now, mode, middle), mode);
                    if is_over { high = middle } else { low = middle }
                }
                (now, t) = (self.advance(now, mode, high), t + high);
                if matches!(mode, Mode::Slide(_)) && self.slip(now).abs() < 1e-6 {
                    now.speed = -now.spin * self.height(now.angle);
                }
                match self.choose(&mut now) {
                    Some(next) => mode = next,
                    None => return found,
                }
            }
            if !(0.0..std::f64::consts::PI).contains(&now.angle) {
                break;
            }
            found.push(now);
        }
        found
    }

    fn advance(&self, from: State, mode: Mode, time: f64) -> State {
        if time == 0.0 {
            return from;
        }
        let slope = |y: &[f64], d: &mut [f64]| {
            let s = State::of(y);
            let [a, turn, ..] = self.forces(s, mode);
            d.copy_from_slice(&[s.speed, -s.spin, a, turn]);
        };
        let mut flow = Flow::new(slope, from.numbers(), 1e-13);
        flow.advance(time);
        State::of(&flow.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLENDER: Rod = Rod { arm: 0.5, radius: 0.0, moment: 1.0 / 12.0, friction: 1.0, g: 9.81 };

    fn start(degrees: f64) -> State {
        State { x: 0.0, angle: degrees.to_radians(), speed: 2.0, spin: 0.0 }
    }

    /// The least friction of the paradox is 4/3, at tan θ = 2: the catalogue's figure.
    #[test]
    fn the_paradox_begins_at_four_thirds() {
        let least = |friction: f64| {
            let rod = Rod { friction, ..SLENDER };
            (1..900).map(|k| rod.response(start(0.1 * f64::from(k)), 1.0)).fold(f64::INFINITY, f64::min)
        };
        assert!(least(1.3333) > 0.0 && least(1.334) < 0.0);
        let at_two =
            Rod { friction: 4.0 / 3.0, ..SLENDER }.response(start(libm::atan(2.0).to_degrees()), 1.0);
        assert!(at_two.abs() < 1e-14, "{at_two}");
    }

    /// Steps of Moreau's kind know of no modes and no paradox: one contact's impulse by cases, in three coordinates.
    fn stepped(rod: &Rod, start: State, end: f64, h: f64) -> State {
        let (mut x, mut y, mut angle) = (start.x, rod.height(start.angle), start.angle);
        let (mut vx, mut vy, mut w) = (start.speed, 0.0, start.spin);
        for _ in 0..(end / h).round() as usize {
            vy -= h * rod.g;
            let (sin, cos) = libm::sincos(angle);
            let (rx, ry) = (rod.arm * cos, -rod.arm * sin - rod.radius);
            // The contact point's velocity, the gap made good over a step.
            let (n, t) = (vy + w * rx + (y - rod.height(angle)) / h, vx - w * ry);
            let (nn, nt, tt) =
                (1.0 + rx * rx / rod.moment, -rx * ry / rod.moment, 1.0 + ry * ry / rod.moment);
            let det = nn * tt - nt * nt;
            let stick = [(-n * tt + t * nt) / det, (-t * nn + n * nt) / det];
            let slide = |side: f64| {
                let pn = -n / (nn - rod.friction * side * nt);
                [pn, -rod.friction * side * pn]
            };
            let fits = |side: f64, p: [f64; 2]| p[0] >= 0.0 && (t + nt * p[0] + tt * p[1]) * side >= 0.0;
            let p = if n >= 0.0 {
                [0.0; 2]
            } else if stick[0] >= 0.0 && stick[1].abs() <= rod.friction * stick[0] {
                stick
            } else {
                [1.0, -1.0].into_iter().map(|s| (s, slide(s))).find(|&(s, p)| fits(s, p)).unwrap().1
            };
            (vx, vy, w) = (vx + p[1], vy + p[0], w + (rx * p[0] - ry * p[1]) / rod.moment);
            (x, y, angle) = (x + h * vx, y + h * vy, angle - h * w);
        }
        State { x, angle, speed: vx, spin: w }
    }

    #[test]
    fn modes_and_steps_agree() {
        for (friction, last) in [(0.3, 0.4), (1.0, 0.5), (1.6, 0.5)] {
            let rod = Rod { friction, ..SLENDER };
            let ends = [0.1, 0.3, last];
            let found = rod.states(start(60.0), &ends);
            assert_eq!(found.len(), 3, "{friction}");
            for (s, end) in found.iter().zip(ends) {
                let (a, b) = (stepped(&rod, start(60.0), end, 2e-5), stepped(&rod, start(60.0), end, 1e-5));
                // The steps' own error goes with their length.
                let off = |p: State| (p.x - s.x).abs().max((p.angle - s.angle).abs());
                assert!(off(b) < 2e-4, "{friction} {end}: {s:?} {b:?}");
                assert!(off(b) < 0.7 * off(a) + 1e-6, "{friction} {end}: {} {}", off(a), off(b));
            }
        }
    }
}
