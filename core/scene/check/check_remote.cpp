#include "core/choices/contact_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

void check_remote_control(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults) {
  const SceneElement* remote = child_of(vessel, "remote_control");
  if (!remote) return;
  for (const char* held : {"fixed", "carriage"})
    if (child_of(vessel, held))
      faults.push_back(fault_of(
          *remote, "found <" + std::string(held) + ">, which moves or holds the vessel; allowed: a free vessel"));
  for (const char* other : {"manoeuvre", "control"})
    if (const SceneElement* controller = child_of(vessel, other);
        controller && text_of(*controller, "mode").value_or("") != "none")
      faults.push_back(
          fault_of(*remote, "found <" + std::string(other) + ">, which gives commands too; allowed: one of them"));
  constexpr std::size_t k_longest = 107;  // bytes that the system takes
  if (const auto socket = text_of(*remote, "socket"); socket && (socket->empty() || socket->size() > k_longest))
    faults.push_back(
        fault_of(*remote, "socket", "found a path of " + std::to_string(socket->size()) + " bytes; allowed: 1 to 107"));
  const SceneElement* contact = child_of(root, "contact");
  if (contact && choice_of<Integrator>(*contact, "integrator") == Integrator::reference)
    faults.push_back(fault_of(*remote,
                              "integrator 'reference' does not take <remote_control>; allowed: moreau, "
                              "semi-implicit-euler"));
}

}  // namespace nilas::scene
