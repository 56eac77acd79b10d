#include "apps/report/page/run_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace nilas::report {

namespace {

void find_shapes(RunFindings& found, const std::string& body) {
  if (!found.run.scene) return;
  const scene::Scene& scene = *found.run.scene;
  const bool needs_identities = !found.run.has_vessel() || !body.empty();
  found.run.attempt("The shapes of vessel and bodies", [&] { found.shapes = run_shapes(scene, needs_identities); });
}

/// The ids of walls and of the scene's bodies in the run. Empty where the number of floes at the start is not known.
std::optional<std::vector<std::int64_t>> ids_of_others(const RunFindings& found) {
  if (!found.shapes) return std::nullopt;
  std::vector<std::int64_t> ids = found.shapes->others;
  if (found.shapes->with_ice || ids.empty()) return ids;
  std::int64_t floes = 0;
  if (found.run.summary.contains("ice") && found.run.summary.at("ice").contains("floes"))
    floes = found.run.summary.at("ice").at("floes");
  else if (!found.frames.empty() && found.frames.front().t == found.run.start())
    floes = static_cast<std::int64_t>(read_ice_frame(found.frames.front()).ids.size());
  else
    return std::nullopt;
  for (std::int64_t& id : ids) id += floes;
  return ids;
}

void find_contacts(RunFindings& found) {
  RunData& run = found.run;
  if (run.scene && run.scene->output.contacts == StoredContacts::none) {
    run.gaps.push_back(
        {"Load by place", "The run stored no contacts, since its scene has <output contacts=\"none\">."});
    return;
  }
  if (found.body == nullptr) return;
  const bool read = run.attempt("Load by place", [&] {
    found.contacts = hull_contacts(run.folder / "contacts.h5", found.body->ids, found.body->is_vessel);
  });
  if (read && found.contacts->steps < run.steps_done())
    run.gaps.push_back(
        {"Load by place", fmt::format("contacts.h5 holds {} of {} steps, so it was cut or is still being "
                                      "written. What it holds is shown.",
                                      found.contacts->steps, run.steps_done())});
  if (!read || found.load == nullptr) return;
  const auto& series = found.load->series;
  const auto& across =
      found.load->is_vessel() ? run.vessel["ice_side_N"] : run.structures[found.load->name + "_ice_side_N"];
  std::optional<std::vector<std::int64_t>> others;
  run.attempt("The floe of the largest load", [&] { others = ids_of_others(found); });
  found.floe_made_peak = others.has_value();
  const double time = found.load->along.peak.raw_time;
  for (std::size_t k = 0; k < series.size(); ++k)
    if (std::abs(run.times()[k] - time) < 0.5 * run.step())
      found.cause = peak_cause(*found.contacts, time, run.step(), series[k], across[k],
                               others.value_or(std::vector<std::int64_t>{}));
  // The load on a fixed body is that along the drift, which the run states.
  if (found.cause && !found.body->is_vessel) found.cause->course = found.shapes->info.drift_course;
}

}  // namespace

const IceFrameFile* frame_near(const RunFindings& found, double t) {
  const auto nearest = std::min_element(found.frames.begin(), found.frames.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.t - t) < std::abs(b.t - t);
  });
  return nearest == found.frames.end() ? nullptr : &*nearest;
}

std::string RunFindings::vessel_name() const {
  return run.scene && run.scene->vessel ? run.scene->vessel->name : "vessel";
}

std::string RunFindings::subject() const {
  if (load == nullptr) return "";
  return load->is_vessel() ? "the vessel" : "'" + load->name + "'";
}

std::unique_ptr<RunFindings> examine_run(const std::filesystem::path& folder, const std::string& body) {
  auto found = std::make_unique<RunFindings>();
  found->run = read_run(folder);
  find_shapes(*found, body);
  found->loads = body_loads(found->run, found->shapes ? &*found->shapes : nullptr);
  found->load = subject_of(found->loads, body, found->vessel_name());
  if (found->shapes && found->load != nullptr)
    found->body = found->shapes->find(found->load->name, found->load->is_vessel());
  found->run.attempt("The ice over time", [&] { found->frames = ice_frame_files(folder); });
  if (found->load != nullptr) find_contacts(*found);
  if (!found->cause || found->floe_made_peak) return found;
  if (const IceFrameFile* frame = frame_near(*found, found->load->along.peak.raw_time))
    found->run.attempt("The floe of the largest load", [&] {
      const auto ids = read_ice_frame(*frame).ids;
      found->floe_made_peak = std::find(ids.begin(), ids.end(), found->cause->floe) != ids.end();
    });
  return found;
}

}  // namespace nilas::report
