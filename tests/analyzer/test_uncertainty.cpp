#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "analyzer/output/json_report.hpp"
#include "analyzer/uncertainty/column_sample.hpp"
#include "analyzer/uncertainty/uncertainty.hpp"
#include "tests/analyzer/support.hpp"

namespace recoat {
namespace {

using testing::layer_of;
using testing::random_balls;
using testing::unit_config;

TEST(BlockBootstrap, WeightsAreThoseOfBlocksOfNeighbours) {
    const BlockBootstrap bootstrap{.columns = 10, .block = 4, .resamples = 200, .seed = 3};
    std::vector<std::uint32_t> total(10, 0);
    for (std::size_t b = 0; b < bootstrap.resamples; ++b) {
        const ColumnWeights weights = bootstrap.weights(b);
        ASSERT_EQ(weights.size(), 10U);
        EXPECT_EQ(std::accumulate(weights.begin(), weights.end(), 0U), 10U);
        for (std::size_t c = 0; c < 10; ++c) total[c] += weights[c];
        // Two blocks of 4 and one of 2: where a column is taken more often than the one before, a block begins.
        std::uint32_t begins = 0;
        for (std::size_t c = 0; c < 10; ++c) {
            if (weights[c] > weights[(c + 9) % 10]) begins += weights[c] - weights[(c + 9) % 10];
        }
        EXPECT_LE(begins, 3U);
    }
    // Every column is as likely: 200 expected, the standard deviation below 20.
    for (const std::uint32_t count : total) EXPECT_NEAR(count, 200, 80);
}

TEST(BlockBootstrap, IsSplitMix64) {
    // The generator's first outputs for the seed 0 are e220a8397b1dcdaf and 6e789e6aa1b965f4.
    const BlockBootstrap bootstrap{.columns = 256, .block = 128, .resamples = 1, .seed = 0};
    ColumnWeights expected(256, 0);
    for (const int start : {0xe2, 0x6e}) {
        for (int i = 0; i < 128; ++i) ++expected[(start + i) % 256];
    }
    EXPECT_EQ(bootstrap.weights(0), expected);
}

/// Standard error of the mean of columns by the bootstrap.
double standard_error_of_mean(const std::vector<double>& values, int block) {
    const BlockBootstrap bootstrap{.columns = static_cast<int>(values.size()), .block = block, .resamples = 4000};
    std::vector<double> means;
    for (std::size_t b = 0; b < bootstrap.resamples; ++b) {
        const ColumnWeights weights = bootstrap.weights(b);
        means.push_back(std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) /
                        static_cast<double>(values.size()));
    }
    return interval_of(means).standard_error;
}

TEST(BlockBootstrap, HasTheVarianceOfAMeanOfIndependentBlocks) {
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal;
    std::vector<double> values(120);
    double last = 0;
    for (double& value : values) value = last = 0.7 * last + normal(generator);
    const auto n = static_cast<int>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    for (const int block : {1, 4, 10, 30}) {
        // Blocks start anywhere on the circle with the same chance; n / block of them, independent, make a mean.
        double squares = 0;
        for (int start = 0; start < n; ++start) {
            double sum = 0;
            for (int i = 0; i < block; ++i) sum += values[(start + i) % n];
            squares += (sum / block - mean) * (sum / block - mean);
        }
        const double expected = std::sqrt(squares / n * block / n);
        // Four standard deviations of a standard error from 4000 resamples.
        EXPECT_NEAR(standard_error_of_mean(values, block) / expected, 1, 4 / std::sqrt(2 * 4000.0)) << block;
    }
}

TEST(BlockBootstrap, IntervalsAreQuantilesOfTheDefinedResamples) {
    std::vector<double> values(1001);
    std::iota(values.begin(), values.end(), 0.0);
    std::ranges::reverse(values);
    values.push_back(std::nan(""));
    const Interval interval = interval_of(values);
    EXPECT_DOUBLE_EQ(interval.lower, 25);
    EXPECT_DOUBLE_EQ(interval.upper, 975);
    EXPECT_NEAR(interval.standard_error, std::sqrt(1001.0 * 1002 / 12), 1e-9);
    EXPECT_TRUE(std::isnan(interval_of(std::vector{std::nan(""), 1.0}).lower));
}

TEST(ColumnSample, MatchesTheValuesWrittenOut) {
    std::mt19937_64 generator(8);
    std::vector<ColumnSample::Item> items;
    for (std::uint32_t column = 0; column < 6; ++column) {
        for (std::uint32_t k = 0; k < column; ++k)
            items.push_back({std::round(static_cast<double>(generator()) / 0x1p59), column});
    }
    const ColumnSample sample(items, 6);
    for (const ColumnWeights& weights :
         {ColumnWeights{1, 1, 1, 1, 1, 1}, ColumnWeights{3, 0, 2, 0, 1, 0}, ColumnWeights{0, 1, 0, 0, 0, 5}}) {
        std::vector<double> written;
        for (const auto& [value, column] : items) written.insert(written.end(), weights[column], value);
        const double centre = mean(written);
        double deviation = 0;
        for (const double value : written) deviation += std::abs(value - centre) / static_cast<double>(written.size());
        EXPECT_EQ(sample.count(weights), static_cast<double>(written.size()));
        EXPECT_NEAR(sample.mean(weights), centre, 1e-12);
        EXPECT_NEAR(sample.mean_deviation(weights), deviation, 1e-12);
        std::ranges::sort(written);
        const std::vector<double> shares = {0.0, 0.25, 0.5, 0.9, 1.0};
        const std::vector<double> found = sample.quantiles(weights, shares);
        for (std::size_t k = 0; k < shares.size(); ++k) EXPECT_DOUBLE_EQ(found[k], quantile(written, shares[k]));
    }
    const ColumnWeights only_empty = {6, 0, 0, 0, 0, 0};
    EXPECT_TRUE(std::isnan(sample.mean(only_empty)));
    EXPECT_TRUE(std::isnan(sample.quantiles(only_empty, std::vector{0.5})[0]));
}

Analysis random_analysis(const AnalysisConfig& config) {
    return analyse(layer_of(random_balls(500, 40, 12, 4), config), config);
}

/// Value of the report that an estimate belongs to.
nlohmann::ordered_json reported(const nlohmann::ordered_json& report, const Quantity& quantity) {
    return report.at(nlohmann::ordered_json::json_pointer("/" + quantity.group + "/" + quantity.name));
}

TEST(Uncertainty, ValuesAreThoseOfTheReport) {
    for (const WindowEdge edge : {WindowEdge::overhang, WindowEdge::interior}) {
        AnalysisConfig config = unit_config(40, 12);
        config.phi_x_edge = edge;
        config.bootstrap_resamples = 50;
        config.voxels_per_dp = {};
        const Analysis analysis = random_analysis(config);
        const auto report = json_report(analysis, config);
        std::size_t compared = 0;
        for (const Estimate& estimate : bootstrap(analysis, config).estimates) {
            if (estimate.quantity.name == "size_class_fraction") {
                EXPECT_NEAR(std::accumulate(estimate.value.begin(), estimate.value.end(), 0.0), 1, 1e-12);
                EXPECT_NEAR(estimate.value[1], analysis.cluster_sizes.size_fraction.at(2), 1e-12);
                continue;
            }
            const auto expected = reported(report, estimate.quantity);
            for (std::size_t k = 0; k < estimate.value.size(); ++k, ++compared) {
                const double value = (estimate.quantity.is_list ? expected.at(k) : expected).get<double>();
                EXPECT_NEAR(estimate.value[k], value, 1e-11)
                    << estimate.quantity.group << ' ' << estimate.quantity.name;
            }
            EXPECT_EQ(estimate.quantity.is_list, expected.is_array());
        }
        EXPECT_GT(compared, 150U);
    }
}

TEST(Uncertainty, SameBitsWithAnyNumberOfThreads) {
    AnalysisConfig config = unit_config(40, 12);
    config.bootstrap_resamples = 100;
    config.voxels_per_dp = {};
    const Analysis analysis = random_analysis(config);
    const auto with_threads = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return json_report(analysis, config, bootstrap(analysis, config)).dump();
    };
    EXPECT_EQ(with_threads(1), with_threads(3));
}

TEST(Uncertainty, BlocksAreAtMostAQuarterOfTheRegion) {
    AnalysisConfig config = unit_config(12, 6);
    config.bootstrap_resamples = 2;
    config.voxels_per_dp = {};
    const Uncertainty uncertainty = bootstrap(analyse(layer_of(random_balls(60, 12, 6, 1), config), config), config);
    EXPECT_EQ(uncertainty.bootstrap.block, 3);
    EXPECT_EQ(uncertainty.block_length, 3);
}

TEST(Uncertainty, OfAnEmptyLayerIsUndefinedNotWrong) {
    AnalysisConfig config = unit_config(8, 6);
    config.bootstrap_resamples = 20;
    const Analysis analysis = analyse(layer_of({}, config), config);
    const Uncertainty uncertainty = bootstrap(analysis, config);
    EXPECT_EQ(uncertainty.at("height", "empty_fraction").interval[0].lower, 1);
    EXPECT_TRUE(std::isnan(uncertainty.at("clusters", "cn_mean").interval[0].lower));
    EXPECT_TRUE(std::isnan(uncertainty.at("phi_exact", "iqr_over_median").interval[0].upper));
    EXPECT_TRUE(json_report(analysis, config, uncertainty)["uncertainty"]["clusters"]["cn_mean"]["lower"].is_null());
}

}  // namespace
}  // namespace recoat
