/* What goes wrong is told, and changes nothing. */
#include "merev.h"

#include <stdio.h>

static int told = 0;

static void listen(const char* message)
{
    printf("  log: %s\n", message);
    told += 1;
}

/* The code of the latest failure, printed with its sentence. */
static int check(int expected)
{
    int code = mvGetLastError();
    printf("  code %d: %s\n", code, mvGetLastErrorMessage());
    return code == expected ? 0 : 1;
}

int main(void)
{
    mvWorldDef worldDef = mvDefaultWorldDef(), empty = { 0 };
    mvBodyDef bodyDef = mvDefaultBodyDef();
    mvWorldId world;
    mvBodyId body;
    int wrong = 0;

    printf("A definition that was not made by its function:\n");
    world = mvCreateWorld(&empty);
    wrong += check(mv_errorDefinition) + !MV_IS_NULL(world);

    world = mvCreateWorld(&worldDef);
    printf("A body at no place:\n");
    bodyDef.position.x = (mvFloat)NAN;
    body = mvCreateBody(world, &bodyDef);
    wrong += check(mv_errorNotFinite) + !MV_IS_NULL(body);

    printf("A null id:\n");
    wrong += mvBody_GetMass(body) != 0;
    wrong += check(mv_errorNull);

    bodyDef.position.x = 1;
    body = mvCreateBody(world, &bodyDef);
    printf("A setter keeps the old value when it refuses the new one:\n");
    mvBody_SetLinearDamping(body, -1);
    wrong += check(mv_errorRange) + (mvBody_GetLinearDamping(body) != 0);

    printf("The callback hears it, too:\n");
    mvSetLogFcn(listen);
    mvDestroyBody(body);
    mvBody_SetTransform(body, mvPos_zero, mvQuat_identity);
    wrong += check(mv_errorStale) + (told != 1);

    printf("Asked twice, the code is gone: %d\n", mvGetLastError());
    mvDestroyWorld(world);
    wrong += mvWorld_IsValid(world) || mvGetLastError() != mv_errorNone;
    return wrong;
}
