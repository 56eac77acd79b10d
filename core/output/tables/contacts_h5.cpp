#include "core/output/tables/contacts_h5.h"

#include <algorithm>
#include <bit>

#include "core/base/error.h"

namespace nilas::output {

namespace {

/// Number of rows that are written together; the cost of opening the file is then negligible.
constexpr std::int64_t k_rows_together = 4096;
constexpr std::chrono::seconds k_longest_wait{1};

/// Whether some friction transmits couples, so that sums of moments include them.
bool has_couples(const scene::Scene& scene) {
  return std::any_of(scene.contact.friction.begin(), scene.contact.friction.end(),
                     [](const scene::FrictionScene& pair) { return pair.rolling > 0 || pair.spinning > 0; });
}

class LayoutList {
 public:
  void number(const std::string& name, const std::string& unit, const std::string& meaning) {
    columns_.push_back({name, unit, meaning, std::vector<double>{}});
  }
  void integer(const std::string& name, const std::string& meaning) {
    columns_.push_back({name, "1", meaning, std::vector<std::int64_t>{}});
  }
  /// Adds the columns name_x_unit, name_y_unit, name_z_unit. `tail` is the unit in the names.
  void vector(const std::string& name, const std::string& tail, const std::string& unit, const std::string& meaning) {
    for (const char* axis : {"x", "y", "z"}) number(name + axis + tail, unit, meaning + ", " + axis);
  }
  std::vector<hdf5::Hdf5Column> take() { return std::move(columns_); }

 private:
  std::vector<hdf5::Hdf5Column> columns_;
};

hdf5::Hdf5Columns::Layout layout(bool has_vessel, bool with_couples) {
  LayoutList list;
  list.number("time_s", "s", "end of the step, as in vessel.csv");
  list.integer("step", "from 1");
  list.integer(
      "body",
      "id of the body that the force acts on: the vessel where it takes part, else a structure, else the higher id");
  list.integer("other", "id of the body that touches it: the floe");
  list.vector("", "_m", "m", "point in G where the contact was found, midway between the surfaces");
  if (has_vessel) list.vector("hull_", "_m", "m", "the same point in V, the frame of the hull's mesh");
  list.vector("n", "", "1", "unit normal into body, in G");
  list.number("gap_m", "m", "when the contact was found; below 0: penetration");
  list.vector("impulse_", "_Ns", "N s", "on body over the step, in G");
  list.vector("f", "_N", "N", "impulse / step, on body, in G");
  if (with_couples) list.vector("couple_", "_Nm", "N m", "of rolling and spinning friction on body, in G");
  list.integer("status", "0 open, 1 stick, 2 slip, 3 crush");
  list.integer("part", "convex part of body, from 1: of a hull folder part-0001.stl ...");
  list.integer("other_part", "convex part of other, from 1");
  list.integer("key", "stays the same from step to step while the same features touch");
  return {"contacts",
          "one row per contact and step, in the order of the steps; rows from the last end in /steps on belong to no "
          "complete step",
          "steps", "row k is step k + 1: its first row in /contacts and the row after its last", list.take()};
}

std::optional<hdf5::Hdf5Columns::Length> kept(const StateReader* from) {
  if (from == nullptr) return std::nullopt;
  hdf5::Hdf5Columns::Length length;
  from->get("steps", length.blocks);
  from->get("rows", length.rows);
  return length;
}

}  // namespace

bool ContactsH5::asked(const scene::Scene& scene, const sim::RunInfo& info) {
  if (scene.contact.integrator == Integrator::reference) return false;  // its impacts occur within a step
  switch (scene.output.contacts) {
    case StoredContacts::all:
      return true;
    case StoredContacts::hull:
      return info.has_vessel || !info.structures.empty();
    case StoredContacts::none:
      return false;
  }
  return false;
}

ContactsH5::ContactsH5(const std::filesystem::path& path, const scene::Scene& scene, const sim::RunInfo& info,
                       const StateReader* from)
    : of_all_bodies_(scene.output.contacts == StoredContacts::all),
      has_vessel_(info.has_vessel),
      has_couples_(has_couples(scene)),
      columns_(path, layout(has_vessel_, has_couples_), kept(from)),
      written_(std::chrono::steady_clock::now()) {}

ContactsH5::~ContactsH5() {
  try {
    columns_.write();
  } catch (const FileError&) {  // the user sees the error that ends the run
  }
}

void ContactsH5::step(const sim::StepRecord& record, const std::vector<contact::SolvedProblem>& parts,
                      const LoadedBodies& loaded) {
  for (const contact::SolvedProblem& solved : parts)
    for (const ContactRow& row : contact_rows(solved, loaded, of_all_bodies_)) add(row, record);
  columns_.end_block();
  if (columns_.pending_rows() >= k_rows_together || std::chrono::steady_clock::now() - written_ >= k_longest_wait)
    write();
}

void ContactsH5::add(const ContactRow& row, const sim::StepRecord& record) {
  const auto add_vector = [&](const Vec3& x) {
    for (const double component : x) columns_.add(component);
  };
  columns_.add(record.t);
  columns_.add(static_cast<std::int64_t>(record.step));
  columns_.add(row.body);
  columns_.add(row.other);
  add_vector(row.p_G);
  if (has_vessel_) add_vector(row.p_V);
  add_vector(row.n);
  columns_.add(row.gap);
  add_vector(row.impulse);
  add_vector(row.impulse / record.h);
  if (has_couples_) add_vector(row.couple / record.h);
  columns_.add(static_cast<std::int64_t>(row.status));
  columns_.add(static_cast<std::int64_t>(row.part));
  columns_.add(static_cast<std::int64_t>(row.other_part));
  columns_.add(std::bit_cast<std::int64_t>(row.key));
  columns_.end_row();
}

void ContactsH5::write() {
  columns_.write();
  written_ = std::chrono::steady_clock::now();
}

void ContactsH5::sync() {
  write();
  columns_.sync();
}

void ContactsH5::save(StateWriter out) const {
  out.add("steps", columns_.length().blocks);
  out.add("rows", columns_.length().rows);
}

}  // namespace nilas::output
