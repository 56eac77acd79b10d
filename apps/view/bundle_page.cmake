# Bundles the pages of the viewer and of the report into one HTML text each, and the script of the page of comparisons,
# and writes them as a source file.
#   cmake -DSOURCE=<folder of the page> -DBUILD=<folder> -DTESTS=<with the packages of its tests> -DEMBED=<embed_templates.cmake> -P bundle_page.cmake
# Where npm or its packages are missing, the texts are empty: the program then says that it has no viewer, and the page
# of a comparison has pictures alone.
set(page ${BUILD}/out/page.html)
set(report ${BUILD}/out/report.html)
file(MAKE_DIRECTORY ${BUILD})
file(REMOVE ${page} ${report})
# The source folder stays as it is: packages and output go into the build folder.
file(COPY ${SOURCE}/ DESTINATION ${BUILD} PATTERN node_modules EXCLUDE)
find_program(NPM npm)
find_program(NODE node)
set(reason "npm is not installed")
if(NPM AND NODE)
  # Packages are fetched once for each list of them, so that a build without a network keeps its page.
  file(SHA256 ${SOURCE}/package-lock.json lock)
  set(stamp ${BUILD}/node_modules/.nilas-${lock}-${TESTS})
  set(failed 0)
  if(NOT TESTS)
    set(without --omit=dev)
  endif()
  if(NOT EXISTS ${stamp})
    execute_process(COMMAND ${NPM} ci ${without} --no-audit --no-fund --loglevel=error WORKING_DIRECTORY ${BUILD}
                    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE reason TIMEOUT 300)
  endif()
  if(NOT failed)
    file(TOUCH ${stamp})
    execute_process(COMMAND ${NODE} build.mjs ${BUILD}/out WORKING_DIRECTORY ${BUILD}
                    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE reason)
    if(failed)
      message(FATAL_ERROR "the page of the viewer could not be bundled: ${reason}")
    endif()
  endif()
endif()
if(NOT EXISTS ${page})
  message(WARNING "The program is built without its viewer: ${reason}")
  file(MAKE_DIRECTORY ${BUILD}/out)
  file(WRITE ${page} "")
  file(WRITE ${BUILD}/out/compare.js "")
  file(WRITE ${report} "")
endif()
set(OUT ${BUILD}/page.cpp)
set(NAMESPACE view)
set(FUNCTION page_file)
set(HEADER apps/view/page_template.h)
set(FILES "${page}|${report}|${BUILD}/out/compare.js|${SOURCE}/theme.css")
include(${EMBED})
