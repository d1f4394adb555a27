/* A ball of diameter 1 m falls 4 m onto a slab with coefficient of restitution 0.9, 100 steps a second. */
#include "lab.h"

int labBouncingBall(const LabHost* host, int steps)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvSphere sphere = { { 0, 0, 0 }, (mvFloat)0.5 };
    mvWorldId world;
    mvBodyId ball;
    float poses[7];
    int step;

    /* Everything bounces, and every hit is told. */
    worldDef.restitutionThreshold = 0;
    worldDef.hitEventThreshold = 0;
    world = mvCreateWorld(&worldDef);

    shapeDef.baseMaterial.restitution = (mvFloat)0.9;
    shapeDef.baseMaterial.friction = (mvFloat)0.1;
    shapeDef.density = 1;
    shapeDef.enableHitEvents = true;

    bodyDef.position.y = -5;
    mvCreateBoxShape(mvCreateBody(world, &bodyDef), &shapeDef, 5, (mvFloat)0.5, 5);

    bodyDef.type = mv_dynamicBody;
    bodyDef.position.y = 0;
    ball = mvCreateBody(world, &bodyDef);
    mvCreateSphereShape(ball, &shapeDef, &sphere);

    for (step = 1; step <= steps; ++step)
    {
        labStep(host, world, 0.01, step, true, &ball, poses, 1);
    }
    mvDestroyWorld(world);
    return mvGetLastError();
}
