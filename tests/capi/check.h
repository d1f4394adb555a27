/* The little that C tests need: CHECK counts failures, done() gives the exit code. */
#ifndef MEREV_TEST_CHECK_H
#define MEREV_TEST_CHECK_H

#include "merev.h"

#include <stdio.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                                                       \
    do                                                                                                         \
    {                                                                                                          \
        if (!(condition))                                                                                      \
        {                                                                                                      \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                                    \
            failures += 1;                                                                                     \
        }                                                                                                      \
    } while (0)

/* The statement fails with this code, and says so in a sentence that names the function. */
#define FAILS(code, function, statement)                                                                       \
    do                                                                                                         \
    {                                                                                                          \
        int got;                                                                                               \
        mvGetLastError();                                                                                      \
        statement;                                                                                             \
        got = mvGetLastError();                                                                                \
        if (got != (code) || strncmp(mvGetLastErrorMessage(), #function ": ", sizeof #function + 1) != 0)      \
        {                                                                                                      \
            fprintf(stderr, "%s:%d: %s: code %d instead of %d (%s)\n", __FILE__, __LINE__, #statement, got,    \
                    (int)(code), mvGetLastErrorMessage());                                                     \
            failures += 1;                                                                                     \
        }                                                                                                      \
    } while (0)

/* The statement does not fail. */
#define WORKS(statement)                                                                                       \
    do                                                                                                         \
    {                                                                                                          \
        int got;                                                                                               \
        mvGetLastError();                                                                                      \
        statement;                                                                                             \
        got = mvGetLastError();                                                                                \
        if (got != mv_errorNone)                                                                               \
        {                                                                                                      \
            fprintf(stderr, "%s:%d: %s: code %d (%s)\n", __FILE__, __LINE__, #statement, got,                  \
                    mvGetLastErrorMessage());                                                                  \
            failures += 1;                                                                                     \
        }                                                                                                      \
    } while (0)

static inline bool near(mvFloat a, mvFloat b, mvFloat tolerance)
{
    return mvAbsFloat(a - b) <= tolerance;
}

static inline bool nearVec(mvVec3 a, mvVec3 b, mvFloat tolerance)
{
    return mvDistance(a, b) <= tolerance;
}

static inline mvVec3 vec(mvFloat x, mvFloat y, mvFloat z)
{
    mvVec3 v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

static inline mvPos pos(mvFloat x, mvFloat y, mvFloat z)
{
    return mvToPos(vec(x, y, z));
}

static int done(const char* name)
{
    if (mvGetWorldCount() != 0)
    {
        fprintf(stderr, "%s: a world was left behind\n", name);
        failures += 1;
    }
    printf("%s: %s\n", name, failures == 0 ? "ok" : "FAILED");
    return failures == 0 ? 0 : 1;
}

#endif
