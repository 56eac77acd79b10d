#include <array>
#include <utility>

#include "core/base/error.h"
#include "hydro/radiation/memory_force.h"

namespace nilas::hydro {

namespace {

/// Weights of a step of one pole: of the state, of the first velocity and of the last.
struct PoleStep {
  std::complex<double> state, first, last;
};

PoleStep pole_step(std::complex<double> p, double h) {
  // Below |z| = 1 the differences lose digits, and the series of f2 with 20 terms is exact to rounding.
  constexpr int k_terms = 20;
  const std::complex<double> z = p * h, growth = std::exp(z);
  std::complex<double> f1, f2;
  if (std::abs(z) > 1) {
    f1 = (growth - 1.0) / z;
    f2 = (f1 - 1.0) / z;
  } else {
    std::complex<double> term = 0.5;
    for (int n = 0; n < k_terms; ++n) {
      f2 += term;
      term *= z / static_cast<double>(n + 2 + 1);
    }
    f1 = 1.0 + z * f2;
  }
  return {growth, h * (f1 - f2), h * f2};
}

class StateSpace : public MemoryForce {
 public:
  StateSpace(const std::vector<PassiveFit>& fits, const Vec6& scale) {
    for (const PassiveFit& fit : fits) {
      const Poles& poles = fit.model.poles;
      std::vector<std::complex<double>> all(poles.real.begin(), poles.real.end());
      all.insert(all.end(), poles.pair.begin(), poles.pair.end());
      for (std::size_t k = 0; k < all.size(); ++k)
        poles_.push_back({all[k], residue(fit.model, k, scale), fit.model.modes});
    }
    real_.resize(poles_.size());
    imaginary_.resize(poles_.size());
  }

  bool started() const override { return started_; }

  Vec6 load(double t, const Vec6& V) const override {
    NILAS_DEMAND(started_ && t >= time_);
    Vec6 sum = Vec6::Zero();
    for (std::size_t k = 0; k < poles_.size(); ++k) {
      Vec6 x = real_[k], y = imaginary_[k];
      if (t > time_) go_on(pole_step(poles_[k].p, t - time_), V, V, x, y);
      for (std::size_t i = 0; i < poles_[k].modes.size(); ++i)
        for (std::size_t j = 0; j < poles_[k].modes.size(); ++j) {
          const std::complex<double> r = poles_[k].residue(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
          const int from = poles_[k].modes[j];
          sum[poles_[k].modes[i]] -= r.real() * x[from] - r.imag() * y[from];
        }
    }
    return sum;
  }

  void advance(double t, const Vec6& V) override {
    NILAS_DEMAND(!started_ || t > time_);
    if (started_ && t - time_ != cached_h_) {
      cached_h_ = t - time_;
      cached_.clear();
      for (const Pole& pole : poles_) cached_.push_back(pole_step(pole.p, cached_h_));
    }
    for (std::size_t k = 0; k < poles_.size(); ++k) {
      if (started_) {
        go_on(cached_[k], velocity_, V, real_[k], imaginary_[k]);
      } else {
        // Steady motion before the start: p x + V = 0.
        const std::complex<double> rest = -1.0 / poles_[k].p;
        real_[k] = rest.real() * V;
        imaginary_[k] = rest.imag() * V;
      }
    }
    started_ = true;
    time_ = t;
    velocity_ = V;
  }

  void save(StateWriter out) const override {
    out.add("started", static_cast<int>(started_));
    out.add("time", time_);
    out.add("velocity", velocity_);
    out.add("real", real_);
    out.add("imaginary", imaginary_);
  }
  void restore(const StateReader& in) override {
    int started = 0;
    in.get("started", started);
    started_ = started != 0;
    in.get("time", time_);
    in.get("velocity", velocity_);
    in.get("real", real_, poles_.size());
    in.get("imaginary", imaginary_, poles_.size());
  }

 private:
  struct Pole {
    std::complex<double> p;
    MatXc residue;  ///< in physical units; of an upper pole twice that of the model
    std::vector<int> modes;
  };

  static MatXc residue(const RationalModel& model, std::size_t k, const Vec6& scale) {
    MatXc out = model.residues[k];
    for (Eigen::Index i = 0; i < out.rows(); ++i)
      for (Eigen::Index j = 0; j < out.cols(); ++j) out(i, j) *= scale[model.modes[i]] * scale[model.modes[j]];
    // An upper pole stands for its conjugate too.
    return k < model.poles.real.size() ? out : MatXc(2.0 * out);
  }

  static void go_on(const PoleStep& step, const Vec6& first, const Vec6& last, Vec6& x, Vec6& y) {
    const Vec6 real =
        step.state.real() * x - step.state.imag() * y + step.first.real() * first + step.last.real() * last;
    y = step.state.real() * y + step.state.imag() * x + step.first.imag() * first + step.last.imag() * last;
    x = real;
  }

  std::vector<Pole> poles_;
  bool started_ = false;
  double time_ = 0;
  Vec6 velocity_ = Vec6::Zero();
  std::vector<Vec6> real_, imaginary_;  ///< the states of each pole, of all modes
  double cached_h_ = -1;
  std::vector<PoleStep> cached_;
};

}  // namespace

std::unique_ptr<MemoryForce> make_state_space(const std::vector<PassiveFit>& fits, const Vec6& scale) {
  return std::make_unique<StateSpace>(fits, scale);
}

}  // namespace nilas::hydro
