#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <fstream>

#include "core/base/error.h"
#include "core/hdf5/hdf5_file.h"

namespace nilas::hdf5 {

/// HDF5 has no reason to refuse what we make in memory, short of memory itself.
static void demand_made(bool made, const std::string& name) {
  if (!made) throw FileError("HDF5 could not make " + name + ": there is too little memory");
}

static Hdf5Handle create_image() {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr std::size_t k_growth_bytes = 1 << 20;
  H5Pset_fapl_core(access.get(), k_growth_bytes, false);
  Hdf5Handle file(H5Fcreate("nilas", H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose);
  demand_made(file.good(), "a file in memory");
  return file;
}

Hdf5Writer::Hdf5Writer() : file_(create_image()) {}

void Hdf5Writer::add_group(const std::string& name) {
  const Hdf5Handle group(H5Gcreate2(file_.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  demand_made(group.good(), name);
}

void Hdf5Writer::add(const std::string& name, std::int64_t type, std::size_t count, const void* values) {
  const hsize_t extent = count;
  const Hdf5Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file_.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  demand_made(data.good(), name);
  demand_made(count == 0 || H5Dwrite(data.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0, name);
}

void Hdf5Writer::add(const std::string& name, const std::vector<int>& values) {
  add(name, H5T_NATIVE_INT, values.size(), values.data());
}

void Hdf5Writer::add(const std::string& name, const std::vector<std::int64_t>& values) {
  add(name, H5T_NATIVE_INT64, values.size(), values.data());
}

void Hdf5Writer::add(const std::string& name, const std::vector<double>& values) {
  add(name, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

void Hdf5Writer::add(const std::string& name, const VecX& values) {
  add(name, H5T_NATIVE_DOUBLE, static_cast<std::size_t>(values.size()), values.data());
}

void Hdf5Writer::add(const std::string& name, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  H5Tset_size(type.get(), text.size() + 1);
  const Hdf5Handle data(
      H5Dcreate2(file_.get(), name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  demand_made(data.good() && H5Dwrite(data.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0, name);
}

void Hdf5Writer::add(const std::string& name, const std::vector<std::size_t>& shape,
                     const std::vector<double>& values) {
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose);
  const Hdf5Handle data(
      H5Dcreate2(file_.get(), name.c_str(), H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  demand_made(data.good() && H5Sget_simple_extent_npoints(space.get()) == static_cast<hssize_t>(values.size()), name);
  demand_made(
      values.empty() || H5Dwrite(data.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0,
      name);
}

/// Waits until what was written to a file, or into a folder, is on the disk.
static bool sync(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool done = ::fsync(descriptor) == 0;
  ::close(descriptor);
  return done;
}

void Hdf5Writer::save(const std::filesystem::path& path, bool synced) const {
  H5Fflush(file_.get(), H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
  demand_made(size > 0, path.string());
  std::vector<char> bytes(static_cast<std::size_t>(size));
  demand_made(H5Fget_file_image(file_.get(), bytes.data(), bytes.size()) == size, path.string());
  std::filesystem::path beside = path;
  beside += ".part";
  std::ofstream out(beside, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code fault;
  const bool written = out && (!synced || sync(beside));
  if (written) std::filesystem::rename(beside, path, fault);
  if (written && !fault) {
    if (synced) sync(path.parent_path());  // the new name; some file systems refuse to sync a folder
    return;
  }
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  throw FileError(path.string() + ": cannot be written");
}

}  // namespace nilas::hdf5
