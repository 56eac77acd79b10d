#pragma once
/// A table in an HDF5 file that grows: one dataset per column, compressed, and a dataset that parts the rows into
/// blocks.
///
/// The file is opened only while pending rows go in, in HDF5's single-writer form, whose order of writing keeps every
/// earlier row readable whatever ends the program. A block counts once it stands in the index, which is written last:
/// rows beyond the last block are those of a write that did not end. A program killed while it writes leaves a mark of
/// an open file, which h5py passes over with swmr=True and `h5clear -s` removes.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/hdf5/hdf5_file.h"

namespace nilas::hdf5 {

struct Hdf5Column {
  std::string name, unit, meaning;                                      ///< unit and meaning become attributes
  std::variant<std::vector<double>, std::vector<std::int64_t>> values;  ///< which of both says what it holds
};

/// The index of a table up to the first entry that does not go on from the one before: beyond it lie those of a write
/// that found the disk full.
std::vector<std::int64_t> whole_blocks(std::vector<std::int64_t> index);

class Hdf5Columns {
 public:
  struct Length {
    std::int64_t blocks = 0, rows = 0;
  };
  /// Columns stand in `group`; the dataset `index` has a row (first row of the block, row after its last) per block.
  struct Layout {
    std::string group, about;  ///< `about` becomes the group's attribute
    std::string index, about_index;
    std::vector<Hdf5Column> columns;
  };

  /// Creates the file. `keep`: continues after this length of an existing file and drops the rest. Throws FileError;
  /// throws InputError and leaves the file unchanged where it is shorter or has other columns.
  Hdf5Columns(std::filesystem::path path, Layout layout, std::optional<Length> keep = {});

  /// The next cell of the row at hand, from left to right; of the column's kind.
  void add(double x);
  void add(std::int64_t n);
  void end_row();
  void end_block();
  /// Length of everything added, written or not.
  Length length() const { return {written_.blocks + static_cast<std::int64_t>(ends_.size()), rows_}; }
  std::int64_t pending_rows() const { return rows_ - written_.rows; }
  bool pending() const { return !ends_.empty(); }

  /// Puts pending blocks into the file; at an error they are lost and nothing can be added any more. Throws FileError.
  void write();
  /// Returns when all that was written is on the disk. Throws FileError.
  void sync() const;

 private:
  void create(const std::filesystem::path& path) const;
  void take_over(Length keep);
  void write_pending(const std::filesystem::path& path);
  [[noreturn]] void fail(const std::string& why) const;

  Hdf5Silence silence_;
  std::filesystem::path path_;
  Layout layout_;
  std::size_t next_ = 0;            ///< column of the next cell
  std::int64_t rows_ = 0;           ///< number of rows in complete blocks and the present one
  Length written_;                  ///< length written to the file
  std::vector<std::int64_t> ends_;  ///< row after the last of each pending block
  bool failed_ = false;
};

}  // namespace nilas::hdf5
