#include "apps/report/run/hull_contacts.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/hdf5/hdf5_columns.h"

namespace nilas::report {

namespace {

using Columns3 = std::array<std::vector<double>, 3>;

class ContactTable {
 public:
  explicit ContactTable(const std::filesystem::path& path) : path_(path), file_(path) {
    if (!file_.has("steps")) throw InputError(path.string() + ": the file holds no steps");
    const auto index = hdf5::whole_blocks(file_.wide_integers("steps"));
    steps = index.size() / 2;
    rows = index.empty() ? 0 : static_cast<std::size_t>(index.back());
  }
  std::vector<double> numbers(const std::string& name) const {
    demand(name);
    return file_.first_numbers("contacts/" + name, rows);
  }
  std::vector<std::int64_t> integers(const std::string& name) const {
    demand(name);
    return file_.first_integers("contacts/" + name, rows);
  }
  /// The columns of a vector, whose names have this before and after the axis.
  Columns3 vectors(const std::string& before, const std::string& after) const {
    return {numbers(before + "x" + after), numbers(before + "y" + after), numbers(before + "z" + after)};
  }

  std::size_t rows = 0, steps = 0;

 private:
  void demand(const std::string& name) const {
    if (!file_.has("contacts/" + name)) throw InputError(path_.string() + ": the file has no column " + name);
  }
  std::filesystem::path path_;
  hdf5::Hdf5Reader file_;
};

Vec3 row_of(const Columns3& columns, std::size_t k) { return {columns[0][k], columns[1][k], columns[2][k]}; }

}  // namespace

HullContacts hull_contacts(const std::filesystem::path& file, const std::vector<std::int64_t>& ids, bool is_vessel) {
  constexpr std::int64_t k_crush = 3;
  const ContactTable table(file);
  const auto time = table.numbers("time_s");
  const auto step = table.integers("step"), body = table.integers("body"), other = table.integers("other"),
             status = table.integers("status");
  const auto place = table.vectors(is_vessel ? "hull_" : "", "_m"), normal = table.vectors("n", ""),
             force = table.vectors("f", "_N"), impulse = table.vectors("impulse_", "_Ns");
  const auto height = table.numbers("z_m");
  HullContacts contacts;
  contacts.steps = table.steps;
  double crushing = 0, all = 0, level = 0;
  for (std::size_t k = 0; k < table.rows; ++k) {
    if (std::find(ids.begin(), ids.end(), body[k]) == ids.end()) continue;
    const Vec3 r = row_of(impulse, k);
    if (r.isZero(0)) continue;
    contacts.time.push_back(time[k]);
    contacts.step.push_back(step[k]);
    contacts.other.push_back(other[k]);
    contacts.place.push_back(row_of(place, k));
    contacts.normal.push_back(row_of(normal, k));
    contacts.force.push_back(row_of(force, k));
    contacts.impulse.push_back(r);
    contacts.crushes.push_back(status[k] == k_crush);
    level += height[k] - place[2][k];
    all += r.norm();
    if (status[k] == k_crush) crushing += r.norm();
  }
  if (!contacts.time.empty()) contacts.floating_level = level / static_cast<double>(contacts.time.size());
  if (all > 0) contacts.share_crushing = crushing / all;
  return contacts;
}

}  // namespace nilas::report
