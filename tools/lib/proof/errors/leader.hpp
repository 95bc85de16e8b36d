// Where lanes decide otherwise, each goes its own way: in a run of the text the first lane that is not done leads. Its
// answers are taken, and the lanes that answer otherwise are left for another run.
#pragma once

#include <bit>
#include <cstdint>

#include "roundings/ways.hpp"

namespace hn::roundings {

class Leader {
 public:
  void restart() { left_ = kAll; }
  // Whether there is another run.
  bool begin() {
    active_ = left_;
    return left_ != 0;
  }
  // The lanes that stayed, a bit for each.
  std::uint32_t end() {
    left_ &= ~active_;
    return active_;
  }

  // The leader's number of these, one for each lane.
  template <typename Numbers>
  auto chosen(const Numbers& numbers) {
    const auto answer = numbers[std::countr_zero(active_)];
    std::uint32_t same = 0;
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) same |= std::uint32_t{numbers[lane] == answer} << lane;
    active_ &= same;
    return answer;
  }
  template <typename Answers>
  bool decided(const Answers& answers) {  // each is 0 or -1
    return chosen(answers) != 0;
  }

 private:
  static constexpr std::uint32_t kAll = (1u << kLanes) - 1u;
  std::uint32_t left_ = kAll, active_ = kAll;
};
inline thread_local Leader leader;

}  // namespace hn::roundings

#ifndef HN_I_DECIDED  // own_test.py has another, which must be found wrong
#define HN_I_DECIDED(answers) hn::roundings::leader.decided(answers)
#endif
