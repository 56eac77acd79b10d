#include "hydro/database/capytaine.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "core/base/error.h"
#include "hydro/database/labelled_file.h"

namespace nilas::hydro {

namespace {

constexpr std::array<const char*, 6> k_capytaine_modes{"surge", "sway", "heave", "roll", "pitch", "yaw"};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Values of a variable by the names of dimensions; a dimension that it lacks does not matter.
class NamedTable {
 public:
  NamedTable(const LabelledFile& file, const std::string& name, const std::vector<std::string>& dimensions)
      : array_(file.numbers(name)), strides_(dimensions.size(), 0) {
    std::size_t stride = 1;
    for (std::size_t k = array_.shape.size(); k-- > 0; stride *= array_.shape[k]) {
      const auto found = std::find(dimensions.begin(), dimensions.end(), array_.dimensions[k]);
      if (found != dimensions.end())
        strides_[static_cast<std::size_t>(found - dimensions.begin())] = stride;
      else if (array_.shape[k] != 1)
        file.refuse(name, "has " + std::to_string(array_.shape[k]) + " entries along " +
                              (array_.dimensions[k].empty() ? "a dimension without name" : array_.dimensions[k]) +
                              "; allowed: 1");
    }
  }
  double at(const std::vector<std::size_t>& index) const {
    std::size_t place = 0;
    for (std::size_t k = 0; k < index.size(); ++k) place += index[k] * strides_[k];
    return array_.values[place];
  }

 private:
  LabelledArray array_;
  std::vector<std::size_t> strides_;
};

class CapytaineReader {
 public:
  explicit CapytaineReader(const std::filesystem::path& path) : file_(open_labelled(path)) {
    database_.source = path.string();
    database_.density = positive("rho");
    database_.gravity = positive("g");
    if (const auto depth = scalar("water_depth"); depth && std::isfinite(*depth))
      database_.depth = positive("water_depth");
    if (const auto speed = scalar("forward_speed"); speed && *speed != 0)
      file_->refuse("forward_speed", "the computation has a forward speed; allowed: 0");
    radiating_ = modes("radiating_dof");
    influenced_ = modes("influenced_dof");
    read_frequencies();
  }

  UnmovedDatabase read() {
    read_hydrostatics();
    const auto reference = point("rotation_center");
    if (file_->has("wave_direction")) database_.heading = file_->numbers("wave_direction").values;
    read_loads();
    read_radiation();
    if (database_.frequency.empty())
      file_->refuse("added_mass", "has no frequency above 0 whose values are all numbers");
    note_left_out();
    return {std::move(database_), reference};
  }

 private:
  std::optional<double> scalar(const std::string& name) const {
    if (!file_->has(name)) return std::nullopt;
    const LabelledArray array = file_->numbers(name);
    if (array.values.size() != 1)
      file_->refuse(name, "has " + std::to_string(array.values.size()) + " values; allowed: 1");
    return array.values.front();
  }

  double positive(const std::string& name) const {
    const auto value = scalar(name);
    if (!value) file_->refuse(name, "is missing");
    if (!(*value > 0)) file_->refuse(name, "found " + std::to_string(*value) + "; allowed: a number > 0");
    return *value;
  }

  std::optional<Vec3> point(const std::string& name) const {
    if (!file_->has(name)) return std::nullopt;
    const LabelledArray array = file_->numbers(name);
    if (array.values.size() != 3) file_->refuse(name, "does not hold one point; allowed: one body");
    const Vec3 value(array.values[0], array.values[1], array.values[2]);
    if (!value.allFinite()) return std::nullopt;
    return value;
  }

  /// For each of the six modes its place in the file.
  std::vector<std::size_t> modes(const std::string& name) const {
    if (!file_->has(name)) file_->refuse(name, "is missing; allowed: the names of the modes");
    const std::vector<std::string> names = file_->texts(name);
    std::vector<std::size_t> places;
    for (const char* mode : k_capytaine_modes) {
      const auto is_mode = [&](const std::string& written) {
        // In files of later versions the name of the body goes before that of the mode.
        const std::size_t body = written.rfind("__");
        return lower_case(body == std::string::npos ? written : written.substr(body + 2)) == mode;
      };
      const auto found = std::find_if(names.begin(), names.end(), is_mode);
      if (found == names.end()) file_->refuse(name, "has no mode '" + std::string(mode) + "'; allowed: Surge to Yaw");
      places.push_back(static_cast<std::size_t>(found - names.begin()));
    }
    if (names.size() != places.size())
      file_->refuse(name, "has " + std::to_string(names.size()) + " modes; allowed: the six of one rigid body");
    return places;
  }

  void read_frequencies() {
    const LabelledArray mass = file_->numbers("added_mass");
    for (const char* name : {"omega", "freq", "period", "wavenumber", "wavelength"})
      if (std::find(mass.dimensions.begin(), mass.dimensions.end(), name) != mass.dimensions.end())
        frequency_dimension_ = name;
    const std::string variable = file_->has("omega") ? "omega" : frequency_dimension_;
    if (variable != "omega" && variable != "freq" && variable != "period")
      file_->refuse("omega", "is missing; allowed: omega, freq or period");
    for (const double value : file_->numbers(variable).values)
      frequencies_.push_back(variable == "omega" ? value : 2 * k_pi * (variable == "freq" ? value : 1 / value));
    // Their order in the file is free.
    for (std::size_t k = 0; k < frequencies_.size(); ++k) {
      if (std::isnan(frequencies_[k]) || frequencies_[k] < 0) file_->refuse(variable, "holds a value below 0 or none");
      if (!order_.emplace(frequencies_[k], k).second) file_->refuse(variable, "holds a value twice");
    }
  }

  Mat6 matrix(const NamedTable& table, std::size_t k) const {
    Mat6 result;
    for (std::size_t i = 0; i < influenced_.size(); ++i)
      for (std::size_t j = 0; j < radiating_.size(); ++j)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            table.at({k, influenced_[i], radiating_[j]});
    return result;
  }

  void read_radiation() {
    const std::vector<std::string> dimensions{frequency_dimension_, "influenced_dof", "radiating_dof"};
    const NamedTable mass(*file_, "added_mass", dimensions), damping(*file_, "radiation_damping", dimensions);
    std::vector<std::vector<ComplexVec6>> kept;
    for (const auto& [w, k] : order_) {
      const Mat6 a = matrix(mass, k), b = matrix(damping, k);
      const bool is_limit = w == 0 || std::isinf(w);
      const bool whole = a.allFinite() && (is_limit || (b.allFinite() && load_is_finite(k)));
      if (!whole) {
        left_out_.push_back(w);
      } else if (is_limit) {
        (w == 0 ? database_.added_mass_zero : database_.added_mass_infinite) = a;
      } else {
        database_.frequency.push_back(w);
        database_.added_mass.push_back(a);
        database_.damping.push_back(b);
        if (!loads_.empty()) database_.excitation.push_back(loads_[k]);
      }
    }
  }

  /// The parts of the excitation: the sum, or diffraction and Froude-Krylov force.
  std::vector<std::string> load_parts() const {
    if (file_->has("excitation_force")) return {"excitation_force"};
    if (file_->has("diffraction_force") && file_->has("Froude_Krylov_force"))
      return {"diffraction_force", "Froude_Krylov_force"};
    return {};
  }

  void read_loads() {
    const std::vector<std::string> parts = load_parts();
    if (parts.empty() || database_.heading.empty()) {
      database_.notes.push_back("The file has no excitation_force, so the database has no wave excitation.");
      database_.heading.clear();
      return;
    }
    const auto [real, imaginary] = complex_places();
    loads_.assign(frequencies_.size(), std::vector<ComplexVec6>(database_.heading.size(), ComplexVec6::Zero()));
    for (const std::string& part : parts) {
      const NamedTable table(*file_, part, {"complex", frequency_dimension_, "wave_direction", "influenced_dof"});
      for (std::size_t k = 0; k < frequencies_.size(); ++k)
        for (std::size_t h = 0; h < database_.heading.size(); ++h)
          for (std::size_t i = 0; i < influenced_.size(); ++i)
            loads_[k][h][static_cast<Eigen::Index>(i)] += std::complex<double>(
                table.at({real, k, h, influenced_[i]}), -table.at({imaginary, k, h, influenced_[i]}));
    }
    sort_headings();
  }

  std::pair<std::size_t, std::size_t> complex_places() const {
    if (!file_->has("complex")) file_->refuse("complex", "is missing; allowed: 're' and 'im'");
    const std::vector<std::string> names = file_->texts("complex");
    const auto real = std::find(names.begin(), names.end(), "re"),
               imaginary = std::find(names.begin(), names.end(), "im");
    if (real == names.end() || imaginary == names.end() || names.size() != 2)
      file_->refuse("complex", "does not name the parts; allowed: 're' and 'im'");
    return {static_cast<std::size_t>(real - names.begin()), static_cast<std::size_t>(imaginary - names.begin())};
  }

  void sort_headings() {
    std::map<double, std::size_t> order;
    for (std::size_t h = 0; h < database_.heading.size(); ++h)
      if (!std::isfinite(database_.heading[h]) || !order.emplace(database_.heading[h], h).second)
        file_->refuse("wave_direction", "holds a value twice or one that is no number");
    const auto unsorted = loads_;
    database_.heading.clear();
    for (std::size_t n = 0; const auto& [heading, h] : order) {
      database_.heading.push_back(heading);
      for (std::size_t k = 0; k < loads_.size(); ++k) loads_[k][n] = unsorted[k][h];
      ++n;
    }
  }

  bool load_is_finite(std::size_t k) const {
    return loads_.empty() ||
           std::all_of(loads_[k].begin(), loads_[k].end(), [](const ComplexVec6& load) { return load.allFinite(); });
  }

  void read_hydrostatics() {
    const auto optional_matrix = [&](const std::string& name) -> std::optional<Mat6> {
      if (!file_->has(name)) return std::nullopt;
      const Mat6 values = matrix(NamedTable(*file_, name, {"none", "influenced_dof", "radiating_dof"}), 0);
      if (!values.allFinite()) return std::nullopt;
      return values;
    };
    database_.restoring = optional_matrix("hydrostatic_stiffness");
    database_.mass = optional_matrix("inertia_matrix");
    if (!database_.restoring)
      database_.notes.push_back("The file has no hydrostatic_stiffness, so the database has none.");
    database_.centre_of_gravity = point("center_of_mass");
    database_.centre_of_buoyancy = point("center_of_buoyancy");
    if (const auto displaced = scalar("disp_mass"); displaced && *displaced > 0)
      database_.volume = *displaced / database_.density;
  }

  void note_left_out() {
    if (left_out_.empty()) return;
    std::ostringstream text;
    text << "The file has no number at w =";
    for (const double w : left_out_) text << ' ' << w;
    text << " rad/s, so these are left out.";
    database_.notes.push_back(text.str());
  }

  std::unique_ptr<LabelledFile> file_;
  Database database_;
  std::vector<std::size_t> radiating_, influenced_;
  std::string frequency_dimension_;
  std::vector<double> frequencies_;      ///< as in the file [rad/s]
  std::map<double, std::size_t> order_;  ///< frequencies from the lowest, with their place in the file
  std::vector<std::vector<ComplexVec6>> loads_;
  std::vector<double> left_out_;
};

}  // namespace

UnmovedDatabase read_capytaine(const std::filesystem::path& path) { return CapytaineReader(path).read(); }

}  // namespace nilas::hydro
