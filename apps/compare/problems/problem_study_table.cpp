#include "apps/compare/problems/problem_study_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/special_numbers.h"
#include "contact/registry.h"
#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/output/file/csv_row.h"

namespace nilas::compare {

namespace {

/// A column: how it is written as text and as JSON, and how it is read.
struct Column {
  std::string name;
  std::function<void(const StudyRow&, output::CsvRow&)> write;
  std::function<Json(const StudyRow&)> value;
  std::function<bool(StudyRow&, const std::string&)> read;
};

template <class Number>
bool parse(const std::string& text, Number& value) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && stop == text.data() + text.size();
}

void write_cell(const std::string& x, output::CsvRow& out) { out.text(x); }
void write_cell(int x, output::CsvRow& out) { out.integer(x); }
void write_cell(double x, output::CsvRow& out) { std::isnan(x) ? out.text("") : out.shortest(x); }

Json cell_json(const std::string& x) { return x; }
Json cell_json(int x) { return x; }
Json cell_json(double x) { return std::isfinite(x) ? Json(x) : Json(); }

bool read_cell(const std::string& text, std::string& x) {
  x = text;
  return true;
}
bool read_cell(const std::string& text, int& x) { return parse(text, x); }
bool read_cell(const std::string& text, double& x) {
  x = k_unknown;
  return text.empty() || parse(text, x);
}

/// The column of a member of the row. `get` returns a reference to it.
template <class Get>
Column column(const std::string& name, Get get) {
  return {name, [get](const StudyRow& row, output::CsvRow& out) { write_cell(get(row), out); },
          [get](const StudyRow& row) { return cell_json(get(row)); },
          [get](StudyRow& row, const std::string& text) { return read_cell(text, get(row)); }};
}

bool read_outcome(StudyRow& row, const std::string& text) {
  for (int k = 0; k <= static_cast<int>(RunOutcome::unreadable); ++k) {
    row.outcome = static_cast<RunOutcome>(k);
    if (text == to_string(row.outcome)) return true;
  }
  return false;
}

std::vector<Column> make_columns() {
  std::vector<Column> all{column(
                              "problem", [](auto& r) -> auto& { return r.problem.name; }),
                          column(
                              "form", [](auto& r) -> auto& { return r.problem.form; }),
                          column(
                              "contacts", [](auto& r) -> auto& { return r.problem.contacts; }),
                          column(
                              "velocities", [](auto& r) -> auto& { return r.problem.velocities; }),
                          column(
                              "mass_ratio_1", [](auto& r) -> auto& { return r.problem.mass_ratio; }),
                          column(
                              "solver", [](auto& r) -> auto& { return r.solver; }),
                          column(
                              "law", [](auto& r) -> auto& { return r.law; }),
                          column(
                              "tolerance_m_s", [](auto& r) -> auto& { return r.tolerance; }),
                          {"outcome", [](const StudyRow& r, output::CsvRow& out) { out.text(to_string(r.outcome)); },
                           [](const StudyRow& r) { return Json(to_string(r.outcome)); }, read_outcome},
                          column(
                              "claimed", [](auto& r) -> auto& { return r.claimed; }),
                          column(
                              "iterations", [](auto& r) -> auto& { return r.iterations; }),
                          column(
                              "solve_s", [](auto& r) -> auto& { return r.seconds; })};
  for (const auto& residual : contact::residual_columns())
    all.push_back(column(
        residual.name, [member = residual.member](auto& r) -> auto& { return r.residuals.*member; }));
  all.push_back(column(
      "open", [](auto& r) -> auto& { return r.open; }));
  all.push_back(column(
      "sticking", [](auto& r) -> auto& { return r.sticking; }));
  all.push_back(column(
      "sliding", [](auto& r) -> auto& { return r.sliding; }));
  all.push_back(column(
      "process_wall_s", [](auto& r) -> auto& { return r.wall; }));
  all.push_back(column(
      "process_cpu_s", [](auto& r) -> auto& { return r.cpu; }));
  all.push_back(column(
      "exit_code", [](auto& r) -> auto& { return r.exit_code; }));
  all.push_back(column(
      "message", [](auto& r) -> auto& { return r.message; }));
  return all;
}

const std::vector<Column>& study_columns() {
  static const std::vector<Column> all = make_columns();
  return all;
}

bool read_row(const std::vector<std::string>& cells, StudyRow& row) {
  if (cells.size() != study_columns().size()) return false;
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (!study_columns()[k].read(row, cells[k])) return false;
  return true;
}

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const auto& one : study_columns()) names.push_back(one.name);
  return names;
}

std::size_t place_of(const std::string& solver) {
  const auto& all = contact::solver_registry();
  return static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [&](const contact::SolverEntry& entry) { return entry.name == solver; }) -
      all.begin());
}

}  // namespace

std::string study_header() { return output::csv_header(column_names()); }

std::string study_line(const StudyRow& row) {
  output::CsvRow out;
  for (const auto& one : study_columns()) one.write(row, out);
  return std::string(out.line());
}

Json study_json(const StudyRow& row) {
  Json object = Json::object();
  for (const auto& one : study_columns()) object[one.name] = one.value(row);
  return object;
}

StoredRows read_study(const std::filesystem::path& file) {
  const CsvRecords records = csv_records(file);
  if (records.header != column_names())
    throw InputError(file.string() + ":1: the line is no header of a study of stored problems of this version");
  StoredRows stored;
  for (const auto& cells : records.rows) {
    StudyRow row;
    if (!read_row(cells, row))
      throw InputError(file.string() + ":" + std::to_string(stored.rows.size() + 2) +
                       ": the line is no row of a study");
    stored.rows.push_back(row);
  }
  stored.bytes = records.bytes;
  return stored;
}

void sort_study(std::vector<StudyRow>& rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const StudyRow& a, const StudyRow& b) {
    if (a.problem.name != b.problem.name) return a.problem.name < b.problem.name;
    if (a.law != b.law) return a.law < b.law;
    const std::size_t first = place_of(a.solver), second = place_of(b.solver);
    return first != second ? first < second : a.tolerance > b.tolerance;
  });
}

}  // namespace nilas::compare
