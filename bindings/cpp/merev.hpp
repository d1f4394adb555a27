// SPDX-License-Identifier: MIT OR Apache-2.0
//
// merev from C++17: one header over merev.h, without exceptions or RTTI, at no cost over the C calls.
//
// Names follow one rule: mvBody_GetPosition(body) is body.getPosition(), mvCreateBody(world, &def) is
// world.createBody(def), and likewise for worlds, shapes and every kind of joint. What a function does, its units and its
// errors stand at the C function in merev.h.
//
//   World      owns a world and destroys it; WorldRef, Body, Shape, Joint, RevoluteJoint ... are ids with methods. They
//              are copied freely, and using one whose object is gone is an error, never a crash.
//   BodyDef    is the C struct filled with its defaults; so are all other definitions.
//   Span       is an array of the library (events) or of the caller (buffers).
//   Callbacks  are anything that can be called. They must not throw.
//   Errors     work as in C: a call that fails changes nothing and returns a neutral value. lastError() tells why, and
//              attempt([&] { ... }) gives a value together with the error.
//
// A library whose binary interface or precision is another than this header's is refused: no world is made, and
// lastError() says so.
//
// This file is generated from merev.h and merev.hpp.in by `cargo xtask header`; do not edit it.
#ifndef MEREV_HPP
#define MEREV_HPP

#include "merev.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <type_traits>
#include <utility>

namespace merev {

using Float = mvFloat;
using Vec2 = mvVec2;
using Vec3 = mvVec3;
using Pos = mvPos;
using Quat = mvQuat;
using Transform = mvTransform;
using WorldTransform = mvWorldTransform;
using Matrix3 = mvMatrix3;
using AABB = mvAABB;
using Plane = mvPlane;
using Filter = mvFilter;
using QueryFilter = mvQueryFilter;
using SurfaceMaterial = mvSurfaceMaterial;
using MassData = mvMassData;
using MotionLocks = mvMotionLocks;
using Sphere = mvSphere;
using Capsule = mvCapsule;
using HullData = mvHullData;
using BoxHull = mvBoxHull;
using ShapeProxy = mvShapeProxy;
using ContactData = mvContactData;
using RayResult = mvRayResult;
using SixDofAxis = mvSixDofAxis;
using StepReport = mvStepReport;
using Profile = mvProfile;
using Counters = mvCounters;
using ContactTuning = mvContactTuning;
using TreeStats = mvTreeStats;
using BodyMoveEvent = mvBodyMoveEvent;
using ContactBeginTouchEvent = mvContactBeginTouchEvent;
using ContactEndTouchEvent = mvContactEndTouchEvent;
using ContactHitEvent = mvContactHitEvent;
using JointEvent = mvJointEvent;

// Errors -----------------------------------------------------------------------------------------------------------

/// What went wrong, if anything.
struct Error {
    /// mv_errorNone, or one of the numbered errors of merev.h.
    mvErrorCode code = mv_errorNone;
    /// The sentence, valid until the next failure on this thread.
    const char* message = "";
    /// Whether there is an error.
    explicit operator bool() const noexcept { return code != mv_errorNone; }
};

/// Why this header cannot use the library that was loaded; null if it can.
inline const char* whyUnfit() noexcept {
    struct Verdict {
        char text[256] = "";
        bool fits = true;
        Verdict() noexcept {
            const bool isDouble = sizeof(Float) == sizeof(double);
            fits = mvGetAbiRevision() == MV_ABI_REVISION && mvIsDoublePrecision() == isDouble;
            const auto precision = [](bool twice) { return twice ? "double" : "single"; };
            std::snprintf(text, sizeof text,
                          "merev.hpp was compiled for binary interface %d in %s precision, but the library that was loaded has "
                          "%d in %s precision: use header and library of one installation.",
                          static_cast<int>(MV_ABI_REVISION), precision(isDouble), static_cast<int>(mvGetAbiRevision()),
                          precision(mvIsDoublePrecision()));
        }
    };
    static const Verdict verdict;
    return verdict.fits ? nullptr : verdict.text;
}

/// The latest failure of this thread; asking clears it.
inline Error lastError() noexcept {
    if (const char* why = whyUnfit()) return {mv_errorUnsupported, why};
    const mvErrorCode code = mvGetLastError();
    return code == mv_errorNone ? Error{} : Error{code, mvGetLastErrorMessage()};
}

/// A value and the error that came with it.
template <class T> struct Result {
    T value;
    Error error;
    /// Whether there is no error.
    explicit operator bool() const noexcept { return !error; }
};

/// Calls a function of no arguments and tells how it went: a Result, or just an Error if it returns nothing.
template <class F> auto attempt(F&& f) {
    static_cast<void>(mvGetLastError());
    if constexpr (std::is_void_v<decltype(f())>) {
        f();
        return lastError();
    } else {
        auto value = f();
        return Result<decltype(value)>{std::move(value), lastError()};
    }
}

// Arrays -----------------------------------------------------------------------------------------------------------

/// Elements that lie side by side and belong to someone else.
template <class T> class Span {
public:
    constexpr Span() noexcept = default;
    constexpr Span(T* data, int size) noexcept : data_(data), size_(size) {}
    template <std::size_t N> constexpr Span(T (&array)[N]) noexcept : data_(array), size_(static_cast<int>(N)) {}
    /// From std::vector, std::array and their like.
    template <class C, class = decltype(static_cast<T*>(std::declval<C&>().data())),
              class = decltype(std::declval<C&>().size())>
    constexpr Span(C&& c) noexcept : data_(c.data()), size_(static_cast<int>(c.size())) {}

    constexpr T* data() const noexcept { return data_; }
    constexpr int size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr T* begin() const noexcept { return data_; }
    constexpr T* end() const noexcept { return data_ + size_; }
    constexpr T& operator[](int k) const noexcept { return data_[k]; }

private:
    T* data_ = nullptr;
    int size_ = 0;
};

// Ids --------------------------------------------------------------------------------------------------------------

inline std::uint64_t pack(mvWorldId id) noexcept { return mvStoreWorldId(id); }
inline std::uint64_t pack(mvBodyId id) noexcept { return mvStoreBodyId(id); }
inline std::uint64_t pack(mvShapeId id) noexcept { return mvStoreShapeId(id); }
inline std::uint64_t pack(mvJointId id) noexcept { return mvStoreJointId(id); }

/// A C id as a type of its own: null by default, comparable, convertible from and to the C id.
template <class C> class Id {
public:
    constexpr Id() noexcept : id_{} {}
    constexpr Id(C id) noexcept : id_(id) {}
    constexpr operator C() const noexcept { return id_; }
    constexpr C id() const noexcept { return id_; }
    /// Whether it is not null. isValid() asks whether the object is still there.
    explicit constexpr operator bool() const noexcept { return id_.index1 != 0; }
    friend bool operator==(Id a, Id b) noexcept { return pack(a.id_) == pack(b.id_); }
    friend bool operator!=(Id a, Id b) noexcept { return pack(a.id_) != pack(b.id_); }
    friend bool operator<(Id a, Id b) noexcept { return pack(a.id_) < pack(b.id_); }

private:
    C id_;
};

using WorldId = Id<mvWorldId>;
using BodyId = Id<mvBodyId>;
using ShapeId = Id<mvShapeId>;
using JointId = Id<mvJointId>;

/// For std::unordered_map<Body, T, merev::Hash>.
struct Hash {
    template <class C> std::size_t operator()(Id<C> id) const noexcept {
        return static_cast<std::size_t>(pack(id.id()) * 0x9e3779b97f4a7c15u >> 16);
    }
};

// Definitions ------------------------------------------------------------------------------------------------------

/// A definition with its defaults. Left without its mark, and so refused everywhere, if the library does not fit.
template <class C, C (*Default)()> struct Def : C {
    Def() noexcept : C(whyUnfit() ? C{} : Default()) {}
};

using WorldDef = Def<mvWorldDef, mvDefaultWorldDef>;
using BodyDef = Def<mvBodyDef, mvDefaultBodyDef>;
using ShapeDef = Def<mvShapeDef, mvDefaultShapeDef>;
using HumanDef = Def<mvHumanDef, mvDefaultHumanDef>;
using DebugDraw = Def<mvDebugDraw, mvDefaultDebugDraw>;
using DistanceJointDef = Def<mvDistanceJointDef, mvDefaultDistanceJointDef>;
using FilterJointDef = Def<mvFilterJointDef, mvDefaultFilterJointDef>;
using GearJointDef = Def<mvGearJointDef, mvDefaultGearJointDef>;
using MotorJointDef = Def<mvMotorJointDef, mvDefaultMotorJointDef>;
using ParallelJointDef = Def<mvParallelJointDef, mvDefaultParallelJointDef>;
using PrismaticJointDef = Def<mvPrismaticJointDef, mvDefaultPrismaticJointDef>;
using PulleyJointDef = Def<mvPulleyJointDef, mvDefaultPulleyJointDef>;
using RackPinionJointDef = Def<mvRackPinionJointDef, mvDefaultRackPinionJointDef>;
using RevoluteJointDef = Def<mvRevoluteJointDef, mvDefaultRevoluteJointDef>;
using ScrewJointDef = Def<mvScrewJointDef, mvDefaultScrewJointDef>;
using SixDofJointDef = Def<mvSixDofJointDef, mvDefaultSixDofJointDef>;
using SphericalJointDef = Def<mvSphericalJointDef, mvDefaultSphericalJointDef>;
using UniversalJointDef = Def<mvUniversalJointDef, mvDefaultUniversalJointDef>;
using WeldJointDef = Def<mvWeldJointDef, mvDefaultWeldJointDef>;
using WheelJointDef = Def<mvWheelJointDef, mvDefaultWheelJointDef>;

// Objects ----------------------------------------------------------------------------------------------------------

class WorldRef;
class Shape;
class Joint;

/// A convex hull that is freed with its owner. Shapes copy what they need of it.
class Hull {
public:
    Hull() noexcept = default;
    explicit Hull(HullData* data) noexcept : data_(data) {}
    /// Around points, of at most so many vertices.
    explicit Hull(Span<const Vec3> points, int maxVertexCount = MV_MAX_HULL_VERTICES) noexcept
        : data_(whyUnfit() ? nullptr : mvCreateHull(points.data(), points.size(), maxVertexCount)) {}
    Hull(Hull&& other) noexcept : data_(other.release()) {}
    Hull& operator=(Hull&& other) noexcept {
        std::swap(data_, other.data_);
        return *this;
    }
    ~Hull() {
        if (data_) mvDestroyHull(data_);
    }
    operator const HullData*() const noexcept { return data_; }
    const HullData* get() const noexcept { return data_; }
    HullData* release() noexcept { return std::exchange(data_, nullptr); }
    explicit operator bool() const noexcept { return data_ != nullptr; }

private:
    HullData* data_ = nullptr;
};

/// A body of a world.
class Body : public BodyId {
public:
    using BodyId::BodyId;
    /// Destroy it, its shapes and its joints.
    void destroy() const noexcept { mvDestroyBody(id()); }
    WorldRef getWorld() const noexcept;

    Shape createSphereShape(const ShapeDef& def, const Sphere& sphere) const noexcept;
    Shape createSphereShape(const Sphere& sphere) const noexcept;
    Shape createCapsuleShape(const ShapeDef& def, const Capsule& capsule) const noexcept;
    Shape createCapsuleShape(const Capsule& capsule) const noexcept;
    /// Half the widths along the body's axes [m].
    Shape createBoxShape(const ShapeDef& def, Float hx, Float hy, Float hz) const noexcept;
    Shape createBoxShape(Float hx, Float hy, Float hz) const noexcept;
    /// From a Hull, or from &boxHull.base.
    Shape createHullShape(const ShapeDef& def, const HullData* hull) const noexcept;
    Shape createHullShape(const HullData* hull) const noexcept;
    Shape createTransformedHullShape(const ShapeDef& def, const HullData* hull, Transform transform, Vec3 scale) const noexcept;
    Shape createPlaneShape(const ShapeDef& def, const Plane& plane) const noexcept;
    Shape createPlaneShape(const Plane& plane) const noexcept;

    /// Does this id name a body that lives? Never fails; false also while another thread changes the world.
    bool isValid() const noexcept { return mvBody_IsValid(id()); }
    /// Get how a body moves.
    mvBodyType getType() const noexcept { return mvBody_GetType(id()); }
    /// Change how a body moves.
    void setType(mvBodyType type) const noexcept { mvBody_SetType(id(), type); }
    /// Set the name of a body.
    void setName(const char* name) const noexcept { mvBody_SetName(id(), name); }
    /// Get the name of a body.
    const char* getName() const noexcept { return mvBody_GetName(id()); }
    /// Set the user data of a body.
    void setUserData(void* userData) const noexcept { mvBody_SetUserData(id(), userData); }
    /// Get the user data of a body.
    void* getUserData() const noexcept { return mvBody_GetUserData(id()); }
    /// Does the next step move this body?
    bool isAwake() const noexcept { return mvBody_IsAwake(id()); }
    /// Wake a body and what it touches, or put them to sleep, whatever their speed.
    void setAwake(bool awake) const noexcept { mvBody_SetAwake(id(), awake); }
    /// Let a body fall asleep, or wake it and keep it awake.
    void enableSleep(bool enableSleep) const noexcept { mvBody_EnableSleep(id(), enableSleep); }
    /// May this body fall asleep?
    bool isSleepEnabled() const noexcept { return mvBody_IsSleepEnabled(id()); }
    /// Set the speed below which a body may fall asleep.
    void setSleepThreshold(Float sleepThreshold) const noexcept { mvBody_SetSleepThreshold(id(), sleepThreshold); }
    /// Get the speed below which a body may fall asleep.
    Float getSleepThreshold() const noexcept { return mvBody_GetSleepThreshold(id()); }
    /// Get the sub-steps that the next step takes for a body: those of the last step, or more where the world has an accuracy to keep, see mvWorldDef.accuracy.
    int getSubStepCount() const noexcept { return mvBody_GetSubStepCount(id()); }
    /// Does this body take part in the world?
    bool isEnabled() const noexcept { return mvBody_IsEnabled(id()); }
    /// Take a body out of the world, keeping its state.
    void disable() const noexcept { mvBody_Disable(id()); }
    /// Put a body back into the world, awake.
    void enable() const noexcept { mvBody_Enable(id()); }
    /// Set the directions in which a body cannot move; its velocity along them becomes 0.
    void setMotionLocks(MotionLocks locks) const noexcept { mvBody_SetMotionLocks(id(), locks); }
    /// Get the directions in which a body cannot move.
    MotionLocks getMotionLocks() const noexcept { return mvBody_GetMotionLocks(id()); }
    /// Make hit events for contacts of all shapes that a body has now, or not.
    void enableHitEvents(bool flag) const noexcept { mvBody_EnableHitEvents(id(), flag); }
    /// Get the number of shapes of a body.
    int getShapeCount() const noexcept { return mvBody_GetShapeCount(id()); }
    /// Get the shapes of a body, in the order in which they were made.
    int getShapes(Span<mvShapeId> shapeArray) const noexcept {
        return mvBody_GetShapes(id(), shapeArray.data(), shapeArray.size());
    }
    /// Get the number of joints of a body.
    int getJointCount() const noexcept { return mvBody_GetJointCount(id()); }
    /// Get the joints of a body, in no particular order.
    int getJoints(Span<mvJointId> jointArray) const noexcept {
        return mvBody_GetJoints(id(), jointArray.data(), jointArray.size());
    }
    /// Get the box around all shapes of a body; around its origin when it has none.
    AABB computeAABB() const noexcept { return mvBody_ComputeAABB(id()); }
    /// Get an upper bound for the number of a body's touching contacts.
    int getContactCapacity() const noexcept { return mvBody_GetContactCapacity(id()); }
    /// Get the touching contacts of a body, as of the last step.
    int getContactData(Span<ContactData> contactData) const noexcept {
        return mvBody_GetContactData(id(), contactData.data(), contactData.size());
    }
    /// Get the mass of a body.
    Float getMass() const noexcept { return mvBody_GetMass(id()); }
    /// Get one divided by the mass of a body.
    Float getInverseMass() const noexcept { return mvBody_GetInverseMass(id()); }
    /// Get the inertia of a body about its centre of mass, in the axes of the body.
    Matrix3 getLocalRotationalInertia() const noexcept { return mvBody_GetLocalRotationalInertia(id()); }
    /// Get the inverse of the inertia of a body about its centre of mass, in world axes.
    Matrix3 getWorldInverseRotationalInertia() const noexcept { return mvBody_GetWorldInverseRotationalInertia(id()); }
    /// Get the centre of mass of a body, in the body's frame.
    Vec3 getLocalCenter() const noexcept { return mvBody_GetLocalCenter(id()); }
    /// Get the centre of mass of a body, in the world.
    Pos getWorldCenter() const noexcept { return mvBody_GetWorldCenter(id()); }
    /// Give a dynamic body a mass of its own.
    void setMassData(MassData massData) const noexcept { mvBody_SetMassData(id(), massData); }
    /// Get mass, centre of mass and inertia of a body.
    MassData getMassData() const noexcept { return mvBody_GetMassData(id()); }
    /// Make the mass of a body that of its shapes: after mvBody_SetMassData(), or after shapes were made, changed or destroyed without updating it.
    void applyMassFromShapes() const noexcept { mvBody_ApplyMassFromShapes(id()); }
    /// Set the fraction of a body's velocity lost per second, for small values.
    void setLinearDamping(Float linearDamping) const noexcept { mvBody_SetLinearDamping(id(), linearDamping); }
    /// Get the fraction of a body's velocity lost per second, for small values.
    Float getLinearDamping() const noexcept { return mvBody_GetLinearDamping(id()); }
    /// Set the fraction of a body's angular velocity lost per second, for small values.
    void setAngularDamping(Float angularDamping) const noexcept { mvBody_SetAngularDamping(id(), angularDamping); }
    /// Get the fraction of a body's angular velocity lost per second, for small values.
    Float getAngularDamping() const noexcept { return mvBody_GetAngularDamping(id()); }
    /// Set the factor on gravity of a body.
    void setGravityScale(Float gravityScale) const noexcept { mvBody_SetGravityScale(id(), gravityScale); }
    /// Get the factor on gravity of a body.
    Float getGravityScale() const noexcept { return mvBody_GetGravityScale(id()); }
    /// Get the position of a body's origin.
    Pos getPosition() const noexcept { return mvBody_GetPosition(id()); }
    /// Get the rotation of a body.
    Quat getRotation() const noexcept { return mvBody_GetRotation(id()); }
    /// Get where a body is: the position of its origin, and its rotation.
    WorldTransform getTransform() const noexcept { return mvBody_GetTransform(id()); }
    /// Move a body at once, without regard for what is in the way.
    void setTransform(Pos position, Quat rotation) const noexcept { mvBody_SetTransform(id(), position, rotation); }
    /// Give a body the velocity that takes it to a placement in a given time.
    void setTargetTransform(WorldTransform target, Float timeStep, bool wake) const noexcept {
        mvBody_SetTargetTransform(id(), target, timeStep, wake);
    }
    /// Get a point of the world as seen from a body.
    Vec3 getLocalPoint(Pos worldPoint) const noexcept { return mvBody_GetLocalPoint(id(), worldPoint); }
    /// Get a point of a body as seen from the world.
    Pos getWorldPoint(Vec3 localPoint) const noexcept { return mvBody_GetWorldPoint(id(), localPoint); }
    /// Get a vector of the world as seen from a body.
    Vec3 getLocalVector(Vec3 worldVector) const noexcept { return mvBody_GetLocalVector(id(), worldVector); }
    /// Get a vector of a body as seen from the world.
    Vec3 getWorldVector(Vec3 localVector) const noexcept { return mvBody_GetWorldVector(id(), localVector); }
    /// Get the velocity of a point of a body.
    Vec3 getLocalPointVelocity(Vec3 localPoint) const noexcept {
        return mvBody_GetLocalPointVelocity(id(), localPoint);
    }
    /// Get the velocity of the point of a body that is at a point of the world.
    Vec3 getWorldPointVelocity(Pos worldPoint) const noexcept { return mvBody_GetWorldPointVelocity(id(), worldPoint); }
    /// Get the velocity of a body's centre of mass.
    Vec3 getLinearVelocity() const noexcept { return mvBody_GetLinearVelocity(id()); }
    /// Set the velocity of a body's centre of mass.
    void setLinearVelocity(Vec3 linearVelocity) const noexcept { mvBody_SetLinearVelocity(id(), linearVelocity); }
    /// Get the angular velocity of a body.
    Vec3 getAngularVelocity() const noexcept { return mvBody_GetAngularVelocity(id()); }
    /// Set the angular velocity of a body.
    void setAngularVelocity(Vec3 angularVelocity) const noexcept { mvBody_SetAngularVelocity(id(), angularVelocity); }
    /// Get the momentum of a body.
    Vec3 getMomentum() const noexcept { return mvBody_GetMomentum(id()); }
    /// Set the momentum of a body.
    void setMomentum(Vec3 momentum) const noexcept { mvBody_SetMomentum(id(), momentum); }
    /// Get the angular momentum of a body about its centre of mass.
    Vec3 getAngularMomentum() const noexcept { return mvBody_GetAngularMomentum(id()); }
    /// Set the angular momentum of a body about its centre of mass.
    void setAngularMomentum(Vec3 angularMomentum) const noexcept { mvBody_SetAngularMomentum(id(), angularMomentum); }
    /// Get the energy of a body's translation and rotation.
    Float getKineticEnergy() const noexcept { return mvBody_GetKineticEnergy(id()); }
    /// Add a force for the next step.
    void applyForce(Vec3 force, Pos point, bool wake) const noexcept { mvBody_ApplyForce(id(), force, point, wake); }
    /// Add a force at the centre of mass for the next step.
    void applyForceToCenter(Vec3 force, bool wake) const noexcept { mvBody_ApplyForceToCenter(id(), force, wake); }
    /// Add a torque for the next step.
    void applyTorque(Vec3 torque, bool wake) const noexcept { mvBody_ApplyTorque(id(), torque, wake); }
    /// Change the momentum of a body at once.
    void applyLinearImpulse(Vec3 impulse, Pos point, bool wake) const noexcept {
        mvBody_ApplyLinearImpulse(id(), impulse, point, wake);
    }
    /// Change the momentum of a body at once, at its centre of mass.
    void applyLinearImpulseToCenter(Vec3 impulse, bool wake) const noexcept {
        mvBody_ApplyLinearImpulseToCenter(id(), impulse, wake);
    }
    /// Change the angular momentum of a body at once.
    void applyAngularImpulse(Vec3 impulse, bool wake) const noexcept {
        mvBody_ApplyAngularImpulse(id(), impulse, wake);
    }
    /// Get the point of a body's shapes closest to a target.
    Float getClosestPoint(Vec3* result, Vec3 target) const noexcept {
        return mvBody_GetClosestPoint(id(), result, target);
    }
    /// Cast a ray at a body as if it were somewhere.
    mvBodyCastResult castRay(Pos origin, Vec3 translation, QueryFilter filter, Float maxFraction,
            WorldTransform bodyTransform) const noexcept {
        return mvBody_CastRay(id(), origin, translation, filter, maxFraction, bodyTransform);
    }
    /// Move a solid against a body as if that were somewhere.
    mvBodyCastResult castShape(Pos origin, const ShapeProxy& proxy, Vec3 translation, QueryFilter filter,
            Float maxFraction, bool canEncroach, WorldTransform bodyTransform) const noexcept {
        return mvBody_CastShape(id(), origin, &proxy, translation, filter, maxFraction, canEncroach, bodyTransform);
    }
    /// Does a solid touch or overlap a body as if that were somewhere?
    bool overlapShape(Pos origin, const ShapeProxy& proxy, QueryFilter filter,
            WorldTransform bodyTransform) const noexcept {
        return mvBody_OverlapShape(id(), origin, &proxy, filter, bodyTransform);
    }
};

/// A shape of a body.
class Shape : public ShapeId {
public:
    using ShapeId::ShapeId;
    void destroy(bool updateBodyMass = true) const noexcept { mvDestroyShape(id(), updateBodyMass); }
    WorldRef getWorld() const noexcept;

    /// Does this id name a shape that lives? Never fails; false also while another thread changes the world.
    bool isValid() const noexcept { return mvShape_IsValid(id()); }
    /// Get what a shape is.
    mvShapeType getType() const noexcept { return mvShape_GetType(id()); }
    /// Get the body that a shape is attached to.
    Body getBody() const noexcept { return mvShape_GetBody(id()); }
    /// Set the name of a shape.
    void setName(const char* name) const noexcept { mvShape_SetName(id(), name); }
    /// Get the name of a shape.
    const char* getName() const noexcept { return mvShape_GetName(id()); }
    /// Set the user data of a shape.
    void setUserData(void* userData) const noexcept { mvShape_SetUserData(id(), userData); }
    /// Get the user data of a shape.
    void* getUserData() const noexcept { return mvShape_GetUserData(id()); }
    /// Get the sphere of a shape.
    Sphere getSphere() const noexcept { return mvShape_GetSphere(id()); }
    /// Get the capsule of a shape.
    Capsule getCapsule() const noexcept { return mvShape_GetCapsule(id()); }
    /// Get the hull of a shape.
    const HullData* getHull() const noexcept { return mvShape_GetHull(id()); }
    /// Get the plane of a shape.
    Plane getPlane() const noexcept { return mvShape_GetPlane(id()); }
    /// Make a shape a sphere.
    void setSphere(const Sphere& sphere) const noexcept { mvShape_SetSphere(id(), &sphere); }
    /// Make a shape a capsule.
    void setCapsule(const Capsule& capsule) const noexcept { mvShape_SetCapsule(id(), &capsule); }
    /// Make a shape a hull.
    void setHull(const HullData& hull) const noexcept { mvShape_SetHull(id(), &hull); }
    /// Set the density of a shape.
    void setDensity(Float density, bool updateBodyMass) const noexcept {
        mvShape_SetDensity(id(), density, updateBodyMass);
    }
    /// Get the density of a shape.
    Float getDensity() const noexcept { return mvShape_GetDensity(id()); }
    /// Set the coefficient of sliding friction of a shape.
    void setFriction(Float friction) const noexcept { mvShape_SetFriction(id(), friction); }
    /// Get the coefficient of sliding friction of a shape.
    Float getFriction() const noexcept { return mvShape_GetFriction(id()); }
    /// Set the coefficient of static friction of a shape.
    void setStaticFriction(Float staticFriction) const noexcept { mvShape_SetStaticFriction(id(), staticFriction); }
    /// Get the coefficient of static friction of a shape.
    Float getStaticFriction() const noexcept { return mvShape_GetStaticFriction(id()); }
    /// Set the coefficient of restitution of a shape.
    void setRestitution(Float restitution) const noexcept { mvShape_SetRestitution(id(), restitution); }
    /// Get the coefficient of restitution of a shape.
    Float getRestitution() const noexcept { return mvShape_GetRestitution(id()); }
    /// Set the surface of a shape.
    void setSurfaceMaterial(SurfaceMaterial surfaceMaterial) const noexcept {
        mvShape_SetSurfaceMaterial(id(), surfaceMaterial);
    }
    /// Get the surface of a shape.
    SurfaceMaterial getSurfaceMaterial() const noexcept { return mvShape_GetSurfaceMaterial(id()); }
    /// Get what a shape collides with.
    Filter getFilter() const noexcept { return mvShape_GetFilter(id()); }
    /// Set what a shape collides with.
    void setFilter(Filter filter, bool invokeContacts) const noexcept {
        mvShape_SetFilter(id(), filter, invokeContacts);
    }
    /// Make begin and end events for contacts of a shape, or not.
    void enableContactEvents(bool flag) const noexcept { mvShape_EnableContactEvents(id(), flag); }
    /// Are there begin and end events for the contacts of a shape?
    bool areContactEventsEnabled() const noexcept { return mvShape_AreContactEventsEnabled(id()); }
    /// Ask the pre-solve callback about contacts of a shape, or not.
    void enablePreSolveEvents(bool flag) const noexcept { mvShape_EnablePreSolveEvents(id(), flag); }
    /// Is the pre-solve callback asked about contacts of a shape?
    bool arePreSolveEventsEnabled() const noexcept { return mvShape_ArePreSolveEventsEnabled(id()); }
    /// Make hit events for contacts of a shape, or not.
    void enableHitEvents(bool flag) const noexcept { mvShape_EnableHitEvents(id(), flag); }
    /// Are there hit events for the contacts of a shape?
    bool areHitEventsEnabled() const noexcept { return mvShape_AreHitEventsEnabled(id()); }
    /// Cast a ray at one shape.
    mvWorldCastOutput rayCast(Pos origin, Vec3 translation) const noexcept {
        return mvShape_RayCast(id(), origin, translation);
    }
    /// Get the box around a shape, in the world.
    AABB getAABB() const noexcept { return mvShape_GetAABB(id()); }
    /// Get mass, centre of mass and inertia of a shape at its density.
    MassData computeMassData() const noexcept { return mvShape_ComputeMassData(id()); }
    /// Get the point of a shape closest to a target.
    Vec3 getClosestPoint(Vec3 target) const noexcept { return mvShape_GetClosestPoint(id(), target); }
    /// Get an upper bound for the number of a shape's touching contacts.
    int getContactCapacity() const noexcept { return mvShape_GetContactCapacity(id()); }
    /// Get the touching contacts of a shape, as of the last step.
    int getContactData(Span<ContactData> contactData) const noexcept {
        return mvShape_GetContactData(id(), contactData.data(), contactData.size());
    }
};

/// A joint of any kind.
class Joint : public JointId {
public:
    using JointId::JointId;
    void destroy(bool wakeAttached = true) const noexcept { mvDestroyJoint(id(), wakeAttached); }
    WorldRef getWorld() const noexcept;

    /// Does this id name a joint that lives? Never fails; false also while another thread changes the world.
    bool isValid() const noexcept { return mvJoint_IsValid(id()); }
    /// Get what a joint is.
    mvJointType getType() const noexcept { return mvJoint_GetType(id()); }
    /// Get the first body of a joint.
    Body getBodyA() const noexcept { return mvJoint_GetBodyA(id()); }
    /// Get the second body of a joint.
    Body getBodyB() const noexcept { return mvJoint_GetBodyB(id()); }
    /// Move frame A of a joint in body A.
    void setLocalFrameA(Transform localFrame) const noexcept { mvJoint_SetLocalFrameA(id(), localFrame); }
    /// Get frame A of a joint.
    Transform getLocalFrameA() const noexcept { return mvJoint_GetLocalFrameA(id()); }
    /// Move frame B of a joint in body B.
    void setLocalFrameB(Transform localFrame) const noexcept { mvJoint_SetLocalFrameB(id(), localFrame); }
    /// Get frame B of a joint.
    Transform getLocalFrameB() const noexcept { return mvJoint_GetLocalFrameB(id()); }
    /// Let the bodies of a joint collide with each other, or not.
    void setCollideConnected(bool shouldCollide) const noexcept { mvJoint_SetCollideConnected(id(), shouldCollide); }
    /// Do the bodies of a joint collide with each other?
    bool getCollideConnected() const noexcept { return mvJoint_GetCollideConnected(id()); }
    /// Set the user data of a joint.
    void setUserData(void* userData) const noexcept { mvJoint_SetUserData(id(), userData); }
    /// Get the user data of a joint.
    void* getUserData() const noexcept { return mvJoint_GetUserData(id()); }
    /// Wake the bodies of a joint.
    void wakeBodies() const noexcept { mvJoint_WakeBodies(id()); }
    /// Get the force of a joint on body B; body A has the opposite.
    Vec3 getConstraintForce() const noexcept { return mvJoint_GetConstraintForce(id()); }
    /// Get the torque of a joint on body B, about the origin of frame B.
    Vec3 getConstraintTorque() const noexcept { return mvJoint_GetConstraintTorque(id()); }
    /// Get by how much a joint fails to hold lengths.
    Float getLinearSeparation() const noexcept { return mvJoint_GetLinearSeparation(id()); }
    /// Get by how much a joint fails to hold angles.
    Float getAngularSeparation() const noexcept { return mvJoint_GetAngularSeparation(id()); }
    /// Set how stiffly a joint holds what it holds.
    void setConstraintTuning(Float hertz, Float dampingRatio) const noexcept {
        mvJoint_SetConstraintTuning(id(), hertz, dampingRatio);
    }
    /// Get how stiffly a joint holds what it holds.
    void getConstraintTuning(Float* hertz, Float* dampingRatio) const noexcept {
        mvJoint_GetConstraintTuning(id(), hertz, dampingRatio);
    }
    /// Set the force above which a joint makes an event.
    void setForceThreshold(Float threshold) const noexcept { mvJoint_SetForceThreshold(id(), threshold); }
    /// Get the force above which a joint makes an event.
    Float getForceThreshold() const noexcept { return mvJoint_GetForceThreshold(id()); }
    /// Set the torque above which a joint makes an event.
    void setTorqueThreshold(Float threshold) const noexcept { mvJoint_SetTorqueThreshold(id(), threshold); }
    /// Get the torque above which a joint makes an event.
    Float getTorqueThreshold() const noexcept { return mvJoint_GetTorqueThreshold(id()); }
    /// Let a joint break at the end of a step in which it made an event, or not.
    void setBreakable(bool flag) const noexcept { mvJoint_SetBreakable(id(), flag); }
    /// Does a joint break where it makes an event?
    bool isBreakable() const noexcept { return mvJoint_IsBreakable(id()); }
    /// Get the size of a joint in drawings.
    Float getDrawScale() const noexcept { return mvJoint_GetDrawScale(id()); }
};

class DistanceJoint : public Joint {
public:
    using Joint::Joint;

    /// Set the length of the rod, or at which the spring rests.
    void setLength(Float length) const noexcept { mvDistanceJoint_SetLength(id(), length); }
    /// Get the length of the rod, or at which the spring rests.
    Float getLength() const noexcept { return mvDistanceJoint_GetLength(id()); }
    /// Turn the spring on or off.
    void enableSpring(bool flag) const noexcept { mvDistanceJoint_EnableSpring(id(), flag); }
    /// Is the spring on?
    bool isSpringEnabled() const noexcept { return mvDistanceJoint_IsSpringEnabled(id()); }
    /// Set the bounds of the force of the spring, which is positive where it pushes.
    void setSpringForceRange(Float lowerForce, Float upperForce) const noexcept {
        mvDistanceJoint_SetSpringForceRange(id(), lowerForce, upperForce);
    }
    /// Get the bounds of the force of the spring.
    void getSpringForceRange(Float* lowerForce, Float* upperForce) const noexcept {
        mvDistanceJoint_GetSpringForceRange(id(), lowerForce, upperForce);
    }
    /// Set the frequency of the spring.
    void setSpringHertz(Float hertz) const noexcept { mvDistanceJoint_SetSpringHertz(id(), hertz); }
    /// Get the frequency of the spring.
    Float getSpringHertz() const noexcept { return mvDistanceJoint_GetSpringHertz(id()); }
    /// Set the damping ratio of the spring.
    void setSpringDampingRatio(Float dampingRatio) const noexcept {
        mvDistanceJoint_SetSpringDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring.
    Float getSpringDampingRatio() const noexcept { return mvDistanceJoint_GetSpringDampingRatio(id()); }
    /// Turn the limit on or off.
    void enableLimit(bool flag) const noexcept { mvDistanceJoint_EnableLimit(id(), flag); }
    /// Is the limit on?
    bool isLimitEnabled() const noexcept { return mvDistanceJoint_IsLimitEnabled(id()); }
    /// Set the limits of the length.
    void setLengthRange(Float minLength, Float maxLength) const noexcept {
        mvDistanceJoint_SetLengthRange(id(), minLength, maxLength);
    }
    /// Get the limits of the length: the least.
    Float getMinLength() const noexcept { return mvDistanceJoint_GetMinLength(id()); }
    /// Get the limits of the length: the greatest.
    Float getMaxLength() const noexcept { return mvDistanceJoint_GetMaxLength(id()); }
    /// Get the distance of the origins of the frames.
    Float getCurrentLength() const noexcept { return mvDistanceJoint_GetCurrentLength(id()); }
    /// Turn the motor on or off.
    void enableMotor(bool flag) const noexcept { mvDistanceJoint_EnableMotor(id(), flag); }
    /// Is the motor on?
    bool isMotorEnabled() const noexcept { return mvDistanceJoint_IsMotorEnabled(id()); }
    /// Set the speed at which the motor wants the length to grow.
    void setMotorSpeed(Float motorSpeed) const noexcept { mvDistanceJoint_SetMotorSpeed(id(), motorSpeed); }
    /// Get the speed at which the motor wants the length to grow.
    Float getMotorSpeed() const noexcept { return mvDistanceJoint_GetMotorSpeed(id()); }
    /// Set the greatest force of the motor.
    void setMaxMotorForce(Float force) const noexcept { mvDistanceJoint_SetMaxMotorForce(id(), force); }
    /// Get the greatest force of the motor.
    Float getMaxMotorForce() const noexcept { return mvDistanceJoint_GetMaxMotorForce(id()); }
    /// Get the force of the motor.
    Float getMotorForce() const noexcept { return mvDistanceJoint_GetMotorForce(id()); }
};

class FilterJoint : public Joint {
public:
    using Joint::Joint;
};

class GearJoint : public Joint {
public:
    using Joint::Joint;

    /// Set the ratio: how far the first coordinate goes back when the second goes on by 1.
    void setRatio(Float ratio) const noexcept { mvGearJoint_SetRatio(id(), ratio); }
    /// Get the ratio: how far the first coordinate goes back when the second goes on by 1.
    Float getRatio() const noexcept { return mvGearJoint_GetRatio(id()); }
};

class MotorJoint : public Joint {
public:
    using Joint::Joint;

    /// Set the velocity that is wanted, in the axes of frame A.
    void setLinearVelocity(Vec3 velocity) const noexcept { mvMotorJoint_SetLinearVelocity(id(), velocity); }
    /// Get the velocity that is wanted, in the axes of frame A.
    Vec3 getLinearVelocity() const noexcept { return mvMotorJoint_GetLinearVelocity(id()); }
    /// Set the angular velocity that is wanted, in the axes of frame A.
    void setAngularVelocity(Vec3 velocity) const noexcept { mvMotorJoint_SetAngularVelocity(id(), velocity); }
    /// Get the angular velocity that is wanted, in the axes of frame A.
    Vec3 getAngularVelocity() const noexcept { return mvMotorJoint_GetAngularVelocity(id()); }
    /// Set the greatest force for the velocity, along each axis.
    void setMaxVelocityForce(Float maxForce) const noexcept { mvMotorJoint_SetMaxVelocityForce(id(), maxForce); }
    /// Get the greatest force for the velocity, along each axis.
    Float getMaxVelocityForce() const noexcept { return mvMotorJoint_GetMaxVelocityForce(id()); }
    /// Set the greatest torque for the angular velocity, about each axis.
    void setMaxVelocityTorque(Float maxTorque) const noexcept { mvMotorJoint_SetMaxVelocityTorque(id(), maxTorque); }
    /// Get the greatest torque for the angular velocity, about each axis.
    Float getMaxVelocityTorque() const noexcept { return mvMotorJoint_GetMaxVelocityTorque(id()); }
    /// Set the frequency of the spring between the origins.
    void setLinearHertz(Float hertz) const noexcept { mvMotorJoint_SetLinearHertz(id(), hertz); }
    /// Get the frequency of the spring between the origins.
    Float getLinearHertz() const noexcept { return mvMotorJoint_GetLinearHertz(id()); }
    /// Set the damping ratio of the spring between the origins.
    void setLinearDampingRatio(Float damping) const noexcept { mvMotorJoint_SetLinearDampingRatio(id(), damping); }
    /// Get the damping ratio of the spring between the origins.
    Float getLinearDampingRatio() const noexcept { return mvMotorJoint_GetLinearDampingRatio(id()); }
    /// Set the frequency of the spring between the axes.
    void setAngularHertz(Float hertz) const noexcept { mvMotorJoint_SetAngularHertz(id(), hertz); }
    /// Get the frequency of the spring between the axes.
    Float getAngularHertz() const noexcept { return mvMotorJoint_GetAngularHertz(id()); }
    /// Set the damping ratio of the spring between the axes.
    void setAngularDampingRatio(Float damping) const noexcept { mvMotorJoint_SetAngularDampingRatio(id(), damping); }
    /// Get the damping ratio of the spring between the axes.
    Float getAngularDampingRatio() const noexcept { return mvMotorJoint_GetAngularDampingRatio(id()); }
    /// Set the greatest force of the spring between the origins, along each axis.
    void setMaxSpringForce(Float maxForce) const noexcept { mvMotorJoint_SetMaxSpringForce(id(), maxForce); }
    /// Get the greatest force of the spring between the origins, along each axis.
    Float getMaxSpringForce() const noexcept { return mvMotorJoint_GetMaxSpringForce(id()); }
    /// Set the greatest torque of the spring between the axes, about each axis.
    void setMaxSpringTorque(Float maxTorque) const noexcept { mvMotorJoint_SetMaxSpringTorque(id(), maxTorque); }
    /// Get the greatest torque of the spring between the axes, about each axis.
    Float getMaxSpringTorque() const noexcept { return mvMotorJoint_GetMaxSpringTorque(id()); }
};

class ParallelJoint : public Joint {
public:
    using Joint::Joint;

    /// Set the frequency of the spring.
    void setSpringHertz(Float hertz) const noexcept { mvParallelJoint_SetSpringHertz(id(), hertz); }
    /// Get the frequency of the spring.
    Float getSpringHertz() const noexcept { return mvParallelJoint_GetSpringHertz(id()); }
    /// Set the damping ratio of the spring.
    void setSpringDampingRatio(Float dampingRatio) const noexcept {
        mvParallelJoint_SetSpringDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring.
    Float getSpringDampingRatio() const noexcept { return mvParallelJoint_GetSpringDampingRatio(id()); }
    /// Set the greatest torque of the spring about each axis.
    void setMaxTorque(Float maxTorque) const noexcept { mvParallelJoint_SetMaxTorque(id(), maxTorque); }
    /// Get the greatest torque of the spring about each axis.
    Float getMaxTorque() const noexcept { return mvParallelJoint_GetMaxTorque(id()); }
};

class PrismaticJoint : public Joint {
public:
    using Joint::Joint;

    /// Turn the spring on or off.
    void enableSpring(bool flag) const noexcept { mvPrismaticJoint_EnableSpring(id(), flag); }
    /// Is the spring on?
    bool isSpringEnabled() const noexcept { return mvPrismaticJoint_IsSpringEnabled(id()); }
    /// Set the frequency of the spring.
    void setSpringHertz(Float hertz) const noexcept { mvPrismaticJoint_SetSpringHertz(id(), hertz); }
    /// Get the frequency of the spring.
    Float getSpringHertz() const noexcept { return mvPrismaticJoint_GetSpringHertz(id()); }
    /// Set the damping ratio of the spring.
    void setSpringDampingRatio(Float dampingRatio) const noexcept {
        mvPrismaticJoint_SetSpringDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring.
    Float getSpringDampingRatio() const noexcept { return mvPrismaticJoint_GetSpringDampingRatio(id()); }
    /// Set the greatest force of the spring.
    void setMaxSpringForce(Float maxForce) const noexcept { mvPrismaticJoint_SetMaxSpringForce(id(), maxForce); }
    /// Get the greatest force of the spring.
    Float getMaxSpringForce() const noexcept { return mvPrismaticJoint_GetMaxSpringForce(id()); }
    /// Set the translation at which the spring rests.
    void setTargetTranslation(Float targetTranslation) const noexcept {
        mvPrismaticJoint_SetTargetTranslation(id(), targetTranslation);
    }
    /// Get the translation at which the spring rests.
    Float getTargetTranslation() const noexcept { return mvPrismaticJoint_GetTargetTranslation(id()); }
    /// Turn the limit on or off.
    void enableLimit(bool flag) const noexcept { mvPrismaticJoint_EnableLimit(id(), flag); }
    /// Is the limit on?
    bool isLimitEnabled() const noexcept { return mvPrismaticJoint_IsLimitEnabled(id()); }
    /// Set the limits of the translation.
    void setLimits(Float lower, Float upper) const noexcept { mvPrismaticJoint_SetLimits(id(), lower, upper); }
    /// Get the limits of the translation: the least.
    Float getLowerLimit() const noexcept { return mvPrismaticJoint_GetLowerLimit(id()); }
    /// Get the limits of the translation: the greatest.
    Float getUpperLimit() const noexcept { return mvPrismaticJoint_GetUpperLimit(id()); }
    /// Turn the motor on or off.
    void enableMotor(bool flag) const noexcept { mvPrismaticJoint_EnableMotor(id(), flag); }
    /// Is the motor on?
    bool isMotorEnabled() const noexcept { return mvPrismaticJoint_IsMotorEnabled(id()); }
    /// Set the speed that the motor wants.
    void setMotorSpeed(Float motorSpeed) const noexcept { mvPrismaticJoint_SetMotorSpeed(id(), motorSpeed); }
    /// Get the speed that the motor wants.
    Float getMotorSpeed() const noexcept { return mvPrismaticJoint_GetMotorSpeed(id()); }
    /// Set the greatest force of the motor.
    void setMaxMotorForce(Float maxForce) const noexcept { mvPrismaticJoint_SetMaxMotorForce(id(), maxForce); }
    /// Get the greatest force of the motor.
    Float getMaxMotorForce() const noexcept { return mvPrismaticJoint_GetMaxMotorForce(id()); }
    /// Get the force of the motor.
    Float getMotorForce() const noexcept { return mvPrismaticJoint_GetMotorForce(id()); }
    /// Set the force of dry friction.
    void setFriction(Float friction) const noexcept { mvPrismaticJoint_SetFriction(id(), friction); }
    /// Get the force of dry friction.
    Float getFriction() const noexcept { return mvPrismaticJoint_GetFriction(id()); }
    /// Get how far frame B is along x of frame A.
    Float getTranslation() const noexcept { return mvPrismaticJoint_GetTranslation(id()); }
    /// Get how fast the translation changes.
    Float getSpeed() const noexcept { return mvPrismaticJoint_GetSpeed(id()); }
};

class PulleyJoint : public Joint {
public:
    using Joint::Joint;

    /// Move the fixed point above body A.
    void setGroundAnchorA(Pos anchor) const noexcept { mvPulleyJoint_SetGroundAnchorA(id(), anchor); }
    /// Get the fixed point above body A.
    Pos getGroundAnchorA() const noexcept { return mvPulleyJoint_GetGroundAnchorA(id()); }
    /// Get the length of the part at body A.
    Float getCurrentLengthA() const noexcept { return mvPulleyJoint_GetCurrentLengthA(id()); }
    /// Move the fixed point above body B.
    void setGroundAnchorB(Pos anchor) const noexcept { mvPulleyJoint_SetGroundAnchorB(id(), anchor); }
    /// Get the fixed point above body B.
    Pos getGroundAnchorB() const noexcept { return mvPulleyJoint_GetGroundAnchorB(id()); }
    /// Get the length of the part at body B.
    Float getCurrentLengthB() const noexcept { return mvPulleyJoint_GetCurrentLengthB(id()); }
    /// Set the ratio: how many lengths of rope hold B for each that holds A.
    void setRatio(Float ratio) const noexcept { mvPulleyJoint_SetRatio(id(), ratio); }
    /// Get the ratio: how many lengths of rope hold B for each that holds A.
    Float getRatio() const noexcept { return mvPulleyJoint_GetRatio(id()); }
    /// Set the limits of the length of the rope.
    void setLengthRange(Float minLength, Float maxLength) const noexcept {
        mvPulleyJoint_SetLengthRange(id(), minLength, maxLength);
    }
    /// Get the least length of the rope.
    Float getMinLength() const noexcept { return mvPulleyJoint_GetMinLength(id()); }
    /// Get the greatest length of the rope.
    Float getMaxLength() const noexcept { return mvPulleyJoint_GetMaxLength(id()); }
    /// Get the length of the rope: the part at A plus ratio times the part at B.
    Float getCurrentLength() const noexcept { return mvPulleyJoint_GetCurrentLength(id()); }
};

class RackPinionJoint : public Joint {
public:
    using Joint::Joint;

    /// Set the ratio: how far the angle goes back when the rack goes on by 1 m.
    void setRatio(Float ratio) const noexcept { mvRackPinionJoint_SetRatio(id(), ratio); }
    /// Get the ratio: how far the angle goes back when the rack goes on by 1 m.
    Float getRatio() const noexcept { return mvRackPinionJoint_GetRatio(id()); }
};

class RevoluteJoint : public Joint {
public:
    using Joint::Joint;

    /// Turn the spring on or off.
    void enableSpring(bool flag) const noexcept { mvRevoluteJoint_EnableSpring(id(), flag); }
    /// Is the spring on?
    bool isSpringEnabled() const noexcept { return mvRevoluteJoint_IsSpringEnabled(id()); }
    /// Set the frequency of the spring.
    void setSpringHertz(Float hertz) const noexcept { mvRevoluteJoint_SetSpringHertz(id(), hertz); }
    /// Get the frequency of the spring.
    Float getSpringHertz() const noexcept { return mvRevoluteJoint_GetSpringHertz(id()); }
    /// Set the damping ratio of the spring.
    void setSpringDampingRatio(Float dampingRatio) const noexcept {
        mvRevoluteJoint_SetSpringDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring.
    Float getSpringDampingRatio() const noexcept { return mvRevoluteJoint_GetSpringDampingRatio(id()); }
    /// Set the greatest torque of the spring.
    void setMaxSpringTorque(Float maxTorque) const noexcept { mvRevoluteJoint_SetMaxSpringTorque(id(), maxTorque); }
    /// Get the greatest torque of the spring.
    Float getMaxSpringTorque() const noexcept { return mvRevoluteJoint_GetMaxSpringTorque(id()); }
    /// Set the angle at which the spring rests.
    void setTargetAngle(Float angle) const noexcept { mvRevoluteJoint_SetTargetAngle(id(), angle); }
    /// Get the angle at which the spring rests.
    Float getTargetAngle() const noexcept { return mvRevoluteJoint_GetTargetAngle(id()); }
    /// Turn the limit on or off.
    void enableLimit(bool flag) const noexcept { mvRevoluteJoint_EnableLimit(id(), flag); }
    /// Is the limit on?
    bool isLimitEnabled() const noexcept { return mvRevoluteJoint_IsLimitEnabled(id()); }
    /// Set the limits of the angle.
    void setLimits(Float lower, Float upper) const noexcept { mvRevoluteJoint_SetLimits(id(), lower, upper); }
    /// Get the limits of the angle: the least.
    Float getLowerLimit() const noexcept { return mvRevoluteJoint_GetLowerLimit(id()); }
    /// Get the limits of the angle: the greatest.
    Float getUpperLimit() const noexcept { return mvRevoluteJoint_GetUpperLimit(id()); }
    /// Turn the motor on or off.
    void enableMotor(bool flag) const noexcept { mvRevoluteJoint_EnableMotor(id(), flag); }
    /// Is the motor on?
    bool isMotorEnabled() const noexcept { return mvRevoluteJoint_IsMotorEnabled(id()); }
    /// Set the speed that the motor wants.
    void setMotorSpeed(Float motorSpeed) const noexcept { mvRevoluteJoint_SetMotorSpeed(id(), motorSpeed); }
    /// Get the speed that the motor wants.
    Float getMotorSpeed() const noexcept { return mvRevoluteJoint_GetMotorSpeed(id()); }
    /// Set the greatest torque of the motor.
    void setMaxMotorTorque(Float maxTorque) const noexcept { mvRevoluteJoint_SetMaxMotorTorque(id(), maxTorque); }
    /// Get the greatest torque of the motor.
    Float getMaxMotorTorque() const noexcept { return mvRevoluteJoint_GetMaxMotorTorque(id()); }
    /// Get the torque of the motor.
    Float getMotorTorque() const noexcept { return mvRevoluteJoint_GetMotorTorque(id()); }
    /// Set the torque of dry friction.
    void setFriction(Float friction) const noexcept { mvRevoluteJoint_SetFriction(id(), friction); }
    /// Get the torque of dry friction.
    Float getFriction() const noexcept { return mvRevoluteJoint_GetFriction(id()); }
    /// Get the angle of frame B against frame A, counting whole turns.
    Float getAngle() const noexcept { return mvRevoluteJoint_GetAngle(id()); }
    /// Get how fast the angle changes.
    Float getSpeed() const noexcept { return mvRevoluteJoint_GetSpeed(id()); }
};

class ScrewJoint : public Joint {
public:
    using Joint::Joint;

    /// Set how far B goes along x with each turn.
    void setPitch(Float pitch) const noexcept { mvScrewJoint_SetPitch(id(), pitch); }
    /// Get how far B goes along x with each turn.
    Float getPitch() const noexcept { return mvScrewJoint_GetPitch(id()); }
    /// Turn the spring on or off.
    void enableSpring(bool flag) const noexcept { mvScrewJoint_EnableSpring(id(), flag); }
    /// Is the spring on?
    bool isSpringEnabled() const noexcept { return mvScrewJoint_IsSpringEnabled(id()); }
    /// Set the frequency of the spring.
    void setSpringHertz(Float hertz) const noexcept { mvScrewJoint_SetSpringHertz(id(), hertz); }
    /// Get the frequency of the spring.
    Float getSpringHertz() const noexcept { return mvScrewJoint_GetSpringHertz(id()); }
    /// Set the damping ratio of the spring.
    void setSpringDampingRatio(Float dampingRatio) const noexcept {
        mvScrewJoint_SetSpringDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring.
    Float getSpringDampingRatio() const noexcept { return mvScrewJoint_GetSpringDampingRatio(id()); }
    /// Set the greatest torque of the spring.
    void setMaxSpringTorque(Float maxTorque) const noexcept { mvScrewJoint_SetMaxSpringTorque(id(), maxTorque); }
    /// Get the greatest torque of the spring.
    Float getMaxSpringTorque() const noexcept { return mvScrewJoint_GetMaxSpringTorque(id()); }
    /// Set the angle at which the spring rests.
    void setTargetAngle(Float angle) const noexcept { mvScrewJoint_SetTargetAngle(id(), angle); }
    /// Get the angle at which the spring rests.
    Float getTargetAngle() const noexcept { return mvScrewJoint_GetTargetAngle(id()); }
    /// Turn the limit on or off.
    void enableLimit(bool flag) const noexcept { mvScrewJoint_EnableLimit(id(), flag); }
    /// Is the limit on?
    bool isLimitEnabled() const noexcept { return mvScrewJoint_IsLimitEnabled(id()); }
    /// Set the limits of the angle.
    void setLimits(Float lower, Float upper) const noexcept { mvScrewJoint_SetLimits(id(), lower, upper); }
    /// Get the limits of the angle: the least.
    Float getLowerLimit() const noexcept { return mvScrewJoint_GetLowerLimit(id()); }
    /// Get the limits of the angle: the greatest.
    Float getUpperLimit() const noexcept { return mvScrewJoint_GetUpperLimit(id()); }
    /// Turn the motor on or off.
    void enableMotor(bool flag) const noexcept { mvScrewJoint_EnableMotor(id(), flag); }
    /// Is the motor on?
    bool isMotorEnabled() const noexcept { return mvScrewJoint_IsMotorEnabled(id()); }
    /// Set the speed that the motor wants.
    void setMotorSpeed(Float motorSpeed) const noexcept { mvScrewJoint_SetMotorSpeed(id(), motorSpeed); }
    /// Get the speed that the motor wants.
    Float getMotorSpeed() const noexcept { return mvScrewJoint_GetMotorSpeed(id()); }
    /// Set the greatest torque of the motor.
    void setMaxMotorTorque(Float maxTorque) const noexcept { mvScrewJoint_SetMaxMotorTorque(id(), maxTorque); }
    /// Get the greatest torque of the motor.
    Float getMaxMotorTorque() const noexcept { return mvScrewJoint_GetMaxMotorTorque(id()); }
    /// Get the torque of the motor.
    Float getMotorTorque() const noexcept { return mvScrewJoint_GetMotorTorque(id()); }
    /// Set the torque of dry friction.
    void setFriction(Float friction) const noexcept { mvScrewJoint_SetFriction(id(), friction); }
    /// Get the torque of dry friction.
    Float getFriction() const noexcept { return mvScrewJoint_GetFriction(id()); }
    /// Get the angle of frame B against frame A about x, counting whole turns.
    Float getAngle() const noexcept { return mvScrewJoint_GetAngle(id()); }
    /// Get how fast the angle changes.
    Float getSpeed() const noexcept { return mvScrewJoint_GetSpeed(id()); }
    /// Get how far frame B is along x of frame A.
    Float getTranslation() const noexcept { return mvScrewJoint_GetTranslation(id()); }
};

class SixDofJoint : public Joint {
public:
    using Joint::Joint;

    /// Set everything about one axis.
    void setAxis(int axis, SixDofAxis value) const noexcept { mvSixDofJoint_SetAxis(id(), axis, value); }
    /// Get everything about one axis.
    SixDofAxis getAxis(int axis) const noexcept { return mvSixDofJoint_GetAxis(id(), axis); }
    /// Get where frame B is along or about one axis.
    Float getCoordinate(int axis) const noexcept { return mvSixDofJoint_GetCoordinate(id(), axis); }
};

class SphericalJoint : public Joint {
public:
    using Joint::Joint;

    /// Turn the cone limit on or off.
    void enableConeLimit(bool flag) const noexcept { mvSphericalJoint_EnableConeLimit(id(), flag); }
    /// Is the cone limit on?
    bool isConeLimitEnabled() const noexcept { return mvSphericalJoint_IsConeLimitEnabled(id()); }
    /// Get the half-angle of the cone for turns about x of frame A.
    Float getConeLimit() const noexcept { return mvSphericalJoint_GetConeLimit(id()); }
    /// Make the cone round, with this half-angle.
    void setConeLimit(Float angle) const noexcept { mvSphericalJoint_SetConeLimit(id(), angle); }
    /// Make the cone elliptical.
    void setConeLimits(Float angleX, Float angleY) const noexcept {
        mvSphericalJoint_SetConeLimits(id(), angleX, angleY);
    }
    /// Get the half-angle of the cone for turns about y of frame A.
    Float getConeLimitY() const noexcept { return mvSphericalJoint_GetConeLimitY(id()); }
    /// Get the angle between the z axes of the frames.
    Float getConeAngle() const noexcept { return mvSphericalJoint_GetConeAngle(id()); }
    /// Turn the limit of the twist on or off.
    void enableTwistLimit(bool flag) const noexcept { mvSphericalJoint_EnableTwistLimit(id(), flag); }
    /// Is the limit of the twist on?
    bool isTwistLimitEnabled() const noexcept { return mvSphericalJoint_IsTwistLimitEnabled(id()); }
    /// Set the limits of the twist.
    void setTwistLimits(Float lower, Float upper) const noexcept {
        mvSphericalJoint_SetTwistLimits(id(), lower, upper);
    }
    /// Get the limits of the twist: the least.
    Float getLowerTwistLimit() const noexcept { return mvSphericalJoint_GetLowerTwistLimit(id()); }
    /// Get the limits of the twist: the greatest.
    Float getUpperTwistLimit() const noexcept { return mvSphericalJoint_GetUpperTwistLimit(id()); }
    /// Get the twist of frame B against frame A about z.
    Float getTwistAngle() const noexcept { return mvSphericalJoint_GetTwistAngle(id()); }
    /// Turn the spring on or off.
    void enableSpring(bool flag) const noexcept { mvSphericalJoint_EnableSpring(id(), flag); }
    /// Is the spring on?
    bool isSpringEnabled() const noexcept { return mvSphericalJoint_IsSpringEnabled(id()); }
    /// Set the frequency of the spring.
    void setSpringHertz(Float hertz) const noexcept { mvSphericalJoint_SetSpringHertz(id(), hertz); }
    /// Get the frequency of the spring.
    Float getSpringHertz() const noexcept { return mvSphericalJoint_GetSpringHertz(id()); }
    /// Set the damping ratio of the spring.
    void setSpringDampingRatio(Float dampingRatio) const noexcept {
        mvSphericalJoint_SetSpringDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring.
    Float getSpringDampingRatio() const noexcept { return mvSphericalJoint_GetSpringDampingRatio(id()); }
    /// Set the greatest torque of the spring about each axis.
    void setMaxSpringTorque(Float maxTorque) const noexcept { mvSphericalJoint_SetMaxSpringTorque(id(), maxTorque); }
    /// Get the greatest torque of the spring about each axis.
    Float getMaxSpringTorque() const noexcept { return mvSphericalJoint_GetMaxSpringTorque(id()); }
    /// Set the rotation of frame B in frame A at which the spring rests.
    void setTargetRotation(Quat targetRotation) const noexcept {
        mvSphericalJoint_SetTargetRotation(id(), targetRotation);
    }
    /// Get the rotation of frame B in frame A at which the spring rests.
    Quat getTargetRotation() const noexcept { return mvSphericalJoint_GetTargetRotation(id()); }
    /// Turn the motor on or off.
    void enableMotor(bool flag) const noexcept { mvSphericalJoint_EnableMotor(id(), flag); }
    /// Is the motor on?
    bool isMotorEnabled() const noexcept { return mvSphericalJoint_IsMotorEnabled(id()); }
    /// Set the angular velocity that the motor wants, in the axes of frame A.
    void setMotorVelocity(Vec3 motorVelocity) const noexcept { mvSphericalJoint_SetMotorVelocity(id(), motorVelocity); }
    /// Get the angular velocity that the motor wants, in the axes of frame A.
    Vec3 getMotorVelocity() const noexcept { return mvSphericalJoint_GetMotorVelocity(id()); }
    /// Get the torque of the motor about the axes of frame A.
    Vec3 getMotorTorque() const noexcept { return mvSphericalJoint_GetMotorTorque(id()); }
    /// Set the greatest torque of the motor about each axis.
    void setMaxMotorTorque(Float torque) const noexcept { mvSphericalJoint_SetMaxMotorTorque(id(), torque); }
    /// Get the greatest torque of the motor about each axis.
    Float getMaxMotorTorque() const noexcept { return mvSphericalJoint_GetMaxMotorTorque(id()); }
    /// Set the torque of dry friction about each axis.
    void setFriction(Float friction) const noexcept { mvSphericalJoint_SetFriction(id(), friction); }
    /// Get the torque of dry friction about each axis.
    Float getFriction() const noexcept { return mvSphericalJoint_GetFriction(id()); }
};

class UniversalJoint : public Joint {
public:
    using Joint::Joint;

    /// Get the angle about x of frame A.
    Float getAngle1() const noexcept { return mvUniversalJoint_GetAngle1(id()); }
    /// Turn the spring about x of frame A on or off.
    void enableSpring1(bool flag) const noexcept { mvUniversalJoint_EnableSpring1(id(), flag); }
    /// Is the spring about x of frame A on?
    bool isSpring1Enabled() const noexcept { return mvUniversalJoint_IsSpring1Enabled(id()); }
    /// Set the frequency of the spring about x of frame A.
    void setSpringHertz1(Float hertz) const noexcept { mvUniversalJoint_SetSpringHertz1(id(), hertz); }
    /// Get the frequency of the spring about x of frame A.
    Float getSpringHertz1() const noexcept { return mvUniversalJoint_GetSpringHertz1(id()); }
    /// Set the damping ratio of the spring about x of frame A.
    void setSpringDampingRatio1(Float dampingRatio) const noexcept {
        mvUniversalJoint_SetSpringDampingRatio1(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring about x of frame A.
    Float getSpringDampingRatio1() const noexcept { return mvUniversalJoint_GetSpringDampingRatio1(id()); }
    /// Set the angle about x of frame A at which the spring rests.
    void setTargetAngle1(Float angle) const noexcept { mvUniversalJoint_SetTargetAngle1(id(), angle); }
    /// Get the angle about x of frame A at which the spring rests.
    Float getTargetAngle1() const noexcept { return mvUniversalJoint_GetTargetAngle1(id()); }
    /// Turn the limit of the angle about x of frame A on or off.
    void enableLimit1(bool flag) const noexcept { mvUniversalJoint_EnableLimit1(id(), flag); }
    /// Is the limit of the angle about x of frame A on?
    bool isLimit1Enabled() const noexcept { return mvUniversalJoint_IsLimit1Enabled(id()); }
    /// Set the limits of the angle about x of frame A.
    void setLimits1(Float lower, Float upper) const noexcept { mvUniversalJoint_SetLimits1(id(), lower, upper); }
    /// Get the limits of the angle about x of frame A: the least.
    Float getLowerLimit1() const noexcept { return mvUniversalJoint_GetLowerLimit1(id()); }
    /// Get the limits of the angle about x of frame A: the greatest.
    Float getUpperLimit1() const noexcept { return mvUniversalJoint_GetUpperLimit1(id()); }
    /// Turn the motor about x of frame A on or off.
    void enableMotor1(bool flag) const noexcept { mvUniversalJoint_EnableMotor1(id(), flag); }
    /// Is the motor about x of frame A on?
    bool isMotor1Enabled() const noexcept { return mvUniversalJoint_IsMotor1Enabled(id()); }
    /// Set the speed that the motor about x of frame A wants.
    void setMotorSpeed1(Float motorSpeed) const noexcept { mvUniversalJoint_SetMotorSpeed1(id(), motorSpeed); }
    /// Get the speed that the motor about x of frame A wants.
    Float getMotorSpeed1() const noexcept { return mvUniversalJoint_GetMotorSpeed1(id()); }
    /// Set the greatest torque of the motor about x of frame A.
    void setMaxMotorTorque1(Float torque) const noexcept { mvUniversalJoint_SetMaxMotorTorque1(id(), torque); }
    /// Get the greatest torque of the motor about x of frame A.
    Float getMaxMotorTorque1() const noexcept { return mvUniversalJoint_GetMaxMotorTorque1(id()); }
    /// Set the torque of dry friction about x of frame A.
    void setFriction1(Float torque) const noexcept { mvUniversalJoint_SetFriction1(id(), torque); }
    /// Get the torque of dry friction about x of frame A.
    Float getFriction1() const noexcept { return mvUniversalJoint_GetFriction1(id()); }
    /// Get the angle about y of frame B.
    Float getAngle2() const noexcept { return mvUniversalJoint_GetAngle2(id()); }
    /// Turn the spring about y of frame B on or off.
    void enableSpring2(bool flag) const noexcept { mvUniversalJoint_EnableSpring2(id(), flag); }
    /// Is the spring about y of frame B on?
    bool isSpring2Enabled() const noexcept { return mvUniversalJoint_IsSpring2Enabled(id()); }
    /// Set the frequency of the spring about y of frame B.
    void setSpringHertz2(Float hertz) const noexcept { mvUniversalJoint_SetSpringHertz2(id(), hertz); }
    /// Get the frequency of the spring about y of frame B.
    Float getSpringHertz2() const noexcept { return mvUniversalJoint_GetSpringHertz2(id()); }
    /// Set the damping ratio of the spring about y of frame B.
    void setSpringDampingRatio2(Float dampingRatio) const noexcept {
        mvUniversalJoint_SetSpringDampingRatio2(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring about y of frame B.
    Float getSpringDampingRatio2() const noexcept { return mvUniversalJoint_GetSpringDampingRatio2(id()); }
    /// Set the angle about y of frame B at which the spring rests.
    void setTargetAngle2(Float angle) const noexcept { mvUniversalJoint_SetTargetAngle2(id(), angle); }
    /// Get the angle about y of frame B at which the spring rests.
    Float getTargetAngle2() const noexcept { return mvUniversalJoint_GetTargetAngle2(id()); }
    /// Turn the limit of the angle about y of frame B on or off.
    void enableLimit2(bool flag) const noexcept { mvUniversalJoint_EnableLimit2(id(), flag); }
    /// Is the limit of the angle about y of frame B on?
    bool isLimit2Enabled() const noexcept { return mvUniversalJoint_IsLimit2Enabled(id()); }
    /// Set the limits of the angle about y of frame B.
    void setLimits2(Float lower, Float upper) const noexcept { mvUniversalJoint_SetLimits2(id(), lower, upper); }
    /// Get the limits of the angle about y of frame B: the least.
    Float getLowerLimit2() const noexcept { return mvUniversalJoint_GetLowerLimit2(id()); }
    /// Get the limits of the angle about y of frame B: the greatest.
    Float getUpperLimit2() const noexcept { return mvUniversalJoint_GetUpperLimit2(id()); }
    /// Turn the motor about y of frame B on or off.
    void enableMotor2(bool flag) const noexcept { mvUniversalJoint_EnableMotor2(id(), flag); }
    /// Is the motor about y of frame B on?
    bool isMotor2Enabled() const noexcept { return mvUniversalJoint_IsMotor2Enabled(id()); }
    /// Set the speed that the motor about y of frame B wants.
    void setMotorSpeed2(Float motorSpeed) const noexcept { mvUniversalJoint_SetMotorSpeed2(id(), motorSpeed); }
    /// Get the speed that the motor about y of frame B wants.
    Float getMotorSpeed2() const noexcept { return mvUniversalJoint_GetMotorSpeed2(id()); }
    /// Set the greatest torque of the motor about y of frame B.
    void setMaxMotorTorque2(Float torque) const noexcept { mvUniversalJoint_SetMaxMotorTorque2(id(), torque); }
    /// Get the greatest torque of the motor about y of frame B.
    Float getMaxMotorTorque2() const noexcept { return mvUniversalJoint_GetMaxMotorTorque2(id()); }
    /// Set the torque of dry friction about y of frame B.
    void setFriction2(Float torque) const noexcept { mvUniversalJoint_SetFriction2(id(), torque); }
    /// Get the torque of dry friction about y of frame B.
    Float getFriction2() const noexcept { return mvUniversalJoint_GetFriction2(id()); }
};

class WeldJoint : public Joint {
public:
    using Joint::Joint;

    /// Set the stiffness of the place.
    void setLinearHertz(Float hertz) const noexcept { mvWeldJoint_SetLinearHertz(id(), hertz); }
    /// Get the stiffness of the place.
    Float getLinearHertz() const noexcept { return mvWeldJoint_GetLinearHertz(id()); }
    /// Set the damping ratio of the place.
    void setLinearDampingRatio(Float dampingRatio) const noexcept {
        mvWeldJoint_SetLinearDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the place.
    Float getLinearDampingRatio() const noexcept { return mvWeldJoint_GetLinearDampingRatio(id()); }
    /// Set the stiffness of the rotation.
    void setAngularHertz(Float hertz) const noexcept { mvWeldJoint_SetAngularHertz(id(), hertz); }
    /// Get the stiffness of the rotation.
    Float getAngularHertz() const noexcept { return mvWeldJoint_GetAngularHertz(id()); }
    /// Set the damping ratio of the rotation.
    void setAngularDampingRatio(Float dampingRatio) const noexcept {
        mvWeldJoint_SetAngularDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the rotation.
    Float getAngularDampingRatio() const noexcept { return mvWeldJoint_GetAngularDampingRatio(id()); }
};

class WheelJoint : public Joint {
public:
    using Joint::Joint;

    /// Turn the spring of the suspension on or off.
    void enableSuspension(bool flag) const noexcept { mvWheelJoint_EnableSuspension(id(), flag); }
    /// Is the spring of the suspension on?
    bool isSuspensionEnabled() const noexcept { return mvWheelJoint_IsSuspensionEnabled(id()); }
    /// Set the frequency of the suspension.
    void setSuspensionHertz(Float hertz) const noexcept { mvWheelJoint_SetSuspensionHertz(id(), hertz); }
    /// Get the frequency of the suspension.
    Float getSuspensionHertz() const noexcept { return mvWheelJoint_GetSuspensionHertz(id()); }
    /// Set the damping ratio of the suspension.
    void setSuspensionDampingRatio(Float dampingRatio) const noexcept {
        mvWheelJoint_SetSuspensionDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the suspension.
    Float getSuspensionDampingRatio() const noexcept { return mvWheelJoint_GetSuspensionDampingRatio(id()); }
    /// Set the travel at which the suspension rests.
    void setTargetSuspension(Float travel) const noexcept { mvWheelJoint_SetTargetSuspension(id(), travel); }
    /// Get the travel at which the suspension rests.
    Float getTargetSuspension() const noexcept { return mvWheelJoint_GetTargetSuspension(id()); }
    /// Set the greatest force of the suspension.
    void setMaxSuspensionForce(Float force) const noexcept { mvWheelJoint_SetMaxSuspensionForce(id(), force); }
    /// Get the greatest force of the suspension.
    Float getMaxSuspensionForce() const noexcept { return mvWheelJoint_GetMaxSuspensionForce(id()); }
    /// Get how far the wheel is along x of frame A.
    Float getSuspensionTravel() const noexcept { return mvWheelJoint_GetSuspensionTravel(id()); }
    /// Turn the limit of the travel on or off.
    void enableSuspensionLimit(bool flag) const noexcept { mvWheelJoint_EnableSuspensionLimit(id(), flag); }
    /// Is the limit of the travel on?
    bool isSuspensionLimitEnabled() const noexcept { return mvWheelJoint_IsSuspensionLimitEnabled(id()); }
    /// Set the limits of the travel.
    void setSuspensionLimits(Float lower, Float upper) const noexcept {
        mvWheelJoint_SetSuspensionLimits(id(), lower, upper);
    }
    /// Get the limits of the travel: the least.
    Float getLowerSuspensionLimit() const noexcept { return mvWheelJoint_GetLowerSuspensionLimit(id()); }
    /// Get the limits of the travel: the greatest.
    Float getUpperSuspensionLimit() const noexcept { return mvWheelJoint_GetUpperSuspensionLimit(id()); }
    /// Turn the motor that spins the wheel on or off.
    void enableSpinMotor(bool flag) const noexcept { mvWheelJoint_EnableSpinMotor(id(), flag); }
    /// Is the motor that spins the wheel on?
    bool isSpinMotorEnabled() const noexcept { return mvWheelJoint_IsSpinMotorEnabled(id()); }
    /// Set the speed that the motor wants.
    void setSpinMotorSpeed(Float speed) const noexcept { mvWheelJoint_SetSpinMotorSpeed(id(), speed); }
    /// Get the speed that the motor wants.
    Float getSpinMotorSpeed() const noexcept { return mvWheelJoint_GetSpinMotorSpeed(id()); }
    /// Set the greatest torque of the motor.
    void setMaxSpinTorque(Float torque) const noexcept { mvWheelJoint_SetMaxSpinTorque(id(), torque); }
    /// Get the greatest torque of the motor.
    Float getMaxSpinTorque() const noexcept { return mvWheelJoint_GetMaxSpinTorque(id()); }
    /// Set the torque of dry friction in the bearing.
    void setSpinFriction(Float torque) const noexcept { mvWheelJoint_SetSpinFriction(id(), torque); }
    /// Get the torque of dry friction in the bearing.
    Float getSpinFriction() const noexcept { return mvWheelJoint_GetSpinFriction(id()); }
    /// Get how fast the wheel spins against the chassis.
    Float getSpinSpeed() const noexcept { return mvWheelJoint_GetSpinSpeed(id()); }
    /// Get how far the wheel has turned, counting whole turns.
    Float getSpinAngle() const noexcept { return mvWheelJoint_GetSpinAngle(id()); }
    /// Get the torque of the motor that spins the wheel.
    Float getSpinTorque() const noexcept { return mvWheelJoint_GetSpinTorque(id()); }
    /// Turn steering on or off.
    void enableSteering(bool flag) const noexcept { mvWheelJoint_EnableSteering(id(), flag); }
    /// Is steering on?
    bool isSteeringEnabled() const noexcept { return mvWheelJoint_IsSteeringEnabled(id()); }
    /// Set the frequency of the spring that steers.
    void setSteeringHertz(Float hertz) const noexcept { mvWheelJoint_SetSteeringHertz(id(), hertz); }
    /// Get the frequency of the spring that steers.
    Float getSteeringHertz() const noexcept { return mvWheelJoint_GetSteeringHertz(id()); }
    /// Set the damping ratio of the spring that steers.
    void setSteeringDampingRatio(Float dampingRatio) const noexcept {
        mvWheelJoint_SetSteeringDampingRatio(id(), dampingRatio);
    }
    /// Get the damping ratio of the spring that steers.
    Float getSteeringDampingRatio() const noexcept { return mvWheelJoint_GetSteeringDampingRatio(id()); }
    /// Set the greatest torque of the spring that steers.
    void setMaxSteeringTorque(Float torque) const noexcept { mvWheelJoint_SetMaxSteeringTorque(id(), torque); }
    /// Get the greatest torque of the spring that steers.
    Float getMaxSteeringTorque() const noexcept { return mvWheelJoint_GetMaxSteeringTorque(id()); }
    /// Turn the limit of the steering angle on or off.
    void enableSteeringLimit(bool flag) const noexcept { mvWheelJoint_EnableSteeringLimit(id(), flag); }
    /// Is the limit of the steering angle on?
    bool isSteeringLimitEnabled() const noexcept { return mvWheelJoint_IsSteeringLimitEnabled(id()); }
    /// Set the limits of the steering angle.
    void setSteeringLimits(Float lower, Float upper) const noexcept {
        mvWheelJoint_SetSteeringLimits(id(), lower, upper);
    }
    /// Get the limits of the steering angle: the least.
    Float getLowerSteeringLimit() const noexcept { return mvWheelJoint_GetLowerSteeringLimit(id()); }
    /// Get the limits of the steering angle: the greatest.
    Float getUpperSteeringLimit() const noexcept { return mvWheelJoint_GetUpperSteeringLimit(id()); }
    /// Set the angle that the spring steers to.
    void setTargetSteeringAngle(Float angle) const noexcept { mvWheelJoint_SetTargetSteeringAngle(id(), angle); }
    /// Get the angle that the spring steers to.
    Float getTargetSteeringAngle() const noexcept { return mvWheelJoint_GetTargetSteeringAngle(id()); }
    /// Get the steering angle about x of frame A.
    Float getSteeringAngle() const noexcept { return mvWheelJoint_GetSteeringAngle(id()); }
    /// Get the torque that steers the wheel, spring and limits together.
    Float getSteeringTorque() const noexcept { return mvWheelJoint_GetSteeringTorque(id()); }
};

/// One hit of a ray or of a shape that is cast.
struct CastHit {
    Shape shape;
    Pos point;
    Vec3 normal;
    /// How far along the translation, 0 to 1.
    Float fraction;
    std::uint64_t userMaterialId;
    int triangleIndex;
    int childIndex;
};

/// The contact events of a step; valid until the next one.
struct ContactEvents {
    Span<const ContactBeginTouchEvent> beginEvents;
    Span<const ContactEndTouchEvent> endEvents;
    Span<const ContactHitEvent> hitEvents;
};

/// A drawing of a world; valid until the next one.
struct DrawBuffers {
    Span<const mvDrawLine> lines;
    Span<const mvDrawTriangle> triangles;
    Span<const mvDrawInstance> instances;
    Span<const mvDrawPoint> points;
    Span<const mvDrawString> strings;
};

namespace detail {

/// Where a callable lives while the library may call it: an lvalue stays with its owner; a temporary is kept for the life
/// of the program, which needs no memory if it captures nothing.
template <class F> void* keep(F&& f) noexcept {
    using Callable = std::remove_reference_t<F>;
    if constexpr (std::is_lvalue_reference_v<F>) {
        return const_cast<void*>(static_cast<const void*>(std::addressof(f)));
    } else {
        static_assert(std::is_empty_v<Callable>, "a callback that captures must be a variable that outlives its use");
        static Callable kept(std::move(f));
        return &kept;
    }
}

template <class F> using Called = std::remove_reference_t<F>;

template <class F> F& called(void* context) noexcept { return *static_cast<F*>(context); }

} // namespace detail

/// A world that someone else owns.
class WorldRef : public WorldId {
public:
    using WorldId::WorldId;
    void destroy() const noexcept { mvDestroyWorld(id()); }

    Body createBody(const BodyDef& def) const noexcept { return mvCreateBody(id(), &def); }
    DistanceJoint createDistanceJoint(const DistanceJointDef& def) const noexcept {
        return mvCreateDistanceJoint(id(), &def);
    }
    FilterJoint createFilterJoint(const FilterJointDef& def) const noexcept {
        return mvCreateFilterJoint(id(), &def);
    }
    GearJoint createGearJoint(const GearJointDef& def) const noexcept {
        return mvCreateGearJoint(id(), &def);
    }
    MotorJoint createMotorJoint(const MotorJointDef& def) const noexcept {
        return mvCreateMotorJoint(id(), &def);
    }
    ParallelJoint createParallelJoint(const ParallelJointDef& def) const noexcept {
        return mvCreateParallelJoint(id(), &def);
    }
    PrismaticJoint createPrismaticJoint(const PrismaticJointDef& def) const noexcept {
        return mvCreatePrismaticJoint(id(), &def);
    }
    PulleyJoint createPulleyJoint(const PulleyJointDef& def) const noexcept {
        return mvCreatePulleyJoint(id(), &def);
    }
    RackPinionJoint createRackPinionJoint(const RackPinionJointDef& def) const noexcept {
        return mvCreateRackPinionJoint(id(), &def);
    }
    RevoluteJoint createRevoluteJoint(const RevoluteJointDef& def) const noexcept {
        return mvCreateRevoluteJoint(id(), &def);
    }
    ScrewJoint createScrewJoint(const ScrewJointDef& def) const noexcept {
        return mvCreateScrewJoint(id(), &def);
    }
    SixDofJoint createSixDofJoint(const SixDofJointDef& def) const noexcept {
        return mvCreateSixDofJoint(id(), &def);
    }
    SphericalJoint createSphericalJoint(const SphericalJointDef& def) const noexcept {
        return mvCreateSphericalJoint(id(), &def);
    }
    UniversalJoint createUniversalJoint(const UniversalJointDef& def) const noexcept {
        return mvCreateUniversalJoint(id(), &def);
    }
    WeldJoint createWeldJoint(const WeldJointDef& def) const noexcept {
        return mvCreateWeldJoint(id(), &def);
    }
    WheelJoint createWheelJoint(const WheelJointDef& def) const noexcept {
        return mvCreateWheelJoint(id(), &def);
    }
    /// A human of bones and joints, made to fall.
    mvHuman createHuman(const HumanDef& def) const noexcept { return mvCreateHuman(id(), &def); }

    // Events: arrays of the library, valid until the next step.

    Span<const BodyMoveEvent> getBodyEvents() const noexcept {
        const mvBodyEvents events = mvWorld_GetBodyEvents(id());
        return {events.moveEvents, events.moveCount};
    }
    ContactEvents getContactEvents() const noexcept {
        const mvContactEvents e = mvWorld_GetContactEvents(id());
        return {{e.beginEvents, e.beginCount}, {e.endEvents, e.endCount}, {e.hitEvents, e.hitCount}};
    }
    Span<const JointEvent> getJointEvents() const noexcept {
        const mvJointEvents events = mvWorld_GetJointEvents(id());
        return {events.jointEvents, events.count};
    }

    /// The world as it is now, drawn into arrays of the library.
    DrawBuffers drawBuffers(const DebugDraw& draw = {}, std::uint64_t maskBits = MV_DEFAULT_MASK_BITS) const noexcept {
        const mvDrawBuffers b = mvWorld_DrawBuffers(id(), &draw, maskBits);
        return {{b.lines, b.lineCount},
                {b.triangles, b.triangleCount},
                {b.instances, b.instanceCount},
                {b.points, b.pointCount},
                {b.strings, b.stringCount}};
    }
    /// The same through the functions of `draw`.
    void draw(const DebugDraw& draw, std::uint64_t maskBits = MV_DEFAULT_MASK_BITS) const noexcept {
        mvWorld_Draw(id(), &draw, maskBits);
    }

    /// Poses and velocities of all awake bodies at once, into arrays of that capacity or null; the number of bodies.
    int getAwakeBodies(mvBodyId* ids, WorldTransform* transforms, Vec3* linear, Vec3* angular, int capacity) const noexcept {
        return mvWorld_GetAwakeBodies(id(), ids, transforms, linear, angular, capacity);
    }

    // Queries that call back; all of them exist in an array form (...All, ...Closest) below.

    /// f(Shape) -> bool: whether to go on.
    template <class F> TreeStats overlapAABB(AABB aabb, QueryFilter filter, F&& f) const noexcept {
        return mvWorld_OverlapAABB(id(), aabb, filter, &overlap<F>, address(f));
    }
    /// f(Shape) -> bool: whether to go on.
    template <class F>
    TreeStats overlapShape(Pos origin, const ShapeProxy& proxy, QueryFilter filter, F&& f) const noexcept {
        return mvWorld_OverlapShape(id(), origin, &proxy, filter, &overlap<F>, address(f));
    }
    /// f(const CastHit&) -> Float: -1 to pass over this shape, 0 to stop, hit.fraction to look nearer only, 1 to go on.
    template <class F> TreeStats castRay(Pos origin, Vec3 translation, QueryFilter filter, F&& f) const noexcept {
        return mvWorld_CastRay(id(), origin, translation, filter, &cast<F>, address(f));
    }
    /// f(const CastHit&) -> Float, as castRay.
    template <class F>
    TreeStats castShape(Pos origin, const ShapeProxy& proxy, Vec3 translation, QueryFilter filter, F&& f) const noexcept {
        return mvWorld_CastShape(id(), origin, &proxy, translation, filter, &cast<F>, address(f));
    }

    // Callbacks of the step. A callable with captures must be a variable that outlives its use, and is not copied;
    // nullptr takes the callback away.

    /// f(Shape a, Shape b) -> bool: whether they may collide.
    template <class F> void setCustomFilterCallback(F&& f) const noexcept {
        mvWorld_SetCustomFilterCallback(
            id(),
            [](mvShapeId a, mvShapeId b, void* context) noexcept -> bool {
                return detail::called<detail::Called<F>>(context)(Shape(a), Shape(b));
            },
            detail::keep(std::forward<F>(f)));
    }
    void setCustomFilterCallback(std::nullptr_t) const noexcept { mvWorld_SetCustomFilterCallback(id(), nullptr, nullptr); }
    /// f(Shape a, Shape b, Pos point, Vec3 normal) -> bool: whether the contact acts.
    template <class F> void setPreSolveCallback(F&& f) const noexcept {
        mvWorld_SetPreSolveCallback(
            id(),
            [](mvShapeId a, mvShapeId b, mvPos point, mvVec3 normal, void* context) noexcept -> bool {
                return detail::called<detail::Called<F>>(context)(Shape(a), Shape(b), point, normal);
            },
            detail::keep(std::forward<F>(f)));
    }
    void setPreSolveCallback(std::nullptr_t) const noexcept { mvWorld_SetPreSolveCallback(id(), nullptr, nullptr); }
    /// f(Float a, uint64_t materialA, Float b, uint64_t materialB) -> Float: the coefficient of the pair.
    template <class F> void setFrictionCallback(F&& f) const noexcept {
        mvWorld_SetFrictionCallback(id(), &mix<F>, detail::keep(std::forward<F>(f)));
    }
    void setFrictionCallback(std::nullptr_t) const noexcept { mvWorld_SetFrictionCallback(id(), nullptr, nullptr); }
    /// f(Float a, uint64_t materialA, Float b, uint64_t materialB) -> Float: the coefficient of the pair.
    template <class F> void setRestitutionCallback(F&& f) const noexcept {
        mvWorld_SetRestitutionCallback(id(), &mix<F>, detail::keep(std::forward<F>(f)));
    }
    void setRestitutionCallback(std::nullptr_t) const noexcept { mvWorld_SetRestitutionCallback(id(), nullptr, nullptr); }

    /// Find the shapes whose boxes overlap a box, into an array.
    int overlapAABBAll(AABB aabb, QueryFilter filter, Span<mvShapeId> shapeIds) const noexcept {
        return mvWorld_OverlapAABBAll(id(), aabb, filter, shapeIds.data(), shapeIds.size());
    }
    /// Find the shapes that touch or overlap a solid, into an array.
    int overlapShapeAll(Pos origin, const ShapeProxy& proxy, QueryFilter filter,
            Span<mvShapeId> shapeIds) const noexcept {
        return mvWorld_OverlapShapeAll(id(), origin, &proxy, filter, shapeIds.data(), shapeIds.size());
    }
    /// Cast a ray and get the nearest shape that it hits.
    RayResult castRayClosest(Pos origin, Vec3 translation, QueryFilter filter) const noexcept {
        return mvWorld_CastRayClosest(id(), origin, translation, filter);
    }
    /// Cast a ray and get the shapes that it hits, nearest first.
    int castRayAll(Pos origin, Vec3 translation, QueryFilter filter, Span<RayResult> results) const noexcept {
        return mvWorld_CastRayAll(id(), origin, translation, filter, results.data(), results.size());
    }
    /// Move a solid without turning and get the nearest shape that it hits.
    RayResult castShapeClosest(Pos origin, const ShapeProxy& proxy, Vec3 translation,
            QueryFilter filter) const noexcept {
        return mvWorld_CastShapeClosest(id(), origin, &proxy, translation, filter);
    }
    /// Move a solid without turning and get the shapes that it hits, nearest first.
    int castShapeAll(Pos origin, const ShapeProxy& proxy, Vec3 translation, QueryFilter filter,
            Span<RayResult> results) const noexcept {
        return mvWorld_CastShapeAll(id(), origin, &proxy, translation, filter, results.data(), results.size());
    }
    /// Does this id name a world that lives? Never fails.
    bool isValid() const noexcept { return mvWorld_IsValid(id()); }
    /// Move the world through time.
    void step(Float timeStep, int subStepCount) const noexcept { mvWorld_Step(id(), timeStep, subStepCount); }
    /// Get the box around everything in the world that has bounds, with some room to spare; zero for an empty world.
    AABB getBounds() const noexcept { return mvWorld_GetBounds(id()); }
    /// Arrange the static shapes of a world anew, after many were made.
    void rebuildStaticTree() const noexcept { mvWorld_RebuildStaticTree(id()); }
    /// Set the user data of a world.
    void setUserData(void* userData) const noexcept { mvWorld_SetUserData(id(), userData); }
    /// Get the user data of a world.
    void* getUserData() const noexcept { return mvWorld_GetUserData(id()); }
    /// Set gravity, and wake all bodies.
    void setGravity(Vec3 gravity) const noexcept { mvWorld_SetGravity(id(), gravity); }
    /// Get gravity.
    Vec3 getGravity() const noexcept { return mvWorld_GetGravity(id()); }
    /// Let bodies fall asleep, or wake all and keep them awake.
    void enableSleeping(bool flag) const noexcept { mvWorld_EnableSleeping(id(), flag); }
    /// May bodies fall asleep?
    bool isSleepingEnabled() const noexcept { return mvWorld_IsSleepingEnabled(id()); }
    /// Keep contact impulses from step to step, or not.
    void enableWarmStarting(bool flag) const noexcept { mvWorld_EnableWarmStarting(id(), flag); }
    /// Are contact impulses kept from step to step?
    bool isWarmStartingEnabled() const noexcept { return mvWorld_IsWarmStartingEnabled(id()); }
    /// Set the approach speed up to which nothing bounces.
    void setRestitutionThreshold(Float value) const noexcept { mvWorld_SetRestitutionThreshold(id(), value); }
    /// Get the approach speed up to which nothing bounces.
    Float getRestitutionThreshold() const noexcept { return mvWorld_GetRestitutionThreshold(id()); }
    /// Set the approach speed above which collisions make hit events.
    void setHitEventThreshold(Float value) const noexcept { mvWorld_SetHitEventThreshold(id(), value); }
    /// Get the approach speed above which collisions make hit events.
    Float getHitEventThreshold() const noexcept { return mvWorld_GetHitEventThreshold(id()); }
    /// Set how overlap of contacts is recovered.
    void setContactTuning(Float stiffness, Float dampingRatio, Float contactSpeed) const noexcept {
        mvWorld_SetContactTuning(id(), stiffness, dampingRatio, contactSpeed);
    }
    /// Get how overlap of contacts is recovered.
    ContactTuning getContactTuning() const noexcept { return mvWorld_GetContactTuning(id()); }
    /// Set the greatest speed of bodies.
    void setMaximumLinearSpeed(Float maximumLinearSpeed) const noexcept {
        mvWorld_SetMaximumLinearSpeed(id(), maximumLinearSpeed);
    }
    /// Get the greatest speed of bodies.
    Float getMaximumLinearSpeed() const noexcept { return mvWorld_GetMaximumLinearSpeed(id()); }
    /// Set the accuracy to keep: see mvWorldDef.accuracy.
    void setAccuracy(Float accuracy) const noexcept { mvWorld_SetAccuracy(id(), accuracy); }
    /// Get the accuracy to keep.
    Float getAccuracy() const noexcept { return mvWorld_GetAccuracy(id()); }
    /// Get the number of bodies that the next step moves.
    int getAwakeBodyCount() const noexcept { return mvWorld_GetAwakeBodyCount(id()); }
    /// Set the number of threads that step the world.
    void setWorkerCount(int count) const noexcept { mvWorld_SetWorkerCount(id(), count); }
    /// Get the number of threads that step the world.
    int getWorkerCount() const noexcept { return mvWorld_GetWorkerCount(id()); }
    /// Get how long the last step took, by stage.
    Profile getProfile() const noexcept { return mvWorld_GetProfile(id()); }
    /// Get how much there is of everything.
    Counters getCounters() const noexcept { return mvWorld_GetCounters(id()); }
    /// Get conserved quantities and errors.
    StepReport getStepReport() const noexcept { return mvWorld_GetStepReport(id()); }
    /// Get a hash of the state of all bodies and contacts: placements, momenta, impulses and sleep.
    uint64_t getStateHash() const noexcept { return mvWorld_GetStateHash(id()); }

private:
    template <class F> static void* address(F& f) noexcept { return detail::keep<F&>(f); }
    template <class F> static bool overlap(mvShapeId shape, void* context) noexcept {
        return detail::called<detail::Called<F>>(context)(Shape(shape));
    }
    template <class F>
    static mvFloat cast(mvShapeId shape, mvPos point, mvVec3 normal, mvFloat fraction, std::uint64_t material, int triangle,
                        int child, void* context) noexcept {
        const CastHit hit{shape, point, normal, fraction, material, triangle, child};
        return detail::called<detail::Called<F>>(context)(hit);
    }
    template <class F>
    static mvFloat mix(mvFloat a, std::uint64_t materialA, mvFloat b, std::uint64_t materialB, void* context) noexcept {
        return detail::called<detail::Called<F>>(context)(a, materialA, b, materialB);
    }
};

/// A world, destroyed with its owner. Null if it could not be made; lastError() tells why.
class World : public WorldRef {
public:
    /// No world.
    World(std::nullptr_t) noexcept {}
    explicit World(const WorldDef& def = {}) noexcept : WorldRef(whyUnfit() ? mvWorldId{} : mvCreateWorld(&def)) {}
    World(World&& other) noexcept : WorldRef(other.release()) {}
    World& operator=(World&& other) noexcept {
        if (this != &other) {
            reset();
            static_cast<WorldRef&>(*this) = other.release();
        }
        return *this;
    }
    ~World() { reset(); }
    /// Destroy the world now.
    void reset() noexcept {
        if (*this) mvDestroyWorld(release());
    }
    /// Give up ownership.
    mvWorldId release() noexcept {
        const mvWorldId id = this->id();
        static_cast<WorldRef&>(*this) = WorldRef();
        return id;
    }
};

inline WorldRef Body::getWorld() const noexcept { return mvBody_GetWorld(id()); }
inline WorldRef Shape::getWorld() const noexcept { return mvShape_GetWorld(id()); }
inline WorldRef Joint::getWorld() const noexcept { return mvJoint_GetWorld(id()); }

inline Shape Body::createSphereShape(const ShapeDef& def, const Sphere& sphere) const noexcept {
    return mvCreateSphereShape(id(), &def, &sphere);
}
inline Shape Body::createSphereShape(const Sphere& sphere) const noexcept { return createSphereShape({}, sphere); }
inline Shape Body::createCapsuleShape(const ShapeDef& def, const Capsule& capsule) const noexcept {
    return mvCreateCapsuleShape(id(), &def, &capsule);
}
inline Shape Body::createCapsuleShape(const Capsule& capsule) const noexcept { return createCapsuleShape({}, capsule); }
inline Shape Body::createBoxShape(const ShapeDef& def, Float hx, Float hy, Float hz) const noexcept {
    return mvCreateBoxShape(id(), &def, hx, hy, hz);
}
inline Shape Body::createBoxShape(Float hx, Float hy, Float hz) const noexcept { return createBoxShape({}, hx, hy, hz); }
inline Shape Body::createHullShape(const ShapeDef& def, const HullData* hull) const noexcept {
    return mvCreateHullShape(id(), &def, hull);
}
inline Shape Body::createHullShape(const HullData* hull) const noexcept { return createHullShape({}, hull); }
inline Shape Body::createTransformedHullShape(const ShapeDef& def, const HullData* hull, Transform transform,
                                              Vec3 scale) const noexcept {
    return mvCreateTransformedHullShape(id(), &def, hull, transform, scale);
}
inline Shape Body::createPlaneShape(const ShapeDef& def, const Plane& plane) const noexcept {
    return mvCreatePlaneShape(id(), &def, &plane);
}
inline Shape Body::createPlaneShape(const Plane& plane) const noexcept { return createPlaneShape({}, plane); }

} // namespace merev

// Operators --------------------------------------------------------------------------------------------------------
// Of the C structs, so they stand where the structs do and are found from any namespace.

inline mvVec3 operator+(mvVec3 a, mvVec3 b) noexcept { return mvAdd(a, b); }
inline mvVec3 operator-(mvVec3 a, mvVec3 b) noexcept { return mvSub(a, b); }
inline mvVec3 operator-(mvVec3 a) noexcept { return mvNeg(a); }
inline mvVec3 operator*(mvFloat s, mvVec3 a) noexcept { return mvMulSV(s, a); }
inline mvVec3 operator*(mvVec3 a, mvFloat s) noexcept { return mvMulSV(s, a); }
inline mvVec3 operator/(mvVec3 a, mvFloat s) noexcept { return {a.x / s, a.y / s, a.z / s}; }
inline mvVec3& operator+=(mvVec3& a, mvVec3 b) noexcept { return a = mvAdd(a, b); }
inline mvVec3& operator-=(mvVec3& a, mvVec3 b) noexcept { return a = mvSub(a, b); }
inline mvVec3& operator*=(mvVec3& a, mvFloat s) noexcept { return a = mvMulSV(s, a); }
inline bool operator==(mvVec3 a, mvVec3 b) noexcept { return a.x == b.x && a.y == b.y && a.z == b.z; }
inline bool operator!=(mvVec3 a, mvVec3 b) noexcept { return !(a == b); }

/// From one place to another.
inline mvVec3 operator-(mvPos a, mvPos b) noexcept { return mvSubPos(a, b); }
inline mvPos operator+(mvPos p, mvVec3 d) noexcept { return mvOffsetPos(p, d); }
inline mvPos operator-(mvPos p, mvVec3 d) noexcept { return mvOffsetPos(p, mvNeg(d)); }
inline mvPos& operator+=(mvPos& p, mvVec3 d) noexcept { return p = mvOffsetPos(p, d); }
inline bool operator==(mvPos a, mvPos b) noexcept { return a.x == b.x && a.y == b.y && a.z == b.z; }
inline bool operator!=(mvPos a, mvPos b) noexcept { return !(a == b); }

/// First b, then a.
inline mvQuat operator*(mvQuat a, mvQuat b) noexcept { return mvMulQuat(a, b); }
/// Turn a vector.
inline mvVec3 operator*(mvQuat q, mvVec3 v) noexcept { return mvRotateVector(q, v); }
/// First b, then a.
inline mvTransform operator*(mvTransform a, mvTransform b) noexcept { return mvMulTransforms(a, b); }
/// Move a point.
inline mvVec3 operator*(mvTransform t, mvVec3 p) noexcept { return mvTransformPoint(t, p); }
/// Move a point to the world.
inline mvPos operator*(mvWorldTransform t, mvVec3 p) noexcept { return mvTransformWorldPoint(t, p); }
inline mvVec3 operator*(const mvMatrix3& m, mvVec3 v) noexcept { return mvMulMV(m, v); }
inline mvMatrix3 operator*(const mvMatrix3& a, const mvMatrix3& b) noexcept { return mvMulMM(a, b); }

#endif // MEREV_HPP
