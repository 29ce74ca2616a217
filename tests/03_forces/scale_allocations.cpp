// A step allocates nothing: every request for memory in this program is counted while the methods run.
#include <cstdlib>
#include <new>
#include <nutshell/chain_scenes.hpp>
#include <nutshell/forces_methods.hpp>
#include <nutshell/lab/run.hpp>
#include "check.hpp"
#include "one_pass.hpp"

namespace {
long allocations = 0;
}

[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

using namespace nutshell;

namespace {

/// Requests for memory in 100 steps, after a first one that may make the run's room for forces.
template <class Scene, class Method>
long allocations_of(const Scene& scene, const Method& method) {
    auto step = method.start(scene);
    auto state = step(scene.start, scene, 0.0, 1e-3);
    const long before = allocations;
    for (int n = 1; n <= 100; ++n) state = step(std::move(state), scene, n * 1e-3, 1e-3);
    lab::keep(state.position.x[0]);
    return allocations - before;
}

template <class Scene>
void check_methods(const Scene& scene) {
    const auto check = [&](const auto& method) {
        INFO(method.name);
        CHECK(allocations_of(scene, method) == 0);
    };
    each(kick_and_drift_methods, check);
    check(one_pass);
}

}  // namespace

TEST_CASE("The count counts") {
    const long before = allocations;
    const Particles some(10);
    CHECK(allocations - before == 7);  // mass, three of position, three of velocity
}

TEST_CASE(
    "A step of many particles allocates nothing, with any method that kicks and drifts "
    "and in one pass") {
    check_methods(anchored_particles(1000));
    check_methods(chain(500, 0.1, {100, 0.1}, {0, 0, 0}, {50, 0, 0}));
    SpringNet net = cloth(20, 1, 1, 50, Weave::with_shear_and_bend);
    net.held = {0, 19};
    check_methods(net);
}
