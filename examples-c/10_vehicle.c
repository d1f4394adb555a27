/* A chassis on four wheels drives over a ramp: motors behind, steering in front. */
#include "merev.h"

#include <stdio.h>

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvWorldId world = mvCreateWorld(&worldDef);
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvWheelJointDef def = mvDefaultWheelJointDef();
    mvPlane floor = { { 0, 1, 0 }, 0 };
    mvSphere tyre = { { 0, 0, 0 }, (mvFloat)0.35 };
    mvVec3 ramp[6] = { { 8, 0, -3 }, { 8, 0, 3 }, { 11, 1, -3 }, { 11, 1, 3 }, { 14, 0, -3 }, { 14, 0, 3 } };
    mvHullData* hull = mvCreateHull(ramp, 6, 6);
    mvBodyId ground = mvCreateBody(world, &bodyDef), chassis;
    mvJointId wheels[4];
    mvFloat top = 0, x = 0;
    int k, step, wrong = 0;

    mvCreatePlaneShape(ground, &shapeDef, &floor);
    mvCreateHullShape(ground, &shapeDef, hull);
    mvDestroyHull(hull);
    bodyDef.type = mv_dynamicBody;
    bodyDef.enableSleep = false;
    bodyDef.position.y = (mvFloat)0.8;
    chassis = mvCreateBody(world, &bodyDef);
    shapeDef.density = 250;
    mvCreateBoxShape(chassis, &shapeDef, (mvFloat)1.5, (mvFloat)0.2, (mvFloat)0.7);

    /* Frame A: its x is up, the way of the suspension and the axis of steering; its z is the axle, sideways. */
    def.base.bodyIdA = chassis;
    def.base.localFrameA.q = mvMakeQuatFromAxisAngle(mvVec3_axisZ, MV_PI / 2);
    def.suspensionHertz = 4;
    def.enableSuspensionLimit = true;
    def.lowerSuspensionLimit = (mvFloat)-0.2;
    def.upperSuspensionLimit = (mvFloat)0.2;
    def.steeringHertz = 5;
    def.maxSteeringTorque = 500;
    def.maxSpinTorque = 250;
    def.spinSpeed = -15; /* about z: negative is forward, along x */
    shapeDef.baseMaterial.friction = (mvFloat)1.2;
    for (k = 0; k < 4; ++k)
    {
        mvVec3 at = { 0, (mvFloat)-0.35, 0 };
        at.x = (mvFloat)(k < 2 ? 1.1 : -1.1);
        at.z = (mvFloat)(k % 2 == 0 ? 0.8 : -0.8);
        bodyDef.position = mvBody_GetWorldPoint(chassis, at);
        def.base.bodyIdB = mvCreateBody(world, &bodyDef);
        mvCreateSphereShape(def.base.bodyIdB, &shapeDef, &tyre);
        def.base.localFrameA.p = at;
        def.base.localFrameB.q = def.base.localFrameA.q;
        def.enableSteering = k < 2;
        def.enableSpinMotor = k >= 2;
        wheels[k] = mvCreateWheelJoint(world, &def);
    }

    printf("  time      x   height  speed  travel of the suspension [mm]\n");
    for (step = 1; step <= 420; ++step)
    {
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
        x = mvBody_GetPosition(chassis).x;
        top = mvMaxFloat(top, mvBody_GetPosition(chassis).y);
        if (step % 30 == 0)
        {
            printf("%4.1f s  %5.1f m  %4.2f m  %4.1f m/s ", step / 60.0, (double)x, (double)mvBody_GetPosition(chassis).y,
                   (double)mvBody_GetLinearVelocity(chassis).x);
            for (k = 0; k < 4; ++k)
            {
                printf("  %4.0f", 1000 * (double)mvWheelJoint_GetSuspensionTravel(wheels[k]));
            }
            printf("\n");
        }
        if (x > 16)
        {
            mvWheelJoint_SetTargetSteeringAngle(wheels[0], (mvFloat)0.3);
            mvWheelJoint_SetTargetSteeringAngle(wheels[1], (mvFloat)0.3);
        }
    }
    printf("Over the ramp: %s; the front wheels steer by %.2f rad, and the car went aside by %.1f m.\n",
           x > 15 ? "yes" : "no", (double)mvWheelJoint_GetSteeringAngle(wheels[0]),
           (double)mvBody_GetPosition(chassis).z);
    wrong += x < 15 || top < (mvFloat)1.5;
    wrong += fabs((double)mvWheelJoint_GetSteeringAngle(wheels[0]) - 0.3) > 0.08;
    wrong += fabs((double)mvBody_GetPosition(chassis).z) < 1;
    mvDestroyWorld(world);
    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return wrong == 0 ? 0 : 1;
}
