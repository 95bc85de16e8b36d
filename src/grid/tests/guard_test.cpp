// Tests what kernels read and write: arrays end at a page that cannot be touched.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <hashnoise/field.hpp>
#include <numeric>

namespace {

// Numbers whose last one, or whose first one, lies at such a page.
template <typename Number>
class GuardedArray {
 public:
  GuardedArray(std::size_t count, bool at_end) : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
    room_ = (count * sizeof(Number) + page_ - 1) / page_ * page_;
    base_ = static_cast<char*>(
        mmap(nullptr, room_ + 2 * page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    mprotect(base_, page_, PROT_NONE);
    mprotect(base_ + page_ + room_, page_, PROT_NONE);
    char* const first = at_end ? base_ + page_ + room_ - count * sizeof(Number) : base_ + page_;
    numbers_ = {reinterpret_cast<Number*>(first), count};
    std::iota(numbers_.begin(), numbers_.end(), Number(-3));
  }
  ~GuardedArray() { munmap(base_, room_ + 2 * page_); }
  GuardedArray(const GuardedArray&) = delete;
  GuardedArray& operator=(const GuardedArray&) = delete;

  std::span<Number> span() const { return numbers_; }

 private:
  std::size_t page_;
  std::size_t room_ = 0;
  char* base_ = nullptr;
  std::span<Number> numbers_;
};

class Guard : public testing::TestWithParam<bool> {};

void touch(const hashnoise::Settings& settings, std::size_t count, bool at_end) {
  const hashnoise::Field<2> field(settings);
  const GuardedArray<float> x(count, at_end), y(count, at_end);
  const GuardedArray<std::int32_t> cell_x(count, at_end), cell_y(count, at_end);
  const GuardedArray<float> values(count * static_cast<std::size_t>(field.component_count()), at_end);
  field.fill(hashnoise::Points<2>{{x.span(), y.span()}}, values.span());
  field.fill(hashnoise::CellPoints<2>{{cell_x.span(), cell_y.span()}, {x.span(), y.span()}}, values.span());
  const auto width = static_cast<int>(count);
  field.fill(hashnoise::Grid<2>{{0, 0}, {0.1f, 0.1f}, {width, 1}}, values.span());
  field.fill(hashnoise::CellGrid<2>{{0, 0}, {0, 0}, {0.1, 0.1}, {1, width}}, values.span());
}

TEST_P(Guard, NothingBesideTheArraysIsTouched) {
  for (const hashnoise::InstructionSet set : hashnoise::instruction_sets()) {
    for (const char* const sum : {"", "fbm", "warp"}) {
      hashnoise::Settings settings;
      settings.instruction_set = set;
      settings.fractal = sum;
      if (!settings.fractal.empty()) settings.octaves = 2;
      for (std::size_t count = 1; count < 84; ++count) touch(settings, count, GetParam());
      if (settings.fractal.empty()) settings.noise = "perlin_d";
      for (const std::size_t count : {1, 15, 16, 17, 1023, 1024, 1025}) touch(settings, count, GetParam());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothEnds, Guard, testing::Bool());

using GuardDeathTest = Guard;

TEST_P(GuardDeathTest, TheGuardIsThere) {
  const GuardedArray<float> numbers(17, GetParam());
  volatile float* const beside = GetParam() ? numbers.span().data() + 17 : numbers.span().data() - 1;
  EXPECT_DEATH(*beside = 1.0f, "");
}

INSTANTIATE_TEST_SUITE_P(BothEnds, GuardDeathTest, testing::Bool());

}  // namespace
