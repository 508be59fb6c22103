#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "analyzer/output/hdf5_report.hpp"

namespace recoat {

/// Reports of several time steps in one file of each kind. The files appear, whole, at finish().
class StepSeries {
public:
    /// Places of the JSON report, the HDF5 report and the folder of the CSV table `steps`; empty: not wanted.
    StepSeries(const std::filesystem::path& json, const std::filesystem::path& hdf5, const std::filesystem::path& csv,
               const Provenance& provenance);
    ~StepSeries();
    StepSeries(const StepSeries&) = delete;
    StepSeries& operator=(const StepSeries&) = delete;

    /// Adds the report of a time step. `estimates` may be without resamples.
    void add(std::int64_t step, const Analysis& analysis, const AnalysisConfig& config, const Uncertainty& estimates);
    void finish();

    /// Header and line of the table for the terminal.
    [[nodiscard]] static std::string text_head();
    [[nodiscard]] static std::string text_line(std::int64_t step, const Analysis& analysis,
                                               const Uncertainty& estimates);

private:
    struct Hdf5;
    std::filesystem::path json_, csv_;
    std::unique_ptr<Hdf5> hdf5_;
    std::string reports_, rows_;
    std::size_t written_ = 0;  ///< groups of the HDF5 report: a number of a step may be there twice
};

}  // namespace recoat
