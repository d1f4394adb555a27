/* What does the world look like? Arrays of triangles and lines, painted from back to front: 11_debug_draw > picture.svg */
#include "merev.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct Piece
{
    mvPos corners[3];
    int count;
    mvFloat depth;
    mvHexColor color;
} Piece;

static const mvVec3 eye = { 7, 6, 12 };

/* Where on the picture a point is seen, and how far ahead. */
static mvVec3 seen(mvPos p)
{
    mvVec3 d = mvSub(mvToVec3(p), eye), s;
    mvVec3 ahead = mvNormalize(mvSub(mvVec3_axisY, eye));
    mvVec3 right = mvNormalize(mvCross(ahead, mvVec3_axisY)), up = mvCross(right, ahead);
    s.z = mvDot(d, ahead);
    s.x = 400 + 900 * mvDot(d, right) / s.z;
    s.y = 300 - 900 * mvDot(d, up) / s.z;
    return s;
}

static int farthestFirst(const void* a, const void* b)
{
    mvFloat d = ((const Piece*)b)->depth - ((const Piece*)a)->depth;
    return (d > 0) - (d < 0);
}

/* A triangle, or a line where there is no normal. False if it looks away from us. */
static bool piece(Piece* out, const mvPos* corners, int count, const mvVec3* normal, mvHexColor color)
{
    const mvVec3 sun = { (mvFloat)0.3, (mvFloat)0.85, (mvFloat)0.43 };
    mvFloat light = normal == NULL ? 1 : (mvFloat)0.55 + (mvFloat)0.45 * mvMaxFloat(0, mvDot(*normal, sun));
    bool ground = true;
    int k;
    out->count = count;
    out->depth = normal == NULL ? -(mvFloat)0.02 : 0;
    out->color = 0;
    for (k = 0; k < count; ++k)
    {
        out->corners[k] = corners[k];
        out->depth += seen(corners[k]).z / (mvFloat)count;
        out->color |= (mvHexColor)(light * (mvFloat)(color >> 8 * k & 255)) << 8 * k;
        ground = ground && corners[k].y < (mvFloat)0.001;
    }
    if (ground) out->depth += 1000; /* behind everything */
    if (normal == NULL) out->color = color;
    return normal == NULL || mvDot(*normal, mvSub(eye, mvToVec3(corners[0]))) > 0;
}

static void paint(const Piece* p)
{
    int k;
    printf(p->count == 2 ? "<polyline stroke" : "<polygon fill");
    printf("=\"#%06x\" points=\"", (unsigned)p->color);
    for (k = 0; k < p->count; ++k) printf("%.1f,%.1f ", (double)seen(p->corners[k]).x, (double)seen(p->corners[k]).y);
    printf("\"/>\n");
}

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvWorldId world = mvCreateWorld(&worldDef);
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvPlane ground = { { 0, 1, 0 }, 0 };
    mvSphere ball = { { 0, 0, 0 }, (mvFloat)0.5 };
    mvCapsule pill = { { (mvFloat)-0.6, 0, 0 }, { (mvFloat)0.6, 0, 0 }, (mvFloat)0.3 };
    mvDebugDraw draw = mvDefaultDebugDraw();
    mvDrawBuffers buffers;
    Piece* pieces;
    int k, count = 0;

    mvCreatePlaneShape(mvCreateBody(world, &bodyDef), &shapeDef, &ground);
    bodyDef.type = mv_dynamicBody;
    for (k = 0; k < 15; ++k)
    {
        mvBodyId body;
        bodyDef.position.x = (mvFloat)(1.3 * (k % 3 - 1) + 0.1 * (k / 3));
        bodyDef.position.y = (mvFloat)(0.6 + 1.05 * (k / 3));
        bodyDef.position.z = (mvFloat)(0.2 * (k % 2));
        body = mvCreateBody(world, &bodyDef);
        if (k % 3 == 0) mvCreateBoxShape(body, &shapeDef, (mvFloat)0.5, (mvFloat)0.5, (mvFloat)0.5);
        if (k % 3 == 1) mvCreateCapsuleShape(body, &shapeDef, &pill);
        if (k % 3 == 2) mvCreateSphereShape(body, &shapeDef, &ball);
    }
    for (k = 0; k < 120; ++k) mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);

    draw.tessellate = draw.drawEdges = true;
    buffers = mvWorld_DrawBuffers(world, &draw, MV_DEFAULT_MASK_BITS);
    pieces = malloc((size_t)(buffers.triangleCount + buffers.lineCount) * sizeof *pieces);
    if (pieces == NULL) return 1;
    for (k = 0; k < buffers.triangleCount; ++k)
    {
        const mvDrawTriangle* t = buffers.triangles + k;
        count += piece(pieces + count, &t->p1, 3, &t->normal, t->color);
    }
    for (k = 0; k < buffers.lineCount; ++k)
    {
        count += piece(pieces + count, &buffers.lines[k].p1, 2, NULL, buffers.lines[k].color);
    }
    qsort(pieces, (size_t)count, sizeof *pieces, farthestFirst);
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" height=\"600\" fill=\"none\">\n");
    printf("<rect width=\"800\" height=\"600\" fill=\"#dfe6ee\"/>\n");
    for (k = 0; k < count; ++k) paint(pieces + k);
    printf("</svg>\n");
    free(pieces);
    mvDestroyWorld(world);
    return count < 1000 || mvGetLastError() != mv_errorNone;
}
