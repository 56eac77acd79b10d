#include "apps/view/live_server.h"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/rand.h>

#include <array>
#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include "apps/view/connections.h"
#include "apps/view/end_connections.h"
#include "apps/view/http.h"
#include "apps/view/page.h"
#include "core/base/error.h"
#include "core/output/replay/piece.h"

namespace nilas::view {

namespace {

constexpr std::size_t k_token_bytes = 16, k_part_bytes = 1 << 16;
constexpr std::size_t k_longest_request = 4096;
/// Every open page keeps one thread. The others answer what pages ask for.
constexpr std::size_t k_most_readers = 16;
constexpr std::size_t k_threads = 24;
/// Most connections that are open at once. The run itself needs open files.
constexpr std::size_t k_most_connections = 64;
/// Every request but that of a page for the stream must be over by then.
constexpr std::chrono::seconds k_longest_request_time{10};
constexpr time_t k_keep_alive = 1, k_read_timeout = 2;  // [s]
constexpr std::chrono::seconds k_farewell{2};
constexpr std::chrono::milliseconds k_longest_wait{200};

/// A page may only use what it holds itself and this server.
constexpr const char* k_policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; connect-src "
    "'self'; "
    "worker-src blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string new_token() {
  std::array<unsigned char, k_token_bytes> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw FileError("--view: the system gives no random numbers for a token");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

/// Takes as long for a wrong token as for the right one.
bool same(const std::string& a, const std::string& b) {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

/// Names by which a browser may reach this machine: a page from elsewhere whose name was made to point here has
/// another.
bool is_local_name(const std::string& host) {
  const std::string name = host.substr(0, host.rfind(':'));
  return name == "127.0.0.1" || name == "localhost" || name == "[::1]";
}

/// Whether a page of another site asks. Browsers say where a page comes from, but for plain reading.
bool is_foreign(const httplib::Request& request) {
  const std::string origin = request.get_header_value("Origin");
  return !origin.empty() && origin != "http://" + request.get_header_value("Host");
}

}  // namespace

struct LiveServer::Http {
  httplib::Server server;
  std::thread thread, guard;
  std::atomic<bool> over = false;  ///< the thread does not listen any more
  int port = 0;
};

LiveServer::LiveServer(const LiveAddress& address, const std::string& title, std::filesystem::path replay_file)
    : token_(new_token()),
      page_(live_page(title, token_)),
      file_(std::move(replay_file)),
      http_(std::make_unique<Http>()) {
  httplib::Server& server = http_->server;
  server.new_task_queue = [] { return new BoundedPool(k_threads, k_most_connections); };
  server.set_payload_max_length(k_longest_request);
  server.set_keep_alive_timeout(k_keep_alive);
  server.set_read_timeout(k_read_timeout);
  // The library would share the port with another program.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  const bool is_ipv6 = address.host.find(':') != std::string::npos;
  const std::string shown = is_ipv6 ? "[" + address.host + "]" : address.host;
  const bool only_local = is_local_name(shown + ":");
  server.set_pre_routing_handler([this, only_local](const httplib::Request& request, httplib::Response& response) {
    response.set_header("Content-Security-Policy", k_policy);
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cache-Control", "no-store");
    const bool allowed = same(request.get_param_value("token"), token_) &&
                         (!only_local || is_local_name(request.get_header_value("Host"))) && !is_foreign(request);
    if (allowed) return httplib::Server::HandlerResponse::Unhandled;
    response.status = 403;
    response.set_content("This page needs the whole address that the run printed, with its token.\n", "text/plain");
    return httplib::Server::HandlerResponse::Handled;
  });
  add_routes();
  const int port = address.port > 0 ? (server.bind_to_port(address.host, address.port) ? address.port : -1)
                                    : server.bind_to_any_port(address.host);
  if (port < 0)
    throw FileError(
        fmt::format("--view: {}:{} cannot be opened; another program may use it. --view-port PORT chooses "
                    "another port, and 0 any free one",
                    address.host, address.port));
  http_->port = port;
  address_ = fmt::format("http://{}:{}/?token={}", shown, port, token_);
  http_->thread = std::thread([this] {
    http_->server.listen_after_bind();
    http_->over = true;
  });
  http_->guard = std::thread([this] { guard_connections(); });
  // stop() has no effect on a server that has not begun.
  while (!http_->server.is_running() && !http_->over) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// One page's reading of the replay file. Between two writes of the run it also sends the state of the run.
class LiveServer::Reader {
 public:
  explicit Reader(LiveServer& server) : server_(server) {}

  /// Sends the next part; returns false when the page is gone.
  bool send(httplib::DataSink& sink) {
    const auto upto = server_.wait_for_more(sent_, state_count_);
    if (!upto) {
      sink.done();
      return true;
    }
    if (*upto > sent_) return send_file(*upto, sink);
    if (sent_ > 0 && server_.control_.state().count != state_count_) return send_state(sink);
    return sink.is_writable();  // false once the page is gone
  }

 private:
  bool send_file(std::int64_t upto, httplib::DataSink& sink) {
    std::array<char, k_part_bytes> part;
    if (!file_.is_open()) file_.open(server_.file_, std::ios::binary);
    file_.clear();
    file_.seekg(sent_);
    file_.read(part.data(), std::min<std::int64_t>(upto - sent_, k_part_bytes));
    sent_ += file_.gcount();
    return sink.write(part.data(), static_cast<std::size_t>(file_.gcount()));
  }

  bool send_state(httplib::DataSink& sink) {
    const LiveControl::State state = server_.control_.state();
    state_count_ = state.count;
    const std::string piece = output::replay::packed_piece(output::replay::k_live, state.json);
    return sink.write(piece.data(), piece.size());
  }

  LiveServer& server_;
  std::ifstream file_;
  std::int64_t sent_ = 0;
  int state_count_ = -1;
};

void LiveServer::add_routes() {
  httplib::Server& server = http_->server;
  server.Get("/", [this](const httplib::Request&, httplib::Response& response) {
    response.set_content(page_, "text/html; charset=utf-8");
  });
  server.Get("/events", [this](const httplib::Request& request, httplib::Response& response) {
    const int port = request.remote_port;
    if (!admit_reader(port)) {
      response.status = 503;
      response.set_content("Too many pages of this run are open. Close one, and this one goes on.\n", "text/plain");
      return;
    }
    auto reader = std::make_shared<Reader>(*this);
    response.set_chunked_content_provider(
        "application/octet-stream",
        [reader](std::size_t, httplib::DataSink& sink) {
          try {
            return reader->send(sink);
          } catch (const std::exception&) {
            return false;  // the library would end the program
          }
        },
        [this, port](bool) {
          const std::lock_guard lock(mutex_);
          readers_.erase(readers_.find(port));
          grown_.notify_all();
        });
  });
  server.Post("/control", [this](const httplib::Request& request, httplib::Response& response) {
    try {
      control_.request(request.body);
      response.status = 204;
    } catch (const InputError& fault) {
      response.status = 400;
      response.set_content(std::string(fault.what()) + "\n", "text/plain");
    }
    const std::lock_guard lock(mutex_);
    grown_.notify_all();
  });
}

/// Notes one more open page by the port of its own end, unless too many are open.
bool LiveServer::admit_reader(int port) {
  const std::lock_guard lock(mutex_);
  if (readers_.size() >= k_most_readers) return false;
  readers_.insert(port);
  return true;
}

/// Ends connections that take too long, since the library waits as long as a byte comes every two seconds.
void LiveServer::guard_connections() {
  SlowConnections slow(http_->port, k_longest_request_time);
  while (!http_->over) {
    slow.end([this](int port) {
      const std::lock_guard lock(mutex_);
      return readers_.contains(port);
    });
    std::unique_lock lock(mutex_);
    constexpr std::chrono::milliseconds k_look{500};
    grown_.wait_for(lock, k_look, [this] { return ended_; });
    if (ended_) return;
  }
}

/// Waits a little for the file to have more than `sent` bytes, or for another count of the run's state, and returns the
/// bytes of the file; nothing when there will be no more.
std::optional<std::int64_t> LiveServer::wait_for_more(std::int64_t sent, int state_count) {
  std::unique_lock lock(mutex_);
  grown_.wait_for(lock, k_longest_wait,
                  [&] { return ended_ || bytes_ > sent || (sent > 0 && control_.state().count != state_count); });
  if (ended_ && bytes_ <= sent) return std::nullopt;
  return bytes_;
}

void LiveServer::written(std::int64_t bytes) {
  const std::lock_guard lock(mutex_);
  if (bytes == bytes_) return;
  bytes_ = bytes;
  control_.frame_written();
  grown_.notify_all();
}

LiveServer::~LiveServer() {
  {
    std::unique_lock lock(mutex_);
    ended_ = true;
    grown_.notify_all();
    grown_.wait_for(lock, k_farewell, [this] { return readers_.empty(); });
  }
  http_->guard.join();
  http_->server.stop();
  // The library waits as long as clients go on to send a request, however slowly.
  while (!http_->over) {
    end_connections(http_->port);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (http_->thread.joinable()) http_->thread.join();
}

}  // namespace nilas::view
