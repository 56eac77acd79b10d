#include <hdf5.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/hdf5/hdf5_file.h"

namespace nilas::hdf5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// Most that a compressed dataset may grow when read; deflate cannot exceed 1032.
constexpr std::size_t k_largest_inflation = 1100;
/// Most bytes that a compressed dataset may take once it is read.
constexpr std::size_t k_most_inflated = std::size_t{1} << 30;
/// Longest text that is read [bytes]; titles and descriptions are far below.
constexpr std::size_t k_longest_text = 1 << 16;

Hdf5Silence::Hdf5Silence() {
  // Nothing stays open at the end but what a damaged file kept HDF5 from closing, and that it would complain about.
  H5dont_atexit();
  H5Eget_auto2(H5E_DEFAULT, reinterpret_cast<H5E_auto2_t*>(&print_), &print_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Silence::~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, reinterpret_cast<H5E_auto2_t>(print_), print_data_); }

struct Hdf5Reader::Dataset {
  Hdf5Handle id, type, space, properties;
  std::size_t count = 0;
  bool good() const { return id.good() && type.good() && space.good() && properties.good(); }
};

static std::vector<char> read_whole(const std::string& path) {
  std::error_code fault;
  if (std::filesystem::is_directory(path, fault)) throw FileError(path + ": is a folder, not a file");
  demand_file(path);
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in) throw FileError(path + ": cannot be opened");
  const auto end = static_cast<std::streamoff>(in.tellg());
  if (end < 0) throw FileError(path + ": cannot be read");
  std::vector<char> bytes(static_cast<std::size_t>(end));
  in.seekg(0);
  if (!in.read(bytes.data(), end)) throw FileError(path + ": cannot be read");
  return bytes;
}

/// True where the file says that a program has it open for writing: that was killed while it wrote, or does now.
static bool is_marked_open(const std::vector<char>& bytes) {
  constexpr std::size_t k_version_at = 8, k_marks_at = 11;  // of the superblock, versions 2 and 3
  return bytes.size() > k_marks_at && bytes[k_version_at] >= 2 && bytes[k_marks_at] != 0;
}

/// Opens such a file in the mode for a file that another program is writing: its size may not fit its content.
static Hdf5Handle open_marked(const std::string& path) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.get(), false, true);
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get()), H5Fclose);
  if (!file.good()) throw InputError(path + ": is no HDF5 file, or is cut short or damaged");
  return file;
}

/// Opens the bytes of a file as they are in memory.
static Hdf5Handle open_image(const std::string& path, std::vector<char> bytes) {
  if (is_marked_open(bytes)) return open_marked(path);
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t k_growth_bytes = 1 << 16;
  H5Pset_fapl_core(access.get(), k_growth_bytes, false);
  if (bytes.empty() || H5Pset_file_image(access.get(), bytes.data(), bytes.size()) < 0)
    throw InputError(path + ": is empty");
  // HDF5 takes an image only under a name that no file has; below a file there is none.
  Hdf5Handle file(H5Fopen((path + "/image").c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
  if (!file.good()) throw InputError(path + ": is no HDF5 file, or is cut short or damaged");
  return file;
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path)
    : path_(path.string()), file_([this] {
        auto bytes = read_whole(path_);
        file_bytes_ = bytes.size();
        return open_image(path_, std::move(bytes));
      }()) {}

void Hdf5Reader::refuse(const std::string& name, const std::string& fault) const {
  throw InputError(path_ + ": /" + name + ": " + fault);
}

bool Hdf5Reader::has(const std::string& name) const {
  for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
    const std::string part = name.substr(0, end);
    H5L_info_t link;
    if (H5Lexists(file_.get(), part.c_str(), H5P_DEFAULT) <= 0) return false;
    if (H5Lget_info(file_.get(), part.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return false;
    if (end == std::string::npos) return true;
  }
}

Hdf5Reader::Dataset Hdf5Reader::open(const std::string& name) const {
  if (!has(name)) refuse(name, "is missing");
  Hdf5Handle id(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!id.good()) refuse(name, "is no dataset, or is damaged");
  const auto place = id.get();
  Dataset dataset{std::move(id),
                  {H5Dget_type(place), H5Tclose},
                  {H5Dget_space(place), H5Sclose},
                  {H5Dget_create_plist(place), H5Pclose}};
  if (!dataset.good()) refuse(name, "is damaged");
  const hssize_t count = H5Sget_simple_extent_npoints(dataset.space.get());
  if (count < 0) refuse(name, "is damaged");
  dataset.count = static_cast<std::size_t>(count);
  return dataset;
}

/// The number of entries in a chunk, for which HDF5 takes memory whole.
std::size_t Hdf5Reader::chunk_entries(const Dataset& dataset) {
  constexpr int k_most_rank = 32;
  std::array<hsize_t, k_most_rank> extent{};
  const int rank = H5Pget_chunk(dataset.properties.get(), k_most_rank, extent.data());
  constexpr std::size_t k_too_many = std::numeric_limits<std::size_t>::max();
  if (rank < 0 || rank > k_most_rank) return k_too_many;
  std::size_t entries = 1;
  for (int k = 0; k < rank; ++k) {
    const hsize_t n = extent[static_cast<std::size_t>(k)];
    if (n > 0 && entries > k_too_many / n) return k_too_many;
    entries *= n;
  }
  return entries;
}

/// Refuses extents that the file does not back with data, and data that lie in other files.
void Hdf5Reader::check_storage(const Dataset& dataset, const std::string& name) const {
  const auto layout = H5Pget_layout(dataset.properties.get());
  if ((layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED) ||
      H5Pget_external_count(dataset.properties.get()) != 0)
    refuse(name, "has its data in another file or in a form that is not supported");
  const std::size_t stored = H5Dget_storage_size(dataset.id.get());
  const std::size_t element = H5Tget_size(dataset.type.get());
  const bool filtered = H5Pget_nfilters(dataset.properties.get()) > 0;
  const std::size_t backed = filtered ? stored * k_largest_inflation : stored;
  if (stored > file_bytes_ || element == 0 || dataset.count > backed / element)
    refuse(name, "claims " + std::to_string(dataset.count) + " entries, the file does not hold as many");
  if (filtered && dataset.count > k_most_inflated / element)
    refuse(name, "claims " + std::to_string(dataset.count) + " entries, more than are supported in compressed form");
  if (layout == H5D_CHUNKED && dataset.count > 0 && chunk_entries(dataset) > backed / element)
    refuse(name, "has chunks larger than what the file holds of it");
}

/// Only the plain number types: HDF5 can describe far stranger ones.
static bool is_one_of(hid_t type, std::initializer_list<hid_t> known) {
  for (const hid_t one : known)
    if (H5Tequal(type, one) > 0) return true;
  return false;
}

static bool is_integer(hid_t type) {
  return is_one_of(type, {H5T_STD_I8LE, H5T_STD_U8LE, H5T_STD_I16LE, H5T_STD_U16LE, H5T_STD_I32LE, H5T_STD_U32LE,
                          H5T_STD_I64LE, H5T_STD_I32BE, H5T_STD_U32BE, H5T_STD_I64BE});
}

static bool is_real(hid_t type) {
  return is_one_of(type, {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_IEEE_F64BE, H5T_IEEE_F32BE});
}

std::vector<std::int64_t> Hdf5Reader::wide_integers(const std::string& name) const {
  const Dataset dataset = open(name);
  if (!is_integer(dataset.type.get())) refuse(name, "does not hold integers");
  check_storage(dataset, name);
  std::vector<std::int64_t> wide(dataset.count);
  if (!wide.empty() && H5Dread(dataset.id.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, wide.data()) < 0)
    refuse(name, "cannot be read; the file is damaged");
  return wide;
}

void Hdf5Reader::read_first(const std::string& name, std::size_t count, std::int64_t type, void* values) const {
  const Dataset dataset = open(name);
  if (dataset.count < count || H5Sget_simple_extent_ndims(dataset.space.get()) != 1)
    refuse(name, "is no list of at least " + std::to_string(count) + " entries");
  check_storage(dataset, name);
  if (count == 0) return;
  const hsize_t first = 0, size = count;
  const Hdf5Handle memory(H5Screate_simple(1, &size, nullptr), H5Sclose);
  H5Sselect_hyperslab(dataset.space.get(), H5S_SELECT_SET, &first, nullptr, &size, nullptr);
  if (H5Dread(dataset.id.get(), type, memory.get(), dataset.space.get(), H5P_DEFAULT, values) < 0)
    refuse(name, "cannot be read; the file is damaged");
}

std::vector<double> Hdf5Reader::first_numbers(const std::string& name, std::size_t count) const {
  if (kind(name) != Kind::numbers) refuse(name, "does not hold numbers");
  std::vector<double> values(count);
  read_first(name, count, H5T_NATIVE_DOUBLE, values.data());
  return values;
}

std::vector<std::int64_t> Hdf5Reader::first_integers(const std::string& name, std::size_t count) const {
  if (kind(name) != Kind::integers) refuse(name, "does not hold integers");
  std::vector<std::int64_t> values(count);
  read_first(name, count, H5T_NATIVE_INT64, values.data());
  return values;
}

std::vector<int> Hdf5Reader::integers(const std::string& name) const {
  const std::vector<std::int64_t> wide = wide_integers(name);
  std::vector<int> values;
  values.reserve(wide.size());
  for (const std::int64_t x : wide) {
    if (x < std::numeric_limits<int>::min() || x > std::numeric_limits<int>::max())
      refuse(name, "holds " + std::to_string(x) + ", beyond 32 bits");
    values.push_back(static_cast<int>(x));
  }
  return values;
}

int Hdf5Reader::integer(const std::string& name) const {
  const auto values = integers(name);
  if (values.size() != 1) refuse(name, "has " + std::to_string(values.size()) + " entries, needs 1");
  return values.front();
}

VecX Hdf5Reader::read_numbers(const std::string& name) const {
  const Dataset dataset = open(name);
  if (!is_real(dataset.type.get()) && !is_integer(dataset.type.get())) refuse(name, "does not hold numbers");
  check_storage(dataset, name);
  VecX values(static_cast<Eigen::Index>(dataset.count));
  if (values.size() > 0 &&
      H5Dread(dataset.id.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    refuse(name, "cannot be read; the file is damaged");
  return values;
}

VecX Hdf5Reader::numbers(const std::string& name) const {
  VecX values = read_numbers(name);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) refuse(name, "entry " + std::to_string(i) + " is not finite");
  return values;
}

VecX Hdf5Reader::numbers_or_infinity(const std::string& name) const {
  VecX values = read_numbers(name);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (std::isnan(values[i])) refuse(name, "entry " + std::to_string(i) + " is not a number");
  return values;
}

bool Hdf5Reader::is_filled(const std::string& name) const {
  return has(name) && H5Dget_storage_size(open(name).id.get()) > 0;
}

std::size_t Hdf5Reader::size(const std::string& name) const { return open(name).count; }

std::string Hdf5Reader::text(const std::string& name) const {
  if (!has(name)) return {};
  const Dataset dataset = open(name);
  if (H5Tget_class(dataset.type.get()) != H5T_STRING || H5Tis_variable_str(dataset.type.get()) != 0) return {};
  const std::size_t length = H5Tget_size(dataset.type.get());
  if (dataset.count != 1 || length > k_longest_text) return {};
  check_storage(dataset, name);
  std::string text(length, '\0');
  if (H5Dread(dataset.id.get(), dataset.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
    refuse(name, "cannot be read; the file is damaged");
  return text.substr(0, text.find('\0'));
}

Hdf5Reader::Kind Hdf5Reader::kind(const std::string& name) const {
  const Dataset dataset = open(name);
  if (is_integer(dataset.type.get())) return Kind::integers;
  if (is_real(dataset.type.get())) return Kind::numbers;
  return H5Tget_class(dataset.type.get()) == H5T_STRING ? Kind::text : Kind::other;
}

std::vector<double> Hdf5Reader::exact_numbers(const std::string& name) const {
  const VecX values = read_numbers(name);
  return {values.begin(), values.end()};
}

std::vector<std::string> Hdf5Reader::datasets(const std::string& group) const {
  if (!has(group)) refuse(group, "is missing");
  const Hdf5Handle place(H5Gopen2(file_.get(), group.c_str(), H5P_DEFAULT), H5Gclose);
  if (!place.good()) refuse(group, "is no group, or is damaged");
  std::vector<std::string> names;
  const auto visit = [](hid_t, const char* name, const H5O_info_t* info, void* list) -> herr_t {
    if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  if (H5Ovisit(place.get(), H5_INDEX_NAME, H5_ITER_INC, visit, &names) < 0) refuse(group, "is damaged");
  return names;
}

}  // namespace nilas::hdf5
