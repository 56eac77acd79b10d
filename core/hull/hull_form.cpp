/// Hull forms from the names that scenes and flags use.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/hull/hull.h"

namespace nilas::hull {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(word, known);
  std::string list;
  for (const auto& name : known) list += (list.empty() ? "" : ", ") + name;
  throw InputError("hull form: " + what + " '" + word + "'; allowed: " + list +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

/// Members of a form by XML name, in the order of the documentation.
struct NamedMembers {
  std::vector<std::pair<std::string, double*>> lengths, angles;

  explicit NamedMembers(HullForm& form) {
    const bool icebreaker = form.kind == HullKind::icebreaker;
    lengths = {{"length", &form.length},
               {"beam", &form.beam},
               {"draught", &form.draught},
               {"depth", &form.depth},
               {"bow_length", &form.bow_length}};
    if (!icebreaker) return;
    lengths.emplace_back("stern_length", &form.stern_length);
    angles = {{"stem_angle_deg", &form.stem_angle},
              {"entrance_angle_deg", &form.entrance_angle},
              {"flare_angle_deg", &form.flare_angle}};
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all{"triangles"};
    for (const auto& list : {lengths, angles})
      for (const auto& entry : list) all.push_back(entry.first);
    return all;
  }
};

double* member(const std::vector<std::pair<std::string, double*>>& list, const std::string& name) {
  for (const auto& [known, place] : list)
    if (known == name) return place;
  return nullptr;
}

int count_of(double value) {
  constexpr double k_most = 1e9;  // fits an int; the form's own limits are far below
  if (!(std::abs(value) < k_most) || value != std::round(value))
    throw InputError("hull form: triangles is " + std::to_string(value) + "; allowed: a whole number");
  return static_cast<int>(value);
}

}  // namespace

HullForm hull_form(const std::string& kind, const std::map<std::string, double>& parameters) {
  const auto known = find_choice<HullKind>(kind);
  if (!known) refuse("unknown kind", kind, choice_names<HullKind>());
  return hull_form(*known, parameters);
}

HullForm hull_form(HullKind kind, const std::map<std::string, double>& parameters) {
  HullForm form;
  form.kind = kind;
  const NamedMembers members(form);
  const auto length = parameters.find("length");
  const double scale = length == parameters.end() ? 1 : length->second / form.length;
  for (const auto& entry : members.lengths) *entry.second *= scale;
  for (const auto& [name, value] : parameters) {
    if (double* place = member(members.lengths, name))
      *place = value;
    else if (double* angle = member(members.angles, name))
      *angle = value * k_deg;
    else if (name == "triangles")
      form.triangles = count_of(value);
    else
      refuse("a form of kind '" + name_of(kind) + "' has no parameter", name, members.names());
  }
  return form;
}

}  // namespace nilas::hull
