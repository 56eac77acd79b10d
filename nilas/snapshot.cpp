#include <utility>

#include "nilas/snapshot_content.h"

namespace nilas {

Snapshot::Snapshot(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Snapshot::Snapshot(const Snapshot& other) : content_(std::make_unique<Content>(*other.content_)) {}
Snapshot::Snapshot(Snapshot&& other) noexcept = default;
Snapshot::~Snapshot() = default;

}  // namespace nilas
