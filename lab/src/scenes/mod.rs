//! The scenes, grouped by what they are about. To add one, write its builder in a group file and list it here.

mod bounce;
pub mod joints;
mod piles;
mod pyramids;
mod stacks;

use crate::scene::Scene;

/// Every scene's builder.
pub const ALL: &[fn() -> Scene] = &[
    pyramids::large_pyramid,
    pyramids::many_pyramids,
    pyramids::pyramid_10,
    stacks::stack_10,
    stacks::stack_20,
    stacks::heavy_on_light,
    piles::convex_pile,
    piles::box_pile,
    bounce::bouncing_ball,
    joints::joint_grid,
    joints::pendulum,
    joints::double_pendulum,
    joints::chain_10,
    joints::chain_20,
    joints::hanging_chain_1,
];

/// Builds the scene of this name.
pub fn find(name: &str) -> Option<Scene> {
    ALL.iter().map(|build| build()).find(|scene| scene.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Form, Kind};

    fn count(name: &str) -> usize {
        find(name).unwrap().dynamic_count()
    }

    #[test]
    fn counts_are_those_of_the_published_scenes() {
        assert_eq!(count("large_pyramid"), 5050);
        assert_eq!(count("many_pyramids"), 14 * 14 * 55);
        assert_eq!(count("pyramid_10"), 55);
        assert_eq!(count("convex_pile"), 5120);
        assert_eq!(count("box_pile"), 4000);
        assert_eq!(count("stack_20"), 20);
        assert_eq!(count("joint_grid"), 9900);
        assert_eq!(find("joint_grid").unwrap().balls.len(), 19_800);
    }

    #[test]
    fn names_are_unique_and_hulls_exist() {
        let scenes: Vec<Scene> = ALL.iter().map(|build| build()).collect();
        for (i, scene) in scenes.iter().enumerate() {
            assert!(scenes[..i].iter().all(|s| s.name != scene.name), "{}", scene.name);
            for body in &scene.bodies {
                if let Form::Hull(k) = body.form {
                    assert!(scene.clouds[k].len() >= 4);
                }
            }
        }
    }

    /// Boxes of a pyramid rest on the one below without overlap, and the pile stands over the middle of the floor.
    #[test]
    fn the_large_pyramid_is_packed_and_centred() {
        let scene = find("large_pyramid").unwrap();
        let cubes: Vec<_> = scene.bodies.iter().filter(|b| b.kind == Kind::Dynamic).collect();
        let (first, last) = (cubes[0], cubes[cubes.len() - 1]);
        assert_eq!(first.position[1], 0.5);
        assert_eq!(last.position[1], 99.5);
        let mean = cubes.iter().map(|b| f64::from(b.position[0])).sum::<f64>() / cubes.len() as f64;
        assert!(mean.abs() < 1e-6, "{mean}");
        let width = cubes[..100].iter().map(|b| b.position[0]).collect::<Vec<_>>();
        assert!(width.windows(2).all(|w| w[1] - w[0] == 1.0));
    }
}
