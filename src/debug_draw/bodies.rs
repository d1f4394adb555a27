//! What is drawn of bodies: shapes, boxes, islands, mass, sleep, names.

use super::{Canvas, Color, DrawOptions, DrawnShape, colors};
use crate::body::SetId;
use crate::math::tolerance::MAX_COORDINATE;
use crate::math::{Aabb, length, max, min, vec3};
use crate::shape::Shape;
use crate::world::{BodyRef, BodyType, ColliderRef, World};

/// The size of the points at centres of mass, in pixels.
const MASS_SIZE: crate::math::Float = 6.0;

/// The bodies that take part.
fn bodies(world: &World) -> impl Iterator<Item = BodyRef<'_>> {
    world.bodies().filter_map(|id| world.body(id).ok()).filter(BodyRef::is_enabled)
}

/// The shapes of a body that the options let through.
fn seen<'w>(
    body: BodyRef<'w>,
    options: &'w DrawOptions,
) -> impl Iterator<Item = (ColliderRef<'w>, Aabb)> + 'w {
    body.shapes().filter_map(move |id| {
        let shape = body.world.shape(id).ok()?;
        let bounds = shape.aabb();
        let drawn = shape.filter().category_bits & options.mask_bits != 0 && bounds.overlaps(&options.bounds);
        drawn.then_some((shape, bounds))
    })
}

/// The box around all drawn shapes but half-spaces, and something around it; 10 m about the origin where there are none.
pub(super) fn extent(world: &World, options: &DrawOptions) -> Aabb {
    let mut scene = Aabb::EMPTY;
    for body in bodies(world) {
        for (shape, bounds) in seen(body, options) {
            if !matches!(shape.shape(), Shape::HalfSpace(_)) {
                scene = scene.union(&bounds);
            }
        }
    }
    if scene == Aabb::EMPTY {
        return Aabb::around(vec3(0.0, 0.0, 0.0), vec3(10.0, 10.0, 10.0));
    }
    // A scene far larger than the drawing bounds is not looked at as a whole.
    let clipped =
        Aabb { lower: max(scene.lower, options.bounds.lower), upper: min(scene.upper, options.bounds.upper) };
    clipped.grown(1.0 + 0.1 * length(clipped.half()))
}

fn color(body: BodyRef<'_>, own: u32) -> Color {
    if own != 0 {
        return own & 0xff_ff_ff;
    }
    match body.body_type() {
        BodyType::Static => colors::STATIC,
        BodyType::Kinematic => colors::KINEMATIC,
        BodyType::Dynamic if body.is_awake() => colors::AWAKE,
        BodyType::Dynamic => colors::ASLEEP,
    }
}

pub(super) fn shapes(world: &World, options: &DrawOptions, scene: &Aabb, canvas: &mut dyn Canvas) {
    for body in bodies(world) {
        for (shape, _) in seen(body, options) {
            let drawn = DrawnShape {
                id: shape.id(),
                body: body.id(),
                shape: shape.shape(),
                pose: shape.world_pose(),
                color: color(body, shape.material().custom_color),
                scene: *scene,
            };
            if options.shapes {
                canvas.shape(&drawn);
            }
            if options.edges {
                drawn.edges(canvas);
            }
        }
    }
}

pub(super) fn shape_bounds(world: &World, options: &DrawOptions, scene: &Aabb, canvas: &mut dyn Canvas) {
    for body in bodies(world) {
        for (shape, _) in seen(body, options) {
            let mut fat = world.colliders[shape.index].fat;
            if matches!(shape.shape(), Shape::HalfSpace(_)) {
                // Its box has no end, but for the plane's side where that is along the axes.
                for k in 0..3 {
                    if fat.lower[k] <= -0.5 * MAX_COORDINATE {
                        fat.lower[k] = scene.lower[k].min(fat.upper[k]);
                    }
                    if fat.upper[k] >= 0.5 * MAX_COORDINATE {
                        fat.upper[k] = scene.upper[k].max(fat.lower[k]);
                    }
                }
            }
            canvas.bounds(&fat, colors::BOUNDS);
        }
    }
}

pub(super) fn islands(world: &World, options: &DrawOptions, canvas: &mut dyn Canvas) {
    for island in world.islands.islands.iter().filter(|i| !i.bodies.is_empty()) {
        let around = island.bodies.iter().fold(Aabb::EMPTY, |around, &index| {
            let body = BodyRef { world, index: index as usize };
            seen(body, options).fold(around, |around, (_, bounds)| around.union(&bounds))
        });
        if around != Aabb::EMPTY {
            canvas.bounds(&around, colors::ISLAND);
        }
    }
}

/// Mass, sleep and names.
pub(super) fn notes(world: &World, options: &DrawOptions, canvas: &mut dyn Canvas) {
    if !(options.mass || options.sleep || options.names) {
        return;
    }
    for body in bodies(world).filter(|b| options.sees(b.world_center())) {
        let kind = body.body_type();
        let center = body.world_center();
        if options.names && !body.name().is_empty() {
            canvas.text(body.transform().p, body.name(), colors::TEXT);
        }
        if options.mass && kind == BodyType::Dynamic {
            canvas.point(center, MASS_SIZE, colors::MASS);
            canvas.text(center, &format!("{:.3} kg", body.mass()), colors::TEXT);
        }
        if options.sleep && kind != BodyType::Static {
            let set = world.bodies.bodies[body.index].set;
            let text = if set == SetId::AWAKE {
                let (rows, row) = world.bodies.at(body.index);
                format!("slow for {:.2} s", rows.slow_time[row])
            } else {
                "asleep".to_owned()
            };
            canvas.text(center, &text, colors::TEXT);
        }
    }
}
