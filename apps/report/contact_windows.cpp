#include "apps/report/contact_windows.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/hdf5/hdf5_columns.h"

namespace nilas::report {

namespace {

/// The contact rows of the steps that were written completely.
struct ContactColumns {
  std::vector<double> time, x, y, z, z_G, nx, ny, nz, fx, fy, fz;  ///< x, y, z in the frame of the drawing [m]
  std::vector<std::int64_t> body;
  long steps = 0;
};

ContactColumns read_contacts(const std::filesystem::path& path, bool of_vessel) {
  const hdf5::Hdf5Reader file(path);
  if (!file.has(of_vessel ? "contacts/hull_x_m" : "contacts/x_m") || !file.has("steps"))
    throw InputError(path.string() + ": the file holds no contacts of " + (of_vessel ? "a hull" : "bodies"));
  const auto index = hdf5::whole_blocks(file.wide_integers("steps"));
  const std::size_t rows = index.empty() ? 0 : static_cast<std::size_t>(index.back());
  const auto numbers = [&](const std::string& name) { return file.first_numbers("contacts/" + name, rows); };
  const std::string frame = of_vessel ? "hull_" : "";
  ContactColumns c;
  c.time = numbers("time_s");
  c.x = numbers(frame + "x_m");
  c.y = numbers(frame + "y_m");
  c.z = numbers(frame + "z_m");
  c.z_G = numbers("z_m");
  c.nx = numbers("nx");
  c.ny = numbers("ny");
  c.nz = numbers("nz");
  c.fx = numbers("fx_N");
  c.fy = numbers("fy_N");
  c.fz = numbers("fz_N");
  c.steps = static_cast<long>(index.size() / 2);
  c.body = file.first_integers("contacts/body", rows);
  return c;
}

ContactWindow window_of(const ContactColumns& c, const DrawnBodies& drawn, const scene::TimeScene& run, double t,
                        double half_width) {
  const auto is_drawn = [&](std::int64_t id) {
    return std::find(drawn.ids.begin(), drawn.ids.end(), id) != drawn.ids.end();
  };
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
    if (c.time[i] < low || c.time[i] > high || !is_drawn(c.body[i])) continue;
    ++rows;
    window.floating_level += c.z_G[i] - c.z[i];
    const Vec3 force(c.fx[i], c.fy[i], c.fz[i]);
    window.mean_force += force;
    if (force.isZero(0)) continue;
    const Vec3 p(c.x[i], c.y[i], c.z[i]), outward(-c.nx[i], -c.ny[i], -c.nz[i]);
    // normals are stored in G and a hull turns, so its side follows from the place: the centre plane is y = 0
    window.marks.push_back({p, drawn.is_vessel ? p : outward, force});
  }
  if (rows > 0) window.floating_level /= static_cast<double>(rows);
  window.mean_force /= static_cast<double>(window.steps);
  std::stable_sort(window.marks.begin(), window.marks.end(), [](const ContactMark& a, const ContactMark& b) {
    return a.force.squaredNorm() < b.force.squaredNorm();
  });
  return window;
}

}  // namespace

std::vector<ContactWindow> contact_windows(const std::filesystem::path& file, const DrawnBodies& drawn,
                                           const scene::TimeScene& run, const std::vector<double>& times,
                                           double half_width) {
  const ContactColumns columns = read_contacts(file, drawn.is_vessel);
  std::vector<ContactWindow> windows;
  for (const double t : times) windows.push_back(window_of(columns, drawn, run, t, half_width));
  return windows;
}

}  // namespace nilas::report
