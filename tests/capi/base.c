/* Version, hash, error state, log. */
#include "check.h"

static int logged = 0;
static char lastLog[512];

static void listen(const char* message)
{
    logged += 1;
    strncpy(lastLog, message, sizeof lastLog - 1);
    /* A failing call inside the log callback is not logged, so this does not go on for ever. */
    mvDestroyWorld(mv_nullWorldId);
}

static int heardFault(const char* condition, const char* fileName, int lineNumber)
{
    fprintf(stderr, "%s:%d: %s\n", fileName, lineNumber, condition);
    failures += 1;
    return 0;
}

int main(void)
{
    mvVersion version = mvGetVersion();
    const uint8_t bytes[] = { 'm', 'v' };
    uint32_t h;

    CHECK(version.major >= 0 && version.minor >= 0 && version.revision >= 0);
    CHECK(version.major + version.minor + version.revision > 0);
    CHECK(mvGetAbiRevision() == MV_ABI_REVISION);
    CHECK(mvIsDoublePrecision() == (sizeof(mvFloat) == sizeof(double)));

    CHECK(mvHash(MV_HASH_INIT, bytes, 0) == MV_HASH_INIT);
    h = mvHash(MV_HASH_INIT, bytes, 2);
    CHECK(h == ((uint32_t)MV_HASH_INIT * 33u + 'm') * 33u + 'v');
    CHECK(h == mvHash(mvHash(MV_HASH_INIT, bytes, 1), bytes + 1, 1));
    WORKS(mvHash(1, NULL, 0));
    FAILS(mv_errorNull, mvHash, CHECK(mvHash(1, NULL, 1) == 0));
    FAILS(mv_errorRange, mvHash, CHECK(mvHash(1, bytes, -1) == 0));

    /* Nothing has failed since: the code was taken, the message stays. */
    CHECK(mvGetLastError() == mv_errorNone);
    CHECK(strlen(mvGetLastErrorMessage()) > 10);

    mvSetAssertFcn(heardFault);
    mvSetLogFcn(listen);
    FAILS(mv_errorRange, mvHash, mvHash(1, bytes, -7));
    CHECK(logged == 1);
    CHECK(strncmp(lastLog, "mvHash: ", 8) == 0 && strstr(lastLog, "-7") != NULL);
    WORKS(mvHash(1, bytes, 2));
    CHECK(logged == 1);
    mvSetLogFcn(NULL);
    FAILS(mv_errorRange, mvHash, mvHash(1, bytes, -1));
    CHECK(logged == 1);
    mvSetAssertFcn(NULL);

    /* What the library holds grows with a world and falls again. */
    {
        mvWorldDef def = mvDefaultWorldDef();
        int64_t before = mvGetByteCount();
        mvWorldId world = mvCreateWorld(&def);
        CHECK(mvGetByteCount() > before);
        mvDestroyWorld(world);
        CHECK(mvGetByteCount() == before);
    }
    return done("base");
}
