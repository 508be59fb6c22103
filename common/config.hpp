#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/config_node.hpp"
#include "common/units.hpp"
#include "common/vec3.hpp"

namespace recoat {

/// Values that are allowed, in SI units. The bounds belong to it unless they are open.
struct Range {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool lower_open = false;
    bool upper_open = false;

    static constexpr Range positive() { return {.lower = 0, .lower_open = true}; }
    static constexpr Range not_negative() { return {.lower = 0}; }

    [[nodiscard]] bool contains(double value) const;
};

/// One mapping of a configuration file: a strict reader that knows which keys were asked for.
///
/// Every reading function throws InputError with the sentence "file:line: section.key: what is wrong; what to do" when
/// the key is missing (unless there is a fallback), has the wrong type, lacks its unit or is out of range. JSON is read
/// as the YAML that it is.
class Config {
public:
    /// Reads a file; `overrides` are the texts "a.b=v" of --set.
    static Config load(const std::filesystem::path& file, std::span<const std::string> overrides = {});

    /// Reads `text`; `name` stands for the file in errors.
    static Config parse(const std::string& text, const std::string& name, std::span<const std::string> overrides = {});

    /// Whether the key is present (with a value or empty). The key counts as known, not as read.
    [[nodiscard]] bool has(std::string_view key) const;
    /// Keys of this mapping in the order of the file.
    [[nodiscard]] std::vector<std::string> keys() const;
    /// Place of this mapping, e.g. "stages.1.spread"; empty at the top.
    [[nodiscard]] const std::string& path() const { return path_; }
    /// Name of the file as given.
    [[nodiscard]] const std::string& file() const;

    /// The mapping under `key`; a key without a value is an empty mapping.
    [[nodiscard]] Config section(std::string_view key) const;
    /// The same, but an empty mapping when the key is absent, so that all its defaults apply.
    [[nodiscard]] Config section_or_empty(std::string_view key) const;
    /// The mappings of a list; the item "- heap" is the mapping {heap: }.
    [[nodiscard]] std::vector<Config> list(std::string_view key) const;

    /// A quantity in SI units.
    [[nodiscard]] double quantity(std::string_view key, Dimension dimension, Range range = {}) const;
    [[nodiscard]] double quantity_or(std::string_view key, Dimension dimension, double fallback,
                                     Range range = {}) const;
    [[nodiscard]] double number(std::string_view key, Range range = {}) const;
    [[nodiscard]] double number_or(std::string_view key, double fallback, Range range = {}) const;
    [[nodiscard]] std::int64_t integer(std::string_view key, Range range = {}) const;
    [[nodiscard]] std::int64_t integer_or(std::string_view key, std::int64_t fallback, Range range = {}) const;
    /// `true` or `false`.
    [[nodiscard]] bool boolean(std::string_view key) const;
    [[nodiscard]] bool boolean_or(std::string_view key, bool fallback) const;
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] std::string text_or(std::string_view key, const std::string& fallback) const;
    /// One of the words `allowed`.
    [[nodiscard]] std::string choice(std::string_view key, std::span<const std::string_view> allowed) const;
    [[nodiscard]] std::string choice_or(std::string_view key, std::span<const std::string_view> allowed,
                                        std::string_view fallback) const;

    /// Whether the key is present and its value is this word.
    [[nodiscard]] bool is_word(std::string_view key, std::string_view word) const;
    /// Puts `text` in place of the value of the key, or of the absent key: what the program chose itself.
    void settle(std::string_view key, const std::string& text) const;

    /// A list of quantities in SI units; `expected_size` 0 means any.
    [[nodiscard]] std::vector<double> quantities(std::string_view key, Dimension dimension,
                                                 std::size_t expected_size = 0, Range range = {}) const;
    /// Three quantities in SI units; with `infinite` the words inf and -inf are allowed too.
    [[nodiscard]] Vec3 vector(std::string_view key, Dimension dimension, bool infinite = false) const;
    [[nodiscard]] Vec3 vector_or(std::string_view key, Dimension dimension, Vec3 fallback, bool infinite = false) const;
    /// A list of words.
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;

    /// Says that the value of the key, if it is there, was given by an option "--name value": errors then name that.
    void set_option(std::string_view key, const std::string& option) const;

    /// Enables the unit dp in the whole file; d_p in metres.
    void set_particle_diameter(double diameter);
    /// Numbers without a unit are SI values in the whole file.
    void set_plain_is_si(bool plain_is_si);

    /// Throws InputError "file:line: section.key: problem_and_advice"; an empty key means this mapping.
    [[noreturn]] void fail(std::string_view key, const std::string& problem_and_advice) const;

    /// Throws InputError when this mapping has a key that is none of these, as finish() does; so a misspelt key is
    /// named before anything that follows from its absence.
    void allow_only(std::span<const std::string_view> keys) const;
    /// Throws InputError when this mapping, or one that was read below it, has a key that was not read; suggests the
    /// known key that it may be meant to be.
    void finish() const;

    /// The configuration from here down as YAML text, with the overrides and the defaults that were used.
    [[nodiscard]] std::string resolved() const;

private:
    struct Document;

    Config(std::shared_ptr<Document> document, ConfigNode::Pointer node, std::string path);

    [[nodiscard]] ConfigNode::Pointer take(std::string_view key, std::string_view wanted) const;
    [[nodiscard]] const ConfigNode& take_scalar(std::string_view key, std::string_view wanted) const;
    [[nodiscard]] ConfigNode::Pointer take_list(std::string_view key, std::string_view wanted,
                                                std::size_t expected_size) const;
    void add_default_list(std::string_view key, Dimension dimension, Vec3 value) const;
    void refuse_unread(const std::string& key, const ConfigNode& value) const;
    [[nodiscard]] bool absent(std::string_view key, const std::string& default_text) const;
    [[nodiscard]] double value(std::string_view key, const ConfigNode& node, Dimension dimension, Range range,
                               bool infinite) const;
    [[nodiscard]] std::string join(std::string_view key) const;
    [[noreturn]] void fail_at(const ConfigNode& node, std::string_view key, const std::string& problem) const;

    std::shared_ptr<Document> document_;
    ConfigNode::Pointer node_;
    std::string path_;
};

}  // namespace recoat
