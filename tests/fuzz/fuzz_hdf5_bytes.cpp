/// Any bytes as an HDF5 file.

#include <cstdint>

#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/properties.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace recoat;
    const fuzz::MemoryFile file({reinterpret_cast<const char*>(data), size});
    const Content content{.file = file.path(), .bytes = {reinterpret_cast<const char*>(data), size}, .packed = false};
    if (!content.is_hdf5()) return 0;
    for (const Reader& reader : readers()) {
        bool own = false;
        fuzz::must_read_or_refuse([&] { own = reader.recognises(content); });
        if (own) fuzz::check_reader(reader, content);
    }
    return 0;
}
