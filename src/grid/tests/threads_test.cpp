// Nothing depends on who runs the tasks, nor in what order.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "fields.hpp"
#include "subjects.hpp"

namespace hashnoise::twin {
namespace {

void backwards(int count, const std::function<void(int)>& task) {
  for (int i = count - 1; i >= 0; --i) task(i);
}

// Every task in a thread of its own, all at once.
void all_at_once(int count, const std::function<void(int)>& task) {
  std::vector<std::jthread> workers;
  for (int i = 0; i < count; ++i) workers.emplace_back([&task, i] { task(i); });
}

template <int D, typename Places>
void expect_same_with_any(const Settings& settings, const Places& where) {
  const auto points = places_of(where).size();
  const Field<D> field(settings);
  const FieldValues alone = fill(field, where, points);
  for (const Executor& executor :
       {threads(), threads(1), threads(2), threads(33), Executor(backwards), Executor(all_at_once)}) {
    const FieldValues filled = fill(field, where, points, executor);
    EXPECT_TRUE(same_bits(filled.values, alone.values, points)) << settings;
    EXPECT_EQ(filled.range, alone.range) << settings;
  }
}

class AnyExecutor : public testing::TestWithParam<Arithmetic> {};

// With kFast, too: a point has the same bits wherever the tasks begin, and though vectors hold other points then.
TEST_P(AnyExecutor, GivesTheSame) {
  Chance chance(3);
  for (const InstructionSet set : instruction_sets()) {
    for (const std::string noise : {"perlin", "simplex_d", "cellular"}) {
      Settings settings;
      settings.noise = noise;
      settings.arithmetic = GetParam();
      settings.instruction_set = set;
      settings.seed = chance.word();
      expect_same_with_any<2>(settings, Grid<2>{{0.1f, -50.0f}, {0.0371f, 0.05f}, {211, 307}});
      expect_same_with_any<2>(settings, CellGrid<2>{{7, -9}, {0.1f, 0.9f}, {0.0371, 0.05}, {1, 65537}});
      expect_same_with_any<3>(settings, Grid<3>{{0.1f, -50.0f, 0.0f}, {0.0371f, 0.05f, 0.1f}, {37, 41, 43}});
      expect_same_with_any<2>(settings, Points<2>(draw_points<2>(65537, 100.0f, Draw::kTame, chance)));
      expect_same_with_any<3>(settings, CellPoints<3>(draw_cell_points<3>(20011, chance)));
    }
    Settings sum;
    sum.fractal = "warp";
    sum.noise = "value_vector";
    sum.arithmetic = GetParam();
    sum.instruction_set = set;
    expect_same_with_any<2>(sum, Grid<2>{{0.1f, -50.0f}, {0.0371f, 0.05f}, {307, 211}});
  }
}

INSTANTIATE_TEST_SUITE_P(, AnyExecutor, testing::Values(Arithmetic::kFast, Arithmetic::kPrecise, Arithmetic::kFixed),
                         [](const auto& parameter) { return std::to_string(static_cast<int>(parameter.param)); });

// With kFast, too. The first component of a part of a grid is that of the whole there. `first` is where the part begins
// in the whole.
template <int D, typename AnyGrid>
void expect_part_of_whole(const Settings& settings, AnyGrid grid, const std::array<int, D>& first,
                          const std::array<int, D>& size) {
  const Field<D> field(settings);
  const std::array<int, D> whole_size = grid.size;
  const std::vector<float> whole = fill(field, grid, count_of<D>(whole_size)).values;
  for (std::size_t axis = 0; axis < D; ++axis) grid.first[axis] += first[axis];
  grid.size = size;
  const std::vector<float> part = fill(field, grid, count_of<D>(size)).values;
  std::vector<float> there;
  for_each_index<D>(size, [&](const std::array<int, D>& index) {
    std::size_t at = 0;
    for (std::size_t axis = D; axis-- > 0;) {
      at = at * static_cast<std::size_t>(whole_size[axis]) + static_cast<std::size_t>(first[axis] + index[axis]);
    }
    there.push_back(whole[at]);
  });
  EXPECT_TRUE(same_bits(std::span(part).first(there.size()), there, there.size())) << settings;
}

// Narrow parts, too, which may take another kernel, and each noise and sum.
TEST_P(AnyExecutor, GivesAPartOfAGridTheBitsOfTheWhole) {
  for (const InstructionSet set : instruction_sets()) {
    const auto expect = [&]<int D>(Settings settings, std::integral_constant<int, D>) {
      settings.arithmetic = GetParam();
      settings.instruction_set = set;
      Grid<D> grid;
      grid.origin.fill(0.3f);
      grid.step.fill(0.0371f);
      grid.size.fill(12);
      grid.size[0] = 90;
      grid.first.fill(-6);  // so that parts begin before point 0, and end after it
      CellGrid<D> cells;
      cells.cell.fill(-7);
      cells.f.fill(0.3f);
      cells.step.fill(0.0371);
      cells.size = grid.size;
      cells.first = grid.first;
      std::array<int, D> first;
      first.fill(5);
      std::array<int, D> size;
      size.fill(4);
      size[0] = settings.fractal.empty() ? 70 : 17;
      expect_part_of_whole<D>(settings, grid, first, size);
      size[0] = 5;
      expect_part_of_whole<D>(settings, grid, first, size);
      expect_part_of_whole<D>(settings, cells, first, size);
    };
    for (const Settings& settings : noise_subjects(2)) expect(settings, std::integral_constant<int, 2>{});
    for (const Settings& settings : noise_subjects(3)) expect(settings, std::integral_constant<int, 3>{});
    for (Settings settings : sum_subjects(2)) {
      expect(settings, std::integral_constant<int, 2>{});
      if (settings.fractal != "fbm") continue;
      settings.period = {7, 5};
      expect(settings, std::integral_constant<int, 2>{});
    }
  }
}

TEST(Threads, ManyUseOneField) {
  Settings settings;
  settings.arithmetic = Arithmetic::kFixed;
  const Field<2> field(settings);
  const Grid<2> grid = {{0.1f, 0.2f}, {0.0371f, 0.05f}, {101, 103}};
  const FieldValues alone = fill(field, grid, 101 * 103);
  std::array<std::vector<float>, 4> values;
  {
    std::vector<std::jthread> workers;
    for (auto& each : values) {
      workers.emplace_back([&] {
        each.resize(101 * 103);
        for (int time = 0; time < 5; ++time) field.fill(grid, each, threads(2));
      });
    }
  }
  for (const auto& each : values) EXPECT_TRUE(same_bits(each, alone.values, 101 * 103));
}

TEST(Threads, AreAsManyAsSaid) {
  for (const int count : {1, 2, 5}) {
    std::atomic<int> running = 0;
    std::atomic<int> most = 0;
    std::vector<std::atomic<int>> runs(50);
    threads(count)(50, [&](int i) {
      const int now = ++running;
      for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++runs[static_cast<std::size_t>(i)];
      --running;
    });
    EXPECT_LE(most, count);
    EXPECT_GE(most, std::min(count, 2));
    for (const auto& each : runs) EXPECT_EQ(each, 1);
  }
}

TEST(Threads, AreNotLessThanNoneAndRunNothingOfNothing) {
  EXPECT_THROW(threads(-1), std::invalid_argument);
  threads(3)(0, [](int) { ADD_FAILURE(); });
}

// And the others end.
TEST(Threads, PassOnWhatATaskThrows) {
  int calls = 0;
  EXPECT_THROW(threads(1)(9,
                          [&](int i) {
                            if (++calls; i == 3) throw std::runtime_error("");
                          }),
               std::runtime_error);
  EXPECT_EQ(calls, 4);
}

// The tasks that an executor is given are the whole work.
TEST(Threads, RunTasksOfTheField) {
  const Field<2> field{Settings{}};
  const Grid<2> grid = {{0, 0}, {0.1f, 0.1f}, {512, 512}};
  std::vector<float> values(512 * 512);
  int calls = 0;
  int tasks = 0;
  field.fill(grid, values, [&](int count, const std::function<void(int)>& task) {
    ++calls;
    tasks += count;
    for (int i = 0; i < count; ++i) task(i);
  });
  EXPECT_EQ(calls, 1);
  EXPECT_GE(tasks, 2);  // else nothing can be shared
}

}  // namespace
}  // namespace hashnoise::twin
