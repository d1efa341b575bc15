#include "widgets/models/victims/mark_places.h"

#include <cmath>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

double apart(const QPointF& one, const QPointF& other) {
    return std::hypot(one.x() - other.x(), one.y() - other.y());
}

TEST(MarkPlaces, WhatHidesNothingStays) {
    const std::vector<MarkDisc> marks{{{100, 100}, 12}, {{118, 100}, 8}, {{300, 40}, 8}};
    EXPECT_EQ(markPlaces(marks), (std::vector<QPointF>{{100, 100}, {118, 100}, {300, 40}}));
    EXPECT_TRUE(markPlaces({}).empty());
}

TEST(MarkPlaces, WhatWouldBeHiddenIsBeside) {
    const auto places = markPlaces({{{100, 100}, 12}, {{97, 100}, 8}, {{100, 100}, 8}});
    EXPECT_EQ(places[0], QPointF(100, 100)) << "the most important stays";
    EXPECT_NEAR(places[1].x(), 78.0, 1e-9) << "to where it is off";
    EXPECT_NEAR(places[1].y(), 100.0, 1e-9);
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_GE(apart(places[i], places[j]), 17.0) << i << ' ' << j;
    }
}

TEST(MarkPlaces, ManyAtOnePlaceAreAllSeen) {
    const auto places = markPlaces(std::vector<MarkDisc>(9, {{50, 50}, 8}));
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_GE(apart(places[i], places[j]), 16.0) << i << ' ' << j;
    }
    const auto crowd = markPlaces(std::vector<MarkDisc>(60, {{50, 50}, 8}));
    EXPECT_EQ(crowd.size(), 60U);
    EXPECT_EQ(crowd.back(), QPointF(50, 50)) << "no room: where it is";
}

}  // namespace
}  // namespace leitstand
