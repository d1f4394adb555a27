/* Bodies: every getter and setter, and what they refuse. */
#include "check.h"

static const mvFloat tiny = (mvFloat)1e-4;
static mvWorldId world;

static void definitions(void)
{
    mvBodyDef def = mvDefaultBodyDef(), bad = def;
    mvBodyId body;
    CHECK(def.type == mv_staticBody && def.gravityScale == 1 && def.enableSleep && def.isAwake && def.isEnabled);
    CHECK(def.sleepThreshold == (mvFloat)0.05 && def.linearDamping == 0 && def.angularDamping == 0);
    FAILS(mv_errorNull, mvCreateBody, CHECK(MV_IS_NULL(mvCreateBody(world, NULL))));
    FAILS(mv_errorNull, mvCreateBody, mvCreateBody(mv_nullWorldId, &def));
    bad.internalValue = 0;
    FAILS(mv_errorDefinition, mvCreateBody, mvCreateBody(world, &bad));
    bad = def;
    bad.type = 3;
    FAILS(mv_errorRange, mvCreateBody, mvCreateBody(world, &bad));
    bad = def;
    bad.position.x = (mvFloat)INFINITY;
    FAILS(mv_errorNotFinite, mvCreateBody, mvCreateBody(world, &bad));
    bad.position.x = (mvFloat)1e12;
    FAILS(mv_errorRange, mvCreateBody, mvCreateBody(world, &bad));
    bad = def;
    bad.rotation.s = 0;
    FAILS(mv_errorRange, mvCreateBody, mvCreateBody(world, &bad));
    bad = def;
    bad.linearDamping = -1;
    FAILS(mv_errorRange, mvCreateBody, mvCreateBody(world, &bad));
    bad = def;
    bad.angularVelocity.z = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvCreateBody, mvCreateBody(world, &bad));
    bad = def;
    bad.name = "\xff\xfe";
    FAILS(mv_errorRange, mvCreateBody, mvCreateBody(world, &bad));
    bad = def;
    memset(&bad.motionLocks.angularY, 9, 1);
    FAILS(mv_errorRange, mvCreateBody, mvCreateBody(world, &bad));
    bad = def;
    memset(&bad.isAwake, 0x80, 1);
    FAILS(mv_errorRange, mvCreateBody, mvCreateBody(world, &bad));
    CHECK(mvWorld_GetCounters(world).bodyCount == 0);

    def.name = "B\xc3\xa9la";
    def.isEnabled = false;
    def.userData = &failures;
    body = mvCreateBody(world, &def);
    CHECK(mvBody_IsValid(body) && strcmp(mvBody_GetName(body), "B\xc3\xa9la") == 0);
    CHECK(mvBody_GetUserData(body) == &failures && !mvBody_IsEnabled(body));
    mvBody_SetUserData(body, NULL);
    CHECK(mvBody_GetUserData(body) == NULL);
    mvBody_SetName(body, "b");
    CHECK(strcmp(mvBody_GetName(body), "b") == 0);
    FAILS(mv_errorRange, mvBody_SetName, mvBody_SetName(body, "\xc3"));
    CHECK(strcmp(mvBody_GetName(body), "b") == 0);
    mvBody_SetName(body, NULL);
    CHECK(strcmp(mvBody_GetName(body), "") == 0);
    mvBody_Enable(body);
    CHECK(mvBody_IsEnabled(body));
    mvBody_Disable(body);
    CHECK(!mvBody_IsEnabled(body));
    mvDestroyBody(body);
    FAILS(mv_errorStale, mvBody_GetName, CHECK(mvBody_GetName(body) == NULL));
    FAILS(mv_errorStale, mvDestroyBody, mvDestroyBody(body));
}

static void motion(mvBodyId body)
{
    mvWorldTransform t;
    mvVec3 v, w, l;
    mvQuat quarter = mvMakeQuatFromAxisAngle(mvVec3_axisZ, MV_PI / 2), none = { { 0, 0, 0 }, 0 };
    mvBody_SetTransform(body, pos(1, 2, 3), quarter);
    t = mvBody_GetTransform(body);
    CHECK(nearVec(mvToVec3(t.p), vec(1, 2, 3), tiny) && near(mvDotQuat(mvBody_GetRotation(body), quarter), 1, tiny));
    CHECK(nearVec(mvToVec3(mvBody_GetPosition(body)), mvToVec3(t.p), 0));
    FAILS(mv_errorRange, mvBody_SetTransform, mvBody_SetTransform(body, pos(1, 2, 3), none));
    FAILS(mv_errorNotFinite, mvBody_SetTransform, mvBody_SetTransform(body, pos((mvFloat)NAN, 2, 3), quarter));
    CHECK(nearVec(mvToVec3(mvBody_GetWorldPoint(body, mvVec3_axisX)), vec(1, 3, 3), tiny));
    CHECK(nearVec(mvBody_GetLocalPoint(body, pos(1, 3, 3)), mvVec3_axisX, tiny));
    CHECK(nearVec(mvBody_GetWorldVector(body, mvVec3_axisX), mvVec3_axisY, tiny));
    CHECK(nearVec(mvBody_GetLocalVector(body, mvVec3_axisY), mvVec3_axisX, tiny));
    FAILS(mv_errorNotFinite, mvBody_GetLocalVector, mvBody_GetLocalVector(body, vec(0, (mvFloat)NAN, 0)));
    FAILS(mv_errorRange, mvBody_GetWorldPoint, mvBody_GetWorldPoint(body, vec(0, (mvFloat)1e30, 0)));

    mvBody_SetLinearVelocity(body, vec(3, 0, 0));
    mvBody_SetAngularVelocity(body, vec(0, 0, 2));
    CHECK(nearVec(mvBody_GetLinearVelocity(body), vec(3, 0, 0), tiny));
    CHECK(nearVec(mvBody_GetAngularVelocity(body), vec(0, 0, 2), tiny));
    v = mvBody_GetWorldPointVelocity(body, mvOffsetPos(mvBody_GetWorldCenter(body), mvVec3_axisX));
    CHECK(nearVec(v, vec(3, 2, 0), tiny));
    v = mvBody_GetLocalPointVelocity(body, mvBody_GetLocalCenter(body));
    CHECK(nearVec(v, vec(3, 0, 0), tiny));
    CHECK(nearVec(mvBody_GetMomentum(body), mvMulSV(mvBody_GetMass(body), vec(3, 0, 0)), (mvFloat)0.1));
    l = mvBody_GetAngularMomentum(body);
    w = mvMulMV(mvBody_GetWorldInverseRotationalInertia(body), l);
    CHECK(nearVec(w, vec(0, 0, 2), tiny));
    CHECK(mvBody_GetKineticEnergy(body) > (mvFloat)4.4 * mvBody_GetMass(body));
    mvBody_SetMomentum(body, mvVec3_zero);
    mvBody_SetAngularMomentum(body, mvVec3_zero);
    CHECK(mvBody_GetKineticEnergy(body) == 0);
    FAILS(mv_errorNotFinite, mvBody_SetMomentum, mvBody_SetMomentum(body, vec(0, 0, (mvFloat)NAN)));
    FAILS(mv_errorNotFinite, mvBody_SetAngularMomentum, mvBody_SetAngularMomentum(body, vec(0, 0, (mvFloat)NAN)));
    FAILS(mv_errorRange, mvBody_SetLinearVelocity, mvBody_SetLinearVelocity(body, vec((mvFloat)1e20, 0, 0)));
    FAILS(mv_errorNotFinite, mvBody_SetAngularVelocity, mvBody_SetAngularVelocity(body, vec((mvFloat)INFINITY, 0, 0)));

    mvBody_ApplyLinearImpulseToCenter(body, vec(0, mvBody_GetMass(body), 0), true);
    CHECK(nearVec(mvBody_GetLinearVelocity(body), mvVec3_axisY, tiny));
    mvBody_ApplyLinearImpulse(body, vec(0, -mvBody_GetMass(body), 0), mvBody_GetWorldCenter(body), true);
    CHECK(nearVec(mvBody_GetLinearVelocity(body), mvVec3_zero, tiny));
    mvBody_ApplyAngularImpulse(body, mvMulSV(mvBody_GetMass(body), mvVec3_axisZ), true);
    CHECK(mvBody_GetAngularVelocity(body).z > 0);
    mvBody_SetAngularVelocity(body, mvVec3_zero);
    mvBody_ApplyForceToCenter(body, vec(mvBody_GetMass(body), 0, 0), true);
    mvBody_ApplyForce(body, vec(mvBody_GetMass(body), 0, 0), mvBody_GetWorldCenter(body), true);
    mvBody_ApplyTorque(body, vec(0, mvBody_GetMass(body), 0), true);
    mvWorld_Step(world, (mvFloat)0.5, 4);
    CHECK(nearVec(mvBody_GetLinearVelocity(body), vec(1, 0, 0), tiny) && mvBody_GetAngularVelocity(body).y > 0);
    FAILS(mv_errorNotFinite, mvBody_ApplyForce, mvBody_ApplyForce(body, vec((mvFloat)NAN, 0, 0), t.p, true));
    FAILS(mv_errorNotFinite, mvBody_ApplyForce, mvBody_ApplyForce(body, v, pos((mvFloat)NAN, 0, 0), true));
    FAILS(mv_errorNotFinite, mvBody_ApplyTorque, mvBody_ApplyTorque(body, vec((mvFloat)NAN, 0, 0), true));
    FAILS(mv_errorNotFinite, mvBody_ApplyForceToCenter, mvBody_ApplyForceToCenter(body, vec((mvFloat)NAN, 0, 0), true));
    FAILS(mv_errorNotFinite, mvBody_ApplyLinearImpulse,
          mvBody_ApplyLinearImpulse(body, vec((mvFloat)NAN, 0, 0), t.p, false));
    FAILS(mv_errorNotFinite, mvBody_ApplyLinearImpulseToCenter,
          mvBody_ApplyLinearImpulseToCenter(body, vec((mvFloat)NAN, 0, 0), false));
    FAILS(mv_errorNotFinite, mvBody_ApplyAngularImpulse,
          mvBody_ApplyAngularImpulse(body, vec((mvFloat)NAN, 0, 0), false));

    t.p = pos(5, 0, 0);
    t.q = mvQuat_identity;
    mvBody_SetTargetTransform(body, t, 1, true);
    mvBody_SetLinearVelocity(body, mvSubPos(t.p, mvBody_GetPosition(body)));
    FAILS(mv_errorRange, mvBody_SetTargetTransform, mvBody_SetTargetTransform(body, t, 0, true));
    t.q.s = 3;
    FAILS(mv_errorRange, mvBody_SetTargetTransform, mvBody_SetTargetTransform(body, t, 1, true));
}

static void settings(mvBodyId body)
{
    mvMotionLocks locks = { false, true, false, false, false, true };
    mvMassData mass = mvBody_GetMassData(body), own = { 2, { 0, 1, 0 }, { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
    CHECK(mvBody_GetType(body) == mv_dynamicBody && mvBody_GetWorld(body).index1 == world.index1);
    CHECK(near(mass.mass * mvBody_GetInverseMass(body), 1, tiny));
    CHECK(nearVec(mvBody_GetLocalRotationalInertia(body).cx, mass.inertia.cx, tiny));
    WORKS(mvBody_SetMassData(body, own));
    CHECK(mvBody_GetMass(body) == 2 && nearVec(mvBody_GetLocalCenter(body), mvVec3_axisY, 0));
    own.mass = -1;
    FAILS(mv_errorRange, mvBody_SetMassData, mvBody_SetMassData(body, own));
    own.mass = 2;
    own.inertia.cx.x = 100;
    FAILS(mv_errorRange, mvBody_SetMassData, mvBody_SetMassData(body, own));
    own.inertia.cx.x = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvBody_SetMassData, mvBody_SetMassData(body, own));
    CHECK(mvBody_GetMass(body) == 2);
    mvBody_ApplyMassFromShapes(body);
    CHECK(mvBody_GetMass(body) == mass.mass);

    mvBody_SetLinearDamping(body, 1);
    mvBody_SetAngularDamping(body, 2);
    mvBody_SetGravityScale(body, -3);
    mvBody_SetSleepThreshold(body, 4);
    CHECK(mvBody_GetLinearDamping(body) == 1 && mvBody_GetAngularDamping(body) == 2);
    CHECK(mvBody_GetGravityScale(body) == -3 && mvBody_GetSleepThreshold(body) == 4);
    FAILS(mv_errorRange, mvBody_SetLinearDamping, mvBody_SetLinearDamping(body, -1));
    FAILS(mv_errorNotFinite, mvBody_SetAngularDamping, mvBody_SetAngularDamping(body, (mvFloat)NAN));
    FAILS(mv_errorNotFinite, mvBody_SetGravityScale, mvBody_SetGravityScale(body, (mvFloat)INFINITY));
    FAILS(mv_errorRange, mvBody_SetSleepThreshold, mvBody_SetSleepThreshold(body, -1));
    CHECK(mvBody_GetLinearDamping(body) == 1 && mvBody_GetSleepThreshold(body) == 4);

    mvBody_EnableSleep(body, false);
    CHECK(!mvBody_IsSleepEnabled(body) && mvBody_IsAwake(body));
    mvBody_EnableSleep(body, true);
    mvBody_SetAwake(body, false);
    CHECK(!mvBody_IsAwake(body));
    mvBody_SetAwake(body, true);
    CHECK(mvBody_IsAwake(body));
    mvBody_SetMotionLocks(body, locks);
    CHECK(mvBody_GetMotionLocks(body).linearY && mvBody_GetMotionLocks(body).angularZ);
    CHECK(!mvBody_GetMotionLocks(body).linearX);
    memset(&locks.linearX, 3, 1);
    FAILS(mv_errorRange, mvBody_SetMotionLocks, mvBody_SetMotionLocks(body, locks));
    mvBody_SetType(body, mv_kinematicBody);
    CHECK(mvBody_GetType(body) == mv_kinematicBody && mvBody_GetMass(body) == 0);
    FAILS(mv_errorRange, mvBody_SetType, mvBody_SetType(body, -1));
    FAILS(mv_errorRange, mvBody_SetMassData, mvBody_SetMassData(body, mass));
    mvBody_SetType(body, mv_dynamicBody);
    CHECK(mvBody_GetMass(body) == mass.mass);
}

static void shapesAndQueries(mvBodyId body)
{
    mvShapeId shapes[4];
    mvVec3 closest, one = { 0, 5, 0 };
    mvShapeProxy probe;
    mvQueryFilter all = mvDefaultQueryFilter(), none = all;
    mvWorldTransform at = mvWorldTransform_identity;
    mvBodyCastResult hit;
    probe.points = &one;
    probe.count = 1;
    probe.radius = 1;
    none.maskBits = 0;
    mvBody_SetTransform(body, pos(0, 0, 0), mvQuat_identity);
    CHECK(mvBody_GetShapeCount(body) == 2 && mvBody_GetShapes(body, shapes, 4) == 2);
    CHECK(mvShape_IsValid(shapes[0]) && mvBody_GetShapes(body, shapes, 1) == 1 && mvBody_GetShapes(body, NULL, 9) == 0);
    FAILS(mv_errorRange, mvBody_GetShapes, mvBody_GetShapes(body, shapes, -1));
    CHECK(nearVec(mvBody_ComputeAABB(body).lowerBound, vec(-1, -1, -1), tiny));
    CHECK(near(mvBody_GetClosestPoint(body, &closest, vec(0, -4, 0)), 3, tiny) && nearVec(closest, vec(0, -1, 0), tiny));
    CHECK(near(mvBody_GetClosestPoint(body, NULL, vec(0, 0, 0)), 0, tiny));
    FAILS(mv_errorNotFinite, mvBody_GetClosestPoint, mvBody_GetClosestPoint(body, &closest, vec((mvFloat)NAN, 0, 0)));

    hit = mvBody_CastRay(body, pos(0, 9, 0), vec(0, -10, 0), all, 1, at);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.6, tiny) && nearVec(hit.normal, mvVec3_axisY, tiny));
    at.p.y = 4;
    hit = mvBody_CastRay(body, pos(0, 9, 0), vec(0, -10, 0), all, 1, at);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.2, tiny) && MV_IS_NON_NULL(hit.shapeId));
    CHECK(!mvBody_CastRay(body, pos(0, 9, 0), vec(0, -10, 0), none, 1, at).hit);
    CHECK(!mvBody_CastRay(body, pos(0, 9, 0), vec(0, -10, 0), all, (mvFloat)0.1, at).hit);
    FAILS(mv_errorRange, mvBody_CastRay, mvBody_CastRay(body, pos(0, 9, 0), mvVec3_axisX, all, -1, at));
    at.p.y = 0;
    hit = mvBody_CastShape(body, pos(0, 4, 0), &probe, vec(0, -10, 0), all, 1, false, at);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.5, (mvFloat)1e-3));
    CHECK(!mvBody_CastShape(body, pos(0, 4, 0), &probe, vec(0, 10, 0), all, 1, false, at).hit);
    FAILS(mv_errorUnsupported, mvBody_CastShape,
          mvBody_CastShape(body, pos(0, 4, 0), &probe, vec(0, -10, 0), all, 1, true, at));
    FAILS(mv_errorNull, mvBody_CastShape, mvBody_CastShape(body, pos(0, 4, 0), NULL, vec(0, -10, 0), all, 1, false, at));
    CHECK(!mvBody_OverlapShape(body, pos(0, 0, 0), &probe, all, at));
    CHECK(mvBody_OverlapShape(body, pos(0, (mvFloat)-1.5, 0), &probe, all, at));
    CHECK(!mvBody_OverlapShape(body, pos(0, (mvFloat)-1.5, 0), &probe, none, at));
    FAILS(mv_errorNull, mvBody_OverlapShape, mvBody_OverlapShape(body, pos(0, 0, 0), NULL, all, at));
    mvBody_EnableHitEvents(body, true);
    CHECK(mvShape_AreHitEventsEnabled(shapes[0]));
    CHECK(mvBody_GetContactCapacity(body) == 0 && mvBody_GetContactData(body, NULL, 0) == 0);
}

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef def = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvSphere ball = { { 0, 2, 0 }, 1 };
    mvBoxHull box = mvMakeCubeHull(1);
    mvBodyId body;
    worldDef.gravity = mvVec3_zero;
    world = mvCreateWorld(&worldDef);
    definitions();
    def.type = mv_dynamicBody;
    body = mvCreateBody(world, &def);
    CHECK(mvBody_GetMass(body) == 0);
    CHECK(nearVec(mvBody_ComputeAABB(body).lowerBound, mvVec3_zero, 0));
    mvCreateHullShape(body, &shapeDef, &box.base);
    mvCreateSphereShape(body, &shapeDef, &ball);
    CHECK(mvBody_GetMass(body) > 8000);
    motion(body);
    settings(body);
    shapesAndQueries(body);
    mvDestroyWorld(world);
    FAILS(mv_errorStale, mvBody_GetPosition, mvBody_GetPosition(body));
    FAILS(mv_errorNull, mvBody_GetRotation, CHECK(mvBody_GetRotation(mv_nullBodyId).s == 1));
    return done("body");
}
