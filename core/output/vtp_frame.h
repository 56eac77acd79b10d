#pragma once
/// The surfaces of all bodies at one instant as a ParaView PolyData document.
#include <cstdint>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/output/body_surface.h"

namespace nilas {

/// Facets of all bodies in G. Kept between frames, so that the arrays are allocated once.
class VtpFrame {
 public:
  void clear();
  /// Adds body `b`; each of its facets carries its `id`, `kind` (0 floe, 1 vessel, 2 rigid body, 3 wall), `speed_m_s`
  /// and `velocity_m_s` of the centre of mass.
  void add(const Bodies& bodies, std::size_t b, const PolygonSurface& surface);
  /// The document; valid until the next call.
  const std::string& document();

 private:
  std::vector<float> points_, speed_, velocity_;
  std::vector<std::int32_t> corners_, ends_;
  std::vector<std::int64_t> id_;
  std::vector<std::uint8_t> kind_;
  std::string text_;
};

}  // namespace nilas
