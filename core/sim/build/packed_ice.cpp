#include "core/sim/build/packed_ice.h"

#include "core/field/outline_library.h"

namespace nilas {

static void set_size(const SizeScene& size, PackedSpec& spec) {
  spec.distribution = kind_of<SizeDistribution>(size);
  const auto set_ends = [&](const auto& of) {
    spec.min = of.min;
    spec.max = of.max;
  };
  std::visit(Overloaded{[&](const FixedSizeScene& fixed) { spec.mean = fixed.mean; },
                        [&](const UniformSizeScene& uniform) { set_ends(uniform); },
                        [&](const LognormalSizeScene& lognormal) {
                          spec.mean = lognormal.mean;
                          spec.sd = lognormal.sd;
                          set_ends(lognormal);
                        },
                        [&](const PowerLawSizeScene& power_law) {
                          spec.exponent = power_law.exponent;
                          set_ends(power_law);
                        },
                        [](const LibrarySizeScene&) {}},
             size);
}

static void set_shape(const FloeShapeScene& shape, PackedSpec& spec) {
  spec.shape = kind_of<FloeShape>(shape);
  std::visit(
      Overloaded{[&](const PolygonScene& polygon) {
                   spec.vertices_min = polygon.vertices_min;
                   spec.vertices_max = polygon.vertices_max;
                 },
                 [&](const RectangleScene& rectangle) { spec.aspect = rectangle.aspect; }, [](const SquareScene&) {},
                 [&](const ParallelogramScene& parallelogram) { spec.aspect = parallelogram.aspect; },
                 [](const DiscScene&) {},
                 [&](const LibraryScene& library) { spec.library = read_outlines(library.file); }},
      shape);
}

PackedSpec packed_spec(const PackedFieldScene& field) {
  PackedSpec spec;
  spec.concentration = field.concentration;
  spec.overlap_tolerance = field.overlap_tolerance;
  spec.shear = field.shear_deg * k_deg;
  set_size(field.size, spec);
  set_shape(field.shape, spec);
  return spec;
}

PackedSpec cell_spec(const VoronoiFieldScene& field) {
  PackedSpec spec;
  spec.concentration = field.concentration;
  set_size(field.size, spec);
  return spec;
}

}  // namespace nilas
