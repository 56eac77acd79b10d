#include "core/field/rows.h"

#include <algorithm>
#include <cmath>

#include "core/field/spec/keep_out.h"

namespace nilas::field {

namespace {

constexpr int k_trials = 20;  ///< tries to distribute the water between rows: obstacles affect some more than others

/// `count` lengths of at least `least` that sum to `sum`; the excess is divided at random points.
std::vector<double> random_parts(std::size_t count, double least, double sum, RandomStream& random) {
  std::vector<double> parts(count);
  double all = 0;
  for (double& part : parts) all += part = -std::log(1 - random.uniform());
  const double over = sum - static_cast<double>(count) * least;
  for (double& part : parts) part = least + over * part / all;
  return parts;
}

struct Slot {
  double from, to;  ///< free interval of a row [m]
  int holds;        ///< number of floes
};
struct Row {
  double base;  ///< height of the floes' lower edges [m]
  std::vector<Slot> slots;
};

/// Lays out rows in axes along and across them. With `turned`, these are Y and -X of the ground frame.
class Rows {
 public:
  Rows(const LooseFloe& floe, const FieldBounds& bounds, double gap, bool turned, RandomStream& random)
      : gap_(gap), turned_(turned), low_(bounds.low), high_(bounds.high) {
    const std::vector<Vec2>& shape = floe.shape;
    long_ = shape[1].x() - shape[0].x();
    lean_ = shape[2].x() - shape[1].x();
    height_ = shape[2].y() - shape[1].y();
    if (turned) {
      low_ = {bounds.low.y(), -bounds.high.x()};
      high_ = {bounds.high.y(), -bounds.low.x()};
    }
    spread(bounds, random);
  }

  int capacity() const {
    int sum = 0;
    for (const Row& row : rows_)
      for (const Slot& slot : row.slots) sum += slot.holds;
    return sum;
  }

  void place(std::vector<LooseFloe>& floes, RandomStream& random) {
    leave_empty(capacity() - static_cast<int>(floes.size()), random);
    std::size_t next = 0;
    for (const Row& row : rows_)
      for (const Slot& slot : row.slots) {
        const double free = slot.to - slot.from - std::abs(lean_) - slot.holds * long_;
        const std::vector<double> water = random_parts(static_cast<std::size_t>(slot.holds) + 1, gap_, free, random);
        double x = slot.from + std::max(0.0, -lean_);
        for (int k = 0; k < slot.holds; ++k) {
          x += water[k];
          settle(floes[next++], {x + 0.5 * (long_ + lean_), row.base + 0.5 * height_});
          x += long_;
        }
      }
  }

 private:
  void spread(const FieldBounds& bounds, RandomStream& random) {
    const double width = high_.y() - low_.y();
    const auto count = static_cast<int>(std::floor((width - gap_) / (height_ + gap_)));
    if (count < 1) return;
    const auto rows = static_cast<std::size_t>(count);
    double base = low_.y();
    const std::vector<double> water = random_parts(rows + 1, gap_, width - count * height_, random);
    for (std::size_t k = 0; k < rows; ++k) {
      base += water[k];
      rows_.push_back({base, slots(base, bounds)});
      base += height_;
    }
  }

  /// The intervals of a row that the obstacles leave free.
  std::vector<Slot> slots(double base, const FieldBounds& bounds) const {
    std::vector<std::pair<double, double>> taken;
    for (const Obstacle& o : bounds.obstacles) {
      std::vector<Vec2> part = o.outline.corners;
      if (turned_)
        for (Vec2& corner : part) corner = {corner.y(), -corner.x()};
      part = cut_outline(part, Vec2::UnitY(), base + height_ + gap_);
      if (!part.empty()) part = cut_outline(part, -Vec2::UnitY(), gap_ - base);
      if (part.empty()) continue;
      const auto by_x = [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); };
      const auto [left, right] = std::minmax_element(part.begin(), part.end(), by_x);
      taken.emplace_back(left->x(), right->x());
    }
    taken.emplace_back(high_.x(), high_.x());
    std::sort(taken.begin(), taken.end());
    std::vector<Slot> found;
    double from = low_.x();
    for (const auto& [left, right] : taken) {
      const auto holds = static_cast<int>(std::floor((left - from - std::abs(lean_) - gap_) / (long_ + gap_)));
      if (holds > 0) found.push_back({from, left, holds});
      from = std::max(from, right);
    }
    return found;
  }

  void leave_empty(int places, RandomStream& random) {
    while (places > 0) {
      Row& row = rows_[static_cast<std::size_t>(random.uniform() * static_cast<double>(rows_.size()))];
      if (row.slots.empty()) continue;
      Slot& slot = row.slots[static_cast<std::size_t>(random.uniform() * static_cast<double>(row.slots.size()))];
      if (slot.holds == 0) continue;
      --slot.holds;
      --places;
    }
  }

  void settle(LooseFloe& floe, const Vec2& place) const {
    floe.centre = turned_ ? Vec2(-place.y(), place.x()) : place;
    floe.angle = turned_ ? 0.5 * k_pi : 0;
  }

  double gap_;
  bool turned_;
  Vec2 low_, high_;                          ///< corners of the region, in the rows' axes [m]
  double long_ = 0, lean_ = 0, height_ = 0;  ///< length, lean and height of a floe [m]
  std::vector<Row> rows_;
};

}  // namespace

int place_in_rows(std::vector<LooseFloe>& floes, const FieldBounds& bounds, double gap, RandomStream& random) {
  int best = 0;
  for (int k = 0; k < k_trials; ++k) {
    const bool first_turned = random.uniform() < 0.5;
    for (const bool turned : {first_turned, !first_turned}) {
      Rows rows(floes.front(), bounds, gap, turned, random);
      best = std::max(best, rows.capacity());
      if (rows.capacity() < static_cast<int>(floes.size())) continue;
      rows.place(floes, random);
      return best;
    }
  }
  return best;
}

}  // namespace nilas::field
