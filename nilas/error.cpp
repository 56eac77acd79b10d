#include "nilas/error.h"

#include "nilas/translate.h"

namespace nilas {

Error::Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
Error::~Error() = default;

namespace library {

void rethrow_as_error() {
  try {
    throw;
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const SceneError& e) {
    throw Error(e.only_unreadable_files() ? ErrorKind::file : ErrorKind::input, e.what());
  } catch (const InputError& e) {
    throw Error(ErrorKind::input, e.what());
  } catch (const FileError& e) {
    throw Error(ErrorKind::file, e.what());
  } catch (const std::filesystem::filesystem_error& e) {
    throw Error(ErrorKind::file, e.what());
  } catch (const SimulationError& e) {
    throw Error(ErrorKind::numerics, e.what());
  } catch (const std::exception& e) {
    throw Error(ErrorKind::defect, std::string("a fault of Nilas, please report it: ") + e.what());
  }
}

}  // namespace library

}  // namespace nilas
