#pragma once
/// NetCDF files: arrays with named dimensions, in the classic form or in that of HDF5.
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace nilas::hydro {

/// Numbers with a name for each dimension; the last index runs fastest. Not a number stays so.
struct LabelledArray {
  std::vector<std::string> dimensions;
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

class LabelledFile {
 public:
  virtual ~LabelledFile() = default;
  virtual bool has(const std::string& name) const = 0;
  /// The numbers of a variable. Throws InputError with file and variable where there is none or it holds no numbers.
  virtual LabelledArray numbers(const std::string& name) const = 0;
  /// A list of texts; throws like numbers().
  virtual std::vector<std::string> texts(const std::string& name) const = 0;
  /// Refuses the content of a variable: "FILE: /NAME: fault".
  [[noreturn]] void refuse(const std::string& name, const std::string& fault) const;

 protected:
  explicit LabelledFile(const std::filesystem::path& path) : path_(path.string()) {}
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Whether a file begins as a NetCDF file of the classic form does. Throws FileError where it cannot be read.
bool is_classic_netcdf(const std::filesystem::path& path);

/// Opens a NetCDF file of either form. Throws FileError where it cannot be read, InputError where it is neither.
std::unique_ptr<LabelledFile> open_labelled(const std::filesystem::path& path);
/// Opens the classic form: versions 1, 2 and 5 of the NetCDF file format, without a record dimension.
std::unique_ptr<LabelledFile> open_classic(const std::filesystem::path& path);

}  // namespace nilas::hydro
