#include <hdf5.h>

#include "core/hdf5/hdf5_file.h"

namespace nilas::hdf5 {

Hdf5Silence::Hdf5Silence() {
  // Nothing stays open at the end but what a damaged file kept HDF5 from closing, and that it would complain about.
  H5dont_atexit();
  H5Eget_auto2(H5E_DEFAULT, reinterpret_cast<H5E_auto2_t*>(&print_), &print_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Silence::~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, reinterpret_cast<H5E_auto2_t>(print_), print_data_); }

}  // namespace nilas::hdf5
