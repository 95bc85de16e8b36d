// A program's output: whether it arrived, and how far a long task has come.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace hn {

// Writes to the standard error, with the program's name.
void complain(std::string_view program, std::string_view message);

// Printed text may not have arrived: on a full disk, for example. Then this complains, and a status of 0 becomes 1.
int status_once_printed(std::string_view program, int status);

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
