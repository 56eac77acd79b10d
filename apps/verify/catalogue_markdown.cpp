#include <fmt/format.h>

#include "apps/verify/setting.h"
#include "apps/verify/table.h"

namespace nilas {

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& by) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : by) + word;
  return text;
}

std::string inputs_text(const Case& one) {
  std::string text;
  for (const auto& input : one.inputs)
    text += fmt::format("{}{} = {:g}{}{}", text.empty() ? "" : ", ", input.name, input.value,
                        input.unit.empty() ? "" : " " + input.unit, input.name == one.varied ? " (and 10 % more)" : "");
  return text;
}

std::string limit_text(const Case& one) {
  std::string text;
  for (std::size_t k = 0; k < one.integrators.size(); ++k) {
    const double order = k < one.orders.size() ? one.orders[k] : 0;
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : "; ", one.integrators[k],
                    order > 0 ? fmt::format("order {:g} over five steps from {:g} s, where the error is at most {:g}",
                                            order, one.step, one.coarsest.at(k))
                              : fmt::format("error {:g} at {:g} s", one.tolerance, one.step));
  }
  if (one.reference) text += fmt::format("; reference error {:g}", one.tolerance);
  return text;
}

constexpr const char* k_head = R"(# Cases of `nilas verify`

Each case is a scene of `apps/scenes/verify`, run by the same engine as every scene, with the inputs below put in as `--set` would; so any of
them can be run by hand. What is expected is computed from the inputs, for the law that is asked: the artefact of a wrong model is an expected
value too. Every case runs again with one input 10 % larger. With `theta` = 1 (`semi-implicit-euler`) or 0.5 (`moreau`) formulas are those of the
time step itself where they can be had; else the limit of small steps is expected at the order that is proven. With
`reference` the formulas of continuous time are expected.

    nilas verify                     the default set
    nilas verify --all               every solver with every integrator
    nilas verify --case D35 --json   one case, all rows
    nilas verify --html --out DIR    DIR/verify.html with a plot per family, DIR/verify.csv

An error is |measured - expected| over the scale of the quantity: the expected value, or where that is zero a typical one
(`scale` in the CSV file and in JSON). Durations and places that are no inputs stand in `apps/verify`.

This page is written by `nilas verify --markdown`.
)";

constexpr const char* k_absent = R"(
## Not here, and why

The numbers are those of a longer list of analytic cases. Of that list are absent: 12 (block on an accelerating wedge: a body cannot be driven
along a path), 22 (spinning and sliding hoop: its limit needs 64 contacts around a rim, a flat face has four), 24 (Euler's disc) and 29 (heavy top
on its tip: no long runs on one sharp point are claimed), 43 (wedge between two blocks) and 47 (arch: both need shapes that no scene element
makes), 44 and 45 (oscillators on a spring: load cells are the only springs, with all axes of one stiffness), 46 (capstan: no rope), 58 (a tip on
two hinges: one vessel joint is all). 32 is the older tools' free rotation in place of the double pendulum, for the same reason.
)";

}  // namespace

std::string catalogue_markdown() {
  std::string text = k_head;
  char family = 0;
  for (const auto& one : catalogue()) {
    if (one.family != family) text += fmt::format("\n## {} {}\n", one.family, family_title(one.family));
    family = one.family;
    text += fmt::format("\n**{} {}.** {}\n", one.id(), one.title, one.formula);
    text += fmt::format("Inputs: {}. Scene `{}`{}. Laws: {}. Limit: {}. Source: {}.\n", inputs_text(one), one.scene,
                        one.also.empty() ? "" : ", `" + joined(one.also, "`, `") + "`", joined(one.laws, ", "),
                        limit_text(one), one.source);
    if (!one.note.empty()) text += one.note + "\n";
  }
  return text + k_absent;
}

}  // namespace nilas
