#pragma once
/// The few things of HDF5 that problem files and checkpoints need: named datasets of numbers and short texts, read with
/// suspicion. Names are paths such as "fclib_local/W/x".
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::hdf5 {

/// HDF5's identifier of an open object, closed at the end of its life.
class Hdf5Handle {
 public:
  using Close = int (*)(std::int64_t);
  Hdf5Handle(std::int64_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  bool good() const { return id_ >= 0; }
  std::int64_t get() const { return id_; }
  /// Leaves the object open for good.
  void abandon() { id_ = -1; }

 private:
  std::int64_t id_;
  Close close_;
};

/// Keeps HDF5 from printing its own messages during its life; faults are reported by exceptions only.
class Hdf5Silence {
 public:
  Hdf5Silence();
  ~Hdf5Silence();
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
  int (*print_)(std::int64_t, void*) = nullptr;
  void* print_data_ = nullptr;
};

struct Question;
class ReadingProcess;

/// A file open for reading. Wrong content is an InputError with the file and the dataset named.
///
/// HDF5's library crashes at some damaged files. So a process of its own reads the file, with bounds on its memory and
/// its processor time, and hands over what is asked for (reading_process.h). It lives as long as the reader, which one
/// thread at a time may use.
class Hdf5Reader {
 public:
  /// Where the process has the file: `memory` takes it whole, `disk` reads only what is asked for.
  enum class Place { memory, disk };
  /// Throws FileError where the file cannot be opened or no process can be started, InputError where it is no HDF5 file
  /// or is cut short.
  explicit Hdf5Reader(const std::filesystem::path& path, Place place = Place::memory);
  ~Hdf5Reader();

  /// True for a group or dataset held in this file; links that lead elsewhere do not count.
  bool has(const std::string& name) const;
  std::vector<int> integers(const std::string& name) const;
  int integer(const std::string& name) const;
  /// Finite numbers.
  VecX numbers(const std::string& name) const;
  /// Finite numbers or infinity.
  VecX numbers_or_infinity(const std::string& name) const;
  /// True for a dataset that was ever written to.
  bool is_filled(const std::string& name) const;
  /// Number of elements, from the dataset's extent.
  std::size_t size(const std::string& name) const;
  /// A text of fixed length, without the zeros that fill it; empty where there is none.
  std::string text(const std::string& name) const;

  enum class Kind { numbers, integers, text, other };
  /// The kind of content of a dataset.
  Kind kind(const std::string& name) const;
  /// All numbers, bit for bit: also those that are not finite.
  std::vector<double> exact_numbers(const std::string& name) const;
  /// Integers of 64 bits.
  std::vector<std::int64_t> wide_integers(const std::string& name) const;
  /// The first `count` of a list, which must be as long; what follows need not be readable.
  std::vector<double> first_numbers(const std::string& name, std::size_t count) const;
  std::vector<std::int64_t> first_integers(const std::string& name, std::size_t count) const;
  /// The first `count` rows of a table of so many columns.
  std::vector<std::int64_t> first_integers(const std::string& name, std::size_t count, std::size_t columns) const;
  /// Number of elements along each dimension; empty for a scalar.
  std::vector<std::size_t> shape(const std::string& name) const;
  /// A list of texts of fixed or variable length.
  std::vector<std::string> texts(const std::string& name) const;
  /// The names of the dimensions of a NetCDF variable; a dimension that has no name is called by an empty text.
  std::vector<std::string> dimension_names(const std::string& name) const;
  /// Names of all datasets in a group and in the groups below it, from that group on.
  std::vector<std::string> datasets(const std::string& group) const;

  [[noreturn]] void refuse(const std::string& name, const std::string& fault) const;

 private:
  std::vector<double> ask_numbers(const Question& question) const;
  std::vector<std::int64_t> ask_integers(const Question& question) const;
  std::int64_t ask_integer(const Question& question) const;
  std::vector<std::string> ask_texts(const Question& question) const;

  std::string path_;
  std::unique_ptr<ReadingProcess> process_;
};

/// A file made in memory and put on disk by save().
class Hdf5Writer {
 public:
  Hdf5Writer();
  void add_group(const std::string& name);
  void add(const std::string& name, const std::vector<int>& values);
  void add(const std::string& name, const std::vector<std::int64_t>& values);
  void add(const std::string& name, const std::vector<double>& values);
  void add(const std::string& name, const VecX& values);
  void add(const std::string& name, const std::string& text);
  /// A table of several dimensions, whose last index runs fastest.
  void add(const std::string& name, const std::vector<std::size_t>& shape, const std::vector<double>& values);
  /// Writes to a temporary file and renames it, so that a failure leaves no half file. `synced`: also safe against a
  /// crash of the machine, since the bytes are on the disk before the rename. Throws FileError.
  void save(const std::filesystem::path& path, bool synced = false) const;

 private:
  void add(const std::string& name, std::int64_t type, std::size_t count, const void* values);

  Hdf5Silence silence_;
  Hdf5Handle file_;
};

}  // namespace nilas::hdf5
