//! The scenes, grouped by what they are about. To add one, write its builder in a group file and list it here.

mod bounce;
mod grains;
pub mod group_a;
mod group_b;
pub mod group_c;
pub mod group_d;
pub mod group_e;
pub mod group_f_j;
pub mod joints;
mod loops;
mod machines;
mod piles;
mod pyramids;
mod ragdolls;
mod rods;
mod stacks;
mod symmetry;
mod tops;
mod touching;

use crate::case::{Case, Verdict};
use crate::scene::Scene;

/// Of the cases of groups A to J \[m/s²\].
pub const G: f64 = 9.81;

const MESH: &str = "the engine has no meshes yet";

/// A scene of the groups A to J.
fn scene(name: &'static str, about: &'static str) -> Scene {
    Scene { gravity: [0.0, -G, 0.0], ..Scene::new(name, about, 0) }
}

fn verdict(error: f64) -> Verdict {
    Verdict::new(error)
}

/// Numbers that look like chance and are always the same.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// In −0.5 … 0.5.
    fn half(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    }
}

/// Every case of the catalogue, by group.
pub fn cases() -> Vec<Case> {
    let groups: [fn() -> Vec<Case>; 9] = [
        group_a::cases,
        group_b::cases,
        group_c::cases,
        group_d::cases,
        group_e::cases,
        group_f_j::cases,
        grains::cases,
        touching::cases,
        symmetry::cases,
    ];
    let mut all: Vec<Case> = groups.iter().flat_map(|cases| cases()).collect();
    all.sort_by_key(|case| case.group);
    all
}

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
    piles::sphere_pile,
    piles::hull_pile,
    piles::big_static,
    ragdolls::ragdoll_pile,
    machines::washer,
    machines::junkyard,
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
        assert_eq!(count("sphere_pile"), 8000);
        assert_eq!(count("hull_pile"), 2000);
        assert_eq!(count("big_static"), 500);
        assert_eq!(count("ragdoll_pile"), 1100);
        assert_eq!(count("washer"), 8000);
        assert_eq!(count("junkyard"), 10_584);
        assert_eq!(count("stack_20"), 20);
        assert_eq!(count("joint_grid"), 9900);
        assert_eq!(find("joint_grid").unwrap().joints.len(), 19_800);
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
        let mean = cubes.iter().map(|b| b.position[0]).sum::<f64>() / cubes.len() as f64;
        assert!(mean.abs() < 1e-6, "{mean}");
        let width = cubes[..100].iter().map(|b| b.position[0]).collect::<Vec<_>>();
        assert!(width.windows(2).all(|w| w[1] - w[0] == 1.0));
    }
}
