#pragma once
/// A study of stored problems: its options, folder, problems and plan, and the table of its runs.
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "apps/compare/problems/problem_report.h"
#include "apps/compare/problems/problem_study.h"
#include "apps/compare/problems/problem_study_plan.h"
#include "apps/compare/problems/problem_study_table.h"
#include "apps/compare/workshop/study_folder.h"
#include "core/output/file/output_file.h"

namespace nilas {

/// The table of a study on disk and in memory: a row per run as each ends.
class ProblemTable {
 public:
  /// Begins an empty one.
  explicit ProblemTable(const std::filesystem::path& file);
  /// Goes on after the rows of earlier sessions.
  ProblemTable(const std::filesystem::path& file, StoredRows stored);

  void add(const StudyRow& row);
  bool holds(const StudyRow& row) const { return keys_.count(key_of(row)) > 0; }
  const std::vector<StudyRow>& rows() const { return rows_; }
  /// Writes it once more, sorted.
  void close();

 private:
  /// Problem, solver, law and tolerance.
  using RunKey = std::tuple<std::string, std::string, std::string, double>;
  static RunKey key_of(const StudyRow& row);

  std::filesystem::path file_;
  std::vector<StudyRow> rows_;
  std::unique_ptr<OutputFile> disk_;
  std::set<RunKey> keys_;
};

/// A study with its folder, its problems and its plan.
struct OpenedProblems {
  ProblemStudyOptions options;
  StudyFolder folder;
  std::vector<StudyFile> files;
  ProblemTable table;
  StudyPlan plan;
  ProblemReport report;  ///< but for its rows
  double wall_before_s;  ///< of earlier sessions
  std::size_t stored;    ///< rows of earlier sessions
  double started_s;      ///< by steady_seconds()

  double elapsed_s() const;
};

/// Folder of a study, within its own, for what runs print until it is judged.
constexpr const char* k_problem_work = ".runs";

/// Takes the folder of a new study or goes on with an earlier one, and plans. Throws InputError, FileError.
OpenedProblems open_problems(const ProblemStudyOptions& asked);

}  // namespace nilas
