#pragma once
/// Why a call of HDF5 failed.
#include <cstdint>
#include <string>

namespace nilas::hdf5 {

/// Notes why the first call of HDF5 fails during its life. Later calls, those that close handles too, clear what HDF5
/// itself remembers.
class FirstReason {
 public:
  FirstReason();
  ~FirstReason();
  FirstReason(const FirstReason&) = delete;
  FirstReason& operator=(const FirstReason&) = delete;

  /// The message of the operating system, else that of HDF5.
  const std::string& text() const { return text_; }
  /// Whether the operating system refused a call.
  bool of_system() const { return of_system_; }

 private:
  friend struct ReasonNotes;
  int (*before_)(std::int64_t, void*) = nullptr;
  void* data_before_ = nullptr;
  std::string text_;
  bool of_system_ = false;
};

}  // namespace nilas::hdf5
