#include "core/choices/ice_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

static void check_placement(const SceneElement& element, std::vector<Fault>& faults) {
  if (is_true(element, "fixed") && is_given_nonzero(element, "velocity"))
    faults.push_back(fault_of(element, "velocity", "fixed ice does not move; allowed: 0 0 0"));
}

static void check_region(const SceneElement& field, std::vector<Fault>& faults) {
  if (!is_named(field, "region"))
    faults.push_back(fault_of(field, "region", "the attribute is missing; allowed: x0 y0 x1 y1 [m]"));
  const auto region = numbers_of(field, "region");
  if (!region) return;
  const auto check = [&](std::size_t low, const char* name) {
    const double a = region->at(low), b = region->at(low + 2);
    if (!(b > a))
      faults.push_back(fault_of(field, "region",
                                std::string("found ") + name + "0 = " + format_number(a) + ", " + name +
                                    "1 = " + format_number(b) + "; allowed: x0 < x1 and y0 < y1"));
  };
  check(0, "x");
  check(1, "y");
}

static void check_source(const SceneElement& field, std::vector<Fault>& faults) {
  const auto kind = choice_of<FieldKind>(field, "kind");
  if (!kind) return;
  if (*kind != FieldKind::file) return check_region(field, faults);
  if (!is_named(field, "file"))
    faults.push_back(fault_of(field, "file", "the attribute is missing; allowed: the path of a GeoJSON file"));
}

/// Checks the order of min, mean and max where they matter.
static void check_size(const SceneElement& size, std::vector<Fault>& faults) {
  const auto distribution = choice_of<SizeDistribution>(size, "distribution");
  const auto mean = number_of(size, "mean"), min = number_of(size, "min"), max = number_of(size, "max");
  const bool spread =
      distribution && *distribution != SizeDistribution::fixed && *distribution != SizeDistribution::as_library;
  if (!spread || !min || !max) return;
  if (*max < *min)
    faults.push_back(fault_of(
        size, "max", "found " + format_number(*max) + "; allowed: at least min, >= " + format_number(*min) + " [m]"));
  else if (*distribution == SizeDistribution::lognormal && mean && (*mean < *min || *mean > *max))
    faults.push_back(fault_of(size, "mean",
                              "found " + format_number(*mean) + "; allowed: from min to max, >= " +
                                  format_number(*min) + " and <= " + format_number(*max) + " [m]"));
}

static void check_shape(const SceneElement& shape, std::vector<Fault>& faults) {
  const auto vertices = numbers_of(shape, "vertices");
  if (vertices && vertices->at(1) < vertices->at(0))
    faults.push_back(fault_of(shape, "vertices", "found the fewest above the most; allowed: fewest most, as in 5 9"));
}

static void check_library(const SceneElement& field, std::vector<Fault>& faults) {
  const SceneElement *size = child_of(field, "size"), *shape = child_of(field, "shape");
  const bool library = shape ? is_named(*shape, "library") : is_misspelt(field, "shape");
  if (size != nullptr && choice_of<SizeDistribution>(*size, "distribution") == SizeDistribution::as_library && !library)
    faults.push_back(fault_of(*size, "distribution", "found as-library; it needs <shape library=...>"));
}

static void check_channel(const SceneElement& field, std::vector<Fault>& faults) {
  const auto width = number_of(field, "channel_width");
  const auto region = numbers_of(field, "region");
  if (width && region && *width >= region->at(3) - region->at(1))
    faults.push_back(fault_of(field, "channel_width",
                              "found " + format_number(*width) + "; allowed: less than the region's width " +
                                  format_number(region->at(3) - region->at(1)) + " [m]"));
}

static void check_points(const SceneElement& element, const std::string& attribute, const std::string& each,
                         std::vector<Fault>& faults) {
  const auto numbers = numbers_of(element, attribute);
  if (numbers && numbers->size() % 2 != 0)
    faults.push_back(fault_of(
        element, attribute,
        "found " + std::to_string(numbers->size()) + " numbers; allowed: an even number of them, x y per " + each));
}

/// Bonded floes leave no gaps. Other kinds of field ignore a bond, which is reported elsewhere.
static void check_bond(const SceneElement& field, std::vector<Fault>& faults) {
  if (choice_of<FieldKind>(field, "kind") != FieldKind::voronoi) return;
  const auto concentration = number_of(field, "concentration");
  if (child_of(field, "bond") && concentration != 1.0)
    faults.push_back(fault_of(field, "concentration",
                              "found " + format_number(concentration.value_or(0)) +
                                  "; allowed with <bond>: 1, floes that are frozen together leave no gaps"));
}

void check_ice(const SceneElement& ice, std::vector<Fault>& faults) {
  for (const auto& child : ice.children) {
    if (child.name == "vary") continue;
    if (child.name == "weak_line") {
      check_points(child, "points", "point", faults);
      continue;
    }
    check_placement(child, faults);
    if (child.name == "floe") {
      check_points(child, "outline", "corner", faults);
      continue;
    }
    check_bond(child, faults);
    check_source(child, faults);
    check_library(child, faults);
    check_channel(child, faults);
    for (const auto& part : child.children) {
      if (part.name == "size") check_size(part, faults);
      if (part.name == "shape") check_shape(part, faults);
    }
  }
}

}  // namespace nilas::scene
