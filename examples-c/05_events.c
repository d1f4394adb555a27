/* What happened in a step? Arrays of events, to be read after it. */
#include "merev.h"

#include <stdio.h>

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvPlane ground = { { 0, 1, 0 }, 0 };
    mvBoxHull cube = mvMakeCubeHull((mvFloat)0.5);
    mvWorldId world = mvCreateWorld(&worldDef);
    mvBodyId boxes[3];
    const char* names[3] = { "red", "green", "blue" };
    int k, step, begins = 0, ends = 0, hits = 0, asleep = 0;

    mvCreatePlaneShape(mvCreateBody(world, &bodyDef), &shapeDef, &ground);
    bodyDef.type = mv_dynamicBody;
    shapeDef.enableContactEvents = true;
    shapeDef.enableHitEvents = true;
    for (k = 0; k < 3; ++k)
    {
        bodyDef.position.x = (mvFloat)(3 * k);
        bodyDef.position.y = (mvFloat)(1 + 2 * k);
        bodyDef.name = names[k];
        boxes[k] = mvCreateBody(world, &bodyDef);
        mvCreateHullShape(boxes[k], &shapeDef, &cube.base);
    }

    for (step = 1; step <= 240; ++step)
    {
        mvContactEvents contacts;
        mvBodyEvents moves;
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
        contacts = mvWorld_GetContactEvents(world);
        for (k = 0; k < contacts.beginCount; ++k)
        {
            mvBodyId body = mvShape_GetBody(contacts.beginEvents[k].shapeIdB);
            printf("%5.2f s  %s touches the ground\n", step / 60.0, mvBody_GetName(body));
            begins += 1;
        }
        for (k = 0; k < contacts.hitCount; ++k)
        {
            printf("%5.2f s  a hit with %.2f m/s\n", step / 60.0, (double)contacts.hitEvents[k].approachSpeed);
            hits += 1;
        }
        for (k = 0; k < contacts.endCount; ++k)
        {
            printf("%5.2f s  a contact ends\n", step / 60.0);
            ends += 1;
        }
        moves = mvWorld_GetBodyEvents(world);
        for (k = 0; k < moves.moveCount; ++k)
        {
            if (moves.moveEvents[k].fellAsleep)
            {
                printf("%5.2f s  %s falls asleep\n", step / 60.0, mvBody_GetName(moves.moveEvents[k].bodyId));
                asleep += 1;
            }
        }
        if (step == 200)
        {
            /* The end of its contact is told in the next step. */
            mvDestroyBody(boxes[0]);
        }
    }
    mvDestroyWorld(world);
    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return begins >= 3 && hits >= 3 && ends >= 1 && asleep == 3 ? 0 : 1;
}
