/* Two Rust libraries in one program: both work, and a panic of the other one is caught by itself. */
#include "merev.h"

int other_sum(int n);

int main(void)
{
    mvWorldDef def = mvDefaultWorldDef();
    mvWorldId world = mvCreateWorld(&def);
    mvBodyDef bodyDef = mvDefaultBodyDef();
    bodyDef.position.x = (mvFloat)NAN;
    if (!mvWorld_IsValid(world) || MV_IS_NON_NULL(mvCreateBody(world, &bodyDef)))
    {
        return 1;
    }
    if (mvGetLastError() != mv_errorNotFinite || other_sum(4) != 14 || other_sum(0) != -1)
    {
        return 2;
    }
    mvWorld_Step(world, (mvFloat)(1.0 / 60), 4);
    mvDestroyWorld(world);
    return mvGetLastError() == mv_errorNone ? 0 : 3;
}
