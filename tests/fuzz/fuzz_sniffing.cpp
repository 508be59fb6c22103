/// Any bytes but HDF5 through the whole way of a file: unpacked, recognised, read.

#include <cstdint>
#include <string>

#include "tests/fuzz/named_content.hpp"
#include "tests/fuzz/properties.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace recoat;
    fuzz::must_read_or_refuse([&] {
        Content content = make_content("input", {reinterpret_cast<const char*>(data), size});
        content.load = fuzz::load_named;
        if (content.is_hdf5()) return;  // would be opened by its name
        const Recording recording(std::move(content));
        fuzz::require(!recording.steps().empty(), "a time step at least");
        fuzz::check_source(recording.read(recording.steps().size() - 1));
    });
    return 0;
}
