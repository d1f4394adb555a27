typedef float mvFloat;
#define MV_ABI_REVISION 1
#define MV_HASH_INIT 5381
#define MV_DEFAULT_CATEGORY_BITS 18446744073709551615ull
#define MV_DEFAULT_MASK_BITS 18446744073709551615ull
#define MV_MAX_SHAPE_CAST_POINTS 64
#define MV_MAX_HULL_VERTICES 255
#define MV_MAX_BONES 14
typedef struct mvVersion {
    int major;
    int minor;
    int revision;
} mvVersion;
typedef struct mvBodyId {
    int32_t index1;
    uint16_t world0;
    uint16_t generation;
} mvBodyId;
typedef struct mvWorldId {
    uint16_t index1;
    uint16_t generation;
} mvWorldId;
typedef int32_t mvBodyType;
typedef struct mvPos {
    mvFloat x;
    mvFloat y;
    mvFloat z;
} mvPos;
typedef struct mvVec3 {
    mvFloat x;
    mvFloat y;
    mvFloat z;
} mvVec3;
typedef struct mvQuat {
    mvVec3 v;
    mvFloat s;
} mvQuat;
typedef struct mvMotionLocks {
    bool linearX;
    bool linearY;
    bool linearZ;
    bool angularX;
    bool angularY;
    bool angularZ;
} mvMotionLocks;
typedef struct mvBodyDef {
    int32_t internalValue;
    mvBodyType type;
    mvPos position;
    mvQuat rotation;
    mvVec3 linearVelocity;
    mvVec3 angularVelocity;
    mvFloat linearDamping;
    mvFloat angularDamping;
    mvFloat gravityScale;
    mvFloat sleepThreshold;
    const char *name;
    void *userData;
    mvMotionLocks motionLocks;
    bool enableSleep;
    bool isAwake;
    bool isEnabled;
} mvBodyDef;
typedef struct mvShapeId {
    int32_t index1;
    uint16_t world0;
    uint16_t generation;
} mvShapeId;
typedef struct mvJointId {
    int32_t index1;
    uint16_t world0;
    uint16_t generation;
} mvJointId;
typedef struct mvAABB {
    mvVec3 lowerBound;
    mvVec3 upperBound;
} mvAABB;
typedef struct mvContactId {
    int32_t index1;
    uint16_t world0;
    int16_t padding;
    uint32_t generation;
} mvContactId;
typedef struct mvManifoldPoint {
    mvPos point;
    mvVec3 anchorA;
    mvVec3 anchorB;
    mvFloat separation;
    mvFloat normalImpulse;
    mvFloat totalNormalImpulse;
    mvFloat normalVelocity;
    uint32_t featureId;
} mvManifoldPoint;
typedef struct mvManifold {
    mvManifoldPoint points[4];
    mvVec3 normal;
    mvVec3 frictionImpulse;
    int pointCount;
} mvManifold;
typedef struct mvContactData {
    mvContactId contactId;
    mvShapeId shapeIdA;
    mvShapeId shapeIdB;
    const mvManifold *manifolds;
    int manifoldCount;
} mvContactData;
typedef struct mvMatrix3 {
    mvVec3 cx;
    mvVec3 cy;
    mvVec3 cz;
} mvMatrix3;
typedef struct mvMassData {
    mvFloat mass;
    mvVec3 center;
    mvMatrix3 inertia;
} mvMassData;
typedef struct mvWorldTransform {
    mvPos p;
    mvQuat q;
} mvWorldTransform;
typedef struct mvBodyCastResult {
    mvShapeId shapeId;
    mvPos point;
    mvVec3 normal;
    mvFloat fraction;
    uint64_t userMaterialId;
    int iterations;
    bool hit;
} mvBodyCastResult;
typedef struct mvQueryFilter {
    uint64_t categoryBits;
    uint64_t maskBits;
} mvQueryFilter;
typedef struct mvShapeProxy {
    const mvVec3 *points;
    int count;
    mvFloat radius;
} mvShapeProxy;
typedef struct mvLocalManifoldPoint {
    mvVec3 point;
    mvFloat separation;
    uint32_t featureId;
} mvLocalManifoldPoint;
typedef struct mvLocalManifold {
    mvVec3 normal;
    mvLocalManifoldPoint *points;
    int pointCount;
} mvLocalManifold;
typedef struct mvSphere {
    mvVec3 center;
    mvFloat radius;
} mvSphere;
typedef struct mvTransform {
    mvVec3 p;
    mvQuat q;
} mvTransform;
typedef struct mvCapsule {
    mvVec3 center1;
    mvVec3 center2;
    mvFloat radius;
} mvCapsule;
typedef struct mvHullData {
    uint64_t version;
    uint64_t hash;
    mvAABB aabb;
    mvFloat surfaceArea;
    mvFloat volume;
    mvFloat innerRadius;
    mvFloat outerRadius;
    mvVec3 center;
    mvMatrix3 centralInertia;
    mvVec3 boxHalfWidths;
    mvTransform boxTransform;
    int32_t vertexCount;
    int32_t vertexOffset;
    int32_t pointOffset;
    int32_t edgeCount;
    int32_t edgeOffset;
    int32_t faceCount;
    int32_t planeOffset;
    int32_t faceOffset;
    int32_t byteCount;
    int32_t padding;
} mvHullData;
typedef struct mvSimplexCache {
    mvFloat metric;
    uint16_t count;
    uint8_t indexA[4];
    uint8_t indexB[4];
} mvSimplexCache;
typedef struct mvSATCache {
    mvFloat separation;
    bool hit;
} mvSATCache;
typedef uint32_t mvHexColor;
typedef struct mvDebugDraw {
    int32_t internalValue;
    void (*DrawShapeFcn)(const mvShapeId *shapeId,
                         const mvWorldTransform *transform,
                         mvHexColor color,
                         void *context);
    void (*DrawSegmentFcn)(const mvPos *p1, const mvPos *p2, mvHexColor color, void *context);
    void (*DrawTransformFcn)(const mvWorldTransform *transform, void *context);
    void (*DrawPointFcn)(const mvPos *p, mvFloat size, mvHexColor color, void *context);
    void (*DrawSphereFcn)(const mvPos *p,
                          mvFloat radius,
                          mvHexColor color,
                          mvFloat alpha,
                          void *context);
    void (*DrawCapsuleFcn)(const mvPos *p1,
                           const mvPos *p2,
                           mvFloat radius,
                           mvHexColor color,
                           mvFloat alpha,
                           void *context);
    void (*DrawPolygonFcn)(const mvPos *vertices,
                           int count,
                           mvHexColor color,
                           mvFloat alpha,
                           void *context);
    void (*DrawBoundsFcn)(const mvAABB *aabb, mvHexColor color, void *context);
    void (*DrawBoxFcn)(const mvVec3 *extents,
                       const mvWorldTransform *transform,
                       mvHexColor color,
                       void *context);
    void (*DrawStringFcn)(const mvPos *p, const char *s, mvHexColor color, void *context);
    mvAABB drawingBounds;
    mvFloat forceScale;
    mvFloat jointScale;
    bool drawShapes;
    bool drawEdges;
    bool drawJoints;
    bool drawJointExtras;
    bool drawBounds;
    bool drawMass;
    bool drawSleep;
    bool drawBodyNames;
    bool drawContacts;
    bool drawAnchorA;
    bool drawGraphColors;
    bool drawContactFeatures;
    bool drawContactNormals;
    bool drawContactForces;
    bool drawFrictionForces;
    bool drawIslands;
    bool tessellate;
    void *context;
} mvDebugDraw;
typedef struct mvDrawLine {
    mvPos p1;
    mvPos p2;
    mvHexColor color;
} mvDrawLine;
typedef struct mvDrawTriangle {
    mvPos p1;
    mvPos p2;
    mvPos p3;
    mvVec3 normal;
    mvHexColor color;
    mvShapeId shapeId;
} mvDrawTriangle;
typedef int32_t mvDrawInstanceKind;
typedef struct mvDrawInstance {
    mvWorldTransform transform;
    mvVec3 size;
    mvDrawInstanceKind kind;
    mvHexColor color;
    mvShapeId shapeId;
} mvDrawInstance;
typedef struct mvDrawPoint {
    mvPos position;
    mvFloat size;
    mvHexColor color;
} mvDrawPoint;
typedef struct mvDrawString {
    mvPos position;
    const char *text;
    mvHexColor color;
} mvDrawString;
typedef struct mvDrawBuffers {
    const mvDrawLine *lines;
    const mvDrawTriangle *triangles;
    const mvDrawInstance *instances;
    const mvDrawPoint *points;
    const mvDrawString *strings;
    int lineCount;
    int triangleCount;
    int instanceCount;
    int pointCount;
    int stringCount;
} mvDrawBuffers;
typedef mvFloat (*mvFrictionCallback)(mvFloat frictionA,
                                      uint64_t userMaterialIdA,
                                      mvFloat frictionB,
                                      uint64_t userMaterialIdB,
                                      void *context);
typedef mvFloat (*mvRestitutionCallback)(mvFloat restitutionA,
                                         uint64_t userMaterialIdA,
                                         mvFloat restitutionB,
                                         uint64_t userMaterialIdB,
                                         void *context);
typedef int32_t mvSolverKind;
typedef int32_t mvIntegratorKind;
typedef int32_t mvBroadPhaseKind;
typedef int32_t mvNarrowPhaseKind;
typedef int32_t mvGjkKind;
typedef int32_t mvManifoldKind;
typedef struct mvWorldDef {
    int32_t internalValue;
    mvVec3 gravity;
    mvFloat restitutionThreshold;
    mvFloat hitEventThreshold;
    mvFloat contactStiffness;
    mvFloat contactDampingRatio;
    mvFloat contactSpeed;
    mvFloat maximumLinearSpeed;
    mvFrictionCallback frictionCallback;
    void *frictionContext;
    mvRestitutionCallback restitutionCallback;
    void *restitutionContext;
    bool enableSleep;
    bool enableWarmStarting;
    bool enableLoadMemory;
    uint32_t workerCount;
    void *userData;
    mvFloat accuracy;
    mvSolverKind solver;
    uint32_t solverIterations;
    uint32_t frictionFacets;
    bool shuffleContacts;
    bool overCorrect;
    mvIntegratorKind integrator;
    mvBroadPhaseKind broadPhase;
    mvNarrowPhaseKind narrowPhase;
    mvGjkKind gjk;
    mvManifoldKind manifold;
} mvWorldDef;
typedef struct mvSurfaceMaterial {
    mvFloat friction;
    mvFloat staticFriction;
    mvFloat restitution;
    mvFloat rollingResistance;
    mvVec3 tangentVelocity;
    uint64_t userMaterialId;
    uint32_t customColor;
} mvSurfaceMaterial;
typedef struct mvFilter {
    uint64_t categoryBits;
    uint64_t maskBits;
    int groupIndex;
} mvFilter;
typedef struct mvShapeDef {
    int32_t internalValue;
    const char *name;
    void *userData;
    mvSurfaceMaterial baseMaterial;
    mvFloat density;
    mvFilter filter;
    bool enableCustomFiltering;
    bool enableContactEvents;
    bool enableHitEvents;
    bool enablePreSolveEvents;
    bool updateBodyMass;
} mvShapeDef;
typedef struct mvDistanceOutput {
    mvVec3 pointA;
    mvVec3 pointB;
    mvVec3 normal;
    mvFloat distance;
    int iterations;
    int simplexCount;
} mvDistanceOutput;
typedef struct mvDistanceInput {
    mvShapeProxy proxyA;
    mvShapeProxy proxyB;
    mvTransform transform;
    bool useRadii;
    mvGjkKind gjk;
} mvDistanceInput;
typedef struct mvSimplexVertex {
    mvVec3 wA;
    mvVec3 wB;
    mvVec3 w;
    int indexA;
    int indexB;
} mvSimplexVertex;
typedef struct mvSimplex {
    mvSimplexVertex vertices[4];
    int count;
} mvSimplex;
typedef struct mvCastOutput {
    mvVec3 normal;
    mvVec3 point;
    mvFloat fraction;
    int iterations;
    bool hit;
} mvCastOutput;
typedef struct mvShapeCastPairInput {
    mvShapeProxy proxyA;
    mvShapeProxy proxyB;
    mvTransform transform;
    mvVec3 translationB;
    mvFloat maxFraction;
    bool canEncroach;
} mvShapeCastPairInput;
typedef struct mvShapeCastInput {
    mvShapeProxy proxy;
    mvVec3 translation;
    mvFloat maxFraction;
    bool canEncroach;
} mvShapeCastInput;
typedef int32_t mvErrorCode;
typedef void (*mvLogFcn)(const char *message);
typedef int (*mvAssertFcn)(const char *condition, const char *fileName, int lineNumber);
typedef struct mvBodyMoveEvent {
    void *userData;
    mvWorldTransform transform;
    mvBodyId bodyId;
    bool fellAsleep;
} mvBodyMoveEvent;
typedef struct mvBodyEvents {
    mvBodyMoveEvent *moveEvents;
    int moveCount;
} mvBodyEvents;
typedef struct mvContactBeginTouchEvent {
    mvShapeId shapeIdA;
    mvShapeId shapeIdB;
    mvContactId contactId;
} mvContactBeginTouchEvent;
typedef struct mvContactEndTouchEvent {
    mvShapeId shapeIdA;
    mvShapeId shapeIdB;
    mvContactId contactId;
} mvContactEndTouchEvent;
typedef struct mvContactHitEvent {
    mvShapeId shapeIdA;
    mvShapeId shapeIdB;
    mvContactId contactId;
    mvPos point;
    mvVec3 normal;
    mvFloat approachSpeed;
    uint64_t userMaterialIdA;
    uint64_t userMaterialIdB;
} mvContactHitEvent;
typedef struct mvContactEvents {
    mvContactBeginTouchEvent *beginEvents;
    mvContactEndTouchEvent *endEvents;
    mvContactHitEvent *hitEvents;
    int beginCount;
    int endCount;
    int hitCount;
} mvContactEvents;
typedef struct mvJointEvent {
    mvJointId jointId;
    void *userData;
    mvFloat force;
    mvFloat torque;
    bool broke;
} mvJointEvent;
typedef struct mvJointEvents {
    mvJointEvent *jointEvents;
    int count;
} mvJointEvents;
typedef struct mvRayCastInput {
    mvVec3 origin;
    mvVec3 translation;
    mvFloat maxFraction;
} mvRayCastInput;
typedef struct mvPlane {
    mvVec3 normal;
    mvFloat offset;
} mvPlane;
typedef struct mvHullHalfEdge {
    uint16_t next;
    uint16_t twin;
    uint16_t origin;
    uint16_t face;
} mvHullHalfEdge;
typedef struct mvHullVertex {
    uint16_t edge;
} mvHullVertex;
typedef struct mvHullFace {
    uint16_t edge;
} mvHullFace;
typedef struct mvBoxHull {
    mvHullData base;
    mvVec3 boxPoints[8];
    mvPlane boxPlanes[6];
    mvHullHalfEdge boxEdges[24];
    mvHullVertex boxVertices[8];
    mvHullFace boxFaces[6];
    uint16_t padding[2];
} mvBoxHull;
typedef struct mvHumanDef {
    int32_t internalValue;
    int boneCount;
    mvPos position;
    mvQuat rotation;
    mvFloat height;
    mvFloat density;
    mvFloat mass;
    mvFloat frictionTorque;
    mvFloat springHertz;
    mvFloat springDampingRatio;
    int groupIndex;
    mvSurfaceMaterial material;
    void *userData;
} mvHumanDef;
typedef struct mvHuman {
    int boneCount;
    mvBodyId bodyIds[14];
    mvJointId jointIds[14];
} mvHuman;
typedef int32_t mvJointType;
typedef struct mvJointDef {
    void *userData;
    mvBodyId bodyIdA;
    mvBodyId bodyIdB;
    mvTransform localFrameA;
    mvTransform localFrameB;
    mvFloat forceThreshold;
    mvFloat torqueThreshold;
    mvFloat constraintHertz;
    mvFloat constraintDampingRatio;
    mvFloat drawScale;
    bool collideConnected;
    bool breakable;
} mvJointDef;
typedef struct mvDistanceJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvFloat length;
    bool enableSpring;
    mvFloat lowerSpringForce;
    mvFloat upperSpringForce;
    mvFloat hertz;
    mvFloat dampingRatio;
    bool enableLimit;
    mvFloat minLength;
    mvFloat maxLength;
    bool enableMotor;
    mvFloat maxMotorForce;
    mvFloat motorSpeed;
} mvDistanceJointDef;
typedef struct mvFilterJointDef {
    int32_t internalValue;
    mvJointDef base;
} mvFilterJointDef;
typedef struct mvGearJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvJointId jointIdA;
    mvJointId jointIdB;
    mvFloat ratio;
} mvGearJointDef;
typedef struct mvMotorJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvVec3 linearVelocity;
    mvFloat maxVelocityForce;
    mvVec3 angularVelocity;
    mvFloat maxVelocityTorque;
    mvFloat linearHertz;
    mvFloat linearDampingRatio;
    mvFloat maxSpringForce;
    mvFloat angularHertz;
    mvFloat angularDampingRatio;
    mvFloat maxSpringTorque;
} mvMotorJointDef;
typedef struct mvParallelJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvFloat hertz;
    mvFloat dampingRatio;
    mvFloat maxTorque;
} mvParallelJointDef;
typedef struct mvPrismaticJointDef {
    int32_t internalValue;
    mvJointDef base;
    bool enableSpring;
    mvFloat hertz;
    mvFloat dampingRatio;
    mvFloat maxSpringForce;
    mvFloat targetTranslation;
    bool enableLimit;
    mvFloat lowerTranslation;
    mvFloat upperTranslation;
    bool enableMotor;
    mvFloat maxMotorForce;
    mvFloat motorSpeed;
    mvFloat friction;
} mvPrismaticJointDef;
typedef struct mvPulleyJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvPos groundAnchorA;
    mvPos groundAnchorB;
    mvFloat ratio;
    mvFloat minLength;
    mvFloat maxLength;
} mvPulleyJointDef;
typedef struct mvRackPinionJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvJointId jointIdA;
    mvJointId jointIdB;
    mvFloat ratio;
} mvRackPinionJointDef;
typedef struct mvRevoluteJointDef {
    int32_t internalValue;
    mvJointDef base;
    bool enableSpring;
    mvFloat hertz;
    mvFloat dampingRatio;
    mvFloat maxSpringTorque;
    mvFloat targetAngle;
    bool enableLimit;
    mvFloat lowerAngle;
    mvFloat upperAngle;
    bool enableMotor;
    mvFloat maxMotorTorque;
    mvFloat motorSpeed;
    mvFloat friction;
} mvRevoluteJointDef;
typedef struct mvScrewJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvFloat pitch;
    bool enableSpring;
    mvFloat hertz;
    mvFloat dampingRatio;
    mvFloat maxSpringTorque;
    mvFloat targetAngle;
    bool enableLimit;
    mvFloat lowerAngle;
    mvFloat upperAngle;
    bool enableMotor;
    mvFloat maxMotorTorque;
    mvFloat motorSpeed;
    mvFloat friction;
} mvScrewJointDef;
typedef int32_t mvAxisMode;
typedef struct mvSixDofAxis {
    mvAxisMode mode;
    mvFloat target;
    mvFloat hertz;
    mvFloat dampingRatio;
    mvFloat maxSpringForce;
    mvFloat lower;
    mvFloat upper;
    mvFloat motorSpeed;
    mvFloat maxMotorForce;
    mvFloat friction;
    bool enableSpring;
    bool enableMotor;
} mvSixDofAxis;
typedef struct mvSixDofJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvSixDofAxis axes[6];
} mvSixDofJointDef;
typedef struct mvSphericalJointDef {
    int32_t internalValue;
    mvJointDef base;
    bool enableSpring;
    mvFloat hertz;
    mvFloat dampingRatio;
    mvFloat maxSpringTorque;
    mvQuat targetRotation;
    bool enableConeLimit;
    mvFloat coneAngle;
    mvFloat coneAngleY;
    bool enableTwistLimit;
    mvFloat lowerTwistAngle;
    mvFloat upperTwistAngle;
    bool enableMotor;
    mvFloat maxMotorTorque;
    mvVec3 motorVelocity;
    mvFloat friction;
} mvSphericalJointDef;
typedef struct mvUniversalJointDef {
    int32_t internalValue;
    mvJointDef base;
    bool enableSpring1;
    mvFloat hertz1;
    mvFloat dampingRatio1;
    mvFloat targetAngle1;
    bool enableLimit1;
    mvFloat lowerAngle1;
    mvFloat upperAngle1;
    bool enableMotor1;
    mvFloat maxMotorTorque1;
    mvFloat motorSpeed1;
    mvFloat friction1;
    bool enableSpring2;
    mvFloat hertz2;
    mvFloat dampingRatio2;
    mvFloat targetAngle2;
    bool enableLimit2;
    mvFloat lowerAngle2;
    mvFloat upperAngle2;
    bool enableMotor2;
    mvFloat maxMotorTorque2;
    mvFloat motorSpeed2;
    mvFloat friction2;
} mvUniversalJointDef;
typedef struct mvWeldJointDef {
    int32_t internalValue;
    mvJointDef base;
    mvFloat linearHertz;
    mvFloat angularHertz;
    mvFloat linearDampingRatio;
    mvFloat angularDampingRatio;
} mvWeldJointDef;
typedef struct mvWheelJointDef {
    int32_t internalValue;
    mvJointDef base;
    bool enableSuspensionSpring;
    mvFloat suspensionHertz;
    mvFloat suspensionDampingRatio;
    mvFloat targetSuspension;
    mvFloat maxSuspensionForce;
    bool enableSuspensionLimit;
    mvFloat lowerSuspensionLimit;
    mvFloat upperSuspensionLimit;
    bool enableSpinMotor;
    mvFloat maxSpinTorque;
    mvFloat spinSpeed;
    mvFloat spinFriction;
    bool enableSteering;
    mvFloat steeringHertz;
    mvFloat steeringDampingRatio;
    mvFloat targetSteeringAngle;
    mvFloat maxSteeringTorque;
    bool enableSteeringLimit;
    mvFloat lowerSteeringLimit;
    mvFloat upperSteeringLimit;
} mvWheelJointDef;
typedef struct mvCosSin {
    mvFloat cosine;
    mvFloat sine;
} mvCosSin;
typedef struct mvSegmentDistanceResult {
    mvVec3 point1;
    mvFloat fraction1;
    mvVec3 point2;
    mvFloat fraction2;
} mvSegmentDistanceResult;
typedef struct mvTreeStats {
    int leafVisits;
} mvTreeStats;
typedef bool (*mvOverlapResultFcn)(mvShapeId shapeId, void *context);
typedef mvFloat (*mvCastResultFcn)(mvShapeId shapeId,
                                   mvPos point,
                                   mvVec3 normal,
                                   mvFloat fraction,
                                   uint64_t userMaterialId,
                                   int triangleIndex,
                                   int childIndex,
                                   void *context);
typedef struct mvRayResult {
    mvShapeId shapeId;
    mvPos point;
    mvVec3 normal;
    uint64_t userMaterialId;
    mvFloat fraction;
    bool hit;
} mvRayResult;
typedef int32_t mvShapeType;
typedef struct mvWorldCastOutput {
    mvVec3 normal;
    mvPos point;
    mvFloat fraction;
    int iterations;
    bool hit;
} mvWorldCastOutput;
typedef bool (*mvCustomFilterFcn)(mvShapeId shapeIdA, mvShapeId shapeIdB, void *context);
typedef bool (*mvPreSolveFcn)(mvShapeId shapeIdA,
                              mvShapeId shapeIdB,
                              mvPos point,
                              mvVec3 normal,
                              void *context);
typedef struct mvContactTuning {
    mvFloat stiffness;
    mvFloat dampingRatio;
    mvFloat contactSpeed;
} mvContactTuning;
typedef struct mvProfile {
    float step;
    float updateBounds;
    float pairs;
    float collide;
    float islands;
    float rehearse;
    float prepare;
    float solve;
    float transforms;
    float sleep;
    float events;
} mvProfile;
typedef struct mvCounters {
    int bodyCount;
    int awakeBodyCount;
    int shapeCount;
    int jointCount;
    int contactCount;
    int constraintCount;
    int overflowCount;
    int islandCount;
    int treeHeight;
    int64_t byteCount;
} mvCounters;
typedef struct mvStepReport {
    double kineticEnergy;
    double potentialEnergy;
    double linearMomentum[3];
    double angularMomentum[3];
    mvFloat worstPenetration;
    mvFloat jointGap;
    mvFloat jointAngleGap;
    mvFloat residual;
    int subStepCount;
    int mostSubStepCount;
    mvFloat error;
    mvSolverKind solver;
    mvFloat solverResidual;
    int solveCount;
    int tooLargeCount;
    int unsolvedCount;
    int64_t fallbackCount;
    int64_t stepCount;
    int64_t quarantinedCount;
    mvCounters counters;
    mvProfile profile;
} mvStepReport;
typedef struct mvVec2 {
    mvFloat x;
    mvFloat y;
} mvVec2;
#define mv_drawSphere 0
#define mv_drawCapsule 1
#define mv_drawBox 2
#define mv_staticBody 0
#define mv_kinematicBody 1
#define mv_dynamicBody 2
#define mv_solver_auto 0
#define mv_integrator_auto 0
#define mv_broadPhase_auto 0
#define mv_narrowPhase_auto 0
#define mv_gjk_auto 0
#define mv_manifold_auto 0
#define mv_errorNone 0
#define mv_errorNull 1
#define mv_errorStale 2
#define mv_errorForeign 3
#define mv_errorDefinition 4
#define mv_errorNotFinite 5
#define mv_errorRange 6
#define mv_errorDegenerate 7
#define mv_errorLocked 8
#define mv_errorBusy 9
#define mv_errorCapacity 10
#define mv_errorUnsupported 11
#define mv_errorFaulted 12
#define mv_errorInternal 13
#define mv_parallelJoint 0
#define mv_distanceJoint 1
#define mv_filterJoint 2
#define mv_motorJoint 3
#define mv_prismaticJoint 4
#define mv_revoluteJoint 5
#define mv_sphericalJoint 6
#define mv_weldJoint 7
#define mv_wheelJoint 8
#define mv_universalJoint 9
#define mv_sixDofJoint 10
#define mv_gearJoint 11
#define mv_rackPinionJoint 12
#define mv_pulleyJoint 13
#define mv_screwJoint 14
#define mv_axisFree 0
#define mv_axisLocked 1
#define mv_axisLimited 2
#define mv_solver_softStep 1
#define mv_solver_sequentialImpulse 2
#define mv_solver_projectedGaussSeidel 3
#define mv_solver_lemke 4
#define mv_solver_dantzig 5
#define mv_solver_proximalAdmm 6
#define mv_integrator_explicitEuler 1
#define mv_integrator_semiImplicitEuler 2
#define mv_integrator_moserVeselov 3
#define mv_integrator_symmetricSplitting 4
#define mv_integrator_lieMidpoint 5
#define mv_integrator_rk4 6
#define mv_integrator_exactRotation 7
#define mv_broadPhase_bruteForce 1
#define mv_broadPhase_dynamicBvh 2
#define mv_broadPhase_sortAndSweep 3
#define mv_broadPhase_sortAndSweep3 4
#define mv_broadPhase_rTree 5
#define mv_broadPhase_rStar 6
#define mv_broadPhase_str 7
#define mv_broadPhase_omt 8
#define mv_broadPhase_bruteForceSplit 9
#define mv_broadPhase_sortAndSweepSplit 10
#define mv_broadPhase_sortAndSweep3Split 11
#define mv_broadPhase_rTreeSplit 12
#define mv_broadPhase_rStarSplit 13
#define mv_broadPhase_strSplit 14
#define mv_broadPhase_omtSplit 15
#define mv_broadPhase_dynamicRTree 16
#define mv_narrowPhase_specialised 1
#define mv_narrowPhase_gjkEpa 2
#define mv_narrowPhase_gjkMpr 3
#define mv_gjk_barycentric 1
#define mv_gjk_cutSpace 2
#define mv_gjk_signedVolumes 3
#define mv_gjk_johnson 4
#define mv_manifold_sutherlandHodgman 1
#define mv_manifold_clipper2 2
#define mv_capsuleShape 0
#define mv_hullShape 3
#define mv_sphereShape 5
#define mv_planeShape 6
 mvVersion mvGetVersion(void);
 int32_t mvGetAbiRevision(void);
 bool mvIsDoublePrecision(void);
 uint32_t mvHash(uint32_t hash, const uint8_t *data, int count);
 mvBodyId mvCreateBody(mvWorldId worldId, const mvBodyDef *def);
 void mvDestroyBody(mvBodyId bodyId);
 bool mvBody_IsValid(mvBodyId id);
 mvWorldId mvBody_GetWorld(mvBodyId bodyId);
 mvBodyType mvBody_GetType(mvBodyId bodyId);
 void mvBody_SetType(mvBodyId bodyId, mvBodyType type);
 void mvBody_SetName(mvBodyId bodyId, const char *name);
 const char *mvBody_GetName(mvBodyId bodyId);
 void mvBody_SetUserData(mvBodyId bodyId, void *userData);
 void *mvBody_GetUserData(mvBodyId bodyId);
 bool mvBody_IsAwake(mvBodyId bodyId);
 void mvBody_SetAwake(mvBodyId bodyId, bool awake);
 void mvBody_EnableSleep(mvBodyId bodyId, bool enableSleep);
 bool mvBody_IsSleepEnabled(mvBodyId bodyId);
 void mvBody_SetSleepThreshold(mvBodyId bodyId, mvFloat sleepThreshold);
 mvFloat mvBody_GetSleepThreshold(mvBodyId bodyId);
int mvBody_GetSubStepCount(mvBodyId bodyId);
 bool mvBody_IsEnabled(mvBodyId bodyId);
 void mvBody_Disable(mvBodyId bodyId);
 void mvBody_Enable(mvBodyId bodyId);
 void mvBody_SetMotionLocks(mvBodyId bodyId, mvMotionLocks locks);
 mvMotionLocks mvBody_GetMotionLocks(mvBodyId bodyId);
 void mvBody_EnableHitEvents(mvBodyId bodyId, bool flag);
 int mvBody_GetShapeCount(mvBodyId bodyId);
 int mvBody_GetShapes(mvBodyId bodyId, mvShapeId *shapeArray, int capacity);
 int mvBody_GetJointCount(mvBodyId bodyId);
 int mvBody_GetJoints(mvBodyId bodyId, mvJointId *jointArray, int capacity);
 mvAABB mvBody_ComputeAABB(mvBodyId bodyId);
 int mvBody_GetContactCapacity(mvBodyId bodyId);
 int mvBody_GetContactData(mvBodyId bodyId, mvContactData *contactData, int capacity);
 mvFloat mvBody_GetMass(mvBodyId bodyId);
 mvFloat mvBody_GetInverseMass(mvBodyId bodyId);
 mvMatrix3 mvBody_GetLocalRotationalInertia(mvBodyId bodyId);
mvMatrix3 mvBody_GetWorldInverseRotationalInertia(mvBodyId bodyId);
 mvVec3 mvBody_GetLocalCenter(mvBodyId bodyId);
 mvPos mvBody_GetWorldCenter(mvBodyId bodyId);
void mvBody_SetMassData(mvBodyId bodyId,
                        mvMassData massData);
 mvMassData mvBody_GetMassData(mvBodyId bodyId);
void mvBody_ApplyMassFromShapes(mvBodyId bodyId);
 void mvBody_SetLinearDamping(mvBodyId bodyId, mvFloat linearDamping);
 mvFloat mvBody_GetLinearDamping(mvBodyId bodyId);
 void mvBody_SetAngularDamping(mvBodyId bodyId, mvFloat angularDamping);
 mvFloat mvBody_GetAngularDamping(mvBodyId bodyId);
 void mvBody_SetGravityScale(mvBodyId bodyId, mvFloat gravityScale);
 mvFloat mvBody_GetGravityScale(mvBodyId bodyId);
 mvPos mvBody_GetPosition(mvBodyId bodyId);
 mvQuat mvBody_GetRotation(mvBodyId bodyId);
 mvWorldTransform mvBody_GetTransform(mvBodyId bodyId);
 void mvBody_SetTransform(mvBodyId bodyId, mvPos position, mvQuat rotation);
void mvBody_SetTargetTransform(mvBodyId bodyId,
                               mvWorldTransform target,
                               mvFloat timeStep,
                               bool wake);
 mvVec3 mvBody_GetLocalPoint(mvBodyId bodyId, mvPos worldPoint);
 mvPos mvBody_GetWorldPoint(mvBodyId bodyId, mvVec3 localPoint);
 mvVec3 mvBody_GetLocalVector(mvBodyId bodyId, mvVec3 worldVector);
 mvVec3 mvBody_GetWorldVector(mvBodyId bodyId, mvVec3 localVector);
 mvVec3 mvBody_GetLocalPointVelocity(mvBodyId bodyId, mvVec3 localPoint);
 mvVec3 mvBody_GetWorldPointVelocity(mvBodyId bodyId, mvPos worldPoint);
 mvVec3 mvBody_GetLinearVelocity(mvBodyId bodyId);
 void mvBody_SetLinearVelocity(mvBodyId bodyId, mvVec3 linearVelocity);
 mvVec3 mvBody_GetAngularVelocity(mvBodyId bodyId);
 void mvBody_SetAngularVelocity(mvBodyId bodyId, mvVec3 angularVelocity);
 mvVec3 mvBody_GetMomentum(mvBodyId bodyId);
 void mvBody_SetMomentum(mvBodyId bodyId, mvVec3 momentum);
 mvVec3 mvBody_GetAngularMomentum(mvBodyId bodyId);
 void mvBody_SetAngularMomentum(mvBodyId bodyId, mvVec3 angularMomentum);
 mvFloat mvBody_GetKineticEnergy(mvBodyId bodyId);
 void mvBody_ApplyForce(mvBodyId bodyId, mvVec3 force, mvPos point, bool wake);
 void mvBody_ApplyForceToCenter(mvBodyId bodyId, mvVec3 force, bool wake);
 void mvBody_ApplyTorque(mvBodyId bodyId, mvVec3 torque, bool wake);
void mvBody_ApplyLinearImpulse(mvBodyId bodyId,
                               mvVec3 impulse,
                               mvPos point,
                               bool wake);
 void mvBody_ApplyLinearImpulseToCenter(mvBodyId bodyId, mvVec3 impulse, bool wake);
 void mvBody_ApplyAngularImpulse(mvBodyId bodyId, mvVec3 impulse, bool wake);
mvFloat mvBody_GetClosestPoint(mvBodyId bodyId,
                               mvVec3 *result,
                               mvVec3 target);
mvBodyCastResult mvBody_CastRay(mvBodyId bodyId,
                                mvPos origin,
                                mvVec3 translation,
                                mvQueryFilter filter,
                                mvFloat maxFraction,
                                mvWorldTransform bodyTransform);
mvBodyCastResult mvBody_CastShape(mvBodyId bodyId,
                                  mvPos origin,
                                  const mvShapeProxy *proxy,
                                  mvVec3 translation,
                                  mvQueryFilter filter,
                                  mvFloat maxFraction,
                                  bool canEncroach,
                                  mvWorldTransform bodyTransform);
bool mvBody_OverlapShape(mvBodyId bodyId,
                         mvPos origin,
                         const mvShapeProxy *proxy,
                         mvQueryFilter filter,
                         mvWorldTransform bodyTransform);
int mvWorld_GetAwakeBodies(mvWorldId worldId,
                           mvBodyId *ids,
                           mvWorldTransform *transforms,
                           mvVec3 *linear,
                           mvVec3 *angular,
                           int capacity);
void mvBody_SetTransforms(const mvBodyId *ids,
                          const mvWorldTransform *transforms,
                          int count);
void mvCollideSpheres(mvLocalManifold *manifold,
                      int capacity,
                      const mvSphere *sphereA,
                      const mvSphere *sphereB,
                      mvTransform transformBtoA);
void mvCollideCapsuleAndSphere(mvLocalManifold *manifold,
                               int capacity,
                               const mvCapsule *capsuleA,
                               const mvSphere *sphereB,
                               mvTransform transformBtoA);
void mvCollideCapsules(mvLocalManifold *manifold,
                       int capacity,
                       const mvCapsule *capsuleA,
                       const mvCapsule *capsuleB,
                       mvTransform transformBtoA);
void mvCollideHullAndSphere(mvLocalManifold *manifold,
                            int capacity,
                            const mvHullData *hullA,
                            const mvSphere *sphereB,
                            mvTransform transformBtoA,
                            mvSimplexCache *cache);
void mvCollideHullAndCapsule(mvLocalManifold *manifold,
                             int capacity,
                             const mvHullData *hullA,
                             const mvCapsule *capsuleB,
                             mvTransform transformBtoA,
                             mvSimplexCache *cache);
void mvCollideHulls(mvLocalManifold *manifold,
                    int capacity,
                    const mvHullData *hullA,
                    const mvHullData *hullB,
                    mvTransform transformBtoA,
                    mvSATCache *cache);
 bool mvContact_IsValid(mvContactId id);
 mvDebugDraw mvDefaultDebugDraw(void);
 void mvWorld_Draw(mvWorldId worldId, const mvDebugDraw *draw, uint64_t maskBits);
mvDrawBuffers mvWorld_DrawBuffers(mvWorldId worldId,
                                  const mvDebugDraw *draw,
                                  uint64_t maskBits);
 mvWorldDef mvDefaultWorldDef(void);
 mvBodyDef mvDefaultBodyDef(void);
 mvShapeDef mvDefaultShapeDef(void);
 mvFilter mvDefaultFilter(void);
 mvQueryFilter mvDefaultQueryFilter(void);
 mvSurfaceMaterial mvDefaultSurfaceMaterial(void);
mvDistanceOutput mvShapeDistance(const mvDistanceInput *input,
                                 mvSimplexCache *cache,
                                 mvSimplex *simplexes,
                                 int simplexCapacity);
 mvCastOutput mvShapeCast(const mvShapeCastPairInput *input);
bool mvOverlapSphere(const mvSphere *shape,
                     mvTransform shapeTransform,
                     const mvShapeProxy *proxy);
bool mvOverlapCapsule(const mvCapsule *shape,
                      mvTransform shapeTransform,
                      const mvShapeProxy *proxy);
bool mvOverlapHull(const mvHullData *shape,
                   mvTransform shapeTransform,
                   const mvShapeProxy *proxy);
mvCastOutput mvShapeCastSphere(const mvSphere *shape,
                               const mvShapeCastInput *input);
mvCastOutput mvShapeCastCapsule(const mvCapsule *shape,
                                const mvShapeCastInput *input);
mvCastOutput mvShapeCastHull(const mvHullData *shape,
                             const mvShapeCastInput *input);
mvErrorCode mvGetLastError(void);
 const char *mvGetLastErrorMessage(void);
 void mvSetLogFcn(mvLogFcn logFcn);
 void mvSetAssertFcn(mvAssertFcn assertFcn);
mvBodyEvents mvWorld_GetBodyEvents(mvWorldId worldId);
mvContactEvents mvWorld_GetContactEvents(mvWorldId worldId);
mvJointEvents mvWorld_GetJointEvents(mvWorldId worldId);
 mvMassData mvComputeSphereMass(const mvSphere *shape, mvFloat density);
 mvMassData mvComputeCapsuleMass(const mvCapsule *shape, mvFloat density);
 mvMassData mvComputeHullMass(const mvHullData *shape, mvFloat density);
 mvAABB mvComputeSphereAABB(const mvSphere *shape, mvTransform transform);
 mvAABB mvComputeCapsuleAABB(const mvCapsule *shape, mvTransform transform);
 mvAABB mvComputeHullAABB(const mvHullData *shape, mvTransform transform);
 bool mvIsValidRay(const mvRayCastInput *input);
 mvCastOutput mvRayCastSphere(const mvSphere *shape, const mvRayCastInput *input);
mvCastOutput mvRayCastCapsule(const mvCapsule *shape,
                              const mvRayCastInput *input);
 mvCastOutput mvRayCastHull(const mvHullData *shape, const mvRayCastInput *input);
mvHullData *mvCreateHull(const mvVec3 *points,
                         int pointCount,
                         int maxVertexCount);
 mvHullData *mvCreateCylinder(mvFloat height, mvFloat radius, mvFloat yOffset, int sides);
 mvHullData *mvCreateCone(mvFloat height, mvFloat radius1, mvFloat radius2, int slices);
 mvHullData *mvCloneHull(const mvHullData *hull);
mvHullData *mvCloneAndTransformHull(const mvHullData *original,
                                    mvTransform transform,
                                    mvVec3 scale);
 void mvDestroyHull(mvHullData *hull);
 mvBoxHull mvMakeCubeHull(mvFloat halfWidth);
 mvBoxHull mvMakeBoxHull(mvFloat hx, mvFloat hy, mvFloat hz);
 mvBoxHull mvMakeOffsetBoxHull(mvFloat hx, mvFloat hy, mvFloat hz, mvVec3 offset);
mvBoxHull mvMakeTransformedBoxHull(mvFloat hx,
                                   mvFloat hy,
                                   mvFloat hz,
                                   mvTransform transform);
 mvHumanDef mvDefaultHumanDef(void);
mvHuman mvCreateHuman(mvWorldId worldId,
                      const mvHumanDef *def);
 void mvDestroyHuman(const mvHuman *human);
 void mvHuman_SetFrictionTorque(const mvHuman *human, mvFloat torque);
 void mvHuman_SetSpring(const mvHuman *human, mvFloat hertz, mvFloat dampingRatio);
 void mvHuman_SetVelocity(const mvHuman *human, mvVec3 velocity);
void mvHuman_ApplyLinearImpulse(const mvHuman *human,
                                mvVec3 impulse);
 void mvDestroyJoint(mvJointId jointId, bool wakeAttached);
 bool mvJoint_IsValid(mvJointId id);
 mvJointType mvJoint_GetType(mvJointId jointId);
 mvBodyId mvJoint_GetBodyA(mvJointId jointId);
 mvBodyId mvJoint_GetBodyB(mvJointId jointId);
 mvWorldId mvJoint_GetWorld(mvJointId jointId);
 void mvJoint_SetLocalFrameA(mvJointId jointId, mvTransform localFrame);
 mvTransform mvJoint_GetLocalFrameA(mvJointId jointId);
 void mvJoint_SetLocalFrameB(mvJointId jointId, mvTransform localFrame);
 mvTransform mvJoint_GetLocalFrameB(mvJointId jointId);
 void mvJoint_SetCollideConnected(mvJointId jointId, bool shouldCollide);
 bool mvJoint_GetCollideConnected(mvJointId jointId);
 void mvJoint_SetUserData(mvJointId jointId, void *userData);
 void *mvJoint_GetUserData(mvJointId jointId);
 void mvJoint_WakeBodies(mvJointId jointId);
 mvVec3 mvJoint_GetConstraintForce(mvJointId jointId);
 mvVec3 mvJoint_GetConstraintTorque(mvJointId jointId);
 mvFloat mvJoint_GetLinearSeparation(mvJointId jointId);
 mvFloat mvJoint_GetAngularSeparation(mvJointId jointId);
 void mvJoint_SetConstraintTuning(mvJointId jointId, mvFloat hertz, mvFloat dampingRatio);
 void mvJoint_GetConstraintTuning(mvJointId jointId, mvFloat *hertz, mvFloat *dampingRatio);
 void mvJoint_SetForceThreshold(mvJointId jointId, mvFloat threshold);
 mvFloat mvJoint_GetForceThreshold(mvJointId jointId);
 void mvJoint_SetTorqueThreshold(mvJointId jointId, mvFloat threshold);
 mvFloat mvJoint_GetTorqueThreshold(mvJointId jointId);
 void mvJoint_SetBreakable(mvJointId jointId, bool flag);
 bool mvJoint_IsBreakable(mvJointId jointId);
 mvFloat mvJoint_GetDrawScale(mvJointId jointId);
 mvDistanceJointDef mvDefaultDistanceJointDef(void);
mvJointId mvCreateDistanceJoint(mvWorldId worldId,
                                const mvDistanceJointDef *def);
 void mvDistanceJoint_SetLength(mvJointId jointId, mvFloat length);
 mvFloat mvDistanceJoint_GetLength(mvJointId jointId);
 void mvDistanceJoint_EnableSpring(mvJointId jointId, bool flag);
 bool mvDistanceJoint_IsSpringEnabled(mvJointId jointId);
void mvDistanceJoint_SetSpringForceRange(mvJointId jointId,
                                         mvFloat lowerForce,
                                         mvFloat upperForce);
void mvDistanceJoint_GetSpringForceRange(mvJointId jointId,
                                         mvFloat *lowerForce,
                                         mvFloat *upperForce);
 void mvDistanceJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvDistanceJoint_GetSpringHertz(mvJointId jointId);
 void mvDistanceJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvDistanceJoint_GetSpringDampingRatio(mvJointId jointId);
 void mvDistanceJoint_EnableLimit(mvJointId jointId, bool flag);
 bool mvDistanceJoint_IsLimitEnabled(mvJointId jointId);
 void mvDistanceJoint_SetLengthRange(mvJointId jointId, mvFloat minLength, mvFloat maxLength);
 mvFloat mvDistanceJoint_GetMinLength(mvJointId jointId);
 mvFloat mvDistanceJoint_GetMaxLength(mvJointId jointId);
 mvFloat mvDistanceJoint_GetCurrentLength(mvJointId jointId);
 void mvDistanceJoint_EnableMotor(mvJointId jointId, bool flag);
 bool mvDistanceJoint_IsMotorEnabled(mvJointId jointId);
 void mvDistanceJoint_SetMotorSpeed(mvJointId jointId, mvFloat motorSpeed);
 mvFloat mvDistanceJoint_GetMotorSpeed(mvJointId jointId);
 void mvDistanceJoint_SetMaxMotorForce(mvJointId jointId, mvFloat force);
 mvFloat mvDistanceJoint_GetMaxMotorForce(mvJointId jointId);
 mvFloat mvDistanceJoint_GetMotorForce(mvJointId jointId);
 mvFilterJointDef mvDefaultFilterJointDef(void);
mvJointId mvCreateFilterJoint(mvWorldId worldId,
                              const mvFilterJointDef *def);
 mvGearJointDef mvDefaultGearJointDef(void);
mvJointId mvCreateGearJoint(mvWorldId worldId,
                            const mvGearJointDef *def);
 void mvGearJoint_SetRatio(mvJointId jointId, mvFloat ratio);
 mvFloat mvGearJoint_GetRatio(mvJointId jointId);
 mvMotorJointDef mvDefaultMotorJointDef(void);
mvJointId mvCreateMotorJoint(mvWorldId worldId,
                             const mvMotorJointDef *def);
 void mvMotorJoint_SetLinearVelocity(mvJointId jointId, mvVec3 velocity);
 mvVec3 mvMotorJoint_GetLinearVelocity(mvJointId jointId);
 void mvMotorJoint_SetAngularVelocity(mvJointId jointId, mvVec3 velocity);
 mvVec3 mvMotorJoint_GetAngularVelocity(mvJointId jointId);
 void mvMotorJoint_SetMaxVelocityForce(mvJointId jointId, mvFloat maxForce);
 mvFloat mvMotorJoint_GetMaxVelocityForce(mvJointId jointId);
 void mvMotorJoint_SetMaxVelocityTorque(mvJointId jointId, mvFloat maxTorque);
 mvFloat mvMotorJoint_GetMaxVelocityTorque(mvJointId jointId);
 void mvMotorJoint_SetLinearHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvMotorJoint_GetLinearHertz(mvJointId jointId);
 void mvMotorJoint_SetLinearDampingRatio(mvJointId jointId, mvFloat damping);
 mvFloat mvMotorJoint_GetLinearDampingRatio(mvJointId jointId);
 void mvMotorJoint_SetAngularHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvMotorJoint_GetAngularHertz(mvJointId jointId);
 void mvMotorJoint_SetAngularDampingRatio(mvJointId jointId, mvFloat damping);
 mvFloat mvMotorJoint_GetAngularDampingRatio(mvJointId jointId);
 void mvMotorJoint_SetMaxSpringForce(mvJointId jointId, mvFloat maxForce);
 mvFloat mvMotorJoint_GetMaxSpringForce(mvJointId jointId);
 void mvMotorJoint_SetMaxSpringTorque(mvJointId jointId, mvFloat maxTorque);
 mvFloat mvMotorJoint_GetMaxSpringTorque(mvJointId jointId);
 mvParallelJointDef mvDefaultParallelJointDef(void);
mvJointId mvCreateParallelJoint(mvWorldId worldId,
                                const mvParallelJointDef *def);
 void mvParallelJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvParallelJoint_GetSpringHertz(mvJointId jointId);
 void mvParallelJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvParallelJoint_GetSpringDampingRatio(mvJointId jointId);
 void mvParallelJoint_SetMaxTorque(mvJointId jointId, mvFloat maxTorque);
 mvFloat mvParallelJoint_GetMaxTorque(mvJointId jointId);
 mvPrismaticJointDef mvDefaultPrismaticJointDef(void);
mvJointId mvCreatePrismaticJoint(mvWorldId worldId,
                                 const mvPrismaticJointDef *def);
 void mvPrismaticJoint_EnableSpring(mvJointId jointId, bool flag);
 bool mvPrismaticJoint_IsSpringEnabled(mvJointId jointId);
 void mvPrismaticJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvPrismaticJoint_GetSpringHertz(mvJointId jointId);
 void mvPrismaticJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvPrismaticJoint_GetSpringDampingRatio(mvJointId jointId);
 void mvPrismaticJoint_SetMaxSpringForce(mvJointId jointId, mvFloat maxForce);
 mvFloat mvPrismaticJoint_GetMaxSpringForce(mvJointId jointId);
 void mvPrismaticJoint_SetTargetTranslation(mvJointId jointId, mvFloat targetTranslation);
 mvFloat mvPrismaticJoint_GetTargetTranslation(mvJointId jointId);
 void mvPrismaticJoint_EnableLimit(mvJointId jointId, bool flag);
 bool mvPrismaticJoint_IsLimitEnabled(mvJointId jointId);
 void mvPrismaticJoint_SetLimits(mvJointId jointId, mvFloat lower, mvFloat upper);
 mvFloat mvPrismaticJoint_GetLowerLimit(mvJointId jointId);
 mvFloat mvPrismaticJoint_GetUpperLimit(mvJointId jointId);
 void mvPrismaticJoint_EnableMotor(mvJointId jointId, bool flag);
 bool mvPrismaticJoint_IsMotorEnabled(mvJointId jointId);
 void mvPrismaticJoint_SetMotorSpeed(mvJointId jointId, mvFloat motorSpeed);
 mvFloat mvPrismaticJoint_GetMotorSpeed(mvJointId jointId);
 void mvPrismaticJoint_SetMaxMotorForce(mvJointId jointId, mvFloat maxForce);
 mvFloat mvPrismaticJoint_GetMaxMotorForce(mvJointId jointId);
 mvFloat mvPrismaticJoint_GetMotorForce(mvJointId jointId);
 void mvPrismaticJoint_SetFriction(mvJointId jointId, mvFloat friction);
 mvFloat mvPrismaticJoint_GetFriction(mvJointId jointId);
 mvFloat mvPrismaticJoint_GetTranslation(mvJointId jointId);
 mvFloat mvPrismaticJoint_GetSpeed(mvJointId jointId);
 mvPulleyJointDef mvDefaultPulleyJointDef(void);
mvJointId mvCreatePulleyJoint(mvWorldId worldId,
                              const mvPulleyJointDef *def);
 void mvPulleyJoint_SetGroundAnchorA(mvJointId jointId, mvPos anchor);
 mvPos mvPulleyJoint_GetGroundAnchorA(mvJointId jointId);
 mvFloat mvPulleyJoint_GetCurrentLengthA(mvJointId jointId);
 void mvPulleyJoint_SetGroundAnchorB(mvJointId jointId, mvPos anchor);
 mvPos mvPulleyJoint_GetGroundAnchorB(mvJointId jointId);
 mvFloat mvPulleyJoint_GetCurrentLengthB(mvJointId jointId);
 void mvPulleyJoint_SetRatio(mvJointId jointId, mvFloat ratio);
 mvFloat mvPulleyJoint_GetRatio(mvJointId jointId);
 void mvPulleyJoint_SetLengthRange(mvJointId jointId, mvFloat minLength, mvFloat maxLength);
 mvFloat mvPulleyJoint_GetMinLength(mvJointId jointId);
 mvFloat mvPulleyJoint_GetMaxLength(mvJointId jointId);
 mvFloat mvPulleyJoint_GetCurrentLength(mvJointId jointId);
 mvRackPinionJointDef mvDefaultRackPinionJointDef(void);
mvJointId mvCreateRackPinionJoint(mvWorldId worldId,
                                  const mvRackPinionJointDef *def);
 void mvRackPinionJoint_SetRatio(mvJointId jointId, mvFloat ratio);
 mvFloat mvRackPinionJoint_GetRatio(mvJointId jointId);
 mvRevoluteJointDef mvDefaultRevoluteJointDef(void);
mvJointId mvCreateRevoluteJoint(mvWorldId worldId,
                                const mvRevoluteJointDef *def);
 void mvRevoluteJoint_EnableSpring(mvJointId jointId, bool flag);
 bool mvRevoluteJoint_IsSpringEnabled(mvJointId jointId);
 void mvRevoluteJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvRevoluteJoint_GetSpringHertz(mvJointId jointId);
 void mvRevoluteJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvRevoluteJoint_GetSpringDampingRatio(mvJointId jointId);
 void mvRevoluteJoint_SetMaxSpringTorque(mvJointId jointId, mvFloat maxTorque);
 mvFloat mvRevoluteJoint_GetMaxSpringTorque(mvJointId jointId);
 void mvRevoluteJoint_SetTargetAngle(mvJointId jointId, mvFloat angle);
 mvFloat mvRevoluteJoint_GetTargetAngle(mvJointId jointId);
 void mvRevoluteJoint_EnableLimit(mvJointId jointId, bool flag);
 bool mvRevoluteJoint_IsLimitEnabled(mvJointId jointId);
 void mvRevoluteJoint_SetLimits(mvJointId jointId, mvFloat lower, mvFloat upper);
 mvFloat mvRevoluteJoint_GetLowerLimit(mvJointId jointId);
 mvFloat mvRevoluteJoint_GetUpperLimit(mvJointId jointId);
 void mvRevoluteJoint_EnableMotor(mvJointId jointId, bool flag);
 bool mvRevoluteJoint_IsMotorEnabled(mvJointId jointId);
 void mvRevoluteJoint_SetMotorSpeed(mvJointId jointId, mvFloat motorSpeed);
 mvFloat mvRevoluteJoint_GetMotorSpeed(mvJointId jointId);
 void mvRevoluteJoint_SetMaxMotorTorque(mvJointId jointId, mvFloat maxTorque);
 mvFloat mvRevoluteJoint_GetMaxMotorTorque(mvJointId jointId);
 mvFloat mvRevoluteJoint_GetMotorTorque(mvJointId jointId);
 void mvRevoluteJoint_SetFriction(mvJointId jointId, mvFloat friction);
 mvFloat mvRevoluteJoint_GetFriction(mvJointId jointId);
 mvFloat mvRevoluteJoint_GetAngle(mvJointId jointId);
 mvFloat mvRevoluteJoint_GetSpeed(mvJointId jointId);
 mvScrewJointDef mvDefaultScrewJointDef(void);
mvJointId mvCreateScrewJoint(mvWorldId worldId,
                             const mvScrewJointDef *def);
 void mvScrewJoint_SetPitch(mvJointId jointId, mvFloat pitch);
 mvFloat mvScrewJoint_GetPitch(mvJointId jointId);
 void mvScrewJoint_EnableSpring(mvJointId jointId, bool flag);
 bool mvScrewJoint_IsSpringEnabled(mvJointId jointId);
 void mvScrewJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvScrewJoint_GetSpringHertz(mvJointId jointId);
 void mvScrewJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvScrewJoint_GetSpringDampingRatio(mvJointId jointId);
 void mvScrewJoint_SetMaxSpringTorque(mvJointId jointId, mvFloat maxTorque);
 mvFloat mvScrewJoint_GetMaxSpringTorque(mvJointId jointId);
 void mvScrewJoint_SetTargetAngle(mvJointId jointId, mvFloat angle);
 mvFloat mvScrewJoint_GetTargetAngle(mvJointId jointId);
 void mvScrewJoint_EnableLimit(mvJointId jointId, bool flag);
 bool mvScrewJoint_IsLimitEnabled(mvJointId jointId);
 void mvScrewJoint_SetLimits(mvJointId jointId, mvFloat lower, mvFloat upper);
 mvFloat mvScrewJoint_GetLowerLimit(mvJointId jointId);
 mvFloat mvScrewJoint_GetUpperLimit(mvJointId jointId);
 void mvScrewJoint_EnableMotor(mvJointId jointId, bool flag);
 bool mvScrewJoint_IsMotorEnabled(mvJointId jointId);
 void mvScrewJoint_SetMotorSpeed(mvJointId jointId, mvFloat motorSpeed);
 mvFloat mvScrewJoint_GetMotorSpeed(mvJointId jointId);
 void mvScrewJoint_SetMaxMotorTorque(mvJointId jointId, mvFloat maxTorque);
 mvFloat mvScrewJoint_GetMaxMotorTorque(mvJointId jointId);
 mvFloat mvScrewJoint_GetMotorTorque(mvJointId jointId);
 void mvScrewJoint_SetFriction(mvJointId jointId, mvFloat friction);
 mvFloat mvScrewJoint_GetFriction(mvJointId jointId);
 mvFloat mvScrewJoint_GetAngle(mvJointId jointId);
 mvFloat mvScrewJoint_GetSpeed(mvJointId jointId);
 mvFloat mvScrewJoint_GetTranslation(mvJointId jointId);
 mvSixDofJointDef mvDefaultSixDofJointDef(void);
mvJointId mvCreateSixDofJoint(mvWorldId worldId,
                              const mvSixDofJointDef *def);
 void mvSixDofJoint_SetAxis(mvJointId jointId, int axis, mvSixDofAxis value);
 mvSixDofAxis mvSixDofJoint_GetAxis(mvJointId jointId, int axis);
 mvFloat mvSixDofJoint_GetCoordinate(mvJointId jointId, int axis);
 mvSphericalJointDef mvDefaultSphericalJointDef(void);
mvJointId mvCreateSphericalJoint(mvWorldId worldId,
                                 const mvSphericalJointDef *def);
 void mvSphericalJoint_EnableConeLimit(mvJointId jointId, bool flag);
 bool mvSphericalJoint_IsConeLimitEnabled(mvJointId jointId);
 mvFloat mvSphericalJoint_GetConeLimit(mvJointId jointId);
 void mvSphericalJoint_SetConeLimit(mvJointId jointId, mvFloat angle);
 void mvSphericalJoint_SetConeLimits(mvJointId jointId, mvFloat angleX, mvFloat angleY);
 mvFloat mvSphericalJoint_GetConeLimitY(mvJointId jointId);
 mvFloat mvSphericalJoint_GetConeAngle(mvJointId jointId);
 void mvSphericalJoint_EnableTwistLimit(mvJointId jointId, bool flag);
 bool mvSphericalJoint_IsTwistLimitEnabled(mvJointId jointId);
 void mvSphericalJoint_SetTwistLimits(mvJointId jointId, mvFloat lower, mvFloat upper);
 mvFloat mvSphericalJoint_GetLowerTwistLimit(mvJointId jointId);
 mvFloat mvSphericalJoint_GetUpperTwistLimit(mvJointId jointId);
 mvFloat mvSphericalJoint_GetTwistAngle(mvJointId jointId);
 void mvSphericalJoint_EnableSpring(mvJointId jointId, bool flag);
 bool mvSphericalJoint_IsSpringEnabled(mvJointId jointId);
 void mvSphericalJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvSphericalJoint_GetSpringHertz(mvJointId jointId);
 void mvSphericalJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvSphericalJoint_GetSpringDampingRatio(mvJointId jointId);
 void mvSphericalJoint_SetMaxSpringTorque(mvJointId jointId, mvFloat maxTorque);
 mvFloat mvSphericalJoint_GetMaxSpringTorque(mvJointId jointId);
 void mvSphericalJoint_SetTargetRotation(mvJointId jointId, mvQuat targetRotation);
 mvQuat mvSphericalJoint_GetTargetRotation(mvJointId jointId);
 void mvSphericalJoint_EnableMotor(mvJointId jointId, bool flag);
 bool mvSphericalJoint_IsMotorEnabled(mvJointId jointId);
 void mvSphericalJoint_SetMotorVelocity(mvJointId jointId, mvVec3 motorVelocity);
 mvVec3 mvSphericalJoint_GetMotorVelocity(mvJointId jointId);
 mvVec3 mvSphericalJoint_GetMotorTorque(mvJointId jointId);
 void mvSphericalJoint_SetMaxMotorTorque(mvJointId jointId, mvFloat torque);
 mvFloat mvSphericalJoint_GetMaxMotorTorque(mvJointId jointId);
 void mvSphericalJoint_SetFriction(mvJointId jointId, mvFloat friction);
 mvFloat mvSphericalJoint_GetFriction(mvJointId jointId);
 mvUniversalJointDef mvDefaultUniversalJointDef(void);
mvJointId mvCreateUniversalJoint(mvWorldId worldId,
                                 const mvUniversalJointDef *def);
 mvFloat mvUniversalJoint_GetAngle1(mvJointId jointId);
 void mvUniversalJoint_EnableSpring1(mvJointId jointId, bool flag);
 bool mvUniversalJoint_IsSpring1Enabled(mvJointId jointId);
 void mvUniversalJoint_SetSpringHertz1(mvJointId jointId, mvFloat hertz);
 mvFloat mvUniversalJoint_GetSpringHertz1(mvJointId jointId);
 void mvUniversalJoint_SetSpringDampingRatio1(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvUniversalJoint_GetSpringDampingRatio1(mvJointId jointId);
 void mvUniversalJoint_SetTargetAngle1(mvJointId jointId, mvFloat angle);
 mvFloat mvUniversalJoint_GetTargetAngle1(mvJointId jointId);
 void mvUniversalJoint_EnableLimit1(mvJointId jointId, bool flag);
 bool mvUniversalJoint_IsLimit1Enabled(mvJointId jointId);
 void mvUniversalJoint_SetLimits1(mvJointId jointId, mvFloat lower, mvFloat upper);
 mvFloat mvUniversalJoint_GetLowerLimit1(mvJointId jointId);
 mvFloat mvUniversalJoint_GetUpperLimit1(mvJointId jointId);
 void mvUniversalJoint_EnableMotor1(mvJointId jointId, bool flag);
 bool mvUniversalJoint_IsMotor1Enabled(mvJointId jointId);
 void mvUniversalJoint_SetMotorSpeed1(mvJointId jointId, mvFloat motorSpeed);
 mvFloat mvUniversalJoint_GetMotorSpeed1(mvJointId jointId);
 void mvUniversalJoint_SetMaxMotorTorque1(mvJointId jointId, mvFloat torque);
 mvFloat mvUniversalJoint_GetMaxMotorTorque1(mvJointId jointId);
 void mvUniversalJoint_SetFriction1(mvJointId jointId, mvFloat torque);
 mvFloat mvUniversalJoint_GetFriction1(mvJointId jointId);
 mvFloat mvUniversalJoint_GetAngle2(mvJointId jointId);
 void mvUniversalJoint_EnableSpring2(mvJointId jointId, bool flag);
 bool mvUniversalJoint_IsSpring2Enabled(mvJointId jointId);
 void mvUniversalJoint_SetSpringHertz2(mvJointId jointId, mvFloat hertz);
 mvFloat mvUniversalJoint_GetSpringHertz2(mvJointId jointId);
 void mvUniversalJoint_SetSpringDampingRatio2(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvUniversalJoint_GetSpringDampingRatio2(mvJointId jointId);
 void mvUniversalJoint_SetTargetAngle2(mvJointId jointId, mvFloat angle);
 mvFloat mvUniversalJoint_GetTargetAngle2(mvJointId jointId);
 void mvUniversalJoint_EnableLimit2(mvJointId jointId, bool flag);
 bool mvUniversalJoint_IsLimit2Enabled(mvJointId jointId);
 void mvUniversalJoint_SetLimits2(mvJointId jointId, mvFloat lower, mvFloat upper);
 mvFloat mvUniversalJoint_GetLowerLimit2(mvJointId jointId);
 mvFloat mvUniversalJoint_GetUpperLimit2(mvJointId jointId);
 void mvUniversalJoint_EnableMotor2(mvJointId jointId, bool flag);
 bool mvUniversalJoint_IsMotor2Enabled(mvJointId jointId);
 void mvUniversalJoint_SetMotorSpeed2(mvJointId jointId, mvFloat motorSpeed);
 mvFloat mvUniversalJoint_GetMotorSpeed2(mvJointId jointId);
 void mvUniversalJoint_SetMaxMotorTorque2(mvJointId jointId, mvFloat torque);
 mvFloat mvUniversalJoint_GetMaxMotorTorque2(mvJointId jointId);
 void mvUniversalJoint_SetFriction2(mvJointId jointId, mvFloat torque);
 mvFloat mvUniversalJoint_GetFriction2(mvJointId jointId);
 mvWeldJointDef mvDefaultWeldJointDef(void);
mvJointId mvCreateWeldJoint(mvWorldId worldId,
                            const mvWeldJointDef *def);
 void mvWeldJoint_SetLinearHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvWeldJoint_GetLinearHertz(mvJointId jointId);
 void mvWeldJoint_SetLinearDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvWeldJoint_GetLinearDampingRatio(mvJointId jointId);
 void mvWeldJoint_SetAngularHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvWeldJoint_GetAngularHertz(mvJointId jointId);
 void mvWeldJoint_SetAngularDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvWeldJoint_GetAngularDampingRatio(mvJointId jointId);
 mvWheelJointDef mvDefaultWheelJointDef(void);
mvJointId mvCreateWheelJoint(mvWorldId worldId,
                             const mvWheelJointDef *def);
 void mvWheelJoint_EnableSuspension(mvJointId jointId, bool flag);
 bool mvWheelJoint_IsSuspensionEnabled(mvJointId jointId);
 void mvWheelJoint_SetSuspensionHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvWheelJoint_GetSuspensionHertz(mvJointId jointId);
 void mvWheelJoint_SetSuspensionDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvWheelJoint_GetSuspensionDampingRatio(mvJointId jointId);
 void mvWheelJoint_SetTargetSuspension(mvJointId jointId, mvFloat travel);
 mvFloat mvWheelJoint_GetTargetSuspension(mvJointId jointId);
 void mvWheelJoint_SetMaxSuspensionForce(mvJointId jointId, mvFloat force);
 mvFloat mvWheelJoint_GetMaxSuspensionForce(mvJointId jointId);
 mvFloat mvWheelJoint_GetSuspensionTravel(mvJointId jointId);
 void mvWheelJoint_EnableSuspensionLimit(mvJointId jointId, bool flag);
 bool mvWheelJoint_IsSuspensionLimitEnabled(mvJointId jointId);
 void mvWheelJoint_SetSuspensionLimits(mvJointId jointId, mvFloat lower, mvFloat upper);
 mvFloat mvWheelJoint_GetLowerSuspensionLimit(mvJointId jointId);
 mvFloat mvWheelJoint_GetUpperSuspensionLimit(mvJointId jointId);
 void mvWheelJoint_EnableSpinMotor(mvJointId jointId, bool flag);
 bool mvWheelJoint_IsSpinMotorEnabled(mvJointId jointId);
 void mvWheelJoint_SetSpinMotorSpeed(mvJointId jointId, mvFloat speed);
 mvFloat mvWheelJoint_GetSpinMotorSpeed(mvJointId jointId);
 void mvWheelJoint_SetMaxSpinTorque(mvJointId jointId, mvFloat torque);
 mvFloat mvWheelJoint_GetMaxSpinTorque(mvJointId jointId);
 void mvWheelJoint_SetSpinFriction(mvJointId jointId, mvFloat torque);
 mvFloat mvWheelJoint_GetSpinFriction(mvJointId jointId);
 mvFloat mvWheelJoint_GetSpinSpeed(mvJointId jointId);
 mvFloat mvWheelJoint_GetSpinAngle(mvJointId jointId);
 mvFloat mvWheelJoint_GetSpinTorque(mvJointId jointId);
 void mvWheelJoint_EnableSteering(mvJointId jointId, bool flag);
 bool mvWheelJoint_IsSteeringEnabled(mvJointId jointId);
 void mvWheelJoint_SetSteeringHertz(mvJointId jointId, mvFloat hertz);
 mvFloat mvWheelJoint_GetSteeringHertz(mvJointId jointId);
 void mvWheelJoint_SetSteeringDampingRatio(mvJointId jointId, mvFloat dampingRatio);
 mvFloat mvWheelJoint_GetSteeringDampingRatio(mvJointId jointId);
 void mvWheelJoint_SetMaxSteeringTorque(mvJointId jointId, mvFloat torque);
 mvFloat mvWheelJoint_GetMaxSteeringTorque(mvJointId jointId);
 void mvWheelJoint_EnableSteeringLimit(mvJointId jointId, bool flag);
 bool mvWheelJoint_IsSteeringLimitEnabled(mvJointId jointId);
 void mvWheelJoint_SetSteeringLimits(mvJointId jointId, mvFloat lower, mvFloat upper);
 mvFloat mvWheelJoint_GetLowerSteeringLimit(mvJointId jointId);
 mvFloat mvWheelJoint_GetUpperSteeringLimit(mvJointId jointId);
 void mvWheelJoint_SetTargetSteeringAngle(mvJointId jointId, mvFloat angle);
 mvFloat mvWheelJoint_GetTargetSteeringAngle(mvJointId jointId);
 mvFloat mvWheelJoint_GetSteeringAngle(mvJointId jointId);
 mvFloat mvWheelJoint_GetSteeringTorque(mvJointId jointId);
 const char *mvGetSolverKindName(mvSolverKind kind);
 const char *mvGetIntegratorKindName(mvIntegratorKind kind);
 const char *mvGetBroadPhaseKindName(mvBroadPhaseKind kind);
 const char *mvGetNarrowPhaseKindName(mvNarrowPhaseKind kind);
 const char *mvGetGjkKindName(mvGjkKind kind);
 const char *mvGetManifoldKindName(mvManifoldKind kind);
 bool mvIsValidFloat(mvFloat a);
 bool mvIsValidVec3(mvVec3 a);
 bool mvIsValidQuat(mvQuat q);
 bool mvIsValidTransform(mvTransform a);
 bool mvIsValidMatrix3(mvMatrix3 a);
 bool mvIsValidAABB(mvAABB a);
 bool mvIsBoundedAABB(mvAABB a);
 bool mvIsSaneAABB(mvAABB a);
 bool mvIsValidPlane(mvPlane a);
 bool mvIsValidPosition(mvPos p);
 bool mvIsValidWorldTransform(mvWorldTransform t);
 mvFloat mvAtan2(mvFloat y, mvFloat x);
 mvCosSin mvComputeCosSin(mvFloat radians);
 mvQuat mvMakeQuatFromMatrix(const mvMatrix3 *m);
mvQuat mvComputeQuatBetweenUnitVectors(mvVec3 v1,
                                       mvVec3 v2);
 mvMatrix3 mvSteiner(mvFloat mass, mvVec3 origin);
 mvVec3 mvPointToSegmentDistance(mvVec3 a, mvVec3 b, mvVec3 q);
mvSegmentDistanceResult mvLineDistance(mvVec3 p1,
                                       mvVec3 d1,
                                       mvVec3 p2,
                                       mvVec3 d2);
mvSegmentDistanceResult mvSegmentDistance(mvVec3 p1,
                                          mvVec3 q1,
                                          mvVec3 p2,
                                          mvVec3 q2);
mvTreeStats mvWorld_OverlapAABB(mvWorldId worldId,
                                mvAABB aabb,
                                mvQueryFilter filter,
                                mvOverlapResultFcn fcn,
                                void *context);
int mvWorld_OverlapAABBAll(mvWorldId worldId,
                           mvAABB aabb,
                           mvQueryFilter filter,
                           mvShapeId *shapeIds,
                           int capacity);
mvTreeStats mvWorld_OverlapShape(mvWorldId worldId,
                                 mvPos origin,
                                 const mvShapeProxy *proxy,
                                 mvQueryFilter filter,
                                 mvOverlapResultFcn fcn,
                                 void *context);
int mvWorld_OverlapShapeAll(mvWorldId worldId,
                            mvPos origin,
                            const mvShapeProxy *proxy,
                            mvQueryFilter filter,
                            mvShapeId *shapeIds,
                            int capacity);
mvTreeStats mvWorld_CastRay(mvWorldId worldId,
                            mvPos origin,
                            mvVec3 translation,
                            mvQueryFilter filter,
                            mvCastResultFcn fcn,
                            void *context);
mvRayResult mvWorld_CastRayClosest(mvWorldId worldId,
                                   mvPos origin,
                                   mvVec3 translation,
                                   mvQueryFilter filter);
int mvWorld_CastRayAll(mvWorldId worldId,
                       mvPos origin,
                       mvVec3 translation,
                       mvQueryFilter filter,
                       mvRayResult *results,
                       int capacity);
mvTreeStats mvWorld_CastShape(mvWorldId worldId,
                              mvPos origin,
                              const mvShapeProxy *proxy,
                              mvVec3 translation,
                              mvQueryFilter filter,
                              mvCastResultFcn fcn,
                              void *context);
mvRayResult mvWorld_CastShapeClosest(mvWorldId worldId,
                                     mvPos origin,
                                     const mvShapeProxy *proxy,
                                     mvVec3 translation,
                                     mvQueryFilter filter);
int mvWorld_CastShapeAll(mvWorldId worldId,
                         mvPos origin,
                         const mvShapeProxy *proxy,
                         mvVec3 translation,
                         mvQueryFilter filter,
                         mvRayResult *results,
                         int capacity);
mvShapeId mvCreateSphereShape(mvBodyId bodyId,
                              const mvShapeDef *def,
                              const mvSphere *sphere);
mvShapeId mvCreateCapsuleShape(mvBodyId bodyId,
                               const mvShapeDef *def,
                               const mvCapsule *capsule);
mvShapeId mvCreateHullShape(mvBodyId bodyId,
                            const mvShapeDef *def,
                            const mvHullData *hull);
mvShapeId mvCreateTransformedHullShape(mvBodyId bodyId,
                                       const mvShapeDef *def,
                                       const mvHullData *hull,
                                       mvTransform transform,
                                       mvVec3 scale);
mvShapeId mvCreateBoxShape(mvBodyId bodyId,
                           const mvShapeDef *def,
                           mvFloat hx,
                           mvFloat hy,
                           mvFloat hz);
mvShapeId mvCreatePlaneShape(mvBodyId bodyId,
                             const mvShapeDef *def,
                             const mvPlane *plane);
 void mvDestroyShape(mvShapeId shapeId, bool updateBodyMass);
 bool mvShape_IsValid(mvShapeId id);
 mvShapeType mvShape_GetType(mvShapeId shapeId);
 mvBodyId mvShape_GetBody(mvShapeId shapeId);
 mvWorldId mvShape_GetWorld(mvShapeId shapeId);
 void mvShape_SetName(mvShapeId shapeId, const char *name);
const char *mvShape_GetName(mvShapeId shapeId);
 void mvShape_SetUserData(mvShapeId shapeId, void *userData);
 void *mvShape_GetUserData(mvShapeId shapeId);
 mvSphere mvShape_GetSphere(mvShapeId shapeId);
 mvCapsule mvShape_GetCapsule(mvShapeId shapeId);
 const mvHullData *mvShape_GetHull(mvShapeId shapeId);
 mvPlane mvShape_GetPlane(mvShapeId shapeId);
 void mvShape_SetSphere(mvShapeId shapeId, const mvSphere *sphere);
 void mvShape_SetCapsule(mvShapeId shapeId, const mvCapsule *capsule);
 void mvShape_SetHull(mvShapeId shapeId, const mvHullData *hull);
 void mvShape_SetDensity(mvShapeId shapeId, mvFloat density, bool updateBodyMass);
 mvFloat mvShape_GetDensity(mvShapeId shapeId);
 void mvShape_SetFriction(mvShapeId shapeId, mvFloat friction);
 mvFloat mvShape_GetFriction(mvShapeId shapeId);
 void mvShape_SetStaticFriction(mvShapeId shapeId, mvFloat staticFriction);
 mvFloat mvShape_GetStaticFriction(mvShapeId shapeId);
 void mvShape_SetRestitution(mvShapeId shapeId, mvFloat restitution);
 mvFloat mvShape_GetRestitution(mvShapeId shapeId);
 void mvShape_SetSurfaceMaterial(mvShapeId shapeId, mvSurfaceMaterial surfaceMaterial);
 mvSurfaceMaterial mvShape_GetSurfaceMaterial(mvShapeId shapeId);
 mvFilter mvShape_GetFilter(mvShapeId shapeId);
void mvShape_SetFilter(mvShapeId shapeId,
                       mvFilter filter,
                       bool invokeContacts);
 void mvShape_EnableContactEvents(mvShapeId shapeId, bool flag);
 bool mvShape_AreContactEventsEnabled(mvShapeId shapeId);
 void mvShape_EnablePreSolveEvents(mvShapeId shapeId, bool flag);
 bool mvShape_ArePreSolveEventsEnabled(mvShapeId shapeId);
 void mvShape_EnableHitEvents(mvShapeId shapeId, bool flag);
 bool mvShape_AreHitEventsEnabled(mvShapeId shapeId);
mvWorldCastOutput mvShape_RayCast(mvShapeId shapeId,
                                  mvPos origin,
                                  mvVec3 translation);
 mvAABB mvShape_GetAABB(mvShapeId shapeId);
 mvMassData mvShape_ComputeMassData(mvShapeId shapeId);
 mvVec3 mvShape_GetClosestPoint(mvShapeId shapeId, mvVec3 target);
 int mvShape_GetContactCapacity(mvShapeId shapeId);
 int mvShape_GetContactData(mvShapeId shapeId, mvContactData *contactData, int capacity);
 mvWorldId mvCreateWorld(const mvWorldDef *def);
 void mvDestroyWorld(mvWorldId worldId);
 int mvGetWorldCount(void);
 int64_t mvGetByteCount(void);
 bool mvWorld_IsValid(mvWorldId id);
void mvWorld_Step(mvWorldId worldId,
                  mvFloat timeStep,
                  int subStepCount);
mvAABB mvWorld_GetBounds(mvWorldId worldId);
 void mvWorld_RebuildStaticTree(mvWorldId worldId);
 void mvWorld_SetUserData(mvWorldId worldId, void *userData);
 void *mvWorld_GetUserData(mvWorldId worldId);
 void mvWorld_SetCustomFilterCallback(mvWorldId worldId, mvCustomFilterFcn fcn, void *context);
 void mvWorld_SetPreSolveCallback(mvWorldId worldId, mvPreSolveFcn fcn, void *context);
 void mvWorld_SetFrictionCallback(mvWorldId worldId, mvFrictionCallback callback, void *context);
void mvWorld_SetRestitutionCallback(mvWorldId worldId,
                                    mvRestitutionCallback callback,
                                    void *context);
 void mvWorld_SetGravity(mvWorldId worldId, mvVec3 gravity);
 mvVec3 mvWorld_GetGravity(mvWorldId worldId);
 void mvWorld_EnableSleeping(mvWorldId worldId, bool flag);
 bool mvWorld_IsSleepingEnabled(mvWorldId worldId);
 void mvWorld_EnableWarmStarting(mvWorldId worldId, bool flag);
 bool mvWorld_IsWarmStartingEnabled(mvWorldId worldId);
 void mvWorld_SetRestitutionThreshold(mvWorldId worldId, mvFloat value);
 mvFloat mvWorld_GetRestitutionThreshold(mvWorldId worldId);
 void mvWorld_SetHitEventThreshold(mvWorldId worldId, mvFloat value);
 mvFloat mvWorld_GetHitEventThreshold(mvWorldId worldId);
void mvWorld_SetContactTuning(mvWorldId worldId,
                              mvFloat stiffness,
                              mvFloat dampingRatio,
                              mvFloat contactSpeed);
 mvContactTuning mvWorld_GetContactTuning(mvWorldId worldId);
 void mvWorld_SetMaximumLinearSpeed(mvWorldId worldId, mvFloat maximumLinearSpeed);
 mvFloat mvWorld_GetMaximumLinearSpeed(mvWorldId worldId);
void mvWorld_SetAccuracy(mvWorldId worldId,
                         mvFloat accuracy);
 mvFloat mvWorld_GetAccuracy(mvWorldId worldId);
 int mvWorld_GetAwakeBodyCount(mvWorldId worldId);
 void mvWorld_SetWorkerCount(mvWorldId worldId, int count);
 int mvWorld_GetWorkerCount(mvWorldId worldId);
 mvProfile mvWorld_GetProfile(mvWorldId worldId);
 mvCounters mvWorld_GetCounters(mvWorldId worldId);
 mvStepReport mvWorld_GetStepReport(mvWorldId worldId);
uint64_t mvWorld_GetStateHash(mvWorldId worldId);
