#include "apps/report/figures/place_load.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace nilas::report {

namespace {

using CellIndex = std::pair<std::int64_t, std::int64_t>;

std::int64_t cell_of(double at, double width) { return static_cast<std::int64_t>(std::floor(at / width)); }

/// The force of one step on each cell that it touches.
struct StepForces {
  std::map<CellIndex, double> forces;
  std::int64_t step = -1;
};

/// Places along the outline of all contacts [m].
std::vector<double> along_of(const HullContacts& contacts, const WaterlineOutline& outline) {
  std::vector<double> along;
  along.reserve(contacts.place.size());
  for (const Vec3& place : contacts.place) along.push_back(outline.along(place.head<2>()));
  return along;
}

}  // namespace

PlaceLoad place_load(const HullContacts& contacts, const WaterlineOutline& outline) {
  constexpr double k_around = 160;
  PlaceLoad load;
  load.width = outline.length() / k_around;
  const std::vector<double> along = along_of(contacts, outline);
  std::map<CellIndex, PlaceCell> cells;
  StepForces now;
  const auto close_step = [&] {
    for (const auto& [index, force] : now.forces) cells[index].peak = std::max(cells[index].peak, force);
    now.forces.clear();
  };
  for (std::size_t k = 0; k < contacts.place.size(); ++k) {
    const double force = contacts.force[k].norm(), impulse = contacts.impulse[k].norm();
    if (!(impulse > 0)) continue;
    if (contacts.step[k] != now.step) close_step();
    now.step = contacts.step[k];
    const CellIndex index{cell_of(along[k], load.width), cell_of(contacts.place[k].z(), load.width)};
    PlaceCell& cell = cells[index];
    cell.place += impulse * contacts.place[k];
    cell.impulse += impulse;
    now.forces[index] += force;
    load.impulse += impulse;
  }
  close_step();
  for (auto& [index, cell] : cells) {
    cell.place /= cell.impulse;
    cell.along = (static_cast<double>(index.first) + 0.5) * load.width;
    cell.height = (static_cast<double>(index.second) + 0.5) * load.width;
    load.cells.push_back(cell);
  }
  return load;
}

std::vector<PanelPressure> panel_pressures(const HullContacts& contacts, const WaterlineOutline& outline,
                                           double least) {
  const std::vector<double> along = along_of(contacts, outline);
  std::vector<PanelPressure> panels;
  for (double side = least; side <= 0.25 * outline.length(); side *= 2) {
    PanelPressure worst{.area = side * side};
    for (const auto& [right, up] : {std::pair{0.0, 0.0}, {0.5, 0.0}, {0.0, 0.5}, {0.5, 0.5}}) {
      StepForces now;
      double time = 0;
      const auto close_step = [&] {
        for (const auto& [index, force] : now.forces)
          if (force / worst.area > worst.pressure) {
            worst.pressure = force / worst.area;
            worst.time = time;
          }
        now.forces.clear();
      };
      for (std::size_t k = 0; k < contacts.place.size(); ++k) {
        const double normal = contacts.force[k].dot(contacts.normal[k]);
        if (!(normal > 0)) continue;
        if (contacts.step[k] != now.step) close_step();
        now.step = contacts.step[k];
        time = contacts.time[k];
        now.forces[{cell_of(along[k] + right * side, side), cell_of(contacts.place[k].z() + up * side, side)}] +=
            normal;
      }
      close_step();
    }
    if (worst.pressure > 0) panels.push_back(worst);
  }
  return panels;
}

}  // namespace nilas::report
