//! Humans that fall: bones and joints from one definition.

use super::access::write_world;
use super::def::{cookie, mvSurfaceMaterial};
use super::def_check::{check_cookie, to_word};
use super::guard::{Neutral, c_count, call, needed, neutral};
use super::id::{mvBodyId, mvJointId, mvWorldId};
use super::math::{mvPos, mvQuat, mvVec3};
use super::mvFloat;
use super::registry::{Target, write};
use crate::error::{Error, ErrorCode, Result};
use crate::world::{Human, HumanDef, World};
use core::ffi::{c_int, c_void};

/// The most bones of a human.
pub const MV_MAX_BONES: i32 = 14;

/// What a human is made from. Made by mvDefaultHumanDef().
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvHumanDef {
    /// Shows that the definition was made by its function. Leave it alone.
    pub internal_value: i32,
    /// How many bones: 11, the default, or 14, with a spine of two parts and feet.
    pub bone_count: c_int,
    /// Where it stands [m]; default the origin.
    pub position: mvPos,
    /// How it stands; default upright: y up, looking along z.
    pub rotation: mvQuat,
    /// The height [m], 0.01 to 100; default 1.8.
    pub height: mvFloat,
    /// The density [kg/m^3], > 0; default 1000.
    pub density: mvFloat,
    /// The mass of the whole body [kg], >= 0; 0, the default, is what the density gives.
    pub mass: mvFloat,
    /// The torque of dry friction in each joint [N m], >= 0; default 1.
    pub friction_torque: mvFloat,
    /// The frequency of springs that hold the rest pose [Hz], >= 0; default 0: none.
    pub spring_hertz: mvFloat,
    /// Their damping ratio, >= 0; default 0.7.
    pub spring_damping_ratio: mvFloat,
    /// The collision group of all bones. Negative, as the default -1, bones of one group do not collide: give each
    /// human a group of its own, or they pass through each other.
    pub group_index: c_int,
    /// The surface of all bones.
    pub material: mvSurfaceMaterial,
    /// Anything: the user data of all bodies, shapes and joints.
    pub user_data: *mut c_void,
}

/// The bones of a human, and their joints. A plain value that is copied freely.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct mvHuman {
    /// How many bones; 0 for none.
    pub bone_count: c_int,
    /// Pelvis, (abdomen,) chest, head, left and right upper arm, left and right forearm, left and right thigh, left
    /// and right shank(, left and right foot). What is in brackets is there with 14 bones.
    pub body_ids: [mvBodyId; 14],
    /// The joint by which each bone hangs on another; null for the pelvis. Spherical at spine, neck, shoulders and
    /// hips, revolute at elbows, knees and ankles.
    pub joint_ids: [mvJointId; 14],
}

const COOKIE: i32 = cookie::<mvHumanDef>(4);

neutral! {
    mvHuman = mvHuman { bone_count: 0, body_ids: [mvBodyId::NEUTRAL; 14], joint_ids: [mvJointId::NEUTRAL; 14] };
}

/// Get the definition of a human with the default values.
#[unsafe(no_mangle)]
pub extern "C" fn mvDefaultHumanDef() -> mvHumanDef {
    let d = HumanDef::default();
    mvHumanDef {
        internal_value: COOKIE,
        bone_count: c_count(d.bones),
        position: d.position.into(),
        rotation: d.rotation.into(),
        height: d.height,
        density: d.density,
        mass: d.mass,
        friction_torque: d.friction_torque,
        spring_hertz: d.spring_hertz,
        spring_damping_ratio: d.spring_damping_ratio,
        group_index: d.group_index,
        material: d.material.into(),
        user_data: std::ptr::null_mut(),
    }
}

/// Create a human in its rest pose: standing, arms down. Nothing strains it.
///
/// @param worldId the world
/// @param def the definition, from mvDefaultHumanDef()
/// @return the human; no bones for bad arguments
/// @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
/// has no joints.
#[unsafe(no_mangle)]
pub extern "C" fn mvCreateHuman(world_id: mvWorldId, def: Option<&mvHumanDef>) -> mvHuman {
    write_world(world_id, |e| {
        let d = needed("The definition", def)?;
        check_cookie("Human", d.internal_value, COOKIE)?;
        let human = e.world.create_human(&HumanDef {
            bones: usize::try_from(d.bone_count).unwrap_or(0),
            position: d.position.raw(),
            rotation: d.rotation.raw(),
            height: d.height,
            density: d.density,
            mass: d.mass,
            friction_torque: d.friction_torque,
            spring_hertz: d.spring_hertz,
            spring_damping_ratio: d.spring_damping_ratio,
            group_index: d.group_index,
            material: d.material.raw(),
            user_data: to_word(d.user_data),
        })?;
        let mut out = mvHuman { bone_count: c_count(human.bodies.len()), ..mvHuman::NEUTRAL };
        out.body_ids.iter_mut().zip(&human.bodies).for_each(|(to, &id)| *to = id.into());
        out.joint_ids[1..].iter_mut().zip(&human.joints).for_each(|(to, &id)| *to = id.into());
        Ok(out)
    })
}

/// Destroy what is left of a human. Bones that were destroyed before are passed over.
/// @param human the human, from mvCreateHuman()
/// @note Errors: mv_errorRange for a number of bones that no human has.
#[unsafe(no_mangle)]
pub extern "C" fn mvDestroyHuman(human: Option<&mvHuman>) {
    edit(human, |world, human| {
        world.destroy_human(human);
        Ok(())
    });
}

/// Set the torque of dry friction in each joint of a human.
/// @param human the human, from mvCreateHuman()
/// @param torque the torque [N m], >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorStale where a joint was destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvHuman_SetFrictionTorque(human: Option<&mvHuman>, torque: mvFloat) {
    edit(human, |world, human| human.set_friction(world, torque));
}

/// Set the springs that hold the rest pose of a human.
/// @param human the human, from mvCreateHuman()
/// @param hertz the frequency [Hz], >= 0; 0 for none
/// @param dampingRatio the damping ratio, >= 0
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorStale where a joint was destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvHuman_SetSpring(human: Option<&mvHuman>, hertz: mvFloat, damping_ratio: mvFloat) {
    edit(human, |world, human| human.set_spring(world, hertz, damping_ratio));
}

/// Give all bones of a human one velocity, without rotation.
/// @param human the human, from mvCreateHuman()
/// @param velocity the velocity [m/s]
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorStale where a bone was destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvHuman_SetVelocity(human: Option<&mvHuman>, velocity: mvVec3) {
    edit(human, |world, human| human.set_velocity(world, velocity.raw()));
}

/// Push a human: the impulse is shared out by mass, so that all bones gain the same velocity. To push one bone, use
/// mvBody_ApplyLinearImpulse().
/// @param human the human, from mvCreateHuman()
/// @param impulse the impulse [N s]
/// @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorStale where a bone was destroyed.
#[unsafe(no_mangle)]
pub extern "C" fn mvHuman_ApplyLinearImpulse(human: Option<&mvHuman>, impulse: mvVec3) {
    edit(human, |world, human| human.apply_impulse(world, impulse.raw()));
}

fn edit(human: Option<&mvHuman>, f: impl FnOnce(&mut World, &Human) -> Result<()>) {
    call(|| {
        let human = needed("The human", human)?;
        if human.bone_count != 11 && human.bone_count != 14 {
            let n = human.bone_count;
            return Err(Error::new(
                ErrorCode::Range,
                format!("boneCount is {n}; a human has 11 or 14 bones."),
            ));
        }
        let n = human.bone_count as usize;
        let first = human.body_ids[0];
        write(Target::of(first.index1, first.world0, "body")?, |e| {
            let bones = Human {
                bodies: human.body_ids[..n].iter().map(|&id| id.into()).collect(),
                joints: human.joint_ids[1..n].iter().map(|&id| id.into()).collect(),
            };
            f(e.world, &bones)
        })
    });
}
