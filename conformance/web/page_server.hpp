// Serves a page to a browser on this machine, and hands on the page's messages, in the thread that waits for them.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/result.hpp"

namespace hn {

class PageServer {
 public:
  // On a free port of 127.0.0.1, under a path that nobody can guess.
  static Result<PageServer> start(std::string page);
  PageServer(PageServer&&) noexcept;
  PageServer& operator=(PageServer&&) = delete;
  ~PageServer();  // the browser should be gone by then

  const std::string& url() const;

  // Waits for a message that the page posts to "event", and answers it once it is handled. False if none came in time.
  bool handle_next(std::chrono::milliseconds limit, const std::function<void(const std::string& message)>& handle);

  // Whether the page held its connection to "alive", and no longer does.
  bool page_is_gone() const;

 private:
  struct State;
  explicit PageServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hn
