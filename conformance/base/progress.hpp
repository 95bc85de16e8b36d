// Saying how far a long task has come.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace hn {

// A line that is overwritten on a terminal; now and then a whole line elsewhere.
class Progress {
 public:
  Progress(std::FILE* out, std::size_t total);
  ~Progress();
  void show(std::size_t done, std::size_t failed, const std::string& current);

 private:
  std::FILE* out_;
  bool terminal_;
  std::size_t total_;
  std::size_t last_tenth_ = 0;
};

}  // namespace hn
