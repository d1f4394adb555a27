/* A row of joints, each with a load or a motor, and what they report. */
#include "merev.h"

#include <stdio.h>

static int wrong = 0;

static mvBodyId cube(mvWorldId world, mvBodyType type, mvFloat x, mvFloat y)
{
    mvBodyDef def = mvDefaultBodyDef();
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvBodyId body;
    def.type = type;
    def.position.x = x;
    def.position.y = y;
    body = mvCreateBody(world, &def);
    shapeDef.density = 125; /* 1 kg */
    mvCreateBoxShape(body, &shapeDef, (mvFloat)0.1, (mvFloat)0.1, (mvFloat)0.1);
    return body;
}

/* Both ends of a joint: a fixed cube at height 5 and one of 1 kg that hangs `down` below it. */
static void ends(mvWorldId world, mvJointDef* base, mvFloat x, mvFloat down)
{
    base->bodyIdA = cube(world, mv_staticBody, x, 5);
    base->bodyIdB = cube(world, mv_dynamicBody, x, 5 - down);
}

static void show(const char* joint, const char* what, mvFloat is, double expected, double tolerance)
{
    int bad = !(fabs((double)is - expected) <= tolerance);
    printf("%-10s %-24s %9.4f  %9.4f %s\n", joint, what, (double)is, expected, bad ? "WRONG" : "");
    wrong += bad;
}

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvWorldId world = mvCreateWorld(&worldDef);
    mvRevoluteJointDef hinge = mvDefaultRevoluteJointDef();
    mvPrismaticJointDef slide = mvDefaultPrismaticJointDef();
    mvDistanceJointDef spring = mvDefaultDistanceJointDef(), rod = mvDefaultDistanceJointDef();
    mvWeldJointDef weld = mvDefaultWeldJointDef();
    mvGearJointDef gear = mvDefaultGearJointDef();
    mvJointId hinges[2], slider, springy, stiff, welded;
    int k;

    /* Two hinges about z: a motor turns the first, a gear makes the second go half as far the other way. */
    hinge.enableMotor = true;
    hinge.motorSpeed = 4;
    hinge.maxMotorTorque = 100;
    ends(world, &hinge.base, 0, 0);
    hinges[0] = mvCreateRevoluteJoint(world, &hinge);
    hinge.enableMotor = false;
    ends(world, &hinge.base, 1, 0);
    hinges[1] = mvCreateRevoluteJoint(world, &hinge);
    gear.jointIdA = hinges[0];
    gear.jointIdB = hinges[1];
    gear.ratio = 2;
    mvCreateGearJoint(world, &gear);

    /* A slide along x, pushed to its limit. */
    slide.enableMotor = slide.enableLimit = true;
    slide.motorSpeed = 1;
    slide.maxMotorForce = 50;
    slide.upperTranslation = (mvFloat)0.5;
    ends(world, &slide.base, 2, 0);
    slider = mvCreatePrismaticJoint(world, &slide);

    /* A spring of 1 Hz stretches by g / (2 pi f)^2 under its load; a rod does not. */
    spring.enableSpring = true;
    spring.hertz = 1;
    spring.dampingRatio = 1;
    ends(world, &spring.base, 4, 1);
    springy = mvCreateDistanceJoint(world, &spring);
    ends(world, &rod.base, 5, 1);
    stiff = mvCreateDistanceJoint(world, &rod);

    /* A weld at arm's length carries a torque. */
    weld.base.bodyIdA = cube(world, mv_staticBody, 7, 5);
    weld.base.bodyIdB = cube(world, mv_dynamicBody, (mvFloat)7.5, 5);
    weld.base.localFrameB.p.x = (mvFloat)-0.5;
    welded = mvCreateWeldJoint(world, &weld);

    for (k = 0; k < 300; ++k)
    {
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
    }
    printf("%-10s %-24s %9s  %9s\n", "joint", "reading", "is", "expected");
    show("revolute", "angle [rad]", mvRevoluteJoint_GetAngle(hinges[0]), 20, 0.05);
    show("gear", "second angle [rad]", mvRevoluteJoint_GetAngle(hinges[1]), -10, 0.05);
    show("prismatic", "translation [m]", mvPrismaticJoint_GetTranslation(slider), 0.5, 1e-3);
    show("prismatic", "motor force [N]", mvPrismaticJoint_GetMotorForce(slider), 50, 0.1);
    show("spring", "length [m]", mvDistanceJoint_GetCurrentLength(springy), 1 + 10 / (4 * MV_PI * MV_PI), 2e-3);
    show("rod", "length [m]", mvDistanceJoint_GetCurrentLength(stiff), 1, 1e-4);
    show("rod", "force [N]", mvJoint_GetConstraintForce(stiff).y, 10, 0.05);
    show("weld", "force [N]", mvJoint_GetConstraintForce(welded).y, 10, 0.05);
    show("weld", "torque [N m]", mvJoint_GetConstraintTorque(welded).z, 5, 0.05);
    show("all", "worst gap [m]", mvWorld_GetStepReport(world).jointGap, 0, 1e-3);
    mvDestroyWorld(world);
    if (mvGetLastError() != mv_errorNone)
    {
        printf("%s\n", mvGetLastErrorMessage());
        return 1;
    }
    return wrong == 0 ? 0 : 1;
}
