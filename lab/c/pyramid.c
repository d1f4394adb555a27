/* A planar pyramid of cubes stands. Later a heavy ball may strike it. */
#include "lab.h"

#include <stdlib.h>

/* A ball comes rolling out of the air at the pyramid's lower third. */
static mvBodyId strike(mvWorldId world, int rows)
{
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvSphere sphere = { { 0, 0, 0 }, (mvFloat)0.9 };
    mvBodyId ball;

    bodyDef.type = mv_dynamicBody;
    bodyDef.position.x = (mvFloat)(-0.9 * rows);
    bodyDef.position.y = (mvFloat)(0.35 * rows);
    bodyDef.position.z = (mvFloat)(1.2 * rows);
    bodyDef.linearVelocity.x = (mvFloat)(1.5 * rows);
    bodyDef.linearVelocity.y = 2;
    bodyDef.linearVelocity.z = (mvFloat)(-2.1 * rows);
    ball = mvCreateBody(world, &bodyDef);
    shapeDef.density = 500;
    mvCreateSphereShape(ball, &shapeDef, &sphere);
    return ball;
}

/* Measures the world after the first step, every measureEvery steps and after the last; strikeAfter 0: never. */
int labPyramid(const LabHost* host, int rows, int steps, int measureEvery, int strikeAfter)
{
    int count = rows * (rows + 1) / 2;
    mvBodyId* bodies = malloc((size_t)(count + 1) * sizeof(mvBodyId));
    float* poses = malloc((size_t)(count + 1) * 7 * sizeof(float));
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvWorldId world;
    int row, column, step, next = 0;

    if (bodies == NULL || poses == NULL)
    {
        abort();
    }
    worldDef.enableSleep = false;
    world = mvCreateWorld(&worldDef);

    /* The ground: its upper side is at height 0. */
    bodyDef.position.y = -1;
    mvCreateBoxShape(mvCreateBody(world, &bodyDef), &shapeDef, 400, 1, 400);

    bodyDef.type = mv_dynamicBody;
    shapeDef.density = 100;
    for (row = 0; row < rows; ++row)
    {
        for (column = 0; column < rows - row; ++column)
        {
            bodyDef.position.x = (mvFloat)(column + 0.5 * (1 + row - rows));
            bodyDef.position.y = (mvFloat)(0.5 + row);
            bodies[next] = mvCreateBody(world, &bodyDef);
            mvCreateBoxShape(bodies[next], &shapeDef, (mvFloat)0.5, (mvFloat)0.5, (mvFloat)0.5);
            ++next;
        }
    }

    for (step = 1; step <= steps; ++step)
    {
        if (strikeAfter > 0 && step == strikeAfter + 1)
        {
            bodies[next++] = strike(world, rows);
        }
        labStep(host, world, 1.0 / 60, step, step == 1 || step % measureEvery == 0 || step == steps, bodies, poses, next);
    }
    mvDestroyWorld(world);
    free(bodies);
    free(poses);
    return mvGetLastError();
}
