#include "core/output/replay/replay_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/output/replay/byte_text.h"
#include "core/output/replay/head.h"
#include "core/output/replay/piece.h"

namespace nilas::output::replay {

static void add_line(const bodies::DrawnLine& line, std::string& out) {
  add_byte(static_cast<int>(line.kind), out);
  add_text(line.name, out);
  add_float(line.force, out);
  add_varint(line.points.size(), out);
  for (const Vec3& x : line.points)
    for (int k = 0; k < 3; ++k) add_float(x[k], out);
}

/// Numbers of shapes go on where those of the part before the checkpoint ended.
static std::uint64_t first_shape(const StateReader* from) {
  std::uint64_t number = 0;
  if (from != nullptr) from->get("next_shape", number);
  return number;
}

ReplayFile::ReplayFile(const std::filesystem::path& path, const scene::Scene& scene, const sim::RunInfo& info,
                       const std::vector<std::string>& vessel_names, bool has_contact_table,
                       std::optional<std::int64_t> keep, const StateReader* from)
    : info_(info),
      has_contact_table_(has_contact_table),
      of_all_bodies_(has_contact_table && scene.output.contacts == StoredContacts::all),
      has_damage_(scene.fracture && scene.fracture->damage),
      channels_(info, vessel_names),
      frames_(first_shape(from)),
      file_(path, "", keep) {
  if (from != nullptr) channels_.restore(from->group("channels"));
  // A run that goes on may have another end.
  std::string start = keep ? std::string() : std::string(k_signature);
  start += packed_piece(k_head, head_text(scene, info, channels_, has_contact_table));
  if (const std::string waves = waves_text(info); !waves.empty()) start += packed_piece(k_waves, waves);
  file_.append(start);
}

BodyMarks ReplayFile::marks_of(const ShownState& shown, const FrameContacts& contacts,
                               const LoadedBodies& loaded) const {
  constexpr double k_damage_units = 255;
  BodyMarks marks{.island = contacts.island_of, .damage = {}, .is_part = {}};
  for (std::size_t b = 0; b < shown.bodies.id.size(); ++b) {
    const int index = static_cast<int>(b);
    marks.is_part.push_back(loaded.is_of_vessel(index) && index != loaded.vessel ? 1 : 0);
    if (!has_damage_) continue;
    const bool can_break = shown.damage && shown.bodies.kind[b] == bodies::BodyKind::floe;
    const double damage = can_break ? std::clamp(shown.damage(shown.bodies.id[b]), 0.0, 1.0) : 0.0;
    marks.damage.push_back(static_cast<int>(std::lround(k_damage_units * damage)));
  }
  return marks;
}

void ReplayFile::note(const sim::StepRecord& record, const std::vector<double>& vessel_values) {
  using Kind = bodies::DrawnLine::Kind;
  channels_.note(record, vessel_values);
  arrows_.clear();
  if (!record.vessel) return;
  const Vec3& at = record.vessel->state.pose.p;
  if (record.vessel->carriage)
    add_arrow(Kind::carriage, "carriage", at, record.vessel->carriage->about_joint.force, arrows_);
  for (std::size_t k = 0; k < record.vessel->module_loads.size(); ++k)
    if (info_.vessel_loads[k] == "wind")
      add_arrow(Kind::wind, "wind", at, record.vessel->module_loads[k].force, arrows_);
}

void ReplayFile::frame(const ShownState& shown) {
  const ContactChoice choice{
      .loaded = loaded_bodies(shown.bodies, info_), .in_table = has_contact_table_, .of_all_bodies = of_all_bodies_};
  const FrameContacts contacts = frame_contacts(shown.substeps, shown.bodies, choice, shown.h > 0 ? shown.h : 1);
  content_.clear();
  shapes_.clear();
  rest_.clear();
  content_.begin(Packing::mixed);
  channels_.add_to(content_.bytes);
  frames_.add(shown.bodies, shown.t, shown.step, shown.h, marks_of(shown, contacts, choice.loaded), content_.bytes,
              numbers_, shapes_);
  contacts_.add(contacts, shown.bodies, frames_, rest_, numbers_);
  add_lines(shown.lines, rest_);
  const std::string numbers = numbers_.finish();
  add_varint(numbers.size(), content_.bytes);
  content_.begin(Packing::dense);
  content_.bytes += numbers;
  content_.begin(Packing::mixed);
  content_.bytes += rest_;
  const std::string before = shapes_.empty() ? std::string() : packed_piece(k_shape, shapes_);
  file_.append(before + packed_piece(k_frame, content_));
}

void ReplayFile::add_lines(const std::vector<bodies::DrawnLine>& lines, std::string& out) const {
  add_varint(arrows_.size() + lines.size(), out);
  for (const auto& line : arrows_) add_line(line, out);
  for (const auto& line : lines) add_line(line, out);
}

void ReplayFile::save(StateWriter out) const {
  out.add("next_shape", frames_.next_shape());
  channels_.save(out.group("channels"));
}

void ReplayFile::finish(const std::string& reason) {
  file_.append(packed_piece(k_end, nlohmann::json{{"reason", reason}}.dump()));
  file_.close();
}

}  // namespace nilas::output::replay
