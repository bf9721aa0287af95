#include "io/summary.hpp"

#include <nlohmann/json.hpp>

#include "core/errors.hpp"
#include "io/file.hpp"

namespace brunt {

namespace {

using Json = nlohmann::ordered_json;

constexpr Real kUnknown = std::numeric_limits<Real>::quiet_NaN();

/// json prints what is not finite as null; this reads it back.
Real real_at(const Json& json, const char* key, Real missing) {
  const auto found = json.find(key);
  if (found == json.end()) return missing;
  return found->is_null() ? kUnknown : found->get<Real>();
}

std::optional<Real> optional_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return std::nullopt;
  return found->get<Real>();
}

Json object_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end()) return Json::object();
  if (!found->is_object()) throw MachineError(std::string(key) + " is not an object");
  return *found;
}

Json measures_json(const std::vector<MeasureResult>& measures) {
  Json all = Json::object();
  for (const auto& measure : measures) {
    Json& entry = all[measure.name];
    entry["value"] = measure.value;
    entry["unit"] = measure.unit;
    entry["reference"] = measure.reference ? Json(*measure.reference) : Json();
    entry["error"] = measure.error ? Json(*measure.error) : Json();
    if (measure.exact) entry["exact"] = *measure.exact;
    if (measure.time) entry["time"] = *measure.time;
    if (measure.convergence.empty()) continue;
    entry["bound"] = measure.bound ? Json(*measure.bound) : Json();
    entry["order"] = measure.order ? Json(*measure.order) : Json();
    entry["convergence"] = measure.convergence;
  }
  return all;
}

std::vector<MeasureResult> measures_from(const Json& all) {
  std::vector<MeasureResult> measures;
  for (const auto& [name, entry] : all.items()) {
    MeasureResult measure;
    measure.name = name;
    measure.value = real_at(entry, "value", kUnknown);
    measure.unit = entry.value("unit", "");
    measure.reference = optional_at(entry, "reference");
    measure.error = optional_at(entry, "error");
    measure.exact = optional_at(entry, "exact");
    measure.time = optional_at(entry, "time");
    measure.bound = optional_at(entry, "bound");
    measure.order = optional_at(entry, "order");
    measure.convergence = entry.value("convergence", "");
    measures.push_back(std::move(measure));
  }
  return measures;
}

Json shares_json(const std::vector<std::pair<std::string, Real>>& shares) {
  Json json = Json::object();
  for (const auto& [name, share] : shares) json[name] = share;
  return json;
}

Json energy_json(const EnergyShares& energy) {
  return {{"largest", energy.largest},
          {"created", energy.created},
          {"sources", shares_json(energy.sources)},
          {"taken", shares_json(energy.taken)},
          {"hourglass", shares_json(energy.hourglass)}};
}

/// What shares_json wrote. missing  what stands for a share that is no number
std::vector<std::pair<std::string, Real>> shares_from(const Json& json, const char* key,
                                                      Real missing = 0) {
  std::vector<std::pair<std::string, Real>> shares;
  const Json all = object_at(json, key);
  for (const auto& [name, unused] : all.items()) {
    shares.emplace_back(name, real_at(all, name.c_str(), missing));
  }
  return shares;
}

EnergyShares energy_from(const Json& json) {
  EnergyShares energy;
  energy.largest = real_at(json, "largest", 0);
  energy.created = real_at(json, "created", 0);
  energy.sources = shares_from(json, "sources");
  energy.taken = shares_from(json, "taken");
  energy.hourglass = shares_from(json, "hourglass");
  return energy;
}

Json pairs_json(const PairCount& pairs) {
  return {{"in_support", pairs.in_support},
          {"compared", pairs.compared},
          {"hit_rate", pairs.hit_rate()}};
}

Json process_json(const RunSummary& s) {
  Json shares = Json::object();
  for (const auto& [body, end, mean] : s.inertia) shares[body] = {{"end", end}, {"mean", mean}};
  return {{"speed", s.process_speed}, {"distorts", s.distorts}, {"kinetic_over_work", shares}};
}

void read_process(const Json& json, RunSummary& s) {
  s.process_speed = real_at(json, "speed", s.process_speed);
  s.distorts = json.value("distorts", s.distorts);
  const Json shares = object_at(json, "kinetic_over_work");
  for (const auto& [body, share] : shares.items()) {
    s.inertia.push_back({body, real_at(share, "end", kUnknown), real_at(share, "mean", kUnknown)});
  }
}

RunSummary from_json(const Json& json) {
  RunSummary s;
  s.version = json.at("version").get<std::string>();
  s.status = json.at("status").get<int>();
  s.deck_hash = json.value("deck_hash", s.deck_hash);
  const Json parameters = object_at(json, "parameters");
  for (const auto& [name, text] : parameters.items()) {
    s.parameters.emplace_back(name, text.is_string() ? text.get<std::string>() : text.dump());
  }
  s.overrides = json.value("overrides", s.overrides);
  s.reason = json.value("reason", s.reason);
  s.steps = json.value("steps", s.steps);
  const Json plan = object_at(json, "plan");
  s.planned_steps = plan.value("steps", s.planned_steps);
  s.planned_memory = real_at(plan, "memory", s.planned_memory);
  s.first_step = json.value("first_step", s.first_step);
  s.wall_seconds = real_at(json, "wall_seconds", s.wall_seconds);
  s.start_seconds = real_at(json, "start_seconds", s.start_seconds);
  s.cpu_seconds = real_at(json, "cpu_seconds", s.cpu_seconds);
  s.points = json.value("points", s.points);
  s.elements = json.value("elements", s.elements);
  s.particles = json.value("particles", s.particles);
  const Json phases = object_at(json, "phases");
  for (const auto& [name, unused] : phases.items()) {
    s.phases.emplace_back(name, real_at(phases, name.c_str(), kUnknown));
  }
  s.loop_seconds = real_at(json, "loop_seconds", s.loop_seconds);
  s.ns_element_step = real_at(json, "ns_element_step", s.ns_element_step);
  s.ns_particle_step = real_at(json, "ns_particle_step", s.ns_particle_step);
  const Json pairs = object_at(json, "pairs");
  s.pairs = {pairs.value("in_support", s.pairs.in_support),
             pairs.value("compared", s.pairs.compared)};
  s.peak_memory = real_at(json, "peak_memory", s.peak_memory);
  s.drift = real_at(json, "drift", s.drift);
  s.state_hash = json.value("state_hash", s.state_hash);
  s.energy = energy_from(object_at(json, "energy"));
  s.step_bounds = shares_from(json, "step_bounds");
  s.step_margins = shares_from(json, "step_margins", kUnknown);
  s.eroded = shares_from(json, "eroded");
  read_process(object_at(json, "process"), s);
  s.measures = measures_from(object_at(json, "measures"));
  const Json warnings = json.value("warnings", Json::array());
  for (const auto& entry : warnings) {
    s.warnings.push_back({entry.value("id", ""), entry.value("text", "")});
  }
  s.contact_lists = json.value("contact_lists", s.contact_lists);
  s.ranks = json.value("ranks", s.ranks);
  s.threads = json.value("threads", s.threads);
  s.instruction_set = json.value("instruction_set", s.instruction_set);
  s.messages_step = json.value("messages_step", s.messages_step);
  s.bytes_step = json.value("bytes_step", s.bytes_step);
  s.reductions_step = json.value("reductions_step", s.reductions_step);
  s.balance = json.value("balance", s.balance);
  s.repartitions = json.value("repartitions", s.repartitions);
  return s;
}

}  // namespace

std::string status_word(int status) {
  switch (status) {
    case 0:
      return "done";
    case 2:
      return "deck error";
    case 3:
      return "physics error";
    case 4:
      return "machine error";
    case 5:
      return "stopped";
    default:
      return "status " + std::to_string(status);
  }
}

std::string to_json(const RunSummary& s) {
  Json json;
  json["version"] = s.version;
  json["deck_hash"] = s.deck_hash;
  json["parameters"] = Json::object();
  for (const auto& [name, text] : s.parameters) json["parameters"][name] = text;
  json["overrides"] = s.overrides;
  json["status"] = s.status;
  json["reason"] = s.reason;
  json["steps"] = s.steps;
  json["plan"] = {{"steps", s.planned_steps}, {"memory", s.planned_memory}};
  json["first_step"] = s.first_step;
  json["wall_seconds"] = s.wall_seconds;
  json["start_seconds"] = s.start_seconds;
  json["cpu_seconds"] = s.cpu_seconds;
  json["points"] = s.points;
  json["elements"] = s.elements;
  json["particles"] = s.particles;
  json["phases"] = Json::object();
  for (const auto& [name, seconds] : s.phases) json["phases"][name] = seconds;
  json["loop_seconds"] = s.loop_seconds;
  json["ns_element_step"] = s.ns_element_step;
  json["ns_particle_step"] = s.ns_particle_step;
  if (s.particles > 0) json["pairs"] = pairs_json(s.pairs);
  json["peak_memory"] = s.peak_memory;
  json["drift"] = s.drift;
  if (!s.state_hash.empty()) json["state_hash"] = s.state_hash;
  json["energy"] = energy_json(s.energy);
  if (s.process_speed != 1) json["process"] = process_json(s);
  if (!s.step_bounds.empty()) json["step_bounds"] = shares_json(s.step_bounds);
  if (!s.step_margins.empty()) json["step_margins"] = shares_json(s.step_margins);
  if (!s.eroded.empty()) json["eroded"] = shares_json(s.eroded);
  json["measures"] = measures_json(s.measures);
  json["warnings"] = Json::array();
  for (const auto& warning : s.warnings) {
    json["warnings"].push_back({{"id", warning.id}, {"text", warning.text}});
  }
  json["contact_lists"] = s.contact_lists;
  json["ranks"] = s.ranks;
  json["threads"] = s.threads;
  json["instruction_set"] = s.instruction_set;
  json["messages_step"] = s.messages_step;
  json["bytes_step"] = s.bytes_step;
  json["reductions_step"] = s.reductions_step;
  json["balance"] = s.balance;
  json["repartitions"] = s.repartitions;
  // Text of the user that is not UTF-8 is replaced rather than losing the whole summary.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

RunSummary parse_summary(const std::string& text, const std::string& name) {
  try {
    return from_json(Json::parse(text));
  } catch (const std::exception& error) {
    throw MachineError("'" + name + "' is not a summary of a run: " + error.what());
  }
}

void write_summary(const std::filesystem::path& folder, const RunSummary& summary) {
  write_file_atomically(folder / "summary.json", to_json(summary));
}

RunSummary read_summary(const std::filesystem::path& folder) {
  const auto path = folder / "summary.json";
  return parse_summary(read_file(path), path.string());
}

}  // namespace brunt
