// SPDX-License-Identifier: Apache-2.0
#include "traffic/event_calendar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace thalweg {
namespace {

struct Numbered {
  double time;
  int number;
};
using Calendar = EventCalendar<Numbered>;

std::vector<int> run(Calendar& calendar) {
  std::vector<int> order;
  calendar.run([](const auto&) {}, [&](const Numbered& event) { order.push_back(event.number); });
  return order;
}

TEST(EventCalendar, HasTheOrderOfAStableSortByTenths) {
  std::mt19937 dice(1);
  std::vector<Numbered> events;
  events.reserve(500);
  for (int i = 0; i < 500; ++i)
    events.push_back({.time = static_cast<double>(dice() % 1000) / 97, .number = i});
  Calendar calendar(20);
  for (int round = 0; round < 2; ++round) {  // what is left of one round is not in the next
    calendar.clear();
    for (const Numbered& event : events) calendar.add(event);
    auto sorted = events;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Numbered& a, const Numbered& b) {
      return static_cast<int>(a.time * 10) < static_cast<int>(b.time * 10);
    });
    std::vector<int> expected;
    expected.reserve(sorted.size());
    for (const Numbered& event : sorted) expected.push_back(event.number);
    EXPECT_EQ(run(calendar), expected);
  }
}

TEST(EventCalendar, TakesEventsThatAreFoundOutMeanwhile) {
  Calendar calendar(100);
  calendar.add({.time = 5, .number = 0});
  calendar.add({.time = 5.02, .number = 1});
  std::vector<int> order;
  calendar.run([](const auto&) {},
               [&](const Numbered& event) {
                 order.push_back(event.number);
                 if (event.number != 0) return;
                 EXPECT_TRUE(calendar.is_now(5.09));
                 EXPECT_FALSE(calendar.is_now(5.11));
                 calendar.add({.time = 6, .number = 2});
                 calendar.add({.time = 1, .number = 3});    // too late: now
                 calendar.add({.time = 101, .number = 4});  // after the horizon: never
               });
  EXPECT_EQ(order, (std::vector{0, 1, 3, 2}));
}

TEST(EventCalendar, ShowsWhatComesNextInThisTenthAndTheFollowing) {
  Calendar calendar(10);
  for (int i = 0; i < 3; ++i) calendar.add({.time = 1, .number = i});
  calendar.add({.time = 1.3, .number = 3});
  calendar.add({.time = 5, .number = 4});  // too far from those before it
  std::vector<std::vector<int>> shown;
  calendar.run(
      [&](const Calendar::Foreseen& ahead) {
        auto& numbers = shown.emplace_back();
        for (const Numbered* event : ahead) {
          if (event != nullptr) numbers.push_back(event->number);
        }
      },
      [](const Numbered&) {});
  EXPECT_EQ(shown, (std::vector<std::vector<int>>{{1, 2, 3}, {2, 3}, {3}, {}, {}}));
}

TEST(EventCalendar, ShowsFourAtMost) {
  Calendar calendar(10);
  for (int i = 0; i < 9; ++i) calendar.add({.time = 1, .number = i});
  std::vector<int> shown;
  calendar.run(
      [&](const Calendar::Foreseen& ahead) { shown.push_back(ahead.back() ? ahead.back()->number : -1); },
      [](const Numbered&) {});
  EXPECT_EQ(shown, (std::vector{4, 5, 6, 7, 8, -1, -1, -1, -1}));
}

}  // namespace
}  // namespace thalweg
