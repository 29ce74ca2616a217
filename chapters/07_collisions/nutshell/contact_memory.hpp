// Chapter 7 · Warm start: the contacts of the last step are found again, and begin with the
// impulses they had. A pile at rest then needs next to nothing new.
#pragma once
#include <cstdint>
#include <nutshell/contact_solver.hpp>

namespace nutshell {

// [take_over]
/// A contact begins with the impulses that the same contact ended with, `old`, a step ago. Its
/// bodies may have changed places since, and its normal has turned a little: what was across the
/// old one is laid across the new.
inline void take_over(PressedContact& c, const PressedContact& old) {
    // exercise 7.10
    const double sign = old.a == c.a ? 1 : -1;  // friction pushes b, and a the other way
    c.normal_impulse = old.normal_impulse;
    c.friction = sign * (old.friction - c.normal.dot(old.friction) * c.normal);
    // end 7.10
}
// [/take_over]

// [contact_memory]
/// The contacts of one step, to be found by their two bodies and their feature: a hash table with
/// open addressing.
class ContactMemory {
  public:
    /// Takes the contacts over; what is in `contacts` afterwards is of no use.
    void remember(std::vector<PressedContact>& contacts) {
        last_.swap(contacts);
        std::size_t size = 16;
        while (size < 2 * last_.size()) size *= 2;
        table_.assign(size, 0);
        for (std::size_t i = 0; i < last_.size(); ++i) {
            std::size_t place = place_of(last_[i]);
            while (table_[place] != 0) place = (place + 1) % size;
            table_[place] = i + 1;
        }
    }

    /// Gives a contact the impulses it had. @return whether it was there
    bool recall(PressedContact& c) const {
        if (table_.empty()) return false;
        for (std::size_t place = place_of(c); table_[place] != 0;
             place = (place + 1) % table_.size()) {
            const PressedContact& old = last_[table_[place] - 1];
            const bool same = old.a == c.a && old.b == c.b,
                       swapped = old.a == c.b && old.b == c.a;
            if (old.feature != c.feature || (!same && !swapped)) continue;
            take_over(c, old);
            return true;
        }
        return false;
    }

  private:
    std::vector<PressedContact> last_;
    std::vector<std::size_t> table_;  // number of the contact plus one; 0: free

    std::size_t place_of(const PressedContact& c) const {
        const auto number = [](int i) { return static_cast<std::uint64_t>(i + 1); };
        std::uint64_t key = number(std::min(c.a, c.b)) * 0x9e3779b97f4a7c15u ^
                            number(std::max(c.a, c.b)) * 0xc2b2ae3d27d4eb4fu ^
                            number(c.feature) * 0x165667b19e3779f9u;
        key ^= key >> 32;
        return static_cast<std::size_t>(key) & (table_.size() - 1);
    }
};
// [/contact_memory]

}  // namespace nutshell
