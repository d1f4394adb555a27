
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
static const mvJointId mv_nullJointId = MV_NULL_ID;
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

/** Pack a joint id into an integer; 0 is null. */
MV_INLINE uint64_t mvStoreJointId(mvJointId id)
{
    return (uint64_t)(uint32_t)id.index1 << 32 | (uint64_t)id.world0 << 16 | (uint64_t)id.generation;
}

/** Unpack a joint id. */
MV_INLINE mvJointId mvLoadJointId(uint64_t x)
{
    mvJointId id;
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

/* --------------------------------------------------------------------------------------------------------
 * The arrays of a hull
 * ------------------------------------------------------------------------------------------------------ */

/** The vertices of a hull, vertexCount of them. */
MV_INLINE const mvHullVertex* mvGetHullVertices(const mvHullData* hull)
{
    return (const mvHullVertex*)((const void*)((const char*)hull + hull->vertexOffset));
}

/** The points of a hull, where its vertices are, vertexCount of them. */
MV_INLINE const mvVec3* mvGetHullPoints(const mvHullData* hull)
{
    return (const mvVec3*)((const void*)((const char*)hull + hull->pointOffset));
}

/** The half-edges of a hull, edgeCount of them. */
MV_INLINE const mvHullHalfEdge* mvGetHullEdges(const mvHullData* hull)
{
    return (const mvHullHalfEdge*)((const void*)((const char*)hull + hull->edgeOffset));
}

/** The faces of a hull, faceCount of them. */
MV_INLINE const mvHullFace* mvGetHullFaces(const mvHullData* hull)
{
    return (const mvHullFace*)((const void*)((const char*)hull + hull->faceOffset));
}

/** The planes of the faces of a hull, faceCount of them. Their normals point outwards. */
MV_INLINE const mvPlane* mvGetHullPlanes(const mvHullData* hull)
{
    return (const mvPlane*)((const void*)((const char*)hull + hull->planeOffset));
}
