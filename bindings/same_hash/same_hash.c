/* The scene that every binding computes, in C: the calls and their order are those of bindings/README.md. */
#include "merev.h"

#include <inttypes.h>
#include <stdio.h>

static mvBodyId box(mvWorldId world, double x, double y, double z)
{
    mvBodyDef def = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvBodyId body;
    def.type = mv_dynamicBody;
    def.position.x = (mvFloat)x;
    def.position.y = (mvFloat)y;
    def.position.z = (mvFloat)z;
    body = mvCreateBody(world, &def);
    mvCreateBoxShape(body, &shapeDef, (mvFloat)0.5, (mvFloat)0.5, (mvFloat)0.5);
    return body;
}

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef groundDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvRevoluteJointDef hinge = mvDefaultRevoluteJointDef();
    mvSphericalJointDef ball = mvDefaultSphericalJointDef();
    mvDistanceJointDef spring = mvDefaultDistanceJointDef();
    mvPlane floor = { { 0, 1, 0 }, 0 };
    mvWorldId world = mvCreateWorld(&worldDef);
    mvBodyId ground = mvCreateBody(world, &groundDef), link;
    int row, column, step;
    mvCreatePlaneShape(ground, &shapeDef, &floor);

    /* A pyramid of 10 boxes. */
    for (row = 0; row < 4; ++row)
    {
        for (column = 0; column < 4 - row; ++column)
        {
            box(world, 1.25 * column + 0.625 * row, 0.5 + row, 0);
        }
    }

    /* An arm that a motor turns, a pendulum at its end, and a box on a spring. */
    link = box(world, 0, 6, 4);
    hinge.base.bodyIdA = ground;
    hinge.base.bodyIdB = link;
    hinge.base.localFrameA.p.y = 6;
    hinge.base.localFrameA.p.z = 4;
    hinge.enableMotor = true;
    hinge.motorSpeed = 1;
    hinge.maxMotorTorque = 1000000;
    mvCreateRevoluteJoint(world, &hinge);
    ball.base.bodyIdA = link;
    ball.base.bodyIdB = box(world, 2, 6, 4);
    ball.base.localFrameA.p.x = 1;
    ball.base.localFrameB.p.x = -1;
    mvCreateSphericalJoint(world, &ball);
    spring.base.bodyIdA = ground;
    spring.base.bodyIdB = box(world, 8, 4, 0);
    spring.base.localFrameA.p.x = 8;
    spring.base.localFrameA.p.y = 8;
    spring.length = 3;
    spring.enableSpring = true;
    spring.hertz = 2;
    spring.dampingRatio = (mvFloat)0.125;
    mvCreateDistanceJoint(world, &spring);

    for (step = 0; step < 120; ++step)
    {
        mvWorld_Step(world, (mvFloat)0.015625, 4);
    }
    printf("%016" PRIx64 "\n", mvWorld_GetStateHash(world));
    mvDestroyWorld(world);
    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return 0;
}
