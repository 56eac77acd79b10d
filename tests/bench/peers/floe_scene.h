#pragma once
/// The packed scene that all engines run: floes as prisms, a wedge hull that moves at constant speed, and four walls.
/// Engines without water get the same simple model: columns of buoyancy with heave damping, and linear drag to a
/// current.
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace peers {

struct Point {
  double x = 0, y = 0;
};

struct Floe {
  std::vector<Point> outline;  ///< Counter-clockwise, in principal axes about the centroid.
  Point centre;
  double yaw = 0, area = 0, mass = 0;
  std::array<double, 3> inertia{};
  std::vector<Point> column;  ///< Centroids of the triangles that carry buoyancy.
  std::vector<double> column_area;
};

struct FloeScene {
  double thickness = 0, density = 920, water = 1005, gravity = 9.81, friction = 0.15, step = 0.01;
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  ///< Positions of the walls [m].
  double current = 0;                     ///< Current along X [m/s].
  double hull_x = 0, hull_length = 0, hull_bow = 0, hull_beam = 0, hull_bottom = 0, hull_top = 0, hull_speed = 0;
  std::vector<Floe> floes;

  double mid_plane() const { return thickness * (0.5 - density / water); }
  std::vector<Point> hull_outline() const {
    const double b = 0.5 * hull_beam, s = hull_length - hull_bow;
    return {{0, -b}, {s, -b}, {hull_length, 0}, {s, b}, {0, b}};
  }
};

inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

/// Moves the outline to its centroid and principal axes, and fills in mass properties and buoyancy columns.
inline void prepare(Floe& f, double thickness, double density) {
  double area = 0, cx = 0, cy = 0;
  const std::size_t n = f.outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = f.outline[i], b = f.outline[(i + 1) % n];
    const double c = cross(a, b);
    area += c / 2;
    cx += (a.x + b.x) * c / 6;
    cy += (a.y + b.y) * c / 6;
  }
  f.area = area;
  f.centre = {cx / area, cy / area};
  double xx = 0, yy = 0, xy = 0;
  for (auto& p : f.outline) p = {p.x - f.centre.x, p.y - f.centre.y};
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = f.outline[i], b = f.outline[(i + 1) % n];
    const double c = cross(a, b);
    xx += c * (a.x * a.x + a.x * b.x + b.x * b.x) / 12;
    yy += c * (a.y * a.y + a.y * b.y + b.y * b.y) / 12;
    xy += c * (a.x * b.y + 2 * a.x * a.y + 2 * b.x * b.y + b.x * a.y) / 24;
  }
  f.yaw = 0.5 * std::atan2(2 * xy, xx - yy);
  const double cs = std::cos(f.yaw), sn = std::sin(f.yaw);
  for (auto& p : f.outline) p = {cs * p.x + sn * p.y, -sn * p.x + cs * p.y};
  const double pxx = cs * cs * xx + 2 * cs * sn * xy + sn * sn * yy, pyy = xx + yy - pxx;
  const double m = density * thickness, plate = area * thickness * thickness / 12;
  f.mass = m * area;
  f.inertia = {m * (pyy + plate), m * (pxx + plate), m * (pxx + pyy)};
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = f.outline[i], b = f.outline[(i + 1) % n];
    f.column.push_back({(a.x + b.x) / 3, (a.y + b.y) / 3});
    f.column_area.push_back(cross(a, b) / 2);
  }
}

inline FloeScene read(const char* file) {
  FloeScene s;
  std::ifstream in(file);
  std::size_t floes = 0;
  in >> s.thickness >> s.x0 >> s.x1 >> s.y0 >> s.y1 >> s.current >> s.hull_x >> s.hull_length >> s.hull_bow >>
      s.hull_beam >> s.hull_bottom >> s.hull_top >> s.hull_speed >> floes;
  for (std::size_t k = 0; k < floes; ++k) {
    std::size_t n = 0;
    in >> n;
    Floe f;
    f.outline.resize(n);
    for (auto& p : f.outline) in >> p.x >> p.y;
    prepare(f, s.thickness, s.density);
    s.floes.push_back(std::move(f));
  }
  if (!in) {
    std::fprintf(stderr, "%s: cannot be read\n", file);
    std::exit(4);
  }
  return s;
}

struct BodyState {
  double p[3], v[3], w[3], R[3][3];
};
struct Load {
  double f[3]{}, t[3]{};
};

/// Water load of one floe: buoyancy and heave damping on columns, linear drag towards the current.
inline Load water_load(const FloeScene& s, const Floe& f, const BodyState& q) {
  Load load;
  const double H = s.thickness, omega = std::sqrt(s.water * s.gravity / (s.density * H)), drag = 0.2;
  for (std::size_t k = 0; k < f.column.size(); ++k) {
    const Point c = f.column[k];
    const double r[3] = {q.R[0][0] * c.x + q.R[0][1] * c.y, q.R[1][0] * c.x + q.R[1][1] * c.y,
                         q.R[2][0] * c.x + q.R[2][1] * c.y};
    const double wet = std::clamp(H / 2 - (q.p[2] + r[2]), 0.0, H);
    double fz = s.water * s.gravity * f.column_area[k] * wet;
    if (wet > 0) fz -= s.density * H * omega * f.column_area[k] * (q.v[2] + q.w[0] * r[1] - q.w[1] * r[0]);
    load.f[2] += fz;
    load.t[0] += r[1] * fz;
    load.t[1] -= r[0] * fz;
  }
  load.f[0] -= f.mass * drag * (q.v[0] - s.current);
  load.f[1] -= f.mass * drag * q.v[1];
  load.t[2] -= f.inertia[2] * drag * q.w[2];
  return load;
}

/// CPU time of this thread [ms]. It keeps other load of the machine out of an engine's time.
inline double now_ms() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

/// Times of one step by stage [ms].
struct Parts {
  double detect = 0, solve = 0, water = 0, total = 0;
};

inline double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

inline double percentile_95(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() * 95 / 100];
}

/// Prints one CSV row: engine,floes,sweeps,detect_ms,solve_ms,water_ms,total_ms,contacts,
/// penetration_max_over_thickness,total_ms_95,natural_map_m_s,missed_steps. Values are medians of the window unless the
/// name says otherwise. A peer has no tolerance to miss.
inline void print_row(const char* engine, std::size_t floes, int sweeps, const std::vector<Parts>& window,
                      double contacts, double penetration, const std::vector<double>& natural_maps, int missed = 0) {
  std::vector<double> d, s, w, t;
  for (const auto& p : window) {
    d.push_back(p.detect);
    s.push_back(p.solve);
    w.push_back(p.water);
    t.push_back(p.total);
  }
  std::printf("%s,%zu,%d,%.4f,%.4f,%.4f,%.4f,%.1f,%.4f,%.4f,%.3g,%d\n", engine, floes, sweeps, median(d), median(s),
              median(w), median(t), contacts, penetration, percentile_95(t), median(natural_maps), missed);
}

constexpr int k_first_measured = 140, k_last_measured = 240;

}  // namespace peers
