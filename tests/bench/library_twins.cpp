/// Compares code of Nilas with its libraries' counterparts: factors of block matrices (Eigen), convex pieces (CGAL's
/// Nef polyhedra), the spline of a carriage's path (SimTK). The comments of that code take their figures from here.
/// usage: bench_library_twins [factors|parts|spline]
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_decomposition_3.h>
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "contact/solvers/linear/block_cholesky.h"
#include "contact/solvers/linear/block_lu.h"
#include "core/base/random.h"
#include "core/mesh/decompose/decompose.h"
#include "core/vessel/tree/simbody.h"
#include "core/vessel/vessel_system.h"

namespace {

using namespace nilas;
using Sparse = Eigen::SparseMatrix<double>;

template <class Work>
double milliseconds(const Work& work) {
  double best = 1e300;
  for (int k = 0; k < 3; ++k) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

/// Blocks of the contacts between neighbours in a grid of bodies: contacts that share a body are coupled.
struct Packing {
  std::vector<int> row_start{0}, column;
  std::vector<Mat3> block;
  Sparse matrix;
};

Packing packing(int nx, int ny, int nz) {
  const auto body = [&](int i, int j, int k) { return (k * ny + j) * nx + i; };
  std::vector<std::array<int, 2>> contacts;
  std::vector<std::vector<int>> of_body(static_cast<std::size_t>(nx * ny * nz));
  const auto join = [&](int a, int b) {
    const int c = static_cast<int>(contacts.size());
    contacts.push_back({a, b});
    of_body[a].push_back(c);
    of_body[b].push_back(c);
  };
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        if (i + 1 < nx) join(body(i, j, k), body(i + 1, j, k));
        if (j + 1 < ny) join(body(i, j, k), body(i, j + 1, k));
        if (k + 1 < nz) join(body(i, j, k), body(i, j, k + 1));
      }
  RandomStream random(7, "packing");
  using Arm = Eigen::Matrix<double, 6, 3>;
  std::vector<std::array<Arm, 2>> arms(contacts.size());
  for (auto& two : arms)
    for (Arm& arm : two) arm = Arm::NullaryExpr([&](Eigen::Index, Eigen::Index) { return random.uniform(-1, 1); });
  Packing out;
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < static_cast<int>(contacts.size()); ++c) {
    std::map<int, Mat3> row;
    for (std::size_t side = 0; side < 2; ++side)
      for (const int d : of_body[contacts[c][side]]) {
        const auto& other = contacts[d];
        const std::size_t at = other[0] == contacts[c][side] ? 0 : 1;
        const Mat3 part = arms[c][side].transpose() * arms[d][at];
        row.try_emplace(d, Mat3::Zero()).first->second += part;
      }
    for (const auto& [d, value] : row) {
      out.column.push_back(d);
      out.block.push_back(value);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) entries.emplace_back(3 * c + i, 3 * d + j, value(i, j));
    }
    out.row_start.push_back(static_cast<int>(out.column.size()));
  }
  const auto n = static_cast<Eigen::Index>(3 * contacts.size());
  out.matrix.resize(n, n);
  out.matrix.setFromTriplets(entries.begin(), entries.end());
  return out;
}

void factors() {
  fmt::print("Factors of a matrix of 3 x 3 blocks plus 0.1 on the diagonal, ms; residual |A x - b| / |b|\n");
  fmt::print("{:<14} {:>8} | {:>21} {:>21} | {:>21} {:>21}\n", "bodies", "contacts", "BlockCholesky", "SimplicialLLT",
             "BlockLu", "SparseLU");
  fmt::print("{:<14} {:>8} | {:>21} {:>21} | {:>21} {:>21}\n", "", "", "plan factor residual", "plan factor residual",
             "plan factor residual", "plan factor residual");
  const std::vector<std::array<int, 3>> sizes{{10, 10, 1},   {30, 30, 1}, {60, 60, 1},
                                              {100, 100, 1}, {8, 8, 8},   {12, 12, 12}};
  for (const auto& [nx, ny, nz] : sizes) {
    Packing p = packing(nx, ny, nz);
    const std::size_t n = p.row_start.size() - 1;
    const double k_added = 0.1;
    Sparse shifted = p.matrix;
    for (Eigen::Index i = 0; i < shifted.rows(); ++i) shifted.coeffRef(i, i) += k_added;
    std::vector<Mat3> shifted_blocks = p.block;
    for (std::size_t row = 0; row < n; ++row)
      for (int at = p.row_start[row]; at < p.row_start[row + 1]; ++at)
        if (p.column[at] == static_cast<int>(row)) shifted_blocks[at] += k_added * Mat3::Identity();
    const VecX b = VecX::LinSpaced(shifted.rows(), -1, 1);
    const auto residual = [&](const VecX& x) { return (shifted * x - b).norm() / b.norm(); };
    const std::vector<Mat3> inverse(n, Mat3::Identity()), added(n, k_added * Mat3::Identity());
    std::string line = fmt::format("{:<14} {:>8} |", fmt::format("{} x {} x {}", nx, ny, nz), n);
    const auto add = [&](double plan, double factor, double left) {
      line += fmt::format(" {:>6.1f} {:>6.1f} {:>7.0e}", plan, factor, left);
    };
    {
      std::optional<solvers::BlockCholesky> own;
      const double plan = milliseconds([&] { own.emplace(p.matrix); });
      const double factor = milliseconds([&] { own->factor(inverse, added); });
      add(plan, factor, residual(own->solve_unrefined(b)));
    }
    {
      Eigen::SimplicialLLT<Sparse> library;
      const double plan = milliseconds([&] { library.analyzePattern(shifted); });
      const double factor = milliseconds([&] { library.factorize(shifted); });
      add(plan, factor, residual(library.solve(b)));
    }
    line += " |";
    {
      // A plan of the same pattern is kept, so that a new object is needed for each planning.
      std::optional<solvers::BlockLu> own;
      const double plan = milliseconds([&] {
        own.emplace();
        own->analyse(p.row_start, p.column);
      });
      const double factor = milliseconds([&] { own->factorise(shifted_blocks); });
      VecX x = b;
      own->solve(x);
      add(plan, factor, residual(x));
    }
    {
      Eigen::SparseLU<Sparse> library;
      const double plan = milliseconds([&] { library.analyzePattern(shifted); });
      const double factor = milliseconds([&] { library.factorize(shifted); });
      add(plan, factor, residual(library.solve(b)));
    }
    fmt::print("{}\n", line);
  }
}

/// A closed block of 2 x 2 m over a flat lower side. Its upper side is a grid of n x n squares, two triangles each, at
/// height(x, y) over the lower side; the rim stays at 1 m.
template <class Height>
geometry::TriangleMesh block_under(int n, const Height& height) {
  geometry::TriangleMesh mesh;
  const int row = n + 1;
  for (int level = 0; level < 2; ++level)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const double x = -1 + 2.0 * i / n, y = -1 + 2.0 * j / n;
        mesh.vertices.emplace_back(x, y, level == 0 ? 0 : height(x, y));
      }
  const int up = row * row;
  const auto quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int at = j * row + i;
      quad(up + at, up + at + 1, up + at + row + 1, up + at + row);
      quad(at, at + row, at + row + 1, at + 1);
    }
  for (int i = 0; i < n; ++i) {
    const int south = i, north = n * row + i, west = i * row, east = i * row + n;
    quad(south, south + 1, up + south + 1, up + south);
    quad(north + 1, north, up + north, up + north + 1);
    quad(west + row, west, up + west, up + west + row);
    quad(east, east + row, up + east + row, up + east);
  }
  return mesh;
}

void parts() {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Nef = CGAL::Nef_polyhedron_3<Kernel>;
  fmt::print("Convex parts of blocks of 2 m with a side that is hollow one way and both ways\n");
  fmt::print("{:>8} {:>10} | {:>15} {:>10} {:>14} {:>10} | {:>9} {:>10}\n", "hollow", "triangles", "decompose parts",
             "tolerance", "deviation [mm]", "[ms]", "Nef parts", "[ms]");
  for (const bool both : {false, true})
    for (const int n : {4, 8, 16}) {
      const geometry::TriangleMesh mesh = block_under(n, [&](double x, double y) {
        const auto hollow = [](double t) { return std::cos(0.5 * k_pi * t); };
        return 1 - 0.5 * hollow(x) * (both ? hollow(y) : 1);
      });
      mesh::ConvexParts own;
      constexpr double k_tolerance = 20e-3;
      const double own_ms = milliseconds([&] { own = mesh::decompose(mesh, {.tolerance = k_tolerance}); });
      CGAL::Surface_mesh<Kernel::Point_3> surface;
      for (const Vec3& p : mesh.vertices) surface.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
      for (const auto& t : mesh.triangles)
        surface.add_face(CGAL::SM_Vertex_index(static_cast<unsigned>(t[0])),
                         CGAL::SM_Vertex_index(static_cast<unsigned>(t[1])),
                         CGAL::SM_Vertex_index(static_cast<unsigned>(t[2])));
      int count = 0;
      const auto start = std::chrono::steady_clock::now();
      Nef nef(surface);
      CGAL::convex_decomposition_3(nef);
      for (auto volume = ++nef.volumes_begin(); volume != nef.volumes_end(); ++volume) count += volume->mark();
      const double nef_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      fmt::print("{:>8} {:>10} | {:>15} {:>10} {:>14.3g} {:>10.1f} | {:>9} {:>10.1f}\n", both ? "both" : "one way",
                 mesh.triangles.size(), own.parts.size(), 1e3 * k_tolerance, 1e3 * own.deviation.largest, own_ms, count,
                 nef_ms);
      std::fflush(stdout);
    }
}

void spline() {
  fmt::print("Natural cubic spline of a path with uneven rows: SimTK's against CarriageMotion's\n");
  for (const int rows : {2, 3, 4, 50, 1000, 20000}) {
    RandomStream random(7, "path");
    SimTK::Vector times(rows);
    SimTK::Vector_<SimTK::Vec3> values(rows);
    std::string csv = "t_s,x_m,y_m,yaw_deg\n";
    double t = 0;
    for (int i = 0; i < rows; ++i) {
      const SimTK::Vec3 p(0.3 * t, std::sin(0.3 * t), 0);
      times[i] = t;
      values[i] = p;
      csv += fmt::format("{:.17g},{:.17g},{:.17g},0\n", t, p[0], p[1]);
      t += random.uniform(0.01, 10);
    }
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "nilas_library_twins.csv";
    std::ofstream(file) << csv;
    const vessel::CarriageMotion own = vessel::CarriageMotion::path(Vec3::Zero(), 0, file.string());
    std::filesystem::remove(file);
    try {
      const auto library =
          SimTK::SplineFitter<SimTK::Vec3>::fitForSmoothingParameter(3, times, values, 0.0).getSpline();
      double apart = 0, at_rows = 0;
      for (int i = 0; i < rows; ++i) at_rows = std::max(at_rows, (library.calcValue(times[i]) - values[i]).norm());
      constexpr int k_samples = 100000;
      const double end = times[rows - 1];
      double sum = 0;
      for (int k = 0; k < k_samples; ++k) {
        const SimTK::Vec3 p = library.calcValue(end * k / k_samples);
        apart = std::max(apart, (Vec3(p[0], p[1], 0) - own.at(end * k / k_samples).p).norm());
      }
      const double own_ms = milliseconds([&] {
        for (int k = 0; k < k_samples; ++k) sum += own.at(end * k / k_samples).v.x();
      });
      const double library_ms = milliseconds([&] {
        for (int k = 0; k < k_samples; ++k)
          sum += library.calcValue(end * k / k_samples)[0] + library.calcDerivative(1, end * k / k_samples)[0];
      });
      fmt::print("{:>6} rows: apart {:.1e} m, the library misses rows by {:.1e} m, {:.3f} and {:.3f} us ({:.3g})\n",
                 rows, apart, at_rows, 1e3 * own_ms / k_samples, 1e3 * library_ms / k_samples, sum);
    } catch (const std::exception& error) {
      const std::string message = error.what();
      fmt::print("{:>6} rows: {}\n", rows, message.substr(message.find("Too few")));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string table = argc > 1 ? argv[1] : "";
  if (table.empty() || table == "factors") factors();
  if (table.empty() || table == "parts") parts();
  if (table.empty() || table == "spline") spline();
  return 0;
}
