#pragma once
/// The attributes in which the scenes of several runs differ.
#include <string>
#include <vector>

namespace nilas::report {

/// An attribute, and its value in each scene; empty where a scene does not have it.
struct SceneDifference {
  std::string path;  ///< "ice/field[2]/@concentration"
  std::vector<std::string> values;
};

/// The attributes in which scenes as run differ, in the order of their first appearance. Elements of the same name are
/// told apart by their `name`, else by their number. Folder and intervals of the output do not count. Throws InputError
/// for text that is no XML.
std::vector<SceneDifference> scene_differences(const std::vector<std::string>& scenes);

}  // namespace nilas::report
