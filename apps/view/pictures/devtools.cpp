#include "apps/view/pictures/devtools.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cctype>

#include "core/base/error.h"
#include "core/output/file/base64.h"

namespace nilas::view {

namespace {

/// The address of a file, with all bytes encoded that have a meaning in an address.
std::string file_address(const std::filesystem::path& file) {
  std::string address = "file://";
  for (const unsigned char c : std::filesystem::absolute(file).string())
    address += std::isalnum(c) != 0 || c == '/' || c == '.' || c == '-' || c == '_'
                   ? std::string(1, static_cast<char>(c))
                   : fmt::format("%{:02X}", c);
  return address;
}

/// The descriptors of `--remote-debugging-pipe`.
constexpr ChildEnds k_debugging{.reads = 3, .writes = 4};
/// Limits of the browser's answers [s]. A long replay on a busy machine takes a minute to load.
constexpr double k_start_s = 120, k_answer_s = 120, k_load_s = 600;

std::vector<std::string> browser_command(const std::filesystem::path& browser, const std::filesystem::path& folder) {
  std::vector<std::string> command{
      browser.string(), "--headless", "--remote-debugging-pipe", "--user-data-dir=" + (folder / "profile").string(),
      // The processor draws: the picture does not depend on a graphics card.
      "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-gpu-watchdog",
      "--disable-hang-monitor", "--force-color-profile=srgb", "--force-device-scale-factor=1", "--disable-lcd-text",
      "--font-render-hinting=none", "--hide-scrollbars", "--mute-audio",
      // Shared memory is small in containers.
      "--disable-dev-shm-usage",
      // Nothing leaves this machine.
      "--host-resolver-rules=MAP * ~NOTFOUND", "--disable-background-networking", "--disable-component-update",
      "--disable-default-apps", "--disable-extensions", "--disable-sync", "--no-first-run",
      "--no-default-browser-check", "--metrics-recording-only", "--password-store=basic", "--use-mock-keychain"};
  // Chromium refuses to start for root with its sandbox, and root is the usual user of a container. The page is this
  // program's own and loads nothing.
  if (::geteuid() == 0) command.emplace_back("--no-sandbox");
  command.emplace_back("about:blank");
  return command;
}

}  // namespace

DevTools::DevTools(const std::filesystem::path& browser, const std::filesystem::path& folder, int width, int height)
    : child_(browser_command(browser, folder), k_debugging, folder / "browser.log") {
  const Json target = call("Target.createTarget", {{"url", "about:blank"}}, k_start_s);
  const Json attached =
      call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}}, k_answer_s);
  session_ = attached.at("sessionId").get<std::string>();
  call("Page.enable", Json::object(), k_answer_s);
  call("Inspector.enable", Json::object(), k_answer_s);
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}}, k_answer_s);
  call("Emulation.setEmulatedMedia",
       {{"features", Json::array({{{"name", "prefers-color-scheme"}, {"value", "light"}},
                                  {{"name", "prefers-reduced-motion"}, {"value", "reduce"}}})}},
       k_answer_s);
}

void DevTools::open(const std::filesystem::path& file) {
  events_.clear();
  const Json answer = call("Page.navigate", {{"url", file_address(file)}}, k_load_s);
  if (answer.contains("errorText"))
    throw FileError(fmt::format(
        "the browser cannot open {} ({}). A browser from snap reads files in your home folder only: let TMPDIR name a "
        "folder there whose name does not begin with a dot",
        file.string(), answer.at("errorText").get<std::string>()));
  while (!events_.contains("Page.loadEventFired")) note_event(next_message(k_load_s));
}

nlohmann::json DevTools::evaluate(const std::string& expression, double limit_s) {
  const Json answer =
      call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}}, limit_s);
  const Json& result = answer.at("result");
  if (answer.contains("exceptionDetails")) {
    const std::string said = result.value("description", answer.at("exceptionDetails").value("text", ""));
    throw FileError("the page cannot draw: " + said.substr(0, said.find("\n    at ")));
  }
  return result.contains("value") ? result.at("value") : Json(nullptr);
}

std::string DevTools::screenshot(bool fast) {
  const Json answer = call("Page.captureScreenshot", {{"format", "png"}, {"optimizeForSpeed", fast}}, k_answer_s);
  const auto& text = answer.at("data").get_ref<const std::string&>();
  std::string png = output::from_base64(text);
  for (std::size_t k = text.size(); k > 0 && text[k - 1] == '='; --k) png.pop_back();
  return png;
}

nlohmann::json DevTools::call(const std::string& method, Json parameters, double limit_s) {
  const int id = ++last_id_;
  Json message{{"id", id}, {"method", method}, {"params", std::move(parameters)}};
  if (!session_.empty()) message["sessionId"] = session_;
  const std::string text = message.dump();
  child_.write(std::string_view(text.c_str(), text.size() + 1), limit_s);
  for (;;) {
    Json answer = next_message(limit_s);
    if (answer.value("id", 0) != id) {
      note_event(answer);
      continue;
    }
    if (answer.contains("error"))
      throw FileError(fmt::format("the browser refused {}: {}", method, answer.at("error").value("message", "")));
    return answer.value("result", Json::object());
  }
}

nlohmann::json DevTools::next_message(double limit_s) {
  for (;;) {
    const auto end = received_.find('\0', searched_);
    if (end != std::string::npos) {
      Json message = Json::parse(std::string_view(received_).substr(0, end), nullptr, false);
      received_.erase(0, end + 1);
      searched_ = 0;
      if (message.is_object()) return message;
      throw FileError("the browser sent a message that cannot be read");
    }
    searched_ = received_.size();
    child_.read(received_, limit_s);
  }
}

void DevTools::note_event(const Json& message) {
  const std::string name = message.value("method", "");
  if (name == "Inspector.targetCrashed")
    throw FileError("the page of the run crashed in the browser, which may lack memory for it");
  events_.insert(name);
}

}  // namespace nilas::view
