//! Whether an arch of stones can stand: is there a set of forces in its joints that balances the weights, pushes only,
//! and stays within the cone of friction?
//!
//! By symmetry the force in the middle of the keystone is horizontal: its size H and its moment about the centre M are
//! all that is unknown. Each joint then asks for four half planes of (H, M): the resultant stays between the joint's
//! edges, and its slope within the friction angle. What is left of a large square when all of them are cut off says
//! whether there is such a force.

use std::f64::consts::PI;

/// A cut through the arch, for weights per volume and depth of 1 and a mean radius of 1: angle from the crown, weight
/// above, first moment of that weight about the vertical axis.
struct Cut {
    angle: f64,
    weight: f64,
    moment: f64,
}

/// The joints of half an arch of `count` (odd) stones, from the crown down. The stones' faces are plane.
fn cuts(count: usize, thickness: f64) -> Vec<Cut> {
    let step = PI / count as f64;
    let (inner, outer) = (1.0 - 0.5 * thickness, 1.0 + 0.5 * thickness);
    let (mut weight, mut moment, mut from) = (0.0, 0.0, 0.0);
    let mut cuts = Vec::new();
    for k in 0..count.div_ceil(2) {
        let to = step * (0.5 + k as f64);
        // Half the keystone is cut out of the whole: its plane faces are those of the whole stone.
        let corner = |radius: f64, angle: f64| {
            let (s, c) = libm::sincos(angle);
            if k == 0 { [radius * s, radius * libm::cos(to)] } else { [radius * s, radius * c] }
        };
        let quad = [corner(inner, from), corner(outer, from), corner(outer, to), corner(inner, to)];
        let (mut area2, mut first) = (0.0, 0.0);
        for i in 0..4 {
            let ([ax, ay], [bx, by]) = (quad[i], quad[(i + 1) % 4]);
            let cross = ax * by - bx * ay;
            area2 += cross;
            first += cross * (ax + bx) / 6.0;
        }
        // Corners run clockwise.
        weight -= 0.5 * area2;
        moment -= first;
        cuts.push(Cut { angle: to, weight, moment });
        from = to;
    }
    cuts
}

/// Cuts off the part of a convex polygon where a x + b y + c < 0.
fn clip(polygon: &[[f64; 2]], [a, b, c]: [f64; 3]) -> Vec<[f64; 2]> {
    let value = |p: &[f64; 2]| a * p[0] + b * p[1] + c;
    let mut out = Vec::new();
    for i in 0..polygon.len() {
        let (p, q) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        let (u, v) = (value(&p), value(&q));
        if u >= 0.0 {
            out.push(p);
        }
        if (u >= 0.0) != (v >= 0.0) {
            let t = u / (u - v);
            out.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
        }
    }
    out
}

/// Whether a half-circular arch of this many stones, thickness over mean radius and friction can stand.
pub fn arch_can_stand(count: usize, thickness: f64, friction: f64) -> bool {
    let mut polygon = vec![[0.0, -10.0], [10.0, -10.0], [10.0, 10.0], [0.0, 10.0]];
    for Cut { angle, weight, moment } in cuts(count, thickness) {
        let (s, c) = libm::sincos(angle);
        // The thrust N = H c + W s, the shear V = H s − W c, and the moment about the joint's middle.
        let normal = [c, 0.0, weight * s];
        let shear = [s, 0.0, -weight * c];
        let about = [c, -1.0, -(moment - s * weight)];
        let combine = |k: f64, other: [f64; 3]| [0, 1, 2].map(|i| k * normal[i] + other[i]);
        let minus = |v: [f64; 3]| v.map(|x| -x);
        for plane in [
            combine(0.5 * thickness, about),
            combine(0.5 * thickness, minus(about)),
            combine(friction, shear),
            combine(friction, minus(shear)),
        ] {
            polygon = clip(&polygon, plane);
        }
    }
    !polygon.is_empty()
}

/// Where a property that fails below and holds above begins to hold.
fn threshold(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..48 {
        let middle = 0.5 * (low + high);
        if holds(middle) { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// The least thickness over mean radius of an arch that cannot slide.
pub fn least_thickness(count: usize) -> f64 {
    threshold(0.01, 0.5, |t| arch_can_stand(count, t, 1e3))
}

/// The least friction of an arch of this thickness.
pub fn least_friction(count: usize, thickness: f64) -> f64 {
    threshold(0.01, 2.0, |mu| arch_can_stand(count, thickness, mu))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The printed figures of the catalogue of scenes: D6; it does not say whether its stones have plane faces.
    #[test]
    fn arches_are_those_of_the_catalogue() {
        let near = |a: f64, b: f64, bound: f64| assert!((a - b).abs() < bound, "{a} {b}");
        near(least_thickness(25), 0.1070, 6e-4);
        near(least_thickness(101), 0.1075, 6e-4);
        near(least_friction(25, 0.2), 0.308, 1e-3);
        near(least_friction(101, 0.2), 0.309, 1e-3);
        near(least_friction(25, 0.15), 0.349, 2e-3);
        near(least_friction(101, 0.15), 0.352, 2e-3);
    }
}
