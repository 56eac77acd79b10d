#pragma once
/// Recorded contact problems for tests: those of tests/data/fclib, and the FCLIB collection if NILAS_FCLIB_DIR names
/// its folder.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "contact/fclib/fclib_io.h"

namespace nilas::test {

/// The files of tests/data/fclib, by name.
inline std::vector<std::filesystem::path> own_problems() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(NILAS_SOURCE_DIR) / "tests/data/fclib"))
    if (entry.path().extension() == ".hdf5") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The files of the folder NILAS_FCLIB_DIR, by name; none where it is not set. Throws if there is no such folder.
inline std::vector<std::filesystem::path> collected_problems() {
  std::vector<std::filesystem::path> files;
  const char* const folder = std::getenv("NILAS_FCLIB_DIR");
  if (folder == nullptr) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".hdf5") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// All recorded problems, our own first.
inline std::vector<std::filesystem::path> recorded_problems() {
  std::vector<std::filesystem::path> files = own_problems();
  for (auto& file : collected_problems()) files.push_back(std::move(file));
  return files;
}

/// Our own problem of this name, "stack-10-1e6".
inline std::filesystem::path own_problem(const std::string& name) {
  return std::filesystem::path(NILAS_SOURCE_DIR) / "tests/data/fclib" / (name + ".hdf5");
}

/// The problem of this name in the collection, as a list of one; empty where NILAS_FCLIB_DIR is not set.
inline std::vector<std::filesystem::path> collected_problem(const std::string& name) {
  const char* const folder = std::getenv("NILAS_FCLIB_DIR");
  if (folder == nullptr) return {};
  return {std::filesystem::path(folder) / (name + ".hdf5")};
}

/// The local form of a file's problem.
inline contact::LocalProblem local_form(const contact::FclibProblem& file) {
  const auto* const local = std::get_if<contact::LocalProblem>(&file.problem);
  return local != nullptr ? *local : contact::reduce(std::get<contact::ContactProblem>(file.problem));
}

}  // namespace nilas::test
