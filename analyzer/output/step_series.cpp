#include "analyzer/output/step_series.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analyzer/output/csv_tables.hpp"
#include "analyzer/output/json_report.hpp"
#include "common/hdf5.hpp"
#include "common/output_file.hpp"

namespace recoat {
namespace {

std::optional<Uncertainty> if_resampled(const Uncertainty& estimates) {
    if (estimates.bootstrap.resamples == 0) return {};
    return estimates;
}

}  // namespace

struct StepSeries::Hdf5 {
    OutputFile output;
    hdf5::File file;

    Hdf5(const std::filesystem::path& place, const Provenance& provenance)
        : output(place), file(create_hdf5_report(output.path(), provenance)) {}
};

StepSeries::StepSeries(const std::filesystem::path& json, const std::filesystem::path& hdf5,
                       const std::filesystem::path& csv, const Provenance& provenance)
    : json_(json), csv_(csv) {
    if (!hdf5.empty()) hdf5_ = std::make_unique<Hdf5>(hdf5, provenance);
}

StepSeries::~StepSeries() = default;

void StepSeries::add(std::int64_t step, const Analysis& analysis, const AnalysisConfig& config,
                     const Uncertainty& estimates) {
    const std::optional<Uncertainty> uncertainty = if_resampled(estimates);
    if (hdf5_) {
        const hdf5::Group group = hdf5_->file.create_group(fmt::format("step_{:04}", written_++));
        group.set_attribute("step", step);
        write_report_groups(group, analysis, config, uncertainty);
    }
    if (!json_.empty()) {
        nlohmann::ordered_json report = {{"step", step}};
        report.update(json_report(analysis, config, uncertainty));
        reports_ += fmt::format("{}{}", reports_.empty() ? "" : ",\n", report.dump());
    }
    if (csv_.empty()) return;
    for (const MetricRow& row : metric_rows(analysis, config, estimates)) {
        rows_ += fmt::format("{},{},{},{},{},{}\n", step, row.key, row.value, row.lower, row.upper, row.standard_error);
    }
}

void StepSeries::finish() {
    if (hdf5_) {
        Hdf5& written = *hdf5_;
        { const hdf5::File closed = std::move(written.file); }
        written.output.commit();
    }
    if (!json_.empty()) write_text_file(json_, fmt::format("{{\"steps\":[{}]}}\n", reports_));
    if (!csv_.empty()) write_text_file(csv_ / "steps.csv", "step,key,value,lower,upper,standard_error\n" + rows_);
}

std::string StepSeries::text_head() {
    return fmt::format("{:>12}{:>10}{:>8}{:>8}{:>9}{:>8}{:>8}{:>7}{:>10}\n", "step", "particles", "phi", "+-",
                       "IQR/phi", "Ra", "+-", "CN", "chambers");
}

std::string StepSeries::text_line(std::int64_t step, const Analysis& analysis, const Uncertainty& estimates) {
    const auto error = [&](std::string_view group, std::string_view name) {
        const double value = estimates.at(group, name).interval[0].standard_error;
        return std::isfinite(value) ? fmt::format("{:.4f}", value) : "-";
    };
    const auto& relative = analysis.phi_exact.iqr_over_median;
    return fmt::format("{:>12}{:>10}{:>8.4f}{:>8}{:>9}{:>8.4f}{:>8}{:>7.3f}{:>10}\n", step,
                       analysis.coordination.n_particles, analysis.phi_exact.median, error("phi_exact", "median"),
                       relative ? fmt::format("{:.4f}", *relative) : "-", analysis.height.roughness,
                       error("height", "Ra"), analysis.coordination.cn_mean,
                       analysis.chamber_pores.separate.sizes.count);
}

}  // namespace recoat
