#include "solver/engine/attraction_pass.hpp"
#include "solver/engine/contact_pass.hpp"
#include "solver/engine/particle_pass.hpp"

// Proof that every pass of the engine compiles as device code as it stands: one source for host and device.

namespace recoat {
namespace {

template <class Pass>
__global__ void run(Pass pass, std::size_t n, double* result) {
    const std::size_t k = blockIdx.x * static_cast<std::size_t>(blockDim.x) + threadIdx.x;
    if (k < n) result[k] = pass(k);
}

template <class Pass>
void launch(const Pass& pass) {
    run<<<1, 32>>>(pass, 0, nullptr);
}

template <class Partner>
void launch_contacts(const Partner& partner, const Attraction& attraction) {
    launch(ContactPass<Partner, false, false>{partner, contact_law<false>({}), {}, {}, 0, 0, 0});
    launch(ContactPass<Partner, false, true>{partner, contact_law<false>({}), {}, {}, 0, 0, 0});
    launch(ContactPass<Partner, true, false>{partner, contact_law<true>({}), {}, {}, 0, 0, 0});
    launch(ContactPass<Partner, true, true>{partner, contact_law<true>({}), {}, {}, 0, 0, 0});
    const auto attract = [&](auto impulse) {
        launch(AttractionPass<Partner, decltype(impulse)>{partner, impulse, {}, {}, 0, 0});
    };
    attract(FixedPointImpulse<2>{attraction, 0});
    attract(SecantImpulse<3>{attraction, 0});
    attract(BracketedImpulse{attraction, 0});
    attract(ExplicitImpulse{attraction, 0});
    attract(PredictionCorrectionImpulse{attraction, 0});
}

template <class Sizes>
void launch_all(const Sizes& sizes) {
    const Attraction attraction{1.65e-10, 1e-7};
    launch_contacts(ParticlePartner<Sizes>{sizes, Period(0), 0}, attraction);
    launch_contacts(WallPartner<Sizes, PlaneShape>{sizes, PlaneShape(Wall{}), {}, 0}, attraction);
    launch_contacts(WallPartner<Sizes, BoxShape>{sizes, BoxShape(Wall{}), {}, 0}, attraction);
    launch(ParticlePass<Sizes, false, false>{sizes, {}, {}, {}, nullptr, nullptr, nullptr, {}, 0, 0, 0, 0});
    launch(ParticlePass<Sizes, false, true>{sizes, {}, {}, {}, nullptr, nullptr, nullptr, {}, 0, 0, 0, 0});
    launch(ParticlePass<Sizes, true, false>{sizes, {}, {}, {}, nullptr, nullptr, nullptr, {}, 0, 0, 0, 0});
    launch(ParticlePass<Sizes, true, true>{sizes, {}, {}, {}, nullptr, nullptr, nullptr, {}, 0, 0, 0, 0});
    launch(ImpulsePass<Sizes>{sizes, {}, {}, nullptr, 0, 0, 0});
}

}  // namespace

void launch_every_pass() {
    launch_all(equal_sizes({}, 1));
    launch_all(any_sizes({}));
}

}  // namespace recoat
