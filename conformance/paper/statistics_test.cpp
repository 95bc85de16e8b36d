#include "paper/statistics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace hn {
namespace {

// The expected values are scipy 1.17.1's, of these samples made in Python with numpy (np) and scipy.stats:
//   near:  i = np.arange(n); x = ((i*7919)%10007 + i*i%10009 + i*i*i%9973 - 15000)/4096
//   cubes: u = (np.arange(n)*7919%10007)/10007-0.5; x = u*u*u+0.1*u*u
//   then:  x = x.astype(np.float32).astype(np.float64)
//          x.min(), x.max(), x.mean(), x.var(), scipy.stats.skew(x), scipy.stats.kurtosis(x), scipy.stats.normaltest(x)
std::vector<float> near(std::int64_t count) {
  std::vector<float> values;
  for (std::int64_t i = 0; i < count; ++i) {
    const auto sum = static_cast<double>((i * 7919) % 10007 + i * i % 10009 + i * i * i % 9973 - 15000);
    values.push_back(static_cast<float>(sum / 4096.0));
  }
  return values;
}

std::vector<float> cubes(std::int64_t count, double offset) {
  std::vector<float> values;
  for (std::int64_t i = 0; i < count; ++i) {
    const double u = static_cast<double>(i * 7919 % 10007) / 10007.0 - 0.5;
    values.push_back(static_cast<float>(u * u * u + 0.1 * u * u + offset));
  }
  return values;
}

void expect_moments(const std::vector<float>& values, const Moments& expected) {
  const auto actual = moments(values);
  ASSERT_TRUE(actual) << actual.error().text();
  EXPECT_EQ(actual->count, expected.count);
  EXPECT_EQ(actual->minimum, expected.minimum);
  EXPECT_EQ(actual->maximum, expected.maximum);
  EXPECT_NEAR(actual->mean, expected.mean, 1e-13 * std::abs(expected.mean));
  EXPECT_NEAR(actual->variance, expected.variance, 1e-11 * expected.variance);
  EXPECT_NEAR(actual->skewness, expected.skewness, 1e-10);
  EXPECT_NEAR(actual->excess_kurtosis, expected.excess_kurtosis, 1e-10);
}

TEST(Statistics, MomentsByHand) {
  // Deviations -1.5, -0.5, 0.5, 1.5: m2 = 1.25, m4 = 2.5625, 2.5625 / 1.5625 - 3 = -1.36.
  const auto result = moments(std::array{1.0f, 2.0f, 3.0f, 4.0f});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->mean, 2.5);
  EXPECT_EQ(result->variance, 1.25);
  EXPECT_NEAR(result->skewness, 0.0, 1e-15);
  EXPECT_NEAR(result->excess_kurtosis, -1.36, 1e-15);
}

TEST(Statistics, MomentsAreThoseOfScipy) {
  expect_moments(near(500), {500, -3.662109375, 3.25537109375, -0.15077978515625, 1.5558364048697948,
                             -0.12076789074344267, -0.2989611110663315});
  expect_moments(near(1 << 18), {1 << 18, -3.662109375, 3.59716796875, -0.0017936285585165024, 1.5151325962764508,
                                 -0.003202712607688368, -0.39593099328735715});
  expect_moments(cubes(1 << 16, 0.0), {1 << 16, -0.10000000149011612, 0.14991506934165955, 0.008325884606178568,
                                       0.0022875431654470948, 0.6817545333199728, 0.9554255621058361});
}

// A sum of squares would lose all the digits of this variance but three.
TEST(Statistics, MomentsFarFromZeroKeepTheirDigits) {
  expect_moments(cubes(1 << 16, 1000.0), {1 << 16, 999.9000244140625, 1000.14990234375, 1000.0083252424374,
                                          0.0022875471213820286, 0.6817741590487221, 0.9553704605244562});
}

TEST(Statistics, ValuesAllTheSameHaveNoShape) {
  const auto result = moments(std::vector<float>(1000, 0.1f));
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->variance, 0.0, 1e-30);
  EXPECT_TRUE(std::isnan(result->skewness));
  EXPECT_TRUE(std::isnan(result->excess_kurtosis));
  const auto test = normality_test(*result);
  ASSERT_FALSE(test);
  EXPECT_EQ(test.error().message, "the normality test needs values that are not all the same");
}

TEST(Statistics, MomentsOfNothingOrOfNanAreAnError) {
  EXPECT_EQ(moments({}).error().message, "without values there are no moments");
  const auto nan = moments(std::array{1.0f, std::numeric_limits<float>::quiet_NaN(), 2.0f});
  ASSERT_FALSE(nan);
  EXPECT_EQ(nan.error().message, "there are no moments: value 1 of 3 is nan");
  EXPECT_FALSE(moments(std::array{std::numeric_limits<float>::infinity()}));
}

TEST(Statistics, HistogramHasLeftEdgesAndTheLastRightOne) {
  const std::array values = {-0.1f, 0.0f, 0.49f, 0.5f, 0.99f, 1.0f, 1.1f, std::numeric_limits<float>::quiet_NaN()};
  EXPECT_EQ(histogram(values, 0.0, 1.0, 2), (std::vector<std::uint64_t>{2, 3}));
}

// Thousandths as floats, of which those at the edges are above or below them: np.histogram(y, 10, (0.0, 1.0)) of
//   y = (np.arange(1001)/1000).astype(np.float32).astype(np.float64)
TEST(Statistics, HistogramIsThatOfNumpyAtTheEdges) {
  std::vector<float> values;
  for (int i = 0; i <= 1000; ++i) values.push_back(static_cast<float>(i / 1000.0));
  EXPECT_EQ(histogram(values, 0.0, 1.0, 10),
            (std::vector<std::uint64_t>{100, 100, 100, 100, 100, 100, 101, 99, 101, 100}));
}

// The quotient is 9, but the edge between bins 8 and 9 is -0.12499999999999956: np.histogram([-0.125], 12, (-2.9, 0.8))
TEST(Statistics, HistogramGoesByTheEdgesNotByTheQuotient) {
  EXPECT_EQ(histogram(std::array{-0.125f}, -2.9, 0.8, 12),
            (std::vector<std::uint64_t>{0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}));
}

// np.histogram(x, 10, (-2.0, 3.0)) and np.histogram(x, 7, (-0.7, 0.7)) of near, n = 65536
TEST(Statistics, HistogramIsThatOfNumpy) {
  const std::vector<float> values = near(1 << 16);
  EXPECT_EQ(histogram(values, -2.0, 3.0, 10),
            (std::vector<std::uint64_t>{4266, 6485, 8538, 9791, 9830, 8805, 6568, 4105, 2304, 1015}));
  EXPECT_EQ(histogram(values, -0.7, 0.7, 7), (std::vector<std::uint64_t>{3610, 3832, 3975, 3964, 4022, 3828, 3696}));
}

TEST(Statistics, HistogramWithoutBinsOrRangeHasNoCounts) {
  const std::array values = {0.5f};
  EXPECT_TRUE(histogram(values, 0.0, 1.0, 0).empty());
  EXPECT_TRUE(histogram(values, 1.0, 1.0, 4).empty());
  EXPECT_TRUE(histogram(values, std::nan(""), 1.0, 4).empty());
}

NormalityTest test_of(const std::vector<float>& values) { return normality_test(moments(values).value()).value(); }

TEST(Statistics, NormalityTestIsThatOfScipy) {
  const NormalityTest test = test_of(near(500));
  EXPECT_NEAR(test.skewness_z, -1.1145614141388844, 1e-11);
  EXPECT_NEAR(test.kurtosis_z, -1.4712938119189924, 1e-11);
  EXPECT_NEAR(test.statistic, 3.4069526268783896, 1e-11);
  EXPECT_NEAR(test.p_value, 0.18204956142778733, 1e-12);
  EXPECT_NEAR(test.log10_p, -0.7398103629795365, 1e-12);
}

TEST(Statistics, TheFewestValuesThatCanBeTested) {
  const NormalityTest test = test_of(near(8));
  EXPECT_NEAR(test.statistic, 0.5181301941429348, 1e-12);
  EXPECT_NEAR(test.p_value, 0.7717727812605265, 1e-12);
  const auto seven = normality_test(moments(near(7)).value());
  ASSERT_FALSE(seven);
  EXPECT_EQ(seven.error().message, "the normality test needs 8 values or more, not 7");
}

// 1 - cdf would be 0 here.
TEST(Statistics, SmallProbabilitiesKeepTheirDigits) {
  const NormalityTest test = test_of(near(1 << 14));
  EXPECT_NEAR(test.statistic, 167.34232793931648, 1e-8);
  EXPECT_NEAR(test.p_value / 4.592775250616409e-37, 1.0, 1e-8);
}

TEST(Statistics, ProbabilitiesBelowDoubleHaveALogarithm) {
  const NormalityTest test = test_of(near(1 << 20));
  EXPECT_NEAR(test.statistic, 11072.70317424925, 1e-6);
  EXPECT_EQ(test.p_value, 0.0);
  EXPECT_NEAR(test.log10_p, -2404.406944164535, 1e-6);
}

// The skewness of a symmetric sample is 0, and so is its z (scipy 1.17.1 puts 1 for a y of exactly 0).
TEST(Statistics, SymmetricValuesAreNotSkewed) {
  EXPECT_EQ(normality_test({100, -1.0, 1.0, 0.0, 1.0, 0.0, 0.0}).value().skewness_z, 0.0);
}

}  // namespace
}  // namespace hn
