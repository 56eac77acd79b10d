/// This file includes CGAL, whose kernels need directed rounding: see fracture/CMakeLists.txt.
#include "fracture/cut/cut_outline.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "fracture/cut/crack_faces.h"
#include "fracture/cut/snap_lines.h"

namespace nilas::fracture {

namespace {

bool is_finite(const std::vector<Vec2>& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec2& p) { return p.allFinite(); });
}

bool is_simple_counter_clockwise(const std::vector<Vec2>& outline) {
  return geometry::is_simple(outline) && !geometry::is_clockwise(outline);
}

CutResult refused(CutStatus status, const std::string& why) { return {status, why, {}, 0, 0}; }

bool visits_a_point_twice(const CrackFace& face) {
  const std::set<int> points(face.points.begin(), face.points.end());
  return points.size() < face.points.size();
}

/// A face with the points that are kept. It begins with its first edge along the outline, else at its point of least x,
/// then y.
struct FaceLoop {
  int place = std::numeric_limits<int>::max();  ///< Place of its first edge along the outline.
  CutPiece piece;
};

FaceLoop loop_of(const CrackFace& face, const SnappedLines& lines, const std::vector<char>& left_out) {
  struct Corner {
    int place;  ///< Place of its first edge, as in FaceLoop.
    Vec2 point;
    bool crack;
  };
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const auto p = static_cast<std::size_t>(face.points[i]);
    if (left_out[p]) continue;
    const int place = face.along[i];
    corners.push_back({place < 0 ? std::numeric_limits<int>::max() : place, lines.points[p], place < 0});
  }
  const auto before = [](const Corner& a, const Corner& b) {
    return std::tuple(a.place, a.point.x(), a.point.y()) < std::tuple(b.place, b.point.x(), b.point.y());
  };
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), before), corners.end());
  FaceLoop loop;
  if (!corners.empty()) loop.place = corners.front().place;
  for (const Corner& corner : corners) {
    loop.piece.outline.push_back(corner.point);
    loop.piece.crack.push_back(corner.crack);
  }
  return loop;
}

bool comes_before(const FaceLoop& a, const FaceLoop& b) {
  if (a.place != b.place) return a.place < b.place;
  const Vec2 &p = a.piece.outline.front(), &q = b.piece.outline.front();
  return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
}

/// Whether the outline and all pieces are simple and counter-clockwise. Then the pieces fill the outline without
/// overlap: each inner edge is walked once each way, so that the winding numbers of the pieces add up to the outline's,
/// one.
bool is_partition(const std::vector<CutPiece>& pieces, const SnappedLines& lines, const std::vector<char>& left_out) {
  std::vector<Vec2> outline;
  for (const int p : lines.outline)
    if (!left_out[p]) outline.push_back(lines.points[p]);
  if (!is_simple_counter_clockwise(outline)) return false;
  return std::all_of(pieces.begin(), pieces.end(),
                     [](const CutPiece& piece) { return is_simple_counter_clockwise(piece.outline); });
}

std::vector<CutPiece> pieces_of(const CrackFaces& found, const SnappedLines& lines, const std::vector<char>& left_out) {
  std::vector<FaceLoop> loops;
  for (const CrackFace& face : found.faces) {
    loops.push_back(loop_of(face, lines, left_out));
    if (loops.back().piece.outline.size() < 3) return {};
  }
  std::sort(loops.begin(), loops.end(), comes_before);
  std::vector<CutPiece> pieces;
  for (FaceLoop& loop : loops) pieces.push_back(std::move(loop.piece));
  return pieces;
}

/// The length of all cracks [m]. Each crack edge belongs to two pieces and counts once.
double crack_length(const std::vector<CutPiece>& pieces) {
  double both = 0;
  for (const CutPiece& piece : pieces)
    for (std::size_t i = 0; i < piece.outline.size(); ++i)
      if (piece.crack[i]) both += (piece.outline[(i + 1) % piece.outline.size()] - piece.outline[i]).norm();
  return both / 2;
}

CutResult uncut(const std::vector<Vec2>& outline, int slivers) {
  return {CutStatus::uncut, "", {{outline, std::vector<bool>(outline.size(), false)}}, 0, slivers};
}

CutResult result_of(const CrackFaces& found, const std::vector<Vec2>& outline, const SnappedLines& lines) {
  for (const CrackFace& face : found.faces)
    if (face.surrounds_more) return refused(CutStatus::hole, "a piece would surround another");
  for (const CrackFace& face : found.faces)
    if (visits_a_point_twice(face)) return refused(CutStatus::pinched, "a piece would touch itself at a vertex");
  if (found.faces.size() < 2) return uncut(outline, found.slivers);
  // Points that are left out straighten edges by a rounding, which may spoil a piece that is as thin.
  for (const auto& left_out : {found.needless, std::vector<char>(lines.points.size(), 0)}) {
    std::vector<CutPiece> pieces = pieces_of(found, lines, left_out);
    if (pieces.empty() || !is_partition(pieces, lines, left_out)) continue;
    const double length = crack_length(pieces);
    return {CutStatus::cut, "", std::move(pieces), length, found.slivers};
  }
  return refused(CutStatus::rounding, "a piece is no longer simple with its points rounded");
}

}  // namespace

std::string name_of(CutStatus status) {
  switch (status) {
    case CutStatus::cut:
      return "cut";
    case CutStatus::uncut:
      return "uncut";
    case CutStatus::bad_outline:
      return "bad outline";
    case CutStatus::bad_crack:
      return "bad crack";
    case CutStatus::hole:
      return "hole";
    case CutStatus::pinched:
      return "pinched";
    case CutStatus::rounding:
      return "rounding";
  }
  return "";
}

CutResult cut_outline(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& cracks) {
  if (!is_finite(outline)) return refused(CutStatus::bad_outline, "a coordinate of the outline is not finite");
  if (!is_simple_counter_clockwise(outline))
    return refused(CutStatus::bad_outline, "the outline is not simple and counter-clockwise");
  if (!std::all_of(cracks.begin(), cracks.end(), is_finite))
    return refused(CutStatus::bad_crack, "a coordinate of a crack is not finite");
  const double resolution = snap_resolution(outline);
  const SnappedLines lines = snap_lines(outline, cracks, resolution);
  const auto everything = std::vector<char>(lines.points.size(), 0);
  if (!lines.settled || !is_partition({}, lines, everything))
    return refused(CutStatus::rounding, "the cracks do not come apart in doubles");
  try {
    return result_of(crack_faces(lines, resolution), outline, lines);
  } catch (const CGAL::Failure_exception& failure) {
    return refused(CutStatus::rounding, std::string("CGAL: ") + failure.what());
  }
}

}  // namespace nilas::fracture
