// The scene that every binding computes, in C++: the calls and their order are those of bindings/README.md.
#include "merev.hpp"

#include <cinttypes>
#include <cstdio>

using namespace merev;

static Body box(WorldRef world, double x, double y, double z) {
    BodyDef def;
    def.type = mv_dynamicBody;
    def.position = {Float(x), Float(y), Float(z)};
    const Body body = world.createBody(def);
    body.createBoxShape(0.5f, 0.5f, 0.5f);
    return body;
}

int main() {
    World world;
    const Body ground = world.createBody({});
    ground.createPlaneShape({{0, 1, 0}, 0});

    // A pyramid of 10 boxes.
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4 - row; ++column) {
            box(world, 1.25 * column + 0.625 * row, 0.5 + row, 0);
        }
    }

    // An arm that a motor turns, a pendulum at its end, and a box on a spring.
    const Body link = box(world, 0, 6, 4);
    RevoluteJointDef hinge;
    hinge.base.bodyIdA = ground;
    hinge.base.bodyIdB = link;
    hinge.base.localFrameA.p = {0, 6, 4};
    hinge.enableMotor = true;
    hinge.motorSpeed = 1;
    hinge.maxMotorTorque = 1000000;
    world.createRevoluteJoint(hinge);
    SphericalJointDef ball;
    ball.base.bodyIdA = link;
    ball.base.bodyIdB = box(world, 2, 6, 4);
    ball.base.localFrameA.p.x = 1;
    ball.base.localFrameB.p.x = -1;
    world.createSphericalJoint(ball);
    DistanceJointDef spring;
    spring.base.bodyIdA = ground;
    spring.base.bodyIdB = box(world, 8, 4, 0);
    spring.base.localFrameA.p = {8, 8, 0};
    spring.length = 3;
    spring.enableSpring = true;
    spring.hertz = 2;
    spring.dampingRatio = 0.125f;
    world.createDistanceJoint(spring);

    for (int step = 0; step < 120; ++step) {
        world.step(Float(0.015625), 4);
    }
    std::printf("%016" PRIx64 "\n", world.getStateHash());
    if (const Error error = lastError()) {
        std::printf("%s\n", error.message);
        return 1;
    }
    return 0;
}
