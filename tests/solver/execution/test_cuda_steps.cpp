#include <limits>

#include <gtest/gtest.h>

#include "solver/execution/cuda.cuh"
#include "solver/execution/value.hpp"

// Compiled with the host as the device (tests/support/device_on_host): steps that are recorded and repeated.

namespace recoat {
namespace {

/// What decides about steps here: their number, and the largest value of a step's loop.
struct Control {
    std::int64_t step = 0, target = 0;
    double peak = 0, seen = 0;
};

/// Adds 1 to every entry; values are the entries themselves.
struct CountUp {
    static constexpr bool measures = true;
    Control* control;
    double* peak;
    double* entry;
    std::size_t capacity;

    [[nodiscard]] bool open() const { return control->step < control->target; }
    [[nodiscard]] std::size_t size() const { return capacity; }
    double operator()(std::size_t k) const { return entry[k] += 1; }
};

struct End {
    Control* control;
    [[nodiscard]] bool running() const { return control->step < control->target; }
    void operator()() const {
        control->seen = control->peak;
        control->peak = 0;
        ++control->step;
    }
};

/// A space with an array of its own, and steps that count it up.
class Counter {
public:
    explicit Counter(std::size_t n) : n_(n) {
        control_.assign(space_, {});
        space_.fill(entries_, n_, 0.0);
    }

    Control advance(std::int64_t steps) {
        Control control = control_.read(space_);
        control.target = control.step + steps;
        control_.assign(space_, control);
        const End end{control_.data()};
        space_.repeat(steps + 3, end, [&] { space_.run_last(loop(), end); });
        return control_.read(space_);
    }

    void grow() {
        n_ = 2 * entries_.capacity();
        space_.fill(entries_, n_, 0.0);
    }
    void set(std::size_t k, double value) {
        space_.for_each(1, [=, to = entries_.data()](std::size_t) { to[k] = value; });
    }

private:
    [[nodiscard]] CountUp loop() { return {control_.data(), &control_.data()->peak, entries_.data(), n_}; }

    Cuda space_{Resources{Backend::cuda, 1, 0}};
    std::size_t n_;
    DeviceArray<double> entries_;
    Value<Cuda, Control> control_;
};

TEST(CudaSteps, EndWhereTheyShouldAndMeasureEveryBlock) {
    Counter counter(2000);
    Control control = counter.advance(70);
    EXPECT_EQ(control.step, 70);
    EXPECT_EQ(control.seen, 70);
    counter.set(1234, 1e6);
    control = counter.advance(7);
    EXPECT_EQ(control.step, 77);
    EXPECT_EQ(control.seen, 1e6 + 7);
}

TEST(CudaSteps, NotANumberHidesNoLargerValueOfItsWarp) {
    Counter counter(300);
    for (std::size_t lane = 0; lane < 32; ++lane) {
        counter.set(128 + lane, std::numeric_limits<double>::quiet_NaN());
        counter.set(128 + (lane + 11) % 32, 1e9);
        EXPECT_EQ(counter.advance(1).seen, 1e9 + 1) << lane;
        counter.set(128 + lane, 0);
        counter.set(128 + (lane + 11) % 32, 0);
    }
}

TEST(CudaSteps, AreRecordedAgainOnlyWhenMemoryOfTheirOwnSpaceHasMoved) {
    Counter one(300), other(300);
    one.advance(10);
    other.advance(10);
    const auto recordings_of = [](Counter& counter) {
        const std::uint64_t before = host_device.recordings;
        counter.advance(10);
        return host_device.recordings - before;
    };
    recordings_of(one);
    recordings_of(other);
    EXPECT_EQ(recordings_of(one), 0u);
    other.grow();
    EXPECT_EQ(recordings_of(one), 0u) << "the memory of another space has moved";
    EXPECT_GT(recordings_of(other), 0u);
    EXPECT_EQ(other.advance(1).seen, 11);
    one.grow();
    EXPECT_GT(recordings_of(one), 0u);
    EXPECT_EQ(recordings_of(other), 0u);
    EXPECT_EQ(one.advance(1).seen, 11);
}

}  // namespace
}  // namespace recoat
