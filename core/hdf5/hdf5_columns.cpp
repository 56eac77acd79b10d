#include "core/hdf5/hdf5_columns.h"

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <array>
#include <cstring>

#include "core/base/error.h"
#include "core/hdf5/first_reason.h"

namespace nilas::hdf5 {

namespace {

/// Rows that are compressed together: enough for a good ratio, few enough that rewriting a part-filled one is cheap.
constexpr hsize_t k_chunk_rows = 256;
constexpr unsigned k_deflate_level = 4;

Hdf5Handle file_access() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
  H5Pset_file_locking(access.get(), false, true);  // a reader must not stop the run
  return access;
}

/// Two columns of the index; one of any other dataset.
constexpr hsize_t k_index_width = 2;

bool make_dataset(const Hdf5Handle& file, const std::string& name, hid_t type, hsize_t width) {
  const std::array<hsize_t, 2> none{0, width}, unlimited{H5S_UNLIMITED, width}, chunk{k_chunk_rows, width};
  const int rank = width == 1 ? 1 : 2;
  const Hdf5Handle space(H5Screate_simple(rank, none.data(), unlimited.data()), H5Sclose);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);
  H5Pset_chunk(properties.get(), rank, chunk.data());
  H5Pset_shuffle(properties.get());
  H5Pset_deflate(properties.get(), k_deflate_level);
  const Hdf5Handle data(
      H5Dcreate2(file.get(), name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose);
  return data.good();
}

bool describe(const Hdf5Handle& file, const std::string& object, const char* attribute, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  H5Tset_size(type.get(), H5T_VARIABLE);
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  const Hdf5Handle made(H5Acreate_by_name(file.get(), object.c_str(), attribute, type.get(), space.get(), H5P_DEFAULT,
                                          H5P_DEFAULT, H5P_DEFAULT),
                        H5Aclose);
  const char* const value = text.c_str();
  return made.good() && H5Awrite(made.get(), type.get(), static_cast<const void*>(&value)) >= 0;
}

/// Rows `first` .. `first + count` of an open dataset of `width` columns.
Hdf5Handle rows_of(const Hdf5Handle& data, hsize_t first, hsize_t count, hsize_t width) {
  Hdf5Handle space(H5Dget_space(data.get()), H5Sclose);
  const std::array<hsize_t, 2> start{first, 0}, size{count, width};
  H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr);
  return space;
}

bool append(const Hdf5Handle& file, const std::string& name, std::int64_t first, std::size_t rows, hsize_t width,
            hid_t type, const void* values) {
  if (rows == 0) return true;
  const auto start = static_cast<hsize_t>(first), count = static_cast<hsize_t>(rows);
  const Hdf5Handle data(H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const std::array<hsize_t, 2> size{count, width}, extent{start + count, width};
  if (!data.good() || H5Dset_extent(data.get(), extent.data()) < 0) return false;
  // of the rank of the dataset: HDF5 would walk over other shapes element by element
  const Hdf5Handle memory(H5Screate_simple(width == 1 ? 1 : 2, size.data(), nullptr), H5Sclose);
  return H5Dwrite(data.get(), type, memory.get(), rows_of(data, start, count, width).get(), H5P_DEFAULT, values) >= 0 &&
         H5Dflush(data.get()) >= 0;
}

template <class T>
hid_t memory_type(const std::vector<T>&) {
  return std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64;
}

}  // namespace

std::vector<std::int64_t> whole_blocks(std::vector<std::int64_t> index) {
  std::int64_t end = 0;
  std::size_t size = 0;
  for (; size + 1 < index.size() && index[size] == end && index[size + 1] >= end; size += k_index_width)
    end = index[size + 1];
  index.resize(size);
  return index;
}

Hdf5Columns::Hdf5Columns(std::filesystem::path path, Layout layout, std::optional<Length> keep)
    : path_(std::move(path)), layout_(std::move(layout)) {
  if (keep)
    take_over(*keep);
  else
    create(path_);
}

void Hdf5Columns::create(const std::filesystem::path& path) const {
  const FirstReason reason;
  Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, file_access().get()), H5Fclose);
  if (!file.good()) fail(reason.text());
  const Hdf5Handle group(H5Gcreate2(file.get(), layout_.group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Gclose);
  bool made = group.good() && describe(file, layout_.group, "about", layout_.about);
  for (const auto& column : layout_.columns) {
    const std::string name = layout_.group + "/" + column.name;
    const bool number = std::holds_alternative<std::vector<double>>(column.values);
    made = made && make_dataset(file, name, number ? H5T_IEEE_F64LE : H5T_STD_I64LE, 1) &&
           describe(file, name, "unit", column.unit) && describe(file, name, "meaning", column.meaning);
  }
  made = made && make_dataset(file, layout_.index, H5T_STD_I64LE, k_index_width) &&
         describe(file, layout_.index, "about", layout_.about_index);
  if (!made || H5Fflush(file.get(), H5F_SCOPE_LOCAL) < 0) fail(reason.text());
}

/// Copies the rows to keep into a new file next to the old one, which may hold rows of an unfinished write.
void Hdf5Columns::take_over(Length keep) {
  try {
    const Hdf5Reader old(path_, Hdf5Reader::Place::disk);
    const auto rows = static_cast<std::size_t>(keep.rows), blocks = static_cast<std::size_t>(keep.blocks);
    const auto index = old.first_integers(layout_.index, blocks, k_index_width);
    if (index.empty() ? keep.rows != 0 : index.back() != keep.rows)
      old.refuse(layout_.index, "has no block that ends there");
    for (auto& column : layout_.columns) {
      const std::string name = layout_.group + "/" + column.name;
      if (auto* numbers = std::get_if<std::vector<double>>(&column.values))
        *numbers = old.first_numbers(name, rows);
      else
        column.values = old.first_integers(name, rows);
    }
    for (std::size_t b = 0; b < index.size(); b += k_index_width) ends_.push_back(index[b + 1]);
  } catch (const InputError& fault) {
    throw InputError(path_.string() + ": does not hold the " + std::to_string(keep.rows) +
                     " rows that the checkpoint goes on from: " + fault.what());
  }
  rows_ = keep.rows;
  std::filesystem::path beside = path_;
  beside += ".part";
  create(beside);
  write_pending(beside);
  std::error_code error;
  std::filesystem::rename(beside, path_, error);
  if (error) fail(error.message());
}

void Hdf5Columns::add(double x) { std::get<std::vector<double>>(layout_.columns.at(next_++).values).push_back(x); }
void Hdf5Columns::add(std::int64_t n) {
  std::get<std::vector<std::int64_t>>(layout_.columns.at(next_++).values).push_back(n);
}

void Hdf5Columns::end_row() {
  NILAS_DEMAND(next_ == layout_.columns.size());
  next_ = 0;
  ++rows_;
}

void Hdf5Columns::end_block() {
  NILAS_DEMAND(next_ == 0 && !failed_);
  ends_.push_back(rows_);
}

void Hdf5Columns::write() {
  if (pending() && !failed_) write_pending(path_);
}

void Hdf5Columns::write_pending(const std::filesystem::path& path) {
  failed_ = true;  // until everything is written
  const auto rows = static_cast<std::size_t>(rows_ - written_.rows);
  std::vector<std::int64_t> index;
  for (const std::int64_t end : ends_) {
    index.push_back(index.empty() ? written_.rows : index.back());
    index.push_back(end);
  }
  {
    const FirstReason reason;
    Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, file_access().get()), H5Fclose);
    bool done = file.good();
    for (const auto& column : layout_.columns)
      std::visit(
          [&](const auto& values) {
            done = done && append(file, layout_.group + "/" + column.name, written_.rows, rows, 1, memory_type(values),
                                  values.data());
          },
          column.values);
    done = done &&
           append(file, layout_.index, written_.blocks, ends_.size(), k_index_width, H5T_NATIVE_INT64, index.data());
    if (!done || H5Fflush(file.get(), H5F_SCOPE_LOCAL) < 0) {
      file.abandon();  // closing would report a file of its intended length, which cannot be opened
      fail(reason.text());
    }
  }
  written_ = length();
  ends_.clear();
  for (auto& column : layout_.columns) std::visit([](auto& values) { values.clear(); }, column.values);
  failed_ = false;
}

void Hdf5Columns::sync() const {
  const int descriptor = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = descriptor >= 0 && ::fsync(descriptor) == 0;
  const std::string why = std::strerror(errno);
  if (descriptor >= 0) ::close(descriptor);
  if (!done) fail(why);
}

void Hdf5Columns::fail(const std::string& why) const { throw FileError(path_.string() + ": cannot write: " + why); }

}  // namespace nilas::hdf5
