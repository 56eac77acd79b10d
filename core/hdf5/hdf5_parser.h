#pragma once
/// Reads HDF5 files by calls of HDF5's library. A file that is damaged can crash that library, so only the process that
/// Hdf5Reader starts for a file may use this.
#include <filesystem>
#include <string>
#include <vector>

#include "core/hdf5/hdf5_file.h"

namespace nilas::hdf5 {

/// The first rows of a dataset: a list where there is one column, else a table.
struct Rows {
  std::size_t count = 0, columns = 1;
  std::size_t entries() const { return count * columns; }
};

/// Most bytes that one dataset of a file of this size can hold, which may be compressed.
std::size_t most_content(std::size_t file_bytes);

/// The content of one file as Hdf5Reader gives it, with the same faults. Nothing is allocated beyond what the file
/// really holds: each dataset's extent is checked against its storage, its storage against the size of the file.
class Hdf5Parser {
 public:
  using Kind = Hdf5Reader::Kind;
  /// `in_place` reads what is needed from the disk. Without it the file is taken into memory whole.
  Hdf5Parser(const std::filesystem::path& path, bool in_place);
  bool has(const std::string& name) const;
  bool is_filled(const std::string& name) const;
  Kind kind(const std::string& name) const;
  std::size_t size(const std::string& name) const;
  std::vector<std::size_t> shape(const std::string& name) const;
  std::string text(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;
  std::vector<std::string> dimension_names(const std::string& name) const;
  std::vector<std::string> datasets(const std::string& group) const;
  std::vector<double> numbers(const std::string& name) const;
  std::vector<std::int64_t> integers(const std::string& name) const;
  std::vector<double> first_numbers(const std::string& name, Rows rows) const;
  std::vector<std::int64_t> first_integers(const std::string& name, Rows rows) const;

 private:
  struct Dataset;
  [[noreturn]] void refuse(const std::string& name, const std::string& fault) const;
  Dataset open(const std::string& name) const;
  static std::size_t chunk_entries(const Dataset& dataset);
  void check_storage(const Dataset& dataset, const std::string& name, std::size_t count) const;
  void read_first(const std::string& name, Rows rows, std::int64_t type, void* values) const;

  std::string path_;
  std::size_t file_bytes_ = 0;
  Hdf5Handle file_;
};

}  // namespace nilas::hdf5
