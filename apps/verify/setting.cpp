#include "apps/verify/setting.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"

namespace nilas::verify {

std::filesystem::path verify_scenes() {
  const std::filesystem::path source = NILAS_SCENES "/verify";
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed = program.parent_path().parent_path() / "share/nilas/scenes/verify";
  for (const auto& folder : {installed, source})
    if (std::filesystem::is_directory(folder, error)) return folder;
  throw FileError("the scenes of nilas verify are neither in " + installed.string() + " nor in " + source.string());
}

std::string text(double value) { return fmt::format("{}", value); }
std::string text(const Vec3& value) { return fmt::format("{} {} {}", value.x(), value.y(), value.z()); }

Setting::Setting(const Case& of, const Model& model, std::map<std::string, double> inputs)
    : case_(of), model_(model), inputs_(std::move(inputs)) {}

double Setting::operator[](const std::string& input) const {
  const auto found = inputs_.find(input);
  NILAS_DEMAND(found != inputs_.end());
  return found->second;
}

long Setting::steps(double time) const { return std::lround(time / h()); }

Trial Setting::trial(const scene::Overrides& overrides, int threads) const {
  return trial_of(case_.scene, overrides, threads);
}

Trial Setting::trial_of(const std::string& scene, const scene::Overrides& overrides, int threads) const {
  scene::Overrides all{{"time/@step", text(h())},
                       {"time/@end", "1e9"},
                       {"contact/@law", model_.law},
                       {"contact/@solver", model_.solver},
                       {"contact/@integrator", model_.integrator},
                       {"contact/@tolerance", text(case_.contact_tolerance)},
                       {"contact/@max_iterations", std::to_string(case_.contact_iterations)}};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return Trial(scene::read_scene(verify_scenes() / scene, all), threads);
}

}  // namespace nilas::verify
