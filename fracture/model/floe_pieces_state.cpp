/// The state of broken floes in a checkpoint. The scene itself has these floes only unbroken.
#include <algorithm>

#include "fracture/model/floe_pieces.h"

namespace nilas::fracture {

void FloePieces::save(const bodies::Bodies& bodies, StateWriter out) const {
  std::vector<std::int64_t> broken, ids, floes, corners, fixed;
  std::vector<Vec2> places, outlines;
  std::vector<double> thickness, mass;
  std::vector<Mat3> inertia;
  for (const auto& [id, floe] : intact_) broken.push_back(id);
  for (const auto& [id, origin] : origins_) {
    const std::size_t b = bodies.index_of(id);
    const geometry::Shape& shape = *bodies.shape[b];
    ids.push_back(id);
    floes.push_back(origin.floe);
    places.push_back(origin.place);
    corners.push_back(static_cast<std::int64_t>(shape.outline.size()));
    outlines.insert(outlines.end(), shape.outline.begin(), shape.outline.end());
    thickness.push_back(shape.thickness);
    mass.push_back(bodies.mass[b]);
    inertia.push_back(bodies.inertia_B[b]);
    fixed.push_back(bodies.motion[b] == bodies::Motion::fixed ? 1 : 0);
  }
  out.add("broken", broken);
  out.add("piece", ids);
  out.add("of_floe", floes);
  out.add("place", places);
  out.add("corners", corners);
  out.add("outline", outlines);
  out.add("thickness", thickness);
  out.add("mass", mass);
  out.add("inertia_B", inertia);
  out.add("fixed", fixed);
  out.add("brash_mass", brash_mass_);
  out.add("extruded_mass", extruded_mass_);
}

void FloePieces::restore(const StateReader& in, bodies::Bodies& bodies, bodies::IceProperties& ice) {
  in.get("brash_mass", brash_mass_);
  in.get("extruded_mass", extruded_mass_);
  take_broken_out(in, bodies, ice);
  put_saved_pieces(in, bodies, ice);
}

void FloePieces::take_broken_out(const StateReader& in, bodies::Bodies& bodies, bodies::IceProperties& ice) {
  std::vector<std::int64_t> broken;
  in.get("broken", broken);
  for (const std::int64_t id : broken) {
    const auto known = std::find(bodies.id.begin(), bodies.id.end(), id);
    const auto b = static_cast<std::size_t>(known - bodies.id.begin());
    if (known == bodies.id.end() || !ice.is_breakable(static_cast<int>(b)))
      in.refuse("broken", "names a floe that this scene does not have");
    keep_intact(b, bodies, ice);
    take_out(b, bodies, ice);
  }
}

void FloePieces::put_saved_pieces(const StateReader& in, bodies::Bodies& bodies, bodies::IceProperties& ice) {
  std::vector<std::int64_t> ids, floes, corners, fixed;
  std::vector<Vec2> places, outlines;
  std::vector<double> thickness, mass;
  std::vector<Mat3> inertia;
  in.get("piece", ids);
  const std::size_t count = ids.size();
  in.get("of_floe", floes, count);
  in.get("place", places, count);
  in.get("corners", corners, count);
  in.get("thickness", thickness, count);
  in.get("mass", mass, count);
  in.get("inertia_B", inertia, count);
  in.get("fixed", fixed, count);
  in.get("outline", outlines);
  std::size_t first = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto n = static_cast<std::size_t>(corners[k]);
    if (intact_.count(floes[k]) == 0) in.refuse("of_floe", "names a floe that is not broken");
    if (ids[k] < bodies.next_id) in.refuse("piece", "its numbers do not rise");
    if (n < 3 || first + n > outlines.size()) in.refuse("outline", "it has another length than corners say");
    bodies::BodySpec spec;
    spec.motion = fixed[k] ? bodies::Motion::fixed : bodies::Motion::free;
    const auto begin = outlines.begin() + static_cast<std::ptrdiff_t>(first);
    spec.shape = std::make_shared<const geometry::Shape>(
        geometry::prism_shape(std::vector<Vec2>(begin, begin + static_cast<std::ptrdiff_t>(n)), thickness[k]));
    spec.mass = mass[k];
    spec.inertia_B = inertia[k];
    bodies.next_id = ids[k];
    add_body(std::move(spec), {floes[k], places[k]}, bodies, ice);
    first += n;
  }
}

}  // namespace nilas::fracture
