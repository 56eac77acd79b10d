#pragma once
/// A browser without a window that is steered over the protocol of its developer tools.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "apps/view/pictures/piped_child.h"

namespace nilas::view {

/// One browser with one page. It draws by software, so that the same page gives the same picture on any graphics card
/// and on none. Its messages are JSON texts that a zero byte ends, over two sockets
/// (https://chromedevtools.github.io/devtools-protocol). It asks no other machine for anything.
class DevTools {
 public:
  /// `folder`: for its profile and log; it must be this program's own. Throws FileError where the browser does not
  /// answer.
  DevTools(const std::filesystem::path& browser, const std::filesystem::path& folder, int width, int height);

  /// Opens a file and waits until it was loaded. Throws FileError.
  void open(const std::filesystem::path& file);
  /// The value of an expression of the page's script, once its promise is kept. Throws FileError with the page's own
  /// words where it fails, or where there is no value after `limit_s`.
  nlohmann::json evaluate(const std::string& expression, double limit_s);
  /// What the page looks like: the bytes of a PNG file. `fast`: packed less.
  std::string screenshot(bool fast);

 private:
  using Json = nlohmann::json;
  Json call(const std::string& method, Json parameters, double limit_s);
  Json next_message(double limit_s);
  void note_event(const Json& message);

  PipedChild child_;
  std::string received_, session_;
  std::size_t searched_ = 0;  ///< so many of the received bytes hold no end of a message
  int last_id_ = 0;
  std::set<std::string> events_;  ///< those that came since the last page was opened
};

}  // namespace nilas::view
