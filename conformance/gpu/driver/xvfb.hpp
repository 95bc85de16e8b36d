// A display for invisible windows, on a machine without a display.
#pragma once

#include <sys/types.h>

#include <utility>

#include "base/result.hpp"

namespace hn {

// An X server without a screen, which ends with this object, and with the process.
class Xvfb {
 public:
  Xvfb() = default;  // none
  Xvfb(Xvfb&& other) noexcept : pid_(std::exchange(other.pid_, 0)) {}
  Xvfb& operator=(Xvfb&& other) noexcept {
    std::swap(pid_, other.pid_);
    return *this;
  }
  ~Xvfb();

  // Starts one and puts it into the environment; none where DISPLAY names a display, or the system needs no X.
  static Result<Xvfb> where_no_display();

 private:
  explicit Xvfb(pid_t pid) : pid_(pid) {}
  pid_t pid_ = 0;
};

}  // namespace hn
