/* Threads: readers side by side, writers alone, worlds independent, errors by thread. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"

#include <pthread.h>
#include <sched.h>

static mvWorldId world;
static mvBodyId body;
static volatile int stage = 0;
static volatile int sawBusy = 0;

static bool hold(mvShapeId id, void* context)
{
    (void)id;
    (void)context;
    /* Inside a query: another thread may read and must not write. */
    stage = 1;
    while (stage == 1)
    {
        sched_yield();
    }
    return true;
}

static bool holdStep(mvShapeId a, mvShapeId b, void* context)
{
    (void)a;
    (void)b;
    (void)context;
    stage = 3;
    while (stage == 3)
    {
        sched_yield();
    }
    return true;
}

static void* other(void* unused)
{
    (void)unused;
    while (stage != 1)
    {
        sched_yield();
    }
    CHECK(mvGetLastError() == mv_errorNone && mvGetLastErrorMessage()[0] == '\0');
    WORKS(mvBody_GetPosition(body));
    WORKS(mvWorld_CastRayClosest(world, pos(0, 9, 0), vec(0, -20, 0), mvDefaultQueryFilter()));
    FAILS(mv_errorBusy, mvBody_SetAwake, mvBody_SetAwake(body, true));
    FAILS(mv_errorBusy, mvWorld_Step, mvWorld_Step(world, 0, 1));
    FAILS(mv_errorBusy, mvDestroyWorld, mvDestroyWorld(world));
    stage = 2;
    while (stage != 3)
    {
        sched_yield();
    }
    /* Inside a step: another thread may do nothing. */
    FAILS(mv_errorBusy, mvBody_GetPosition, mvBody_GetPosition(body));
    FAILS(mv_errorBusy, mvBody_SetAwake, mvBody_SetAwake(body, true));
    FAILS(mv_errorBusy, mvDestroyWorld, mvDestroyWorld(world));
    CHECK(!mvBody_IsValid(body) && mvWorld_IsValid(world));
    CHECK(mvGetLastError() == mv_errorNone);
    stage = 4;
    return NULL;
}

static void* reader(void* unused)
{
    int k;
    (void)unused;
    for (k = 0; k < 20000; ++k)
    {
        mvBody_GetTransform(body);
        mvWorld_CastRayClosest(world, pos(0, 9, 0), vec(0, -20, 0), mvDefaultQueryFilter());
        if (mvGetLastError() == mv_errorBusy)
        {
            sawBusy = 1;
        }
    }
    return NULL;
}

static void* writer(void* unused)
{
    int k;
    (void)unused;
    for (k = 0; k < 2000; ++k)
    {
        mvBody_SetAwake(body, true);
        mvWorld_Step(world, (mvFloat)0.01, 1);
        CHECK(mvGetLastError() != mv_errorInternal);
    }
    return NULL;
}

static void* ownWorld(void* unused)
{
    int k;
    (void)unused;
    for (k = 0; k < 200; ++k)
    {
        mvWorldDef def = mvDefaultWorldDef();
        mvBodyDef bodyDef = mvDefaultBodyDef();
        mvWorldId mine = mvCreateWorld(&def);
        mvBodyId b;
        bodyDef.type = mv_dynamicBody;
        b = mvCreateBody(mine, &bodyDef);
        WORKS(mvWorld_Step(mine, (mvFloat)0.01, 1));
        WORKS(mvBody_GetPosition(b));
        WORKS(mvDestroyWorld(mine));
        FAILS(mv_errorStale, mvBody_GetMass, mvBody_GetMass(b));
    }
    return NULL;
}

int main(void)
{
    mvWorldDef def = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvSphere ball = { { 0, 0, 0 }, (mvFloat)0.5 };
    mvPlane floor = { { 0, 1, 0 }, 0 };
    pthread_t threads[4];
    mvAABB box;
    int k;
    world = mvCreateWorld(&def);
    mvCreatePlaneShape(mvCreateBody(world, &bodyDef), &shapeDef, &floor);
    bodyDef.type = mv_dynamicBody;
    bodyDef.position.y = (mvFloat)0.5;
    body = mvCreateBody(world, &bodyDef);
    shapeDef.enableCustomFiltering = true;
    mvCreateSphereShape(body, &shapeDef, &ball);
    box.lowerBound = vec(-1, (mvFloat)0.4, -1);
    box.upperBound = vec(1, 1, 1);

    pthread_create(&threads[0], NULL, other, NULL);
    mvWorld_OverlapAABB(world, box, mvDefaultQueryFilter(), hold, NULL);
    mvWorld_SetCustomFilterCallback(world, holdStep, NULL);
    WORKS(mvWorld_Step(world, (mvFloat)0.01, 1));
    pthread_join(threads[0], NULL);
    CHECK(stage == 4);
    mvWorld_SetCustomFilterCallback(world, NULL, NULL);

    pthread_create(&threads[0], NULL, reader, NULL);
    pthread_create(&threads[1], NULL, reader, NULL);
    pthread_create(&threads[2], NULL, writer, NULL);
    pthread_create(&threads[3], NULL, ownWorld, NULL);
    for (k = 0; k < 4; ++k)
    {
        pthread_join(threads[k], NULL);
    }
    /* After all that, the world is as good as new. */
    WORKS(mvWorld_Step(world, (mvFloat)0.01, 4));
    CHECK(near(mvBody_GetPosition(body).y, (mvFloat)0.5, (mvFloat)0.02));
    WORKS(mvDestroyWorld(world));
    return done("threads");
}
