#pragma once

#include <tbb/parallel_for.h>

#include "common/one_copy.hpp"

namespace recoat {

template <class Index, class Body>
RECOAT_ONE_COPY void call_body(const Body& body, Index k) {
    body(k);
}

/// body(k) for 0 <= k < count, on all threads; calls are independent. The library that runs them has several places
/// from which it calls, chosen by who is idle: hence one copy of the body for all.
template <class Index, class Body>
void for_each_in_parallel(Index count, const Body& body) {
    tbb::parallel_for(Index{0}, count, [&](Index k) { call_body<Index, Body>(body, k); });
}

}  // namespace recoat
