/* Distance, overlap, casts and contact points without a world. */
#include "check.h"

static const mvFloat tiny = (mvFloat)1e-4;

int main(void)
{
    mvVec3 boxPoints[8], one[1], two[2];
    mvShapeProxy point, stick, none = { NULL, 1, 0 };
    mvDistanceInput input;
    mvDistanceOutput d;
    mvSimplexCache cache = { 0, 0, { 0 }, { 0 } };
    mvSimplex simplex, trace[65];
    mvGjkKind gjk;
    mvBoxHull box = mvMakeBoxHull(1, 1, 1);
    mvSphere ball = { { 0, 0, 0 }, 1 };
    mvCapsule pill = { { 0, -1, 0 }, { 0, 1, 0 }, (mvFloat)0.5 };
    mvShapeCastInput cast;
    mvShapeCastPairInput pair;
    mvCastOutput hit;
    mvTransform t = mvTransform_identity;
    mvLocalManifoldPoint points[4];
    mvLocalManifold manifold;
    mvSATCache sat = { 0, false };
    int i;

    memcpy(boxPoints, box.boxPoints, sizeof boxPoints);
    one[0] = vec(4, 0, 0);
    two[0] = vec(0, 0, -1);
    two[1] = vec(0, 0, 1);
    point.points = one;
    point.count = 1;
    point.radius = 1;
    stick.points = two;
    stick.count = 2;
    stick.radius = (mvFloat)0.25;

    input.proxyA.points = boxPoints;
    input.proxyA.count = 8;
    input.proxyA.radius = 0;
    input.proxyB = point;
    input.transform = mvTransform_identity;
    input.useRadii = true;
    input.gjk = mv_gjk_auto;
    d = mvShapeDistance(&input, &cache, &simplex, 1);
    CHECK(near(d.distance, 2, tiny) && nearVec(d.normal, mvVec3_axisX, tiny) && d.simplexCount == 1);
    CHECK(nearVec(d.pointB, vec(3, 0, 0), tiny) && near(d.pointA.x, 1, tiny));
    CHECK(simplex.count >= 1 && simplex.count <= 4 && cache.count == simplex.count);
    for (i = 0; i < simplex.count; ++i)
    {
        CHECK(nearVec(simplex.vertices[i].wA, boxPoints[simplex.vertices[i].indexA], tiny));
        CHECK(nearVec(simplex.vertices[i].w, mvSub(simplex.vertices[i].wB, simplex.vertices[i].wA), tiny));
    }
    for (gjk = mv_gjk_auto; gjk <= mv_gjk_johnson; ++gjk)
    {
        input.gjk = gjk;
        d = mvShapeDistance(&input, NULL, trace, 65);
        CHECK(near(d.distance, 2, tiny) && d.simplexCount >= 1 && d.simplexCount <= 65);
        CHECK(mvLength(trace[d.simplexCount - 1].vertices[0].w) >= 2);
    }
    FAILS(mv_errorRange, mvShapeDistance, mvShapeDistance((input.gjk = 99, &input), NULL, NULL, 0));
    input.gjk = mv_gjk_auto;
    input.useRadii = false;
    CHECK(near(mvShapeDistance(&input, NULL, NULL, 0).distance, 3, tiny));
    input.transform.p.x = -4;
    CHECK(mvShapeDistance(&input, &cache, NULL, 0).distance == 0);
    input.transform.q.s = 0;
    FAILS(mv_errorRange, mvShapeDistance, mvShapeDistance(&input, &cache, NULL, 0));
    FAILS(mv_errorNull, mvShapeDistance, mvShapeDistance(NULL, NULL, NULL, 0));
    input.transform.q.s = 1;
    input.proxyB = none;
    FAILS(mv_errorNull, mvShapeDistance, mvShapeDistance(&input, NULL, NULL, 0));
    input.proxyB.count = 0;
    FAILS(mv_errorRange, mvShapeDistance, mvShapeDistance(&input, NULL, NULL, 0));
    input.proxyB = point;
    input.proxyB.radius = -1;
    FAILS(mv_errorRange, mvShapeDistance, mvShapeDistance(&input, NULL, NULL, 0));
    input.proxyB = point;
    memset(&input.useRadii, 7, 1);
    FAILS(mv_errorRange, mvShapeDistance, mvShapeDistance(&input, NULL, NULL, 0));

    pair.proxyA = stick;
    pair.proxyB = point;
    pair.transform = mvTransform_identity;
    pair.translationB = vec(-4, 0, 0);
    pair.maxFraction = 1;
    pair.canEncroach = false;
    hit = mvShapeCast(&pair);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)(2.75 / 4), (mvFloat)1e-3) && near(hit.point.x, (mvFloat)0.25, (mvFloat)1e-3));
    pair.maxFraction = (mvFloat)0.5;
    CHECK(!mvShapeCast(&pair).hit);
    pair.canEncroach = true;
    FAILS(mv_errorUnsupported, mvShapeCast, mvShapeCast(&pair));
    FAILS(mv_errorNull, mvShapeCast, mvShapeCast(NULL));

    CHECK(!mvOverlapSphere(&ball, t, &point) && !mvOverlapCapsule(&pill, t, &point) && !mvOverlapHull(&box.base, t, &point));
    t.p.x = (mvFloat)2.5;
    CHECK(mvOverlapSphere(&ball, t, &point) && mvOverlapHull(&box.base, t, &point));
    t.p.x = (mvFloat)2.75;
    CHECK(mvOverlapCapsule(&pill, t, &point));
    FAILS(mv_errorNull, mvOverlapHull, mvOverlapHull(NULL, t, &point));
    FAILS(mv_errorNull, mvOverlapCapsule, mvOverlapCapsule(&pill, t, NULL));
    FAILS(mv_errorNull, mvOverlapSphere, mvOverlapSphere(NULL, t, &point));

    cast.proxy = point;
    cast.translation = vec(-8, 0, 0);
    cast.maxFraction = 1;
    cast.canEncroach = false;
    hit = mvShapeCastSphere(&ball, &cast);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.25, (mvFloat)1e-3) && nearVec(hit.normal, mvVec3_axisX, (mvFloat)1e-2));
    hit = mvShapeCastCapsule(&pill, &cast);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)(2.5 / 8), (mvFloat)1e-3));
    hit = mvShapeCastHull(&box.base, &cast);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.25, (mvFloat)1e-3) && near(hit.point.x, 1, (mvFloat)1e-3));
    cast.translation = vec(8, 0, 0);
    CHECK(!mvShapeCastHull(&box.base, &cast).hit);
    cast.translation.y = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvShapeCastHull, mvShapeCastHull(&box.base, &cast));
    FAILS(mv_errorNotFinite, mvShapeCastSphere, mvShapeCastSphere(&ball, &cast));
    FAILS(mv_errorNull, mvShapeCastCapsule, mvShapeCastCapsule(&pill, NULL));

    manifold.points = points;
    t = mvTransform_identity;
    t.p.x = (mvFloat)1.9;
    mvCollideSpheres(&manifold, 4, &ball, &ball, t);
    CHECK(manifold.pointCount == 1 && nearVec(manifold.normal, mvVec3_axisX, tiny));
    CHECK(near(points[0].separation, (mvFloat)-0.1, tiny) && near(points[0].point.x, (mvFloat)0.95, tiny));
    t.p.x = 3;
    mvCollideSpheres(&manifold, 4, &ball, &ball, t);
    CHECK(manifold.pointCount == 0);
    t.p.x = (mvFloat)1.4;
    mvCollideCapsuleAndSphere(&manifold, 4, &pill, &ball, t);
    CHECK(manifold.pointCount == 1 && near(points[0].separation, (mvFloat)-0.1, tiny));
    t.p.x = (mvFloat)0.9;
    mvCollideCapsules(&manifold, 4, &pill, &pill, t);
    CHECK(manifold.pointCount == 2 && near(points[1].separation, (mvFloat)-0.1, tiny));
    t.p.x = (mvFloat)1.9;
    mvCollideHullAndSphere(&manifold, 4, &box.base, &ball, t, &cache);
    CHECK(manifold.pointCount == 1 && near(points[0].separation, (mvFloat)-0.1, tiny));
    t.p.x = (mvFloat)1.4;
    mvCollideHullAndCapsule(&manifold, 4, &box.base, &pill, t, NULL);
    CHECK(manifold.pointCount == 2 && near(points[0].separation, (mvFloat)-0.1, tiny));
    t.p.x = (mvFloat)1.9;
    mvCollideHulls(&manifold, 4, &box.base, &box.base, t, &sat);
    CHECK(manifold.pointCount == 4 && near(points[3].separation, (mvFloat)-0.1, tiny));
    CHECK(sat.hit && near(sat.separation, (mvFloat)-0.1, tiny) && nearVec(manifold.normal, mvVec3_axisX, tiny));
    mvCollideHulls(&manifold, 2, &box.base, &box.base, t, NULL);
    CHECK(manifold.pointCount == 2);
    manifold.points = NULL;
    mvCollideHulls(&manifold, 4, &box.base, &box.base, t, NULL);
    CHECK(manifold.pointCount == 0);
    FAILS(mv_errorNull, mvCollideHulls, mvCollideHulls(NULL, 4, &box.base, &box.base, t, NULL));
    FAILS(mv_errorNull, mvCollideHulls, mvCollideHulls(&manifold, 4, NULL, &box.base, t, NULL));
    FAILS(mv_errorRange, mvCollideSpheres, mvCollideSpheres(&manifold, -1, &ball, &ball, t));
    FAILS(mv_errorNull, mvCollideCapsules, mvCollideCapsules(&manifold, 4, &pill, NULL, t));
    ball.radius = (mvFloat)INFINITY;
    FAILS(mv_errorNotFinite, mvCollideHullAndSphere, mvCollideHullAndSphere(&manifold, 4, &box.base, &ball, t, NULL));
    FAILS(mv_errorNotFinite, mvCollideCapsuleAndSphere, mvCollideCapsuleAndSphere(&manifold, 4, &pill, &ball, t));
    t.p.x = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvCollideHullAndCapsule, mvCollideHullAndCapsule(&manifold, 4, &box.base, &pill, t, NULL));
    return done("distance");
}
