#include "core/output/tables/bodies_csv.h"

#include "core/output/file/csv_row.h"

namespace nilas::output {

BodiesCsv::BodiesCsv(const std::filesystem::path& path, std::optional<std::int64_t> keep) : file_(path, "", keep) {
  if (keep) return;
  file_.append(csv_header({"time_s", "id", "name", "x_m", "y_m", "z_m", "qw", "qx", "qy", "qz", "vx_m_s", "vy_m_s",
                           "vz_m_s", "wx_rad_s", "wy_rad_s", "wz_rad_s"}));
}

void BodiesCsv::rows(double t, const bodies::Bodies& bodies) {
  block_.clear();
  CsvRow row;
  for (std::size_t b = 0; b < bodies.id.size(); ++b) {
    const Vec3 &p = bodies.p_GB[b], &v = bodies.v_GB[b], &w = bodies.w_GB[b];
    const Quat& q = bodies.q_GB[b];
    row.clear();
    row.full(t).integer(bodies.id[b]).text(bodies.name[b]);
    for (const double x : {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), w.x(), w.y(), w.z()})
      row.full(x);
    block_ += row.line();
  }
  file_.append(block_);
}

}  // namespace nilas::output
