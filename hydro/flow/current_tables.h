#pragma once
/// Currents that vary over depth or over time. They add to the uniform current and to each other.
#include <string>
#include <vector>

#include "core/base/math.h"
#include "hydro/flow/flow.h"

namespace nilas::hydro {

/// Horizontal velocities over one coordinate: linear between its points, constant beyond them.
class VelocityTable {
 public:
  /// `x` grows from point to point and is not empty; one value [m/s] belongs to each.
  VelocityTable(std::vector<double> x, std::vector<Vec2> values);
  Vec2 at(double x) const;
  /// The value of greatest magnitude; the first of them where several have it.
  Vec2 greatest() const;
  double first() const { return x_.front(); }
  double last() const { return x_.back(); }

 private:
  std::vector<double> x_;
  std::vector<Vec2> values_;
};

/// Reads the current over depth from a CSV file with the columns z_m,u_m_s,v_m_s: the height above still water, which
/// is negative below, and the velocity along X and Y of G. Heights grow, or fall, from row to row. Heights are
/// multiplied by `scale` and velocities by its root, as Froude's law has it. Throws FileError where the file cannot be
/// read, and InputError with file and line for a wrong table.
VelocityTable read_current_profile(const std::string& csv_file, double scale = 1);

/// Reads the current over time from a CSV file with the columns t_s,u_m_s,v_m_s. Times grow from row to row. Times and
/// velocities are multiplied by the root of `scale`. Throws as read_current_profile().
VelocityTable read_current_series(const std::string& csv_file, double scale = 1);

/// The current that varies over depth.
class CurrentProfile : public Flow {
 public:
  /// `level` is z of still water [m].
  CurrentProfile(VelocityTable table, double level) : table_(std::move(table)), level_(level) {}
  Vec3 velocity(const Vec3& p_G, double /*t*/) const override {
    const Vec2 u = table_.at(p_G.z() - level_);
    return {u.x(), u.y(), 0};
  }

 private:
  VelocityTable table_;
  double level_;
};

/// The current that varies over time, the same everywhere. Before the first time and after the last it stays as it is
/// there.
class CurrentSeries : public Flow {
 public:
  explicit CurrentSeries(VelocityTable table) : table_(std::move(table)) {}
  Vec3 velocity(const Vec3& /*p_G*/, double t) const override {
    const Vec2 u = table_.at(t);
    return {u.x(), u.y(), 0};
  }

 private:
  VelocityTable table_;
};

}  // namespace nilas::hydro
