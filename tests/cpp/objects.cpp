// Ownership, ids, errors, arrays, operators.
#include "check.hpp"

#include <array>
#include <unordered_set>
#include <vector>

static_assert(sizeof(Body) == sizeof(mvBodyId) && std::is_trivially_copyable_v<Body>, "a handle is an id");
static_assert(!std::is_convertible_v<Body, Shape> && !std::is_convertible_v<Shape, Body>, "kinds do not mix");
static_assert(!std::is_copy_constructible_v<World> && std::is_nothrow_move_constructible_v<World>, "one owner");
static_assert(!std::is_copy_constructible_v<Hull>, "one owner");

static void worlds_are_owned() {
    CHECK(mvGetWorldCount() == 0);
    {
        World a, b;
        CHECK(mvGetWorldCount() == 2);
        a = std::move(b);
        CHECK(mvGetWorldCount() == 1 && a && a.isValid());
        World c = std::move(a);
        CHECK(mvGetWorldCount() == 1 && c.isValid());
        World none = nullptr;
        CHECK(!none && !none.isValid());
        const WorldRef given = World().release();
        CHECK(mvGetWorldCount() == 2);
        given.destroy();
    }
    CHECK(mvGetWorldCount() == 0 && !lastError());
    WorldDef def;
    def.gravity.x = NAN;
    const Result<World> bad = attempt([&] { return World(def); });
    CHECK(!bad && !bad.value && bad.error.code == mv_errorNotFinite && bad.error.message[0]);
}

static void ids_are_values() {
    World world;
    const Body a = dynamicBox(world, {0, 0, 0}), b = dynamicBox(world, {2, 0, 0});
    CHECK(a && a != b && a == Body(a.id()) && (a < b) != (b < a) && Body() == mv_nullBodyId && !Body());
    std::unordered_set<Body, Hash> set{a, b, a};
    CHECK(set.size() == 2);
    CHECK(a.getWorld() == world);
    std::array<mvShapeId, 4> shapes{};
    CHECK(a.getShapeCount() == 1 && a.getShapes(shapes) == 1);
    const Shape shape = shapes[0];
    CHECK(shape.getBody() == a && shape.getType() == mv_hullShape && shape.getWorld() == world);
    a.destroy();
    CHECK(!a.isValid() && b.isValid() && !shape.isValid());
    const Error stale = attempt([&] { a.setLinearVelocity({1, 0, 0}); });
    CHECK(stale && stale.code == mv_errorStale);
    const Result<Vec3> fine = attempt([&] { return b.getLinearVelocity(); });
    CHECK(fine && fine.value == Vec3{});
}

static void shapes_of_all_kinds() {
    World world;
    BodyDef def;
    def.type = mv_dynamicBody;
    const Body body = world.createBody(def);
    ShapeDef shapeDef;
    shapeDef.density = 2;
    NEAR(body.createSphereShape(shapeDef, {{0, 0, 0}, 1}).computeMassData().mass, 8 * MV_PI / 3, 1e-4);
    CHECK(body.createSphereShape({{0, 0, 0}, 1}).getSphere().radius == 1);
    CHECK(body.createCapsuleShape({{0, 0, 0}, {0, 1, 0}, 1}).getType() == mv_capsuleShape);
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Hull hull(corners);
    CHECK(hull && hull.get()->vertexCount == 4);
    const Shape tetrahedron = body.createHullShape(shapeDef, hull);
    NEAR(tetrahedron.computeMassData().mass, 2.0 / 6, 1e-5);
    const BoxHull cube = mvMakeCubeHull(1);
    CHECK(body.createHullShape(&cube.base));
    CHECK(body.createTransformedHullShape(shapeDef, hull, mvTransform_identity, {2, 2, 2}));
    CHECK(world.createBody({}).createPlaneShape({{0, 1, 0}, 0}).getPlane().normal.y == 1);
    tetrahedron.destroy();
    CHECK(!tetrahedron.isValid() && !lastError());
    const Vec3 flat[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(!Hull(flat) && lastError().code == mv_errorDegenerate);
}

static void structs_have_operators() {
    const Vec3 a{1, 2, 3}, b{4, 5, 6};
    CHECK(a + b == (Vec3{5, 7, 9}) && b - a == (Vec3{3, 3, 3}) && -a == Float(-1) * a && a * 2 == a + a && b / 2 * 2 == b);
    Vec3 c = a;
    c += b;
    c -= a;
    c *= 2;
    CHECK(c == b + b && c != b);
    Pos p{1, 1, 1};
    p += a;
    CHECK((p - (Pos{1, 1, 1})) == a && p - a == (Pos{1, 1, 1}) && p + b != p);
    const Quat quarter = mvMakeQuatFromAxisAngle(mvVec3_axisZ, MV_PI / 2);
    NEAR((quarter * mvVec3_axisX).y, 1, 1e-6);
    NEAR((quarter * quarter * mvVec3_axisX).x, -1, 1e-6);
    const Transform t{{1, 0, 0}, quarter};
    NEAR((t * mvVec3_axisX).y, 1, 1e-6);
    NEAR((t * t * Vec3{}).x, 1, 1e-6);
    NEAR((WorldTransform{{0, 0, 5}, quarter} * mvVec3_axisX).z, 5, 1e-6);
    CHECK(mvMat3_identity * mvMat3_identity * a == a);
}

int main() {
    CHECK(whyUnfit() == nullptr);
    worlds_are_owned();
    ids_are_values();
    shapes_of_all_kinds();
    structs_have_operators();
    std::printf("objects: fine\n");
    return 0;
}
