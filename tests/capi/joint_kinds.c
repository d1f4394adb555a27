/* Every setter and getter of every kind of joint: what is set is read back, nonsense changes nothing, and a joint of
 * another kind is refused. */
#include "check.h"

#define NUMBER(P, Name, joint, other)                                                                          \
    do                                                                                                         \
    {                                                                                                          \
        WORKS(P##_Set##Name(joint, (mvFloat)0.75));                                                            \
        CHECK(P##_Get##Name(joint) == (mvFloat)0.75);                                                          \
        FAILS(mv_errorNotFinite, P##_Set##Name, P##_Set##Name(joint, (mvFloat)NAN));                           \
        CHECK(P##_Get##Name(joint) == (mvFloat)0.75);                                                          \
        FAILS(mv_errorRange, P##_Set##Name, P##_Set##Name(other, (mvFloat)0.75));                              \
        FAILS(mv_errorRange, P##_Get##Name, CHECK(P##_Get##Name(other) == 0));                                 \
        FAILS(mv_errorNull, P##_Set##Name, P##_Set##Name(mv_nullJointId, 1));                                  \
    } while (0)

#define VECTOR(P, Name, joint, other)                                                                          \
    do                                                                                                         \
    {                                                                                                          \
        WORKS(P##_Set##Name(joint, vec(1, -2, 3)));                                                            \
        CHECK(nearVec(P##_Get##Name(joint), vec(1, -2, 3), 0));                                                \
        FAILS(mv_errorNotFinite, P##_Set##Name, P##_Set##Name(joint, vec(0, (mvFloat)INFINITY, 0)));           \
        CHECK(nearVec(P##_Get##Name(joint), vec(1, -2, 3), 0));                                                \
        FAILS(mv_errorRange, P##_Set##Name, P##_Set##Name(other, vec(1, 2, 3)));                               \
        FAILS(mv_errorRange, P##_Get##Name, CHECK(nearVec(P##_Get##Name(other), vec(0, 0, 0), 0)));            \
    } while (0)

#define SWITCH(P, Name, joint, other)                                                                          \
    do                                                                                                         \
    {                                                                                                          \
        WORKS(P##_Enable##Name(joint, true));                                                                  \
        CHECK(P##_Is##Name##Enabled(joint));                                                                   \
        WORKS(P##_Enable##Name(joint, false));                                                                 \
        CHECK(!P##_Is##Name##Enabled(joint));                                                                  \
        FAILS(mv_errorRange, P##_Enable##Name, P##_Enable##Name(other, true));                                 \
        FAILS(mv_errorRange, P##_Is##Name##Enabled, CHECK(!P##_Is##Name##Enabled(other)));                     \
    } while (0)

#define RANGE(P, Name, Lower, Upper, joint, other)                                                             \
    do                                                                                                         \
    {                                                                                                          \
        WORKS(P##_Set##Name(joint, (mvFloat)0.25, (mvFloat)0.5));                                              \
        CHECK(P##_Get##Lower(joint) == (mvFloat)0.25 && P##_Get##Upper(joint) == (mvFloat)0.5);                \
        FAILS(mv_errorRange, P##_Set##Name, P##_Set##Name(joint, 2, 1));                                       \
        FAILS(mv_errorNotFinite, P##_Set##Name, P##_Set##Name(joint, 0, (mvFloat)NAN));                        \
        CHECK(P##_Get##Lower(joint) == (mvFloat)0.25 && P##_Get##Upper(joint) == (mvFloat)0.5);                \
        FAILS(mv_errorRange, P##_Set##Name, P##_Set##Name(other, 0, 1));                                       \
        FAILS(mv_errorRange, P##_Get##Upper, CHECK(P##_Get##Upper(other) == 0));                               \
    } while (0)

#define READING(P, Name, joint, other)                                                                         \
    do                                                                                                         \
    {                                                                                                          \
        WORKS(CHECK(mvIsValidFloat(P##_Get##Name(joint))));                                                    \
        FAILS(mv_errorRange, P##_Get##Name, CHECK(P##_Get##Name(other) == 0));                                 \
    } while (0)

static void parallels(mvJointId j, mvJointId other)
{
    NUMBER(mvParallelJoint, SpringHertz, j, other);
    NUMBER(mvParallelJoint, SpringDampingRatio, j, other);
    NUMBER(mvParallelJoint, MaxTorque, j, other);
}

static void distances(mvJointId j, mvJointId other)
{
    NUMBER(mvDistanceJoint, Length, j, other);
    SWITCH(mvDistanceJoint, Spring, j, other);
    NUMBER(mvDistanceJoint, SpringHertz, j, other);
    NUMBER(mvDistanceJoint, SpringDampingRatio, j, other);
    SWITCH(mvDistanceJoint, Limit, j, other);
    RANGE(mvDistanceJoint, LengthRange, MinLength, MaxLength, j, other);
    READING(mvDistanceJoint, CurrentLength, j, other);
    SWITCH(mvDistanceJoint, Motor, j, other);
    NUMBER(mvDistanceJoint, MotorSpeed, j, other);
    NUMBER(mvDistanceJoint, MaxMotorForce, j, other);
    READING(mvDistanceJoint, MotorForce, j, other);
}

static void motors(mvJointId j, mvJointId other)
{
    VECTOR(mvMotorJoint, LinearVelocity, j, other);
    VECTOR(mvMotorJoint, AngularVelocity, j, other);
    NUMBER(mvMotorJoint, MaxVelocityForce, j, other);
    NUMBER(mvMotorJoint, MaxVelocityTorque, j, other);
    NUMBER(mvMotorJoint, LinearHertz, j, other);
    NUMBER(mvMotorJoint, LinearDampingRatio, j, other);
    NUMBER(mvMotorJoint, AngularHertz, j, other);
    NUMBER(mvMotorJoint, AngularDampingRatio, j, other);
    NUMBER(mvMotorJoint, MaxSpringForce, j, other);
    NUMBER(mvMotorJoint, MaxSpringTorque, j, other);
}

static void prismatics(mvJointId j, mvJointId other)
{
    SWITCH(mvPrismaticJoint, Spring, j, other);
    NUMBER(mvPrismaticJoint, SpringHertz, j, other);
    NUMBER(mvPrismaticJoint, SpringDampingRatio, j, other);
    NUMBER(mvPrismaticJoint, MaxSpringForce, j, other);
    NUMBER(mvPrismaticJoint, TargetTranslation, j, other);
    SWITCH(mvPrismaticJoint, Limit, j, other);
    RANGE(mvPrismaticJoint, Limits, LowerLimit, UpperLimit, j, other);
    SWITCH(mvPrismaticJoint, Motor, j, other);
    NUMBER(mvPrismaticJoint, MotorSpeed, j, other);
    NUMBER(mvPrismaticJoint, MaxMotorForce, j, other);
    READING(mvPrismaticJoint, MotorForce, j, other);
    NUMBER(mvPrismaticJoint, Friction, j, other);
    READING(mvPrismaticJoint, Translation, j, other);
    READING(mvPrismaticJoint, Speed, j, other);
}

static void revolutes(mvJointId j, mvJointId other)
{
    SWITCH(mvRevoluteJoint, Spring, j, other);
    NUMBER(mvRevoluteJoint, SpringHertz, j, other);
    NUMBER(mvRevoluteJoint, SpringDampingRatio, j, other);
    NUMBER(mvRevoluteJoint, MaxSpringTorque, j, other);
    NUMBER(mvRevoluteJoint, TargetAngle, j, other);
    SWITCH(mvRevoluteJoint, Limit, j, other);
    RANGE(mvRevoluteJoint, Limits, LowerLimit, UpperLimit, j, other);
    SWITCH(mvRevoluteJoint, Motor, j, other);
    NUMBER(mvRevoluteJoint, MotorSpeed, j, other);
    NUMBER(mvRevoluteJoint, MaxMotorTorque, j, other);
    READING(mvRevoluteJoint, MotorTorque, j, other);
    NUMBER(mvRevoluteJoint, Friction, j, other);
    READING(mvRevoluteJoint, Angle, j, other);
    READING(mvRevoluteJoint, Speed, j, other);
}

static void sphericals(mvJointId j, mvJointId other)
{
    SWITCH(mvSphericalJoint, ConeLimit, j, other);
    NUMBER(mvSphericalJoint, ConeLimit, j, other);
    READING(mvSphericalJoint, ConeAngle, j, other);
    SWITCH(mvSphericalJoint, TwistLimit, j, other);
    RANGE(mvSphericalJoint, TwistLimits, LowerTwistLimit, UpperTwistLimit, j, other);
    READING(mvSphericalJoint, TwistAngle, j, other);
    SWITCH(mvSphericalJoint, Spring, j, other);
    NUMBER(mvSphericalJoint, SpringHertz, j, other);
    NUMBER(mvSphericalJoint, SpringDampingRatio, j, other);
    NUMBER(mvSphericalJoint, MaxSpringTorque, j, other);
    SWITCH(mvSphericalJoint, Motor, j, other);
    VECTOR(mvSphericalJoint, MotorVelocity, j, other);
    CHECK(mvIsValidVec3(mvSphericalJoint_GetMotorTorque(j)));
    NUMBER(mvSphericalJoint, MaxMotorTorque, j, other);
    NUMBER(mvSphericalJoint, Friction, j, other);
}

static void welds(mvJointId j, mvJointId other)
{
    NUMBER(mvWeldJoint, LinearHertz, j, other);
    NUMBER(mvWeldJoint, LinearDampingRatio, j, other);
    NUMBER(mvWeldJoint, AngularHertz, j, other);
    NUMBER(mvWeldJoint, AngularDampingRatio, j, other);
}

static void wheels(mvJointId j, mvJointId other)
{
    SWITCH(mvWheelJoint, Suspension, j, other);
    NUMBER(mvWheelJoint, SuspensionHertz, j, other);
    NUMBER(mvWheelJoint, SuspensionDampingRatio, j, other);
    NUMBER(mvWheelJoint, TargetSuspension, j, other);
    NUMBER(mvWheelJoint, MaxSuspensionForce, j, other);
    READING(mvWheelJoint, SuspensionTravel, j, other);
    SWITCH(mvWheelJoint, SuspensionLimit, j, other);
    RANGE(mvWheelJoint, SuspensionLimits, LowerSuspensionLimit, UpperSuspensionLimit, j, other);
    SWITCH(mvWheelJoint, SpinMotor, j, other);
    NUMBER(mvWheelJoint, SpinMotorSpeed, j, other);
    NUMBER(mvWheelJoint, MaxSpinTorque, j, other);
    NUMBER(mvWheelJoint, SpinFriction, j, other);
    READING(mvWheelJoint, SpinSpeed, j, other);
    READING(mvWheelJoint, SpinAngle, j, other);
    READING(mvWheelJoint, SpinTorque, j, other);
    SWITCH(mvWheelJoint, Steering, j, other);
    NUMBER(mvWheelJoint, SteeringHertz, j, other);
    NUMBER(mvWheelJoint, SteeringDampingRatio, j, other);
    NUMBER(mvWheelJoint, MaxSteeringTorque, j, other);
    SWITCH(mvWheelJoint, SteeringLimit, j, other);
    RANGE(mvWheelJoint, SteeringLimits, LowerSteeringLimit, UpperSteeringLimit, j, other);
    NUMBER(mvWheelJoint, TargetSteeringAngle, j, other);
    READING(mvWheelJoint, SteeringAngle, j, other);
    READING(mvWheelJoint, SteeringTorque, j, other);
}

static void universals(mvJointId j, mvJointId other)
{
    READING(mvUniversalJoint, Angle1, j, other);
    SWITCH(mvUniversalJoint, Spring1, j, other);
    NUMBER(mvUniversalJoint, SpringHertz1, j, other);
    NUMBER(mvUniversalJoint, SpringDampingRatio1, j, other);
    NUMBER(mvUniversalJoint, TargetAngle1, j, other);
    SWITCH(mvUniversalJoint, Limit1, j, other);
    RANGE(mvUniversalJoint, Limits1, LowerLimit1, UpperLimit1, j, other);
    SWITCH(mvUniversalJoint, Motor1, j, other);
    NUMBER(mvUniversalJoint, MotorSpeed1, j, other);
    NUMBER(mvUniversalJoint, MaxMotorTorque1, j, other);
    NUMBER(mvUniversalJoint, Friction1, j, other);
    READING(mvUniversalJoint, Angle2, j, other);
    SWITCH(mvUniversalJoint, Spring2, j, other);
    NUMBER(mvUniversalJoint, SpringHertz2, j, other);
    NUMBER(mvUniversalJoint, SpringDampingRatio2, j, other);
    NUMBER(mvUniversalJoint, TargetAngle2, j, other);
    SWITCH(mvUniversalJoint, Limit2, j, other);
    RANGE(mvUniversalJoint, Limits2, LowerLimit2, UpperLimit2, j, other);
    SWITCH(mvUniversalJoint, Motor2, j, other);
    NUMBER(mvUniversalJoint, MotorSpeed2, j, other);
    NUMBER(mvUniversalJoint, MaxMotorTorque2, j, other);
    NUMBER(mvUniversalJoint, Friction2, j, other);
}

static void gears(mvJointId j, mvJointId other)
{
    NUMBER(mvGearJoint, Ratio, j, other);
}

static void rackPinions(mvJointId j, mvJointId other)
{
    NUMBER(mvRackPinionJoint, Ratio, j, other);
}

static void pulleys(mvJointId j, mvJointId other)
{
    READING(mvPulleyJoint, CurrentLengthA, j, other);
    READING(mvPulleyJoint, CurrentLengthB, j, other);
    NUMBER(mvPulleyJoint, Ratio, j, other);
    RANGE(mvPulleyJoint, LengthRange, MinLength, MaxLength, j, other);
    READING(mvPulleyJoint, CurrentLength, j, other);
}

static void screws(mvJointId j, mvJointId other)
{
    NUMBER(mvScrewJoint, Pitch, j, other);
    SWITCH(mvScrewJoint, Spring, j, other);
    NUMBER(mvScrewJoint, SpringHertz, j, other);
    NUMBER(mvScrewJoint, SpringDampingRatio, j, other);
    NUMBER(mvScrewJoint, MaxSpringTorque, j, other);
    NUMBER(mvScrewJoint, TargetAngle, j, other);
    SWITCH(mvScrewJoint, Limit, j, other);
    RANGE(mvScrewJoint, Limits, LowerLimit, UpperLimit, j, other);
    SWITCH(mvScrewJoint, Motor, j, other);
    NUMBER(mvScrewJoint, MotorSpeed, j, other);
    NUMBER(mvScrewJoint, MaxMotorTorque, j, other);
    READING(mvScrewJoint, MotorTorque, j, other);
    NUMBER(mvScrewJoint, Friction, j, other);
    READING(mvScrewJoint, Angle, j, other);
    READING(mvScrewJoint, Speed, j, other);
    READING(mvScrewJoint, Translation, j, other);
}

static mvBodyId bodies[2];
static mvWorldId world;
static mvJointId all[15];
static mvJointId filter;

/* A definition that is null, or whose cookie is wrong, is refused; a good one makes a joint of the kind. */
#define CREATE(Name, type, change)                                                                             \
    do                                                                                                         \
    {                                                                                                          \
        mv##Name##JointDef def = mvDefault##Name##JointDef();                                                  \
        def.base.bodyIdA = bodies[0];                                                                          \
        def.base.bodyIdB = bodies[1];                                                                          \
        change;                                                                                                \
        FAILS(mv_errorNull, mvCreate##Name##Joint, CHECK(MV_IS_NULL(mvCreate##Name##Joint(world, NULL))));     \
        WORKS(all[type] = mvCreate##Name##Joint(world, &def));                                                 \
        CHECK(mvJoint_IsValid(all[type]) && mvJoint_GetType(all[type]) == (type));                             \
        def.internalValue += 1;                                                                                \
        FAILS(mv_errorDefinition, mvCreate##Name##Joint,                                                       \
              CHECK(MV_IS_NULL(mvCreate##Name##Joint(world, &def))));                                          \
    } while (0)

static void rest(void)
{
    mvJointId j = all[mv_distanceJoint], s = all[mv_sphericalJoint], six = all[mv_sixDofJoint];
    mvFloat least = 7, most = 7;
    mvQuat turn = mvMakeQuatFromAxisAngle(mvVec3_axisZ, 1);
    mvSixDofAxis axis;

    WORKS(mvDistanceJoint_SetSpringForceRange(j, -2, 3));
    WORKS(mvDistanceJoint_GetSpringForceRange(j, &least, &most));
    CHECK(least == -2 && most == 3);
    WORKS(mvDistanceJoint_GetSpringForceRange(j, NULL, NULL));
    FAILS(mv_errorRange, mvDistanceJoint_SetSpringForceRange, mvDistanceJoint_SetSpringForceRange(j, 3, -2));
    FAILS(mv_errorRange, mvDistanceJoint_GetSpringForceRange,
          mvDistanceJoint_GetSpringForceRange(filter, &least, &most));
    CHECK(least == -2 && most == 3);

    WORKS(mvSphericalJoint_SetConeLimits(s, (mvFloat)0.25, (mvFloat)0.5));
    CHECK(mvSphericalJoint_GetConeLimit(s) == (mvFloat)0.25 && mvSphericalJoint_GetConeLimitY(s) == (mvFloat)0.5);
    FAILS(mv_errorRange, mvSphericalJoint_SetConeLimits, mvSphericalJoint_SetConeLimits(s, 1, -1));
    FAILS(mv_errorRange, mvSphericalJoint_SetConeLimit, mvSphericalJoint_SetConeLimit(s, 4));
    CHECK(mvSphericalJoint_GetConeLimit(s) == (mvFloat)0.25);
    WORKS(mvSphericalJoint_SetTargetRotation(s, turn));
    CHECK(near(mvSphericalJoint_GetTargetRotation(s).v.z, turn.v.z, (mvFloat)1e-6));
    turn.s = 5;
    FAILS(mv_errorRange, mvSphericalJoint_SetTargetRotation, mvSphericalJoint_SetTargetRotation(s, turn));

    axis = mvSixDofJoint_GetAxis(six, 4);
    CHECK(axis.mode == mv_axisLocked && !axis.enableMotor);
    axis.mode = mv_axisLimited;
    axis.lower = -1;
    axis.upper = 2;
    axis.enableMotor = true;
    WORKS(mvSixDofJoint_SetAxis(six, 4, axis));
    axis = mvSixDofJoint_GetAxis(six, 4);
    CHECK(axis.mode == mv_axisLimited && axis.lower == -1 && axis.upper == 2 && axis.enableMotor);
    axis.mode = 7;
    FAILS(mv_errorRange, mvSixDofJoint_SetAxis, mvSixDofJoint_SetAxis(six, 4, axis));
    FAILS(mv_errorRange, mvSixDofJoint_GetAxis, mvSixDofJoint_GetAxis(six, 6));
    FAILS(mv_errorRange, mvSixDofJoint_GetCoordinate, mvSixDofJoint_GetCoordinate(six, -1));
    FAILS(mv_errorRange, mvSixDofJoint_GetAxis, mvSixDofJoint_GetAxis(filter, 0));
    WORKS(CHECK(near(mvSixDofJoint_GetCoordinate(six, 0), 1, (mvFloat)1e-6)));

    /* Ratios of gears and pulleys must not be 0; a sentence names both kinds. */
    FAILS(mv_errorRange, mvGearJoint_SetRatio, mvGearJoint_SetRatio(all[mv_gearJoint], 0));
    FAILS(mv_errorRange, mvPulleyJoint_SetRatio, mvPulleyJoint_SetRatio(all[mv_pulleyJoint], 0));
    FAILS(mv_errorRange, mvGearJoint_SetRatio, mvGearJoint_SetRatio(all[mv_rackPinionJoint], 1));
    CHECK(strstr(mvGetLastErrorMessage(), "rack-and-pinion joint") != NULL);
    CHECK(strstr(mvGetLastErrorMessage(), "not a gear joint") != NULL);
    WORKS(mvPulleyJoint_SetGroundAnchorA(all[mv_pulleyJoint], pos(1, 5, 0)));
    CHECK(mvPulleyJoint_GetGroundAnchorA(all[mv_pulleyJoint]).y == 5);
    WORKS(mvPulleyJoint_SetGroundAnchorB(all[mv_pulleyJoint], pos(2, 6, 0)));
    CHECK(mvPulleyJoint_GetGroundAnchorB(all[mv_pulleyJoint]).y == 6);
}

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    int k;

    world = mvCreateWorld(&worldDef);
    bodyDef.type = mv_dynamicBody;
    for (k = 0; k < 2; ++k)
    {
        bodyDef.position.x = (mvFloat)k;
        bodies[k] = mvCreateBody(world, &bodyDef);
        mvCreateBoxShape(bodies[k], &shapeDef, (mvFloat)0.2, (mvFloat)0.2, (mvFloat)0.2);
    }
    CREATE(Parallel, mv_parallelJoint, (void)0);
    CREATE(Distance, mv_distanceJoint, (void)0);
    CREATE(Filter, mv_filterJoint, (void)0);
    CREATE(Motor, mv_motorJoint, (void)0);
    CREATE(Prismatic, mv_prismaticJoint, (void)0);
    CREATE(Revolute, mv_revoluteJoint, (void)0);
    CREATE(Spherical, mv_sphericalJoint, (void)0);
    CREATE(Weld, mv_weldJoint, (void)0);
    CREATE(Wheel, mv_wheelJoint, (void)0);
    CREATE(Universal, mv_universalJoint, (void)0);
    CREATE(SixDof, mv_sixDofJoint, (void)0);
    CREATE(Gear, mv_gearJoint, (def.jointIdA = all[mv_revoluteJoint], def.jointIdB = all[mv_prismaticJoint]));
    CREATE(RackPinion, mv_rackPinionJoint,
           (def.jointIdA = all[mv_revoluteJoint], def.jointIdB = all[mv_prismaticJoint]));
    CREATE(Pulley, mv_pulleyJoint, (void)0);
    CREATE(Screw, mv_screwJoint, (void)0);
    filter = all[mv_filterJoint];
    CHECK(mvWorld_GetCounters(world).jointCount == 15);
    rest();
    parallels(all[mv_parallelJoint], filter);
    distances(all[mv_distanceJoint], filter);
    motors(all[mv_motorJoint], filter);
    prismatics(all[mv_prismaticJoint], filter);
    revolutes(all[mv_revoluteJoint], filter);
    sphericals(all[mv_sphericalJoint], filter);
    welds(all[mv_weldJoint], filter);
    wheels(all[mv_wheelJoint], filter);
    universals(all[mv_universalJoint], filter);
    gears(all[mv_gearJoint], filter);
    rackPinions(all[mv_rackPinionJoint], filter);
    pulleys(all[mv_pulleyJoint], filter);
    screws(all[mv_screwJoint], filter);

    /* A gear goes with either of its joints. */
    WORKS(mvDestroyJoint(all[mv_prismaticJoint], true));
    CHECK(!mvJoint_IsValid(all[mv_gearJoint]) && !mvJoint_IsValid(all[mv_rackPinionJoint]));
    FAILS(mv_errorStale, mvGearJoint_GetRatio, CHECK(mvGearJoint_GetRatio(all[mv_gearJoint]) == 0));
    CHECK(mvBody_GetJointCount(bodies[0]) == 12);
    mvDestroyWorld(world);
    return done("joint_kinds");
}
