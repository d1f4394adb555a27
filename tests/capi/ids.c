/* Ids: null, packing, generations, very many worlds. */
#include "check.h"

#include <stdlib.h>

int main(void)
{
    enum { many = 5000 };
    mvWorldDef def = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvSphere ball = { { 0, 0, 0 }, 1 };
    mvWorldId world = mvCreateWorld(&def), again;
    mvBodyId body, old, fresh;
    mvShapeId shape;
    mvContactId contact = { 7, 3, 0, 0xfedcba98u }, back;
    uint32_t words[3];
    mvWorldId* worlds;
    int i;

    body = mvCreateBody(world, &bodyDef);
    shape = mvCreateSphereShape(body, &shapeDef, &ball);
    CHECK(MV_IS_NON_NULL(world) && MV_IS_NON_NULL(body) && MV_IS_NON_NULL(shape));
    CHECK(MV_IS_NULL(mv_nullWorldId) && MV_IS_NULL(mv_nullBodyId) && MV_IS_NULL(mv_nullShapeId));
    CHECK(MV_IS_NULL(mv_nullContactId) && !MV_ID_EQUALS(body, mv_nullBodyId));

    again = mvLoadWorldId(mvStoreWorldId(world));
    CHECK(again.index1 == world.index1 && again.generation == world.generation);
    old = mvLoadBodyId(mvStoreBodyId(body));
    CHECK(MV_ID_EQUALS(old, body));
    CHECK(MV_ID_EQUALS(mvLoadShapeId(mvStoreShapeId(shape)), shape));
    mvStoreContactId(contact, words);
    back = mvLoadContactId(words);
    CHECK(MV_ID_EQUALS(contact, back));
    CHECK(mvStoreBodyId(mv_nullBodyId) == 0 && mvStoreShapeId(mv_nullShapeId) == 0);
    CHECK(mvStoreWorldId(mv_nullWorldId) == 0);

    /* A body's id stays stale when its place is used again. */
    mvDestroyBody(body);
    fresh = mvCreateBody(world, &bodyDef);
    CHECK(fresh.index1 == body.index1 && fresh.generation != body.generation);
    CHECK(mvBody_IsValid(fresh) && !mvBody_IsValid(body) && !mvShape_IsValid(shape));

    /* So it does when the world's place is used again by another world. */
    mvDestroyWorld(world);
    CHECK(!mvWorld_IsValid(world) && !mvBody_IsValid(fresh));
    again = mvCreateWorld(&def);
    CHECK(again.index1 == world.index1 && again.generation != world.generation);
    CHECK(!mvWorld_IsValid(world) && mvWorld_IsValid(again));
    old = mvCreateBody(again, &bodyDef);
    CHECK(old.index1 == fresh.index1 && old.world0 == fresh.world0 && old.generation != fresh.generation);
    FAILS(mv_errorStale, mvBody_GetMass, mvBody_GetMass(fresh));
    FAILS(mv_errorStale, mvWorld_Step, mvWorld_Step(world, 0, 1));
    CHECK(mvBody_GetWorld(old).index1 == again.index1 && mvBody_GetWorld(old).generation == again.generation);
    mvDestroyWorld(again);

    /* A place is used again and again, and never by two ids that are the same. */
    for (i = 0; i < 1000; ++i)
    {
        again = mvCreateWorld(&def);
        CHECK(again.generation != world.generation || again.index1 != world.index1);
        world = again;
        mvDestroyWorld(world);
    }

    worlds = (mvWorldId*)malloc(many * sizeof *worlds);
    for (i = 0; i < many; ++i)
    {
        worlds[i] = mvCreateWorld(&def);
        CHECK(mvWorld_IsValid(worlds[i]));
    }
    CHECK(mvGetWorldCount() == many);
    body = mvCreateBody(worlds[many - 1], &bodyDef);
    CHECK(mvBody_IsValid(body) && body.world0 == worlds[many - 1].index1 - 1);
    for (i = 0; i < many; ++i)
    {
        mvDestroyWorld(worlds[i]);
    }
    free(worlds);
    return done("ids");
}
