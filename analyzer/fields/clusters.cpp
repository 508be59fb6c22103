#include "analyzer/fields/clusters.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>

namespace recoat {
namespace {

/// Half the difference of the eigenvalues must exceed this share of their mean for a cluster to have a direction.
constexpr double smallest_anisotropy = 1e-6;
/// Mean eigenvalue [d_p^2] below which a cluster has no extent in the top view (an upright doublet after wrapping).
constexpr double smallest_extent = 1e-12;

/// Walks the clusters breadth first and measures each.
class ClusterFinder {
public:
    ClusterFinder(const Layer& layer, const ContactGraph& graph) : layer_(layer), graph_(graph), unwrapped_y_(layer.y) {
        clusters_.of_particle.assign(layer.size(), unvisited);
    }

    Clusters run() {
        for (std::size_t seed = 0; seed < layer_.size(); ++seed) {
            if (clusters_.of_particle[seed] == unvisited) clusters_.cluster.push_back(walk(seed));
        }
        return std::move(clusters_);
    }

private:
    static constexpr std::size_t unvisited = std::numeric_limits<std::size_t>::max();

    Cluster walk(std::size_t seed) {
        Cluster cluster;
        const std::size_t label = clusters_.cluster.size();
        members_.assign(1, seed);
        clusters_.of_particle[seed] = label;
        for (std::size_t next = 0; next < members_.size(); ++next) {
            const std::size_t i = members_[next];
            for (const auto [j, turn] : graph_.neighbours(i)) {
                const double y = unwrapped_y_[i] + (layer_.y[j] - layer_.y[i] + turn * layer_.width);
                if (clusters_.of_particle[j] == unvisited) {
                    clusters_.of_particle[j] = label;
                    unwrapped_y_[j] = y;
                    members_.push_back(j);
                } else if (std::abs(unwrapped_y_[j] - y) > 0.5 * layer_.width) {
                    cluster.percolates = true;
                }
            }
        }
        cluster.size = members_.size();
        if (cluster.size >= 2 && !cluster.percolates) set_axis(cluster);
        return cluster;
    }

    /// Direction of the larger principal axis of the members' centres in the top view.
    void set_axis(Cluster& cluster) const {
        Eigen::Matrix2d gyration = Eigen::Matrix2d::Zero();
        const Eigen::Vector2d centre = mean_position();
        for (const std::size_t i : members_) {
            const Eigen::Vector2d arm = position(i) - centre;
            gyration += arm * arm.transpose();
        }
        gyration /= static_cast<double>(cluster.size);
        const double difference = gyration(0, 0) - gyration(1, 1), twice_shear = 2 * gyration(0, 1);
        const double half_difference = 0.5 * std::hypot(difference, twice_shear);
        const double mean = 0.5 * gyration.trace();
        if (mean <= smallest_extent || half_difference <= smallest_anisotropy * mean) {
            cluster.isotropic = true;
            return;
        }
        cluster.angle = std::abs(0.5 * std::atan2(twice_shear, difference)) * 180 / std::numbers::pi;
    }

    [[nodiscard]] Eigen::Vector2d position(std::size_t i) const { return {layer_.x[i], unwrapped_y_[i]}; }

    [[nodiscard]] Eigen::Vector2d mean_position() const {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const std::size_t i : members_) sum += position(i);
        return sum / static_cast<double>(members_.size());
    }

    const Layer& layer_;
    const ContactGraph& graph_;
    std::vector<double> unwrapped_y_;
    std::vector<std::size_t> members_;
    Clusters clusters_;
};

}  // namespace

Clusters find_clusters(const Layer& layer, const ContactGraph& graph) { return ClusterFinder(layer, graph).run(); }

}  // namespace recoat
