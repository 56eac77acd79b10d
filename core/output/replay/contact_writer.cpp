#include "core/output/replay/contact_writer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/math.h"
#include "core/output/replay/byte_text.h"

namespace nilas::output::replay {

namespace {

constexpr double k_normal_unit = 127, k_point_units = 4, k_pair_point_units = 256;
constexpr int k_stored_flag = 64;
/// Normals and forces of pairs are counted in these steps of a circle, and the size of forces in these steps of a
/// decade.
constexpr std::int64_t k_circle = 128, k_force_circle = 64;
constexpr double k_angle = 2 * k_pi / static_cast<double>(k_circle),
                 k_force_angle = 2 * k_pi / static_cast<double>(k_force_circle), k_force_step = 1.0 / 20,
                 k_least_force = 1e-12;
/// The numbers of a pair, in the order of the file. Those around the z axis are the same after a whole circle.
enum PairNumber : std::size_t {
  normal_around,
  normal_up,
  force_up,
  point_x,
  point_y,
  point_z,
  force_size,
  force_around
};

double around(const Vec3& v) { return std::atan2(v.y(), v.x()); }
double up(const Vec3& v) { return std::asin(std::clamp(v.z() / v.norm(), -1.0, 1.0)); }
/// The same angle nearest to zero, in steps of a circle.
std::int64_t wrapped(std::int64_t steps, std::int64_t circle) {
  const std::int64_t rest = ((steps + circle / 2) % circle + circle) % circle;
  return rest - circle / 2;
}

std::array<std::int64_t, 8> numbers_of(const FrameContact& contact, const bodies::Bodies& bodies, double unit) {
  const auto b = static_cast<std::size_t>(contact.first);
  const Mat3 to_body = bodies.R_GB[b].transpose();
  const Vec3 point = to_body * (contact.p_G - bodies.p_GB[b]), normal = to_body * contact.n;
  const Vec3 force = to_body * contact.force;
  std::array<std::int64_t, 8> numbers{};
  numbers[normal_around] = in_units(around(normal), k_angle);
  numbers[normal_up] = in_units(up(normal), k_angle);
  // The angles of a force count from the normal as it is stored.
  const auto beyond = [](double angle, std::int64_t stored) {
    return in_units(angle - k_angle * static_cast<double>(stored), k_force_angle);
  };
  numbers[force_up] = beyond(up(force), numbers[normal_up]);
  for (int k = 0; k < 3; ++k)
    numbers[point_x + static_cast<std::size_t>(k)] = in_units(point[k], k_pair_point_units * unit);
  numbers[force_size] = in_units(std::log10(std::max(force.norm(), k_least_force)), k_force_step);
  numbers[force_around] = wrapped(beyond(around(force), numbers[normal_around]), k_force_circle);
  return numbers;
}

void add_islands(const std::vector<FrameIsland>& islands, std::string& content) {
  add_varint(islands.size(), content);
  for (const FrameIsland& island : islands) {
    add_varint(static_cast<std::uint64_t>(island.contacts), content);
    add_varint(static_cast<std::uint64_t>(island.iterations), content);
    add_float(island.residual, content);
  }
}

/// Places of first bodies as differences, and of second ones as they are.
void add_places(const std::vector<const FrameContact*>& list, std::string& content) {
  std::int64_t last = 0;
  for (const FrameContact* c : list) add_signed(c->first - std::exchange(last, c->first), content);
  for (const FrameContact* c : list) add_varint(static_cast<std::uint64_t>(c->second), content);
}

void add_exact(const std::vector<const FrameContact*>& list, const BodyFrames& frames, std::string& content) {
  add_varint(list.size(), content);
  for (const FrameContact* c : list) add_byte(static_cast<int>(c->status) + (c->stored ? k_stored_flag : 0), content);
  add_places(list, content);
  for (int k = 0; k < 3; ++k)
    for (const FrameContact* c : list) {
      const auto b = static_cast<std::size_t>(c->first);
      const std::int64_t units = in_units(c->p_G[k], frames.unit(b)) - frames.position(b)[static_cast<std::size_t>(k)];
      add_signed(in_units(static_cast<double>(units), k_point_units), content);
    }
  for (int k = 0; k < 3; ++k)
    for (const FrameContact* c : list) add_byte(static_cast<int>(std::lround(k_normal_unit * c->n[k])), content);
  for (const FrameContact* c : list)
    for (int k = 0; k < 3; ++k) add_float(c->force[k], content);
}

}  // namespace

void ContactWriter::add(const FrameContacts& list, const bodies::Bodies& bodies, const BodyFrames& frames,
                        std::string& content, NumberCoder& numbers) {
  add_islands(list.islands, content);
  std::vector<const FrameContact*> exact, sums;
  for (const FrameContact& c : list.contacts) (c.exact ? exact : sums).push_back(&c);
  add_exact(exact, frames, content);
  if (frames.is_key()) pairs_.clear();
  add_pairs(sums, bodies, frames, numbers);
}

/// The pairs of the frame before that still touch, and a mark for each whose bodies are there.
std::vector<ContactWriter::Pair> ContactWriter::kept(const std::vector<const FrameContact*>& now,
                                                     const bodies::Bodies& bodies, NumberCoder& numbers) const {
  std::map<std::pair<std::int64_t, std::int64_t>, const FrameContact*> found;
  for (const FrameContact* c : now)
    found[{bodies.id[static_cast<std::size_t>(c->first)], bodies.id[static_cast<std::size_t>(c->second)]}] = c;
  const auto is_there = [&](std::int64_t id) { return std::binary_search(bodies.id.begin(), bodies.id.end(), id); };
  std::vector<Pair> list;
  for (Pair pair : pairs_) {
    if (!is_there(pair.first) || !is_there(pair.second)) continue;
    const auto place = found.find({pair.first, pair.second});
    numbers.add(k_of_parting, pair.status, place == found.end() ? 1 : 0);
    if (place == found.end()) continue;
    pair.contact = place->second;
    list.push_back(pair);
  }
  return list;
}

/// Pairs that stay come first, in their order, so that each stands for itself by its place.
void ContactWriter::add_pairs(const std::vector<const FrameContact*>& now, const bodies::Bodies& bodies,
                              const BodyFrames& frames, NumberCoder& numbers) {
  std::vector<Pair> list = kept(now, bodies, numbers);
  std::vector<const FrameContact*> stays, fresh;
  for (const Pair& pair : list) stays.push_back(pair.contact);
  std::sort(stays.begin(), stays.end());
  for (const FrameContact* c : now)
    if (!std::binary_search(stays.begin(), stays.end(), c)) fresh.push_back(c);
  numbers.add(k_of_new_pairs, k_no_past, static_cast<std::int64_t>(fresh.size()));
  int last = 0;
  for (const FrameContact* c : fresh) {
    numbers.add(k_of_first, k_no_past, c->first - std::exchange(last, c->first));
    numbers.add(k_of_second, k_no_past, c->second - c->first);
    Pair pair{.first = bodies.id[static_cast<std::size_t>(c->first)],
              .second = bodies.id[static_cast<std::size_t>(c->second)]};
    pair.contact = c;
    list.push_back(pair);
  }
  for (Pair& pair : list) {
    const auto status = static_cast<std::uint8_t>(pair.contact->status);
    numbers.add(k_of_status, std::exchange(pair.status, status), status);
  }
  std::vector<std::array<std::int64_t, k_numbers>> values;
  for (const Pair& pair : list)
    values.push_back(numbers_of(*pair.contact, bodies, frames.unit(static_cast<std::size_t>(pair.contact->first))));
  for (std::size_t k = 0; k < k_numbers; ++k)
    for (std::size_t i = 0; i < list.size(); ++i) {
      Pair& pair = list[i];
      const std::int64_t difference = values[i][k] - std::exchange(pair.numbers[k], values[i][k]);
      pair.digits[k] = numbers.add(k_of_pair + k, pair.digits[k],
                                   k == normal_around  ? wrapped(difference, k_circle)
                                   : k == force_around ? wrapped(difference, k_force_circle)
                                                       : difference);
    }
  pairs_ = std::move(list);
}

}  // namespace nilas::output::replay
