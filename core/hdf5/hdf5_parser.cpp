#include "core/hdf5/hdf5_parser.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>

#include "core/base/error.h"
#include "core/base/file_bytes.h"

namespace nilas::hdf5 {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// Most that a compressed dataset may grow when read; deflate cannot exceed 1032.
constexpr std::size_t k_largest_inflation = 1100;
/// Most bytes that a compressed dataset may take once it is read.
constexpr std::size_t k_most_inflated = std::size_t{1} << 30;
/// Longest text that is read [bytes]; titles and descriptions are far below.
constexpr std::size_t k_longest_text = 1 << 16;

std::size_t most_content(std::size_t file_bytes) {
  return std::max(file_bytes, std::min(file_bytes * k_largest_inflation, k_most_inflated));
}

struct Hdf5Parser::Dataset {
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

/// Opens a file where it is, in the mode for a file that another program is writing: its size may not fit its content.
static Hdf5Handle open_in_place(const std::string& path) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.get(), false, true);
  // HDF5 reads again what is inconsistent, each time after twice the pause before. Its own hundred times never end.
  constexpr unsigned k_attempts = 10;
  H5Pset_metadata_read_attempts(access.get(), k_attempts);
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get()), H5Fclose);
  if (!file.good()) throw InputError(path + ": is no HDF5 file, or is cut short or damaged");
  return file;
}

/// Opens the bytes of a file as they are in memory.
static Hdf5Handle open_image(const std::string& path, std::vector<char> bytes) {
  if (is_marked_open(bytes)) return open_in_place(path);
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

Hdf5Parser::Hdf5Parser(const std::filesystem::path& path, bool in_place)
    : path_(path.string()), file_([&] {
        if (in_place) {
          file_bytes_ = static_cast<std::size_t>(std::filesystem::file_size(path));
          return open_in_place(path_);
        }
        auto bytes = read_whole(path_);
        file_bytes_ = bytes.size();
        return open_image(path_, std::move(bytes));
      }()) {}

void Hdf5Parser::refuse(const std::string& name, const std::string& fault) const {
  throw InputError(path_ + ": /" + name + ": " + fault);
}

bool Hdf5Parser::has(const std::string& name) const {
  for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
    const std::string part = name.substr(0, end);
    H5L_info_t link;
    if (H5Lexists(file_.get(), part.c_str(), H5P_DEFAULT) <= 0) return false;
    if (H5Lget_info(file_.get(), part.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return false;
    if (end == std::string::npos) return true;
  }
}

Hdf5Parser::Dataset Hdf5Parser::open(const std::string& name) const {
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
std::size_t Hdf5Parser::chunk_entries(const Dataset& dataset) {
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
void Hdf5Parser::check_storage(const Dataset& dataset, const std::string& name, std::size_t count) const {
  const auto layout = H5Pget_layout(dataset.properties.get());
  if ((layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED) ||
      H5Pget_external_count(dataset.properties.get()) != 0)
    refuse(name, "has its data in another file or in a form that is not supported");
  const std::size_t stored = H5Dget_storage_size(dataset.id.get());
  const std::size_t element = H5Tget_size(dataset.type.get());
  const bool filtered = H5Pget_nfilters(dataset.properties.get()) > 0;
  const std::size_t backed = filtered ? stored * k_largest_inflation : stored;
  if (stored > file_bytes_ || element == 0 || count > backed / element)
    refuse(name, "claims " + std::to_string(count) + " entries, the file does not hold as many");
  if (filtered && count > k_most_inflated / element)
    refuse(name, "claims " + std::to_string(count) + " entries, more than are supported in compressed form");
  if (layout == H5D_CHUNKED && count > 0 && chunk_entries(dataset) > backed / element)
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

std::vector<std::int64_t> Hdf5Parser::integers(const std::string& name) const {
  const Dataset dataset = open(name);
  if (!is_integer(dataset.type.get())) refuse(name, "does not hold integers");
  check_storage(dataset, name, dataset.count);
  std::vector<std::int64_t> wide(dataset.count);
  if (!wide.empty() && H5Dread(dataset.id.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, wide.data()) < 0)
    refuse(name, "cannot be read; the file is damaged");
  return wide;
}

void Hdf5Parser::read_first(const std::string& name, Rows rows, std::int64_t type, void* values) const {
  const Dataset dataset = open(name);
  const std::vector<std::size_t> extent = shape(name);
  const std::vector<std::size_t> needed =
      rows.columns == 1 ? std::vector<std::size_t>{rows.count} : std::vector<std::size_t>{rows.count, rows.columns};
  if (extent.size() != needed.size() || extent.front() < rows.count ||
      (extent.size() == 2 && extent[1] != rows.columns))
    refuse(name, "is no list of at least " + std::to_string(rows.count) + " entries");
  check_storage(dataset, name, rows.entries());
  if (rows.entries() == 0) return;
  const std::array<hsize_t, 2> first{0, 0}, size{rows.count, rows.columns};
  const Hdf5Handle memory(H5Screate_simple(static_cast<int>(extent.size()), size.data(), nullptr), H5Sclose);
  H5Sselect_hyperslab(dataset.space.get(), H5S_SELECT_SET, first.data(), nullptr, size.data(), nullptr);
  if (H5Dread(dataset.id.get(), type, memory.get(), dataset.space.get(), H5P_DEFAULT, values) < 0)
    refuse(name, "cannot be read; the file is damaged");
}

std::vector<double> Hdf5Parser::first_numbers(const std::string& name, Rows rows) const {
  if (kind(name) != Kind::numbers) refuse(name, "does not hold numbers");
  std::vector<double> values(rows.entries());
  read_first(name, rows, H5T_NATIVE_DOUBLE, values.data());
  return values;
}

std::vector<std::int64_t> Hdf5Parser::first_integers(const std::string& name, Rows rows) const {
  if (kind(name) != Kind::integers) refuse(name, "does not hold integers");
  std::vector<std::int64_t> values(rows.entries());
  read_first(name, rows, H5T_NATIVE_INT64, values.data());
  return values;
}

std::vector<double> Hdf5Parser::numbers(const std::string& name) const {
  const Dataset dataset = open(name);
  if (!is_real(dataset.type.get()) && !is_integer(dataset.type.get())) refuse(name, "does not hold numbers");
  check_storage(dataset, name, dataset.count);
  std::vector<double> values(dataset.count);
  if (!values.empty() && H5Dread(dataset.id.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    refuse(name, "cannot be read; the file is damaged");
  return values;
}

bool Hdf5Parser::is_filled(const std::string& name) const {
  return has(name) && H5Dget_storage_size(open(name).id.get()) > 0;
}

std::size_t Hdf5Parser::size(const std::string& name) const { return open(name).count; }

std::string Hdf5Parser::text(const std::string& name) const {
  if (!has(name)) return {};
  const Dataset dataset = open(name);
  if (H5Tget_class(dataset.type.get()) != H5T_STRING || H5Tis_variable_str(dataset.type.get()) != 0) return {};
  const std::size_t length = H5Tget_size(dataset.type.get());
  if (dataset.count != 1 || length > k_longest_text) return {};
  check_storage(dataset, name, dataset.count);
  std::string text(length, '\0');
  if (H5Dread(dataset.id.get(), dataset.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
    refuse(name, "cannot be read; the file is damaged");
  return text.substr(0, text.find('\0'));
}

Hdf5Parser::Kind Hdf5Parser::kind(const std::string& name) const {
  const Dataset dataset = open(name);
  if (is_integer(dataset.type.get())) return Kind::integers;
  if (is_real(dataset.type.get())) return Kind::numbers;
  return H5Tget_class(dataset.type.get()) == H5T_STRING ? Kind::text : Kind::other;
}

std::vector<std::string> Hdf5Parser::datasets(const std::string& group) const {
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
