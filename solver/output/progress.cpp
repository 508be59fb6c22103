#include "solver/output/progress.hpp"

#include <nlohmann/json.hpp>

#include "solver/output/ledger_fields.hpp"

namespace recoat {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const EnergyLedger& ledger) {
    Json json;
    for (const LedgerField& field : ledger_fields) json[std::string(field.name)] = ledger.*field.value;
    return json;
}

EnergyLedger ledger_from(const Json& json) {
    EnergyLedger ledger;
    for (const LedgerField& field : ledger_fields) ledger.*field.value = json.at(std::string(field.name));
    return ledger;
}

Json to_json(const StageRecord& record) {
    Json json = {{"name", record.name},
                 {"steps", record.steps},
                 {"time", record.time},
                 {"settled", record.settled},
                 {"wall_seconds", record.wall_seconds},
                 {"kinetic_energy", record.kinetic_energy},
                 {"largest_overlap", record.largest_overlap},
                 {"start", to_json(record.start)},
                 {"end", to_json(record.end)}};
    if (record.packing_density) json["packing_density"] = *record.packing_density;
    if (record.layer_end) json["layer_end"] = *record.layer_end;
    return json;
}

StageRecord record_from(const Json& json) {
    StageRecord record;
    record.name = json.at("name");
    record.steps = json.at("steps");
    record.time = json.at("time");
    record.settled = json.at("settled");
    record.wall_seconds = json.at("wall_seconds");
    record.kinetic_energy = json.at("kinetic_energy");
    record.largest_overlap = json.at("largest_overlap");
    record.start = ledger_from(json.at("start"));
    record.end = ledger_from(json.at("end"));
    if (json.contains("packing_density")) record.packing_density = json.at("packing_density").get<double>();
    if (json.contains("layer_end")) record.layer_end = json.at("layer_end").get<double>();
    return record;
}

}  // namespace

std::string progress_to_text(const RunProgress& progress) {
    Json json = {{"stage", progress.stage},
                 {"segment", progress.segment},
                 {"segment_entered", progress.segment_entered},
                 {"segment_steps", progress.segment_steps},
                 {"checks_at_rest", progress.checks_at_rest},
                 {"settled", progress.settled},
                 {"stage_first_step", progress.stage_first_step},
                 {"wall_seconds", progress.wall_seconds},
                 {"stage_wall_seconds", progress.stage_wall_seconds},
                 {"start", to_json(progress.start)},
                 {"blade_stop_rear", progress.blade_stop.rear},
                 {"finished", Json::array()}};
    for (const StageRecord& record : progress.finished) json["finished"].push_back(to_json(record));
    return json.dump();
}

RunProgress progress_from_text(const std::string& text) {
    const Json json = Json::parse(text);
    RunProgress progress;
    progress.stage = json.at("stage");
    progress.segment = json.at("segment");
    progress.segment_entered = json.at("segment_entered");
    progress.segment_steps = json.at("segment_steps");
    progress.checks_at_rest = json.at("checks_at_rest");
    progress.settled = json.at("settled");
    progress.stage_first_step = json.at("stage_first_step");
    progress.wall_seconds = json.at("wall_seconds");
    progress.stage_wall_seconds = json.at("stage_wall_seconds");
    progress.start = ledger_from(json.at("start"));
    progress.blade_stop.rear = json.at("blade_stop_rear");
    for (const Json& record : json.at("finished")) progress.finished.push_back(record_from(record));
    return progress;
}

}  // namespace recoat
