/// Heads and series, which name other files: any text that one of their readers takes for its own.

#include <cstdint>
#include <string>

#include "analyzer/readers/vtk_series.hpp"
#include "tests/fuzz/named_content.hpp"
#include "tests/fuzz/properties.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace recoat;
    const Content content{.file = "input",
                          .bytes = {reinterpret_cast<const char*>(data), size},
                          .packed = false,
                          .load = fuzz::load_named};
    for (const Reader& reader : {vtk_pieces_reader, vtk_collection_reader, vtk_series_reader}) {
        fuzz::must_read_or_refuse([&] {
            if (reader.recognises(content)) fuzz::check_reader(reader, content);
        });
    }
    return 0;
}
