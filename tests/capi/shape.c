/* Shapes: every kind, every getter and setter, and what they refuse. */
#include "check.h"

static const mvFloat tiny = (mvFloat)1e-4;
static mvWorldId world;
static mvBodyId body, ground;
static mvShapeDef def;

static void kinds(void)
{
    mvSphere ball = { { 1, 0, 0 }, 2 }, badBall = { { 0, 0, 0 }, -1 };
    mvCapsule pill = { { 0, -1, 0 }, { 0, 1, 0 }, 1 }, badPill = pill;
    mvBoxHull box = mvMakeBoxHull(1, 2, 3);
    mvVec3 tetrahedron[4];
    mvHullData* hull;
    const mvHullData* seen;
    mvPlane plane = { { 0, 2, 0 }, 1 };
    mvTransform t = mvTransform_identity;
    mvShapeId s;
    tetrahedron[0] = vec(0, 0, 0);
    tetrahedron[1] = vec(1, 0, 0);
    tetrahedron[2] = vec(0, 1, 0);
    tetrahedron[3] = vec(0, 0, 1);

    s = mvCreateSphereShape(body, &def, &ball);
    CHECK(mvShape_GetType(s) == mv_sphereShape && mvShape_GetSphere(s).radius == 2 && mvShape_GetSphere(s).center.x == 1);
    FAILS(mv_errorRange, mvShape_GetCapsule, CHECK(mvShape_GetCapsule(s).radius == 0));
    FAILS(mv_errorRange, mvShape_GetHull, CHECK(mvShape_GetHull(s) == NULL));
    FAILS(mv_errorRange, mvShape_GetPlane, mvShape_GetPlane(s));
    mvShape_SetCapsule(s, &pill);
    CHECK(mvShape_GetType(s) == mv_capsuleShape && mvShape_GetCapsule(s).center2.y == 1);
    FAILS(mv_errorRange, mvShape_GetSphere, mvShape_GetSphere(s));
    mvShape_SetHull(s, &box.base);
    CHECK(mvShape_GetType(s) == mv_hullShape && near(mvShape_GetHull(s)->volume, 48, tiny));
    CHECK(mvShape_GetHull(s) == mvShape_GetHull(s));
    hull = mvCreateHull(tetrahedron, 4, 4);
    mvShape_SetHull(s, hull);
    CHECK(mvShape_GetHull(s)->vertexCount == 4);
    mvShape_SetSphere(s, &ball);
    FAILS(mv_errorNull, mvShape_SetSphere, mvShape_SetSphere(s, NULL));
    FAILS(mv_errorRange, mvShape_SetSphere, mvShape_SetSphere(s, &badBall));
    FAILS(mv_errorNull, mvShape_SetHull, mvShape_SetHull(s, NULL));
    FAILS(mv_errorNull, mvShape_SetCapsule, mvShape_SetCapsule(s, NULL));
    CHECK(mvShape_GetType(s) == mv_sphereShape);
    mvDestroyShape(s, true);
    FAILS(mv_errorStale, mvShape_GetType, mvShape_GetType(s));

    s = mvCreateHullShape(body, &def, hull);
    mvDestroyHull(hull);
    seen = mvShape_GetHull(s);
    CHECK(seen->vertexCount == 4 && near(seen->volume, (mvFloat)(1.0 / 6), tiny));
    t.p.x = 5;
    mvDestroyShape(s, true);
    s = mvCreateTransformedHullShape(body, &def, &box.base, t, vec(2, 1, -1));
    CHECK(near(mvShape_GetHull(s)->volume, 96, tiny) && near(mvShape_GetHull(s)->center.x, 5, tiny));
    mvDestroyShape(s, true);
    s = mvCreateBoxShape(body, &def, 1, 2, 3);
    CHECK(mvShape_GetType(s) == mv_hullShape && near(mvShape_GetHull(s)->volume, 48, tiny));
    mvDestroyShape(s, true);
    s = mvCreateCapsuleShape(body, &def, &pill);
    CHECK(near(mvShape_ComputeMassData(s).mass, mvBody_GetMass(body), tiny));
    mvDestroyShape(s, false);
    CHECK(mvBody_GetMass(body) > 0);
    mvBody_ApplyMassFromShapes(body);
    CHECK(mvBody_GetMass(body) == 0);
    s = mvCreatePlaneShape(ground, &def, &plane);
    CHECK(mvShape_GetType(s) == mv_planeShape && nearVec(mvShape_GetPlane(s).normal, mvVec3_axisY, tiny));
    CHECK(near(mvShape_GetPlane(s).offset, 1, tiny));
    mvDestroyShape(s, true);

    FAILS(mv_errorRange, mvCreatePlaneShape, CHECK(MV_IS_NULL(mvCreatePlaneShape(body, &def, &plane))));
    plane.normal.y = 0;
    FAILS(mv_errorDegenerate, mvCreatePlaneShape, mvCreatePlaneShape(ground, &def, &plane));
    FAILS(mv_errorNull, mvCreatePlaneShape, mvCreatePlaneShape(ground, &def, NULL));
    FAILS(mv_errorNull, mvCreateSphereShape, mvCreateSphereShape(body, &def, NULL));
    FAILS(mv_errorNull, mvCreateSphereShape, mvCreateSphereShape(body, NULL, &ball));
    FAILS(mv_errorNull, mvCreateSphereShape, mvCreateSphereShape(mv_nullBodyId, &def, &ball));
    FAILS(mv_errorRange, mvCreateSphereShape, mvCreateSphereShape(body, &def, &badBall));
    badPill.center2 = badPill.center1;
    FAILS(mv_errorDegenerate, mvCreateCapsuleShape, mvCreateCapsuleShape(body, &def, &badPill));
    FAILS(mv_errorNull, mvCreateHullShape, mvCreateHullShape(body, &def, NULL));
    box.base.volume += 1;
    FAILS(mv_errorDefinition, mvCreateHullShape, mvCreateHullShape(body, &def, &box.base));
    FAILS(mv_errorDefinition, mvCreateTransformedHullShape,
          mvCreateTransformedHullShape(body, &def, &box.base, t, mvVec3_one));
    FAILS(mv_errorNotFinite, mvCreateBoxShape, mvCreateBoxShape(body, &def, 1, (mvFloat)NAN, 1));
    CHECK(mvBody_GetShapeCount(body) == 0 && mvBody_GetShapeCount(ground) == 0);
}

static void definitions(void)
{
    mvSphere ball = { { 0, 0, 0 }, 1 };
    mvShapeDef bad = def;
    mvShapeId s;
    bad.internalValue ^= 1;
    FAILS(mv_errorDefinition, mvCreateSphereShape, mvCreateSphereShape(body, &bad, &ball));
    bad = def;
    bad.density = -1;
    FAILS(mv_errorRange, mvCreateSphereShape, mvCreateSphereShape(body, &bad, &ball));
    bad = def;
    bad.baseMaterial.restitution = 2;
    FAILS(mv_errorRange, mvCreateSphereShape, mvCreateSphereShape(body, &bad, &ball));
    bad = def;
    bad.baseMaterial.tangentVelocity.x = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvCreateSphereShape, mvCreateSphereShape(body, &bad, &ball));
    bad = def;
    memset(&bad.enableHitEvents, 255, 1);
    FAILS(mv_errorRange, mvCreateSphereShape, mvCreateSphereShape(body, &bad, &ball));
    bad = def;
    bad.name = "\xf0\x28\x8c\x28";
    FAILS(mv_errorRange, mvCreateSphereShape, mvCreateSphereShape(body, &bad, &ball));
    bad = def;
    bad.updateBodyMass = false;
    bad.name = "ball";
    bad.userData = &world;
    s = mvCreateSphereShape(body, &bad, &ball);
    CHECK(mvBody_GetMass(body) == 0 && strcmp(mvShape_GetName(s), "ball") == 0 && mvShape_GetUserData(s) == &world);
    mvDestroyShape(s, true);
}

static void settings(void)
{
    mvSphere ball = { { 0, 0, 0 }, 1 };
    mvShapeId s = mvCreateSphereShape(body, &def, &ball);
    mvSurfaceMaterial m = mvDefaultSurfaceMaterial();
    mvFilter filter = mvDefaultFilter();
    mvWorldCastOutput hit;
    mvFloat mass = mvBody_GetMass(body);
    CHECK(MV_ID_EQUALS(mvShape_GetBody(s), body) && mvShape_GetWorld(s).index1 == world.index1);
    mvShape_SetName(s, "s");
    CHECK(strcmp(mvShape_GetName(s), "s") == 0);
    FAILS(mv_errorRange, mvShape_SetName, mvShape_SetName(s, "\x80"));
    mvShape_SetUserData(s, &mass);
    CHECK(mvShape_GetUserData(s) == &mass);
    mvShape_SetDensity(s, 2000, false);
    CHECK(mvShape_GetDensity(s) == 2000 && mvBody_GetMass(body) == mass);
    mvShape_SetDensity(s, 2000, true);
    CHECK(near(mvBody_GetMass(body) / mass, 2, tiny));
    FAILS(mv_errorRange, mvShape_SetDensity, mvShape_SetDensity(s, -1, true));
    mvShape_SetFriction(s, (mvFloat)0.25);
    CHECK(mvShape_GetFriction(s) == (mvFloat)0.25 && mvShape_GetStaticFriction(s) < 0);
    mvShape_SetStaticFriction(s, (mvFloat)0.75);
    mvShape_SetRestitution(s, (mvFloat)0.5);
    CHECK(mvShape_GetStaticFriction(s) == (mvFloat)0.75 && mvShape_GetRestitution(s) == (mvFloat)0.5);
    FAILS(mv_errorRange, mvShape_SetFriction, mvShape_SetFriction(s, -1));
    FAILS(mv_errorRange, mvShape_SetRestitution, mvShape_SetRestitution(s, (mvFloat)1.5));
    FAILS(mv_errorNotFinite, mvShape_SetStaticFriction, mvShape_SetStaticFriction(s, (mvFloat)NAN));
    CHECK(mvShape_GetFriction(s) == (mvFloat)0.25 && mvShape_GetRestitution(s) == (mvFloat)0.5);
    m.userMaterialId = 0xdeadbeefcafe;
    m.customColor = 0xff8000;
    mvShape_SetSurfaceMaterial(s, m);
    CHECK(mvShape_GetSurfaceMaterial(s).userMaterialId == 0xdeadbeefcafe && mvShape_GetSurfaceMaterial(s).customColor == 0xff8000);
    m.friction = (mvFloat)INFINITY;
    FAILS(mv_errorNotFinite, mvShape_SetSurfaceMaterial, mvShape_SetSurfaceMaterial(s, m));
    filter.groupIndex = -3;
    filter.maskBits = 5;
    mvShape_SetFilter(s, filter, true);
    CHECK(mvShape_GetFilter(s).groupIndex == -3 && mvShape_GetFilter(s).maskBits == 5);
    CHECK(mvShape_GetFilter(s).categoryBits == MV_DEFAULT_CATEGORY_BITS);
    mvShape_SetFilter(s, mvDefaultFilter(), false);
    mvShape_EnableContactEvents(s, false);
    mvShape_EnablePreSolveEvents(s, true);
    mvShape_EnableHitEvents(s, true);
    CHECK(!mvShape_AreContactEventsEnabled(s) && mvShape_ArePreSolveEventsEnabled(s) && mvShape_AreHitEventsEnabled(s));
    hit = mvShape_RayCast(s, pos(-5, 0, 0), vec(10, 0, 0));
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.4, tiny) && near(hit.point.x, -1, tiny));
    CHECK(!mvShape_RayCast(s, pos(0, 0, 0), vec(10, 0, 0)).hit);
    FAILS(mv_errorNotFinite, mvShape_RayCast, mvShape_RayCast(s, pos((mvFloat)NAN, 0, 0), vec(1, 0, 0)));
    CHECK(nearVec(mvShape_GetAABB(s).upperBound, mvVec3_one, tiny));
    CHECK(nearVec(mvShape_GetClosestPoint(s, vec(0, 7, 0)), mvVec3_axisY, tiny));
    FAILS(mv_errorNotFinite, mvShape_GetClosestPoint, mvShape_GetClosestPoint(s, vec(0, (mvFloat)INFINITY, 0)));
    CHECK(mvShape_GetContactCapacity(s) == 0 && mvShape_GetContactData(s, NULL, 0) == 0);
    FAILS(mv_errorRange, mvShape_GetContactData, mvShape_GetContactData(s, NULL, -1));
    mvDestroyBody(body);
    CHECK(!mvShape_IsValid(s));
    FAILS(mv_errorStale, mvDestroyShape, mvDestroyShape(s, true));
}

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    def = mvDefaultShapeDef();
    CHECK(def.density == 1000 && def.baseMaterial.friction == (mvFloat)0.6 && def.filter.maskBits == MV_DEFAULT_MASK_BITS);
    CHECK(def.enableContactEvents && !def.enableHitEvents && !def.enablePreSolveEvents && def.updateBodyMass);
    CHECK(def.baseMaterial.staticFriction < 0 && def.baseMaterial.restitution == 0);
    world = mvCreateWorld(&worldDef);
    ground = mvCreateBody(world, &bodyDef);
    bodyDef.type = mv_dynamicBody;
    body = mvCreateBody(world, &bodyDef);
    kinds();
    definitions();
    settings();
    WORKS(mvWorld_RebuildStaticTree(world));
    mvDestroyWorld(world);
    return done("shape");
}
