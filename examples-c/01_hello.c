/* A box falls onto a floor and comes to rest. */
#include "merev.h"

#include <stdio.h>

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvWorldId world = mvCreateWorld(&worldDef);

    /* The floor: a static body with a box, its upper side at y = 0. */
    mvBodyDef floorDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvBoxHull floorBox = mvMakeBoxHull(10, 1, 10);
    mvBodyId floor;
    mvBodyDef boxDef = mvDefaultBodyDef();
    mvBoxHull cube = mvMakeCubeHull((mvFloat)0.5);
    mvBodyId box;
    int step;
    mvPos end;

    floorDef.position.y = -1;
    floor = mvCreateBody(world, &floorDef);
    mvCreateHullShape(floor, &shapeDef, &floorBox.base);

    /* The box: a dynamic body, a cube of side 1, 4 m up. */
    boxDef.type = mv_dynamicBody;
    boxDef.position.y = 4;
    box = mvCreateBody(world, &boxDef);
    mvCreateHullShape(box, &shapeDef, &cube.base);

    /* Two seconds, sixty steps a second, four sub-steps each. */
    for (step = 0; step < 120; ++step)
    {
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
        if (step % 20 == 0)
        {
            printf("%4.2f s  height %6.3f m\n", (step + 1) / 60.0, (double)mvBody_GetPosition(box).y);
        }
    }
    end = mvBody_GetPosition(box);
    printf("at rest  height %6.3f m\n", (double)end.y);
    mvDestroyWorld(world);

    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return end.y > 0.49 && end.y < 0.51 ? 0 : 1;
}
