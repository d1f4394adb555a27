//! Conserved quantities, from motions and masses.

use crate::case::masses;
use crate::engines::Motion;
use crate::scene::Scene;
use crate::vector::{V3, add, conjugate, cross, dot, rotate, scale};

/// A body's own angular momentum, world axes.
fn spin_momentum(m: &Motion, inertia: V3) -> V3 {
    let w = rotate(conjugate(m.rotation), m.spin);
    rotate(m.rotation, [0, 1, 2].map(|k| inertia[k] * w[k]))
}

/// \[kg m/s\]
pub fn momentum(scene: &Scene, frame: &[Motion]) -> V3 {
    let pairs = masses(scene).into_iter().zip(frame);
    pairs.fold([0.0; 3], |sum, ((m, _), motion)| add(sum, scale(motion.velocity, m)))
}

/// About the world's origin \[kg m²/s\].
pub fn angular_momentum(scene: &Scene, frame: &[Motion]) -> V3 {
    let pairs = masses(scene).into_iter().zip(frame);
    pairs.fold([0.0; 3], |sum, ((m, inertia), motion)| {
        let orbit = cross(motion.position, scale(motion.velocity, m));
        add(sum, add(orbit, spin_momentum(motion, inertia)))
    })
}

/// \[J\]
pub fn kinetic(scene: &Scene, frame: &[Motion]) -> f64 {
    let pairs = masses(scene).into_iter().zip(frame);
    pairs
        .map(|((m, inertia), motion)| {
            0.5 * m * dot(motion.velocity, motion.velocity)
                + 0.5 * dot(motion.spin, spin_momentum(motion, inertia))
        })
        .sum()
}

/// Kinetic and that of gravity, zero at the origin \[J\].
pub fn energy(scene: &Scene, frame: &[Motion]) -> f64 {
    let pairs = masses(scene).into_iter().zip(frame);
    let potential: f64 = pairs.map(|((m, _), motion)| -m * dot(scene.gravity, motion.position)).sum();
    kinetic(scene, frame) + potential
}

/// The greatest change of a run's energy over a size of it.
pub fn energy_change(scene: &Scene, frames: &[Vec<Motion>], size: f64) -> f64 {
    let start = energy(scene, &frames[0]);
    frames.iter().map(|f| (energy(scene, f) - start).abs() / size).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Body, Form};
    use crate::vector::{norm, sub, turn};

    /// A turned box with a spin about one of its axes has I ω about it, wherever it is.
    #[test]
    fn a_box_has_its_moments() {
        let mut scene = Scene::new("box", "", 1);
        let q = turn([0.6, 0.0, 0.8], 0.7);
        let axis = rotate(q, [0.0, 1.0, 0.0]);
        scene.bodies.push(Body {
            rotation: q,
            spin: scale(axis, 3.0),
            velocity: [1.0, 0.0, 0.0],
            density: 10.0,
            ..Body::dynamic(Form::Box([0.5, 1.0, 1.5]), [0.0, 2.0, 0.0])
        });
        let frame = Motion::start(&scene);
        let (m, i) = (60.0, 60.0 / 12.0 * (1.0 + 9.0));
        let l = add(scale(axis, 3.0 * i), [0.0, 0.0, -2.0 * m]);
        assert!(norm(sub(angular_momentum(&scene, &frame), l)) < 1e-10);
        assert!((kinetic(&scene, &frame) - 0.5 * m - 0.5 * i * 9.0).abs() < 1e-10);
        assert!((energy(&scene, &frame) - kinetic(&scene, &frame) - m * 10.0 * 2.0).abs() < 1e-10);
        assert!((momentum(&scene, &frame)[0] - m).abs() < 1e-12);
        assert!(energy_change(&scene, &[frame.clone(), frame], 1.0) == 0.0);
    }
}
