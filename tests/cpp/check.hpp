// What the C++ tests share.
#include "merev.hpp"

#include <cstdio>
#include <cstdlib>

#define CHECK(condition)                                                        \
    do {                                                                        \
        if (!(condition)) {                                                     \
            std::printf("%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
            std::exit(1);                                                       \
        }                                                                       \
    } while (0)

#define NEAR(a, b, tolerance) CHECK(std::fabs(double(a) - double(b)) < (tolerance))

using namespace merev;

inline Body dynamicBox(WorldRef world, Pos position, Float half = Float(0.5)) {
    BodyDef def;
    def.type = mv_dynamicBody;
    def.position = position;
    const Body body = world.createBody(def);
    body.createBoxShape(half, half, half);
    return body;
}

inline void run(WorldRef world, int steps) {
    for (int k = 0; k < steps; ++k) {
        world.step(Float(1.0 / 60), 4);
    }
}
