#include "hydro/database/bemio.h"

#include <cmath>

#include "core/base/error.h"
#include "core/hdf5/hdf5_file.h"

namespace nilas::hydro {

namespace {

const std::string k_simulation = "simulation_parameters/", k_properties = "body1/properties/",
                  k_coefficients = "body1/hydro_coeffs/";
constexpr std::size_t k_modes = 6;

double one_number(const hdf5::Hdf5Reader& file, const std::string& name) {
  const VecX values = file.numbers(name);
  if (values.size() != 1) file.refuse(name, "has " + std::to_string(values.size()) + " entries; allowed: 1");
  return values[0];
}

double positive(const hdf5::Hdf5Reader& file, const std::string& name) {
  const double value = one_number(file, name);
  if (!(value > 0)) file.refuse(name, "found " + std::to_string(value) + "; allowed: a number > 0");
  return value;
}

Vec3 point(const hdf5::Hdf5Reader& file, const std::string& name) {
  const VecX values = file.numbers(name);
  if (values.size() != 3) file.refuse(name, "has " + std::to_string(values.size()) + " entries; allowed: 3");
  return values;
}

/// The numbers of a dataset of this shape.
VecX table(const hdf5::Hdf5Reader& file, const std::string& name, const std::vector<std::size_t>& shape) {
  const auto written = [](const std::vector<std::size_t>& extents) {
    std::string text;
    for (const std::size_t n : extents) text += (text.empty() ? "" : " x ") + std::to_string(n);
    return text;
  };
  const VecX values = file.numbers(name);
  const std::vector<std::size_t> found = file.shape(name);
  if (found != shape) file.refuse(name, "has the shape " + written(found) + "; allowed: " + written(shape));
  return values;
}

class BemioReader {
 public:
  explicit BemioReader(const std::filesystem::path& path) : file_(path) {
    database_.source = path.string();
    database_.density = positive(file_, k_simulation + "rho");
    database_.gravity = positive(file_, k_simulation + "g");
    if (file_.has("body2"))
      file_.refuse("body2", "the file has several bodies; allowed: one body, without neighbours in the water");
    read_scaling();
    read_parameters();
    read_properties();
  }

  UnmovedDatabase read() {
    read_radiation();
    read_excitation();
    read_drift();
    const std::string name = k_coefficients + "linear_restoring_stiffness";
    if (file_.has(name)) database_.restoring = matrix(table(file_, name, {k_modes, k_modes}), 0, 1) * load_;
    return {std::move(database_), centre_of_gravity_};
  }

 private:
  void read_scaling() {
    const double scaled = one_number(file_, k_simulation + "scaled");
    if (scaled != 0 && scaled != 1)
      file_.refuse(k_simulation + "scaled", "found " + std::to_string(scaled) + "; allowed: 0 or 1");
    scaled_ = scaled == 1;
    mass_ = scaled_ ? 1 : database_.density;
    load_ = scaled_ ? 1 : database_.density * database_.gravity;
  }

  void read_parameters() {
    const VecX frequency = file_.numbers(k_simulation + "w"), heading = file_.numbers(k_simulation + "wave_dir");
    database_.frequency.assign(frequency.begin(), frequency.end());
    for (const double degrees : heading) database_.heading.push_back(degrees * k_deg);
    // An infinite depth is written as a text.
    const std::string depth = k_simulation + "water_depth";
    if (file_.has(depth) && file_.kind(depth) == hdf5::Hdf5Reader::Kind::numbers) {
      const VecX value = file_.numbers_or_infinity(depth);
      if (value.size() == 1 && std::isfinite(value[0])) database_.depth = positive(file_, depth);
    }
  }

  void read_properties() {
    const std::string dof = k_properties + "dof";
    if (file_.has(dof) && one_number(file_, dof) != static_cast<double>(k_modes))
      file_.refuse(dof, "the body has more than six modes; allowed: a rigid body");
    centre_of_gravity_ = point(file_, k_properties + "cg");
    database_.centre_of_gravity = centre_of_gravity_;
    database_.centre_of_buoyancy = point(file_, k_properties + "cb");
    database_.volume = positive(file_, k_properties + "disp_vol");
  }

  /// Entries (i, j, k) of a table whose last index has `count` values.
  static Mat6 matrix(const VecX& values, std::size_t k, std::size_t count) {
    Mat6 result;
    for (std::size_t i = 0; i < k_modes; ++i)
      for (std::size_t j = 0; j < k_modes; ++j)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            values[static_cast<Eigen::Index>((i * k_modes + j) * count + k)];
    return result;
  }

  void read_radiation() {
    const std::size_t count = database_.frequency.size();
    const VecX mass = table(file_, k_coefficients + "added_mass/all", {k_modes, k_modes, count});
    const VecX damping = table(file_, k_coefficients + "radiation_damping/all", {k_modes, k_modes, count});
    for (std::size_t k = 0; k < count; ++k) {
      database_.added_mass.push_back(matrix(mass, k, count) * mass_);
      database_.damping.push_back(matrix(damping, k, count) * (scaled_ ? 1 : mass_ * database_.frequency[k]));
    }
    const std::string limit = k_coefficients + "added_mass/inf_freq";
    if (file_.has(limit)) database_.added_mass_infinite = matrix(table(file_, limit, {k_modes, k_modes}), 0, 1) * mass_;
  }

  void read_excitation() {
    const std::size_t frequencies = database_.frequency.size(), headings = database_.heading.size();
    const std::vector<std::size_t> shape{k_modes, headings, frequencies};
    const VecX re = table(file_, k_coefficients + "excitation/re", shape);
    const VecX im = table(file_, k_coefficients + "excitation/im", shape);
    database_.excitation.assign(frequencies, std::vector<ComplexVec6>(headings));
    for (std::size_t i = 0; i < k_modes; ++i)
      for (std::size_t h = 0; h < headings; ++h)
        for (std::size_t k = 0; k < frequencies; ++k) {
          const auto n = static_cast<Eigen::Index>((i * headings + h) * frequencies + k);
          database_.excitation[k][h][static_cast<Eigen::Index>(i)] = load_ * std::complex<double>(re[n], im[n]);
        }
  }

  void read_drift() {
    const std::size_t frequencies = database_.frequency.size(), headings = database_.heading.size();
    for (const char* way : {"pressure_integration", "control_surface", "momentum_conservation"}) {
      const std::string name = k_coefficients + "mean_drift/" + way + "/val";
      if (!file_.has(name)) continue;
      const VecX values = table(file_, name, {k_modes, headings, frequencies});
      database_.drift.assign(frequencies, std::vector<Vec6>(headings));
      for (std::size_t i = 0; i < k_modes; ++i)
        for (std::size_t h = 0; h < headings; ++h)
          for (std::size_t k = 0; k < frequencies; ++k)
            database_.drift[k][h][static_cast<Eigen::Index>(i)] =
                load_ * values[static_cast<Eigen::Index>((i * headings + h) * frequencies + k)];
      return;
    }
  }

  hdf5::Hdf5Reader file_;
  Database database_;
  Vec3 centre_of_gravity_ = Vec3::Zero();
  bool scaled_ = false;
  double mass_ = 1, load_ = 1;  ///< by what the file's values must be multiplied
};

}  // namespace

UnmovedDatabase read_bemio(const std::filesystem::path& path) { return BemioReader(path).read(); }

namespace {

/// Values of all modes and headings, [mode][heading][frequency].
template <class Value>
std::vector<double> by_mode(const Database& database, const Value& value) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(k_modes); ++i)
    for (std::size_t h = 0; h < database.heading.size(); ++h)
      for (std::size_t k = 0; k < database.frequency.size(); ++k) values.push_back(value(k, h, i));
  return values;
}

/// Matrices as [i][j][frequency], each divided by unit(k).
template <class Unit>
std::vector<double> by_entry(const std::vector<Mat6>& matrices, const Unit& unit) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(k_modes); ++i)
    for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(k_modes); ++j)
      for (std::size_t k = 0; k < matrices.size(); ++k) values.push_back(matrices[k](i, j) / unit(k));
  return values;
}

void demand_complete(const Database& database, const std::filesystem::path& path) {
  const auto demand = [&](bool there, const char* what) {
    if (!there) throw InputError(path.string() + ": the form of BEMIO needs " + what + ", which the database has not");
  };
  demand(database.added_mass_infinite.has_value(), "the added mass at infinite frequency");
  demand(!database.excitation.empty(), "wave excitation");
  demand(database.restoring.has_value(), "the hydrostatic stiffness");
  demand(database.volume.has_value(), "the displaced volume");
}

void add_parameters(hdf5::Hdf5Writer& file, const Database& database) {
  std::vector<double> periods, headings;
  for (const double w : database.frequency) periods.push_back(2 * k_pi / w);
  for (const double heading : database.heading) headings.push_back(heading / k_deg);
  const std::size_t frequencies = database.frequency.size();
  file.add_group("simulation_parameters");
  file.add(k_simulation + "rho", {1, 1}, {database.density});
  file.add(k_simulation + "g", {1, 1}, {database.gravity});
  file.add(k_simulation + "scaled", {1, 1}, {0.0});
  file.add(k_simulation + "T", {frequencies, 1}, periods);
  file.add(k_simulation + "w", {frequencies, 1}, database.frequency);
  file.add(k_simulation + "wave_dir", {headings.size(), 1}, headings);
  if (database.depth)
    file.add(k_simulation + "water_depth", {1, 1}, {*database.depth});
  else
    file.add(k_simulation + "water_depth", std::string("infinite"));
}

void add_properties(hdf5::Hdf5Writer& file, const Database& database, const Vec3& reference) {
  const Vec3 buoyancy = database.centre_of_buoyancy.value_or(Vec3::Zero());
  file.add_group("body1");
  file.add_group("body1/properties");
  file.add(k_properties + "name", std::string("vessel"));
  for (const char* name : {"body_number", "dof_start"}) file.add(k_properties + name, {1, 1}, {1.0});
  for (const char* name : {"dof", "dof_end"}) file.add(k_properties + name, {1, 1}, {static_cast<double>(k_modes)});
  file.add(k_properties + "cg", {3, 1}, {reference.x(), reference.y(), reference.z()});
  file.add(k_properties + "cb", {3, 1}, {buoyancy.x(), buoyancy.y(), buoyancy.z()});
  file.add(k_properties + "disp_vol", {1, 1}, {*database.volume});
}

void add_coefficients(hdf5::Hdf5Writer& file, const Database& database) {
  const double load = database.density * database.gravity;
  const std::size_t frequencies = database.frequency.size();
  const std::vector<std::size_t> matrices{k_modes, k_modes, frequencies}, limit{k_modes, k_modes};
  const std::vector<std::size_t> loads{k_modes, database.heading.size(), frequencies};
  for (const char* group : {"", "added_mass", "radiation_damping", "excitation"})
    file.add_group(("body1/hydro_coeffs/" + std::string(group)));
  const auto mass_unit = [&](std::size_t) { return database.density; };
  file.add(k_coefficients + "added_mass/all", matrices, by_entry(database.added_mass, mass_unit));
  file.add(k_coefficients + "added_mass/inf_freq", limit, by_entry({*database.added_mass_infinite}, mass_unit));
  file.add(k_coefficients + "radiation_damping/all", matrices,
           by_entry(database.damping, [&](std::size_t k) { return database.density * database.frequency[k]; }));
  file.add(k_coefficients + "linear_restoring_stiffness", limit,
           by_entry({*database.restoring}, [&](std::size_t) { return load; }));
  using Complex = std::complex<double>;
  const auto add_parts = [&](const char* name, double (*part)(const Complex&), double unit) {
    file.add(k_coefficients + "excitation/" + name, loads, by_mode(database, [&](std::size_t k, std::size_t h, auto i) {
               return part(database.excitation[k][h][i]) / unit;
             }));
  };
  add_parts(
      "re", [](const Complex& x) { return x.real(); }, load);
  add_parts(
      "im", [](const Complex& x) { return x.imag(); }, load);
  add_parts(
      "mag", [](const Complex& x) { return std::abs(x); }, load);
  add_parts(
      "phase", [](const Complex& x) { return std::arg(x); }, 1);
  if (database.drift.empty()) return;
  file.add_group("body1/hydro_coeffs/mean_drift");
  file.add_group("body1/hydro_coeffs/mean_drift/pressure_integration");
  file.add(k_coefficients + "mean_drift/pressure_integration/val", loads,
           by_mode(database, [&](std::size_t k, std::size_t h, auto i) { return database.drift[k][h][i] / load; }));
}

}  // namespace

void write_bemio(const Database& database, const std::filesystem::path& path) {
  demand_complete(database, path);
  const Vec3 reference = database.centre_of_gravity.value_or(Vec3::Zero());
  const Database moved = about_origin(database, -reference);
  hdf5::Hdf5Writer file;
  file.add_group("bem_data");
  file.add("bem_data/code", std::string("Nilas"));
  add_parameters(file, moved);
  add_properties(file, moved, reference);
  add_coefficients(file, moved);
  file.save(path);
}

}  // namespace nilas::hydro
