#include "core/base/state.h"

#include "core/base/error.h"

namespace nilas {

void StateWriter::put(const std::string& name, StateEntry entry) {
  const bool added = state_->entries.emplace(group_ + name, std::move(entry)).second;
  NILAS_DEMAND(added);
}

void StateReader::refuse(const std::string& name, const std::string& fault) const {
  throw InputError(state_->source + ": " + group_ + name + ": " + fault);
}

const StateEntry& StateReader::find(const std::string& name, std::size_t kind) const {
  const auto found = state_->entries.find(group_ + name);
  if (found == state_->entries.end()) refuse(name, "is missing");
  if (found->second.index() != kind) refuse(name, "holds another kind of values");
  return found->second;
}

void StateReader::demand(const std::string& name, std::size_t found, std::size_t expected) const {
  if (found != expected) refuse(name, "has " + std::to_string(found) + " entries, needs " + std::to_string(expected));
}

}  // namespace nilas
