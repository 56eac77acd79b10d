#include "core/vessel/mooring/moordyn_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/base/error.h"

namespace nilas::vessel {

namespace {

constexpr int k_coupled_point = -1;  // Point::COUPLED of MoorDyn 2
constexpr int k_errors_only = 3;     // MOORDYN_ERR_LEVEL

[[noreturn]] void refuse_library(const std::string& name, const std::string& why) {
  throw InputError(fmt::format(
      "mooring model 'moordyn' needs the library of MoorDyn 2; {}: {}. Install it, or name its file in the environment "
      "variable NILAS_MOORDYN; allowed without it: quasi-static",
      name, why));
}

template <class Function>
void find_function(const MoordynApi& api, const char* name, Function& function) {
  void* found = dlsym(api.library.get(), name);
  if (found == nullptr) refuse_library(api.name, std::string("it has no function ") + name);
  function = reinterpret_cast<Function>(found);
}

std::vector<double> listed(const std::vector<Vec3>& places) {
  std::vector<double> all;
  for (const Vec3& p : places) all.insert(all.end(), p.begin(), p.end());
  return all;
}

}  // namespace

MoordynApi load_moordyn() {
  const char* chosen = std::getenv("NILAS_MOORDYN");
  MoordynApi api;
  api.name = chosen != nullptr ? chosen : "libmoordyn.so.2";
  void* handle = dlopen(api.name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) refuse_library(api.name, dlerror());
  api.library = std::shared_ptr<void>(handle, dlclose);
  find_function(api, "MoorDyn_Create", api.create);
  find_function(api, "MoorDyn_Close", api.close);
  find_function(api, "MoorDyn_SetVerbosity", api.set_verbosity);
  find_function(api, "MoorDyn_NCoupledDOF", api.coupled_dof);
  find_function(api, "MoorDyn_Init", api.init);
  find_function(api, "MoorDyn_Step", api.step);
  find_function(api, "MoorDyn_GetNumberPoints", api.number_of_points);
  find_function(api, "MoorDyn_GetPoint", api.point);
  find_function(api, "MoorDyn_GetPointType", api.point_type);
  find_function(api, "MoorDyn_GetPointPos", api.point_place);
  find_function(api, "MoorDyn_GetPointForce", api.point_force);
  find_function(api, "MoorDyn_GetNumberLines", api.number_of_lines);
  find_function(api, "MoorDyn_GetLine", api.line);
  find_function(api, "MoorDyn_GetLineID", api.line_id);
  find_function(api, "MoorDyn_GetLineMaxTen", api.greatest_tension);
  find_function(api, "MoorDyn_Serialize", api.serialize);
  find_function(api, "MoorDyn_Deserialize", api.deserialize);
  return api;
}

MoordynSystem::MoordynSystem(const MoordynApi& api, const std::string& file)
    : api_(api), file_(std::filesystem::absolute(file).string()), system_(api_.create(file_.c_str()), api_.close) {
  if (!system_) throw InputError(file_ + ": MoorDyn cannot read this file; its message stands above");
  api_.set_verbosity(system_.get(), k_errors_only);
  unsigned dof = 0, points = 0, lines = 0;
  api_.coupled_dof(system_.get(), &dof);
  api_.number_of_points(system_.get(), &points);
  api_.number_of_lines(system_.get(), &lines);
  for (unsigned k = 1; k <= points; ++k) {
    void* point = api_.point(system_.get(), k);
    int type = 0;
    api_.point_type(point, &type);
    if (type != k_coupled_point) continue;
    Vec3 place = Vec3::Zero();
    api_.point_place(point, place.data());
    coupled_.push_back(point);
    points_.push_back(place);
  }
  if (coupled_.empty()) throw InputError(file_ + ": found no coupled point; allowed: one or more, on the vessel");
  if (dof != 3 * coupled_.size())
    throw InputError(
        fmt::format("{}: found {} coupled degrees of freedom, but {} coupled points; allowed: coupled "
                    "points only, no bodies and rods",
                    file_, dof, coupled_.size()));
  for (unsigned k = 1; k <= lines; ++k) {
    line_handles_.push_back(api_.line(system_.get(), k));
    api_.line_id(line_handles_.back(), &ids_.emplace_back());
  }
}

std::vector<Vec3> MoordynSystem::start(const std::vector<Vec3>& places) {
  const std::vector<double> x = listed(places), v(x.size(), 0.0);
  if (api_.init(system_.get(), x.data(), v.data()) != 0)
    throw InputError(file_ + ": MoorDyn finds no rest of the lines; its message stands above");
  std::vector<Vec3> forces(coupled_.size());
  for (std::size_t k = 0; k < coupled_.size(); ++k) api_.point_force(coupled_[k], forces[k].data());
  return forces;
}

std::vector<Vec3> MoordynSystem::advance(const std::vector<Vec3>& from, const std::vector<Vec3>& to, double t,
                                         double h) {
  const std::vector<double> x = listed(from);
  std::vector<double> v = listed(to), f(x.size(), 0.0);
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = (v[k] - x[k]) / h;
  double start = t, length = h;
  const int failed = api_.step(system_.get(), x.data(), v.data(), f.data(), &start, &length);
  const std::vector<double> tensions = this->tensions();
  for (std::size_t k = 0; k < tensions.size(); ++k)
    if (!std::isfinite(tensions[k]))
      throw SimulationError(
          fmt::format("at {:.6g} s the tension of MoorDyn's line {} left finite numbers; a shorter dtM in {} may help",
                      t + h, ids_[k], file_));
  if (failed != 0) throw SimulationError(fmt::format("at {:.6g} s MoorDyn failed with the code {}", t + h, failed));
  std::vector<Vec3> forces(coupled_.size());
  for (std::size_t k = 0; k < forces.size(); ++k) {
    forces[k] = Vec3::Map(&f[3 * k]);
    if (!forces[k].allFinite())
      throw SimulationError(
          fmt::format("at {:.6g} s MoorDyn's force on coupled point {} left finite numbers", t + h, k + 1));
  }
  return forces;
}

std::vector<double> MoordynSystem::tensions() const {
  std::vector<double> all(line_handles_.size());
  for (std::size_t k = 0; k < all.size(); ++k) api_.greatest_tension(line_handles_[k], &all[k]);
  return all;
}

std::vector<std::int64_t> MoordynSystem::state() const {
  std::size_t bytes = 0;
  api_.serialize(system_.get(), &bytes, nullptr);
  std::vector<std::uint64_t> data((bytes + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
  api_.serialize(system_.get(), nullptr, data.data());
  return {data.begin(), data.end()};
}

void MoordynSystem::restore(const std::vector<std::int64_t>& state) {
  const std::vector<std::uint64_t> data(state.begin(), state.end());
  if (api_.deserialize(system_.get(), data.data()) != 0)
    throw InputError(file_ + ": MoorDyn does not take the state of the checkpoint");
}

}  // namespace nilas::vessel
