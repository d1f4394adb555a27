/* Debug draw, by functions and into arrays. */
#include "check.h"

#include <math.h>

typedef struct Drawn
{
    mvWorldId world;
    mvBodyId body;
    int shapes, segments, transforms, points, spheres, capsules, polygons, corners, bounds, boxes, strings;
    mvFloat length;
    mvHexColor color;
    mvPos spherePosition, pillEnd1, pillEnd2;
    mvVec3 boxExtents;
    mvFloat radii;
    char text[64];
} Drawn;

/* A function of a drawing may read the world but not change it. */
static void inside(Drawn* d)
{
    WORKS(mvBody_GetMass(d->body));
    FAILS(mv_errorLocked, mvBody_SetAwake, mvBody_SetAwake(d->body, true));
}

static void drawShape(const mvShapeId* shapeId, const mvWorldTransform* transform, mvHexColor color, void* context)
{
    Drawn* d = context;
    CHECK(mvShape_IsValid(*shapeId) && mvIsValidWorldTransform(*transform) && color <= 0xffffff);
    inside(d);
    d->shapes += 1;
}

static void drawSegment(const mvPos* p1, const mvPos* p2, mvHexColor color, void* context)
{
    Drawn* d = context;
    d->length += mvLength(mvSubPos(*p2, *p1));
    d->color = color;
    d->segments += 1;
}

static void drawTransform(const mvWorldTransform* transform, void* context)
{
    CHECK(mvIsValidWorldTransform(*transform));
    ((Drawn*)context)->transforms += 1;
}

static void drawPoint(const mvPos* p, mvFloat size, mvHexColor color, void* context)
{
    CHECK(mvIsValidPosition(*p) && size > 0 && color <= 0xffffff);
    ((Drawn*)context)->points += 1;
}

static void drawSphere(const mvPos* p, mvFloat radius, mvHexColor color, mvFloat alpha, void* context)
{
    Drawn* d = context;
    CHECK(color == 0x123456 && alpha == 1);
    d->spherePosition = *p;
    d->radii += radius;
    d->spheres += 1;
}

static void drawCapsule(const mvPos* p1, const mvPos* p2, mvFloat radius, mvHexColor color, mvFloat alpha, void* context)
{
    Drawn* d = context;
    CHECK(color <= 0xffffff && alpha == 1);
    d->pillEnd1 = *p1;
    d->pillEnd2 = *p2;
    d->radii += radius;
    d->capsules += 1;
}

static void drawPolygon(const mvPos* vertices, int count, mvHexColor color, mvFloat alpha, void* context)
{
    Drawn* d = context;
    int k;
    CHECK(color <= 0xffffff && alpha == 1);
    for (k = 0; k < count; ++k)
    {
        CHECK(mvIsValidPosition(vertices[k]));
    }
    d->corners += count;
    d->polygons += 1;
}

static void drawBounds(const mvAABB* aabb, mvHexColor color, void* context)
{
    CHECK(mvIsValidAABB(*aabb) && color <= 0xffffff);
    ((Drawn*)context)->bounds += 1;
}

static void drawBox(const mvVec3* extents, const mvWorldTransform* transform, mvHexColor color, void* context)
{
    Drawn* d = context;
    CHECK(near(transform->p.x, 3, (mvFloat)1e-5) && color <= 0xffffff);
    d->boxExtents = *extents;
    d->boxes += 1;
}

static void drawString(const mvPos* p, const char* s, mvHexColor color, void* context)
{
    Drawn* d = context;
    CHECK(mvIsValidPosition(*p) && color <= 0xffffff && strlen(s) < sizeof d->text);
    strcpy(d->text, s);
    d->strings += 1;
}

static mvDebugDraw nothing(Drawn* d)
{
    mvDebugDraw draw = mvDefaultDebugDraw();
    draw.DrawSegmentFcn = drawSegment;
    draw.DrawTransformFcn = drawTransform;
    draw.DrawPointFcn = drawPoint;
    draw.DrawSphereFcn = drawSphere;
    draw.DrawCapsuleFcn = drawCapsule;
    draw.DrawPolygonFcn = drawPolygon;
    draw.DrawBoundsFcn = drawBounds;
    draw.DrawBoxFcn = drawBox;
    draw.DrawStringFcn = drawString;
    draw.drawShapes = draw.drawJoints = false;
    draw.context = d;
    return draw;
}

/* A ground, a ball, a capsule, a box and a wedge. */
static mvWorldId makeWorld(mvBodyId* box)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvWorldId world = mvCreateWorld(&worldDef);
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvPlane plane = { { 0, 1, 0 }, 0 };
    mvSphere ball = { { 0, (mvFloat)0.25, 0 }, (mvFloat)0.5 };
    mvCapsule pill = { { -1, 0, 0 }, { 1, 0, 0 }, (mvFloat)0.25 };
    mvVec3 corners[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    mvHullData* wedge = mvCreateHull(corners, 4, 4);
    mvCreatePlaneShape(mvCreateBody(world, &bodyDef), &shapeDef, &plane);
    bodyDef.type = mv_dynamicBody;
    bodyDef.position = pos(3, (mvFloat)0.5, 0);
    bodyDef.name = "box";
    *box = mvCreateBody(world, &bodyDef);
    mvCreateBoxShape(*box, &shapeDef, (mvFloat)0.5, (mvFloat)0.5, (mvFloat)0.5);
    bodyDef.type = mv_staticBody;
    bodyDef.name = NULL;
    bodyDef.position = pos(-3, 2, 0);
    shapeDef.baseMaterial.customColor = 0x123456;
    mvCreateSphereShape(mvCreateBody(world, &bodyDef), &shapeDef, &ball);
    shapeDef.baseMaterial.customColor = 0;
    shapeDef.filter.categoryBits = 4;
    bodyDef.position = pos(0, 2, 0);
    mvCreateCapsuleShape(mvCreateBody(world, &bodyDef), &shapeDef, &pill);
    bodyDef.position = pos(0, 2, 5);
    mvCreateHullShape(mvCreateBody(world, &bodyDef), &shapeDef, wedge);
    mvDestroyHull(wedge);
    return world;
}

static void byFunctions(void)
{
    mvBodyId box;
    mvWorldId world = makeWorld(&box);
    Drawn d = { 0 }, none = { 0 };
    mvDebugDraw draw = nothing(&d), empty = { 0 };
    int k;
    d.world = world;
    d.body = box;
    for (k = 0; k < 10; ++k)
    {
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
    }

    WORKS(mvWorld_Draw(world, &draw, MV_DEFAULT_MASK_BITS));
    none.world = world;
    none.body = box;
    CHECK(memcmp(&d, &none, sizeof d) == 0);

    draw.drawShapes = true;
    WORKS(mvWorld_Draw(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(d.spheres == 1 && d.capsules == 1 && d.boxes == 1 && d.polygons == 5 && d.corners == 4 + 4 * 3);
    CHECK(nearVec(mvToVec3(d.spherePosition), vec(-3, (mvFloat)2.25, 0), (mvFloat)1e-5));
    CHECK(near(d.radii, (mvFloat)0.75, (mvFloat)1e-6));
    CHECK(nearVec(mvToVec3(d.pillEnd1), vec(-1, 2, 0), (mvFloat)1e-5));
    CHECK(nearVec(mvToVec3(d.pillEnd2), vec(1, 2, 0), (mvFloat)1e-5));
    CHECK(nearVec(d.boxExtents, vec((mvFloat)0.5, (mvFloat)0.5, (mvFloat)0.5), (mvFloat)1e-6));

    /* One category of shapes, and one part of the world. */
    d = none;
    WORKS(mvWorld_Draw(world, &draw, 4));
    CHECK(d.spheres == 1 && d.capsules == 1 && d.boxes == 1 && d.polygons == 5);
    d = none;
    draw.drawingBounds.lowerBound = vec(-4, 1, -1);
    draw.drawingBounds.upperBound = vec(-2, 3, 1);
    WORKS(mvWorld_Draw(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(d.spheres == 1 && d.capsules == 0 && d.boxes == 0 && d.polygons == 0);

    /* A function for all shapes. */
    d = none;
    draw = nothing(&d);
    draw.drawShapes = true;
    draw.DrawShapeFcn = drawShape;
    WORKS(mvWorld_Draw(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(d.shapes == 5 && d.spheres == 0 && d.polygons == 0);

    /* The rest, one by one. */
    d = none;
    draw = nothing(&d);
    draw.drawContacts = draw.drawContactFeatures = draw.drawContactForces = true;
    draw.forceScale = (mvFloat)1e-3;
    WORKS(mvWorld_Draw(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(d.points == 4 && d.strings == 4 && d.segments == 4);
    CHECK(near(d.length, 10, (mvFloat)0.1)); /* 1000 kg at 10 m/s^2, 0.001 m/N */
    d = none;
    draw = nothing(&d);
    draw.drawBounds = draw.drawIslands = true;
    WORKS(mvWorld_Draw(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(d.bounds == 6);
    d = none;
    draw.DrawBoundsFcn = NULL;
    WORKS(mvWorld_Draw(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(d.bounds == 0 && d.segments == 72);
    d = none;
    draw = nothing(&d);
    draw.drawBodyNames = true;
    WORKS(mvWorld_Draw(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(d.strings == 1 && strcmp(d.text, "box") == 0);

    FAILS(mv_errorNull, mvWorld_Draw, mvWorld_Draw(world, NULL, 1));
    FAILS(mv_errorNull, mvWorld_Draw, mvWorld_Draw(mv_nullWorldId, &draw, 1));
    FAILS(mv_errorDefinition, mvWorld_Draw, mvWorld_Draw(world, &empty, 1));
    draw.forceScale = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvWorld_Draw, mvWorld_Draw(world, &draw, 1));
    mvDestroyWorld(world);
    FAILS(mv_errorStale, mvWorld_Draw, mvWorld_Draw(world, &draw, 1));
}

static void intoArrays(void)
{
    mvBodyId box, anchor;
    mvWorldId world = makeWorld(&box);
    mvDebugDraw draw = mvDefaultDebugDraw(), empty = { 0 };
    mvDistanceJointDef jointDef = mvDefaultDistanceJointDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvDrawBuffers b;
    mvVec3 up = { 0, 0, 0 };
    unsigned char bad = 7;
    int k, long1 = 0;

    bodyDef.position = pos(3, 4, 0);
    anchor = mvCreateBody(world, &bodyDef);
    jointDef.base.bodyIdA = anchor;
    jointDef.base.bodyIdB = box;
    jointDef.length = (mvFloat)3.5;
    mvCreateDistanceJoint(world, &jointDef);

    WORKS(b = mvWorld_DrawBuffers(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(b.instanceCount == 3 && b.triangleCount == 2 + 4 && b.lineCount == 3 && b.pointCount == 2);
    CHECK(b.stringCount == 0);
    for (k = 0; k < b.instanceCount; ++k)
    {
        mvBodyId body = mvShape_GetBody(b.instances[k].shapeId);
        if (b.instances[k].kind == mv_drawBox)
        {
            CHECK(MV_ID_EQUALS(body, box));
            CHECK(nearVec(b.instances[k].size, vec((mvFloat)0.5, (mvFloat)0.5, (mvFloat)0.5), (mvFloat)1e-6));
        }
        if (b.instances[k].kind == mv_drawCapsule)
        {
            mvVec3 end = mvRotateVector(b.instances[k].transform.q, vec(0, b.instances[k].size.y, 0));
            CHECK(near(mvAbsFloat(end.x), 1, (mvFloat)1e-5) && b.instances[k].size.x == (mvFloat)0.25);
        }
        if (b.instances[k].kind == mv_drawSphere)
        {
            CHECK(b.instances[k].color == 0x123456 && b.instances[k].size.z == (mvFloat)0.5);
            CHECK(near(b.instances[k].transform.p.y, (mvFloat)2.25, (mvFloat)1e-6));
        }
    }
    /* The rod hangs from (3, 4, 0) down to (3, 0.5, 0). */
    for (k = 0; k < b.lineCount; ++k)
    {
        mvVec3 way = mvSubPos(b.lines[k].p2, b.lines[k].p1);
        CHECK(near(b.lines[k].p1.x, 3, (mvFloat)1e-5) && way.x == 0 && way.z == 0);
        long1 += near(way.y, (mvFloat)-3.5, (mvFloat)1e-5);
    }
    CHECK(long1 == 1);
    /* The normals of a closed surface, weighted by area, sum to nothing. */
    for (k = 0; k < b.triangleCount; ++k)
    {
        mvDrawTriangle t = b.triangles[k];
        if (!near(t.p1.y, 0, (mvFloat)1e-6) || !near(t.p2.y, 0, (mvFloat)1e-6) || !near(t.p3.y, 0, (mvFloat)1e-6))
        {
            up = mvAdd(up, mvCross(mvSubPos(t.p2, t.p1), mvSubPos(t.p3, t.p1)));
            CHECK(mvDot(mvCross(mvSubPos(t.p2, t.p1), mvSubPos(t.p3, t.p1)), t.normal) > 0);
        }
    }
    CHECK(mvLength(up) < (mvFloat)1e-5);

    draw.tessellate = true;
    draw.drawJoints = false;
    draw.drawEdges = draw.drawMass = true;
    WORKS(b = mvWorld_DrawBuffers(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(b.instanceCount == 0 && b.triangleCount > 2 + 4 + 12 + 200 && b.lineCount > 12 + 6 + 4);
    CHECK(b.pointCount == 1 && b.stringCount == 1 && strcmp(b.strings[0].text, "1000.000 kg") == 0);
    CHECK(near(b.points[0].position.x, 3, (mvFloat)1e-6) && b.points[0].size > 0);

    draw.drawShapes = draw.drawEdges = draw.drawMass = false;
    WORKS(b = mvWorld_DrawBuffers(world, &draw, MV_DEFAULT_MASK_BITS));
    CHECK(b.lineCount + b.triangleCount + b.instanceCount + b.pointCount + b.stringCount == 0);

    FAILS(mv_errorNull, mvWorld_DrawBuffers, b = mvWorld_DrawBuffers(world, NULL, 1));
    FAILS(mv_errorDefinition, mvWorld_DrawBuffers, b = mvWorld_DrawBuffers(world, &empty, 1));
    memcpy(&draw.drawShapes, &bad, 1);
    FAILS(mv_errorRange, mvWorld_DrawBuffers, b = mvWorld_DrawBuffers(world, &draw, 1));
    CHECK(b.lines == NULL && b.triangleCount == 0);
    mvDestroyWorld(world);
    draw = mvDefaultDebugDraw();
    FAILS(mv_errorStale, mvWorld_DrawBuffers, b = mvWorld_DrawBuffers(world, &draw, 1));
}

int main(void)
{
    byFunctions();
    intoArrays();
    return done("draw");
}
