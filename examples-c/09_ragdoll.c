/* Three humans fall down a flight of steps and come to rest. */
#include "merev.h"

#include <stdio.h>

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvWorldId world = mvCreateWorld(&worldDef);
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvHumanDef def = mvDefaultHumanDef();
    mvPlane floor = { { 0, 1, 0 }, 0 };
    mvVec3 push = { 0, 0, 120 };
    mvHuman humans[3];
    mvStepReport report;
    mvFloat worst = 0;
    int k, step, wrong = 0;

    mvCreatePlaneShape(mvCreateBody(world, &bodyDef), &shapeDef, &floor);
    for (k = 0; k < 4; ++k)
    {
        bodyDef.position.y = (mvFloat)(0.7 - 0.2 * k);
        bodyDef.position.z = (mvFloat)(0.5 * k);
        mvCreateBoxShape(mvCreateBody(world, &bodyDef), &shapeDef, 3, (mvFloat)0.1, (mvFloat)0.25);
    }

    /* Each human has a group of its own, so that it meets the others but not itself. */
    def.mass = 75;
    def.frictionTorque = 4;
    for (k = 0; k < 3; ++k)
    {
        def.boneCount = k == 1 ? 14 : 11;
        def.position.x = (mvFloat)(k - 1);
        def.position.y = (mvFloat)0.81;
        def.groupIndex = -(k + 1);
        humans[k] = mvCreateHuman(world, &def);
        mvHuman_ApplyLinearImpulse(&humans[k], push);
    }

    for (step = 0; step < 1200 && mvWorld_GetAwakeBodyCount(world) > 0; ++step)
    {
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
        report = mvWorld_GetStepReport(world);
        worst = mvMaxFloat(worst, report.jointGap);
        if (step % 60 == 0)
        {
            printf("%4.1f s: heads at", step / 60.0);
            for (k = 0; k < 3; ++k)
            {
                mvPos head = mvBody_GetWorldCenter(humans[k].bodyIds[humans[k].boneCount == 14 ? 3 : 2]);
                printf("  (%5.2f, %5.2f, %5.2f)", (double)head.x, (double)head.y, (double)head.z);
            }
            printf(", %6.1f J\n", report.kineticEnergy);
        }
    }
    printf("At rest after %.1f s; joints came apart by at most %.2f mm.\n", step / 60.0, 1000 * (double)worst);
    wrong += step == 1200 || worst > (mvFloat)0.03;
    for (k = 0; k < 3; ++k)
    {
        mvPos pelvis = mvBody_GetWorldCenter(humans[k].bodyIds[0]);
        wrong += !(pelvis.y > 0 && pelvis.y < 1 && pelvis.z > (mvFloat)0.3);
        mvDestroyHuman(&humans[k]);
    }
    wrong += mvWorld_GetCounters(world).jointCount != 0;
    mvDestroyWorld(world);
    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return wrong == 0 ? 0 : 1;
}
