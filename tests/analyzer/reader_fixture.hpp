#pragma once

#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "analyzer/readers/reader.hpp"
#include "common/error.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/throws_message.hpp"

namespace recoat::testing {

/// Hands texts to the readers as a file of one name.
class ReaderTest : public ::testing::Test {
protected:
    [[nodiscard]] Source read(std::string_view text, const ReadOptions& options = {}) const {
        const auto path = folder_ / file;
        std::ofstream(path, std::ios::binary) << text;
        return read_particles(path, options);
    }

    /// The message of the refusal, without the folder.
    [[nodiscard]] std::string error(std::string_view text, const ReadOptions& options = {}) const {
        const std::string message = message_of<InputError>([&] { (void)read(text, options); });
        const std::string place = folder_.path().string() + "/";
        return message.starts_with(place) ? message.substr(place.size()) : message;
    }

    static std::filesystem::path data(const std::string& name) {
        return std::filesystem::path(RECOAT_TEST_DATA) / "dumps" / name;
    }

    static constexpr const char* file = "layer";

private:
    TemporaryFolder folder_;
};

inline ::testing::AssertionResult begins(const std::string& text, const std::string& start) {
    if (text.starts_with(start)) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << text;
}

/// `text` with the first occurrence of `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    if (place == std::string::npos) throw std::logic_error("there is no " + from);
    return text.replace(place, from.size(), to);
}

}  // namespace recoat::testing
