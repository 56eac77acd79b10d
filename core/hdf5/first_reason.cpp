#include "core/hdf5/first_reason.h"

#include <hdf5.h>

#include <cstring>

namespace nilas::hdf5 {

/// What HDF5 calls while it reports a failure.
struct ReasonNotes {
  static herr_t note(hid_t stack, void* data) {
    auto& self = *static_cast<FirstReason*>(data);
    return self.text_.empty() ? H5Ewalk2(stack, H5E_WALK_UPWARD, look, data) : 0;
  }
  static herr_t look(unsigned, const H5E_error2_t* error, void* data) {
    auto& self = *static_cast<FirstReason*>(data);
    constexpr const char* k_before = "error message = '";
    const char* const found = error->desc == nullptr ? nullptr : std::strstr(error->desc, k_before);
    if (found != nullptr) {
      self.text_ = found + std::strlen(k_before);
      self.text_ = self.text_.substr(0, self.text_.find('\''));
      self.of_system_ = true;
    } else if (self.text_.empty() && error->desc != nullptr) {
      self.text_ = error->desc;
    }
    return 0;
  }
};

FirstReason::FirstReason() {
  H5Eget_auto2(H5E_DEFAULT, reinterpret_cast<H5E_auto2_t*>(&before_), &data_before_);
  H5Eset_auto2(H5E_DEFAULT, ReasonNotes::note, this);
}

FirstReason::~FirstReason() { H5Eset_auto2(H5E_DEFAULT, reinterpret_cast<H5E_auto2_t>(before_), data_before_); }

}  // namespace nilas::hdf5
