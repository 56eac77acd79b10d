#include "apps/verify/trial.h"

#include <algorithm>

#include "core/base/error.h"

namespace nilas::verify {

Trial::Trial(const scene::Scene& scene, int threads)
    : warnings_(std::make_unique<WarningCounts>(make_logger("off", ""))),
      simulation_(std::make_unique<sim::Simulation>(scene, threads, *warnings_)),
      h_(scene.time.step),
      initial_(simulation_->initial_ledger()) {}

const sim::StepRecord& Trial::step() { return last_ = simulation_->step(); }

void Trial::run(long steps) {
  for (long k = 0; k < steps; ++k) step();
}

BodyState Trial::body(const std::string& name) const {
  const bodies::Bodies& bodies = simulation_->bodies();
  const auto found = std::find(bodies.name.begin(), bodies.name.end(), name);
  NILAS_DEMAND(found != bodies.name.end());
  const auto b = static_cast<std::size_t>(found - bodies.name.begin());
  return {bodies.p_GB[b], bodies.v_GB[b], bodies.w_GB[b],
          bodies.q_GB[b], bodies.mass[b], bodies.inertia_G(static_cast<int>(b))};
}

std::vector<Touch> Trial::touches() const {
  const bodies::Bodies& bodies = simulation_->bodies();
  const contact::SolvedProblem& solved = simulation_->last_problem();
  std::vector<Touch> all;
  for (std::size_t i = 0; i < solved.points.size(); ++i) {
    const detect::ContactPoint& c = solved.points[i];
    all.push_back({bodies.name[c.a], bodies.name[c.b], c.p, c.n, c.gap, solved.impulses[i] / h_});
  }
  return all;
}

Vec3 Trial::contact_force_on(const std::string& name) const {
  Vec3 sum = Vec3::Zero();
  for (const auto& touch : touches()) {
    if (touch.b == name) sum += touch.force;
    if (touch.a == name) sum -= touch.force;
  }
  return sum;
}

Vec3 Trial::force_between(const std::string& by, const std::string& on) const {
  Vec3 sum = Vec3::Zero();
  for (const auto& touch : touches()) {
    if (touch.a == by && touch.b == on) sum += touch.force;
    if (touch.b == by && touch.a == on) sum -= touch.force;
  }
  return sum;
}

}  // namespace nilas::verify
