#include "fracture/model/ice_modules.h"

#include <algorithm>

#include "fracture/model/broken_contacts.h"
#include "fracture/model/floe_pieces.h"
#include "fracture/model/step_end.h"

namespace nilas::fracture {

namespace {

class CrushingModule : public bodies::Module {
 public:
  CrushingModule(const CrushingSettings& settings, const bodies::Bodies& bodies, const bodies::IceProperties& ice,
                 WarningCounts& warnings)
      : crushing_(settings, bodies, ice), warnings_(warnings) {}

  std::string name() const override { return "crushing"; }
  bool owns_pairs() const override { return true; }
  bool owns_pair(int a, int b) const override { return crushing_.crushes(a, b); }
  void add_contacts(const bodies::Bodies& bodies, const bodies::BodyPairs& near, const bodies::SubstepLength& length,
                    std::vector<detect::ContactPoint>& points) override {
    const std::vector<detect::ContactPoint> found = crushing_.points(bodies, near, length.h, length.ahead);
    points.insert(points.end(), found.begin(), found.end());
  }
  void remember() override { memory_ = crushing_.memory(); }
  void go_back() override { crushing_.set_memory(memory_); }
  void begin_step() override { deepest_ = 0; }
  void note_motion(const bodies::Bodies& bodies, const contact::StepMotion& motion) override {
    crushing_.note_crushed(bodies, motion);
    deepest_ = std::max(deepest_, crushing_.deepest_overlap(bodies));
  }
  void end_step(StepEnd& end) override {
    for (FloeBreak& floe : crushing_.floes_to_clear(end.bodies, warnings_))
      end.failures[floe.floe].push_back(std::move(floe.ways.front()));
  }
  void follow(const bodies::Bodies& bodies, const std::vector<NewPiece>& pieces) override {
    crushing_.follow(bodies, pieces);
  }
  std::vector<std::string> columns() const override { return {"crushed_overlap_max_m"}; }
  void append_values(std::vector<double>& values) const override { values.push_back(deepest_); }
  std::optional<double> total(std::string_view name) const override {
    if (name == bodies::k_crushed_mass) return crushing_.crushed_mass();
    return std::nullopt;
  }
  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override { crushing_.save(out); }
  void restore(const StateReader& in) override { crushing_.restore(in); }

 private:
  Crushing crushing_;
  WarningCounts& warnings_;
  Crushing::Memory memory_;
  double deepest_ = 0;  ///< Largest overlap of the step [m].
};

class BreakingModule : public bodies::Module {
 public:
  BreakingModule(const BreakingSettings& settings, const bodies::IceProperties& ice) : breaking_(settings), ice_(ice) {}

  std::string name() const override { return "breaking"; }
  void note_motion(const bodies::Bodies& bodies, const contact::StepMotion& motion) override {
    breaking_.note_loads(bodies, ice_, motion);
  }
  void end_step(StepEnd& end) override {
    for (FloeBreak& floe : breaking_.take_breaks(end.bodies, ice_, end.step)) {
      std::vector<Failure>& ways = end.failures[floe.floe];
      ways.insert(ways.begin(), std::make_move_iterator(floe.ways.begin()), std::make_move_iterator(floe.ways.end()));
    }
  }
  void follow(const bodies::Bodies& bodies, const std::vector<NewPiece>& pieces) override {
    breaking_.follow(bodies, pieces);
  }
  std::optional<double> of_body(std::string_view name, std::int64_t id) const override {
    if (name == bodies::k_damage) return breaking_.damage(id);
    return std::nullopt;
  }
  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override { breaking_.save(out); }
  void restore(const StateReader& in) override { breaking_.restore(in); }

 private:
  Breaking breaking_;
  const bodies::IceProperties& ice_;
};

/// Cuts the floes that fail. A floe may both break and have crushed ice to be cut out. The break is then tried first,
/// and the ice is cut out only where it fails.
class PiecesModule : public bodies::Module {
 public:
  PiecesModule(const PieceLimits& limits, bodies::IceProperties& ice, WarningCounts& warnings)
      : pieces_(limits), ice_(ice), warnings_(warnings) {}

  std::string name() const override { return "pieces"; }
  void add_to_guess(const bodies::Bodies& bodies, const std::vector<detect::ContactPoint>& points,
                    const std::vector<Mat3>& frames, VecX& guess) override {
    broken_contacts_.add_to(bodies, points, frames, guess);
  }
  void end_guess() override { broken_contacts_.forget(); }
  void end_step(StepEnd& end) override {
    for (auto& [floe, ways] : end.failures) {
      FractureEvent event = pieces_.put({floe, std::move(ways)}, end.bodies, ice_, warnings_, end.pieces);
      if (event.kind.empty()) continue;
      event.t = end.t;
      event.energy = end.book_break();
      end.broken.push_back(std::move(event));
    }
    end.failures.clear();
    if (!end.broken.empty()) broken_contacts_.note(end.last, end.broken);
  }
  std::optional<double> total(std::string_view name) const override {
    if (name == bodies::k_brash_mass) return pieces_.brash_mass();
    if (name == bodies::k_extruded_mass) return pieces_.extruded_mass();
    return std::nullopt;
  }
  void save(const bodies::Bodies& bodies, StateWriter out) const override {
    pieces_.save(bodies, out);
    broken_contacts_.save(out.group("contacts"));
  }
  void restore_bodies(const StateReader& in, bodies::Bodies& bodies) override { pieces_.restore(in, bodies, ice_); }
  void restore(const StateReader& in) override { broken_contacts_.restore(in.group("contacts")); }

 private:
  FloePieces pieces_;
  bodies::IceProperties& ice_;
  WarningCounts& warnings_;
  BrokenContacts broken_contacts_;  ///< Impulses of the last step, until the next are solved.
};

}  // namespace

std::unique_ptr<bodies::Module> make_crushing(const CrushingSettings& settings, const bodies::Bodies& bodies,
                                              const bodies::IceProperties& ice, WarningCounts& warnings) {
  return std::make_unique<CrushingModule>(settings, bodies, ice, warnings);
}

std::unique_ptr<bodies::Module> make_breaking(const BreakingSettings& settings, const bodies::IceProperties& ice) {
  return std::make_unique<BreakingModule>(settings, ice);
}

std::unique_ptr<bodies::Module> make_pieces(const PieceLimits& limits, bodies::IceProperties& ice,
                                            WarningCounts& warnings) {
  return std::make_unique<PiecesModule>(limits, ice, warnings);
}

}  // namespace nilas::fracture
