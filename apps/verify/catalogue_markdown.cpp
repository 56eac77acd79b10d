#include <fmt/format.h>

#include "apps/verify/setting.h"
#include "apps/verify/table.h"

namespace nilas::verify {

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
    text += fmt::format(
        "{}{} {}", text.empty() ? "" : "; ", one.integrators[k],
        order > 0 ? fmt::format("order {:g} over five steps, the first of {:g} s with an error of at most {:g}", order,
                                one.step, one.coarsest.at(k))
                  : fmt::format("error at most {:g} at a step of {:g} s", one.tolerance, one.step));
  }
  if (one.reference) text += fmt::format("; reference error at most {:g}", one.tolerance);
  return text;
}

constexpr const char* k_head = R"(# Cases of `nilas verify`

Each case is a scene of `apps/scenes/verify`, which the engine runs like any other scene. The inputs
below enter as overrides of scene attributes, as `--set` makes them, so each case can also be run by
hand.

The expected values are computed from the inputs, for the law of the run. Where a simplified law has
an artefact, the expected value includes it. Every case runs a second time with one input 10 %
larger. There are three kinds of formulas:

- Most formulas are those of the time step itself, with `theta` = 1 (`semi-implicit-euler`) or 0.5
  (`moreau`).
- Where no such formula is known, the limit of small steps is expected. The error must then fall at
  the proven order.
- With the integrator `reference` the formulas of continuous time are expected.

The commands are:

    nilas verify                     runs the default set
    nilas verify --all               runs every solver with every integrator
    nilas verify --case D35 --json   runs one case and prints all rows as JSON
    nilas verify --html --out DIR    writes verify.html, with a plot per family, and verify.csv

The error of a quantity is |measured - expected| over its scale. The scale is the expected value, or
a typical value where the expected value is zero or small. The CSV file and the JSON call it `scale`.
Durations and positions that are not inputs are in the sources in `apps/verify`.

This page is written by `nilas verify --markdown`.
)";

constexpr const char* k_absent = R"(
## Cases that are absent

The numbers are those of a longer list of analytic cases. These cases of the list are absent:

| case | reason |
|---|---|
| 12, block on an accelerating wedge | A body cannot be driven along a path. |
| 22, spinning and sliding hoop | The limit needs 64 contacts around a rim, and a flat face has four. |
| 24, Euler's disc; 29, heavy top on its tip | Long runs on one sharp point are outside of what the program claims. |
| 43, wedge between two blocks; 47, arch | No meshes were made for their shapes. |
| 44 and 45, oscillators on a spring | Only vessels have springs, at their load cells and at the joints of their parts. |
| 46, capstan | There is no rope. |
| 58, a tip on two hinges | Only the parts of a vessel can have several hinges. Tests in `tests/core/vessel/tree` cover them. |

Number 32 of the list is a double pendulum. Here it is the free rotation without the gyroscopic
torque, and `tests/core/vessel/tree/jointed_pendulum_test.cpp` covers the double pendulum.
)";

}  // namespace

std::string catalogue_markdown() {
  std::string text = k_head;
  char family = 0;
  for (const auto& one : catalogue()) {
    if (one.family != family) text += fmt::format("\n## {} {}\n", one.family, family_title(one.family));
    family = one.family;
    text += fmt::format("\n**{} {}.** {}\n", one.id(), one.title, one.formula);
    text += fmt::format("Inputs: {}. Scene `{}`{}. Laws: {}. Limits: {}. Source: {}.\n", inputs_text(one), one.scene,
                        one.also.empty() ? "" : ", `" + joined(one.also, "`, `") + "`", joined(one.laws, ", "),
                        limit_text(one), one.source);
    if (!one.note.empty()) text += one.note + "\n";
  }
  return text + k_absent;
}

}  // namespace nilas::verify
