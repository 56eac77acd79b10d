#include "core/output/run/run_folder.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/error.h"
#include "core/output/replay/replay_file.h"
#include "core/output/run/claim_folder.h"
#include "core/output/run/run_inputs.h"
#include "core/output/run/scene_xml.h"
#include "core/output/tables/contacts_h5.h"
#include "core/output/tables/events_csv.h"
#include "core/output/tables/parts_csv.h"
#include "core/output/tables/problem_files.h"
#include "core/output/tables/structures_csv.h"

namespace nilas::output {

/// The length to which a file of a continued run is cut; empty for a new run.
static std::optional<std::int64_t> kept_bytes(const StateReader* from, const std::string& file) {
  if (from == nullptr) return std::nullopt;
  std::int64_t bytes = 0;
  from->group("bytes").get(file, bytes);
  return bytes;
}

constexpr const char* k_statistics_file = "statistics.bin";

/// The same for the file of the statistics, which a run without numbers for them does not have.
static std::optional<std::int64_t> kept_statistics(const sim::RunInfo& info, const StateReader* from) {
  return RunStatistics::numbers_per_step(info) > 0 ? kept_bytes(from, k_statistics_file) : std::nullopt;
}

struct RunFolder::Outputs {
  Outputs(const std::filesystem::path& folder, const scene::Scene& scene, const sim::RunInfo& run_info,
          WarningCounts& counts, const StateReader* from)
      : info(run_info),
        warnings(counts),
        channels(info),
        statistics(info, folder / k_statistics_file, kept_statistics(info, from)),
        steps(folder / "steps.csv", info, kept_bytes(from, "steps.csv")),
        problems(folder, scene.output.problems, scene.contact.integrator != Integrator::reference),
        snapshot_every(scene.output.trajectory_every),
        bodies_asked(scene.output.bodies),
        contacts_of_all(scene.output.contacts == StoredContacts::all) {
    if (info.has_vessel) vessel.emplace(folder / "vessel.csv", channels, kept_bytes(from, "vessel.csv"));
    if (!info.parts.empty() || !info.rods.empty())
      vessel_parts.emplace(folder / "parts.csv", info, kept_bytes(from, "parts.csv"));
    if (!info.structures.empty())
      structures.emplace(folder / "structures.csv", info, kept_bytes(from, "structures.csv"));
    if (ContactsH5::asked(scene, info)) {
      std::optional<StateReader> kept;
      if (from != nullptr) kept = from->group("contacts");
      contacts.emplace(folder / "contacts.h5", scene, info, kept ? &*kept : nullptr);
    }
    if (scene.fracture && scene.fracture->cuts_floes())
      events.emplace(folder / "events.csv", kept_bytes(from, "events.csv"));
    if (snapshot_every > 0) trajectory.emplace(folder, scene, contacts.has_value(), kept_bytes(from, "trajectory.pvd"));
    if (snapshot_every > 0) open_replay(folder, scene, from);
    if (from != nullptr) restore(*from);
  }

  void open_replay(const std::filesystem::path& folder, const scene::Scene& scene, const StateReader* from) {
    std::optional<StateReader> kept;
    if (from != nullptr) kept = from->group("replay");
    const std::vector<std::string> no_vessel;
    replay.emplace(folder / "replay.bin", scene, info, vessel ? channels.names() : no_vessel, contacts.has_value(),
                   kept_bytes(from, "replay.bin"), kept ? &*kept : nullptr);
  }

  /// Opens bodies.csv. The default depends on the number of bodies at the start, before any broke.
  void open_bodies(const std::filesystem::path& folder, const StateReader* from) {
    if (snapshot_every > 0 && bodies_asked.value_or(info.bodies <= k_bodies_csv_default_limit))
      bodies.emplace(folder / "bodies.csv", kept_bytes(from, "bodies.csv"));
  }

  /// Calls `call` for every file that grows.
  template <class Call>
  void for_each_file(const Call& call) const {
    call("steps.csv", steps.file());
    if (vessel) call("vessel.csv", vessel->file());
    if (vessel_parts) call("parts.csv", vessel_parts->file());
    if (structures) call("structures.csv", structures->file());
    if (bodies) call("bodies.csv", bodies->file());
    if (trajectory) call("trajectory.pvd", trajectory->list());
    if (replay) call("replay.bin", replay->file());
    if (events) call("events.csv", events->file());
    if (statistics.file() != nullptr) call(k_statistics_file, *statistics.file());
  }

  void save(StateWriter out) const {
    StateWriter bytes = out.group("bytes");
    for_each_file([&](const char* name, const OutputFile& file) { bytes.add(name, file.bytes()); });
    out.add("t_start", t_start);
    out.add("snapshots", snapshots);
    statistics.save(out.group("statistics"));
    problems.save(out.group("problems"));
    if (contacts) contacts->save(out.group("contacts"));
    if (replay) replay->save(out.group("replay"));
  }

  void restore(const StateReader& in) {
    in.get("t_start", t_start);
    in.get("snapshots", snapshots);
    statistics.restore(in.group("statistics"));
    problems.restore(in.group("problems"));
  }

  /// Contacts of a step for the trajectory frames: those in contacts.h5.
  std::vector<ContactRow> shown_contacts(const std::vector<contact::SolvedProblem>& parts,
                                         const bodies::Bodies& now) const {
    std::vector<ContactRow> rows;
    if (!contacts || !trajectory) return rows;
    const LoadedBodies loaded = loaded_bodies(now, info);
    for (const contact::SolvedProblem& solved : parts) {
      const auto more = contact_rows(solved, loaded, contacts_of_all);
      rows.insert(rows.end(), more.begin(), more.end());
    }
    return rows;
  }

  /// Whether a snapshot is due. Snapshots are taken at the step nearest to each multiple of the interval.
  bool snapshot_due(double t, double h) const {
    return snapshot_every > 0 && t - t_start >= static_cast<double>(snapshots) * snapshot_every - 0.5 * h;
  }

  sim::RunInfo info;
  WarningCounts& warnings;
  VesselChannels channels;
  RunStatistics statistics;
  StepsCsv steps;
  std::optional<VesselCsv> vessel;
  std::optional<PartsCsv> vessel_parts;
  std::optional<StructuresCsv> structures;
  std::optional<BodiesCsv> bodies;
  std::optional<Trajectory> trajectory;
  std::optional<replay::ReplayFile> replay;
  std::optional<EventsCsv> events;
  std::optional<ContactsH5> contacts;
  ProblemFiles problems;
  double snapshot_every;  ///< interval of snapshots [s]; 0: none
  std::optional<bool> bodies_asked;
  bool contacts_of_all;
  double t_start = 0;
  long snapshots = 0;
  std::vector<double> vessel_values;
  double output_ms_before = 0;  ///< time that the outputs of the step before took [ms]
};

RunFolder::RunFolder(const std::filesystem::path& path, bool force, const std::vector<scene::InputFile>& inputs)
    : path_(path), lock_(claim_run_folder(path, force, inputs)) {}
RunFolder::RunFolder(std::filesystem::path path, RunLock lock) : path_(std::move(path)), lock_(std::move(lock)) {}
RunFolder::~RunFolder() = default;

void RunFolder::abandon() const {
  std::error_code ignored;
  std::filesystem::remove(log_file(), ignored);
  std::filesystem::remove(path_, ignored);  // fails on purpose when the folder is not empty
}

void RunFolder::open(const scene::Scene& scene, const sim::RunInfo& info, WarningCounts& warnings) {
  copy_inputs(path_, scene.inputs);
  write_scene_xml(scene_file(), scene);
  outputs_ = std::make_unique<Outputs>(path_, scene, info, warnings, nullptr);
}

void RunFolder::resume(const scene::Scene& scene, const sim::RunInfo& info, WarningCounts& warnings,
                       const StateReader& in) {
  outputs_ = std::make_unique<Outputs>(path_, scene, info, warnings, &in);
  outputs_->open_bodies(path_, &in);
  copy_inputs(path_, scene.inputs);
  write_scene_xml(scene_file(), scene);
  clear_after(path_, outputs_->statistics.steps(), outputs_->problems.worst_step());
}

void RunFolder::write_checkpoint(const sim::CheckpointOrigin& origin, State state) {
  NILAS_DEMAND(outputs_ != nullptr);
  outputs_->for_each_file([](const char*, const OutputFile& file) { file.sync(); });
  if (outputs_->contacts) outputs_->contacts->sync();
  if (outputs_->trajectory) outputs_->trajectory->sync();
  outputs_->problems.sync();
  outputs_->save(StateWriter(state).group("outputs"));
  nilas::sim::write_checkpoint(checkpoint_file(), origin, state);
  outputs_->problems.saved();
}

/// What the modules draw now.
static std::vector<bodies::DrawnLine> drawn(const DrawnLines& lines) {
  return lines ? lines() : std::vector<bodies::DrawnLine>();
}

void RunFolder::start(double t, const sim::Ledger& ledger, const bodies::Bodies& bodies, const DrawnLines& lines) {
  NILAS_DEMAND(outputs_ != nullptr);
  Outputs& out = *outputs_;
  out.t_start = t;
  out.statistics.start(t, ledger);
  out.open_bodies(path_, nullptr);
  if (!out.snapshot_due(t, 0)) return;
  write_snapshot(t, 0, bodies, {});
  if (out.replay)
    out.replay->frame(
        {.t = t, .h = 0, .step = 0, .bodies = bodies, .substeps = {}, .damage = {}, .lines = drawn(lines)});
}

void RunFolder::record(sim::StepRecord record, const std::vector<contact::SolvedProblem>& parts,
                       const bodies::Bodies& bodies, const FloeDamage& damage, const DrawnLines& lines) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  NILAS_DEMAND(outputs_ != nullptr);
  Outputs& out = *outputs_;
  out.vessel_values.clear();
  if (out.vessel) {
    NILAS_DEMAND(record.vessel.has_value());
    if (!out.channels.read(*record.vessel, out.vessel_values))
      out.warnings.warn("gimbal lock",
                        "the vessel pitches to 90 degrees: its roll, pitch and yaw rates are written as 0");
    out.vessel->row(record.t, out.vessel_values);
    if (out.vessel_parts) out.vessel_parts->row(record.t, *record.vessel);
  }
  if (out.structures) out.structures->row(record);
  if (out.contacts) out.contacts->step(record, parts, loaded_bodies(bodies, out.info));
  if (out.events) out.events->rows(record.broken);
  double& output_ms = record.ms[static_cast<std::size_t>(sim::Phase::output)];
  if (out.replay) {
    // The time of this step's outputs is known once they are written, so viewers see that of the step before.
    const double own = std::exchange(output_ms, out.output_ms_before);
    out.replay->note(record, out.vessel_values);
    output_ms = own;
  }
  if (out.snapshot_due(record.t, record.h)) {
    write_snapshot(record.t, record.step, bodies, {out.shown_contacts(parts, bodies), record.h, damage});
    if (out.replay)
      out.replay->frame({.t = record.t,
                         .h = record.h,
                         .step = record.step,
                         .bodies = bodies,
                         .substeps = parts,
                         .damage = damage,
                         .lines = drawn(lines)});
  }
  output_ms += std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  out.output_ms_before = output_ms;
  out.steps.row(record);
  out.statistics.add(record, out.vessel_values);
}

void RunFolder::store(const sim::StepRecord& record, const contact::SolvedProblem& solved) {
  NILAS_DEMAND(outputs_ != nullptr);
  outputs_->problems.step(record, solved);
}

void RunFolder::store_last(const contact::SolvedProblem& solved) {
  NILAS_DEMAND(outputs_ != nullptr);
  outputs_->problems.last(solved);
}

void RunFolder::write_snapshot(double t, long step, const bodies::Bodies& bodies, const ShownStep& shown) {
  Outputs& out = *outputs_;
  ++out.snapshots;
  if (out.bodies) out.bodies->rows(t, bodies);
  if (out.trajectory) out.trajectory->frame(t, step, bodies, shown);
}

/// How a run ended, for its viewers.
static std::string ending_sentence(const SummaryInput& input) {
  if (!input.ended_early.empty()) return "The run ended early: " + input.ended_early + ".";
  return input.status == "done" ? "The run reached its end." : "The run ended with the status '" + input.status + "'.";
}

nlohmann::ordered_json RunFolder::finish(SummaryInput input, const bodies::Bodies& bodies) {
  NILAS_DEMAND(outputs_ != nullptr);
  Outputs& out = *outputs_;
  out.steps.finish();
  if (out.vessel) out.vessel->finish();
  if (out.vessel_parts) out.vessel_parts->finish();
  if (out.structures) out.structures->finish();
  if (out.bodies) out.bodies->finish();
  if (out.trajectory) out.trajectory->finish();
  if (out.replay) out.replay->finish(ending_sentence(input));
  if (out.events) out.events->finish();
  if (out.contacts) out.contacts->finish();
  input.ice_mass_end = free_ice_mass(bodies);
  input.floes_end = std::count(bodies.kind.begin(), bodies.kind.end(), bodies::BodyKind::floe);
  auto summary = summary_json(out.info, out.statistics, input);
  write_summary_json(summary_file(), summary);
  // Only a run that goes on needs it. What is open can still be read.
  std::error_code error;
  const bool goes_on = std::filesystem::exists(checkpoint_file(), error);
  if (!goes_on && !error) std::filesystem::remove(path_ / k_statistics_file, error);
  return summary;
}

const RunStatistics& RunFolder::statistics() const {
  NILAS_DEMAND(outputs_ != nullptr);
  return outputs_->statistics;
}

std::int64_t RunFolder::replay_bytes() const {
  return outputs_ && outputs_->replay ? outputs_->replay->file().bytes() : 0;
}

double free_ice_mass(const bodies::Bodies& bodies) {
  double mass = 0;
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    if (bodies.kind[b] == bodies::BodyKind::floe && bodies.motion[b] == bodies::Motion::free) mass += bodies.mass[b];
  return mass;
}

}  // namespace nilas::output
