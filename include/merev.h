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
 * Category bits that match every mask.
 */
#define MV_DEFAULT_CATEGORY_BITS 18446744073709551615ull

/**
 * Mask bits that accept every category.
 */
#define MV_DEFAULT_MASK_BITS 18446744073709551615ull

/**
 * The most points of an mvShapeProxy.
 */
#define MV_MAX_SHAPE_CAST_POINTS 64

/**
 * The most vertices of a hull.
 */
#define MV_MAX_HULL_VERTICES 255

/**
 * The most bones of a human.
 */
#define MV_MAX_BONES 14

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
 * How a body moves: one of mv_staticBody, mv_kinematicBody, mv_dynamicBody.
 */
typedef int32_t mvBodyType;

/**
 * A position in the world. A type of its own, so that world positions can get more digits than everything
 * else without a change to programs: convert with mvToPos() and mvToVec3(), subtract with mvSubPos().
 */
typedef struct mvPos {
    /**
     * Along x.
     */
    mvFloat x;
    /**
     * Along y.
     */
    mvFloat y;
    /**
     * Along z.
     */
    mvFloat z;
} mvPos;

/**
 * A vector or point in three dimensions.
 */
typedef struct mvVec3 {
    /**
     * Along x.
     */
    mvFloat x;
    /**
     * Along y.
     */
    mvFloat y;
    /**
     * Along z.
     */
    mvFloat z;
} mvVec3;

/**
 * A rotation as a unit quaternion: vector part v, scalar part s. The identity is v = 0, s = 1.
 */
typedef struct mvQuat {
    /**
     * The vector part.
     */
    mvVec3 v;
    /**
     * The scalar part.
     */
    mvFloat s;
} mvQuat;

/**
 * Directions in which a body cannot move, in world axes.
 */
typedef struct mvMotionLocks {
    /**
     * No translation along x.
     */
    bool linearX;
    /**
     * No translation along y.
     */
    bool linearY;
    /**
     * No translation along z.
     */
    bool linearZ;
    /**
     * No rotation about x.
     */
    bool angularX;
    /**
     * No rotation about y.
     */
    bool angularY;
    /**
     * No rotation about z.
     */
    bool angularZ;
} mvMotionLocks;

/**
 * What a body is made from. Made by mvDefaultBodyDef().
 */
typedef struct mvBodyDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * How the body moves; default mv_staticBody.
     */
    mvBodyType type;
    /**
     * The position of the body's origin [m].
     */
    mvPos position;
    /**
     * The rotation of the body, of length 1.
     */
    mvQuat rotation;
    /**
     * The velocity of the body's origin [m/s].
     */
    mvVec3 linearVelocity;
    /**
     * The angular velocity, in world axes [rad/s].
     */
    mvVec3 angularVelocity;
    /**
     * The fraction of the velocity lost per second, for small values [1/s], >= 0; default 0.
     */
    mvFloat linearDamping;
    /**
     * The fraction of the angular velocity lost per second, for small values [1/s], >= 0; default 0.
     */
    mvFloat angularDamping;
    /**
     * A factor on gravity; default 1.
     */
    mvFloat gravityScale;
    /**
     * The body may fall asleep below this speed [m/s], >= 0; default 0.05.
     */
    mvFloat sleepThreshold;
    /**
     * A name for people, in UTF-8; null for none. Copied.
     */
    const char *name;
    /**
     * Anything: mvBody_GetUserData().
     */
    void *userData;
    /**
     * Directions in which the body cannot move; none by default.
     */
    mvMotionLocks motionLocks;
    /**
     * Whether the body may fall asleep; default true.
     */
    bool enableSleep;
    /**
     * Whether the body starts awake; default true.
     */
    bool isAwake;
    /**
     * Whether the body takes part at all; default true.
     */
    bool isEnabled;
} mvBodyDef;

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
 * A joint between bodies. Zero is null.
 */
typedef struct mvJointId {
    /**
     * The place among the joints of its world, counted from 1; 0 is null.
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
} mvJointId;

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
 * A point of contact.
 */
typedef struct mvManifoldPoint {
    /**
     * Where, at the start of the last step [m].
     */
    mvPos point;
    /**
     * The point, from the centre of mass of body A, in world axes [m].
     */
    mvVec3 anchorA;
    /**
     * The point, from the centre of mass of body B, in world axes [m].
     */
    mvVec3 anchorB;
    /**
     * The gap between the surfaces at the start of the last step, negative where they overlap [m].
     */
    mvFloat separation;
    /**
     * The impulse along the normal in the last sub-step [N s].
     */
    mvFloat normalImpulse;
    /**
     * The sum of the impulses along the normal over the last step [N s].
     */
    mvFloat totalNormalImpulse;
    /**
     * The velocity along the normal at the start of the last step, negative when approaching [m/s].
     */
    mvFloat normalVelocity;
    /**
     * Which features of the shapes meet; the same number in the next step means the same features.
     */
    uint32_t featureId;
} mvManifoldPoint;

/**
 * The points of contact that share a normal.
 */
typedef struct mvManifold {
    /**
     * The points, the first pointCount of them.
     */
    mvManifoldPoint points[4];
    /**
     * The normal from shape A to shape B, of length 1.
     */
    mvVec3 normal;
    /**
     * The sum of the friction impulses on body B over the last step [N s].
     */
    mvVec3 frictionImpulse;
    /**
     * The number of points, 0 to 4.
     */
    int pointCount;
} mvManifold;

/**
 * Two touching shapes.
 */
typedef struct mvContactData {
    /**
     * The contact.
     */
    mvContactId contactId;
    /**
     * The first shape.
     */
    mvShapeId shapeIdA;
    /**
     * The second shape.
     */
    mvShapeId shapeIdB;
    /**
     * The manifolds. Valid until the next step, or until the world is destroyed.
     */
    const mvManifold *manifolds;
    /**
     * The number of manifolds.
     */
    int manifoldCount;
} mvContactData;

/**
 * A 3 by 3 matrix, by columns.
 */
typedef struct mvMatrix3 {
    /**
     * The first column.
     */
    mvVec3 cx;
    /**
     * The second column.
     */
    mvVec3 cy;
    /**
     * The third column.
     */
    mvVec3 cz;
} mvMatrix3;

/**
 * Mass, centre of mass and inertia.
 */
typedef struct mvMassData {
    /**
     * The mass [kg].
     */
    mvFloat mass;
    /**
     * The centre of mass in the frame of the shape or body [m].
     */
    mvVec3 center;
    /**
     * The inertia about the centre of mass, in the axes of the shape or body [kg m^2].
     */
    mvMatrix3 inertia;
} mvMassData;

/**
 * A rigid placement in the world: rotate by q, then shift to p.
 */
typedef struct mvWorldTransform {
    /**
     * The shift [m].
     */
    mvPos p;
    /**
     * The rotation.
     */
    mvQuat q;
} mvWorldTransform;

/**
 * Where a ray or a moving solid hits a body.
 */
typedef struct mvBodyCastResult {
    /**
     * The shape that was hit.
     */
    mvShapeId shapeId;
    /**
     * The point on its surface [m].
     */
    mvPos point;
    /**
     * The outward normal of the surface at the point, of length 1.
     */
    mvVec3 normal;
    /**
     * The fraction of the translation travelled.
     */
    mvFloat fraction;
    /**
     * The user material of the shape.
     */
    uint64_t userMaterialId;
    /**
     * The number of iterations used; 0 where the answer is a closed form.
     */
    int iterations;
    /**
     * Whether there was a hit. If not, everything else is zero.
     */
    bool hit;
} mvBodyCastResult;

/**
 * Which shapes a query sees: its mask must hold a category of the shape and the shape's mask one of the query.
 */
typedef struct mvQueryFilter {
    /**
     * What the query is; default all bits.
     */
    uint64_t categoryBits;
    /**
     * What the query sees; default all bits.
     */
    uint64_t maskBits;
} mvQueryFilter;

/**
 * A convex solid: all points within a radius of the convex hull of some points.
 */
typedef struct mvShapeProxy {
    /**
     * The points [m].
     */
    const mvVec3 *points;
    /**
     * Their number, 1 to MV_MAX_SHAPE_CAST_POINTS.
     */
    int count;
    /**
     * The radius [m], >= 0.
     */
    mvFloat radius;
} mvShapeProxy;

/**
 * A point of contact, in the frame of the first shape.
 */
typedef struct mvLocalManifoldPoint {
    /**
     * The middle between the two surfaces [m].
     */
    mvVec3 point;
    /**
     * The gap along the normal, negative where the shapes overlap [m].
     */
    mvFloat separation;
    /**
     * Which features of the shapes meet; the same number again means the same features.
     */
    uint32_t featureId;
} mvLocalManifoldPoint;

/**
 * The points of contact of two shapes, in the frame of the first.
 */
typedef struct mvLocalManifold {
    /**
     * From the first shape to the second, of length 1; zero where there is no point.
     */
    mvVec3 normal;
    /**
     * Where to write the points: set by the caller; may be null.
     */
    mvLocalManifoldPoint *points;
    /**
     * How many points were written, 0 to 4.
     */
    int pointCount;
} mvLocalManifold;

/**
 * A ball.
 */
typedef struct mvSphere {
    /**
     * The centre [m].
     */
    mvVec3 center;
    /**
     * The radius [m], at least 1e-5.
     */
    mvFloat radius;
} mvSphere;

/**
 * A rigid placement: rotate by q, then shift by p.
 */
typedef struct mvTransform {
    /**
     * The shift [m].
     */
    mvVec3 p;
    /**
     * The rotation.
     */
    mvQuat q;
} mvTransform;

/**
 * All points within a radius of a segment.
 */
typedef struct mvCapsule {
    /**
     * The centre of one end [m].
     */
    mvVec3 center1;
    /**
     * The centre of the other end [m], at least 1e-5 from the first.
     */
    mvVec3 center2;
    /**
     * The radius [m], at least 1e-5.
     */
    mvFloat radius;
} mvCapsule;

/**
 * A convex hull: this struct followed by its arrays, byteCount bytes in all. It may be copied as a block, with
 * alignment 8; offsets are in bytes from the start of this struct. It is read only: a changed hull is refused.
 */
typedef struct mvHullData {
    /**
     * Identifies a hull of this version and precision of the library, and of this many bytes.
     */
    uint64_t version;
    /**
     * A hash of all bytes, counted with this field as 0.
     */
    uint64_t hash;
    /**
     * The box around the hull.
     */
    mvAABB aabb;
    /**
     * The area of the surface [m^2].
     */
    mvFloat surfaceArea;
    /**
     * The volume [m^3].
     */
    mvFloat volume;
    /**
     * The least distance from the center to a face [m].
     */
    mvFloat innerRadius;
    /**
     * The greatest distance from the center to a vertex [m].
     */
    mvFloat outerRadius;
    /**
     * The centre of mass [m].
     */
    mvVec3 center;
    /**
     * The inertia about the center for a density of 1 [m^5].
     */
    mvMatrix3 centralInertia;
    /**
     * Half the side lengths, if the hull was made as a box; zero otherwise.
     */
    mvVec3 boxHalfWidths;
    /**
     * Where the box is, if the hull was made as one.
     */
    mvTransform boxTransform;
    /**
     * The number of vertices and of points.
     */
    int32_t vertexCount;
    /**
     * Where the vertices are: mvGetHullVertices().
     */
    int32_t vertexOffset;
    /**
     * Where the points are: mvGetHullPoints().
     */
    int32_t pointOffset;
    /**
     * The number of half-edges: twice the number of edges.
     */
    int32_t edgeCount;
    /**
     * Where the half-edges are: mvGetHullEdges().
     */
    int32_t edgeOffset;
    /**
     * The number of faces and of planes.
     */
    int32_t faceCount;
    /**
     * Where the planes of the faces are: mvGetHullPlanes().
     */
    int32_t planeOffset;
    /**
     * Where the faces are: mvGetHullFaces().
     */
    int32_t faceOffset;
    /**
     * The number of bytes of the whole hull.
     */
    int32_t byteCount;
    /**
     * Zero.
     */
    int32_t padding;
} mvHullData;

/**
 * Which points carried the closest points. Written by mvShapeDistance(); all zero is a good start.
 */
typedef struct mvSimplexCache {
    /**
     * The distance of the hulls of the points.
     */
    mvFloat metric;
    /**
     * The number of points of each solid, 0 to 4.
     */
    uint16_t count;
    /**
     * Which points of A.
     */
    uint8_t indexA[4];
    /**
     * Which points of B.
     */
    uint8_t indexB[4];
} mvSimplexCache;

/**
 * What was found out about a pair of hulls. All zero is a good start.
 */
typedef struct mvSATCache {
    /**
     * The gap along the axis that was found, negative where the hulls overlap [m].
     */
    mvFloat separation;
    /**
     * Whether the hulls have contact points.
     */
    bool hit;
} mvSATCache;

/**
 * A colour, 0xRRGGBB.
 */
typedef uint32_t mvHexColor;

/**
 * What mvWorld_Draw() draws and with what, and what mvWorld_DrawBuffers() puts into arrays. Made by
 * mvDefaultDebugDraw(). Functions get pointers, valid during the call, and numbers; all are in world coordinates, any
 * may be null. They may read the world but not change it.
 */
typedef struct mvDebugDraw {
    /**
     * Shows that the structure was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * Draws a shape whose frame is placed by the transform. Where it is null, shapes are drawn by DrawSphereFcn,
     * DrawCapsuleFcn, DrawBoxFcn and, face by face, DrawPolygonFcn.
     */
    void (*DrawShapeFcn)(const mvShapeId *shapeId,
                         const mvWorldTransform *transform,
                         mvHexColor color,
                         void *context);
    /**
     * Draws a line.
     */
    void (*DrawSegmentFcn)(const mvPos *p1, const mvPos *p2, mvHexColor color, void *context);
    /**
     * Draws a frame; its axes as long as you like. Where it is null, DrawSegmentFcn draws the axes.
     */
    void (*DrawTransformFcn)(const mvWorldTransform *transform, void *context);
    /**
     * Draws a point; its size is in pixels.
     */
    void (*DrawPointFcn)(const mvPos *p, mvFloat size, mvHexColor color, void *context);
    /**
     * Draws a ball.
     */
    void (*DrawSphereFcn)(const mvPos *p,
                          mvFloat radius,
                          mvHexColor color,
                          mvFloat alpha,
                          void *context);
    /**
     * Draws a capsule.
     */
    void (*DrawCapsuleFcn)(const mvPos *p1,
                           const mvPos *p2,
                           mvFloat radius,
                           mvHexColor color,
                           mvFloat alpha,
                           void *context);
    /**
     * Draws a face of a hull, or the part of a half-space's surface that is near the scene: a flat convex polygon whose
     * corners go counter-clockwise seen from outside.
     */
    void (*DrawPolygonFcn)(const mvPos *vertices,
                           int count,
                           mvHexColor color,
                           mvFloat alpha,
                           void *context);
    /**
     * Draws a box along the axes. Where it is null, DrawSegmentFcn draws its edges.
     */
    void (*DrawBoundsFcn)(const mvAABB *aabb, mvHexColor color, void *context);
    /**
     * Draws a box with these half extents.
     */
    void (*DrawBoxFcn)(const mvVec3 *extents,
                       const mvWorldTransform *transform,
                       mvHexColor color,
                       void *context);
    /**
     * Draws a text, in UTF-8.
     */
    void (*DrawStringFcn)(const mvPos *p, const char *s, mvHexColor color, void *context);
    /**
     * What lies wholly outside is not drawn; default all that coordinates can reach.
     */
    mvAABB drawingBounds;
    /**
     * The length of forces [m/N], >= 0; default 1e-4.
     */
    mvFloat forceScale;
    /**
     * A factor on the size of joints, >= 0; default 1.
     */
    mvFloat jointScale;
    /**
     * Whether shapes are drawn; default true.
     */
    bool drawShapes;
    /**
     * Whether the edges of shapes are drawn, as lines; default false.
     */
    bool drawEdges;
    /**
     * Whether joints are drawn; default true.
     */
    bool drawJoints;
    /**
     * Whether frames and limits of joints are drawn, too; default false.
     */
    bool drawJointExtras;
    /**
     * Whether the boxes that the broad phase knows are drawn; default false.
     */
    bool drawBounds;
    /**
     * Whether mass and centre of mass of dynamic bodies are drawn; default false.
     */
    bool drawMass;
    /**
     * Whether it is written for how long bodies have been slow, and which are asleep; default false.
     */
    bool drawSleep;
    /**
     * Whether the names of bodies are written; default false.
     */
    bool drawBodyNames;
    /**
     * Whether contact points are drawn; default false.
     */
    bool drawContacts;
    /**
     * Whether contact points lie on the surface of shape A rather than midway; default false.
     */
    bool drawAnchorA;
    /**
     * Whether contact points have the colours of the constraint graph; default false.
     */
    bool drawGraphColors;
    /**
     * Whether the features that meet in contact points are written; default false.
     */
    bool drawContactFeatures;
    /**
     * Whether contact normals are drawn; default false.
     */
    bool drawContactNormals;
    /**
     * Whether forces along contact normals are drawn, mean over the last step; default false.
     */
    bool drawContactForces;
    /**
     * Whether friction forces are drawn, mean over the last step; default false.
     */
    bool drawFrictionForces;
    /**
     * Whether islands are drawn, as boxes around their bodies; default false.
     */
    bool drawIslands;
    /**
     * Whether mvWorld_DrawBuffers() gives triangles for balls, capsules and boxes, too, rather than instances; default
     * false.
     */
    bool tessellate;
    /**
     * Passed to the functions.
     */
    void *context;
} mvDebugDraw;

/**
 * A line of a drawing.
 */
typedef struct mvDrawLine {
    /**
     * One end [m].
     */
    mvPos p1;
    /**
     * The other end [m].
     */
    mvPos p2;
    /**
     * Its colour.
     */
    mvHexColor color;
} mvDrawLine;

/**
 * A triangle of a shape's surface.
 */
typedef struct mvDrawTriangle {
    /**
     * The corners, counter-clockwise seen from outside [m].
     */
    mvPos p1;
    /**
     * The second.
     */
    mvPos p2;
    /**
     * The third.
     */
    mvPos p3;
    /**
     * The outward normal, of length 1.
     */
    mvVec3 normal;
    /**
     * Its colour.
     */
    mvHexColor color;
    /**
     * Whose it is.
     */
    mvShapeId shapeId;
} mvDrawTriangle;

/**
 * What an instance is: one of the mv_draw... constants.
 */
typedef int32_t mvDrawInstanceKind;

/**
 * A shape that is drawn from a mesh of its kind.
 */
typedef struct mvDrawInstance {
    /**
     * The frame in which it is centred.
     */
    mvWorldTransform transform;
    /**
     * By kind [m].
     */
    mvVec3 size;
    /**
     * What it is.
     */
    mvDrawInstanceKind kind;
    /**
     * Its colour.
     */
    mvHexColor color;
    /**
     * Whose it is.
     */
    mvShapeId shapeId;
} mvDrawInstance;

/**
 * A point of a drawing.
 */
typedef struct mvDrawPoint {
    /**
     * Where [m].
     */
    mvPos position;
    /**
     * In pixels.
     */
    mvFloat size;
    /**
     * Its colour.
     */
    mvHexColor color;
} mvDrawPoint;

/**
 * A text of a drawing.
 */
typedef struct mvDrawString {
    /**
     * Where [m].
     */
    mvPos position;
    /**
     * What it says, in UTF-8.
     */
    const char *text;
    /**
     * Its colour.
     */
    mvHexColor color;
} mvDrawString;

/**
 * A drawing in arrays.
 */
typedef struct mvDrawBuffers {
    /**
     * Edges, joints, boxes, frames, normals and forces.
     */
    const mvDrawLine *lines;
    /**
     * The surfaces of shapes that are no instances.
     */
    const mvDrawTriangle *triangles;
    /**
     * Balls, capsules and boxes.
     */
    const mvDrawInstance *instances;
    /**
     * Contacts, centres of mass and the like.
     */
    const mvDrawPoint *points;
    /**
     * Names and numbers.
     */
    const mvDrawString *strings;
    /**
     * The number of lines.
     */
    int lineCount;
    /**
     * The number of triangles.
     */
    int triangleCount;
    /**
     * The number of instances.
     */
    int instanceCount;
    /**
     * The number of points.
     */
    int pointCount;
    /**
     * The number of texts.
     */
    int stringCount;
} mvDrawBuffers;

/**
 * Mixes the friction of two materials: called for every contact in every step, on the stepping thread, once for
 * sliding and once for static friction. A result that is not a number >= 0 counts as 0.
 */
typedef mvFloat (*mvFrictionCallback)(mvFloat frictionA,
                                      uint64_t userMaterialIdA,
                                      mvFloat frictionB,
                                      uint64_t userMaterialIdB,
                                      void *context);

/**
 * Mixes the restitution of two materials: called for every contact in every step, on the stepping thread. A result
 * that is not a number from 0 to 1 is moved there.
 */
typedef mvFloat (*mvRestitutionCallback)(mvFloat restitutionA,
                                         uint64_t userMaterialIdA,
                                         mvFloat restitutionB,
                                         uint64_t userMaterialIdB,
                                         void *context);

/**
 * The solver of contacts: one of the mv_solver... constants.
 */
typedef int32_t mvSolverKind;

/**
 * How bodies are moved through a sub-step: one of the mv_integrator... constants.
 */
typedef int32_t mvIntegratorKind;

/**
 * How pairs of close shapes are found: one of the mv_broadPhase... constants. All find the same pairs.
 */
typedef int32_t mvBroadPhaseKind;

/**
 * How contact points of two shapes are found: one of the mv_narrowPhase... constants.
 */
typedef int32_t mvNarrowPhaseKind;

/**
 * How the search for the distance of two shapes looks at simplices: one of the mv_gjk... constants. All find the same
 * distance, up to rounding.
 */
typedef int32_t mvGjkKind;

/**
 * How contact points are found where faces meet: one of the mv_manifold... constants.
 */
typedef int32_t mvManifoldKind;

/**
 * What a world is made from. Made by mvDefaultWorldDef().
 */
typedef struct mvWorldDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * Gravity [m/s^2]; default (0, -10, 0).
     */
    mvVec3 gravity;
    /**
     * Collisions up to this approach speed do not bounce [m/s], >= 0; default 0.1.
     */
    mvFloat restitutionThreshold;
    /**
     * Collisions above this approach speed make hit events [m/s], >= 0; default 1.
     */
    mvFloat hitEventThreshold;
    /**
     * How stiff contacts are against overlap, as a fraction of the sub-step rate, > 0 and at most 0.5; default 0.21.
     */
    mvFloat contactStiffness;
    /**
     * How strongly the recovery of overlap is damped, > 0; 1 is critical; default 0.5.
     */
    mvFloat contactDampingRatio;
    /**
     * The greatest speed at which overlap is pushed out [m/s], >= 0; default 3.
     */
    mvFloat contactSpeed;
    /**
     * The greatest speed of a body [m/s], > 0; default infinity, no limit.
     */
    mvFloat maximumLinearSpeed;
    /**
     * Mixes friction instead of the default, the geometric mean; may be null.
     */
    mvFrictionCallback frictionCallback;
    /**
     * Passed to frictionCallback.
     */
    void *frictionContext;
    /**
     * Mixes restitution instead of the default, the greater one; may be null.
     */
    mvRestitutionCallback restitutionCallback;
    /**
     * Passed to restitutionCallback.
     */
    void *restitutionContext;
    /**
     * Whether bodies at rest fall asleep; default true.
     */
    bool enableSleep;
    /**
     * Whether contact impulses are kept from step to step; default true. Off is for experiments.
     */
    bool enableWarmStarting;
    /**
     * Whether steady loads are remembered, so that stacks rest without overlap; default true. Off is for experiments.
     */
    bool enableLoadMemory;
    /**
     * How many threads step the world. Only 1, the default, is built yet.
     */
    uint32_t workerCount;
    /**
     * Anything: mvWorld_GetUserData().
     */
    void *userData;
    /**
     * The error that a step may add to the motion, as a share of the way gone in it, 0 to 1; default 0: exactly the
     * sub-steps asked for. Otherwise they are the least, and an island gets two, four, ... 32 times as many where that
     * is needed and helps: for swinging, spinning and springy things. Only with the solver softStep.
     */
    mvFloat accuracy;
    /**
     * The contact solver; default mv_solver_auto.
     */
    mvSolverKind solver;
    /**
     * The sweeps of each sub-step of the solvers sequentialImpulse and projectedGaussSeidel, at most 10000; default 0:
     * the step is not divided, and has as many sweeps as it was to have sub-steps.
     */
    uint32_t solverIterations;
    /**
     * The corners of the friction pyramids of the solvers lemke and dantzig (which makes them even), 3 to 64;
     * default 8.
     */
    uint32_t frictionFacets;
    /**
     * Whether sequentialImpulse visits the points in another order in every iteration; default true.
     */
    bool shuffleContacts;
    /**
     * Whether the first iterations of sequentialImpulse correct by more than is missing; default false.
     */
    bool overCorrect;
    /**
     * The integrator; default mv_integrator_auto.
     */
    mvIntegratorKind integrator;
    /**
     * The broad phase; default mv_broadPhase_auto.
     */
    mvBroadPhaseKind broadPhase;
    /**
     * The narrow phase; default mv_narrowPhase_auto.
     */
    mvNarrowPhaseKind narrowPhase;
    /**
     * How the narrow phase looks at simplices; default mv_gjk_auto.
     */
    mvGjkKind gjk;
    /**
     * How contact points are found where faces meet; default mv_manifold_auto.
     */
    mvManifoldKind manifold;
} mvWorldDef;

/**
 * What a surface does in contact.
 */
typedef struct mvSurfaceMaterial {
    /**
     * The coefficient of sliding friction, >= 0; default 0.6. A pair has the geometric mean.
     */
    mvFloat friction;
    /**
     * The coefficient of static friction; negative, the default, means that of sliding. A pair has the geometric mean.
     */
    mvFloat staticFriction;
    /**
     * The coefficient of restitution, 0 to 1; default 0. A pair has the greater one.
     */
    mvFloat restitution;
    /**
     * The resistance to rolling, as a fraction of the radius by which the pressure is ahead, >= 0; default 0. A pair
     * has the greater one.
     */
    mvFloat rollingResistance;
    /**
     * The velocity of the surface as that of a conveyor belt, in the body's frame [m/s].
     */
    mvVec3 tangentVelocity;
    /**
     * Anything; passed to mixing callbacks and given with hits.
     */
    uint64_t userMaterialId;
    /**
     * A colour for drawing, 0xRRGGBB; 0 means none.
     */
    uint32_t customColor;
} mvSurfaceMaterial;

/**
 * Which shapes collide: each one's mask must hold a category of the other, unless they share a group.
 */
typedef struct mvFilter {
    /**
     * What the shape is; default all bits.
     */
    uint64_t categoryBits;
    /**
     * What the shape collides with; default all bits.
     */
    uint64_t maskBits;
    /**
     * Shapes of one group other than 0 always collide if it is positive, and never if it is negative.
     */
    int groupIndex;
} mvFilter;

/**
 * What a shape is made from, besides its geometry. Made by mvDefaultShapeDef().
 */
typedef struct mvShapeDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * A name for people, in UTF-8; null for none. Copied.
     */
    const char *name;
    /**
     * Anything: mvShape_GetUserData().
     */
    void *userData;
    /**
     * The surface.
     */
    mvSurfaceMaterial baseMaterial;
    /**
     * The density [kg/m^3], >= 0; default 1000.
     */
    mvFloat density;
    /**
     * What the shape collides with; default everything.
     */
    mvFilter filter;
    /**
     * Whether the custom filter callback is asked about this shape; default false.
     */
    bool enableCustomFiltering;
    /**
     * Whether contacts of this shape make begin and end events; one of the two shapes is enough; default true.
     */
    bool enableContactEvents;
    /**
     * Whether contacts of this shape make hit events; one of the two shapes is enough; default false.
     */
    bool enableHitEvents;
    /**
     * Whether the pre-solve callback is asked about contacts of this shape; default false.
     */
    bool enablePreSolveEvents;
    /**
     * Whether making the shape updates the mass of its body; default true.
     */
    bool updateBodyMass;
} mvShapeDef;

/**
 * The closest points of two solids, in the frame of A.
 */
typedef struct mvDistanceOutput {
    /**
     * The point of A closest to B; where they overlap, a common point.
     */
    mvVec3 pointA;
    /**
     * The point of B closest to A; where they overlap, the same point.
     */
    mvVec3 pointB;
    /**
     * From A to B, of length 1; zero where the hulls of the points overlap.
     */
    mvVec3 normal;
    /**
     * The distance [m]; 0 where they touch or overlap.
     */
    mvFloat distance;
    /**
     * The number of iterations.
     */
    int iterations;
    /**
     * The number of simplexes written.
     */
    int simplexCount;
} mvDistanceOutput;

/**
 * Two solids whose distance is wanted.
 */
typedef struct mvDistanceInput {
    /**
     * The first solid, A.
     */
    mvShapeProxy proxyA;
    /**
     * The second solid, B.
     */
    mvShapeProxy proxyB;
    /**
     * Where B is, seen from A.
     */
    mvTransform transform;
    /**
     * Whether the radii count.
     */
    bool useRadii;
    /**
     * How the search looks at simplices; 0 is mv_gjk_auto.
     */
    mvGjkKind gjk;
} mvDistanceInput;

/**
 * A pair of points of two solids.
 */
typedef struct mvSimplexVertex {
    /**
     * The point of A.
     */
    mvVec3 wA;
    /**
     * The point of B, in the frame of A.
     */
    mvVec3 wB;
    /**
     * From A to B.
     */
    mvVec3 w;
    /**
     * The index of the point of A.
     */
    int indexA;
    /**
     * The index of the point of B.
     */
    int indexB;
} mvSimplexVertex;

/**
 * The pairs of points between which the closest points lie.
 */
typedef struct mvSimplex {
    /**
     * The pairs, the first count of them.
     */
    mvSimplexVertex vertices[4];
    /**
     * Their number, 1 to 4.
     */
    int count;
} mvSimplex;

/**
 * Where a ray or a moving shape hits a shape.
 */
typedef struct mvCastOutput {
    /**
     * The outward normal of the surface at the point, of length 1.
     */
    mvVec3 normal;
    /**
     * The point on the surface [m].
     */
    mvVec3 point;
    /**
     * The fraction of the translation travelled.
     */
    mvFloat fraction;
    /**
     * The number of iterations used; 0 where the answer is a closed form.
     */
    int iterations;
    /**
     * Whether there was a hit. If not, everything else is zero.
     */
    bool hit;
} mvCastOutput;

/**
 * Two solids, of which the second is moved without turning.
 */
typedef struct mvShapeCastPairInput {
    /**
     * The solid that stands, A.
     */
    mvShapeProxy proxyA;
    /**
     * The solid that moves, B.
     */
    mvShapeProxy proxyB;
    /**
     * Where B starts, seen from A.
     */
    mvTransform transform;
    /**
     * From the start to the end of B's motion, in the frame of A [m].
     */
    mvVec3 translationB;
    /**
     * The greatest fraction of the translation to consider, >= 0; usually 1.
     */
    mvFloat maxFraction;
    /**
     * Whether solids that touch at the start may come a little closer. Only false is built yet.
     */
    bool canEncroach;
} mvShapeCastPairInput;

/**
 * A solid that is moved without turning.
 */
typedef struct mvShapeCastInput {
    /**
     * The solid.
     */
    mvShapeProxy proxy;
    /**
     * From the start to the end of the motion [m].
     */
    mvVec3 translation;
    /**
     * The greatest fraction of the translation to consider, >= 0; usually 1.
     */
    mvFloat maxFraction;
    /**
     * Whether solids that touch at the start may come a little closer. Only false is built yet.
     */
    bool canEncroach;
} mvShapeCastInput;

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
 * A body moved in the last step, or fell asleep.
 */
typedef struct mvBodyMoveEvent {
    /**
     * The body's user data.
     */
    void *userData;
    /**
     * Where the body is now.
     */
    mvWorldTransform transform;
    /**
     * The body.
     */
    mvBodyId bodyId;
    /**
     * Whether the body fell asleep in the last step.
     */
    bool fellAsleep;
} mvBodyMoveEvent;

/**
 * The bodies that a step moved.
 */
typedef struct mvBodyEvents {
    /**
     * The events, in order of the bodies' places. Valid until the next step.
     */
    mvBodyMoveEvent *moveEvents;
    /**
     * Their number.
     */
    int moveCount;
} mvBodyEvents;

/**
 * Two shapes began to touch.
 */
typedef struct mvContactBeginTouchEvent {
    /**
     * The first shape.
     */
    mvShapeId shapeIdA;
    /**
     * The second shape.
     */
    mvShapeId shapeIdB;
    /**
     * The contact.
     */
    mvContactId contactId;
} mvContactBeginTouchEvent;

/**
 * Two shapes ceased to touch, or one of them was destroyed; then its id is stale.
 */
typedef struct mvContactEndTouchEvent {
    /**
     * The first shape.
     */
    mvShapeId shapeIdA;
    /**
     * The second shape.
     */
    mvShapeId shapeIdB;
    /**
     * The contact.
     */
    mvContactId contactId;
} mvContactEndTouchEvent;

/**
 * Two shapes hit each other faster than the world's threshold.
 */
typedef struct mvContactHitEvent {
    /**
     * The first shape.
     */
    mvShapeId shapeIdA;
    /**
     * The second shape.
     */
    mvShapeId shapeIdB;
    /**
     * The contact.
     */
    mvContactId contactId;
    /**
     * Where they hit [m].
     */
    mvPos point;
    /**
     * The normal from shape A to shape B, of length 1.
     */
    mvVec3 normal;
    /**
     * How fast they approached [m/s], positive.
     */
    mvFloat approachSpeed;
    /**
     * The user material of shape A.
     */
    uint64_t userMaterialIdA;
    /**
     * The user material of shape B.
     */
    uint64_t userMaterialIdB;
} mvContactHitEvent;

/**
 * What happened to contacts in the last step.
 */
typedef struct mvContactEvents {
    /**
     * Contacts that began. Valid until the next step.
     */
    mvContactBeginTouchEvent *beginEvents;
    /**
     * Contacts that ended, by destruction before the step included. Valid until the next step.
     */
    mvContactEndTouchEvent *endEvents;
    /**
     * Hits. Valid until the next step.
     */
    mvContactHitEvent *hitEvents;
    /**
     * The number of contacts that began.
     */
    int beginCount;
    /**
     * The number of contacts that ended.
     */
    int endCount;
    /**
     * The number of hits.
     */
    int hitCount;
} mvContactEvents;

/**
 * A joint carried more than one of its thresholds in the last step.
 */
typedef struct mvJointEvent {
    /**
     * The joint; stale where it broke.
     */
    mvJointId jointId;
    /**
     * The joint's user data.
     */
    void *userData;
    /**
     * The size of its force on body B, mean over the step [N].
     */
    mvFloat force;
    /**
     * The size of its torque on body B, mean over the step [N m].
     */
    mvFloat torque;
    /**
     * Whether it broke.
     */
    bool broke;
} mvJointEvent;

/**
 * The joints that carried too much in a step.
 */
typedef struct mvJointEvents {
    /**
     * The events, in order of the joints' places. Valid until the next step.
     */
    mvJointEvent *jointEvents;
    /**
     * Their number.
     */
    int count;
} mvJointEvents;

/**
 * A ray to be cast at a shape, in the shape's frame.
 */
typedef struct mvRayCastInput {
    /**
     * Where the ray starts [m].
     */
    mvVec3 origin;
    /**
     * From the start to the end of the ray [m].
     */
    mvVec3 translation;
    /**
     * The greatest fraction of the translation to consider, not negative; usually 1.
     */
    mvFloat maxFraction;
} mvRayCastInput;

/**
 * A plane: the points whose dot product with the unit normal equals the offset. The distance of a point from
 * it is dot(normal, point) - offset, positive on the side the normal points to.
 */
typedef struct mvPlane {
    /**
     * The normal, of length 1.
     */
    mvVec3 normal;
    /**
     * The distance of the plane from the origin, along the normal.
     */
    mvFloat offset;
} mvPlane;

/**
 * A half-edge: one direction of an edge, belonging to the face on its left.
 */
typedef struct mvHullHalfEdge {
    /**
     * The next half-edge around the face, counter-clockwise seen from outside.
     */
    uint16_t next;
    /**
     * The half-edge in the other direction.
     */
    uint16_t twin;
    /**
     * The vertex where it starts.
     */
    uint16_t origin;
    /**
     * The face on its left.
     */
    uint16_t face;
} mvHullHalfEdge;

/**
 * A vertex of a hull.
 */
typedef struct mvHullVertex {
    /**
     * One of the half-edges that start here.
     */
    uint16_t edge;
} mvHullVertex;

/**
 * A face of a hull.
 */
typedef struct mvHullFace {
    /**
     * One of the half-edges around it.
     */
    uint16_t edge;
} mvHullFace;

/**
 * A box as a hull: a plain value that needs no destroying. Pass the address of its base where a hull is wanted.
 */
typedef struct mvBoxHull {
    /**
     * The hull, whose offsets lead to the arrays below.
     */
    mvHullData base;
    /**
     * The corners: bit 0, 1, 2 of the index is set where x, y, z of the box's frame is positive.
     */
    mvVec3 boxPoints[8];
    /**
     * The planes of the faces -x, +x, -y, +y, -z, +z.
     */
    mvPlane boxPlanes[6];
    /**
     * The half-edges.
     */
    mvHullHalfEdge boxEdges[24];
    /**
     * The vertices.
     */
    mvHullVertex boxVertices[8];
    /**
     * The faces.
     */
    mvHullFace boxFaces[6];
    /**
     * Zero.
     */
    uint16_t padding[2];
} mvBoxHull;

/**
 * What a human is made from. Made by mvDefaultHumanDef().
 */
typedef struct mvHumanDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * How many bones: 11, the default, or 14, with a spine of two parts and feet.
     */
    int boneCount;
    /**
     * Where it stands [m]; default the origin.
     */
    mvPos position;
    /**
     * How it stands; default upright: y up, looking along z.
     */
    mvQuat rotation;
    /**
     * The height [m], 0.01 to 100; default 1.8.
     */
    mvFloat height;
    /**
     * The density [kg/m^3], > 0; default 1000.
     */
    mvFloat density;
    /**
     * The mass of the whole body [kg], >= 0; 0, the default, is what the density gives.
     */
    mvFloat mass;
    /**
     * The torque of dry friction in each joint [N m], >= 0; default 1.
     */
    mvFloat frictionTorque;
    /**
     * The frequency of springs that hold the rest pose [Hz], >= 0; default 0: none.
     */
    mvFloat springHertz;
    /**
     * Their damping ratio, >= 0; default 0.7.
     */
    mvFloat springDampingRatio;
    /**
     * The collision group of all bones. Negative, as the default -1, bones of one group do not collide: give each
     * human a group of its own, or they pass through each other.
     */
    int groupIndex;
    /**
     * The surface of all bones.
     */
    mvSurfaceMaterial material;
    /**
     * Anything: the user data of all bodies, shapes and joints.
     */
    void *userData;
} mvHumanDef;

/**
 * The bones of a human, and their joints. A plain value that is copied freely.
 */
typedef struct mvHuman {
    /**
     * How many bones; 0 for none.
     */
    int boneCount;
    /**
     * Pelvis, (abdomen,) chest, head, left and right upper arm, left and right forearm, left and right thigh, left
     * and right shank(, left and right foot). What is in brackets is there with 14 bones.
     */
    mvBodyId bodyIds[14];
    /**
     * The joint by which each bone hangs on another; null for the pelvis. Spherical at spine, neck, shoulders and
     * hips, revolute at elbows, knees and ankles.
     */
    mvJointId jointIds[14];
} mvHuman;

/**
 * What a joint is: one of the mv_...Joint constants. Numbers are never reused.
 */
typedef int32_t mvJointType;

/**
 * What all joints have. A part of each joint's definition, set by its mvDefault...JointDef().
 */
typedef struct mvJointDef {
    /**
     * Anything: mvJoint_GetUserData().
     */
    void *userData;
    /**
     * The first body.
     */
    mvBodyId bodyIdA;
    /**
     * The second body, another one of the same world. At least one of them should be dynamic.
     */
    mvBodyId bodyIdB;
    /**
     * Where the joint's frame A is in body A, from the body's origin; default the identity.
     */
    mvTransform localFrameA;
    /**
     * Where the joint's frame B is in body B, from the body's origin; default the identity.
     */
    mvTransform localFrameB;
    /**
     * Above this force the joint makes an event [N], >= 0; default infinity.
     */
    mvFloat forceThreshold;
    /**
     * Above this torque the joint makes an event [N m], >= 0; default infinity.
     */
    mvFloat torqueThreshold;
    /**
     * How stiffly the joint holds what it holds [Hz], >= 0; 0, the default, is rigid.
     */
    mvFloat constraintHertz;
    /**
     * The damping ratio that belongs to it, >= 0; default 2.
     */
    mvFloat constraintDampingRatio;
    /**
     * The size in drawings [m], >= 0; default 1.
     */
    mvFloat drawScale;
    /**
     * Whether the two bodies collide with each other; default false.
     */
    bool collideConnected;
    /**
     * Whether the joint breaks where it would make an event; default false.
     */
    bool breakable;
} mvJointDef;

/**
 * A distance joint: holds the origins of the frames at a distance. Without the spring it is a rigid rod; with it a
 * spring, within limits and with a motor if those are enabled: a rope is an enabled spring of 0 Hz with an upper
 * limit.
 * Made by mvDefaultDistanceJointDef().
 */
typedef struct mvDistanceJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * The length of the rod, or at which the spring rests [m], >= 0; default 1.
     */
    mvFloat length;
    /**
     * Whether it is a spring instead of a rod; default false.
     */
    bool enableSpring;
    /**
     * How hard the spring may pull: the least force, negative [N]; default minus infinity.
     */
    mvFloat lowerSpringForce;
    /**
     * How hard the spring may push: the greatest force [N]; default infinity.
     */
    mvFloat upperSpringForce;
    /**
     * The frequency of the spring [Hz], >= 0; default 0: no force.
     */
    mvFloat hertz;
    /**
     * Its damping ratio, >= 0; 1 is critical; default 0.
     */
    mvFloat dampingRatio;
    /**
     * Whether the length is limited. Acts with the spring only. Default false.
     */
    bool enableLimit;
    /**
     * The least length [m], >= 0; default 0.
     */
    mvFloat minLength;
    /**
     * The greatest length [m], not below the least; default 100000.
     */
    mvFloat maxLength;
    /**
     * Whether a motor changes the length. Acts with the spring only. Default false.
     */
    bool enableMotor;
    /**
     * The greatest force of the motor [N], >= 0; default 0.
     */
    mvFloat maxMotorForce;
    /**
     * The speed at which the motor wants the length to grow [m/s]; default 0.
     */
    mvFloat motorSpeed;
} mvDistanceJointDef;

/**
 * A filter joint: the bodies do not collide with each other; nothing else happens to them.
 * Made by mvDefaultFilterJointDef().
 */
typedef struct mvFilterJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
} mvFilterJointDef;

/**
 * A gear joint: the coordinates of two joints, each revolute or prismatic, stay in step: that of the first plus
 * ratio times that of the second does not change. The bodies and frames in base are not used: those of the two
 * joints count. It is destroyed with either of them.
 * Made by mvDefaultGearJointDef().
 */
typedef struct mvGearJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * The first joint, revolute or prismatic.
     */
    mvJointId jointIdA;
    /**
     * The second joint, revolute or prismatic.
     */
    mvJointId jointIdB;
    /**
     * How far the first coordinate goes back when the second goes on by 1, not 0; default 1.
     */
    mvFloat ratio;
} mvGearJointDef;

/**
 * A motor joint: drives frame B against frame A towards a velocity, and by springs towards the place of frame A.
 * Vectors are in the axes of frame A.
 * Made by mvDefaultMotorJointDef().
 */
typedef struct mvMotorJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * The velocity of B that is wanted [m/s]; default 0.
     */
    mvVec3 linearVelocity;
    /**
     * The greatest force for it, along each axis [N], >= 0; default 0.
     */
    mvFloat maxVelocityForce;
    /**
     * The angular velocity of B that is wanted [rad/s]; default 0.
     */
    mvVec3 angularVelocity;
    /**
     * The greatest torque for it, about each axis [N m], >= 0; default 0.
     */
    mvFloat maxVelocityTorque;
    /**
     * The frequency of the spring that brings the origins together [Hz], >= 0; default 0: none.
     */
    mvFloat linearHertz;
    /**
     * Its damping ratio, >= 0; default 1.
     */
    mvFloat linearDampingRatio;
    /**
     * Its greatest force, along each axis [N], >= 0; default 0.
     */
    mvFloat maxSpringForce;
    /**
     * The frequency of the spring that turns the axes along each other [Hz], >= 0; default 0: none.
     */
    mvFloat angularHertz;
    /**
     * Its damping ratio, >= 0; default 1.
     */
    mvFloat angularDampingRatio;
    /**
     * Its greatest torque, about each axis [N m], >= 0; default 0.
     */
    mvFloat maxSpringTorque;
} mvMotorJointDef;

/**
 * A parallel joint: a spring keeps z of frame B along z of frame A, so that a body stays upright. All else is
 * free.
 * Made by mvDefaultParallelJointDef().
 */
typedef struct mvParallelJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * The frequency of the spring [Hz], >= 0; default 1.
     */
    mvFloat hertz;
    /**
     * Its damping ratio, >= 0; 1, the default, is critical.
     */
    mvFloat dampingRatio;
    /**
     * Its greatest torque about each axis [N m], >= 0; default infinity.
     */
    mvFloat maxTorque;
} mvParallelJointDef;

/**
 * A prismatic joint: frame B slides along x of frame A and does not turn against it. The translation is that of
 * B's origin along x of frame A.
 * Made by mvDefaultPrismaticJointDef().
 */
typedef struct mvPrismaticJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * Whether a spring acts; default false.
     */
    bool enableSpring;
    /**
     * The frequency of the spring [Hz], >= 0; default 0: no force.
     */
    mvFloat hertz;
    /**
     * The damping ratio of the spring, >= 0; 1 is critical; default 0.
     */
    mvFloat dampingRatio;
    /**
     * The greatest force of the spring [N], >= 0; default infinity.
     */
    mvFloat maxSpringForce;
    /**
     * The translation at which the spring rests [m]; default 0.
     */
    mvFloat targetTranslation;
    /**
     * Whether the translation is limited; default false.
     */
    bool enableLimit;
    /**
     * The least translation [m]; default 0.
     */
    mvFloat lowerTranslation;
    /**
     * The greatest translation [m], not below the least; default 0.
     */
    mvFloat upperTranslation;
    /**
     * Whether a motor acts; default false.
     */
    bool enableMotor;
    /**
     * The greatest force of the motor [N], >= 0; default 0.
     */
    mvFloat maxMotorForce;
    /**
     * The speed that the motor wants [m/s]; default 0.
     */
    mvFloat motorSpeed;
    /**
     * The force of dry friction [N], >= 0; default 0.
     */
    mvFloat friction;
} mvPrismaticJointDef;

/**
 * A pulley joint: a rope runs from body A over a fixed point to another and down to body B. Its length, the part
 * at A plus ratio times the part at B, stays within bounds.
 * Made by mvDefaultPulleyJointDef().
 */
typedef struct mvPulleyJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * The fixed point above body A, in the world [m]; default the origin.
     */
    mvPos groundAnchorA;
    /**
     * The fixed point above body B, in the world [m]; default the origin.
     */
    mvPos groundAnchorB;
    /**
     * How many lengths of rope hold B for each that holds A, > 0; default 1.
     */
    mvFloat ratio;
    /**
     * The least length [m], >= 0; 0, the default: the rope may be slack.
     */
    mvFloat minLength;
    /**
     * The greatest length [m], >= 0; 0, the default: what it is when the joint is made.
     */
    mvFloat maxLength;
} mvPulleyJointDef;

/**
 * A rack and pinion: the angle of a revolute joint stays in step with the translation of a prismatic joint: the
 * angle plus ratio times the translation does not change. The bodies and frames in base are not used: those of the
 * two joints count. It is destroyed with either of them.
 * Made by mvDefaultRackPinionJointDef().
 */
typedef struct mvRackPinionJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * The pinion: a revolute joint.
     */
    mvJointId jointIdA;
    /**
     * The rack: a prismatic joint.
     */
    mvJointId jointIdB;
    /**
     * How far the angle goes back when the rack goes on by 1 m [rad/m], not 0: 1 divided by the radius of the
     * pinion, or minus that; default 1.
     */
    mvFloat ratio;
} mvRackPinionJointDef;

/**
 * A revolute joint: a hinge about z of both frames. The angle is that of frame B against frame A and counts whole
 * turns.
 * Made by mvDefaultRevoluteJointDef().
 */
typedef struct mvRevoluteJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * Whether a spring acts; default false.
     */
    bool enableSpring;
    /**
     * The frequency of the spring [Hz], >= 0; default 0: no force.
     */
    mvFloat hertz;
    /**
     * The damping ratio of the spring, >= 0; 1 is critical; default 0.
     */
    mvFloat dampingRatio;
    /**
     * The greatest torque of the spring [N m], >= 0; default infinity.
     */
    mvFloat maxSpringTorque;
    /**
     * The angle at which the spring rests [rad]; default 0.
     */
    mvFloat targetAngle;
    /**
     * Whether the angle is limited; default false.
     */
    bool enableLimit;
    /**
     * The least angle [rad]; default 0.
     */
    mvFloat lowerAngle;
    /**
     * The greatest angle [rad], not below the least; default 0.
     */
    mvFloat upperAngle;
    /**
     * Whether a motor acts; default false.
     */
    bool enableMotor;
    /**
     * The greatest torque of the motor [N m], >= 0; default 0.
     */
    mvFloat maxMotorTorque;
    /**
     * The speed that the motor wants [rad/s]; default 0.
     */
    mvFloat motorSpeed;
    /**
     * The torque of dry friction [N m], >= 0; default 0.
     */
    mvFloat friction;
} mvRevoluteJointDef;

/**
 * A screw joint: frame B turns about x of frame A and slides along it by the pitch with each turn. The angle
 * counts whole turns.
 * Made by mvDefaultScrewJointDef().
 */
typedef struct mvScrewJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * How far B goes along x with each turn [m]; negative for a left-handed screw; default 0: it only turns.
     */
    mvFloat pitch;
    /**
     * Whether a spring acts; default false.
     */
    bool enableSpring;
    /**
     * The frequency of the spring [Hz], >= 0; default 0: no force.
     */
    mvFloat hertz;
    /**
     * The damping ratio of the spring, >= 0; 1 is critical; default 0.
     */
    mvFloat dampingRatio;
    /**
     * The greatest torque of the spring [N m], >= 0; default infinity.
     */
    mvFloat maxSpringTorque;
    /**
     * The angle at which the spring rests [rad]; default 0.
     */
    mvFloat targetAngle;
    /**
     * Whether the angle is limited; default false.
     */
    bool enableLimit;
    /**
     * The least angle [rad]; default 0.
     */
    mvFloat lowerAngle;
    /**
     * The greatest angle [rad], not below the least; default 0.
     */
    mvFloat upperAngle;
    /**
     * Whether a motor acts; default false.
     */
    bool enableMotor;
    /**
     * The greatest torque of the motor [N m], >= 0; default 0.
     */
    mvFloat maxMotorTorque;
    /**
     * The speed that the motor wants [rad/s]; default 0.
     */
    mvFloat motorSpeed;
    /**
     * The torque of dry friction [N m], >= 0; default 0.
     */
    mvFloat friction;
} mvScrewJointDef;

/**
 * What an axis of a six-axes joint may do: one of mv_axisFree, mv_axisLocked, mv_axisLimited.
 */
typedef int32_t mvAxisMode;

/**
 * One axis of a six-axes joint. Lengths [m] and forces [N] for the first three, angles [rad] and torques [N m] for the
 * others.
 */
typedef struct mvSixDofAxis {
    /**
     * What the axis may do; default mv_axisLocked.
     */
    mvAxisMode mode;
    /**
     * Where the spring rests; default 0.
     */
    mvFloat target;
    /**
     * The frequency of the spring [Hz], >= 0; default 0: no force.
     */
    mvFloat hertz;
    /**
     * Its damping ratio, >= 0; 1 is critical; default 0.
     */
    mvFloat dampingRatio;
    /**
     * Its greatest force or torque, >= 0; default infinity.
     */
    mvFloat maxSpringForce;
    /**
     * The least value, where the mode is mv_axisLimited; default 0.
     */
    mvFloat lower;
    /**
     * The greatest value, not below the least; default 0.
     */
    mvFloat upper;
    /**
     * The speed that the motor wants [m/s or rad/s]; default 0.
     */
    mvFloat motorSpeed;
    /**
     * The greatest force or torque of the motor, >= 0; default 0.
     */
    mvFloat maxMotorForce;
    /**
     * The force or torque of dry friction, >= 0; default 0.
     */
    mvFloat friction;
    /**
     * Whether the spring acts; default false.
     */
    bool enableSpring;
    /**
     * Whether the motor acts; default false.
     */
    bool enableMotor;
} mvSixDofAxis;

/**
 * A joint of six axes, each of them free, locked or limited, with spring, motor and friction. Axes 0 to 2 are the
 * parts along x, y, z of frame A of the way from its origin to that of frame B; axes 3 to 5 the parts of the
 * rotation vector of frame B against frame A.
 * Made by mvDefaultSixDofJointDef(): all locked.
 */
typedef struct mvSixDofJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * The axes: along x, y, z [m], then about x, y, z [rad]. All locked by default.
     */
    mvSixDofAxis axes[6];
} mvSixDofJointDef;

/**
 * A spherical joint: the origins of the frames stay together. The turn of frame B against frame A may be limited:
 * its z axis to a cone about that of frame A, and the twist about z.
 * Made by mvDefaultSphericalJointDef().
 */
typedef struct mvSphericalJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * Whether a spring turns B towards targetRotation; default false.
     */
    bool enableSpring;
    /**
     * The frequency of the spring [Hz], >= 0; default 0: no torque.
     */
    mvFloat hertz;
    /**
     * Its damping ratio, >= 0; 1 is critical; default 0.
     */
    mvFloat dampingRatio;
    /**
     * Its greatest torque about each axis [N m], >= 0; default infinity.
     */
    mvFloat maxSpringTorque;
    /**
     * The rotation of frame B in frame A at which the spring rests; default the identity.
     */
    mvQuat targetRotation;
    /**
     * Whether the cone limits; default false.
     */
    bool enableConeLimit;
    /**
     * The half-angle of the cone for turns about x of frame A [rad], 0 to pi; default 0.
     */
    mvFloat coneAngle;
    /**
     * The half-angle for turns about y of frame A [rad], at most pi; negative, the default, means that of x: a
     * round cone.
     */
    mvFloat coneAngleY;
    /**
     * Whether the twist is limited; default false.
     */
    bool enableTwistLimit;
    /**
     * The least twist about z [rad]; default 0.
     */
    mvFloat lowerTwistAngle;
    /**
     * The greatest twist [rad], not below the least; default 0.
     */
    mvFloat upperTwistAngle;
    /**
     * Whether a motor acts; default false.
     */
    bool enableMotor;
    /**
     * Its greatest torque about each axis [N m], >= 0; default 0.
     */
    mvFloat maxMotorTorque;
    /**
     * The angular velocity of B against A that it wants, in the axes of frame A [rad/s]; default 0.
     */
    mvVec3 motorVelocity;
    /**
     * The torque of dry friction about each axis [N m], >= 0; default 0.
     */
    mvFloat friction;
} mvSphericalJointDef;

/**
 * A universal joint: the origins of the frames stay together and x of frame A stays across y of frame B. B turns
 * about x of frame A by the first angle and about its own y by the second.
 * Made by mvDefaultUniversalJointDef().
 */
typedef struct mvUniversalJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * Whether a spring acts on the angle about x of frame A; default false.
     */
    bool enableSpring1;
    /**
     * Its frequency [Hz], >= 0; default 0: no torque.
     */
    mvFloat hertz1;
    /**
     * Its damping ratio, >= 0; 1 is critical; default 0.
     */
    mvFloat dampingRatio1;
    /**
     * The angle at which it rests [rad]; default 0.
     */
    mvFloat targetAngle1;
    /**
     * Whether the angle about x of frame A is limited; default false.
     */
    bool enableLimit1;
    /**
     * The least angle [rad]; default 0.
     */
    mvFloat lowerAngle1;
    /**
     * The greatest angle [rad], not below the least; default 0.
     */
    mvFloat upperAngle1;
    /**
     * Whether a motor turns B about x of frame A; default false.
     */
    bool enableMotor1;
    /**
     * Its greatest torque [N m], >= 0; default 0.
     */
    mvFloat maxMotorTorque1;
    /**
     * The speed that it wants [rad/s]; default 0.
     */
    mvFloat motorSpeed1;
    /**
     * The torque of dry friction about x of frame A [N m], >= 0; default 0.
     */
    mvFloat friction1;
    /**
     * Whether a spring acts on the angle about y of frame B; default false.
     */
    bool enableSpring2;
    /**
     * Its frequency [Hz], >= 0; default 0: no torque.
     */
    mvFloat hertz2;
    /**
     * Its damping ratio, >= 0; 1 is critical; default 0.
     */
    mvFloat dampingRatio2;
    /**
     * The angle at which it rests [rad]; default 0.
     */
    mvFloat targetAngle2;
    /**
     * Whether the angle about y of frame B is limited; default false.
     */
    bool enableLimit2;
    /**
     * The least angle [rad]; default 0.
     */
    mvFloat lowerAngle2;
    /**
     * The greatest angle [rad], not below the least; default 0.
     */
    mvFloat upperAngle2;
    /**
     * Whether a motor turns B about y of frame B; default false.
     */
    bool enableMotor2;
    /**
     * Its greatest torque [N m], >= 0; default 0.
     */
    mvFloat maxMotorTorque2;
    /**
     * The speed that it wants [rad/s]; default 0.
     */
    mvFloat motorSpeed2;
    /**
     * The torque of dry friction about y of frame B [N m], >= 0; default 0.
     */
    mvFloat friction2;
} mvUniversalJointDef;

/**
 * A weld joint: holds the frames together, rigidly or by springs.
 * Made by mvDefaultWeldJointDef().
 */
typedef struct mvWeldJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * The stiffness of the place [Hz], >= 0; 0, the default, is rigid.
     */
    mvFloat linearHertz;
    /**
     * The stiffness of the rotation [Hz], >= 0; 0, the default, is rigid.
     */
    mvFloat angularHertz;
    /**
     * The damping ratio of the place, >= 0; default 0.
     */
    mvFloat linearDampingRatio;
    /**
     * The damping ratio of the rotation, >= 0; default 0.
     */
    mvFloat angularDampingRatio;
} mvWeldJointDef;

/**
 * A wheel joint: A is the chassis, B the wheel. The wheel travels along x of frame A, spins about z of frame B and
 * may steer about x of frame A.
 * Made by mvDefaultWheelJointDef().
 */
typedef struct mvWheelJointDef {
    /**
     * Shows that the definition was made by its function. Leave it alone.
     */
    int32_t internalValue;
    /**
     * What all joints have.
     */
    mvJointDef base;
    /**
     * Whether the suspension has a spring; default true.
     */
    bool enableSuspensionSpring;
    /**
     * Its frequency [Hz], >= 0; default 1.
     */
    mvFloat suspensionHertz;
    /**
     * Its damping ratio, >= 0; default 0.7.
     */
    mvFloat suspensionDampingRatio;
    /**
     * The travel at which it rests [m]; default 0.
     */
    mvFloat targetSuspension;
    /**
     * Its greatest force [N], >= 0; default infinity.
     */
    mvFloat maxSuspensionForce;
    /**
     * Whether the travel is limited; default false.
     */
    bool enableSuspensionLimit;
    /**
     * The least travel [m]; default 0.
     */
    mvFloat lowerSuspensionLimit;
    /**
     * The greatest travel [m], not below the least; default 0.
     */
    mvFloat upperSuspensionLimit;
    /**
     * Whether a motor spins the wheel; default false.
     */
    bool enableSpinMotor;
    /**
     * Its greatest torque [N m], >= 0; default 0.
     */
    mvFloat maxSpinTorque;
    /**
     * The speed that it wants [rad/s]; default 0.
     */
    mvFloat spinSpeed;
    /**
     * The torque of dry friction in the bearing [N m], >= 0; default 0.
     */
    mvFloat spinFriction;
    /**
     * Whether the wheel steers; default false.
     */
    bool enableSteering;
    /**
     * The frequency of the spring that steers [Hz], >= 0; default 1.
     */
    mvFloat steeringHertz;
    /**
     * Its damping ratio, >= 0; default 0.7.
     */
    mvFloat steeringDampingRatio;
    /**
     * The angle that it steers to [rad]; default 0.
     */
    mvFloat targetSteeringAngle;
    /**
     * Its greatest torque [N m], >= 0; default 0.
     */
    mvFloat maxSteeringTorque;
    /**
     * Whether the steering angle is limited; default false.
     */
    bool enableSteeringLimit;
    /**
     * The least steering angle [rad]; default 0.
     */
    mvFloat lowerSteeringLimit;
    /**
     * The greatest steering angle [rad], not below the least; default 0.
     */
    mvFloat upperSteeringLimit;
} mvWheelJointDef;

/**
 * Cosine and sine of one angle.
 */
typedef struct mvCosSin {
    /**
     * The cosine.
     */
    mvFloat cosine;
    /**
     * The sine.
     */
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
 * What a query looked at.
 */
typedef struct mvTreeStats {
    /**
     * The number of shapes that the callback was told of.
     */
    int leafVisits;
} mvTreeStats;

/**
 * Told of a shape that an overlap query found.
 *
 * @return true to go on, false to stop
 */
typedef bool (*mvOverlapResultFcn)(mvShapeId shapeId, void *context);

/**
 * Told of a shape that a ray or a moving solid hit, nearest first.
 *
 * @param point where, in the world [m]
 * @param normal the outward normal of the surface there
 * @param fraction the fraction of the translation travelled
 * @param userMaterialId the user material of the shape
 * @param triangleIndex -1: shapes of triangles are not built yet
 * @param childIndex -1: compound shapes are not built yet
 * @return -1 to ignore this shape, 0 to stop, a fraction to look no farther than that, 1 to go on
 */
typedef mvFloat (*mvCastResultFcn)(mvShapeId shapeId,
                                   mvPos point,
                                   mvVec3 normal,
                                   mvFloat fraction,
                                   uint64_t userMaterialId,
                                   int triangleIndex,
                                   int childIndex,
                                   void *context);

/**
 * Where a ray or a moving solid hits a shape.
 */
typedef struct mvRayResult {
    /**
     * The shape that was hit.
     */
    mvShapeId shapeId;
    /**
     * The point on its surface [m].
     */
    mvPos point;
    /**
     * The outward normal of the surface at the point, of length 1; zero where a moving solid overlaps the shape from
     * the start.
     */
    mvVec3 normal;
    /**
     * The user material of the shape.
     */
    uint64_t userMaterialId;
    /**
     * The fraction of the translation travelled.
     */
    mvFloat fraction;
    /**
     * Whether there was a hit. If not, everything else is zero.
     */
    bool hit;
} mvRayResult;

/**
 * What a shape is: one of the mv_...Shape constants. Boxes are hulls.
 */
typedef int32_t mvShapeType;

/**
 * Where a ray or a moving shape hits a shape of a world.
 */
typedef struct mvWorldCastOutput {
    /**
     * The outward normal of the surface at the point, of length 1.
     */
    mvVec3 normal;
    /**
     * The point on the surface [m].
     */
    mvPos point;
    /**
     * The fraction of the translation travelled.
     */
    mvFloat fraction;
    /**
     * The number of iterations used; 0 where the answer is a closed form.
     */
    int iterations;
    /**
     * Whether there was a hit. If not, everything else is zero.
     */
    bool hit;
} mvWorldCastOutput;

/**
 * Decides whether two shapes may collide. Asked on the stepping thread, when their boxes meet and one of them has
 * enableCustomFiltering. The world may be read but not changed.
 *
 * @return false to let them pass through each other
 */
typedef bool (*mvCustomFilterFcn)(mvShapeId shapeIdA, mvShapeId shapeIdB, void *context);

/**
 * Decides whether a contact acts in this step. Asked on the stepping thread, in every step in which the shapes
 * touch or nearly do and one of them has enablePreSolveEvents. The world may be read but not changed.
 *
 * @param point one of the points of contact
 * @param normal from shape A to shape B, of length 1
 * @return false to let the shapes pass through each other in this step
 */
typedef bool (*mvPreSolveFcn)(mvShapeId shapeIdA,
                              mvShapeId shapeIdB,
                              mvPos point,
                              mvVec3 normal,
                              void *context);

/**
 * How overlap of contacts is recovered.
 */
typedef struct mvContactTuning {
    /**
     * How stiff contacts are, as a fraction of the sub-step rate.
     */
    mvFloat stiffness;
    /**
     * How strongly recovery is damped; 1 is critical.
     */
    mvFloat dampingRatio;
    /**
     * The greatest speed at which overlap is pushed out [m/s].
     */
    mvFloat contactSpeed;
} mvContactTuning;

/**
 * Milliseconds of the last step, by stage.
 */
typedef struct mvProfile {
    /**
     * The whole step.
     */
    float step;
    /**
     * Boxes around shapes.
     */
    float updateBounds;
    /**
     * Pairs of shapes whose boxes meet.
     */
    float pairs;
    /**
     * Contact points.
     */
    float collide;
    /**
     * Islands.
     */
    float islands;
    /**
     * Rehearsals, where an accuracy is to be kept.
     */
    float rehearse;
    /**
     * Laying out the constraints.
     */
    float prepare;
    /**
     * Solving, all sub-steps.
     */
    float solve;
    /**
     * Moving the bodies.
     */
    float transforms;
    /**
     * Falling asleep.
     */
    float sleep;
    /**
     * Events.
     */
    float events;
} mvProfile;

/**
 * How much there is of everything.
 */
typedef struct mvCounters {
    /**
     * Bodies of all types.
     */
    int bodyCount;
    /**
     * Awake bodies, kinematic ones included.
     */
    int awakeBodyCount;
    /**
     * Shapes.
     */
    int shapeCount;
    /**
     * Joints.
     */
    int jointCount;
    /**
     * Pairs of shapes whose boxes meet.
     */
    int contactCount;
    /**
     * Contacts that acted in the last step.
     */
    int constraintCount;
    /**
     * Those of them that had to be solved one by one.
     */
    int overflowCount;
    /**
     * Islands that are awake.
     */
    int islandCount;
    /**
     * The longest way through the trees of the broad phase.
     */
    int treeHeight;
    /**
     * Bytes that the world holds.
     */
    int64_t byteCount;
} mvCounters;

/**
 * Conserved quantities and errors of a world, as it is now.
 */
typedef struct mvStepReport {
    /**
     * Energy of translation and rotation of the dynamic bodies [J].
     */
    double kineticEnergy;
    /**
     * Energy of the dynamic bodies in the field of gravity, zero at the world's origin [J].
     */
    double potentialEnergy;
    /**
     * Sum of the momenta: x, y, z [kg m/s].
     */
    double linearMomentum[3];
    /**
     * Sum of the angular momenta about the world's origin: x, y, z [kg m^2/s].
     */
    double angularMomentum[3];
    /**
     * The deepest overlap of any contact [m].
     */
    mvFloat worstPenetration;
    /**
     * The greatest error of what rigid joints hold: of lengths [m].
     */
    mvFloat jointGap;
    /**
     * The same of angles [rad].
     */
    mvFloat jointAngleGap;
    /**
     * The greatest approach speed left at a loaded contact point [m/s].
     */
    mvFloat residual;
    /**
     * The sub-steps of the last step, as it was asked for.
     */
    int subStepCount;
    /**
     * The most sub-steps that an island had in the last step: more than that only with an accuracy to keep.
     */
    int mostSubStepCount;
    /**
     * The greatest error that rehearsals of awake islands found last: what a step adds to the motion, as a share of the
     * way gone in it. 0 without an accuracy.
     */
    mvFloat error;
    /**
     * The solver of the last step: one of the mv_solver... constants.
     */
    mvSolverKind solver;
    /**
     * The greatest error of the contact laws at any point when the solver was done [m/s]; softStep does not measure
     * it and leaves 0.
     */
    mvFloat solverResidual;
    /**
     * The islands that an exact solver (lemke, dantzig, proximalAdmm) was asked to solve in the last step.
     */
    int solveCount;
    /**
     * Those of them that were too large for it, and swept by projected Gauss-Seidel instead.
     */
    int tooLargeCount;
    /**
     * Those of them that it did not solve, and that were swept instead.
     */
    int unsolvedCount;
    /**
     * The islands swept instead of solved since the world began.
     */
    int64_t fallbackCount;
    /**
     * Steps so far.
     */
    int64_t stepCount;
    /**
     * Bodies put to rest because their state stopped being finite.
     */
    int64_t quarantinedCount;
    /**
     * How much there is of everything.
     */
    mvCounters counters;
    /**
     * Milliseconds of the last step.
     */
    mvProfile profile;
} mvStepReport;

/**
 * A vector or point in two dimensions.
 */
typedef struct mvVec2 {
    /**
     * Along x.
     */
    mvFloat x;
    /**
     * Along y.
     */
    mvFloat y;
} mvVec2;

/**
 * A ball: size is (radius, radius, radius).
 */
#define mv_drawSphere 0

/**
 * A capsule along y: size is (radius, half the length of its segment, radius).
 */
#define mv_drawCapsule 1

/**
 * A box: size is its half extents.
 */
#define mv_drawBox 2

/**
 * Never moves by itself; nothing pushes it.
 */
#define mv_staticBody 0

/**
 * Moves with the velocity it is given; nothing pushes it.
 */
#define mv_kinematicBody 1

/**
 * Moves by forces and contacts.
 */
#define mv_dynamicBody 2

/**
 * What the library thinks best.
 */
#define mv_solver_auto 0

/**
 * What the library thinks best.
 */
#define mv_integrator_auto 0

/**
 * What the library thinks best.
 */
#define mv_broadPhase_auto 0

/**
 * What the library thinks best.
 */
#define mv_narrowPhase_auto 0

/**
 * What the library thinks best.
 */
#define mv_gjk_auto 0

/**
 * What the library thinks best.
 */
#define mv_manifold_auto 0

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

/**
 * A spring keeps two axes along each other.
 */
#define mv_parallelJoint 0

/**
 * A rod, rope or spring between two points.
 */
#define mv_distanceJoint 1

/**
 * The bodies do not collide.
 */
#define mv_filterJoint 2

/**
 * Drives one body against another.
 */
#define mv_motorJoint 3

/**
 * A slide along x.
 */
#define mv_prismaticJoint 4

/**
 * A hinge about z.
 */
#define mv_revoluteJoint 5

/**
 * Ball and socket.
 */
#define mv_sphericalJoint 6

/**
 * Two bodies as one.
 */
#define mv_weldJoint 7

/**
 * A wheel on its suspension.
 */
#define mv_wheelJoint 8

/**
 * Cardan's joint.
 */
#define mv_universalJoint 9

/**
 * Six axes, each free, locked or limited.
 */
#define mv_sixDofJoint 10

/**
 * Two joints in step.
 */
#define mv_gearJoint 11

/**
 * A turn in step with a slide.
 */
#define mv_rackPinionJoint 12

/**
 * A rope over two fixed points.
 */
#define mv_pulleyJoint 13

/**
 * A slide in step with a turn about the same axis.
 */
#define mv_screwJoint 14

/**
 * The axis is free; spring, motor and friction may act.
 */
#define mv_axisFree 0

/**
 * The axis is held at 0.
 */
#define mv_axisLocked 1

/**
 * The axis is kept within its limits; spring, motor and friction may act.
 */
#define mv_axisLimited 2

/**
 * Soft contacts, sub-steps instead of iterations.
 */
#define mv_solver_softStep 1

/**
 * The thesis's: the impulse of a collision at every point, again and again; for comparison.
 */
#define mv_solver_sequentialImpulse 2

/**
 * Accumulated impulses, their sum is clamped; begins with those of the last step.
 */
#define mv_solver_projectedGaussSeidel 3

/**
 * All contacts of an island at once by complementary pivoting, friction pyramids; for small scenes.
 */
#define mv_solver_lemke 4

/**
 * All contacts of an island at once by principal pivoting with bounds, friction pyramids; for small scenes.
 */
#define mv_solver_dantzig 5

/**
 * All contacts of an island at once, exact friction cones; for scenes of moderate size.
 */
#define mv_solver_proximalAdmm 6

/**
 * Velocities of the start of the step: the thesis's method, for comparison.
 */
#define mv_integrator_explicitEuler 1

/**
 * Velocities of the end of the step: what most engines do, for comparison.
 */
#define mv_integrator_semiImplicitEuler 2

/**
 * Exact flight, and a rotation that keeps energy and angular momentum.
 */
#define mv_integrator_moserVeselov 3

/**
 * Exact flight, rotation by exact turns about the principal axes.
 */
#define mv_integrator_symmetricSplitting 4

/**
 * Exact flight, rotation by the angular velocity of the middle of the step.
 */
#define mv_integrator_lieMidpoint 5

/**
 * Exact flight, rotation by Runge and Kutta's method of fourth order.
 */
#define mv_integrator_rk4 6

/**
 * Exact flight, rotation by elliptic functions.
 */
#define mv_integrator_exactRotation 7

/**
 * All pairs are looked at: slow, simple, a yardstick.
 */
#define mv_broadPhase_bruteForce 1

/**
 * Trees of boxes that follow the motion.
 */
#define mv_broadPhase_dynamicBvh 2

/**
 * One list sorted along the axis of greatest spread.
 */
#define mv_broadPhase_sortAndSweep 3

/**
 * Three sorted lists, whose overlaps are intersected.
 */
#define mv_broadPhase_sortAndSweep3 4

/**
 * Guttman's R-tree, grown box by box.
 */
#define mv_broadPhase_rTree 5

/**
 * The R*-tree, grown box by box with reinsertion.
 */
#define mv_broadPhase_rStar 6

/**
 * An R-tree packed by sort-tile-recursive, built anew as boxes change.
 */
#define mv_broadPhase_str 7

/**
 * An R-tree packed top-down with least overlap, built anew as boxes change.
 */
#define mv_broadPhase_omt 8

/**
 * All pairs but those of two standing shapes.
 */
#define mv_broadPhase_bruteForceSplit 9

/**
 * The same as mv_broadPhase_sortAndSweep, with what stands in a list of its own.
 */
#define mv_broadPhase_sortAndSweepSplit 10

/**
 * The same as mv_broadPhase_sortAndSweep3, with what stands in lists of its own.
 */
#define mv_broadPhase_sortAndSweep3Split 11

/**
 * The same as mv_broadPhase_rTree, with what stands in a tree of its own.
 */
#define mv_broadPhase_rTreeSplit 12

/**
 * The same as mv_broadPhase_rStar, with what stands in a tree of its own.
 */
#define mv_broadPhase_rStarSplit 13

/**
 * The same as mv_broadPhase_str, with what stands in a tree of its own.
 */
#define mv_broadPhase_strSplit 14

/**
 * The same as mv_broadPhase_omt, with what stands in a tree of its own.
 */
#define mv_broadPhase_omtSplit 15

/**
 * R-trees packed as mv_broadPhase_omt, patched where shapes move and packed anew when worn out.
 */
#define mv_broadPhase_dynamicRTree 16

/**
 * Closed forms and separating axes.
 */
#define mv_narrowPhase_specialised 1

/**
 * Iterative distance and penetration: a cross-check by another way.
 */
#define mv_narrowPhase_gjkEpa 2

/**
 * Iterative distance, and penetration along a ray: cheaper, but the penetration need not be the least.
 */
#define mv_narrowPhase_gjkMpr 3

/**
 * A linear system for barycentric coordinates, with recursion over faces: slow, a yardstick.
 */
#define mv_gjk_barycentric 1

/**
 * The Voronoi regions of vertices, edges and faces.
 */
#define mv_gjk_cutSpace 2

/**
 * Signs of volumes.
 */
#define mv_gjk_signedVolumes 3

/**
 * Cofactors of all faces, with a backup procedure.
 */
#define mv_gjk_johnson 4

/**
 * One face is cut by the sides of the other.
 */
#define mv_manifold_sutherlandHodgman 1

/**
 * Both faces are intersected by the polygon library Clipper2. Fails with mv_errorUnsupported where it is not built in.
 */
#define mv_manifold_clipper2 2

/**
 * All points within a radius of a segment.
 */
#define mv_capsuleShape 0

/**
 * A convex solid with flat faces, boxes included.
 */
#define mv_hullShape 3

/**
 * A ball.
 */
#define mv_sphereShape 5

/**
 * Everything below a plane.
 */
#define mv_planeShape 6

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
 * Create a body. It has no mass before it has a shape with a density, or mass data of its own.
 *
 * @param worldId the world
 * @param def the definition, from mvDefaultBodyDef()
 * @return the body; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
 */
MV_API mvBodyId mvCreateBody(mvWorldId worldId, const mvBodyDef *def);

/**
 * Destroy a body with its shapes. What it touched wakes up.
 * @param bodyId the body
 */
MV_API void mvDestroyBody(mvBodyId bodyId);

/**
 * Does this id name a body that lives? Never fails; false also while another thread changes the world.
 */
MV_API bool mvBody_IsValid(mvBodyId id);

/**
 * Get the world that a body lives in.
 * @param bodyId the body
 * @return the world; null for a bad body
 */
MV_API mvWorldId mvBody_GetWorld(mvBodyId bodyId);

/**
 * Get how a body moves.
 * @param bodyId the body
 * @return mv_staticBody, mv_kinematicBody or mv_dynamicBody; mv_staticBody for a bad body
 */
MV_API mvBodyType mvBody_GetType(mvBodyId bodyId);

/**
 * Change how a body moves. Its mass becomes that of its shapes again; a static body stands still.
 * @param bodyId the body
 * @param type mv_staticBody, mv_kinematicBody or mv_dynamicBody
 * @note Errors: mv_errorRange, also when a plane would move.
 */
MV_API void mvBody_SetType(mvBodyId bodyId, mvBodyType type);

/**
 * Set the name of a body.
 * @param bodyId the body
 * @param name UTF-8, copied; null for none
 * @note Errors: mv_errorRange when the name is not UTF-8.
 */
MV_API void mvBody_SetName(mvBodyId bodyId, const char *name);

/**
 * Get the name of a body.
 * @param bodyId the body
 * @return UTF-8, empty for none; null for a bad body. Valid until the name is changed or the body destroyed.
 */
MV_API const char *mvBody_GetName(mvBodyId bodyId);

/**
 * Set the user data of a body.
 * @param bodyId the body
 * @param userData anything; it is never followed
 */
MV_API void mvBody_SetUserData(mvBodyId bodyId, void *userData);

/**
 * Get the user data of a body.
 * @param bodyId the body
 * @return what was set; null for a bad body
 */
MV_API void *mvBody_GetUserData(mvBodyId bodyId);

/**
 * Does the next step move this body?
 * @param bodyId the body
 */
MV_API bool mvBody_IsAwake(mvBodyId bodyId);

/**
 * Wake a body and what it touches, or put them to sleep, whatever their speed. Only dynamic bodies sleep.
 * @param bodyId the body
 * @param awake whether to wake or to put to sleep
 */
MV_API void mvBody_SetAwake(mvBodyId bodyId, bool awake);

/**
 * Let a body fall asleep, or wake it and keep it awake.
 * @param bodyId the body
 * @param enableSleep whether the body may sleep
 */
MV_API void mvBody_EnableSleep(mvBodyId bodyId, bool enableSleep);

/**
 * May this body fall asleep?
 * @param bodyId the body
 */
MV_API bool mvBody_IsSleepEnabled(mvBodyId bodyId);

/**
 * Set the speed below which a body may fall asleep.
 * @param bodyId the body
 * @param sleepThreshold the speed [m/s], >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_SetSleepThreshold(mvBodyId bodyId, mvFloat sleepThreshold);

/**
 * Get the speed below which a body may fall asleep.
 * @param bodyId the body
 * @return the speed [m/s]; 0 for a bad body
 */
MV_API mvFloat mvBody_GetSleepThreshold(mvBodyId bodyId);

/**
 * Get the sub-steps that the next step takes for a body: those of the last step, or more where the world has an accuracy
 * to keep, see mvWorldDef.accuracy.
 * @param bodyId the body
 * @return a count; 0 before the first step and for a bad body
 */
MV_API
int mvBody_GetSubStepCount(mvBodyId bodyId);

/**
 * Does this body take part in the world?
 * @param bodyId the body
 */
MV_API bool mvBody_IsEnabled(mvBodyId bodyId);

/**
 * Take a body out of the world, keeping its state. What it touched wakes up.
 * @param bodyId the body
 */
MV_API void mvBody_Disable(mvBodyId bodyId);

/**
 * Put a body back into the world, awake.
 * @param bodyId the body
 */
MV_API void mvBody_Enable(mvBodyId bodyId);

/**
 * Set the directions in which a body cannot move; its velocity along them becomes 0. Only dynamic bodies have
 * locks.
 * @param bodyId the body
 * @param locks the directions
 * @note Errors: mv_errorRange for a lock that is neither true nor false.
 */
MV_API void mvBody_SetMotionLocks(mvBodyId bodyId, mvMotionLocks locks);

/**
 * Get the directions in which a body cannot move.
 * @param bodyId the body
 */
MV_API mvMotionLocks mvBody_GetMotionLocks(mvBodyId bodyId);

/**
 * Make hit events for contacts of all shapes that a body has now, or not.
 * @param bodyId the body
 * @param flag whether to make them
 */
MV_API void mvBody_EnableHitEvents(mvBodyId bodyId, bool flag);

/**
 * Get the number of shapes of a body.
 * @param bodyId the body
 */
MV_API int mvBody_GetShapeCount(mvBodyId bodyId);

/**
 * Get the shapes of a body, in the order in which they were made.
 * @param bodyId the body
 * @param shapeArray filled with the shapes; may be null
 * @param capacity the room in the array, >= 0
 * @return how many were written
 * @note Errors: mv_errorRange.
 */
MV_API int mvBody_GetShapes(mvBodyId bodyId, mvShapeId *shapeArray, int capacity);

/**
 * Get the number of joints of a body. Gears count at all bodies of their two joints.
 * @param bodyId the body
 */
MV_API int mvBody_GetJointCount(mvBodyId bodyId);

/**
 * Get the joints of a body, in no particular order.
 * @param bodyId the body
 * @param jointArray filled with the joints; may be null
 * @param capacity the room in the array, >= 0
 * @return how many were written
 * @note Errors: mv_errorRange.
 */
MV_API int mvBody_GetJoints(mvBodyId bodyId, mvJointId *jointArray, int capacity);

/**
 * Get the box around all shapes of a body; around its origin when it has none.
 * @param bodyId the body
 * @return the box; zero for a bad body
 */
MV_API mvAABB mvBody_ComputeAABB(mvBodyId bodyId);

/**
 * Get an upper bound for the number of a body's touching contacts.
 * @param bodyId the body
 */
MV_API int mvBody_GetContactCapacity(mvBodyId bodyId);

/**
 * Get the touching contacts of a body, as of the last step.
 * @param bodyId the body
 * @param contactData filled with the contacts; may be null
 * @param capacity the room in the array, >= 0
 * @return how many were written
 * @note Errors: mv_errorRange.
 */
MV_API int mvBody_GetContactData(mvBodyId bodyId, mvContactData *contactData, int capacity);

/**
 * Get the mass of a body.
 * @param bodyId the body
 * @return the mass [kg]; 0 for a body without mass or a bad one
 */
MV_API mvFloat mvBody_GetMass(mvBodyId bodyId);

/**
 * Get one divided by the mass of a body.
 * @param bodyId the body
 * @return the inverse mass [1/kg]; 0 for a body without mass or a bad one
 */
MV_API mvFloat mvBody_GetInverseMass(mvBodyId bodyId);

/**
 * Get the inertia of a body about its centre of mass, in the axes of the body.
 * @param bodyId the body
 * @return the inertia [kg m^2]; zero for a body without mass or a bad one
 */
MV_API mvMatrix3 mvBody_GetLocalRotationalInertia(mvBodyId bodyId);

/**
 * Get the inverse of the inertia of a body about its centre of mass, in world axes. Locked axes count as infinite
 * inertia.
 * @param bodyId the body
 * @return the inverse inertia [1/(kg m^2)]; zero for a body without mass or a bad one
 */
MV_API
mvMatrix3 mvBody_GetWorldInverseRotationalInertia(mvBodyId bodyId);

/**
 * Get the centre of mass of a body, in the body's frame.
 * @param bodyId the body
 * @return the centre [m]; zero for a bad body
 */
MV_API mvVec3 mvBody_GetLocalCenter(mvBodyId bodyId);

/**
 * Get the centre of mass of a body, in the world.
 * @param bodyId the body
 * @return the centre [m]; zero for a bad body
 */
MV_API mvPos mvBody_GetWorldCenter(mvBodyId bodyId);

/**
 * Give a dynamic body a mass of its own. Shapes no longer change it until mvBody_ApplyMassFromShapes() or
 * mvBody_SetType().
 * @param bodyId the body
 * @param massData mass, centre of mass in the body's frame, inertia about that centre in the body's axes
 * @note Errors: mv_errorNotFinite, mv_errorRange for a body that is not dynamic, a negative mass or an inertia that no
 * solid has, mv_errorDegenerate.
 */
MV_API
void mvBody_SetMassData(mvBodyId bodyId,
                        mvMassData massData);

/**
 * Get mass, centre of mass and inertia of a body.
 * @param bodyId the body
 * @return the figures; zero for a body without mass or a bad one
 */
MV_API mvMassData mvBody_GetMassData(mvBodyId bodyId);

/**
 * Make the mass of a body that of its shapes: after mvBody_SetMassData(), or after shapes were made, changed or
 * destroyed without updating it.
 * @param bodyId the body
 */
MV_API
void mvBody_ApplyMassFromShapes(mvBodyId bodyId);

/**
 * Set the fraction of a body's velocity lost per second, for small values.
 * @param bodyId the body
 * @param linearDamping the value [1/s], >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_SetLinearDamping(mvBodyId bodyId, mvFloat linearDamping);

/**
 * Get the fraction of a body's velocity lost per second, for small values.
 * @param bodyId the body
 * @return the value [1/s]; 0 for a bad body
 */
MV_API mvFloat mvBody_GetLinearDamping(mvBodyId bodyId);

/**
 * Set the fraction of a body's angular velocity lost per second, for small values.
 * @param bodyId the body
 * @param angularDamping the value [1/s], >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_SetAngularDamping(mvBodyId bodyId, mvFloat angularDamping);

/**
 * Get the fraction of a body's angular velocity lost per second, for small values.
 * @param bodyId the body
 * @return the value [1/s]; 0 for a bad body
 */
MV_API mvFloat mvBody_GetAngularDamping(mvBodyId bodyId);

/**
 * Set the factor on gravity of a body.
 * @param bodyId the body
 * @param gravityScale the value
 * @note Errors: mv_errorNotFinite.
 */
MV_API void mvBody_SetGravityScale(mvBodyId bodyId, mvFloat gravityScale);

/**
 * Get the factor on gravity of a body.
 * @param bodyId the body
 * @return the value; 0 for a bad body
 */
MV_API mvFloat mvBody_GetGravityScale(mvBodyId bodyId);

/**
 * Get the position of a body's origin.
 * @param bodyId the body
 * @return the position [m]; zero for a bad body
 */
MV_API mvPos mvBody_GetPosition(mvBodyId bodyId);

/**
 * Get the rotation of a body.
 * @param bodyId the body
 * @return the rotation; the identity for a bad body
 */
MV_API mvQuat mvBody_GetRotation(mvBodyId bodyId);

/**
 * Get where a body is: the position of its origin, and its rotation.
 * @param bodyId the body
 * @return the placement; the identity for a bad body
 */
MV_API mvWorldTransform mvBody_GetTransform(mvBodyId bodyId);

/**
 * Move a body at once, without regard for what is in the way. Its velocity stays; what it touched wakes up.
 * @param bodyId the body
 * @param position where its origin goes [m]
 * @param rotation its new rotation, of length 1
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_SetTransform(mvBodyId bodyId, mvPos position, mvQuat rotation);

/**
 * Give a body the velocity that takes it to a placement in a given time. Meant for kinematic bodies.
 * @param bodyId the body
 * @param target where its origin shall go
 * @param timeStep in which time [s], > 0
 * @param wake whether to wake the body; a sleeping body is left alone otherwise
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
void mvBody_SetTargetTransform(mvBodyId bodyId,
                               mvWorldTransform target,
                               mvFloat timeStep,
                               bool wake);

/**
 * Get a point of the world as seen from a body.
 * @param bodyId the body
 * @param worldPoint the point [m]
 * @return the point in the body's frame; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API mvVec3 mvBody_GetLocalPoint(mvBodyId bodyId, mvPos worldPoint);

/**
 * Get a point of a body as seen from the world.
 * @param bodyId the body
 * @param localPoint the point in the body's frame [m]
 * @return the point in the world; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API mvPos mvBody_GetWorldPoint(mvBodyId bodyId, mvVec3 localPoint);

/**
 * Get a vector of the world as seen from a body.
 * @param bodyId the body
 * @param worldVector the vector
 * @return the vector in the body's frame; zero for bad arguments
 * @note Errors: mv_errorNotFinite.
 */
MV_API mvVec3 mvBody_GetLocalVector(mvBodyId bodyId, mvVec3 worldVector);

/**
 * Get a vector of a body as seen from the world.
 * @param bodyId the body
 * @param localVector the vector in the body's frame
 * @return the vector in the world; zero for bad arguments
 * @note Errors: mv_errorNotFinite.
 */
MV_API mvVec3 mvBody_GetWorldVector(mvBodyId bodyId, mvVec3 localVector);

/**
 * Get the velocity of a point of a body.
 * @param bodyId the body
 * @param localPoint the point in the body's frame [m]
 * @return the velocity in world axes [m/s]; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API mvVec3 mvBody_GetLocalPointVelocity(mvBodyId bodyId, mvVec3 localPoint);

/**
 * Get the velocity of the point of a body that is at a point of the world.
 * @param bodyId the body
 * @param worldPoint the point [m]
 * @return the velocity in world axes [m/s]; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API mvVec3 mvBody_GetWorldPointVelocity(mvBodyId bodyId, mvPos worldPoint);

/**
 * Get the velocity of a body's centre of mass.
 * @param bodyId the body
 * @return the velocity [m/s]; zero for a bad body
 */
MV_API mvVec3 mvBody_GetLinearVelocity(mvBodyId bodyId);

/**
 * Set the velocity of a body's centre of mass. Wakes the body unless it is zero; static bodies stay.
 * @param bodyId the body
 * @param linearVelocity the velocity [m/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_SetLinearVelocity(mvBodyId bodyId, mvVec3 linearVelocity);

/**
 * Get the angular velocity of a body.
 * @param bodyId the body
 * @return the angular velocity in world axes [rad/s]; zero for a bad body
 */
MV_API mvVec3 mvBody_GetAngularVelocity(mvBodyId bodyId);

/**
 * Set the angular velocity of a body. Wakes the body unless it is zero; static bodies stay.
 * @param bodyId the body
 * @param angularVelocity the angular velocity in world axes [rad/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_SetAngularVelocity(mvBodyId bodyId, mvVec3 angularVelocity);

/**
 * Get the momentum of a body.
 * @param bodyId the body
 * @return the momentum [kg m/s]; zero for a body without mass or a bad one
 */
MV_API mvVec3 mvBody_GetMomentum(mvBodyId bodyId);

/**
 * Set the momentum of a body. Bodies without mass are left alone.
 * @param bodyId the body
 * @param momentum the momentum [kg m/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_SetMomentum(mvBodyId bodyId, mvVec3 momentum);

/**
 * Get the angular momentum of a body about its centre of mass.
 * @param bodyId the body
 * @return the angular momentum in world axes [kg m^2/s]; zero for a body without inertia or a bad one
 */
MV_API mvVec3 mvBody_GetAngularMomentum(mvBodyId bodyId);

/**
 * Set the angular momentum of a body about its centre of mass. Bodies without inertia are left alone.
 * @param bodyId the body
 * @param angularMomentum the angular momentum in world axes [kg m^2/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_SetAngularMomentum(mvBodyId bodyId, mvVec3 angularMomentum);

/**
 * Get the energy of a body's translation and rotation.
 * @param bodyId the body
 * @return the energy [J]; 0 for a body without mass or a bad one
 */
MV_API mvFloat mvBody_GetKineticEnergy(mvBodyId bodyId);

/**
 * Add a force for the next step. Only awake dynamic bodies feel it.
 * @param bodyId the body
 * @param force the force in world axes [N]
 * @param point where it acts, in the world [m]
 * @param wake whether to wake the body first
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvBody_ApplyForce(mvBodyId bodyId, mvVec3 force, mvPos point, bool wake);

/**
 * Add a force at the centre of mass for the next step. Only awake dynamic bodies feel it.
 * @param bodyId the body
 * @param force the force in world axes [N]
 * @param wake whether to wake the body first
 * @note Errors: mv_errorNotFinite.
 */
MV_API void mvBody_ApplyForceToCenter(mvBodyId bodyId, mvVec3 force, bool wake);

/**
 * Add a torque for the next step. Only awake dynamic bodies feel it.
 * @param bodyId the body
 * @param torque the torque in world axes [N m]
 * @param wake whether to wake the body first
 * @note Errors: mv_errorNotFinite.
 */
MV_API void mvBody_ApplyTorque(mvBodyId bodyId, mvVec3 torque, bool wake);

/**
 * Change the momentum of a body at once. Only awake dynamic bodies feel it.
 * @param bodyId the body
 * @param impulse the change in world axes [N s]
 * @param point where it acts, in the world [m]
 * @param wake whether to wake the body first
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
void mvBody_ApplyLinearImpulse(mvBodyId bodyId,
                               mvVec3 impulse,
                               mvPos point,
                               bool wake);

/**
 * Change the momentum of a body at once, at its centre of mass. Only awake dynamic bodies feel it.
 * @param bodyId the body
 * @param impulse the change in world axes [N s]
 * @param wake whether to wake the body first
 * @note Errors: mv_errorNotFinite.
 */
MV_API void mvBody_ApplyLinearImpulseToCenter(mvBodyId bodyId, mvVec3 impulse, bool wake);

/**
 * Change the angular momentum of a body at once. Only awake dynamic bodies feel it.
 * @param bodyId the body
 * @param impulse the change in world axes [N m s]
 * @param wake whether to wake the body first
 * @note Errors: mv_errorNotFinite.
 */
MV_API void mvBody_ApplyAngularImpulse(mvBodyId bodyId, mvVec3 impulse, bool wake);

/**
 * Get the point of a body's shapes closest to a target.
 * @param bodyId the body
 * @param result where to write the point, in the world; the target itself where that is inside, the body's origin when
 * it has no shapes; may be null
 * @param target the target, in the world [m]
 * @return the distance [m]; 0 for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvFloat mvBody_GetClosestPoint(mvBodyId bodyId,
                               mvVec3 *result,
                               mvVec3 target);

/**
 * Cast a ray at a body as if it were somewhere. A ray that starts inside a shape does not hit that shape.
 * @param bodyId the body
 * @param origin where the ray starts [m]
 * @param translation from the start to the end of the ray [m]
 * @param filter which shapes the ray sees
 * @param maxFraction the greatest fraction of the translation to consider, 0 to 1
 * @param bodyTransform where to think the body is
 * @return the first hit; no hit for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvBodyCastResult mvBody_CastRay(mvBodyId bodyId,
                                mvPos origin,
                                mvVec3 translation,
                                mvQueryFilter filter,
                                mvFloat maxFraction,
                                mvWorldTransform bodyTransform);

/**
 * Move a solid against a body as if that were somewhere. A shape that it overlaps from the start is hit at fraction 0
 * with a zero normal.
 * @param bodyId the body
 * @param origin what the points of the proxy are counted from [m]
 * @param proxy the solid
 * @param translation from the start to the end of the motion [m]
 * @param filter which shapes the solid sees
 * @param maxFraction the greatest fraction of the translation to consider, 0 to 1
 * @param canEncroach whether touching solids may come a little closer; only false is built yet
 * @param bodyTransform where to think the body is
 * @return the first hit; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported.
 */
MV_API
mvBodyCastResult mvBody_CastShape(mvBodyId bodyId,
                                  mvPos origin,
                                  const mvShapeProxy *proxy,
                                  mvVec3 translation,
                                  mvQueryFilter filter,
                                  mvFloat maxFraction,
                                  bool canEncroach,
                                  mvWorldTransform bodyTransform);

/**
 * Does a solid touch or overlap a body as if that were somewhere?
 * @param bodyId the body
 * @param origin what the points of the proxy are counted from [m]
 * @param proxy the solid
 * @param filter which shapes the solid sees
 * @param bodyTransform where to think the body is
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
bool mvBody_OverlapShape(mvBodyId bodyId,
                         mvPos origin,
                         const mvShapeProxy *proxy,
                         mvQueryFilter filter,
                         mvWorldTransform bodyTransform);

/**
 * Get placement and velocities of all bodies that the next step moves. An array that is null is skipped.
 *
 * @param worldId the world
 * @param ids filled with the bodies, in no particular order
 * @param transforms filled with where their origins are
 * @param linear filled with the velocities of their centres of mass [m/s]
 * @param angular filled with their angular velocities in world axes [rad/s]
 * @param capacity the room in each array, >= 0
 * @return how many such bodies there are, which may be more than the capacity; 0 for bad arguments
 * @note Errors: mv_errorRange.
 */
MV_API
int mvWorld_GetAwakeBodies(mvWorldId worldId,
                           mvBodyId *ids,
                           mvWorldTransform *transforms,
                           mvVec3 *linear,
                           mvVec3 *angular,
                           int capacity);

/**
 * Move many bodies of one world at once, as mvBody_SetTransform() does with one. If anything is wrong with one of
 * them, none is moved.
 *
 * @param ids the bodies, all of one world
 * @param transforms where their origins go
 * @param count how many, >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
void mvBody_SetTransforms(const mvBodyId *ids,
                          const mvWorldTransform *transforms,
                          int count);

/**
 * Find the contact point of two spheres, if they touch or nearly do.
 *
 * @param manifold filled; its points are where the caller wants the points written
 * @param capacity the room for points, >= 0
 * @param sphereA the first sphere
 * @param sphereB the second sphere
 * @param transformBtoA where the second is, seen from the first
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold is then empty.
 */
MV_API
void mvCollideSpheres(mvLocalManifold *manifold,
                      int capacity,
                      const mvSphere *sphereA,
                      const mvSphere *sphereB,
                      mvTransform transformBtoA);

/**
 * Find the contact point of a capsule and a sphere, if they touch or nearly do.
 *
 * @param manifold filled; its points are where the caller wants the points written
 * @param capacity the room for points, >= 0
 * @param capsuleA the capsule
 * @param sphereB the sphere
 * @param transformBtoA where the sphere is, seen from the capsule
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold is then empty.
 */
MV_API
void mvCollideCapsuleAndSphere(mvLocalManifold *manifold,
                               int capacity,
                               const mvCapsule *capsuleA,
                               const mvSphere *sphereB,
                               mvTransform transformBtoA);

/**
 * Find the contact points of two capsules, if they touch or nearly do.
 *
 * @param manifold filled; its points are where the caller wants the points written
 * @param capacity the room for points, >= 0
 * @param capsuleA the first capsule
 * @param capsuleB the second capsule
 * @param transformBtoA where the second is, seen from the first
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold is then empty.
 */
MV_API
void mvCollideCapsules(mvLocalManifold *manifold,
                       int capacity,
                       const mvCapsule *capsuleA,
                       const mvCapsule *capsuleB,
                       mvTransform transformBtoA);

/**
 * Find the contact point of a hull and a sphere, if they touch or nearly do.
 *
 * @param manifold filled; its points are where the caller wants the points written
 * @param capacity the room for points, >= 0
 * @param hullA the hull
 * @param sphereB the sphere
 * @param transformBtoA where the sphere is, seen from the hull
 * @param cache may be null; set to empty, since this pair needs none
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold
 * is then empty.
 */
MV_API
void mvCollideHullAndSphere(mvLocalManifold *manifold,
                            int capacity,
                            const mvHullData *hullA,
                            const mvSphere *sphereB,
                            mvTransform transformBtoA,
                            mvSimplexCache *cache);

/**
 * Find the contact points of a hull and a capsule, if they touch or nearly do.
 *
 * @param manifold filled; its points are where the caller wants the points written
 * @param capacity the room for points, >= 0
 * @param hullA the hull
 * @param capsuleB the capsule
 * @param transformBtoA where the capsule is, seen from the hull
 * @param cache may be null; set to empty, since this pair needs none
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold
 * is then empty.
 */
MV_API
void mvCollideHullAndCapsule(mvLocalManifold *manifold,
                             int capacity,
                             const mvHullData *hullA,
                             const mvCapsule *capsuleB,
                             mvTransform transformBtoA,
                             mvSimplexCache *cache);

/**
 * Find the contact points of two hulls, if they touch or nearly do.
 *
 * @param manifold filled; its points are where the caller wants the points written
 * @param capacity the room for points, >= 0
 * @param hullA the first hull
 * @param hullB the second hull
 * @param transformBtoA where the second is, seen from the first
 * @param cache written: how the pair stands; may be null
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate. The manifold
 * is then empty.
 */
MV_API
void mvCollideHulls(mvLocalManifold *manifold,
                    int capacity,
                    const mvHullData *hullA,
                    const mvHullData *hullB,
                    mvTransform transformBtoA,
                    mvSATCache *cache);

/**
 * Does this contact exist? A contact exists while the boxes of its shapes meet.
 */
MV_API bool mvContact_IsValid(mvContactId id);

/**
 * Get a drawing with the default values: shapes and joints, without functions.
 */
MV_API mvDebugDraw mvDefaultDebugDraw(void);

/**
 * Draw a world as it is now. Disabled bodies are not drawn.
 *
 * @param worldId the world
 * @param draw what to draw, and the functions that do it
 * @param maskBits shapes with none of these category bits are not drawn; MV_DEFAULT_MASK_BITS for all
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvWorld_Draw(mvWorldId worldId, const mvDebugDraw *draw, uint64_t maskBits);

/**
 * Draw a world as it is now, into arrays. The functions of the drawing are not called.
 *
 * @param worldId the world
 * @param draw what to draw
 * @param maskBits shapes with none of these category bits are not drawn; MV_DEFAULT_MASK_BITS for all
 * @return the arrays, empty for bad arguments. They stay valid until the next call of this function for this world, on
 * any thread, or until the world is destroyed.
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvDrawBuffers mvWorld_DrawBuffers(mvWorldId worldId,
                                  const mvDebugDraw *draw,
                                  uint64_t maskBits);

/**
 * Get a world definition with the default values.
 */
MV_API mvWorldDef mvDefaultWorldDef(void);

/**
 * Get a body definition with the default values: a static body at the origin.
 */
MV_API mvBodyDef mvDefaultBodyDef(void);

/**
 * Get a shape definition with the default values.
 */
MV_API mvShapeDef mvDefaultShapeDef(void);

/**
 * Get the filter that collides with everything.
 */
MV_API mvFilter mvDefaultFilter(void);

/**
 * Get the query filter that sees everything.
 */
MV_API mvQueryFilter mvDefaultQueryFilter(void);

/**
 * Get the default surface.
 */
MV_API mvSurfaceMaterial mvDefaultSurfaceMaterial(void);

/**
 * Get the distance of two convex solids.
 *
 * @param input the solids
 * @param cache written: which points carry the closest points; may be null. Today's search does not read it.
 * @param simplexes filled with the simplexes of the search in order, the one it ended with always the last; may be null
 * @param simplexCapacity the room in the array, >= 0; 65 is enough for every search
 * @return the closest points, in the frame of A; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvDistanceOutput mvShapeDistance(const mvDistanceInput *input,
                                 mvSimplexCache *cache,
                                 mvSimplex *simplexes,
                                 int simplexCapacity);

/**
 * Move a convex solid until it touches another. Solids that overlap from the start do not hit.
 *
 * @param input the solids
 * @return the first hit, in the frame of A; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API mvCastOutput mvShapeCast(const mvShapeCastPairInput *input);

/**
 * Does a sphere touch or overlap a solid?
 *
 * @param shape the sphere
 * @param shapeTransform where the sphere is
 * @param proxy the solid
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
bool mvOverlapSphere(const mvSphere *shape,
                     mvTransform shapeTransform,
                     const mvShapeProxy *proxy);

/**
 * Does a capsule touch or overlap a solid?
 *
 * @param shape the capsule
 * @param shapeTransform where the capsule is
 * @param proxy the solid
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
bool mvOverlapCapsule(const mvCapsule *shape,
                      mvTransform shapeTransform,
                      const mvShapeProxy *proxy);

/**
 * Does a hull touch or overlap a solid?
 *
 * @param shape the hull
 * @param shapeTransform where the hull is
 * @param proxy the solid
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
 */
MV_API
bool mvOverlapHull(const mvHullData *shape,
                   mvTransform shapeTransform,
                   const mvShapeProxy *proxy);

/**
 * Move a solid against a sphere. A solid that overlaps from the start does not hit.
 *
 * @param shape the sphere
 * @param input the solid and its motion, in the sphere's frame
 * @return the first hit; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvCastOutput mvShapeCastSphere(const mvSphere *shape,
                               const mvShapeCastInput *input);

/**
 * Move a solid against a capsule. A solid that overlaps from the start does not hit.
 *
 * @param shape the capsule
 * @param input the solid and its motion, in the capsule's frame
 * @return the first hit; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvCastOutput mvShapeCastCapsule(const mvCapsule *shape,
                                const mvShapeCastInput *input);

/**
 * Move a solid against a hull. A solid that overlaps from the start does not hit.
 *
 * @param shape the hull
 * @param input the solid and its motion, in the hull's frame
 * @return the first hit; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvCastOutput mvShapeCastHull(const mvHullData *shape,
                             const mvShapeCastInput *input);

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
 * Get the bodies that the last step moved or put to sleep.
 *
 * @return the events; none for a bad world. Their array stays valid until the next step, whatever else happens
 * to the bodies, or until the world is destroyed.
 */
MV_API
mvBodyEvents mvWorld_GetBodyEvents(mvWorldId worldId);

/**
 * Get the contacts that began and ended in the last step, and the hits.
 *
 * @return the events; none for a bad world. Their arrays stay valid until the next step, whatever else happens
 * to the shapes, or until the world is destroyed.
 */
MV_API
mvContactEvents mvWorld_GetContactEvents(mvWorldId worldId);

/**
 * Get the joints that carried more than one of their thresholds in the last step.
 *
 * @return the events; none for a bad world. Their array stays valid until the next step, whatever else happens
 * to the joints, or until the world is destroyed.
 */
MV_API
mvJointEvents mvWorld_GetJointEvents(mvWorldId worldId);

/**
 * Get mass, centre of mass and inertia of a solid sphere.
 *
 * @param shape the sphere
 * @param density the density [kg/m^3], not negative
 * @return the exact figures; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvMassData mvComputeSphereMass(const mvSphere *shape, mvFloat density);

/**
 * Get mass, centre of mass and inertia of a solid capsule.
 *
 * @param shape the capsule
 * @param density the density [kg/m^3], not negative
 * @return the exact figures; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvMassData mvComputeCapsuleMass(const mvCapsule *shape, mvFloat density);

/**
 * Get mass, centre of mass and inertia of a solid hull.
 *
 * @param shape the hull
 * @param density the density [kg/m^3], not negative
 * @return the exact figures; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
 */
MV_API mvMassData mvComputeHullMass(const mvHullData *shape, mvFloat density);

/**
 * Get the box around a placed sphere.
 *
 * @param shape the sphere
 * @param transform where it is
 * @return the box; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvAABB mvComputeSphereAABB(const mvSphere *shape, mvTransform transform);

/**
 * Get the box around a placed capsule.
 *
 * @param shape the capsule
 * @param transform where it is
 * @return the box; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvAABB mvComputeCapsuleAABB(const mvCapsule *shape, mvTransform transform);

/**
 * Get the box around a placed hull.
 *
 * @param shape the hull
 * @param transform where it is
 * @return the box; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
 */
MV_API mvAABB mvComputeHullAABB(const mvHullData *shape, mvTransform transform);

/**
 * Can this ray be cast: are all its numbers finite and in range?
 */
MV_API bool mvIsValidRay(const mvRayCastInput *input);

/**
 * Cast a ray at a sphere. A ray that starts inside does not hit.
 *
 * @param shape the sphere
 * @param input the ray, in the same frame
 * @return the first hit; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvCastOutput mvRayCastSphere(const mvSphere *shape, const mvRayCastInput *input);

/**
 * Cast a ray at a capsule. A ray that starts inside does not hit.
 *
 * @param shape the capsule
 * @param input the ray, in the same frame
 * @return the first hit; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvCastOutput mvRayCastCapsule(const mvCapsule *shape,
                              const mvRayCastInput *input);

/**
 * Cast a ray at a hull. A ray that starts inside does not hit.
 *
 * @param shape the hull
 * @param input the ray, in the same frame
 * @return the first hit; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange.
 */
MV_API mvCastOutput mvRayCastHull(const mvHullData *shape, const mvRayCastInput *input);

/**
 * Create the convex hull of a cloud of points.
 *
 * Points inside, doubled points and points within rounding of a face vanish.
 * @param points the points [m]
 * @param pointCount their number, at least 4
 * @param maxVertexCount the most vertices the hull may have, at least 4; more than MV_MAX_HULL_VERTICES counts
 * as that. Where the true hull has more, the farthest points are kept.
 * @return the hull, to be destroyed by mvDestroyHull(); null for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate for fewer than 4 points or
 * points that lie on one plane.
 */
MV_API
mvHullData *mvCreateHull(const mvVec3 *points,
                         int pointCount,
                         int maxVertexCount);

/**
 * Create a hull in the form of a cylinder along the y axis.
 *
 * @param height the distance of the end faces [m], > 0
 * @param radius the distance of the side edges from the axis [m], > 0
 * @param yOffset where the lower end face is [m]
 * @param sides the number of side faces, 3 to 127
 * @return the hull, to be destroyed by mvDestroyHull(); null for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvHullData *mvCreateCylinder(mvFloat height, mvFloat radius, mvFloat yOffset, int sides);

/**
 * Create a hull in the form of a cone or truncated cone along the y axis, its first end face at y = 0.
 *
 * @param height the distance of the ends [m], > 0
 * @param radius1 the radius at y = 0 [m], > 0
 * @param radius2 the radius at y = height [m]; 0 for a tip
 * @param slices the number of side faces, 3 to 127
 * @return the hull, to be destroyed by mvDestroyHull(); null for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvHullData *mvCreateCone(mvFloat height, mvFloat radius1, mvFloat radius2, int slices);

/**
 * Copy a hull.
 *
 * @param hull a hull, or the base of a box hull
 * @return the copy, to be destroyed by mvDestroyHull(); null for a bad hull
 * @note Errors: mv_errorNull, mv_errorDefinition for a hull that was changed or is of another version.
 */
MV_API mvHullData *mvCloneHull(const mvHullData *hull);

/**
 * Copy a hull, scale the copy along the axes of its frame, and place it.
 *
 * @param original a hull, or the base of a box hull
 * @param transform where to place the scaled hull
 * @param scale the scale along x, y and z, which may be negative but not zero
 * @return the new hull, to be destroyed by mvDestroyHull(); null for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvHullData *mvCloneAndTransformHull(const mvHullData *original,
                                    mvTransform transform,
                                    mvVec3 scale);

/**
 * Destroy a hull that mvCreateHull(), mvCloneHull() or a function like them made. Shapes made from it stay.
 *
 * @param hull the hull
 * @note Errors: mv_errorNull, mv_errorStale for a pointer that is no such hull, or not any more.
 */
MV_API void mvDestroyHull(mvHullData *hull);

/**
 * Make a cube as a hull.
 *
 * @param halfWidth half the side length [m], > 0
 * @return the box; one that no function accepts for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvBoxHull mvMakeCubeHull(mvFloat halfWidth);

/**
 * Make a box as a hull, centred on the origin.
 *
 * @param hx half the side length along x [m], > 0
 * @param hy half the side length along y [m], > 0
 * @param hz half the side length along z [m], > 0
 * @return the box; one that no function accepts for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvBoxHull mvMakeBoxHull(mvFloat hx, mvFloat hy, mvFloat hz);

/**
 * Make a box as a hull, centred on a point.
 *
 * @param hx half the side length along x [m], > 0
 * @param hy half the side length along y [m], > 0
 * @param hz half the side length along z [m], > 0
 * @param offset the centre [m]
 * @return the box; one that no function accepts for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API mvBoxHull mvMakeOffsetBoxHull(mvFloat hx, mvFloat hy, mvFloat hz, mvVec3 offset);

/**
 * Make a placed box as a hull.
 *
 * @param hx half the side length along x [m], > 0
 * @param hy half the side length along y [m], > 0
 * @param hz half the side length along z [m], > 0
 * @param transform where the box is
 * @return the box; one that no function accepts for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvBoxHull mvMakeTransformedBoxHull(mvFloat hx,
                                   mvFloat hy,
                                   mvFloat hz,
                                   mvTransform transform);

/**
 * Get the definition of a human with the default values.
 */
MV_API mvHumanDef mvDefaultHumanDef(void);

/**
 * Create a human in its rest pose: standing, arms down. Nothing strains it.
 *
 * @param worldId the world
 * @param def the definition, from mvDefaultHumanDef()
 * @return the human; no bones for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvHuman mvCreateHuman(mvWorldId worldId,
                      const mvHumanDef *def);

/**
 * Destroy what is left of a human. Bones that were destroyed before are passed over.
 * @param human the human, from mvCreateHuman()
 * @note Errors: mv_errorRange for a number of bones that no human has.
 */
MV_API void mvDestroyHuman(const mvHuman *human);

/**
 * Set the torque of dry friction in each joint of a human.
 * @param human the human, from mvCreateHuman()
 * @param torque the torque [N m], >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorStale where a joint was destroyed.
 */
MV_API void mvHuman_SetFrictionTorque(const mvHuman *human, mvFloat torque);

/**
 * Set the springs that hold the rest pose of a human.
 * @param human the human, from mvCreateHuman()
 * @param hertz the frequency [Hz], >= 0; 0 for none
 * @param dampingRatio the damping ratio, >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorStale where a joint was destroyed.
 */
MV_API void mvHuman_SetSpring(const mvHuman *human, mvFloat hertz, mvFloat dampingRatio);

/**
 * Give all bones of a human one velocity, without rotation.
 * @param human the human, from mvCreateHuman()
 * @param velocity the velocity [m/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorStale where a bone was destroyed.
 */
MV_API void mvHuman_SetVelocity(const mvHuman *human, mvVec3 velocity);

/**
 * Push a human: the impulse is shared out by mass, so that all bones gain the same velocity. To push one bone, use
 * mvBody_ApplyLinearImpulse().
 * @param human the human, from mvCreateHuman()
 * @param impulse the impulse [N s]
 * @note Errors: mv_errorNotFinite, mv_errorRange, mv_errorStale where a bone was destroyed.
 */
MV_API
void mvHuman_ApplyLinearImpulse(const mvHuman *human,
                                mvVec3 impulse);

/**
 * Destroy a joint, with the gears that run on it.
 * @param jointId the joint
 * @param wakeAttached whether its bodies wake
 * @note Errors: mv_errorRange.
 */
MV_API void mvDestroyJoint(mvJointId jointId, bool wakeAttached);

/**
 * Does this id name a joint that lives? Never fails; false also while another thread changes the world.
 */
MV_API bool mvJoint_IsValid(mvJointId id);

/**
 * Get what a joint is.
 * @param jointId the joint
 * @return one of the mv_...Joint constants; mv_parallelJoint, which is 0, for a bad joint
 */
MV_API mvJointType mvJoint_GetType(mvJointId jointId);

/**
 * Get the first body of a joint.
 * @param jointId the joint
 * @return body A; of a gear that of its first joint; null for a bad joint
 */
MV_API mvBodyId mvJoint_GetBodyA(mvJointId jointId);

/**
 * Get the second body of a joint.
 * @param jointId the joint
 * @return body B; of a gear that of its first joint; null for a bad joint
 */
MV_API mvBodyId mvJoint_GetBodyB(mvJointId jointId);

/**
 * Get the world that a joint lives in.
 * @param jointId the joint
 * @return the world; null for a bad joint
 */
MV_API mvWorldId mvJoint_GetWorld(mvJointId jointId);

/**
 * Move frame A of a joint in body A. Where the frames do not fit each other, the joint pulls them together.
 * @param jointId the joint
 * @param localFrame where the frame is, from the body's origin
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvJoint_SetLocalFrameA(mvJointId jointId, mvTransform localFrame);

/**
 * Get frame A of a joint.
 * @param jointId the joint
 * @return where the frame is, from the origin of body A; the identity for a bad joint
 */
MV_API mvTransform mvJoint_GetLocalFrameA(mvJointId jointId);

/**
 * Move frame B of a joint in body B. Where the frames do not fit each other, the joint pulls them together.
 * @param jointId the joint
 * @param localFrame where the frame is, from the body's origin
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvJoint_SetLocalFrameB(mvJointId jointId, mvTransform localFrame);

/**
 * Get frame B of a joint.
 * @param jointId the joint
 * @return where the frame is, from the origin of body B; the identity for a bad joint
 */
MV_API mvTransform mvJoint_GetLocalFrameB(mvJointId jointId);

/**
 * Let the bodies of a joint collide with each other, or not.
 * @param jointId the joint
 * @param shouldCollide whether they collide
 * @note Errors: mv_errorRange.
 */
MV_API void mvJoint_SetCollideConnected(mvJointId jointId, bool shouldCollide);

/**
 * Do the bodies of a joint collide with each other?
 * @param jointId the joint
 */
MV_API bool mvJoint_GetCollideConnected(mvJointId jointId);

/**
 * Set the user data of a joint.
 * @param jointId the joint
 * @param userData anything; it is never followed
 */
MV_API void mvJoint_SetUserData(mvJointId jointId, void *userData);

/**
 * Get the user data of a joint.
 * @param jointId the joint
 * @return what was set; null for a bad joint
 */
MV_API void *mvJoint_GetUserData(mvJointId jointId);

/**
 * Wake the bodies of a joint.
 * @param jointId the joint
 */
MV_API void mvJoint_WakeBodies(mvJointId jointId);

/**
 * Get the force of a joint on body B; body A has the opposite.
 * @param jointId the joint
 * @return the mean over the last step, in world axes [N]; zero for a bad joint
 */
MV_API mvVec3 mvJoint_GetConstraintForce(mvJointId jointId);

/**
 * Get the torque of a joint on body B, about the origin of frame B.
 * @param jointId the joint
 * @return the mean over the last step, in world axes [N m]; zero for a bad joint
 */
MV_API mvVec3 mvJoint_GetConstraintTorque(mvJointId jointId);

/**
 * Get by how much a joint fails to hold lengths. Springs do not count, limits only where they are exceeded.
 * @param jointId the joint
 * @return the error [m], >= 0; 0 for a bad joint
 */
MV_API mvFloat mvJoint_GetLinearSeparation(mvJointId jointId);

/**
 * Get by how much a joint fails to hold angles. Springs do not count, limits only where they are exceeded.
 * @param jointId the joint
 * @return the error [rad], >= 0; 0 for a bad joint
 */
MV_API mvFloat mvJoint_GetAngularSeparation(mvJointId jointId);

/**
 * Set how stiffly a joint holds what it holds.
 * @param jointId the joint
 * @param hertz the stiffness [Hz], >= 0; 0 is rigid
 * @param dampingRatio the damping ratio, >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvJoint_SetConstraintTuning(mvJointId jointId, mvFloat hertz, mvFloat dampingRatio);

/**
 * Get how stiffly a joint holds what it holds.
 * @param jointId the joint
 * @param hertz where to write the stiffness [Hz], 0 for rigid; may be null
 * @param dampingRatio where to write the damping ratio; may be null
 */
MV_API void mvJoint_GetConstraintTuning(mvJointId jointId, mvFloat *hertz, mvFloat *dampingRatio);

/**
 * Set the force above which a joint makes an event.
 * @param jointId the joint
 * @param threshold the force [N], >= 0; infinity for none
 * @note Errors: mv_errorRange, also for NaN.
 */
MV_API void mvJoint_SetForceThreshold(mvJointId jointId, mvFloat threshold);

/**
 * Get the force above which a joint makes an event.
 * @param jointId the joint
 * @return the force [N], infinity for none; 0 for a bad joint
 */
MV_API mvFloat mvJoint_GetForceThreshold(mvJointId jointId);

/**
 * Set the torque above which a joint makes an event.
 * @param jointId the joint
 * @param threshold the torque [N m], >= 0; infinity for none
 * @note Errors: mv_errorRange, also for NaN.
 */
MV_API void mvJoint_SetTorqueThreshold(mvJointId jointId, mvFloat threshold);

/**
 * Get the torque above which a joint makes an event.
 * @param jointId the joint
 * @return the torque [N m], infinity for none; 0 for a bad joint
 */
MV_API mvFloat mvJoint_GetTorqueThreshold(mvJointId jointId);

/**
 * Let a joint break at the end of a step in which it made an event, or not.
 * @param jointId the joint
 * @param flag whether it breaks
 * @note Errors: mv_errorRange.
 */
MV_API void mvJoint_SetBreakable(mvJointId jointId, bool flag);

/**
 * Does a joint break where it makes an event?
 * @param jointId the joint
 */
MV_API bool mvJoint_IsBreakable(mvJointId jointId);

/**
 * Get the size of a joint in drawings.
 * @param jointId the joint
 * @return the size [m]; 0 for a bad joint
 */
MV_API mvFloat mvJoint_GetDrawScale(mvJointId jointId);

/**
 * Get the definition of a distance joint with the default values.
 */
MV_API mvDistanceJointDef mvDefaultDistanceJointDef(void);

/**
 * Create a distance joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultDistanceJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateDistanceJoint(mvWorldId worldId,
                                const mvDistanceJointDef *def);

/**
 * Set the length of the rod, or at which the spring rests.
 * @param jointId a distance joint
 * @param length the value [m], >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvDistanceJoint_SetLength(mvJointId jointId, mvFloat length);

/**
 * Get the length of the rod, or at which the spring rests.
 * @param jointId a distance joint
 * @return the value [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetLength(mvJointId jointId);

/**
 * Turn the spring on or off.
 * @param jointId a distance joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvDistanceJoint_EnableSpring(mvJointId jointId, bool flag);

/**
 * Is the spring on?
 * @param jointId a distance joint; false for another joint or a bad one
 */
MV_API bool mvDistanceJoint_IsSpringEnabled(mvJointId jointId);

/**
 * Set the bounds of the force of the spring, which is positive where it pushes.
 * @param jointId a distance joint
 * @param lowerForce the least force [N], negative where it may pull; may be infinite
 * @param upperForce the greatest force [N]; may be infinite
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API
void mvDistanceJoint_SetSpringForceRange(mvJointId jointId,
                                         mvFloat lowerForce,
                                         mvFloat upperForce);

/**
 * Get the bounds of the force of the spring.
 * @param jointId a distance joint
 * @param lowerForce where to write the least force [N]; may be null
 * @param upperForce where to write the greatest force [N]; may be null
 * @note Errors: mv_errorRange for another joint; nothing is written then.
 */
MV_API
void mvDistanceJoint_GetSpringForceRange(mvJointId jointId,
                                         mvFloat *lowerForce,
                                         mvFloat *upperForce);

/**
 * Set the frequency of the spring.
 * @param jointId a distance joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvDistanceJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring.
 * @param jointId a distance joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetSpringHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring.
 * @param jointId a distance joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvDistanceJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring.
 * @param jointId a distance joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetSpringDampingRatio(mvJointId jointId);

/**
 * Turn the limit on or off.
 * @param jointId a distance joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvDistanceJoint_EnableLimit(mvJointId jointId, bool flag);

/**
 * Is the limit on?
 * @param jointId a distance joint; false for another joint or a bad one
 */
MV_API bool mvDistanceJoint_IsLimitEnabled(mvJointId jointId);

/**
 * Set the limits of the length.
 * @param jointId a distance joint
 * @param minLength the least [m], >= 0
 * @param maxLength the greatest [m], >= 0, not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvDistanceJoint_SetLengthRange(mvJointId jointId, mvFloat minLength, mvFloat maxLength);

/**
 * Get the limits of the length: the least.
 * @param jointId a distance joint
 * @return the least [m], >= 0; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetMinLength(mvJointId jointId);

/**
 * Get the limits of the length: the greatest.
 * @param jointId a distance joint
 * @return the greatest [m], >= 0; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetMaxLength(mvJointId jointId);

/**
 * Get the distance of the origins of the frames.
 * @param jointId a distance joint
 * @return the length [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetCurrentLength(mvJointId jointId);

/**
 * Turn the motor on or off.
 * @param jointId a distance joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvDistanceJoint_EnableMotor(mvJointId jointId, bool flag);

/**
 * Is the motor on?
 * @param jointId a distance joint; false for another joint or a bad one
 */
MV_API bool mvDistanceJoint_IsMotorEnabled(mvJointId jointId);

/**
 * Set the speed at which the motor wants the length to grow.
 * @param jointId a distance joint
 * @param motorSpeed the value [m/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvDistanceJoint_SetMotorSpeed(mvJointId jointId, mvFloat motorSpeed);

/**
 * Get the speed at which the motor wants the length to grow.
 * @param jointId a distance joint
 * @return the value [m/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetMotorSpeed(mvJointId jointId);

/**
 * Set the greatest force of the motor.
 * @param jointId a distance joint
 * @param force the value [N], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvDistanceJoint_SetMaxMotorForce(mvJointId jointId, mvFloat force);

/**
 * Get the greatest force of the motor.
 * @param jointId a distance joint
 * @return the value [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetMaxMotorForce(mvJointId jointId);

/**
 * Get the force of the motor.
 * @param jointId a distance joint
 * @return the mean over the last sub-step [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvDistanceJoint_GetMotorForce(mvJointId jointId);

/**
 * Get the definition of a filter joint with the default values.
 */
MV_API mvFilterJointDef mvDefaultFilterJointDef(void);

/**
 * Create a filter joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultFilterJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateFilterJoint(mvWorldId worldId,
                              const mvFilterJointDef *def);

/**
 * Get the definition of a gear joint with the default values.
 */
MV_API mvGearJointDef mvDefaultGearJointDef(void);

/**
 * Create a gear joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultGearJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateGearJoint(mvWorldId worldId,
                            const mvGearJointDef *def);

/**
 * Set the ratio: how far the first coordinate goes back when the second goes on by 1.
 * @param jointId a gear joint
 * @param ratio the value , not 0
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvGearJoint_SetRatio(mvJointId jointId, mvFloat ratio);

/**
 * Get the ratio: how far the first coordinate goes back when the second goes on by 1.
 * @param jointId a gear joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvGearJoint_GetRatio(mvJointId jointId);

/**
 * Get the definition of a motor joint with the default values.
 */
MV_API mvMotorJointDef mvDefaultMotorJointDef(void);

/**
 * Create a motor joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultMotorJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateMotorJoint(mvWorldId worldId,
                             const mvMotorJointDef *def);

/**
 * Set the velocity that is wanted, in the axes of frame A.
 * @param jointId a motor joint
 * @param velocity the value [m/s]
 * @note Errors: mv_errorNotFinite; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetLinearVelocity(mvJointId jointId, mvVec3 velocity);

/**
 * Get the velocity that is wanted, in the axes of frame A.
 * @param jointId a motor joint
 * @return the value [m/s]; zero for another joint or a bad one
 */
MV_API mvVec3 mvMotorJoint_GetLinearVelocity(mvJointId jointId);

/**
 * Set the angular velocity that is wanted, in the axes of frame A.
 * @param jointId a motor joint
 * @param velocity the value [rad/s]
 * @note Errors: mv_errorNotFinite; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetAngularVelocity(mvJointId jointId, mvVec3 velocity);

/**
 * Get the angular velocity that is wanted, in the axes of frame A.
 * @param jointId a motor joint
 * @return the value [rad/s]; zero for another joint or a bad one
 */
MV_API mvVec3 mvMotorJoint_GetAngularVelocity(mvJointId jointId);

/**
 * Set the greatest force for the velocity, along each axis.
 * @param jointId a motor joint
 * @param maxForce the value [N], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetMaxVelocityForce(mvJointId jointId, mvFloat maxForce);

/**
 * Get the greatest force for the velocity, along each axis.
 * @param jointId a motor joint
 * @return the value [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvMotorJoint_GetMaxVelocityForce(mvJointId jointId);

/**
 * Set the greatest torque for the angular velocity, about each axis.
 * @param jointId a motor joint
 * @param maxTorque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetMaxVelocityTorque(mvJointId jointId, mvFloat maxTorque);

/**
 * Get the greatest torque for the angular velocity, about each axis.
 * @param jointId a motor joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvMotorJoint_GetMaxVelocityTorque(mvJointId jointId);

/**
 * Set the frequency of the spring between the origins.
 * @param jointId a motor joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetLinearHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring between the origins.
 * @param jointId a motor joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvMotorJoint_GetLinearHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring between the origins.
 * @param jointId a motor joint
 * @param damping the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetLinearDampingRatio(mvJointId jointId, mvFloat damping);

/**
 * Get the damping ratio of the spring between the origins.
 * @param jointId a motor joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvMotorJoint_GetLinearDampingRatio(mvJointId jointId);

/**
 * Set the frequency of the spring between the axes.
 * @param jointId a motor joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetAngularHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring between the axes.
 * @param jointId a motor joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvMotorJoint_GetAngularHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring between the axes.
 * @param jointId a motor joint
 * @param damping the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetAngularDampingRatio(mvJointId jointId, mvFloat damping);

/**
 * Get the damping ratio of the spring between the axes.
 * @param jointId a motor joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvMotorJoint_GetAngularDampingRatio(mvJointId jointId);

/**
 * Set the greatest force of the spring between the origins, along each axis.
 * @param jointId a motor joint
 * @param maxForce the value [N], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetMaxSpringForce(mvJointId jointId, mvFloat maxForce);

/**
 * Get the greatest force of the spring between the origins, along each axis.
 * @param jointId a motor joint
 * @return the value [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvMotorJoint_GetMaxSpringForce(mvJointId jointId);

/**
 * Set the greatest torque of the spring between the axes, about each axis.
 * @param jointId a motor joint
 * @param maxTorque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvMotorJoint_SetMaxSpringTorque(mvJointId jointId, mvFloat maxTorque);

/**
 * Get the greatest torque of the spring between the axes, about each axis.
 * @param jointId a motor joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvMotorJoint_GetMaxSpringTorque(mvJointId jointId);

/**
 * Get the definition of a parallel joint with the default values.
 */
MV_API mvParallelJointDef mvDefaultParallelJointDef(void);

/**
 * Create a parallel joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultParallelJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateParallelJoint(mvWorldId worldId,
                                const mvParallelJointDef *def);

/**
 * Set the frequency of the spring.
 * @param jointId a parallel joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvParallelJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring.
 * @param jointId a parallel joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvParallelJoint_GetSpringHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring.
 * @param jointId a parallel joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvParallelJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring.
 * @param jointId a parallel joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvParallelJoint_GetSpringDampingRatio(mvJointId jointId);

/**
 * Set the greatest torque of the spring about each axis.
 * @param jointId a parallel joint
 * @param maxTorque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvParallelJoint_SetMaxTorque(mvJointId jointId, mvFloat maxTorque);

/**
 * Get the greatest torque of the spring about each axis.
 * @param jointId a parallel joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvParallelJoint_GetMaxTorque(mvJointId jointId);

/**
 * Get the definition of a prismatic joint with the default values.
 */
MV_API mvPrismaticJointDef mvDefaultPrismaticJointDef(void);

/**
 * Create a prismatic joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultPrismaticJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreatePrismaticJoint(mvWorldId worldId,
                                 const mvPrismaticJointDef *def);

/**
 * Turn the spring on or off.
 * @param jointId a prismatic joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvPrismaticJoint_EnableSpring(mvJointId jointId, bool flag);

/**
 * Is the spring on?
 * @param jointId a prismatic joint; false for another joint or a bad one
 */
MV_API bool mvPrismaticJoint_IsSpringEnabled(mvJointId jointId);

/**
 * Set the frequency of the spring.
 * @param jointId a prismatic joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPrismaticJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring.
 * @param jointId a prismatic joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetSpringHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring.
 * @param jointId a prismatic joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPrismaticJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring.
 * @param jointId a prismatic joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetSpringDampingRatio(mvJointId jointId);

/**
 * Set the greatest force of the spring.
 * @param jointId a prismatic joint
 * @param maxForce the value [N], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPrismaticJoint_SetMaxSpringForce(mvJointId jointId, mvFloat maxForce);

/**
 * Get the greatest force of the spring.
 * @param jointId a prismatic joint
 * @return the value [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetMaxSpringForce(mvJointId jointId);

/**
 * Set the translation at which the spring rests.
 * @param jointId a prismatic joint
 * @param targetTranslation the value [m]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPrismaticJoint_SetTargetTranslation(mvJointId jointId, mvFloat targetTranslation);

/**
 * Get the translation at which the spring rests.
 * @param jointId a prismatic joint
 * @return the value [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetTargetTranslation(mvJointId jointId);

/**
 * Turn the limit on or off.
 * @param jointId a prismatic joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvPrismaticJoint_EnableLimit(mvJointId jointId, bool flag);

/**
 * Is the limit on?
 * @param jointId a prismatic joint; false for another joint or a bad one
 */
MV_API bool mvPrismaticJoint_IsLimitEnabled(mvJointId jointId);

/**
 * Set the limits of the translation.
 * @param jointId a prismatic joint
 * @param lower the least [m]
 * @param upper the greatest [m], not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPrismaticJoint_SetLimits(mvJointId jointId, mvFloat lower, mvFloat upper);

/**
 * Get the limits of the translation: the least.
 * @param jointId a prismatic joint
 * @return the least [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetLowerLimit(mvJointId jointId);

/**
 * Get the limits of the translation: the greatest.
 * @param jointId a prismatic joint
 * @return the greatest [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetUpperLimit(mvJointId jointId);

/**
 * Turn the motor on or off.
 * @param jointId a prismatic joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvPrismaticJoint_EnableMotor(mvJointId jointId, bool flag);

/**
 * Is the motor on?
 * @param jointId a prismatic joint; false for another joint or a bad one
 */
MV_API bool mvPrismaticJoint_IsMotorEnabled(mvJointId jointId);

/**
 * Set the speed that the motor wants.
 * @param jointId a prismatic joint
 * @param motorSpeed the value [m/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPrismaticJoint_SetMotorSpeed(mvJointId jointId, mvFloat motorSpeed);

/**
 * Get the speed that the motor wants.
 * @param jointId a prismatic joint
 * @return the value [m/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetMotorSpeed(mvJointId jointId);

/**
 * Set the greatest force of the motor.
 * @param jointId a prismatic joint
 * @param maxForce the value [N], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPrismaticJoint_SetMaxMotorForce(mvJointId jointId, mvFloat maxForce);

/**
 * Get the greatest force of the motor.
 * @param jointId a prismatic joint
 * @return the value [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetMaxMotorForce(mvJointId jointId);

/**
 * Get the force of the motor.
 * @param jointId a prismatic joint
 * @return the mean over the last sub-step [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetMotorForce(mvJointId jointId);

/**
 * Set the force of dry friction.
 * @param jointId a prismatic joint
 * @param friction the value [N], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPrismaticJoint_SetFriction(mvJointId jointId, mvFloat friction);

/**
 * Get the force of dry friction.
 * @param jointId a prismatic joint
 * @return the value [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetFriction(mvJointId jointId);

/**
 * Get how far frame B is along x of frame A.
 * @param jointId a prismatic joint
 * @return the translation [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetTranslation(mvJointId jointId);

/**
 * Get how fast the translation changes.
 * @param jointId a prismatic joint
 * @return the speed [m/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPrismaticJoint_GetSpeed(mvJointId jointId);

/**
 * Get the definition of a pulley joint with the default values.
 */
MV_API mvPulleyJointDef mvDefaultPulleyJointDef(void);

/**
 * Create a pulley joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultPulleyJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreatePulleyJoint(mvWorldId worldId,
                              const mvPulleyJointDef *def);

/**
 * Move the fixed point above body A.
 * @param jointId a pulley joint
 * @param anchor the point, in the world [m]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPulleyJoint_SetGroundAnchorA(mvJointId jointId, mvPos anchor);

/**
 * Get the fixed point above body A.
 * @param jointId a pulley joint
 * @return the point, in the world [m]; the origin for another joint or a bad one
 */
MV_API mvPos mvPulleyJoint_GetGroundAnchorA(mvJointId jointId);

/**
 * Get the length of the part at body A.
 * @param jointId a pulley joint
 * @return the length [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPulleyJoint_GetCurrentLengthA(mvJointId jointId);

/**
 * Move the fixed point above body B.
 * @param jointId a pulley joint
 * @param anchor the point, in the world [m]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPulleyJoint_SetGroundAnchorB(mvJointId jointId, mvPos anchor);

/**
 * Get the fixed point above body B.
 * @param jointId a pulley joint
 * @return the point, in the world [m]; the origin for another joint or a bad one
 */
MV_API mvPos mvPulleyJoint_GetGroundAnchorB(mvJointId jointId);

/**
 * Get the length of the part at body B.
 * @param jointId a pulley joint
 * @return the length [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPulleyJoint_GetCurrentLengthB(mvJointId jointId);

/**
 * Set the ratio: how many lengths of rope hold B for each that holds A.
 * @param jointId a pulley joint
 * @param ratio the value > 0
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPulleyJoint_SetRatio(mvJointId jointId, mvFloat ratio);

/**
 * Get the ratio: how many lengths of rope hold B for each that holds A.
 * @param jointId a pulley joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvPulleyJoint_GetRatio(mvJointId jointId);

/**
 * Set the limits of the length of the rope.
 * @param jointId a pulley joint
 * @param minLength the least length [m], >= 0; 0: it may be slack
 * @param maxLength the greatest length [m], > 0, not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvPulleyJoint_SetLengthRange(mvJointId jointId, mvFloat minLength, mvFloat maxLength);

/**
 * Get the least length of the rope.
 * @param jointId a pulley joint
 * @return the length [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPulleyJoint_GetMinLength(mvJointId jointId);

/**
 * Get the greatest length of the rope.
 * @param jointId a pulley joint
 * @return the length [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPulleyJoint_GetMaxLength(mvJointId jointId);

/**
 * Get the length of the rope: the part at A plus ratio times the part at B.
 * @param jointId a pulley joint
 * @return the length [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvPulleyJoint_GetCurrentLength(mvJointId jointId);

/**
 * Get the definition of a rack-and-pinion joint with the default values.
 */
MV_API mvRackPinionJointDef mvDefaultRackPinionJointDef(void);

/**
 * Create a rack-and-pinion joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultRackPinionJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateRackPinionJoint(mvWorldId worldId,
                                  const mvRackPinionJointDef *def);

/**
 * Set the ratio: how far the angle goes back when the rack goes on by 1 m.
 * @param jointId a rack-and-pinion joint
 * @param ratio the value [rad/m], not 0
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRackPinionJoint_SetRatio(mvJointId jointId, mvFloat ratio);

/**
 * Get the ratio: how far the angle goes back when the rack goes on by 1 m.
 * @param jointId a rack-and-pinion joint
 * @return the value [rad/m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRackPinionJoint_GetRatio(mvJointId jointId);

/**
 * Get the definition of a revolute joint with the default values.
 */
MV_API mvRevoluteJointDef mvDefaultRevoluteJointDef(void);

/**
 * Create a revolute joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultRevoluteJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateRevoluteJoint(mvWorldId worldId,
                                const mvRevoluteJointDef *def);

/**
 * Turn the spring on or off.
 * @param jointId a revolute joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvRevoluteJoint_EnableSpring(mvJointId jointId, bool flag);

/**
 * Is the spring on?
 * @param jointId a revolute joint; false for another joint or a bad one
 */
MV_API bool mvRevoluteJoint_IsSpringEnabled(mvJointId jointId);

/**
 * Set the frequency of the spring.
 * @param jointId a revolute joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRevoluteJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring.
 * @param jointId a revolute joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetSpringHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring.
 * @param jointId a revolute joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRevoluteJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring.
 * @param jointId a revolute joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetSpringDampingRatio(mvJointId jointId);

/**
 * Set the greatest torque of the spring.
 * @param jointId a revolute joint
 * @param maxTorque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRevoluteJoint_SetMaxSpringTorque(mvJointId jointId, mvFloat maxTorque);

/**
 * Get the greatest torque of the spring.
 * @param jointId a revolute joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetMaxSpringTorque(mvJointId jointId);

/**
 * Set the angle at which the spring rests.
 * @param jointId a revolute joint
 * @param angle the value [rad]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRevoluteJoint_SetTargetAngle(mvJointId jointId, mvFloat angle);

/**
 * Get the angle at which the spring rests.
 * @param jointId a revolute joint
 * @return the value [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetTargetAngle(mvJointId jointId);

/**
 * Turn the limit on or off.
 * @param jointId a revolute joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvRevoluteJoint_EnableLimit(mvJointId jointId, bool flag);

/**
 * Is the limit on?
 * @param jointId a revolute joint; false for another joint or a bad one
 */
MV_API bool mvRevoluteJoint_IsLimitEnabled(mvJointId jointId);

/**
 * Set the limits of the angle.
 * @param jointId a revolute joint
 * @param lower the least [rad]
 * @param upper the greatest [rad], not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRevoluteJoint_SetLimits(mvJointId jointId, mvFloat lower, mvFloat upper);

/**
 * Get the limits of the angle: the least.
 * @param jointId a revolute joint
 * @return the least [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetLowerLimit(mvJointId jointId);

/**
 * Get the limits of the angle: the greatest.
 * @param jointId a revolute joint
 * @return the greatest [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetUpperLimit(mvJointId jointId);

/**
 * Turn the motor on or off.
 * @param jointId a revolute joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvRevoluteJoint_EnableMotor(mvJointId jointId, bool flag);

/**
 * Is the motor on?
 * @param jointId a revolute joint; false for another joint or a bad one
 */
MV_API bool mvRevoluteJoint_IsMotorEnabled(mvJointId jointId);

/**
 * Set the speed that the motor wants.
 * @param jointId a revolute joint
 * @param motorSpeed the value [rad/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRevoluteJoint_SetMotorSpeed(mvJointId jointId, mvFloat motorSpeed);

/**
 * Get the speed that the motor wants.
 * @param jointId a revolute joint
 * @return the value [rad/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetMotorSpeed(mvJointId jointId);

/**
 * Set the greatest torque of the motor.
 * @param jointId a revolute joint
 * @param maxTorque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRevoluteJoint_SetMaxMotorTorque(mvJointId jointId, mvFloat maxTorque);

/**
 * Get the greatest torque of the motor.
 * @param jointId a revolute joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetMaxMotorTorque(mvJointId jointId);

/**
 * Get the torque of the motor.
 * @param jointId a revolute joint
 * @return the mean over the last sub-step [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetMotorTorque(mvJointId jointId);

/**
 * Set the torque of dry friction.
 * @param jointId a revolute joint
 * @param friction the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvRevoluteJoint_SetFriction(mvJointId jointId, mvFloat friction);

/**
 * Get the torque of dry friction.
 * @param jointId a revolute joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetFriction(mvJointId jointId);

/**
 * Get the angle of frame B against frame A, counting whole turns.
 * @param jointId a revolute joint
 * @return the angle [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetAngle(mvJointId jointId);

/**
 * Get how fast the angle changes.
 * @param jointId a revolute joint
 * @return the speed [rad/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvRevoluteJoint_GetSpeed(mvJointId jointId);

/**
 * Get the definition of a screw joint with the default values.
 */
MV_API mvScrewJointDef mvDefaultScrewJointDef(void);

/**
 * Create a screw joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultScrewJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateScrewJoint(mvWorldId worldId,
                             const mvScrewJointDef *def);

/**
 * Set how far B goes along x with each turn.
 * @param jointId a screw joint
 * @param pitch the value [m]
 * @note Errors: mv_errorNotFinite; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetPitch(mvJointId jointId, mvFloat pitch);

/**
 * Get how far B goes along x with each turn.
 * @param jointId a screw joint
 * @return the value [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetPitch(mvJointId jointId);

/**
 * Turn the spring on or off.
 * @param jointId a screw joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvScrewJoint_EnableSpring(mvJointId jointId, bool flag);

/**
 * Is the spring on?
 * @param jointId a screw joint; false for another joint or a bad one
 */
MV_API bool mvScrewJoint_IsSpringEnabled(mvJointId jointId);

/**
 * Set the frequency of the spring.
 * @param jointId a screw joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring.
 * @param jointId a screw joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetSpringHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring.
 * @param jointId a screw joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring.
 * @param jointId a screw joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetSpringDampingRatio(mvJointId jointId);

/**
 * Set the greatest torque of the spring.
 * @param jointId a screw joint
 * @param maxTorque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetMaxSpringTorque(mvJointId jointId, mvFloat maxTorque);

/**
 * Get the greatest torque of the spring.
 * @param jointId a screw joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetMaxSpringTorque(mvJointId jointId);

/**
 * Set the angle at which the spring rests.
 * @param jointId a screw joint
 * @param angle the value [rad]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetTargetAngle(mvJointId jointId, mvFloat angle);

/**
 * Get the angle at which the spring rests.
 * @param jointId a screw joint
 * @return the value [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetTargetAngle(mvJointId jointId);

/**
 * Turn the limit on or off.
 * @param jointId a screw joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvScrewJoint_EnableLimit(mvJointId jointId, bool flag);

/**
 * Is the limit on?
 * @param jointId a screw joint; false for another joint or a bad one
 */
MV_API bool mvScrewJoint_IsLimitEnabled(mvJointId jointId);

/**
 * Set the limits of the angle.
 * @param jointId a screw joint
 * @param lower the least [rad]
 * @param upper the greatest [rad], not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetLimits(mvJointId jointId, mvFloat lower, mvFloat upper);

/**
 * Get the limits of the angle: the least.
 * @param jointId a screw joint
 * @return the least [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetLowerLimit(mvJointId jointId);

/**
 * Get the limits of the angle: the greatest.
 * @param jointId a screw joint
 * @return the greatest [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetUpperLimit(mvJointId jointId);

/**
 * Turn the motor on or off.
 * @param jointId a screw joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvScrewJoint_EnableMotor(mvJointId jointId, bool flag);

/**
 * Is the motor on?
 * @param jointId a screw joint; false for another joint or a bad one
 */
MV_API bool mvScrewJoint_IsMotorEnabled(mvJointId jointId);

/**
 * Set the speed that the motor wants.
 * @param jointId a screw joint
 * @param motorSpeed the value [rad/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetMotorSpeed(mvJointId jointId, mvFloat motorSpeed);

/**
 * Get the speed that the motor wants.
 * @param jointId a screw joint
 * @return the value [rad/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetMotorSpeed(mvJointId jointId);

/**
 * Set the greatest torque of the motor.
 * @param jointId a screw joint
 * @param maxTorque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetMaxMotorTorque(mvJointId jointId, mvFloat maxTorque);

/**
 * Get the greatest torque of the motor.
 * @param jointId a screw joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetMaxMotorTorque(mvJointId jointId);

/**
 * Get the torque of the motor.
 * @param jointId a screw joint
 * @return the mean over the last sub-step [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetMotorTorque(mvJointId jointId);

/**
 * Set the torque of dry friction.
 * @param jointId a screw joint
 * @param friction the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvScrewJoint_SetFriction(mvJointId jointId, mvFloat friction);

/**
 * Get the torque of dry friction.
 * @param jointId a screw joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetFriction(mvJointId jointId);

/**
 * Get the angle of frame B against frame A about x, counting whole turns.
 * @param jointId a screw joint
 * @return the angle [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetAngle(mvJointId jointId);

/**
 * Get how fast the angle changes.
 * @param jointId a screw joint
 * @return the speed [rad/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetSpeed(mvJointId jointId);

/**
 * Get how far frame B is along x of frame A.
 * @param jointId a screw joint
 * @return the translation [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvScrewJoint_GetTranslation(mvJointId jointId);

/**
 * Get the definition of a six-axes joint with the default values.
 */
MV_API mvSixDofJointDef mvDefaultSixDofJointDef(void);

/**
 * Create a six-axes joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultSixDofJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateSixDofJoint(mvWorldId worldId,
                              const mvSixDofJointDef *def);

/**
 * Set everything about one axis.
 * @param jointId a six-axes joint
 * @param axis which, 0 to 5
 * @param value the axis as it shall be
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSixDofJoint_SetAxis(mvJointId jointId, int axis, mvSixDofAxis value);

/**
 * Get everything about one axis.
 * @param jointId a six-axes joint
 * @param axis which, 0 to 5
 * @return the axis; zeros for bad arguments
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API mvSixDofAxis mvSixDofJoint_GetAxis(mvJointId jointId, int axis);

/**
 * Get where frame B is along or about one axis.
 * @param jointId a six-axes joint
 * @param axis which, 0 to 5
 * @return the part of the way along that axis [m], or of the rotation vector [rad]; 0 for bad arguments
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API mvFloat mvSixDofJoint_GetCoordinate(mvJointId jointId, int axis);

/**
 * Get the definition of a spherical joint with the default values.
 */
MV_API mvSphericalJointDef mvDefaultSphericalJointDef(void);

/**
 * Create a spherical joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultSphericalJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateSphericalJoint(mvWorldId worldId,
                                 const mvSphericalJointDef *def);

/**
 * Turn the cone limit on or off.
 * @param jointId a spherical joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvSphericalJoint_EnableConeLimit(mvJointId jointId, bool flag);

/**
 * Is the cone limit on?
 * @param jointId a spherical joint; false for another joint or a bad one
 */
MV_API bool mvSphericalJoint_IsConeLimitEnabled(mvJointId jointId);

/**
 * Get the half-angle of the cone for turns about x of frame A.
 * @param jointId a spherical joint
 * @return the angle [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetConeLimit(mvJointId jointId);

/**
 * Make the cone round, with this half-angle.
 * @param jointId a spherical joint
 * @param angle the half-angle [rad], 0 to pi
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetConeLimit(mvJointId jointId, mvFloat angle);

/**
 * Make the cone elliptical.
 * @param jointId a spherical joint
 * @param angleX the half-angle for turns about x of frame A [rad], 0 to pi
 * @param angleY the half-angle for turns about y of frame A [rad], 0 to pi
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetConeLimits(mvJointId jointId, mvFloat angleX, mvFloat angleY);

/**
 * Get the half-angle of the cone for turns about y of frame A.
 * @param jointId a spherical joint
 * @return the angle [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetConeLimitY(mvJointId jointId);

/**
 * Get the angle between the z axes of the frames.
 * @param jointId a spherical joint
 * @return the angle [rad], 0 to pi; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetConeAngle(mvJointId jointId);

/**
 * Turn the limit of the twist on or off.
 * @param jointId a spherical joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvSphericalJoint_EnableTwistLimit(mvJointId jointId, bool flag);

/**
 * Is the limit of the twist on?
 * @param jointId a spherical joint; false for another joint or a bad one
 */
MV_API bool mvSphericalJoint_IsTwistLimitEnabled(mvJointId jointId);

/**
 * Set the limits of the twist.
 * @param jointId a spherical joint
 * @param lower the least [rad]
 * @param upper the greatest [rad], not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetTwistLimits(mvJointId jointId, mvFloat lower, mvFloat upper);

/**
 * Get the limits of the twist: the least.
 * @param jointId a spherical joint
 * @return the least [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetLowerTwistLimit(mvJointId jointId);

/**
 * Get the limits of the twist: the greatest.
 * @param jointId a spherical joint
 * @return the greatest [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetUpperTwistLimit(mvJointId jointId);

/**
 * Get the twist of frame B against frame A about z.
 * @param jointId a spherical joint
 * @return the angle [rad], -pi to pi; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetTwistAngle(mvJointId jointId);

/**
 * Turn the spring on or off.
 * @param jointId a spherical joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvSphericalJoint_EnableSpring(mvJointId jointId, bool flag);

/**
 * Is the spring on?
 * @param jointId a spherical joint; false for another joint or a bad one
 */
MV_API bool mvSphericalJoint_IsSpringEnabled(mvJointId jointId);

/**
 * Set the frequency of the spring.
 * @param jointId a spherical joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetSpringHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring.
 * @param jointId a spherical joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetSpringHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring.
 * @param jointId a spherical joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetSpringDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring.
 * @param jointId a spherical joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetSpringDampingRatio(mvJointId jointId);

/**
 * Set the greatest torque of the spring about each axis.
 * @param jointId a spherical joint
 * @param maxTorque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetMaxSpringTorque(mvJointId jointId, mvFloat maxTorque);

/**
 * Get the greatest torque of the spring about each axis.
 * @param jointId a spherical joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetMaxSpringTorque(mvJointId jointId);

/**
 * Set the rotation of frame B in frame A at which the spring rests.
 * @param jointId a spherical joint
 * @param targetRotation the rotation, of length 1
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetTargetRotation(mvJointId jointId, mvQuat targetRotation);

/**
 * Get the rotation of frame B in frame A at which the spring rests.
 * @param jointId a spherical joint
 * @return the rotation; the identity for another joint or a bad one
 */
MV_API mvQuat mvSphericalJoint_GetTargetRotation(mvJointId jointId);

/**
 * Turn the motor on or off.
 * @param jointId a spherical joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvSphericalJoint_EnableMotor(mvJointId jointId, bool flag);

/**
 * Is the motor on?
 * @param jointId a spherical joint; false for another joint or a bad one
 */
MV_API bool mvSphericalJoint_IsMotorEnabled(mvJointId jointId);

/**
 * Set the angular velocity that the motor wants, in the axes of frame A.
 * @param jointId a spherical joint
 * @param motorVelocity the value [rad/s]
 * @note Errors: mv_errorNotFinite; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetMotorVelocity(mvJointId jointId, mvVec3 motorVelocity);

/**
 * Get the angular velocity that the motor wants, in the axes of frame A.
 * @param jointId a spherical joint
 * @return the value [rad/s]; zero for another joint or a bad one
 */
MV_API mvVec3 mvSphericalJoint_GetMotorVelocity(mvJointId jointId);

/**
 * Get the torque of the motor about the axes of frame A.
 * @param jointId a spherical joint
 * @return the mean over the last sub-step [N m]; zero for another joint or a bad one
 */
MV_API mvVec3 mvSphericalJoint_GetMotorTorque(mvJointId jointId);

/**
 * Set the greatest torque of the motor about each axis.
 * @param jointId a spherical joint
 * @param torque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetMaxMotorTorque(mvJointId jointId, mvFloat torque);

/**
 * Get the greatest torque of the motor about each axis.
 * @param jointId a spherical joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetMaxMotorTorque(mvJointId jointId);

/**
 * Set the torque of dry friction about each axis.
 * @param jointId a spherical joint
 * @param friction the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvSphericalJoint_SetFriction(mvJointId jointId, mvFloat friction);

/**
 * Get the torque of dry friction about each axis.
 * @param jointId a spherical joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvSphericalJoint_GetFriction(mvJointId jointId);

/**
 * Get the definition of an universal joint with the default values.
 */
MV_API mvUniversalJointDef mvDefaultUniversalJointDef(void);

/**
 * Create an universal joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultUniversalJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateUniversalJoint(mvWorldId worldId,
                                 const mvUniversalJointDef *def);

/**
 * Get the angle about x of frame A.
 * @param jointId a universal joint
 * @return the angle [rad], -pi to pi; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetAngle1(mvJointId jointId);

/**
 * Turn the spring about x of frame A on or off.
 * @param jointId a universal joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvUniversalJoint_EnableSpring1(mvJointId jointId, bool flag);

/**
 * Is the spring about x of frame A on?
 * @param jointId a universal joint; false for another joint or a bad one
 */
MV_API bool mvUniversalJoint_IsSpring1Enabled(mvJointId jointId);

/**
 * Set the frequency of the spring about x of frame A.
 * @param jointId a universal joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetSpringHertz1(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring about x of frame A.
 * @param jointId a universal joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetSpringHertz1(mvJointId jointId);

/**
 * Set the damping ratio of the spring about x of frame A.
 * @param jointId a universal joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetSpringDampingRatio1(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring about x of frame A.
 * @param jointId a universal joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetSpringDampingRatio1(mvJointId jointId);

/**
 * Set the angle about x of frame A at which the spring rests.
 * @param jointId a universal joint
 * @param angle the value [rad]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetTargetAngle1(mvJointId jointId, mvFloat angle);

/**
 * Get the angle about x of frame A at which the spring rests.
 * @param jointId a universal joint
 * @return the value [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetTargetAngle1(mvJointId jointId);

/**
 * Turn the limit of the angle about x of frame A on or off.
 * @param jointId a universal joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvUniversalJoint_EnableLimit1(mvJointId jointId, bool flag);

/**
 * Is the limit of the angle about x of frame A on?
 * @param jointId a universal joint; false for another joint or a bad one
 */
MV_API bool mvUniversalJoint_IsLimit1Enabled(mvJointId jointId);

/**
 * Set the limits of the angle about x of frame A.
 * @param jointId a universal joint
 * @param lower the least [rad]
 * @param upper the greatest [rad], not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetLimits1(mvJointId jointId, mvFloat lower, mvFloat upper);

/**
 * Get the limits of the angle about x of frame A: the least.
 * @param jointId a universal joint
 * @return the least [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetLowerLimit1(mvJointId jointId);

/**
 * Get the limits of the angle about x of frame A: the greatest.
 * @param jointId a universal joint
 * @return the greatest [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetUpperLimit1(mvJointId jointId);

/**
 * Turn the motor about x of frame A on or off.
 * @param jointId a universal joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvUniversalJoint_EnableMotor1(mvJointId jointId, bool flag);

/**
 * Is the motor about x of frame A on?
 * @param jointId a universal joint; false for another joint or a bad one
 */
MV_API bool mvUniversalJoint_IsMotor1Enabled(mvJointId jointId);

/**
 * Set the speed that the motor about x of frame A wants.
 * @param jointId a universal joint
 * @param motorSpeed the value [rad/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetMotorSpeed1(mvJointId jointId, mvFloat motorSpeed);

/**
 * Get the speed that the motor about x of frame A wants.
 * @param jointId a universal joint
 * @return the value [rad/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetMotorSpeed1(mvJointId jointId);

/**
 * Set the greatest torque of the motor about x of frame A.
 * @param jointId a universal joint
 * @param torque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetMaxMotorTorque1(mvJointId jointId, mvFloat torque);

/**
 * Get the greatest torque of the motor about x of frame A.
 * @param jointId a universal joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetMaxMotorTorque1(mvJointId jointId);

/**
 * Set the torque of dry friction about x of frame A.
 * @param jointId a universal joint
 * @param torque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetFriction1(mvJointId jointId, mvFloat torque);

/**
 * Get the torque of dry friction about x of frame A.
 * @param jointId a universal joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetFriction1(mvJointId jointId);

/**
 * Get the angle about y of frame B.
 * @param jointId a universal joint
 * @return the angle [rad], -pi to pi; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetAngle2(mvJointId jointId);

/**
 * Turn the spring about y of frame B on or off.
 * @param jointId a universal joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvUniversalJoint_EnableSpring2(mvJointId jointId, bool flag);

/**
 * Is the spring about y of frame B on?
 * @param jointId a universal joint; false for another joint or a bad one
 */
MV_API bool mvUniversalJoint_IsSpring2Enabled(mvJointId jointId);

/**
 * Set the frequency of the spring about y of frame B.
 * @param jointId a universal joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetSpringHertz2(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring about y of frame B.
 * @param jointId a universal joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetSpringHertz2(mvJointId jointId);

/**
 * Set the damping ratio of the spring about y of frame B.
 * @param jointId a universal joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetSpringDampingRatio2(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring about y of frame B.
 * @param jointId a universal joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetSpringDampingRatio2(mvJointId jointId);

/**
 * Set the angle about y of frame B at which the spring rests.
 * @param jointId a universal joint
 * @param angle the value [rad]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetTargetAngle2(mvJointId jointId, mvFloat angle);

/**
 * Get the angle about y of frame B at which the spring rests.
 * @param jointId a universal joint
 * @return the value [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetTargetAngle2(mvJointId jointId);

/**
 * Turn the limit of the angle about y of frame B on or off.
 * @param jointId a universal joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvUniversalJoint_EnableLimit2(mvJointId jointId, bool flag);

/**
 * Is the limit of the angle about y of frame B on?
 * @param jointId a universal joint; false for another joint or a bad one
 */
MV_API bool mvUniversalJoint_IsLimit2Enabled(mvJointId jointId);

/**
 * Set the limits of the angle about y of frame B.
 * @param jointId a universal joint
 * @param lower the least [rad]
 * @param upper the greatest [rad], not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetLimits2(mvJointId jointId, mvFloat lower, mvFloat upper);

/**
 * Get the limits of the angle about y of frame B: the least.
 * @param jointId a universal joint
 * @return the least [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetLowerLimit2(mvJointId jointId);

/**
 * Get the limits of the angle about y of frame B: the greatest.
 * @param jointId a universal joint
 * @return the greatest [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetUpperLimit2(mvJointId jointId);

/**
 * Turn the motor about y of frame B on or off.
 * @param jointId a universal joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvUniversalJoint_EnableMotor2(mvJointId jointId, bool flag);

/**
 * Is the motor about y of frame B on?
 * @param jointId a universal joint; false for another joint or a bad one
 */
MV_API bool mvUniversalJoint_IsMotor2Enabled(mvJointId jointId);

/**
 * Set the speed that the motor about y of frame B wants.
 * @param jointId a universal joint
 * @param motorSpeed the value [rad/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetMotorSpeed2(mvJointId jointId, mvFloat motorSpeed);

/**
 * Get the speed that the motor about y of frame B wants.
 * @param jointId a universal joint
 * @return the value [rad/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetMotorSpeed2(mvJointId jointId);

/**
 * Set the greatest torque of the motor about y of frame B.
 * @param jointId a universal joint
 * @param torque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetMaxMotorTorque2(mvJointId jointId, mvFloat torque);

/**
 * Get the greatest torque of the motor about y of frame B.
 * @param jointId a universal joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetMaxMotorTorque2(mvJointId jointId);

/**
 * Set the torque of dry friction about y of frame B.
 * @param jointId a universal joint
 * @param torque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvUniversalJoint_SetFriction2(mvJointId jointId, mvFloat torque);

/**
 * Get the torque of dry friction about y of frame B.
 * @param jointId a universal joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvUniversalJoint_GetFriction2(mvJointId jointId);

/**
 * Get the definition of a weld joint with the default values.
 */
MV_API mvWeldJointDef mvDefaultWeldJointDef(void);

/**
 * Create a weld joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultWeldJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateWeldJoint(mvWorldId worldId,
                            const mvWeldJointDef *def);

/**
 * Set the stiffness of the place.
 * @param jointId a weld joint
 * @param hertz the value [Hz], >= 0; 0 is rigid
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWeldJoint_SetLinearHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the stiffness of the place.
 * @param jointId a weld joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWeldJoint_GetLinearHertz(mvJointId jointId);

/**
 * Set the damping ratio of the place.
 * @param jointId a weld joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWeldJoint_SetLinearDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the place.
 * @param jointId a weld joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvWeldJoint_GetLinearDampingRatio(mvJointId jointId);

/**
 * Set the stiffness of the rotation.
 * @param jointId a weld joint
 * @param hertz the value [Hz], >= 0; 0 is rigid
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWeldJoint_SetAngularHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the stiffness of the rotation.
 * @param jointId a weld joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWeldJoint_GetAngularHertz(mvJointId jointId);

/**
 * Set the damping ratio of the rotation.
 * @param jointId a weld joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWeldJoint_SetAngularDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the rotation.
 * @param jointId a weld joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvWeldJoint_GetAngularDampingRatio(mvJointId jointId);

/**
 * Get the definition of a wheel joint with the default values.
 */
MV_API mvWheelJointDef mvDefaultWheelJointDef(void);

/**
 * Create a wheel joint. Its bodies wake.
 *
 * @param worldId the world that both bodies live in
 * @param def the definition, from mvDefaultWheelJointDef()
 * @return the joint; null for bad arguments
 * @note Errors: mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported for a world whose solver
 * has no joints.
 */
MV_API
mvJointId mvCreateWheelJoint(mvWorldId worldId,
                             const mvWheelJointDef *def);

/**
 * Turn the spring of the suspension on or off.
 * @param jointId a wheel joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvWheelJoint_EnableSuspension(mvJointId jointId, bool flag);

/**
 * Is the spring of the suspension on?
 * @param jointId a wheel joint; false for another joint or a bad one
 */
MV_API bool mvWheelJoint_IsSuspensionEnabled(mvJointId jointId);

/**
 * Set the frequency of the suspension.
 * @param jointId a wheel joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetSuspensionHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the suspension.
 * @param jointId a wheel joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSuspensionHertz(mvJointId jointId);

/**
 * Set the damping ratio of the suspension.
 * @param jointId a wheel joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetSuspensionDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the suspension.
 * @param jointId a wheel joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSuspensionDampingRatio(mvJointId jointId);

/**
 * Set the travel at which the suspension rests.
 * @param jointId a wheel joint
 * @param travel the value [m]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetTargetSuspension(mvJointId jointId, mvFloat travel);

/**
 * Get the travel at which the suspension rests.
 * @param jointId a wheel joint
 * @return the value [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetTargetSuspension(mvJointId jointId);

/**
 * Set the greatest force of the suspension.
 * @param jointId a wheel joint
 * @param force the value [N], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetMaxSuspensionForce(mvJointId jointId, mvFloat force);

/**
 * Get the greatest force of the suspension.
 * @param jointId a wheel joint
 * @return the value [N]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetMaxSuspensionForce(mvJointId jointId);

/**
 * Get how far the wheel is along x of frame A.
 * @param jointId a wheel joint
 * @return the travel [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSuspensionTravel(mvJointId jointId);

/**
 * Turn the limit of the travel on or off.
 * @param jointId a wheel joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvWheelJoint_EnableSuspensionLimit(mvJointId jointId, bool flag);

/**
 * Is the limit of the travel on?
 * @param jointId a wheel joint; false for another joint or a bad one
 */
MV_API bool mvWheelJoint_IsSuspensionLimitEnabled(mvJointId jointId);

/**
 * Set the limits of the travel.
 * @param jointId a wheel joint
 * @param lower the least [m]
 * @param upper the greatest [m], not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetSuspensionLimits(mvJointId jointId, mvFloat lower, mvFloat upper);

/**
 * Get the limits of the travel: the least.
 * @param jointId a wheel joint
 * @return the least [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetLowerSuspensionLimit(mvJointId jointId);

/**
 * Get the limits of the travel: the greatest.
 * @param jointId a wheel joint
 * @return the greatest [m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetUpperSuspensionLimit(mvJointId jointId);

/**
 * Turn the motor that spins the wheel on or off.
 * @param jointId a wheel joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvWheelJoint_EnableSpinMotor(mvJointId jointId, bool flag);

/**
 * Is the motor that spins the wheel on?
 * @param jointId a wheel joint; false for another joint or a bad one
 */
MV_API bool mvWheelJoint_IsSpinMotorEnabled(mvJointId jointId);

/**
 * Set the speed that the motor wants.
 * @param jointId a wheel joint
 * @param speed the value [rad/s]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetSpinMotorSpeed(mvJointId jointId, mvFloat speed);

/**
 * Get the speed that the motor wants.
 * @param jointId a wheel joint
 * @return the value [rad/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSpinMotorSpeed(mvJointId jointId);

/**
 * Set the greatest torque of the motor.
 * @param jointId a wheel joint
 * @param torque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetMaxSpinTorque(mvJointId jointId, mvFloat torque);

/**
 * Get the greatest torque of the motor.
 * @param jointId a wheel joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetMaxSpinTorque(mvJointId jointId);

/**
 * Set the torque of dry friction in the bearing.
 * @param jointId a wheel joint
 * @param torque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetSpinFriction(mvJointId jointId, mvFloat torque);

/**
 * Get the torque of dry friction in the bearing.
 * @param jointId a wheel joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSpinFriction(mvJointId jointId);

/**
 * Get how fast the wheel spins against the chassis.
 * @param jointId a wheel joint
 * @return the speed [rad/s]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSpinSpeed(mvJointId jointId);

/**
 * Get how far the wheel has turned, counting whole turns.
 * @param jointId a wheel joint
 * @return the angle [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSpinAngle(mvJointId jointId);

/**
 * Get the torque of the motor that spins the wheel.
 * @param jointId a wheel joint
 * @return the mean over the last sub-step [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSpinTorque(mvJointId jointId);

/**
 * Turn steering on or off.
 * @param jointId a wheel joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvWheelJoint_EnableSteering(mvJointId jointId, bool flag);

/**
 * Is steering on?
 * @param jointId a wheel joint; false for another joint or a bad one
 */
MV_API bool mvWheelJoint_IsSteeringEnabled(mvJointId jointId);

/**
 * Set the frequency of the spring that steers.
 * @param jointId a wheel joint
 * @param hertz the value [Hz], >= 0; 0 has no effect
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetSteeringHertz(mvJointId jointId, mvFloat hertz);

/**
 * Get the frequency of the spring that steers.
 * @param jointId a wheel joint
 * @return the value [Hz]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSteeringHertz(mvJointId jointId);

/**
 * Set the damping ratio of the spring that steers.
 * @param jointId a wheel joint
 * @param dampingRatio the value >= 0; 1 is critical
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetSteeringDampingRatio(mvJointId jointId, mvFloat dampingRatio);

/**
 * Get the damping ratio of the spring that steers.
 * @param jointId a wheel joint
 * @return the value; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSteeringDampingRatio(mvJointId jointId);

/**
 * Set the greatest torque of the spring that steers.
 * @param jointId a wheel joint
 * @param torque the value [N m], >= 0, may be infinite
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetMaxSteeringTorque(mvJointId jointId, mvFloat torque);

/**
 * Get the greatest torque of the spring that steers.
 * @param jointId a wheel joint
 * @return the value [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetMaxSteeringTorque(mvJointId jointId);

/**
 * Turn the limit of the steering angle on or off.
 * @param jointId a wheel joint
 * @param flag whether it acts
 * @note Errors: mv_errorRange, also for another joint.
 */
MV_API void mvWheelJoint_EnableSteeringLimit(mvJointId jointId, bool flag);

/**
 * Is the limit of the steering angle on?
 * @param jointId a wheel joint; false for another joint or a bad one
 */
MV_API bool mvWheelJoint_IsSteeringLimitEnabled(mvJointId jointId);

/**
 * Set the limits of the steering angle.
 * @param jointId a wheel joint
 * @param lower the least [rad]
 * @param upper the greatest [rad], not below the least
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetSteeringLimits(mvJointId jointId, mvFloat lower, mvFloat upper);

/**
 * Get the limits of the steering angle: the least.
 * @param jointId a wheel joint
 * @return the least [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetLowerSteeringLimit(mvJointId jointId);

/**
 * Get the limits of the steering angle: the greatest.
 * @param jointId a wheel joint
 * @return the greatest [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetUpperSteeringLimit(mvJointId jointId);

/**
 * Set the angle that the spring steers to.
 * @param jointId a wheel joint
 * @param angle the value [rad]
 * @note Errors: mv_errorNotFinite, mv_errorRange; mv_errorRange for another joint.
 */
MV_API void mvWheelJoint_SetTargetSteeringAngle(mvJointId jointId, mvFloat angle);

/**
 * Get the angle that the spring steers to.
 * @param jointId a wheel joint
 * @return the value [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetTargetSteeringAngle(mvJointId jointId);

/**
 * Get the steering angle about x of frame A.
 * @param jointId a wheel joint
 * @return the angle [rad]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSteeringAngle(mvJointId jointId);

/**
 * Get the torque that steers the wheel, spring and limits together.
 * @param jointId a wheel joint
 * @return the mean over the last sub-step [N m]; 0 for another joint or a bad one
 */
MV_API mvFloat mvWheelJoint_GetSteeringTorque(mvJointId jointId);

/**
 * Get the name of a solver.
 *
 * @return a constant, null for a number that is none of the constants
 * @note Errors: mv_errorRange.
 */
MV_API const char *mvGetSolverKindName(mvSolverKind kind);

/**
 * Get the name of an integrator.
 *
 * @return a constant, null for a number that is none of the constants
 * @note Errors: mv_errorRange.
 */
MV_API const char *mvGetIntegratorKindName(mvIntegratorKind kind);

/**
 * Get the name of a broad phase.
 *
 * @return a constant, null for a number that is none of the constants
 * @note Errors: mv_errorRange.
 */
MV_API const char *mvGetBroadPhaseKindName(mvBroadPhaseKind kind);

/**
 * Get the name of a narrow phase.
 *
 * @return a constant, null for a number that is none of the constants
 * @note Errors: mv_errorRange.
 */
MV_API const char *mvGetNarrowPhaseKindName(mvNarrowPhaseKind kind);

/**
 * Get the name of a way to look at simplices.
 *
 * @return a constant, null for a number that is none of the constants
 * @note Errors: mv_errorRange.
 */
MV_API const char *mvGetGjkKindName(mvGjkKind kind);

/**
 * Get the name of a way to find contact points.
 *
 * @return a constant, null for a number that is none of the constants
 * @note Errors: mv_errorRange.
 */
MV_API const char *mvGetManifoldKindName(mvManifoldKind kind);

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

/**
 * Find the shapes whose boxes overlap a box. The world may be read but not changed in the callback.
 *
 * @param worldId the world
 * @param aabb the box
 * @param filter which shapes the query sees
 * @param fcn told of each shape, in order of their places
 * @param context passed to fcn
 * @return what was looked at; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvTreeStats mvWorld_OverlapAABB(mvWorldId worldId,
                                mvAABB aabb,
                                mvQueryFilter filter,
                                mvOverlapResultFcn fcn,
                                void *context);

/**
 * Find the shapes whose boxes overlap a box, into an array.
 *
 * @param worldId the world
 * @param aabb the box
 * @param filter which shapes the query sees
 * @param shapeIds filled with the shapes, in order of their places; may be null
 * @param capacity the room in the array, >= 0
 * @return how many were found, which may be more than the capacity; 0 for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
int mvWorld_OverlapAABBAll(mvWorldId worldId,
                           mvAABB aabb,
                           mvQueryFilter filter,
                           mvShapeId *shapeIds,
                           int capacity);

/**
 * Find the shapes that touch or overlap a solid. The world may be read but not changed in the callback.
 *
 * @param worldId the world
 * @param origin what the points of the proxy are counted from [m]
 * @param proxy the solid
 * @param filter which shapes the query sees
 * @param fcn told of each shape, in order of their places
 * @param context passed to fcn
 * @return what was looked at; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvTreeStats mvWorld_OverlapShape(mvWorldId worldId,
                                 mvPos origin,
                                 const mvShapeProxy *proxy,
                                 mvQueryFilter filter,
                                 mvOverlapResultFcn fcn,
                                 void *context);

/**
 * Find the shapes that touch or overlap a solid, into an array.
 *
 * @param worldId the world
 * @param origin what the points of the proxy are counted from [m]
 * @param proxy the solid
 * @param filter which shapes the query sees
 * @param shapeIds filled with the shapes, in order of their places; may be null
 * @param capacity the room in the array, >= 0
 * @return how many were found, which may be more than the capacity; 0 for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
int mvWorld_OverlapShapeAll(mvWorldId worldId,
                            mvPos origin,
                            const mvShapeProxy *proxy,
                            mvQueryFilter filter,
                            mvShapeId *shapeIds,
                            int capacity);

/**
 * Cast a ray and be told of the shapes that it hits, nearest first. Shapes in which it starts are not hit. The world
 * may be read but not changed in the callback.
 *
 * @param worldId the world
 * @param origin where the ray starts [m]
 * @param translation from the start to the end of the ray [m]
 * @param filter which shapes the ray sees
 * @param fcn told of each hit
 * @param context passed to fcn
 * @return what was looked at; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvTreeStats mvWorld_CastRay(mvWorldId worldId,
                            mvPos origin,
                            mvVec3 translation,
                            mvQueryFilter filter,
                            mvCastResultFcn fcn,
                            void *context);

/**
 * Cast a ray and get the nearest shape that it hits. Shapes in which it starts are not hit.
 *
 * @param worldId the world
 * @param origin where the ray starts [m]
 * @param translation from the start to the end of the ray [m]
 * @param filter which shapes the ray sees
 * @return the nearest hit; of equally near ones that of the shape with the lowest place; no hit for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvRayResult mvWorld_CastRayClosest(mvWorldId worldId,
                                   mvPos origin,
                                   mvVec3 translation,
                                   mvQueryFilter filter);

/**
 * Cast a ray and get the shapes that it hits, nearest first. Shapes in which it starts are not hit.
 *
 * @param worldId the world
 * @param origin where the ray starts [m]
 * @param translation from the start to the end of the ray [m]
 * @param filter which shapes the ray sees
 * @param results filled with the hits; may be null
 * @param capacity the room in the array, >= 0
 * @return how many hits there are, which may be more than the capacity; 0 for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
int mvWorld_CastRayAll(mvWorldId worldId,
                       mvPos origin,
                       mvVec3 translation,
                       mvQueryFilter filter,
                       mvRayResult *results,
                       int capacity);

/**
 * Move a solid without turning and be told of the shapes that it hits, nearest first. A shape that it overlaps from
 * the start is hit at fraction 0 with a zero normal. The world may be read but not changed in the callback.
 *
 * @param worldId the world
 * @param origin what the points of the proxy are counted from [m]
 * @param proxy the solid
 * @param translation from the start to the end of the motion [m]
 * @param filter which shapes the solid sees
 * @param fcn told of each hit
 * @param context passed to fcn
 * @return what was looked at; zero for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvTreeStats mvWorld_CastShape(mvWorldId worldId,
                              mvPos origin,
                              const mvShapeProxy *proxy,
                              mvVec3 translation,
                              mvQueryFilter filter,
                              mvCastResultFcn fcn,
                              void *context);

/**
 * Move a solid without turning and get the nearest shape that it hits. A shape that it overlaps from the start is hit
 * at fraction 0 with a zero normal.
 *
 * @param worldId the world
 * @param origin what the points of the proxy are counted from [m]
 * @param proxy the solid
 * @param translation from the start to the end of the motion [m]
 * @param filter which shapes the solid sees
 * @return the nearest hit; of equally near ones that of the shape with the lowest place; no hit for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvRayResult mvWorld_CastShapeClosest(mvWorldId worldId,
                                     mvPos origin,
                                     const mvShapeProxy *proxy,
                                     mvVec3 translation,
                                     mvQueryFilter filter);

/**
 * Move a solid without turning and get the shapes that it hits, nearest first. A shape that it overlaps from the start
 * is hit at fraction 0 with a zero normal.
 *
 * @param worldId the world
 * @param origin what the points of the proxy are counted from [m]
 * @param proxy the solid
 * @param translation from the start to the end of the motion [m]
 * @param filter which shapes the solid sees
 * @param results filled with the hits; may be null
 * @param capacity the room in the array, >= 0
 * @return how many hits there are, which may be more than the capacity; 0 for bad arguments
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange.
 */
MV_API
int mvWorld_CastShapeAll(mvWorldId worldId,
                         mvPos origin,
                         const mvShapeProxy *proxy,
                         mvVec3 translation,
                         mvQueryFilter filter,
                         mvRayResult *results,
                         int capacity);

/**
 * Attach a sphere to a body.
 *
 * @param bodyId the body
 * @param def the definition, from mvDefaultShapeDef()
 * @param sphere the sphere, in the body's frame
 * @return the shape; null for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvShapeId mvCreateSphereShape(mvBodyId bodyId,
                              const mvShapeDef *def,
                              const mvSphere *sphere);

/**
 * Attach a capsule to a body.
 *
 * @param bodyId the body
 * @param def the definition, from mvDefaultShapeDef()
 * @param capsule the capsule, in the body's frame
 * @return the shape; null for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvShapeId mvCreateCapsuleShape(mvBodyId bodyId,
                               const mvShapeDef *def,
                               const mvCapsule *capsule);

/**
 * Attach a hull to a body.
 *
 * @param bodyId the body
 * @param def the definition, from mvDefaultShapeDef()
 * @param hull the hull, in the body's frame; it may be destroyed right after
 * @return the shape; null for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvShapeId mvCreateHullShape(mvBodyId bodyId,
                            const mvShapeDef *def,
                            const mvHullData *hull);

/**
 * Attach a scaled and placed copy of a hull to a body.
 *
 * @param bodyId the body
 * @param def the definition, from mvDefaultShapeDef()
 * @param hull the hull; it may be destroyed right after
 * @param transform where the scaled hull is in the body's frame
 * @param scale the scale along the hull's x, y and z, which may be negative but not zero
 * @return the shape; null for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvShapeId mvCreateTransformedHullShape(mvBodyId bodyId,
                                       const mvShapeDef *def,
                                       const mvHullData *hull,
                                       mvTransform transform,
                                       mvVec3 scale);

/**
 * Attach a box to a body, centred on the body's origin.
 *
 * @param bodyId the body
 * @param def the definition, from mvDefaultShapeDef()
 * @param hx half the side length along x [m], > 0
 * @param hy half the side length along y [m], > 0
 * @param hz half the side length along z [m], > 0
 * @return the shape; null for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API
mvShapeId mvCreateBoxShape(mvBodyId bodyId,
                           const mvShapeDef *def,
                           mvFloat hx,
                           mvFloat hy,
                           mvFloat hz);

/**
 * Attach everything below a plane to a static body: a floor without end.
 *
 * @param bodyId the body
 * @param def the definition, from mvDefaultShapeDef()
 * @param plane the plane, in the body's frame; its normal may have any length but 0 and is scaled to 1,
 * the offset is along the scaled normal
 * @return the shape; null for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate; mv_errorRange also for a body that is not static.
 */
MV_API
mvShapeId mvCreatePlaneShape(mvBodyId bodyId,
                             const mvShapeDef *def,
                             const mvPlane *plane);

/**
 * Destroy a shape. What it touched wakes up.
 * @param shapeId the shape
 * @param updateBodyMass whether to update the body's mass; else call mvBody_ApplyMassFromShapes() later
 */
MV_API void mvDestroyShape(mvShapeId shapeId, bool updateBodyMass);

/**
 * Does this id name a shape that lives? Never fails; false also while another thread changes the world.
 */
MV_API bool mvShape_IsValid(mvShapeId id);

/**
 * Get what a shape is.
 * @param shapeId the shape
 * @return one of the mv_...Shape constants; mv_capsuleShape, which is 0, for a bad shape
 */
MV_API mvShapeType mvShape_GetType(mvShapeId shapeId);

/**
 * Get the body that a shape is attached to.
 * @param shapeId the shape
 * @return the body; null for a bad shape
 */
MV_API mvBodyId mvShape_GetBody(mvShapeId shapeId);

/**
 * Get the world that a shape lives in.
 * @param shapeId the shape
 * @return the world; null for a bad shape
 */
MV_API mvWorldId mvShape_GetWorld(mvShapeId shapeId);

/**
 * Set the name of a shape.
 * @param shapeId the shape
 * @param name UTF-8, copied; null for none
 * @note Errors: mv_errorRange when the name is not UTF-8.
 */
MV_API void mvShape_SetName(mvShapeId shapeId, const char *name);

/**
 * Get the name of a shape.
 * @param shapeId the shape
 * @return UTF-8, empty for none; null for a bad shape. Valid until the name is changed or the shape destroyed.
 */
MV_API
const char *mvShape_GetName(mvShapeId shapeId);

/**
 * Set the user data of a shape.
 * @param shapeId the shape
 * @param userData anything; it is never followed
 */
MV_API void mvShape_SetUserData(mvShapeId shapeId, void *userData);

/**
 * Get the user data of a shape.
 * @param shapeId the shape
 * @return what was set; null for a bad shape
 */
MV_API void *mvShape_GetUserData(mvShapeId shapeId);

/**
 * Get the sphere of a shape.
 * @param shapeId the shape
 * @return the sphere, in the body's frame; zero for a bad shape
 * @note Errors: mv_errorRange when the shape is no sphere.
 */
MV_API mvSphere mvShape_GetSphere(mvShapeId shapeId);

/**
 * Get the capsule of a shape.
 * @param shapeId the shape
 * @return the capsule, in the body's frame; zero for a bad shape
 * @note Errors: mv_errorRange when the shape is no capsule.
 */
MV_API mvCapsule mvShape_GetCapsule(mvShapeId shapeId);

/**
 * Get the hull of a shape.
 * @param shapeId the shape
 * @return the hull, in the body's frame; null for a bad shape. Valid until the shape is changed or destroyed.
 * @note Errors: mv_errorRange when the shape is no hull.
 */
MV_API const mvHullData *mvShape_GetHull(mvShapeId shapeId);

/**
 * Get the plane of a shape.
 * @param shapeId the shape
 * @return the plane, in the body's frame; zero for a bad shape
 * @note Errors: mv_errorRange when the shape is no plane.
 */
MV_API mvPlane mvShape_GetPlane(mvShapeId shapeId);

/**
 * Make a shape a sphere. The body's mass stays: call mvBody_ApplyMassFromShapes() to update it.
 * @param shapeId the shape
 * @param sphere the sphere, in the body's frame
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API void mvShape_SetSphere(mvShapeId shapeId, const mvSphere *sphere);

/**
 * Make a shape a capsule. The body's mass stays: call mvBody_ApplyMassFromShapes() to update it.
 * @param shapeId the shape
 * @param capsule the capsule, in the body's frame
 * @note Errors: mv_errorNull, mv_errorNotFinite, mv_errorRange, mv_errorDegenerate.
 */
MV_API void mvShape_SetCapsule(mvShapeId shapeId, const mvCapsule *capsule);

/**
 * Make a shape a hull. The body's mass stays: call mvBody_ApplyMassFromShapes() to update it.
 * @param shapeId the shape
 * @param hull the hull, in the body's frame; it may be destroyed right after
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorRange, mv_errorDegenerate.
 */
MV_API void mvShape_SetHull(mvShapeId shapeId, const mvHullData *hull);

/**
 * Set the density of a shape.
 * @param shapeId the shape
 * @param density the density [kg/m^3], >= 0
 * @param updateBodyMass whether to update the body's mass; else call mvBody_ApplyMassFromShapes() later
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvShape_SetDensity(mvShapeId shapeId, mvFloat density, bool updateBodyMass);

/**
 * Get the density of a shape.
 * @param shapeId the shape
 * @return the density [kg/m^3]; 0 for a bad shape
 */
MV_API mvFloat mvShape_GetDensity(mvShapeId shapeId);

/**
 * Set the coefficient of sliding friction of a shape.
 * @param shapeId the shape
 * @param friction the coefficient, >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvShape_SetFriction(mvShapeId shapeId, mvFloat friction);

/**
 * Get the coefficient of sliding friction of a shape.
 * @param shapeId the shape
 * @return the coefficient; 0 for a bad shape
 */
MV_API mvFloat mvShape_GetFriction(mvShapeId shapeId);

/**
 * Set the coefficient of static friction of a shape.
 * @param shapeId the shape
 * @param staticFriction the coefficient, negative for that of sliding
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvShape_SetStaticFriction(mvShapeId shapeId, mvFloat staticFriction);

/**
 * Get the coefficient of static friction of a shape.
 * @param shapeId the shape
 * @return the coefficient, negative for that of sliding; 0 for a bad shape
 */
MV_API mvFloat mvShape_GetStaticFriction(mvShapeId shapeId);

/**
 * Set the coefficient of restitution of a shape.
 * @param shapeId the shape
 * @param restitution the coefficient, 0 to 1
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvShape_SetRestitution(mvShapeId shapeId, mvFloat restitution);

/**
 * Get the coefficient of restitution of a shape.
 * @param shapeId the shape
 * @return the coefficient; 0 for a bad shape
 */
MV_API mvFloat mvShape_GetRestitution(mvShapeId shapeId);

/**
 * Set the surface of a shape. It takes effect in the next step.
 * @param shapeId the shape
 * @param surfaceMaterial the surface
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvShape_SetSurfaceMaterial(mvShapeId shapeId, mvSurfaceMaterial surfaceMaterial);

/**
 * Get the surface of a shape.
 * @param shapeId the shape
 * @return the surface; zero for a bad shape
 */
MV_API mvSurfaceMaterial mvShape_GetSurfaceMaterial(mvShapeId shapeId);

/**
 * Get what a shape collides with.
 * @param shapeId the shape
 * @return the filter; zero for a bad shape
 */
MV_API mvFilter mvShape_GetFilter(mvShapeId shapeId);

/**
 * Set what a shape collides with. If that changes anything, its contacts end, and those that the filter allows are
 * found again in the next step.
 * @param shapeId the shape
 * @param filter the filter
 * @param invokeContacts whether contacts are to be found anew; today they always are
 * @note Errors: mv_errorRange for a flag that is neither true nor false.
 */
MV_API
void mvShape_SetFilter(mvShapeId shapeId,
                       mvFilter filter,
                       bool invokeContacts);

/**
 * Make begin and end events for contacts of a shape, or not. One of the two shapes is enough.
 * @param shapeId the shape
 * @param flag whether to do it
 */
MV_API void mvShape_EnableContactEvents(mvShapeId shapeId, bool flag);

/**
 * Are there begin and end events for the contacts of a shape?
 * @param shapeId the shape
 */
MV_API bool mvShape_AreContactEventsEnabled(mvShapeId shapeId);

/**
 * Ask the pre-solve callback about contacts of a shape, or not. One of the two shapes is enough.
 * @param shapeId the shape
 * @param flag whether to do it
 */
MV_API void mvShape_EnablePreSolveEvents(mvShapeId shapeId, bool flag);

/**
 * Is the pre-solve callback asked about contacts of a shape?
 * @param shapeId the shape
 */
MV_API bool mvShape_ArePreSolveEventsEnabled(mvShapeId shapeId);

/**
 * Make hit events for contacts of a shape, or not. One of the two shapes is enough.
 * @param shapeId the shape
 * @param flag whether to do it
 */
MV_API void mvShape_EnableHitEvents(mvShapeId shapeId, bool flag);

/**
 * Are there hit events for the contacts of a shape?
 * @param shapeId the shape
 */
MV_API bool mvShape_AreHitEventsEnabled(mvShapeId shapeId);

/**
 * Cast a ray at one shape. A ray that starts inside does not hit.
 * @param shapeId the shape
 * @param origin where the ray starts [m]
 * @param translation from the start to the end of the ray [m]
 * @return the hit, in the world; no hit for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
mvWorldCastOutput mvShape_RayCast(mvShapeId shapeId,
                                  mvPos origin,
                                  mvVec3 translation);

/**
 * Get the box around a shape, in the world.
 * @param shapeId the shape
 * @return the box; zero for a bad shape
 */
MV_API mvAABB mvShape_GetAABB(mvShapeId shapeId);

/**
 * Get mass, centre of mass and inertia of a shape at its density.
 * @param shapeId the shape
 * @return the figures, in the body's frame; zero for a bad shape
 */
MV_API mvMassData mvShape_ComputeMassData(mvShapeId shapeId);

/**
 * Get the point of a shape closest to a target.
 * @param shapeId the shape
 * @param target the target, in the world [m]
 * @return the point, in the world; the target itself where that is inside; zero for bad arguments
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API mvVec3 mvShape_GetClosestPoint(mvShapeId shapeId, mvVec3 target);

/**
 * Get an upper bound for the number of a shape's touching contacts.
 * @param shapeId the shape
 */
MV_API int mvShape_GetContactCapacity(mvShapeId shapeId);

/**
 * Get the touching contacts of a shape, as of the last step.
 * @param shapeId the shape
 * @param contactData filled with the contacts; may be null
 * @param capacity the room in the array, >= 0
 * @return how many were written
 * @note Errors: mv_errorRange.
 */
MV_API int mvShape_GetContactData(mvShapeId shapeId, mvContactData *contactData, int capacity);

/**
 * Create a world. At least 4096 worlds can live at once; worlds are independent of each other.
 *
 * @param def the definition, from mvDefaultWorldDef()
 * @return the world, to be destroyed by mvDestroyWorld(); null for bad arguments
 * @note Errors: mv_errorNull, mv_errorDefinition, mv_errorNotFinite, mv_errorRange, mv_errorUnsupported,
 * mv_errorCapacity.
 */
MV_API mvWorldId mvCreateWorld(const mvWorldDef *def);

/**
 * Destroy a world with everything in it. All ids of it are stale from then on.
 *
 * @param worldId the world; a faulted one can be destroyed as well
 */
MV_API void mvDestroyWorld(mvWorldId worldId);

/**
 * Get the number of worlds that live now.
 */
MV_API int mvGetWorldCount(void);

/**
 * Get the number of bytes that the library holds: for all worlds and for hulls that callers own. A world that
 * another thread is changing counts as 0.
 */
MV_API int64_t mvGetByteCount(void);

/**
 * Does this id name a world that lives? Never fails.
 */
MV_API bool mvWorld_IsValid(mvWorldId id);

/**
 * Move the world through time.
 *
 * @param worldId the world
 * @param timeStep how far [s], >= 0; keep it the same from step to step, usually 1/60. 0 brings contacts up to
 * date and moves nothing.
 * @param subStepCount into how many sub-steps to divide it, 1 to 1000, usually 4. More is more accurate.
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
void mvWorld_Step(mvWorldId worldId,
                  mvFloat timeStep,
                  int subStepCount);

/**
 * Get the box around everything in the world that has bounds, with some room to spare; zero for an empty world.
 * @param worldId the world
 */
MV_API
mvAABB mvWorld_GetBounds(mvWorldId worldId);

/**
 * Arrange the static shapes of a world anew, after many were made. Changes no answer, only how fast it comes.
 * @param worldId the world
 */
MV_API void mvWorld_RebuildStaticTree(mvWorldId worldId);

/**
 * Set the user data of a world.
 * @param worldId the world
 * @param userData anything; it is never followed
 */
MV_API void mvWorld_SetUserData(mvWorldId worldId, void *userData);

/**
 * Get the user data of a world.
 * @param worldId the world
 * @return what was set; null for a bad world
 */
MV_API void *mvWorld_GetUserData(mvWorldId worldId);

/**
 * Set the callback that decides whether shapes may collide.
 * @param worldId the world
 * @param fcn the callback, null for none
 * @param context passed to the callback
 */
MV_API void mvWorld_SetCustomFilterCallback(mvWorldId worldId, mvCustomFilterFcn fcn, void *context);

/**
 * Set the callback that decides whether contacts act.
 * @param worldId the world
 * @param fcn the callback, null for none
 * @param context passed to the callback
 */
MV_API void mvWorld_SetPreSolveCallback(mvWorldId worldId, mvPreSolveFcn fcn, void *context);

/**
 * Set the callback that mixes friction.
 * @param worldId the world
 * @param callback the callback, null for the geometric mean
 * @param context passed to the callback
 */
MV_API void mvWorld_SetFrictionCallback(mvWorldId worldId, mvFrictionCallback callback, void *context);

/**
 * Set the callback that mixes restitution.
 * @param worldId the world
 * @param callback the callback, null for the greater one
 * @param context passed to the callback
 */
MV_API
void mvWorld_SetRestitutionCallback(mvWorldId worldId,
                                    mvRestitutionCallback callback,
                                    void *context);

/**
 * Set gravity, and wake all bodies.
 * @param worldId the world
 * @param gravity the acceleration [m/s^2]
 * @note Errors: mv_errorNotFinite.
 */
MV_API void mvWorld_SetGravity(mvWorldId worldId, mvVec3 gravity);

/**
 * Get gravity.
 * @param worldId the world
 * @return the acceleration [m/s^2]; zero for a bad world
 */
MV_API mvVec3 mvWorld_GetGravity(mvWorldId worldId);

/**
 * Let bodies fall asleep, or wake all and keep them awake.
 * @param worldId the world
 * @param flag whether bodies may sleep
 */
MV_API void mvWorld_EnableSleeping(mvWorldId worldId, bool flag);

/**
 * May bodies fall asleep?
 * @param worldId the world
 */
MV_API bool mvWorld_IsSleepingEnabled(mvWorldId worldId);

/**
 * Keep contact impulses from step to step, or not. Off is for experiments.
 * @param worldId the world
 * @param flag whether to keep them
 */
MV_API void mvWorld_EnableWarmStarting(mvWorldId worldId, bool flag);

/**
 * Are contact impulses kept from step to step?
 * @param worldId the world
 */
MV_API bool mvWorld_IsWarmStartingEnabled(mvWorldId worldId);

/**
 * Set the approach speed up to which nothing bounces.
 * @param worldId the world
 * @param value the speed [m/s], >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvWorld_SetRestitutionThreshold(mvWorldId worldId, mvFloat value);

/**
 * Get the approach speed up to which nothing bounces.
 * @param worldId the world
 * @return the speed [m/s]; 0 for a bad world
 */
MV_API mvFloat mvWorld_GetRestitutionThreshold(mvWorldId worldId);

/**
 * Set the approach speed above which collisions make hit events.
 * @param worldId the world
 * @param value the speed [m/s], >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API void mvWorld_SetHitEventThreshold(mvWorldId worldId, mvFloat value);

/**
 * Get the approach speed above which collisions make hit events.
 * @param worldId the world
 * @return the speed [m/s]; 0 for a bad world
 */
MV_API mvFloat mvWorld_GetHitEventThreshold(mvWorldId worldId);

/**
 * Set how overlap of contacts is recovered.
 * @param worldId the world
 * @param stiffness how stiff contacts are, as a fraction of the sub-step rate, > 0 and at most 0.5
 * @param dampingRatio how strongly recovery is damped, > 0; 1 is critical
 * @param contactSpeed the greatest speed at which overlap is pushed out [m/s], >= 0
 * @note Errors: mv_errorNotFinite, mv_errorRange.
 */
MV_API
void mvWorld_SetContactTuning(mvWorldId worldId,
                              mvFloat stiffness,
                              mvFloat dampingRatio,
                              mvFloat contactSpeed);

/**
 * Get how overlap of contacts is recovered.
 * @param worldId the world
 */
MV_API mvContactTuning mvWorld_GetContactTuning(mvWorldId worldId);

/**
 * Set the greatest speed of bodies.
 * @param worldId the world
 * @param maximumLinearSpeed the speed [m/s], > 0; infinity for no limit
 * @note Errors: mv_errorRange, also for NaN.
 */
MV_API void mvWorld_SetMaximumLinearSpeed(mvWorldId worldId, mvFloat maximumLinearSpeed);

/**
 * Get the greatest speed of bodies.
 * @param worldId the world
 * @return the speed [m/s], infinity for no limit; 0 for a bad world
 */
MV_API mvFloat mvWorld_GetMaximumLinearSpeed(mvWorldId worldId);

/**
 * Set the accuracy to keep: see mvWorldDef.accuracy.
 * @param worldId the world
 * @param accuracy the error that a step may add, as a share of the way gone in it, 0 to 1; 0: exactly the sub-steps asked for
 * @note Errors: mv_errorRange, mv_errorNotFinite, mv_errorUnsupported: not 0 with another solver than softStep.
 */
MV_API
void mvWorld_SetAccuracy(mvWorldId worldId,
                         mvFloat accuracy);

/**
 * Get the accuracy to keep.
 * @param worldId the world
 * @return a share of the way; 0 for none, and for a bad world
 */
MV_API mvFloat mvWorld_GetAccuracy(mvWorldId worldId);

/**
 * Get the number of bodies that the next step moves.
 * @param worldId the world
 */
MV_API int mvWorld_GetAwakeBodyCount(mvWorldId worldId);

/**
 * Set the number of threads that step the world. Only 1 is built yet.
 * @param worldId the world
 * @param count the number of threads
 * @note Errors: mv_errorRange below 1, mv_errorUnsupported above.
 */
MV_API void mvWorld_SetWorkerCount(mvWorldId worldId, int count);

/**
 * Get the number of threads that step the world.
 * @param worldId the world
 */
MV_API int mvWorld_GetWorkerCount(mvWorldId worldId);

/**
 * Get how long the last step took, by stage.
 * @param worldId the world
 */
MV_API mvProfile mvWorld_GetProfile(mvWorldId worldId);

/**
 * Get how much there is of everything.
 * @param worldId the world
 */
MV_API mvCounters mvWorld_GetCounters(mvWorldId worldId);

/**
 * Get conserved quantities and errors. This measures the world as it is now, at about the cost of finding all
 * contact points.
 * @param worldId the world
 */
MV_API mvStepReport mvWorld_GetStepReport(mvWorldId worldId);

/**
 * Get a hash of the state of all bodies and contacts: placements, momenta, impulses and sleep. Two worlds that
 * were made and stepped in the same way have the same hash, on every platform.
 * @param worldId the world
 */
MV_API
uint64_t mvWorld_GetStateHash(mvWorldId worldId);

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

#endif /* MEREV_H */
