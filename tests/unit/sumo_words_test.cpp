// SPDX-License-Identifier: Apache-2.0
#include "app/sumo_words.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <memory>

namespace thalweg::testing {
namespace {

class Words : public ::testing::Test {
 protected:
  std::string shown;
  std::unique_ptr<SumoWords> words =
      std::make_unique<SumoWords>([this](std::string_view line) { shown += line; });
};

TEST_F(Words, OfManyAlikeTheFirstThreeAreShown) {
  for (int i = 1; i <= 5; ++i) std::cerr << "Warning: Vehicle 'v" << i << "' waits, time=" << i << ".50.\n";
  std::cerr << "Warning: Vehicle 'v1' teleports.\n goes on\nNo warning.\n";
  EXPECT_EQ(shown,
            "Warning: Vehicle 'v1' waits, time=1.50.\n"
            "Warning: Vehicle 'v2' waits, time=2.50.\n"
            "Warning: Vehicle 'v3' waits, time=3.50.\n"
            "Warning: Vehicle 'v1' teleports.\n goes on\nNo warning.\n");
  shown.clear();
  words->end("sumo.log");
  EXPECT_EQ(shown,
            "Warning: ... and 2 more like this one of SUMO's: Vehicle 'v1' waits, time=1.50. All are in "
            "'sumo.log'.\n");
}

TEST_F(Words, ErrorsAreKeptForTheEnd) {
  std::cerr << "Warning: well.\nError: On processing option 'x':\n No such option.\nWarning: an open line";
  EXPECT_EQ(shown, "Warning: well.\n");
  words->end("sumo.log");
  EXPECT_EQ(words->errors(), "On processing option 'x':\n No such option.");
  EXPECT_EQ(shown, "Warning: well.\nWarning: an open line\n");
}

TEST_F(Words, TheErrorStreamIsGivenBack) {
  std::streambuf* const taken = std::cerr.rdbuf();
  EXPECT_EQ(taken, words.get());
  words.reset();
  EXPECT_NE(std::cerr.rdbuf(), taken);
}

TEST_F(Words, AnOpenQuoteEndsWithTheLine) {
  std::cerr << "Warning: it's 7\nWarning: 9";
  words->end("sumo.log");
  EXPECT_EQ(shown, "Warning: it's 7\nWarning: 9\n");
}

}  // namespace
}  // namespace thalweg::testing
