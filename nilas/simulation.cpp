#include "nilas/simulation.h"

#include <spdlog/sinks/null_sink.h>
#include <unistd.h>

#include <cmath>
#include <utility>

#include "contact/solved_problem.h"
#include "core/output/tables/steps_csv.h"
#include "core/scene/time_steps.h"
#include "core/sim/build/module_list.h"
#include "nilas/problem_content.h"
#include "nilas/scene_content.h"
#include "nilas/simulation_content.h"
#include "nilas/snapshot_content.h"
#include "nilas/translate.h"

namespace nilas {

namespace {

/// The modules of every scene, then one that shows the channels of commands, and applied loads where they are asked
/// for.
sim::ModuleList modules_of(const SimulationSettings& settings, const std::shared_ptr<library::WaitingLoads>& waiting,
                           std::shared_ptr<Channels>& commands) {
  sim::ModuleList list = sim::scene_modules();
  list.push_back({"commands", false, [&commands](const sim::ModuleSources& from) {
                    commands = from.parts.commands;
                    return sim::BuiltModule{};
                  }});
  if (settings.applied_loads)
    list.push_back({"applied", true, [waiting](const sim::ModuleSources&) {
                      return sim::BuiltModule{library::make_applied_loads(waiting), "the program that uses Nilas"};
                    }});
  return list;
}

std::shared_ptr<spdlog::logger> silent_logger() {
  return std::make_shared<spdlog::logger>("nilas", std::make_shared<spdlog::sinks::null_sink_mt>());
}

const char* kind_name(bodies::BodyKind kind) {
  switch (kind) {
    case bodies::BodyKind::floe:
      return "floe";
    case bodies::BodyKind::rigid:
      return "rigid";
    case bodies::BodyKind::wall:
      return "wall";
    default:
      return "vessel";
  }
}

Vector3 array_of(const Vec3& x) { return {x.x(), x.y(), x.z()}; }
std::array<double, 4> array_of(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Vec3 vector_of(const Vector3& x) { return {x[0], x[1], x[2]}; }

template <class Array>
void append(const Array& values, std::vector<double>& all) {
  all.insert(all.end(), values.begin(), values.end());
}

VesselStep vessel_step(const sim::VesselRecord& record) {
  VesselStep step;
  step.contact_force = array_of(record.contact.force);
  step.contact_torque = array_of(record.contact.torque);
  step.ice_force = array_of(record.ice);
  step.position = array_of(record.state.pose.p);
  step.velocity = array_of(record.state.v);
  step.angular_velocity = array_of(record.state.w);
  step.orientation = array_of(record.state.pose.q);
  return step;
}

void demand_finite(const char* what, const Vector3& values) {
  for (const double x : values)
    if (!std::isfinite(x)) throw Error(ErrorKind::input, std::string(what) + " has a number that is not finite");
}

}  // namespace

Simulation::Content::Content(const Scene& of, const SimulationSettings& given)
    : scene(of),
      settings(given),
      process(::getpid()),
      waiting(std::make_shared<library::WaitingLoads>()),
      warning_counts(silent_logger()),
      simulation(built(commands)) {
  if (simulation->info().has_vessel) channels.emplace(simulation->info());
}

std::unique_ptr<sim::Simulation> Simulation::Content::built(std::shared_ptr<Channels>& channels_of) {
  return std::make_unique<sim::Simulation>(scene.content().scene, settings.threads, warning_counts,
                                           modules_of(settings, waiting, channels_of));
}

Simulation::Content::Use::Use(const Content& content) : in_use_(content.in_use) {
  if (::getpid() != content.process)
    throw Error(ErrorKind::input,
                "a simulation cannot be used in a process that was forked after it was built; build "
                "it there");
  if (in_use_.exchange(true)) throw Error(ErrorKind::input, "another thread uses this simulation at the same time");
}
Simulation::Content::Use::~Use() { in_use_.store(false); }

Simulation::Simulation(const Scene& scene, const SimulationSettings& settings) {
  if (settings.threads < 1) throw Error(ErrorKind::input, "threads must be at least 1");
  content_ = library::translated([&] { return std::make_unique<Content>(scene, settings); });
}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

Step Simulation::step() {
  Content& in = *content_;
  const Content::Use use(in);
  if (in.has_failed) throw Error(ErrorKind::numerics, "the simulation failed in an earlier step and cannot go on");
  if (const std::string why = in.simulation->end_of_course(); !why.empty())
    throw Error(ErrorKind::input, "the simulation cannot go on: " + why);
  return library::translated([&] {
    in.has_failed = true;
    in.last = in.simulation->step();
    in.has_failed = false;
    in.waiting->clear();
    const sim::StepRecord& record = in.last;
    Step step;
    step.number = record.step;
    step.time = record.t;
    step.contacts = record.contacts;
    step.floes = record.floes;
    step.iterations = record.iterations;
    step.solved = !record.solver_short;
    step.message = record.solver_message;
    step.residual = record.residuals.law_map_m_s;
    step.state_hash = record.state_hash;
    step.numbers = output::step_numbers(in.simulation->info(), record);
    if (record.vessel) {
      step.vessel = vessel_step(*record.vessel);
      in.channels->read(*record.vessel, step.vessel_numbers);
    }
    return step;
  });
}

bool Simulation::is_done() const {
  const Content::Use use(*content_);
  const sim::Simulation& simulation = *content_->simulation;
  return simulation.steps() >= scene::number_of_steps(content_->scene.content().scene.time) ||
         !simulation.end_of_course().empty();
}
std::string Simulation::end_of_course() const {
  const Content::Use use(*content_);
  return content_->simulation->end_of_course();
}
double Simulation::time() const {
  const Content::Use use(*content_);
  return content_->simulation->time();
}
long Simulation::steps() const {
  const Content::Use use(*content_);
  return content_->simulation->steps();
}
const Scene& Simulation::scene() const { return content_->scene; }
int Simulation::num_bodies() const {
  const Content::Use use(*content_);
  return content_->simulation->bodies().size();
}
int Simulation::vessel() const { return content_->simulation->vessel_index(); }

BodyStates Simulation::bodies() const {
  const Content::Use use(*content_);
  const bodies::Bodies& all = content_->simulation->bodies();
  BodyStates states;
  states.id = all.id;
  states.name = all.name;
  states.mass = all.mass;
  for (int b = 0; b < all.size(); ++b) {
    const auto k = static_cast<std::size_t>(b);
    states.kind.emplace_back(kind_name(all.kind[k]));
    append(array_of(all.p_GB[k]), states.position);
    append(array_of(all.q_GB[k]), states.orientation);
    append(array_of(all.v_GB[k]), states.velocity);
    append(array_of(all.w_GB[k]), states.angular_velocity);
  }
  return states;
}

std::vector<std::string> Simulation::step_columns() const {
  std::vector<std::string> names = output::step_columns(content_->simulation->info());
  std::erase(names, "status");
  std::erase(names, "state_hash");
  return names;
}
std::vector<std::string> Simulation::vessel_columns() const {
  return content_->channels ? content_->channels->names() : std::vector<std::string>();
}
std::vector<std::pair<std::string, std::string>> Simulation::modules() const {
  return content_->simulation->info().modules;
}
std::vector<std::pair<std::string, long>> Simulation::warnings() const {
  const Content::Use use(*content_);
  const auto& counts = content_->warning_counts.counts();
  return {counts.begin(), counts.end()};
}

void Simulation::apply(int body, const Vector3& force, const Vector3& torque, const std::optional<Vector3>& point) {
  const Content::Use use(*content_);
  const bodies::Bodies& all = content_->simulation->bodies();
  if (!content_->settings.applied_loads)
    throw Error(ErrorKind::input, "loads cannot be applied: build the simulation with applied_loads");
  if (body < 0 || body >= all.size())
    throw Error(ErrorKind::input,
                "there is no body " + std::to_string(body) + "; allowed: 0 to " + std::to_string(all.size() - 1));
  demand_finite("force", force);
  demand_finite("torque", torque);
  if (point) demand_finite("point", *point);
  const auto b = static_cast<std::size_t>(body);
  content_->waiting->push_back({all.id[b], vector_of(force), vector_of(torque),
                                point ? Vec3(vector_of(*point) - all.p_GB[b]) : Vec3(Vec3::Zero())});
}

static std::vector<std::pair<std::string, double>> commands_of(const Channels& channels) {
  std::vector<std::pair<std::string, double>> all;
  for (int k = 0; k < channels.size(); ++k)
    if (channels.is_command(k)) all.emplace_back(channels.name(k), channels[k]);
  return all;
}

std::vector<std::pair<std::string, double>> Simulation::commands() const {
  const Content::Use use(*content_);
  return commands_of(*content_->commands);
}

void Simulation::set_command(const std::string& name, double value) {
  const Content::Use use(*content_);
  Channels& channels = *content_->commands;
  const int k = channels.find(name);
  if (k < 0 || !channels.is_command(k)) {
    std::string allowed;
    for (const auto& [other, ignored] : commands_of(channels)) allowed += (allowed.empty() ? "" : ", ") + other;
    throw Error(ErrorKind::input, "there is no command '" + name + "'; allowed: " +
                                      (allowed.empty() ? "none, since the scene has nothing to command" : allowed));
  }
  if (!std::isfinite(value)) throw Error(ErrorKind::input, "the value of '" + name + "' is not finite");
  channels.set(k, value);
}

Problem Simulation::last_problem() const {
  const Content::Use use(*content_);
  const contact::SolvedProblem& solved = content_->simulation->last_problem();
  auto content = std::make_unique<Problem::Content>();
  content->stored.problem = solved.problem;
  content->stored.title = content_->scene.name() + ", step " + std::to_string(content_->simulation->steps());
  for (int k = 0; k < solved.problem.num_velocities(); ++k) content->stored.dof_of_file.push_back(k);
  if (solved.guess.size() > 0) content->stored.guess = solved.guess;
  if (solved.solution.r.size() > 0) content->stored.solution = solved.solution.r;
  return Problem(std::move(content));
}

std::vector<double> Simulation::last_impulses() const {
  const Content::Use use(*content_);
  return library::listed(content_->simulation->last_problem().solution.r);
}

Snapshot Simulation::snapshot() const {
  const Content::Use use(*content_);
  return library::translated([&] {
    if (content_->scene.content().scene.contact.integrator == Integrator::reference)
      throw Error(ErrorKind::input, "the reference integrator has no snapshots");
    auto content = std::make_unique<Snapshot::Content>();
    content->fingerprint = content_->scene.fingerprint();
    content->applied_loads = content_->settings.applied_loads;
    content->waiting = *content_->waiting;
    content_->simulation->save(StateWriter(content->state));
    return Snapshot(std::move(content));
  });
}

void Simulation::restore(const Snapshot& snapshot) {
  const Content::Use use(*content_);
  library::translated([&] {
    const Snapshot::Content& from = *snapshot.content_;
    if (from.fingerprint != content_->scene.fingerprint() || from.applied_loads != content_->settings.applied_loads)
      throw Error(ErrorKind::input, "the snapshot is of a simulation with another scene or other settings");
    // Bodies that broke since, or had broken before, are found only from the start of the scene.
    std::shared_ptr<Channels> commands;
    auto fresh = content_->built(commands);
    fresh->restore(StateReader(from.state));
    content_->simulation = std::move(fresh);
    content_->commands = std::move(commands);
    *content_->waiting = from.waiting;
    content_->last = {};
    content_->has_failed = false;
  });
}

}  // namespace nilas
