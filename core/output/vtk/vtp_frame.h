#pragma once
/// The surfaces of bodies at one instant as a ParaView PolyData document.
#include <cstdint>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/output/vtk/body_surface.h"

namespace nilas::output {

/// Facets of bodies in G. Kept between frames, so that arrays are allocated once.
class VtpFrame {
 public:
  /// Empties the frame. `with_damage`: bodies added next have `damage`.
  void clear(bool with_damage = false);
  /// Adds body `b`. Each of its facets has `id`, `kind` (0 floe, 1 vessel, 2 rigid body, 3 wall), `thickness_m` (0
  /// unless a plate), `speed_m_s` and `velocity_m_s` of the centre of mass. The field data `body_id` and `body_name`
  /// list the bodies.
  void add(const bodies::Bodies& bodies, std::size_t b, const PolygonSurface& surface, double damage = 0);
  /// The document as text, valid until the next call.
  const std::string& document();

 private:
  std::vector<float> points_, thickness_, damage_, speed_, velocity_;
  std::vector<std::int32_t> corners_, ends_;
  std::vector<std::int64_t> id_, body_id_;
  std::vector<std::string> body_name_;
  std::vector<std::uint8_t> kind_;
  bool with_damage_ = false;
  std::string text_;
};

}  // namespace nilas::output
