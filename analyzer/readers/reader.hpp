#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "analyzer/readers/content.hpp"
#include "analyzer/readers/series.hpp"
#include "analyzer/readers/source.hpp"

namespace recoat {

/// One format that particles can be read from. To add a format: a pair of files with these two functions, its test, and
/// a line in the list of reader.cpp.
struct Reader {
    std::string_view name;
    std::string_view description;
    /// Whether the file is of this format, judged by what it holds.
    bool (*recognises)(const Content& content);
    /// Finds the time steps in the file; their particles have lengths in the unit of the file. It and what it returns
    /// throw InputError naming the file, the line and the column at fault. `content` and `options` must outlive it.
    Series (*open)(const Content& content, const ReadOptions& options);
};

/// All formats in the order in which they are tried.
[[nodiscard]] std::span<const Reader> readers();

/// The time steps of a file of any known format, as its reader gives them. `content` and `options` must outlive it.
/// Throws InputError when the file is of no known format, or damaged where that shows before the particles are read.
[[nodiscard]] Series open_series(const Content& content, const ReadOptions& options);

/// An open file of particles: it is loaded once, and its time steps are read one by one, in any order, lengths in
/// metres. `options.step` does not apply.
class Recording {
public:
    /// Throws InputError when the file is of no known format, or damaged where that shows before the particles are
    /// read.
    explicit Recording(const std::filesystem::path& file, ReadOptions options = {})
        : Recording(load_content(file), std::move(options)) {}
    explicit Recording(Content content, ReadOptions options = {});

    /// Numbers of the time steps in the order of the file; at least one.
    [[nodiscard]] std::span<const std::int64_t> steps() const { return series_.steps; }
    /// The particles of a time step, by its place in steps(). Throws InputError when they are damaged.
    [[nodiscard]] Source read(std::size_t index) const;
    /// The particles of the time step that the user chose. Throws InputError when there is none such, or it is damaged.
    [[nodiscard]] Source read(StepChoice choice) const;
    /// Throws InputError when the file is damaged behind the last of steps().
    void require_whole() const;

private:
    [[nodiscard]] Source read_at(std::size_t index) const;

    // Pointers: the series refers to both.
    std::unique_ptr<const Content> content_;
    std::unique_ptr<const ReadOptions> options_;
    const Reader* reader_ = nullptr;
    Series series_;
};

/// Reads the particles of one time step of a file of any known format. Throws InputError when it is of none, or
/// damaged.
[[nodiscard]] Source read_particles(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace recoat
