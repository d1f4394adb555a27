/* Joints: life cycle, what all of them have, readings, events and breaking. */
#include "check.h"

static const mvFloat dt = (mvFloat)(1.0 / 60);

static mvBodyId box(mvWorldId world, mvBodyType type, mvPos at)
{
    mvBodyDef def = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvBodyId body;
    def.type = type;
    def.position = at;
    def.enableSleep = false;
    body = mvCreateBody(world, &def);
    mvCreateBoxShape(body, &shapeDef, (mvFloat)0.25, (mvFloat)0.25, (mvFloat)0.25);
    return body;
}

static void run(mvWorldId world, int steps)
{
    while (steps-- > 0)
    {
        mvWorld_Step(world, dt, 4);
    }
}

static void common(mvWorldId world)
{
    mvBodyId a = box(world, mv_staticBody, pos(0, 5, 0)), b = box(world, mv_dynamicBody, pos(1, 5, 0));
    mvRevoluteJointDef def = mvDefaultRevoluteJointDef();
    mvTransform frame = mvTransform_identity, bad = mvTransform_identity;
    mvFloat hertz = 9, damping = 9;
    mvJointId joint, list[3];
    int tag = 3;

    CHECK(def.base.constraintHertz == 0 && def.base.constraintDampingRatio == 2 && def.base.drawScale == 1);
    CHECK(!def.base.collideConnected && !def.base.breakable && def.base.localFrameA.q.s == 1);
    def.base.bodyIdA = a;
    def.base.bodyIdB = a;
    FAILS(mv_errorRange, mvCreateRevoluteJoint, CHECK(MV_IS_NULL(mvCreateRevoluteJoint(world, &def))));
    def.base.bodyIdB = mv_nullBodyId;
    FAILS(mv_errorNull, mvCreateRevoluteJoint, CHECK(MV_IS_NULL(mvCreateRevoluteJoint(world, &def))));
    def.base.bodyIdB = b;
    def.base.localFrameB.q.s = 3;
    FAILS(mv_errorRange, mvCreateRevoluteJoint, CHECK(MV_IS_NULL(mvCreateRevoluteJoint(world, &def))));
    def.base.localFrameB.q.s = 1;
    def.lowerAngle = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvCreateRevoluteJoint, CHECK(MV_IS_NULL(mvCreateRevoluteJoint(world, &def))));
    def.lowerAngle = 0;
    def.base.localFrameB.p.x = -1;
    def.base.userData = &tag;
    WORKS(joint = mvCreateRevoluteJoint(world, &def));
    CHECK(mvJoint_IsValid(joint) && mvJoint_GetUserData(joint) == &tag);
    CHECK(MV_ID_EQUALS(mvLoadJointId(mvStoreJointId(joint)), joint) && mvStoreJointId(mv_nullJointId) == 0);
    CHECK(MV_ID_EQUALS(mvJoint_GetBodyA(joint), a) && MV_ID_EQUALS(mvJoint_GetBodyB(joint), b));
    CHECK(mvJoint_GetWorld(joint).index1 == world.index1 && mvJoint_GetDrawScale(joint) == 1);
    CHECK(mvBody_GetJointCount(b) == 1 && mvBody_GetJoints(b, list, 3) == 1 && MV_ID_EQUALS(list[0], joint));
    CHECK(mvBody_GetJoints(b, NULL, 0) == 0);
    FAILS(mv_errorRange, mvBody_GetJoints, mvBody_GetJoints(b, list, -1));

    WORKS(mvJoint_SetUserData(joint, NULL));
    CHECK(mvJoint_GetUserData(joint) == NULL);
    WORKS(mvJoint_SetCollideConnected(joint, true));
    CHECK(mvJoint_GetCollideConnected(joint));
    WORKS(mvJoint_SetCollideConnected(joint, false));
    CHECK(!mvJoint_GetCollideConnected(joint));
    WORKS(mvJoint_SetConstraintTuning(joint, 30, 1));
    WORKS(mvJoint_GetConstraintTuning(joint, &hertz, &damping));
    CHECK(hertz == 30 && damping == 1);
    FAILS(mv_errorRange, mvJoint_SetConstraintTuning, mvJoint_SetConstraintTuning(joint, -1, 1));
    WORKS(mvJoint_GetConstraintTuning(joint, NULL, NULL));
    WORKS(mvJoint_SetConstraintTuning(joint, 0, 2));
    WORKS(mvJoint_SetForceThreshold(joint, 5));
    WORKS(mvJoint_SetTorqueThreshold(joint, 6));
    CHECK(mvJoint_GetForceThreshold(joint) == 5 && mvJoint_GetTorqueThreshold(joint) == 6);
    FAILS(mv_errorRange, mvJoint_SetForceThreshold, mvJoint_SetForceThreshold(joint, (mvFloat)NAN));
    FAILS(mv_errorRange, mvJoint_SetTorqueThreshold, mvJoint_SetTorqueThreshold(joint, -1));
    WORKS(mvJoint_SetForceThreshold(joint, (mvFloat)INFINITY));
    WORKS(mvJoint_SetTorqueThreshold(joint, (mvFloat)INFINITY));
    WORKS(mvJoint_SetBreakable(joint, true));
    CHECK(mvJoint_IsBreakable(joint));
    frame.p.x = 2;
    WORKS(mvJoint_SetLocalFrameA(joint, frame));
    CHECK(mvJoint_GetLocalFrameA(joint).p.x == 2 && near(mvJoint_GetLinearSeparation(joint), 2, (mvFloat)1e-5));
    CHECK(near(mvWorld_GetStepReport(world).jointGap, 2, (mvFloat)1e-5));
    WORKS(mvJoint_SetLocalFrameA(joint, mvTransform_identity));
    bad.q.s = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvJoint_SetLocalFrameB, mvJoint_SetLocalFrameB(joint, bad));
    frame.p.x = -1;
    WORKS(mvJoint_SetLocalFrameB(joint, frame));
    CHECK(mvJoint_GetLocalFrameB(joint).p.x == -1);
    CHECK(near(mvJoint_GetAngularSeparation(joint), 0, (mvFloat)1e-5));
    WORKS(mvJoint_WakeBodies(joint));

    WORKS(mvDestroyJoint(joint, true));
    FAILS(mv_errorStale, mvDestroyJoint, mvDestroyJoint(joint, true));
    FAILS(mv_errorNull, mvJoint_GetType, CHECK(mvJoint_GetType(mv_nullJointId) == 0));
    FAILS(mv_errorStale, mvJoint_GetBodyA, CHECK(MV_IS_NULL(mvJoint_GetBodyA(joint))));
    FAILS(mv_errorStale, mvRevoluteJoint_GetAngle, CHECK(mvRevoluteJoint_GetAngle(joint) == 0));
    joint = mvCreateRevoluteJoint(world, &def);
    mvDestroyBody(b);
    CHECK(!mvJoint_IsValid(joint) && mvBody_GetJointCount(a) == 0);
    mvDestroyBody(a);
}

/* A motor turns a hinge more than twice round: the angle counts turns; the hinge carries the weight. */
static void readings(mvWorldId world)
{
    mvBodyId a = box(world, mv_staticBody, pos(0, 5, 0)), b = box(world, mv_dynamicBody, pos(0, 5, 0));
    mvRevoluteJointDef def = mvDefaultRevoluteJointDef();
    mvJointId joint;
    mvFloat weight = 10 * mvBody_GetMass(b);

    def.base.bodyIdA = a;
    def.base.bodyIdB = b;
    def.enableMotor = true;
    def.motorSpeed = 5;
    def.maxMotorTorque = 1000;
    joint = mvCreateRevoluteJoint(world, &def);
    run(world, 180);
    CHECK(near(mvRevoluteJoint_GetAngle(joint), 15, (mvFloat)0.1));
    CHECK(near(mvRevoluteJoint_GetSpeed(joint), 5, (mvFloat)0.01));
    CHECK(near(mvJoint_GetConstraintForce(joint).y, weight, (mvFloat)0.01 * weight));
    CHECK(mvIsValidVec3(mvJoint_GetConstraintTorque(joint)));
    WORKS(mvRevoluteJoint_SetMotorSpeed(joint, -5));
    mvWorld_Step(world, dt, 1);
    CHECK(mvRevoluteJoint_GetMotorTorque(joint) < 0);
    CHECK(mvWorld_GetCounters(world).jointCount == 1);
    mvDestroyBody(a);
    mvDestroyBody(b);
}

/* A weld that carries a box: an event each step above the threshold; once it may break, it does. */
static void breaking(mvWorldId world)
{
    mvBodyId a = box(world, mv_staticBody, pos(0, 9, 0)), b = box(world, mv_dynamicBody, pos(0, 8, 0));
    mvWeldJointDef def = mvDefaultWeldJointDef();
    mvJointEvents events;
    mvJointId joint;
    mvFloat weight = 10 * mvBody_GetMass(b), height;
    int tag = 4;

    def.base.bodyIdA = a;
    def.base.bodyIdB = b;
    def.base.localFrameA.p.y = -1;
    def.base.userData = &tag;
    def.base.forceThreshold = 2 * weight;
    joint = mvCreateWeldJoint(world, &def);
    run(world, 30);
    CHECK(mvWorld_GetJointEvents(world).count == 0);
    mvJoint_SetForceThreshold(joint, weight / 2);
    run(world, 2);
    events = mvWorld_GetJointEvents(world);
    CHECK(events.count == 1);
    if (events.count == 1)
    {
        CHECK(MV_ID_EQUALS(events.jointEvents[0].jointId, joint) && events.jointEvents[0].userData == &tag);
        CHECK(!events.jointEvents[0].broke && near(events.jointEvents[0].force, weight, (mvFloat)0.02 * weight));
        CHECK(near(events.jointEvents[0].torque, 0, (mvFloat)0.01 * weight));
    }
    CHECK(nearVec(mvJoint_GetConstraintTorque(joint), vec(0, 0, 0), (mvFloat)0.01 * weight));
    height = mvBody_GetPosition(b).y;
    CHECK(near(height, 8, (mvFloat)1e-3));
    mvJoint_SetBreakable(joint, true);
    run(world, 1);
    events = mvWorld_GetJointEvents(world);
    CHECK(events.count == 1 && events.jointEvents[0].broke && !mvJoint_IsValid(joint));
    run(world, 30);
    CHECK(mvWorld_GetJointEvents(world).count == 0 && mvBody_GetPosition(b).y < height - 1);
    mvDestroyBody(a);
    mvDestroyBody(b);
}

/* Bodies and joints of another world are told apart. */
static void worlds(mvWorldId world)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvWorldId other = mvCreateWorld(&worldDef);
    mvBodyId a = box(world, mv_staticBody, pos(0, 0, 0)), b = box(other, mv_dynamicBody, pos(0, 0, 0));
    mvFilterJointDef def = mvDefaultFilterJointDef();
    mvGearJointDef gear = mvDefaultGearJointDef();
    mvJointId joint;

    def.base.bodyIdA = a;
    def.base.bodyIdB = b;
    FAILS(mv_errorForeign, mvCreateFilterJoint, mvCreateFilterJoint(world, &def));
    FAILS(mv_errorNull, mvCreateGearJoint, mvCreateGearJoint(world, &gear));
    def.base.bodyIdA = box(other, mv_staticBody, pos(1, 0, 0));
    joint = mvCreateFilterJoint(other, &def);
    gear.jointIdA = gear.jointIdB = joint;
    FAILS(mv_errorForeign, mvCreateGearJoint, mvCreateGearJoint(world, &gear));
    FAILS(mv_errorRange, mvCreateGearJoint, mvCreateGearJoint(other, &gear));
    mvDestroyWorld(other);
    CHECK(!mvJoint_IsValid(joint));
    FAILS(mv_errorStale, mvJoint_GetType, mvJoint_GetType(joint));
    FAILS(mv_errorStale, mvWorld_GetJointEvents, CHECK(mvWorld_GetJointEvents(other).jointEvents == NULL));
    mvDestroyBody(a);
}

int main(void)
{
    mvWorldDef def = mvDefaultWorldDef();
    mvWorldId world = mvCreateWorld(&def);
    common(world);
    readings(world);
    breaking(world);
    worlds(world);
    mvDestroyWorld(world);
    return done("joint");
}
