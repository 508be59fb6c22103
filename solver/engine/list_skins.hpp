#pragma once

namespace recoat {

/// How far ahead the pair lists look. It changes run time, and results only by the order of sums; the defaults are
/// those that cost least in docs/accuracy.md.
struct ListSkins {
    double far = 0.1;         ///< beyond the range of the force, of the list that is made over cells [d_p]
    double close_steps = 25;  ///< steps that the list made from it should last

    friend bool operator==(const ListSkins&, const ListSkins&) = default;
};

}  // namespace recoat
