#include "web/browser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "run/results.hpp"
#include "web/chromium.hpp"
#include "web/page_server.hpp"
#include "web/suite.hpp"

namespace hn {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

// Three seconds on two idle cores. How long a case may take is for the caller to decide.
constexpr auto kLongestStart = std::chrono::seconds(60);
constexpr auto kPoll = std::chrono::milliseconds(100);

ContextInfo info_of(const Json& event, const Browser& browser) {
  ContextInfo info = context_info_from(event);
  info.languages = browser.platform == Platform::webgpu ? webgpu_languages() : kWebGl2Languages;
  return info;
}

// The results so far, from the page's messages, which a thread of the server has.
class Conversation {
 public:
  Conversation(const Browser& browser, std::span<const Case> cases, const CaseEvents& events)
      : browser_(browser), cases_(cases), events_(events) {}

  // An error in a message of the page, or its end, ends the conversation.
  void hear(const std::string& message) {
    const std::lock_guard lock(mutex_);
    if (over()) return;
    try {
      hear(Json::parse(message));
    } catch (const Json::exception& exception) {
      misunderstand(exception, message);
    } catch (const std::invalid_argument& exception) {
      misunderstand(exception, message);
    }
    if (over()) ended_.notify_all();
  }

  // Whether it ends within this time.
  bool ends_within(std::chrono::milliseconds limit) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, limit, [this] { return over(); });
  }
  bool ready() const { return ready_; }
  std::string running() const {
    const std::lock_guard lock(mutex_);
    return running_;
  }
  Result<void> result() const { return error_ ? Result<void>(tl::unexpected(*error_)) : Result<void>(); }

 private:
  bool over() const { return done_ || error_; }

  void hear(const Json& event) {
    const std::string type = event.at("type");
    if (type == "ready") {
      meet(info_of(event, browser_));
    } else if (type == "started") {
      running_ = event.at("id");
      finish_unsupported_until(running_);
      events_.started(running_);
    } else if (type == "finished") {
      events_.finished(case_result_from(event));
      running_.clear();
      ++next_;
    } else if (type == "done") {
      finish_unsupported_until({});
      done_ = true;
    } else {
      const auto message = event.at("message").get<std::string>();
      error_ = Error{fmt::format("the page could not go on: {}", message), {}};
      const bool no_context =
          message.find("WebGL2") != std::string::npos || message.find("WebGPU") != std::string::npos;
      if (!ready_ && no_context) tell_absent();
    }
  }

  void misunderstand(const std::exception& exception, const std::string& message) {
    error_ = Error{fmt::format("the page sent an unknown message: {}", exception.what()), message};
  }

  void tell_absent() const {
    if (events_.absent) events_.absent(error_->text());
  }

  void meet(const ContextInfo& info) {
    if (info.renderer.find(browser_.renderer) == std::string::npos) {
      error_ = Error{fmt::format("Chromium uses \"{}\" instead of {}", info.renderer, browser_.renderer), {}};
      tell_absent();
      return;
    }
    ready_ = true;
    events_.ready(info);
  }

  // Cases that do not go to the page have their verdict in their place among the others.
  void finish_unsupported_until(std::string_view id) {
    for (; next_ < cases_.size() && cases_[next_].id != id; ++next_) {
      const Case& test = cases_[next_];
      events_.started(test.id);
      events_.finished(
          {test.id, outcome_with(Status::unsupported, {unsupported_in_browser(test, browser_.platform), {}}), 0.0});
    }
  }

  const Browser& browser_;
  std::span<const Case> cases_;
  const CaseEvents& events_;
  std::size_t next_ = 0;
  mutable std::mutex mutex_;
  std::condition_variable ended_;
  std::string running_;
  std::atomic<bool> ready_ = false;
  bool done_ = false;
  std::optional<Error> error_;
};

// Why it makes no sense to wait any longer; nothing if it does.
std::optional<Error> trouble(const GuardedProcess& chromium, const PageServer& server, const Conversation& conversation,
                             Clock::time_point start) {
  const std::string running = conversation.running();
  const std::string when = running.empty() ? running : fmt::format(" while {} ran", running);
  if (const auto end = chromium.ended()) return Error{fmt::format("Chromium {}{}", *end, when), chromium.log()};
  if (server.page_is_gone()) return Error{fmt::format("the page was gone{}", when), chromium.log()};
  if (!conversation.ready() && Clock::now() - start > kLongestStart) {
    return Error{fmt::format("Chromium has not shown the page after {} s", kLongestStart.count()), chromium.log()};
  }
  return std::nullopt;
}

Result<void> converse(const Browser& browser, const std::string& suite, Conversation& conversation) {
  HN_TRY(auto page, web_page(suite));
  HN_TRY(const auto server,
         PageServer::start(std::move(page), [&](const std::string& message) { conversation.hear(message); }));
  const auto start = Clock::now();
  HN_TRY(const auto chromium, start_chromium(browser, server.url()));
  while (!conversation.ends_within(kPoll)) {
    if (auto error = trouble(chromium, server, conversation, start)) return tl::unexpected(std::move(*error));
  }
  return conversation.result();
}

constexpr std::string_view kReportTo = "event";

}  // namespace

Result<void> run_in_browser(const Browser& browser, const SourceSet& sources, const std::filesystem::path& golden,
                            std::span<const std::string> ids, const CaseEvents& events) {
  if (const auto program = find_program(browser); !program) {
    if (events.absent) events.absent(program.error().text());
    return tl::unexpected(program.error());
  }
  HN_TRY(const auto cases, cases_with(ids));
  std::vector<Case> supported = cases;
  std::erase_if(supported, [&](const Case& test) { return !unsupported_in_browser(test, browser.platform).empty(); });
  Conversation conversation(browser, cases, events);
  return converse(browser, make_suite(sources, golden, supported, kReportTo, browser.platform).json, conversation);
}

Result<ContextInfo> describe_browser(const Browser& browser) {
  ContextInfo found;
  const CaseEvents events = {[&](const ContextInfo& info) { found = info; }, [](const std::string&) {},
                             [](const CaseResult&) {}};
  Conversation conversation(browser, {}, events);
  HN_DO(converse(browser, make_suite(SourceSet::embedded(), {}, {}, kReportTo, browser.platform).json, conversation));
  return found;
}

}  // namespace hn
