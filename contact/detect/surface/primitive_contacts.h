#pragma once
/// Contacts with closed forms: anything with a plane or a sphere.
#include <span>
#include <vector>

#include "contact/detect/broad/contact_key.h"
#include "contact/detect/broad/pair_view.h"

namespace nilas {

/// A contact point in the frame of one of the parts, its host.
struct LocalContact {
  Vec3 p = Vec3::Zero();   ///< midway between the surfaces
  Vec3 n = Vec3::UnitX();  ///< from the host to the guest
  double gap = 0;          ///< [m]
  Feature feature;         ///< what of the parts touches
};

struct HostView {
  const Part& host;
  const Part& guest;
  RelativePose guest_in_host;
  double margin = 0;                ///< [m]
  std::span<const Feature> last{};  ///< what was kept of the pair before (point_reduction.h)
};

/// Half space z < 0 of the host with any guest but a plane: up to four points of a polytope or cylinder and the deeper
/// ones that join them (point_reduction.h), one of a sphere.
void plane_contacts(const HostView& view, std::vector<LocalContact>& out);

/// Sphere (guest) on a polytope, cylinder or sphere: one point along the line from the surface point nearest to the
/// sphere's centre; with the centre inside, along the shortest way out.
void sphere_contacts(const HostView& view, std::vector<LocalContact>& out);

}  // namespace nilas
