#pragma once
/// What to do about steps that the contact solver did not solve.

namespace nilas::sim {

/// In lines of a terminal's width, those after the first indented.
constexpr const char* k_unsolved_advice =
    "Ice that is jammed\n"
    "  between bodies may lock, and then no solver helps: let it crush\n"
    "  (<fracture><crushing>) or make its contacts elastic\n"
    "  (<friction elastic=\"true\">). Elsewhere more iterations may help\n"
    "  (contact/@max_iterations)";

}  // namespace nilas::sim
