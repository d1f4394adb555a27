/* Humans from C: creation, settings, pushes, nonsense. */
#include "check.h"

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef();
    mvHumanDef def = mvDefaultHumanDef();
    mvWorldId world;
    mvHuman human, bad;
    mvFloat mass = 0;
    int k, tag = 1;

    worldDef.gravity.y = 0;
    world = mvCreateWorld(&worldDef);
    CHECK(def.boneCount == 11 && def.height == (mvFloat)1.8 && def.groupIndex == -1);
    FAILS(mv_errorNull, mvCreateHuman, CHECK(mvCreateHuman(world, NULL).boneCount == 0));
    def.boneCount = 13;
    FAILS(mv_errorRange, mvCreateHuman, CHECK(mvCreateHuman(world, &def).boneCount == 0));
    def.boneCount = 14;
    def.height = (mvFloat)NAN;
    FAILS(mv_errorNotFinite, mvCreateHuman, mvCreateHuman(world, &def));
    def.height = 2;
    def.internalValue += 1;
    FAILS(mv_errorDefinition, mvCreateHuman, mvCreateHuman(world, &def));
    def.internalValue -= 1;
    CHECK(mvWorld_GetCounters(world).bodyCount == 0);

    def.mass = 80;
    def.userData = &tag;
    WORKS(human = mvCreateHuman(world, &def));
    CHECK(human.boneCount == 14 && MV_IS_NULL(human.jointIds[0]));
    for (k = 0; k < 14; ++k)
    {
        mass += mvBody_GetMass(human.bodyIds[k]);
        CHECK(mvBody_GetUserData(human.bodyIds[k]) == &tag);
        CHECK(k == 0 || MV_ID_EQUALS(mvJoint_GetBodyB(human.jointIds[k]), human.bodyIds[k]));
    }
    CHECK(near(mass, 80, (mvFloat)1e-3));
    CHECK(mvJoint_GetType(human.jointIds[3]) == mv_sphericalJoint);
    CHECK(mvJoint_GetType(human.jointIds[6]) == mv_revoluteJoint);
    CHECK(mvJoint_GetType(human.jointIds[13]) == mv_revoluteJoint);
    WORKS(mvHuman_SetFrictionTorque(&human, 2));
    CHECK(mvSphericalJoint_GetFriction(human.jointIds[3]) == 2 && mvRevoluteJoint_GetFriction(human.jointIds[7]) == 2);
    WORKS(mvHuman_SetSpring(&human, 3, 1));
    CHECK(mvSphericalJoint_IsSpringEnabled(human.jointIds[3]) && mvRevoluteJoint_GetSpringHertz(human.jointIds[7]) == 3);
    WORKS(mvHuman_SetVelocity(&human, vec(1, 0, 0)));
    WORKS(mvHuman_ApplyLinearImpulse(&human, vec(0, 160, 0)));
    for (k = 0; k < 60; ++k)
    {
        mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
    }
    for (k = 0; k < 14; ++k)
    {
        CHECK(nearVec(mvBody_GetLinearVelocity(human.bodyIds[k]), vec(1, 2, 0), (mvFloat)1e-3));
    }
    FAILS(mv_errorRange, mvHuman_SetFrictionTorque, mvHuman_SetFrictionTorque(&human, -1));
    FAILS(mv_errorNotFinite, mvHuman_SetSpring, mvHuman_SetSpring(&human, (mvFloat)NAN, 1));
    FAILS(mv_errorNull, mvHuman_SetVelocity, mvHuman_SetVelocity(NULL, vec(0, 0, 0)));
    bad = human;
    bad.boneCount = 1000;
    FAILS(mv_errorRange, mvHuman_ApplyLinearImpulse, mvHuman_ApplyLinearImpulse(&bad, vec(0, 0, 0)));
    FAILS(mv_errorRange, mvDestroyHuman, mvDestroyHuman(&bad));

    mvDestroyBody(human.bodyIds[13]);
    FAILS(mv_errorStale, mvHuman_SetFrictionTorque, mvHuman_SetFrictionTorque(&human, 1));
    WORKS(mvDestroyHuman(&human));
    CHECK(mvWorld_GetCounters(world).bodyCount == 0 && mvWorld_GetCounters(world).jointCount == 0);
    mvDestroyWorld(world);
    return done("human");
}
