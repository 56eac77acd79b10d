#include "contact/elastic_contacts.h"

#include <algorithm>
#include <tuple>

#include "contact/detect/broad/contact_key.h"
#include "contact/law/cone.h"
#include "core/base/order_free_sum.h"

namespace nilas::contact {

namespace {

double half_square(double k, double x) { return 0.5 * k * x * x; }

std::uint64_t patch_name(const bodies::Bodies& bodies, const detect::ContactPoint& point) {
  const auto word = [](auto x) { return static_cast<std::uint64_t>(x); };
  const std::uint64_t pair = detect::mix(word(bodies.id[point.a]), word(bodies.id[point.b]));
  return detect::mix(pair, word(point.part_a) << 32 | word(point.part_b));
}

bool same_patch(const detect::ContactPoint& p, const detect::ContactPoint& q) {
  return std::tie(p.a, p.b, p.part_a, p.part_b) == std::tie(q.a, q.b, q.part_a, q.part_b);
}

/// Normal stiffness of a patch; 0 where it is rigid [N/m].
double patch_stiffness(const Elasticity& elastic, double edge_a, double edge_b) {
  if (elastic.stiffness > 0) return elastic.stiffness;
  const double softness = (edge_a > 0 ? 1 / edge_a : 0) + (edge_b > 0 ? 1 / edge_b : 0);
  return softness > 0 ? elastic.edge_factor / softness : 0;
}

/// T with which two masses on a spring have this share of critical damping [s].
double retardation(const bodies::Bodies& bodies, const detect::ContactPoint& point, double damping_ratio,
                   double stiffness) {
  const auto inverse = [&](int body) { return bodies.moves(body) ? 1 / bodies.mass[body] : 0; };
  return 2 * damping_ratio / std::sqrt(stiffness * (inverse(point.a) + inverse(point.b)));
}

Vec3 in_plane(const Vec3& stretch, const Vec3& n, double length) {
  const Vec3 along = stretch - n.dot(stretch) * n;
  const double left = along.norm();
  return left > 0 ? Vec3(length / left * along) : Vec3(Vec3::Zero());
}

/// A spring that is stretched in the frames of both bodies, as they now are in G.
Vec3 carried(const bodies::Bodies& bodies, const detect::ContactPoint& point, const Vec3& on_a, const Vec3& on_b) {
  return 0.5 * (bodies.R_GB[point.a] * on_a + bodies.R_GB[point.b] * on_b);
}

}  // namespace

SpringRow spring_row(const Spring& spring, double gap, const Mat3& C, double h) {
  const double lag = h + spring.retardation;
  SpringRow row;
  row.compliance = 1 / (spring.normal * h * lag);
  row.tangential_compliance = 1 / (spring.tangential * h * lag);
  const double compression = spring.compression(gap);
  row.bias = C.transpose() * spring.stretch / lag;
  row.bias[0] = -compression / (compression > 0 ? lag : h);
  return row;
}

SpringStep spring_step(const Spring& spring, double gap, const Mat3& C, double h, const Vec3& r, const Vec3& u,
                       double bound, double d) {
  SpringStep out{.exists = true};
  const double before = std::max(0.0, spring.compression(gap));
  const double after = std::max(0.0, spring.compression(gap) - h * u[0]);
  const Vec2 stretch = (C.transpose() * spring.stretch).tail<2>();
  const double held = half_square(spring.normal, before) + 0.5 * spring.tangential * stretch.squaredNorm();
  out.stored = half_square(spring.normal, after);
  if (r[0] <= 0) {
    out.damping = std::max(0.0, held - out.stored);
    return out;
  }
  const double dashpot = spring.normal * spring.retardation / h;
  const Vec2 friction = r.tail<2>(), slide = u.tail<2>();
  const Vec2 held_rate = -(friction / (spring.tangential * h) + stretch) / (h + spring.retardation);
  const bool sticks = (d * friction - (slide - held_rate)).norm() <= d * bound;
  const Vec2 rate = sticks ? slide : held_rate;
  const Vec2 reached = stretch + h * rate;
  out.stretch = C.rightCols<2>() * reached;
  out.stored += 0.5 * spring.tangential * reached.squaredNorm();
  out.damping =
      dashpot * (after - before) * (after - before) + spring.tangential * spring.retardation * h * rate.squaredNorm();
  out.friction = -friction.dot(slide - rate);
  return out;
}

Vec3 ElasticContacts::mean_stretch(const bodies::Bodies& bodies, const detect::ContactPoint& point, std::size_t first,
                                   std::size_t last) const {
  OrderFreeVectorSum on_a, on_b;
  for (std::size_t k = first; k < last; ++k) {
    on_a.add(sorted_[by_patch_[k].kept].on_a);
    on_b.add(sorted_[by_patch_[k].kept].on_b);
  }
  const double count = static_cast<double>(last - first);
  const Vec3 mean_a = on_a.value() / count, mean_b = on_b.value() / count;
  return in_plane(carried(bodies, point, mean_a, mean_b), point.n, 0.5 * (mean_a.norm() + mean_b.norm()));
}

/// Fills rest and stretch of a point's spring from the last step.
void ElasticContacts::recall(const bodies::Bodies& bodies, const detect::ContactPoint& point, Spring& spring) const {
  const double overlap = std::max(0.0, -point.gap);
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), point.key,
                                      [](const Kept& kept, std::uint64_t key) { return kept.key < key; });
  if (found != sorted_.end() && found->key == point.key) {
    spring.rest = std::min(found->rest, overlap);
    spring.stretch = in_plane(carried(bodies, point, found->on_a, found->on_b), point.n,
                              0.5 * (found->on_a.norm() + found->on_b.norm()));
    return;
  }
  const auto less = [](const Patch& patch, const Patch& other) { return patch.name < other.name; };
  const auto [first, last] =
      std::equal_range(by_patch_.begin(), by_patch_.end(), Patch{patch_name(bodies, point), 0}, less);
  spring.rest = overlap;
  if (first == last) return;
  for (auto of_patch = first; of_patch != last; ++of_patch)
    spring.rest = std::min(spring.rest, sorted_[of_patch->kept].rest);
  spring.stretch = mean_stretch(bodies, point, static_cast<std::size_t>(first - by_patch_.begin()),
                                static_cast<std::size_t>(last - by_patch_.begin()));
}

std::vector<Spring> ElasticContacts::springs(const bodies::Bodies& bodies,
                                             const std::vector<detect::ContactPoint>& points,
                                             const FrictionPairs& friction, const std::vector<double>& edge) const {
  std::vector<Spring> springs(points.size());
  for (std::size_t first = 0; first < points.size();) {
    const detect::ContactPoint& point = points[first];
    std::size_t last = first;
    double sharing = 0;
    for (; last < points.size() && same_patch(point, points[last]); ++last) sharing += points[last].crushes() ? 0 : 1;
    const auto& elastic = friction.of(bodies.material[point.a], bodies.material[point.b]).elastic;
    const double whole = elastic ? patch_stiffness(*elastic, edge[point.a], edge[point.b]) : 0;
    for (std::size_t i = first; i < last && whole > 0; ++i) {
      if (points[i].crushes()) continue;
      springs[i].normal = whole / sharing;
      springs[i].tangential = elastic->tangential_ratio * springs[i].normal;
      springs[i].retardation = retardation(bodies, point, elastic->damping_ratio, whole);
      recall(bodies, points[i], springs[i]);
    }
    first = last;
  }
  return springs;
}

void ElasticContacts::keep(const bodies::Bodies& bodies, const std::vector<detect::ContactPoint>& points,
                           const std::vector<Spring>& springs, const std::vector<SpringStep>& steps) {
  sorted_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!springs[i].exists()) continue;
    const detect::ContactPoint& point = points[i];
    const Vec3& stretch = steps[i].stretch;
    sorted_.push_back({point.key, patch_name(bodies, point), springs[i].rest,
                       bodies.R_GB[point.a].transpose() * stretch, bodies.R_GB[point.b].transpose() * stretch});
  }
  std::sort(sorted_.begin(), sorted_.end(), [](const Kept& a, const Kept& b) { return a.key < b.key; });
  list_patches();
}

void ElasticContacts::list_patches() {
  by_patch_.clear();
  for (std::size_t k = 0; k < sorted_.size(); ++k) by_patch_.push_back({sorted_[k].patch, k});
  std::sort(by_patch_.begin(), by_patch_.end(),
            [](const Patch& a, const Patch& b) { return std::tie(a.name, a.kept) < std::tie(b.name, b.kept); });
}

void ElasticContacts::save(StateWriter out) const {
  std::vector<std::uint64_t> keys, patches;
  std::vector<double> rests;
  std::vector<Vec3> on_a, on_b;
  for (const Kept& kept : sorted_) {
    keys.push_back(kept.key);
    patches.push_back(kept.patch);
    rests.push_back(kept.rest);
    on_a.push_back(kept.on_a);
    on_b.push_back(kept.on_b);
  }
  out.add("key", keys);
  out.add("patch", patches);
  out.add("rest", rests);
  out.add("stretch_on_a", on_a);
  out.add("stretch_on_b", on_b);
}

void ElasticContacts::restore(const StateReader& in) {
  std::vector<std::uint64_t> keys, patches;
  std::vector<double> rests;
  std::vector<Vec3> on_a, on_b;
  in.get("key", keys);
  in.get("patch", patches);
  in.get("rest", rests, keys.size());
  in.get("stretch_on_a", on_a, keys.size());
  in.get("stretch_on_b", on_b, keys.size());
  if (patches.size() != keys.size()) in.refuse("patch", "it has another length than key");
  sorted_.clear();
  for (std::size_t k = 0; k < keys.size(); ++k) sorted_.push_back({keys[k], patches[k], rests[k], on_a[k], on_b[k]});
  list_patches();
}

}  // namespace nilas::contact
