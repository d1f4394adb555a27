// Bullet behind peer.h.
#include "peer.h"
#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <btBulletCollisionCommon.h>
#include <btBulletDynamicsCommon.h>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace {

btVector3 vector(const double v[3]) { return btVector3(btScalar(v[0]), btScalar(v[1]), btScalar(v[2])); }

btQuaternion quaternion(const double q[4]) {
    return btQuaternion(btScalar(q[0]), btScalar(q[1]), btScalar(q[2]), btScalar(q[3]));
}

btTransform transform(const double position[3], const double rotation[4]) {
    return btTransform(quaternion(rotation), vector(position));
}

void store(const btVector3 &v, double out[3]) {
    for (int k = 0; k < 3; k++) {
        out[k] = v[k];
    }
}

// A pair has the root of the product, and the greater restitution; Bullet's own rules are two products.
btScalar mixed_friction(const btCollisionObject *a, const btCollisionObject *b) {
    return btSqrt(a->getFriction() * b->getFriction());
}

btScalar mixed_restitution(const btCollisionObject *a, const btCollisionObject *b) {
    return btMax(a->getRestitution(), b->getRestitution());
}

struct Push {
    btVector3 force = btVector3(0, 0, 0);
    btVector3 torque = btVector3(0, 0, 0);
};

// A hull's points in the frame of a body's mass, for all bodies that have it so.
struct Hull {
    unsigned index;
    btTransform at;
    btConvexHullShape *shape;
};

// Members are destroyed from below: the world first.
struct World {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broad_phase;
    btDantzigSolver pivots;
    std::unique_ptr<btSequentialImpulseConstraintSolver> solver;
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<Hull> hulls;
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    std::vector<std::unique_ptr<btTypedConstraint>> joints;
    std::vector<Push> pushes;
    // Those that move with a given velocity.
    std::vector<btRigidBody *> movers;
    std::unique_ptr<btDiscreteDynamicsWorld> world;
    btScalar dt = 0;
    unsigned sub_steps = 1;

    ~World() {
        for (auto &joint : joints) {
            world->removeConstraint(joint.get());
        }
        for (auto &body : bodies) {
            world->removeRigidBody(body.get());
        }
    }

    template <typename Shape> Shape *keep(Shape *shape) {
        shapes.emplace_back(shape);
        return shape;
    }
};

btConvexHullShape *hull_at(World &w, const peer_scene &scene, unsigned index, const btTransform &at) {
    for (const Hull &hull : w.hulls) {
        if (hull.index == index && hull.at == at) {
            return hull.shape;
        }
    }
    auto *shape = w.keep(new btConvexHullShape());
    const peer_hull &hull = scene.hulls[index];
    for (unsigned k = 0; k < hull.point_count; k++) {
        shape->addPoint(at * vector(hull.points + 3 * k), false);
    }
    shape->recalcLocalAabb();
    // Else it would be 40 mm larger all around.
    shape->setMargin(0);
    w.hulls.push_back({index, at, shape});
    return shape;
}

// A shape, and where it lies in the body: hulls and capsules along an axis need no place.
btCollisionShape *make_shape(World &w, const peer_scene &scene, const peer_shape &s, btTransform &at) {
    at = transform(s.position, s.rotation);
    switch (s.kind) {
    case PEER_BOX:
        return w.keep(new btBoxShape(vector(s.size)));
    case PEER_SPHERE:
        return w.keep(new btSphereShape(btScalar(s.size[0])));
    case PEER_CAPSULE: {
        btScalar radius = btScalar(s.size[0]), length = btScalar(2.0 * s.size[1]);
        if (std::fabs(at.getBasis().getColumn(2).y()) > btScalar(0.999999)) {
            at.setRotation(btQuaternion::getIdentity());
            return w.keep(new btCapsuleShape(radius, length));
        }
        return w.keep(new btCapsuleShapeZ(radius, length));
    }
    default: {
        btCollisionShape *shape = hull_at(w, scene, s.hull, at);
        at.setIdentity();
        return shape;
    }
    }
}

btCollisionShape *shape_of(World &w, const peer_scene &scene, const peer_body &body) {
    btTransform at;
    const peer_shape *first = scene.shapes + body.first_shape;
    if (body.shape_count == 1) {
        btCollisionShape *shape = make_shape(w, scene, *first, at);
        if (at == btTransform::getIdentity()) {
            return shape;
        }
        auto *compound = w.keep(new btCompoundShape());
        compound->addChildShape(at, shape);
        return compound;
    }
    auto *compound = w.keep(new btCompoundShape());
    for (unsigned k = 0; k < body.shape_count; k++) {
        btCollisionShape *shape = make_shape(w, scene, first[k], at);
        compound->addChildShape(at, shape);
    }
    return compound;
}

void add_body(World &w, const peer_scene &scene, const peer_body &body) {
    bool moves = body.kind == PEER_DYNAMIC;
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(moves ? body.mass : 0.0), nullptr,
                                                  shape_of(w, scene, body),
                                                  moves ? vector(body.inertia) : btVector3(0, 0, 0));
    info.m_startWorldTransform = transform(body.position, body.rotation);
    info.m_friction = btScalar(body.friction);
    info.m_restitution = btScalar(body.restitution);
    w.bodies.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody *b = w.bodies.back().get();
    if (body.kind == PEER_KINEMATIC) {
        b->setCollisionFlags(b->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    }
    if (!scene.sleeps || body.kind == PEER_KINEMATIC) {
        b->setActivationState(DISABLE_DEACTIVATION);
    }
    const int loose = btBroadphaseProxy::DefaultFilter, firm = btBroadphaseProxy::StaticFilter;
    int all = moves ? int(btBroadphaseProxy::AllFilter) : int(btBroadphaseProxy::AllFilter ^ firm);
    w.world->addRigidBody(b, moves ? loose : firm, body.collides ? all : 0);
    b->setLinearVelocity(vector(body.velocity));
    b->setAngularVelocity(vector(body.spin));
    b->setInterpolationLinearVelocity(b->getLinearVelocity());
    b->setInterpolationAngularVelocity(b->getAngularVelocity());
    if (body.kind == PEER_KINEMATIC) {
        // Bullet takes the velocity from the last place and this one.
        btTransform before;
        btTransformUtil::integrateTransform(b->getWorldTransform(), -b->getLinearVelocity(),
                                            -b->getAngularVelocity(), w.dt, before);
        b->setInterpolationWorldTransform(before);
        w.movers.push_back(b);
    }
}

const char *add_joint(World &w, const peer_joint &j) {
    btRigidBody &a = *w.bodies[j.bodies[0]], &b = *w.bodies[j.bodies[1]];
    btTransform p = transform(j.position[0], j.rotation[0]), q = transform(j.position[1], j.rotation[1]);
    std::unique_ptr<btTypedConstraint> joint;
    switch (j.kind) {
    case PEER_BALL:
        joint = std::make_unique<btPoint2PointConstraint>(a, b, p.getOrigin(), q.getOrigin());
        break;
    case PEER_HINGE:
        joint = std::make_unique<btHingeConstraint>(a, b, p, q);
        break;
    case PEER_WELD:
        joint = std::make_unique<btFixedConstraint>(a, b, p, q);
        break;
    case PEER_SLIDER:
        if (j.springs) {
            auto slider = std::make_unique<btGeneric6DofSpring2Constraint>(a, b, p, q);
            // Free where the lower limit is above the upper one; all others stay at 0.
            slider->setLimit(0, 1, -1);
            for (int k = 1; k < 6; k++) {
                slider->setLimit(k, 0, 0);
            }
            slider->enableSpring(0, true);
            // As the scene says, not limited by the step.
            slider->setStiffness(0, btScalar(j.stiffness), false);
            slider->setDamping(0, btScalar(j.damping), false);
            slider->setEquilibriumPoint(0, 0);
            joint = std::move(slider);
        } else {
            joint = std::make_unique<btSliderConstraint>(a, b, p, q, true);
        }
        break;
    default:
        return "Bullet has no rods and no springs between two points";
    }
    w.world->addConstraint(joint.get(), true);
    w.joints.push_back(std::move(joint));
    return nullptr;
}

void advance(World &w) {
    for (unsigned s = 0; s < w.sub_steps; s++) {
        for (size_t k = 0; k < w.bodies.size(); k++) {
            const Push &push = w.pushes[k];
            if (!push.force.isZero() || !push.torque.isZero()) {
                w.bodies[k]->applyCentralForce(push.force);
                w.bodies[k]->applyTorque(push.torque);
            }
        }
        w.world->stepSimulation(w.dt, 0);
        for (btRigidBody *b : w.movers) {
            btTransform next;
            btTransformUtil::integrateTransform(b->getWorldTransform(), b->getLinearVelocity(),
                                                b->getAngularVelocity(), w.dt, next);
            b->setWorldTransform(next);
        }
    }
}

} // namespace

extern "C" {
PEER_FUNCTIONS(bullet)

void *bullet_create(const peer_scene *scene, const peer_setting *setting, char *why, unsigned why_size) {
    gCalculateCombinedFrictionCallback = mixed_friction;
    gCalculateCombinedRestitutionCallback = mixed_restitution;
    auto w = std::make_unique<World>();
    w->dt = btScalar(setting->dt);
    w->sub_steps = setting->sub_steps;
    if (setting->solver == 1) {
        w->solver = std::make_unique<btNNCGConstraintSolver>();
    } else if (setting->solver == 2) {
        w->solver = std::make_unique<btMLCPSolver>(&w->pivots);
    } else {
        w->solver = std::make_unique<btSequentialImpulseConstraintSolver>();
    }
    w->world = std::make_unique<btDiscreteDynamicsWorld>(&w->dispatcher, &w->broad_phase, w->solver.get(),
                                                         &w->configuration);
    w->world->setGravity(vector(scene->gravity));
    btContactSolverInfo &info = w->world->getSolverInfo();
    if (setting->solver == 2) {
        // One matrix for each island, as Bullet's own examples set it.
        info.m_minimumSolverBatchSize = 1;
    }
    if (setting->iterations > 0) {
        info.m_numIterations = int(setting->iterations);
    }
    if (scene->restitution_threshold >= 0.0) {
        info.m_restitutionVelocityThreshold = btScalar(scene->restitution_threshold);
    }
    w->pushes.resize(scene->body_count);
    for (unsigned k = 0; k < scene->body_count; k++) {
        add_body(*w, *scene, scene->bodies[k]);
    }
    for (unsigned k = 0; k < scene->joint_count; k++) {
        if (const char *problem = add_joint(*w, scene->joints[k])) {
            std::snprintf(why, why_size, "%s", problem);
            return nullptr;
        }
    }
    return w.release();
}

void bullet_step(void *world) {
    World &w = *static_cast<World *>(world);
    advance(w);
    for (Push &push : w.pushes) {
        push = Push();
    }
}

void bullet_push(void *world, unsigned body, const double force[3], const double torque[3]) {
    Push &push = static_cast<World *>(world)->pushes[body];
    push.force += vector(force);
    push.torque += vector(torque);
}

void bullet_motions(const void *world, peer_motion *out) {
    const World &w = *static_cast<const World *>(world);
    for (size_t k = 0; k < w.bodies.size(); k++) {
        const btRigidBody &b = *w.bodies[k];
        btQuaternion q = b.getWorldTransform().getRotation();
        store(b.getWorldTransform().getOrigin(), out[k].position);
        store(b.getLinearVelocity(), out[k].velocity);
        store(b.getAngularVelocity(), out[k].spin);
        out[k].rotation[0] = q.x(), out[k].rotation[1] = q.y();
        out[k].rotation[2] = q.z(), out[k].rotation[3] = q.w();
    }
}

int bullet_is_broken(const void *) { return 0; }

void bullet_destroy(void *world) { delete static_cast<World *>(world); }

const char *bullet_version(void) {
    static const std::string version =
        std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
    return version.c_str();
}
}
