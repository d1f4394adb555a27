// A library of another binary interface: this program pretends to have loaded one.
#include "check.hpp"

#include <cstring>

extern "C" std::int32_t mvGetAbiRevision(void) { return MV_ABI_REVISION + 1; }

int main() {
    CHECK(whyUnfit() != nullptr);
    World world;
    CHECK(!world && mvGetWorldCount() == 0);
    const Error error = lastError();
    CHECK(error && std::strstr(error.message, "use header and library of one installation"));
    CHECK(BodyDef().internalValue == 0 && !Hull(Span<const Vec3>()));
    std::printf("%s\n", error.message);
    return 0;
}
