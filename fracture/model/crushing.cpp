#include "fracture/model/crushing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "contact/detect/broad/contact_key.h"
#include "core/base/order_free_sum.h"
#include "core/geometry/mass_properties.h"

namespace nilas::fracture {

namespace {

/// An axis has one point where the radius of gyration is below this share of the square root of the whole area [-].
constexpr double k_point_share = 0.1;
/// Normal speeds below this share of the relative velocity count as rest, since a face's normal is rounded [-].
constexpr double k_rest_share = 1e-12;
/// The number of halvings that find the time at which a face first touches ice, within 1e-9 of the step.
constexpr int k_touch_halvings = 30;

/// The motion of a body with velocities that are constant over the step.
struct Moving {
  Vec3 p, v, w;
  Mat3 R;

  Moving(const bodies::Bodies& bodies, int body)
      : p(bodies.p_GB[body]), v(bodies.v_GB[body]), w(bodies.w_GB[body]), R(bodies.R_GB[body]) {
    if (bodies.motion[body] != bodies::Motion::fixed) return;
    v.setZero();
    w.setZero();
  }
  Placement after(double t) const {
    const double angle = t * w.norm();
    if (angle == 0) return {R, p + t * v};
    return {Mat3(Eigen::AngleAxisd(angle, w.normalized())) * R, p + t * v};
  }
  Vec3 velocity_at(const Vec3& x) const { return v + w.cross(x - p); }
  Vec3 in_body(const Vec3& x_G) const { return R.transpose() * (x_G - p); }
};

/// Whether a ball may reach into one of the convex parts.
bool reaches(const std::vector<geometry::ConvexPolytope>& parts, const Vec3& centre, double radius) {
  return std::any_of(parts.begin(), parts.end(), [&](const geometry::ConvexPolytope& part) {
    for (std::size_t f = 0; f < part.normals.size(); ++f)
      if (part.normals[f].dot(centre) - part.offsets[f] > radius) return false;
    return true;
  });
}

/// The placement of frame a in frame b: x_b = R x_a + p.
Placement between(const Placement& a_in_G, const Placement& b_in_G) {
  return {b_in_G.R.transpose() * a_in_G.R, b_in_G.R.transpose() * (a_in_G.p - b_in_G.p)};
}

}  // namespace

/// A face with its areas at both ends of the step; one of them may be missing.
struct Crushing::FaceLoad {
  const FaceInIce* now = nullptr;
  const FaceInIce* next = nullptr;
  double pressure = 0;           ///< Pressure at the step's start, or at its end where only that has an area [Pa].
  double force = 0, growth = 0;  ///< Force at the step's start, and its growth until the end [N].

  const FaceInIce& face() const { return now ? *now : *next; }
};

struct Crushing::Pair {
  const CrushingSurface& hull;
  const bodies::Bodies& bodies;
  int floe;
  double h, ahead;
  Moving of_hull, of_floe;
  Placement present, next;                   ///< The hull in the floe now and at the step's end.
  std::vector<FaceInIce> faces, faces_next;  ///< Faces in ice then; faces_next only with an implicit law.
  double area = 0, area_next = 0;            ///< Areas of these faces [m^2].
  double pressing = 0, pressing_next = 0;    ///< Areas that the pressure depends on [m^2].
  double least = 0;                          ///< Least radius of gyration for two points on an axis [m].
  std::uint64_t key = 0;

  bool touches_now() const { return !faces.empty(); }
  bool touches() const { return !faces.empty() || !faces_next.empty(); }

  std::int64_t id(int body) const { return bodies.id[body]; }
  const std::vector<geometry::ConvexPolytope>& pieces() const { return bodies.shape[floe]->parts; }
  CrushedFace name(const FaceInIce& face) const { return {id(hull.body), id(floe), face.face, face.piece}; }
  Placement hull_in_floe(double t) const { return between(of_hull.after(t), of_floe.after(t)); }
  double pressing_area(const std::vector<FaceInIce>& in_ice) const;
  Vec3 place(const FaceLoad& load, const Vec3& x) const;
  double first_touch(const FaceInIce& face) const;
  detect::ContactPoint point_on(const FaceInIce& face) const;
};

/// The area that the pressure depends on [m^2]. Faces that slide along the ice or back off carry no load, and do not
/// spread the pressure. Where no face presses, at rest, all of them count.
double Crushing::Pair::pressing_area(const std::vector<FaceInIce>& in_ice) const {
  OrderFreeSum sum;
  for (const FaceInIce& face : in_ice) {
    const Vec3 x = of_floe.p + of_floe.R * face.centroid, into_ice = of_floe.R * face.normal;
    const Vec3 of_each_other = of_hull.velocity_at(x) - of_floe.velocity_at(x);
    if (of_each_other.dot(into_ice) > k_rest_share * of_each_other.norm()) sum.add(face.area);
  }
  return sum.value() > 0 ? sum.value() : total_area(in_ice);
}

/// The place in G of a point of the floe's frame [m]. Where the face reaches the ice only at the step's end, the
/// motions of both bodies carry the point back.
Vec3 Crushing::Pair::place(const FaceLoad& load, const Vec3& x) const {
  const Vec3 with_floe = of_floe.p + of_floe.R * x;
  if (load.now) return with_floe;
  return 0.5 * (with_floe + of_hull.p + of_hull.R * (next.R.transpose() * (x - next.p)));
}

/// The time at which a face touches ice that is out of it now and in it at the step's end [s].
double Crushing::Pair::first_touch(const FaceInIce& face) const {
  double out = 0, in = ahead;
  for (int k = 0; k < k_touch_halvings; ++k) {
    const double t = 0.5 * (out + in);
    const bool touches = face_in_ice(hull.faces[face.face], hull_in_floe(t), pieces()[face.piece]).has_value();
    (touches ? in : out) = t;
  }
  return in;
}

/// A contact point with the bodies, the normal and the key of the face.
detect::ContactPoint Crushing::Pair::point_on(const FaceInIce& face) const {
  const HullFace& surface = hull.faces[face.face];
  const Vec3 into_ice = of_hull.R * surface.normal;
  detect::ContactPoint point;
  point.a = hull.body;
  point.b = floe;
  point.part_a = surface.part;
  point.part_b = face.piece;
  point.n = into_ice;
  point.key =
      detect::mix(detect::mix(key, static_cast<std::uint64_t>(face.face)), static_cast<std::uint64_t>(face.piece));
  if (hull.body < floe) return point;
  std::swap(point.a, point.b);
  std::swap(point.part_a, point.part_b);
  point.n = -into_ice;
  return point;
}

Crushing::Crushing(const CrushingSettings& settings, const bodies::Bodies& bodies, const bodies::IceProperties& ice)
    : law_(settings.law), ice_(ice), between_floes_(settings.between_floes), clear_volume_(settings.clear_volume) {
  is_hull_.assign(bodies.id.size(), 0);
  for (int body = 0; body < bodies.size(); ++body) learn(bodies, body);
}

void Crushing::learn(const bodies::Bodies& bodies, int body) {
  const auto b = static_cast<std::size_t>(body);
  if (bodies.kind[b] != bodies::BodyKind::vessel && bodies.kind[b] != bodies::BodyKind::rigid) return;
  auto surface = crushing_surface(bodies, body);
  if (!surface) return;
  is_hull_[b] = 1;
  hulls_.push_back(std::move(*surface));
}

void Crushing::follow(const bodies::Bodies& bodies, const std::vector<NewPiece>& pieces) {
  for (const NewPiece& piece : pieces) {
    const geometry::Shape& shape = *bodies.shape[bodies.index_of(piece.id)];
    depth_.hand_on(piece.floe, piece.id, piece.place, static_cast<int>(shape.parts.size()));
  }
  is_hull_.assign(bodies.id.size(), 0);
  for (CrushingSurface& hull : hulls_) {
    const std::size_t b = bodies.index_of(hull.id);
    hull.body = static_cast<int>(b);
    is_hull_[b] = 1;
  }
  const auto is_there = [&](std::int64_t id) { return std::binary_search(bodies.id.begin(), bodies.id.end(), id); };
  std::erase_if(floes_, [&](const auto& floe) { return !is_there(floe.first); });
  std::erase_if(near_hulls_, [&](const Ids& ids) { return !is_there(ids.second); });
}

/// The surface of a floe, computed once and kept.
const CrushingSurface& Crushing::floe_surface(const bodies::Bodies& bodies, int floe) {
  CrushingSurface& surface = floes_[bodies.id[floe]];
  if (surface.parts.empty()) surface = crushing_surface(bodies, floe).value();
  surface.body = floe;
  return surface;
}

bool Crushing::crushes(int a, int b) const {
  if (between_floes_ && ice_.is_breakable(a) && ice_.is_breakable(b)) return true;
  return (is_hull(a) && ice_.is_breakable(b)) || (is_hull(b) && ice_.is_breakable(a));
}

/// The largest distance that a point of the body may move in a time [m].
static double way(const bodies::Bodies& bodies, std::size_t b, double time) {
  if (bodies.motion[b] == bodies::Motion::fixed) return 0;
  return time * (bodies.v_GB[b].norm() + bodies.w_GB[b].norm() * bodies.shape[b]->bounding_radius);
}

bool Crushing::balls_meet(const bodies::Bodies& bodies, int a, int b, double ahead) {
  const auto i = static_cast<std::size_t>(a), k = static_cast<std::size_t>(b);
  const double reach = bodies.shape[i]->bounding_radius + bodies.shape[k]->bounding_radius + way(bodies, i, ahead) +
                       way(bodies, k, ahead);
  return (bodies.p_GB[k] - bodies.p_GB[i]).norm() <= reach;
}

const CrushingSurface& Crushing::hull_of(int body) const {
  return *std::find_if(hulls_.begin(), hulls_.end(), [&](const CrushingSurface& hull) { return hull.body == body; });
}

/// Whether the floe's bounding ball, widened by both motions until the step's end, reaches a part of the hull.
bool Crushing::may_meet(const bodies::Bodies& bodies, const CrushingSurface& hull, int floe, double ahead) {
  const auto k = static_cast<std::size_t>(hull.body), b = static_cast<std::size_t>(floe);
  if (bodies.motion[k] == bodies::Motion::fixed && bodies.motion[b] == bodies::Motion::fixed) return false;
  const double reach = bodies.shape[b]->bounding_radius + way(bodies, k, ahead) + way(bodies, b, ahead);
  const Vec3 between = bodies.p_GB[b] - bodies.p_GB[k];
  if (between.norm() > bodies.shape[k]->bounding_radius + reach) return false;
  return reaches(hull.parts, bodies.R_GB[k].transpose() * between, reach);
}

std::vector<detect::ContactPoint> Crushing::points(const bodies::Bodies& bodies,
                                                   const std::vector<std::pair<int, int>>& near, double h,
                                                   double ahead) {
  std::vector<detect::ContactPoint> points;
  near_hulls_.clear();
  for (const auto& [a, b] : near) {
    if (!is_hull(a) && !is_hull(b)) {
      if (balls_meet(bodies, a, b, ahead)) add_floes(bodies, a, b, h, ahead, points);
      continue;
    }
    const CrushingSurface& hull = hull_of(is_hull(a) ? a : b);
    const int floe = is_hull(a) ? b : a;
    if (!may_meet(bodies, hull, floe, ahead)) continue;
    if (clear_volume_) near_hulls_.emplace(hull.id, bodies.id[floe]);
    add_pair(pair_of(bodies, hull, floe, h, ahead), points);
  }
  depth_.forget_others();
  faces_of_first_.swap(new_faces_of_first_);
  new_faces_of_first_.clear();
  return points;
}

double Crushing::pressure(const Pair& pair, const FaceInIce& face, const Placement& hull_in_floe, double total) const {
  double strength = ice_.compressive_strength[pair.floe].at(face.centroid);
  if (ice_.is_breakable(pair.hull.body)) {  // the weaker ice gives way
    const Vec3 place = hull_in_floe.R.transpose() * (face.centroid - hull_in_floe.p);
    strength = std::min(strength, ice_.compressive_strength[pair.hull.body].at(place));
  }
  return law_.pressure(strength, total);
}

Crushing::Pair Crushing::pair_of(const bodies::Bodies& bodies, const CrushingSurface& hull, int floe, double h,
                                 double ahead) const {
  Pair pair{hull, bodies, floe, h, ahead, Moving(bodies, hull.body), Moving(bodies, floe), {}, {}, {}, {}};
  pair.present = pair.hull_in_floe(0);
  pair.next = pair.hull_in_floe(ahead);
  pair.faces = faces_in_ice(hull.faces, pair.present, pair.pieces());
  if (law_.is_implicit()) pair.faces_next = faces_in_ice(hull.faces, pair.next, pair.pieces());
  pair.area = total_area(pair.faces);
  pair.area_next = total_area(pair.faces_next);
  const bool by_area = law_.model == CrushingModel::pressure_area;
  pair.pressing = by_area ? pair.pressing_area(pair.faces) : pair.area;
  pair.pressing_next = by_area ? pair.pressing_area(pair.faces_next) : pair.area_next;
  pair.least = k_point_share * std::sqrt(std::max(pair.area, pair.area_next));
  pair.key = detect::mix(detect::mix(0x6372757368ULL, static_cast<std::uint64_t>(pair.id(hull.body))),
                         static_cast<std::uint64_t>(pair.id(floe)));
  return pair;
}

void Crushing::add_pair(const Pair& pair, std::vector<detect::ContactPoint>& points) {
  for (const FaceLoad& load : loads_of(pair)) add_face(pair, load, points);
}

/// Leaves the net growth of a face. Area that moves from one piece of the floe to the next within the step is no
/// growth.
void Crushing::leave_net_growth(std::vector<FaceLoad>& loads, std::size_t first) {
  OrderFreeSum net, growing;
  for (std::size_t k = first; k < loads.size(); ++k) {
    net.add(loads[k].growth);
    growing.add(std::max(0.0, loads[k].growth));
  }
  const double share = net.value() > 0 ? net.value() / growing.value() : 0;
  for (std::size_t k = first; k < loads.size(); ++k) loads[k].growth = share * std::max(0.0, loads[k].growth);
}

std::vector<Crushing::FaceLoad> Crushing::loads_of(const Pair& pair) const {
  const std::vector<FaceInIce>&now = pair.faces, &next = pair.faces_next;
  std::vector<FaceLoad> loads;
  std::size_t of_face = 0;
  // both lists are in the order of faces and pieces
  for (auto i = now.begin(), j = next.begin(); i != now.end() || j != next.end();) {
    const auto place = [](const FaceInIce& face) { return std::pair(face.face, face.piece); };
    FaceLoad load;
    if (j == next.end() || (i != now.end() && place(*i) <= place(*j))) load.now = &*i;
    if (i == now.end() || (j != next.end() && place(*j) <= place(*i))) load.next = &*j;
    if (load.next) {
      load.pressure = pressure(pair, *j, pair.next, pair.pressing_next);
      load.growth = load.pressure * j++->area;
    }
    if (load.now) {
      load.pressure = pressure(pair, *i, pair.present, pair.pressing);
      load.force = load.pressure * i++->area;
    }
    if (!next.empty()) load.growth -= load.force;
    if (!loads.empty() && loads.back().face().face != load.face().face) {
      leave_net_growth(loads, of_face);
      of_face = loads.size();
    }
    loads.push_back(load);
  }
  leave_net_growth(loads, of_face);
  return loads;
}

/// Whether the faces of the first of two floes count: those with the smaller area in the other floe now, or at the
/// step's end where there is none now. Of equal areas the faces of the lighter floe count. Of equal masses those of the
/// floe with the smaller sum of principal moments of inertia count. Only if these are equal too does the order decide.
bool Crushing::first_counts(const Pair& of_first, const Pair& of_second) {
  constexpr double k_same = 1e-9;  // numbers nearer than this differ by rounding [-]
  const bool now = of_first.touches_now() || of_second.touches_now();
  const double a_in_b = now ? of_first.area : of_first.area_next, b_in_a = now ? of_second.area : of_second.area_next;
  // A floe that is wholly inside the other has no area of the other's surface in it.
  if (a_in_b == 0 || b_in_a == 0) return b_in_a == 0;
  const bodies::Bodies& bodies = of_first.bodies;
  const auto a = static_cast<std::size_t>(of_first.hull.body), b = static_cast<std::size_t>(of_second.hull.body);
  for (const auto& [of_a, of_b] : {std::pair(a_in_b, b_in_a), std::pair(bodies.mass[a], bodies.mass[b]),
                                   std::pair(bodies.inertia_B[a].trace(), bodies.inertia_B[b].trace())})
    if (std::abs(of_a - of_b) > k_same * std::max(of_a, of_b)) return of_a < of_b;
  return true;
}

/// Adds the points of two floes. The choice of the faces is remembered only for floes that touch now, so that it
/// depends neither on velocities nor on the step's length.
void Crushing::add_floes(const bodies::Bodies& bodies, int a, int b, double h, double ahead,
                         std::vector<detect::ContactPoint>& points) {
  const Ids ids(bodies.id[a], bodies.id[b]);
  const CrushingSurface &of_a = floe_surface(bodies, a), &of_b = floe_surface(bodies, b);
  const auto pair = [&](bool first) { return pair_of(bodies, first ? of_a : of_b, first ? b : a, h, ahead); };
  const auto add = [&](const Pair& of_one, bool first) {
    add_pair(of_one, points);
    if (of_one.touches_now()) new_faces_of_first_[ids] = first ? 1 : 0;
  };
  const auto known = faces_of_first_.find(ids);
  const bool was_first = known == faces_of_first_.end() || known->second != 0;
  const Pair one = pair(was_first);
  if (known != faces_of_first_.end() && one.touches_now()) return add(one, was_first);
  const Pair other = pair(!was_first);
  if (!one.touches() && !other.touches()) return;
  const Pair &first = was_first ? one : other, &second = was_first ? other : one;
  const bool takes_first = first_counts(first, second);
  add(takes_first ? first : second, takes_first);
}

void Crushing::add_face(const Pair& pair, const FaceLoad& load, std::vector<detect::ContactPoint>& points) {
  const FaceInIce& face = load.face();
  CrushedPlane crushed{face.normal, -std::numeric_limits<double>::infinity(), face.centroid};
  if (load.now) crushed = depth_.advance(pair.name(face), face.normal, face.centroid, std::sqrt(face.spread.trace()));
  const detect::ContactPoint of_face = pair.point_on(face);
  const Vec3 centre = pair.place(load, face.centroid);
  const Vec3 velocity = pair.of_hull.velocity_at(centre) - pair.of_floe.velocity_at(centre);
  const double rest = k_rest_share * velocity.norm();
  const auto add = [&](const Vec3& x, double limit, double compliance, int number) {
    detect::ContactPoint point = of_face;
    point.p = pair.place(load, x);
    point.gap = crushed.gap(x) + rest * pair.h;
    point.force_limit = limit;
    point.pressure = load.pressure;
    point.compliance = compliance;
    point.key = detect::mix(of_face.key, static_cast<std::uint64_t>(number));
    points.push_back(point);
  };
  if (load.force > 0) {
    const PressurePoints places = pressure_points(face, pair.least);
    for (int k = 0; k < places.count; ++k) add(places.points[k], load.force / places.count, 0, 1 + k);
  }
  const double closing = (pair.of_hull.R * pair.hull.faces[face.face].normal).dot(velocity);
  if (!(load.growth > 0 && closing > rest)) return;
  // The distance until the first touch is a gap, which closes in the same share of the step.
  const double out = load.now ? 0 : pair.first_touch(face) / pair.ahead;
  add(face.centroid, load.growth, (1 - out) * closing / (load.growth * pair.h), 0);
  points.back().gap += out * closing * pair.h;
}

void Crushing::note_crushed(const bodies::Bodies& bodies, const contact::StepMotion& motion) {
  std::map<int, double> densities;
  const auto density = [&](int body) {
    const auto [known, is_new] = densities.try_emplace(body, 0);
    const auto b = static_cast<std::size_t>(body);
    const geometry::Shape& shape = *bodies.shape[b];
    if (is_new) known->second = bodies.mass[b] / (geometry::polygon_moments(shape.outline).area * shape.thickness);
    return known->second;
  };
  OrderFreeSum crushed;
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const detect::ContactPoint& c = motion.points[i];
    if (!c.crushes() || c.pressure == 0) continue;
    const Vec3 twice =
        contact::relative_velocity(motion, motion.before, i) + contact::relative_velocity(motion, motion.after, i);
    const double work = -0.5 * motion.normal_impulses[i].dot(twice);
    const bool of_a = ice_.is_breakable(c.a), of_b = ice_.is_breakable(c.b);
    const double mean = of_a && of_b ? 0.5 * (density(c.a) + density(c.b)) : density(of_a ? c.a : c.b);
    crushed.add(mean * work / c.pressure);
  }
  crushed_mass_ += crushed.value();
}

void Crushing::save(StateWriter out) const {
  depth_.save(out.group("depth"));
  std::vector<std::int64_t> floes;
  for (const auto& [pair, first] : faces_of_first_) floes.insert(floes.end(), {pair.first, pair.second, first});
  out.add("floes", floes);
  out.add("crushed_mass", crushed_mass_);
}

void Crushing::restore(const StateReader& in) {
  depth_.restore(in.group("depth"));
  std::vector<std::int64_t> floes;
  in.get("floes", floes);
  constexpr std::size_t k_numbers = 3;
  if (floes.size() % k_numbers != 0) in.refuse("floes", "it has no whole number of pairs");
  faces_of_first_.clear();
  for (std::size_t k = 0; k < floes.size(); k += k_numbers)
    faces_of_first_[{floes[k], floes[k + 1]}] = floes[k + 2] != 0 ? 1 : 0;
  in.get("crushed_mass", crushed_mass_);
}

}  // namespace nilas::fracture
