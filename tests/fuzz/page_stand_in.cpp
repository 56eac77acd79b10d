/// Stands in for the bundled page of the viewer, which no request can change.
#include "apps/view/page_template.h"

namespace nilas::view {

std::string_view page_file(std::string_view) {
  return "@NILAS_BLOCKS@ @NILAS_FACTS@ @NILAS_DATA@ @NILAS_BODY@ @NILAS_TITLE@";
}

}  // namespace nilas::view
