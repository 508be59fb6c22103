#include "analyzer/readers/packing.hpp"

#include <array>

#include <fmt/format.h>

#include "analyzer/readers/bzip2.hpp"
#include "analyzer/readers/gzip.hpp"
#include "analyzer/readers/unpacking.hpp"
#include "analyzer/readers/xz.hpp"
#include "analyzer/readers/zstd.hpp"
#include "common/error.hpp"

namespace recoat {
namespace {

constexpr std::array<Packing, 4> packings = {{{"gzip", is_gzip, unpack_gzip},
                                              {"bzip2", is_bzip2, unpack_bzip2},
                                              {"xz", is_xz, unpack_xz},
                                              {"zstd", is_zstd, unpack_zstd}}};

}  // namespace

const Packing* packing_of(std::string_view bytes) {
    for (const Packing& packing : packings) {
        if (packing.begins(bytes)) return &packing;
    }
    return nullptr;
}

std::string unpack(const Packing& packing, std::string_view packed, const std::string& file) {
    try {
        return packing.unpack(packed);
    } catch (const PackingError& error) {
        throw InputError(
            fmt::format("{}: the compressed data are damaged or end too early ({}); copy the file again from where it "
                        "was made",
                        file, error.what()));
    }
}

}  // namespace recoat
