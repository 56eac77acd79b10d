#include "apps/report/contact_windows.h"

#include <fmt/format.h>

#include <algorithm>

#include "contact/hdf5_columns.h"
#include "core/base/error.h"

namespace nilas {

namespace {

/// Rows of complete steps.
struct ContactColumns {
  std::vector<double> time, x, y, z, z_G, fx, fy, fz;
  std::vector<std::int64_t> body;
  long steps = 0;
};

ContactColumns read_contacts(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  if (!file.has("contacts/hull_x_m") || !file.has("steps"))
    throw InputError(path.string() + ": holds no contacts of a hull");
  const auto index = whole_blocks(file.wide_integers("steps"));
  const std::size_t rows = index.empty() ? 0 : static_cast<std::size_t>(index.back());
  const auto numbers = [&](const std::string& name) { return file.first_numbers("contacts/" + name, rows); };
  ContactColumns c{numbers("time_s"),
                   numbers("hull_x_m"),
                   numbers("hull_y_m"),
                   numbers("hull_z_m"),
                   numbers("z_m"),
                   numbers("fx_N"),
                   numbers("fy_N"),
                   numbers("fz_N"),
                   {},
                   static_cast<long>(index.size() / 2)};
  c.body = file.first_integers("contacts/body", rows);
  return c;
}

ContactWindow window_of(const ContactColumns& c, std::int64_t vessel_id, const TimeScene& run, double t,
                        double half_width) {
  const double low = t - half_width - 0.5 * run.step, high = t + half_width + 0.5 * run.step;
  ContactWindow window{.t = t, .half_width = half_width, .steps = 0, .marks = {}};
  for (long k = 1; k <= c.steps; ++k) {
    const double at = run.start + static_cast<double>(k) * run.step;
    if (at > low && at < high) ++window.steps;
  }
  if (window.steps == 0)
    throw InputError(fmt::format("no step lies within {:g} s of {:g} s; the run has {:g} to {:g} s", half_width, t,
                                 run.start, run.start + static_cast<double>(c.steps) * run.step));
  long rows = 0;
  for (std::size_t i = 0; i < c.time.size(); ++i) {
    if (c.time[i] < low || c.time[i] > high || c.body[i] != vessel_id) continue;
    ++rows;
    window.floating_level += c.z_G[i] - c.z[i];
    const Vec3 force(c.fx[i], c.fy[i], c.fz[i]);
    window.mean_force += force;
    if (!force.isZero(0)) window.marks.push_back({{c.x[i], c.y[i], c.z[i]}, force});
  }
  if (rows > 0) window.floating_level /= static_cast<double>(rows);
  window.mean_force /= static_cast<double>(window.steps);
  std::stable_sort(window.marks.begin(), window.marks.end(), [](const ContactMark& a, const ContactMark& b) {
    return a.force.squaredNorm() < b.force.squaredNorm();
  });
  return window;
}

}  // namespace

std::vector<ContactWindow> contact_windows(const std::filesystem::path& file, std::int64_t vessel_id,
                                           const TimeScene& run, const std::vector<double>& times, double half_width) {
  const ContactColumns columns = read_contacts(file);
  std::vector<ContactWindow> windows;
  for (const double t : times) windows.push_back(window_of(columns, vessel_id, run, t, half_width));
  return windows;
}

}  // namespace nilas
