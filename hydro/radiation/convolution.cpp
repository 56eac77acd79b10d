#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "hydro/radiation/memory_force.h"

namespace nilas::hydro {

namespace {

class Convolution : public MemoryForce {
 public:
  explicit Convolution(const Retardation& kernel)
      : step_(kernel.step), memory_(kernel.memory), K1_(kernel.K1), K2_(kernel.K2) {}

  bool started() const override { return !time_.empty(); }

  Vec6 load(double t, const Vec6& V) const override {
    NILAS_DEMAND(started() && t >= time_.back());
    Vec6 sum = Vec6::Zero();
    Mat6 newer = Mat6::Zero();
    Vec6 newer_velocity = V;
    double newer_age = 0;
    // From the newest interval to the oldest within the memory.
    for (std::size_t k = time_.size(); k-- > 0 && newer_age < memory_;) {
      const double age = t - time_[k];
      if (!(age > newer_age)) {
        newer_velocity = velocity_[k];
        continue;
      }
      const double reach = std::min(age, memory_);
      const Mat6 older = K2(reach);
      sum += (older - newer) * ((newer_velocity - velocity_[k]) / (age - newer_age));
      newer = older;
      newer_velocity = velocity_[k];
      newer_age = age;
    }
    return -sum;
  }

  void advance(double t, const Vec6& V) override {
    NILAS_DEMAND(!started() || t > time_.back());
    time_.push_back(t);
    velocity_.push_back(V);
    // One time beyond the memory is kept: the interval that it begins reaches into the memory. Old times are taken away
    // in bunches, so that the work per step stays bounded.
    const auto first = std::upper_bound(time_.begin(), time_.end(), t - memory_);
    const auto old = std::max<std::ptrdiff_t>(first - time_.begin() - 1, 0);
    if (2 * old < static_cast<std::ptrdiff_t>(time_.size())) return;
    time_.erase(time_.begin(), time_.begin() + old);
    velocity_.erase(velocity_.begin(), velocity_.begin() + old);
  }

  void save(StateWriter out) const override {
    out.add("time", time_);
    out.add("velocity", velocity_);
  }
  void restore(const StateReader& in) override {
    in.get("time", time_);
    in.get("velocity", velocity_, time_.size());
  }

 private:
  /// int_0^s int_0^r K, cubic between knots with the slopes K1.
  Mat6 K2(double s) const {
    const auto k = std::min(static_cast<std::size_t>(s / step_), K2_.size() - 2);
    const double u = s / step_ - static_cast<double>(k);
    // The rest of a cubic beyond the chord, from the slopes at both ends.
    const Mat6 chord = K2_[k + 1] - K2_[k];
    const Mat6 start = step_ * K1_[k] - chord, end = chord - step_ * K1_[k + 1];
    return K2_[k] + u * chord + u * (1 - u) * ((1 - u) * start + u * end);
  }

  double step_, memory_;
  std::vector<Mat6> K1_, K2_;
  std::vector<double> time_;
  std::vector<Vec6> velocity_;
};

}  // namespace

std::unique_ptr<MemoryForce> make_convolution(const Retardation& kernel) {
  return std::make_unique<Convolution>(kernel);
}

}  // namespace nilas::hydro
