//! What is drawn of contacts: points, normals, forces, features. Those of bodies asleep are as they fell asleep.

use super::{Canvas, Color, DrawOptions, colors};
use crate::constraint::contact::{Contact, ContactPoint, flags};
use crate::island::color::NO_COLOR;
use crate::math::{Float, Vec3};
use crate::world::World;

/// The size of contact points, in pixels.
const POINT_SIZE: Float = 8.0;
/// The length of normals \[m\].
const NORMAL_LENGTH: Float = 0.3;

pub(super) fn contacts(world: &World, options: &DrawOptions, canvas: &mut dyn Canvas) {
    let o = options;
    if !(o.contacts || o.contact_normals || o.contact_forces || o.friction_forces || o.contact_features) {
        return;
    }
    let step = world.last_h * world.last_sub_steps as Float;
    // Newtons from the impulses of the last step; nothing before the first.
    let per_impulse = if step > 0.0 { options.force_scale / step } else { 0.0 };
    let pool = &world.identity.contacts;
    for index in (0..pool.slots()).filter(|&i| pool.is_live(i, pool.generation(i))) {
        let contact = &world.contacts.contacts[index];
        if contact.is(flags::CONSTRAINT) && is_drawn(world, contact, options.mask_bits) {
            draw(world, contact, options, per_impulse, canvas);
        }
    }
}

/// A contact is drawn where one of its shapes is.
fn is_drawn(world: &World, contact: &Contact, mask_bits: u64) -> bool {
    contact.shape.iter().any(|&s| world.colliders[s as usize].filter.category_bits & mask_bits != 0)
}

fn draw(
    world: &World,
    contact: &Contact,
    options: &DrawOptions,
    per_impulse: Float,
    canvas: &mut dyn Canvas,
) {
    let (set, row) = world.bodies.at(contact.body[0] as usize);
    let center_a = set.motion[row].x;
    let (mut load, mut loaded) = (0.0, Vec3::zeros());
    for p in contact.points() {
        let middle = center_a + p.anchor;
        (load, loaded) = (load + p.total, loaded + middle * p.total);
        let at = if options.anchor_a { middle - contact.normal * (0.5 * p.separation) } else { middle };
        if !options.sees(at) {
            continue;
        }
        if options.contacts {
            canvas.point(at, POINT_SIZE, point_color(contact, p, options.graph_colors));
        }
        if options.contact_normals {
            canvas.segment(at, at + contact.normal * NORMAL_LENGTH, colors::NORMAL);
        }
        if options.contact_forces && p.total > 0.0 {
            canvas.segment(at, at + contact.normal * (p.total * per_impulse), colors::FORCE);
        }
        if options.contact_features {
            canvas.text(at, &format!("{:08x}", p.feature), colors::TEXT);
        }
    }
    if options.friction_forces && load > 0.0 && contact.total_friction != Vec3::zeros() {
        let at = loaded / load;
        if options.sees(at) {
            canvas.segment(at, at + contact.total_friction * per_impulse, colors::FRICTION);
        }
    }
}

fn point_color(contact: &Contact, point: &ContactPoint, graph: bool) -> Color {
    match (graph, contact.color) {
        (true, NO_COLOR) => colors::TEXT,
        (true, color) => graph_color(color),
        (false, _) if point.separation <= 0.0 || point.total > 0.0 => colors::TOUCHING,
        (false, _) => colors::NEAR,
    }
}

/// Colours that differ, for the colours of the graph.
fn graph_color(color: u8) -> Color {
    const HUES: [Color; 12] = [
        0xe6_19_4b, 0x3c_b4_4b, 0xff_e1_19, 0x43_63_d8, 0xf5_82_31, 0x91_1e_b4, 0x42_d4_f4, 0xf0_32_e6,
        0xbf_ef_45, 0xfa_be_d4, 0x46_99_90, 0x9a_63_24,
    ];
    let hue = HUES[color as usize % HUES.len()];
    // The second dozen is darker.
    if (color as usize / HUES.len()).is_multiple_of(2) { hue } else { (hue & 0xfe_fe_fe) >> 1 }
}
