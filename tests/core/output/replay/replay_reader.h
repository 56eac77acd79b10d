#pragma once
/// Reads a replay as its page does: the format by docs/reference/replay-file.md, written apart from the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"
#include "core/output/replay/piece.h"
#include "tests/core/output/replay/number_reader.h"

namespace nilas::test {

/// Numbers from the content of a piece.
class ByteReader {
 public:
  explicit ByteReader(std::string content) : content_(std::move(content)) {}
  bool at_end() const { return at_ == content_.size(); }
  template <class Number>
  Number number() {
    Number x{};
    std::memcpy(&x, content_.data() + at_, sizeof x);
    skip(sizeof x);
    return x;
  }
  std::uint64_t varint() {
    std::uint64_t x = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = number<unsigned char>();
      x |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80) return x;
    }
  }
  std::int64_t signed_varint() {
    const std::uint64_t x = varint();
    return static_cast<std::int64_t>(x >> 1) ^ -static_cast<std::int64_t>(x & 1);
  }
  std::string block() {
    const auto size = varint();
    const std::string out = content_.substr(at_, size);
    skip(size);
    return out;
  }
  Vec3 floats() {
    Vec3 x;
    for (int k = 0; k < 3; ++k) x[k] = static_cast<double>(number<float>());
    return x;
  }

 private:
  void skip(std::size_t bytes) {
    if (at_ + bytes > content_.size()) throw std::runtime_error("a piece ends too early");
    at_ += bytes;
  }
  std::string content_;
  std::size_t at_ = 0;
};

struct ReplayShape {
  int type = 0;
  std::uint64_t owner = 0;
  std::vector<Vec3> points;
  std::vector<std::vector<std::uint64_t>> polygons;
};
template <std::size_t N>
constexpr std::array<int, N> all(int value) {
  std::array<int, N> list{};
  list.fill(value);
  return list;
}
struct ReplayBody {
  std::int64_t id = 0;
  int kind = 0;
  std::uint64_t shape = 0;
  bool fixed = false;
  double thickness = 0, mass = 0, unit = 0;
  std::string name;
  int past = 0;
  std::array<std::int64_t, 7> now{}, before{};
  std::int64_t speed = 0, island = 0, damage = 0;
  std::array<int, 10> digits = all<10>(k_no_number_before);  ///< of the newest numbers
  Vec3 p = Vec3::Zero();
  Quat q = Quat::Identity();
};
struct ReplayContact {
  int status = 0;
  bool exact = false, stored = false;
  std::size_t first = 0, second = 0;
  std::array<std::int64_t, 8> numbers{};  ///< of a pair
  std::array<int, 8> digits = all<8>(k_no_number_before);
  Vec3 p = Vec3::Zero(), n = Vec3::Zero(), force = Vec3::Zero();
};
struct ReplayIsland {
  std::uint64_t contacts = 0, iterations = 0;
  double residual = 0;
};
struct ReplayLine {
  int kind = 0;
  std::string name;
  double force = 0;
  std::vector<Vec3> points;
};
struct ReplayFrame {
  bool key = false;
  double t = 0, h = 0;
  std::uint64_t step = 0;
  std::vector<ReplayBody> bodies;
  std::vector<ReplayIsland> islands;
  std::vector<ReplayContact> contacts;
  std::vector<std::array<float, 3>> channels;
  std::vector<ReplayLine> lines;
};

class Replay {
 public:
  explicit Replay(const std::string& bytes) {
    const auto list = output::replay::pieces_of(bytes, "replay.bin");
    cut = list.cut;
    for (const auto& piece : list.pieces) {
      ByteReader in(output::replay::unpacked(piece.packed));
      if (piece.kind == 'H') head = nlohmann::json::parse(output::replay::unpacked(piece.packed));
      while (piece.kind == 'S' && !in.at_end()) read_shape(in);
      if (piece.kind == 'W') waves = nlohmann::json::parse(output::replay::unpacked(piece.packed));
      if (piece.kind == 'E') end = nlohmann::json::parse(output::replay::unpacked(piece.packed)).at("reason");
      if (piece.kind == 'F') read_frame(in);
      EXPECT_TRUE(piece.kind != 'F' || in.at_end());
    }
  }

  nlohmann::json head, waves;
  std::map<std::uint64_t, ReplayShape> shapes;
  std::vector<ReplayFrame> frames;
  std::size_t cut = 0;
  std::string end;  ///< how the run ended; empty: that is not known

 private:
  void read_shape(ByteReader& in) {
    const auto number = in.varint();
    EXPECT_EQ(shapes.count(number), 0u) << "a number is used once";
    ReplayShape& shape = shapes[number];
    shape.type = in.number<unsigned char>();
    shape.owner = in.varint();
    shape.points.resize(in.varint());
    for (Vec3& x : shape.points) x = in.floats();
    std::vector<std::uint64_t> sizes(in.varint());
    for (auto& size : sizes) size = in.varint();
    for (const auto size : sizes) {
      std::vector<std::uint64_t> polygon(size);
      for (auto& corner : polygon) corner = in.varint();
      shape.polygons.push_back(polygon);
    }
  }

  void read_frame(ByteReader& in) {
    ReplayFrame frame;
    frame.channels.resize(head.at("channels").size());
    for (auto& channel : frame.channels) channel = read_channel(in);
    frame.key = (in.number<unsigned char>() & 1) != 0;
    frame.t = in.number<double>();
    frame.step = in.varint();
    frame.h = in.number<double>();
    if (!frame.key) frame.bodies = frames.back().bodies;
    read_list(in, frame);
    if (frame.key) shares_.clear();
    NumberReader numbers(in.block(), shares_);
    read_arrays(numbers, frame);
    std::vector<ReplayContact> pairs = read_pairs(numbers, frame);
    EXPECT_TRUE(numbers.at_end());
    frame.islands.resize(in.varint());
    for (auto& island : frame.islands) {
      island.contacts = in.varint();
      island.iterations = in.varint();
      island.residual = static_cast<double>(in.number<float>());
    }
    read_exact(in, frame);
    for (auto& pair : pairs) place(pair, frame);
    frame.contacts.insert(frame.contacts.end(), pairs.begin(), pairs.end());
    frame.lines.resize(in.varint());
    for (auto& line : frame.lines) {
      line.kind = in.number<unsigned char>();
      line.name = in.block();
      line.force = static_cast<double>(in.number<float>());
      line.points.resize(in.varint());
      for (Vec3& x : line.points) x = in.floats();
    }
    frames.push_back(std::move(frame));
  }

  static void read_list(ByteReader& in, ReplayFrame& frame) {
    std::int64_t place = -1;
    for (auto gone = in.varint(); gone > 0; --gone) {
      place += static_cast<std::int64_t>(in.varint());
      frame.bodies.at(static_cast<std::size_t>(place)).id = 0;
    }
    std::erase_if(frame.bodies, [](const ReplayBody& body) { return body.id == 0; });
    std::int64_t id = 0;
    for (auto came = in.varint(); came > 0; --came) {
      ReplayBody body;
      body.id = id += in.signed_varint();
      body.kind = in.number<unsigned char>();
      body.shape = in.varint();
      body.fixed = in.number<unsigned char>() != 0;
      body.thickness = static_cast<double>(in.number<float>());
      body.mass = static_cast<double>(in.number<float>());
      body.unit = static_cast<double>(in.number<float>());
      body.name = in.block();
      frame.bodies.push_back(body);
    }
  }

  static std::int64_t next(NumberReader& in, std::size_t kind, int& digits) {
    const std::int64_t x = in.number(static_cast<int>(kind), digits);
    digits = digits_of(x);
    return x;
  }

  void read_arrays(NumberReader& in, ReplayFrame& frame) const {
    for (std::size_t k = 0; k < 7; ++k)
      for (ReplayBody& body : frame.bodies) {
        const std::int64_t predicted = body.past == 0   ? 0
                                       : body.past == 1 ? body.now[k]
                                                        : 2 * body.now[k] - body.before[k];
        body.before[k] = body.now[k];
        body.now[k] = predicted + next(in, k, body.digits[k]);
      }
    for (ReplayBody& body : frame.bodies) body.speed += next(in, 7, body.digits[7]);
    for (ReplayBody& body : frame.bodies) body.island += next(in, 8, body.digits[8]);
    if (head.at("damage").get<bool>())
      for (ReplayBody& body : frame.bodies) body.damage += next(in, 9, body.digits[9]);
    for (ReplayBody& body : frame.bodies) {
      body.past = std::min(body.past + 1, 2);
      const auto& x = body.now;
      body.p = body.unit * Vec3(static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2]));
      body.q = Quat(static_cast<double>(x[3]), static_cast<double>(x[4]), static_cast<double>(x[5]),
                    static_cast<double>(x[6]))
                   .normalized();
    }
  }

  /// Value, smallest, largest.
  static std::array<float, 3> read_channel(ByteReader& in) {
    const auto value = in.number<float>();
    const auto half = [&] {
      return std::bit_cast<float>(static_cast<std::uint32_t>(in.number<std::uint16_t>()) << 16);
    };
    const float below = half(), above = half();
    return {value, value - below, value + above};
  }

  static void read_places(ByteReader& in, std::span<ReplayContact> contacts) {
    std::int64_t place = 0;
    for (auto& c : contacts) c.first = static_cast<std::size_t>(place += in.signed_varint());
    for (auto& c : contacts) c.second = in.varint();
  }

  static void read_exact(ByteReader& in, ReplayFrame& frame) {
    frame.contacts.resize(in.varint());
    for (auto& c : frame.contacts) {
      const int byte = in.number<unsigned char>();
      c.status = byte & 63;
      c.exact = true;
      c.stored = (byte & 64) != 0;
    }
    read_places(in, frame.contacts);
    for (int k = 0; k < 3; ++k)
      for (auto& c : frame.contacts) {
        const ReplayBody& body = frame.bodies.at(c.first);
        c.p[k] = body.p[k] + 4 * body.unit * static_cast<double>(in.signed_varint());
      }
    for (int k = 0; k < 3; ++k)
      for (auto& c : frame.contacts) c.n[k] = in.number<signed char>() / 127.0;
    for (auto& c : frame.contacts) c.force = in.floats();
  }

  /// The pairs of the frame before that touch still, by the places of now.
  std::vector<ReplayContact> kept_pairs(NumberReader& in, const ReplayFrame& frame) const {
    std::vector<ReplayContact> kept;
    if (frame.key) return kept;
    const auto place_of = [&](std::size_t before) {
      const auto id = frames.back().bodies.at(before).id;
      const auto found =
          std::find_if(frame.bodies.begin(), frame.bodies.end(), [&](const auto& b) { return b.id == id; });
      return static_cast<std::size_t>(found - frame.bodies.begin());
    };
    for (ReplayContact pair : frames.back().contacts) {
      if (pair.exact) continue;
      pair.first = place_of(pair.first);
      pair.second = place_of(pair.second);
      if (std::max(pair.first, pair.second) < frame.bodies.size() && in.number(10, pair.status) == 0)
        kept.push_back(pair);
    }
    return kept;
  }

  std::vector<ReplayContact> read_pairs(NumberReader& in, const ReplayFrame& frame) const {
    std::vector<ReplayContact> pairs = kept_pairs(in, frame);
    const std::size_t old = pairs.size();
    pairs.resize(old + static_cast<std::size_t>(in.number(11, k_no_number_before)));
    std::int64_t at = 0;
    for (auto& c : std::span(pairs).subspan(old)) {
      c.first = static_cast<std::size_t>(at += in.number(12, k_no_number_before));
      c.second = static_cast<std::size_t>(at + in.number(13, k_no_number_before));
    }
    for (std::size_t i = 0; i < pairs.size(); ++i)
      pairs[i].status = static_cast<int>(in.number(14, i < old ? pairs[i].status : k_no_number_before));
    for (std::size_t k = 0; k < 8; ++k)
      for (auto& c : pairs) c.numbers[k] += next(in, 15 + k, c.digits[k]);
    return pairs;
  }

  static void place(ReplayContact& c, const ReplayFrame& frame) {
    const ReplayBody& body = frame.bodies.at(c.first);
    const auto number = [&](std::size_t k) { return static_cast<double>(c.numbers[k]); };
    const auto direction = [](double around, double up) {
      return Vec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
    };
    const double step = k_pi / 64, force_step = k_pi / 32, around = step * number(0), up = step * number(1);
    c.p = body.p + body.q * (256 * body.unit * Vec3(number(3), number(4), number(5)));
    c.n = body.q * direction(around, up);
    c.force = std::pow(10, number(6) / 20) *
              (body.q * direction(around + force_step * number(7), up + force_step * number(2)));
  }

  NumberReader::Shares shares_;  ///< after the newest frame
};

}  // namespace nilas::test
