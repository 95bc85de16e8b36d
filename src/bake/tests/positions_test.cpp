#include "bake/positions.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

TEST(Positions, ArePlacesOfACell) {
  const Axis axis = axis_of(0.0, 2.0, 8);
  EXPECT_EQ(axis.cell, (std::vector<std::int32_t>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(axis.f, (std::vector<float>{0.0f, 0.25f, 0.5f, 0.75f, 0.0f, 0.25f, 0.5f, 0.75f}));
  EXPECT_EQ(axis.p, (std::vector<float>{0.0f, 0.25f, 0.5f, 0.75f, 1.0f, 1.25f, 1.5f, 1.75f}));
}

// Errors do not add up: what follows the last point of a tile is the first point of the next one.
TEST(Positions, OfATileGoOnWhereItEnds) {
  for (const int size : {1, 3, 7, 100, 1000, 1024, 4001}) {
    for (const int cells : {1, 3, 8, 1000, 1 << 20}) {
      const Axis one = axis_of(0.0, cells, size);
      const Axis two = axis_of(0.0, 2.0 * cells, 2 * size);
      for (int i = 0; i < size; ++i) {
        const auto here = static_cast<std::size_t>(i);
        const auto there = static_cast<std::size_t>(i + size);
        ASSERT_EQ(two.cell[here], one.cell[here]);
        ASSERT_EQ(two.f[here], one.f[here]);
        ASSERT_EQ(two.cell[there], one.cell[here] + cells) << size << " " << cells << " " << i;
        ASSERT_EQ(two.f[there], one.f[here]) << size << " " << cells << " " << i;
      }
    }
  }
}

TEST(Positions, FromAnOrigin) {
  const Axis axis = axis_of(-0.25, 1.0, 2);
  EXPECT_EQ(axis.cell, (std::vector<std::int32_t>{-1, 0}));
  EXPECT_EQ(axis.f, (std::vector<float>{0.75f, 0.25f}));
  const Axis far = axis_of(1073741823.5, 1.0, 4);
  EXPECT_EQ(far.cell, (std::vector<std::int32_t>{1073741823, 1073741823, 1073741824, 1073741824}));
  EXPECT_EQ(far.f, (std::vector<float>{0.5f, 0.75f, 0.0f, 0.25f}));
}

TEST(Positions, StayInsideTheirCells) {
  const Axis axis = axis_of(0.1, 12.3, 997);
  for (const float f : axis.f) {
    EXPECT_GE(f, 0.0f);
    EXPECT_LT(f, 1.0f);
  }
}

}  // namespace
}  // namespace hn
