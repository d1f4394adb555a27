//! Mechanisms: a top on its tip, a train of gears, a differential, a crank, bars in windows. Each runs upright and turned as a
//! whole by a random rotation, is held against its closed form, and both copies must agree.

mod common;

use common::Random;
use merev::constraint::joint::{
    Drive, GearJoint, JointKind, Motor, PrismaticJoint, RevoluteJoint, SphericalJoint,
};
use merev::math::{length, quat_about, rotate, scalar, vec3};
use merev::shape::MassData;
use merev::world::{BodyDef, JointDef, JointId, WorldDef};
use merev::{BodyId, Float, Mat3, Pose, Quat, Vec3, World};

const SINGLE: bool = size_of::<Float>() == 4;
const DT: Float = 1.0 / 60.0;

/// A world under construction: everything is said in upright coordinates and placed turned.
struct Turned {
    world: World,
    turn: Quat,
}

impl Turned {
    fn new(turn: Quat, gravity: Float) -> Self {
        let gravity = turn * vec3(0.0, -gravity, 0.0);
        let def = WorldDef { gravity, enable_sleep: false, ..WorldDef::default() };
        Self { world: World::try_new(&def).unwrap(), turn }
    }

    fn ground(&mut self) -> BodyId {
        self.world.create_body(&BodyDef { rotation: self.turn, ..BodyDef::fixed(Vec3::zeros()) }).unwrap()
    }

    /// A body whose axes lie as `rotation` says.
    fn body(&mut self, at: Vec3, rotation: Quat, mass: Float, inertia: Vec3) -> BodyId {
        let def = BodyDef { rotation: self.turn * rotation, ..BodyDef::dynamic(self.turn * at) };
        let id = self.world.create_body(&def).unwrap();
        let data = MassData { mass, center: Vec3::zeros(), inertia: Mat3::from_diagonal(&inertia) };
        self.world.body_mut(id).unwrap().set_mass_data(&data).unwrap();
        id
    }

    fn wheel(&mut self, at: Vec3) -> BodyId {
        self.body(at, Quat::identity(), 1.0, Vec3::repeat(0.1))
    }

    /// A joint whose frames stand at `p`, turned by `q`.
    fn join(&mut self, kind: JointKind, a: BodyId, b: BodyId, p: Vec3, q: Quat) -> JointId {
        let [fa, fb] = [a, b].map(|id| {
            let t = self.world.body(id).unwrap().transform();
            Pose::new(t.point_back(self.turn * p), t.q.conjugate() * (self.turn * q))
        });
        self.world.create_joint(&JointDef::new(kind, a, b).frames(fa, fb)).unwrap()
    }

    fn gear(&mut self, a: JointId, b: JointId, ratio: Float) {
        let gear = GearJoint::between(&self.world, a, b, ratio).unwrap();
        let [on_a, on_b] = [a, b].map(|j| self.world.joint(j).unwrap().body_b());
        self.world.create_joint(&JointDef::new(JointKind::Gear(gear), on_a, on_b)).unwrap();
    }

    fn steps(&mut self, count: usize) {
        (0..count).for_each(|_| self.world.try_step(DT, 4).unwrap());
    }

    fn angle(&self, joint: JointId) -> Float {
        self.world.joint(joint).unwrap().coordinate()
    }

    /// Angular velocity, upright \[rad/s\].
    fn spin(&self, id: BodyId) -> Vec3 {
        self.turn.conjugate() * self.world.body(id).unwrap().angular_velocity()
    }

    fn center(&self, id: BodyId) -> Vec3 {
        self.turn.conjugate() * self.world.body(id).unwrap().world_center()
    }

    fn energy(&self) -> f64 {
        let report = self.world.step_report();
        report.kinetic_energy + report.potential_energy
    }
}

/// Runs a scene upright and turned; what they read must be the same to `tolerance`.
fn both<const N: usize>(tolerance: Float, scene: impl Fn(Quat) -> [Float; N]) {
    let [upright, turned] = [Quat::identity(), Random(77).rotation()].map(scene);
    let apart = upright.iter().zip(&turned).map(|(a, b)| (a - b).abs()).fold(0.0, Float::max);
    println!("upright and turned differ by {apart:.1e}: {upright:.5?} {turned:.5?}");
    assert!(apart <= tolerance, "{upright:?} and {turned:?}");
}

fn hinge() -> JointKind {
    JointKind::Revolute(RevoluteJoint::default())
}

fn driven(speed: Float, max_force: Float) -> JointKind {
    let motor = Motor { enable: true, speed, max_force };
    JointKind::Revolute(RevoluteJoint { drive: Drive { motor, ..Drive::default() } })
}

/// A heavy symmetric top on a ball joint, let go in steady precession at the tilt θ:
///   I₁ cos θ Ω² − I₃ ω₃ Ω + m g l = 0   (Goldstein, *Classical Mechanics*, §5.7),
/// with I₁ about the tip. The angle it went about the vertical, the tilt and ω₃ must stay what they were.
#[test]
fn a_top_goes_round_steadily() {
    let (m, l, g) = (1.0, 0.1, 9.81);
    let (i3, across) = (0.02, 0.01);
    let i1 = across + m * l * l;
    let tilt = scalar::PI / 6.0;
    let (s, c) = scalar::sin_cos(tilt);
    for (name, spin) in [("slow", 30.0), ("fast", 120.0)] {
        let b: Float = i3 * spin;
        let omega = (b - (b * b - 4.0 * i1 * c * m * g * l).sqrt()) / (2.0 * i1 * c);
        both(if SINGLE { 2e-3 } else { 1e-6 }, |turn| {
            let mut w = Turned::new(turn, g);
            let ground = w.ground();
            // The axis of the top is its own y.
            let axis = vec3(s, c, 0.0);
            let top = w.body(axis * l, quat_about(Vec3::z(), -tilt), m, vec3(across, i3, across));
            w.join(
                JointKind::Spherical(SphericalJoint::default()),
                ground,
                top,
                Vec3::zeros(),
                Quat::identity(),
            );
            let start = axis * spin + (Vec3::y() - axis * c) * omega;
            let mut body = w.world.body_mut(top).unwrap();
            body.set_angular_velocity(turn * start).unwrap();
            body.set_linear_velocity(turn * start.cross(&(axis * l))).unwrap();
            let e0 = w.energy();
            let (mut gone, mut nutation, mut slip, mut drift) = (0.0, 0.0 as Float, 0.0 as Float, 0.0_f64);
            let mut last = axis;
            for _ in 0..600 {
                w.steps(1);
                let now = w.center(top) / l;
                gone += scalar::atan2(last.z * now.x - last.x * now.z, last.x * now.x + last.z * now.z);
                nutation =
                    nutation.max((scalar::atan2((now.x * now.x + now.z * now.z).sqrt(), now.y) - tilt).abs());
                let own = rotate(&w.world.body(top).unwrap().transform().q, Vec3::y());
                slip = slip.max((w.world.body(top).unwrap().angular_velocity().dot(&own) - spin).abs());
                drift = drift.max((w.energy() - e0).abs());
                last = now;
            }
            let off = gone / (omega * 10.0) - 1.0;
            println!(
                "{name} top: precession off by {off:.1e}, nutation {nutation:.1e} rad, spin off by {slip:.1e} rad/s, \
                 energy {:.1e}",
                drift / e0
            );
            assert!(off.abs() < 2e-3, "went {gone} rad of {}", omega * 10.0);
            assert!(nutation < 2e-3 && slip < 1e-3 * spin && drift < 1e-3 * e0);
            [gone, nutation]
        });
    }
}

#[test]
fn gears_keep_their_ratio() {
    both(if SINGLE { 2e-3 } else { 1e-9 }, |turn| {
        let mut w = Turned::new(turn, 0.0);
        let g = w.ground();
        // A train of three: 1 : 2 : 3, the second one in between.
        let hinges = [0.0, 2.0, 4.0].map(|x| {
            let b = w.wheel(vec3(x, 0.0, 0.0));
            w.join(hinge(), g, b, vec3(x, 0.0, 0.0), Quat::identity())
        });
        w.gear(hinges[0], hinges[1], 2.0);
        w.gear(hinges[1], hinges[2], 1.5);
        w.world.joint_mut(hinges[0]).unwrap().set_kind(driven(12.0, 1.0)).unwrap();
        w.steps(1200);
        let angle = hinges.map(|h| w.angle(h));
        println!("gears: {angle:?}");
        assert!(angle[0] > 200.0);
        assert!((angle[0] + 2.0 * angle[1]).abs() < 1e-3 && (angle[1] + 1.5 * angle[2]).abs() < 1e-3);
        // A joint that goes takes its gears along.
        let count = w.world.joint_count();
        w.world.destroy_joint(hinges[1], true).unwrap();
        assert_eq!(w.world.joint_count(), count - 3);
        w.steps(30);
        w.world.validate();
        angle
    });
}

#[test]
fn a_differential_shares_what_drives_it() {
    both(if SINGLE { 2e-3 } else { 1e-9 }, |turn| {
        // A carrier about z with a pinion across it, between two side wheels about z that run on the carrier.
        let mut w = Turned::new(turn, 0.0);
        let g = w.ground();
        let [carrier, left, right, pinion] =
            [Vec3::zeros(), -Vec3::z(), Vec3::z(), Vec3::x()].map(|p| w.wheel(p));
        let along = Quat::identity();
        let driven_by = w.join(driven(3.0, 100.0), g, carrier, Vec3::zeros(), along);
        let on_left = w.join(hinge(), carrier, left, -Vec3::z(), along);
        let on_right = w.join(hinge(), carrier, right, Vec3::z(), along);
        let across = quat_about(Vec3::y(), scalar::PI / 2.0);
        let on_pinion = w.join(hinge(), carrier, pinion, Vec3::x(), across);
        for (side, wheel, ratio) in [(on_left, left, 1.0), (on_right, right, -1.0)] {
            let gear = GearJoint::between(&w.world, side, on_pinion, ratio).unwrap();
            w.world.create_joint(&JointDef::new(JointKind::Gear(gear), wheel, pinion)).unwrap();
        }
        // The left wheel is held by the brake: the right one then turns twice as fast as the carrier.
        w.join(driven(0.0, 1e4), g, left, -Vec3::z(), along);
        w.steps(180);
        let [l, r, c] = [left, right, carrier].map(|b| w.spin(b).z);
        println!("differential: left {l}, right {r}, carrier {c}");
        assert!((c - 3.0).abs() < 0.01 && l.abs() < 0.01 && (r - 6.0).abs() < 0.01);
        assert!(((l + r) * 0.5 - c).abs() < 1e-3);
        let sum = w.angle(on_left) + w.angle(on_right);
        assert!(sum.abs() < 1e-3, "what one loses on the carrier the other gains: {sum}");
        assert!((w.angle(driven_by) - 9.0).abs() < 0.1);
        [l, r, c]
    });
}

/// A slider crank turned by a motor: x = r cos φ + √(l² − r² sin² φ), through both dead centres.
#[test]
fn a_crank_moves_its_slider() {
    both(if SINGLE { 1e-3 } else { 1e-7 }, |turn| {
        let (r, l): (Float, Float) = (0.3, 1.0);
        let mut w = Turned::new(turn, 9.81);
        let g = w.ground();
        let along = Quat::identity();
        let rod = |w: &mut Turned, a: Vec3, b: Vec3| {
            let size = length(b - a);
            w.body((a + b) * 0.5, along, 1.0, Vec3::repeat(size * size / 12.0))
        };
        let (pin, end) = (vec3(r, 0.0, 0.0), vec3(r + l, 0.0, 0.0));
        let crank = rod(&mut w, Vec3::zeros(), pin);
        let link = rod(&mut w, pin, end);
        let slider = w.wheel(end);
        let shaft = w.join(driven(6.0, 1e3), g, crank, Vec3::zeros(), along);
        w.join(hinge(), crank, link, pin, along);
        w.join(hinge(), link, slider, end, along);
        w.join(JointKind::Prismatic(PrismaticJoint::default()), g, slider, end, along);
        let mut worst: Float = 0.0;
        for _ in 0..300 {
            w.steps(1);
            let (s, c) = scalar::sin_cos(w.angle(shaft));
            worst = worst.max((w.center(slider).x - (r * c + (l * l - r * r * s * s).sqrt())).abs());
        }
        println!("crank: {} rad, slider off by {worst:.1e} m", w.angle(shaft));
        assert!(worst < 1e-4 && (w.angle(shaft) - 30.0).abs() < 0.1);
        [w.angle(shaft), w.center(slider).x]
    });
}

/// Bars stand on the ground a metre apart, couplers join their tops; all fall over to x at 1 m/s, go through the pose where
/// all lie in one line and any bar could turn either way, and come back (IFToMM benchmark A02, González et al., *Multibody
/// Syst. Dyn.* 16, 2006). Hinges in a plane hold each coupler three times more than it needs: rows are redundant, and
/// what rounding leaves of them must not be pushed. Energy, gaps, and that both copies stay together.
fn four_bars(windows: usize) {
    let thin = vec3(0.01, 1.0, 1.0) / 12.0;
    both(if SINGLE { 0.02 } else { 1e-3 }, |turn| {
        let mut s = Turned::new(turn, 9.81);
        let ground = s.ground();
        let up = quat_about(Vec3::z(), 0.5 * scalar::PI);
        let start = |s: &mut Turned, body, v: Vec3, w: Vec3| {
            let mut body = s.world.body_mut(body).unwrap();
            body.set_linear_velocity(turn * v).unwrap();
            body.set_angular_velocity(turn * w).unwrap();
        };
        let mut bars = Vec::new();
        for k in 0..=windows {
            let foot = vec3(k as Float, 0.0, 0.0);
            let bar = s.body(foot + vec3(0.0, 0.5, 0.0), up, 1.0, thin);
            start(&mut s, bar, vec3(0.5, 0.0, 0.0), vec3(0.0, 0.0, -1.0));
            s.join(hinge(), ground, bar, foot, Quat::identity());
            bars.push(bar);
        }
        for (k, pair) in bars.windows(2).enumerate() {
            let top = vec3(k as Float, 1.0, 0.0);
            let coupler = s.body(top + vec3(0.5, 0.0, 0.0), Quat::identity(), 1.0, thin);
            start(&mut s, coupler, vec3(1.0, 0.0, 0.0), Vec3::zeros());
            s.join(hinge(), pair[0], coupler, top, Quat::identity());
            s.join(hinge(), pair[1], coupler, top + vec3(1.0, 0.0, 0.0), Quat::identity());
        }
        s.steps(1);
        let (energy, mut worst): (f64, (f64, Float)) = (s.energy(), (0.0, 0.0));
        for _ in 0..600 {
            s.steps(1);
            let report = s.world.step_report();
            worst.0 = worst.0.max((s.energy() / energy - 1.0).abs());
            worst.1 = worst.1.max(report.joint_gap);
        }
        println!("{windows} windows: energy off by {:.1e}, gap {:.1e} m", worst.0, worst.1);
        assert!(worst.0 < 2e-3 && worst.1 < 5e-5, "{worst:?}");
        let p = s.center(bars[windows]);
        [p.x, p.y, p.z]
    });
}

#[test]
fn two_windows_of_bars_fall_over_and_come_back() {
    four_bars(2);
}

#[test]
fn ten_windows_of_bars_fall_over_and_come_back() {
    four_bars(10);
}
