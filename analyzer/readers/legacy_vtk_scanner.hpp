#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace recoat {

/// Takes the words and arrays of a legacy VTK file, ASCII or binary, one after the other. All functions throw
/// InputError with file and line (of a binary file, the byte) when the file is not as it should be.
class LegacyVtkScanner {
public:
    LegacyVtkScanner(std::string name, std::string_view bytes) : name_(std::move(name)), bytes_(bytes) {}

    /// The first three lines: version, title, ASCII or BINARY.
    void read_head();

    /// The next word; empty at the end of the file.
    [[nodiscard]] std::string keyword();
    /// The next word of the line, which must be there; `what` is for the error.
    [[nodiscard]] std::string word(std::string_view what);
    /// A word that is a number of things.
    [[nodiscard]] std::size_t count(std::string_view what);
    /// What is left of the line, without white space around it.
    [[nodiscard]] std::string_view rest_of_line() const;
    /// Whether this word comes next.
    [[nodiscard]] bool follows(std::string_view word) const;

    /// An array of `tuples` x `components` numbers of the named type; begins on the next line.
    [[nodiscard]] std::vector<double> numbers(std::size_t tuples, std::size_t components, const std::string& type);
    /// An array of so many numbers as whole numbers to the last bit; nothing where one is none.
    [[nodiscard]] std::optional<std::vector<std::int64_t>> whole_numbers(std::size_t count, const std::string& type);
    void skip(std::size_t count, const std::string& type) { skip_tuples(count, 1, type); }
    void skip_tuples(std::size_t tuples, std::size_t components, const std::string& type);
    /// Passes over a METADATA block, which ends with an empty line.
    void skip_metadata();
    /// Refuses an ASCII file that ends inside its last line, whose last number may be cut.
    void need_line_end() const;
    /// Type of colours: bytes in binary files, reals in ASCII ones.
    [[nodiscard]] std::string colour_type() const { return binary_ ? "unsigned_char" : "float"; }

    [[noreturn]] void fail(const std::string& problem) const;

private:
    /// tuples x components, which cannot be more than the file holds.
    [[nodiscard]] std::size_t elements(std::size_t tuples, std::size_t components) const;
    void skip_white_space();
    std::string_view take_line();
    [[nodiscard]] std::string_view take_word();
    [[nodiscard]] std::string_view take_bytes(std::size_t tuples, std::size_t components, std::size_t bits);
    [[nodiscard]] double take_number();

    std::string name_;
    std::string_view bytes_;
    std::size_t place_ = 0;
    bool binary_ = false;
};

}  // namespace recoat
