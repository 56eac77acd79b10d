#include "core/scene/read/scale_defaults.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/geometry/mesh.h"
#include "core/geometry/mesh_box.h"
#include "core/scene/scene.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/ice_presets.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace fs = std::filesystem;

namespace {

/// The scale at which the defaults of the towing carriage and of the step were chosen. Scenes without ice or motion
/// keep the default tolerance.
constexpr double k_model_length = defaults::k_hull_length;                // [m]
constexpr double k_thin_ice = 0.2, k_long_hull = 30, k_long_field = 100;  // [m], from there on full scale
constexpr double k_tolerance_share = 1e-3;                                // share of the speed
constexpr double k_least_tolerance = 1e-9;                                // [m/s]

/// The number 1, 2 or 5 times a power of ten that is nearest by ratio.
double near_round_number(double x) {
  const double decade = std::pow(10, std::floor(std::log10(x)));
  double best = decade;
  for (const double digit : {1.0, 2.0, 5.0, 10.0})
    if (std::abs(std::log(x / (digit * decade))) < std::abs(std::log(x / best))) best = digit * decade;
  return best;
}

/// Rounds a default to three digits, since nobody chose the others.
std::string three_digits(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return format_number(std::round(x / unit) * unit);
}

std::optional<double> mesh_length(const fs::path& hull) {
  try {
    const geometry::TriangleMesh mesh = geometry::read_stl(fs::is_directory(hull) ? hull / "fluid.stl" : hull);
    return geometry::box_of(mesh).sizes().x();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<double> hull_length(const SceneElement& vessel, const fs::path& folder, double file_scale) {
  if (const SceneElement* form = child_of(vessel, "hull")) return number_of(*form, "length").value_or(k_model_length);
  const auto hull = text_of(vessel, "hull");
  if (!hull) return std::nullopt;
  const auto length = mesh_length(folder / *hull);
  return length ? std::optional(*length * file_scale) : std::nullopt;
}

double path_speed(const fs::path& file) {
  double fastest = 0;
  try {
    const CsvTable table = read_csv(file.string(), {"t_s", "x_m", "y_m", "yaw_deg"});
    for (std::size_t k = 1; k < table.rows.size(); ++k) {
      const auto &a = table.rows[k - 1], &b = table.rows[k];
      if (b[0] > a[0]) fastest = std::max(fastest, std::hypot(b[1] - a[1], b[2] - a[2]) / (b[0] - a[0]));
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return 0;
  }
  return fastest;
}

/// The fastest current of a table over `coordinate`.
double current_speed(const fs::path& file, const std::string& coordinate) {
  double fastest = 0;
  try {
    for (const auto& row : read_csv(file.string(), {coordinate, "u_m_s", "v_m_s"}).rows)
      fastest = std::max(fastest, std::hypot(row[1], row[2]));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return 0;
  }
  return fastest;
}

/// The fastest motion that an element or its children name.
double fastest_in(const SceneElement& element, const fs::path& folder, double file_scale) {
  double fastest = 0;
  if (const auto v = numbers_of(element, "velocity"); v && v->size() == 3)
    fastest = std::hypot(v->at(0), v->at(1), v->at(2));
  if (element.name == "carriage") fastest = std::max(fastest, std::abs(number_of(element, "speed").value_or(0)));
  if (element.name == "path")
    if (const auto file = text_of(element, "file")) fastest = path_speed(folder / *file) * std::sqrt(file_scale);
  if (element.name == "current") {
    if (const auto file = text_of(element, "profile"))
      fastest += current_speed(folder / *file, "z_m") * std::sqrt(file_scale);
    if (const auto file = text_of(element, "series"))
      fastest += current_speed(folder / *file, "t_s") * std::sqrt(file_scale);
  }
  for (const auto& child : element.children) fastest = std::max(fastest, fastest_in(child, folder, file_scale));
  return fastest;
}

/// Thickness of the ice: its own, else the largest of its fields and floes.
std::optional<double> thickness_of(const SceneElement& ice) {
  if (const auto own = number_of(ice, "thickness")) return own;
  std::optional<double> largest;
  for (const auto& child : ice.children)
    if (const auto h = number_of(child, "thickness")) largest = std::max(largest.value_or(0), *h);
  return largest;
}

double field_extent(const SceneElement& ice) {
  double extent = 0;
  for (const auto& child : ice.children)
    if (const auto region = numbers_of(child, "region"); region && region->size() == 4)
      extent = std::max({extent, region->at(2) - region->at(0), region->at(3) - region->at(1)});
  return extent;
}

std::string metres(double x) { return fmt::format("{:.3g} m", x); }

}  // namespace

ScaleDefaults::ScaleDefaults(const SceneElement& root, const fs::path& folder) {
  const double file_scale = number_of(root, "scale").value_or(1);
  if (const SceneElement* vessel = child_of(root, "vessel")) length_ = hull_length(*vessel, folder, file_scale);
  if (length_ && !(*length_ > 0)) length_.reset();
  speed_ = fastest_in(root, folder, file_scale);
  fractures_ = child_of(root, "fracture") != nullptr;
  if (const SceneElement* ice = child_of(root, "ice")) {
    has_ice_ = true;
    choose_preset(*ice);
  } else {
    preset_ = ice_presets().front().name;
  }
}

void ScaleDefaults::choose_preset(const SceneElement& ice) {
  const std::string model = ice_presets().at(0).name, full_scale = ice_presets().at(1).name;
  const auto names = ice_preset_names();
  const auto asked = text_of(ice, "preset");
  const auto choose = [&](bool full, const std::string& reason) {
    preset_ = full ? full_scale : model;
    preset_reason_ = reason;
  };
  if (asked && std::find(names.begin(), names.end(), *asked) != names.end()) {
    preset_ = *asked;
    preset_reason_ = "as asked";
  } else if (const auto h = thickness_of(ice); h && *h > 0) {
    choose(*h >= k_thin_ice, "since the ice is " + metres(*h) + " thick");
  } else if (length_) {
    choose(*length_ >= k_long_hull, "since the hull is " + metres(*length_) + " long");
  } else if (const double extent = field_extent(ice); extent > 0) {
    choose(extent >= k_long_field, "since the field is " + metres(extent) + " long");
  } else {
    choose(false, "since neither ice nor hull tells the scale");
  }
}

std::optional<std::string> ScaleDefaults::of_ice(const std::string& element, const std::string& attribute) const {
  const IcePreset& p = ice_preset(preset_);
  const std::map<std::string, double> values{{"ice density", p.density},
                                             {"ice youngs_modulus", p.youngs_modulus},
                                             {"ice poisson", p.poisson},
                                             {"ice thickness", p.thickness},
                                             {"fracture flexural_strength", p.flexural_strength},
                                             {"fracture compressive_strength", p.compressive_strength},
                                             {"fracture fracture_toughness", p.fracture_toughness},
                                             {"fracture min_area", p.min_area},
                                             {"crushing coefficient", p.pressure_coefficient},
                                             {"size mean", p.floe_mean},
                                             {"size sd", p.floe_sd},
                                             {"size min", p.floe_min},
                                             {"size max", p.floe_max}};
  if (element == "ice" && attribute == "preset") return has_ice_ ? std::optional(preset_) : std::nullopt;
  const auto found = values.find(element + " " + attribute);
  return found == values.end() ? std::nullopt : std::optional(format_number(found->second));
}

std::optional<std::string> ScaleDefaults::take(const std::string& element, const std::string& attribute) {
  const std::string name = element + " " + attribute;
  const double scale = length_.value_or(k_model_length) / k_model_length;
  std::optional<std::string> value = of_ice(element, attribute);
  if (name == "time step") value = format_number(near_round_number(TimeScene{}.step * std::sqrt(scale)));
  if (name == "force_balance stiffness") value = three_digits(ForceBalanceScene{}.stiffness * std::pow(scale, 2));
  if (name == "force_balance damping") value = three_digits(ForceBalanceScene{}.damping * std::pow(scale, 2.5));
  const double supply = length_.value_or(ControlScene::k_length) / ControlScene::k_length;
  if (name == "thruster lag") value = three_digits(ThrusterScene{}.lag * std::sqrt(supply));
  if (name == "thruster turn_rate_deg") value = three_digits(ThrusterScene{}.turn_rate_deg / std::sqrt(supply));
  if (name == "control bandwidth") {
    const Vec3 w = ControlScene{}.bandwidth / std::sqrt(supply);
    value = three_digits(w.x()) + " " + three_digits(w.y()) + " " + three_digits(w.z());
  }
  if (name == "contact tolerance") {
    const double decade = std::floor(std::log10(k_tolerance_share * std::max(speed_, 1e-300)) + 1e-9);
    const bool scaled = has_ice_ && speed_ > 0;
    value = format_number(scaled ? std::max(k_least_tolerance, std::pow(10, decade)) : ContactScene{}.tolerance);
  }
  if (value) taken_[name] = *value;
  return value;
}

std::vector<std::string> ScaleDefaults::notes() const {
  std::vector<std::string> notes;
  /// The value taken, with few digits; empty if it was not taken.
  const auto taken = [&](const std::string& name) {
    const auto found = taken_.find(name);
    return found == taken_.end() ? "" : fmt::format("{:.3g}", parse_number(found->second).value_or(0));
  };
  if (length_ && *length_ != k_model_length) {
    const std::string froude = ", by Froude's law for a hull of " + metres(*length_);
    if (const std::string step = taken("time step"); !step.empty())
      notes.push_back("<time step>: " + step + " s is taken" + froude);
    if (const std::string k = taken("force_balance stiffness"); !k.empty())
      notes.push_back("<force_balance stiffness>: " + k + " N/m is taken for each cell" + froude);
    if (const std::string c = taken("force_balance damping"); !c.empty())
      notes.push_back("<force_balance damping>: " + c + " N s/m is taken for each cell" + froude);
  }
  if (const std::string tolerance = taken("contact tolerance"); !tolerance.empty() && has_ice_ && speed_ > 0)
    notes.push_back("<contact tolerance>: " + tolerance + " m/s is taken, at most a thousandth of the largest speed, " +
                    fmt::format("{:.3g} m/s", speed_));
  if (!has_ice_) return notes;
  std::string values;
  const auto add = [&](const std::string& name, const std::string& words, const std::string& unit) {
    if (const std::string value = taken(name); !value.empty())
      values += (values.empty() ? "" : ", ") + words + " " + value + unit;
  };
  add("ice thickness", "thickness", " m");
  add("size mean", "mean floe size", " m");
  if (fractures_) {
    add("ice youngs_modulus", "Young's modulus", " Pa");
    add("fracture flexural_strength", "flexural strength", " Pa");
    add("fracture compressive_strength", "compressive strength", " Pa");
    add("fracture fracture_toughness", "fracture toughness", " Pa sqrt(m)");
  }
  if (!values.empty()) notes.push_back("<ice preset>: '" + preset_ + "' is taken, " + preset_reason_ + ": " + values);
  return notes;
}

}  // namespace nilas::scene
