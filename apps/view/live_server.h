#pragma once
/// Serves the page of a run on this machine while the run goes on.
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "apps/view/live_control.h"

namespace nilas::view {

struct LiveAddress {
  std::string host = "127.0.0.1";
  int port = 0;  ///< 0: a free one
};

/// One server with threads of its own. Pages read the replay file as it grows, so they cost the run nothing. Up to 16
/// may be open at once, and they may come and go. Every request needs the token that is part of the address.
/// At most 64 connections are open at once, and a request that takes longer than ten seconds is ended.
class LiveServer {
 public:
  /// Opens the port. `title`: the name of the scene. The file need not exist yet. Throws FileError where the port
  /// cannot be opened, InputError where the program has no page.
  LiveServer(const LiveAddress& address, const std::string& title, std::filesystem::path replay_file);
  /// Lets open pages read what is left, for at most two seconds, and closes the port.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  /// What a user opens in a browser: http://127.0.0.1:PORT/?token=...
  const std::string& address() const { return address_; }
  LiveControl& control() { return control_; }
  /// The replay file now has this many bytes of whole pieces.
  void written(std::int64_t bytes);

 private:
  struct Http;
  class Reader;
  void add_routes();
  bool admit_reader(int port);
  void guard_connections();
  std::optional<std::int64_t> wait_for_more(std::int64_t sent, int state_count);

  std::string token_, page_, address_;
  std::filesystem::path file_;
  LiveControl control_;
  std::mutex mutex_;
  std::condition_variable grown_;
  std::int64_t bytes_ = 0;
  bool ended_ = false;
  std::multiset<int> readers_;  ///< ports of the other ends
  std::unique_ptr<Http> http_;
};

}  // namespace nilas::view
