#include "contact/solvers/bodies/cone_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/solvers/linear/wide_clones.h"

namespace nilas::solvers {

namespace {

/// Three lists of numbers that are read.
struct Read {
  const double *n, *t1, *t2;
  Read(const ContactVectors& v, std::size_t first)
      : n(v.row[0].data() + first), t1(v.row[1].data() + first), t2(v.row[2].data() + first) {}
};

/// Three lists that are written.
struct Written {
  double *n, *t1, *t2;
  Written(ContactVectors& v, std::size_t first)
      : n(v.row[0].data() + first), t1(v.row[1].data() + first), t2(v.row[2].data() + first) {}
};

struct WrittenMatrices {
  double *m00, *m10, *m20, *m11, *m21, *m22;
  WrittenMatrices(ContactMatrices& m, std::size_t first)
      : m00(m.entry[0].data() + first),
        m10(m.entry[1].data() + first),
        m20(m.entry[2].data() + first),
        m11(m.entry[3].data() + first),
        m21(m.entry[4].data() + first),
        m22(m.entry[5].data() + first) {}
};

/// A point that rounding put on the boundary counts as inside by this share of its length.
constexpr double k_hair = 4e-16;
/// Relative rounding of a discriminant.
constexpr double k_rounding = 1e-14;

/// Contacts whose least numbers are found together.
constexpr std::size_t k_batch = 256;

std::ptrdiff_t size_of(ContactRange range) { return static_cast<std::ptrdiff_t>(range.last - range.first); }

/// Calls body(part) for the parts of a range that fit into a batch.
template <class Body>
void in_batches(ContactRange range, const Body& body) {
  for (std::size_t first = range.first; first < range.last; first += k_batch)
    body(ContactRange{first, std::min(range.last, first + k_batch)});
}

/// Fills `least` with the smaller of the two distances to the cones' sides, a hair added.
NILAS_WIDE_CLONES void scale_all(std::ptrdiff_t count, Read x, Read y, Written p, Written l, double* b,
                                 WrittenMatrices q, double* least) {
  NILAS_INDEPENDENT
  for (std::ptrdiff_t c = 0; c < count; ++c) {
    const double xt = std::sqrt(x.t1[c] * x.t1[c] + x.t2[c] * x.t2[c]);
    const double yt = std::sqrt(y.t1[c] * y.t1[c] + y.t2[c] * y.t2[c]);
    const double x_hair = k_hair * x.n[c], y_hair = k_hair * y.n[c];
    const double x_margin = x.n[c] - xt > x_hair ? x.n[c] - xt : x_hair;
    const double y_margin = y.n[c] - yt > y_hair ? y.n[c] - yt : y_hair;
    const double x_root = std::sqrt(x_margin * (x.n[c] + xt)), y_root = std::sqrt(y_margin * (y.n[c] + yt));
    const double x_unit = 1 / x_root, y_unit = 1 / y_root;
    const double xn = x.n[c] * x_unit, x1 = x.t1[c] * x_unit, x2 = x.t2[c] * x_unit;
    const double yn = y.n[c] * y_unit, y1 = y.t1[c] * y_unit, y2 = y.t2[c] * y_unit;
    const double g = std::sqrt(0.5 * (1 + (xn * yn + (x1 * y1 + x2 * y2)))), half = 0.5 / g;
    const double wn = (xn + yn) * half, w1 = (x1 - y1) * half, w2 = (x2 - y2) * half;
    const double square = x_root * y_unit, root = std::sqrt(square), stretch = 1 / std::sqrt(2 * (wn + 1));
    const double pn = (wn + 1) * stretch, p1 = w1 * stretch, p2 = w2 * stretch;
    const double along = 2 * (pn * y.n[c] + (p1 * y.t1[c] + p2 * y.t2[c]));
    b[c] = root;
    p.n[c] = pn;
    p.t1[c] = p1;
    p.t2[c] = p2;
    l.n[c] = root * (along * pn - y.n[c]);
    l.t1[c] = root * (along * p1 + y.t1[c]);
    l.t2[c] = root * (along * p2 + y.t2[c]);
    q.m00[c] = square * (2 * wn * wn - 1);
    q.m10[c] = square * (2 * wn * w1);
    q.m20[c] = square * (2 * wn * w2);
    q.m11[c] = square * (2 * w1 * w1 + 1);
    q.m21[c] = square * (2 * w1 * w2);
    q.m22[c] = square * (2 * w2 * w2 + 1);
    const double x_inside = x.n[c] - xt + x_hair, y_inside = y.n[c] - yt + y_hair;
    least[c] = x_inside < y_inside ? x_inside : y_inside;
  }
}

/// T a for one contact, by components.
struct Scaled {
  double n, t1, t2;
};
inline Scaled times_one(double b, double pn, double p1, double p2, double n, double t1, double t2) {
  const double along = 2 * (pn * n + (p1 * t1 + p2 * t2));
  return {b * (along * pn - n), b * (along * p1 + t1), b * (along * p2 + t2)};
}

/// out = T (g + sign T a)
NILAS_WIDE_CLONES void twice_all(std::ptrdiff_t count, Read p, const double* b, double sign, Read g, Read a,
                                 Written out) {
  NILAS_INDEPENDENT
  for (std::ptrdiff_t c = 0; c < count; ++c) {
    const Scaled in = times_one(b[c], p.n[c], p.t1[c], p.t2[c], a.n[c], a.t1[c], a.t2[c]);
    const Scaled t =
        times_one(b[c], p.n[c], p.t1[c], p.t2[c], g.n[c] + sign * in.n, g.t1[c] + sign * in.t1, g.t2[c] + sign * in.t2);
    out.n[c] = t.n;
    out.t1[c] = t.t1;
    out.t2[c] = t.t2;
  }
}

NILAS_WIDE_CLONES void correct_all(std::ptrdiff_t count, Read p, const double* b, Read l, Read dx, Read dy,
                                   double target, Written g) {
  NILAS_INDEPENDENT
  for (std::ptrdiff_t c = 0; c < count; ++c) {
    const Scaled v = times_one(1 / b[c], p.n[c], -p.t1[c], -p.t2[c], dx.n[c], dx.t1[c], dx.t2[c]);
    const Scaled w = times_one(b[c], p.n[c], p.t1[c], p.t2[c], dy.n[c], dy.t1[c], dy.t2[c]);
    const double rn = target - (v.n * w.n + (v.t1 * w.t1 + v.t2 * w.t2));
    const double r1 = -(v.n * w.t1 + w.n * v.t1), r2 = -(v.n * w.t2 + w.n * v.t2);
    const double lt = std::sqrt(l.t1[c] * l.t1[c] + l.t2[c] * l.t2[c]);
    const double det = (l.n[c] - lt) * (l.n[c] + lt), inverse = 1 / l.n[c];
    const double first = (l.n[c] * rn - (l.t1[c] * r1 + l.t2[c] * r2)) / det;
    g.n[c] = first - l.n[c];
    g.t1[c] = (r1 - first * l.t1[c]) * inverse - l.t1[c];
    g.t2[c] = (r2 - first * l.t2[c]) * inverse - l.t2[c];
  }
}

/// Fills `longest` with the step of each contact to its boundary, beyond all numbers where there is none.
NILAS_WIDE_CLONES void steps_to_boundary(std::ptrdiff_t count, Read x, Read dx, double* longest) {
  NILAS_INDEPENDENT
  for (std::ptrdiff_t c = 0; c < count; ++c) {
    const double xt = std::sqrt(x.t1[c] * x.t1[c] + x.t2[c] * x.t2[c]);
    const double hair = k_hair * x.n[c], margin = x.n[c] - xt > hair ? x.n[c] - xt : hair;
    const double start = margin * (x.n[c] + xt);
    const double half = x.n[c] * dx.n[c] - (x.t1[c] * dx.t1[c] + x.t2[c] * dx.t2[c]);
    const double bend = dx.n[c] * dx.n[c] - (dx.t1[c] * dx.t1[c] + dx.t2[c] * dx.t2[c]);
    const double inside = half * half - bend * start;
    const double divisor = std::sqrt(inside > 0 ? inside : 0) - half;
    const bool meets = inside >= -k_rounding * (half * half);  // a half line meets its end with inside = 0
    longest[c] = meets && divisor > 0 ? start / divisor : HUGE_VAL;
  }
}

NILAS_WIDE_CLONES void move_all(std::ptrdiff_t count, Read dx, double t, Written x) {
  NILAS_INDEPENDENT
  for (std::ptrdiff_t c = 0; c < count; ++c) {
    x.n[c] += t * dx.n[c];
    x.t1[c] += t * dx.t1[c];
    x.t2[c] += t * dx.t2[c];
  }
}

}  // namespace

bool scale(const ContactVectors& x, const ContactVectors& y, ConeScaling& scaling, ContactRange range) {
  bool is_inside = true;
  in_batches(range, [&](ContactRange part) {
    std::array<double, k_batch> least;
    const std::size_t at = part.first;
    double* const b = scaling.b.data() + at;
    scale_all(size_of(part), {x, at}, {y, at}, {scaling.p, at}, {scaling.scaled, at}, b, {scaling.squared, at},
              least.data());
    is_inside = is_inside &&
                std::all_of(least.data(), least.data() + size_of(part), [](double margin) { return margin > 0; }) &&
                std::all_of(b, b + size_of(part), [](double one) { return std::isfinite(one); });
  });
  return is_inside;
}

void from_dual(const ConeScaling& scaling, const ContactVectors& g, const ContactVectors& a, ContactVectors& out,
               ContactRange range) {
  const std::size_t at = range.first;
  twice_all(size_of(range), {scaling.p, at}, scaling.b.data() + at, 1, {g, at}, {a, at}, {out, at});
}

void to_primal(const ConeScaling& scaling, const ContactVectors& g, const ContactVectors& a, ContactVectors& out,
               ContactRange range) {
  const std::size_t at = range.first;
  twice_all(size_of(range), {scaling.p, at}, scaling.b.data() + at, -1, {g, at}, {a, at}, {out, at});
}

void corrected(const ConeScaling& scaling, const ContactVectors& dx, const ContactVectors& dy, double target,
               ContactVectors& g, ContactRange range) {
  const std::size_t at = range.first;
  correct_all(size_of(range), {scaling.p, at}, scaling.b.data() + at, {scaling.scaled, at}, {dx, at}, {dy, at}, target,
              {g, at});
}

double longest_step(const ContactVectors& x, const ContactVectors& dx, ContactRange range) {
  double least = 1;
  in_batches(range, [&](ContactRange part) {
    std::array<double, k_batch> longest;
    steps_to_boundary(size_of(part), {x, part.first}, {dx, part.first}, longest.data());
    for (std::ptrdiff_t c = 0; c < size_of(part); ++c) least = std::min(least, longest[c]);
  });
  return least;
}

double gap_after(const ContactVectors& x, const ContactVectors& y, const ContactVectors& dx, const ContactVectors& dy,
                 double t) {
  double sum = 0;
  for (std::size_t c = 0; c < x.row[0].size(); ++c)
    for (std::size_t i = 0; i < 3; ++i) sum += (x.row[i][c] + t * dx.row[i][c]) * (y.row[i][c] + t * dy.row[i][c]);
  return sum;
}

void move(const ContactVectors& dx, double t, ContactVectors& x, ContactRange range) {
  move_all(size_of(range), {dx, range.first}, t, {x, range.first});
}

}  // namespace nilas::solvers
