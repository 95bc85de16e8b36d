// How far a picture has come.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>

namespace hn {

// A line that is overwritten on a terminal, and nothing elsewhere. Several threads may add to it.
class RowsProgress {
 public:
  RowsProgress(std::size_t rows, std::size_t points_in_row);
  ~RowsProgress();
  RowsProgress(const RowsProgress&) = delete;
  RowsProgress& operator=(const RowsProgress&) = delete;

  void add(std::size_t rows);

 private:
  const bool terminal_;
  const std::size_t rows_;
  const std::size_t points_in_row_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::chrono::steady_clock::time_point shown_ = start_;
};

}  // namespace hn
