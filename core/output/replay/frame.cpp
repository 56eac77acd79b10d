#include "core/output/replay/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/output/replay/byte_text.h"

namespace nilas::output::replay {

namespace {

// With the rounding of quaternions below, no point of a floe is farther than 1e-4 of its diameter from its place:
// half a unit along each axis is 0.69e-4, half a unit of each component of a quaternion is 0.27e-4.
constexpr double k_unit_share = 0.8e-4, k_least_unit = 1e-6, k_turn_unit = 1.0 / 32768;
constexpr int k_key_flag = 1;

/// The unit of positions for a body of this shape, as the file has it [m].
double unit_of(const geometry::Shape& shape) {
  const double unit = std::max(k_least_unit, k_unit_share * 2 * shape.bounding_radius);
  return static_cast<double>(static_cast<float>(unit));
}

/// The code of a speed [m/s]: 0 below 1e-6, then 28 steps a decade.
std::int64_t speed_code(double speed) {
  constexpr double k_least = 1e-6, k_steps = 28;
  return speed < k_least ? 0 : 1 + std::llround(k_steps * (std::log10(speed) + 6));
}

int kind_code(bodies::BodyKind kind, bool is_part) {
  switch (kind) {
    case bodies::BodyKind::floe:
      return 0;
    case bodies::BodyKind::vessel:
      return is_part ? 4 : 1;
    case bodies::BodyKind::rigid:
      return 2;
    case bodies::BodyKind::wall:
      return 3;
  }
  return 2;
}

}  // namespace

/// A key frame: all bodies come anew. Bodies other than floes get the unit of the smallest floe.
void BodyFrames::begin_key(const bodies::Bodies& bodies) {
  double least = std::numeric_limits<double>::infinity(), of_any = least;
  for (std::size_t b = 0; b < bodies.id.size(); ++b) {
    const double unit = unit_of(*bodies.shape[b]);
    of_any = std::min(of_any, unit);
    if (bodies.kind[b] == bodies::BodyKind::floe) least = std::min(least, unit);
  }
  least_unit_ = std::isfinite(least) ? least : std::isfinite(of_any) ? of_any : k_unit_share;
  now_.clear();
  since_key_ = 0;
  shapes_.forget_unused();
}

void BodyFrames::add(const bodies::Bodies& bodies, double t, long step, double h, const BodyMarks& marks,
                     std::string& content, NumberCoder& numbers, std::string& shapes) {
  const bool is_key = since_key_ >= k_key_every;
  if (is_key) {
    begin_key(bodies);
    numbers.forget();
  }
  ++since_key_;
  add_byte(is_key ? k_key_flag : 0, content);
  add_number(t, content);
  add_varint(static_cast<std::uint64_t>(step), content);
  add_number(h, content);
  add_list(bodies, marks, content, shapes);
  add_motion(bodies, numbers);
  add_marks(bodies, marks, numbers);
}

/// Bodies keep their order, and those that come stand at the end, so a pass through both lists finds what changed.
void BodyFrames::add_list(const bodies::Bodies& bodies, const BodyMarks& marks, std::string& content,
                          std::string& shapes) {
  std::vector<std::uint64_t> gone;
  std::size_t b = 0;
  std::ptrdiff_t last = -1;
  for (std::size_t k = 0; k < now_.size(); ++k) {
    if (b < bodies.id.size() && bodies.id[b] == now_[k].id) {
      ++b;
      continue;
    }
    gone.push_back(static_cast<std::uint64_t>(static_cast<std::ptrdiff_t>(k) -
                                              std::exchange(last, static_cast<std::ptrdiff_t>(k))));
    now_[k].id = 0;
  }
  std::erase_if(now_, [](const Stored& body) { return body.id == 0; });
  add_varint(gone.size(), content);
  for (const std::uint64_t step : gone) add_varint(step, content);
  add_varint(bodies.id.size() - now_.size(), content);
  std::int64_t last_id = 0;
  for (; b < bodies.id.size(); ++b)
    add_body(bodies, b, !marks.is_part.empty() && marks.is_part[b] != 0, last_id, content, shapes);
}

void BodyFrames::add_body(const bodies::Bodies& bodies, std::size_t b, bool is_part, std::int64_t& last_id,
                          std::string& content, std::string& shapes) {
  const geometry::Shape& shape = *bodies.shape[b];
  const bool is_floe = bodies.kind[b] == bodies::BodyKind::floe;
  add_signed(bodies.id[b] - std::exchange(last_id, bodies.id[b]), content);
  add_byte(kind_code(bodies.kind[b], is_part), content);
  add_varint(shapes_.number_of(bodies.shape[b], is_floe, shapes), content);
  add_byte(bodies.motion[b] == bodies::Motion::fixed ? 1 : 0, content);
  add_float(shape.kind == geometry::ShapeKind::prism ? shape.thickness : 0, content);
  add_float(bodies.mass[b], content);
  Stored stored;
  stored.id = bodies.id[b];
  stored.unit = is_floe ? unit_of(shape) : least_unit_;
  now_.push_back(stored);
  add_float(stored.unit, content);
  add_text(is_floe ? std::string_view() : std::string_view(bodies.name[b]), content);
}

/// The numbers w, x, y, z of a turn, with the sign nearest to that of the frame before.
std::array<double, 4> BodyFrames::turn_nearest(const Quat& q, const Stored& body) {
  std::array<double, 4> turn{q.w(), q.x(), q.y(), q.z()};
  double along = body.past > 0 ? 0 : turn[0];
  for (std::size_t k = 0; k < turn.size() && body.past > 0; ++k) along += turn[k] * static_cast<double>(body.turn[k]);
  for (double& x : turn) x = along < 0 ? -x : x;
  return turn;
}

void BodyFrames::add_motion(const bodies::Bodies& bodies, NumberCoder& numbers) {
  NILAS_DEMAND(now_.size() == bodies.id.size());
  std::vector<std::array<double, 4>> turns;
  for (std::size_t b = 0; b < now_.size(); ++b) turns.push_back(turn_nearest(bodies.q_GB[b], now_[b]));
  for (std::size_t k = 0; k < k_of_speed; ++k)
    for (std::size_t b = 0; b < now_.size(); ++b) {
      Stored& body = now_[b];
      std::int64_t& stored = k < k_of_turn ? body.position[k] : body.turn[k - k_of_turn];
      const std::int64_t value = k < k_of_turn ? in_units(bodies.p_GB[b][static_cast<Eigen::Index>(k)], body.unit)
                                               : in_units(turns[b][k - k_of_turn], k_turn_unit);
      const std::int64_t predicted = body.past == 0 ? 0 : body.past == 1 ? stored : 2 * stored - body.before[k];
      body.add(k_of_position + k, value - predicted, numbers);
      body.before[k] = stored;
      stored = value;
    }
  for (Stored& body : now_) body.past = std::min(body.past + 1, 2);
}

void BodyFrames::add_marks(const bodies::Bodies& bodies, const BodyMarks& marks, NumberCoder& numbers) {
  for (std::size_t b = 0; b < now_.size(); ++b) {
    const std::int64_t code = speed_code(bodies.v_GB[b].norm());
    now_[b].add(k_of_speed, code - std::exchange(now_[b].speed, code), numbers);
  }
  for (std::size_t b = 0; b < now_.size(); ++b) {
    const std::int64_t island = marks.island.empty() ? 0 : marks.island[b];
    now_[b].add(k_of_island, island - std::exchange(now_[b].island, island), numbers);
  }
  for (std::size_t b = 0; b < marks.damage.size(); ++b)
    now_[b].add(k_of_damage, marks.damage[b] - std::exchange(now_[b].damage, marks.damage[b]), numbers);
}

}  // namespace nilas::output::replay
