#pragma once

#include "analyzer/readers/reader.hpp"

namespace recoat {

/// Whether the file is a table of results as EDEM exports it: lines "Q05 : Particle Position X (m):,1,2,3".
bool is_edem_queries(const Content& content);

/// Reads the queries of each time: a line has one value for every particle, behind the name of the query, which may
/// carry its unit. Times count from 0.
Series open_edem_queries(const Content& content, const ReadOptions& options);

inline constexpr Reader edem_queries_reader = {"edem-queries", "results that EDEM exports, a line for each query",
                                               is_edem_queries, open_edem_queries};

}  // namespace recoat
