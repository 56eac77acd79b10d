#include "core/scene/elements/field_scene.h"

namespace nilas::scene {

const RegionScene* FieldScene::region() const {
  return std::visit(Overloaded{[](const ChannelFieldScene& channel) { return &channel.ice.region; },
                               [](const FileFieldScene&) -> const RegionScene* { return nullptr; },
                               [](const auto& laid_out) { return &laid_out.region; }},
                    form);
}

const SizeScene* FieldScene::size() const {
  return std::visit(Overloaded{[](const PackedFieldScene& packed) { return &packed.size; },
                               [](const VoronoiFieldScene& cells) { return &cells.size; },
                               [](const ChannelFieldScene& channel) { return &channel.ice.size; },
                               [](const GridFieldScene&) -> const SizeScene* { return nullptr; },
                               [](const LevelFieldScene&) -> const SizeScene* { return nullptr; },
                               [](const FileFieldScene&) -> const SizeScene* { return nullptr; }},
                    form);
}

}  // namespace nilas::scene
