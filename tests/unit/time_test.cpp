// SPDX-License-Identifier: Apache-2.0
#include "core/time.hpp"

#include <gtest/gtest.h>

namespace thalweg {
namespace {

TEST(Time, ReadsSumosFormats) {
  EXPECT_EQ(parse_time("12.5"), 12'500);
  EXPECT_EQ(parse_time(" -1 "), -1'000);
  EXPECT_EQ(parse_time("15:00:01.5"), 54'001'500);
  EXPECT_EQ(parse_time("1:0:0:0"), 86'400'000);
  EXPECT_EQ(parse_time("-0:1:0"), -60'000);
}

TEST(Time, RefusesWhatIsNone) {
  for (const char* text : {"", "x", "1:2", "1:2:3:4:5", "1::2", "nan", "inf", "1 2"}) {
    EXPECT_EQ(parse_time(text), std::nullopt) << text;
  }
}

TEST(Time, SumsStayAtInfinity) {
  EXPECT_EQ(add_saturating(infinity, 5), infinity);
  EXPECT_EQ(add_saturating(infinity - 1, 5), infinity);
  EXPECT_EQ(add_saturating(2, 3), 5);
  EXPECT_EQ(from_seconds(1e300), infinity);
}

}  // namespace
}  // namespace thalweg
