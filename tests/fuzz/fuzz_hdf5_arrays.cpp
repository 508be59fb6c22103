/// A state file whose arrays, attributes and links are changed by the recipe that the bytes are.

#include <algorithm>
#include <cstdint>
#include <string>

#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/properties.hpp"
#include "tests/fuzz/state_mutations.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace recoat;
    static const std::string whole = fuzz::small_state_file();
    constexpr std::size_t longest_recipe = 200;
    const fuzz::MemoryFile file(whole);
    fuzz::mutate(file.path(), {data, std::min(size, longest_recipe)});
    const Content content{.file = file.path(), .bytes = whole, .packed = false};
    for (const Reader& reader : readers()) {
        bool own = false;
        fuzz::must_read_or_refuse([&] { own = reader.recognises(content); });
        if (own) return fuzz::check_reader(reader, content), 0;
    }
    return 0;
}
