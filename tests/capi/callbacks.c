/* Callbacks of steps and queries: they are asked, they may read, they must not change. */
#include "check.h"

typedef struct Scene
{
    mvWorldId world;
    mvBodyId body;
    mvShapeId shape;
    mvSphere ball;
    int filtered, solved, friction, restitution, overlapped;
    bool allow;
} Scene;

/* Everything that reads works; everything that changes is refused with mv_errorLocked and changes nothing. */
static void readButNotWrite(Scene* s)
{
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvPos p;
    WORKS(p = mvBody_GetPosition(s->body));
    CHECK(mvIsValidPosition(p) && mvBody_IsValid(s->body) && mvShape_IsValid(s->shape) && mvWorld_IsValid(s->world));
    WORKS(mvShape_GetFriction(s->shape));
    WORKS(mvWorld_GetGravity(s->world));
    WORKS(mvWorld_GetCounters(s->world));
    WORKS(mvWorld_CastRayClosest(s->world, pos(0, 10, 0), vec(0, -20, 0), mvDefaultQueryFilter()));
    FAILS(mv_errorLocked, mvBody_SetLinearVelocity, mvBody_SetLinearVelocity(s->body, vec(0, 0, 0)));
    FAILS(mv_errorLocked, mvCreateBody, CHECK(MV_IS_NULL(mvCreateBody(s->world, &bodyDef))));
    FAILS(mv_errorLocked, mvCreateSphereShape, mvCreateSphereShape(s->body, &shapeDef, &s->ball));
    FAILS(mv_errorLocked, mvDestroyBody, mvDestroyBody(s->body));
    FAILS(mv_errorLocked, mvDestroyShape, mvDestroyShape(s->shape, true));
    FAILS(mv_errorLocked, mvWorld_Step, mvWorld_Step(s->world, 0, 1));
    FAILS(mv_errorLocked, mvDestroyWorld, mvDestroyWorld(s->world));
    FAILS(mv_errorLocked, mvWorld_SetGravity, mvWorld_SetGravity(s->world, mvVec3_zero));
    CHECK(mvBody_IsValid(s->body) && mvGetWorldCount() >= 1);
}

static bool filter(mvShapeId a, mvShapeId b, void* context)
{
    Scene* s = (Scene*)context;
    CHECK(mvShape_IsValid(a) && mvShape_IsValid(b));
    s->filtered += 1;
    readButNotWrite(s);
    return s->allow;
}

static bool preSolve(mvShapeId a, mvShapeId b, mvPos point, mvVec3 normal, void* context)
{
    Scene* s = (Scene*)context;
    CHECK(mvShape_IsValid(a) && mvShape_IsValid(b) && mvIsValidPosition(point) && mvIsNormalized(normal));
    s->solved += 1;
    readButNotWrite(s);
    return s->allow;
}

static mvFloat mixFriction(mvFloat a, uint64_t ia, mvFloat b, uint64_t ib, void* context)
{
    Scene* s = (Scene*)context;
    CHECK(ia + ib == 3);
    s->friction += 1;
    if (s->friction == 1)
    {
        readButNotWrite(s);
    }
    return a + b;
}

static mvFloat mixRestitution(mvFloat a, uint64_t ia, mvFloat b, uint64_t ib, void* context)
{
    Scene* s = (Scene*)context;
    CHECK(ia + ib == 3 && a + b >= 0);
    s->restitution += 1;
    return (mvFloat)NAN;
}

static bool overlap(mvShapeId id, void* context)
{
    Scene* s = (Scene*)context;
    CHECK(mvShape_IsValid(id));
    s->overlapped += 1;
    readButNotWrite(s);
    return true;
}

static mvFloat castResult(mvShapeId id, mvPos point, mvVec3 normal, mvFloat fraction, uint64_t material, int triangle,
                          int child, void* context)
{
    Scene* s = (Scene*)context;
    CHECK(mvShape_IsValid(id) && mvIsValidPosition(point) && mvIsNormalized(normal));
    CHECK(fraction <= 1 && material < 3 && triangle == child);
    s->overlapped += 1;
    readButNotWrite(s);
    return 1;
}

int main(void)
{
    mvWorldDef def = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvPlane floor = { { 0, 1, 0 }, 0 };
    mvAABB all;
    Scene s;
    mvBodyId ground;
    int k;
    memset(&s, 0, sizeof s);
    s.ball.radius = (mvFloat)0.5;
    s.allow = true;
    def.frictionCallback = mixFriction;
    def.frictionContext = &s;
    s.world = mvCreateWorld(&def);
    mvWorld_SetRestitutionCallback(s.world, mixRestitution, &s);
    mvWorld_SetCustomFilterCallback(s.world, filter, &s);
    mvWorld_SetPreSolveCallback(s.world, preSolve, &s);
    ground = mvCreateBody(s.world, &bodyDef);
    shapeDef.baseMaterial.userMaterialId = 1;
    mvCreatePlaneShape(ground, &shapeDef, &floor);
    bodyDef.type = mv_dynamicBody;
    bodyDef.position.y = (mvFloat)0.5;
    s.body = mvCreateBody(s.world, &bodyDef);
    shapeDef.baseMaterial.userMaterialId = 2;
    shapeDef.enableCustomFiltering = true;
    shapeDef.enablePreSolveEvents = true;
    s.shape = mvCreateSphereShape(s.body, &shapeDef, &s.ball);

    for (k = 0; k < 10; ++k)
    {
        mvWorld_Step(s.world, (mvFloat)(1.0 / 60), 4);
    }
    CHECK(s.filtered == 1 && s.solved >= 5 && s.friction >= 10 && s.restitution >= 5);
    CHECK(mvBody_GetPosition(s.body).y > (mvFloat)0.45);

    /* The pre-solve callback lets the ball through the floor. */
    s.allow = false;
    for (k = 0; k < 30; ++k)
    {
        mvWorld_Step(s.world, (mvFloat)(1.0 / 60), 4);
    }
    CHECK(mvBody_GetPosition(s.body).y < 0);

    /* Without callbacks it comes back under the plane's care. */
    mvWorld_SetPreSolveCallback(s.world, NULL, NULL);
    mvWorld_SetCustomFilterCallback(s.world, NULL, NULL);
    mvWorld_SetFrictionCallback(s.world, NULL, NULL);
    mvWorld_SetRestitutionCallback(s.world, NULL, NULL);
    k = s.friction + s.restitution + s.solved;
    mvWorld_Step(s.world, (mvFloat)(1.0 / 60), 4);
    CHECK(k == s.friction + s.restitution + s.solved);

    all.lowerBound = vec(-100, -100, -100);
    all.upperBound = vec(100, 100, 100);
    mvWorld_OverlapAABB(s.world, all, mvDefaultQueryFilter(), overlap, &s);
    CHECK(s.overlapped == 2);
    mvBody_SetTransform(s.body, pos(0, 5, 0), mvQuat_identity);
    mvWorld_CastRay(s.world, pos(0, 10, 0), vec(0, -20, 0), mvDefaultQueryFilter(), castResult, &s);
    CHECK(s.overlapped == 4);
    mvDestroyWorld(s.world);
    return done("callbacks");
}
