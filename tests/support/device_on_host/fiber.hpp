#pragma once

#include <cstddef>
#include <memory>

#include <ucontext.h>

#ifdef RECOAT_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

/// A thread of a block: a stack of its own on a thread of the host. To the thread sanitizer it is a thread like any
/// other, which sees what others have written only through `Meeting`.
class Fiber {
public:
    Fiber() = default;
    Fiber(const Fiber&) = delete;
    Fiber& operator=(const Fiber&) = delete;
    ~Fiber() {
#ifdef RECOAT_THREAD_SANITIZER
        if (stack_ != nullptr) __tsan_destroy_fiber(known_as_);
#endif
    }

    /// This is where the caller is now.
    void adopt_caller() {
#ifdef RECOAT_THREAD_SANITIZER
        known_as_ = __tsan_get_current_fiber();
#endif
    }
    /// `function` never returns; once per fiber.
    void begin_at(void (*function)()) {
        stack_.reset(new char[stack_bytes]);
#ifdef RECOAT_THREAD_SANITIZER
        known_as_ = __tsan_create_fiber(0);
#endif
        getcontext(&place_);
        place_.uc_stack.ss_sp = stack_.get();
        place_.uc_stack.ss_size = stack_bytes;
        place_.uc_link = nullptr;
        makecontext(&place_, function, 0);
    }
    /// Goes on with another one, until something switches back.
    void switch_to(Fiber& other) {
#ifdef RECOAT_THREAD_SANITIZER
        __tsan_switch_to_fiber(other.known_as_, __tsan_switch_to_fiber_no_sync);
#endif
        swapcontext(&place_, &other.place_);
    }

private:
    static constexpr std::size_t stack_bytes = std::size_t{1} << 17;
    ucontext_t place_{};
    std::unique_ptr<char[]> stack_;
#ifdef RECOAT_THREAD_SANITIZER
    void* known_as_ = nullptr;
#endif
};

/// Where threads of a block meet: who arrives has written before whoever leaves reads. Two places in turn, so that
/// those who are a meeting ahead tell nothing to those who are behind.
class Meeting {
public:
    void arrive([[maybe_unused]] unsigned round) {
#ifdef RECOAT_THREAD_SANITIZER
        __tsan_release(&place_[round % 2]);
#endif
    }
    void leave([[maybe_unused]] unsigned round) {
#ifdef RECOAT_THREAD_SANITIZER
        __tsan_acquire(&place_[round % 2]);
#endif
    }

private:
    char place_[2] = {};
};
