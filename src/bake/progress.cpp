#include "bake/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace hn {

RowsProgress::RowsProgress(std::size_t rows, std::size_t points_in_row)
    : terminal_(isatty(STDERR_FILENO) != 0), rows_(rows), points_in_row_(points_in_row) {}

RowsProgress::~RowsProgress() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

void RowsProgress::add(std::size_t rows) {
  if (!terminal_) return;
  const std::lock_guard lock(mutex_);
  done_ += rows;
  const auto now = std::chrono::steady_clock::now();
  if (now - shown_ < std::chrono::milliseconds(100)) return;
  shown_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done_ * points_in_row_) / seconds * 1e-6;
  std::fputs(fmt::format("\r\033[K{} of {} rows, {:.1f} million points a second", done_, rows_, rate).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace hn
