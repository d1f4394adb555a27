//! Joints in a story: all kinds, made from good and bad definitions, and every function about them.

use super::*;
use std::mem::MaybeUninit;

/// More than this in one world would make steps slow.
const MOST_JOINTS: i32 = 60;

pub fn create(s: &mut Story) {
    let (w, a, b, base) = (s.world(), s.body(), s.body(), s.r.below(16));
    if mvWorld_GetCounters(w).joint_count >= MOST_JOINTS {
        return;
    }
    mvGetLastError();
    // Mostly two bodies of one world.
    let id = match s.r.below(16) {
        0 => {
            let mut d = mvDefaultParallelJointDef();
            common(s, &mut d.base, base, a, b);
            (d.hertz, d.max_torque) = (s.r.num(), s.r.num());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateParallelJoint(w, Some(&d))
        }
        1 => {
            let mut d = mvDefaultDistanceJointDef();
            common(s, &mut d.base, base, a, b);
            d.length = s.r.size();
            (d.enable_spring, d.hertz, d.enable_limit) = (s.r.flag(), s.r.num(), s.r.flag());
            (d.min_length, d.max_length) = (s.r.size(), 1.0 + s.r.size());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateDistanceJoint(w, Some(&d))
        }
        2 => {
            let mut d = mvDefaultFilterJointDef();
            common(s, &mut d.base, base, a, b);
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateFilterJoint(w, Some(&d))
        }
        3 => {
            let mut d = mvDefaultMotorJointDef();
            common(s, &mut d.base, base, a, b);
            (d.linear_velocity, d.max_velocity_force) = (s.r.vec(), s.r.num());
            (d.linear_hertz, d.max_spring_force) = (s.r.num(), s.r.num());
            (d.angular_hertz, d.max_spring_torque) = (s.r.num(), s.r.num());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateMotorJoint(w, Some(&d))
        }
        4 => {
            let mut d = mvDefaultPrismaticJointDef();
            common(s, &mut d.base, base, a, b);
            (d.enable_spring, d.hertz, d.enable_limit, d.enable_motor) =
                (s.r.flag(), s.r.num(), s.r.flag(), s.r.flag());
            (d.motor_speed, d.friction) = (s.r.num(), s.r.num());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreatePrismaticJoint(w, Some(&d))
        }
        5 => {
            let mut d = mvDefaultRevoluteJointDef();
            common(s, &mut d.base, base, a, b);
            (d.enable_spring, d.hertz, d.enable_limit, d.enable_motor) =
                (s.r.flag(), s.r.num(), s.r.flag(), s.r.flag());
            (d.motor_speed, d.friction) = (s.r.num(), s.r.num());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateRevoluteJoint(w, Some(&d))
        }
        6 => {
            let mut d = mvDefaultSphericalJointDef();
            common(s, &mut d.base, base, a, b);
            (d.enable_cone_limit, d.cone_angle, d.cone_angle_y) = (s.r.flag(), s.r.num(), s.r.num());
            (d.enable_twist_limit, d.enable_spring, d.hertz) = (s.r.flag(), s.r.flag(), s.r.num());
            (d.target_rotation, d.friction) = (s.r.quat(), s.r.num());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateSphericalJoint(w, Some(&d))
        }
        7 => {
            let mut d = mvDefaultWeldJointDef();
            common(s, &mut d.base, base, a, b);
            (d.linear_hertz, d.angular_hertz) = (s.r.num(), s.r.num());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateWeldJoint(w, Some(&d))
        }
        8 => {
            let mut d = mvDefaultWheelJointDef();
            common(s, &mut d.base, base, a, b);
            (d.suspension_hertz, d.enable_suspension_limit, d.enable_spin_motor) =
                (s.r.num(), s.r.flag(), s.r.flag());
            (d.spin_speed, d.max_spin_torque, d.enable_steering) = (s.r.num(), s.r.num(), s.r.flag());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateWheelJoint(w, Some(&d))
        }
        9 => {
            let mut d = mvDefaultUniversalJointDef();
            common(s, &mut d.base, base, a, b);
            (d.enable_limit1, d.enable_motor2, d.motor_speed2) = (s.r.flag(), s.r.flag(), s.r.num());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateUniversalJoint(w, Some(&d))
        }
        10 => {
            let mut d = mvDefaultSixDofJointDef();
            common(s, &mut d.base, base, a, b);
            for k in 0..6 {
                d.axes[k].mode = if s.r.below(30) == 0 { s.r.choice() } else { s.r.below(3) as i32 };
                (d.axes[k].hertz, d.axes[k].enable_spring) = (s.r.num(), s.r.flag());
            }
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateSixDofJoint(w, Some(&d))
        }
        11 => {
            let mut d = mvDefaultGearJointDef();
            common(s, &mut d.base, base, a, b);
            (d.joint_id_a, d.joint_id_b) = (s.joint(), s.joint());
            d.ratio = s.r.num();
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateGearJoint(w, Some(&d))
        }
        12 => {
            let mut d = mvDefaultRackPinionJointDef();
            common(s, &mut d.base, base, a, b);
            (d.joint_id_a, d.joint_id_b) = (s.joint(), s.joint());
            d.ratio = s.r.num();
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateRackPinionJoint(w, Some(&d))
        }
        13 => {
            let mut d = mvDefaultPulleyJointDef();
            common(s, &mut d.base, base, a, b);
            (d.ground_anchor_a, d.ground_anchor_b) = (s.r.pos(), s.r.pos());
            (d.min_length, d.ratio) = (s.r.num(), s.r.size());
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreatePulleyJoint(w, Some(&d))
        }
        14 => {
            let mut d = mvDefaultScrewJointDef();
            common(s, &mut d.base, base, a, b);
            (d.enable_spring, d.hertz, d.enable_limit, d.enable_motor) =
                (s.r.flag(), s.r.num(), s.r.flag(), s.r.flag());
            (d.motor_speed, d.friction) = (s.r.num(), s.r.num());
            d.pitch = s.r.num();
            if s.r.below(40) == 0 {
                d.internal_value ^= 1 << s.r.below(31);
            }
            mvCreateScrewJoint(w, Some(&d))
        }
        _ => mvCreateRevoluteJoint(w, None),
    };
    if id.index1 != 0 {
        s.joints.push(id);
    }
}

fn common(s: &mut Story, d: &mut mvJointDef, what: usize, a: mvBodyId, b: mvBodyId) {
    (d.body_id_a, d.body_id_b) = (a, b);
    (d.local_frame_a, d.local_frame_b) = (s.r.transform(), s.r.transform());
    match what {
        0 => d.force_threshold = s.r.num(),
        1 => d.torque_threshold = s.r.num(),
        2 => d.constraint_hertz = s.r.num(),
        3 => d.constraint_damping_ratio = s.r.num(),
        4 => d.draw_scale = s.r.num(),
        5 => d.collide_connected = s.r.flag(),
        6 => (d.breakable, d.force_threshold) = (s.r.flag(), s.r.num()),
        _ => {}
    }
}

pub fn destroy(s: &mut Story) {
    if s.r.below(3) == 0 {
        mvDestroyJoint(s.joint(), s.r.flag());
    }
}

pub fn list(s: &mut Story) {
    let (b, n) = (s.body(), s.r.choice().min(8));
    let mut ids = [mvJointId::default(); 8];
    // Sound: there is room for 8.
    let got = unsafe { mvBody_GetJoints(b, ids.as_mut_ptr(), n) };
    assert!(got >= 0 && got <= n.max(0));
    s.joints.extend(&ids[..got as usize]);
    assert!(mvBody_GetJointCount(b) >= 0);
}

pub fn events(s: &mut Story) {
    let events = mvWorld_GetJointEvents(s.world());
    for k in 0..if s.alone { events.count as usize } else { 0 } {
        // Sound: the array is valid until the next step, which is not before the next call.
        let event = unsafe { *events.joint_events.add(k) };
        assert!(!event.force.is_nan() && !event.torque.is_nan());
        s.joints.push(event.joint_id);
    }
}

/// What fits the joint, mostly: one kind's functions are many.
pub fn change(s: &mut Story) {
    let j = s.joint();
    if s.r.below(4) == 0 {
        return set(s, j);
    }
    for _ in 0..8 {
        set(s, j);
        if mvGetLastError() == mv_errorNone {
            break;
        }
    }
}

pub fn read(s: &mut Story) {
    let j = s.joint();
    if s.r.below(4) == 0 {
        return get(s, j);
    }
    for _ in 0..8 {
        get(s, j);
        if mvGetLastError() == mv_errorNone {
            break;
        }
    }
}

fn set(s: &mut Story, j: mvJointId) {
    match s.r.below(128) {
        0 => mvJoint_SetLocalFrameA(j, s.r.transform()),
        1 => mvJoint_SetLocalFrameB(j, s.r.transform()),
        2 => mvJoint_SetCollideConnected(j, s.r.flag()),
        3 => mvJoint_WakeBodies(j),
        4 => mvJoint_SetConstraintTuning(j, s.r.num(), s.r.num()),
        5 => mvJoint_SetForceThreshold(j, s.r.num()),
        6 => mvJoint_SetTorqueThreshold(j, s.r.num()),
        7 => mvJoint_SetBreakable(j, s.r.flag()),
        8 => mvDistanceJoint_SetLength(j, s.r.num()),
        9 => mvDistanceJoint_EnableSpring(j, s.r.flag()),
        10 => mvDistanceJoint_SetSpringForceRange(j, s.r.num(), s.r.num()),
        11 => mvDistanceJoint_SetSpringHertz(j, s.r.num()),
        12 => mvDistanceJoint_SetSpringDampingRatio(j, s.r.num()),
        13 => mvDistanceJoint_EnableLimit(j, s.r.flag()),
        14 => mvDistanceJoint_SetLengthRange(j, s.r.num(), s.r.num()),
        15 => mvDistanceJoint_EnableMotor(j, s.r.flag()),
        16 => mvDistanceJoint_SetMotorSpeed(j, s.r.num()),
        17 => mvDistanceJoint_SetMaxMotorForce(j, s.r.num()),
        18 => mvGearJoint_SetRatio(j, s.r.num()),
        19 => mvMotorJoint_SetLinearVelocity(j, s.r.vec()),
        20 => mvMotorJoint_SetAngularVelocity(j, s.r.vec()),
        21 => mvMotorJoint_SetMaxVelocityForce(j, s.r.num()),
        22 => mvMotorJoint_SetMaxVelocityTorque(j, s.r.num()),
        23 => mvMotorJoint_SetLinearHertz(j, s.r.num()),
        24 => mvMotorJoint_SetLinearDampingRatio(j, s.r.num()),
        25 => mvMotorJoint_SetAngularHertz(j, s.r.num()),
        26 => mvMotorJoint_SetAngularDampingRatio(j, s.r.num()),
        27 => mvMotorJoint_SetMaxSpringForce(j, s.r.num()),
        28 => mvMotorJoint_SetMaxSpringTorque(j, s.r.num()),
        29 => mvParallelJoint_SetSpringHertz(j, s.r.num()),
        30 => mvParallelJoint_SetSpringDampingRatio(j, s.r.num()),
        31 => mvParallelJoint_SetMaxTorque(j, s.r.num()),
        32 => mvPrismaticJoint_EnableSpring(j, s.r.flag()),
        33 => mvPrismaticJoint_SetSpringHertz(j, s.r.num()),
        34 => mvPrismaticJoint_SetSpringDampingRatio(j, s.r.num()),
        35 => mvPrismaticJoint_SetMaxSpringForce(j, s.r.num()),
        36 => mvPrismaticJoint_SetTargetTranslation(j, s.r.num()),
        37 => mvPrismaticJoint_EnableLimit(j, s.r.flag()),
        38 => mvPrismaticJoint_SetLimits(j, s.r.num(), s.r.num()),
        39 => mvPrismaticJoint_EnableMotor(j, s.r.flag()),
        40 => mvPrismaticJoint_SetMotorSpeed(j, s.r.num()),
        41 => mvPrismaticJoint_SetMaxMotorForce(j, s.r.num()),
        42 => mvPrismaticJoint_SetFriction(j, s.r.num()),
        43 => mvPulleyJoint_SetGroundAnchorA(j, s.r.pos()),
        44 => mvPulleyJoint_SetGroundAnchorB(j, s.r.pos()),
        45 => mvPulleyJoint_SetRatio(j, s.r.num()),
        46 => mvPulleyJoint_SetLengthRange(j, s.r.num(), s.r.num()),
        47 => mvRackPinionJoint_SetRatio(j, s.r.num()),
        48 => mvRevoluteJoint_EnableSpring(j, s.r.flag()),
        49 => mvRevoluteJoint_SetSpringHertz(j, s.r.num()),
        50 => mvRevoluteJoint_SetSpringDampingRatio(j, s.r.num()),
        51 => mvRevoluteJoint_SetMaxSpringTorque(j, s.r.num()),
        52 => mvRevoluteJoint_SetTargetAngle(j, s.r.num()),
        53 => mvRevoluteJoint_EnableLimit(j, s.r.flag()),
        54 => mvRevoluteJoint_SetLimits(j, s.r.num(), s.r.num()),
        55 => mvRevoluteJoint_EnableMotor(j, s.r.flag()),
        56 => mvRevoluteJoint_SetMotorSpeed(j, s.r.num()),
        57 => mvRevoluteJoint_SetMaxMotorTorque(j, s.r.num()),
        58 => mvRevoluteJoint_SetFriction(j, s.r.num()),
        59 => mvScrewJoint_SetPitch(j, s.r.num()),
        60 => mvScrewJoint_EnableSpring(j, s.r.flag()),
        61 => mvScrewJoint_SetSpringHertz(j, s.r.num()),
        62 => mvScrewJoint_SetSpringDampingRatio(j, s.r.num()),
        63 => mvScrewJoint_SetMaxSpringTorque(j, s.r.num()),
        64 => mvScrewJoint_SetTargetAngle(j, s.r.num()),
        65 => mvScrewJoint_EnableLimit(j, s.r.flag()),
        66 => mvScrewJoint_SetLimits(j, s.r.num(), s.r.num()),
        67 => mvScrewJoint_EnableMotor(j, s.r.flag()),
        68 => mvScrewJoint_SetMotorSpeed(j, s.r.num()),
        69 => mvScrewJoint_SetMaxMotorTorque(j, s.r.num()),
        70 => mvScrewJoint_SetFriction(j, s.r.num()),
        71 => mvSphericalJoint_EnableConeLimit(j, s.r.flag()),
        72 => mvSphericalJoint_SetConeLimit(j, s.r.num()),
        73 => mvSphericalJoint_SetConeLimits(j, s.r.num(), s.r.num()),
        74 => mvSphericalJoint_EnableTwistLimit(j, s.r.flag()),
        75 => mvSphericalJoint_SetTwistLimits(j, s.r.num(), s.r.num()),
        76 => mvSphericalJoint_EnableSpring(j, s.r.flag()),
        77 => mvSphericalJoint_SetSpringHertz(j, s.r.num()),
        78 => mvSphericalJoint_SetSpringDampingRatio(j, s.r.num()),
        79 => mvSphericalJoint_SetMaxSpringTorque(j, s.r.num()),
        80 => mvSphericalJoint_SetTargetRotation(j, s.r.quat()),
        81 => mvSphericalJoint_EnableMotor(j, s.r.flag()),
        82 => mvSphericalJoint_SetMotorVelocity(j, s.r.vec()),
        83 => mvSphericalJoint_SetMaxMotorTorque(j, s.r.num()),
        84 => mvSphericalJoint_SetFriction(j, s.r.num()),
        85 => mvUniversalJoint_EnableSpring1(j, s.r.flag()),
        86 => mvUniversalJoint_SetSpringHertz1(j, s.r.num()),
        87 => mvUniversalJoint_SetSpringDampingRatio1(j, s.r.num()),
        88 => mvUniversalJoint_SetTargetAngle1(j, s.r.num()),
        89 => mvUniversalJoint_EnableLimit1(j, s.r.flag()),
        90 => mvUniversalJoint_SetLimits1(j, s.r.num(), s.r.num()),
        91 => mvUniversalJoint_EnableMotor1(j, s.r.flag()),
        92 => mvUniversalJoint_SetMotorSpeed1(j, s.r.num()),
        93 => mvUniversalJoint_SetMaxMotorTorque1(j, s.r.num()),
        94 => mvUniversalJoint_SetFriction1(j, s.r.num()),
        95 => mvUniversalJoint_EnableSpring2(j, s.r.flag()),
        96 => mvUniversalJoint_SetSpringHertz2(j, s.r.num()),
        97 => mvUniversalJoint_SetSpringDampingRatio2(j, s.r.num()),
        98 => mvUniversalJoint_SetTargetAngle2(j, s.r.num()),
        99 => mvUniversalJoint_EnableLimit2(j, s.r.flag()),
        100 => mvUniversalJoint_SetLimits2(j, s.r.num(), s.r.num()),
        101 => mvUniversalJoint_EnableMotor2(j, s.r.flag()),
        102 => mvUniversalJoint_SetMotorSpeed2(j, s.r.num()),
        103 => mvUniversalJoint_SetMaxMotorTorque2(j, s.r.num()),
        104 => mvUniversalJoint_SetFriction2(j, s.r.num()),
        105 => mvWeldJoint_SetLinearHertz(j, s.r.num()),
        106 => mvWeldJoint_SetLinearDampingRatio(j, s.r.num()),
        107 => mvWeldJoint_SetAngularHertz(j, s.r.num()),
        108 => mvWeldJoint_SetAngularDampingRatio(j, s.r.num()),
        109 => mvWheelJoint_EnableSuspension(j, s.r.flag()),
        110 => mvWheelJoint_SetSuspensionHertz(j, s.r.num()),
        111 => mvWheelJoint_SetSuspensionDampingRatio(j, s.r.num()),
        112 => mvWheelJoint_SetTargetSuspension(j, s.r.num()),
        113 => mvWheelJoint_SetMaxSuspensionForce(j, s.r.num()),
        114 => mvWheelJoint_EnableSuspensionLimit(j, s.r.flag()),
        115 => mvWheelJoint_SetSuspensionLimits(j, s.r.num(), s.r.num()),
        116 => mvWheelJoint_EnableSpinMotor(j, s.r.flag()),
        117 => mvWheelJoint_SetSpinMotorSpeed(j, s.r.num()),
        118 => mvWheelJoint_SetMaxSpinTorque(j, s.r.num()),
        119 => mvWheelJoint_SetSpinFriction(j, s.r.num()),
        120 => mvWheelJoint_EnableSteering(j, s.r.flag()),
        121 => mvWheelJoint_SetSteeringHertz(j, s.r.num()),
        122 => mvWheelJoint_SetSteeringDampingRatio(j, s.r.num()),
        123 => mvWheelJoint_SetMaxSteeringTorque(j, s.r.num()),
        124 => mvWheelJoint_EnableSteeringLimit(j, s.r.flag()),
        125 => mvWheelJoint_SetSteeringLimits(j, s.r.num(), s.r.num()),
        126 => mvWheelJoint_SetTargetSteeringAngle(j, s.r.num()),
        _ => {
            let mut axis = MaybeUninit::<mvSixDofAxis>::zeroed();
            // Sound: zeros are numbers.
            let axis = unsafe { axis.assume_init_mut() };
            (axis.mode, axis.target, axis.hertz, axis.lower) =
                (s.r.choice(), s.r.num(), s.r.num(), -s.r.num());
            (axis.upper, axis.motor_speed, axis.max_motor_force) = (s.r.num(), s.r.num(), s.r.num());
            (axis.friction, axis.max_spring_force) = (s.r.num(), s.r.num());
            (axis.enable_spring, axis.enable_motor) = (s.r.flag(), s.r.flag());
            mvSixDofJoint_SetAxis(j, s.r.choice(), *axis);
        }
    }
}

fn get(s: &mut Story, j: mvJointId) {
    match s.r.below(173) {
        0 => drop(mvJoint_IsValid(j)),
        1 => drop(mvJoint_GetType(j)),
        2 => drop(mvJoint_GetBodyA(j)),
        3 => drop(mvJoint_GetBodyB(j)),
        4 => drop(mvJoint_GetWorld(j)),
        5 => drop(mvJoint_GetLocalFrameA(j)),
        6 => drop(mvJoint_GetLocalFrameB(j)),
        7 => drop(mvJoint_GetCollideConnected(j)),
        8 => drop(mvJoint_GetConstraintForce(j)),
        9 => drop(mvJoint_GetConstraintTorque(j)),
        10 => drop(mvJoint_GetLinearSeparation(j)),
        11 => drop(mvJoint_GetAngularSeparation(j)),
        12 => drop(mvJoint_GetForceThreshold(j)),
        13 => drop(mvJoint_GetTorqueThreshold(j)),
        14 => drop(mvJoint_IsBreakable(j)),
        15 => drop(mvJoint_GetDrawScale(j)),
        16 => drop(mvDistanceJoint_GetLength(j)),
        17 => drop(mvDistanceJoint_IsSpringEnabled(j)),
        18 => drop(mvDistanceJoint_GetSpringHertz(j)),
        19 => drop(mvDistanceJoint_GetSpringDampingRatio(j)),
        20 => drop(mvDistanceJoint_IsLimitEnabled(j)),
        21 => drop(mvDistanceJoint_GetMinLength(j)),
        22 => drop(mvDistanceJoint_GetMaxLength(j)),
        23 => drop(mvDistanceJoint_GetCurrentLength(j)),
        24 => drop(mvDistanceJoint_IsMotorEnabled(j)),
        25 => drop(mvDistanceJoint_GetMotorSpeed(j)),
        26 => drop(mvDistanceJoint_GetMaxMotorForce(j)),
        27 => drop(mvDistanceJoint_GetMotorForce(j)),
        28 => drop(mvGearJoint_GetRatio(j)),
        29 => drop(mvMotorJoint_GetLinearVelocity(j)),
        30 => drop(mvMotorJoint_GetAngularVelocity(j)),
        31 => drop(mvMotorJoint_GetMaxVelocityForce(j)),
        32 => drop(mvMotorJoint_GetMaxVelocityTorque(j)),
        33 => drop(mvMotorJoint_GetLinearHertz(j)),
        34 => drop(mvMotorJoint_GetLinearDampingRatio(j)),
        35 => drop(mvMotorJoint_GetAngularHertz(j)),
        36 => drop(mvMotorJoint_GetAngularDampingRatio(j)),
        37 => drop(mvMotorJoint_GetMaxSpringForce(j)),
        38 => drop(mvMotorJoint_GetMaxSpringTorque(j)),
        39 => drop(mvParallelJoint_GetSpringHertz(j)),
        40 => drop(mvParallelJoint_GetSpringDampingRatio(j)),
        41 => drop(mvParallelJoint_GetMaxTorque(j)),
        42 => drop(mvPrismaticJoint_IsSpringEnabled(j)),
        43 => drop(mvPrismaticJoint_GetSpringHertz(j)),
        44 => drop(mvPrismaticJoint_GetSpringDampingRatio(j)),
        45 => drop(mvPrismaticJoint_GetMaxSpringForce(j)),
        46 => drop(mvPrismaticJoint_GetTargetTranslation(j)),
        47 => drop(mvPrismaticJoint_IsLimitEnabled(j)),
        48 => drop(mvPrismaticJoint_GetLowerLimit(j)),
        49 => drop(mvPrismaticJoint_GetUpperLimit(j)),
        50 => drop(mvPrismaticJoint_IsMotorEnabled(j)),
        51 => drop(mvPrismaticJoint_GetMotorSpeed(j)),
        52 => drop(mvPrismaticJoint_GetMaxMotorForce(j)),
        53 => drop(mvPrismaticJoint_GetMotorForce(j)),
        54 => drop(mvPrismaticJoint_GetFriction(j)),
        55 => drop(mvPrismaticJoint_GetTranslation(j)),
        56 => drop(mvPrismaticJoint_GetSpeed(j)),
        57 => drop(mvPulleyJoint_GetGroundAnchorA(j)),
        58 => drop(mvPulleyJoint_GetCurrentLengthA(j)),
        59 => drop(mvPulleyJoint_GetGroundAnchorB(j)),
        60 => drop(mvPulleyJoint_GetCurrentLengthB(j)),
        61 => drop(mvPulleyJoint_GetRatio(j)),
        62 => drop(mvPulleyJoint_GetMinLength(j)),
        63 => drop(mvPulleyJoint_GetMaxLength(j)),
        64 => drop(mvPulleyJoint_GetCurrentLength(j)),
        65 => drop(mvRackPinionJoint_GetRatio(j)),
        66 => drop(mvRevoluteJoint_IsSpringEnabled(j)),
        67 => drop(mvRevoluteJoint_GetSpringHertz(j)),
        68 => drop(mvRevoluteJoint_GetSpringDampingRatio(j)),
        69 => drop(mvRevoluteJoint_GetMaxSpringTorque(j)),
        70 => drop(mvRevoluteJoint_GetTargetAngle(j)),
        71 => drop(mvRevoluteJoint_IsLimitEnabled(j)),
        72 => drop(mvRevoluteJoint_GetLowerLimit(j)),
        73 => drop(mvRevoluteJoint_GetUpperLimit(j)),
        74 => drop(mvRevoluteJoint_IsMotorEnabled(j)),
        75 => drop(mvRevoluteJoint_GetMotorSpeed(j)),
        76 => drop(mvRevoluteJoint_GetMaxMotorTorque(j)),
        77 => drop(mvRevoluteJoint_GetMotorTorque(j)),
        78 => drop(mvRevoluteJoint_GetFriction(j)),
        79 => drop(mvRevoluteJoint_GetAngle(j)),
        80 => drop(mvRevoluteJoint_GetSpeed(j)),
        81 => drop(mvScrewJoint_GetPitch(j)),
        82 => drop(mvScrewJoint_IsSpringEnabled(j)),
        83 => drop(mvScrewJoint_GetSpringHertz(j)),
        84 => drop(mvScrewJoint_GetSpringDampingRatio(j)),
        85 => drop(mvScrewJoint_GetMaxSpringTorque(j)),
        86 => drop(mvScrewJoint_GetTargetAngle(j)),
        87 => drop(mvScrewJoint_IsLimitEnabled(j)),
        88 => drop(mvScrewJoint_GetLowerLimit(j)),
        89 => drop(mvScrewJoint_GetUpperLimit(j)),
        90 => drop(mvScrewJoint_IsMotorEnabled(j)),
        91 => drop(mvScrewJoint_GetMotorSpeed(j)),
        92 => drop(mvScrewJoint_GetMaxMotorTorque(j)),
        93 => drop(mvScrewJoint_GetMotorTorque(j)),
        94 => drop(mvScrewJoint_GetFriction(j)),
        95 => drop(mvScrewJoint_GetAngle(j)),
        96 => drop(mvScrewJoint_GetSpeed(j)),
        97 => drop(mvScrewJoint_GetTranslation(j)),
        98 => drop(mvSixDofJoint_GetAxis(j, s.r.choice())),
        99 => drop(mvSixDofJoint_GetCoordinate(j, s.r.choice())),
        100 => drop(mvSphericalJoint_IsConeLimitEnabled(j)),
        101 => drop(mvSphericalJoint_GetConeLimit(j)),
        102 => drop(mvSphericalJoint_GetConeLimitY(j)),
        103 => drop(mvSphericalJoint_GetConeAngle(j)),
        104 => drop(mvSphericalJoint_IsTwistLimitEnabled(j)),
        105 => drop(mvSphericalJoint_GetLowerTwistLimit(j)),
        106 => drop(mvSphericalJoint_GetUpperTwistLimit(j)),
        107 => drop(mvSphericalJoint_GetTwistAngle(j)),
        108 => drop(mvSphericalJoint_IsSpringEnabled(j)),
        109 => drop(mvSphericalJoint_GetSpringHertz(j)),
        110 => drop(mvSphericalJoint_GetSpringDampingRatio(j)),
        111 => drop(mvSphericalJoint_GetMaxSpringTorque(j)),
        112 => drop(mvSphericalJoint_GetTargetRotation(j)),
        113 => drop(mvSphericalJoint_IsMotorEnabled(j)),
        114 => drop(mvSphericalJoint_GetMotorVelocity(j)),
        115 => drop(mvSphericalJoint_GetMotorTorque(j)),
        116 => drop(mvSphericalJoint_GetMaxMotorTorque(j)),
        117 => drop(mvSphericalJoint_GetFriction(j)),
        118 => drop(mvUniversalJoint_GetAngle1(j)),
        119 => drop(mvUniversalJoint_IsSpring1Enabled(j)),
        120 => drop(mvUniversalJoint_GetSpringHertz1(j)),
        121 => drop(mvUniversalJoint_GetSpringDampingRatio1(j)),
        122 => drop(mvUniversalJoint_GetTargetAngle1(j)),
        123 => drop(mvUniversalJoint_IsLimit1Enabled(j)),
        124 => drop(mvUniversalJoint_GetLowerLimit1(j)),
        125 => drop(mvUniversalJoint_GetUpperLimit1(j)),
        126 => drop(mvUniversalJoint_IsMotor1Enabled(j)),
        127 => drop(mvUniversalJoint_GetMotorSpeed1(j)),
        128 => drop(mvUniversalJoint_GetMaxMotorTorque1(j)),
        129 => drop(mvUniversalJoint_GetFriction1(j)),
        130 => drop(mvUniversalJoint_GetAngle2(j)),
        131 => drop(mvUniversalJoint_IsSpring2Enabled(j)),
        132 => drop(mvUniversalJoint_GetSpringHertz2(j)),
        133 => drop(mvUniversalJoint_GetSpringDampingRatio2(j)),
        134 => drop(mvUniversalJoint_GetTargetAngle2(j)),
        135 => drop(mvUniversalJoint_IsLimit2Enabled(j)),
        136 => drop(mvUniversalJoint_GetLowerLimit2(j)),
        137 => drop(mvUniversalJoint_GetUpperLimit2(j)),
        138 => drop(mvUniversalJoint_IsMotor2Enabled(j)),
        139 => drop(mvUniversalJoint_GetMotorSpeed2(j)),
        140 => drop(mvUniversalJoint_GetMaxMotorTorque2(j)),
        141 => drop(mvUniversalJoint_GetFriction2(j)),
        142 => drop(mvWeldJoint_GetLinearHertz(j)),
        143 => drop(mvWeldJoint_GetLinearDampingRatio(j)),
        144 => drop(mvWeldJoint_GetAngularHertz(j)),
        145 => drop(mvWeldJoint_GetAngularDampingRatio(j)),
        146 => drop(mvWheelJoint_IsSuspensionEnabled(j)),
        147 => drop(mvWheelJoint_GetSuspensionHertz(j)),
        148 => drop(mvWheelJoint_GetSuspensionDampingRatio(j)),
        149 => drop(mvWheelJoint_GetTargetSuspension(j)),
        150 => drop(mvWheelJoint_GetMaxSuspensionForce(j)),
        151 => drop(mvWheelJoint_GetSuspensionTravel(j)),
        152 => drop(mvWheelJoint_IsSuspensionLimitEnabled(j)),
        153 => drop(mvWheelJoint_GetLowerSuspensionLimit(j)),
        154 => drop(mvWheelJoint_GetUpperSuspensionLimit(j)),
        155 => drop(mvWheelJoint_IsSpinMotorEnabled(j)),
        156 => drop(mvWheelJoint_GetSpinMotorSpeed(j)),
        157 => drop(mvWheelJoint_GetMaxSpinTorque(j)),
        158 => drop(mvWheelJoint_GetSpinFriction(j)),
        159 => drop(mvWheelJoint_GetSpinSpeed(j)),
        160 => drop(mvWheelJoint_GetSpinAngle(j)),
        161 => drop(mvWheelJoint_GetSpinTorque(j)),
        162 => drop(mvWheelJoint_IsSteeringEnabled(j)),
        163 => drop(mvWheelJoint_GetSteeringHertz(j)),
        164 => drop(mvWheelJoint_GetSteeringDampingRatio(j)),
        165 => drop(mvWheelJoint_GetMaxSteeringTorque(j)),
        166 => drop(mvWheelJoint_IsSteeringLimitEnabled(j)),
        167 => drop(mvWheelJoint_GetLowerSteeringLimit(j)),
        168 => drop(mvWheelJoint_GetUpperSteeringLimit(j)),
        169 => drop(mvWheelJoint_GetTargetSteeringAngle(j)),
        170 => drop(mvWheelJoint_GetSteeringAngle(j)),
        171 => drop(mvWheelJoint_GetSteeringTorque(j)),
        _ => {
            let (mut x, mut y) = (0.0, 0.0);
            mvDistanceJoint_GetSpringForceRange(j, Some(&mut x), None);
            mvJoint_GetConstraintTuning(j, Some(&mut x), Some(&mut y));
            assert!(y >= 0.0);
        }
    }
}
