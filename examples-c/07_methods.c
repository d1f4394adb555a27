/* One scene by every method that the library has: a stack of five cubes and a box that tumbles freely beside it. For
 * each kind of each choice the table says how far the top of the stack is from where it should be after two seconds,
 * and by what share the energy of the tumbling box has changed. */
#include <math.h>
#include <stdio.h>
#include "merev.h"

typedef const char* NameFcn(int32_t kind);

typedef struct {
    const char* choice;
    NameFcn* name;
    int32_t* (*field)(mvWorldDef* def);
} Choice;

static int32_t* Solver(mvWorldDef* def) { return &def->solver; }
static int32_t* Integrator(mvWorldDef* def) { return &def->integrator; }
static int32_t* BroadPhase(mvWorldDef* def) { return &def->broadPhase; }
static int32_t* NarrowPhase(mvWorldDef* def) { return &def->narrowPhase; }
static int32_t* Gjk(mvWorldDef* def) { return &def->gjk; }
static int32_t* Manifold(mvWorldDef* def) { return &def->manifold; }

static const Choice choices[] = {
    {"solver", mvGetSolverKindName, Solver},
    {"integrator", mvGetIntegratorKindName, Integrator},
    {"broad phase", mvGetBroadPhaseKindName, BroadPhase},
    {"narrow phase", mvGetNarrowPhaseKindName, NarrowPhase},
    {"gjk", mvGetGjkKindName, Gjk},
    {"manifold", mvGetManifoldKindName, Manifold},
};

/* Adds a box of these half side lengths. */
static mvBodyId AddBox(mvWorldId world, mvBodyType type, mvFloat y, mvFloat x, mvVec3 half, mvFloat gravityScale) {
    mvBodyDef bodyDef = mvDefaultBodyDef();
    bodyDef.type = type;
    bodyDef.position.x = x;
    bodyDef.position.y = y;
    bodyDef.gravityScale = gravityScale;
    mvBodyId body = mvCreateBody(world, &bodyDef);
    mvShapeDef shapeDef = mvDefaultShapeDef();
    mvBoxHull box = mvMakeBoxHull(half.x, half.y, half.z);
    mvCreateHullShape(body, &shapeDef, &box.base);
    return body;
}

/* Runs the scene; false where a number stopped being finite. */
static bool Run(const mvWorldDef* def, double* top, double* energy) {
    const mvVec3 ground = {10, (mvFloat)0.5, 10}, cube = {(mvFloat)0.5, (mvFloat)0.5, (mvFloat)0.5};
    const mvVec3 brick = {(mvFloat)0.05, (mvFloat)0.2, (mvFloat)0.45}, spin = {(mvFloat)0.1, 5, (mvFloat)0.1};
    mvWorldId world = mvCreateWorld(def);
    AddBox(world, mv_staticBody, (mvFloat)-0.5, 0, ground, 1);
    mvBodyId last = mv_nullBodyId;
    for (int i = 0; i < 5; ++i) {
        last = AddBox(world, mv_dynamicBody, (mvFloat)0.5 + i, 0, cube, 1);
    }
    mvBodyId tumbler = AddBox(world, mv_dynamicBody, 3, 20, brick, 0);
    mvBody_SetAngularVelocity(tumbler, spin);
    double before = mvBody_GetKineticEnergy(tumbler);
    for (int i = 0; i < 120; ++i) {
        mvWorld_Step(world, (mvFloat)(1 / 60.0), 4);
    }
    *top = mvBody_GetPosition(last).y - 4.5;
    *energy = mvBody_GetKineticEnergy(tumbler) / before - 1;
    mvDestroyWorld(world);
    return isfinite(*top) && isfinite(*energy);
}

int main(void) {
    int failures = 0;
    printf("%-13s %-24s %16s %18s\n", "choice", "kind", "top of stack", "energy of tumbler");
    for (size_t c = 0; c < sizeof choices / sizeof choices[0]; ++c) {
        for (int32_t kind = 1; choices[c].name(kind) != NULL; ++kind) {
            mvWorldDef def = mvDefaultWorldDef();
            def.enableSleep = false;
            *choices[c].field(&def) = kind;
            double top = 0, energy = 0;
            if (!Run(&def, &top, &energy)) {
                printf("%-13s %-24s does not stay finite\n", choices[c].choice, choices[c].name(kind));
                ++failures;
                continue;
            }
            printf("%-13s %-24s %+13.3f mm %+17.1e\n", choices[c].choice, choices[c].name(kind), 1e3 * top, energy);
        }
        mvGetLastError(); /* The number after the last kind has no name. */
    }
    return failures == 0 ? 0 : 1;
}
