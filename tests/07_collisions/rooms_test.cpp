// Chapter 7: rooms by chance, in which nothing may fail.
#include "rooms.hpp"

using namespace nutshell;

namespace {

void check_rooms(std::uint64_t from, std::uint64_t to, double restitution = 0) {
    for (std::uint64_t seed = from; seed <= to; ++seed) {
        RandomRoom room;
        room.seed = seed;
        World world = room.start();
        world.surface.restitution = restitution;
        Engine engine;
        check_room(std::move(world), std::move(engine), seed);
    }
}

}  // namespace

TEST_CASE("Rooms whose bodies bounce: no energy gained with the four relaxing passes that they get") {
    for (const double restitution : {0.5, 0.9}) check_rooms(1, 60, restitution);
}

TEST_CASE("10^3 rooms of boxes and spheres by chance: no NaN, nobody escapes, no energy gained") {
    check_rooms(1, 1000);
}

TEST_CASE("10^5 rooms of boxes and spheres by chance", "[.million]") {
    check_rooms(1001, 100000);
}
