#pragma once
/// The setting of a case's check: its inputs, the model of the run, and runs of its scene.
#include <filesystem>
#include <map>

#include "apps/verify/case.h"
#include "apps/verify/trial.h"
#include "core/scene/read/read_scene.h"

namespace nilas::verify {

/// Returns the folder with the scenes of the cases. Throws FileError that names the folders that were tried.
std::filesystem::path verify_scenes();

/// Returns a value as the text of an attribute.
std::string text(const Vec3& value);
std::string text(double value);

/// Inputs and model of one run of a case.
class Setting {
 public:
  Setting(const Case& of, const Model& model, std::map<std::string, double> inputs);

  /// Returns an input. Throws ContractError for an input that the case does not have.
  double operator[](const std::string& input) const;
  const Model& model() const { return model_; }
  double h() const { return model_.step; }
  double theta() const { return model_.theta(); }
  /// Returns the number of steps until `time` [s], rounded to the nearest.
  long steps(double time) const;

  /// Returns a run of the case's scene with the model's choices and with `overrides`, as --set takes them.
  Trial trial(const scene::Overrides& overrides, int threads = 1) const;
  /// Returns a run of another scene file with the same choices.
  Trial trial_of(const std::string& scene, const scene::Overrides& overrides, int threads = 1) const;

 private:
  const Case& case_;
  Model model_;
  std::map<std::string, double> inputs_;
};

}  // namespace nilas::verify
