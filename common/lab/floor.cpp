// The machine's own floor: how long arithmetic takes when each operation waits for the last.
#include <nutshell/lab/study.hpp>

namespace nutshell::lab {

MachineFloor machine_floor() {
    constexpr int chain = 1000;
    const double multiply_add = time_of([] {
        double x = 1, a = 0.999, b = 0.001;
        keep(a), keep(b);  // from here on the compiler cannot know their values
        for (int i = 0; i < chain; ++i) x = x * a + b;
        keep(x);
    });
    const double square_root = time_of([] {
        double x = 2, one = 1;
        keep(one);
        for (int i = 0; i < chain; ++i) x = one / std::sqrt(x);
        keep(x);
    });
    return {multiply_add / chain, square_root / chain};
}

}  // namespace nutshell::lab
