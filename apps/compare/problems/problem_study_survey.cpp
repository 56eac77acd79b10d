#include <algorithm>
#include <chrono>
#include <set>

#include "apps/compare/problems/problem_study_plan.h"
#include "apps/compare/workshop/special_numbers.h"
#include "contact/fclib/fclib_io.h"
#include "core/base/error.h"

namespace nilas::compare {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> problem_files(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw FileError(folder.string() + ": there is no such folder");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    if ((kind == ".hdf5" || kind == ".h5") && !entry.is_directory()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw InputError(folder.string() + ": found no contact problem; allowed: files in FCLIB format, *.hdf5 or *.h5 (" +
                     "nilas problems --export writes some)");
  return files;
}

/// The text without line breaks, so that a row of a table is one line.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void look_into(StudyFile& file) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const contact::FclibProblem problem = contact::read_fclib(file.path);
    const auto* const global = std::get_if<contact::ContactProblem>(&problem.problem);
    file.problem.form = global ? "global" : "local";
    file.problem.contacts = global ? global->num_points() : problem.num_contacts();
    file.problem.velocities = problem.num_velocities();
    file.moments = global && global->has_moments();
    if (global) file.problem.mass_ratio = contact_mass_ratio(*global);
  } catch (const std::exception& error) {
    file.fault = on_one_line(error.what());
  }
  file.reading_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

double contact_mass_ratio(const contact::ContactProblem& problem) {
  double lightest = k_infinity, heaviest = 0;
  const auto see = [&](int block, const MatX& rows) {
    if (block < 0) return;
    const MatX mass = problem.mass(block);
    const double inverse = (rows * mass.ldlt().solve(rows.transpose())).trace() / 3;
    if (!(inverse > 0)) return;
    lightest = std::min(lightest, 1 / inverse);
    heaviest = std::max(heaviest, 1 / inverse);
  };
  for (int c = 0; c < problem.num_contacts(); ++c) {
    if (problem.is_moment(c)) continue;
    const auto& pair = problem.pairs[c];
    see(pair.a, problem.jacobian_a(c));
    see(pair.b, problem.jacobian_b(c));
  }
  return heaviest > 0 ? heaviest / lightest : k_unknown;
}

std::vector<StudyFile> survey(const fs::path& folder) {
  std::vector<StudyFile> files;
  std::multiset<std::string> stems;
  for (const auto& path : problem_files(folder)) {
    files.emplace_back().path = path;
    stems.insert(path.stem().string());
  }
  for (auto& file : files) {
    const std::string stem = file.path.stem().string();
    file.problem.name = stems.count(stem) == 1 ? stem : file.path.filename().string();
    look_into(file);
  }
  if (std::all_of(files.begin(), files.end(), [](const StudyFile& file) { return !file.fault.empty(); }))
    throw InputError(folder.string() + ": none of its " + std::to_string(files.size()) +
                     " files can be read; the fault of the first is: " + files.front().fault);
  return files;
}

}  // namespace nilas::compare
