#pragma once
/// What a comparison leaves: tables, JSON, pictures, a page and a paragraph.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/merits.h"
#include "apps/compare/scenes/report/outlook.h"
#include "apps/compare/scenes/run/study_folder.h"

namespace nilas {

/// How the runs shared the machine.
struct StudyTiming {
  int jobs = 1;
  int cores = 1;  ///< that the jobs could use
  double elapsed_s = 0;
  double busy = std::numeric_limits<double>::quiet_NaN();  ///< jobs that were at work, on average
  /// Time of the first setting's first steps beside neighbours over their time alone; NaN: not measured.
  double slowdown = std::numeric_limits<double>::quiet_NaN();

  /// Share of the work of as many cores that was done; NaN where neighbours were not measured.
  double efficiency() const { return busy / jobs / slowdown; }
};

class StudyOutputs {
 public:
  /// All must outlive this. `late`: runs that did not begin; `trouble`: of the probe, where it made no step;
  /// `ended_by`: why it did not come to its end.
  StudyOutputs(const Study& study, const Findings& findings, const StudyTiming& timing,
               const std::vector<std::string>& late, std::string trouble, std::string ended_by, Outlook view);

  /// compare.html without pictures, before they are drawn or anything was run. Throws FileError.
  void write_page(const std::filesystem::path& folder) const;
  /// compare.csv, settings.csv, loads.csv, compare.json, then pictures and compare.html. Returns why there are no
  /// pictures, or nothing. Throws FileError where a table or the page cannot be written.
  std::string write(const std::filesystem::path& folder) const;
  /// Whether anything could be judged.
  bool compared() const;
  /// What is not to be trusted, or not done, and why.
  std::vector<std::string> warnings() const;
  /// The paragraph, the warnings and what more time would tell, a line per sentence; commands begin with two blanks.
  std::string text() const;
  nlohmann::ordered_json json() const;

 private:
  std::string runs_csv() const;
  std::string settings_csv() const;
  std::string loads_csv() const;
  std::string label(std::size_t setting) const;
  std::vector<std::string> labels() const;
  std::vector<std::string> sentences() const;
  void say_horizon(std::vector<std::string>& lines) const;
  void say_price(std::vector<std::string>& lines) const;
  void say_peaks(const Merit& merit, std::vector<std::string>& lines) const;
  /// What means over realisations stand for.
  std::string such_ice() const;
  /// There is a vessel, and no load on it.
  bool untouched() const;
  void say_ablation(std::vector<std::string>& lines) const;
  std::string page(const std::filesystem::path& folder, const std::vector<std::string>& pictures,
                   const std::string& instead) const;
  std::string own_setting() const;
  std::string blocked() const;
  std::string settings_table() const;
  std::string runs_table() const;
  std::string how_measured() const;
  std::vector<std::string> load_notes() const;
  /// What is taken out of the scene, put back one at a time, and what cannot be.
  std::vector<std::string> ablation_notes() const;

  const Study& study_;
  const Findings& found_;
  const StudyTiming& timing_;
  const std::vector<std::string>& late_;
  std::string trouble_;
  std::string ended_by_;
  Outlook outlook_;
};

/// "1.23 N", "0.45 mm": a length, force or angle with a readable unit.
std::string quantity_text(double value, const std::string& unit);

}  // namespace nilas
