#pragma once
/// The bodies of a replay frame: what differs from a prediction by the two frames before.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/output/replay/number_coder.h"
#include "core/output/replay/shapes.h"

namespace nilas::output::replay {

/// What a frame shows of bodies beyond their poses, one entry a body.
struct BodyMarks {
  std::vector<int> island;    ///< number of the island from 1, 0: none
  std::vector<int> damage;    ///< in units of 1/255; empty where the scene has none
  std::vector<char> is_part;  ///< 1 for a part of the vessel
};

class BodyFrames {
 public:
  /// The number of frames from one key frame to the next.
  static constexpr int k_key_every = 64;

  /// `first_shape`: the number of the first shape, so that a resumed run uses none twice.
  explicit BodyFrames(std::uint64_t first_shape) : shapes_(first_shape) {}

  std::uint64_t next_shape() const { return shapes_.next(); }
  /// Whether the newest frame stands by itself.
  bool is_key() const { return since_key_ == 1; }
  /// The position of a body of the newest frame is stored in this unit [m].
  double unit(std::size_t b) const { return now_[b].unit; }
  /// Where that body is, in its unit.
  const std::array<std::int64_t, 3>& position(std::size_t b) const { return now_[b].position; }

  /// Appends the head of a frame to `content`, the arrays of bodies to `numbers`, and new shapes to the content of a
  /// piece of shapes.
  void add(const bodies::Bodies& bodies, double t, long step, double h, const BodyMarks& marks, std::string& content,
           NumberCoder& numbers, std::string& shapes);

 private:
  struct Stored {
    std::int64_t id = 0;
    double unit = 1;  ///< of its position [m]
    int past = 0;     ///< number of frames since it came, at most 2
    std::array<std::int64_t, 3> position{};
    std::array<std::int64_t, 4> turn{};
    std::array<std::int64_t, 7> before{};  ///< position and turn of the frame before
    std::int64_t speed = 0, island = 0, damage = 0;
    std::array<std::uint8_t, k_of_parting> digits = none();  ///< of the newest number of each kind

    static constexpr std::array<std::uint8_t, k_of_parting> none() {
      std::array<std::uint8_t, k_of_parting> digits{};
      digits.fill(k_no_past);
      return digits;
    }
    void add(std::size_t kind, std::int64_t x, NumberCoder& numbers) {
      digits[kind] = numbers.add(kind, digits[kind], x);
    }
  };

  void begin_key(const bodies::Bodies& bodies);
  void add_list(const bodies::Bodies& bodies, const BodyMarks& marks, std::string& content, std::string& shapes);
  void add_body(const bodies::Bodies& bodies, std::size_t b, bool is_part, std::int64_t& last_id, std::string& content,
                std::string& shapes);
  static std::array<double, 4> turn_nearest(const Quat& q, const Stored& body);
  void add_motion(const bodies::Bodies& bodies, NumberCoder& numbers);
  void add_marks(const bodies::Bodies& bodies, const BodyMarks& marks, NumberCoder& numbers);

  Shapes shapes_;
  std::vector<Stored> now_;
  double least_unit_ = 1;  ///< of all floes at the newest key frame
  int since_key_ = k_key_every;
};

}  // namespace nilas::output::replay
