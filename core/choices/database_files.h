#pragma once
/// The files that belong to a hydrodynamic database.
#include <filesystem>
#include <vector>

namespace nilas {

/// Whether the name of a file is that of a WAMIT result that is read here: .1, .2, .3, .4, .8, .9, .hst or .gdf. An
/// ending may be in capitals.
bool is_wamit_file(const std::filesystem::path& file);

/// The files that are read where `file` is named as a database. For a WAMIT file these are all of the same stem and
/// folder that are there, in the order of the list above. For another file it is that file alone.
std::vector<std::filesystem::path> database_files(const std::filesystem::path& file);

}  // namespace nilas
