#pragma once

#include <vector>

namespace recoat {

/// One value where the loops of a space run.
template <class Space, class T>
class Value {
public:
    [[nodiscard]] T* data() { return array_.data(); }

    void assign(Space& space, const T& value) { space.copy(std::vector<T>{value}, array_); }
    [[nodiscard]] T read(Space& space) const {
        std::vector<T> value;
        space.copy(array_, value);
        return value.front();
    }

private:
    typename Space::template Array<T> array_;
};

}  // namespace recoat
