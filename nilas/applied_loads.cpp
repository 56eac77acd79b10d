#include "nilas/applied_loads.h"

#include <algorithm>
#include <utility>

namespace nilas::library {

namespace {

class AppliedLoads : public bodies::ForceModule {
 public:
  explicit AppliedLoads(std::shared_ptr<WaitingLoads> waiting) : waiting_(std::move(waiting)) {}
  std::string name() const override { return "applied"; }

  void add_forces(const bodies::Bodies& bodies, double, bodies::Wrenches& out) override {
    for (const AppliedLoad& load : *waiting_) {
      // ids grow with the index
      const auto found = std::lower_bound(bodies.id.begin(), bodies.id.end(), load.body);
      if (found == bodies.id.end() || *found != load.body) continue;
      const auto b = static_cast<std::size_t>(found - bodies.id.begin());
      out[b] += Wrench{load.force, load.torque + load.arm.cross(load.force)};
    }
  }

 private:
  std::shared_ptr<WaitingLoads> waiting_;
};

}  // namespace

std::unique_ptr<bodies::Module> make_applied_loads(std::shared_ptr<WaitingLoads> waiting) {
  return std::make_unique<AppliedLoads>(std::move(waiting));
}

}  // namespace nilas::library
