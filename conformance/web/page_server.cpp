#include "web/page_server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <limits>
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

}  // namespace

struct PageServer::State {
  std::string page;
  std::string url;
  httplib::Server server;
  std::function<void(const std::string&)> handle;
  std::atomic<bool> page_gone = false;
  std::atomic<bool> stopped = false;
  std::thread thread;

  void add_handlers(const std::string& path) {
    server.Get(path, [this](const httplib::Request&, httplib::Response& response) {
      response.set_content(page, "text/html; charset=utf-8");
    });
    server.Post(path + "event", [this](const httplib::Request& request, httplib::Response& response) {
      handle(request.body);
      response.status = 204;
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

Result<PageServer> PageServer::start(std::string page, std::function<void(const std::string&)> handle) {
  auto state = std::make_unique<State>();
  state->page = std::move(page);
  state->handle = std::move(handle);
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
  // stop() before the server runs would be forgotten.
  while (!state_->server.is_running() && !state_->stopped) std::this_thread::yield();
  state_->server.stop();
  state_->thread.join();
}

const std::string& PageServer::url() const { return state_->url; }

bool PageServer::page_is_gone() const { return state_->page_gone; }

}  // namespace hn
