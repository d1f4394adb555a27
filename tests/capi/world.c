/* Worlds: definition, stepping, tuning, reports, bulk access. */
#include "check.h"

static const mvFloat tiny = (mvFloat)1e-5;

static mvBodyId ballAt(mvWorldId world, mvFloat x, mvFloat y, mvFloat z)
{
    mvBodyDef def = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvSphere ball = { { 0, 0, 0 }, (mvFloat)0.5 };
    mvBodyId body;
    def.type = mv_dynamicBody;
    def.position = pos(x, y, z);
    body = mvCreateBody(world, &def);
    mvCreateSphereShape(body, &shapeDef, &ball);
    return body;
}

static void definitions(void)
{
    mvWorldDef def = mvDefaultWorldDef(), bad;
    CHECK(nearVec(def.gravity, vec(0, -10, 0), 0) && def.workerCount == 1 && def.enableSleep);
    /* The defaults that the header names. */
    CHECK(def.restitutionThreshold == (mvFloat)0.1 && def.hitEventThreshold == 1 && def.contactSpeed == 3);
    CHECK(def.contactStiffness == (mvFloat)0.21 && def.contactDampingRatio == (mvFloat)0.5);
    CHECK(def.maximumLinearSpeed > MV_FLOAT_MAX && def.enableWarmStarting && def.enableLoadMemory && def.accuracy == 0);
    FAILS(mv_errorNull, mvCreateWorld, CHECK(MV_IS_NULL(mvCreateWorld(NULL))));
    memset(&bad, 0, sizeof bad);
    FAILS(mv_errorDefinition, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.internalValue += 1;
    FAILS(mv_errorDefinition, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.gravity.y = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.restitutionThreshold = -1;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.contactStiffness = 2;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.maximumLinearSpeed = 0;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.workerCount = 64;
    FAILS(mv_errorUnsupported, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.accuracy = (mvFloat)1.01;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad.accuracy = (mvFloat)0.01;
    bad.solver = mv_solver_lemke;
    FAILS(mv_errorUnsupported, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.solver = 77;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.solverIterations = 10001;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.frictionFacets = 2;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    memset(&bad.shuffleContacts, 2, 1);
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.broadPhase = -1;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.narrowPhase = 1 << 30;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.integrator = 500;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.gjk = 5;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    bad.manifold = 5;
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    bad = def;
    memset(&bad.enableSleep, 2, 1);
    FAILS(mv_errorRange, mvCreateWorld, mvCreateWorld(&bad));
    CHECK(mvGetWorldCount() == 0);
    CHECK(strcmp(mvGetSolverKindName(mv_solver_softStep), "soft_step") == 0);
    CHECK(strcmp(mvGetBroadPhaseKindName(mv_broadPhase_auto), "auto") == 0);
    CHECK(strcmp(mvGetNarrowPhaseKindName(mv_narrowPhase_auto), "auto") == 0);
    CHECK(strcmp(mvGetIntegratorKindName(mv_integrator_auto), "auto") == 0);
    CHECK(strcmp(mvGetNarrowPhaseKindName(mv_narrowPhase_gjkMpr), "gjk_mpr") == 0);
    CHECK(strcmp(mvGetGjkKindName(mv_gjk_cutSpace), "cut_space") == 0);
    CHECK(strcmp(mvGetManifoldKindName(mv_manifold_auto), "auto") == 0);
    CHECK(strcmp(mvGetManifoldKindName(mv_manifold_clipper2), "clipper2") == 0);
    FAILS(mv_errorRange, mvGetGjkKindName, CHECK(mvGetGjkKindName(99) == NULL));
    FAILS(mv_errorRange, mvGetSolverKindName, CHECK(mvGetSolverKindName(99) == NULL));
}

static void settings(void)
{
    mvWorldDef def = mvDefaultWorldDef();
    mvWorldId world;
    mvContactTuning tuning;
    int mark;
    def.userData = &mark;
    world = mvCreateWorld(&def);
    CHECK(mvWorld_IsValid(world) && mvWorld_GetUserData(world) == &mark);
    mvWorld_SetUserData(world, NULL);
    CHECK(mvWorld_GetUserData(world) == NULL);
    mvWorld_SetGravity(world, vec(1, 2, 3));
    CHECK(nearVec(mvWorld_GetGravity(world), vec(1, 2, 3), 0));
    FAILS(mv_errorNotFinite, mvWorld_SetGravity, mvWorld_SetGravity(world, vec((mvFloat)NAN, 0, 0)));
    CHECK(nearVec(mvWorld_GetGravity(world), vec(1, 2, 3), 0));
    mvWorld_EnableSleeping(world, false);
    CHECK(!mvWorld_IsSleepingEnabled(world));
    mvWorld_EnableWarmStarting(world, false);
    CHECK(!mvWorld_IsWarmStartingEnabled(world));
    mvWorld_SetRestitutionThreshold(world, 3);
    CHECK(mvWorld_GetRestitutionThreshold(world) == 3);
    FAILS(mv_errorRange, mvWorld_SetRestitutionThreshold, mvWorld_SetRestitutionThreshold(world, -3));
    CHECK(mvWorld_GetRestitutionThreshold(world) == 3);
    mvWorld_SetHitEventThreshold(world, 4);
    CHECK(mvWorld_GetHitEventThreshold(world) == 4);
    FAILS(mv_errorNotFinite, mvWorld_SetHitEventThreshold, mvWorld_SetHitEventThreshold(world, (mvFloat)INFINITY));
    mvWorld_SetContactTuning(world, (mvFloat)0.25, 5, 2);
    tuning = mvWorld_GetContactTuning(world);
    CHECK(tuning.stiffness == (mvFloat)0.25 && tuning.dampingRatio == 5 && tuning.contactSpeed == 2);
    FAILS(mv_errorRange, mvWorld_SetContactTuning, mvWorld_SetContactTuning(world, 0, 5, 2));
    CHECK(mvWorld_GetContactTuning(world).stiffness == (mvFloat)0.25);
    mvWorld_SetMaximumLinearSpeed(world, 50);
    CHECK(mvWorld_GetMaximumLinearSpeed(world) == 50);
    FAILS(mv_errorRange, mvWorld_SetMaximumLinearSpeed, mvWorld_SetMaximumLinearSpeed(world, (mvFloat)NAN));
    mvWorld_SetAccuracy(world, (mvFloat)0.5);
    CHECK(mvWorld_GetAccuracy(world) == (mvFloat)0.5);
    FAILS(mv_errorRange, mvWorld_SetAccuracy, mvWorld_SetAccuracy(world, 2));
    FAILS(mv_errorNotFinite, mvWorld_SetAccuracy, mvWorld_SetAccuracy(world, (mvFloat)NAN));
    CHECK(mvWorld_GetAccuracy(world) == (mvFloat)0.5);
    WORKS(mvWorld_SetAccuracy(world, 0));
    WORKS(mvWorld_SetWorkerCount(world, 1));
    CHECK(mvWorld_GetWorkerCount(world) == 1);
    FAILS(mv_errorRange, mvWorld_SetWorkerCount, mvWorld_SetWorkerCount(world, 0));
    FAILS(mv_errorUnsupported, mvWorld_SetWorkerCount, mvWorld_SetWorkerCount(world, 8));
    FAILS(mv_errorRange, mvWorld_Step, mvWorld_Step(world, (mvFloat)-0.01, 4));
    FAILS(mv_errorNotFinite, mvWorld_Step, mvWorld_Step(world, (mvFloat)NAN, 4));
    FAILS(mv_errorRange, mvWorld_Step, mvWorld_Step(world, (mvFloat)0.01, 0));
    FAILS(mv_errorRange, mvWorld_Step, mvWorld_Step(world, (mvFloat)0.01, 1 << 30));
    WORKS(mvWorld_Step(world, 0, 1));
    mvDestroyWorld(world);
    FAILS(mv_errorStale, mvDestroyWorld, mvDestroyWorld(world));
    FAILS(mv_errorNull, mvDestroyWorld, mvDestroyWorld(mv_nullWorldId));
}

static void reports(void)
{
    mvWorldDef def = mvDefaultWorldDef();
    mvWorldId world, twin;
    mvBodyId a, b, ids[3];
    mvWorldTransform transforms[3];
    mvVec3 linear[3], angular[3];
    mvStepReport report;
    mvCounters counters;
    uint64_t hash;
    int k;

    def.gravity = mvVec3_zero;
    world = mvCreateWorld(&def);
    twin = mvCreateWorld(&def);
    CHECK(nearVec(mvAABB_Extents(mvWorld_GetBounds(world)), mvVec3_zero, 0));
    a = ballAt(world, 0, 0, 0);
    b = ballAt(world, 3, 0, 0);
    hash = mvWorld_GetStateHash(world);
    mvBody_SetLinearVelocity(b, vec(0, 2, 0));
    CHECK(mvWorld_GetStateHash(world) != hash);
    ballAt(twin, 0, 0, 0);
    mvBody_SetLinearVelocity(ballAt(twin, 3, 0, 0), vec(0, 2, 0));
    for (k = 0; k < 10; ++k)
    {
        mvWorld_Step(world, (mvFloat)0.01, 4);
        mvWorld_Step(twin, (mvFloat)0.01, 4);
        CHECK(mvWorld_GetStateHash(world) == mvWorld_GetStateHash(twin));
    }
    report = mvWorld_GetStepReport(world);
    CHECK(near((mvFloat)report.kineticEnergy, 2 * mvBody_GetMass(b), (mvFloat)1e-2));
    CHECK(near((mvFloat)report.linearMomentum[1], 2 * mvBody_GetMass(b), (mvFloat)1e-2));
    CHECK(near((mvFloat)report.angularMomentum[2], 6 * mvBody_GetMass(b), (mvFloat)1e-1));
    CHECK(report.mostSubStepCount == 4 && report.error == 0 && mvBody_GetSubStepCount(b) == 4);
    FAILS(mv_errorNull, mvBody_GetSubStepCount, mvBody_GetSubStepCount(mv_nullBodyId));
    CHECK(report.subStepCount == 4 && report.stepCount == 10 && report.counters.bodyCount == 2);
    CHECK(report.potentialEnergy == 0 && report.worstPenetration == 0 && report.quarantinedCount == 0);
    CHECK(strcmp(mvGetSolverKindName(report.solver), "soft_step") == 0);
    counters = mvWorld_GetCounters(world);
    CHECK(counters.bodyCount == 2 && counters.shapeCount == 2 && counters.awakeBodyCount == 2);
    CHECK(counters.byteCount > 0 && mvWorld_GetProfile(world).step >= 0);
    CHECK(near(mvWorld_GetBounds(world).upperBound.x, (mvFloat)3.5, (mvFloat)0.2));
    CHECK(mvWorld_GetAwakeBodyCount(world) == 2);

    CHECK(mvWorld_GetAwakeBodies(world, ids, transforms, linear, angular, 3) == 2);
    k = MV_ID_EQUALS(ids[0], b) ? 0 : 1;
    CHECK(MV_ID_EQUALS(ids[k], b) && MV_ID_EQUALS(ids[1 - k], a));
    CHECK(nearVec(linear[k], vec(0, 2, 0), tiny) && nearVec(angular[k], mvVec3_zero, 0));
    CHECK(near(transforms[k].p.y, (mvFloat)0.2, tiny));
    CHECK(mvWorld_GetAwakeBodies(world, NULL, NULL, NULL, NULL, 0) == 2);
    CHECK(mvWorld_GetAwakeBodies(world, ids, NULL, NULL, NULL, 1) == 2);
    FAILS(mv_errorRange, mvWorld_GetAwakeBodies,
          CHECK(mvWorld_GetAwakeBodies(world, ids, NULL, NULL, NULL, -1) == 0));

    ids[0] = a;
    ids[1] = b;
    transforms[0] = mvWorldTransform_identity;
    transforms[1] = mvWorldTransform_identity;
    transforms[0].p = pos(10, 0, 0);
    transforms[1].p = pos(20, 0, 0);
    WORKS(mvBody_SetTransforms(ids, transforms, 2));
    CHECK(mvBody_GetPosition(a).x == 10 && mvBody_GetPosition(b).x == 20);
    /* One that is wrong, and none moves. */
    transforms[0].p = pos(1, 0, 0);
    transforms[1].p.z = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvBody_SetTransforms, mvBody_SetTransforms(ids, transforms, 2));
    transforms[1] = transforms[0];
    ids[1] = mv_nullBodyId;
    FAILS(mv_errorNull, mvBody_SetTransforms, mvBody_SetTransforms(ids, transforms, 2));
    ids[1] = ballAt(twin, 9, 9, 9);
    FAILS(mv_errorForeign, mvBody_SetTransforms, mvBody_SetTransforms(ids, transforms, 2));
    ids[1] = b;
    ids[1].generation += 1;
    FAILS(mv_errorStale, mvBody_SetTransforms, mvBody_SetTransforms(ids, transforms, 2));
    FAILS(mv_errorRange, mvBody_SetTransforms, mvBody_SetTransforms(ids, transforms, -2));
    FAILS(mv_errorNull, mvBody_SetTransforms, mvBody_SetTransforms(ids, NULL, 2));
    WORKS(mvBody_SetTransforms(NULL, NULL, 0));
    CHECK(mvBody_GetPosition(a).x == 10);

    mvDestroyWorld(world);
    mvDestroyWorld(twin);
}

/* A ball comes to rest on a static one with every solver, and the report names it. */
static void solvers(void)
{
    const mvSolverKind kinds[] = {mv_solver_softStep,  mv_solver_sequentialImpulse, mv_solver_projectedGaussSeidel,
                                  mv_solver_lemke,     mv_solver_dantzig,           mv_solver_proximalAdmm};
    const char *names[] = {"soft_step", "sequential_impulse", "projected_gauss_seidel",
                           "lemke",     "dantzig",            "proximal_admm"};
    int i, k;
    for (i = 0; i < 6; ++i)
    {
        mvWorldDef def = mvDefaultWorldDef();
        mvWorldId world;
        mvBodyId ball;
        mvStepReport report;
        CHECK(strcmp(mvGetSolverKindName(kinds[i]), names[i]) == 0);
        CHECK(def.solverIterations == 0 && def.frictionFacets == 8 && def.shuffleContacts && !def.overCorrect);
        def.solver = kinds[i];
        def.enableSleep = false;
        world = mvCreateWorld(&def);
        mvBody_SetType(ballAt(world, 0, 0, 0), mv_staticBody);
        ball = ballAt(world, 0, (mvFloat)1.05, 0);
        for (k = 0; k < 60; ++k)
        {
            WORKS(mvWorld_Step(world, (mvFloat)(1.0 / 60.0), 4));
        }
        report = mvWorld_GetStepReport(world);
        CHECK(report.solver == kinds[i]);
        CHECK(report.solveCount == (i < 3 ? 0 : 4) && report.fallbackCount == 0);
        CHECK(report.tooLargeCount == 0 && report.unsolvedCount == 0 && report.solverResidual < (mvFloat)0.05);
        CHECK(near(mvBody_GetPosition(ball).y, 1, (mvFloat)0.02) && mvBody_GetLinearVelocity(ball).y < (mvFloat)0.1);
        mvDestroyWorld(world);
    }
}

int main(void)
{
    definitions();
    settings();
    reports();
    solvers();
    return done("world");
}
