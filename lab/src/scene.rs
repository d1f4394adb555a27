//! A scene as data, which every engine builds its world from: bodies, shapes, joints, materials, forces and how to
//! step.
//!
//! Units are SI and y is up. Numbers are f64; an engine that computes in f32 rounds each of them once.

use crate::vector::{self, Q4, V3};

/// What a body is to the engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Static,
    /// Moves with the velocity and the spin it starts with.
    Kinematic,
    Dynamic,
}

/// The geometry of a body, centred on the body's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// Half side lengths [m].
    Box(V3),
    /// Radius [m].
    Sphere(f64),
    /// Half the length of its segment, which lies along y, and its radius [m].
    Capsule(f64, f64),
    /// The convex hull of one of the scene's point clouds, by index.
    Hull(usize),
    /// Several boxes as one body: one of the scene's lists, by index.
    Boxes(usize),
}

/// A box of a compound body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Half side lengths [m].
    pub half: V3,
    /// Of its centre, from the body's origin [m].
    pub position: V3,
    pub rotation: Q4,
}

/// A body with its one shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    pub kind: Kind,
    /// [m]
    pub position: V3,
    /// x, y, z, w, of length 1.
    pub rotation: Q4,
    /// Of the centre of mass [m/s].
    pub velocity: V3,
    /// World axes [rad/s].
    pub spin: V3,
    pub form: Form,
    /// [kg/m³]
    pub density: f64,
    /// A pair has √(ab).
    pub friction: f64,
    /// A pair has the greater one.
    pub restitution: f64,
    /// Whether its shape collides with anything.
    pub collides: bool,
    /// Mass and inertia, where they are not those of the shape.
    pub mass: Option<Mass>,
}

/// Mass \[kg\], centre of mass \[m\] and principal moments of inertia \[kg m²\] about it, along the body's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    pub mass: f64,
    /// From the body's origin.
    pub center: V3,
    pub inertia: V3,
}

impl Mass {
    /// With its centre at the body's origin.
    pub fn new(mass: f64, inertia: V3) -> Self {
        Self { mass, center: [0.0; 3], inertia }
    }
}

/// A spring and its damper, as seen by the mass it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Frequency of the undamped oscillation \[Hz\].
    pub hertz: f64,
    /// 1 is critical.
    pub damping_ratio: f64,
    /// The mass that both are meant for: 1/m is the sum of both sides' 1/m \[kg\].
    pub mass: f64,
}

impl Spring {
    /// \[N/m\]
    #[cfg_attr(
        not(any(feature = "peers", feature = "ode", feature = "mujoco", feature = "bullet")),
        allow(dead_code, reason = "for engines that ask for it")
    )]
    pub fn stiffness(&self) -> f64 {
        let w = std::f64::consts::TAU * self.hertz;
        self.mass * w * w
    }

    /// \[N s/m\]
    #[cfg_attr(
        not(any(feature = "peers", feature = "ode", feature = "mujoco", feature = "bullet")),
        allow(dead_code, reason = "for engines that ask for it")
    )]
    pub fn damping(&self) -> f64 {
        2.0 * self.damping_ratio * self.mass * std::f64::consts::TAU * self.hertz
    }
}

/// What a joint holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// Two points together.
    Ball,
    /// Points together, and z of both frames along each other.
    Hinge,
    /// All but a slide along x of both frames, on which a spring to 0 may act.
    Slider(Option<Spring>),
    /// All.
    Weld,
    /// Two points at a distance \[m\].
    Rod(f64),
    /// A spring between two points that rests at a distance \[m\].
    Spring(f64, Spring),
}

/// A joint between two bodies of the scene, which then do not collide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    pub hold: Hold,
    /// By index.
    pub bodies: [usize; 2],
    /// Where, from each body's origin \[m\].
    pub local: [V3; 2],
    /// The joint's axes in each body.
    pub axes: [Q4; 2],
}

impl Joint {
    pub fn new(hold: Hold, bodies: [usize; 2], local: [V3; 2]) -> Self {
        Self { hold, bodies, local, axes: [vector::STILL; 2] }
    }

    pub fn ball(bodies: [usize; 2], local: [V3; 2]) -> Self {
        Self::new(Hold::Ball, bodies, local)
    }
}

/// How a force changes with time: it is the direction's multiple.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// 1.
    Constant,
    /// Grows by this a second, to 1 at most.
    Ramp(f64),
}

/// A force on a body, at its centre of mass or at a point above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push {
    /// By index.
    pub body: usize,
    /// When the course is 1 \[N\].
    pub force: V3,
    /// Where, in the body's frame \[m\].
    pub at: V3,
    pub course: Course,
}

impl Push {
    /// The force at a time \[N\]. Engines hold it over a step; its mean over the step is then the force in the middle.
    pub fn at_time(&self, t: f64) -> V3 {
        match self.course {
            Course::Constant => self.force,
            Course::Ramp(rate) => vector::scale(self.force, (rate * t).clamp(0.0, 1.0)),
        }
    }
}

/// A load that follows the motion. The lab puts it on as forces, held over a step, so engines need not know it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// On a body, by index \[N m\].
    Torque(usize, V3),
    /// A spring without mass from a point of a body to one of the world.
    Spring {
        body: usize,
        /// In the body's frame \[m\].
        at: V3,
        /// In the world \[m\].
        anchor: V3,
        /// \[N/m\]
        stiffness: f64,
        /// Its length without force \[m\].
        rest: f64,
    },
}

/// What a spring does to a point at `place` \[N\].
pub fn pull(place: V3, anchor: V3, stiffness: f64, rest: f64) -> V3 {
    let way = vector::sub(anchor, place);
    let length = vector::norm(way);
    vector::scale(way, stiffness * (length - rest) / length)
}

/// A scene and how to step it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    pub name: &'static str,
    /// What it shows, in one line.
    pub about: &'static str,
    /// [m/s²]
    pub gravity: V3,
    /// Length of a step [s].
    pub dt: f64,
    pub sub_steps: u32,
    /// How many steps it runs unless told otherwise.
    pub steps: usize,
    /// Whether bodies may fall asleep.
    pub sleep: bool,
    /// Approach speed up to which nothing bounces [m/s]; `None` leaves each engine its default.
    pub restitution_threshold: Option<f64>,
    /// Point clouds of the hulls [m].
    pub clouds: Vec<Vec<V3>>,
    /// Parts of compound bodies.
    pub compounds: Vec<Vec<Part>>,
    pub bodies: Vec<Body>,
    pub joints: Vec<Joint>,
    pub pushes: Vec<Push>,
    pub loads: Vec<Load>,
}

impl Body {
    pub fn fixed(form: Form, position: V3) -> Self {
        Self {
            kind: Kind::Static,
            position,
            rotation: vector::STILL,
            velocity: [0.0; 3],
            spin: [0.0; 3],
            form,
            density: 1000.0,
            friction: 0.6,
            restitution: 0.0,
            collides: true,
            mass: None,
        }
    }

    pub fn dynamic(form: Form, position: V3) -> Self {
        Self { kind: Kind::Dynamic, ..Self::fixed(form, position) }
    }

    /// Its centre of mass, from its origin.
    pub fn center(&self) -> V3 {
        self.mass.map_or([0.0; 3], |m| m.center)
    }

    /// Whether its centre of mass is not its origin.
    pub fn has_offset(&self) -> bool {
        self.center() != [0.0; 3]
    }
}

impl Scene {
    /// An empty scene with the settings that most scenes share.
    pub fn new(name: &'static str, about: &'static str, steps: usize) -> Self {
        Self {
            name,
            about,
            gravity: [0.0, -10.0, 0.0],
            dt: 1.0 / 60.0,
            sub_steps: 4,
            steps,
            sleep: false,
            restitution_threshold: None,
            clouds: Vec::new(),
            compounds: Vec::new(),
            bodies: Vec::new(),
            joints: Vec::new(),
            pushes: Vec::new(),
            loads: Vec::new(),
        }
    }

    /// A box-shaped floor of these half side lengths whose top is at height 0.
    pub fn floor(&mut self, half: V3) {
        self.floor_of(half, |floor| floor);
    }

    /// The same with another surface.
    pub fn floor_of(&mut self, half: V3, surface: impl Fn(Body) -> Body) {
        self.bodies.push(surface(Body::fixed(Form::Box(half), [0.0, -half[1], 0.0])));
    }

    pub fn dynamic_count(&self) -> usize {
        self.bodies.iter().filter(|b| b.kind == Kind::Dynamic).count()
    }

    /// The scene turned as a whole about the origin, gravity and forces included.
    pub fn turned(&self, q: Q4) -> Self {
        let mut scene = self.clone();
        scene.gravity = vector::rotate(q, scene.gravity);
        for body in &mut scene.bodies {
            body.position = vector::rotate(q, body.position);
            body.velocity = vector::rotate(q, body.velocity);
            body.spin = vector::rotate(q, body.spin);
            body.rotation = vector::unit(vector::times(q, body.rotation));
        }
        for push in &mut scene.pushes {
            push.force = vector::rotate(q, push.force);
        }
        for load in &mut scene.loads {
            match load {
                Load::Torque(_, v) | Load::Spring { anchor: v, .. } => *v = vector::rotate(q, *v),
            }
        }
        scene
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Turning there and back gives the scene again.
    #[test]
    fn a_turned_scene_turns_back() {
        let mut scene = Scene::new("a", "", 1);
        scene.bodies.push(Body {
            velocity: [1.0, 2.0, 3.0],
            spin: [3.0, 2.0, 1.0],
            ..Body::dynamic(Form::Sphere(1.0), [4.0, 5.0, 6.0])
        });
        scene.pushes.push(Push { body: 0, force: [1.0, 0.0, 0.0], at: [0.0; 3], course: Course::Ramp(0.5) });
        let q = vector::unit([0.2, -0.5, 0.3, 0.79]);
        let back = scene.turned(q).turned(vector::conjugate(q));
        let near = |a: V3, b: V3| assert!(vector::norm(vector::sub(a, b)) < 1e-14, "{a:?} {b:?}");
        near(back.bodies[0].position, scene.bodies[0].position);
        near(back.bodies[0].velocity, scene.bodies[0].velocity);
        near(back.bodies[0].spin, scene.bodies[0].spin);
        near(back.pushes[0].at_time(1.0), [0.5, 0.0, 0.0]);
        near(back.gravity, scene.gravity);
        assert!((vector::angle_between(back.bodies[0].rotation, vector::STILL)) < 1e-14);
    }

    #[test]
    fn a_spring_is_given_by_its_mass() {
        let spring = Spring { hertz: 1.0, damping_ratio: 0.5, mass: 2.0 };
        let w = std::f64::consts::TAU;
        assert!((spring.stiffness() - 2.0 * w * w).abs() < 1e-12);
        assert!((spring.damping() - 2.0 * w).abs() < 1e-12);
    }
}
