#include "solver/scene/model_options.hpp"

#include <algorithm>
#include <stdexcept>

namespace recoat {
namespace {

constexpr std::array<OptionValue, 3> scheme = {{
    {"discrete_gradient", "impulse equal to the exact work of the attraction over the path of the step"},
    {"explicit_force", "force at the separation at the start of the step"},
    {"prediction_correction", "the paper's equation 9: work over the predicted path"},
}};
constexpr std::array<OptionValue, 2> non_contact_hamaker = {{
    {"original", "A^O out of contact, A^R in contact: keeps the capture velocity"},
    {"reduced", "A^R everywhere, as is common practice: capture velocity up to 64 % too small"},
}};
constexpr std::array<OptionValue, 2> wall_modulus = {{
    {"elastic", "walls have the material of the particles, E* = E/2"},
    {"rigid", "walls are infinitely stiff, E* = E"},
}};
constexpr std::array<OptionValue, 3> rolling_length = {{
    {"radius", "torque mu_r R F"},
    {"reduced_radius", "torque mu_r R* F"},
    {"diameter", "torque mu_r 2R F"},
}};
constexpr std::array<OptionValue, 2> rolling_form = {{
    {"own", "against the particle's own angular velocity, as in the paper"},
    {"relative", "against that of the pair: conserves angular momentum"},
}};
constexpr std::array<OptionValue, 2> lever_arm = {{
    {"contact_point", "from the centre to the common contact point: conserves angular momentum"},
    {"radius", "the radius, as in the paper"},
}};
constexpr std::array<OptionValue, 2> tangential_damping = {{
    {"as_normal", "the coefficient of the normal dashpot"},
    {"none", "no tangential dashpot"},
}};
constexpr std::array<OptionValue, 2> dashpot_cap = {{
    {"true", "tangential spring and dashpot together at most mu_t F"},
    {"false", "only the spring is limited"},
}};
constexpr std::array<OptionValue, 2> normal_clip = {{
    {"false", "damping may make the contact force attractive: the coefficient of restitution is exact"},
    {"true", "the contact force stays repulsive: restitution higher than stated (0.4 gives 0.472)"},
}};

constexpr std::array<ModelOption, 9> options = {{
    {"cohesion", "scheme", "How attraction enters a step", scheme},
    {"cohesion", "non_contact_hamaker", "Hamaker constant of separated particles under stiffness scaling",
     non_contact_hamaker},
    {"contact", "wall_modulus", "Elasticity of walls", wall_modulus},
    {"contact", "rolling_length", "Length that multiplies the coefficient of rolling friction", rolling_length},
    {"contact", "rolling_form", "Angular velocity that rolling friction opposes", rolling_form},
    {"contact", "lever_arm", "Arm of the tangential force", lever_arm},
    {"contact", "tangential_damping", "Tangential dashpot", tangential_damping},
    {"contact", "dashpot_cap", "Coulomb limit and the tangential dashpot", dashpot_cap},
    {"contact", "normal_clip", "Viscous attraction at the end of a contact", normal_clip},
}};

}  // namespace

std::vector<std::string_view> ModelOption::names() const {
    std::vector<std::string_view> result;
    for (const OptionValue& value : values) result.push_back(value.name);
    return result;
}

std::size_t ModelOption::read(const Config& section_config) const {
    const std::vector<std::string_view> allowed = names();
    const std::string chosen = section_config.choice_or(key, allowed, allowed.front());
    return static_cast<std::size_t>(std::ranges::find(allowed, chosen) - allowed.begin());
}

std::span<const ModelOption> model_options() { return options; }

const ModelOption& model_option(std::string_view section, std::string_view key) {
    for (const ModelOption& option : options) {
        if (option.section == section && option.key == key) return option;
    }
    throw std::logic_error("no option " + std::string(section) + "." + std::string(key));
}

}  // namespace recoat
