// Joints, events, queries and callbacks.
#include "check.hpp"

#include <vector>

static void events_are_spans() {
    World world;
    ShapeDef shapeDef;
    shapeDef.enableContactEvents = shapeDef.enableHitEvents = true;
    const Shape floor = world.createBody({}).createPlaneShape(shapeDef, {{0, 1, 0}, 0});
    BodyDef def;
    def.type = mv_dynamicBody;
    def.position = {0, 2, 0};
    const Body ball = world.createBody(def);
    const Shape shape = ball.createSphereShape(shapeDef, {{0, 0, 0}, Float(0.5)});
    int begins = 0, hits = 0, moves = 0;
    for (int k = 0; k < 120; ++k) {
        world.step(Float(1.0 / 60), 4);
        const ContactEvents events = world.getContactEvents();
        for (const ContactBeginTouchEvent& e : events.beginEvents) {
            const bool both = (Shape(e.shapeIdA) == floor && Shape(e.shapeIdB) == shape) ||
                              (Shape(e.shapeIdA) == shape && Shape(e.shapeIdB) == floor);
            CHECK(both);
            ++begins;
        }
        hits += events.hitEvents.size();
        for (const BodyMoveEvent& e : world.getBodyEvents()) {
            CHECK(Body(e.bodyId) == ball);
            ++moves;
        }
    }
    CHECK(begins >= 1 && hits >= 1 && moves > 30);
    CHECK(world.getJointEvents().empty() && !lastError());
    ball.setAwake(true);
    mvBodyId ids[2];
    WorldTransform transforms[2];
    CHECK(world.getAwakeBodies(ids, transforms, nullptr, nullptr, 2) == 1);
    CHECK(Body(ids[0]) == ball && transforms[0].p == ball.getPosition());
}

static void drawings_are_spans() {
    World world;
    dynamicBox(world, {1, 2, 3});
    const DrawBuffers drawn = world.drawBuffers();
    CHECK(drawn.instances.size() == 1 && drawn.triangles.empty() && !lastError());
    const mvDrawInstance& box = drawn.instances[0];
    CHECK(box.transform.p.x == 1 && box.transform.p.y == 2 && box.transform.p.z == 3);

    DebugDraw nothing;
    nothing.drawShapes = nothing.drawJoints = false;
    CHECK(world.drawBuffers(nothing).instances.empty() && !lastError());

    int boxes = 0;
    DebugDraw counting;
    counting.context = &boxes;
    counting.DrawBoxFcn = [](const mvVec3*, const mvWorldTransform*, mvHexColor, void* count) {
        ++*static_cast<int*>(count);
    };
    world.draw(counting);
    CHECK(boxes == 1 && !lastError());
}

static void queries_call_lambdas() {
    World world;
    std::vector<Body> boxes;
    for (int k = 0; k < 5; ++k) {
        boxes.push_back(dynamicBox(world, {Float(3 * k), 0, 0}));
    }
    const QueryFilter all = mvDefaultQueryFilter();
    std::vector<Body> met;
    world.overlapAABB({{-1, -1, -1}, {4, 1, 1}}, all, [&](Shape s) {
        met.push_back(s.getBody());
        return true;
    });
    CHECK(met.size() == 2);

    // Only the first of them: the nearest box is found by clipping the ray.
    Float nearest = 1;
    Body first;
    world.castRay({-5, 0, 0}, {20, 0, 0}, all, [&](const CastHit& hit) {
        if (hit.fraction < nearest) {
            nearest = hit.fraction;
            first = hit.shape.getBody();
        }
        return hit.fraction;
    });
    CHECK(first == boxes[0]);
    NEAR(nearest, 4.5 / 20, 1e-5);
    CHECK(Shape(world.castRayClosest({-5, 0, 0}, {20, 0, 0}, all).shapeId).getBody() == boxes[0]);

    const Vec3 point[] = {{0, 0, 0}};
    const ShapeProxy ball{point, 1, 1};
    int touched = 0;
    const auto count = [&](Shape) { return ++touched, true; };
    world.overlapShape({0, 0, 0}, ball, all, count);
    CHECK(touched == 1);
    int cast = 0;
    world.castShape({-5, 0, 0}, ball, {20, 0, 0}, all, [&](const CastHit&) { return ++cast, Float(1); });
    CHECK(cast == 5);
    RayResult results[3];
    CHECK(world.castRayAll({-5, 0, 0}, {20, 0, 0}, all, results) == 5);
    CHECK(Shape(results[2].shapeId).getBody() == boxes[2] && !lastError());
}

static void callbacks_act() {
    World world;
    world.createBody({}).createPlaneShape({{0, 1, 0}, 0});
    BodyDef def;
    def.type = mv_dynamicBody;
    def.position = {0, 1, 0};
    ShapeDef shapeDef;
    shapeDef.enableCustomFiltering = shapeDef.enablePreSolveEvents = true;
    const Body body = world.createBody(def);
    body.createSphereShape(shapeDef, {{0, 0, 0}, Float(0.5)});

    // A lambda without captures may be a temporary; here it lets the ball through.
    world.setCustomFilterCallback([](Shape, Shape) { return false; });
    run(world, 60);
    CHECK(body.getPosition().y < -1);
    world.setCustomFilterCallback(nullptr);

    int asked = 0;
    auto preSolve = [&](Shape, Shape, Pos, Vec3 normal) {
        NEAR(std::fabs(double(normal.y)), 1, 1e-3);
        ++asked;
        return true;
    };
    world.setPreSolveCallback(preSolve);
    int mixed = 0;
    auto friction = [&](Float a, std::uint64_t, Float b, std::uint64_t) { return ++mixed, a * b; };
    world.setFrictionCallback(friction);
    world.setRestitutionCallback([](Float, std::uint64_t, Float, std::uint64_t) { return Float(0); });
    body.setTransform({0, 1, 0}, mvQuat_identity);
    body.setLinearVelocity({0, 0, 0});
    run(world, 60);
    NEAR(body.getPosition().y, 0.5, 0.02);
    CHECK(asked > 0 && mixed > 0);
    world.setPreSolveCallback(nullptr);
    world.setFrictionCallback(nullptr);
    world.setRestitutionCallback(nullptr);

    // Inside a callback the world may be read but not changed.
    mvErrorCode code = mv_errorNone;
    auto meddle = [&](Shape) {
        code = attempt([&] { return world.createBody({}); }).error.code;
        return false;
    };
    world.overlapAABB({{-1, -1, -1}, {1, 1, 1}}, mvDefaultQueryFilter(), meddle);
    CHECK(code == mv_errorLocked);
}

template <class J, class D> static void joint(WorldRef world, D def, J (WorldRef::*create)(const D&) const noexcept, mvJointType type) {
    def.base.bodyIdA = dynamicBox(world, {0, 0, 0});
    def.base.bodyIdB = dynamicBox(world, {3, 0, 0});
    const J made = (world.*create)(def);
    CHECK(made && made.isValid() && made.getType() == type && made.getBodyA() == Body(def.base.bodyIdA));
    CHECK(made.getWorld() == world && made.getBodyB().getJointCount() == 1);
    made.destroy();
    CHECK(!made.isValid() && !lastError());
}

static void joints_of_every_kind() {
    World world;
    joint(world, ParallelJointDef(), &WorldRef::createParallelJoint, mv_parallelJoint);
    joint(world, DistanceJointDef(), &WorldRef::createDistanceJoint, mv_distanceJoint);
    joint(world, FilterJointDef(), &WorldRef::createFilterJoint, mv_filterJoint);
    joint(world, MotorJointDef(), &WorldRef::createMotorJoint, mv_motorJoint);
    joint(world, PrismaticJointDef(), &WorldRef::createPrismaticJoint, mv_prismaticJoint);
    joint(world, RevoluteJointDef(), &WorldRef::createRevoluteJoint, mv_revoluteJoint);
    joint(world, SphericalJointDef(), &WorldRef::createSphericalJoint, mv_sphericalJoint);
    joint(world, WeldJointDef(), &WorldRef::createWeldJoint, mv_weldJoint);
    joint(world, WheelJointDef(), &WorldRef::createWheelJoint, mv_wheelJoint);
    joint(world, UniversalJointDef(), &WorldRef::createUniversalJoint, mv_universalJoint);
    joint(world, SixDofJointDef(), &WorldRef::createSixDofJoint, mv_sixDofJoint);
    joint(world, PulleyJointDef(), &WorldRef::createPulleyJoint, mv_pulleyJoint);
    joint(world, ScrewJointDef(), &WorldRef::createScrewJoint, mv_screwJoint);
}

// A hinge with a motor turns at the speed that was asked for; a gear makes a second one follow.
static void gears_turn() {
    World world;
    const Body ground = world.createBody({});
    RevoluteJointDef hinge;
    hinge.base.bodyIdA = ground;
    hinge.base.bodyIdB = dynamicBox(world, {0, 0, 0});
    hinge.enableMotor = true;
    hinge.motorSpeed = 2;
    hinge.maxMotorTorque = 1000000;
    const RevoluteJoint driven = world.createRevoluteJoint(hinge);
    hinge.enableMotor = false;
    hinge.base.localFrameA.p = {5, 0, 0};
    hinge.base.bodyIdB = dynamicBox(world, {5, 0, 0});
    const RevoluteJoint follower = world.createRevoluteJoint(hinge);
    GearJointDef gearDef;
    gearDef.base.bodyIdA = driven.getBodyB();
    gearDef.base.bodyIdB = follower.getBodyB();
    gearDef.jointIdA = driven;
    gearDef.jointIdB = follower;
    gearDef.ratio = 2;
    const GearJoint gear = world.createGearJoint(gearDef);
    CHECK(gear && gear.getRatio() == 2);
    run(world, 60);
    NEAR(driven.getAngle(), 2, 0.05);
    NEAR(follower.getAngle(), -1, 0.05);
    NEAR(driven.getSpeed(), 2, 0.05);
    CHECK(driven.isMotorEnabled() && !follower.isMotorEnabled() && !lastError());
}

int main() {
    events_are_spans();
    drawings_are_spans();
    queries_call_lambdas();
    callbacks_act();
    joints_of_every_kind();
    gears_turn();
    CHECK(mvGetWorldCount() == 0);
    std::printf("world: fine\n");
    return 0;
}
