#pragma once
/// What a case's check works with: its inputs, the model asked for, and runs of its scene.
#include <filesystem>
#include <map>

#include "apps/verify/case.h"
#include "apps/verify/trial.h"
#include "core/scene/read/read_scene.h"

namespace nilas {

/// Where the scenes of the cases lie. Throws FileError naming the places that were tried.
std::filesystem::path verify_scenes();

/// A vector as an attribute's value.
std::string text(const Vec3& value);
std::string text(double value);

class Setting {
 public:
  Setting(const Case& of, const Model& model, std::map<std::string, double> inputs);

  /// An input. Throws ContractError for a name that the case has not.
  double operator[](const std::string& input) const;
  const Model& model() const { return model_; }
  double h() const { return model_.step; }
  double theta() const { return model_.theta(); }
  /// Steps until `time` seconds, rounded to the nearest.
  long steps(double time) const;

  /// The case's scene with the model's choices and `overrides` (as --set takes them).
  Trial trial(const Overrides& overrides, int threads = 1) const;
  /// Another scene file with the same choices.
  Trial trial_of(const std::string& scene, const Overrides& overrides, int threads = 1) const;

 private:
  const Case& case_;
  Model model_;
  std::map<std::string, double> inputs_;
};

}  // namespace nilas
