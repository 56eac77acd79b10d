#pragma once
/// The pages of a replay, of a live view and of a report: each one HTML file that needs nothing else.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace nilas::view {

/// Throws InputError where the program was built without the page, which needs npm once, with how to build it with one.
void demand_page();

/// The page that follows a run over the network. `title`: the name of the scene.
std::string live_page(const std::string& title, const std::string& token);

/// The page that holds a whole replay. `bytes`: those of replay.bin, complete or cut.
std::string replay_page(const std::string& title, std::string_view bytes);

/// The page of a report. `body`: its elements as HTML; `data`: what its script draws, as apps/view/page/src/report
/// reads it.
std::string report_page(const std::string& title, const std::string& body, const nlohmann::ordered_json& data);

}  // namespace nilas::view
