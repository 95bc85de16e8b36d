#include "web/page_server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <random>
#include <thread>
#include <utility>

namespace hn {
namespace {

// How soon it is noticed that a page is gone, or that the server shall stop.
constexpr auto kHeartbeat = std::chrono::milliseconds(100);

std::string random_token() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

// From one thread to another, one message at a time; the sender goes on when it is handled.
class Mailbox {
 public:
  // False if nobody will read it any more.
  bool put(std::string message) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return closed_ || !message_; });
    message_ = std::move(message);
    changed_.notify_all();
    changed_.wait(lock, [&] { return closed_ || !message_; });
    return !closed_;
  }

  bool handle_next(std::chrono::milliseconds limit, const std::function<void(const std::string&)>& handle) {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, limit, [&] { return message_.has_value(); })) return false;
    handle(*message_);
    message_.reset();
    changed_.notify_all();
    return true;
  }

  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<std::string> message_;
  bool closed_ = false;
};

}  // namespace

struct PageServer::State {
  std::string page;
  std::string url;
  httplib::Server server;
  Mailbox mailbox;
  std::atomic<bool> page_gone = false;
  std::atomic<bool> stopped = false;
  std::thread thread;

  void add_handlers(const std::string& path) {
    server.Get(path, [this](const httplib::Request&, httplib::Response& response) {
      response.set_content(page, "text/html; charset=utf-8");
    });
    server.Post(path + "event", [this](const httplib::Request& request, httplib::Response& response) {
      response.status = mailbox.put(request.body) ? 204 : 503;
    });
    server.Get(path + "alive", [this](const httplib::Request&, httplib::Response& response) {
      // Text would be compressed, which keeps single bytes back.
      response.set_chunked_content_provider(
          "application/octet-stream",
          [](std::size_t, httplib::DataSink& sink) {
            std::this_thread::sleep_for(kHeartbeat);
            return sink.write(".", 1);
          },
          [this](bool) { page_gone = true; });
    });
  }
};

PageServer::PageServer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PageServer::PageServer(PageServer&&) noexcept = default;

Result<PageServer> PageServer::start(std::string page) {
  auto state = std::make_unique<State>();
  state->page = std::move(page);
  const std::string path = fmt::format("/{}/", random_token());
  state->add_handlers(path);
  state->server.set_tcp_nodelay(true);
  state->server.set_keep_alive_max_count(std::numeric_limits<int>::max());  // one connection for all events
  const int port = state->server.bind_to_any_port("127.0.0.1");
  if (port < 0) return fail("cannot open a port on 127.0.0.1 for the browser");
  state->url = fmt::format("http://127.0.0.1:{}{}", port, path);
  state->thread = std::thread([&listening = *state] {
    listening.server.listen_after_bind();
    listening.stopped = true;
  });
  return PageServer(std::move(state));
}

PageServer::~PageServer() {
  if (!state_) return;
  state_->mailbox.close();
  // stop() before the server runs would be forgotten.
  while (!state_->server.is_running() && !state_->stopped) std::this_thread::yield();
  state_->server.stop();
  state_->thread.join();
}

const std::string& PageServer::url() const { return state_->url; }

bool PageServer::handle_next(std::chrono::milliseconds limit,
                             const std::function<void(const std::string& message)>& handle) {
  return state_->mailbox.handle_next(limit, handle);
}

bool PageServer::page_is_gone() const { return state_->page_gone; }

}  // namespace hn
