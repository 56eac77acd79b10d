#pragma once
/// Choices of a scene's <output>.
#include "core/choices/choice.h"

namespace nilas {

/// Which contacts a run stores.
enum class StoredContacts { hull, all, none };
constexpr ChoiceText choice_text(StoredContacts value) {
  switch (value) {
    case StoredContacts::hull:
      return {"hull", "The contacts of the vessel and of fixed bodies are stored."};
    case StoredContacts::all:
      return {"all", "The contacts of all bodies are stored. Integrator reference does not allow this."};
    case StoredContacts::none:
      return {"none", "No contacts are stored."};
  }
  return {};
}

/// Which contact problems a run stores.
enum class StoredProblems { never, worst, failed, every };
constexpr ChoiceText choice_text(StoredProblems value) {
  switch (value) {
    case StoredProblems::never:
      return {"never", "No problem is stored."};
    case StoredProblems::worst:
      return {"worst", "The problem with the largest residual so far is stored."};
    case StoredProblems::failed:
      return {"failed", "Problems whose solver missed its tolerance are stored."};
    case StoredProblems::every:
      return {"every", "The problem of every step is stored."};
  }
  return {};
}

/// Which mesh of the hull a viewer draws at first.
enum class ViewedMesh { collision, fluid };
constexpr ChoiceText choice_text(ViewedMesh value) {
  switch (value) {
    case ViewedMesh::collision:
      return {"collision", "The convex pieces that meet the ice are drawn."};
    case ViewedMesh::fluid:
      return {"fluid", "The closed surface that meets the water is drawn."};
  }
  return {};
}

}  // namespace nilas
