// Serves a page to a browser on this machine, and hands on the page's messages.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/result.hpp"

namespace hn {

class PageServer {
 public:
  // On a free port of 127.0.0.1, under a path that nobody can guess. Messages that the page posts to "event" are
  // answered once they are handled, in a thread of the server.
  static Result<PageServer> start(std::string page, std::function<void(const std::string& message)> handle);
  PageServer(PageServer&&) noexcept;
  PageServer& operator=(PageServer&&) = delete;
  ~PageServer();  // the browser should be gone by then

  const std::string& url() const;

  // Whether the page held its connection to "alive", and no longer does.
  bool page_is_gone() const;

 private:
  struct State;
  explicit PageServer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hn
