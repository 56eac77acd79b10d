#include "contact/detect/fcl_contacts.h"

#include <algorithm>

#include "contact/detect/surface/pair_points.h"
#include "contact/detect/surface/primitive_contacts.h"

namespace nilas::detect {

namespace {

/// A point of the surfaces nearer than this to one of FCL's points is the same contact [share of the smaller part's
/// radius].
constexpr double k_same_place = 1e-3;

/// Contacts in the frame of one part. FCL's own contacts come first.
struct Manifold {
  std::vector<LocalContact> contacts;
  double deepest = 0;  ///< gap of FCL's deepest contact [m]

  explicit Manifold(const std::vector<FclContact>& found) : deepest(found.front().gap) {
    int name = 0;
    for (const FclContact& contact : found) {
      contacts.push_back({contact.p, contact.n, contact.gap, {FeatureKind::witness, name++, -1}});
      deepest = std::min(deepest, contact.gap);
    }
  }
  /// Adds the contact unless one of FCL's lies at the same place.
  void complete(LocalContact contact, double same_place) {
    const bool is_there = std::any_of(contacts.begin(), contacts.end(), [&](const LocalContact& c) {
      return c.feature.kind == FeatureKind::witness && (c.p - contact.p).norm() <= same_place;
    });
    contact.gap = std::max(contact.gap, deepest);
    if (!is_there) contacts.push_back(contact);
  }
};

/// Adds the points of the parts' surfaces along FCL's normal.
void add_surfaces(const PairView& pair, const FclContact& deepest, AxisSearchRoom& room, PairMemory& memory,
                  Manifold& manifold) {
  Axis axis;
  axis.n = deepest.n;
  axis.s = separation(pair, axis.n);
  if (axis.s > pair.margin) return;
  face_each_other(pair, axis, room.facing);
  const std::size_t kept = select_points(pair, axis, memory.kept, room.facing);
  remember(room.facing.points, kept, memory.kept);
  const ContactPlane& plane = room.facing.plane;
  for (const OverlayPoint& p : room.facing.points) {
    const Vec3 x = p.u * plane.t1 + p.v * plane.t2 + (p.height_a + 0.5 * p.gap) * plane.n;
    manifold.complete({x, axis.n, p.gap, p.feature}, k_same_place * pair.size);
  }
}

bool hides(const Part& part, const Vec3& x, const Vec3& outward) { return part.cover && part.cover->hides(x, outward); }

/// Contacts in the frame of `host`, with normals from it to `guest`.
struct HostedContacts {
  const bodies::Bodies& bodies;
  const Part& host;
  const Part& guest;

  bool hidden(const LocalContact& c, const RelativePose& host_in_guest) const {
    return hides(host, c.p - 0.5 * c.gap * c.n, c.n) ||
           hides(guest, host_in_guest.point(c.p + 0.5 * c.gap * c.n), -(host_in_guest.R * c.n));
  }

  /// Appends the contacts that are not hidden, with a and b in the order of their bodies. Returns false when none is
  /// left.
  bool add(const std::vector<LocalContact>& contacts, std::vector<ContactPoint>& points) const {
    const bool host_is_a = host.body < guest.body;
    const Part &a = host_is_a ? host : guest, &b = host_is_a ? guest : host;
    const std::uint64_t key = pair_key(bodies, a, b);
    const RelativePose host_in_guest = pose_of_b_in_a(bodies, guest.body, host.body);
    const Mat3& R = bodies.R_GB[host.body];
    bool any = false;
    for (const LocalContact& contact : contacts) {
      if (hidden(contact, host_in_guest)) continue;
      any = true;
      ContactPoint& point = add_point(a, b, points);
      point.p = bodies.p_GB[host.body] + R * contact.p;
      point.n = host_is_a ? Vec3(R * contact.n) : Vec3(-(R * contact.n));
      point.gap = contact.gap;
      point.key = contact_key(key, contact.feature);
    }
    return any;
  }
};

PairContacts with_plane(const bodies::Bodies& bodies, const Part& plane, const Part& guest, double margin,
                        FclShapes& fcl, PairMemory& memory, std::vector<ContactPoint>& points) {
  PairContacts out;
  ++out.search.fcl_queries;
  const RelativePose guest_in_plane = pose_of_b_in_a(bodies, plane.body, guest.body);
  bool failed = false;
  const std::vector<FclContact> found = fcl.plane_contacts(guest, guest_in_plane, margin, failed);
  ++(failed ? out.search.fallbacks : out.search.by_fcl);
  if (found.empty()) return out;
  Manifold manifold(found);
  if (guest.kind != PartKind::sphere) {
    std::vector<LocalContact> corners;
    nilas::detect::plane_contacts({plane, guest, guest_in_plane, margin, memory.kept}, corners);
    remember(corners, corners.size(), memory.kept);
    for (const LocalContact& corner : corners) manifold.complete(corner, k_same_place * guest.bounding_radius);
  }
  HostedContacts{bodies, plane, guest}.add(manifold.contacts, points);
  return out;
}

}  // namespace

PairContacts find_fcl_contacts(const bodies::Bodies& bodies, const Part& a, const Part& b, double margin,
                               FclShapes& fcl, AxisSearchRoom& room, PairMemory& memory,
                               std::vector<ContactPoint>& points) {
  if (a.kind == PartKind::plane) return with_plane(bodies, a, b, margin, fcl, memory, points);
  if (b.kind == PartKind::plane) return with_plane(bodies, b, a, margin, fcl, memory, points);
  PairContacts out;
  ++out.search.fcl_queries;
  const PairView pair = view_pair(a, b, pose_of_b_in_a(bodies, a.body, b.body), margin);
  memory.separating = Vec3::Zero();
  const std::vector<FclContact> found = fcl.contacts(pair);
  ++(found.empty() ? out.search.fallbacks : out.search.by_fcl);
  if (found.empty()) return out;
  const FclContact& deepest = *std::min_element(found.begin(), found.end(),
                                                [](const FclContact& p, const FclContact& q) { return p.gap < q.gap; });
  if (deepest.gap >= margin) {
    if (separation(pair, deepest.n) > margin) memory.separating = bodies.R_GB[a.body] * deepest.n;
    return out;
  }
  Manifold manifold(found);
  const bool round = a.kind == PartKind::sphere || b.kind == PartKind::sphere;
  if (!round) add_surfaces(pair, deepest, room, memory, manifold);
  if (!HostedContacts{bodies, a, b}.add(manifold.contacts, points) && deepest.gap < -pair.tolerance)
    out.left_depth = -deepest.gap;
  return out;
}

}  // namespace nilas::detect
