#include "core/event/sample.h"

#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/event/all_samples.h"

namespace leitstand {
namespace {

Sample note(const std::string& text) {
    NoteSample sample;
    sample.text = text;
    return sample;
}

TEST(Samples, AreOfOneType) {
    const Sample sample = note("here");
    EXPECT_TRUE(sample.is<NoteSample>());
    EXPECT_EQ(sample.as<NoteSample>()->text, "here");
    EXPECT_EQ(sample.get<NoteSample>().text, "here");
    EXPECT_EQ(sample.as<GasSample>(), nullptr);
    EXPECT_THROW(static_cast<void>(sample.get<GasSample>()), std::logic_error);
    EXPECT_EQ(note("temporary").get<NoteSample>().text, "temporary");
}

TEST(Samples, EditingOneLeavesItsCopiesAsTheyAre) {
    Sample first = note("first");
    Sample copy = first;
    EXPECT_EQ(copy.as<NoteSample>(), first.as<NoteSample>()) << "shared until then";
    copy.edit<NoteSample>()->text = "copy";
    first.edit<NoteSample>()->text = "edited";
    EXPECT_EQ(copy.get<NoteSample>().text, "copy");
    EXPECT_EQ(first.get<NoteSample>().text, "edited");
    Sample moved = std::move(copy);
    const Sample another = moved;
    moved.edit<NoteSample>()->text = "moved";
    EXPECT_EQ(another.get<NoteSample>().text, "copy");
    EXPECT_EQ(moved.edit<GasSample>(), nullptr);
}

TEST(Samples, WhatNobodySharesIsEditedInPlace) {
    Sample sample = note("alone");
    const NoteSample* const before = sample.as<NoteSample>();
    EXPECT_EQ(sample.edit<NoteSample>(), before);
    Sample moved = std::move(sample);
    EXPECT_EQ(moved.edit<NoteSample>(), before);
    Sample& same = moved;
    moved = same;
    EXPECT_EQ(moved.get<NoteSample>().text, "alone");
}

TEST(Samples, AreVisitedByTheirType) {
    const auto textOf = [](const auto& content) {
        if constexpr (requires { std::string(content.text); }) return std::string(content.text);
        return std::string("none");
    };
    EXPECT_EQ(visit(textOf, note("seen")), "seen");
    EXPECT_EQ(visit(textOf, Sample(GasSample())), "none");
    Sample sample = note("before");
    edit(
        [](auto& content) {
            if constexpr (requires { content.text = "after"; }) content.text = "after";
        },
        sample);
    EXPECT_EQ(sample.get<NoteSample>().text, "after");
}

TEST(Samples, WithoutContentAreNothing) {
    Sample sample = note("gone");
    const Sample taken = std::move(sample);
    EXPECT_EQ(taken.get<NoteSample>().text, "gone");
    for (const Sample& empty : {Sample(), std::as_const(sample)}) {  // NOLINT(bugprone-use-after-move): meant
        EXPECT_EQ(empty.index(), SampleTypes::Size);
        EXPECT_EQ(empty.as<NoteSample>(), nullptr);
        EXPECT_THROW(visit([](const auto&) {}, empty), std::logic_error);
    }
}

}  // namespace
}  // namespace leitstand
