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


/**
 * The revision of the binary interface that this header describes. A program may compare it with
 * mvGetAbiRevision() to learn whether the library that was loaded is the one it was compiled for.
 */
#define MV_ABI_REVISION 1

/**
 * The start value of mvHash().
 */
#define MV_HASH_INIT 5381

/**
 * A version by the rules of semver.org.
 */
typedef struct mvVersion {
    /**
     * Changes when programs have to be changed.
     */
    int major;
    /**
     * Changes with new features.
     */
    int minor;
    /**
     * Changes with repairs.
     */
    int revision;
} mvVersion;

/**
 * The kind of a failure: one of the mv_error... constants. Numbers are never reused.
 */
typedef int32_t mvErrorCode;

/**
 * Hears the message of every failing call, in UTF-8, on the thread that made the call. The message is valid
 * during the callback only.
 */
typedef void (*mvLogFcn)(const char *message);

/**
 * Hears of internal faults: what was violated and where, in UTF-8, valid during the callback only. The return
 * value is reserved: return 0.
 */
typedef int (*mvAssertFcn)(const char *condition, const char *fileName, int lineNumber);

/**
 * A vector or point in three dimensions.
 */
typedef struct mvVec3 {
    mvFloat x;
    mvFloat y;
    mvFloat z;
} mvVec3;

/**
 * A rotation as a unit quaternion: vector part v, scalar part s. The identity is v = 0, s = 1.
 */
typedef struct mvQuat {
    mvVec3 v;
    mvFloat s;
} mvQuat;

/**
 * A rigid placement: rotate by q, then shift by p.
 */
typedef struct mvTransform {
    mvVec3 p;
    mvQuat q;
} mvTransform;

/**
 * A 3 by 3 matrix, by columns.
 */
typedef struct mvMatrix3 {
    mvVec3 cx;
    mvVec3 cy;
    mvVec3 cz;
} mvMatrix3;

/**
 * An axis-aligned box.
 */
typedef struct mvAABB {
    /**
     * The least corner.
     */
    mvVec3 lowerBound;
    /**
     * The greatest corner.
     */
    mvVec3 upperBound;
} mvAABB;

/**
 * A plane: the points whose dot product with the unit normal equals the offset. The distance of a point from
 * it is dot(normal, point) - offset, positive on the side the normal points to.
 */
typedef struct mvPlane {
    mvVec3 normal;
    mvFloat offset;
} mvPlane;

/**
 * A position in the world. A type of its own, so that world positions can get more digits than everything
 * else without a change to programs: convert with mvToPos() and mvToVec3(), subtract with mvSubPos().
 */
typedef struct mvPos {
    mvFloat x;
    mvFloat y;
    mvFloat z;
} mvPos;

/**
 * A rigid placement in the world: rotate by q, then shift to p.
 */
typedef struct mvWorldTransform {
    mvPos p;
    mvQuat q;
} mvWorldTransform;

/**
 * Cosine and sine of one angle.
 */
typedef struct mvCosSin {
    mvFloat cosine;
    mvFloat sine;
} mvCosSin;

/**
 * The closest points of two segments or lines.
 */
typedef struct mvSegmentDistanceResult {
    /**
     * The closest point on the first.
     */
    mvVec3 point1;
    /**
     * Where it lies, as a fraction of the first's direction.
     */
    mvFloat fraction1;
    /**
     * The closest point on the second.
     */
    mvVec3 point2;
    /**
     * Where it lies, as a fraction of the second's direction.
     */
    mvFloat fraction2;
} mvSegmentDistanceResult;

/**
 * A vector or point in two dimensions.
 */
typedef struct mvVec2 {
    mvFloat x;
    mvFloat y;
} mvVec2;

/**
 * A world. Zero is null.
 */
typedef struct mvWorldId {
    /**
     * The place among the worlds, counted from 1; 0 is null.
     */
    uint16_t index1;
    /**
     * How often that place has been used.
     */
    uint16_t generation;
} mvWorldId;

/**
 * A body. Zero is null.
 */
typedef struct mvBodyId {
    /**
     * The place among the bodies of its world, counted from 1; 0 is null.
     */
    int32_t index1;
    /**
     * The place of its world among the worlds, counted from 0.
     */
    uint16_t world0;
    /**
     * How often that place has been used.
     */
    uint16_t generation;
} mvBodyId;

/**
 * A shape attached to a body. Zero is null.
 */
typedef struct mvShapeId {
    /**
     * The place among the shapes of its world, counted from 1; 0 is null.
     */
    int32_t index1;
    /**
     * The place of its world among the worlds, counted from 0.
     */
    uint16_t world0;
    /**
     * How often that place has been used.
     */
    uint16_t generation;
} mvShapeId;

/**
 * A contact of two shapes: from the step in which their boxes meet to the one in which they part. Zero is null.
 */
typedef struct mvContactId {
    /**
     * The place among the contacts of its world, counted from 1; 0 is null.
     */
    int32_t index1;
    /**
     * The place of its world among the worlds, counted from 0.
     */
    uint16_t world0;
    /**
     * Zero.
     */
    int16_t padding;
    /**
     * How often that place has been used.
     */
    uint32_t generation;
} mvContactId;

/**
 * No call of this thread has failed since the last mvGetLastError().
 */
#define mv_errorNone 0

/**
 * An id or a pointer is null where one is needed.
 */
#define mv_errorNull 1

/**
 * The id's object was destroyed.
 */
#define mv_errorStale 2

/**
 * The id belongs to another world.
 */
#define mv_errorForeign 3

/**
 * A definition was not made by its mvDefault...Def() function, or by that of another build of the library.
 */
#define mv_errorDefinition 4

/**
 * A number is NaN or infinite.
 */
#define mv_errorNotFinite 5

/**
 * A value lies outside its stated range.
 */
#define mv_errorRange 6

/**
 * Geometry without volume, direction or size.
 */
#define mv_errorDegenerate 7

/**
 * The world is inside a step or a query of this thread: a callback must not change it.
 */
#define mv_errorLocked 8

/**
 * Another thread is using the world.
 */
#define mv_errorBusy 9

/**
 * A stated capacity is exhausted.
 */
#define mv_errorCapacity 10

/**
 * A choice that exists but is not built into this version.
 */
#define mv_errorUnsupported 11

/**
 * An internal fault was caught earlier; the world can only be destroyed.
 */
#define mv_errorFaulted 12

/**
 * An internal fault was caught in this call. Please report it with the message.
 */
#define mv_errorInternal 13

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * Get the version of the library.
 */
MV_API mvVersion mvGetVersion(void);

/**
 * Get the revision of the library's binary interface: layouts of structs and signatures of functions. It
 * equals MV_ABI_REVISION of the header that belongs to the library.
 */
MV_API int32_t mvGetAbiRevision(void);

/**
 * Whether the library computes in double precision: whether its mvFloat is a double. A program must define
 * MV_DOUBLE_PRECISION, before it includes this header, exactly when this is true.
 */
MV_API bool mvIsDoublePrecision(void);

/**
 * Hash bytes, for tests of determinism: h becomes 33 h + byte, modulo 2 to the power of 32.
 *
 * @param hash the hash of what went before; MV_HASH_INIT at the start
 * @param data the bytes; may be null when count is 0
 * @param count the number of bytes, not negative
 * @return the hash; 0 for bad arguments
 */
MV_API uint32_t mvHash(uint32_t hash, const uint8_t *data, int count);

/**
 * Get the code of the latest failing call of this thread, and clear it.
 *
 * @return one of the mv_error... constants; mv_errorNone when no call of this thread has failed since the last
 * time this was asked.
 */
MV_API
mvErrorCode mvGetLastError(void);

/**
 * Get the sentence of the latest failing call of this thread. mvGetLastError() does not clear it.
 *
 * @return UTF-8 that says what was wrong and what would be right, empty when nothing has failed yet; never
 * null. Valid until the next failing call of this thread, or its end.
 */
MV_API const char *mvGetLastErrorMessage(void);

/**
 * Set the callback that hears of every failing call, on all threads.
 *
 * The callback may call the library; failures of those calls are not logged.
 * @param logFcn the callback, or null for silence (the default)
 */
MV_API void mvSetLogFcn(mvLogFcn logFcn);

/**
 * Set the callback that hears of internal faults, that is, of bugs of this library.
 *
 * The faulty call returns mv_errorInternal whether or not there is a callback; nothing is aborted.
 * @param assertFcn the callback, or null for none (the default)
 */
MV_API void mvSetAssertFcn(mvAssertFcn assertFcn);

/**
 * Is this number finite: neither NaN nor infinite?
 */
MV_API bool mvIsValidFloat(mvFloat a);

/**
 * Are all components finite?
 */
MV_API bool mvIsValidVec3(mvVec3 a);

/**
 * Is this a finite quaternion of length 1 (to 1 in 1000)?
 */
MV_API bool mvIsValidQuat(mvQuat q);

/**
 * Is the position finite and the rotation valid?
 */
MV_API bool mvIsValidTransform(mvTransform a);

/**
 * Are all components finite?
 */
MV_API bool mvIsValidMatrix3(mvMatrix3 a);

/**
 * Are both corners finite, and the lower one not above the upper one?
 */
MV_API bool mvIsValidAABB(mvAABB a);

/**
 * Are all coordinates finite and within the greatest that the library accepts, 1e9?
 */
MV_API bool mvIsBoundedAABB(mvAABB a);

/**
 * Is this box valid and bounded?
 */
MV_API bool mvIsSaneAABB(mvAABB a);

/**
 * Is this plane finite, with a normal of length 1 (to 1 in 1000)?
 */
MV_API bool mvIsValidPlane(mvPlane a);

/**
 * Is this position finite?
 */
MV_API bool mvIsValidPosition(mvPos p);

/**
 * Is the position finite and the rotation valid?
 */
MV_API bool mvIsValidWorldTransform(mvWorldTransform t);

/**
 * Get the angle of the point (x, y) seen from the origin, with the same bits on every platform.
 *
 * @return the angle in radians, from -pi to pi; 0 for (0, 0) and for bad arguments
 * @note Errors: mv_errorNotFinite.
 */
MV_API mvFloat mvAtan2(mvFloat y, mvFloat x);

/**
 * Get cosine and sine of an angle, with the same bits on every platform.
 *
 * @param radians the angle, any finite number
 * @return cosine and sine; those of 0 for bad arguments
 * @note Errors: mv_errorNotFinite.
 */
MV_API mvCosSin mvComputeCosSin(mvFloat radians);

/**
 * Get the rotation of a rotation matrix.
 *
 * @param m a rotation matrix: orthonormal columns, determinant 1 (to 1 in 100)
 * @return the unit quaternion; the identity for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange when m is no rotation.
 */
MV_API mvQuat mvMakeQuatFromMatrix(const mvMatrix3 *m);

/**
 * Get the least rotation that turns one direction into another.
 *
 * @param v1 the direction to turn, of length 1
 * @param v2 the direction to reach, of length 1
 * @return the rotation; for opposite directions one of the half turns that do it; the identity for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorDegenerate when a vector is not of length 1 (to 1 in 1000).
 */
MV_API
mvQuat mvComputeQuatBetweenUnitVectors(mvVec3 v1,
                                              mvVec3 v2);

/**
 * Get the inertia of a point mass, about the origin.
 *
 * Add it to an inertia about the centre of mass to get that about a point at the distance of origin.
 * @param mass the mass [kg], not negative
 * @param origin where the mass is [m]
 * @return the inertia [kg m^2]; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API mvMatrix3 mvSteiner(mvFloat mass, mvVec3 origin);

/**
 * Get the point of a segment closest to a target.
 *
 * @param a the start of the segment
 * @param b the end of the segment; may equal a
 * @param q the target
 * @return the closest point; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API mvVec3 mvPointToSegmentDistance(mvVec3 a, mvVec3 b, mvVec3 q);

/**
 * Get the closest points of two infinite lines.
 *
 * @param p1 a point of the first line
 * @param d1 the first line's direction, of any length but 0
 * @param p2 a point of the second line
 * @param d2 the second line's direction, of any length but 0
 * @return the closest points; for parallel lines the first is p1; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate for a direction without length.
 */
MV_API
mvSegmentDistanceResult mvLineDistance(mvVec3 p1,
                                              mvVec3 d1,
                                              mvVec3 p2,
                                              mvVec3 d2);

/**
 * Get the closest points of two segments.
 *
 * @param p1 the start of the first segment
 * @param q1 the end of the first segment; may equal p1
 * @param p2 the start of the second segment
 * @param q2 the end of the second segment; may equal p2
 * @return the closest points; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvSegmentDistanceResult mvSegmentDistance(mvVec3 p1,
                                                 mvVec3 q1,
                                                 mvVec3 p2,
                                                 mvVec3 q2);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus


/* --------------------------------------------------------------------------------------------------------
 * Null ids, comparing ids, packing ids into integers
 * ------------------------------------------------------------------------------------------------------ */

/** Initialises an id of any type to null. */
#ifdef __cplusplus
#define MV_NULL_ID {}
#else
#define MV_NULL_ID { 0 }
#endif

static const mvWorldId mv_nullWorldId = MV_NULL_ID;
static const mvBodyId mv_nullBodyId = MV_NULL_ID;
static const mvShapeId mv_nullShapeId = MV_NULL_ID;
static const mvContactId mv_nullContactId = MV_NULL_ID;

/** Whether an id of any type is null. */
#define MV_IS_NULL(id) ((id).index1 == 0)

/** Whether an id of any type is not null. */
#define MV_IS_NON_NULL(id) ((id).index1 != 0)

/** Whether two ids of one type, not that of worlds, are the same. */
#define MV_ID_EQUALS(id1, id2) \
    ((id1).index1 == (id2).index1 && (id1).world0 == (id2).world0 && (id1).generation == (id2).generation)

/** Pack a world id into an integer; 0 is null. */
MV_INLINE uint32_t mvStoreWorldId(mvWorldId id)
{
    return (uint32_t)id.index1 << 16 | (uint32_t)id.generation;
}

/** Unpack a world id. */
MV_INLINE mvWorldId mvLoadWorldId(uint32_t x)
{
    mvWorldId id;
    id.index1 = (uint16_t)(x >> 16);
    id.generation = (uint16_t)(x & 0xffffu);
    return id;
}

/** Pack a body id into an integer; 0 is null. */
MV_INLINE uint64_t mvStoreBodyId(mvBodyId id)
{
    return (uint64_t)(uint32_t)id.index1 << 32 | (uint64_t)id.world0 << 16 | (uint64_t)id.generation;
}

/** Unpack a body id. */
MV_INLINE mvBodyId mvLoadBodyId(uint64_t x)
{
    mvBodyId id;
    id.index1 = (int32_t)(uint32_t)(x >> 32);
    id.world0 = (uint16_t)(x >> 16 & 0xffffu);
    id.generation = (uint16_t)(x & 0xffffu);
    return id;
}

/** Pack a shape id into an integer; 0 is null. */
MV_INLINE uint64_t mvStoreShapeId(mvShapeId id)
{
    return (uint64_t)(uint32_t)id.index1 << 32 | (uint64_t)id.world0 << 16 | (uint64_t)id.generation;
}

/** Unpack a shape id. */
MV_INLINE mvShapeId mvLoadShapeId(uint64_t x)
{
    mvShapeId id;
    id.index1 = (int32_t)(uint32_t)(x >> 32);
    id.world0 = (uint16_t)(x >> 16 & 0xffffu);
    id.generation = (uint16_t)(x & 0xffffu);
    return id;
}

/** Pack a contact id into three integers; zeros are null. */
MV_INLINE void mvStoreContactId(mvContactId id, uint32_t values[3])
{
    values[0] = (uint32_t)id.index1;
    values[1] = (uint32_t)id.world0;
    values[2] = id.generation;
}

/** Unpack a contact id. */
MV_INLINE mvContactId mvLoadContactId(const uint32_t values[3])
{
    mvContactId id;
    id.index1 = (int32_t)values[0];
    id.world0 = (uint16_t)(values[1] & 0xffffu);
    id.padding = 0;
    id.generation = values[2];
    return id;
}

/* --------------------------------------------------------------------------------------------------------
 * Scalars
 *
 * The mathematics from here to the end checks nothing: a number that is not finite stays so, and the next
 * call that takes it refuses it.
 * ------------------------------------------------------------------------------------------------------ */

/** Pi. */
#define MV_PI ((mvFloat)3.14159265358979323846)

/** Multiply degrees by this to get radians. */
#define MV_DEG_TO_RAD ((mvFloat)0.01745329251994329577)

/** Multiply radians by this to get degrees. */
#define MV_RAD_TO_DEG ((mvFloat)57.2957795130823208768)

/** The least magnitude that mvSafeScale() leaves. */
#define MV_MIN_SCALE ((mvFloat)0.01)

#ifdef MV_DOUBLE_PRECISION
#define MV_FLOAT_EPSILON DBL_EPSILON
#define MV_FLOAT_MIN DBL_MIN
#define MV_FLOAT_MAX DBL_MAX
#define MV_SQRT(x) sqrt(x)
#define MV_REMAINDER(x, y) remainder((x), (y))
#define MV_NEXT_AFTER(x, y) nextafter((x), (y))
#else
#define MV_FLOAT_EPSILON FLT_EPSILON
#define MV_FLOAT_MIN FLT_MIN
#define MV_FLOAT_MAX FLT_MAX
#define MV_SQRT(x) sqrtf(x)
#define MV_REMAINDER(x, y) remainderf((x), (y))
#define MV_NEXT_AFTER(x, y) nextafterf((x), (y))
#endif

/** The lesser of two integers. */
MV_INLINE int mvMinInt(int a, int b)
{
    return b < a ? b : a;
}

/** The greater of two integers. */
MV_INLINE int mvMaxInt(int a, int b)
{
    return a < b ? b : a;
}

/** The integer of [lower, upper] closest to a. */
MV_INLINE int mvClampInt(int a, int lower, int upper)
{
    return mvMaxInt(lower, mvMinInt(a, upper));
}

/** |a| */
MV_INLINE mvFloat mvAbsFloat(mvFloat a)
{
    return a < 0 ? -a : a;
}

/** The lesser of two numbers. */
MV_INLINE mvFloat mvMinFloat(mvFloat a, mvFloat b)
{
    return b < a ? b : a;
}

/** The greater of two numbers. */
MV_INLINE mvFloat mvMaxFloat(mvFloat a, mvFloat b)
{
    return a < b ? b : a;
}

/** The number of [lower, upper] closest to a. */
MV_INLINE mvFloat mvClampFloat(mvFloat a, mvFloat lower, mvFloat upper)
{
    return mvMaxFloat(lower, mvMinFloat(a, upper));
}

/** The number at fraction alpha of the way from a to b. */
MV_INLINE mvFloat mvLerpFloat(mvFloat a, mvFloat b, mvFloat alpha)
{
    return (1 - alpha) * a + alpha * b;
}

/** The sine of an angle; the same bits on every platform. */
MV_INLINE mvFloat mvSin(mvFloat radians)
{
    return mvComputeCosSin(radians).sine;
}

/** The cosine of an angle; the same bits on every platform. */
MV_INLINE mvFloat mvCos(mvFloat radians)
{
    return mvComputeCosSin(radians).cosine;
}

/** The same angle between -pi and pi. */
MV_INLINE mvFloat mvUnwindAngle(mvFloat radians)
{
    return MV_REMAINDER(radians, 2 * MV_PI);
}

/* --------------------------------------------------------------------------------------------------------
 * Vectors
 * ------------------------------------------------------------------------------------------------------ */

static const mvVec3 mvVec3_zero = { 0, 0, 0 };
static const mvVec3 mvVec3_one = { 1, 1, 1 };
static const mvVec3 mvVec3_axisX = { 1, 0, 0 };
static const mvVec3 mvVec3_axisY = { 0, 1, 0 };
static const mvVec3 mvVec3_axisZ = { 0, 0, 1 };

/** a + b */
MV_INLINE mvVec3 mvAdd(mvVec3 a, mvVec3 b)
{
    mvVec3 r = { a.x + b.x, a.y + b.y, a.z + b.z };
    return r;
}

/** a - b */
MV_INLINE mvVec3 mvSub(mvVec3 a, mvVec3 b)
{
    mvVec3 r = { a.x - b.x, a.y - b.y, a.z - b.z };
    return r;
}

/** The products of the components. */
MV_INLINE mvVec3 mvMul(mvVec3 a, mvVec3 b)
{
    mvVec3 r = { a.x * b.x, a.y * b.y, a.z * b.z };
    return r;
}

/** -a */
MV_INLINE mvVec3 mvNeg(mvVec3 a)
{
    mvVec3 r = { -a.x, -a.y, -a.z };
    return r;
}

/** The dot product. */
MV_INLINE mvFloat mvDot(mvVec3 a, mvVec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** The cross product. */
MV_INLINE mvVec3 mvCross(mvVec3 a, mvVec3 b)
{
    mvVec3 r = { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
    return r;
}

/** The square of the length. */
MV_INLINE mvFloat mvLengthSquared(mvVec3 v)
{
    return mvDot(v, v);
}

/** The length. */
MV_INLINE mvFloat mvLength(mvVec3 v)
{
    return MV_SQRT(mvDot(v, v));
}

/** The square of the distance of two points. */
MV_INLINE mvFloat mvDistanceSquared(mvVec3 a, mvVec3 b)
{
    return mvLengthSquared(mvSub(b, a));
}

/** The distance of two points. */
MV_INLINE mvFloat mvDistance(mvVec3 a, mvVec3 b)
{
    return mvLength(mvSub(b, a));
}

/** s * a */
MV_INLINE mvVec3 mvMulSV(mvFloat s, mvVec3 a)
{
    mvVec3 r = { s * a.x, s * a.y, s * a.z };
    return r;
}

/** a + s * b */
MV_INLINE mvVec3 mvMulAdd(mvVec3 a, mvFloat s, mvVec3 b)
{
    return mvAdd(a, mvMulSV(s, b));
}

/** a - s * b */
MV_INLINE mvVec3 mvMulSub(mvVec3 a, mvFloat s, mvVec3 b)
{
    return mvSub(a, mvMulSV(s, b));
}

/** s * a + t * b */
MV_INLINE mvVec3 mvBlend2(mvFloat s, mvVec3 a, mvFloat t, mvVec3 b)
{
    return mvAdd(mvMulSV(s, a), mvMulSV(t, b));
}

/** The point at fraction alpha of the way from a to b. */
MV_INLINE mvVec3 mvLerp(mvVec3 a, mvVec3 b, mvFloat alpha)
{
    return mvBlend2(1 - alpha, a, alpha, b);
}

/** The vector of length 1 with this direction; zero where the vector is too short to have one. */
MV_INLINE mvVec3 mvNormalize(mvVec3 v)
{
    mvFloat squared = mvLengthSquared(v);
    return squared > 1000 * MV_FLOAT_MIN ? mvMulSV(1 / MV_SQRT(squared), v) : mvVec3_zero;
}

/** Length and direction in one; the direction is zero where the vector is too short to have one. */
MV_INLINE mvVec3 mvGetLengthAndNormalize(mvFloat* length, mvVec3 v)
{
    *length = mvLength(v);
    return mvNormalize(v);
}

/** A vector of length 1 at a right angle to the vector v, which must not be zero. */
MV_INLINE mvVec3 mvPerp(mvVec3 v)
{
    /* Cross with the axis that v has least of. */
    mvFloat x = mvAbsFloat(v.x), y = mvAbsFloat(v.y), z = mvAbsFloat(v.z);
    mvVec3 axis = x <= y && x <= z ? mvVec3_axisX : y <= z ? mvVec3_axisY : mvVec3_axisZ;
    return mvNormalize(mvCross(v, axis));
}

/** Is the length 1 up to rounding? */
MV_INLINE bool mvIsNormalized(mvVec3 v)
{
    return mvAbsFloat(1 - mvLengthSquared(v)) < 100 * MV_FLOAT_EPSILON;
}

/** The magnitudes of the components. */
MV_INLINE mvVec3 mvAbs(mvVec3 v)
{
    mvVec3 r = { mvAbsFloat(v.x), mvAbsFloat(v.y), mvAbsFloat(v.z) };
    return r;
}

/** The signs of the components: 1 or -1; that of zero is 1. */
MV_INLINE mvVec3 mvSign(mvVec3 v)
{
    mvVec3 r;
    r.x = (mvFloat)(v.x < 0 ? -1 : 1);
    r.y = (mvFloat)(v.y < 0 ? -1 : 1);
    r.z = (mvFloat)(v.z < 0 ? -1 : 1);
    return r;
}

/** The lesser components. */
MV_INLINE mvVec3 mvMin(mvVec3 a, mvVec3 b)
{
    mvVec3 r = { mvMinFloat(a.x, b.x), mvMinFloat(a.y, b.y), mvMinFloat(a.z, b.z) };
    return r;
}

/** The greater components. */
MV_INLINE mvVec3 mvMax(mvVec3 a, mvVec3 b)
{
    mvVec3 r = { mvMaxFloat(a.x, b.x), mvMaxFloat(a.y, b.y), mvMaxFloat(a.z, b.z) };
    return r;
}

/** The point of the box [lower, upper] closest to v. */
MV_INLINE mvVec3 mvClamp(mvVec3 v, mvVec3 lower, mvVec3 upper)
{
    return mvMax(lower, mvMin(v, upper));
}

/** The scale with every component moved away from zero to at least MV_MIN_SCALE; signs stay. */
MV_INLINE mvVec3 mvSafeScale(mvVec3 scale)
{
    mvVec3 least = { MV_MIN_SCALE, MV_MIN_SCALE, MV_MIN_SCALE };
    return mvMul(mvSign(scale), mvMax(mvAbs(scale), least));
}

/* --------------------------------------------------------------------------------------------------------
 * Rotations
 * ------------------------------------------------------------------------------------------------------ */

static const mvQuat mvQuat_identity = { { 0, 0, 0 }, 1 };

/** The dot product of two quaternions: negative when they lie on opposite sides of the double cover. */
MV_INLINE mvFloat mvDotQuat(mvQuat a, mvQuat b)
{
    return mvDot(a.v, b.v) + a.s * b.s;
}

/** Is the length 1 up to rounding? */
MV_INLINE bool mvIsNormalizedQuat(mvQuat q)
{
    return mvAbsFloat(1 - mvDotQuat(q, q)) < 20 * MV_FLOAT_EPSILON;
}

/** The quaternion scaled to length 1; the identity where it is too short. */
MV_INLINE mvQuat mvNormalizeQuat(mvQuat q)
{
    mvFloat squared = mvDotQuat(q, q);
    if (squared > 1000 * MV_FLOAT_MIN)
    {
        mvFloat k = 1 / MV_SQRT(squared);
        mvQuat r = { { k * q.v.x, k * q.v.y, k * q.v.z }, k * q.s };
        return r;
    }
    return mvQuat_identity;
}

/** The inverse rotation. */
MV_INLINE mvQuat mvConjugate(mvQuat q)
{
    mvQuat r = { { -q.v.x, -q.v.y, -q.v.z }, q.s };
    return r;
}

/** The same rotation, with all parts negated. */
MV_INLINE mvQuat mvNegateQuat(mvQuat q)
{
    mvQuat r = { { -q.v.x, -q.v.y, -q.v.z }, -q.s };
    return r;
}

/** Rotate by b, then by a. */
MV_INLINE mvQuat mvMulQuat(mvQuat a, mvQuat b)
{
    mvQuat r;
    r.v = mvAdd(mvCross(a.v, b.v), mvBlend2(a.s, b.v, b.s, a.v));
    r.s = a.s * b.s - mvDot(a.v, b.v);
    return r;
}

/** Rotate by b, then by the inverse of a: b seen from a. */
MV_INLINE mvQuat mvInvMulQuat(mvQuat a, mvQuat b)
{
    return mvMulQuat(mvConjugate(a), b);
}

/** Rotate a vector. */
MV_INLINE mvVec3 mvRotateVector(mvQuat q, mvVec3 v)
{
    mvVec3 t = mvMulSV(2, mvCross(q.v, v));
    return mvAdd(mvMulAdd(v, q.s, t), mvCross(q.v, t));
}

/** Rotate a vector back. */
MV_INLINE mvVec3 mvInvRotateVector(mvQuat q, mvVec3 v)
{
    return mvRotateVector(mvConjugate(q), v);
}

/** The rotation by an angle about an axis of length 1. */
MV_INLINE mvQuat mvMakeQuatFromAxisAngle(mvVec3 axis, mvFloat radians)
{
    mvCosSin cs = mvComputeCosSin(radians / 2);
    mvQuat q;
    q.v = mvMulSV(cs.sine, axis);
    q.s = cs.cosine;
    return q;
}

/** The angle of a rotation, 0 to 2 pi. */
MV_INLINE mvFloat mvGetQuatAngle(mvQuat q)
{
    return 2 * mvAtan2(mvLength(q.v), q.s);
}

/** The axis of a rotation, zero for the identity, and its angle, 0 to 2 pi. */
MV_INLINE mvVec3 mvGetAxisAngle(mvFloat* radians, mvQuat q)
{
    mvFloat length = mvLength(q.v);
    *radians = 2 * mvAtan2(length, q.s);
    return length > 0 ? mvMulSV(1 / length, q.v) : mvVec3_zero;
}

/** The part of a rotation about the z axis, as an angle from -pi to pi. */
MV_INLINE mvFloat mvGetTwistAngle(mvQuat q)
{
    return 2 * (q.s < 0 ? mvAtan2(-q.v.z, -q.s) : mvAtan2(q.v.z, q.s));
}

/** The angle between the z axis and its image, 0 to pi. */
MV_INLINE mvFloat mvGetSwingAngle(mvQuat q)
{
    mvFloat turned = MV_SQRT(q.v.x * q.v.x + q.v.y * q.v.y);
    mvFloat kept = MV_SQRT(q.v.z * q.v.z + q.s * q.s);
    return 2 * mvAtan2(turned, kept);
}

/** The rotation at about fraction alpha of the shorter way from a to b: blended and normalised. */
MV_INLINE mvQuat mvNLerp(mvQuat a, mvQuat b, mvFloat alpha)
{
    mvQuat q;
    if (mvDotQuat(a, b) < 0)
    {
        a = mvNegateQuat(a);
    }
    q.v = mvLerp(a.v, b.v, alpha);
    q.s = mvLerpFloat(a.s, b.s, alpha);
    return mvNormalizeQuat(q);
}

/* --------------------------------------------------------------------------------------------------------
 * Placements
 * ------------------------------------------------------------------------------------------------------ */

static const mvTransform mvTransform_identity = { { 0, 0, 0 }, { { 0, 0, 0 }, 1 } };

/** A point of the placed frame, seen from outside. */
MV_INLINE mvVec3 mvTransformPoint(mvTransform t, mvVec3 p)
{
    return mvAdd(mvRotateVector(t.q, p), t.p);
}

/** A point given from outside, seen from the placed frame. */
MV_INLINE mvVec3 mvInvTransformPoint(mvTransform t, mvVec3 p)
{
    return mvInvRotateVector(t.q, mvSub(p, t.p));
}

/** Place by b, then by a. */
MV_INLINE mvTransform mvMulTransforms(mvTransform a, mvTransform b)
{
    mvTransform r;
    r.p = mvTransformPoint(a, b.p);
    r.q = mvMulQuat(a.q, b.q);
    return r;
}

/** Placement b seen from placement a. */
MV_INLINE mvTransform mvInvMulTransforms(mvTransform a, mvTransform b)
{
    mvTransform r;
    r.p = mvInvTransformPoint(a, b.p);
    r.q = mvInvMulQuat(a.q, b.q);
    return r;
}

/** The inverse placement. */
MV_INLINE mvTransform mvInvertTransform(mvTransform t)
{
    mvTransform r;
    r.p = mvInvRotateVector(t.q, mvNeg(t.p));
    r.q = mvConjugate(t.q);
    return r;
}

/* --------------------------------------------------------------------------------------------------------
 * World positions and placements
 * ------------------------------------------------------------------------------------------------------ */

static const mvPos mvPos_zero = { 0, 0, 0 };
static const mvWorldTransform mvWorldTransform_identity = { { 0, 0, 0 }, { { 0, 0, 0 }, 1 } };

/** A vector from the world origin as a position. */
MV_INLINE mvPos mvToPos(mvVec3 v)
{
    mvPos r = { v.x, v.y, v.z };
    return r;
}

/** A position as a vector from the world origin; may lose digits. */
MV_INLINE mvVec3 mvToVec3(mvPos p)
{
    mvVec3 r = { p.x, p.y, p.z };
    return r;
}

/** a - b: the vector from b to a. */
MV_INLINE mvVec3 mvSubPos(mvPos a, mvPos b)
{
    mvVec3 r = { a.x - b.x, a.y - b.y, a.z - b.z };
    return r;
}

/** p + d */
MV_INLINE mvPos mvOffsetPos(mvPos p, mvVec3 d)
{
    mvPos r = { p.x + d.x, p.y + d.y, p.z + d.z };
    return r;
}

/** The position at fraction t of the way from a to b. */
MV_INLINE mvPos mvLerpPosition(mvPos a, mvPos b, mvFloat t)
{
    mvPos r = { (1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y, (1 - t) * a.z + t * b.z };
    return r;
}

/** The greatest mvFloat that is not above x. */
MV_INLINE mvFloat mvRoundDownFloat(double x)
{
    mvFloat f = (mvFloat)x;
    return (double)f > x ? MV_NEXT_AFTER(f, -MV_FLOAT_MAX) : f;
}

/** The least mvFloat that is not below x. */
MV_INLINE mvFloat mvRoundUpFloat(double x)
{
    mvFloat f = (mvFloat)x;
    return (double)f < x ? MV_NEXT_AFTER(f, MV_FLOAT_MAX) : f;
}

/** A point of the placed frame as a world position. */
MV_INLINE mvPos mvTransformWorldPoint(mvWorldTransform t, mvVec3 p)
{
    return mvOffsetPos(t.p, mvRotateVector(t.q, p));
}

/** A world position seen from the placed frame. */
MV_INLINE mvVec3 mvInvTransformWorldPoint(mvWorldTransform t, mvPos p)
{
    return mvInvRotateVector(t.q, mvSubPos(p, t.p));
}

/** Placement b seen from placement a. */
MV_INLINE mvTransform mvInvMulWorldTransforms(mvWorldTransform a, mvWorldTransform b)
{
    mvTransform r;
    r.p = mvInvTransformWorldPoint(a, b.p);
    r.q = mvInvMulQuat(a.q, b.q);
    return r;
}

/** Place by b, then by a. */
MV_INLINE mvWorldTransform mvMulWorldTransforms(mvWorldTransform a, mvTransform b)
{
    mvWorldTransform r;
    r.p = mvTransformWorldPoint(a, b.p);
    r.q = mvMulQuat(a.q, b.q);
    return r;
}

/** The placement with its position counted from base. */
MV_INLINE mvTransform mvToRelativeTransform(mvWorldTransform t, mvPos base)
{
    mvTransform r;
    r.p = mvSubPos(t.p, base);
    r.q = t.q;
    return r;
}

/** A placement whose outside is the world. */
MV_INLINE mvWorldTransform mvMakeWorldTransform(mvTransform t)
{
    mvWorldTransform r;
    r.p = mvToPos(t.p);
    r.q = t.q;
    return r;
}

/* --------------------------------------------------------------------------------------------------------
 * Matrices
 * ------------------------------------------------------------------------------------------------------ */

static const mvMatrix3 mvMat3_zero = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
static const mvMatrix3 mvMat3_identity = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

/** m * a */
MV_INLINE mvVec3 mvMulMV(mvMatrix3 m, mvVec3 a)
{
    return mvAdd(mvMulSV(a.x, m.cx), mvBlend2(a.y, m.cy, a.z, m.cz));
}

/** -a */
MV_INLINE mvMatrix3 mvNegateMat3(mvMatrix3 a)
{
    mvMatrix3 r;
    r.cx = mvNeg(a.cx);
    r.cy = mvNeg(a.cy);
    r.cz = mvNeg(a.cz);
    return r;
}

/** a + b */
MV_INLINE mvMatrix3 mvAddMM(mvMatrix3 a, mvMatrix3 b)
{
    mvMatrix3 r;
    r.cx = mvAdd(a.cx, b.cx);
    r.cy = mvAdd(a.cy, b.cy);
    r.cz = mvAdd(a.cz, b.cz);
    return r;
}

/** a - b */
MV_INLINE mvMatrix3 mvSubMM(mvMatrix3 a, mvMatrix3 b)
{
    mvMatrix3 r;
    r.cx = mvSub(a.cx, b.cx);
    r.cy = mvSub(a.cy, b.cy);
    r.cz = mvSub(a.cz, b.cz);
    return r;
}

/** s * a */
MV_INLINE mvMatrix3 mvMulSM(mvFloat s, mvMatrix3 a)
{
    mvMatrix3 r;
    r.cx = mvMulSV(s, a.cx);
    r.cy = mvMulSV(s, a.cy);
    r.cz = mvMulSV(s, a.cz);
    return r;
}

/** a * b */
MV_INLINE mvMatrix3 mvMulMM(mvMatrix3 a, mvMatrix3 b)
{
    mvMatrix3 r;
    r.cx = mvMulMV(a, b.cx);
    r.cy = mvMulMV(a, b.cy);
    r.cz = mvMulMV(a, b.cz);
    return r;
}

/** Rows and columns exchanged. */
MV_INLINE mvMatrix3 mvTranspose(mvMatrix3 m)
{
    mvMatrix3 r = { { m.cx.x, m.cy.x, m.cz.x }, { m.cx.y, m.cy.y, m.cz.y }, { m.cx.z, m.cy.z, m.cz.z } };
    return r;
}

/** The magnitudes of the components. */
MV_INLINE mvMatrix3 mvAbsMatrix3(mvMatrix3 m)
{
    mvMatrix3 r;
    r.cx = mvAbs(m.cx);
    r.cy = mvAbs(m.cy);
    r.cz = mvAbs(m.cz);
    return r;
}

/** The determinant. */
MV_INLINE mvFloat mvDet(mvMatrix3 m)
{
    return mvDot(m.cx, mvCross(m.cy, m.cz));
}

/** The transpose of the inverse; zero where there is no inverse. */
MV_INLINE mvMatrix3 mvInvertT(mvMatrix3 m)
{
    mvFloat det = mvDet(m);
    mvMatrix3 r = mvMat3_zero;
    if (mvAbsFloat(det) > 1000 * MV_FLOAT_MIN)
    {
        r.cx = mvMulSV(1 / det, mvCross(m.cy, m.cz));
        r.cy = mvMulSV(1 / det, mvCross(m.cz, m.cx));
        r.cz = mvMulSV(1 / det, mvCross(m.cx, m.cy));
    }
    return r;
}

/** The inverse; zero where there is none. */
MV_INLINE mvMatrix3 mvInvertMatrix(mvMatrix3 m)
{
    return mvTranspose(mvInvertT(m));
}

/** The vector x with m * x = a; zero where there is no inverse. */
MV_INLINE mvVec3 mvSolve3(mvMatrix3 m, mvVec3 a)
{
    mvMatrix3 t = mvInvertT(m);
    mvVec3 r = { mvDot(t.cx, a), mvDot(t.cy, a), mvDot(t.cz, a) };
    return r;
}

/** The rotation matrix of a rotation: its columns are the rotated axes. */
MV_INLINE mvMatrix3 mvMakeMatrixFromQuat(mvQuat q)
{
    mvMatrix3 r;
    r.cx = mvRotateVector(q, mvVec3_axisX);
    r.cy = mvRotateVector(q, mvVec3_axisY);
    r.cz = mvRotateVector(q, mvVec3_axisZ);
    return r;
}

/* --------------------------------------------------------------------------------------------------------
 * Boxes and planes
 * ------------------------------------------------------------------------------------------------------ */

/** The box around balls of one radius at the points, of which there must be at least one. */
MV_INLINE mvAABB mvMakeAABB(const mvVec3* points, int count, mvFloat radius)
{
    mvVec3 grow = { radius, radius, radius };
    mvAABB r;
    int i;
    r.lowerBound = points[0];
    r.upperBound = points[0];
    for (i = 1; i < count; ++i)
    {
        r.lowerBound = mvMin(r.lowerBound, points[i]);
        r.upperBound = mvMax(r.upperBound, points[i]);
    }
    r.lowerBound = mvSub(r.lowerBound, grow);
    r.upperBound = mvAdd(r.upperBound, grow);
    return r;
}

/** Does a contain all of b? */
MV_INLINE bool mvAABB_Contains(mvAABB a, mvAABB b)
{
    return a.lowerBound.x <= b.lowerBound.x && b.upperBound.x <= a.upperBound.x &&
           a.lowerBound.y <= b.lowerBound.y && b.upperBound.y <= a.upperBound.y &&
           a.lowerBound.z <= b.lowerBound.z && b.upperBound.z <= a.upperBound.z;
}

/** Do the boxes touch or overlap? */
MV_INLINE bool mvAABB_Overlaps(mvAABB a, mvAABB b)
{
    return a.lowerBound.x <= b.upperBound.x && b.lowerBound.x <= a.upperBound.x &&
           a.lowerBound.y <= b.upperBound.y && b.lowerBound.y <= a.upperBound.y &&
           a.lowerBound.z <= b.upperBound.z && b.lowerBound.z <= a.upperBound.z;
}

/** The area of the surface. */
MV_INLINE mvFloat mvAABB_Area(mvAABB a)
{
    mvVec3 d = mvSub(a.upperBound, a.lowerBound);
    return 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
}

/** The middle. */
MV_INLINE mvVec3 mvAABB_Center(mvAABB a)
{
    return mvMulSV((mvFloat)0.5, mvAdd(a.lowerBound, a.upperBound));
}

/** Half the side lengths. */
MV_INLINE mvVec3 mvAABB_Extents(mvAABB a)
{
    return mvMulSV((mvFloat)0.5, mvSub(a.upperBound, a.lowerBound));
}

/** The least box around both. */
MV_INLINE mvAABB mvAABB_Union(mvAABB a, mvAABB b)
{
    mvAABB r;
    r.lowerBound = mvMin(a.lowerBound, b.lowerBound);
    r.upperBound = mvMax(a.upperBound, b.upperBound);
    return r;
}

/** The box grown by a length on every side. */
MV_INLINE mvAABB mvAABB_Inflate(mvAABB a, mvFloat extension)
{
    mvVec3 grow = { extension, extension, extension };
    mvAABB r;
    r.lowerBound = mvSub(a.lowerBound, grow);
    r.upperBound = mvAdd(a.upperBound, grow);
    return r;
}

/** The least box around the placed box. */
MV_INLINE mvAABB mvAABB_Transform(mvTransform t, mvAABB a)
{
    mvVec3 center = mvTransformPoint(t, mvAABB_Center(a));
    mvVec3 extents = mvMulMV(mvAbsMatrix3(mvMakeMatrixFromQuat(t.q)), mvAABB_Extents(a));
    mvAABB r;
    r.lowerBound = mvSub(center, extents);
    r.upperBound = mvAdd(center, extents);
    return r;
}

/** The point of the box closest to a point. */
MV_INLINE mvVec3 mvClosestPointToAABB(mvVec3 point, mvAABB a)
{
    return mvClamp(point, a.lowerBound, a.upperBound);
}

/** The box moved to a world position. */
MV_INLINE mvAABB mvOffsetAABB(mvAABB a, mvPos origin)
{
    mvAABB r;
    r.lowerBound = mvToVec3(mvOffsetPos(origin, a.lowerBound));
    r.upperBound = mvToVec3(mvOffsetPos(origin, a.upperBound));
    return r;
}

/** The plane through a point with a normal of length 1. */
MV_INLINE mvPlane mvMakePlaneFromNormalAndPoint(mvVec3 normal, mvVec3 point)
{
    mvPlane r;
    r.normal = normal;
    r.offset = mvDot(normal, point);
    return r;
}

/** The plane through three points, which turn counter-clockwise seen from where the normal points. */
MV_INLINE mvPlane mvMakePlaneFromPoints(mvVec3 a, mvVec3 b, mvVec3 c)
{
    return mvMakePlaneFromNormalAndPoint(mvNormalize(mvCross(mvSub(b, a), mvSub(c, a))), a);
}

/** The distance of a point from a plane, positive on the side the normal points to. */
MV_INLINE mvFloat mvPlaneSeparation(mvPlane plane, mvVec3 point)
{
    return mvDot(plane.normal, point) - plane.offset;
}

/** The placed plane. */
MV_INLINE mvPlane mvTransformPlane(mvTransform t, mvPlane plane)
{
    mvPlane r;
    r.normal = mvRotateVector(t.q, plane.normal);
    r.offset = plane.offset + mvDot(r.normal, t.p);
    return r;
}

#endif /* MEREV_H */
