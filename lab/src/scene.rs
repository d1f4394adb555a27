//! A scene as data, which every engine builds its world from: bodies, shapes, materials and how to step.
//!
//! Units are SI, y is up, and numbers are f32 so that every engine starts from the same bits.

/// What a body is to the engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Static,
    Dynamic,
}

/// The geometry of a body, centred on the body's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// Half side lengths [m].
    Box([f32; 3]),
    /// Radius [m].
    Sphere(f32),
    /// The convex hull of one of the scene's point clouds, by index.
    Hull(usize),
}

/// A body with its one shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    pub kind: Kind,
    /// [m]
    pub position: [f32; 3],
    /// x, y, z, w, of length 1.
    pub rotation: [f32; 4],
    /// [m/s]
    pub velocity: [f32; 3],
    pub form: Form,
    /// [kg/m³]
    pub density: f32,
    pub friction: f32,
    pub restitution: f32,
    /// Whether its shape collides with anything.
    pub collides: bool,
    /// Mass and inertia, where they are not those of the shape.
    pub mass: Option<Mass>,
}

/// Mass \[kg\] and principal moments of inertia \[kg m²\] about the body's origin and axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    pub mass: f32,
    pub inertia: [f32; 3],
}

/// A ball joint between two bodies of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// By index.
    pub bodies: [usize; 2],
    /// Where, from each body's origin \[m\].
    pub local: [[f32; 3]; 2],
}

impl Body {
    pub fn fixed(form: Form, position: [f32; 3]) -> Self {
        Self {
            kind: Kind::Static,
            position,
            rotation: [0.0, 0.0, 0.0, 1.0],
            velocity: [0.0; 3],
            form,
            density: 1000.0,
            friction: 0.6,
            restitution: 0.0,
            collides: true,
            mass: None,
        }
    }

    pub fn dynamic(form: Form, position: [f32; 3]) -> Self {
        Self { kind: Kind::Dynamic, ..Self::fixed(form, position) }
    }
}

/// A scene and how to step it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    pub name: &'static str,
    /// What it shows, in one line.
    pub about: &'static str,
    /// [m/s²]
    pub gravity: [f32; 3],
    /// Length of a step [s].
    pub dt: f32,
    pub sub_steps: u32,
    /// How many steps it runs unless told otherwise.
    pub steps: usize,
    /// Whether bodies may fall asleep.
    pub sleep: bool,
    /// Approach speed up to which nothing bounces [m/s]; `None` leaves each engine its default.
    pub restitution_threshold: Option<f32>,
    /// Point clouds of the hulls [m].
    pub clouds: Vec<Vec<[f32; 3]>>,
    pub bodies: Vec<Body>,
    pub balls: Vec<Ball>,
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
            bodies: Vec::new(),
            balls: Vec::new(),
        }
    }

    /// A box-shaped floor of these half side lengths whose top is at height 0.
    pub fn floor(&mut self, half: [f32; 3]) {
        self.bodies.push(Body::fixed(Form::Box(half), [0.0, -half[1], 0.0]));
    }

    pub fn dynamic_count(&self) -> usize {
        self.bodies.iter().filter(|b| b.kind == Kind::Dynamic).count()
    }
}
