// SPDX-License-Identifier: Apache-2.0
#include "demand/duarouter_log.hpp"

#include <gtest/gtest.h>

namespace thalweg::testing {
namespace {

TEST(DuarouterLog, TheFirstMessageCountsWithAllItsLines) {
  const auto reasons = reasons_of(
      "Warning: Source junction 'A0' not known for trip 'j'!\n"
      "Set option '--junction-taz' or load a TAZ-file\n"
      "Warning: The route for vehicle 'j' has no edges.\n"
      "Warning: The route '!jf' for flow 'jf' is not known.\n"
      "Vehicle 'x' has no valid route.\n"
      "Warning: No connection between edge 'a' and edge 'b' found.\n"
      " and more of that\n"
      "Warning: Mandatory edge 'd' not reachable by vehicle 'y'.\n"
      "Success.\n");
  ASSERT_EQ(reasons.size(), 4U);
  EXPECT_EQ(reasons.at("j"),
            "Source junction 'A0' not known for trip 'j'! Set option '--junction-taz' or load a TAZ-file");
  EXPECT_EQ(reasons.at("jf"), "The route '!jf' for flow 'jf' is not known.");
  EXPECT_EQ(reasons.at("x"), "Vehicle 'x' has no valid route.");
  EXPECT_EQ(reasons.at("y"), "Mandatory edge 'd' not reachable by vehicle 'y'.");
}

TEST(DuarouterLog, PersonsAreNamedApart) {
  const std::string_view log =
      "Warning: The edge 'nix' within the route for person 'u' is not known.\n"
      "Warning: Discarding person 'u' because her plan is empty\n"
      "Warning: No route for trip in person 'f.0'.\n";
  const auto reasons = reasons_of_persons(log);
  ASSERT_EQ(reasons.size(), 2U);
  EXPECT_EQ(reasons.at("u"), "The edge 'nix' within the route for person 'u' is not known.");
  EXPECT_TRUE(reasons_of(log).empty());
}

TEST(DuarouterLog, NothingIsSaidOfNobody) {
  EXPECT_TRUE(reasons_of("").empty());
  EXPECT_TRUE(reasons_of("Success.\nvehicle 'unfinished\n").empty());
}

}  // namespace
}  // namespace thalweg::testing
