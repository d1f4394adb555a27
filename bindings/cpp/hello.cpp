// A box falls onto a floor and comes to rest.
#include "merev.hpp"

#include <cstdio>

int main() {
    merev::World world;
    if (!world) {
        std::printf("%s\n", merev::lastError().message);
        return 1;
    }

    // The floor: a static body with a plane, its upper side at y = 0.
    world.createBody({}).createPlaneShape({{0, 1, 0}, 0});

    // The box: a dynamic body, a cube of side 1, 4 m up.
    merev::BodyDef def;
    def.type = mv_dynamicBody;
    def.position = {0, 4, 0};
    merev::Body box = world.createBody(def);
    box.createBoxShape(0.5f, 0.5f, 0.5f);

    // Two seconds, sixty steps a second, four sub-steps each.
    for (int step = 1; step <= 120; ++step) {
        world.step(merev::Float(1.0 / 60), 4);
        if (step % 20 == 0) {
            std::printf("%4.2f s  height %6.3f m\n", step / 60.0, double(box.getPosition().y));
        }
    }

    // Look down from above.
    merev::RayResult hit = world.castRayClosest({0, 10, 0}, {0, -20, 0}, mvDefaultQueryFilter());
    std::printf("a ray meets the %s at height %.3f m\n", merev::Shape(hit.shapeId).getBody() == box ? "box" : "floor",
                double(hit.point.y));

    // A mistake is told, not followed.
    const merev::Error error = merev::attempt([&] { box.setLinearVelocity({NAN, 0, 0}); });
    std::printf("error %d: %s\n", error.code, error.message);

    return error.code == mv_errorNotFinite && hit.point.y > 0.99f && hit.point.y < 1.01f ? 0 : 1;
}
