// SPDX-License-Identifier: Apache-2.0
#include "lab/score.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/instance.hpp"

namespace thalweg::lab {
namespace {

TEST(Score, ReadsEtaOffTheWeights) {
  const std::vector<Millis> weights{2, 8, 2, infinity, 4};  // w = {2, 4, 8}, four open arcs
  const Scores scores = scores_of(weights);
  EXPECT_EQ(scores.different, 3U);
  EXPECT_DOUBLE_EQ(scores.eta, 8.0 / 3);
  EXPECT_DOUBLE_EQ(scores.gap, 6.0 / 3);
  EXPECT_DOUBLE_EQ(scores.eta_of_arcs, 8.0 / 4);
  EXPECT_NEAR(scores.variation, std::sqrt(6.0) / 4, 1e-12);  // mean 4, variance (4 + 16 + 4 + 0) / 4
  EXPECT_EQ(scores_of({}).different, 0U);
}

//   0 --9--> 2     an anti event: 9 against 1 + 2; 3 is out of reach
//   0 --1--> 1 --2--> 2
TEST(Score, AccuracyIsTheExcessOverTheOptimum) {
  const auto instance = testing::make_instance(4, {{0, 2, 9}, {0, 1, 1}, {1, 2, 2}, {3, 0, 1}});
  AccuracyScratch scratch;
  const Accuracy accuracy = accuracy_from(instance.graph, instance.costs, VertexId{0U}, scratch);
  EXPECT_EQ(accuracy.pairs, 2U);
  EXPECT_DOUBLE_EQ(accuracy.optimal, 50);
  EXPECT_DOUBLE_EQ(accuracy.excess, 100);  // (0 + 200) / 2
  EXPECT_EQ(accuracy_from(instance.graph, instance.costs, VertexId{2U}, scratch).pairs, 0U);
}

TEST(Score, RankCorrelationSeesOrderNotDistance) {
  const std::vector<double> a{1, 2, 3, 4};
  EXPECT_DOUBLE_EQ(rank_correlation(a, std::vector<double>{1, 10, 100, 1000}).value(), 1);
  EXPECT_DOUBLE_EQ(rank_correlation(a, std::vector<double>{9, 7, 2, 1}).value(), -1);
  // Ranks 0, 1.5, 1.5, 3 against 0, 1, 2, 3: 4.5 / sqrt(4.5 x 5)
  EXPECT_NEAR(rank_correlation(a, std::vector<double>{1, 2, 2, 3}).value(), 4.5 / std::sqrt(22.5), 1e-12);
  EXPECT_FALSE(rank_correlation(a, std::vector<double>{5, 5, 5, 5}).has_value());
}

}  // namespace
}  // namespace thalweg::lab
