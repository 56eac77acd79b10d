#include "apps/report/run/run_table.h"

#include <algorithm>
#include <fstream>

#include "core/base/csv.h"
#include "core/base/error.h"

namespace nilas::report {

namespace {

std::vector<std::string> header_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) throw FileError(file.string() + ": cannot be read");
  CsvLine fields;
  fields.split(line);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < fields.size(); ++k) names.emplace_back(fields[k]);
  return names;
}

}  // namespace

RunTable::RunTable(const std::filesystem::path& file)
    : file_(file), names_(header_of(file)), columns_(csv_columns(file, names_)) {
  (void)place_of("time_s");
}

bool RunTable::has(const std::string& name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

std::size_t RunTable::place_of(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw InputError(file_.string() + ": the table has no column " + name);
  return static_cast<std::size_t>(found - names_.begin());
}

const std::vector<double>& RunTable::operator[](const std::string& name) const { return columns_[place_of(name)]; }

std::vector<std::string> RunTable::texts(const std::string& name) const {
  const std::size_t place = place_of(name);
  std::ifstream in(file_);
  std::vector<std::string> texts;
  std::string line;
  CsvLine fields;
  std::getline(in, line);
  while (texts.size() < rows() && std::getline(in, line)) {
    fields.split(line);
    texts.emplace_back(fields[place]);
  }
  if (in.bad() || texts.size() < rows()) throw FileError(file_.string() + ": cannot be read");
  return texts;
}

}  // namespace nilas::report
