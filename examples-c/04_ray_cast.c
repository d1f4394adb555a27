/* What is in the way? Rays and a moving ball against a row of posts. */
#include "merev.h"

#include <stdio.h>

/* Told of every hit, nearest first; the answer says how to go on. */
static mvFloat count(mvShapeId shape, mvPos point, mvVec3 normal, mvFloat fraction, uint64_t material, int triangle,
                     int child, void* context)
{
    (void)shape, (void)normal, (void)material, (void)triangle, (void)child;
    printf("  hit at x = %.3f, fraction %.3f\n", (double)point.x, (double)fraction);
    *(int*)context += 1;
    return 1;
}

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvCapsule post = { { 0, 0, 0 }, { 0, 2, 0 }, (mvFloat)0.25 };
    mvWorldId world = mvCreateWorld(&worldDef);
    mvQueryFilter filter = mvDefaultQueryFilter();
    mvPos origin = { -2, 1, 0 };
    mvVec3 way = { 10, 0, 0 }, center = { 0, 0, 0 };
    mvShapeProxy ball;
    mvRayResult hit, all[8];
    int k, total, told = 0, wrong = 0;

    for (k = 0; k < 4; ++k)
    {
        bodyDef.position.x = (mvFloat)(2 * k);
        shapeDef.filter.categoryBits = k < 2 ? 1 : 2;
        mvCreateCapsuleShape(mvCreateBody(world, &bodyDef), &shapeDef, &post);
    }

    printf("The nearest:\n");
    hit = mvWorld_CastRayClosest(world, origin, way, filter);
    printf("  %s at x = %.3f\n", hit.hit ? "hit" : "miss", (double)hit.point.x);
    wrong += !hit.hit || fabs((double)hit.point.x + 0.25) > 1e-3;

    printf("All, by callback:\n");
    mvWorld_CastRay(world, origin, way, filter, count, &told);
    wrong += told != 4;

    printf("All, into an array:\n");
    total = mvWorld_CastRayAll(world, origin, way, filter, all, 8);
    for (k = 0; k < total; ++k)
    {
        printf("  x = %.3f\n", (double)all[k].point.x);
    }
    wrong += total != 4;

    printf("Only the second kind:\n");
    filter.maskBits = 2;
    hit = mvWorld_CastRayClosest(world, origin, way, filter);
    printf("  %s at x = %.3f\n", hit.hit ? "hit" : "miss", (double)hit.point.x);
    wrong += !hit.hit || fabs((double)hit.point.x - 3.75) > 1e-3;

    printf("A ball of radius 0.5 instead of a ray:\n");
    ball.points = &center;
    ball.count = 1;
    ball.radius = (mvFloat)0.5;
    hit = mvWorld_CastShapeClosest(world, origin, &ball, way, mvDefaultQueryFilter());
    printf("  stops after %.3f of the way\n", (double)hit.fraction);
    wrong += !hit.hit || fabs((double)hit.fraction - 0.125) > 1e-3;

    mvDestroyWorld(world);
    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return wrong == 0 ? 0 : 1;
}
