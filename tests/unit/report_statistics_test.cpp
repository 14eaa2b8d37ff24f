// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "report/statistics.hpp"

namespace thalweg {
namespace {

using Values = std::vector<double>;

TEST(Statistics, IntervalOfTheMean) {
  // mean 3, s = sqrt(2.5), t(4, 0.975) = 2.776445: 2.776445 * sqrt(2.5 / 5)
  const Estimate result = estimate(Values{1, 2, 3, 4, 5});
  EXPECT_EQ(result.count, 5U);
  EXPECT_DOUBLE_EQ(result.mean, 3);
  EXPECT_NEAR(result.half_width.value(), 1.963243, 1e-6);
  EXPECT_NEAR(result.low().value(), 1.036757, 1e-6);
  EXPECT_NEAR(result.high().value(), 4.963243, 1e-6);
  EXPECT_TRUE(result.differs_from_zero());
}

TEST(Statistics, OneValueHasNoIntervalAndNoneHasNoMean) {
  const Estimate one = estimate(Values{7});
  EXPECT_DOUBLE_EQ(one.mean, 7);
  EXPECT_FALSE(one.half_width);
  EXPECT_FALSE(one.low());
  EXPECT_FALSE(one.differs_from_zero());
  EXPECT_TRUE(std::isnan(estimate(Values{}).mean));
  EXPECT_FALSE(welch_difference(Values{7}, Values{8}).half_width);
}

TEST(Statistics, PairingHelpsWhenThePairsGoTogether) {
  const Values a{11, 21, 31.5, 41};
  const Values b{10, 20, 30, 40};
  const Estimate paired = paired_difference(a, b);
  const Estimate welch = welch_difference(a, b);
  EXPECT_DOUBLE_EQ(paired.mean, 1.125);
  EXPECT_DOUBLE_EQ(welch.mean, 1.125);
  EXPECT_TRUE(paired.differs_from_zero());
  EXPECT_FALSE(welch.differs_from_zero());
  EXPECT_GT(correlation(a, b).value(), 0.999);
}

TEST(Statistics, WelchAgainstATextbook) {
  // variances 2.5 and 10, five values each: 5.882353 degrees of freedom, t = 2.4589
  const Estimate result = welch_difference(Values{1, 2, 3, 4, 5}, Values{2, 4, 6, 8, 10});
  EXPECT_DOUBLE_EQ(result.mean, -3);
  EXPECT_NEAR(result.half_width.value(), 2.4589 * std::sqrt(2.5), 1e-3);
  EXPECT_DOUBLE_EQ(welch_difference(Values{2, 2}, Values{1, 1}).half_width.value(), 0);
}

TEST(Statistics, Correlation) {
  EXPECT_DOUBLE_EQ(correlation(Values{1, 2, 3}, Values{6, 4, 2}).value(), -1);
  EXPECT_FALSE(correlation(Values{1, 1, 1}, Values{6, 4, 2}));
  EXPECT_FALSE(correlation(Values{1, 2}, Values{6, 4}));
}

TEST(Statistics, MoreValuesNeeded) {
  const Values values{1, 2, 3, 4, 5};  // half width 1.96 with five
  EXPECT_EQ(more_values_needed(values, 2), 0U);
  // 1.0 takes n with t(n-1) sqrt(2.5 / n) <= 1: t(11) = 2.201 gives 1.0046 for 12, t(12) = 2.179 gives 0.955
  EXPECT_EQ(more_values_needed(values, 1), 8U);
  EXPECT_FALSE(more_values_needed(values, 0));
  EXPECT_FALSE(more_values_needed(Values{1}, 1));
  EXPECT_FALSE(more_values_needed(values, 1e-6));
}

}  // namespace
}  // namespace thalweg
