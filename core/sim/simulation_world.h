#pragma once
/// What a simulation holds and the parts that its step is put together from; for core/sim/simulation*.cpp alone.
#include <optional>
#include <vector>

#include "contact/assemble.h"
#include "contact/detect/detector.h"
#include "core/sim/account/ledger.h"
#include "core/sim/account/stopwatch.h"
#include "core/sim/reference/reference.h"
#include "core/sim/simulation.h"
#include "core/sim/step/warm_start.h"
#include "core/sim/world/contact_model.h"
#include "core/sim/world/world.h"
#include "fracture/model/breaking.h"
#include "fracture/model/broken_contacts.h"
#include "fracture/model/crushing.h"

namespace nilas {

/// A vessel on a carriage at the step's start: its momenta balance from there, not from where the contacts are found.
struct VesselStart {
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();  ///< [m/s, rad/s]
  Mat3 inertia = Mat3::Zero();              ///< in G [kg m^2]
};

/// Bodies and energies before a part of a step, which is taken back where its solution does not hold.
struct PartStart {
  std::vector<Vec3> p, v, w;
  std::vector<Quat> q;
  std::vector<Mat3> R;
  EnergyAccount energy;
  std::optional<Crushing::Memory> crushed;
};

/// In the order that ContactDetector gives points.
void sort_as_detected(std::vector<ContactPoint>& points);

struct Simulation::World {
  World(const Scene& scene, int thread_count, WarningCounts& warning_counts);

  std::size_t size() const { return static_cast<std::size_t>(parts.bodies.size()); }

  double potential();
  double time() const { return start + static_cast<double>(steps) * whole_step + elapsed; }

  void shorten_motion_before_impulses();
  std::optional<PartStart> part_start() const;
  void take_back(const std::optional<PartStart>& before);
  void move_before_impulses();
  void move_vessel_before_impulses();
  std::vector<Wrench> of_parts(const Wrenches& loads) const;
  const Wrenches& evaluate_loads();
  std::vector<ArticulatedBlock> begin_vessel(const Wrenches& free);
  std::vector<ContactPoint> find_contacts();
  void add_crush_points(std::vector<ContactPoint>& points);
  bool will_bounce_when_met(const ContactPoint& c);
  std::vector<BodyMotion> ways(const Velocities& velocities, const std::vector<FastPair>& pairs, double exact,
                               double horizon) const;
  std::vector<FastPair> list_fast_pairs(const Velocities& velocities, double horizon) const;
  std::vector<SweptPair> sweep(const Velocities& velocities, double exact, double horizon,
                               const SoughtOverlap& overlap = {});
  Velocities velocities_until_impact();
  double until_first_impact(double left);
  ContactPoint as_gap(const ContactPoint& met, double t, const Velocities& velocities) const;
  void follow_fast_pairs(std::vector<ContactPoint>& points);
  std::vector<ContactPoint> points_at_the_end(const StepMotion& motion) const;
  Velocities solved_velocities(const AssembledContacts& contacts, const ContactSolution& solution,
                               const std::vector<ArticulatedBlock>& vessel) const;
  bool add_missed(const Velocities& after, std::vector<int>& misses, std::vector<ContactPoint>& points);
  bool can_be_halved() const;
  std::optional<std::pair<int, int>> passing(const Velocities& velocities, double horizon);
  [[noreturn]] void refuse(const std::pair<int, int>& pair) const;
  void judge_unheld(const Velocities& after);
  Velocities new_velocities(const AssembledContacts& contacts, const ContactSolution& solution,
                            const Wrenches& free) const;
  StepMotion velocity_step(const AssembledContacts& contacts, const ContactSolution& solution, const Wrenches& free,
                           std::vector<ContactPoint> points);
  void advance_poses(StepMotion& motion);
  Velocities correct_positions(const StepMotion& motion, const AssembledContacts& contacts, StepRecord& record);
  void note_solution(const ContactSolution& solution, StepRecord& record) const;
  static void note_residuals(const Residuals& residuals, StepRecord& record);
  void copy_vessel_state();
  /// A vessel without parts on a carriage is booked from end to end of a step.
  bool is_booked_whole() const { return parts.vessel && parts.vessel->on_carriage() && !parts.is_jointed(); }
  PairFilter left_pairs() const;
  std::vector<std::pair<int, int>> crushing_pairs() const;
  VesselAccount vessel_account() const;
  StepLoads step_loads() const;
  VesselRecord vessel_record(const StepMotion& motion, const std::vector<Mat3>& C) const;
  Wrench on_whole_vessel(const Wrench& on_hull, const StepMotion& motion, const Wrenches& on_parts) const;
  std::vector<PartRecord> part_records(const StepMotion& motion) const;
  StepRecord reference_step();
  void note_reference_vessel(const ReferenceVesselLoads& impulses, StepRecord& record);
  void keep_solved(ContactProblem& problem, ContactSolution& solution, const StepMotion& motion);
  const SolvedProblem& last() const;
  double part_of_step(double longest, bool may_cut, StepRecord& record, MomentumBalance& balance, Stopwatch& watch);
  ContactSolution solve(AssembledContacts& contacts, const std::vector<ContactPoint>& points, StepRecord& record);
  std::vector<FloeBreak> take_breaks();
  void break_ice(StepRecord& record);
  void follow_bodies(const std::vector<NewPiece>& new_pieces);
  void note_vessel(const StepMotion& motion, const std::vector<Mat3>& C, StepRecord& record) const;
  void note_structures(const StepMotion& motion, StepRecord& record) const;
  void note_end(const MomentumBalance& balance, StepRecord& record) const;
  void stop_on_failure(const StepRecord& record) const;
  std::uint64_t state_hash() const;
  void demand_finite() const;
  void name_unnamed_pairs();
  void save(StateWriter out) const;
  void restore(const StateReader& in);

  WorldParts parts;
  WarningCounts& warnings;
  int threads;
  double whole_step, start;
  double h;            ///< of the part of the step at work: all of it unless it is cut [s]
  double elapsed = 0;  ///< of the step, in the parts before [s]
  /// Fast pairs that the last solution leads into each other although all their solutions were spent.
  std::vector<std::pair<int, int>> unheld;
  bool cut = false;                       ///< the part at work ends with an impact
  std::vector<std::uint64_t> on_the_way;  ///< keys of contacts whose gap is what closes until then, no distance
  long steps = 0;
  int floes = 0;
  Vec3 gravity;
  bool gyroscopic;
  ContactDetector detector;
  ContactModel model;
  WarmStart warm;
  std::vector<double> contact_d;   ///< per contact of the last solution, as from `measure` [1/kg]
  BrokenContacts broken_contacts;  ///< of the step before, until the next impulses
  Wrenches weight, free_loads;
  std::vector<Wrenches> module_loads;
  std::vector<double> width;         ///< smallest of each body [m]
  std::optional<Crushing> crushing;  ///< of a scene with <crushing> and ice
  std::optional<Breaking> breaking;  ///< of a scene with <bending> or <splitting>, and ice
  std::optional<FloePieces> pieces;  ///< of a scene in which floes can be cut
  EnergyAccount energy;
  VesselStart vessel_start;
  std::vector<SolvedProblem> solved;             ///< of the last step, one for each part that impacts cut it into
  SolvedProblem unsolved;                        ///< before the first step
  std::optional<ReferenceIntegrator> reference;  ///< moves the bodies in place of all else
  std::size_t pairs_named = 0;                   ///< of the pairs without friction, already told
};

}  // namespace nilas
