#pragma once
/// The page of a replay or of a live view: one HTML file that needs nothing else.
#include <filesystem>
#include <string>
#include <string_view>

namespace nilas::view {

/// Throws InputError where the program was built without the page, which needs npm once, with how to build it with one.
void demand_page();

/// The page that follows a run over the network. `title`: the name of the scene.
std::string live_page(const std::string& title, const std::string& token);

/// The page that holds a whole replay. `bytes`: those of replay.bin, complete or cut.
std::string replay_page(const std::string& title, std::string_view bytes);

}  // namespace nilas::view
