// Saying how far a long task has come.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

namespace hn {

// A line that is overwritten on a terminal; elsewhere a whole line every ten seconds, and at the end.
class Progress {
 public:
  Progress(std::FILE* out, std::size_t total);
  ~Progress();
  // seconds_left: where it is known.
  void show(std::size_t done, std::size_t failed, const std::string& current,
            std::optional<double> seconds_left = std::nullopt);

 private:
  std::FILE* out_;
  bool terminal_;
  std::size_t total_;
  std::chrono::steady_clock::time_point next_line_ = {};
  bool ended_ = false;
};

}  // namespace hn
