#include <fmt/format.h>

#include <cmath>

#include "hydro/restoring/restoring.h"

namespace nilas::hydro {

namespace {

class TiltWatch : public bodies::Module {
 public:
  TiltWatch(int hull, WarningCounts& warnings) : hull_(static_cast<std::size_t>(hull)), warnings_(&warnings) {}
  std::string name() const override { return "database_tilt"; }

  void end_substep(const bodies::Bodies& bodies, double t, double /*h*/) override {
    if (told_) return;
    const Mat3& R = bodies.R_GB[hull_];
    const double tilt = std::atan2(std::hypot(R(0, 2), R(1, 2)), R(2, 2));
    if (!(tilt > k_small_tilt)) return;
    told_ = true;
    warnings_->warn("tilt beyond the database",
                    fmt::format("at {:g} s '{}' leans over by {:.3g} deg; the loads of its database are those of small "
                                "angles, up to about {:g} deg",
                                t, bodies.name[hull_], tilt / k_deg, k_small_tilt / k_deg));
  }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override {
    out.add("told", static_cast<int>(told_));
  }
  void restore(const StateReader& in) override {
    int told = 0;
    in.get("told", told);
    told_ = told != 0;
  }

 private:
  std::size_t hull_;
  WarningCounts* warnings_;
  bool told_ = false;
};

}  // namespace

std::unique_ptr<bodies::Module> make_tilt_watch(int hull, WarningCounts& warnings) {
  return std::make_unique<TiltWatch>(hull, warnings);
}

}  // namespace nilas::hydro
