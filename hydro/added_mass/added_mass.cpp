#include "hydro/added_mass/added_mass.h"

#include <utility>

#include "hydro/added_mass/floe_added_mass.h"

namespace nilas::hydro {

namespace {

class AddedMass : public bodies::Module {
 public:
  AddedMass(FloeAddedMass floes, double density, std::optional<Mat6> vessel)
      : floes_(floes), density_(density), vessel_(std::move(vessel)) {}
  std::string name() const override { return "added_mass"; }
  bool exerts_loads() const override { return vessel_.has_value(); }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::water; }
  std::optional<Mat6> vessel_added_mass() const override { return vessel_; }
  bodies::AddedMassOf added_mass_of_bodies() const override {
    if (floes_ == FloeAddedMass::none) return {};
    return [floes = floes_, density = density_](bodies::BodyKind kind, const geometry::Shape& shape, double mass) {
      if (kind != bodies::BodyKind::floe) return Mat6(Mat6::Zero());
      double area = 0;
      for (std::size_t k = 0; k < shape.outline.size(); ++k) {
        const Vec2 &a = shape.outline[k], &b = shape.outline[(k + 1) % shape.outline.size()];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
      }
      return floe_added_mass(floes, shape, mass / (density * area), density);
    };
  }

 private:
  FloeAddedMass floes_;
  double density_;
  std::optional<Mat6> vessel_;
};

}  // namespace

Mat6 about_other_point(const Mat6& matrix, const Vec3& arm) {
  Mat3 cross;
  cross << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
  Mat6 to_old = Mat6::Identity();
  to_old.topRightCorner<3, 3>() = -cross;
  const Mat6 moved = to_old.transpose() * matrix * to_old;
  return 0.5 * (moved + moved.transpose());
}

std::unique_ptr<bodies::Module> make_added_mass(FloeAddedMass floes, double density, std::optional<Mat6> vessel) {
  return std::make_unique<AddedMass>(floes, density, std::move(vessel));
}

}  // namespace nilas::hydro
