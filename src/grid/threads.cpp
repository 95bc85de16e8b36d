#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <hashnoise/field.hpp>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace hashnoise::inline HN_I_LIBRARY {

Executor threads(int count) {
  if (count < 0) {
    throw std::invalid_argument("threads: count is " + std::to_string(count) + ", and has to be 0 or more");
  }
  if (count == 0) count = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
  count = 1;  // a thread cannot start, and without exceptions that would end the program
#endif
  return [count](int tasks, const std::function<void(int)>& task) {
    std::atomic<int> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
      try {
        for (int i = next++; i < tasks; i = next++) task(i);
      } catch (...) {
        next = tasks;
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
      }
    };
    {
      std::vector<std::future<void>> others;  // the end of each waits for its thread
      for (int i = 1; i < std::min(count, tasks); ++i) others.push_back(std::async(std::launch::async, work));
      work();
    }
    if (failure) std::rethrow_exception(failure);
  };
}

}  // namespace hashnoise
