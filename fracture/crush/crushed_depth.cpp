#include "fracture/crush/crushed_depth.h"

#include <algorithm>
#include <vector>

namespace nilas::fracture {

double CrushedPlane::gap(const Vec3& x) const { return std::max(0.0, offset - normal.dot(x)); }

CrushedPlane CrushedDepth::advance(const CrushedFace& face, const Vec3& normal, const Vec3& centroid, double reach) {
  CrushedPlane plane{normal, normal.dot(centroid), centroid};
  if (const auto known = known_.find(face); known != known_.end() && known->second.gap(centroid) > 0) {
    const Vec3 way = centroid - known->second.place;
    const Vec3 along = way - known->second.normal.dot(way) * known->second.normal;
    if (along.norm() <= reach) plane = known->second;
  }
  named_[face] = plane;
  return plane;
}

void CrushedDepth::forget_others() {
  known_.swap(named_);
  named_.clear();
}

void CrushedDepth::hand_on(std::int64_t floe, std::int64_t piece, const Vec2& place, int parts) {
  std::map<CrushedFace, CrushedPlane> of_piece;
  for (const auto& [face, plane] : known_) {
    if (face.floe != floe) continue;
    const Vec3 shift(place.x(), place.y(), 0);
    const CrushedPlane moved{plane.normal, plane.offset - plane.normal.dot(shift), plane.place - shift};
    for (int k = 0; k < parts; ++k) {
      const auto [there, is_new] = of_piece.try_emplace({face.hull, piece, face.face, k}, moved);
      // The offset is the depth at the piece's centre. Planes of one face have the same normal unless it turned between
      // the parts; then the plane that stays may be the less deep one at the face, and ice there is crushed again.
      if (!is_new && moved.offset > there->second.offset) there->second = moved;
    }
  }
  known_.merge(of_piece);
}

void CrushedDepth::save(StateWriter out) const {
  std::vector<std::int64_t> faces;
  std::vector<Vec3> normals, places;
  std::vector<double> offsets;
  for (const auto& [face, plane] : known_) {
    faces.insert(faces.end(), {face.hull, face.floe, face.face, face.piece});
    normals.push_back(plane.normal);
    offsets.push_back(plane.offset);
    places.push_back(plane.place);
  }
  out.add("face", faces);
  out.add("normal", normals);
  out.add("offset", offsets);
  out.add("place", places);
}

void CrushedDepth::restore(const StateReader& in) {
  std::vector<std::int64_t> faces;
  std::vector<Vec3> normals, places;
  std::vector<double> offsets;
  in.get("offset", offsets);
  in.get("normal", normals, offsets.size());
  in.get("place", places, offsets.size());
  constexpr std::size_t k_numbers = 4;
  in.get("face", faces, k_numbers * offsets.size());
  known_.clear();
  named_.clear();
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    const std::int64_t* face = faces.data() + k_numbers * k;
    known_[{face[0], face[1], static_cast<int>(face[2]), static_cast<int>(face[3])}] = {normals[k], offsets[k],
                                                                                        places[k]};
  }
}

}  // namespace nilas::fracture
