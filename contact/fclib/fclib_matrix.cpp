#include "contact/fclib/fclib_matrix.h"

#include <algorithm>
#include <tuple>

namespace nilas::contact {

namespace {

constexpr int k_compressed_columns = -1;
constexpr int k_compressed_rows = -2;
/// Declared room beyond this and beyond so many times the places of the matrix is a damaged number. Writers reserve 48
/// entries per contact whatever the size.
constexpr long long k_small_room = 1000, k_spare_room = 4;

/// The datasets of one group as they are in the file.
struct RawMatrix {
  std::string group;
  int rows = 0, columns = 0, storage = 0;
  std::vector<int> p, i;
  VecX x;
};

std::string number(long long n) { return std::to_string(n); }

void demand_extent(const hdf5::Hdf5Reader& file, const std::string& name, int needed) {
  const int found = file.integer(name);
  if (found != needed) file.refuse(name, "is " + number(found) + ", needs to be " + number(needed));
}

/// `stored`: how many entries there are.
void check_room(const hdf5::Hdf5Reader& file, const RawMatrix& raw, long long stored) {
  const std::string name = raw.group + "/nzmax";
  const int room = file.integer(name);
  const long long places = static_cast<long long>(raw.rows) * raw.columns;
  if (room < stored || room > std::max({k_small_room, k_spare_room * places, stored}))
    file.refuse(name,
                "is " + number(room) + " with " + number(stored) + " entries stored of a matrix of " + number(places));
}

void demand_length(const hdf5::Hdf5Reader& file, const std::string& name, long long found, long long needed) {
  if (found < needed) file.refuse(name, "has " + number(found) + " entries, needs " + number(needed));
}

bool within(const std::vector<int>& indices, int count, int bound) {
  return std::all_of(indices.begin(), indices.begin() + count, [bound](int k) { return k >= 0 && k < bound; });
}

/// Whether every column is named.
bool fills_columns(const std::vector<int>& indices, int count, int columns) {
  std::vector<bool> named(static_cast<std::size_t>(columns));
  for (int k = 0; k < count; ++k) named[indices[k]] = true;
  return std::find(named.begin(), named.end(), false) == named.end();
}

/// True where p holds the rows of triplets, false where it holds the columns.
bool rows_first(const hdf5::Hdf5Reader& file, const RawMatrix& raw) {
  const int count = raw.storage;
  const bool rows_in_i = within(raw.p, count, raw.columns) && within(raw.i, count, raw.rows);
  const bool rows_in_p = within(raw.p, count, raw.rows) && within(raw.i, count, raw.columns);
  if (!rows_in_i && !rows_in_p) file.refuse(raw.group + "/i", "an index is outside the matrix");
  if (rows_in_i != rows_in_p) return rows_in_p;
  return raw.rows != raw.columns && !fills_columns(raw.p, count, raw.columns) &&
         fills_columns(raw.i, count, raw.columns);
}

std::vector<MatrixEntry> triplet_entries(const hdf5::Hdf5Reader& file, const RawMatrix& raw) {
  demand_length(file, raw.group + "/p", static_cast<long long>(raw.p.size()), raw.storage);
  demand_length(file, raw.group + "/i", static_cast<long long>(raw.i.size()), raw.storage);
  demand_length(file, raw.group + "/x", raw.x.size(), raw.storage);
  check_room(file, raw, raw.storage);
  const bool swap = rows_first(file, raw);
  std::vector<MatrixEntry> entries;
  entries.reserve(static_cast<std::size_t>(raw.storage));
  for (std::size_t k = 0; k < static_cast<std::size_t>(raw.storage); ++k) {
    const double value = raw.x[static_cast<Eigen::Index>(k)];
    if (value != 0) entries.push_back({swap ? raw.p[k] : raw.i[k], swap ? raw.i[k] : raw.p[k], value});
  }
  return entries;
}

/// Demands pointers that rise from 0 to a number of entries that is there. Returns that number.
int check_pointers(const hdf5::Hdf5Reader& file, const RawMatrix& raw, int lines) {
  const std::string name = raw.group + "/p";
  if (raw.p.size() != static_cast<std::size_t>(lines) + 1)
    file.refuse(name, "has " + number(static_cast<long long>(raw.p.size())) + " entries, needs " + number(lines + 1));
  if (raw.p.front() != 0) file.refuse(name, "begins at " + number(raw.p.front()) + ", needs to begin at 0");
  const auto fall = std::is_sorted_until(raw.p.begin(), raw.p.end());
  if (fall != raw.p.end()) file.refuse(name, "falls at entry " + number(fall - raw.p.begin()));
  demand_length(file, raw.group + "/i", static_cast<long long>(raw.i.size()), raw.p.back());
  demand_length(file, raw.group + "/x", raw.x.size(), raw.p.back());
  check_room(file, raw, raw.p.back());
  return raw.p.back();
}

std::vector<MatrixEntry> compressed_entries(const hdf5::Hdf5Reader& file, const RawMatrix& raw) {
  const bool by_rows = raw.storage == k_compressed_rows;
  const int lines = by_rows ? raw.rows : raw.columns;
  const int count = check_pointers(file, raw, lines);
  if (!within(raw.i, count, by_rows ? raw.columns : raw.rows))
    file.refuse(raw.group + "/i", "an index is outside the matrix");
  std::vector<MatrixEntry> entries;
  entries.reserve(static_cast<std::size_t>(count));
  for (int line = 0; line < lines; ++line)
    for (int k = raw.p[line]; k < raw.p[static_cast<std::size_t>(line) + 1]; ++k) {
      const int across = raw.i[k];
      if (raw.x[k] != 0) entries.push_back({by_rows ? line : across, by_rows ? across : line, raw.x[k]});
    }
  return entries;
}

}  // namespace

bool has_matrix(const hdf5::Hdf5Reader& file, const std::string& group) {
  return file.has(group) && file.integer(group + "/m") > 0 && file.integer(group + "/n") > 0;
}

std::vector<MatrixEntry> read_matrix(const hdf5::Hdf5Reader& file, const std::string& group, int rows, int columns) {
  demand_extent(file, group + "/m", rows);
  demand_extent(file, group + "/n", columns);
  RawMatrix raw{group, rows, columns, file.integer(group + "/nz"), {}, {}, {}};
  if (raw.storage < k_compressed_rows)
    file.refuse(group + "/nz", "is " + number(raw.storage) + ", known are -2 (rows), -1 (columns) and counts");
  raw.p = file.integers(group + "/p");
  raw.i = file.integers(group + "/i");
  raw.x = file.numbers(group + "/x");
  return raw.storage >= 0 ? triplet_entries(file, raw) : compressed_entries(file, raw);
}

void add_matrix(hdf5::Hdf5Writer& file, const std::string& group, int rows, int columns,
                std::vector<MatrixEntry> entries) {
  std::sort(entries.begin(), entries.end(), [](const MatrixEntry& a, const MatrixEntry& b) {
    return std::tie(a.column, a.row) < std::tie(b.column, b.row);
  });
  std::vector<int> p(static_cast<std::size_t>(columns) + 1), i;
  std::vector<double> x;
  for (const auto& entry : entries) {
    ++p[static_cast<std::size_t>(entry.column) + 1];
    i.push_back(entry.row);
    x.push_back(entry.value);
  }
  for (std::size_t k = 1; k < p.size(); ++k) p[k] += p[k - 1];
  file.add_group(group);
  file.add(group + "/m", std::vector<int>{rows});
  file.add(group + "/n", std::vector<int>{columns});
  file.add(group + "/nzmax", std::vector<int>{p.back()});
  file.add(group + "/nz", std::vector<int>{k_compressed_columns});
  file.add(group + "/p", p);
  file.add(group + "/i", i);
  file.add(group + "/x", x);
}

}  // namespace nilas::contact
