#include "tests/core/output/push_example.h"

namespace nilas::output {

namespace {

class Push : public bodies::ForceModule {
 public:
  Push(const Vec3& force, int steps) : force_(force), steps_left_(steps) {}
  std::string name() const override { return "push"; }
  /// It sets bodies in motion, but at no one velocity.
  std::optional<Vec3> drift() const override { return Vec3::Zero(); }

  void add_forces(const bodies::Bodies& bodies, double /*t*/, bodies::Wrenches& out) override {
    if (!acts_) return;
    for (int b = 0; b < bodies.size(); ++b)
      if (bodies.is_free(b)) out[b].force += force_;
  }

  void begin_step() override {
    acts_ = steps_left_ > 0;
    if (acts_) --steps_left_;
  }

  std::vector<std::string> columns() const override { return {"push_steps_left_1"}; }
  void append_values(std::vector<double>& values) const override { values.push_back(steps_left_); }
  std::optional<double> total(std::string_view name) const override {
    if (name == "push_steps_left") return steps_left_;
    return std::nullopt;
  }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override { out.add("steps_left", steps_left_); }
  void restore(const StateReader& in) override { in.get("steps_left", steps_left_); }

 private:
  Vec3 force_;  ///< [N]
  int steps_left_;
  bool acts_ = false;  ///< in this step
};

}  // namespace

std::unique_ptr<bodies::ForceModule> make_push(const Vec3& force, int steps) {
  return std::make_unique<Push>(force, steps);
}

}  // namespace nilas::output
