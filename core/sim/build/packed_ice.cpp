#include "core/sim/build/packed_ice.h"

#include "core/field/outline_library.h"

namespace nilas::sim {

static void set_size(const scene::SizeScene& size, double unit, field::PackedSpec& spec) {
  spec.distribution = kind_of<SizeDistribution>(size);
  const auto set_ends = [&](const auto& of) {
    spec.min = of.min / unit;
    spec.max = of.max / unit;
  };
  std::visit(Overloaded{[&](const scene::FixedSizeScene& fixed) { spec.mean = fixed.mean / unit; },
                        [&](const scene::UniformSizeScene& uniform) { set_ends(uniform); },
                        [&](const scene::LognormalSizeScene& lognormal) {
                          spec.mean = lognormal.mean / unit;
                          spec.sd = lognormal.sd / unit;
                          set_ends(lognormal);
                        },
                        [&](const scene::PowerLawSizeScene& power_law) {
                          spec.exponent = power_law.exponent;
                          set_ends(power_law);
                        },
                        [](const scene::LibrarySizeScene&) {}},
             size);
}

static void set_shape(const scene::FloeShapeScene& shape, field::PackedSpec& spec) {
  spec.shape = kind_of<FloeShape>(shape);
  std::visit(Overloaded{[&](const scene::PolygonScene& polygon) {
                          spec.vertices_min = polygon.vertices_min;
                          spec.vertices_max = polygon.vertices_max;
                        },
                        [&](const scene::RectangleScene& rectangle) { spec.aspect = rectangle.aspect; },
                        [](const scene::SquareScene&) {},
                        [&](const scene::ParallelogramScene& parallelogram) { spec.aspect = parallelogram.aspect; },
                        [](const scene::DiscScene&) {},
                        [&](const scene::LibraryScene& library) { spec.library = field::read_outlines(library.file); }},
             shape);
}

field::PackedSpec packed_spec(const scene::PackedFieldScene& field, double unit) {
  field::PackedSpec spec;
  spec.concentration = field.concentration;
  spec.overlap_tolerance = field.overlap_tolerance;
  spec.shear = field.shear_deg * k_deg;
  set_size(field.size, unit, spec);
  set_shape(field.shape, spec);
  return spec;
}

field::PackedSpec cell_spec(const scene::VoronoiFieldScene& field, double unit) {
  field::PackedSpec spec;
  spec.concentration = field.concentration;
  set_size(field.size, unit, spec);
  return spec;
}

field::PackedSpec scaled(field::PackedSpec spec, double factor) {
  for (Vec2* corner : {&spec.low, &spec.high}) *corner *= factor;
  for (double* length : {&spec.mean, &spec.sd, &spec.min, &spec.max, &spec.keep_out_margin}) *length *= factor;
  for (auto* outlines : {&spec.library, &spec.keep_out})
    for (auto& outline : *outlines)
      for (Vec2& p : outline) p *= factor;
  return spec;
}

}  // namespace nilas::sim
