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

namespace nilas::compare {

/// The table of a study on disk and in memory, which gets a row as each run ends.
class ProblemTable {
 public:
  /// Begins an empty table. Throws FileError.
  explicit ProblemTable(const std::filesystem::path& file);
  /// Continues after the rows of earlier sessions. Throws FileError.
  ProblemTable(const std::filesystem::path& file, StoredRows stored);

  void add(const StudyRow& row);
  bool holds(const StudyRow& row) const { return keys_.count(key_of(row)) > 0; }
  const std::vector<StudyRow>& rows() const { return rows_; }
  /// Writes the whole table again, sorted. Throws FileError.
  void close();

 private:
  /// The problem, solver, law and tolerance of a run.
  using RunKey = std::tuple<std::string, std::string, std::string, double>;
  static RunKey key_of(const StudyRow& row);

  std::filesystem::path file_;
  std::vector<StudyRow> rows_;
  std::unique_ptr<output::OutputFile> disk_;
  std::set<RunKey> keys_;
};

/// A study with its folder, its problems and its plan.
struct OpenedProblems {
  ProblemStudyOptions options;
  StudyFolder folder;
  std::vector<StudyFile> files;
  ProblemTable table;
  StudyPlan plan;
  ProblemReport report;  ///< the report without its rows
  double wall_before_s;  ///< wall time of earlier sessions [s]
  std::size_t stored;    ///< number of rows of earlier sessions
  double started_s;      ///< start of the budget, on the clock of steady_seconds() [s]

  double elapsed_s() const;
};

/// The name of the report as JSON in the folder of the study.
constexpr const char* k_problem_json = "compare.json";
/// The name of the folder, within that of the study, for the output of runs until it is judged.
constexpr const char* k_problem_work = ".runs";

/// Takes the folder of a new study or opens that of an earlier one, and makes the plan. Throws InputError, FileError.
OpenedProblems open_problems(const ProblemStudyOptions& asked);

}  // namespace nilas::compare
