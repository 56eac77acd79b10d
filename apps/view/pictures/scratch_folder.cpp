#include "apps/view/pictures/scratch_folder.h"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "core/base/error.h"

namespace nilas::view {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "nilas-view-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw FileError(name + ": cannot be made: " + std::strerror(errno));
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  // A browser that was ended may still have processes that write into its profile for a moment.
  constexpr int k_tries = 50;
  for (int k = 0; k < k_tries; ++k) {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
    if (!error && !std::filesystem::exists(path_, error)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace nilas::view
