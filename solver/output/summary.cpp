#include "solver/output/summary.hpp"

#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "common/error.hpp"
#include "common/output_file.hpp"
#include "common/version.hpp"
#include "solver/output/energy_balance.hpp"
#include "solver/output/ledger_fields.hpp"

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

Json balance_json(const EnergyLedger& start, const EnergyLedger& end) {
    const EnergyBalance balance = energy_balance(start, end);
    return {{"wall_work", balance.wall_work},
            {"dissipated", balance.dissipated},
            {"balance_error", balance.error},
            {"balance_error_relative", balance.relative_error()},
            {"balance_relative_to", balance.exchanged >= balance.scale() ? "exchanged" : "held"},
            {"balance_scale", balance.scale()}};
}

Json stage_json(const StageRecord& record, std::size_t particles) {
    const double particle_steps = static_cast<double>(particles) * static_cast<double>(record.steps);
    Json json = {{"name", record.name},
                 {"steps", record.steps},
                 {"time", record.time},
                 {"settled", record.settled},
                 {"wall_seconds", record.wall_seconds},
                 {"particle_steps_per_second", record.wall_seconds > 0 ? particle_steps / record.wall_seconds : 0.0},
                 {"kinetic_energy", record.kinetic_energy},
                 {"largest_overlap", record.largest_overlap}};
    if (record.packing_density) json["packing_density"] = *record.packing_density;
    if (record.layer_end) json["layer_end"] = *record.layer_end;
    json["energy"] = balance_json(record.start, record.end);
    return json;
}

Json energy_json(const EnergyLedger& start, const EnergyLedger& end) {
    Json json;
    for (const LedgerField& field : ledger_fields) json[std::string(field.name)] = end.*field.value;
    const Json balance = balance_json(start, end);
    json["balance_error"] = balance["balance_error"];
    json["balance_error_relative"] = balance["balance_error_relative"];
    json["balance_relative_to"] = balance["balance_relative_to"];
    json["balance_scale"] = balance["balance_scale"];
    return json;
}

bool inside(const Scene& scene, Vec3 p) {
    const Vec3 a = scene.domain_lower, b = scene.domain_upper;
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    return finite && p.x >= a.x && p.x <= b.x && p.y >= a.y && p.y <= b.y && p.z >= a.z && p.z <= b.z;
}

std::int64_t count_lost(const Scene& scene, const ParticleTable& particles) {
    std::int64_t lost = 0;
    for (const Vec3& position : particles.position) lost += inside(scene, position) ? 0 : 1;
    if (const auto* column = std::get_if<ColumnSource>(&scene.source)) {
        lost += column->count - static_cast<std::int64_t>(particles.size());
    }
    return lost;
}

}  // namespace

void write_summary(const std::filesystem::path& file, const Scene& scene, const RunProgress& progress,
                   const Engine& engine, RunStatus status, const Resources& resources) {
    const ParticleTable particles = engine.particles();
    Json json = {
        {"version", program_version()},
        {"config", scene.resolved},
        {"seed", scene.seed},
        {"particles", particles.size()},
        {"bond_number", scene.bond_number},
        {"stiffness_ratio", scene.model.stiffness_ratio},
        {"time_step", scene.time_step},
        {"status", status == RunStatus::finished ? "finished" : "stopped"},
        {"steps", engine.step()},
        {"time", engine.time()},
        {"stages", Json::array()},
        {"energy", energy_json(progress.start, engine.ledger())},
        {"particles_lost", count_lost(scene, particles)},
        {"wall_seconds", progress.wall_seconds},
        {"backend", name_of(resources.backend)},
        {"threads", resources.threads},
        {"instruction_set", name_of(resources.instructions)},
        // A device knows double precision only.
        {"precision", resources.backend == Backend::cpu && scene.precision == Precision::mixed ? "mixed" : "double"}};
    for (const StageRecord& record : progress.finished) json["stages"].push_back(stage_json(record, particles.size()));
    write_text_file(file, json.dump(2) + "\n");
}

std::optional<EarlierSummary> read_summary(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) return std::nullopt;
    try {
        const Json json = Json::parse(stream);
        return EarlierSummary{json.at("config"), json.at("version"), json.at("status") == "finished"};
    } catch (const Json::exception&) {
        throw InputError(file.string() + ": this is no summary of recoat-solve; choose another folder for --out");
    }
}

}  // namespace recoat
