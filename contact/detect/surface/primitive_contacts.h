#pragma once
/// Computes contacts in closed form: any shape with a plane or a sphere.
#include <span>
#include <vector>

#include "contact/detect/broad/contact_key.h"
#include "contact/detect/broad/pair_view.h"

namespace nilas::detect {

/// A contact point in the frame of one of the parts, its host.
struct LocalContact {
  Vec3 p = Vec3::Zero();   ///< midway between the surfaces
  Vec3 n = Vec3::UnitX();  ///< unit normal from the host to the guest
  double gap = 0;          ///< [m]
  Feature feature;         ///< features that touch
};

struct HostView {
  const Part& host;
  const Part& guest;
  RelativePose guest_in_host;
  double margin = 0;                ///< [m]
  std::span<const Feature> last{};  ///< features of the points kept at the last call (point_reduction.h)
};

/// Finds the contacts of the half space z < 0 of the host with any guest except a plane. A polytope or cylinder has up
/// to four points and the deeper ones that join them (point_reduction.h), a sphere has one.
void plane_contacts(const HostView& view, std::vector<LocalContact>& out);

/// Finds the contact of a sphere (guest) with a polytope, cylinder or sphere. It is one point along the line from the
/// nearest surface point to the sphere's centre. With the centre inside, it lies along the shortest exit.
void sphere_contacts(const HostView& view, std::vector<LocalContact>& out);

}  // namespace nilas::detect
