/* SPDX-License-Identifier: MIT OR Apache-2.0
 *
 * merev: a rigid-body physics engine.
 *
 * This header is generated from the library's source (xtask header); do not edit it.
 *
 * Conventions
 *   Units are SI: metres, kilograms, seconds, newtons; angles are radians. Frames are right-handed and no axis
 *   is up. A body's origin, which position and rotation describe, and its centre of mass are different points.
 *
 *   Objects are named by ids: small values that are copied freely. An id that is null (zero), whose object was
 *   destroyed, or that belongs to another world is always detected, never followed.
 *
 *   A definition struct comes from its mvDefault...Def() function; change the fields that matter and leave
 *   internalValue alone. A definition that was not made that way is refused.
 *
 * Errors
 *   A call that cannot do what it was asked changes nothing and returns a neutral value: a null id, a null
 *   pointer, zero, false, the identity of a rotation. mvGetLastError() then gives a code and
 *   mvGetLastErrorMessage() the sentence, per thread; mvSetLogFcn() sets a callback that hears of every
 *   failure. Any call with an id can fail with mv_errorNull, mv_errorStale, mv_errorForeign, mv_errorLocked,
 *   mv_errorBusy, mv_errorFaulted and mv_errorInternal; further codes stand at the functions. Functions called
 *   ..._IsValid never fail.
 *
 * Threads
 *   Different worlds are independent of each other. Any number of threads may read one world (get and query) at
 *   once; a call that changes a world beside any other call on the same world fails with mv_errorBusy and
 *   nothing ever waits. Inside a callback the world may be read but not changed (mv_errorLocked).
 *
 * Pointers
 *   A pointer to a definition, a geometry or an array of ids must not be null unless it says so; null is
 *   detected. Everything handed in is copied before the call returns. Strings are UTF-8 and end with a zero.
 *
 * A program that uses a library built in double precision defines MV_DOUBLE_PRECISION before it includes this.
 */
#ifndef MEREV_H
#define MEREV_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Define MEREV_DLL to use the library as a DLL on Windows. */
#if defined(_WIN32) && defined(MEREV_DLL)
#define MV_API __declspec(dllimport)
#else
#define MV_API
#endif

#ifdef __cplusplus
#define MV_INLINE inline
#else
#define MV_INLINE static inline
#endif

/* The scalar of the whole library. */
#ifdef MV_DOUBLE_PRECISION
typedef double mvFloat;
#else
typedef float mvFloat;
#endif
