/* Queries: a row of boxes on the x axis, asked in every way. */
#include "check.h"

static mvShapeId found[8];
static int count;

static bool collect(mvShapeId id, void* context)
{
    int* most = (int*)context;
    if (count < 8)
    {
        found[count] = id;
    }
    count += 1;
    return count < *most;
}

static mvFloat lastFraction;
static mvFloat answer;

static mvFloat meet(mvShapeId id, mvPos point, mvVec3 normal, mvFloat fraction, uint64_t material, int triangle,
                    int child, void* context)
{
    CHECK(context == &answer && mvShape_IsValid(id) && mvIsValidPosition(point) && mvIsNormalized(normal));
    CHECK(fraction >= lastFraction && material == 5 && triangle == -1 && child == -1);
    lastFraction = fraction;
    count += 1;
    return answer;
}

int main(void)
{
    mvWorldDef def = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvBoxHull box = mvMakeCubeHull(1);
    mvWorldId world = mvCreateWorld(&def);
    mvShapeId shapes[5];
    mvQueryFilter all = mvDefaultQueryFilter(), some = all;
    mvRayResult results[8], hit;
    mvAABB area;
    mvVec3 one = { 0, 0, 0 };
    mvShapeProxy ball;
    mvFloat tiny = (mvFloat)1e-4;
    int k, most = 100;

    ball.points = &one;
    ball.count = 1;
    ball.radius = (mvFloat)0.5;
    shapeDef.baseMaterial.userMaterialId = 5;
    for (k = 0; k < 5; ++k)
    {
        bodyDef.position.x = (mvFloat)(3 * k);
        shapeDef.filter.categoryBits = k % 2 == 0 ? 1 : 2;
        shapes[k] = mvCreateHullShape(mvCreateBody(world, &bodyDef), &shapeDef, &box.base);
    }
    some.maskBits = 2;

    hit = mvWorld_CastRayClosest(world, pos(-4, 0, 0), vec(20, 0, 0), all);
    CHECK(hit.hit && MV_ID_EQUALS(hit.shapeId, shapes[0]) && near(hit.fraction, (mvFloat)0.15, tiny));
    CHECK(near(hit.point.x, -1, tiny) && near(hit.normal.x, -1, tiny) && hit.userMaterialId == 5);
    hit = mvWorld_CastRayClosest(world, pos(-4, 0, 0), vec(20, 0, 0), some);
    CHECK(hit.hit && MV_ID_EQUALS(hit.shapeId, shapes[1]));
    CHECK(!mvWorld_CastRayClosest(world, pos(-4, 9, 0), vec(20, 0, 0), all).hit);
    hit = mvWorld_CastRayClosest(world, pos(0, 0, 0), vec(20, 0, 0), all);
    CHECK(hit.hit && MV_ID_EQUALS(hit.shapeId, shapes[1]));

    CHECK(mvWorld_CastRayAll(world, pos(20, 0, 0), vec(-40, 0, 0), all, results, 8) == 5);
    for (k = 0; k < 5; ++k)
    {
        CHECK(MV_ID_EQUALS(results[k].shapeId, shapes[4 - k]) && results[k].hit);
    }
    CHECK(mvWorld_CastRayAll(world, pos(20, 0, 0), vec(-40, 0, 0), all, results, 2) == 5);
    CHECK(mvWorld_CastRayAll(world, pos(20, 0, 0), vec(-40, 0, 0), some, NULL, 0) == 2);

    answer = 1;
    CHECK(mvWorld_CastRay(world, pos(-4, 0, 0), vec(20, 0, 0), all, meet, &answer).leafVisits == 5 && count == 5);
    answer = -1;
    count = 0;
    lastFraction = 0;
    mvWorld_CastRay(world, pos(-4, 0, 0), vec(20, 0, 0), all, meet, &answer);
    CHECK(count == 5);
    answer = 0;
    count = 0;
    lastFraction = 0;
    mvWorld_CastRay(world, pos(-4, 0, 0), vec(20, 0, 0), all, meet, &answer);
    CHECK(count == 1);
    answer = (mvFloat)0.35;
    count = 0;
    lastFraction = 0;
    mvWorld_CastRay(world, pos(-4, 0, 0), vec(20, 0, 0), all, meet, &answer);
    CHECK(count == 2);

    hit = mvWorld_CastShapeClosest(world, pos(-4, 0, 0), &ball, vec(20, 0, 0), all);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.125, (mvFloat)1e-3) && MV_ID_EQUALS(hit.shapeId, shapes[0]));
    hit = mvWorld_CastShapeClosest(world, pos(0, 0, 0), &ball, vec(20, 0, 0), all);
    CHECK(hit.hit && hit.fraction == 0 && mvLength(hit.normal) == 0);
    CHECK(mvWorld_CastShapeAll(world, pos(-4, 0, 0), &ball, vec(20, 0, 0), all, results, 8) == 5);
    CHECK(MV_ID_EQUALS(results[4].shapeId, shapes[4]));
    answer = 1;
    count = 0;
    lastFraction = 0;
    CHECK(mvWorld_CastShape(world, pos(-4, 0, 0), &ball, vec(20, 0, 0), all, meet, &answer).leafVisits == 5);

    area.lowerBound = vec(-2, -2, -2);
    area.upperBound = vec(4, 2, 2);
    count = 0;
    CHECK(mvWorld_OverlapAABB(world, area, all, collect, &most).leafVisits == 2 && count == 2);
    CHECK(MV_ID_EQUALS(found[0], shapes[0]) && MV_ID_EQUALS(found[1], shapes[1]));
    most = 1;
    count = 0;
    CHECK(mvWorld_OverlapAABB(world, area, all, collect, &most).leafVisits == 1);
    CHECK(mvWorld_OverlapAABBAll(world, area, some, found, 8) == 1 && MV_ID_EQUALS(found[0], shapes[1]));
    ball.radius = 1;
    most = 100;
    count = 0;
    mvWorld_OverlapShape(world, pos((mvFloat)1.5, 0, 0), &ball, all, collect, &most);
    CHECK(count == 2);
    CHECK(mvWorld_OverlapShapeAll(world, pos((mvFloat)1.5, 0, 0), &ball, all, found, 1) == 2);
    CHECK(mvWorld_OverlapShapeAll(world, pos((mvFloat)1.5, 5, 0), &ball, all, found, 1) == 0);
    CHECK(mvGetLastError() == mv_errorNone);

    FAILS(mv_errorNull, mvWorld_CastRay, mvWorld_CastRay(world, pos(0, 0, 0), vec(1, 0, 0), all, NULL, NULL));
    FAILS(mv_errorNotFinite, mvWorld_CastRay,
          mvWorld_CastRay(world, pos((mvFloat)NAN, 0, 0), vec(1, 0, 0), all, meet, &answer));
    FAILS(mv_errorNotFinite, mvWorld_CastRayClosest,
          CHECK(!mvWorld_CastRayClosest(world, pos(0, 0, 0), vec((mvFloat)INFINITY, 0, 0), all).hit));
    FAILS(mv_errorRange, mvWorld_CastRayAll,
          mvWorld_CastRayAll(world, pos(0, 0, 0), vec(1, 0, 0), all, results, -1));
    FAILS(mv_errorNull, mvWorld_CastShapeClosest,
          mvWorld_CastShapeClosest(world, pos(0, 0, 0), NULL, vec(1, 0, 0), all));
    FAILS(mv_errorNull, mvWorld_CastShape,
          mvWorld_CastShape(world, pos(0, 0, 0), &ball, vec(1, 0, 0), all, NULL, NULL));
    FAILS(mv_errorRange, mvWorld_CastShapeAll,
          mvWorld_CastShapeAll(world, pos((mvFloat)1e20, 0, 0), &ball, vec(1, 0, 0), all, results, 8));
    FAILS(mv_errorNull, mvWorld_OverlapAABB, mvWorld_OverlapAABB(world, area, all, NULL, NULL));
    area.lowerBound.y = 9;
    FAILS(mv_errorRange, mvWorld_OverlapAABB, mvWorld_OverlapAABB(world, area, all, collect, &most));
    area.lowerBound.y = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvWorld_OverlapAABBAll, mvWorld_OverlapAABBAll(world, area, all, found, 8));
    ball.count = 1000;
    FAILS(mv_errorRange, mvWorld_OverlapShape, mvWorld_OverlapShape(world, pos(0, 0, 0), &ball, all, collect, &most));
    ball.points = NULL;
    ball.count = 1;
    FAILS(mv_errorNull, mvWorld_OverlapShapeAll, mvWorld_OverlapShapeAll(world, pos(0, 0, 0), &ball, all, found, 8));
    mvDestroyWorld(world);
    FAILS(mv_errorStale, mvWorld_CastRayClosest, mvWorld_CastRayClosest(world, pos(0, 0, 0), vec(1, 0, 0), all));
    return done("query");
}
