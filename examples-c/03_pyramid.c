/* A pyramid of boxes stands, and keeps standing. */
#include "merev.h"

#include <stdio.h>

enum
{
    base = 12
};

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvPlane ground = { { 0, 1, 0 }, 0 };
    mvBoxHull cube = mvMakeCubeHull((mvFloat)0.5);
    mvWorldId world = mvCreateWorld(&worldDef);
    mvBodyId top = mv_nullBodyId;
    mvStepReport report;
    int row, column, step;
    double height;

    /* A plane is a floor without end. */
    mvCreatePlaneShape(mvCreateBody(world, &bodyDef), &shapeDef, &ground);

    bodyDef.type = mv_dynamicBody;
    for (row = 0; row < base; ++row)
    {
        for (column = 0; column < base - row; ++column)
        {
            bodyDef.position.x = (mvFloat)(1.05 * (column + 0.5 * row));
            bodyDef.position.y = (mvFloat)(0.5 + row);
            top = mvCreateBody(world, &bodyDef);
            mvCreateHullShape(top, &shapeDef, &cube.base);
        }
    }
    printf("%d boxes\n", mvWorld_GetCounters(world).bodyCount - 1);

    for (step = 1; step <= 600; ++step)
    {
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
        if (step % 120 == 0)
        {
            report = mvWorld_GetStepReport(world);
            printf("%4.1f s  top at %8.5f m  deepest overlap %.1e m  energy %.1e J  awake %d\n", step / 60.0,
                   (double)mvBody_GetPosition(top).y, (double)report.worstPenetration, report.kineticEnergy,
                   mvWorld_GetAwakeBodyCount(world));
        }
    }
    height = (double)mvBody_GetPosition(top).y;
    mvDestroyWorld(world);
    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return fabs(height - (base - 0.5)) < 0.05 ? 0 : 1;
}
