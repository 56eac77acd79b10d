#pragma once
/// The contacts of a replay frame as bytes. Sums over pairs of bodies are stored as differences from the frame before,
/// seen from the first body.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/output/replay/contacts.h"
#include "core/output/replay/frame.h"
#include "core/output/replay/number_coder.h"

namespace nilas::output::replay {

class ContactWriter {
 public:
  /// Appends islands and exact contacts to the content of a frame, whose bodies `frames` has, and pairs to `numbers`.
  void add(const FrameContacts& list, const bodies::Bodies& bodies, const BodyFrames& frames, std::string& content,
           NumberCoder& numbers);

 private:
  static constexpr std::size_t k_numbers = 8;
  /// A pair by the identities of its bodies, with what is stored of it.
  struct Pair {
    std::int64_t first = 0, second = 0;
    std::array<std::int64_t, k_numbers> numbers{};
    std::array<std::uint8_t, k_numbers> digits = none();  ///< of the newest differences
    std::uint8_t status = k_no_past;
    const FrameContact* contact = nullptr;  ///< in the newest frame

    static constexpr std::array<std::uint8_t, k_numbers> none() {
      std::array<std::uint8_t, k_numbers> digits{};
      digits.fill(k_no_past);
      return digits;
    }
  };

  void add_pairs(const std::vector<const FrameContact*>& now, const bodies::Bodies& bodies, const BodyFrames& frames,
                 NumberCoder& numbers);
  std::vector<Pair> kept(const std::vector<const FrameContact*>& now, const bodies::Bodies& bodies,
                         NumberCoder& numbers) const;

  std::vector<Pair> pairs_;  ///< of the frame before, in their order there
};

}  // namespace nilas::output::replay
