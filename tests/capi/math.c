/* Every function of the mathematics, inline and exported. */
#include "check.h"

static const mvFloat tiny = (mvFloat)1e-5;

static void scalars(void)
{
    mvCosSin cs = mvComputeCosSin(MV_PI / 6);
    CHECK(mvMinInt(1, 2) == 1 && mvMaxInt(1, 2) == 2);
    CHECK(mvClampInt(5, 1, 3) == 3 && mvClampInt(-5, 1, 3) == 1 && mvClampInt(2, 1, 3) == 2);
    CHECK(mvAbsFloat(-2) == 2 && mvMinFloat(1, 2) == 1 && mvMaxFloat(1, 2) == 2);
    CHECK(mvClampFloat(5, 1, 3) == 3 && mvClampFloat(0, 1, 3) == 1);
    CHECK(mvLerpFloat(2, 4, (mvFloat)0.25) == (mvFloat)2.5);
    CHECK(near(cs.sine, (mvFloat)0.5, tiny) && near(cs.cosine, (mvFloat)0.8660254, tiny));
    CHECK(near(mvSin(MV_PI / 2), 1, tiny) && near(mvCos(MV_PI), -1, tiny));
    CHECK(near(mvAtan2(1, -1), 3 * MV_PI / 4, tiny));
    CHECK(near(mvUnwindAngle(5 * MV_PI / 2), MV_PI / 2, tiny));
    CHECK(near(90 * MV_DEG_TO_RAD, MV_PI / 2, tiny) && near(MV_PI * MV_RAD_TO_DEG, 180, (mvFloat)1e-4));
    CHECK((double)mvRoundDownFloat(0.1) <= 0.1 && (double)mvRoundUpFloat(0.1) >= 0.1);
    CHECK(mvRoundDownFloat(0.5) == (mvFloat)0.5 && mvRoundUpFloat(0.5) == (mvFloat)0.5);
    FAILS(mv_errorNotFinite, mvAtan2, CHECK(mvAtan2((mvFloat)NAN, 1) == 0));
    FAILS(mv_errorNotFinite, mvComputeCosSin, CHECK(mvComputeCosSin((mvFloat)INFINITY).cosine == 1));
}

static void vectors(void)
{
    mvVec3 a = vec(1, 2, 3), b = vec(-2, 0, 4), n;
    mvFloat length;
    CHECK(nearVec(mvAdd(a, b), vec(-1, 2, 7), 0) && nearVec(mvSub(a, b), vec(3, 2, -1), 0));
    CHECK(nearVec(mvMul(a, b), vec(-2, 0, 12), 0) && nearVec(mvNeg(a), vec(-1, -2, -3), 0));
    CHECK(mvDot(a, b) == 10 && nearVec(mvCross(a, b), vec(8, -10, 4), 0));
    CHECK(mvLengthSquared(b) == 20 && near(mvLength(vec(3, 0, 4)), 5, tiny));
    CHECK(mvDistanceSquared(a, b) == 14 && near(mvDistance(vec(1, 1, 1), vec(1, 4, 5)), 5, tiny));
    CHECK(nearVec(mvMulSV(2, a), vec(2, 4, 6), 0) && nearVec(mvMulAdd(a, 2, b), vec(-3, 2, 11), 0));
    CHECK(nearVec(mvMulSub(a, 2, b), vec(5, 2, -5), 0) && nearVec(mvBlend2(2, a, 3, b), vec(-4, 4, 18), 0));
    CHECK(nearVec(mvLerp(a, b, (mvFloat)0.5), vec((mvFloat)-0.5, 1, (mvFloat)3.5), tiny));
    n = mvNormalize(vec(0, 3, 4));
    CHECK(nearVec(n, vec(0, (mvFloat)0.6, (mvFloat)0.8), tiny) && mvIsNormalized(n) && !mvIsNormalized(a));
    CHECK(nearVec(mvNormalize(mvVec3_zero), mvVec3_zero, 0));
    CHECK(nearVec(mvGetLengthAndNormalize(&length, vec(0, 0, -2)), vec(0, 0, -1), tiny) && near(length, 2, tiny));
    CHECK(near(mvDot(mvPerp(a), a), 0, tiny) && mvIsNormalized(mvPerp(a)) && mvIsNormalized(mvPerp(mvVec3_axisZ)));
    CHECK(nearVec(mvAbs(b), vec(2, 0, 4), 0) && nearVec(mvSign(b), vec(-1, 1, 1), 0));
    CHECK(nearVec(mvMin(a, b), vec(-2, 0, 3), 0) && nearVec(mvMax(a, b), vec(1, 2, 4), 0));
    CHECK(nearVec(mvClamp(b, mvVec3_zero, mvVec3_one), vec(0, 0, 1), 0));
    CHECK(nearVec(mvSafeScale(vec(0, -1, (mvFloat)-0.001)), vec(MV_MIN_SCALE, -1, -MV_MIN_SCALE), tiny));
    CHECK(mvIsValidVec3(a) && !mvIsValidVec3(vec(0, (mvFloat)NAN, 0)));
    CHECK(mvIsValidFloat(1) && !mvIsValidFloat((mvFloat)INFINITY));
    CHECK(nearVec(mvPointToSegmentDistance(vec(0, 0, 0), vec(4, 0, 0), vec(3, 5, 0)), vec(3, 0, 0), tiny));
    CHECK(nearVec(mvPointToSegmentDistance(a, a, b), a, tiny));
    {
        mvSegmentDistanceResult r = mvSegmentDistance(vec(-1, 0, 0), vec(1, 0, 0), vec(0, 2, -1), vec(0, 2, 1));
        CHECK(nearVec(r.point1, mvVec3_zero, tiny) && nearVec(r.point2, vec(0, 2, 0), tiny));
        CHECK(near(r.fraction1, (mvFloat)0.5, tiny) && near(r.fraction2, (mvFloat)0.5, tiny));
        r = mvSegmentDistance(vec(0, 0, 0), vec(1, 0, 0), vec(3, 1, 0), vec(2, 1, 0));
        CHECK(nearVec(r.point1, vec(1, 0, 0), tiny) && nearVec(r.point2, vec(2, 1, 0), tiny));
        r = mvLineDistance(vec(5, 0, 0), vec(1, 0, 0), vec(0, 1, 7), vec(0, 0, 2));
        CHECK(nearVec(r.point1, mvVec3_zero, tiny) && nearVec(r.point2, vec(0, 1, 0), tiny));
        FAILS(mv_errorDegenerate, mvLineDistance, mvLineDistance(a, mvVec3_zero, b, a));
        FAILS(mv_errorNotFinite, mvSegmentDistance, mvSegmentDistance(vec((mvFloat)NAN, 0, 0), a, b, a));
        FAILS(mv_errorRange, mvPointToSegmentDistance, mvPointToSegmentDistance(vec((mvFloat)2e9, 0, 0), a, b));
    }
}

static void rotations(void)
{
    mvQuat q = mvMakeQuatFromAxisAngle(mvVec3_axisZ, MV_PI / 2), r, zero = { { 0, 0, 0 }, 0 };
    mvQuat p = mvMakeQuatFromAxisAngle(mvNormalize(vec(1, 2, 3)), (mvFloat)0.7);
    mvFloat angle;
    mvMatrix3 m = mvMakeMatrixFromQuat(p);
    CHECK(nearVec(mvRotateVector(q, mvVec3_axisX), mvVec3_axisY, tiny));
    CHECK(nearVec(mvInvRotateVector(q, mvVec3_axisY), mvVec3_axisX, tiny));
    CHECK(near(mvDotQuat(q, q), 1, tiny) && mvIsNormalizedQuat(q) && !mvIsNormalizedQuat(zero));
    CHECK(mvIsNormalizedQuat(mvNormalizeQuat(q)) && mvNormalizeQuat(zero).s == 1);
    CHECK(near(mvDotQuat(mvMulQuat(p, mvConjugate(p)), mvQuat_identity), 1, tiny));
    CHECK(near(mvDotQuat(mvInvMulQuat(p, mvMulQuat(p, q)), q), 1, tiny));
    CHECK(near(mvDotQuat(mvNegateQuat(p), p), -1, tiny));
    CHECK(near(mvGetQuatAngle(q), MV_PI / 2, tiny));
    CHECK(nearVec(mvGetAxisAngle(&angle, p), mvNormalize(vec(1, 2, 3)), tiny) && near(angle, (mvFloat)0.7, tiny));
    CHECK(near(mvGetTwistAngle(q), MV_PI / 2, tiny) && near(mvGetTwistAngle(mvNegateQuat(q)), MV_PI / 2, tiny));
    CHECK(near(mvGetSwingAngle(q), 0, (mvFloat)1e-3));
    CHECK(near(mvGetSwingAngle(mvMakeQuatFromAxisAngle(mvVec3_axisX, 1)), 1, tiny));
    r = mvNLerp(mvQuat_identity, mvNegateQuat(q), (mvFloat)0.5);
    CHECK(near(mvGetQuatAngle(r.s < 0 ? mvNegateQuat(r) : r), MV_PI / 4, tiny));
    CHECK(near(mvAbsFloat(mvDotQuat(mvMakeQuatFromMatrix(&m), p)), 1, tiny));
    {
        mvVec3 axes[4];
        int k;
        axes[0] = mvVec3_axisX;
        axes[1] = mvVec3_axisY;
        axes[2] = mvVec3_axisZ;
        axes[3] = mvNormalize(vec(1, -1, 2));
        for (k = 0; k < 4; ++k)
        {
            mvQuat half = mvMakeQuatFromAxisAngle(axes[k], (mvFloat)3.1);
            mvMatrix3 h = mvMakeMatrixFromQuat(half);
            CHECK(near(mvAbsFloat(mvDotQuat(mvMakeQuatFromMatrix(&h), half)), 1, (mvFloat)1e-4));
        }
    }
    r = mvComputeQuatBetweenUnitVectors(mvVec3_axisX, mvVec3_axisZ);
    CHECK(nearVec(mvRotateVector(r, mvVec3_axisX), mvVec3_axisZ, tiny));
    r = mvComputeQuatBetweenUnitVectors(mvVec3_axisX, mvNeg(mvVec3_axisX));
    CHECK(nearVec(mvRotateVector(r, mvVec3_axisX), mvNeg(mvVec3_axisX), tiny));
    CHECK(mvIsValidQuat(q) && !mvIsValidQuat(zero));
    FAILS(mv_errorNull, mvMakeQuatFromMatrix, CHECK(mvMakeQuatFromMatrix(NULL).s == 1));
    FAILS(mv_errorRange, mvMakeQuatFromMatrix, mvMakeQuatFromMatrix(&mvMat3_zero));
    FAILS(mv_errorDegenerate, mvComputeQuatBetweenUnitVectors,
          mvComputeQuatBetweenUnitVectors(mvVec3_one, mvVec3_axisX));
}

static void placements(void)
{
    mvTransform t, u;
    mvWorldTransform w;
    mvVec3 v = vec(1, 2, 3);
    t.p = vec(1, 0, 0);
    t.q = mvMakeQuatFromAxisAngle(mvVec3_axisZ, MV_PI / 2);
    CHECK(nearVec(mvTransformPoint(t, mvVec3_axisX), vec(1, 1, 0), tiny));
    CHECK(nearVec(mvInvTransformPoint(t, vec(1, 1, 0)), mvVec3_axisX, tiny));
    u = mvMulTransforms(t, mvInvertTransform(t));
    CHECK(nearVec(u.p, mvVec3_zero, tiny) && near(u.q.s, 1, tiny));
    u = mvInvMulTransforms(t, t);
    CHECK(nearVec(u.p, mvTransform_identity.p, tiny) && near(u.q.s, 1, tiny));
    w = mvMakeWorldTransform(t);
    CHECK(nearVec(mvToVec3(mvTransformWorldPoint(w, v)), mvTransformPoint(t, v), tiny));
    CHECK(nearVec(mvInvTransformWorldPoint(w, mvToPos(v)), mvInvTransformPoint(t, v), tiny));
    CHECK(nearVec(mvInvMulWorldTransforms(w, w).p, mvVec3_zero, tiny));
    CHECK(nearVec(mvToVec3(mvMulWorldTransforms(w, t).p), mvMulTransforms(t, t).p, tiny));
    CHECK(nearVec(mvToRelativeTransform(w, pos(1, 1, 1)).p, vec(0, -1, -1), tiny));
    CHECK(nearVec(mvSubPos(pos(3, 2, 1), pos(1, 1, 1)), vec(2, 1, 0), 0));
    CHECK(nearVec(mvToVec3(mvOffsetPos(mvPos_zero, v)), v, 0));
    CHECK(nearVec(mvToVec3(mvLerpPosition(mvPos_zero, mvToPos(v), (mvFloat)0.5)), mvMulSV((mvFloat)0.5, v), tiny));
    CHECK(mvIsValidTransform(t) && mvIsValidWorldTransform(w) && mvIsValidWorldTransform(mvWorldTransform_identity));
    t.q.s = 7;
    w.p.x = (mvFloat)NAN;
    CHECK(!mvIsValidTransform(t) && !mvIsValidWorldTransform(w) && !mvIsValidPosition(w.p));
    CHECK(mvIsValidPosition(mvPos_zero));
}

static void matrices(void)
{
    mvMatrix3 m, inverse;
    mvVec3 v = vec(1, -2, 3);
    m.cx = vec(2, 1, 0);
    m.cy = vec(0, 3, 1);
    m.cz = vec(1, 0, 4);
    inverse = mvInvertMatrix(m);
    CHECK(near(mvDet(m), 25, tiny));
    CHECK(nearVec(mvMulMV(m, v), vec(5, -5, 10), tiny));
    CHECK(nearVec(mvMulMV(inverse, mvMulMV(m, v)), v, tiny) && nearVec(mvSolve3(m, mvMulMV(m, v)), v, tiny));
    CHECK(nearVec(mvMulMV(mvMulMM(m, inverse), v), v, tiny));
    CHECK(nearVec(mvTranspose(m).cx, vec(2, 0, 1), 0));
    CHECK(nearVec(mvInvertT(m).cx, mvTranspose(inverse).cx, tiny));
    CHECK(nearVec(mvAddMM(m, mvNegateMat3(m)).cy, mvVec3_zero, 0) && nearVec(mvSubMM(m, m).cz, mvVec3_zero, 0));
    CHECK(nearVec(mvMulSM(2, m).cz, vec(2, 0, 8), 0) && nearVec(mvAbsMatrix3(mvNegateMat3(m)).cx, m.cx, 0));
    CHECK(nearVec(mvInvertMatrix(mvMat3_zero).cx, mvVec3_zero, 0) && nearVec(mvMat3_identity.cy, mvVec3_axisY, 0));
    CHECK(nearVec(mvSteiner(2, vec(0, 3, 0)).cx, vec(18, 0, 0), tiny));
    FAILS(mv_errorRange, mvSteiner, mvSteiner(-1, v));
    CHECK(mvIsValidMatrix3(m));
    m.cz.y = (mvFloat)INFINITY;
    CHECK(!mvIsValidMatrix3(m));
}

static void boxesAndPlanes(void)
{
    mvVec3 points[2];
    mvAABB a, b;
    mvTransform t = mvTransform_identity;
    mvPlane plane;
    points[0] = vec(1, -1, 0);
    points[1] = vec(-1, 2, 3);
    a = mvMakeAABB(points, 2, 1);
    CHECK(nearVec(a.lowerBound, vec(-2, -2, -1), 0) && nearVec(a.upperBound, vec(2, 3, 4), 0));
    b = mvAABB_Inflate(a, 1);
    CHECK(mvAABB_Contains(b, a) && !mvAABB_Contains(a, b) && mvAABB_Overlaps(a, b));
    CHECK(mvAABB_Area(a) == 130 && nearVec(mvAABB_Center(a), vec(0, (mvFloat)0.5, (mvFloat)1.5), 0));
    CHECK(nearVec(mvAABB_Extents(a), vec(2, (mvFloat)2.5, (mvFloat)2.5), 0));
    CHECK(mvAABB_Contains(mvAABB_Union(a, b), b));
    t.p = vec(100, 0, 0);
    CHECK(!mvAABB_Overlaps(a, mvAABB_Transform(t, a)));
    CHECK(nearVec(mvAABB_Transform(t, a).lowerBound, vec(98, -2, -1), tiny));
    CHECK(nearVec(mvClosestPointToAABB(vec(9, 0, 0), a), vec(2, 0, 0), 0));
    CHECK(nearVec(mvOffsetAABB(a, pos(1, 0, 0)).upperBound, vec(3, 3, 4), 0));
    CHECK(mvIsValidAABB(a) && mvIsBoundedAABB(a) && mvIsSaneAABB(a));
    a.upperBound.x = -5;
    CHECK(!mvIsValidAABB(a) && mvIsBoundedAABB(a) && !mvIsSaneAABB(a));
    b.upperBound.x = (mvFloat)1e10;
    CHECK(mvIsValidAABB(b) && !mvIsBoundedAABB(b) && !mvIsSaneAABB(b));
    plane = mvMakePlaneFromPoints(vec(0, 1, 0), vec(0, 1, 1), vec(1, 1, 0));
    CHECK(nearVec(plane.normal, mvVec3_axisY, tiny) && near(plane.offset, 1, tiny) && mvIsValidPlane(plane));
    plane = mvMakePlaneFromNormalAndPoint(mvVec3_axisX, vec(100, 0, 0));
    CHECK(near(mvPlaneSeparation(plane, vec(103, 5, 5)), 3, tiny));
    CHECK(near(mvTransformPlane(t, plane).offset, 200, tiny));
    plane.normal = mvVec3_zero;
    CHECK(!mvIsValidPlane(plane));
}

int main(void)
{
    mvVec2 flat = { 1, 2 };
    CHECK(flat.x + flat.y == 3);
    scalars();
    vectors();
    rotations();
    placements();
    matrices();
    boxesAndPlanes();
    CHECK(mvGetLastError() == mv_errorNone);
    return done("math");
}
