#include "hydro/database/labelled_file.h"

#include <fstream>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/hdf5/hdf5_file.h"

namespace nilas::hydro {

void LabelledFile::refuse(const std::string& name, const std::string& fault) const {
  throw InputError(path_ + ": /" + name + ": " + fault);
}

namespace {

class LabelledHdf5 : public LabelledFile {
 public:
  explicit LabelledHdf5(const std::filesystem::path& path) : LabelledFile(path), file_(path) {}
  bool has(const std::string& name) const override { return file_.has(name); }
  LabelledArray numbers(const std::string& name) const override {
    return {file_.dimension_names(name), file_.shape(name), file_.exact_numbers(name)};
  }
  std::vector<std::string> texts(const std::string& name) const override {
    const std::vector<std::string> written = file_.texts(name);
    const std::vector<std::size_t> shape = file_.shape(name);
    if (shape.size() < 2) return written;
    // Texts as rows of single characters.
    std::vector<std::string> joined(shape.front());
    for (std::size_t k = 0; k < written.size(); ++k) joined[k * shape.front() / written.size()] += written[k];
    return joined;
  }

 private:
  hdf5::Hdf5Reader file_;
};

}  // namespace

bool is_classic_netcdf(const std::filesystem::path& path) {
  demand_file(path);
  std::ifstream in(path, std::ios::binary);
  std::string start(3, '\0');
  return in.read(start.data(), static_cast<std::streamsize>(start.size())) && start == "CDF";
}

std::unique_ptr<LabelledFile> open_labelled(const std::filesystem::path& path) {
  if (is_classic_netcdf(path)) return open_classic(path);
  return std::make_unique<LabelledHdf5>(path);
}

}  // namespace nilas::hydro
