/* Hulls: building, copying, validating; mass, boxes and rays of shapes without a world. */
#include "check.h"

#include <stdlib.h>

static const mvFloat tiny = (mvFloat)1e-4;

/* Euler's formula, twins, loops, planes, hash. */
static void sane(const mvHullData* hull)
{
    const mvHullVertex* vertices = mvGetHullVertices(hull);
    const mvVec3* points = mvGetHullPoints(hull);
    const mvHullHalfEdge* edges = mvGetHullEdges(hull);
    const mvHullFace* faces = mvGetHullFaces(hull);
    const mvPlane* planes = mvGetHullPlanes(hull);
    int i, k, visited = 0;
    CHECK(hull->vertexCount - hull->edgeCount / 2 + hull->faceCount == 2);
    for (i = 0; i < hull->edgeCount; ++i)
    {
        CHECK(edges[edges[i].twin].twin == i && edges[i].twin != i);
        CHECK(edges[edges[i].next].face == edges[i].face);
        CHECK(edges[edges[i].twin].origin == edges[edges[i].next].origin);
    }
    for (i = 0; i < hull->vertexCount; ++i)
    {
        CHECK(edges[vertices[i].edge].origin == i);
        for (k = 0; k < hull->faceCount; ++k)
        {
            CHECK(mvPlaneSeparation(planes[k], points[i]) < tiny);
        }
    }
    for (i = 0; i < hull->faceCount; ++i)
    {
        int e = faces[i].edge;
        do
        {
            CHECK(near(mvPlaneSeparation(planes[i], points[edges[e].origin]), 0, tiny));
            visited += 1;
            e = edges[e].next;
        } while (e != faces[i].edge && visited <= hull->edgeCount);
        CHECK(mvIsValidPlane(planes[i]) && mvPlaneSeparation(planes[i], hull->center) < 0);
    }
    CHECK(visited == hull->edgeCount);
}

static void boxes(void)
{
    mvBoxHull cube = mvMakeCubeHull(1), box = mvMakeBoxHull(1, 2, 3), copy, bad;
    mvTransform t;
    mvMassData mass = mvComputeHullMass(&box.base, 2);
    mvHullData* clone;
    sane(&cube.base);
    sane(&box.base);
    CHECK(near(box.base.volume, 48, tiny) && near(box.base.surfaceArea, 88, tiny));
    CHECK(near(box.base.innerRadius, 1, tiny) && near(box.base.outerRadius, MV_SQRT((mvFloat)14), tiny));
    CHECK(near(mass.mass, 96, tiny) && near(mass.inertia.cx.x, 96 * 13 / (mvFloat)3, (mvFloat)1e-2));
    CHECK(nearVec(box.boxPoints[7], vec(1, 2, 3), 0) && box.base.byteCount == (int)sizeof box);
    CHECK(near(mvMakeOffsetBoxHull(1, 1, 1, vec(5, 0, 0)).base.center.x, 5, tiny));
    t.p = vec(0, 0, 7);
    t.q = mvMakeQuatFromAxisAngle(mvVec3_axisX, MV_PI / 2);
    copy = mvMakeTransformedBoxHull(1, 2, 3, t);
    sane(&copy.base);
    CHECK(nearVec(copy.base.aabb.upperBound, vec(1, 3, 9), tiny));
    CHECK(nearVec(mvComputeHullAABB(&copy.base, mvTransform_identity).lowerBound, vec(-1, -3, 5), tiny));

    /* A copy works by itself; a changed one does not. */
    memcpy(&copy, &box, sizeof box);
    WORKS(CHECK(mvComputeHullMass(&copy.base, 2).mass == mass.mass));
    copy.boxPoints[3].x += 1;
    FAILS(mv_errorDefinition, mvComputeHullMass, CHECK(mvComputeHullMass(&copy.base, 2).mass == 0));
    memcpy(&copy, &box, sizeof box);
    copy.base.byteCount = 1 << 30;
    FAILS(mv_errorDefinition, mvComputeHullMass, mvComputeHullMass(&copy.base, 2));
    copy.base.byteCount = -8;
    FAILS(mv_errorDefinition, mvComputeHullMass, mvComputeHullMass(&copy.base, 2));
    memset(&copy, 0, sizeof copy);
    FAILS(mv_errorDefinition, mvCloneHull, CHECK(mvCloneHull(&copy.base) == NULL));

    clone = mvCloneHull(&box.base);
    sane(clone);
    CHECK(mvComputeHullMass(clone, 2).mass == mass.mass);
    mvDestroyHull(clone);

    FAILS(mv_errorRange, mvMakeCubeHull, bad = mvMakeCubeHull(-1));
    FAILS(mv_errorDefinition, mvComputeHullMass, mvComputeHullMass(&bad.base, 1));
    FAILS(mv_errorNotFinite, mvMakeBoxHull, mvMakeBoxHull(1, (mvFloat)NAN, 1));
    FAILS(mv_errorDegenerate, mvMakeBoxHull, mvMakeBoxHull(1, (mvFloat)1e-7, 1));
    FAILS(mv_errorNotFinite, mvMakeOffsetBoxHull, mvMakeOffsetBoxHull(1, 1, 1, vec((mvFloat)INFINITY, 0, 0)));
    t.q.s = 5;
    FAILS(mv_errorRange, mvMakeTransformedBoxHull, mvMakeTransformedBoxHull(1, 1, 1, t));
}

static void clouds(void)
{
    enum { n = 500 };
    mvVec3 points[n];
    mvHullData *hull, *other;
    int64_t before = mvGetByteCount();
    unsigned seed = 1;
    int i;
    for (i = 0; i < n; ++i)
    {
        mvVec3 v;
        seed = seed * 1664525u + 1013904223u;
        v.x = (mvFloat)(seed >> 8) / 8388608 - 1;
        seed = seed * 1664525u + 1013904223u;
        v.y = (mvFloat)(seed >> 8) / 8388608 - 1;
        seed = seed * 1664525u + 1013904223u;
        v.z = (mvFloat)(seed >> 8) / 8388608 - 1;
        points[i] = v;
    }
    hull = mvCreateHull(points, n, n);
    sane(hull);
    CHECK(hull->vertexCount <= MV_MAX_HULL_VERTICES && mvGetByteCount() == before + hull->byteCount);
    other = mvCreateHull(points, n, 16);
    sane(other);
    CHECK(other->vertexCount <= 16 && other->volume < hull->volume);
    mvDestroyHull(other);
    {
        mvTransform t = mvTransform_identity;
        t.p.x = 10;
        other = mvCloneAndTransformHull(hull, t, vec(-2, 1, 1));
        sane(other);
        CHECK(near(other->volume, 2 * hull->volume, (mvFloat)1e-3));
        mvDestroyHull(other);
        FAILS(mv_errorDegenerate, mvCloneAndTransformHull, mvCloneAndTransformHull(hull, t, vec(0, 1, 1)));
        FAILS(mv_errorNull, mvCloneAndTransformHull, mvCloneAndTransformHull(NULL, t, mvVec3_one));
    }
    FAILS(mv_errorRange, mvCreateHull, CHECK(mvCreateHull(points, n, 3) == NULL));
    FAILS(mv_errorRange, mvCreateHull, mvCreateHull(points, -4, 8));
    FAILS(mv_errorNull, mvCreateHull, mvCreateHull(NULL, 4, 8));
    FAILS(mv_errorDegenerate, mvCreateHull, mvCreateHull(points, 3, 8));
    points[7].y = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvCreateHull, mvCreateHull(points, n, 64));
    for (i = 0; i < n; ++i)
    {
        points[i].y = 1;
    }
    FAILS(mv_errorDegenerate, mvCreateHull, mvCreateHull(points, n, 64));

    mvDestroyHull(hull);
    CHECK(mvGetByteCount() == before);
    FAILS(mv_errorStale, mvDestroyHull, mvDestroyHull(hull));
    FAILS(mv_errorNull, mvDestroyHull, mvDestroyHull(NULL));

    hull = mvCreateCylinder(2, 1, -1, 32);
    sane(hull);
    CHECK(hull->faceCount == 34 && near(hull->center.y, 0, tiny) && hull->volume > 6 && hull->volume < 2 * MV_PI);
    mvDestroyHull(hull);
    hull = mvCreateCone(3, 1, 0, 12);
    sane(hull);
    CHECK(hull->vertexCount == 13 && near(hull->center.y, (mvFloat)0.75, tiny));
    mvDestroyHull(hull);
    FAILS(mv_errorRange, mvCreateCylinder, CHECK(mvCreateCylinder(2, 1, 0, 2) == NULL));
    FAILS(mv_errorRange, mvCreateCone, mvCreateCone(2, 1, -1, 12));
    FAILS(mv_errorRange, mvCreateCone, mvCreateCone(2, 1, 1, 1 << 20));
}

static void simple(void)
{
    mvSphere ball = { { 1, 0, 0 }, 2 }, badBall = { { 0, 0, 0 }, 0 };
    mvCapsule pill = { { 0, -1, 0 }, { 0, 1, 0 }, (mvFloat)0.5 }, badPill = { { 0, 0, 0 }, { 0, 0, 0 }, 1 };
    mvBoxHull box = mvMakeTransformedBoxHull(1, 1, 1, mvTransform_identity);
    mvTransform t = mvTransform_identity;
    mvRayCastInput ray = { { -5, 0, 0 }, { 10, 0, 0 }, 1 };
    mvCastOutput hit;
    t.p.y = 3;
    CHECK(near(mvComputeSphereMass(&ball, 3).mass, 32 * MV_PI, (mvFloat)1e-3));
    CHECK(near(mvComputeCapsuleMass(&pill, 1).mass, MV_PI * (mvFloat)0.25 * (2 + (mvFloat)2 / 3), tiny));
    CHECK(nearVec(mvComputeSphereAABB(&ball, t).upperBound, vec(3, 5, 2), tiny));
    CHECK(nearVec(mvComputeCapsuleAABB(&pill, t).lowerBound, vec((mvFloat)-0.5, (mvFloat)1.5, (mvFloat)-0.5), tiny));
    CHECK(mvIsValidRay(&ray) && !mvIsValidRay(NULL));

    hit = mvRayCastSphere(&ball, &ray);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.4, tiny) && nearVec(hit.normal, vec(-1, 0, 0), tiny));
    hit = mvRayCastCapsule(&pill, &ray);
    CHECK(hit.hit && near(hit.point.x, (mvFloat)-0.5, tiny));
    hit = mvRayCastHull(&box.base, &ray);
    CHECK(hit.hit && near(hit.fraction, (mvFloat)0.4, tiny) && nearVec(hit.point, vec(-1, 0, 0), tiny));
    ray.maxFraction = (mvFloat)0.3;
    CHECK(!mvRayCastHull(&box.base, &ray).hit);
    ray.maxFraction = 1;
    ray.origin = mvVec3_zero;
    CHECK(!mvRayCastHull(&box.base, &ray).hit && !mvRayCastSphere(&ball, &ray).hit);
    CHECK(mvGetLastError() == mv_errorNone);

    FAILS(mv_errorNull, mvRayCastSphere, CHECK(!mvRayCastSphere(NULL, &ray).hit));
    FAILS(mv_errorNull, mvRayCastSphere, mvRayCastSphere(&ball, NULL));
    FAILS(mv_errorDegenerate, mvRayCastCapsule, mvRayCastCapsule(&badPill, &ray));
    FAILS(mv_errorRange, mvComputeSphereMass, mvComputeSphereMass(&badBall, 1));
    FAILS(mv_errorRange, mvComputeSphereMass, mvComputeSphereMass(&ball, -1));
    FAILS(mv_errorNotFinite, mvComputeHullMass, mvComputeHullMass(&box.base, (mvFloat)NAN));
    ray.maxFraction = -1;
    CHECK(!mvIsValidRay(&ray));
    FAILS(mv_errorRange, mvRayCastHull, mvRayCastHull(&box.base, &ray));
    t.q.v.x = 1;
    FAILS(mv_errorRange, mvComputeCapsuleAABB, mvComputeCapsuleAABB(&pill, t));
}

int main(void)
{
    boxes();
    clouds();
    simple();
    return done("hull");
}
