/* A ball falls 4 m onto a box and bounces with restitution 0.9, beside what paper and pencil say.
 *
 * It falls for t0 = sqrt(0.8) s and arrives with v0 = sqrt(80) m/s. Hit k = 0, 1, 2 ... leaves with v0 * 0.9^(k+1),
 * and each flight takes twice that speed divided by gravity. */
#include "merev.h"

#include <stdio.h>

static const double gravity = 10, restitution = 0.9;

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvBoxHull floorBox = mvMakeBoxHull(5, (mvFloat)0.5, 5);
    mvSphere sphere = { { 0, 0, 0 }, (mvFloat)0.5 };
    mvWorldId world;
    mvBodyId ball;
    double hitTime = sqrt(0.8), leaving = sqrt(80.0) * restitution, mass, before = 0;
    int step, hits = 0, wrong = 0;

    worldDef.gravity.y = (mvFloat)-gravity;
    world = mvCreateWorld(&worldDef);
    shapeDef.baseMaterial.restitution = (mvFloat)restitution;
    shapeDef.baseMaterial.friction = (mvFloat)0.1;
    shapeDef.density = 1;
    bodyDef.position.y = -5;
    mvCreateHullShape(mvCreateBody(world, &bodyDef), &shapeDef, &floorBox.base);
    bodyDef.type = mv_dynamicBody;
    bodyDef.position.y = 0;
    ball = mvCreateBody(world, &bodyDef);
    mvCreateSphereShape(ball, &shapeDef, &sphere);
    mass = (double)mvBody_GetMass(ball);

    printf("      seen at [s]  hit at, exact   momentum after, exact [kg m/s]\n");
    for (step = 1; step <= 2000; ++step)
    {
        double time = step / 100.0, momentum, exact;
        mvWorld_Step(world, (mvFloat)0.01, 4);
        momentum = (double)mvBody_GetMomentum(ball).y;
        if (before < 0 && momentum > 0)
        {
            /* The rest of the step is flight already. */
            exact = mass * (leaving - gravity * (time - hitTime));
            printf("hit %2d  %8.2f  %13.4f  %15.5f %8.5f\n", hits, time, hitTime, momentum, exact);
            if (hits < 15 && (fabs(time - hitTime) > 0.02 || fabs(momentum - exact) > 0.02 * exact))
            {
                wrong += 1;
            }
            hits += 1;
            hitTime += 2 * leaving / gravity;
            leaving *= restitution;
        }
        before = momentum;
    }
    printf("after 20 s: height %.4f m, exact -4; %d hits\n", (double)mvBody_GetPosition(ball).y, hits);
    wrong += fabs((double)mvBody_GetPosition(ball).y + 4) > 0.01;
    mvDestroyWorld(world);
    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return wrong == 0 && hits >= 15 ? 0 : 1;
}
