#include "contact/detect/narrow_phase.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "contact/detect/broad/contact_key.h"
#include "contact/detect/broad/mirror_pair.h"
#include "contact/detect/fcl_contacts.h"
#include "contact/detect/search/cylinder_axis.h"
#include "contact/detect/search/way_out.h"
#include "contact/detect/surface/face_axes.h"
#include "contact/detect/surface/pair_points.h"
#include "contact/detect/surface/primitive_contacts.h"

namespace nilas::detect {

namespace {

/// A point on a gently curved patch has the normal of its own place. With one normal for all points, a body that slides
/// over a bow would sink into it by the sine of the difference. Steeper faces belong to ridges, where the pair's normal
/// serves.
const double k_most_slope = std::tan(k_grown_angle);

/// The remembered axis dismisses a pair only where it clears the margin by more than rounding. Without the memory the
/// pair would then have no contact either.
bool separated_by_memory(const bodies::Bodies& bodies, const Part& a, const Part& b, double margin,
                         const PairMemory& memory) {
  const Vec3& n = memory.separating;
  const Vec3 n_a = bodies.R_GB[a.body].transpose() * n;
  const Vec3 n_b = bodies.R_GB[b.body].transpose() * n;
  const Vec3 between = bodies.p_GB[b.body] - bodies.p_GB[a.body];
  const double s = n.dot(between) - extent(b, -n_b) - extent(a, n_a);
  return s > margin + k_coordinate_rounding * (a.bounding_radius + b.bounding_radius + between.norm());
}

using ContactPoints = std::vector<ContactPoint>;

/// Sorts points by key. Two features of one pair have the same key only if 64 bits collide; then the later key is
/// raised by one.
void order_by_key(std::span<ContactPoint> points) {
  std::sort(points.begin(), points.end(), [](const ContactPoint& p, const ContactPoint& q) { return p.key < q.key; });
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].key <= points[i - 1].key) points[i].key = points[i - 1].key + 1;
}

void primitive_pair(const bodies::Bodies& bodies, const Part& a, const Part& b, double margin, PairMemory& memory,
                    ContactPoints& points) {
  const bool a_hosts = a.kind == PartKind::plane || (a.kind != PartKind::sphere && b.kind == PartKind::sphere);
  const Part& host = a_hosts ? a : b;
  const Part& guest = a_hosts ? b : a;
  std::vector<LocalContact> contacts;
  const HostView view{host, guest, pose_of_b_in_a(bodies, host.body, guest.body), margin, memory.kept};
  if (host.kind == PartKind::plane)
    plane_contacts(view, contacts);
  else
    sphere_contacts(view, contacts);
  remember(contacts, contacts.size(), memory.kept);
  const std::uint64_t key = pair_key(bodies, a, b);
  const Mat3& R = bodies.R_GB[host.body];
  for (const LocalContact& contact : contacts) {
    if (host.cover && host.cover->hides(contact.p - 0.5 * contact.gap * contact.n, contact.n)) continue;
    ContactPoint& point = add_point(a, b, points);
    point.p = bodies.p_GB[host.body] + R * contact.p;
    point.n = a_hosts ? Vec3(R * contact.n) : Vec3(-(R * contact.n));
    point.gap = contact.gap;
    point.key = contact_key(key, contact.feature);
  }
}

/// Returns whether the pair had an axis at the last call, or a memory of one that was not proven.
bool was_seen(const PairMemory& memory) {
  return !memory.separating.isZero(0) || memory.contact_axis.kind != AxisKind::direction;
}

/// FCL's first direction shortens the search of many faces. Over few faces the search is the quicker of the two, so FCL
/// gives only new pairs their axis.
bool asks_fcl_first(const PairSearch& search, const Part& a, const Part& b, const PairMemory& memory) {
  return search.narrow == NarrowPhase::nilas && !(was_seen(memory) && has_few_faces(a) && has_few_faces(b));
}

/// Returns the depth by which the parts overlap where their contact is left to others [m], else 0.
double polytope_or_cylinder_pair(const bodies::Bodies& bodies, const Part& a, const Part& b, double margin,
                                 const PairSearch& search, AxisSearchRoom& room, PairMemory& memory,
                                 AxisSearchCounts& counts, ContactPoints& points, bool alone) {
  const PairView pair = view_pair(a, b, pose_of_b_in_a(bodies, a.body, b.body), margin);
  const bool both_faceted = a.facets && b.facets;
  const bool ask_first = asks_fcl_first(search, a, b, memory);
  Axis axis = both_faceted ? find_axis(pair, memory.contact_axis, search.fcl, ask_first, room, counts)
                           : find_cylinder_axis(pair, memory.contact_axis, search.fcl, ask_first, room, counts);
  const Mat3& R = bodies.R_GB[a.body];
  std::vector<Feature> last = std::move(memory.kept);
  memory = {};
  if (axis.s > margin) {
    memory.separating = R * axis.n;
    return 0;
  }
  bool across = false;  // mirror images that touch along the axis across the plane between them
  if (are_images(bodies, a, b)) {
    const Axis own = axis_across(bodies, pair);
    if (own.s > margin) return 0;
    across = serves_instead(own, axis);
    if (across) face_each_other(pair, axis = own, room.facing);
  }
  const double depth = axis.s < -pair.tolerance ? -axis.s : 0;
  memory.contact_axis.kind = AxisKind::unnamed;
  if ((a.cover || b.cover) && !find_way_out(pair, room, axis, alone)) return depth;
  const Vec3 n_G = R * axis.n;
  if (axis.proven && axis.kind != AxisKind::direction)
    memory.contact_axis = {axis.kind, axis.feature_a, axis.feature_b};
  const std::size_t kept = select_points(pair, axis, last, room.facing);
  remember(room.facing.points, kept, last);
  memory.kept = std::move(last);
  const std::uint64_t key = pair_key(bodies, a, b);
  const ContactPlane& plane = room.facing.plane;
  for (const OverlayPoint& p : room.facing.points) {
    ContactPoint& point = add_point(a, b, points);
    const Vec3 x = p.u * plane.t1 + p.v * plane.t2 + (p.height_a + 0.5 * p.gap) * plane.n;
    point.p = bodies.p_GB[a.body] + R * x;
    point.n = n_G;
    point.gap = p.gap;
    const bool deepest = p.gap <= axis.s + pair.tolerance;  // at the deepest point the axis itself is the normal
    if (across) {
      point.p.y() = middle_plane(bodies, a, b);
      point.n = Vec3(0, std::copysign(1.0, n_G.y()), 0);
    } else if (room.facing.curved && !deepest &&
               p.slope.u * p.slope.u + p.slope.v * p.slope.v <= k_most_slope * k_most_slope) {
      const Vec3 n = plane.n - p.slope.u * plane.t1 - p.slope.v * plane.t2;
      point.n = R * n.normalized();
      point.gap =
          std::max(p.gap / n.norm(), axis.s);  // no place of the surfaces is nearer than the separation along the axis
    }
    point.key = contact_key(key, p.feature);
  }
  return 0;
}

}  // namespace

namespace {

/// Finds contacts by Nilas' own search, for a pair that its memory does not separate.
PairContacts find_exact_contacts(const bodies::Bodies& bodies, const Part& a, const Part& b, double margin,
                                 const PairSearch& search, AxisSearchRoom& room, PairMemory& memory,
                                 ContactPoints& points, bool alone) {
  PairContacts out;
  const auto is_primitive = [](const Part& part) {
    return part.kind == PartKind::sphere || part.kind == PartKind::plane;
  };
  out.closed_form = is_primitive(a) || is_primitive(b);
  if (out.closed_form)
    primitive_pair(bodies, a, b, margin, memory, points);
  else
    out.left_depth = polytope_or_cylinder_pair(bodies, a, b, margin, search, room, memory, out.search, points, alone);
  return out;
}

}  // namespace

PairContacts find_pair_contacts(const bodies::Bodies& bodies, const Part& a, const Part& b, double margin,
                                const PairSearch& search, AxisSearchRoom& room, PairMemory& memory,
                                std::vector<ContactPoint>& points, bool alone) {
  PairContacts out;
  const std::size_t before = points.size();
  if (!memory.separating.isZero(0) && separated_by_memory(bodies, a, b, margin, memory)) {
    out.separated_by_memory = true;
    return out;
  }
  if (search.narrow == NarrowPhase::fcl) {
    out = find_fcl_contacts(bodies, a, b, margin, search.fcl, room, memory, points);
    if (out.search.fallbacks > 0) {
      const AxisSearchCounts asked = out.search;
      out = find_exact_contacts(bodies, a, b, margin, {NarrowPhase::nilas_alone, search.fcl}, room, memory, points,
                                alone);
      out.search = asked;
      ++out.search.corrected;
    }
  } else {
    out = find_exact_contacts(bodies, a, b, margin, search, room, memory, points, alone);
  }
  out.count = static_cast<int>(points.size() - before);
  order_by_key(std::span(points).subspan(before));
  return out;
}

}  // namespace nilas::detect
