#include "tests/bench/moving_field.h"

#include <cmath>
#include <numeric>
#include <string>

#include "core/base/math.h"

namespace nilas::bench {

namespace {

constexpr double k_size = 0.5, k_thickness = 0.05, k_jitter = 0.2;  // [m], [m], of a cell
constexpr double k_shrink = 0.985;                                  // The shrinkage leaves 7 mm between neighbours.
constexpr double k_swing = 0.004, k_turn = 0.006, k_rate = 8;       // [m], [rad], [rad/s]
const Vec3 k_drift(0.1, 0.02, 0);                                   // [m/s]

}  // namespace

MovingField::MovingField(int floes) {
  RandomStream random(5, "moving field");
  const int rows = static_cast<int>(std::lround(std::sqrt(floes)));
  columns_ = (floes + rows - 1) / rows;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns_; ++i)
      corners_.emplace_back(k_size * (i + k_jitter * random.uniform(-1, 1)),
                            k_size * (j + k_jitter * random.uniform(-1, 1)));
  for (int k = 0; k < floes; ++k) add_floe(cell(k % columns_, k / columns_, random), random);
  concentration_ /= floes * k_size * k_size;
  move_to(0);
}

std::vector<Vec2> MovingField::cell(int i, int j, RandomStream& random) const {
  const auto corner = [&](int column, int row) { return corners_[row * (columns_ + 1) + column]; };
  const std::vector<Vec2> quad{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
  std::vector<Vec2> outline;
  for (std::size_t k = 0; k < quad.size(); ++k) {
    if (random.uniform() < 0.5) {
      outline.push_back(quad[k]);
      continue;
    }
    constexpr double k_cut = 0.12;
    outline.push_back(quad[k] + k_cut * (quad[(k + 3) % quad.size()] - quad[k]));
    outline.push_back(quad[k] + k_cut * (quad[(k + 1) % quad.size()] - quad[k]));
  }
  return outline;
}

void MovingField::add_floe(std::vector<Vec2> outline, RandomStream& random) {
  const geometry::PolygonMoments moments = geometry::polygon_moments(outline);
  for (Vec2& x : outline) x = k_shrink * (x - moments.centroid);
  concentration_ += k_shrink * k_shrink * moments.area;
  bodies::BodySpec spec;
  spec.name = "floe" + std::to_string(bodies_.size());
  spec.kind = bodies::BodyKind::floe;
  spec.material = "ice";
  spec.shape = std::make_shared<const geometry::Shape>(geometry::prism_shape(outline, k_thickness));
  spec.mass = 920 * k_thickness * moments.area;
  bodies_.add(spec);
  Path path;
  path.place = Vec3(moments.centroid.x(), moments.centroid.y(), 0);
  path.swing = k_swing * Vec3(random.normal(), random.normal(), 0.3 * random.normal());
  path.turn = k_turn * Vec3(random.normal(), random.normal(), random.normal());
  path.rate = k_rate * random.uniform(0.5, 1.5);
  path.phase = random.uniform(0, 2 * k_pi);
  paths_.push_back(path);
}

void MovingField::move_to(double t) {
  for (int b = 0; b < bodies_.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    const Path& path = paths_[i];
    const double angle = path.rate * t + path.phase;
    const Vec3 turn = std::sin(angle) * path.turn;
    bodies_.set_pose(b, path.place + t * k_drift + std::sin(angle) * path.swing,
                     Quat(Eigen::AngleAxisd(turn.norm(), turn.norm() > 0 ? Vec3(turn.normalized()) : Vec3::UnitZ())));
    bodies_.v_GB[i] = k_drift + path.rate * std::cos(angle) * path.swing;
    bodies_.w_GB[i] = path.rate * std::cos(angle) * path.turn;
  }
}

}  // namespace nilas::bench
