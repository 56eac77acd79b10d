#include <hdf5.h>

#include "core/hdf5/hdf5_parser.h"

namespace nilas::hdf5 {

/// Most texts in a list and most bytes of one; labels are far below.
constexpr hssize_t k_most_labels = 10000;
constexpr std::size_t k_longest_label = 1 << 12;

namespace {

struct OpenDataset {
  Hdf5Handle id, type, space;
  bool good() const { return id.good() && type.good() && space.good(); }
};

OpenDataset open_dataset(hid_t file, const std::string& name) {
  Hdf5Handle id(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const auto place = id.get();
  return {std::move(id), {H5Dget_type(place), H5Tclose}, {H5Dget_space(place), H5Sclose}};
}

std::vector<std::string> variable_texts(const OpenDataset& data, std::size_t count, bool& done) {
  std::vector<char*> raw(count, nullptr);
  const Hdf5Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(memory.get(), H5T_VARIABLE);
  H5Tset_cset(memory.get(), H5Tget_cset(data.type.get()));
  // Many entries may be one and the same long text of the file.
  hsize_t bytes = 0;
  done = H5Dvlen_get_buf_size(data.id.get(), memory.get(), data.space.get(), &bytes) >= 0 &&
         bytes <= k_most_labels * k_longest_label;
  if (!done) return {};
  done = H5Dread(data.id.get(), memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) >= 0;
  std::vector<std::string> texts;
  for (const char* each : raw) texts.emplace_back(each == nullptr ? "" : each);
  if (done) H5Dvlen_reclaim(memory.get(), data.space.get(), H5P_DEFAULT, raw.data());
  return texts;
}

std::vector<std::string> fixed_texts(const OpenDataset& data, std::size_t count, std::size_t length, bool& done) {
  std::string raw(count * length, '\0');
  done = H5Dread(data.id.get(), data.type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) >= 0;
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string each = raw.substr(k * length, length);
    texts.push_back(each.substr(0, each.find('\0')));
  }
  return texts;
}

/// The name of the dataset that the scale of one dimension refers to; empty where there is none.
std::string scale_name(hid_t attribute, const hvl_t& references) {
  if (references.len == 0 || references.p == nullptr) return {};
  std::string name(k_longest_label, '\0');
  const ssize_t length = H5Rget_name(attribute, H5R_OBJECT, references.p, name.data(), name.size());
  if (length <= 0 || static_cast<std::size_t>(length) >= name.size()) return {};
  name.resize(static_cast<std::size_t>(length));
  return name.substr(name.find_last_of('/') + 1);
}

}  // namespace

std::vector<std::size_t> Hdf5Parser::shape(const std::string& name) const {
  if (!has(name)) refuse(name, "is missing");
  const OpenDataset data = open_dataset(file_.get(), name);
  const int rank = data.good() ? H5Sget_simple_extent_ndims(data.space.get()) : -1;
  if (rank < 0) refuse(name, "is no dataset, or is damaged");
  std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
  if (rank > 0) H5Sget_simple_extent_dims(data.space.get(), extent.data(), nullptr);
  return {extent.begin(), extent.end()};
}

std::vector<std::string> Hdf5Parser::texts(const std::string& name) const {
  if (!has(name)) refuse(name, "is missing");
  const OpenDataset data = open_dataset(file_.get(), name);
  if (!data.good() || H5Tget_class(data.type.get()) != H5T_STRING) refuse(name, "does not hold texts");
  const hssize_t count = H5Sget_simple_extent_npoints(data.space.get());
  const std::size_t length = H5Tget_size(data.type.get());
  if (count < 0 || count > k_most_labels || length > k_longest_label) refuse(name, "holds too many or too long texts");
  bool done = false;
  const auto n = static_cast<std::size_t>(count);
  std::vector<std::string> texts =
      H5Tis_variable_str(data.type.get()) > 0 ? variable_texts(data, n, done) : fixed_texts(data, n, length, done);
  if (!done) refuse(name, "cannot be read; the file is damaged");
  return texts;
}

std::vector<std::string> Hdf5Parser::dimension_names(const std::string& name) const {
  const std::size_t rank = shape(name).size();
  std::vector<std::string> names(rank);
  const OpenDataset data = open_dataset(file_.get(), name);
  if (H5Aexists(data.id.get(), "DIMENSION_LIST") <= 0) {
    // A coordinate is the scale of its own dimension.
    if (rank == 1 && H5Aexists(data.id.get(), "CLASS") > 0) names.front() = name.substr(name.find_last_of('/') + 1);
    return names;
  }
  const Hdf5Handle attribute(H5Aopen(data.id.get(), "DIMENSION_LIST", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose), space(H5Aget_space(attribute.get()), H5Sclose);
  const Hdf5Handle memory(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
  std::vector<hvl_t> lists(rank);
  if (H5Tget_class(type.get()) != H5T_VLEN ||
      H5Sget_simple_extent_npoints(space.get()) != static_cast<hssize_t>(rank) ||
      H5Aread(attribute.get(), memory.get(), lists.data()) < 0)
    refuse(name, "has a DIMENSION_LIST that cannot be read");
  for (std::size_t k = 0; k < rank; ++k) names[k] = scale_name(attribute.get(), lists[k]);
  H5Dvlen_reclaim(memory.get(), space.get(), H5P_DEFAULT, lists.data());
  return names;
}

}  // namespace nilas::hdf5
